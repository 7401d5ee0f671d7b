//! Where, when and by what a report was made.

use std::time::{SystemTime, UNIX_EPOCH};

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
        let days = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs() / 86_400);
        Self {
            machine: format!("{}, {} {}", processor(), std::env::consts::OS, std::env::consts::ARCH),
            cores: std::thread::available_parallelism().map_or(1, std::num::NonZero::get),
            program: format!("viscotack {} ({})", viscotack_program::VERSION, viscotack_program::COMMIT),
            compiler: viscotack_program::COMPILER.to_owned(),
            date: date(days),
        }
    }
}

/// The model of the processor where the system tells it.
fn processor() -> String {
    let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = text.lines().find_map(|line| line.strip_prefix("model name")).and_then(|rest| rest.split_once(':'));
    model.map_or_else(|| "processor unknown".to_owned(), |(_, name)| name.trim().to_owned())
}

/// The day that many days after 1970-01-01 (Gregorian calendar, by counting years from 1 March).
fn date(days: u64) -> String {
    let shifted = days + 719_468;
    let era_day = shifted % 146_097;
    let year_of_era = (era_day - era_day / 1_460 + era_day / 36_524 - era_day / 146_096) / 365;
    let day_of_year = era_day - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let month = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * month + 2) / 5 + 1;
    let (year, month) = (400 * (shifted / 146_097) + year_of_era, if month < 10 { month + 3 } else { month - 9 });
    format!("{:04}-{month:02}-{day:02}", year + u64::from(month <= 2))
}

#[cfg(test)]
mod tests {
    use super::date;

    #[test]
    fn days_become_dates() {
        let known = [(0, "1970-01-01"), (59, "1970-03-01"), (11_016, "2000-02-29"), (11_017, "2000-03-01"), (20_453, "2025-12-31")];
        for (days, expected) in known {
            assert_eq!(date(days), expected);
        }
    }
}
