//! One test: its data, and the model at the same places.
//!
//! A contact that is lost, or that the surface jumps into, leaves a jump in the curve. Compared row by row, a jump that is a row early would weigh more than
//! all other rows and would change in steps. So the rows beside it are compared with the contact as it is on their side, and the place of the jump is a
//! datum of its own, known to the distance of two rows (standard deviation: the distance over √12).

use super::interpolate::Branch;
use super::noise;
use crate::plan::{PathCurve, Plan};
use crate::scene::document::{Document, Node, Value};
use crate::scene::read;
use crate::scene::typed::Problem;
use rayon::prelude::*;

/// Instants of a ramp without adhesion, whose way is known where it is asked for only.
const INSTANTS: u32 = 200;
/// The key of Δγ.
pub(super) const WORK: &str = "adhesion.work_of_adhesion";
/// An unresolved place is known no better than this part of the range of the data.
const PLACE: f64 = 1e-5;

/// What the data show where the scene has zero, in the units of the scene.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Offsets {
    pub(super) depth: f64,
    pub(super) time: f64,
    pub(super) force: f64,
    pub(super) drift: f64,
}

/// A number that is put into a scene.
#[derive(Debug, Clone)]
pub(super) struct Put {
    pub(super) key: String,
    pub(super) place: crate::scene::diagnostic::Place,
}

/// A column that is compared.
#[derive(Debug, Clone)]
pub(super) struct Compared {
    pub(super) word: String,
    /// A number a row.
    pub(super) values: Vec<f64>,
    /// Its SI unit; empty without units.
    pub(super) unit: String,
    /// Standard deviation of its noise, guessed from the data.
    pub(super) noise: f64,
}

/// A test.
#[derive(Debug, Clone)]
pub(super) struct Comparison {
    pub(super) file: String,
    /// The scene with what differs in this test.
    pub(super) document: Document,
    /// What the data are given against: its word, and whether it is a number of the scene.
    pub(super) against: String,
    /// The SI unit of that; empty without units.
    pub(super) unit: String,
    pub(super) across: Option<Put>,
    pub(super) abscissa: Vec<f64>,
    pub(super) time: Option<Vec<f64>>,
    pub(super) columns: Vec<Compared>,
    /// Rows that are compared: all but those on the fall of a jump.
    pub(super) rows: Vec<usize>,
    /// Rows beside the jump into contact, and beside the loss of it.
    pub(super) gain: Option<[usize; 2]>,
    pub(super) loss: Option<[usize; 2]>,
    /// Whether logarithms are compared.
    pub(super) relative: bool,
    /// Δγ of attraction beside a contact that it does not deform (Derjaguin, Muller and Toporov), in place of adhesion at its edge.
    pub(super) beside: Option<f64>,
    /// Whether ranges of attraction that are so short that an edge is their limit have no numbers here.
    pub(super) long_ranges_only: bool,
}

impl Comparison {
    /// Finds the jumps of a test along a history.
    pub(super) fn with_jumps(mut self) -> Self {
        let shown = self
            .columns
            .iter()
            .find(|column| column.word == "force")
            .or_else(|| self.columns.iter().find(|column| column.word == "contact_radius"));
        let Some(column) = shown else { return self };
        let pulls = column.word == "force";
        let count = column.values.len();
        self.loss = noise::loss(&column.values, pulls);
        let reversed: Vec<f64> = column.values.iter().rev().copied().collect();
        let gain = noise::loss(&reversed, pulls).map(|[inside, outside]| [count - 1 - outside, count - 1 - inside]);
        self.gain = gain.filter(|gain| self.loss.is_none_or(|loss| gain[1] < loss[0]));
        let on_a_fall = |row: &usize| [self.gain, self.loss].into_iter().flatten().any(|[from, to]| *row > from && *row < to);
        let beside_loss = self.beside_loss();
        self.rows.retain(|row| !on_a_fall(row) && !beside_loss.contains(row));
        self
    }

    /// Rows in contact that are nearer to its loss than the place of that is known: there the force falls without bounds in a way, and tells no more than the place.
    fn beside_loss(&self) -> Vec<usize> {
        let place = |row: usize| self.abscissa.get(row).copied();
        let Some(([from, _], (first, last))) = self.loss.and_then(|loss| Some((loss, (place(loss[0])?, place(loss[1])?)))) else {
            return Vec::new();
        };
        let (middle, width) = (0.5 * (first + last), (last - first).abs());
        (0..=from).rev().take_while(|row| place(*row).is_some_and(|place| (place - middle).abs() < width)).collect()
    }

    /// Places of jumps in the data and what they are known to.
    pub(super) fn jumps(&self) -> Vec<(f64, f64)> {
        let (low, high) = self.range();
        let place = |[from, to]: [usize; 2]| {
            let (one, other) = (*self.abscissa.get(from)?, *self.abscissa.get(to)?);
            Some((0.5 * (one + other), ((one - other).abs() / 12_f64.sqrt()).max(PLACE * (high - low))))
        };
        [self.gain, self.loss].into_iter().flatten().filter_map(place).collect()
    }

    /// The smallest and the largest abscissa.
    pub(super) fn range(&self) -> (f64, f64) {
        self.abscissa.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(*value), high.max(*value)))
    }

    /// The number that is compared for a value.
    fn shown(&self, value: f64) -> Option<f64> {
        if self.relative { (value > 0.0).then(|| value.ln()) } else { Some(value) }
    }

    /// The data as they are compared: columns, then the places of jumps.
    pub(super) fn data(&self) -> Option<Vec<f64>> {
        let of = |column: &Compared| {
            self.rows.iter().filter_map(|&row| column.values.get(row)).map(|value| self.shown(*value)).collect::<Vec<_>>()
        };
        let columns = self.columns.iter().flat_map(of);
        columns.chain(self.jumps().into_iter().map(|jump| Some(jump.0))).collect()
    }

    /// The model at the places of the data.
    pub(super) fn model(&self, values: &[(&Put, f64)], offsets: Offsets, tolerance: f64) -> Result<Vec<f64>, String> {
        let mut document = self.document.clone();
        let mut beside = self.beside;
        for (put, value) in values {
            if beside.is_some() && put.key == WORK {
                beside = Some(*value);
                continue;
            }
            document
                .replace(&put.key, Node { value: Value::Number(*value), place: put.place.clone() })
                .map_err(|error| error.to_string())?;
        }
        match &self.across {
            Some(across) => self.across_states(&document, across, tolerance),
            None => {
                if self.long_ranges_only {
                    super::other_theory::has_a_long_range(&document)?;
                }
                self.along(&curve_of(&document, tolerance, beside)?, offsets)
            }
        }
    }

    fn across_states(&self, document: &Document, across: &Put, tolerance: f64) -> Result<Vec<f64>, String> {
        let state = |row: &usize| -> Result<Vec<f64>, String> {
            let mut document = document.clone();
            let value = self.abscissa.get(*row).copied().ok_or("a row is missing")?;
            document
                .replace(&across.key, Node { value: Value::Number(value), place: across.place.clone() })
                .map_err(|error| error.to_string())?;
            let mut scene = read::read_state(&document).map_err(|error| error.to_string())?;
            scene.accuracy = tolerance;
            let plan = Plan::new(&scene).map_err(|refusal| refusal.to_string())?;
            let columns = plan.columns();
            let rows = plan.solve(0, &[]);
            let answer = rows.first().ok_or("there is no result")?;
            if !answer.status.has_values() {
                return Err(format!("{} = {value:e}: {}", across.key, answer.reason.as_deref().unwrap_or("no such state")));
            }
            self.columns
                .iter()
                .map(|column| {
                    let place = columns.iter().position(|known| known.name == column.word);
                    let found = place.and_then(|place| answer.values.get(place).copied().flatten());
                    found
                        .and_then(|found| self.shown(found.value))
                        .ok_or_else(|| format!("{} = {value:e} has no {}", across.key, column.word))
                })
                .collect()
        };
        let states: Vec<Vec<f64>> = self.rows.par_iter().map(state).collect::<Result<_, _>>()?;
        Ok((0..self.columns.len()).flat_map(|column| states.iter().filter_map(move |state| state.get(column).copied())).collect())
    }

    fn along(&self, curve: &PathCurve, offsets: Offsets) -> Result<Vec<f64>, String> {
        let missing = |word: &str| format!("the scene has no {word}: a `frame` needs indentation.frame_stiffness");
        let abscissa = curve.column(&self.against).ok_or_else(|| missing(&self.against))?;
        let shift = if self.against == "time" { offsets.time } else { offsets.depth };
        let last = abscissa.len().checked_sub(1).ok_or("the way has no points")?;
        let largest = |values: &[f64]| values.iter().enumerate().max_by(|one, other| one.1.total_cmp(other.1)).map_or(0, |peak| peak.0);
        // Given against a depth, the way in and the way out are two branches.
        let (turn, turn_of_data) = if self.against == "time" { (last, usize::MAX) } else { (largest(abscissa), largest(&self.abscissa)) };
        let [first_touch, last_touch] = curve.contact.unwrap_or([0, last]);
        let branch = |from: usize, to: usize| (from <= to).then(|| Branch::of(abscissa, &curve.pieces, from..=to));
        let whole = [branch(0, turn), branch(turn, last)];
        let touching = [branch(first_touch, turn.min(last_touch)), branch(turn.max(first_touch), last_touch)];
        let open = last_touch.checked_add(1).and_then(|from| branch(from, last));
        let near = first_touch.checked_sub(1).and_then(|to| branch(0, to));
        let (gained, lost) = (curve.gained_at(&self.against), curve.lost_at(&self.against));
        let begin = self.time.as_ref().and_then(|time| time.first().copied()).unwrap_or(0.0);
        let mut model = Vec::with_capacity(self.rows.len() * self.columns.len() + 2);
        for column in &self.columns {
            let ordinate = curve.column(&column.word).ok_or_else(|| missing(&column.word))?;
            let vanishes = matches!(column.word.as_str(), "force" | "contact_radius");
            for &row in &self.rows {
                let shown = *self.abscissa.get(row).ok_or("a row is missing")?;
                let (place, side) = (shown - shift, usize::from(row > turn_of_data));
                let either = |branches: &[Option<Branch>; 2]| {
                    branches
                        .get(side)
                        .and_then(Option::as_ref)
                        .or_else(|| branches.iter().flatten().next())
                        .and_then(|one| one.value(ordinate, place))
                };
                let free = self.gain.is_some_and(|gain| row <= gain[0]);
                let gone = match self.loss {
                    Some(loss) => row >= loss[1],
                    // Without a jump in the data it lies where the model has it.
                    None if self.against == "time" => lost.is_some_and(|lost| place >= lost),
                    None => side == 1 && lost.is_some_and(|lost| place <= lost),
                };
                let untouched = side == 0 && self.gain.is_none() && gained.is_some_and(|gained| place <= gained);
                let value = if curve.at_a_distance && (free || untouched) {
                    near.as_ref()
                        .and_then(|near| near.value(ordinate, place))
                        .or_else(|| either(&whole))
                        .ok_or("a row lies on no branch")?
                } else if (free || gone || untouched) && vanishes && !curve.at_a_distance {
                    0.0
                } else if gone {
                    open.as_ref()
                        .and_then(|open| open.value(ordinate, place))
                        .or_else(|| either(&whole))
                        .ok_or("a row lies on no branch")?
                } else if self.gain.is_some() || self.loss.is_some() || lost.is_some() {
                    either(&touching).or_else(|| either(&whole)).ok_or("a row lies on no branch")?
                } else {
                    either(&whole).ok_or("a row lies on no branch")?
                };
                let now = self.time.as_ref().and_then(|time| time.get(row).copied()).unwrap_or(begin);
                let offset = match column.word.as_str() {
                    "force" => offsets.force + offsets.drift * (now - begin),
                    "penetration" | "frame" => offsets.depth,
                    _ => 0.0,
                };
                model.push(self.shown(value + offset).ok_or_else(|| format!("the model's {} is not above zero", column.word))?);
            }
        }
        // A contact that stays counts as lost a little beyond the end of the history.
        let (end, start) = (*abscissa.last().ok_or("the way has no points")?, *abscissa.first().ok_or("the way has no points")?);
        let (low, high) = self.range();
        let beyond = 0.05 * (high - low) * if end < *abscissa.get(turn).unwrap_or(&end) { -1.0 } else { 1.0 };
        if self.gain.is_some() {
            model.push(gained.unwrap_or(start) + shift);
        }
        if self.loss.is_some() {
            model.push(lost.unwrap_or(end + beyond) + shift);
        }
        Ok(model)
    }
}

/// The way of a scene at a tolerance.
pub(super) fn curve_of(document: &Document, tolerance: f64, beside: Option<f64>) -> Result<PathCurve, String> {
    let mut scene = read::read_state(document).map_err(|error| error.to_string())?;
    if let Problem::Indentation(indentation) = &mut scene.problem
        && indentation.adhesion.is_none()
    {
        indentation.instants = indentation.instants.max(INSTANTS);
    }
    let attraction = beside.map(|work| super::beside::attracted(&mut scene, work)).transpose()?;
    let plan = Plan::new(&scene).map_err(|refusal| refusal.to_string())?;
    let mut curve = plan.curve(tolerance).ok_or("the problem has no history of contact")?.map_err(|refusal| refusal.to_string())?;
    if let Some(attraction) = attraction {
        attraction.put_into(&mut curve);
    }
    Ok(curve)
}
