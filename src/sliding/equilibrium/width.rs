//! Every steady contact of one half-width, speed and adhesion.
//!
//! So no branch can hide: what is not on a curve that was followed belongs to another one.

use super::existence::WhyNot;
use super::forms::{Conditions, Form, Line, direction, of_line, slopes};
use crate::continuation::two_unknowns::{TwoResiduals, largest};
use crate::refusal::Refusal;
use crate::sliding::contact::{
    ContactEdges, ContactMemory, ContactState, ContactSystem, Indenter, Prescribed, ProcessZone, Resolution, WaveContact,
};
use crate::sliding::edge_balance::{EdgeBalance, SlidingControl, WaveAdhesion};
use std::cell::Cell;
use std::f64::consts::PI;
use std::sync::Arc;

/// Largest residual of a root.
const ROOT: f64 = 1e-4;
/// Eccentricities nearer than this are those of one contact (across a narrow gap rounding moves them).
const SAME: f64 = 1e-5;

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

/// A contact of a half-width, with how its conditions follow eccentricity and load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Point {
    /// ln tan(a/2), of a parabola ln(a/2).
    pub(super) place: f64,
    pub(super) half_width: f64,
    pub(super) eccentricity: f64,
    pub(super) mean_pressure: f64,
    /// Δ − 1 of a wave, which keeps its digits near full contact; Δ of a parabola.
    pub(super) depth: f64,
    /// ∂(work_i/2πΓ)/∂e; without adhesion −∂(amplitude_i)/∂e.
    pub(super) by_shift: [f64; 2],
    /// ∂(work_i/2πΓ)/∂p̄.
    pub(super) by_load: [f64; 2],
    /// ∂Δ/∂e and ∂Δ/∂p̄.
    pub(super) depth_slopes: [f64; 2],
}

impl Point {
    pub(super) fn contact(&self, indenter: Indenter) -> ContactAt {
        ContactAt {
            half_width: self.half_width,
            eccentricity: self.eccentricity,
            mean_pressure: self.mean_pressure,
            penetration: match indenter {
                Indenter::Wave => 1.0 + self.depth,
                Indenter::Parabola => self.depth,
            },
        }
    }
}

/// The contacts of one material, speed and adhesion.
#[derive(Debug)]
pub(in crate::sliding) struct ContactsOfWidth {
    balance: EdgeBalance,
    memory: Arc<ContactMemory>,
    indenter: Indenter,
    adhesion: Option<(WaveAdhesion, (ProcessZone, ProcessZone))>,
    resolution: Resolution,
    /// Half-widths whose conditions were formed: each as much as two evaluations of both conditions.
    widths: Cell<u64>,
}

impl ContactsOfWidth {
    pub(in crate::sliding) fn new(
        memory: Arc<ContactMemory>,
        indenter: Indenter,
        adhesion: Option<WaveAdhesion>,
        resolution: Resolution,
    ) -> Self {
        let balance = EdgeBalance::new(Arc::clone(&memory), indenter, adhesion, SlidingControl::MeanPressure(0.0), resolution);
        let adhesion = adhesion.map(|adhesion| {
            let lengths = (adhesion.trailing_zone, adhesion.leading_zone);
            (adhesion, ProcessZone::both(&memory, indenter, lengths, resolution))
        });
        Self { balance, memory, indenter, adhesion, resolution, widths: Cell::new(0) }
    }

    pub(super) const fn indenter(&self) -> Indenter {
        self.indenter
    }

    /// Half-widths whose conditions were formed.
    pub(in crate::sliding) fn widths(&self) -> u64 {
        self.widths.get()
    }

    /// As how many evaluations of both conditions they count.
    pub(in crate::sliding) fn evaluations(&self) -> u64 {
        2 * self.widths.get() + self.balance.take_evaluations()
    }

    /// The contacts of a half-width that can exist, in the order of their eccentricities.
    ///
    /// # Errors
    /// Those of the contacts; [`Refusal::NotConverged`] where a work is not a number.
    pub(in crate::sliding) fn at(&self, half_width: f64) -> Result<Vec<ContactAt>, Refusal> {
        let edges = ContactEdges::new(self.indenter, WaveContact { half_width, eccentricity: 0.0 });
        let mut found = Vec::new();
        for point in self.points(edges)? {
            if self.can_exist(&point)? {
                found.push(point.contact(self.indenter));
            } else {
                // Of weak adhesion the point is rough.
                let control = SlidingControl::HalfWidth(half_width);
                let balance = self.balance.under(control);
                let near = balance.solve_admissible([point.mean_pressure, point.eccentricity], None, ROOT);
                self.widths.set(self.widths.get() + balance.take_evaluations().div_ceil(2));
                found.extend(near.ok().filter(|(found, _)| apart(self.indenter, found.unknowns[1], point.eccentricity) < SAME).map(
                    |(found, _)| {
                        let state = &found.solution.state;
                        ContactAt {
                            half_width,
                            eccentricity: found.unknowns[1],
                            mean_pressure: found.unknowns[0],
                            penetration: state.penetration(),
                        }
                    },
                ));
            }
        }
        Ok(found)
    }

    /// The contact of a control near a half-width and an eccentricity, if one can exist.
    pub(super) fn solved(&self, control: SlidingControl, start: [f64; 2]) -> Option<ContactAt> {
        let balance = self.balance.under(control);
        let found = balance.solve_admissible(start, None, ROOT).ok();
        self.widths.set(self.widths.get() + balance.take_evaluations().div_ceil(2));
        let (solution, _) = found?;
        let state = &solution.solution.state;
        Some(ContactAt {
            half_width: solution.unknowns[0],
            eccentricity: solution.unknowns[1],
            mean_pressure: state.mean_pressure(),
            penetration: state.penetration(),
        })
    }

    /// Whether a contact holds at the conditions themselves, with both edges pulled and no faces that meet.
    pub(super) fn can_exist(&self, point: &Point) -> Result<bool, Refusal> {
        let edges = ContactEdges::at_place(self.indenter, point.place, point.eccentricity);
        let states = self.balance.evaluate_edges(edges, Prescribed::MeanPressure(point.mean_pressure))?;
        Ok(largest(states.residual()) < ROOT && self.balance.admissibility(&states)?.holds())
    }

    /// The contacts of a half-width whose edges are pulled, in the order of their eccentricities; whether faces meet is not looked at.
    ///
    /// # Errors
    /// As [`ContactsOfWidth::at`].
    pub(super) fn points(&self, edges: ContactEdges) -> Result<Vec<Point>, Refusal> {
        let (system, conditions) = self.conditions(edges)?;
        let mut found = Vec::new();
        for (eccentricity, mean_pressure) in conditions.roots() {
            let direction = direction(self.indenter, eccentricity);
            if conditions.works.is_some() && conditions.amplitudes.iter().any(|line| of_line(line, direction, mean_pressure) >= 0.0) {
                continue;
            }
            found.push(self.point(edges, &system, &conditions, (eccentricity, mean_pressure))?);
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

    /// What forbids the contact near an eccentricity; none if the conditions have no root there, or nothing does.
    pub(super) fn why_not(&self, place: f64, eccentricity: f64) -> Option<WhyNot> {
        let edges = ContactEdges::at_place(self.indenter, place, 0.0);
        let (system, conditions) = self.conditions(edges).ok()?;
        let far = |root: &(f64, f64)| apart(self.indenter, root.0, eccentricity);
        let root = conditions.roots().into_iter().min_by(|first, second| far(first).total_cmp(&far(second)))?;
        let direction = direction(self.indenter, root.0);
        // Trailing and leading edge in turn.
        let pressed = conditions.amplitudes.iter().position(|line| of_line(line, direction, root.1) >= 0.0);
        match pressed.filter(|_| conditions.works.is_some()) {
            Some(index) if index % 2 == 0 => Some(WhyNot::TrailingPressed),
            Some(_) => Some(WhyNot::LeadingPressed),
            None => {
                let point = self.point(edges, &system, &conditions, root).ok()?;
                (!self.can_exist(&point).unwrap_or(true)).then_some(WhyNot::FacesMeet)
            }
        }
    }

    fn point(
        &self,
        edges: ContactEdges,
        system: &ContactSystem,
        conditions: &Conditions,
        (eccentricity, mean_pressure): (f64, f64),
    ) -> Result<Point, Refusal> {
        let (depth, depth_slopes) = match &conditions.depth {
            Some(line) => {
                let [c, s, p] = *line;
                let (cosine, sine) = direction(self.indenter, eccentricity);
                (of_line(line, (cosine, sine), mean_pressure), [s * cosine - c * sine, p])
            }
            // Relative to a datum, and nothing is held by it.
            None => (system.state(eccentricity, Prescribed::MeanPressure(mean_pressure))?.penetration(), [0.0, 1.0]),
        };
        let (trailing, leading) = match &conditions.works {
            Some(works) => {
                let [trailing, leading] = works.each_ref().map(|form| slopes(form, self.indenter, eccentricity, mean_pressure));
                (trailing, leading)
            }
            None => {
                let slopes = |line: Option<&Line>| {
                    let [c, s, p] = line.copied().unwrap_or([f64::NAN; 3]);
                    let (cosine, sine) = direction(self.indenter, eccentricity);
                    [if self.indenter == Indenter::Wave { c * sine - s * cosine } else { -s }, -p]
                };
                (slopes(conditions.amplitudes.first()), slopes(conditions.amplitudes.get(1)))
            }
        };
        Ok(Point {
            place: edges.place(),
            half_width: edges.half_width,
            eccentricity,
            mean_pressure,
            depth,
            by_shift: [trailing[0], leading[0]],
            by_load: [trailing[1], leading[1]],
            depth_slopes,
        })
    }

    /// Both conditions of a half-width, from three contacts: upright, pressed and aside.
    fn conditions(&self, edges: ContactEdges) -> Result<(ContactSystem, Conditions), Refusal> {
        let half_width = edges.half_width;
        self.widths.set(self.widths.get() + 1);
        let (beta, work) = (self.memory.stiffening_ratio(), self.adhesion.as_ref().map_or(0.0, |(adhesion, _)| adhesion.larger_work()));
        let slope = match self.indenter {
            Indenter::Wave => 1.0 / (0.5 * edges.half_gap).tan(),
            Indenter::Parabola => 0.5 * half_width,
        };
        let load = self.indenter.half_angle_scale(half_width) + (work * slope * beta.sqrt()).sqrt();
        let (reach, aside) = match self.indenter {
            Indenter::Wave => (1.0, 0.5 * PI),
            Indenter::Parabola => {
                let reach = half_width + 10.0 * load / half_width;
                (reach, reach)
            }
        };
        let system = |edges: ContactEdges| ContactSystem::new(&self.memory, self.indenter, edges, self.resolution);
        let places = [(0.0, 0.0), (0.0, load), (aside, 0.0)];
        let own = system(edges)?;
        let states = all(places.map(|(eccentricity, pressure)| own.state(eccentricity, Prescribed::MeanPressure(pressure))))?;
        // The coefficients of (c, s, p) from the values at the three places.
        let line = |[upright, pressed, beside]: [f64; 3]| -> Line {
            match self.indenter {
                Indenter::Wave => [upright, beside, (pressed - upright) / load],
                Indenter::Parabola => [upright, (beside - upright) / reach, (pressed - upright) / load],
            }
        };
        let amplitudes_of = |states: &[ContactState; 3]| {
            let values = states.each_ref().map(ContactState::edge_amplitudes);
            [line(values.map(|(trailing, _)| trailing)), line(values.map(|(_, leading)| leading))]
        };
        let mut amplitudes = amplitudes_of(&states).to_vec();
        let depth = (self.indenter == Indenter::Wave).then(|| line(states.each_ref().map(|state| -state.mean_separation())));
        let Some((adhesion, zones)) = &self.adhesion else {
            return Ok((own, Conditions { indenter: self.indenter, works: None, amplitudes, depth }));
        };
        let targets = adhesion.targets();
        let mut works = [[0.0; 6]; 2];
        // Equal zones widen the contact alike.
        let trailing_system = system(edges.moved_out(-zones.0.length()))?;
        let even = zones.0.length().to_bits() == zones.1.length().to_bits();
        let leading_system = if even { None } else { Some(system(edges.moved_out(zones.1.length()))?) };
        let systems = [&trailing_system, leading_system.as_ref().unwrap_or(&trailing_system)];
        for (((form, target), (zone, outward)), moved_system) in
            works.iter_mut().zip(targets).zip([(&zones.0, -1.0), (&zones.1, 1.0)]).zip(systems)
        {
            // The eccentricity of a moved contact is that of its own middle.
            let shift = 0.5 * outward * zone.length();
            let moved = all(states.each_ref().map(|state| moved_system.state(state.contact().eccentricity + shift, state.held())))?;
            amplitudes.extend(amplitudes_of(&moved));
            let (tensions, gaps) = (zone.tensions(&moved), zone.gaps_outside(&states));
            // work(m, n) of the tension of one contact on the gap of another.
            let cross = tensions.each_ref().map(|tension| gaps.each_ref().map(|gap| zone.work_on(tension, gap).value / target));
            *form = self.form(&cross, load, reach);
            if form.iter().any(|value| value.is_nan()) {
                return Err(Refusal::NotConverged { what: "the closure of a sliding edge", detail: "a work is not a number".into() });
            }
        }
        Ok((own, Conditions { indenter: self.indenter, works: Some(works), amplitudes, depth }))
    }

    /// The quadratic form of the works of the tensions of three contacts on their gaps.
    fn form(&self, cross: &[[f64; 3]; 3], load: f64, reach: f64) -> Form {
        // Rows of the change from the three contacts to (c, s, p).
        let change = match self.indenter {
            Indenter::Wave => [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [-1.0 / load, 1.0 / load, 0.0]],
            Indenter::Parabola => [[1.0, 0.0, 0.0], [-1.0 / reach, 0.0, 1.0 / reach], [-1.0 / load, 1.0 / load, 0.0]],
        };
        let entry = |first: usize, second: usize| -> f64 {
            let mut sum = 0.0;
            for (m, row) in cross.iter().enumerate() {
                for (n, value) in row.iter().enumerate() {
                    sum += change[first][m] * value * change[second][n];
                }
            }
            sum
        };
        let both = |first: usize, second: usize| entry(first, second) + entry(second, first);
        [entry(0, 0), entry(1, 1), entry(2, 2), both(0, 1), both(0, 2), both(1, 2)]
    }

    /// The contact of a half-width that continues one of another.
    pub(super) fn nearest(&self, place: f64, eccentricity: f64) -> Option<Point> {
        let points = self.points(ContactEdges::at_place(self.indenter, place, 0.0)).ok()?;
        let far = |point: &Point| apart(self.indenter, point.eccentricity, eccentricity);
        points.into_iter().min_by(|first, second| far(first).total_cmp(&far(second)))
    }
}

/// The distance of two eccentricities; a wave repeats.
pub(super) fn apart(indenter: Indenter, first: f64, second: f64) -> f64 {
    let far = first - second;
    match indenter {
        Indenter::Wave => (far - 2.0 * PI * (far / (2.0 * PI)).round()).abs(),
        Indenter::Parabola => far.abs(),
    }
}

fn all(states: [Result<ContactState, Refusal>; 3]) -> Result<[ContactState; 3], Refusal> {
    let [first, second, third] = states;
    Ok([first?, second?, third?])
}
