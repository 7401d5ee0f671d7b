//! Which polyline a record is followed along: its rows, or one of fewer corners within a tolerance.

use super::history::dependent;
use super::section::Section;
use crate::scene::catalogue::Range;
use crate::scene::check::Units;
use crate::scene::diagnostic::SceneError;
use crate::scene::typed::{HistoryQuantity, RecordThinning};
use crate::scene::units::Dimension;
use viscotack::continuation::polyline::{Thinned, noise, thinned};

/// Records of at most so many rows are followed row by row, if the scene says nothing else.
const FOLLOWED_ROW_BY_ROW: usize = 2000;
/// The default tolerance over the scene's accuracy times the range of the record.
const OF_THE_ACCURACY: f64 = 0.25;
/// Noise of a normal distribution stays within so many standard deviations in a million rows.
const OF_THE_NOISE: f64 = 5.0;
/// More corners than these take minutes: the tolerance is then below the noise.
const MOST_CORNERS: usize = 10_000;

/// What is followed.
pub(super) struct Followed {
    pub(super) corners: Vec<(f64, f64)>,
    /// Times of all rows.
    pub(super) rows: Vec<f64>,
    pub(super) thinning: Option<RecordThinning>,
}

/// The corners of a record, within the tolerance that the scene states, or the default.
pub(super) fn corners(
    item: &Section<'_>,
    quantity: HistoryQuantity,
    file: &str,
    times: Vec<f64>,
    values: Vec<f64>,
    accuracy: f64,
) -> Result<Followed, SceneError> {
    let stated = item.value("tolerance").map(|_| dependent(item, "tolerance", quantity.dimension(), Range::NonNegative)).transpose()?;
    let left_out = item.text("noise") == Some("left_out");
    let rows: Vec<(f64, f64)> = times.iter().copied().zip(values).collect();
    if stated.is_none() && !left_out && rows.len() <= FOLLOWED_ROW_BY_ROW {
        return Ok(Followed { corners: rows, rows: times, thinning: None });
    }
    let (low, high) = rows.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), row| (low.min(row.1), high.max(row.1)));
    let range = high - low;
    let wanted = stated.unwrap_or(OF_THE_ACCURACY * accuracy * range);
    let found_noise = noise(&rows);
    let tolerance = if left_out { wanted.max(OF_THE_NOISE * found_noise) } else { wanted };
    let floor = if quantity.range() == Range::Finite { f64::NEG_INFINITY } else { 0.0 };
    let within = |tolerance: f64| -> Result<Thinned, SceneError> {
        thinned(&rows, tolerance, floor)
            .map_err(|refusal| item.wrong("table", format!("{file:?} cannot be followed: {refusal}"), "this file"))
    };
    let found = within(tolerance)?;
    if found.corners.len() > MOST_CORNERS {
        // The least tolerance of a geometric row that leaves few enough: it works when pasted.
        let mut enough = tolerance.max(found_noise).max(1e-6 * range);
        while within(enough)?.corners.len() > MOST_CORNERS / 2 && enough < range {
            enough *= 1.25;
        }
        let unit = unit_of(item.units(), quantity.dimension());
        let message = format!(
            "{file:?} has {} rows, and within {tolerance:.3e}{unit} of them {} corners remain: its noise is {found_noise:.1e}{unit}",
            rows.len(),
            found.corners.len()
        );
        let help = format!("add tolerance = {:e} to this segment, or noise = \"left_out\" to have its noise left out", rounded_up(enough));
        return Err(item.wrong("table", message, format!("at most {MOST_CORNERS} corners can be followed")).help(help));
    }
    let unit = unit_of(item.units(), quantity.dimension());
    let share = if range > 0.0 { found.deviation / range } else { 0.0 };
    let why = match (stated, left_out) {
        (_, true) if tolerance > wanted => format!("{OF_THE_NOISE} times its noise of {found_noise:.1e}{unit}"),
        (Some(_), _) => "as the scene states".to_owned(),
        (None, _) => "a quarter of the accuracy times its range; `tolerance` changes it".to_owned(),
    };
    let statement = format!(
        "{file:?}: its {} rows are followed along {} corners; the largest deviation of `{}` is {:.2e}{unit}, {share:.1e} of its range (tolerance {tolerance:.2e}{unit}, {why})",
        rows.len(),
        found.corners.len(),
        quantity.word(),
        found.deviation,
    );
    let thinned = found.deviation > 0.0 || found.corners.len() < rows.len();
    let thinning = thinned.then_some(RecordThinning { deviation: share, statement });
    Ok(Followed { corners: found.corners, rows: times, thinning })
}

/// The unit behind a number in SI, with a blank.
fn unit_of(units: Units, dimension: Dimension) -> String {
    if units == Units::Si { format!(" {}", dimension.si_unit()) } else { String::new() }
}

/// Two digits, not below the number.
fn rounded_up(value: f64) -> f64 {
    let unit = 10.0_f64.powf(value.log10().floor() - 1.0);
    let rounded = (value / unit).ceil() * unit;
    format!("{rounded:.1e}").parse().unwrap_or(rounded)
}
