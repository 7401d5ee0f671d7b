//! Whether the machine gives threads. Where it refuses them (a limit of processes, or of memory), all work is done on the thread that is there.

use std::sync::OnceLock;
use std::sync::RwLock;
use std::thread::{Builder, available_parallelism, scope};

/// Threads besides those of the work: of the progress bar, of signals, of a second opinion.
const OTHERS: usize = 4;

/// Processes allowed to the user for each thread that is wanted, with which none is refused as a rule.
const PLENTY: usize = 100;

static ALLOWED: OnceLock<bool> = OnceLock::new();

/// Starts so many threads for parallel work: without a number, one a core. Tries once whether as many start as work and its surroundings want; where one is
/// refused, parallel work is done on this thread. To be called before any work, on the thread that asks for it.
pub fn prepare(jobs: Option<usize>) {
    ALLOWED.get_or_init(|| {
        let asked = std::env::var("RAYON_NUM_THREADS").ok().and_then(|text| text.parse().ok()).unwrap_or(0);
        let wanted = jobs.unwrap_or(cores().max(asked)) + OTHERS;
        let allowed = !may_be_refused(wanted) || all_start(wanted);
        if !allowed {
            // It starts no thread. That a pool is there already is no error.
            drop(rayon::ThreadPoolBuilder::new().num_threads(1).use_current_thread().build_global());
        } else if let Some(jobs) = jobs {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(jobs);
            // One is there already.
            drop(if jobs == 1 { pool.use_current_thread() } else { pool }.build_global());
        }
        allowed
    });
}

/// How many threads may work side by side.
#[must_use]
pub fn available() -> usize {
    if is_alone() { 1 } else { cores() }
}

/// Whether threads were refused.
#[must_use]
pub fn is_alone() -> bool {
    ALLOWED.get() == Some(&false)
}

fn cores() -> usize {
    available_parallelism().map_or(1, std::num::NonZero::get)
}

/// Whether a limit of this process may keep threads from starting; trying takes longer than many scenes.
fn may_be_refused(wanted: usize) -> bool {
    let Ok(limits) = std::fs::read_to_string("/proc/self/limits") else { return true };
    let limit = |name: &str| -> Option<&str> { limits.lines().find_map(|line| line.strip_prefix(name))?.split_whitespace().next() };
    let plenty = |name: &str, least: usize| {
        limit(name).is_some_and(|found| found == "unlimited" || found.parse().is_ok_and(|found: usize| found >= least))
    };
    // What else the user runs counts as well.
    let processes = plenty("Max processes", PLENTY * wanted);
    std::env::var_os("RUST_MIN_STACK").is_some() || !processes || !plenty("Max address space", usize::MAX)
}

/// Whether so many threads are alive together.
fn all_start(count: usize) -> bool {
    let gate = RwLock::new(());
    let started = scope(|scope| {
        let closed = gate.write();
        let all = (0..count).all(|_| Builder::new().spawn_scoped(scope, || drop(gate.read())).is_ok());
        drop(closed);
        all
    });
    // The system counts a thread for a moment longer than it lives.
    std::thread::sleep(std::time::Duration::from_millis(1));
    started
}
