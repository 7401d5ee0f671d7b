//! Sliding contacts of which both edges are known.
//!
//! With adhesion: half-width, load and speed are drawn, the eccentricity follows from equal works at both edges, and the works are what both edges take.
//! Without: eccentricity and load follow from two edges that are not singular.

use super::super::draw::Draw;
use super::partial_fractions::{FractionContact, Load, Spectrum};
use std::f64::consts::PI;
use viscotack::material::PlaneMaterial;
use viscotack::refusal::Refusal;
use viscotack::sliding::SlidingMemory;
use viscotack::sliding::contact::Indenter;
use viscotack::sliding::edge_balance::{SlidingControl, WaveAdhesion};
use viscotack::sliding::steady::SlidingProblem;

/// The reduction loses digits in proportion to Πζ_j: so much at most.
const MOST_MAGNIFIED: f64 = 1e3;
/// Relative error of the drawn state: quadrature, and the rounding of Πζ_j.
pub const KNOWN_TO: f64 = 1e-8;

/// A contact that is known.
#[derive(Debug, Clone)]
pub struct KnownContact {
    /// The solid.
    pub material: PlaneMaterial,
    /// kv (1/s).
    pub rate: f64,
    /// Works and zones of both edges.
    pub adhesion: Option<WaveAdhesion>,
    /// a in 1/k.
    pub half_width: f64,
    /// e in 1/k.
    pub eccentricity: f64,
    /// p̄ in E0*kΛ/2.
    pub mean_pressure: f64,
    /// Δ in Λ.
    pub penetration: f64,
    /// In E0*k²Λ²/2.
    pub friction_stress: f64,
    /// Which of load, penetration and half-width to ask it by.
    pub control: SlidingControl,
}

impl KnownContact {
    /// The problem whose answer it is.
    #[must_use]
    pub const fn problem(&self, accuracy: f64) -> SlidingProblem<'static> {
        SlidingProblem {
            rate: self.rate,
            indenter: Indenter::Wave,
            adhesion: self.adhesion,
            work_by_speed: None,
            control: self.control,
            accuracy,
        }
    }

    /// What a solver must return: name and value.
    #[must_use]
    pub const fn values(&self) -> [(&'static str, f64); 5] {
        [
            ("half-width", self.half_width),
            ("eccentricity", self.eccentricity),
            ("mean pressure", self.mean_pressure),
            ("penetration", self.penetration),
            ("friction stress", self.friction_stress),
        ]
    }

    /// In words and numbers that draw it again.
    #[must_use]
    pub fn described(&self) -> String {
        format!(
            "β {:.4}, {} terms, ζ {:.3e}, a {:.5}, e {:.5}, p̄ {:.5}, {:?}, {:?}",
            self.material.stiffening_ratio(),
            self.material.creep_terms().len(),
            self.rate * self.material.longest_retardation_time().unwrap_or(0.0),
            self.half_width,
            self.eccentricity,
            self.mean_pressure,
            self.adhesion,
            self.control
        )
    }

    /// The largest relative defect of both works at another place, by the same other route: whether that is a contact as well.
    #[must_use]
    pub fn defect_at(&self, half_width: f64, eccentricity: f64, mean_pressure: f64) -> Option<f64> {
        let adhesion = self.adhesion?;
        let spectrum = spectrum(&self.material, self.rate).ok()??;
        let contact = FractionContact::new(&spectrum, half_width, eccentricity, Load::MeanPressure(mean_pressure))?;
        let works = contact.works(eccentricity, [adhesion.trailing_zone, adhesion.leading_zone])?;
        let targets = [2.0 * PI * adhesion.trailing_work, 2.0 * PI * adhesion.leading_work];
        Some(works.iter().zip(&targets).map(|(work, target)| (work / target - 1.0).abs()).fold(0.0, f64::max))
    }
}

fn spectrum(material: &PlaneMaterial, rate: f64) -> Result<Option<Spectrum>, Refusal> {
    let kernel = SlidingMemory::of_material(material, rate, 1.0)?;
    let relaxations = material.relaxation_terms().iter().map(|term| rate * term.relaxation_time).collect();
    Ok(Spectrum::new(&kernel, relaxations))
}

/// The root of a function by secants from a start; none if it does not come within `enough` of zero.
fn secant(start: f64, step: f64, enough: f64, longest: f64, mut f: impl FnMut(f64) -> Option<f64>) -> Option<f64> {
    let (mut before, mut here) = (start, start + step);
    let (mut at_before, mut at_here) = (f(before)?, f(here)?);
    for _ in 0..24 {
        if at_here.abs() <= enough {
            return Some(here);
        }
        let slope = (at_here - at_before) / (here - before);
        if !(slope.is_finite() && slope != 0.0) {
            return None;
        }
        let next = here - (at_here / slope).clamp(-longest, longest);
        (before, at_before) = (here, at_here);
        here = next;
        at_here = f(here)?;
    }
    None
}

/// Draws until a contact comes out that can exist (pulled edges, open gap): the first of at most forty.
///
/// # Errors
/// Those of making a material; [`Refusal::NotConverged`] if none of the forty draws is one.
pub fn known_contact(draw: &mut Draw) -> Result<KnownContact, Refusal> {
    for _ in 0..40 {
        if let Some(contact) = drawn(draw)? {
            return Ok(contact);
        }
    }
    Err(Refusal::NotConverged { what: "a known sliding contact", detail: "no draw in forty is one".into() })
}

fn drawn(draw: &mut Draw) -> Result<Option<KnownContact>, Refusal> {
    // Loads have contacts on several branches where the solid stiffens much: such contacts are asked for by their half-width.
    let by_width = draw.chance(0.6);
    let terms = 1 + draw.below(3);
    let beta = draw.log_between(1.2, if by_width { 100.0 } else { 3.0 });
    let (longest, decades) = (draw.log_between(1e-4, 1e3), draw.between(0.5, 2.5));
    let relaxed = draw.log_between(1e3, 1e9);
    let material = draw.solid(relaxed, beta, longest, terms, decades)?;
    let Some(slowest) = material.longest_retardation_time() else { return Ok(None) };
    let rate = draw.log_between(1e-2, 1e3) / slowest;
    let half_width = draw.between(0.2, 2.5);
    let narrow = half_width.min(PI - half_width);
    let adhesive = draw.chance(0.75);
    let zones = [draw.log_between(3e-3, 0.08) * narrow, draw.log_between(3e-3, 0.08) * narrow];
    let zones = if draw.chance(0.5) { [zones[0], zones[0]] } else { zones };
    let (work, choice) = (draw.log_between(1e-4, 0.01), draw.below(2));
    let Some(spectrum) = spectrum(&material, rate)? else { return Ok(None) };
    if spectrum.magnification() > MOST_MAGNIFIED {
        return Ok(None);
    }
    let stiffness = spectrum.stiffness(1.0 / half_width);
    let s = (0.5 * half_width).sin();
    let of = |contact: &FractionContact<'_>, eccentricity: f64, adhesion: Option<WaveAdhesion>| KnownContact {
        material: material.clone(),
        rate,
        adhesion,
        half_width,
        eccentricity,
        mean_pressure: contact.mean_pressure,
        penetration: contact.penetration,
        friction_stress: contact.friction_stress,
        control: match (by_width, choice) {
            (true, _) => SlidingControl::HalfWidth(half_width),
            (false, 0) => SlidingControl::MeanPressure(contact.mean_pressure),
            _ => SlidingControl::Penetration(contact.penetration),
        },
    };
    if !adhesive {
        return Ok(without_adhesion(&spectrum, half_width, stiffness).map(|(contact, eccentricity)| of(&contact, eccentricity, None)));
    }
    let pull = 2.0 * (stiffness * work * (0.5 * half_width).tan()).sqrt();
    // Under a load or a penetration only what is stable with room to spare: between 1.4 of the width at pull-off and three quarters of the way to snap-in.
    let strength = (work / stiffness).sqrt();
    if !by_width && (strength > 0.12 || half_width > 1.6 || half_width < 1.4 * (2.0 * work / stiffness).cbrt()) {
        return Ok(None);
    }
    let pressure = stiffness * s * s - pull;
    let works_at = |eccentricity: f64| {
        let contact = FractionContact::new(&spectrum, half_width, eccentricity, Load::MeanPressure(pressure))?;
        let works = contact.works(eccentricity, zones)?;
        (works[0] > 0.0 && works[1] > 0.0).then_some((contact, works))
    };
    let uneven = |eccentricity: f64| works_at(eccentricity).map(|(_, works)| 0.5 * (works[0] / works[1]).ln());
    let reach = 0.3 * narrow.min(1.0);
    let Some(eccentricity) = secant(0.0, -0.02 * reach, 1e-11, reach, uneven) else { return Ok(None) };
    let Some((contact, works)) = works_at(eccentricity).filter(|(contact, _)| contact.is_open()) else { return Ok(None) };
    let reduced = (works[0] * works[1]).sqrt() / (2.0 * PI);
    let adhesion = WaveAdhesion { trailing_zone: zones[0], leading_zone: zones[1], ..WaveAdhesion::even(reduced, zones[0]) };
    // A drawn pull that came out far stronger than meant belongs to another regime than the one above.
    Ok((by_width || reduced < 4.0 * work).then(|| of(&contact, eccentricity, Some(adhesion))))
}

/// The contact of a half-width without a singular edge.
fn without_adhesion(spectrum: &Spectrum, half_width: f64, stiffness: f64) -> Option<(FractionContact<'_>, f64)> {
    let scale = stiffness * (0.5 * half_width).sin().powi(2);
    // k of both edges is linear in the load: their sum vanishes at one load, their difference tells the eccentricity.
    let regular = |eccentricity: f64| {
        let at = |pressure: f64| FractionContact::new(spectrum, half_width, eccentricity, Load::MeanPressure(pressure));
        let sum = |contact: &FractionContact<'_>| contact.edge_amplitudes().0 + contact.edge_amplitudes().1;
        let (first, second) = (sum(&at(0.0)?), sum(&at(scale)?));
        let contact = at(-first * scale / (second - first))?;
        let difference = (contact.edge_amplitudes().1 - contact.edge_amplitudes().0) / scale;
        Some((contact, difference))
    };
    let reach = 0.3 * half_width.min(1.0);
    let eccentricity = secant(0.0, -0.02 * reach, 1e-13, reach, |eccentricity| regular(eccentricity).map(|(_, difference)| difference))?;
    let (contact, _) = regular(eccentricity)?;
    (contact.mean_pressure > 0.0 && contact.is_open()).then_some((contact, eccentricity))
}
