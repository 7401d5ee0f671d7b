//! The [crack], [adhesion] and [fields] tables of a steady crack.

use super::section::Section;
use super::{DEFAULT_FACTOR, DEFAULT_FIELD_POINTS, without_cohesive_stress, works};
use crate::scene::check::Units;
use crate::scene::diagnostic::SceneError;
use crate::scene::typed::{CohesiveLaw, CrackControl, Fields, ProcessZoneLaw, SceneMaterial, SteadyCrack, Strip, StripLoad, Theory};
use viscotack::crack::{CrackBody, Motion};
use viscotack::elastic::PlaneState;
use viscotack::elastic::pure_shear_strip::SidewaysStrain;

pub(super) fn read(top: &Section<'_>, material: &SceneMaterial) -> Result<SteadyCrack, SceneError> {
    let crack = top.required_table("crack", "it is the problem")?;
    let motion = match crack.text("motion") {
        Some("closing") => Motion::Closing,
        _ => Motion::Opening,
    };
    crack.without(&["points", "spacing", "first_time"], "a crack under a [[history]]")?;
    let body = body(&crack)?;
    let plane = plane(&crack, top, material)?;
    let (work_of_adhesion, process_zone) = adhesion(top, Some((&crack, motion)), body)?;
    let theories = theories(top, &crack, motion, process_zone)?;
    let control = control((top, &crack), plane, material, work_of_adhesion)?;
    Ok(SteadyCrack { motion, body, plane, work_of_adhesion, process_zone, theories, control, fields: fields(top)? })
}

pub(super) fn body(crack: &Section<'_>) -> Result<CrackBody, SceneError> {
    Ok(match crack.text("body") {
        Some("two_halves") => CrackBody::TwoHalves,
        Some(_) => CrackBody::AgainstRigid,
        // The groups of a reduced scene are the same for both.
        None if crack.units() == Units::Reduced => CrackBody::AgainstRigid,
        None => return Err(crack.missing("body")),
    })
}

pub(super) fn plane(crack: &Section<'_>, top: &Section<'_>, material: &SceneMaterial) -> Result<PlaneState, SceneError> {
    if crack.units() == Units::Reduced {
        return match crack.text("plane") {
            Some("strain") => {
                let message = "the moduli of a reduced scene are plane moduli already: `crack.plane` = \"strain\" would count ν twice";
                Err(crack.wrong("plane", message, "leave it out"))
            }
            _ => Ok(PlaneState::Stress),
        };
    }
    match crack.required_text("plane")? {
        "strain" if !material.has_plane_strain_modulus() => Err(top
            .required_table("material", "")?
            .missing("poisson_ratio")
            .help("plane strain needs material.poisson_ratio, of rubber poisson_ratio = 0.49 in [material]")),
        "strain" => Ok(PlaneState::Strain),
        _ => Ok(PlaneState::Stress),
    }
}

pub(super) fn adhesion(
    top: &Section<'_>,
    steady: Option<(&Section<'_>, Motion)>,
    body: CrackBody,
) -> Result<(f64, ProcessZoneLaw), SceneError> {
    let table = top.required_table("adhesion", "a crack moves by the balance of work at its tip")?;
    table.without(&["interaction_range"], "an indentation")?;
    let reduced = table.units() == Units::Reduced;
    table.without(&["trailing_work_of_adhesion", "leading_work_of_adhesion"], "a sliding contact")?;
    let by_speed = match table.node().get("by_speed") {
        Some(_) => match steady {
            Some((crack, motion)) => Some(work_at_speed(top, &table, crack, motion)?),
            None => {
                let message = "`adhesion.by_speed`: under a [[history]] the tip finds its speed, and the work would follow it";
                return Err(table.wrong("by_speed", message, "leave it out, or give `crack.speed`"));
            }
        },
        None => None,
    };
    let work = match (by_speed.map_or_else(|| table.number("work_of_adhesion"), |work| Ok(Some(work)))?, reduced) {
        (Some(work), true) if (work - 1.0).abs() > 1e-12 => {
            return Err(table.wrong(
                "work_of_adhesion",
                "`adhesion.work_of_adhesion`: in reduced units the work of adhesion is the unit",
                "must be 1 (or left out)",
            ));
        }
        (Some(work), _) => work,
        (None, true) => 1.0,
        (None, false) => return Err(table.missing("work_of_adhesion")),
    };
    let zone = match table.table("process_zone") {
        Some(zone) => zone,
        // a₀ = 1 is the unit of a reduced scene: the growing zone with the default factor needs nothing more.
        None if reduced => return Ok((work, reduced_zone(body, DEFAULT_FACTOR, CohesiveLaw::Growing))),
        None => return Err(table.missing("process_zone")),
    };
    zone.without(&["trailing_length", "leading_length"], "a sliding contact")?;
    let factor = zone.number("factor")?.unwrap_or(DEFAULT_FACTOR);
    let law = match zone.text("law") {
        Some("constant") => CohesiveLaw::Constant,
        Some("schapery") => CohesiveLaw::Schapery,
        Some(law @ ("dugdale" | "exponential")) => {
            let message = format!("`{}` = {law:?} is a law of sliding contacts", zone.full("law"));
            return Err(zone.wrong("law", message, "must be \"growing\", \"constant\" or \"schapery\""));
        }
        _ => CohesiveLaw::Growing,
    };
    let given = if reduced {
        if zone.node().get("cohesive_stress").is_some() {
            let message = "`adhesion.process_zone.cohesive_stress`: in reduced units the cohesive stress is fixed by the unit of length a₀";
            return Err(zone.wrong("cohesive_stress", message, "leave it out"));
        }
        zone.number("length")?.map(ProcessZoneLaw::Length).unwrap_or_else(|| reduced_zone(body, factor, law))
    } else {
        match zone.exactly_one(&["length", "cohesive_stress"])? {
            "length" => ProcessZoneLaw::Length(zone.required_number("length")?),
            _ => ProcessZoneLaw::Cohesive { cohesive_stress: zone.required_number("cohesive_stress")?, factor, law },
        }
    };
    if let ProcessZoneLaw::Length(_) = given {
        without_cohesive_stress(&zone)?;
    }
    Ok((work, given))
}

/// Δγ at the speed of a crack: of the two works of a table, the trailing one where it opens.
fn work_at_speed(top: &Section<'_>, table: &Section<'_>, crack: &Section<'_>, motion: Motion) -> Result<f64, SceneError> {
    if table.units() == Units::Reduced {
        let message = "`adhesion.by_speed`: in reduced units the work of adhesion of a crack is the unit";
        return Err(table.wrong("by_speed", message, "write the scene in SI units"));
    }
    let Some(speed) = crack.number("speed")? else {
        let message = "`adhesion.by_speed`: the speed of this crack is found, not given, and the work of adhesion would change with it";
        return Err(table.wrong("by_speed", message, "needs crack.speed").help("sweep crack.speed and read the load off the table"));
    };
    let works = works::read(top)?.ok_or_else(|| table.missing("work_of_adhesion"))?;
    let [trailing, leading] = works.at(speed)?;
    Ok(if motion == Motion::Closing { leading } else { trailing })
}

/// The cohesive stress for which a₀ = E0Δγ/(πσ_c²·halves) is one.
fn reduced_zone(body: CrackBody, factor: f64, law: CohesiveLaw) -> ProcessZoneLaw {
    let cohesive_stress = (std::f64::consts::PI * body.deformable_halves()).sqrt().recip();
    ProcessZoneLaw::Cohesive { cohesive_stress, factor, law }
}

fn theories(top: &Section<'_>, crack: &Section<'_>, motion: Motion, zone: ProcessZoneLaw) -> Result<Vec<Theory>, SceneError> {
    let mut theories = Vec::new();
    for word in crack.texts("theories") {
        let theory = match word {
            "persson_brener" => Theory::PerssonBrener,
            "cohesive_zone" => Theory::CohesiveZone,
            _ => Theory::VirtualWork,
        };
        if theory == Theory::CohesiveZone && matches!(zone, ProcessZoneLaw::Length(_)) {
            let message =
                "`crack.theories` names the cohesive-zone theory, which needs a cohesive stress, but the process zone is given as a length";
            return Err(crack.wrong("theories", message, "give adhesion.process_zone.cohesive_stress"));
        }
        theories.push(theory);
    }
    if theories.is_empty() {
        theories.push(Theory::VirtualWork);
    }
    if let ProcessZoneLaw::Cohesive { law: CohesiveLaw::Schapery, .. } = zone
        && (motion == Motion::Opening || theories.contains(&Theory::PerssonBrener))
    {
        let message = "`adhesion.process_zone.law` = \"schapery\" is the length of a closing cohesive zone";
        let zone = top.table("adhesion").and_then(|table| table.table("process_zone"));
        let place = zone.map_or_else(|| crack.key_place("theories"), |zone| zone.key_place("law"));
        let label = "needs crack.motion = \"closing\", and no \"persson_brener\" in crack.theories";
        return Err(SceneError::at(&place, message, label));
    }
    Ok(theories)
}

fn control(
    (top, crack): (&Section<'_>, &Section<'_>),
    plane: PlaneState,
    material: &SceneMaterial,
    work: f64,
) -> Result<CrackControl, SceneError> {
    Ok(match crack.exactly_one(&["speed", "energy_release_rate", "stress_intensity", "strip"])? {
        "speed" => CrackControl::Speed(crack.required_number("speed")?),
        "energy_release_rate" => CrackControl::EnergyReleaseRate(crack.required_number("energy_release_rate")?),
        "stress_intensity" => {
            let given = crack.required_number("stress_intensity")?;
            // Its reduced unit is √(2E0Δγ) with E0 = 1.
            let unit = if crack.units() == Units::Reduced { (2.0 * work).sqrt() } else { 1.0 };
            CrackControl::StressIntensity(given * unit)
        }
        _ => CrackControl::Strip(strip(&crack.required_table("strip", "it is the load")?, (top, crack), plane, material)?),
    })
}

fn strip(
    table: &Section<'_>,
    tables: (&Section<'_>, &Section<'_>),
    plane: PlaneState,
    material: &SceneMaterial,
) -> Result<Strip, SceneError> {
    let lateral = lateral(table, tables, plane, material)?;
    let load = match table.exactly_one(&["strain", "stress"])? {
        "strain" => StripLoad::Strain(table.required_number("strain")?),
        _ => StripLoad::Stress(table.required_number("stress")?),
    };
    Ok(Strip { half_height: table.required_number("half_height")?, load, lateral })
}

/// Whether a strip contracts along its length; refuses a strip that cannot be loaded.
pub(super) fn lateral(
    table: &Section<'_>,
    (top, crack): (&Section<'_>, &Section<'_>),
    plane: PlaneState,
    material: &SceneMaterial,
) -> Result<SidewaysStrain, SceneError> {
    if table.units() == Units::Reduced {
        return Err(crack.wrong("strip", "`crack.strip` needs lengths and stresses in SI units", "write units = \"si\""));
    }
    let lateral = match table.text("lateral") {
        Some("uniaxial") => SidewaysStrain::Free,
        _ => SidewaysStrain::Held,
    };
    let follows = material.isotropic.is_some();
    if follows && (lateral == SidewaysStrain::Held || plane == PlaneState::Strain) {
        let message = "the stress intensity of this strip depends on Poisson's ratio, which changes with time where the bulk modulus is given: no exact treatment";
        return Err(crack
            .wrong("strip", message, "needs a constant Poisson ratio")
            .help("write lateral = \"uniaxial\" in crack.strip and plane = \"stress\", or give material.poisson_ratio in place of material.bulk_modulus"));
    }
    if lateral == SidewaysStrain::Held && material.poisson_ratio.is_none() {
        return Err(top.required_table("material", "")?.missing("poisson_ratio").help(
            "a strip clamped along its length needs it, of rubber poisson_ratio = 0.49 in [material]; a strip that contracts freely along its length is another problem: lateral = \"uniaxial\" in crack.strip",
        ));
    }
    if lateral == SidewaysStrain::Held && plane == PlaneState::Strain && material.poisson_ratio == Some(0.5) {
        let message = "an incompressible strip, clamped and in plane strain, cannot be stretched at all";
        return Err(crack.wrong("strip", message, "use plane = \"stress\", or a Poisson ratio below 0.5"));
    }
    Ok(lateral)
}

fn fields(top: &Section<'_>) -> Result<Option<Fields>, SceneError> {
    let Some(table) = top.table("fields") else { return Ok(None) };
    let (from, to) = (table.required_number("from")?, table.required_number("to")?);
    if from >= to {
        return Err(table.wrong("to", format!("`fields.to` ({to:e}) is not above `fields.from` ({from:e})"), "must be the larger one"));
    }
    let points = table.number("points")?.unwrap_or(DEFAULT_FIELD_POINTS) as u32;
    Ok(Some(Fields { from, to, points }))
}
