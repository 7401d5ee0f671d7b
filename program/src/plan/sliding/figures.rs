//! The plots of a sliding contact: friction, contact and edges against what the sweep varies, and the fields along the surface.

use super::SlidingPlan;
use super::columns::{at, field};
use crate::outcome::plot::{Axis, Colour, Curve, Figure, Line};
use crate::outcome::{FieldPoint, Row};
use crate::plan::curves::{
    Family, Kind, axis_of, families, figure, innermost, left_out, noted, shade, swept_axis, swept_label, thinned, thinning, value,
};
use crate::scene::sweep::Sweep;
use crate::scene::typed::{Scene, SlidingContact, SlidingIndenter, Units};
use std::f64::consts::PI;

/// Most states whose fields are drawn in one figure.
const MOST_FIELDS: usize = 5;

impl SlidingPlan {
    pub(super) fn drawings(&self, scene: &Scene, rows: &[Row]) -> Vec<(String, Figure)> {
        let mut figures = Vec::new();
        let kinds: Vec<Kind> = self.sliding.contacts.iter().map(|&contact| self.kind(contact)).collect();
        let families = families(scene, rows, &kinds);
        // One state has no curve.
        if let Some(sweep) = scene.sweeps.last()
            && families.iter().any(|family| family.rows.len() > 1)
        {
            let against = sweep.key.strip_prefix("sliding.").unwrap_or(&sweep.key).replace('.', "_");
            let horizontal = self.axis_of_sweep(sweep);
            let over_sweep = |label: String, column: usize| figure(&families, (horizontal.clone(), Axis::linear(label)), innermost, column);
            let pressed = rows.iter().filter(|row| row.value(at::FRICTION).is_some()).all(|row| row.value(at::COEFFICIENT).is_some());
            let friction = if pressed {
                over_sweep(self.label("friction coefficient", r"$\mu$", "", r"$\mu/k\Lambda$", r"$\mu R/L$"), at::COEFFICIENT)
            } else {
                let mut drawn = over_sweep(self.friction_label(), at::FRICTION);
                for family in families.iter().filter(|family| family.kind.word == SlidingContact::Adhesive.word()) {
                    drawn = drawn.with_curve(self.adhesive_part(family));
                }
                drawn
            };
            figures.push((format!("friction_against_{against}"), friction));
            let half_width = over_sweep(self.label("contact half-width", "$a$", " (m)", "$ka$", "$a/L$"), at::HALF_WIDTH);
            figures
                .push((format!("half_width_against_{against}"), self.beside_reference(half_width, &families, "elastic_half_width", 1.0)));
            figures.push((
                format!("eccentricity_against_{against}"),
                over_sweep(self.label("eccentricity", "$e$", " (m)", "$ke$", "$e/L$"), at::ECCENTRICITY),
            ));
            figures.extend(self.extra_drawings(scene, rows, &against, [("half_width", "a"), ("friction_stress", r"\tau_f")]));
            figures.extend(self.release_figure(&families, horizontal.clone()).map(|drawn| (format!("edges_against_{against}"), drawn)));
            figures = noted(figures, left_out(scene, rows, kinds.len()));
        }
        figures.extend(self.field_figures(scene, rows));
        figures
    }

    /// The adhesive contact is solid, the adhesiveless one dashed; alone, either is solid.
    fn kind(&self, contact: SlidingContact) -> Kind {
        let dashed = contact == SlidingContact::Adhesiveless && self.sliding.contacts.len() > 1;
        Kind { word: contact.word(), name: contact.word(), line: if dashed { Line::Dashed } else { Line::Solid } }
    }

    /// A label with its symbol: in SI units, or as a reduced group of a wave or of a cylinder.
    pub(super) fn label(&self, name: &str, symbol: &str, unit: &str, of_wave: &str, of_cylinder: &str) -> String {
        match (self.units, self.is_wave()) {
            (Units::Si, _) => format!("{name} {symbol}{unit}"),
            (Units::Reduced, true) => format!("{name} {of_wave}"),
            (Units::Reduced, false) => format!("{name} {of_cylinder}"),
        }
    }

    pub(super) fn friction_label(&self) -> String {
        match (self.units, self.is_wave()) {
            (Units::Si, true) => r"friction stress $\tau_f$ (Pa)".into(),
            (Units::Si, false) => "friction per width (N/m)".into(),
            (Units::Reduced, true) => r"friction stress $2\tau_f/E_0^* k^2\Lambda^2$".into(),
            (Units::Reduced, false) => r"friction per width $F_t R^2/\pi E_0^* L^3$".into(),
        }
    }

    pub(super) fn axis_of_sweep(&self, sweep: &Sweep) -> Axis {
        match sweep.key.as_str() {
            "sliding.speed" => axis_of(sweep, self.label("sliding speed", "$v$", " (m/s)", r"$kv\tau$", r"$v\tau/L$")),
            "sliding.mean_pressure" => axis_of(sweep, self.label("mean pressure", r"$\bar{p}$", " (Pa)", r"$2\bar{p}/E_0^* k\Lambda$", "")),
            "sliding.load_per_width" => axis_of(sweep, self.label("load per width", "$F$", " (N/m)", "", r"$F R/\pi E_0^* L^2$")),
            "sliding.penetration" => axis_of(sweep, self.label("penetration", r"$\Delta$", " (m)", r"$\Delta/\Lambda$", "")),
            _ => swept_axis(sweep),
        }
    }

    /// The adhesive part of the friction, dotted.
    fn adhesive_part(&self, family: &Family<'_>) -> Curve {
        let points = family.points(innermost, |row| value(row, at::ADHESIVE_FRICTION));
        let label = if family.colour == 0 { "adhesive part" } else { "" };
        Curve::new(label, points).with_line(Line::Dotted).with(family.shade)
    }

    /// G/Δγ of both edges of the adhesive contact: the opening edge solid, the closing one dashed.
    fn release_figure(&self, families: &[Family<'_>], horizontal: Axis) -> Option<Figure> {
        self.sliding.adhesion.filter(|_| self.sliding.contacts.contains(&SlidingContact::Adhesive))?;
        let mut drawn = Figure::new(horizontal, Axis::logarithmic(r"energy release rate $G/\Delta\gamma$"));
        for family in families.iter().filter(|family| family.kind.word == SlidingContact::Adhesive.word()) {
            let alone = family.label == family.kind.name;
            for (edge, column, rest, line) in [
                ("trailing edge", at::TRAILING_RELEASE, at::TRAILING_NONCONSERVATIVE, Line::Solid),
                ("leading edge", at::LEADING_RELEASE, at::LEADING_NONCONSERVATIVE, Line::Dashed),
            ] {
                let label = match (alone, line) {
                    (true, _) => edge.to_owned(),
                    (false, Line::Solid) => family.label.clone(),
                    (false, _) => String::new(),
                };
                let colour = if alone && line == Line::Dashed { Colour::Index(1) } else { family.shade };
                // What is released and what is not make up Δγ of the edge at the speed of the row.
                let points = family.points(innermost, |row| value(row, column) / (value(row, column) + value(row, rest)));
                drawn = drawn.with_curve(Curve::new(label, points).with_line(line).with(colour));
            }
        }
        Some(drawn)
    }

    fn field_figures(&self, scene: &Scene, rows: &[Row]) -> Vec<(String, Figure)> {
        let states: Vec<&Row> = rows.iter().filter(|row| !row.fields.is_empty()).collect();
        if states.is_empty() {
            return Vec::new();
        }
        let note = thinning(states.len(), MOST_FIELDS, "fields");
        let states = thinned(states, MOST_FIELDS);
        let along = || Axis::linear(self.label("position", "$x$", " (m)", "$kx$", "$x/L$"));
        let (lowest, highest) = states
            .iter()
            .filter_map(|row| bulk(&row.fields))
            .fold((0.0_f64, 0.0_f64), |range, of_row| (range.0.min(of_row.0), range.1.max(of_row.1)));
        let room = 0.15 * (highest - lowest);
        let mut vertical = Axis::linear(self.label("pressure", "$p$", " (Pa)", r"$2p/E_0^* k\Lambda$", r"$2pR/E_0^* L$"));
        if room > 0.0 {
            vertical = vertical.with_range(lowest - room, highest + room);
        }
        let places = || states.iter().flat_map(|row| contact(&row.fields)).map(|point| point.place);
        let mut horizontal = along();
        if let (Some(first), Some(last)) = (places().reduce(f64::min), places().reduce(f64::max))
            && first < last
        {
            // The steep ends must not lie on the frame.
            horizontal = horizontal.with_range(first - 0.05 * (last - first), last + 0.05 * (last - first));
        }
        let mut pressure = Figure::new(horizontal, vertical);
        let mut surface = Figure::new(along(), Axis::linear(self.label("height", "$-w$", " (m)", r"$-w/\Lambda$", r"$-wR/L^2$")));
        let several = self.sliding.contacts.len() > 1;
        for (index, row) in states.iter().enumerate() {
            let line = if several && row.label(0) == SlidingContact::Adhesiveless.word() { Line::Dashed } else { Line::Solid };
            let label = match (several, scene.sweeps.is_empty()) {
                (_, true) => row.label(0).to_owned(),
                (true, false) => format!("{}, {}", row.label(0), swept_label(scene, &row.swept)),
                (false, false) => swept_label(scene, &row.swept),
            };
            let points = contact(&row.fields).map(|point| (point.place, component(point, field::PRESSURE))).collect();
            pressure = pressure.with_curve(Curve::new(label.clone(), points).with_line(line).with(shade(index, states.len())));
            let points = row.fields.iter().map(|point| (point.place, -component(point, field::DISPLACEMENT))).collect();
            surface = surface.with_curve(Curve::new(label, points).with_line(line).with(shade(index, states.len())));
        }
        // One sliding body for the first state: each state has its own height of it.
        if let ([row], SlidingIndenter::Wave { .. }) = (states.as_slice(), self.sliding.indenter) {
            surface = surface.with_curve(self.wave_profile(row));
        }
        noted(vec![("pressure".into(), pressure), ("surface".into(), surface)], note)
    }

    /// The wave over a single contact, from the places where it touches.
    fn wave_profile(&self, row: &Row) -> Curve {
        let depth = row.value(at::PENETRATION).unwrap_or(0.0);
        let (length, height) = (self.scale.length, self.scale.displacement);
        let points = (0..=200)
            .map(|index| PI * (f64::from(index) / 100.0 - 1.0))
            .map(|x| (x * length, 2.0 * (0.5 * x).sin().powi(2) * height - depth))
            .collect();
        Curve::new("sliding body", points).with_line(Line::Dotted).with_colour(2)
    }
}

fn component(point: &FieldPoint, place: usize) -> f64 {
    point.values.get(place).map_or(f64::NAN, |estimate| estimate.value)
}

/// The points in the contact: outside the pressure is exactly zero.
fn contact(fields: &[FieldPoint]) -> impl Iterator<Item = &FieldPoint> {
    fields.iter().filter(|point| point.values.get(field::PRESSURE).is_some_and(|pressure| pressure.error > 0.0))
}

/// The range of the pressures without their singular ends, which a figure cuts.
fn bulk(fields: &[FieldPoint]) -> Option<(f64, f64)> {
    let mut pressures: Vec<f64> = contact(fields).map(|point| component(point, field::PRESSURE)).collect();
    pressures.sort_by(f64::total_cmp);
    let at = |part: f64| pressures.get((part * pressures.len() as f64) as usize).copied();
    at(0.1).zip(at(0.97))
}
