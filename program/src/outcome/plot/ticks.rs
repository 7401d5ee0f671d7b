//! Round numbers along an axis, their labels, and how many of them have room.

use super::{
    figure::Scale,
    interval::{Interval, half_length},
    label::{self, Run},
    style,
};

/// More labels than this make an axis restless, whatever room there is.
const MOST_LABELS: usize = 9;
/// Least distance between two ticks without labels, in points.
const CLOSEST_MINOR: f64 = 2.4;
/// A decade with less room than this, in points, gets no ticks inside it.
const SHORTEST_DIVIDED_DECADE: f64 = 11.0;
/// Labels with more digits than this are split into an offset and a rest.
const MOST_DIGITS: usize = 5;

/// Which way an axis runs: it decides whether labels stand in line or in a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Direction {
    Horizontal,
    Vertical,
}

/// The ticks of one axis; places are fractions of its length.
#[derive(Debug, Default)]
pub(super) struct Ticks {
    pub(super) major: Vec<(f64, Vec<Run>)>,
    pub(super) minor: Vec<f64>,
    /// A factor or an offset common to all labels, written at the end of the axis.
    pub(super) note: Option<Vec<Run>>,
}

/// The ticks for an axis of this length in points.
pub(super) fn ticks(interval: Interval, length: f64, direction: Direction) -> Ticks {
    let room = Room { length, direction };
    match interval.scale {
        Scale::Linear => linear(interval, interval.lower, interval.upper, room),
        Scale::Logarithmic => logarithmic(interval, room),
    }
}

#[derive(Clone, Copy)]
struct Room {
    length: f64,
    direction: Direction,
}

impl Room {
    fn fits(self, labels: &[(f64, Vec<Run>)]) -> bool {
        labels.len() <= MOST_LABELS
            && labels.windows(2).all(|pair| {
                let distance = (pair[1].0 - pair[0].0) * self.length;
                let needed = match self.direction {
                    Direction::Horizontal => {
                        let both = label::width(&pair[0].1, style::TICK_SIZE) + label::width(&pair[1].1, style::TICK_SIZE);
                        0.5 * both + 0.8 * style::TICK_SIZE
                    }
                    Direction::Vertical => 2.0 * style::TICK_SIZE,
                };
                distance >= needed
            })
    }
}

/// `digits` times `10^exponent`, exactly.
#[derive(Debug, Clone, Copy)]
struct Decimal {
    digits: i64,
    exponent: i32,
}

impl Decimal {
    fn value(self) -> f64 {
        format!("{}e{}", self.digits, self.exponent).parse().unwrap_or(f64::NAN)
    }

    fn length(self) -> usize {
        self.digits.unsigned_abs().to_string().len()
    }

    /// The number times `10^-shift`, written out.
    fn written(self, shift: i32) -> String {
        if self.digits == 0 {
            return "0".to_owned();
        }
        let sign = if self.digits < 0 { "−" } else { "" };
        let digits = self.digits.unsigned_abs().to_string();
        let exponent = self.exponent - shift;
        if exponent >= 0 {
            return format!("{sign}{digits}{}", "0".repeat(usize::try_from(exponent).unwrap_or(0)));
        }
        let decimals = usize::try_from(-exponent).unwrap_or(0);
        let padded = format!("{}{digits}", "0".repeat((decimals + 1).saturating_sub(digits.len())));
        let (whole, rest) = padded.split_at(padded.len() - decimals);
        format!("{sign}{whole}.{rest}")
    }

    /// The exponent of the leading digit.
    fn magnitude(self) -> i32 {
        self.exponent + i32::try_from(self.length()).unwrap_or(0) - 1
    }
}

fn linear(interval: Interval, lower: f64, upper: f64, room: Room) -> Ticks {
    let half = half_length(lower, upper);
    let finest = ((half / 5.0).log10().floor().clamp(-330.0, 308.0)) as i32;
    let mut chosen = Ticks::default();
    for exponent in finest..finest + 3 {
        for factor in [1_i64, 2, 5] {
            let step = Decimal { digits: factor, exponent };
            let Some(numbers) = multiples(step, lower, upper) else { continue };
            if numbers.len() < 2 && chosen.major.len() >= 2 {
                return chosen;
            }
            let (labels, note) = written(&numbers);
            let major = placed(interval, &numbers, labels);
            if major.len() < 2 {
                continue;
            }
            let fits = room.fits(&major);
            let minor = linear_minor(interval, step, (lower, upper), room);
            chosen = Ticks { major, minor, note };
            if fits {
                return chosen;
            }
        }
    }
    chosen
}

/// The multiples of the step in the range, unless they are too many to be labelled.
fn multiples(step: Decimal, lower: f64, upper: f64) -> Option<Vec<Decimal>> {
    const SLACK: f64 = 1e-9; // of a step: an end that is a multiple but for rounding keeps its label
    let size = step.value();
    let (first, last) = ((lower / size - SLACK).ceil(), (upper / size + SLACK).floor());
    if !(first.abs() < 1e15 && last.abs() < 1e15) || last - first > 60.0 {
        return None;
    }
    let (first, last) = (first as i64, last as i64);
    Some((first..=last).map(|index| Decimal { digits: index * step.digits, exponent: step.exponent }).collect())
}

fn placed(interval: Interval, numbers: &[Decimal], labels: Vec<Vec<Run>>) -> Vec<(f64, Vec<Run>)> {
    numbers
        .iter()
        .zip(labels)
        .filter_map(|(number, runs)| interval.fraction(number.value()).map(|place| (place.clamp(0.0, 1.0), runs)))
        .collect()
}

fn linear_minor(interval: Interval, step: Decimal, range: (f64, f64), room: Room) -> Vec<f64> {
    let finer = match step.digits {
        1 => Decimal { digits: 2, exponent: step.exponent - 1 },
        2 => Decimal { digits: 5, exponent: step.exponent - 1 },
        _ => Decimal { digits: 1, exponent: step.exponent },
    };
    let places: Vec<f64> = multiples(finer, range.0, range.1)
        .unwrap_or_default()
        .into_iter()
        .filter(|number| number.digits * if finer.exponent < step.exponent { 1 } else { 10 } % (10 * step.digits) != 0)
        .filter_map(|number| interval.fraction(number.value()))
        .filter(|place| (0.0..=1.0).contains(place))
        .collect();
    if places.windows(2).all(|pair| (pair[1] - pair[0]) * room.length >= CLOSEST_MINOR) { places } else { Vec::new() }
}

/// The labels of evenly spaced numbers, and what they have in common.
fn written(numbers: &[Decimal]) -> (Vec<Vec<Run>>, Option<Vec<Run>>) {
    let roundest = numbers.iter().rev().copied().max_by_key(|number| trailing_zeros(number.digits));
    let (Some(base), Some(longest)) = (roundest, numbers.iter().copied().max_by_key(|n| n.digits.unsigned_abs())) else {
        return (Vec::new(), None);
    };
    let rests: Vec<Decimal> = numbers.iter().map(|n| Decimal { digits: n.digits - base.digits, ..*n }).collect();
    let longest_rest = rests.iter().copied().max_by_key(|n| n.digits.unsigned_abs()).unwrap_or(longest);
    if longest.length() > MOST_DIGITS && longest.length() >= longest_rest.length() + 3 {
        let (labels, factor) = written_with_factor(&rests, longest_rest);
        let mut note = factor.unwrap_or_default();
        note.extend(label::plain(if base.digits < 0 { " − " } else { " + " }));
        note.extend(written_alone(Decimal { digits: base.digits.abs(), ..base }));
        return (labels, Some(note));
    }
    written_with_factor(numbers, longest)
}

fn trailing_zeros(digits: i64) -> usize {
    let written = digits.to_string();
    written.len() - written.trim_end_matches('0').len()
}

fn written_with_factor(numbers: &[Decimal], longest: Decimal) -> (Vec<Vec<Run>>, Option<Vec<Run>>) {
    let magnitude = longest.magnitude();
    if longest.digits == 0 || (-3..=4).contains(&magnitude) {
        return (numbers.iter().map(|n| label::plain(&n.written(0))).collect(), None);
    }
    (numbers.iter().map(|n| label::plain(&n.written(magnitude))).collect(), Some(label::power_of_ten("×", magnitude)))
}

/// A number on its own: written out if that is short, else with a power of ten.
fn written_alone(number: Decimal) -> Vec<Run> {
    let trimmed = |text: String| {
        if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
    };
    let magnitude = number.magnitude();
    if (-3..=5).contains(&magnitude) {
        label::plain(&trimmed(number.written(0)))
    } else {
        let mantissa = trimmed(number.written(magnitude));
        if mantissa == "1" { label::power_of_ten("", magnitude) } else { label::power_of_ten(&format!("{mantissa}×"), magnitude) }
    }
}

fn logarithmic(interval: Interval, room: Room) -> Ticks {
    const SLACK: f64 = 1e-9; // decades
    let first = (interval.lower - SLACK).ceil() as i32;
    let last = (interval.upper + SLACK).floor() as i32;
    let decade = room.length / (interval.upper - interval.lower);
    if last - first >= 1 {
        return decades(interval, (first, last), decade, room);
    }
    within_decades(interval, decade, room).unwrap_or_else(|| {
        // Less than two round numbers: the axis is so short that it is nearly linear, and gets the ticks of a linear one.
        linear(interval, 10_f64.powf(interval.lower), 10_f64.powf(interval.upper), room)
    })
}

fn exponent_place(interval: Interval, exponent: f64) -> f64 {
    ((exponent - interval.lower) / (interval.upper - interval.lower)).clamp(0.0, 1.0)
}

/// Powers of ten, every `step` decades.
fn decades(interval: Interval, (first, last): (i32, i32), decade: f64, room: Room) -> Ticks {
    const STEPS: [i32; 16] = [1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 20, 30, 40, 50, 100, 200];
    let labelled = |step: i32| -> Vec<(f64, Vec<Run>)> {
        let start = first + (-first).rem_euclid(step);
        (start..=last)
            .step_by(usize::try_from(step).unwrap_or(1))
            .map(|exponent| (exponent_place(interval, f64::from(exponent)), label::power_of_ten("", exponent)))
            .collect()
    };
    let step = STEPS.into_iter().find(|step| room.fits(&labelled(*step))).unwrap_or(200);
    let minor = if step == 1 && decade >= SHORTEST_DIVIDED_DECADE {
        mantissas(interval, &[2, 3, 4, 5, 6, 7, 8, 9]).into_iter().map(|(place, _)| place).collect()
    } else {
        let finer = (1..step).find(|finer| step % finer == 0 && f64::from(*finer) * decade >= CLOSEST_MINOR);
        finer.map_or_else(Vec::new, |finer| {
            (first..=last)
                .filter(|exponent| exponent % finer == 0 && exponent % step != 0)
                .map(|exponent| exponent_place(interval, f64::from(exponent)))
                .collect()
        })
    };
    Ticks { major: labelled(step), minor, note: None }
}

/// The numbers `mantissa × 10^n` on the axis, with their places, in order.
fn mantissas(interval: Interval, allowed: &[i64]) -> Vec<(f64, Decimal)> {
    let (first, last) = (interval.lower.floor() as i32, interval.upper.floor() as i32);
    (first..=last)
        .flat_map(|exponent| allowed.iter().map(move |digits| Decimal { digits: *digits, exponent }))
        .map(|number| (number, f64::from(number.exponent) + (number.digits as f64).log10()))
        .filter(|(_, exponent)| (interval.lower - 1e-12..=interval.upper + 1e-12).contains(exponent))
        .map(|(number, exponent)| (exponent_place(interval, exponent), number))
        .collect()
}

/// Labels at 1, 2, 5 and the like, for an axis of about one decade.
fn within_decades(interval: Interval, decade: f64, room: Room) -> Option<Ticks> {
    const SETS: [&[i64]; 4] = [&[1, 2, 3, 4, 5, 6, 7, 8, 9], &[1, 2, 3, 5, 7], &[1, 2, 5], &[1, 3]];
    const ENOUGH: usize = 3;
    let labelled = |set: &[i64]| -> Vec<(f64, Vec<Run>)> {
        mantissas(interval, set).into_iter().map(|(place, number)| (place, written_alone(number))).collect()
    };
    let major = SETS.into_iter().map(labelled).find(|labels| room.fits(labels)).filter(|labels| labels.len() >= ENOUGH)?;
    let labelled_at = |place: f64| major.iter().any(|(known, _)| (known - place).abs() < 1e-9);
    let minor = if decade >= SHORTEST_DIVIDED_DECADE {
        mantissas(interval, &[1, 2, 3, 4, 5, 6, 7, 8, 9]).into_iter().map(|(place, _)| place).filter(|place| !labelled_at(*place)).collect()
    } else {
        Vec::new()
    };
    Some(Ticks { major, minor, note: None })
}
