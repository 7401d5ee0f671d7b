//! Whether the machine gives threads. Where it refuses them (a limit of processes, or of memory), all work is done on the thread that is there.

use std::sync::OnceLock;
use std::sync::RwLock;
use std::thread::{Builder, available_parallelism, scope};

/// Threads besides those of the work: of the progress bar, of signals, of a second opinion.
const OTHERS: usize = 4;

static ALLOWED: OnceLock<bool> = OnceLock::new();

/// Tries once whether as many threads start as work and its surroundings want; where one is refused, parallel work is done on this thread. To be called before
/// any work, on the thread that asks for it.
pub fn prepare() {
    ALLOWED.get_or_init(|| {
        let asked = std::env::var("RAYON_NUM_THREADS").ok().and_then(|text| text.parse().ok()).unwrap_or(0);
        let allowed = all_start(cores().max(asked) + OTHERS);
        if !allowed {
            // It starts no thread. That a pool is there already is no error.
            drop(rayon::ThreadPoolBuilder::new().num_threads(1).use_current_thread().build_global());
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
