//! The plots of branches, stable parts and others distinguished, turns marked; and of strengths.

use super::SlidingPlan;
use super::columns::{at, place_of, strength};
use super::isolated::ISOLA;
use crate::outcome::Row;
use crate::outcome::plot::{Axis, Curve, Figure, Line, Marker};
use crate::plan::curves::{Kind, Ordinate, families, figure, innermost, shade, swept_label, thinned, thinning, value};
use crate::scene::typed::{BranchParameter, Scene, SlidingBranch, SlidingContact, SlidingLoad, Units};

/// Most states whose branches are drawn in one figure.
const MOST_BRANCHES: usize = 6;

/// Half-widths that span more than this factor have a logarithmic axis.
const LOGARITHMIC_FROM: f64 = 10.0;

/// Turns that are marked, with their sign and name; all others are diamonds.
const MARKS: [(&str, Marker, &str); 4] = [
    ("pull_off", Marker::Circle, "pull-off"),
    ("snap_in", Marker::Square, "snap-in"),
    ("separation", Marker::Triangle, "separation"),
    ("zero_load", Marker::OpenCircle, "no load"),
];

/// How a part of a branch holds.
#[derive(Clone, Copy, PartialEq)]
enum Held {
    /// Under what is held along the branch; along loads under a held load.
    Stable,
    /// Along loads: under a held penetration only.
    ByPenetration,
    Unstable,
}

impl Held {
    const ALL: [Self; 3] = [Self::Stable, Self::ByPenetration, Self::Unstable];

    const fn line(self) -> Line {
        match self {
            Self::Stable => Line::Solid,
            Self::ByPenetration => Line::Dashed,
            Self::Unstable => Line::Dotted,
        }
    }
}

impl SlidingPlan {
    pub(super) fn branch_drawings(&self, branch: &SlidingBranch, scene: &Scene, rows: &[Row]) -> Vec<(String, Figure)> {
        let load = || Axis::linear(self.load_label());
        let width = || Axis::linear(self.half_width_label());
        let draw = |horizontal: Axis, vertical: Axis, columns: (usize, usize)| {
            self.branch_figure(branch, scene, rows, (horizontal, vertical), columns)
        };
        if branch.parameter.is_load() {
            let name = if self.is_wave() { "mean_pressure" } else { "load" };
            let mut figures = vec![(format!("{name}_against_half_width"), draw(width(), load(), (at::HALF_WIDTH, at::LOAD)))];
            if self.is_wave() {
                let depth = Axis::linear(self.label("penetration", r"$\Delta$", " (m)", r"$\Delta/\Lambda$", ""));
                figures.insert(0, (format!("{name}_against_penetration"), draw(depth, load(), (at::PENETRATION, at::LOAD))));
            }
            return figures;
        }
        let (label, column) = match branch.parameter {
            BranchParameter::Speed => (self.label("sliding speed", "$v$", " (m/s)", r"$kv\tau$", r"$v\tau/L$"), at::SPEED),
            BranchParameter::ProcessZone => {
                (self.label("process zone", r"$\delta$", " (m)", r"$k\delta$", r"$\delta/L$"), at::TRAILING_ZONE)
            }
            _ => (
                self.label("work of adhesion", r"$\Delta\gamma$", " (J/m²)", r"$\Gamma$", r"$\Gamma$"),
                place_of(&self.sliding, "work_of_adhesion"),
            ),
        };
        let along = || Axis::logarithmic(label.clone());
        let against = branch.parameter.word();
        let positive = rows.iter().filter_map(|row| row.value(at::FRICTION)).all(|friction| friction > 0.0);
        let vertical = if positive { Axis::logarithmic(self.friction_label()) } else { Axis::linear(self.friction_label()) };
        let friction = (format!("friction_against_{against}"), draw(along(), vertical, (column, at::FRICTION)));
        let other = match self.sliding.control {
            SlidingLoad::HalfWidth(_) => ("load", load(), at::LOAD),
            _ => {
                let widths = || rows.iter().filter_map(|row| row.value(at::HALF_WIDTH));
                let (narrowest, widest) = (widths().fold(f64::INFINITY, f64::min), widths().fold(0.0, f64::max));
                // Contacts of all widths, such as an isola of narrow ones beside almost full ones.
                let axis = if widest > LOGARITHMIC_FROM * narrowest { Axis::logarithmic } else { Axis::linear };
                ("half_width", axis(self.half_width_label()), at::HALF_WIDTH)
            }
        };
        vec![(format!("{}_against_{against}", other.0), draw(along(), other.1, (column, other.2))), friction]
    }

    fn half_width_label(&self) -> String {
        self.label("contact half-width", "$a$", " (m)", "$ka$", "$a/L$")
    }

    fn name_of(&self, branch: &SlidingBranch, held: Held) -> &'static str {
        match held {
            Held::Stable if branch.parameter.is_load() && self.is_wave() => "stable under load",
            Held::Stable => "stable",
            Held::ByPenetration => "stable at held penetration",
            Held::Unstable => "unstable",
        }
    }

    /// How a row holds; none at a turn.
    fn held(&self, branch: &SlidingBranch, row: &Row) -> Option<Held> {
        let flag = |name: &str| row.value(place_of(&self.sliding, name)).map(|flag| flag > 0.5);
        let by_penetration = || flag("stable_under_penetration");
        if !branch.parameter.is_load() {
            let held =
                if matches!(self.sliding.control, SlidingLoad::Penetration(_)) { by_penetration() } else { flag("stable_under_load") };
            return held.map(|stable| if stable { Held::Stable } else { Held::Unstable });
        }
        match (flag("stable_under_load")?, self.is_wave()) {
            (true, _) => Some(Held::Stable),
            (false, false) => Some(Held::Unstable),
            (false, true) => by_penetration().map(|stable| if stable { Held::ByPenetration } else { Held::Unstable }),
        }
    }

    fn branch_figure(
        &self,
        branch: &SlidingBranch,
        scene: &Scene,
        rows: &[Row],
        (horizontal, vertical): (Axis, Axis),
        (across, up): (usize, usize),
    ) -> Figure {
        let point = |row: &Row| (value(row, across), value(row, up));
        let mut states: Vec<usize> = rows.iter().map(|row| row.state).collect();
        states.dedup();
        let several = states.len() > 1;
        let note = thinning(states.len(), MOST_BRANCHES, "states");
        let states = thinned(states, MOST_BRANCHES);
        let mut drawn = Figure::new(horizontal, vertical);
        drawn.note = note;
        for (colour, state) in states.iter().enumerate() {
            let own: Vec<&Row> = rows.iter().filter(|row| row.state == *state && row.status.has_values()).collect();
            for held in Held::ALL {
                let points = self.parts(branch, &own, held, &point);
                if points.is_empty() {
                    continue;
                }
                let label = match (several, held) {
                    (true, Held::Stable) => own.first().map_or_else(String::new, |row| swept_label(scene, &row.swept)),
                    (true, _) => String::new(),
                    (false, held) => self.name_of(branch, held).into(),
                };
                drawn = drawn.with_curve(Curve::new(label, points).with_line(held.line()).with(shade(colour, states.len())));
            }
        }
        if several {
            // What the strokes are, without a curve of their own.
            for held in Held::ALL {
                let is_there = rows.iter().any(|row| states.contains(&row.state) && self.held(branch, row) == Some(held));
                if is_there && held != Held::Stable {
                    drawn = drawn.with_curve(Curve::new(self.name_of(branch, held), Vec::new()).with_line(held.line()).with_colour(2));
                }
            }
        }
        // Signs on top of all curves.
        let kept = |row: &&Row| states.contains(&row.state) && row.status.has_values() && !row.label(3).is_empty();
        for (event, marker, name) in MARKS {
            let points: Vec<(f64, f64)> = rows.iter().filter(kept).filter(|row| row.label(3) == event).map(point).collect();
            if !points.is_empty() {
                drawn = drawn.with_curve(Curve::new(name, points).with_line(Line::None).with_marker(marker).with_colour(2));
            }
        }
        let unnamed = |row: &&Row| MARKS.iter().all(|(event, ..)| row.label(3) != *event);
        let folds: Vec<(f64, f64)> =
            if branch.parameter.is_load() { Vec::new() } else { rows.iter().filter(kept).filter(unnamed).map(point).collect() };
        if folds.is_empty() {
            drawn
        } else {
            drawn.with_curve(Curve::new("fold", folds).with_line(Line::None).with_marker(Marker::Diamond).with_colour(2))
        }
    }

    /// The parts of one state's branches that hold in one way, gaps between them; a turn belongs to the parts on both sides.
    fn parts(&self, branch: &SlidingBranch, rows: &[&Row], held: Held, point: &dyn Fn(&Row) -> (f64, f64)) -> Vec<(f64, f64)> {
        let ways: Vec<Option<Held>> = rows.iter().map(|row| self.held(branch, row)).collect();
        let (mut points, mut first) = (Vec::new(), 0);
        for (index, row) in rows.iter().enumerate() {
            let begins = index.checked_sub(1).and_then(|before| rows.get(before)).is_none_or(|before| before.label(2) != row.label(2));
            if begins {
                first = index;
            }
            // A closed branch comes back to its first point.
            let next = match rows.get(index + 1) {
                Some(next) if next.label(2) == row.label(2) => index + 1,
                _ if row.label(2).starts_with(ISOLA) => first,
                _ => continue,
            };
            let Some((from, to)) = rows.get(index).zip(rows.get(next)) else { continue };
            let (before, after) = (ways.get(index).copied().flatten(), ways.get(next).copied().flatten());
            // Between a turn and a point the point tells; between two points that differ, the second.
            let way = after.or(before);
            if way != Some(held) {
                continue;
            }
            let (start, end) = (point(from), point(to));
            if points.last() != Some(&start) {
                points.extend([(f64::NAN, f64::NAN), start]);
            }
            points.push(end);
        }
        points
    }

    fn load_label(&self) -> String {
        match (self.units, self.is_wave()) {
            (Units::Si, true) => r"mean pressure $\bar{p}$ (Pa)".into(),
            (Units::Si, false) => "load per width $F$ (N/m)".into(),
            (Units::Reduced, true) => r"mean pressure $2\bar{p}/E_0^* k\Lambda$".into(),
            (Units::Reduced, false) => r"load per width $F R/\pi E_0^* L^2$".into(),
        }
    }

    pub(super) fn strength_drawings(&self, scene: &Scene, rows: &[Row]) -> Vec<(String, Figure)> {
        let word = SlidingContact::Adhesive.word();
        let families = families(scene, rows, &[Kind { word, name: word, line: Line::Solid }]);
        let Some(sweep) = scene.sweeps.last().filter(|_| families.iter().any(|family| family.rows.len() > 1)) else { return Vec::new() };
        let against = sweep.key.strip_prefix("sliding.").unwrap_or(&sweep.key).replace('.', "_");
        let horizontal = self.axis_of_sweep(sweep);
        let over = |vertical: Axis, column: usize, factor: f64| {
            figure(&families, (horizontal.clone(), vertical), innermost, Ordinate { column, factor })
        };
        let pull_off = match (self.units, self.is_wave()) {
            (Units::Si, true) => r"pull-off pressure $|p_\mathrm{out}|$ (Pa)",
            (Units::Si, false) => r"pull-off force per width $|F_\mathrm{out}|$ (N/m)",
            (Units::Reduced, true) => r"pull-off pressure $2|p_\mathrm{out}|/E_0^* k\Lambda$",
            (Units::Reduced, false) => r"pull-off force $|F_\mathrm{out}| R/\pi E_0^* L^2$",
        };
        // Beside each the elastic reference contact, if it is asked for.
        let beside = |drawn: Figure, name: &str, sign: f64| self.beside_reference(drawn, &families, name, sign);
        let pulled = over(Axis::linear(pull_off), strength::PULL_OFF, -1.0);
        let mut figures = vec![(format!("pull_off_against_{against}"), beside(pulled, "elastic_pull_off_pressure", -1.0))];
        if self.is_wave() {
            let snap_in = self.label("snap-in pressure", r"$p_\mathrm{IN}$", " (Pa)", r"$2p_\mathrm{IN}/E_0^* k\Lambda$", "");
            let positive = rows.iter().filter_map(|row| row.value(strength::SNAP_IN)).all(|pressure| pressure > 0.0);
            let snap_in = if positive { Axis::logarithmic(snap_in) } else { Axis::linear(snap_in) };
            let toughness = self.label("toughness", "$T$", " (J/m)", r"$2T/E_0^* \Lambda^2$", "");
            let snapped = over(snap_in, strength::SNAP_IN, 1.0);
            figures.push((format!("snap_in_against_{against}"), beside(snapped, "elastic_snap_in_pressure", 1.0)));
            let tough = over(Axis::linear(toughness), strength::TOUGHNESS, 1.0);
            figures.push((format!("toughness_against_{against}"), beside(tough, "elastic_toughness", 1.0)));
        }
        figures.extend(self.extra_drawings(scene, rows, &against, [("pull_off_pressure", r"|p_\mathrm{out}|"), ("toughness", "T")]));
        figures
    }
}
