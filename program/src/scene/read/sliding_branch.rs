//! The [sliding.branch] and [sliding.strength] tables: curves of contacts, and what contacts bear.

use super::section::Section;
use super::works::GivenWorks;
use crate::scene::check::number;
use crate::scene::diagnostic::SceneError;
use crate::scene::typed::{BranchParameter, SlidingAdhesion, SlidingBranch, SlidingIndenter, SlidingTask, SlidingZone};
use crate::scene::units::Dimension;

/// Points of a branch where a scene names no number.
const DEFAULT_POINTS: f64 = 100.0;
/// What prescribes a load.
const LOADS: [&str; 4] = ["mean_pressure", "load_per_width", "penetration", "half_width"];

/// What is looked for.
pub(super) fn task(sliding: &Section<'_>, with_adhesion: bool) -> Result<SlidingTask, SceneError> {
    let Some(name) = sliding.at_most_one(&["branch", "strength"])? else { return Ok(SlidingTask::State) };
    if !with_adhesion {
        let message = format!("[sliding.{name}] is about adhesive contacts, but the scene has no [adhesion]");
        return Err(SceneError::at(&sliding.key_place(name), message, "needs [adhesion]"));
    }
    match sliding.table("branch") {
        Some(table) => Ok(SlidingTask::Branch(branch(&table, sliding.node().get("wave").is_some())?)),
        None => Ok(sliding.value(name).map_or(SlidingTask::State, |_| SlidingTask::Strength)),
    }
}

/// Whether the load varies, so that none is given.
pub(super) const fn meets_every_load(task: &SlidingTask) -> bool {
    match task {
        SlidingTask::State => false,
        SlidingTask::Branch(branch) => branch.parameter.is_load(),
        SlidingTask::Strength => true,
    }
}

/// The speeds of a branch along them.
pub(super) fn speeds(task: &SlidingTask) -> Option<[f64; 2]> {
    match task {
        SlidingTask::Branch(branch) if branch.parameter == BranchParameter::Speed => branch.range,
        _ => None,
    }
}

/// Refuses a load where every load is met.
pub(super) fn without_load(sliding: &Section<'_>) -> Result<(), SceneError> {
    match LOADS.iter().find(|key| sliding.node().get(key).is_some()) {
        Some(key) => {
            let table = if sliding.node().get("branch").is_some() { "branch" } else { "strength" };
            let message = format!("`{}` is given, but [sliding.{table}] goes through every load", sliding.full(key));
            Err(SceneError::at(&sliding.key_place(key), message, "leave it out"))
        }
        None => Ok(()),
    }
}

/// Refuses what only single contacts have.
pub(super) fn of_states(top: &Section<'_>, sliding: &Section<'_>) -> Result<(), SceneError> {
    let leave = |place: &Section<'_>, key: &str, message: &str| Err(SceneError::at(&place.key_place(key), message, "leave it out"));
    if top.node().get("fields").is_some() {
        return leave(top, "fields", "[fields] belongs to a contact under one load, not to a branch or a strength");
    }
    if sliding.texts("contacts").contains(&"adhesiveless") {
        let message = "`sliding.contacts` names an adhesiveless contact: branches and strengths are of adhesive ones";
        return Err(sliding.wrong("contacts", message, "leave \"adhesiveless\" out"));
    }
    Ok(())
}

fn branch(table: &Section<'_>, wave: bool) -> Result<SlidingBranch, SceneError> {
    let word = table.required_text("parameter")?;
    let parameter = BranchParameter::WORDS
        .iter()
        .find(|(_, known)| *known == word)
        .map(|(parameter, _)| *parameter)
        .ok_or_else(|| table.missing("parameter"))?;
    let of_other = match parameter {
        BranchParameter::LoadPerWidth => wave,
        BranchParameter::MeanPressure | BranchParameter::Penetration => !wave,
        _ => false,
    };
    if of_other {
        let message = format!("`{}` = {word:?} does not belong to this body", table.full("parameter"));
        let instead = if wave { "\"mean_pressure\", \"penetration\"" } else { "\"load_per_width\"" };
        return Err(table.wrong("parameter", message, format!("give one of {instead}, \"half_width\"")));
    }
    let range = range(table, parameter, wave)?;
    let frame_stiffness = table.number("frame_stiffness")?;
    if frame_stiffness.is_some() && !wave {
        let message = format!("`{}`: a cylinder has no penetration, which a frame would hold", table.full("frame_stiffness"));
        return Err(table.wrong("frame_stiffness", message, "leave it out"));
    }
    let every = table.text("branches") == Some("every");
    let ranged = !matches!(parameter, BranchParameter::HalfWidth) && parameter.is_load() && range.is_some();
    if every && ranged {
        let message =
            format!("`{}` = \"every\" goes through every load, but a range of {} is given", table.full("branches"), parameter.word());
        let instead = if wave { "leave `from` and `to` out, or go along \"half_width\"" } else { "go along \"half_width\"" };
        return Err(table.wrong("branches", message, instead));
    }
    let points = table.number("points")?.unwrap_or(DEFAULT_POINTS) as u32;
    Ok(SlidingBranch { parameter, range, points, frame_stiffness, every })
}

fn range(table: &Section<'_>, parameter: BranchParameter, wave: bool) -> Result<Option<[f64; 2]>, SceneError> {
    let (dimension, positive) = match parameter {
        BranchParameter::MeanPressure => (Dimension::PRESSURE, false),
        BranchParameter::LoadPerWidth => (Dimension::LOAD_PER_WIDTH, false),
        BranchParameter::Penetration => (Dimension::LENGTH, false),
        BranchParameter::HalfWidth | BranchParameter::ProcessZone => (Dimension::LENGTH, true),
        BranchParameter::Speed => (Dimension::SPEED, true),
        BranchParameter::WorkOfAdhesion => (Dimension::ENERGY_PER_AREA, true),
    };
    let end = |key: &'static str| -> Result<Option<f64>, SceneError> {
        let Some(node) = table.value(key) else { return Ok(None) };
        let value = number(node, &table.full(key), dimension, table.units())?;
        if positive && value <= 0.0 {
            let message = format!("`{}` is out of range along {}", table.full(key), parameter.word());
            return Err(table.wrong(key, message, "must be greater than 0"));
        }
        Ok(Some(value))
    };
    match (end("from")?, end("to")?) {
        (Some(from), Some(to)) if from < to => Ok(Some([from, to])),
        (Some(from), Some(to)) => {
            let message = format!("`{}` ({to:e}) is not above `{}` ({from:e})", table.full("to"), table.full("from"));
            Err(table.wrong("to", message, "must be the larger one"))
        }
        (None, None) if wave && parameter.is_load() => Ok(None),
        (None, _) => Err(table.missing("from")),
        (_, None) => Err(table.missing("to")),
    }
}

/// Refuses a branch that contradicts the adhesion.
pub(super) fn fits(
    sliding: &Section<'_>,
    task: &SlidingTask,
    indenter: SlidingIndenter,
    adhesion: SlidingAdhesion,
    works: &GivenWorks<'_>,
) -> Result<(), SceneError> {
    let (SlidingTask::Branch(branch), Some(table)) = (task, sliding.table("branch")) else { return Ok(()) };
    let Some(range) = branch.range else { return Ok(()) };
    let work = if works.per_edge { "the work of adhesion of the trailing edge" } else { "adhesion.work_of_adhesion" };
    within(&table, branch.parameter, (indenter, adhesion, work), range)?;
    if branch.parameter == BranchParameter::Speed {
        range.into_iter().try_for_each(|speed| works.covers(speed))?;
        if let SlidingZone::Cohesive { grows: true, .. } = adhesion.process_zone {
            let message = "`sliding.branch.parameter` = \"speed\" holds the process zones, but adhesion.process_zone grows with the speed";
            return Err(table
                .wrong("parameter", message, "needs a process zone by length or by cohesive_stress")
                .help("or sweep sliding.speed"));
        }
        if works.law.is_some() && matches!(adhesion.process_zone, SlidingZone::Cohesive { .. }) {
            let message = "`sliding.branch.parameter` = \"speed\" holds the process zones, but adhesion.process_zone follows from a cohesive stress and, with it, from a work of adhesion that changes with speed";
            return Err(table.wrong("parameter", message, "needs a process zone by length").help("or sweep sliding.speed"));
        }
    }
    Ok(())
}

/// Refuses ends that contradict the rest of the scene.
fn within(
    table: &Section<'_>,
    parameter: BranchParameter,
    (indenter, adhesion, work): (SlidingIndenter, SlidingAdhesion, &str),
    [smallest, largest]: [f64; 2],
) -> Result<(), SceneError> {
    let starts_at = |start: f64, name: &str| {
        if (smallest..=largest).contains(&start) {
            return Ok(());
        }
        let message = format!("the branch begins at {name} ({start:e}), which is not between `from` and `to`");
        Err(table.wrong(if start < smallest { "from" } else { "to" }, message, format!("must reach to {start:e}")))
    };
    match (parameter, indenter, adhesion.process_zone) {
        (BranchParameter::HalfWidth, SlidingIndenter::Wave { wavelength, .. }, _) if largest >= 0.5 * wavelength => {
            let message = format!("`{}` ({largest:e}) is not below half the wavelength ({:e})", table.full("to"), 0.5 * wavelength);
            Err(table.wrong("to", message, "a full contact has no edges"))
        }
        (BranchParameter::WorkOfAdhesion, _, SlidingZone::Cohesive { .. }) => {
            let message = "`sliding.branch.parameter` = \"work_of_adhesion\" holds the process zones, but adhesion.process_zone follows from a cohesive stress";
            Err(table.wrong("parameter", message, "needs a process zone by length").help("or sweep adhesion.work_of_adhesion"))
        }
        (BranchParameter::WorkOfAdhesion, ..) => starts_at(adhesion.works[0], work),
        (BranchParameter::ProcessZone, _, SlidingZone::Lengths { trailing, .. }) => {
            starts_at(trailing, "the process zone of the trailing edge")
        }
        (BranchParameter::ProcessZone, _, SlidingZone::Cohesive { .. }) => {
            let message = "`sliding.branch.parameter` = \"process_zone\": the process zone follows from a cohesive stress";
            Err(table.wrong("parameter", message, "needs a process zone by length").help("or sweep adhesion.process_zone.cohesive_stress"))
        }
        _ => Ok(()),
    }
}
