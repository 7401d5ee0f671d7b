//! The linear system of a contact of given width: the memory loads under each of the three fields that a contact is a sum of.
//!
//! Every field of a contact is linear in (cos e, sin e, D), of a parabola in (1, e, D). The system depends on the half-width alone, so contacts of one width that
//! differ in eccentricity, load or penetration share it.

use super::arcs::Arcs;
use super::edges::ContactEdges;
use super::indenter::Indenter;
use super::integrals::{InsideIntegrals, OutsideIntegrals, condition_number, inside_integrals, outside_integrals};
use super::memory::ContactMemory;
use super::resolution::Resolution;
use super::state::{ContactState, Prescribed, Totals, first_harmonic, log_half_sine, separation_of_wave};
use crate::refusal::{Refusal, require_finite};
use nalgebra::DMatrix;
use std::f64::consts::PI;
use std::sync::Arc;

/// A solved system.
#[derive(Debug, Clone)]
pub(in crate::sliding) struct ContactSystem {
    edges: ContactEdges,
    indenter: Indenter,
    arcs: Arcs,
    resolution: Resolution,
    memory: Arc<ContactMemory>,
    outside: Vec<OutsideIntegrals>,
    /// j_jV_j under W, −S and H₀ of strength one.
    wave_loads: Vec<f64>,
    slope_loads: Vec<f64>,
    flat_loads: Vec<f64>,
    condition: f64,
}

impl ContactSystem {
    /// Of a half-width and its half gap; the eccentricity of `edges` is not used.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a half-width outside 0 < a < π; [`Refusal::NotConverged`] if the system is singular to rounding.
    pub(in crate::sliding) fn new(
        memory: &Arc<ContactMemory>,
        indenter: Indenter,
        edges: ContactEdges,
        resolution: Resolution,
    ) -> Result<Self, Refusal> {
        let ContactEdges { half_width, half_gap, .. } = edges;
        if !(half_width > 0.0 && half_gap > 0.0) {
            return Err(Refusal::out_of_range("half_width", half_width, "greater than 0 and, of a wave, below π (in 1/k)"));
        }
        let arcs = Arcs::new(edges, indenter);
        let outside: Vec<OutsideIntegrals> =
            memory.creep().iter().map(|mode| outside_integrals(&arcs, edges, mode.ratio, resolution)).collect();
        // Rows M_{ε_i} f_i(−a) = 0: the loads j_jV_j under W, under −S, and under H₀.
        let count = memory.creep().len();
        let mut matrix = DMatrix::zeros(count, count);
        let mut sides = DMatrix::zeros(count, 3);
        for (row, relaxation) in memory.relaxation.iter().enumerate() {
            let InsideIntegrals { flat, odd, wave, slope } = inside_integrals(&arcs, edges, relaxation.ratio, resolution);
            // Rows are divided by M_ε H₀(−a), columns by their O^s: everything is then of order one.
            sides[(row, 0)] = wave / flat;
            sides[(row, 1)] = slope / flat;
            sides[(row, 2)] = 1.0;
            for (column, integrals) in outside.iter().enumerate() {
                matrix[(row, column)] = 2.0 / PI * memory.pole(column, row) * (integrals.cosine / integrals.sine * (odd / flat) + 1.0);
            }
        }
        let condition = condition_number(&matrix);
        if count > 0 && !matrix.lu().solve_mut(&mut sides) {
            return Err(Refusal::NotConverged {
                what: "the memory loads of a sliding contact",
                detail: "the linear system is singular".into(),
            });
        }
        let scaled =
            |side: usize| -> Vec<f64> { outside.iter().enumerate().map(|(row, integrals)| sides[(row, side)] / integrals.sine).collect() };
        let (wave_loads, slope_loads, flat_loads) = (scaled(0), scaled(1), scaled(2));
        Ok(Self { edges, indenter, arcs, resolution, memory: Arc::clone(memory), outside, wave_loads, slope_loads, flat_loads, condition })
    }

    pub(super) const fn arcs(&self) -> &Arcs {
        &self.arcs
    }

    /// The contact of an eccentricity.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for numbers that are not finite; [`Refusal::Undefined`] for the separation of a parabola.
    pub(in crate::sliding) fn state(&self, eccentricity: f64, prescribed: Prescribed) -> Result<ContactState, Refusal> {
        require_finite("eccentricity", eccentricity)?;
        let Self { arcs, indenter, outside, memory, .. } = self;
        let square = arcs.half.0 * arcs.half.0;
        let shift = indenter.shift(eccentricity);
        let wave_loads: Vec<f64> =
            self.wave_loads.iter().zip(&self.slope_loads).map(|(wave, slope)| shift.1 * wave + shift.0 * slope).collect();
        let depth_of = |loads: &[f64]| loads.iter().zip(outside).map(|(load, integrals)| load * integrals.depth).sum::<f64>() / PI;
        // Δ and p̄ are linear in D: Δ from the crest, 1 − Δ from the trough, each without the digits that it would lose in the other.
        let log_sine = log_half_sine(arcs);
        let crest = match indenter {
            Indenter::Wave => {
                let half = (0.5 * eccentricity).sin();
                2.0 * half * half + shift.1 * square * (1.0 - 2.0 * log_sine)
            }
            Indenter::Parabola => 0.5 * eccentricity * eccentricity + square * (1.0 - 2.0 * log_sine),
        };
        let (wave_depth, flat_depth) = (depth_of(&wave_loads), depth_of(&self.flat_loads));
        let (fixed, per_flat) = (crest - wave_depth, -log_sine - flat_depth);
        let trough = shift.1 * separation_of_wave(arcs) + wave_depth;
        let flat_strength = match prescribed {
            Prescribed::MeanPressure(pressure) => 2.0 * (require_finite("mean_pressure", pressure)? - square * shift.1),
            Prescribed::Penetration(penetration) => (require_finite("penetration", penetration)? - fixed) / per_flat,
            Prescribed::MeanSeparation(_) if *indenter == Indenter::Parabola => {
                return Err(Refusal::Undefined {
                    quantity: "the mean separation of a cylinder",
                    reason: "its gap grows without bound".into(),
                });
            }
            Prescribed::MeanSeparation(separation) => (trough - require_finite("mean_separation", separation)?) / per_flat,
        };
        let loads: Vec<f64> = wave_loads.iter().zip(&self.flat_loads).map(|(wave, flat)| wave + flat_strength * flat).collect();
        let (first_harmonic, harmonic_sizes) = match indenter {
            Indenter::Wave => first_harmonic(memory, (square, eccentricity), flat_strength, &loads, outside),
            Indenter::Parabola => ((0.0, 0.0), (0.0, 0.0)),
        };
        let state = ContactState {
            edges: ContactEdges { eccentricity, ..self.edges },
            indenter: *indenter,
            arcs: *arcs,
            resolution: self.resolution,
            memory: Arc::clone(memory),
            flat_strength,
            loads,
            outside: outside.iter().map(|integrals| (integrals.cosine, integrals.sine)).collect(),
            totals: Totals {
                mean_pressure: square * shift.1 + 0.5 * flat_strength,
                penetration: fixed + flat_strength * per_flat,
                separation: trough - flat_strength * per_flat,
                first_harmonic,
                harmonic_sizes,
            },
            condition: self.condition,
        };
        require_finite("mean_pressure", state.mean_pressure())?;
        require_finite("penetration", state.penetration())?;
        require_finite("friction_stress", state.friction_stress())?;
        Ok(state)
    }
}
