//! Pressure and surface displacement at any radius.
//!
//! p(r) = (1/π)[Q(a)/√(a² − r²) − ∫_r^a Q′/√(s² − r²) ds], w(r) = (2/π)∫₀^r W/√(r² − s²) ds, panel by panel; a jump of Q between two panels
//! is an atom [Q]/√(s₀² − r²). Substitutions s = r cosh θ and s = r sin θ take the root away.

use super::line::Contact;
use super::panel::{POINTS, Panel, RULE, value_at};
use crate::refusal::{Refusal, require_finite, require_non_negative};
use crate::special::gauss_legendre::UNIT_RULE_20;
use std::f64::consts::PI;

/// Panels so far from a radius, over their width, are summed up at their own nodes, and nearer ones at more of them: with eight nodes a root at that distance
/// leaves 1e-14 (an ellipse of 7.9, to the power of −16), with twenty 1e-16 (of 2.7, to that of −40; of the highest powers of a panel 1e-14).
const FAR: f64 = 1.5;
const NOT_NEAR: f64 = 0.33;
/// Widest piece in the angle θ: eight nodes then keep a polynomial of degree 7 in s to 1e-12.
const WIDEST: f64 = 0.5;

/// The fields of a contact, sampled once from its line.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceFields {
    radius: f64,
    line_load: Vec<Panel>,
    /// Q′, panel by panel.
    slopes: Vec<Panel>,
    displacement: Vec<Panel>,
    /// Both at more nodes of each panel.
    more_slopes: Vec<Nodes>,
    more_displacement: Vec<Nodes>,
}

/// Nodes of more of a panel: how many there are.
const MORE: usize = 20;

/// Places of a panel and what the function weighs at each.
#[derive(Debug, Clone, PartialEq)]
struct Nodes {
    places: [f64; MORE],
    weighted: [f64; MORE],
}

impl Nodes {
    fn of(panel: &Panel) -> Self {
        let width = panel.upper - panel.lower;
        let rule = |k: usize| UNIT_RULE_20.get(k).copied().unwrap_or_default();
        let places = std::array::from_fn(|k| panel.lower + width * rule(k).0);
        Self { places, weighted: std::array::from_fn(|k| width * rule(k).1 * panel.at(panel.lower + width * rule(k).0)) }
    }

    /// ∫ of the function over √|s² − r²|.
    fn over_root(&self, r: f64) -> f64 {
        let mut parts = [0.0; MORE];
        for ((part, s), weighted) in parts.iter_mut().zip(&self.places).zip(&self.weighted) {
            *part = weighted / ((s - r) * (s + r)).abs().sqrt();
        }
        parts.iter().sum()
    }
}

/// ∫ of a function over √|s² − r²| along a panel that is far enough from r; none where it is near.
fn from_afar(panel: &Panel, more: &Nodes, r: f64) -> Option<f64> {
    let width = panel.upper - panel.lower;
    let distance = (panel.lower - r).max(r - panel.upper);
    if distance >= FAR * width {
        let mut parts = [0.0; POINTS];
        for (part, ((x, weight), value)) in parts.iter_mut().zip(RULE.nodes.iter().zip(&RULE.weights).zip(&panel.values)) {
            let s = panel.lower + width * x;
            *part = weight * value / ((s - r) * (s + r)).abs().sqrt();
        }
        return Some(width * parts.iter().sum::<f64>());
    }
    (distance >= NOT_NEAR * width).then(|| more.over_root(r))
}

impl SurfaceFields {
    /// The fields of a contact at its instant.
    #[must_use]
    pub fn of(contact: &Contact<'_>) -> Self {
        let line_load = contact.line_load();
        let (profile, penetration) = (contact.profile(), contact.penetration());
        let mut displacement: Vec<Panel> =
            line_load.iter().map(|panel| Panel::sampled(panel.lower, panel.upper, |s| penetration - profile.line(s))).collect();
        displacement.extend(contact.free_displacement(0.0));
        Self::made_of(contact.radius(), line_load, displacement)
    }

    /// The fields of a line given by its load in contact and its displacement, panel by panel from the axis outwards, at rest beyond the last one.
    pub(super) fn made_of(radius: f64, line_load: Vec<Panel>, mut displacement: Vec<Panel>) -> Self {
        if displacement.is_empty() {
            displacement.push(Panel::sampled(0.0, f64::MIN_POSITIVE, |_| 0.0));
        }
        let slopes: Vec<Panel> = line_load.iter().map(Panel::slope).collect();
        let (more_slopes, more_displacement) = (slopes.iter().map(Nodes::of).collect(), displacement.iter().map(Nodes::of).collect());
        Self { radius, line_load, slopes, displacement, more_slopes, more_displacement }
    }

    /// a (m).
    #[must_use]
    pub const fn radius(&self) -> f64 {
        self.radius
    }

    /// p (Pa) at a radius r ≥ 0 (m); 0 outside the contact.
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a negative radius, and at the edge, where the pressure is infinite.
    pub fn pressure(&self, radius: f64) -> Result<f64, Refusal> {
        let r = require_non_negative("radius", radius)?;
        if r >= self.radius {
            return if r > self.radius || self.radius == 0.0 {
                // Without contact there is no edge either.
                Ok(0.0)
            } else {
                Err(Refusal::out_of_range("radius", r, "other than the contact radius, where the pressure is infinite"))
            };
        }
        let root = |s: f64| ((s - r) * (s + r)).sqrt();
        let mut total = value_at(&self.line_load, self.radius) / root(self.radius);
        for (index, ((panel, slope), more)) in self.line_load.iter().zip(&self.slopes).zip(&self.more_slopes).enumerate() {
            if panel.upper <= r {
                continue;
            }
            if let Some(next) = self.line_load.get(index + 1) {
                total -= (next.at(next.lower) - panel.at(panel.upper)) / root(panel.upper);
            }
            if let Some(afar) = from_afar(slope, more, r) {
                total -= afar;
                continue;
            }
            if r == 0.0 {
                // On the axis Q′ds/s, regular for a smooth indenter.
                let mean = |x: &f64| panel.lower + (panel.upper - panel.lower) * x;
                let points = RULE.nodes.iter().zip(RULE.weights);
                total -= (panel.upper - panel.lower) * points.map(|(x, weight)| weight * slope.at(mean(x)) / mean(x)).sum::<f64>();
                continue;
            }
            // With s = r cosh θ: ds/√(s² − r²) = dθ.
            let (low, high) = ((panel.lower.max(r) / r).acosh(), (panel.upper / r).acosh());
            let pieces = ((high - low) / WIDEST).ceil().max(1.0);
            let width = (high - low) / pieces;
            for piece in 0..pieces as u32 {
                for (x, weight) in RULE.nodes.iter().zip(RULE.weights) {
                    total -= weight * width * slope.at(r * (low + width * (f64::from(piece) + x)).cosh());
                }
            }
        }
        require_finite("pressure", total / PI)
    }

    /// w (m) into the body at a radius r ≥ 0 (m).
    ///
    /// # Errors
    /// [`Refusal::OutOfRange`] for a negative radius.
    pub fn displacement(&self, radius: f64) -> Result<f64, Refusal> {
        let r = require_non_negative("radius", radius)?;
        if r == 0.0 {
            return Ok(value_at(&self.displacement, 0.0));
        }
        let mut total = 0.0;
        for (panel, more) in self.displacement.iter().zip(&self.more_displacement).take_while(|(panel, _)| panel.lower < r) {
            if let Some(afar) = from_afar(panel, more, r) {
                total += afar;
                continue;
            }
            // With s = r sin θ: ds/√(r² − s²) = dθ.
            let (low, high) = ((panel.lower / r).asin(), (panel.upper.min(r) / r).asin());
            let pieces = ((high - low) / WIDEST).ceil().max(1.0);
            let width = (high - low) / pieces;
            for piece in 0..pieces as u32 {
                for (x, weight) in RULE.nodes.iter().zip(RULE.weights) {
                    total += weight * width * panel.at(r * (low + width * (f64::from(piece) + x)).sin());
                }
            }
        }
        require_finite("displacement", 2.0 / PI * total)
    }
}
