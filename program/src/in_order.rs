//! Work on many items side by side whose results are handed over in the order of the items: no thread waits for a slow item that another works on, and
//! only so many results wait.

use rayon::prelude::*;
use std::collections::VecDeque;
use std::sync::mpsc::{Receiver, Sender, channel};

/// Does `work` on every item and hands the results to `take`, in order, as many together as are there. At most `ahead` items are under way or wait, so that
/// memory does not grow with the number of items. The order and the results do not depend on the number of threads.
///
/// # Errors
/// The first error of an item, of the work or of `take`; what comes before it is handed over.
pub fn in_order<T: Send, R: Send, E: Send>(
    mut items: impl Iterator<Item = Result<T, E>>,
    ahead: usize,
    work: impl Fn(T) -> Result<R, E> + Sync,
    mut take: impl FnMut(Vec<R>) -> Result<(), E>,
) -> Result<(), E> {
    if crate::threads::is_alone() || rayon::current_num_threads() == 1 {
        return items.try_for_each(|item| take(vec![work(item?)?]));
    }
    if rayon::current_thread_index().is_some() {
        // A thread of the pool must not wait for the pool.
        return by_chunks(items, ahead, work, take);
    }
    let ahead = ahead.max(LEAST * rayon::current_num_threads());
    let work = &work;
    rayon::in_place_scope(|scope| {
        let (sender, receiver) = channel();
        let mut waiting = Waiting { receiver, first: 0, results: VecDeque::with_capacity(ahead) };
        let (mut given, mut ended) = (0, None);
        loop {
            while ended.is_none() && given < waiting.first + ahead {
                match items.next() {
                    Some(Ok(item)) => {
                        let reply = Reply { number: given, sender: sender.clone() };
                        scope.spawn(move |_| reply.send(work(item)));
                        given += 1;
                    }
                    Some(Err(error)) => ended = Some(Err(error)),
                    None => ended = Some(Ok(())),
                }
            }
            if waiting.first == given {
                return ended.unwrap_or(Ok(()));
            }
            match waiting.ready() {
                Some(results) => take_some(results, &mut take)?,
                // A thread has panicked: the scope passes it on.
                None => return Ok(()),
            }
        }
    })
}

/// Hands over what comes before the first error.
fn take_some<R, E>(results: Vec<Result<R, E>>, take: &mut impl FnMut(Vec<R>) -> Result<(), E>) -> Result<(), E> {
    let mut error = None;
    let good: Vec<R> = results.into_iter().map_while(|result| result.map_err(|found| error = Some(found)).ok()).collect();
    if !good.is_empty() {
        take(good)?;
    }
    error.map_or(Ok(()), Err)
}

/// How many of so many quick items are best given to a thread at once, where so many may be under way: handing one over takes some microseconds, and wakes
/// the thread that takes the results. A short list is still cut into some parts for each thread.
#[must_use]
pub fn together(items: usize, ahead: usize) -> usize {
    let parts = LEAST * rayon::current_num_threads();
    (ahead / (2 * parts)).min(items / parts).max(1)
}

/// Items for each thread that may be under way, at least.
const LEAST: usize = 4;

/// A part of the items after the other.
fn by_chunks<T: Send, R: Send, E: Send>(
    mut items: impl Iterator<Item = Result<T, E>>,
    ahead: usize,
    work: impl Fn(T) -> Result<R, E> + Sync,
    mut take: impl FnMut(Vec<R>) -> Result<(), E>,
) -> Result<(), E> {
    loop {
        let chunk: Vec<_> = items.by_ref().take(ahead.max(1)).collect();
        if chunk.is_empty() {
            return Ok(());
        }
        take_some(chunk.into_par_iter().map(|item| item.and_then(&work)).collect(), &mut take)?;
    }
}

/// Sends the result of an item, or nothing where the work has panicked.
struct Reply<R> {
    number: usize,
    sender: Sender<(usize, Option<R>)>,
}

impl<R> Reply<R> {
    fn send(self, result: R) {
        // Nobody waits for it any more where an earlier item has failed.
        let _ = self.sender.send((self.number, Some(result)));
    }
}

impl<R> Drop for Reply<R> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            let _ = self.sender.send((self.number, None));
        }
    }
}

/// Results that wait for their turn.
struct Waiting<R> {
    receiver: Receiver<(usize, Option<R>)>,
    /// The number of the first that has not been handed over.
    first: usize,
    results: VecDeque<Option<R>>,
}

impl<R> Waiting<R> {
    /// The next results, at least one; none where one will never come.
    fn ready(&mut self) -> Option<Vec<R>> {
        while self.results.front().is_none_or(Option::is_none) {
            let received = self.receiver.recv().ok()?;
            self.keep(received)?;
        }
        while let Ok(received) = self.receiver.try_recv() {
            self.keep(received)?;
        }
        let mut ready = Vec::new();
        while self.results.front().is_some_and(Option::is_some) {
            ready.extend(self.results.pop_front().flatten());
        }
        self.first += ready.len();
        Some(ready)
    }

    fn keep(&mut self, (number, result): (usize, Option<R>)) -> Option<()> {
        let place = number - self.first;
        while self.results.len() <= place {
            self.results.push_back(None);
        }
        *self.results.get_mut(place)? = Some(result?);
        Some(())
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic)]
    use super::{in_order, together};
    use std::sync::atomic::{AtomicUsize, Ordering};
    use std::time::Duration;

    /// Numbers through work that takes longer the other way round, with a pool of so many threads.
    fn run(threads: usize, inside: bool, ahead: usize, fail: Option<usize>) -> (Result<(), String>, Vec<usize>, usize) {
        let (under_way, most) = (AtomicUsize::new(0), AtomicUsize::new(0));
        let mut taken = Vec::new();
        let work = |item: usize| {
            std::thread::sleep(Duration::from_micros(((item * 7919) % 13) as u64 * 50));
            if Some(item) == fail { Err(format!("item {item}")) } else { Ok(item * item) }
        };
        let items = (0..300).map(|item| {
            most.fetch_max(under_way.fetch_add(1, Ordering::SeqCst) + 1, Ordering::SeqCst);
            Ok(item)
        });
        let take = |results: Vec<usize>| {
            under_way.fetch_sub(results.len(), Ordering::SeqCst);
            taken.extend(results);
            Ok(())
        };
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        // Outside of the pool the pool of the process is used.
        let ended = if inside { pool.install(|| in_order(items, ahead, work, take)) } else { in_order(items, ahead, work, take) };
        (ended, taken, most.into_inner())
    }

    #[test]
    fn results_come_in_order_and_few_wait() {
        let squares: Vec<usize> = (0..300).map(|item| item * item).collect();
        for (threads, inside, ahead) in [(1, true, 1), (2, true, 7), (3, false, 1), (1, false, 64), (4, true, 1000)] {
            let (ended, taken, most) = run(threads, inside, ahead, None);
            assert_eq!((ended, &taken), (Ok(()), &squares));
            let room = ahead.max(super::LEAST * rayon::current_num_threads());
            assert!(most <= room, "{most} were under way, {room} are allowed");
        }
    }

    #[test]
    fn quick_items_are_handed_over_together_and_every_thread_gets_some() {
        let threads = rayon::current_num_threads();
        assert_eq!(together(1_000_000, 80 * threads), 10);
        // Fewer items than that: some parts for each thread.
        assert_eq!(together(3 * super::LEAST * threads, 1_000_000), 3);
        assert_eq!((together(1, 1_000_000), together(1_000_000, 1)), (1, 1));
    }

    #[test]
    fn an_error_ends_the_work_after_what_was_before_it() {
        for inside in [true, false] {
            let (ended, taken, most) = run(2, inside, 8, Some(120));
            assert_eq!(ended, Err("item 120".to_owned()));
            assert!(taken.len() <= 120 && taken.iter().enumerate().all(|(item, square)| item * item == *square));
            assert!(most < 100);
        }
    }

    #[test]
    fn a_panic_is_passed_on() {
        let ended = std::panic::catch_unwind(|| {
            in_order((0..50).map(Ok::<_, ()>), 8, |item| if item == 20 { panic!("on purpose") } else { Ok(item) }, |_| Ok(()))
        });
        assert!(ended.is_err());
    }
}
