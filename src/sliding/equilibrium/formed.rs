//! Both edge conditions of a half-width, formed from three contacts.

use super::forms::{Conditions, Line};
use super::width::ContactsOfWidth;
use super::works::{Square, Works, directions, even_and_odd};
use crate::refusal::Refusal;
use crate::sliding::contact::{ContactEdges, ContactState, Indenter, Prescribed, ZoneSum};
use std::f64::consts::PI;

impl ContactsOfWidth {
    /// Both conditions of a half-width, from three contacts: upright, pressed and aside.
    pub(super) fn conditions(&self, edges: ContactEdges) -> Result<Conditions, Refusal> {
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
        let places = [(0.0, 0.0), (0.0, load), (aside, 0.0)];
        let systems = self.balance.systems_of(edges)?;
        let states = all(places.map(|(eccentricity, pressure)| systems.own.state(eccentricity, Prescribed::MeanPressure(pressure))))?;
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
        let (Some((adhesion, zones)), Some(wider)) = (&self.adhesion, &systems.moved) else {
            return Ok(Conditions { indenter: self.indenter, works: None, amplitudes, depth });
        };
        let targets = adhesion.targets();
        let place = edges.place();
        let lines = even_and_odd(self.indenter, place, &amplitudes[0], &amplitudes[1]);
        let parts = self.parts(&directions(self.indenter, place, lines), load, reach);
        let mut forms = [[0.0; 6]; 2];
        for ((((form, target), (zone, outward)), moved_system), fields) in
            forms.iter_mut().zip(targets).zip([(&zones.0, -1.0), (&zones.1, 1.0)]).zip(wider.both()).zip(&wider.fields)
        {
            // The eccentricity of a moved contact is that of its own middle.
            let shift = 0.5 * outward * zone.length();
            let moved = all(states.each_ref().map(|state| moved_system.state(state.contact().eccentricity + shift, state.held())))?;
            amplitudes.extend(amplitudes_of(&moved));
            let tensions = moved.each_ref().map(|state| zone.tension_by(fields, state));
            let gaps = states.each_ref().map(|state| zone.gap_by(fields, state));
            let (tensions, gaps) =
                (parts.map(|part| ZoneSum::of_pressures(&tensions, part)), parts.map(|part| ZoneSum::of_gaps(&gaps, part)));
            let entry = |one: usize, other: usize| zone.work_on(&tensions[one], &gaps[other]) / target;
            let both = |one: usize, other: usize| entry(one, other) + entry(other, one);
            *form = [entry(0, 0), entry(1, 1), entry(2, 2), both(0, 1), both(0, 2), both(1, 2)];
            if form.iter().any(|value| value.is_nan()) {
                return Err(Refusal::NotConverged { what: "the closure of a sliding edge", detail: "a work is not a number".into() });
            }
        }
        let works = Some(Works::new(self.indenter, place, lines, forms));
        Ok(Conditions { indenter: self.indenter, works, amplitudes, depth })
    }

    /// How much of the three contacts is in the contacts along given directions of (c, s, p).
    fn parts(&self, directions: &Square, load: f64, reach: f64) -> Square {
        directions.map(|[c, s, p]| match self.indenter {
            Indenter::Wave => [c - p / load, p / load, s],
            Indenter::Parabola => [c - p / load - s / reach, p / load, s / reach],
        })
    }
}

fn all(states: [Result<ContactState, Refusal>; 3]) -> Result<[ContactState; 3], Refusal> {
    let [first, second, third] = states;
    Ok([first?, second?, third?])
}
