//! The plots of a steady crack: toughness against speed, what a sweep varies, and the fields at the tip.

use super::SteadyCrackPlan;
use super::columns::{at, field};
use crate::outcome::Row;
use crate::outcome::plot::{Axis, Curve, Figure, Line};
use crate::plan::curves::{
    Family, Kind, families, figure, innermost, left_out, noted, shade, swept_axis, swept_label, thinned, thinning, value,
};
use crate::plan::maps::Answer;
use crate::scene::typed::{CrackControl, Scene, Theory, Units};
use viscotack::crack::Motion;

/// Most states whose fields are drawn in one figure.
const MOST_FIELDS: usize = 6;

/// The theory of the program is solid, its rivals are dashed and dotted.
const fn kind(theory: Theory) -> Kind {
    let line = match theory {
        Theory::VirtualWork => Line::Solid,
        Theory::PerssonBrener => Line::Dashed,
        Theory::CohesiveZone => Line::Dotted,
    };
    Kind { word: theory.word(), name: theory.name(), line }
}

impl SteadyCrackPlan {
    pub(super) fn drawings(&self, scene: &Scene, rows: &[Row]) -> Vec<(String, Figure)> {
        let mut figures = Vec::new();
        let kinds: Vec<Kind> = self.crack.theories.iter().map(|&theory| kind(theory)).collect();
        let families = families(scene, rows, &kinds);
        // One state has no curve.
        if families.iter().any(|family| family.rows.len() > 1) {
            let si = self.units == Units::Si;
            let speed = if si { "crack speed $v$ (m/s)" } else { r"crack speed $v\tau/a_0$" };
            let solid = self.plane_material.relaxed_modulus() > 0.0;
            let (column, stem, label) = match (solid, si) {
                (true, true) => (at::ENERGY_RELEASE_RATE, "energy_release_rate", "energy release rate $G$ (J/m²)"),
                (true, false) => (at::RATIO, "energy_release_rate", r"energy release rate $G/\Delta\gamma$"),
                (false, _) => (at::STRESS_INTENSITY, "stress_intensity", "stress intensity $K$ (Pa √m)"),
            };
            figures.push((
                format!("{stem}_against_speed"),
                figure(&families, (Axis::logarithmic(speed), Axis::logarithmic(label)), |row| value(row, at::SPEED), column),
            ));
            figures.extend(self.against_swept(scene, &families));
            figures = noted(figures, left_out(scene, rows, kinds.len()));
        }
        figures.extend(self.field_figures(scene, rows));
        figures
    }

    /// A plot against the innermost swept number, where that is not the speed itself.
    fn against_swept(&self, scene: &Scene, families: &[Family<'_>]) -> Option<(String, Figure)> {
        let sweep = scene.sweeps.last()?;
        if sweep.key == "crack.speed" {
            return None;
        }
        let load = !matches!(self.crack.control, CrackControl::Speed(_));
        let (column, stem) = if load { (at::SPEED, "speed") } else { (at::RATIO, "toughness") };
        let vertical = match (load, self.units) {
            (true, Units::Si) => Axis::logarithmic("crack speed $v$ (m/s)"),
            (true, Units::Reduced) => Axis::logarithmic(r"crack speed $v\tau/a_0$"),
            (false, _) => Axis::logarithmic(r"energy release rate $G/\Delta\gamma$"),
        };
        let drawn = figure(families, (swept_axis(sweep), vertical), innermost, column);
        Some((format!("{stem}_against_{}", sweep.key.replace('.', "_")), drawn))
    }

    /// The load that a speed needs, or the speed under a load.
    pub(super) fn main_answer(&self) -> Answer {
        let si = self.units == Units::Si;
        let by_load = !matches!(self.crack.control, CrackControl::Speed(_));
        let (column, label) = match (by_load, self.plane_material.relaxed_modulus() > 0.0) {
            (true, _) => (at::SPEED, if si { "crack speed $v$ (m/s)" } else { r"crack speed $v\tau/a_0$" }),
            (false, true) if si => (at::ENERGY_RELEASE_RATE, "energy release rate $G$ (J/m²)"),
            (false, true) => (at::RATIO, r"energy release rate $G/\Delta\gamma$"),
            (false, false) => (at::STRESS_INTENSITY, "stress intensity $K$ (Pa √m)"),
        };
        Answer { column, axis: Axis::logarithmic(label) }
    }

    fn field_figures(&self, scene: &Scene, rows: &[Row]) -> Vec<(String, Figure)> {
        let mut states: Vec<&Row> = rows.iter().filter(|row| !row.fields.is_empty()).collect();
        if states.is_empty() {
            return Vec::new();
        }
        let note = thinning(states.len(), MOST_FIELDS, "fields");
        states = thinned(states, MOST_FIELDS);
        let si = self.units == Units::Si;
        let distance = |side: &str| {
            Axis::logarithmic(if si { format!("distance {side} the tip (m)") } else { format!("distance {side} the tip $s/a_0$") })
        };
        let mut opening = Figure::new(
            distance("behind"),
            Axis::logarithmic(if si {
                "displacement of one face $u$ (m)"
            } else {
                r"displacement of one face $u/\sqrt{a_0 \Delta\gamma/E_0}$"
            }),
        );
        let mut stress = Figure::new(
            distance("ahead of"),
            Axis::logarithmic(if si { r"stress $|\sigma|$ (Pa)" } else { r"stress $|\sigma|/\sqrt{E_0 \Delta\gamma/a_0}$" }),
        );
        for (index, row) in states.iter().enumerate() {
            let label = if scene.sweeps.is_empty() { String::new() } else { swept_label(scene, &row.swept) };
            let points = row.fields.iter().map(|point| (point.place, field(point, at::DISPLACEMENT))).collect();
            opening = opening.with_curve(Curve::new(label.clone(), points).with_line(Line::Solid).with(shade(index, states.len())));
            // Tension solid, compression dashed: one curve of |σ| in two pieces.
            let part = |sign: f64| {
                row.fields
                    .iter()
                    .map(|point| {
                        let stress = field(point, at::STRESS);
                        (point.place, if stress * sign > 0.0 { stress.abs() } else { f64::NAN })
                    })
                    .collect()
            };
            let tension = if scene.sweeps.is_empty() { "tension".to_owned() } else { label };
            stress = stress.with_curve(Curve::new(tension, part(1.0)).with_line(Line::Solid).with(shade(index, states.len())));
            if row.fields.iter().any(|point| field(point, at::STRESS) < 0.0) {
                let compression = if index == 0 { "compression" } else { "" };
                stress = stress.with_curve(Curve::new(compression, part(-1.0)).with_line(Line::Dashed).with(shade(index, states.len())));
            }
        }
        let figures = if self.crack.motion == Motion::Opening {
            vec![("opening".into(), opening), ("stress".into(), stress)]
        } else {
            vec![("stress".into(), stress), ("opening".into(), opening)]
        };
        noted(figures, note)
    }
}
