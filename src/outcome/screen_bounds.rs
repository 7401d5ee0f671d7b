//! The line on the error bounds of a table on the screen: a bound as long as its value is never part of a sentence that sounds fine.

use super::Outcome;

/// How long the bounds of the shown columns are, over their values; those beyond the wanted accuracy are counted by themselves.
pub(super) fn bounds_line(outcome: &Outcome, shown: &[usize]) -> String {
    let values = outcome.rows.iter().flat_map(|row| shown.iter().filter_map(|&index| row.values.get(index).copied().flatten()));
    // Without bound where the value is zero and its error is not.
    let bounds: Vec<f64> = values.map(|value| if value.error == 0.0 { 0.0 } else { value.relative_error() }).collect();
    let (short, long): (Vec<f64>, Vec<f64>) = bounds.iter().partition(|bound| **bound <= outcome.accuracy);
    let largest = |bounds: &[f64]| bounds.iter().fold(0.0, |most: f64, bound| most.max(*bound));
    if long.is_empty() {
        return format!("error bounds: at most ± {:.0e} of each value shown; states.csv has every one", largest(&short));
    }
    let longest = largest(&long);
    let up_to =
        if longest < 1.0 { format!("up to ± {longest:.0e} of the value") } else { "as long as the value itself, or longer".to_owned() };
    let of_most = if short.is_empty() {
        String::new()
    } else {
        format!("at most ± {:.0e} of {} of {} values shown; ", largest(&short), short.len(), bounds.len())
    };
    format!(
        "error bounds: {of_most}CAUTION: {} {} beyond the wanted accuracy, {up_to} (a value near zero, or an inaccurate row); states.csv has every one",
        long.len(),
        if long.len() == 1 { "is" } else { "are" }
    )
}
