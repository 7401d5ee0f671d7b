//! The plots of a sliding surface: outputs against what the sweep or the loop varies, the profile with its spectrum, and fields.

use super::SurfacePlan;
use super::columns::{at, field};
use crate::outcome::plot::{Axis, Colour, Curve, Figure, Line, Marker};
use crate::outcome::{FieldPoint, Row};
use crate::plan::curves::{
    Kind, axis_of, families, figure, innermost, left_out, noted, shade, swept_axis, swept_label, thinned, thinning, value,
};
use crate::scene::sweep::Sweep;
use crate::scene::typed::{Scene, SlidingContact, SurfaceTask, Units};
use std::f64::consts::TAU;

/// Most states whose fields are drawn in one figure.
const MOST_FIELDS: usize = 5;
/// Points of the drawn profile, bins of a histogram.
const PROFILE_POINTS: usize = 2000;
const BINS: usize = 40;

impl SurfacePlan {
    pub(super) fn drawings(&self, scene: &Scene, rows: &[Row]) -> Vec<(String, Figure)> {
        let mut figures = match self.sliding.task {
            SurfaceTask::State => self.over_the_sweep(scene, rows),
            SurfaceTask::Loop { .. } | SurfaceTask::Branch { .. } => self.over_the_load(scene, rows),
        };
        if self.sliding.surface.word != "wave" {
            figures.extend(self.of_the_profile());
        }
        let states: Vec<&Row> = rows.iter().filter(|row| !row.fields.is_empty()).collect();
        if !states.is_empty() {
            figures.extend(if self.is_line() { self.field_figures(scene, &states) } else { self.field_maps(&states) });
            figures.extend(self.histograms(scene, &states));
        }
        figures
    }

    fn kind(&self, contact: SlidingContact) -> Kind {
        let second = contact == SlidingContact::Adhesiveless && self.sliding.contacts.len() > 1;
        Kind { word: contact.word(), name: contact.word(), line: if second { Line::Dashed } else { Line::Solid } }
    }

    fn over_the_sweep(&self, scene: &Scene, rows: &[Row]) -> Vec<(String, Figure)> {
        let kinds: Vec<Kind> = self.sliding.contacts.iter().map(|&contact| self.kind(contact)).collect();
        let families = families(scene, rows, &kinds);
        let Some(sweep) = scene.sweeps.last().filter(|_| families.iter().any(|family| family.rows.len() > 1)) else {
            return Vec::new();
        };
        let against = sweep.key.strip_prefix("sliding.").unwrap_or(&sweep.key).replace('.', "_");
        let horizontal = self.axis_of_sweep(sweep);
        let over = |label: String, column: usize| figure(&families, (horizontal.clone(), Axis::linear(label)), innermost, column);
        let pressed = rows.iter().filter(|row| row.value(at::FRICTION).is_some()).all(|row| row.value(at::COEFFICIENT).is_some());
        let friction = if pressed { over(self.coefficient_label(), at::COEFFICIENT) } else { over(self.friction_label(), at::FRICTION) };
        let figures = vec![
            (format!("friction_against_{against}"), friction),
            (format!("contact_fraction_against_{against}"), over("contact area over nominal area".into(), at::CONTACT)),
            (format!("mean_gap_against_{against}"), over(self.gap_label(), at::GAP)),
        ];
        noted(figures, left_out(scene, rows, kinds.len()))
    }

    /// Along a loop the way up is solid, the way down dashed; a jump is a gap in the curve, with a ring where it lands.
    fn over_the_load(&self, scene: &Scene, rows: &[Row]) -> Vec<(String, Figure)> {
        let is_loop = matches!(self.sliding.task, SurfaceTask::Loop { .. });
        let mut sets: Vec<&[f64]> = rows.iter().map(|row| row.swept.as_slice()).collect();
        sets.dedup();
        let all = sets.len();
        let sets = thinned(sets, MOST_FIELDS);
        let draw = |label: String, column: usize| {
            let mut drawn = Figure::new(Axis::linear(self.pressure_label()), Axis::linear(label));
            for (index, set) in sets.iter().enumerate() {
                let own: Vec<&Row> = rows.iter().filter(|row| row.swept == *set).collect();
                let colour = if sets.len() > 1 { shade(index, sets.len()) } else { Colour::Index(0) };
                let name = if scene.sweeps.is_empty() { String::new() } else { swept_label(scene, set) };
                let half = if is_loop { own.len() / 2 } else { own.len() };
                for (way, part) in [own.get(..half), own.get(half..)].into_iter().flatten().enumerate().filter(|(_, part)| !part.is_empty())
                {
                    let mut points = Vec::with_capacity(part.len());
                    for row in part {
                        if row.label(3) == "jump" {
                            points.push((f64::NAN, f64::NAN));
                        }
                        if is_loop || row.label(3).is_empty() {
                            points.push((value(row, at::PRESSURE), value(row, column)));
                        }
                    }
                    let line = if way == 0 { Line::Solid } else { Line::Dashed };
                    let colour = if way > 0 && is_loop && sets.len() == 1 { Colour::Index(1) } else { colour };
                    let label = match (is_loop, way, name.is_empty()) {
                        (true, 0, true) => "loading".to_owned(),
                        (true, _, true) => "unloading".to_owned(),
                        (_, 0, false) => name.clone(),
                        _ => String::new(),
                    };
                    drawn = drawn.with_curve(Curve::new(label, points).with_line(line).with(colour));
                }
                let marked: Vec<(f64, f64)> = own
                    .iter()
                    .filter(|row| !matches!(row.label(3), "" | "loading" | "unloading"))
                    .map(|row| (value(row, at::PRESSURE), value(row, column)))
                    .collect();
                if !marked.is_empty() {
                    drawn = drawn.with_curve(Curve::new("", marked).with_line(Line::None).with_marker(Marker::OpenCircle).with(colour));
                }
            }
            drawn
        };
        let mut figures = vec![
            ("friction_against_mean_pressure".to_owned(), draw(self.friction_label(), at::FRICTION)),
            ("contact_fraction_against_mean_pressure".to_owned(), draw("contact area over nominal area".into(), at::CONTACT)),
            ("mean_gap_against_mean_pressure".to_owned(), draw(self.gap_label(), at::GAP)),
        ];
        if is_loop {
            figures.push(("patches_against_mean_pressure".to_owned(), draw("patches of contact".into(), at::PATCHES)));
        }
        noted(figures, thinning(all, MOST_FIELDS, "values of the sweep"))
    }

    /// A profile over one period and its spectrum; of a surface its spectrum along the sliding direction.
    fn of_the_profile(&self) -> Vec<(String, Figure)> {
        let length = self.scales.length;
        let mut figures = Vec::new();
        if self.is_line() {
            let heights = self.profile.heights();
            let (n, step) = (heights.len(), heights.len().div_ceil(PROFILE_POINTS));
            let points = (0..n)
                .step_by(step)
                .map(|i| (i as f64 * TAU / n as f64 * length, heights.get(i).copied().unwrap_or(f64::NAN) * self.scales.height))
                .collect();
            let drawn = Figure::new(self.place_axis(), Axis::linear(self.label("height of the profile", "$h$", " (m)", r"$h/\Lambda$")));
            figures.push(("profile".to_owned(), drawn.with_curve(Curve::new("", points))));
        }
        let points = self
            .profile
            .amplitudes()
            .into_iter()
            .enumerate()
            .filter(|(_, amplitude)| *amplitude > 1e-13)
            .map(|(i, amplitude)| ((i + 1) as f64 / length, amplitude * self.scales.height))
            .collect();
        let horizontal = Axis::logarithmic(self.label("wave number along the motion", "$q$", " (1/m)", "$q/k$"));
        let vertical = Axis::logarithmic(self.label("amplitude", "$h_q$", " (m)", r"$h_q/\Lambda$"));
        let curve = Curve::new("", points).with_line(Line::None).with_marker(Marker::Circle);
        figures.push(("spectrum".to_owned(), Figure::new(horizontal, vertical).with_curve(curve)));
        figures
    }

    fn field_figures(&self, scene: &Scene, states: &[&Row]) -> Vec<(String, Figure)> {
        let note = thinning(states.len(), MOST_FIELDS, "fields");
        let states = thinned(states.to_vec(), MOST_FIELDS);
        let mut pressure = Figure::new(self.place_axis(), Axis::linear(self.stress_label()));
        let mut surface = Figure::new(self.place_axis(), Axis::linear(self.label("height", "$-w$", " (m)", r"$-w/\Lambda$")));
        for (index, row) in states.iter().enumerate() {
            let second = self.sliding.contacts.len() > 1 && row.label(0) == SlidingContact::Adhesiveless.word();
            let line = if second { Line::Dashed } else { Line::Solid };
            let label = match (self.sliding.contacts.len() > 1, scene.sweeps.is_empty()) {
                (_, true) => row.label(0).to_owned(),
                (true, false) => format!("{}, {}", row.label(0), swept_label(scene, &row.swept)),
                (false, false) => swept_label(scene, &row.swept),
            };
            let colour = shade(index, states.len());
            let along = |of: &dyn Fn(&FieldPoint) -> f64| row.fields.iter().map(|point| (point.place, of(point))).collect::<Vec<_>>();
            let curve = |label: String, points| Curve::new(label, points).with_line(line).with(colour);
            pressure = pressure.with_curve(curve(label.clone(), along(&|point| component(point, field::PRESSURE))));
            surface = surface.with_curve(curve(label, along(&|point| -component(point, field::DISPLACEMENT))));
        }
        if let [row] = states.as_slice() {
            let gap = value(row, at::GAP);
            let points = row.fields.iter().map(|point| (point.place, gap - component(point, field::PROFILE))).collect();
            surface = surface.with_curve(Curve::new("sliding surface", points).with_line(Line::Dotted).with_colour(2));
        }
        noted(vec![("pressure".into(), pressure), ("surface".into(), surface)], note)
    }

    /// Parts of the places by pressure and by gap, of at most a few states.
    fn histograms(&self, scene: &Scene, states: &[&Row]) -> Vec<(String, Figure)> {
        let first = usize::from(!self.is_line());
        let states = thinned(states.to_vec(), MOST_FIELDS);
        [("pressures", field::PRESSURE, self.stress_label()), ("gaps", field::GAP, self.label("gap", "$g$", " (m)", r"$g/\Lambda$"))]
            .into_iter()
            .map(|(name, place, label)| {
                let mut drawn = Figure::new(Axis::linear(label), Axis::logarithmic("part of the places in one of 40 bins"));
                for (index, row) in states.iter().enumerate() {
                    let values: Vec<f64> = row.fields.iter().map(|point| component(point, first + place)).collect();
                    let label = if scene.sweeps.is_empty() { row.label(0).to_owned() } else { swept_label(scene, &row.swept) };
                    drawn = drawn.with_curve(Curve::new(label, bins(&values)).with(shade(index, states.len())));
                }
                (format!("histogram_of_{name}"), drawn)
            })
            // In full contact all gaps are one number.
            .filter(|(_, drawn)| drawn.curves.iter().any(|curve| !curve.points.is_empty()))
            .collect()
    }

    pub(super) fn axis_of_sweep(&self, sweep: &Sweep) -> Axis {
        match sweep.key.as_str() {
            "sliding.speed" => axis_of(sweep, self.label("sliding speed", "$v$", " (m/s)", r"$kv\tau$")),
            "sliding.mean_pressure" => axis_of(sweep, self.pressure_label()),
            "sliding.mean_gap" => axis_of(sweep, self.gap_label()),
            "sliding.layer.thickness" => axis_of(sweep, self.label("thickness of the layer", "$d$", " (m)", "$kd$")),
            "adhesion.range" => axis_of(sweep, self.label("range of the law", "$r$", " (m)", r"$r/\Lambda$")),
            _ => swept_axis(sweep),
        }
    }

    pub(super) fn label(&self, name: &str, symbol: &str, unit: &str, reduced: &str) -> String {
        match self.units {
            Units::Si => format!("{name} {symbol}{unit}"),
            Units::Reduced => format!("{name} {reduced}"),
        }
    }

    pub(super) fn coefficient_label(&self) -> String {
        self.label("friction coefficient", r"$\mu$", "", r"$\mu/k\Lambda$")
    }

    pub(super) fn friction_label(&self) -> String {
        self.label("friction stress", r"$\tau_f$", " (Pa)", r"$2\tau_f/E_0^* k^2\Lambda^2$")
    }

    fn gap_label(&self) -> String {
        self.label("mean gap", r"$\bar{g}$", " (m)", r"$\bar{g}/\Lambda$")
    }

    fn pressure_label(&self) -> String {
        self.label("mean pressure", r"$\bar{p}$", " (Pa)", r"$2\bar{p}/E_0^* k\Lambda$")
    }

    pub(super) fn stress_label(&self) -> String {
        self.label("pressure", "$p$", " (Pa)", r"$2p/E_0^* k\Lambda$")
    }

    pub(super) fn place_axis(&self) -> Axis {
        Axis::linear(self.label("position", "$x$", " (m)", "$kx$"))
    }
}

pub(super) fn component(point: &FieldPoint, place: usize) -> f64 {
    point.values.get(place).map_or(f64::NAN, |estimate| estimate.value)
}

/// The parts of some values in equal bins, as a stepped curve; empty bins are gaps.
fn bins(values: &[f64]) -> Vec<(f64, f64)> {
    let (low, high) = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &v| (low.min(v), high.max(v)));
    let width = (high - low) / BINS as f64;
    if width.is_nan() || width <= 0.0 {
        return Vec::new();
    }
    let mut counts = [0_u32; BINS];
    for v in values {
        let bin = (((v - low) / width) as usize).min(BINS - 1);
        counts[bin] += 1;
    }
    let mut points = Vec::with_capacity(2 * BINS);
    for (bin, &count) in counts.iter().enumerate() {
        let part = if count > 0 { f64::from(count) / values.len() as f64 } else { f64::NAN };
        let start = low + width * bin as f64;
        points.extend([(start, part), (start + width, part)]);
    }
    points
}
