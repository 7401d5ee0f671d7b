//! Sources computed on all cores, one source a core, the costliest first; what was kept is not computed again.

use super::source::{Source, SourceError};
use super::store::Store;
use super::table::Table;
use std::collections::BTreeMap;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use viscotack_program::outcome::folder::FolderError;

/// A table, and whether it was computed now.
#[derive(Debug, Clone)]
pub(super) struct Computed {
    pub(super) table: Table,
    pub(super) fresh: bool,
}

/// What stopped it.
#[derive(Debug)]
pub(super) enum JobError {
    Source(String, Box<SourceError>),
    Store(FolderError),
}

/// The tables of all sources, by key; equal sources are computed once.
pub(super) fn tables(
    sources: Vec<Source>,
    store: Option<&Store>,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<BTreeMap<String, Computed>, JobError> {
    let mut done: BTreeMap<String, Computed> = BTreeMap::new();
    let mut wanted: BTreeMap<String, Source> = BTreeMap::new();
    for source in sources {
        if let Some(table) = store.and_then(|store| store.load(&source.key)) {
            done.insert(source.key.clone(), Computed { table, fresh: false });
        } else {
            wanted.insert(source.key.clone(), source);
        }
    }
    let mut queue: Vec<(u64, Source)> = wanted.into_values().map(|source| (source.cost(), source)).collect();
    queue.sort_by_key(|(cost, _)| std::cmp::Reverse(*cost));
    let total = queue.len();
    let (next, finished) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let results: Mutex<Vec<Result<(String, Table), JobError>>> = Mutex::new(Vec::new());
    progress(0, total);
    let work = || {
        // A source is computed on its own core: its seconds are its own, and small scenes keep all cores busy.
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
        while let Some((_, source)) = queue.get(next.fetch_add(1, Ordering::Relaxed)) {
            let computed = match &pool {
                Ok(pool) => pool.install(|| source.compute()),
                Err(_) => source.compute(),
            };
            let result = computed.map_err(|error| JobError::Source(source.place.clone(), Box::new(error))).and_then(|table| {
                if let Some(store) = store {
                    store.keep(&source.key, &table).map_err(JobError::Store)?;
                }
                Ok((source.key.clone(), table))
            });
            if let Ok(mut results) = results.lock() {
                results.push(result);
            }
            progress(finished.fetch_add(1, Ordering::Relaxed) + 1, total);
        }
    };
    std::thread::scope(|scope| {
        for _ in 1..viscotack_program::threads::available().min(total) {
            // One that is refused is not missed: this thread works, too.
            drop(std::thread::Builder::new().spawn_scoped(scope, work));
        }
        work();
    });
    for result in results.into_inner().unwrap_or_default() {
        let (key, table) = result?;
        done.insert(key, Computed { table, fresh: true });
    }
    Ok(done)
}
