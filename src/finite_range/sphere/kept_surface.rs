//! The surface at an instant: gap, pressure and displacement at every radius.

use std::sync::Arc;

use super::kernel::Rule;
use super::mesh::Mesh;
use super::state::State;
use super::surface;

/// A surface that was kept. Lengths and pressures as in [`super::problem::Problem`].
#[derive(Clone)]
pub struct Surface {
    /// The time at which it was kept, in the unit of the retardation times.
    pub time: f64,
    /// Its place in [`super::result::Run::rows`].
    pub row: usize,
    /// Penetration (h₀), positive into the body.
    pub penetration: f64,
    /// Force (RΔγ), positive in compression.
    pub force: f64,
    mesh: Arc<Mesh>,
    rule: Rule,
    /// The unknown of the law less the undeformed gap: a polynomial in every element.
    lifted: Vec<f64>,
    pressure: Vec<f64>,
    law: surface::Surface,
}

/// What holds at a radius.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// The distance between both surfaces (h₀).
    pub gap: f64,
    /// Pressure (Δγ/h₀), positive in compression.
    pub pressure: f64,
    /// Displacement of the body's surface (h₀), positive into the body.
    pub displacement: f64,
}

impl Surface {
    pub(super) fn of(state: &State, time: f64, row: usize, rule: &Rule, law: &surface::Surface) -> Self {
        Self {
            time,
            row,
            penetration: state.penetration,
            force: state.force,
            mesh: Arc::clone(&state.mesh),
            rule: rule.clone(),
            lifted: state.u.iter().zip(state.undeformed.iter()).map(|(u, flat)| u - flat).collect(),
            pressure: state.p.clone(),
            law: law.clone(),
        }
    }

    /// What holds at a radius ≥ 0 (√(R h₀)); beyond the mesh the body is not deformed.
    #[must_use]
    pub fn at(&self, radius: f64) -> Place {
        let flat = self.law.undeformed(radius);
        let lift = self.mesh.value_at(&self.rule, &self.lifted, radius);
        let u = flat + lift.unwrap_or(-self.penetration);
        let gap = self.law.gap(u);
        let pressure = self.mesh.value_at(&self.rule, &self.pressure, radius).unwrap_or_else(|| self.law.pressure(u));
        Place { gap, pressure, displacement: gap - flat + self.penetration }
    }
}

impl PartialEq for Surface {
    fn eq(&self, other: &Self) -> bool {
        self.mesh.x == other.mesh.x && self.lifted == other.lifted && self.pressure == other.pressure
    }
}

impl std::fmt::Debug for Surface {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { time, penetration, force, .. } = self;
        write!(formatter, "Surface {{ time: {time}, penetration: {penetration}, force: {force} }}")
    }
}
