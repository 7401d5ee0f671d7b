//! Energies of a contact on the line: exact one-dimensional integrals over every spring and dashpot, bonded or free.

use super::line::Contact;
use super::panel::{POINTS, RULE};

impl Contact<'_> {
    /// U (J), the energy stored in every spring, inside and outside the contact (thesis Eq 4.30 on the line).
    #[must_use]
    pub fn stored_energy(&self) -> f64 {
        self.integrate(|load, strains| {
            load * load / self.springs.glassy + strains.iter().zip(&self.springs.creep).map(|(e, (j, _))| e * e / j).sum::<f64>()
        })
    }

    /// P_d (W), the power dissipated in every dashpot (thesis Eq 4.32).
    #[must_use]
    pub fn dissipated_power(&self) -> f64 {
        self.integrate(|load, strains| {
            let terms = strains.iter().zip(&self.springs.creep);
            2.0 * terms.map(|(e, &(j, tau))| (j * load - e) * ((j * load - e) / j) / tau).sum::<f64>()
        })
    }

    fn integrate(&self, density: impl Fn(f64, &[f64]) -> f64) -> f64 {
        let mut strains = vec![0.0; self.springs.terms()];
        let mut total = 0.0;
        for (index, cell) in self.cells.iter().enumerate() {
            let heights = if cell.bonded { cell.heights(&self.profile) } else { [0.0; POINTS] };
            for (g, (weight, height)) in RULE.weights.iter().zip(heights).enumerate() {
                let state = self.state(index, g);
                let load = if cell.bonded {
                    self.springs.voigt(state, &mut strains);
                    self.springs.load(self.penetration - height, state.iter().copied())
                } else {
                    strains.copy_from_slice(state);
                    0.0
                };
                total += (cell.high - cell.low) * weight * density(load, &strains);
            }
        }
        total
    }
}
