//! Every steady contact of one half-width, speed and adhesion, without a start.
//!
//! At given half-width and speed both fields of a contact are linear in cos e, sin e and p̄ (of a parabola in 1, e and p̄), and so are those of the contacts with a
//! moved edge at the same penetration. The closure work of each edge is therefore a quadratic form
//! ```text
//! work_i/2πΓ_i = uᵀA_i u = 1,    u = (cos e, sin e, p̄)        i = trailing, leading
//! ```
//! known from six contacts. For each e the two conditions give p̄ in closed form, two values each; where one of the first equals one of the second along e,
//! there is a root, and none elsewhere. Those whose edges are pulled and whose faces do not meet are the contacts. So no branch can hide: what is not on a branch that was
//! followed belongs to another one. Source: our own.

use crate::continuation::two_unknowns::{TwoResiduals, largest};
use crate::refusal::Refusal;
use crate::sliding::contact::{ContactEdges, ContactMemory, ContactState, Indenter, Prescribed, ProcessZone, Resolution, WaveContact};
use crate::sliding::edge_balance::{EdgeBalance, SlidingControl, WaveAdhesion};
use std::cell::Cell;
use std::f64::consts::PI;
use std::sync::Arc;

/// Eccentricities at which both conditions are compared.
const COMPARED: usize = 720;
/// Halvings between two of them.
const HALVINGS: usize = 48;
/// Largest residual of a root.
const ROOT: f64 = 1e-4;
/// Eccentricities nearer than this are those of one contact (across a narrow gap rounding moves them).
const SAME: f64 = 1e-5;
/// Eccentricities of a parabola go from −tan to +tan of this, in units of where the load of the other edge balances.
const WIDEST_ANGLE: f64 = 1.5;

/// A steady contact of a half-width.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactAt {
    /// a.
    pub half_width: f64,
    /// e.
    pub eccentricity: f64,
    /// p̄.
    pub mean_pressure: f64,
    /// Δ.
    pub penetration: f64,
}

/// The six coefficients of a quadratic form in (c, s, p): cc, ss, pp, cs, cp, sp.
type Form = [f64; 6];
/// The three of a linear form.
type Line = [f64; 3];

/// The contacts of one material, speed and adhesion.
pub(super) struct EveryContact {
    balance: EdgeBalance,
    memory: Arc<ContactMemory>,
    indenter: Indenter,
    adhesion: WaveAdhesion,
    zones: (ProcessZone, ProcessZone),
    resolution: Resolution,
    /// How often both conditions were evaluated.
    evaluations: Cell<u64>,
}

/// The conditions of a half-width.
struct Conditions {
    works: [Form; 2],
    /// Amplitudes of the trailing and of the leading edge, in the contact and in both moved ones.
    amplitudes: [Line; 6],
}

impl EveryContact {
    pub(super) fn new(memory: Arc<ContactMemory>, indenter: Indenter, adhesion: WaveAdhesion, resolution: Resolution) -> Self {
        let zones = ProcessZone::both(&memory, indenter, (adhesion.trailing_zone, adhesion.leading_zone), resolution);
        let control = SlidingControl::MeanPressure(0.0);
        let balance = EdgeBalance::new(Arc::clone(&memory), indenter, Some(adhesion), control, resolution);
        Self { balance, memory, indenter, adhesion, zones, resolution, evaluations: Cell::new(0) }
    }

    /// How often both conditions were evaluated, each three contacts.
    pub(super) fn evaluations(&self) -> u64 {
        self.evaluations.set(self.evaluations.get() + self.balance.take_evaluations());
        self.evaluations.get()
    }

    /// The contacts of a half-width, in the order of their eccentricities.
    ///
    /// # Errors
    /// Those of the contacts; [`Refusal::NotConverged`] where a work is not a number.
    pub(super) fn at(&self, half_width: f64) -> Result<Vec<ContactAt>, Refusal> {
        let (conditions, reach) = self.conditions(half_width)?;
        let mut found: Vec<ContactAt> = Vec::new();
        for (eccentricity, mean_pressure) in conditions.roots(self.indenter, reach) {
            let direction = direction(self.indenter, eccentricity);
            if conditions.amplitudes.iter().any(|line| of_line(line, direction, mean_pressure) >= 0.0) {
                continue;
            }
            let contact = WaveContact { half_width, eccentricity };
            let states = self.balance.evaluate_at(contact, Prescribed::MeanPressure(mean_pressure))?;
            if largest(states.residual()) < ROOT && self.balance.admissibility(&states)?.holds() {
                found.push(ContactAt { half_width, eccentricity, mean_pressure, penetration: states.state.penetration() });
            }
        }
        found.sort_by(|first, second| first.eccentricity.total_cmp(&second.eccentricity));
        found.dedup_by(|first, second| (first.eccentricity - second.eccentricity).abs() < SAME * (1.0 + second.eccentricity.abs()));
        // π is −π.
        if let ([first, .., last], Indenter::Wave) = (&found[..], self.indenter)
            && 2.0 * PI - (last.eccentricity - first.eccentricity) < SAME
        {
            found.pop();
        }
        Ok(found)
    }

    /// Both forms at a half-width, from six contacts, and the size of eccentricities.
    fn conditions(&self, half_width: f64) -> Result<(Conditions, f64), Refusal> {
        let (beta, work) = (self.memory.stiffening_ratio(), self.adhesion.larger_work());
        let slope = match self.indenter {
            Indenter::Wave => (0.5 * half_width).tan(),
            Indenter::Parabola => 0.5 * half_width,
        };
        let load = self.indenter.half_angle_scale(half_width) + (work * slope * beta.sqrt()).sqrt();
        let reach = match self.indenter {
            Indenter::Wave => 1.0,
            Indenter::Parabola => half_width + 10.0 * load / half_width,
        };
        let quarter = 0.5 * PI;
        let places = match self.indenter {
            Indenter::Wave => [(0.0, 0.0), (0.0, load), (0.0, -load), (quarter, 0.0), (quarter, load), (0.5 * quarter, 0.0)],
            Indenter::Parabola => [(0.0, 0.0), (0.0, load), (0.0, -load), (reach, 0.0), (reach, load), (-reach, 0.0)],
        };
        let mut values = [[0.0; 8]; 6];
        for (value, (eccentricity, pressure)) in values.iter_mut().zip(places) {
            *value = self.numbers(half_width, eccentricity, pressure)?;
        }
        if values.iter().flatten().any(|value| value.is_nan()) {
            return Err(Refusal::NotConverged { what: "the closure of a sliding edge", detail: "a work is not a number".into() });
        }
        let form = |index: usize| -> Form {
            let [none, pressed, pulled, aside, aside_pressed, other] = values.map(|value| value.get(index).copied().unwrap_or(f64::NAN));
            let pp = (pressed + pulled - 2.0 * none) / (2.0 * load * load);
            let cp = (pressed - pulled) / (2.0 * load);
            match self.indenter {
                Indenter::Wave => [none, aside, pp, 2.0 * other - none - aside, cp, (aside_pressed - aside) / load - pp * load],
                Indenter::Parabola => {
                    let ss = (aside + other - 2.0 * none) / (2.0 * reach * reach);
                    [none, ss, pp, (aside - other) / (2.0 * reach), cp, ((aside_pressed - aside) / load - pp * load - cp) / reach]
                }
            }
        };
        let line = |index: usize| -> Line {
            let [none, pressed, _, aside, ..] = values.map(|value| value.get(index).copied().unwrap_or(f64::NAN));
            let aside = if self.indenter == Indenter::Wave { aside } else { (aside - none) / reach };
            [none, aside, (pressed - none) / load]
        };
        let conditions = Conditions { works: [form(0), form(1)], amplitudes: std::array::from_fn(|index| line(index + 2)) };
        Ok((conditions, reach))
    }

    /// Both works over 2πΓ, and the amplitudes of both edges in the contact and in the moved ones.
    fn numbers(&self, half_width: f64, eccentricity: f64, pressure: f64) -> Result<[f64; 8], Refusal> {
        let edges = ContactEdges::new(self.indenter, WaveContact { half_width, eccentricity });
        self.evaluations.set(self.evaluations.get() + 1);
        let solve = |edges, prescribed| ContactState::at_edges(&self.memory, self.indenter, edges, prescribed, self.resolution);
        let state = solve(edges, Prescribed::MeanPressure(pressure))?;
        let (trailing, leading) = &self.zones;
        let behind = solve(edges.moved_out(-trailing.length()), state.held())?;
        let ahead = solve(edges.moved_out(leading.length()), state.held())?;
        let targets = self.adhesion.targets();
        let works = [trailing.work(&state, &trailing.tension(&behind)), leading.work(&state, &leading.tension(&ahead))];
        let [own, moved, other] = [&state, &behind, &ahead].map(ContactState::edge_amplitudes);
        Ok([works[0].value / targets[0], works[1].value / targets[1], own.0, own.1, moved.0, moved.1, other.0, other.1])
    }
}

/// (cos e, sin e), of a parabola (1, e).
fn direction(indenter: Indenter, eccentricity: f64) -> (f64, f64) {
    match indenter {
        Indenter::Wave => (eccentricity.cos(), eccentricity.sin()),
        Indenter::Parabola => (1.0, eccentricity),
    }
}

fn of_line([c, s, p]: &Line, (cosine, sine): (f64, f64), pressure: f64) -> f64 {
    c * cosine + s * sine + p * pressure
}

/// Both mean pressures at which a form is one.
fn pressures([cc, ss, pp, cs, cp, sp]: &Form, (c, s): (f64, f64)) -> [f64; 2] {
    let (half, rest) = (0.5 * (cp * c + sp * s), cc * c * c + ss * s * s + cs * c * s - 1.0);
    let root = (half * half - pp * rest).sqrt();
    // Without cancellation: the product of both is rest/pp.
    let sum = if half < 0.0 { -half + root } else { -half - root };
    let (first, second) = (sum / pp, rest / sum);
    [first.min(second), first.max(second)]
}

impl Conditions {
    /// Eccentricity and mean pressure of every root of both conditions.
    fn roots(&self, indenter: Indenter, reach: f64) -> Vec<(f64, f64)> {
        let place = |index: f64| {
            let part = 2.0 * index / COMPARED as f64 - 1.0;
            match indenter {
                Indenter::Wave => part * PI,
                Indenter::Parabola => reach * (part * WIDEST_ANGLE).tan(),
            }
        };
        let mut roots = Vec::new();
        for (first, second) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let at = |index: f64| {
                let direction = direction(indenter, place(index));
                let pick = |edge: usize, which: usize| {
                    self.works.get(edge).and_then(|form| pressures(form, direction).get(which).copied()).unwrap_or(f64::NAN)
                };
                (pick(0, first), pick(1, second))
            };
            let difference = |index: f64| {
                let (one, other) = at(index);
                one - other
            };
            let mut add = |mut low: f64, mut high: f64| {
                let sign = difference(low) < 0.0;
                for _ in 0..HALVINGS {
                    let middle = 0.5 * (low + high);
                    if (difference(middle) < 0.0) == sign {
                        low = middle;
                    } else {
                        high = middle;
                    }
                }
                let index = 0.5 * (low + high);
                roots.push((place(index), at(index).0));
            };
            let values: Vec<f64> = (0..=COMPARED).map(|index| difference(index as f64)).collect();
            for (index, pair) in values.windows(2).enumerate() {
                if let [from, to] = *pair
                    && from * to <= 0.0
                {
                    add(index as f64, index as f64 + 1.0);
                }
            }
            // Two roots between neighbours: where the difference comes near zero and goes back.
            for (index, triple) in values.windows(3).enumerate() {
                let [from, middle, to] = *triple else { continue };
                if from * middle > 0.0 && middle * to > 0.0 && middle.abs() <= from.abs().min(to.abs()) {
                    let (mut low, mut high) = (index as f64, index as f64 + 2.0);
                    for _ in 0..HALVINGS {
                        let (one, other) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
                        if difference(one) * middle.signum() < difference(other) * middle.signum() {
                            high = other;
                        } else {
                            low = one;
                        }
                    }
                    let nearest = 0.5 * (low + high);
                    if difference(nearest) * middle < 0.0 {
                        add(index as f64, nearest);
                        add(nearest, index as f64 + 2.0);
                    }
                }
            }
        }
        roots
    }
}
