//! The [sliding], [adhesion] and [fields] tables of a sliding contact.

use super::counter_body;
use super::section::Section;
use super::{DEFAULT_FACTOR, DEFAULT_FIELD_POINTS, sliding_branch, without_cohesive_stress, works};
use crate::scene::check::Units;
use crate::scene::diagnostic::SceneError;
use crate::scene::typed::{
    SceneMaterial, Sliding, SlidingAdhesion, SlidingColumns, SlidingContact, SlidingIndenter, SlidingLoad, SlidingTask, SlidingZone,
};
use std::f64::consts::{PI, TAU};
use viscotack::sliding::steady::ReachedBy;

/// α = 2∫ tension · gap dx/(Δγ a₀) over the fast zone of a constant tension, and of an exponential one (four digits, measured by
/// `finite_range`; `docs/src/guides/surfaces.md`).
const ALPHA_OF_DUGDALE: f64 = PI * PI / 6.0;
const ALPHA_OF_EXPONENTIAL: f64 = 6.497;

pub(super) fn read(top: &Section<'_>, material: &SceneMaterial) -> Result<Sliding, SceneError> {
    let sliding = top.required_table("sliding", "it is the problem")?;
    if sliding.units() == Units::Si && !material.has_plane_strain_modulus() {
        let help = "the half-plane is in plane strain, E* = E/(1 − ν²): a sliding contact needs material.poisson_ratio, of rubber poisson_ratio = 0.49 in [material]";
        return Err(top.required_table("material", "")?.missing("poisson_ratio").help(help));
    }
    let indenter = indenter(&sliding)?;
    let counter_body = counter_body::elastic(&sliding)?;
    let works = works::read(top)?;
    let task = sliding_branch::task(&sliding, works.is_some())?;
    let control = if sliding_branch::meets_every_load(&task) {
        sliding_branch::without_load(&sliding)?;
        SlidingLoad::Every
    } else {
        control(&sliding, indenter)?
    };
    let speed = match sliding_branch::speeds(&task) {
        Some([slowest, _]) => {
            let message = "`sliding.speed` is given, and runs along the branch";
            match sliding.node().get("speed") {
                Some(_) => return Err(sliding.wrong("speed", message, "leave it out").help("or name another sliding.branch.parameter")),
                None => slowest,
            }
        }
        None => sliding.required_number("speed")?,
    };
    let adhesion = match &works {
        Some(works) => Some(SlidingAdhesion { works: works.at(speed)?, process_zone: process_zone(top)? }),
        None => None,
    };
    if let (Some(adhesion), Some(works)) = (adhesion, &works) {
        sliding_branch::fits(&sliding, &task, indenter, adhesion, works)?;
    }
    let works_per_edge = works.as_ref().is_some_and(|works| works.per_edge);
    let work_by_speed = works.and_then(|works| works.law);
    let columns = columns(&sliding, &task, indenter, adhesion.is_some())?;
    let contacts = contacts(&sliding, adhesion.is_some())?;
    if task != SlidingTask::State {
        sliding_branch::of_states(top, &sliding)?;
    }
    let field_points = match top.table("fields") {
        None => None,
        Some(fields) => {
            fields.without(&["from", "to"], "a crack")?;
            Some(fields.number("points")?.unwrap_or(DEFAULT_FIELD_POINTS) as u32)
        }
    };
    let reached_by = reached_by(&sliding, &task, control)?;
    let frame_stiffness = frame_stiffness(&sliding, &task, indenter)?;
    Ok(Sliding {
        indenter,
        counter_body,
        speed,
        control,
        task,
        contacts,
        adhesion,
        works_per_edge,
        work_by_speed,
        columns,
        field_points,
        reached_by,
        frame_stiffness,
    })
}

/// How what is held was reached.
fn reached_by(sliding: &Section<'_>, task: &SlidingTask, control: SlidingLoad) -> Result<ReachedBy, SceneError> {
    let Some(word) = sliding.text("reached_by") else { return Ok(ReachedBy::Loading) };
    if *task != SlidingTask::State {
        let message = "`sliding.reached_by` picks one of several contacts, but a branch or a strength goes through all of them";
        return Err(sliding.wrong("reached_by", message, "leave it out"));
    }
    if let SlidingLoad::HalfWidth(_) = control {
        let message = "`sliding.reached_by` tells how a load or penetration was reached, but the half-width is given";
        return Err(sliding.wrong("reached_by", message, "leave it out"));
    }
    if matches!(word, "long_range" | "every") {
        let message = format!("`sliding.reached_by` = \"{word}\" belongs to a law of attraction, but this scene has edges");
        return Err(sliding.wrong("reached_by", message, "must be \"loading\" or \"unloading\""));
    }
    Ok(if word == "unloading" { ReachedBy::Unloading } else { ReachedBy::Loading })
}

/// The frame of a single contact.
fn frame_stiffness(sliding: &Section<'_>, task: &SlidingTask, indenter: SlidingIndenter) -> Result<Option<f64>, SceneError> {
    let Some(stiffness) = sliding.number("frame_stiffness")? else { return Ok(None) };
    if let SlidingIndenter::Cylinder { .. } = indenter {
        let message = "`sliding.frame_stiffness`: a cylinder has no penetration, which a frame would hold";
        return Err(sliding.wrong("frame_stiffness", message, "leave it out"));
    }
    match task {
        SlidingTask::State => Ok(Some(stiffness)),
        SlidingTask::Branch(_) => {
            let message = "`sliding.frame_stiffness` is of a single contact";
            Err(sliding.wrong("frame_stiffness", message, "write `sliding.branch.frame_stiffness` instead"))
        }
        SlidingTask::Strength => {
            let message = "`sliding.frame_stiffness` is of a single contact, not of a strength";
            Err(sliding.wrong("frame_stiffness", message, "leave it out"))
        }
    }
}

fn indenter(sliding: &Section<'_>) -> Result<SlidingIndenter, SceneError> {
    let name = sliding.exactly_one(&["wave", "cylinder"])?;
    let table = sliding.required_table(name, "it is the body that slides")?;
    let size = |key: &'static str, unit: f64| match (table.units(), table.number(key)?) {
        (Units::Si, _) => table.required_number(key),
        (Units::Reduced, None) => Ok(unit),
        (Units::Reduced, Some(_)) => {
            let message = format!("`{}`: in reduced units the size of the sliding body is the unit", table.full(key));
            Err(table.wrong(key, message, "leave it out, as in wave = {}"))
        }
    };
    Ok(match name {
        "wave" => SlidingIndenter::Wave { wavelength: size("wavelength", TAU)?, amplitude: size("amplitude", 1.0)? },
        _ => SlidingIndenter::Cylinder { radius: size("radius", 1.0)? },
    })
}

fn control(sliding: &Section<'_>, indenter: SlidingIndenter) -> Result<SlidingLoad, SceneError> {
    let (given, other, why) = match indenter {
        SlidingIndenter::Wave { .. } => {
            (&["mean_pressure", "penetration", "half_width"][..], &["load_per_width"][..], "a wave carries a mean pressure")
        }
        SlidingIndenter::Cylinder { .. } => (
            &["load_per_width", "half_width"][..],
            &["mean_pressure", "penetration"][..],
            "a single cylinder carries a load per width, and sinks into a half-plane without bound",
        ),
    };
    if let Some(key) = other.iter().find(|key| sliding.node().get(key).is_some()) {
        let message = format!("`{}` does not belong to this body: {why}", sliding.full(key));
        let instead = given.iter().map(|key| format!("`{}`", sliding.full(key))).collect::<Vec<_>>().join(", ");
        return Err(SceneError::at(&sliding.key_place(key), message, format!("give one of {instead}")));
    }
    let key = sliding.exactly_one(given)?;
    let value = sliding.required_number(key)?;
    let whole = match indenter {
        SlidingIndenter::Wave { wavelength, .. } if key == "half_width" && value >= 0.5 * wavelength => Some(0.5 * wavelength),
        _ => None,
    };
    if let Some(half_wavelength) = whole {
        let message = format!("`sliding.half_width` ({value:e}) is not below half the wavelength ({half_wavelength:e})");
        return Err(sliding.wrong("half_width", message, "a full contact has no edges"));
    }
    Ok(match key {
        "mean_pressure" => SlidingLoad::MeanPressure(value),
        "load_per_width" => SlidingLoad::LoadPerWidth(value),
        "penetration" => SlidingLoad::Penetration(value),
        _ => SlidingLoad::HalfWidth(value),
    })
}

fn process_zone(top: &Section<'_>) -> Result<SlidingZone, SceneError> {
    let table = top.required_table("adhesion", "it holds the process zone")?;
    table.without(&["interaction_range"], "an indentation")?;
    let zone = table.table("process_zone").ok_or_else(|| table.missing("process_zone"))?;
    let per_edge = ["trailing_length", "leading_length"].into_iter().find(|key| zone.node().get(key).is_some());
    let way = match per_edge {
        Some(key) => {
            zone.exactly_one(&["length", "cohesive_stress", "peak_stress", key])?;
            key
        }
        None => zone.exactly_one(&["length", "cohesive_stress", "peak_stress"])?,
    };
    let process_zone = match way {
        "peak_stress" => grown_zone(&zone)?,
        "cohesive_stress" => {
            if let Some(law) = zone.text("law")
                && law != "constant"
            {
                let message =
                    format!("`{}` = {law:?} is a law of cracks: the process zone of a sliding contact is constant", zone.full("law"));
                return Err(zone.wrong("law", message, "must be \"constant\", or left out"));
            }
            SlidingZone::Cohesive {
                cohesive_stress: zone.required_number("cohesive_stress")?,
                factor: zone.number("factor")?.unwrap_or(DEFAULT_FACTOR),
                grows: false,
            }
        }
        way => {
            without_cohesive_stress(&zone)?;
            let (trailing, leading) = if way == "length" { ("length", "length") } else { ("trailing_length", "leading_length") };
            SlidingZone::Lengths { trailing: zone.required_number(trailing)?, leading: zone.required_number(leading)? }
        }
    };
    Ok(process_zone)
}

/// A zone that grows with its edge: α follows from the law.
fn grown_zone(zone: &Section<'_>) -> Result<SlidingZone, SceneError> {
    if zone.node().get("factor").is_some() {
        let message = format!("`{}` follows from the law where `{}` is given", zone.full("factor"), zone.full("peak_stress"));
        return Err(zone.wrong("factor", message, "leave it out"));
    }
    let factor = match zone.required_text("law")? {
        "dugdale" => ALPHA_OF_DUGDALE,
        "exponential" => ALPHA_OF_EXPONENTIAL,
        law => {
            let message = format!("`{}` = {law:?} has no largest tension: the zone grows by the law of its tension", zone.full("law"));
            return Err(zone.wrong("law", message, "must be \"dugdale\" or \"exponential\""));
        }
    };
    Ok(SlidingZone::Cohesive { cohesive_stress: zone.required_number("peak_stress")?, factor, grows: true })
}

/// The columns asked for besides, in the order of the catalogue.
fn columns(
    sliding: &Section<'_>,
    task: &SlidingTask,
    indenter: SlidingIndenter,
    with_adhesion: bool,
) -> Result<Vec<SlidingColumns>, SceneError> {
    let words = sliding.texts("columns");
    let refused = |word: &str, why: &str| {
        let message = format!("`sliding.columns` names {word:?}: {why}");
        Err(sliding.wrong("columns", message, format!("leave {word:?} out")))
    };
    for &word in &words {
        if !with_adhesion {
            let message = format!("`sliding.columns` names {word:?}, which is about adhesive contacts, and the scene has no [adhesion]");
            let error = sliding.wrong("columns", message, "add [adhesion], or delete this line");
            return Err(error.help(
                "[adhesion] is such as: work_of_adhesion = \"0.05 J/m^2\" and process_zone = { length = \"1 µm\" }; without it the contact does not adhere",
            ));
        }
        match (word, task, indenter) {
            ("elastic_reference_contact", _, SlidingIndenter::Cylinder { .. }) => {
                return refused(word, "its modulus is |E(ω)| at ω = kv, and a single cylinder has no wave number");
            }
            ("elastic_reference_contact" | "sensitivities", SlidingTask::Branch(_), _) => {
                return refused(word, "a branch has no such columns; sweep its parameter instead");
            }
            ("friction_parts", SlidingTask::Strength, _) => return refused(word, "a strength has no friction"),
            _ => {}
        }
    }
    Ok(SlidingColumns::WORDS.iter().filter(|(_, word)| words.contains(word)).map(|(columns, _)| *columns).collect())
}

fn contacts(sliding: &Section<'_>, with_adhesion: bool) -> Result<Vec<SlidingContact>, SceneError> {
    let words = sliding.texts("contacts");
    if words.is_empty() {
        return Ok(vec![if with_adhesion { SlidingContact::Adhesive } else { SlidingContact::Adhesiveless }]);
    }
    if words.contains(&"adhesive") && !with_adhesion {
        let message = "`sliding.contacts` names an adhesive contact, but the scene has no [adhesion]";
        return Err(sliding.wrong("contacts", message, "add [adhesion], or leave \"adhesive\" out"));
    }
    Ok(words.into_iter().map(|word| if word == "adhesive" { SlidingContact::Adhesive } else { SlidingContact::Adhesiveless }).collect())
}
