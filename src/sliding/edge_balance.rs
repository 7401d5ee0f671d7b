//! What must hold at the two edges of a sliding contact, and the edges at which it does.
//!
//! ```text
//! adhesive       work_i(l₁, l₂) = (1/2δ_i) ∫ tension₊ gap₋ = 2πΓ_i   at the trailing (i = 1) and at the leading edge (i = 2)
//! adhesiveless   k_i(l₁, l₂) = 0                                     no edge is singular
//! ```
//! Each work is quadratic in the amplitude of its edge, so √(work_i/2πΓ_i) − 1 is nearly linear in the edges: that is the residual. The unknowns
//! are the half-width and the eccentricity, or, at a prescribed half-width, the mean pressure and the eccentricity. Every adhesive contact has
//! four roots, as a pressed edge with interpenetrating faces does the same work as a pulled one: the residual takes the sign of the amplitude, so
//! that three of them are none, and after each solve the signs, also in the moved contacts, and the gap are checked ([`Admissibility`]). The moved contacts keep the
//! penetration of the contact as it is, not its load.
//!
//! Source: thesis Secs 3.2 and 3.3.

use super::contact::{
    ContactEdges, ContactMemory, ContactState, ContactSystem, Indenter, Prescribed, ProcessZone, Resolution, WaveContact, ZoneFields,
    ZonePressure, ZoneWork,
};
use crate::continuation::two_unknowns::{Jacobian, Solution, TwoEquations, TwoResiduals, largest};
use crate::estimate::Estimate;
use crate::refusal::Refusal;
use std::cell::{Cell, RefCell};
use std::f64::consts::PI;
use std::sync::Arc;

/// Adhesion of a wave contact in reduced units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WaveAdhesion {
    /// Γ = Δγ/(πE0*kΛ²) of the trailing edge, where the contact opens.
    pub trailing_work: f64,
    /// Γ of the leading edge, where it closes; smaller where the interface itself dissipates (adhesion hysteresis).
    pub leading_work: f64,
    /// δ of the trailing edge, in 1/k.
    pub trailing_zone: f64,
    /// δ of the leading edge, in 1/k.
    pub leading_zone: f64,
}

impl WaveAdhesion {
    /// The same work and the same process zone at both edges.
    #[must_use]
    pub const fn even(reduced_work: f64, zone: f64) -> Self {
        Self { trailing_work: reduced_work, leading_work: reduced_work, trailing_zone: zone, leading_zone: zone }
    }

    /// Whether both edges take the same work.
    #[must_use]
    pub fn is_even(&self) -> bool {
        self.trailing_work.to_bits() == self.leading_work.to_bits()
    }

    /// With both works multiplied, that of the trailing edge by the first factor.
    #[must_use]
    pub fn with_works_times(self, [trailing, leading]: [f64; 2]) -> Self {
        Self { trailing_work: trailing * self.trailing_work, leading_work: leading * self.leading_work, ..self }
    }

    /// With the work of the trailing edge given, that of the leading edge in the same ratio to it.
    #[must_use]
    pub fn with_trailing_work(self, reduced_work: f64) -> Self {
        // The ratio of equal works is one to the last bit.
        Self { trailing_work: reduced_work, leading_work: reduced_work * (self.leading_work / self.trailing_work), ..self }
    }

    /// With both process zones multiplied.
    #[must_use]
    pub fn with_zones_times(self, factor: f64) -> Self {
        Self { trailing_zone: factor * self.trailing_zone, leading_zone: factor * self.leading_zone, ..self }
    }

    /// The larger of both works.
    pub(super) const fn larger_work(&self) -> f64 {
        self.trailing_work.max(self.leading_work)
    }

    /// 2πΓ of both edges, which the works are held against.
    pub(super) fn targets(&self) -> [f64; 2] {
        [2.0 * PI * self.trailing_work, 2.0 * PI * self.leading_work]
    }
}

/// What is prescribed of a contact besides its speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SlidingControl {
    /// Mean pressure p̄; may be zero or negative with adhesion.
    MeanPressure(f64),
    /// Penetration Δ: 0 where the crest touches, 1 at full contact. Not available for [`Indenter::Parabola`].
    Penetration(f64),
    /// Half the contact width a; the mean pressure is found.
    HalfWidth(f64),
}

/// What was checked of an accepted state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Admissibility {
    /// Both edges are pulled, in the contact and in both moved ones; without adhesion: neither is singular.
    pub edges_pulled: bool,
    /// The smallest gap found outside the contact, over the largest.
    pub smallest_gap: f64,
}

impl Admissibility {
    /// Whether the state can exist.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.edges_pulled && self.smallest_gap > 0.0
    }
}

/// Steps of the search for the least gap between its neighbours: a thousandth of their distance.
const LEAST_STEPS: u32 = 14;
/// Points at which the gap is looked at, on each side of the contact.
const GAP_POINTS: u32 = 16;
/// Longest step of an unknown in units of the room that it has.
const LONGEST_STEP: f64 = 0.33;
/// Steps of difference quotients in units of the same room.
const DIFFERENCE: f64 = 1e-6;
/// Longest step of difference quotients in the eccentricity of a narrow gap.
const MOST_OF_ROOM: f64 = 1e-3;
/// Rounding of a condition over the size of its terms.
const ROUNDING: f64 = 8.0 * f64::EPSILON;
/// Rounding of the load, over itself: it opens or closes a gap by itself times the half-width of the gap.
const LOAD_ROUNDING: f64 = 8.0 * f64::EPSILON;
/// A gap this far below zero, over the largest, is rounding.
const GAP_ROUNDING: f64 = 1e-13;

/// The conditions at one pair of unknowns.
#[derive(Debug, Clone)]
pub struct EdgeStates {
    /// The contact.
    pub state: ContactState,
    /// The contacts with the trailing and with the leading edge moved out; none without adhesion.
    pub moved: Option<(ContactState, ContactState)>,
    /// The pressures inside the moved edges.
    tensions: Option<(ZonePressure, ZonePressure)>,
    /// The two residuals.
    residual: [f64; 2],
    /// The same as smooth functions, whatever the signs of the amplitudes.
    smooth: [f64; 2],
    /// What rounding leaves uncertain of each.
    pub rounding: [f64; 2],
}

impl EdgeStates {
    /// The residuals as smooth functions of the edges and the load, also across a place where an edge is pressed.
    pub(in crate::sliding) const fn smooth_residual(&self) -> [f64; 2] {
        self.smooth
    }
}

impl TwoResiduals for EdgeStates {
    fn residual(&self) -> [f64; 2] {
        self.residual
    }

    fn rounding(&self) -> f64 {
        largest(self.rounding)
    }
}

/// The two conditions for one material, speed, adhesion and control.
#[derive(Debug, Clone)]
pub struct EdgeBalance {
    memory: Arc<ContactMemory>,
    indenter: Indenter,
    adhesion: Option<(WaveAdhesion, Arc<(ProcessZone, ProcessZone)>)>,
    control: SlidingControl,
    resolution: Resolution,
    evaluations: Cell<u64>,
    /// The systems of the half-width that was asked for last: eccentricities, loads and release rates share them.
    systems: RefCell<Option<(ContactEdges, Arc<Systems>)>>,
}

/// The linear systems of a half-width.
#[derive(Debug)]
pub(in crate::sliding) struct Systems {
    pub(in crate::sliding) own: ContactSystem,
    pub(in crate::sliding) moved: Option<MovedSystems>,
}

/// Those with an edge moved out; equal zones widen a contact alike.
#[derive(Debug)]
pub(in crate::sliding) struct MovedSystems {
    trailing: ContactSystem,
    leading: Option<ContactSystem>,
    pub(in crate::sliding) fields: [ZoneFields; 2],
}

impl MovedSystems {
    /// Of the trailing and of the leading edge.
    pub(in crate::sliding) fn both(&self) -> [&ContactSystem; 2] {
        [&self.trailing, self.leading.as_ref().unwrap_or(&self.trailing)]
    }
}

impl EdgeBalance {
    /// Prepares the conditions; all numbers are taken as checked.
    #[must_use]
    pub fn new(
        memory: Arc<ContactMemory>,
        indenter: Indenter,
        adhesion: Option<WaveAdhesion>,
        control: SlidingControl,
        resolution: Resolution,
    ) -> Self {
        let adhesion = adhesion.map(|adhesion| {
            let zones = ProcessZone::both(&memory, indenter, (adhesion.trailing_zone, adhesion.leading_zone), resolution);
            (adhesion, Arc::new(zones))
        });
        Self { memory, indenter, adhesion, control, resolution, evaluations: Cell::new(0), systems: RefCell::new(None) }
    }

    /// The same conditions under another control; what is prepared is shared.
    #[must_use]
    pub fn under(&self, control: SlidingControl) -> Self {
        Self { control, evaluations: Cell::new(0), ..self.clone() }
    }

    /// The adhesion.
    #[must_use]
    pub fn adhesion(&self) -> Option<WaveAdhesion> {
        self.adhesion.as_ref().map(|(adhesion, ..)| *adhesion)
    }

    /// The adhesion with the zones that are prepared for it.
    pub(in crate::sliding) fn with_zones(&self) -> Option<(WaveAdhesion, Arc<(ProcessZone, ProcessZone)>)> {
        self.adhesion.clone()
    }

    /// The material at its speed.
    pub(in crate::sliding) const fn memory(&self) -> &Arc<ContactMemory> {
        &self.memory
    }

    /// The indenter.
    pub(in crate::sliding) const fn indenter(&self) -> Indenter {
        self.indenter
    }

    /// The resolution.
    #[must_use]
    pub const fn resolution(&self) -> Resolution {
        self.resolution
    }

    /// Contacts solved for one evaluation.
    #[must_use]
    pub(crate) const fn contacts_per_evaluation(&self) -> u64 {
        if self.adhesion.is_some() { 3 } else { 1 }
    }

    /// Evaluations since this was last asked, those that led to nothing as well.
    pub(crate) fn take_evaluations(&self) -> u64 {
        self.evaluations.take()
    }

    /// The edges and the prescription that a pair of unknowns stands for.
    fn placed(&self, [first, eccentricity]: [f64; 2]) -> (WaveContact, Prescribed) {
        match self.control {
            SlidingControl::MeanPressure(pressure) => (WaveContact { half_width: first, eccentricity }, Prescribed::MeanPressure(pressure)),
            SlidingControl::Penetration(penetration) => {
                (WaveContact { half_width: first, eccentricity }, Prescribed::Penetration(penetration))
            }
            SlidingControl::HalfWidth(half_width) => (WaveContact { half_width, eccentricity }, Prescribed::MeanPressure(first)),
        }
    }

    /// The conditions at a pair of unknowns.
    ///
    /// # Errors
    /// Those of the contacts; [`Refusal::NotConverged`] where a work is not a number.
    pub fn evaluate(&self, unknowns: [f64; 2]) -> Result<EdgeStates, Refusal> {
        let (contact, prescribed) = self.placed(unknowns);
        self.evaluate_at(contact, prescribed)
    }

    /// The conditions at given edges under any prescription, whatever the control.
    ///
    /// # Errors
    /// As [`EdgeBalance::evaluate`].
    pub fn evaluate_at(&self, contact: WaveContact, prescribed: Prescribed) -> Result<EdgeStates, Refusal> {
        self.evaluate_edges(ContactEdges::new(self.indenter, contact), prescribed)
    }

    /// The conditions at given edges, of which half the gap is known to its own digits.
    ///
    /// # Errors
    /// As [`EdgeBalance::evaluate`].
    pub(crate) fn evaluate_edges(&self, edges: ContactEdges, prescribed: Prescribed) -> Result<EdgeStates, Refusal> {
        self.evaluations.set(self.evaluations.get() + 1);
        let systems = self.systems_of(edges)?;
        let state = systems.own.state(edges.eccentricity, prescribed)?;
        let (Some((adhesion, zones)), Some(wider)) = (&self.adhesion, &systems.moved) else {
            let half = self.indenter.half_angle_scale(edges.half_width);
            let (behind, ahead) = state.edge_amplitudes();
            let scale = self.memory.stiffening_ratio() * half;
            let rounding = ROUNDING * (1.0 + state.condition().ln());
            let residual = [behind / scale, ahead / scale];
            return Ok(EdgeStates { state, moved: None, tensions: None, residual, smooth: residual, rounding: [rounding, rounding] });
        };
        let (trailing, leading) = &**zones;
        let behind = edges.moved_out(-trailing.length());
        let ahead = edges.moved_out(leading.length());
        let [trailing_system, leading_system] = wider.both();
        let trailing_moved = trailing_system.state(behind.eccentricity, state.held())?;
        let leading_moved = leading_system.state(ahead.eccentricity, state.held())?;
        let targets = adhesion.targets();
        // With the sign of the amplitude the root goes on linearly where the edge is pressed, instead of rising to a second zero.
        let root = |work: f64, target: f64| if work > 0.0 { (work / target).sqrt() } else { work / target };
        let defect = |root: f64, amplitude: f64| if amplitude > 0.0 { -root.abs() - 1.0 } else { root - 1.0 };
        let amplitudes = state.edge_amplitudes();
        let [behind, ahead] = &wider.fields;
        let tensions = (trailing.tension_by(behind, &trailing_moved), leading.tension_by(ahead, &leading_moved));
        let gaps = (trailing.gap_by(behind, &state), leading.gap_by(ahead, &state));
        let works = (trailing.work_of(&tensions.0, &gaps.0), leading.work_of(&tensions.1, &gaps.1));
        let roots = [root(works.0.value, targets[0]), root(works.1.value, targets[1])];
        let (residual, smooth) = ([defect(roots[0], amplitudes.0), defect(roots[1], amplitudes.1)], roots.map(|root| root - 1.0));
        let digits = 1.0 + state.condition().ln();
        // The amplitude of an edge is what two loads of the size of the whole differ by, times cos(a/2): nothing but rounding where adhesion is weak enough.
        let cosine = if edges.half_gap.is_finite() { (0.5 * edges.half_gap).sin() } else { 1.0 };
        let load = state.mean_pressure().abs() * cosine + self.indenter.half_angle_scale(edges.half_width);
        let lost = |amplitude: f64| ROUNDING * self.memory.stiffening_ratio() * load / amplitude.abs();
        let rounding = [
            (ROUNDING * digits * works.0.size / targets[0]).max(lost(amplitudes.0)),
            (ROUNDING * digits * works.1.size / targets[1]).max(lost(amplitudes.1)),
        ];
        if residual.iter().any(|value| value.is_nan()) {
            return Err(Refusal::NotConverged { what: "the closure of a sliding edge", detail: "the work is not a number".into() });
        }
        Ok(EdgeStates { state, moved: Some((trailing_moved, leading_moved)), tensions: Some(tensions), residual, smooth, rounding })
    }

    /// The systems of a half-width.
    pub(in crate::sliding) fn systems_of(&self, edges: ContactEdges) -> Result<Arc<Systems>, Refusal> {
        let edges = ContactEdges { eccentricity: 0.0, ..edges };
        if let Some((of, systems)) = &*self.systems.borrow()
            && *of == edges
        {
            return Ok(Arc::clone(systems));
        }
        let new = |edges| ContactSystem::new(&self.memory, self.indenter, edges, self.resolution);
        let own = new(edges)?;
        let moved = match &self.adhesion {
            None => None,
            Some((_, zones)) => {
                let [trailing, leading] = [&zones.0, &zones.1].map(ProcessZone::length);
                let even = trailing.to_bits() == leading.to_bits();
                let behind = new(edges.moved_out(-trailing))?;
                let ahead = if even { None } else { Some(new(edges.moved_out(leading))?) };
                let first = zones.0.fields(&behind, &own);
                let second = ahead.as_ref().map_or_else(|| first.mirrored(), |ahead| zones.1.fields(ahead, &own));
                Some(MovedSystems { trailing: behind, leading: ahead, fields: [first, second] })
            }
        };
        let systems = Arc::new(Systems { own, moved });
        *self.systems.borrow_mut() = Some((edges, Arc::clone(&systems)));
        Ok(systems)
    }

    /// G/Δγ of both edges at a root, each over the work of its own edge, with what rounding leaves uncertain: [U(edge moved) − U]/(2πΓδ) at fixed penetration; none
    /// without adhesion.
    ///
    /// # Errors
    /// Those of the reversed contact.
    pub fn releases(&self, states: &EdgeStates) -> Result<Option<(Estimate, Estimate)>, Refusal> {
        let (Some((adhesion, zones)), Some(tensions)) = (&self.adhesion, &states.tensions) else {
            return Ok(None);
        };
        let (trailing, leading) = &**zones;
        let edges = states.state.edges();
        let reversed = self.systems_of(edges)?.own.state(-edges.eccentricity, states.state.held())?;
        let targets = adhesion.targets();
        let over = |target: f64, work: ZoneWork| Estimate::new(work.value / target, ROUNDING * work.size / target);
        Ok(Some((over(targets[0], trailing.release(&reversed, &tensions.0)), over(targets[1], leading.release(&reversed, &tensions.1)))))
    }

    /// The room that each unknown has: a length for edges, a pressure for the mean pressure.
    #[must_use]
    pub fn room(&self, [first, _]: [f64; 2]) -> [f64; 2] {
        match self.control {
            SlidingControl::HalfWidth(half_width) => {
                [self.indenter.half_angle_scale(half_width) + first.abs(), self.room_of_eccentricity(half_width)]
            }
            _ => [first.min(self.indenter.widest() - first), self.room_of_eccentricity(first)],
        }
    }

    /// Near full contact a gap may be anywhere on the wave.
    fn room_of_eccentricity(&self, half_width: f64) -> f64 {
        match self.indenter {
            Indenter::Wave => half_width.min(1.0),
            Indenter::Parabola => half_width,
        }
    }

    /// Solves both conditions from a pair of unknowns; the root is not yet checked for admissibility.
    ///
    /// # Errors
    /// [`Refusal::NotConverged`].
    pub fn solve(&self, start: [f64; 2], jacobian: Option<Jacobian>, tolerance: f64) -> Result<Solution<EdgeStates>, Refusal> {
        self.with_equations(|equations| equations.solve(start, jacobian, tolerance))
    }

    /// The difference steps of the unknowns.
    #[must_use]
    pub fn differences(&self, unknowns: [f64; 2]) -> [f64; 2] {
        let [first, eccentricity] = self.room(unknowns).map(|room| DIFFERENCE * room);
        let half_width = if let SlidingControl::HalfWidth(half_width) = self.control { half_width } else { unknowns[0] };
        let (Indenter::Wave, Some((adhesion, ..))) = (self.indenter, &self.adhesion) else { return [first, eccentricity] };
        // Across a narrow gap the pressure of the wave hardly changes: what an eccentricity does is this many times smaller than one.
        let gap = PI - half_width;
        let tilts = (adhesion.larger_work() / (0.5 * gap).tan()).sqrt() / gap;
        [first, eccentricity.max((f64::EPSILON * tilts).sqrt().min(MOST_OF_ROOM))]
    }

    fn with_equations<R>(
        &self,
        run: impl FnOnce(
            &TwoEquations<'_, &dyn Fn([f64; 2]) -> Result<EdgeStates, Refusal>, &dyn Fn([f64; 2], [f64; 2]) -> f64>,
        ) -> Result<R, Refusal>,
    ) -> Result<R, Refusal> {
        let evaluate = |unknowns| self.evaluate(unknowns);
        let limit = |unknowns: [f64; 2], step: [f64; 2]| {
            let room = self.room(unknowns);
            // The eccentricity may move by more than the narrower arc allows the edges to.
            let part = |index: usize, share: f64| share * room[index] / step[index].abs().max(f64::MIN_POSITIVE);
            part(0, LONGEST_STEP).min(part(1, 2.0 * LONGEST_STEP))
        };
        let differences = |unknowns| self.differences(unknowns);
        run(&TwoEquations {
            what: if self.adhesion.is_some() {
                "the edges of an adhesive sliding contact"
            } else {
                "the edges of an adhesiveless sliding contact"
            },
            evaluate: &(&evaluate as &dyn Fn([f64; 2]) -> Result<EdgeStates, Refusal>),
            limit: &(&limit as &dyn Fn([f64; 2], [f64; 2]) -> f64),
            differences: &differences,
        })
    }

    /// Looks at the signs of a root.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] only if a point of the gap is out of it: a defect.
    pub fn admissibility(&self, states: &EdgeStates) -> Result<Admissibility, Refusal> {
        let state = &states.state;
        let pulled = |contact: &ContactState| contact.edge_amplitudes().0 < 0.0 && contact.edge_amplitudes().1 < 0.0;
        let edges_pulled = states.moved.as_ref().is_none_or(|(trailing, leading)| pulled(state) && pulled(trailing) && pulled(leading));
        // Far from a parabola nothing can touch: its gap is looked at as far as the contact and its memory reach.
        let half_width = state.contact().half_width;
        // Signs need no digits.
        let rough = state.evaluated_at(Resolution::Coarse);
        let half_gap = match self.indenter {
            Indenter::Wave => state.edges().half_gap,
            Indenter::Parabola => 10.0 * half_width,
        };
        // From the leading edge around to the trailing one: t in half gaps.
        let gap_at = |t: f64| -> Result<f64, Refusal> {
            let point = if t <= 1.0 { state.ahead_of_leading(t * half_gap)? } else { state.behind_trailing((2.0 - t) * half_gap)? };
            Ok(rough.gap(point))
        };
        // Dense at both edges, where interpenetration begins.
        let part = |index: u32| 1.0 - (0.5 * PI * f64::from(index) / f64::from(GAP_POINTS)).cos();
        let places: Vec<f64> = (1..=GAP_POINTS).map(part).chain((1..GAP_POINTS).rev().map(|index| 2.0 - part(index))).collect();
        let gaps = places.iter().map(|&t| gap_at(t)).collect::<Result<Vec<f64>, Refusal>>()?;
        let largest = gaps.iter().copied().fold(0.0, f64::max);
        let mut smallest = gaps.iter().copied().fold(f64::INFINITY, f64::min);
        // Between two points faces may meet unseen.
        for (place, gap) in places.windows(3).zip(gaps.windows(3)) {
            if let ([from, _, to], [before, middle, after]) = (place, gap)
                && middle <= before
                && middle <= after
            {
                smallest = smallest.min(least(*from, *to, gap_at)?);
            }
        }
        // Without adhesion the gap opens as the distance to the power 3/2 and may be lost to rounding at the edge; a narrow one is lost as a whole to that of the load,
        // which differs from the load of full contact by the square of the gap.
        let rounding = if states.moved.is_none() {
            let load = state.mean_pressure().abs() + self.indenter.half_angle_scale(half_width);
            GAP_ROUNDING * largest + LOAD_ROUNDING * load * half_gap.min(1.0)
        } else {
            0.0
        };
        Ok(Admissibility { edges_pulled, smallest_gap: (smallest + rounding) / largest.max(rounding) })
    }

    /// Solves both conditions and checks the root.
    ///
    /// # Errors
    /// [`Refusal::NotConverged`], also for a root that cannot exist.
    pub fn solve_admissible(
        &self,
        start: [f64; 2],
        jacobian: Option<Jacobian>,
        tolerance: f64,
    ) -> Result<(Solution<EdgeStates>, Admissibility), Refusal> {
        let found = self.solve(start, jacobian, tolerance)?;
        let admissibility = self.admissibility(&found.solution)?;
        if admissibility.holds() {
            Ok((found, admissibility))
        } else {
            Err(Refusal::NotConverged {
                what: "the edges of a sliding contact",
                detail: "the root found is unphysical (a pressed edge or interpenetrating faces)".into(),
            })
        }
    }
}

/// The least value of a function between two arguments, by the golden section.
fn least(mut low: f64, mut high: f64, function: impl Fn(f64) -> Result<f64, Refusal>) -> Result<f64, Refusal> {
    // 2/(1 + √5)
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let inner = |low: f64, high: f64| (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
    let (mut one, mut other) = inner(low, high);
    let (mut at_one, mut at_other) = (function(one)?, function(other)?);
    for _ in 0..LEAST_STEPS {
        if at_one < at_other {
            (high, other, at_other) = (other, one, at_one);
            one = inner(low, high).0;
            at_one = function(one)?;
        } else {
            (low, one, at_one) = (one, other, at_other);
            other = inner(low, high).1;
            at_other = function(other)?;
        }
    }
    Ok(at_one.min(at_other))
}
