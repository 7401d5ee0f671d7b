//! Retraction from a relaxed contact, faster than the memory (thesis Sec 4.10), in closed form for a process zone of no length.
//!
//! ```text
//! a = a_B:  F = F_B − 2a_BE∞*(Δ_B − Δ), until K_I² = 2E∞*Δγ                                              (4.42–4.44)
//! then      Δ = Δ_B − (Δ_B − a²/R)/β − √(2πaΔγ/E∞*),  F = (4/3)E0*a³/R − 2√(2πE∞*Δγ)a^{3/2}                (4.45–4.47)
//! ```
//! Beside it Kendall's punch of the same radius, F = √(8πE∞*Δγa_B³) (4.48). Units: R, πE0*R²; γ̃ = Δγ/(πE0*R).

use super::super::table::Table;
use super::spaced;
use serde::Deserialize;
use std::f64::consts::PI;
use viscotack::elastic::{EquilibriumBranch, JkrSphere, KendallPunch};
use viscotack::refusal::Refusal;

/// See the module.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(in crate::figures) struct FastRetraction {
    /// γ̃.
    work_of_adhesion: f64,
    /// β.
    stiffening_ratio: f64,
    /// Δ_B of each retraction.
    starts: Vec<f64>,
    /// Points of each before and after the contact lets go.
    points: usize,
}

impl FastRetraction {
    pub(super) fn table(&self) -> Result<Table, Refusal> {
        let (work, beta) = (PI * self.work_of_adhesion, self.stiffening_ratio);
        let sphere = JkrSphere::new(1.0, 1.0, work)?;
        let pull_off = sphere.pull_off_force();
        let mut columns = [const { Vec::new() }; 6];
        for &start in &self.starts {
            let relaxed = sphere.state_by_penetration(start, EquilibriumBranch::Stable)?;
            let first = relaxed.contact_radius;
            let penetration = |a: f64| start - (start - a * a) / beta - (2.0 * PI * a * work / beta).sqrt();
            let force = |a: f64| 4.0 / 3.0 * a.powi(3) - 2.0 * (2.0 * PI * beta * work).sqrt() * a * a.sqrt();
            // Under a held penetration it lets go where the penetration turns, dΔ/da = 0.
            let turn = (PI * work * beta / 8.0).cbrt().min(first);
            let straight = spaced([0.0, 1.0], self.points, false).into_iter().map(|part| {
                let on = |from: f64, to: f64| from + (to - from) * part;
                (on(relaxed.penetration, penetration(first)), on(relaxed.force, force(first)), first)
            });
            let mut path: Vec<(f64, f64, f64)> = straight.collect();
            path.extend(spaced([first, turn], self.points, false).into_iter().map(|a| (penetration(a), force(a), a)));
            let largest = path.iter().fold(0.0, |most: f64, (_, force, _)| most.max(-force));
            // Between the points the largest tension is at a³ = πβΔγ·9/8, where that is inside the contact.
            let inside = (9.0 / 8.0 * PI * beta * work).cbrt();
            let largest = if inside < first { largest.max(-force(inside)) } else { largest };
            let punch = KendallPunch::new(first, beta, work)?.pull_off_force()?;
            for (penetration, force, radius) in path {
                let numbers = [start, penetration, force / PI, radius, largest / pull_off, punch / pull_off];
                for (column, number) in columns.iter_mut().zip(numbers) {
                    column.push(number);
                }
            }
        }
        let [start, penetration, force, radius, ratio, punch] = columns;
        Ok(Table::exact(&[
            ("start", start),
            ("penetration", penetration),
            ("force", force),
            ("contact_radius", radius),
            ("pull_off_ratio", ratio),
            ("punch_ratio", punch),
        ]))
    }
}
