//! The equilibria of an elastic sphere (thesis Sec 1.3), in units of R, πE0*R² and a modulus m = E*/E0*.

use super::super::table::Table;
use super::spaced;
use serde::Deserialize;
use std::f64::consts::PI;
use viscotack::elastic::{Control, JkrSphere};
use viscotack::refusal::Refusal;

/// See the module.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(in crate::figures) struct Jkr {
    /// γ̃ = Δγ/(πE0*R).
    work_of_adhesion: f64,
    /// m.
    modulus: f64,
    /// From and to this a/R.
    contact_radii: [f64; 2],
    points: usize,
}

impl Jkr {
    pub(super) fn table(&self) -> Result<Table, Refusal> {
        let sphere = JkrSphere::new(1.0, self.modulus, PI * self.work_of_adhesion)?;
        let mut columns = [const { Vec::new() }; 5];
        let mut radii = spaced(self.contact_radii, self.points, false);
        // The two points where the contact is lost are points of the curve.
        radii.extend([sphere.pull_off(Control::Load)?.contact_radius, sphere.pull_off(Control::Penetration)?.contact_radius]);
        radii.sort_by(f64::total_cmp);
        for radius in radii {
            let state = sphere.state_by_contact_radius(radius)?;
            let flag = |control| if sphere.is_stable(&state, control) { 1.0 } else { 0.0 };
            let numbers = [radius, state.penetration, state.force / PI, flag(Control::Load), flag(Control::Penetration)];
            for (column, number) in columns.iter_mut().zip(numbers) {
                column.push(number);
            }
        }
        let [radius, penetration, force, load, depth] = columns;
        Ok(Table::exact(&[
            ("contact_radius", radius),
            ("penetration", penetration),
            ("force", force),
            ("stable_under_load", load),
            ("stable_under_penetration", depth),
        ]))
    }
}
