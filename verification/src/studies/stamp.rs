//! Where, when and by what a report was made.

use crate::date;

/// Machine, program, date.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Stamp {
    /// Model of the processor, and what the system calls itself.
    pub machine: String,
    /// Logical cores.
    pub cores: usize,
    /// Version and commit of this program.
    pub program: String,
    /// The compiler that built it.
    pub compiler: String,
    /// Day of the run, universal time, as 2026-01-31.
    pub date: String,
}

impl Stamp {
    /// Of this run.
    #[must_use]
    pub fn now() -> Self {
        Self {
            machine: format!("{}, {} {}", processor(), std::env::consts::OS, std::env::consts::ARCH),
            cores: std::thread::available_parallelism().map_or(1, std::num::NonZero::get),
            program: format!("viscotack {} ({})", viscotack_program::VERSION, viscotack_program::COMMIT),
            compiler: viscotack_program::COMPILER.to_owned(),
            date: date::today(),
        }
    }
}

/// The model of the processor where the system tells it.
fn processor() -> String {
    let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = text.lines().find_map(|line| line.strip_prefix("model name")).and_then(|rest| rest.split_once(':'));
    model.map_or_else(|| "processor unknown".to_owned(), |(_, name)| name.trim().to_owned())
}
