//! The periodic Green's function of Fig 2.4, π𝒢, at several ζ = kvτ; ζ = 0 and the elastic solids are its limits.

use super::super::table::Table;
use super::spaced;
use serde::Deserialize;
use std::f64::consts::PI;
use viscotack::refusal::Refusal;
use viscotack::sliding::{HalfPlaneGreen, SlidingMemory};

/// See the module.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub(in crate::figures) struct Green {
    stiffening_ratio: f64,
    /// ζ of each curve.
    ratios: Vec<f64>,
    /// From and to this kx, away from the loads at multiples of 2π.
    positions: [f64; 2],
    points: usize,
}

impl Green {
    pub(super) fn table(&self) -> Result<Table, Refusal> {
        let (mut ratios, mut places, mut values) = (Vec::new(), Vec::new(), Vec::new());
        for &ratio in &self.ratios {
            let kernel = HalfPlaneGreen::new(SlidingMemory::standard_solid(self.stiffening_ratio, ratio)?)?;
            for place in spaced(self.positions, self.points, false) {
                ratios.push(ratio);
                places.push(place);
                // At a load the kernel is minus infinity: a gap.
                values.push(kernel.value(place).map_or(f64::NAN, |value| PI * value.value));
            }
        }
        Ok(Table::exact(&[("ratio", ratios), ("position", places), ("green", values)]))
    }
}
