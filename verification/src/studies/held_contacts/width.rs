//! All steady contacts of one half-width, by algebra alone.
//!
//! At given half-width and speed every field of a contact is linear in u = (cos e, sin e, p̄), of a parabola in (1, e, p̄); so are the fields of both contacts with a
//! moved edge at the same penetration. The work of each edge is therefore a quadratic form, and an equilibrium is a common point of two conics,
//! ```text
//! uᵀA_i u = 2πΓ_i (u₁² + u₂²)        i = trailing, leading        (parabola: u₁²)
//! ```
//! Two conics have four common points, each standing for ±u: no contact of a half-width can be overlooked, and nothing is followed from anywhere.
//! The forms come from three contacts by polarisation. Of the eight the contacts are those whose edges are pulled, in the contact and in both moved ones, and
//! whose faces do not meet.

use super::conics::common_points;
use nalgebra::{Matrix2, Matrix3, Vector2, Vector3};
use std::f64::consts::PI;
use std::sync::Arc;
use viscotack::refusal::Refusal;
use viscotack::sliding::contact::{ContactEdges, ContactMemory, ContactState, Indenter, Prescribed, ProcessZone, Resolution, ZonePressure};
use viscotack::sliding::edge_balance::WaveAdhesion;

/// Points of the gap from each edge to the middle, evenly in the root of the distance and in its logarithm.
const GAP_POINTS: usize = 24;
/// A gap below zero by this part of the largest one is still open: the digits of the coarser resolutions.
const GAP_DIGITS: f64 = 1e-6;
/// Without adhesion the gap opens as the distance to the power 3/2, and a narrow one is lost in the rounding of the load.
const SMOOTH_DIGITS: f64 = 1e-4;
/// A residual above this is corrected by Newton's method on the works themselves.
const CORRECTED: f64 = 1e-10;

/// An equilibrium of both edges.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Equilibrium {
    /// ln tan(a/2), of a parabola ln(a/2).
    pub place: f64,
    /// a.
    pub half_width: f64,
    /// e.
    pub eccentricity: f64,
    /// p̄.
    pub mean_pressure: f64,
    /// Δ.
    pub penetration: f64,
    /// Friction stress.
    pub friction_stress: f64,
    /// Largest relative defect of both works, evaluated at the contact itself.
    pub residual: f64,
    /// Smallest gap over the largest.
    pub smallest_gap: f64,
    /// Largest edge amplitude of the contact and the moved ones; negative if all are pulled.
    pub largest_amplitude: f64,
}

impl Equilibrium {
    /// Whether the contact can exist.
    #[must_use]
    pub fn exists(&self) -> bool {
        self.largest_amplitude < 0.0 && self.smallest_gap > -GAP_DIGITS
    }
}

/// Material, speed and adhesion of a search.
#[derive(Debug)]
pub struct Bodies {
    pub(super) memory: Arc<ContactMemory>,
    pub(super) indenter: Indenter,
    pub(super) adhesion: Option<WaveAdhesion>,
    zones: Option<(ProcessZone, ProcessZone)>,
    resolution: Resolution,
}

/// Works over 2πΓ, amplitudes and penetration of a contact with given edges.
#[derive(Debug, Clone, Copy)]
pub struct Works {
    /// Trailing, leading.
    pub works: [f64; 2],
    /// Δ.
    pub penetration: f64,
    /// p̄.
    pub mean_pressure: f64,
}

impl Bodies {
    /// With the zones of its edges prepared.
    #[must_use]
    pub fn new(memory: Arc<ContactMemory>, indenter: Indenter, adhesion: Option<WaveAdhesion>, resolution: Resolution) -> Self {
        let zones = adhesion.map(|adhesion| {
            (
                ProcessZone::new(&memory, indenter, viscotack::sliding::contact::Edge::Trailing, adhesion.trailing_zone, resolution),
                ProcessZone::new(&memory, indenter, viscotack::sliding::contact::Edge::Leading, adhesion.leading_zone, resolution),
            )
        });
        Self { memory, indenter, adhesion, zones, resolution }
    }

    fn solve(&self, edges: ContactEdges, prescribed: Prescribed) -> Result<ContactState, Refusal> {
        ContactState::at_edges(&self.memory, self.indenter, edges, prescribed, self.resolution)
    }

    /// The edges with the trailing one moved out by the first length and the leading one by the second.
    fn moved(edges: ContactEdges, trailing: f64, leading: f64) -> ContactEdges {
        let wider = 0.5 * (trailing + leading);
        ContactEdges {
            half_width: edges.half_width + wider,
            half_gap: edges.half_gap - wider,
            eccentricity: edges.eccentricity + 0.5 * (leading - trailing),
        }
    }

    /// A contact with its two moved ones.
    fn with_moved(&self, edges: ContactEdges, prescribed: Prescribed) -> Result<[ContactState; 3], Refusal> {
        let state = self.solve(edges, prescribed)?;
        let (behind, ahead) = self.adhesion.map_or((0.0, 0.0), |adhesion| (adhesion.trailing_zone, adhesion.leading_zone));
        let trailing = self.solve(Self::moved(edges, behind, 0.0), state.held())?;
        let leading = self.solve(Self::moved(edges, 0.0, ahead), state.held())?;
        Ok([state, trailing, leading])
    }

    /// The works of both edges of any contact, in equilibrium or not.
    ///
    /// # Errors
    /// Those of the contacts.
    pub fn works(&self, edges: ContactEdges, prescribed: Prescribed) -> Result<Works, Refusal> {
        let (Some((trailing, leading)), Some(adhesion)) = (&self.zones, self.adhesion) else {
            // Without adhesion the amplitudes stand for the works.
            let state = self.solve(edges, prescribed)?;
            let (behind, ahead) = state.edge_amplitudes();
            return Ok(Works { works: [-behind, -ahead], penetration: state.penetration(), mean_pressure: state.mean_pressure() });
        };
        let [state, behind, ahead] = self.with_moved(edges, prescribed)?;
        let works = [
            trailing.work(&state, &trailing.tension(&behind)).value / (2.0 * PI * adhesion.trailing_work),
            leading.work(&state, &leading.tension(&ahead)).value / (2.0 * PI * adhesion.leading_work),
        ];
        Ok(Works { works, penetration: state.penetration(), mean_pressure: state.mean_pressure() })
    }

    /// Every equilibrium at a place whose edges may be pulled or pressed, whose faces may meet: [`Equilibrium::exists`] tells.
    ///
    /// # Errors
    /// Those of the contacts.
    pub fn equilibria(&self, place: f64) -> Result<Vec<Equilibrium>, Refusal> {
        let edges = ContactEdges::at_place(self.indenter, place, 0.0);
        let (slope, beta) = (place.exp(), self.memory.stiffening_ratio());
        let work = self.adhesion.map_or(0.0, |adhesion| adhesion.trailing_work.max(adhesion.leading_work));
        let load = self.indenter.half_angle_scale(edges.half_width) + (work * slope * beta.sqrt()).sqrt();
        let aside = match self.indenter {
            Indenter::Wave => 0.5 * PI,
            Indenter::Parabola => edges.half_width,
        };
        // Columns: u of three contacts.
        let (places, basis) = match self.indenter {
            Indenter::Wave => ([(0.0, 0.0), (aside, 0.0), (0.0, load)], Matrix3::new(1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, load)),
            Indenter::Parabola => ([(0.0, 0.0), (aside, 0.0), (0.0, load)], Matrix3::new(1.0, 1.0, 1.0, 0.0, aside, 0.0, 0.0, 0.0, load)),
        };
        let mut states = Vec::with_capacity(3);
        for (eccentricity, pressure) in places {
            states.push(self.with_moved(ContactEdges { eccentricity, ..edges }, Prescribed::MeanPressure(pressure))?);
        }
        let points = match (&self.zones, self.adhesion) {
            (Some(zones), Some(adhesion)) => self.conics(&states, zones, adhesion, &basis),
            _ => smooth(&states).into_iter().collect(),
        };
        let amplitudes: Vec<Vector3<f64>> = (0..6)
            .map(|index| {
                Vector3::from_fn(|column, _| {
                    let amplitudes =
                        states.get(column).and_then(|set: &[ContactState; 3]| set.get(index / 2)).map(ContactState::edge_amplitudes);
                    amplitudes.map_or(f64::NAN, |(trailing, leading)| if index % 2 == 0 { trailing } else { leading })
                })
            })
            .collect();
        let mut found = Vec::new();
        for point in points {
            for sign in [1.0, -1.0] {
                let weights = point * sign;
                let u = basis * weights;
                let size = match self.indenter {
                    Indenter::Wave => u[0].hypot(u[1]),
                    Indenter::Parabola => u[0],
                };
                if size <= 0.0 || !size.is_finite() {
                    continue;
                }
                let (weights, u) = (weights / size, u / size);
                let eccentricity = if self.indenter == Indenter::Wave { u[1].atan2(u[0]) } else { u[1] };
                let largest = amplitudes.iter().map(|line| line.dot(&weights)).fold(f64::NEG_INFINITY, f64::max);
                if self.adhesion.is_some() && largest >= 0.0 {
                    continue;
                }
                let contact = ContactEdges { eccentricity, ..edges };
                found.push(self.reported(place, contact, u[2], largest)?);
            }
        }
        found.sort_by(|one, other| one.eccentricity.total_cmp(&other.eccentricity));
        Ok(found)
    }

    /// The contacts that can exist at a place.
    ///
    /// # Errors
    /// Those of the contacts.
    pub fn contacts(&self, place: f64) -> Result<Vec<Equilibrium>, Refusal> {
        let mut found = self.equilibria(place)?;
        found.retain(Equilibrium::exists);
        Ok(found)
    }

    fn conics(
        &self,
        states: &[[ContactState; 3]],
        (trailing, leading): &(ProcessZone, ProcessZone),
        adhesion: WaveAdhesion,
        basis: &Matrix3<f64>,
    ) -> Vec<Vector3<f64>> {
        let tensions: Vec<[ZonePressure; 2]> =
            states.iter().map(|[_, behind, ahead]| [trailing.tension(behind), leading.tension(ahead)]).collect();
        let form = |edge: usize| {
            let (zone, work) = if edge == 0 { (trailing, adhesion.trailing_work) } else { (leading, adhesion.leading_work) };
            let plain = Matrix3::from_fn(|row, column| {
                let pair = states.get(row).zip(tensions.get(column).and_then(|pair| pair.get(edge)));
                pair.map_or(f64::NAN, |([state, ..], tension)| zone.work(state, tension).value / (2.0 * PI * work))
            });
            let unit = match self.indenter {
                Indenter::Wave => Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, 0.0)),
                Indenter::Parabola => Matrix3::from_diagonal(&Vector3::new(1.0, 0.0, 0.0)),
            };
            (plain + plain.transpose()) * 0.5 - basis.transpose() * unit * basis
        };
        common_points(&form(0), &form(1))
    }

    /// What is off at both edges: works less one, without adhesion the amplitudes over the stiffness.
    ///
    /// # Errors
    /// Those of the contacts.
    pub fn balance(&self, edges: ContactEdges, prescribed: Prescribed) -> Result<Vector2<f64>, Refusal> {
        let [trailing, leading] = self.works(edges, prescribed)?.works;
        if self.adhesion.is_some() {
            return Ok(Vector2::new(trailing - 1.0, leading - 1.0));
        }
        let scale = self.memory.stiffening_ratio() * self.indenter.half_angle_scale(edges.half_width);
        Ok(Vector2::new(trailing, leading) / scale)
    }

    /// The numbers of a contact at a held mean pressure or penetration.
    ///
    /// # Errors
    /// Those of the contacts.
    pub fn numbers(&self, place: f64, eccentricity: f64, value: f64, by_depth: bool) -> Result<Equilibrium, Refusal> {
        let edges = ContactEdges::at_place(self.indenter, place, eccentricity);
        let prescribed = if by_depth { Prescribed::Penetration(value) } else { Prescribed::MeanPressure(value) };
        let states = self.with_moved(edges, prescribed)?;
        let largest_amplitude = states
            .iter()
            .map(ContactState::edge_amplitudes)
            .fold(f64::NEG_INFINITY, |largest, (trailing, leading)| largest.max(trailing).max(leading));
        let [state, ..] = states;
        Ok(Equilibrium {
            place,
            half_width: edges.half_width,
            eccentricity,
            mean_pressure: state.mean_pressure(),
            penetration: state.penetration(),
            friction_stress: state.friction_stress(),
            residual: self.balance(edges, prescribed)?.amax(),
            smallest_gap: if self.adhesion.is_some() { smallest_gap(&state)? } else { smallest_gap(&state)? + SMOOTH_DIGITS },
            largest_amplitude: if self.adhesion.is_some() { largest_amplitude } else { -1.0 },
        })
    }

    /// Eccentricity and mean pressure corrected by Newton's method with differences, at a fixed half-width.
    fn corrected(&self, edges: ContactEdges, pressure: f64) -> Result<(ContactEdges, f64), Refusal> {
        let off = |ahead: f64, more: f64| -> Result<Vector2<f64>, Refusal> {
            let moved = ContactEdges { eccentricity: edges.eccentricity + ahead, ..edges };
            let [trailing, leading] = self.works(moved, Prescribed::MeanPressure(pressure + more))?.works;
            Ok(Vector2::new(trailing - 1.0, leading - 1.0))
        };
        let here = off(0.0, 0.0)?;
        if self.adhesion.is_none() || here.amax() < CORRECTED {
            return Ok((edges, pressure));
        }
        let (ahead, more) = (1e-5 * edges.half_width.min(1.0), 1e-5 * (pressure.abs() + self.indenter.half_angle_scale(edges.half_width)));
        let by_ahead = (off(ahead, 0.0)? - off(-ahead, 0.0)?) / (2.0 * ahead);
        let by_more = (off(0.0, more)? - off(0.0, -more)?) / (2.0 * more);
        let step = Matrix2::from_columns(&[by_ahead, by_more]).lu().solve(&here).unwrap_or_else(Vector2::zeros);
        if !step.iter().all(|value| value.is_finite()) || off(-step[0], -step[1])?.norm() > here.norm() {
            return Ok((edges, pressure));
        }
        Ok((ContactEdges { eccentricity: edges.eccentricity - step[0], ..edges }, pressure - step[1]))
    }

    /// An equilibrium with its numbers and evidence.
    fn reported(&self, place: f64, edges: ContactEdges, pressure: f64, largest_amplitude: f64) -> Result<Equilibrium, Refusal> {
        let (edges, pressure) = self.corrected(edges, pressure)?;
        let state = self.solve(edges, Prescribed::MeanPressure(pressure))?;
        let works = self.works(edges, Prescribed::MeanPressure(pressure))?;
        let residual = match self.adhesion {
            Some(_) => works.works.iter().map(|work| (work - 1.0).abs()).fold(0.0, f64::max),
            None => 0.0,
        };
        Ok(Equilibrium {
            place,
            half_width: edges.half_width,
            eccentricity: edges.eccentricity,
            mean_pressure: pressure,
            penetration: state.penetration(),
            friction_stress: state.friction_stress(),
            residual,
            smallest_gap: if self.adhesion.is_some() { smallest_gap(&state)? } else { smallest_gap(&state)? + SMOOTH_DIGITS },
            largest_amplitude: if self.adhesion.is_some() { largest_amplitude } else { -1.0 },
        })
    }
}

/// Without adhesion: where both amplitudes vanish, lines instead of conics.
fn smooth(states: &[[ContactState; 3]]) -> Option<Vector3<f64>> {
    let [first, second, third] = states else { return None };
    let amplitudes = [first, second, third].map(|set| set[0].edge_amplitudes());
    let trailing = Vector3::from(amplitudes.map(|pair| pair.0));
    let leading = Vector3::from(amplitudes.map(|pair| pair.1));
    Some(trailing.normalize().cross(&leading.normalize()))
}

/// The smallest gap outside over the largest, near an edge over what a square root would leave of that.
fn smallest_gap(state: &ContactState) -> Result<f64, Refusal> {
    let edges = state.edges();
    let reach = if edges.half_gap.is_finite() { edges.half_gap } else { 10.0 * edges.half_width };
    let mut gaps = Vec::with_capacity(4 * GAP_POINTS);
    for index in 1..=GAP_POINTS {
        let part = index as f64 / GAP_POINTS as f64;
        for part in [part * part, 1e-6_f64.powf(1.0 - part)] {
            for point in [state.ahead_of_leading(part * reach)?, state.behind_trailing(part * reach)?] {
                gaps.push((part, state.gap(point)));
            }
        }
    }
    let largest = gaps.iter().fold(0.0_f64, |largest, (_, gap)| largest.max(*gap));
    Ok(gaps.iter().map(|(part, gap)| gap / (largest * part.sqrt())).fold(f64::INFINITY, f64::min))
}
