//! Where the model of a steady crack may be doubted, held against the rows.

use super::SteadyCrackPlan;
use super::columns::at;
use crate::outcome::{Row, Validity, Verdict};
use crate::scene::typed::{CrackControl, ProcessZoneLaw, Units};

/// Below this a process zone is shorter than the molecules of a rubber (m).
const SMALLEST_ZONE: f64 = 1e-9;

impl SteadyCrackPlan {
    pub(in crate::plan) fn validity(&self, rows: &[Row]) -> Vec<Validity> {
        let mut entries = Vec::new();
        let value = |row: &Row, column: usize| row.values.get(column).copied().flatten().map(|estimate| estimate.value);
        let column = |column: usize| rows.iter().filter_map(move |row| value(row, column));
        let largest_zone = column(at::PROCESS_ZONE).fold(0.0, f64::max);
        let smallest_zone = column(at::PROCESS_ZONE).fold(f64::INFINITY, f64::min);
        if self.units == Units::Si && smallest_zone.is_finite() {
            entries.push(judged(
                "shortest process zone (m)",
                smallest_zone,
                smallest_zone >= SMALLEST_ZONE,
                "a continuum needs a process zone longer than about 1 nm",
            ));
        }
        // Both faces' slope at the end of the process zone, u(δ)/δ with the glassy radius r: √(2r/δ).
        let slope = rows
            .iter()
            .filter_map(|row| Some((2.0 * value(row, at::GLASSY_RADIUS)? / value(row, at::PROCESS_ZONE)?).sqrt()))
            .fold(0.0, f64::max);
        if self.units == Units::Si && slope > 0.0 {
            entries.push(judged("face slope at the process zone", slope, slope < 0.3, "linear elasticity wants slopes well below one there"));
        }
        self.strip_validity(rows, largest_zone, &mut entries);
        if let (ProcessZoneLaw::Cohesive { cohesive_stress, .. }, Units::Si) = (self.crack.process_zone, self.units) {
            let ratio = cohesive_stress / self.plane_material.glassy_modulus();
            entries.push(judged("cohesive stress over glassy modulus", ratio, ratio < 0.3, "the material about the process zone must stay linear"));
        }
        entries.push(Validity {
            name: "constant Poisson ratio".into(),
            value: self.poisson_ratio,
            verdict: Verdict::Good,
            meaning: "assumed at all times; real rubbers keep it to a few per cent up to their glass transition".into(),
        });
        entries.push(Validity {
            name: "inertia and heat".into(),
            value: None,
            verdict: Verdict::NotJudged,
            meaning: "left out: speeds must stay far below the shear-wave speed, and the tip isothermal".into(),
        });
        entries
    }

    fn strip_validity(&self, rows: &[Row], largest_zone: f64, entries: &mut Vec<Validity>) {
        let CrackControl::Strip(strip) = self.crack.control else {
            return;
        };
        if rows.is_empty() {
            return;
        }
        let height = strip.half_height;
        if largest_zone > 0.0 {
            let ratio = largest_zone / height;
            entries.push(judged("process zone over strip half-height", ratio, ratio < 0.05, "the tip's square-root field must reach beyond the process zone"));
        }
        let fastest = rows.iter().filter_map(|row| row.values.get(at::SPEED).copied().flatten()).map(|speed| speed.value).fold(0.0, f64::max);
        if let Some(longest) = self.plane_material.longest_retardation_time() {
            let ratio = fastest * longest / height;
            entries.push(judged(
                "memory length v·τ_max over strip half-height",
                ratio,
                ratio < 0.3,
                "the strip must be relaxed one height from the tip; faster cracks leave stiff material at the clamps, and G is then not the relaxed one",
            ));
        }
        if let (Ok(stress), ProcessZoneLaw::Cohesive { cohesive_stress, .. }) = (self.strip_stress(&strip), self.crack.process_zone) {
            let ratio = stress / cohesive_stress;
            entries.push(judged("remote stress over cohesive stress", ratio, ratio < 0.1, "far stress must be small against the cohesive stress"));
        }
        // A strain above about 20 % is beyond small-strain theory.
        if let Ok(stress) = self.strip_stress(&strip) {
            let strain = stress / self.youngs_material.relaxed_modulus().max(f64::MIN_POSITIVE);
            entries.push(judged("remote strain (of the state planned)", strain, strain < 0.2, "small-strain theory; G of a rubber at large stretch needs its measured energy density"));
        }
    }
}

fn judged(name: &str, value: f64, good: bool, meaning: &str) -> Validity {
    Validity { name: name.into(), value: Some(value), verdict: if good { Verdict::Good } else { Verdict::Caution }, meaning: meaning.into() }
}
