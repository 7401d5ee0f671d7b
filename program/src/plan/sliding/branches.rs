//! Curves of contacts as the solver gives them, in reduced units: the one place of this plan that follows a [`viscotack::sliding::branch`].

use super::SlidingPlan;
use crate::scene::typed::{BranchParameter, SlidingBranch};
use std::borrow::Cow;
use viscotack::estimate::Estimate;
use viscotack::refusal::Refusal;
use viscotack::sliding::branch::{Branch, BranchEnd, BranchPath, BranchProblem, FoldQuantity, SecondVariations, Stability, Turn, trace};
use viscotack::sliding::steady::{PartialValues, SlidingControl, WaveAdhesion};

/// The widest contact of a cylinder that is followed, in L, at no load.
const WIDEST_UNLOADED: f64 = 6.0;
/// The same over Hertz's half-width at the largest load.
const WIDEST_OVER_HERTZ: f64 = 2.0;
/// The parts of a branch within a range, in the order of the curve.
const PARTS: [&str; 4] = ["first", "second", "third", "fourth"];
/// Points by which is seen how much of a branch lies within a range.
const PROBES: usize = 40;
/// More points than these are not solved to find enough inside a range.
const MOST_POINTS: usize = 10_000;

/// What a row of a branch is.
pub(super) struct Item {
    /// Which branch: of one curve the word is "whole", of the parts of it within a range "first" and so on; of several see [`super::isolated`].
    pub(super) branch: Cow<'static, str>,
    /// The turn or the state that it is; empty for a point.
    pub(super) event: &'static str,
    /// The contact; or why there is none.
    pub(super) found: Result<Found, Refusal>,
    /// What is to be said about it.
    pub(super) note: Option<String>,
}

/// A contact of a branch, reduced.
pub(super) struct Found {
    pub(super) values: PartialValues,
    /// kv.
    pub(super) rate: Estimate,
    /// Γ of the trailing and of the leading edge.
    pub(super) reduced_works: [Estimate; 2],
    /// Both process zones.
    pub(super) zones: [Estimate; 2],
    pub(super) under_load: Option<bool>,
    pub(super) under_penetration: Option<bool>,
    pub(super) in_frame: Option<bool>,
    /// Of a turn.
    pub(super) residual: Option<f64>,
}

/// A curve of contacts.
pub(super) struct Traced {
    pub(super) items: Vec<Item>,
    pub(super) closure_evaluations: u64,
}

impl SlidingPlan {
    /// The problem of a branch without its points; `span` are the ends of its parameter, reduced.
    pub(super) fn branch_problem(&self, parameter: Option<BranchParameter>, span: Option<[f64; 2]>) -> Result<BranchProblem<'_>, Refusal> {
        let adhesion = self.reduced_adhesion().ok_or_else(|| Refusal::Undefined {
            quantity: "a branch of contacts",
            reason: "without adhesion there is no energy balance at the edges".into(),
        })?;
        let mut problem = BranchProblem::loads(self.rate(self.sliding.speed), adhesion, self.accuracy);
        problem.indenter = self.indenter();
        problem.work_by_speed = self.work_by_rate.as_ref();
        if !self.is_wave() {
            let largest = match (parameter, span) {
                (Some(BranchParameter::LoadPerWidth), Some([_, largest])) => largest.max(0.0),
                _ => 0.0,
            };
            // Hertz: (a/L)² = 4F̃.
            problem.half_widths[1] = WIDEST_UNLOADED.max(WIDEST_OVER_HERTZ * 2.0 * largest.sqrt());
        }
        match (parameter, span) {
            (Some(BranchParameter::HalfWidth), Some(span)) => problem.half_widths = span,
            (Some(BranchParameter::Speed), Some(span)) => (problem.path, problem.parameters) = (BranchPath::Speeds(self.control()), span),
            (Some(BranchParameter::WorkOfAdhesion), Some(span)) => {
                (problem.path, problem.parameters) = (BranchPath::Adhesions(self.control()), span);
            }
            (Some(BranchParameter::ProcessZone), Some(span)) => {
                let factors = span.map(|zone| zone / adhesion.trailing_zone);
                (problem.path, problem.parameters) = (BranchPath::Zones(self.control()), factors);
            }
            _ => {}
        }
        Ok(problem)
    }

    /// The ends of a branch's parameter, reduced.
    pub(super) fn span(&self, branch: &SlidingBranch) -> Option<[f64; 2]> {
        let unit = match branch.parameter {
            BranchParameter::MeanPressure | BranchParameter::LoadPerWidth => self.scale.load,
            BranchParameter::Penetration => self.scale.displacement,
            BranchParameter::HalfWidth | BranchParameter::Speed | BranchParameter::ProcessZone => self.scale.length,
            BranchParameter::WorkOfAdhesion => self.scale.work_of_adhesion,
        };
        branch.range.map(|ends| ends.map(|end| end / unit))
    }

    /// The contacts of a branch.
    pub(super) fn traced(&self, branch: &SlidingBranch) -> Result<Traced, Refusal> {
        let span = self.span(branch);
        let mut problem = self.branch_problem(Some(branch.parameter), span)?;
        problem.points = branch.points as usize;
        let material = &self.material;
        match (branch.parameter, span) {
            _ if branch.every => self.every_traced(branch, &problem),
            (BranchParameter::Speed, _) => self.speeds_traced(branch, &problem),
            (BranchParameter::MeanPressure | BranchParameter::LoadPerWidth | BranchParameter::Penetration, Some(span)) => {
                let place = if branch.parameter == BranchParameter::Penetration { 3 } else { 2 };
                self.within(branch, &mut problem, place, span)
            }
            _ => {
                let mut traced = Traced { items: Vec::new(), closure_evaluations: 0 };
                self.collect(&mut traced, branch, &problem, trace(material, &problem)?, "whole", None);
                Ok(traced)
            }
        }
    }

    /// The part of a branch of loads on which a quantity, by its place in an outline, lies within a span. The whole one is followed first, to see how
    /// much of it that is.
    fn within(
        &self,
        branch: &SlidingBranch,
        problem: &mut BranchProblem<'_>,
        place: usize,
        [from, to]: [f64; 2],
    ) -> Result<Traced, Refusal> {
        let inside = |values: &PartialValues| {
            let value = if place == 3 { values.penetration } else { values.mean_pressure };
            value.value + value.error >= from && value.value - value.error <= to
        };
        let whole = trace(&self.material, &BranchProblem { points: PROBES, ..*problem })?;
        let mut traced = Traced { items: Vec::new(), closure_evaluations: whole.work.closure_evaluations };
        let met = whole.points.iter().filter(|point| inside(&point.values)).count();
        let outline = whole.outline();
        let values = || outline.iter().filter_map(|point| point.get(place).copied());
        let (least, most) = (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
        if met == 0 && (from > most || to < least) {
            let (above, name) = (from > most, if place == 3 { "penetration" } else { "load" });
            return Err(Refusal::NoSuchState {
                reason: format!("no contact of the branch has a {name} in the range"),
                limit_name: match (above, place) {
                    (true, 3) => "the largest penetration",
                    (false, 3) => "the smallest penetration",
                    (true, _) => "the largest load",
                    (false, _) => "the smallest load",
                },
                limit: if above { most } else { least },
            });
        }
        let part = met.max(1) as f64 / PROBES as f64;
        problem.points = ((f64::from(branch.points) / part).ceil() as usize).min(MOST_POINTS.max(branch.points as usize));
        let found = trace(&self.material, problem)?;
        self.collect(&mut traced, branch, problem, found, "whole", None);
        // A curve that leaves the range and comes back is so many parts.
        let (mut part, mut left) = (0, false);
        traced.items.retain_mut(|item| {
            let kept = item.found.as_ref().map_or(true, |found| inside(&found.values));
            if kept {
                part += usize::from(left || part == 0);
                item.branch = PARTS.get(part - 1).copied().unwrap_or("further").into();
            }
            left = !kept && part > 0;
            kept
        });
        Ok(traced)
    }

    /// Points and turns of a branch in the order of the curve.
    pub(super) fn collect(
        &self,
        traced: &mut Traced,
        branch: &SlidingBranch,
        problem: &BranchProblem<'_>,
        found: Branch,
        name: impl Into<Cow<'static, str>>,
        gap: Option<&str>,
    ) {
        let name = name.into();
        traced.closure_evaluations += found.work.closure_evaluations;
        let stiffness = branch.frame_stiffness.map(|stiffness| stiffness * self.scale.displacement / self.scale.load);
        let at = |parameter: Estimate, values: PartialValues, variations: Option<&SecondVariations>, residual| {
            let (rate, reduced_works, factor) = conditions(problem, parameter);
            let zones = [problem.adhesion.trailing_zone, problem.adhesion.leading_zone]
                .map(|zone| Estimate::new(zone * factor.value, zone * factor.error));
            let reported = |of: &dyn Fn(&SecondVariations) -> Stability| variations.and_then(|variations| stable(of(variations)));
            Found {
                values,
                rate,
                reduced_works,
                zones,
                under_load: reported(&SecondVariations::under_load),
                under_penetration: reported(&SecondVariations::under_penetration),
                in_frame: stiffness.and_then(|stiffness| reported(&|variations| variations.in_frame(stiffness))),
                residual,
            }
        };
        let meant = [found.pull_off(problem), found.snap_in(), found.separation()].map(|fold| fold.map(|fold| fold.arclength.to_bits()));
        let mut items: Vec<(f64, Item)> = Vec::new();
        for point in found.points {
            let found = Ok(at(point.parameter, point.values, Some(&point.variations), None));
            items.push((point.arclength, Item { branch: name.clone(), event: "", found, note: None }));
        }
        for (arclength, refusal) in found.left_out {
            items.push((arclength, Item { branch: name.clone(), event: "", found: Err(refusal), note: None }));
        }
        for (quantity, arclength, refusal) in found.unlocated {
            items.push((arclength, Item { branch: name.clone(), event: turn_of(quantity, None), found: Err(refusal), note: None }));
        }
        for fold in found.folds {
            let event = match meant.iter().position(|place| *place == Some(fold.arclength.to_bits())) {
                Some(0) if fold.quantity == FoldQuantity::MeanPressure => "pull_off",
                Some(1) if fold.quantity == FoldQuantity::MeanPressure => "snap_in",
                Some(2) if fold.quantity == FoldQuantity::Penetration => "separation",
                _ => turn_of(fold.quantity, Some(fold.turn)),
            };
            let note = if fold.quantity == FoldQuantity::LogRate { gap.map(str::to_owned) } else { None };
            let mut found = at(fold.parameter(), fold.contact, Some(&fold.variations), Some(fold.residual));
            // What is held turns here: neither stable nor unstable, whatever rounding says.
            match (fold.quantity, problem.held()) {
                (FoldQuantity::HalfWidth, _) => {}
                (FoldQuantity::Penetration, _) | (_, Some(SlidingControl::Penetration(_))) => found.under_penetration = None,
                _ => found.under_load = None,
            }
            let found = Ok(found);
            items.push((fold.arclength, Item { branch: name.clone(), event, found, note }));
        }
        for point in found.zero_load {
            let found = Ok(at(point.values.mean_pressure, point.values, Some(&point.variations), None));
            items.push((point.arclength, Item { branch: name.clone(), event: "zero_load", found, note: None }));
        }
        items.sort_by(|first, second| first.0.total_cmp(&second.0));
        let mut items: Vec<Item> = items.into_iter().map(|(_, item)| item).collect();
        if let (Some(first), Some(note)) = (items.first_mut(), self.ending("begins", &found.begins)) {
            first.note = Some(note);
        }
        if let (Some(last), Some(note)) = (items.last_mut(), self.ending("ends", &found.ends)) {
            last.note = Some(note);
        }
        traced.items.extend(items);
    }

    /// Where a branch stops before the end that was asked for.
    fn ending(&self, verb: &str, end: &BranchEnd) -> Option<String> {
        match end {
            BranchEnd::Impossible { half_width, witness, .. } => {
                let half_width = half_width * self.scale.length;
                Some(format!("the branch {verb} at a half-width of {half_width:.4e}: {}", witness.name()))
            }
            BranchEnd::Lost { half_width, reason, .. } => {
                let half_width = half_width * self.scale.length;
                Some(format!("the branch {verb} at a half-width of {half_width:.4e}: {}", self.sentence(reason)))
            }
            BranchEnd::TooLong => Some(format!("the branch {verb} here: it is too long")),
            BranchEnd::HalfWidth(_) | BranchEnd::Parameter(_) | BranchEnd::Closed => None,
        }
    }

    /// The branch of every load at the scene's speed, whose turns are what the contact carries.
    pub(super) fn every_load(&self) -> Result<BranchProblem<'_>, Refusal> {
        self.branch_problem(None, None)
    }
}

/// Rate, Γ of both edges and factor of the zones at a value of the parameter.
fn conditions(problem: &BranchProblem<'_>, parameter: Estimate) -> (Estimate, [Estimate; 2], Estimate) {
    let WaveAdhesion { trailing_work, leading_work, .. } = problem.adhesion;
    let (rate, works, one) = (Estimate::exact(problem.rate), [trailing_work, leading_work].map(Estimate::exact), Estimate::exact(1.0));
    match (problem.path, problem.work_by_speed) {
        (BranchPath::Loads, _) => (rate, works, one),
        (BranchPath::Speeds(_), None) => (parameter, works, one),
        (BranchPath::Speeds(_), Some(law)) => {
            let of = |edge: fn([f64; 2]) -> f64, given: f64| {
                let at = |rate: f64| given * (edge(law.factors(rate)) / edge(law.factors(problem.rate)));
                let (low, here, high) = (at(parameter.value - parameter.error), at(parameter.value), at(parameter.value + parameter.error));
                Estimate::new(here, (low - here).abs().max((high - here).abs()) + 4.0 * f64::EPSILON * here)
            };
            (parameter, [of(|[trailing, _]| trailing, trailing_work), of(|[_, leading]| leading, leading_work)], one)
        }
        (BranchPath::Adhesions(_), _) => (rate, [parameter, parameter.scaled(leading_work / trailing_work)], one),
        (BranchPath::Zones(_), _) => (rate, works, parameter),
    }
}

fn stable(stability: Stability) -> Option<bool> {
    match stability {
        Stability::Stable => Some(true),
        Stability::Unstable => Some(false),
        Stability::Marginal => None,
    }
}

/// The word of a turn that has no name of its own.
fn turn_of(quantity: FoldQuantity, turn: Option<Turn>) -> &'static str {
    match (quantity, turn) {
        (FoldQuantity::MeanPressure, Some(Turn::Minimum)) => "smallest_load",
        (FoldQuantity::MeanPressure, Some(Turn::Maximum)) => "largest_load",
        (FoldQuantity::MeanPressure, None) => "turn_of_load",
        (FoldQuantity::Penetration, Some(Turn::Minimum)) => "smallest_penetration",
        (FoldQuantity::Penetration, Some(Turn::Maximum)) => "largest_penetration",
        (FoldQuantity::Penetration, None) => "turn_of_penetration",
        (FoldQuantity::HalfWidth, Some(Turn::Minimum)) => "smallest_half_width",
        (FoldQuantity::HalfWidth, Some(Turn::Maximum)) => "largest_half_width",
        (FoldQuantity::HalfWidth, None) => "turn_of_half_width",
        (FoldQuantity::LogRate, Some(Turn::Minimum)) => "smallest_speed",
        (FoldQuantity::LogRate, Some(Turn::Maximum)) => "largest_speed",
        (FoldQuantity::LogRate, None) => "turn_of_speed",
        (FoldQuantity::LogWork, Some(Turn::Minimum)) => "smallest_work_of_adhesion",
        (FoldQuantity::LogWork, Some(Turn::Maximum)) => "largest_work_of_adhesion",
        (FoldQuantity::LogWork, None) => "turn_of_work_of_adhesion",
        (FoldQuantity::LogZone, Some(Turn::Minimum)) => "smallest_process_zone",
        (FoldQuantity::LogZone, Some(Turn::Maximum)) => "largest_process_zone",
        (FoldQuantity::LogZone, None) => "turn_of_process_zone",
    }
}
