//! Work on many items side by side whose results are handed over in the order of the items: no thread waits for a slow item that another works on, and
//! only so many results wait.

use rayon::Scope;
use std::collections::VecDeque;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Does `work` on every item and hands the results to `take`, in order, as many together as are there. At most `ahead` items are under way or wait, so that
/// memory does not grow with the number of items. The order and the results do not depend on the number of threads.
///
/// The thread that finishes an item hands over what is ready and begins the next item: no thread is woken for either, which takes as long as a quick item.
/// What `take` leaves of a result is dropped by the thread that made it: threads that give back each other's memory wait for each other at every request.
///
/// # Errors
/// The first error of an item, of the work or of `take`; what comes before it is handed over.
pub fn in_order<T, R: Send, E: Send>(
    mut items: impl Iterator<Item = Result<T, E>> + Send,
    ahead: usize,
    work: impl Fn(T) -> Result<R, E> + Sync,
    mut take: impl FnMut(&mut [R]) -> Result<(), E> + Send,
) -> Result<(), E> {
    let threads = rayon::current_num_threads();
    if crate::threads::is_alone() || threads == 1 {
        return items.try_for_each(|item| take(&mut [work(item?)?]));
    }
    let queue = Queue {
        items: Mutex::new(items),
        state: Mutex::new(State::new(ahead.max(LEAST * threads), threads)),
        work,
        take: Mutex::new(take),
    };
    rayon::in_place_scope(|scope| (0..threads).for_each(|_| scope.spawn(|scope| queue.step(scope))));
    queue.state.into_inner().unwrap_or_else(PoisonError::into_inner).failed.map_or(Ok(()), Err)
}

/// How many of so many quick items are best given to a thread at once, where so many may be under way: each handing over takes about a microsecond. A short
/// list is still cut into some parts for each thread, so that all end at about the same time.
#[must_use]
pub fn together(items: usize, ahead: usize) -> usize {
    let parts = LEAST * rayon::current_num_threads();
    (ahead / (2 * parts)).min(items / (4 * parts)).max(1)
}

/// Items for each thread that may be under way, at least.
const LEAST: usize = 4;

/// Items, what is done with them, and how far it is.
struct Queue<I, W, H, R, E> {
    items: Mutex<I>,
    state: Mutex<State<R, E>>,
    work: W,
    take: Mutex<H>,
}

/// How far the work is.
struct State<R, E> {
    /// Most items that are under way or wait.
    ahead: usize,
    /// Number of the next item that will be begun, of the first whose result is not yet with the thread that hands over, and of the first that has not
    /// been handed over.
    next: usize,
    first: usize,
    handed_over: usize,
    /// Results from the first on, as far as they are there.
    results: VecDeque<Option<Made<R, E>>>,
    /// What is left of results that were handed over, by the thread that made them.
    left: Vec<Vec<R>>,
    /// Threads that found no room for another item.
    resting: usize,
    /// Whether a thread is handing over.
    handing_over: bool,
    /// Whether no further item is begun.
    ended: bool,
    failed: Option<E>,
}

/// A result, and which thread made it.
struct Made<R, E> {
    result: Result<R, E>,
    thread: usize,
}

impl<R, E> State<R, E> {
    fn new(ahead: usize, threads: usize) -> Self {
        let results = VecDeque::with_capacity(ahead);
        let left = (0..threads).map(|_| Vec::with_capacity(ahead)).collect();
        Self { ahead, next: 0, first: 0, handed_over: 0, results, left, resting: 0, handing_over: false, ended: false, failed: None }
    }

    fn keep(&mut self, number: usize, made: Made<R, E>) {
        let place = number - self.first;
        while self.results.len() <= place {
            self.results.push_back(None);
        }
        if let Some(kept) = self.results.get_mut(place) {
            *kept = Some(made);
        }
    }

    /// The next results that can be handed over, the threads that made them, and the error behind them.
    fn ready(&mut self) -> (Vec<R>, Vec<usize>, Option<E>) {
        let (mut good, mut threads) = (Vec::new(), Vec::new());
        while self.results.front().is_some_and(Option::is_some) {
            match self.results.pop_front().flatten() {
                Some(Made { result: Ok(result), thread }) => {
                    good.push(result);
                    threads.push(thread);
                }
                Some(Made { result: Err(error), .. }) => return (good, threads, Some(error)),
                None => {}
            }
            self.first += 1;
        }
        (good, threads, None)
    }

    fn fail(&mut self, error: E) {
        self.ended = true;
        self.failed.get_or_insert(error);
    }
}

/// Ends the work where it panics: nothing behind that item can be handed over.
struct EndOnPanic<'q, R, E>(&'q Mutex<State<R, E>>);

impl<R, E> Drop for EndOnPanic<'_, R, E> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            locked(self.0).ended = true;
        }
    }
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl<T, R: Send, E: Send, I, W, H> Queue<I, W, H, R, E>
where
    I: Iterator<Item = Result<T, E>> + Send,
    W: Fn(T) -> Result<R, E> + Sync,
    H: FnMut(&mut [R]) -> Result<(), E> + Send,
{
    /// One item, and what can be handed over then. The next item is another task: a thread that waits within its work may take up a task, but never all of them.
    fn step<'s>(&'s self, scope: &Scope<'s>) {
        let Some((number, item)) = self.begin() else { return };
        let _end = EndOnPanic(&self.state);
        let result = item.and_then(&self.work);
        let freed = self.finish(number, result);
        (0..=freed).for_each(|_| scope.spawn(|scope| self.step(scope)));
    }

    /// The next item, if there is one and room for it.
    fn begin(&self) -> Option<(usize, Result<T, E>)> {
        let mut items = locked(&self.items);
        {
            let mut state = locked(&self.state);
            if state.ended {
                return None;
            }
            if state.next >= state.handed_over + state.ahead {
                state.resting += 1;
                return None;
            }
        }
        let item = items.next();
        let mut state = locked(&self.state);
        // Behind an error, or the end, comes nothing.
        state.ended |= !matches!(item, Some(Ok(_)));
        let number = state.next;
        state.next += usize::from(item.is_some());
        item.map(|item| (number, item))
    }

    /// Keeps a result and hands over what is ready, unless another thread does so; gives how many resting threads have work again.
    fn finish(&self, number: usize, result: Result<R, E>) -> usize {
        let thread = rayon::current_thread_index().unwrap_or(0);
        let mut own_left: Vec<R> = Vec::new();
        let mut state = locked(&self.state);
        // Dropped at the end of this function, after the lock.
        own_left.extend(state.left.get_mut(thread).into_iter().flat_map(|left| left.drain(..)));
        if state.failed.is_some() {
            return 0;
        }
        state.keep(number, Made { result, thread });
        if state.handing_over {
            return 0;
        }
        state.handing_over = true;
        let mut freed = 0;
        while state.failed.is_none() && state.results.front().is_some_and(Option::is_some) {
            let (mut good, threads, error) = state.ready();
            drop(state);
            let count = good.len();
            let taken = if count > 0 { (*locked(&self.take))(&mut good) } else { Ok(()) };
            state = locked(&self.state);
            state.handed_over += count;
            for (result, thread) in good.into_iter().zip(threads) {
                if let Some(left) = state.left.get_mut(thread) {
                    left.push(result);
                }
            }
            if let Some(error) = taken.err().or(error) {
                state.fail(error);
            }
            freed += std::mem::take(&mut state.resting);
        }
        state.handing_over = false;
        freed
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
        let take = |results: &mut [usize]| {
            under_way.fetch_sub(results.len(), Ordering::SeqCst);
            taken.extend_from_slice(results);
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
        assert_eq!(together(3 * 4 * super::LEAST * threads, 1_000_000), 3);
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

    /// A result that counts where it is dropped by another thread than the one that made it.
    struct Owned<'c> {
        maker: std::thread::ThreadId,
        dropped: &'c AtomicUsize,
        by_others: &'c AtomicUsize,
    }

    impl Drop for Owned<'_> {
        fn drop(&mut self) {
            self.dropped.fetch_add(1, Ordering::SeqCst);
            self.by_others.fetch_add(usize::from(std::thread::current().id() != self.maker), Ordering::SeqCst);
        }
    }

    #[test]
    fn a_thread_drops_what_it_has_made() {
        let (dropped, by_others) = (AtomicUsize::new(0), AtomicUsize::new(0));
        let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().unwrap();
        let (items, ahead) = (2000, 16);
        let work = |item: usize| {
            std::thread::sleep(Duration::from_micros(((item * 7919) % 13) as u64 * 5));
            Ok::<_, ()>(Owned { maker: std::thread::current().id(), dropped: &dropped, by_others: &by_others })
        };
        pool.install(|| in_order((0..items).map(Ok), ahead, work, |_| Ok(()))).unwrap();
        // What is left at the very end goes with the queue.
        let (dropped, by_others) = (dropped.into_inner(), by_others.into_inner());
        println!("{by_others} of {dropped} were dropped by another thread");
        assert_eq!(dropped, items);
        assert!(by_others <= ahead, "{by_others} of {items} results were dropped by a thread that had not made them");
    }

    #[test]
    fn a_panic_is_passed_on() {
        let ended = std::panic::catch_unwind(|| {
            in_order((0..50).map(Ok::<_, ()>), 8, |item| if item == 20 { panic!("on purpose") } else { Ok(item) }, |_| Ok(()))
        });
        assert!(ended.is_err());
    }
}
