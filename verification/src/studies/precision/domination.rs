//! Who wins: whether any run of a rival is as accurate as this program in less time.

use super::{Method, Sample};

/// The runs of one rival against all of ours.
#[derive(Debug, Clone, PartialEq)]
pub struct Contest {
    /// Runs of the rival that gave a result.
    pub runs: usize,
    /// The least of (rival's time)/(our time for at most its error), with the run; none if none of ours is as accurate, or none of theirs ended.
    pub closest: Option<(f64, String)>,
    /// The same at the rival's most accurate run.
    pub at_its_best: Option<(f64, f64)>,
    /// Runs of the rival more accurate than any of ours.
    pub out_of_reach: Vec<String>,
}

impl Contest {
    /// Whether no run of the rival is as accurate in less time.
    #[must_use]
    pub fn dominates(&self) -> bool {
        self.out_of_reach.is_empty() && self.closest.as_ref().is_none_or(|(ratio, _)| *ratio > 1.0)
    }

    /// In words.
    #[must_use]
    pub fn text(&self) -> String {
        if self.runs == 0 {
            return "the rival gave no result".to_owned();
        }
        let mut text = match &self.closest {
            Some((ratio, run)) if *ratio > 1.0 => format!("at least {} times faster at equal accuracy (closest at {run})", times(*ratio)),
            Some((ratio, run)) => format!("LOSES at {run}: {} times slower for that error", times(1.0 / ratio)),
            None => "nowhere as accurate".to_owned(),
        };
        if let Some((error, ratio)) = self.at_its_best {
            text.push_str(&format!("; at the rival's best error of {error:.1e}, {} times faster", times(ratio)));
        }
        if !self.out_of_reach.is_empty() {
            text.push_str(&format!("; out of reach: {}", self.out_of_reach.join(", ")));
        }
        text
    }
}

/// Our methods against one rival.
#[must_use]
pub fn contest(own: &[&Method], other: &Method) -> Contest {
    let runs: Vec<(&Sample, f64)> = other.samples.iter().filter_map(|sample| Some((sample, *sample.error.as_ref().ok()?))).collect();
    let ours = |error: f64| {
        let reached = own.iter().flat_map(|method| &method.samples).filter(|sample| sample.error.as_ref().is_ok_and(|own| *own <= error));
        reached.map(|sample| sample.seconds).min_by(f64::total_cmp)
    };
    let mut found = Contest { runs: runs.len(), closest: None, at_its_best: None, out_of_reach: Vec::new() };
    let mut best = f64::INFINITY;
    for (sample, error) in runs {
        let Some(seconds) = ours(error) else {
            found.out_of_reach.push(format!("{} ({error:.1e})", sample.setting));
            continue;
        };
        let ratio = sample.seconds / seconds;
        if found.closest.as_ref().is_none_or(|(least, _)| ratio < *least) {
            found.closest = Some((ratio, format!("{}, error {error:.1e}", sample.setting)));
        }
        if error < best {
            best = error;
            found.at_its_best = Some((error, ratio));
        }
    }
    found
}

/// A ratio in two or three digits.
fn times(ratio: f64) -> String {
    if ratio < 10.0 { format!("{ratio:.1}") } else { format!("{ratio:.0}") }
}
