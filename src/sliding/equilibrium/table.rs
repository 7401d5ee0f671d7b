//! Both edge conditions at every half-width of a range, from those at a few.
//!
//! Along x = ln tan(a/2) lines and forms, divided by what they are of an elastic contact ([`super::works`]), are smooth: their Chebyshev series on panels of x end
//! after a few terms, and what the series leave out stays small beside a work.

use super::forms::{Conditions, Form, Line};
use super::works::{Works, even_and_odd, scales, third};
use crate::sliding::contact::{ContactEdges, Indenter};
use std::f64::consts::PI;

/// Degrees of the series that are tried on a panel before it is divided: the nodes of each are among those of the next.
const DEGREES: [usize; 3] = [14, 28, 56];
/// The longest panel: of longer ones hardly any is as smooth as the highest degree.
const LONGEST: f64 = 6.0;
/// A panel that is not divided, whatever is left out.
const SHORTEST: f64 = 0.2;
/// A panel that is left out if any of its half-widths is refused.
const NARROWEST: f64 = 1e-3;
/// Half-widths after which no panel is divided any more: ten times those of twelve terms over seven decades. Hundreds of decades, which no scene of this world has, are
/// then known less well.
const MOST_NODES: usize = 4000;
/// Largest coefficient of the last terms, over the first ones.
const TOLERANCE: f64 = 1e-6;
/// The same over the least of what they add up to, times this part.
const LOCAL: f64 = 0.1;
/// The same of what a moved edge changes: it is looked at for signs alone.
const SIGN_TOLERANCE: f64 = 1e-4;

/// Series of all numbers of both conditions over a part of the range.
#[derive(Debug)]
struct Panel {
    middle: f64,
    half: f64,
    /// By degree.
    series: Vec<Vec<f64>>,
}

/// Both conditions of a range of half-widths.
#[derive(Debug)]
pub(super) struct Table {
    indenter: Indenter,
    panels: Vec<Panel>,
    /// Lines of amplitudes.
    lines: usize,
    with_works: bool,
}

impl Table {
    /// From the conditions of single half-widths.
    pub(super) fn new(indenter: Indenter, [low, high]: [f64; 2], conditions: impl Fn(ContactEdges) -> Option<Conditions>) -> Self {
        let mut table = Self { indenter, panels: Vec::new(), lines: 0, with_works: false };
        let count = ((high - low) / LONGEST).ceil().max(1.0);
        let border = |index: f64| low + (high - low) * index / count;
        let mut open: Vec<[f64; 2]> =
            (0..count as u32).rev().map(|index| [border(f64::from(index)), border(f64::from(index + 1))]).collect();
        let at = |place: f64, table: &mut Self| -> Option<Vec<f64>> {
            let found = conditions(ContactEdges::at_place(indenter, place, 0.0))?;
            (table.lines, table.with_works) = (found.amplitudes.len(), found.works.is_some());
            Some(flattened(indenter, &found, place))
        };
        let mut nodes = 0;
        while let Some([low, high]) = open.pop() {
            let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
            let mut values: Vec<Vec<f64>> = Vec::new();
            let (mut settled, mut refused, mut before) = (None, false, None);
            for degree in DEGREES {
                let known = std::mem::take(&mut values);
                for index in 0..=degree {
                    // The nodes of half the degree are every second one.
                    match known.get(index / 2).filter(|_| index % 2 == 0) {
                        Some(value) => values.push(value.clone()),
                        None => {
                            nodes += 1;
                            match at(middle + half * (PI * index as f64 / degree as f64).cos(), &mut table) {
                                Some(value) => values.push(value),
                                None => break,
                            }
                        }
                    }
                }
                refused = values.len() <= degree;
                if refused {
                    break;
                }
                let series = series(&values);
                let left_out = table.left_out(&series, &values, middle);
                // What is left out falls as a power of the degree.
                let (ratio, more) = (before.map_or(left_out, |before| left_out / before), (DEGREES[2] - degree) as f64);
                let by = if before.is_some() { 2.0 * more } else { more } / degree as f64;
                let hopeless = left_out * ratio.powf(by) > TOLERANCE || degree == DEGREES[2];
                if left_out <= TOLERANCE || (hopeless && (half < SHORTEST || nodes > MOST_NODES)) {
                    settled = Some(series);
                    break;
                }
                if hopeless {
                    break;
                }
                before = Some(left_out);
            }
            match settled {
                Some(series) => table.panels.push(Panel { middle, half, series }),
                // Nothing is known of a half-width that is refused: the zone may be wider than the room there.
                None if refused && (half < NARROWEST || nodes > MOST_NODES) => {}
                // Nor of a segment at whose ends and middle there is none.
                None if refused && half < SHORTEST && [low, middle, high].into_iter().all(|place| at(place, &mut table).is_none()) => {}
                None => open.extend([[middle, high], [low, middle]]),
            }
        }
        table
    }

    /// The last terms of a series, over the first ones: every line beside itself, every entry of a form beside the works that its squares do. A part of it over what
    /// they are at the node where that is least: along a long panel a solid goes from glassy to relaxed.
    fn left_out(&self, series: &[Vec<f64>], values: &[Vec<f64>], place: f64) -> f64 {
        let Some((last, before)) = series.last().zip(series.len().checked_sub(2).and_then(|index| series.get(index))) else {
            return f64::INFINITY;
        };
        let tail = |index: usize| last[index].abs().max(before[index].abs());
        let size = |index: usize| series.iter().map(|terms| terms[index].abs()).sum::<f64>();
        let over = |tail: f64, size: f64| if tail == 0.0 { 0.0 } else { tail / size };
        let line = |begin: usize| {
            let largest = (begin..begin + 3).map(size).fold(0.0, f64::max);
            let of_node = |node: &Vec<f64>| (begin..begin + 3).map(|index| node[index].abs()).fold(0.0, f64::max);
            let largest = largest.min(values.iter().map(of_node).fold(f64::INFINITY, f64::min) / LOCAL);
            (begin..begin + 3).map(|index| over(tail(index), largest)).fold(0.0, worse)
        };
        let forms = 3 * (self.lines + 1);
        let first =
            |line: usize| -> Line { series.first().map_or([f64::NAN; 3], |terms| std::array::from_fn(|column| terms[3 * line + column])) };
        let third: f64 = third(&first(0), &first(1)).iter().map(|part| part * part).sum();
        let of_works = place.exp() / (third * scales(self.indenter, place).0[0]);
        let form = |begin: usize| {
            const SQUARES: [[usize; 2]; 6] = [[0, 0], [1, 1], [2, 2], [0, 1], [0, 2], [1, 2]];
            // What a form must be for the contact without amplitudes to do the works of the adhesion: less is lost beside them.
            let squares = [size(begin), size(begin + 1), size(begin + 2).max(of_works)];
            let entries = SQUARES.iter().enumerate().map(|(index, [row, column])| {
                let of_node = |node: &Vec<f64>| {
                    let square = |index: usize| node[begin + index].abs().max(if index == 2 { of_works } else { 0.0 });
                    (square(*row) * square(*column)).sqrt().max(node[begin + index].abs())
                };
                let least = values.iter().map(of_node).fold(f64::INFINITY, f64::min);
                over(tail(begin + index), (squares[*row] * squares[*column]).sqrt().max(size(begin + index)).min(least / LOCAL))
            });
            entries.fold(0.0, worse)
        };
        let moved = (2..self.lines).map(|index| line(3 * index) * (TOLERANCE / SIGN_TOLERANCE)).fold(0.0, worse);
        let works = if self.with_works { worse(form(forms), form(forms + 6)) } else { 0.0 };
        [line(0), line(3), line(3 * self.lines), moved, works].into_iter().fold(0.0, worse)
    }

    /// The conditions at a place; none outside of the range.
    pub(super) fn at(&self, place: f64) -> Option<Conditions> {
        let panel = self.panels.iter().find(|panel| (place - panel.middle).abs() <= panel.half * (1.0 + 1e-12))?;
        let twice = 2.0 * (place - panel.middle) / panel.half;
        let mut values = vec![0.0; panel.series.first().map_or(0, Vec::len)];
        // T_k and T_(k+1).
        let (mut now, mut next) = (1.0, 0.5 * twice);
        for terms in &panel.series {
            for (value, term) in values.iter_mut().zip(terms) {
                *value += now * term;
            }
            (now, next) = (next, twice * next - now);
        }
        Some(self.restored(&values, place))
    }

    fn restored(&self, values: &[f64], place: f64) -> Conditions {
        let (scales, cosine) = scales(self.indenter, place);
        let plain = |index: usize| -> Line { std::array::from_fn(|column| values[3 * index + column]) };
        let full = |line: Line, size: f64| -> Line { std::array::from_fn(|column| line[column] * scales[column] * size) };
        let (sum, difference) = (plain(0), plain(1));
        let mut amplitudes: Vec<Line> =
            [1.0, -1.0].map(|sign| full(std::array::from_fn(|column| 0.5 * (sum[column] + sign * difference[column])), cosine)).to_vec();
        for index in 2..self.lines {
            let (own, moved) = (amplitudes[index % 2], full(plain(index), cosine));
            amplitudes.push(std::array::from_fn(|column| own[column] + moved[column]));
        }
        let depth = (self.indenter == Indenter::Wave).then(|| full(plain(self.lines), cosine));
        let works = self.with_works.then(|| {
            let weight = (-place).exp();
            let form = |edge: usize| -> Form { std::array::from_fn(|index| weight * values[3 * (self.lines + 1) + 6 * edge + index]) };
            Works::new(self.indenter, place, [sum, difference], [form(0), form(1)])
        });
        Conditions { indenter: self.indenter, works, amplitudes, depth }
    }
}

/// The numbers of both conditions, divided by what they are of an elastic contact: lines (sum and difference of the two amplitudes first), depth, forms.
fn flattened(indenter: Indenter, conditions: &Conditions, place: f64) -> Vec<f64> {
    let (scales, cosine) = scales(indenter, place);
    let flat = |line: &Line| -> Line { std::array::from_fn(|column| line[column] / (scales[column] * cosine)) };
    let mut values = Vec::with_capacity(33);
    let mut lines: Vec<Line> = conditions.amplitudes.iter().map(flat).collect();
    if let [trailing, leading, ..] = &conditions.amplitudes[..] {
        let [sum, difference] = even_and_odd(indenter, place, trailing, leading);
        (lines[0], lines[1]) = (sum, difference);
    }
    // Those of a moved edge by what moving it changes: that is small, and so is an amplitude.
    for (index, line) in conditions.amplitudes.iter().enumerate().skip(2) {
        let own = conditions.amplitudes.get(index % 2).map_or([f64::NAN; 3], flat);
        lines[index] = std::array::from_fn(|column| flat(line)[column] - own[column]);
    }
    values.extend(lines.iter().flatten());
    values.extend(conditions.depth.as_ref().map_or([0.0; 3], flat));
    if let Some(works) = &conditions.works {
        values.extend(works.forms.iter().flatten().map(|entry| entry * place.exp()));
    }
    values
}

/// The larger one; what is not a number is larger than any.
const fn worse(one: f64, other: f64) -> f64 {
    if one.is_nan() || other.is_nan() { f64::INFINITY } else { one.max(other) }
}

/// The Chebyshev coefficients of values at cos(πj/n).
fn series(values: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let degree = values.len() - 1;
    let cosines: Vec<f64> = (0..2 * degree).map(|turns| (PI * turns as f64 / degree as f64).cos()).collect();
    let ends = |index: usize| if index == 0 || index == degree { 0.5 } else { 1.0 };
    (0..=degree)
        .map(|order| {
            let mut terms = vec![0.0; values.first().map_or(0, Vec::len)];
            for (node, here) in values.iter().enumerate() {
                let weight = 2.0 / degree as f64 * ends(order) * ends(node) * cosines[order * node % (2 * degree)];
                for (term, value) in terms.iter_mut().zip(here) {
                    *term += weight * value;
                }
            }
            terms
        })
        .collect()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::expect_used)]
    use super::*;

    #[test]
    fn a_flattened_condition_is_restored() {
        let forms = [[3.0, 1.5, 7.0, 0.3, -2.0, 0.4], [-1.0, 0.5, 2.0, 0.1, 1.0, 4.0]];
        let amplitudes = vec![[1.0, 0.2, -3.0], [1.1, -0.3, -2.9], [0.5, 0.5, 1.0], [0.1, 0.2, 0.3], [0.7, -0.1, 0.2], [1.0, 1.0, 1.0]];
        for place in [-3.0, 0.1, 2.0] {
            let at = |place: f64| Conditions {
                indenter: Indenter::Wave,
                works: Some(Works::new(Indenter::Wave, place, even_and_odd(Indenter::Wave, place, &amplitudes[0], &amplitudes[1]), forms)),
                amplitudes: amplitudes.clone(),
                depth: Some([0.1, 0.2, 0.3]),
            };
            let table = Table::new(Indenter::Wave, [place - 0.1, place + 0.1], |edges| Some(at(edges.place())));
            let conditions = at(place);
            let found = table.at(place).expect("inside");
            let (works, right) = (found.works.expect("works"), conditions.works.expect("works"));
            for edge in [0, 1] {
                let [one, other] = [works, right].map(|works| works.work(edge, (0.8, 0.6), 0.3));
                assert!((one - other).abs() < 1e-5 * (1.0 + other.abs()), "{place}: {one} {other}");
            }
            for (one, other) in found.amplitudes.iter().flatten().zip(conditions.amplitudes.iter().flatten()) {
                assert!((one - other).abs() < 1e-6, "{place}: {:?}", found.amplitudes);
            }
        }
    }
}
