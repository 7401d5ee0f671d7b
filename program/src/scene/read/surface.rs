//! The [sliding] and [adhesion] tables of a profile or surface that acts at a distance, or has no adhesion.

use super::section::Section;
use super::surface_points::{self, Grid};
use super::{DEFAULT_FIELD_POINTS, attraction, counter_body};
use crate::scene::check::Units;
use crate::scene::diagnostic::SceneError;
use crate::scene::document::Document;
use crate::scene::typed::{
    PoissonRatio, SceneLayer, SceneMaterial, SceneSurface, SlidingContact, SurfaceLoad, SurfacePath, SurfaceSliding, SurfaceTask,
};
use std::f64::consts::TAU;
use viscotack::finite_range::line::{Ends, Harmonic, Levelling, Profile, Roughness, level, periodic, rough};
use viscotack::refusal::Refusal;
use viscotack::sliding::layer::Backing;

/// Γ of a reduced scene in pressure times height: Δγ = πE0*kΛ² Γ, and E0*kΛ/2 times Λ is the unit.
const REDUCED_WORK: f64 = TAU;
/// Places of a map along each direction.
const DEFAULT_MAP_POINTS: f64 = 128.0;
const MOST_MAP_POINTS: u32 = 1024;
const DEFAULT_LOOP_POINTS: f64 = 40.0;
const DEFAULT_BRANCH_POINTS: f64 = 100.0;
/// Keys of the edge theory.
const OF_AN_EDGE: [&str; 6] = ["penetration", "half_width", "load_per_width", "cylinder", "strength", "columns"];

/// Whether the scene is about a surface that acts at a distance: it has a profile, a surface, or a law of attraction.
pub(super) fn is_meant(top: &Section<'_>) -> bool {
    let shape = top.node().get("sliding").is_some_and(|table| ["profile", "surface"].iter().any(|key| table.get(key).is_some()));
    shape || attraction::is_given(top)
}

pub(super) fn read(document: &Document, top: &Section<'_>, material: &SceneMaterial) -> Result<SurfaceSliding, SceneError> {
    let sliding = top.required_table("sliding", "it is the problem")?;
    if sliding.units() == Units::Si && !material.has_plane_strain_modulus() {
        let help = "the half-space is deformed with E* = E/(1 − ν²): a sliding contact needs material.poisson_ratio, of rubber poisson_ratio = 0.49 in [material]";
        return Err(top.required_table("material", "")?.missing("poisson_ratio").help(help));
    }
    if let Some(key) = OF_AN_EDGE.into_iter().find(|key| sliding.node().get(key).is_some()) {
        let message = format!(
            "`{}` belongs to a contact with edges and a process zone, but this scene has {}",
            sliding.full(key),
            if attraction::is_given(top) { "a law of attraction" } else { "a profile or surface" }
        );
        return Err(SceneError::at(&sliding.key_place(key), message, "leave it out"));
    }
    let attraction = attraction::read(top, document, if sliding.units() == Units::Reduced { REDUCED_WORK } else { 1.0 })?;
    if attraction.is_none() && top.node().get("adhesion").is_some() {
        let message = "the adhesion of a profile or surface needs a law of attraction: it has many edges, and no process zone";
        let place = top.table("adhesion").map_or_else(|| top.end(), |table| table.header());
        return Err(SceneError::at(&place, message, "in this table").help("give adhesion.law and adhesion.range, or leave [adhesion] out"));
    }
    let surface = surface(&sliding, document)?;
    let control = control(&sliding)?;
    let task = task(&sliding, control)?;
    let contacts = contacts(&sliding, attraction.is_some(), task)?;
    let field_points = match top.table("fields") {
        None => None,
        Some(fields) => {
            fields.without(&["from", "to"], "a crack")?;
            if task != SurfaceTask::State {
                return Err(SceneError::at(&fields.header(), "a loop or branch has no fields", "leave the table out"));
            }
            let default = if surface.profile.is_line() { DEFAULT_FIELD_POINTS } else { DEFAULT_MAP_POINTS };
            let points = fields.number("points")?.unwrap_or(default) as u32;
            if !surface.profile.is_line() && points > MOST_MAP_POINTS {
                let message = format!("`fields.points` ({points}) is the number of places along each direction of a surface");
                return Err(fields.wrong("points", message, format!("at most {MOST_MAP_POINTS}")));
            }
            Some(points)
        }
    };
    Ok(SurfaceSliding {
        surface,
        counter_body: counter_body::elastic(&sliding)?,
        layer: layer(&sliding, material)?,
        speed: sliding.required_number("speed")?,
        control,
        contacts,
        attraction,
        reached_by: reached_by(&sliding, control, task)?,
        task,
        field_points,
        most_nodes: sliding.number("most_nodes")?.map(|nodes| nodes as u32),
    })
}

fn surface(sliding: &Section<'_>, document: &Document) -> Result<std::sync::Arc<SceneSurface>, SceneError> {
    let name = sliding.exactly_one(&["wave", "profile", "surface"])?;
    document.surfaces().of(sliding, &[name], "", || {
        let table = sliding.required_table(name, "it is the body that slides")?;
        match name {
            "wave" => wave(&table),
            "profile" => profile(&table, document),
            _ => map(&table, document),
        }
    })
}

fn refused(table: &Section<'_>, key: &str, refusal: &Refusal) -> SceneError {
    table.wrong(key, format!("`{}` gives no surface: {refusal}", table.full(key)), "here")
}

fn wave(table: &Section<'_>) -> Result<SceneSurface, SceneError> {
    let size = |key: &'static str, unit: f64| match (table.units(), table.number(key)?) {
        (Units::Si, _) => table.required_number(key),
        (Units::Reduced, None) => Ok(unit),
        (Units::Reduced, Some(_)) => {
            let message = format!("`{}`: in reduced units the size of the sliding body is the unit", table.full(key));
            Err(table.wrong(key, message, "leave it out, as in wave = {}"))
        }
    };
    let (period, amplitude) = (size("wavelength", TAU)?, size("amplitude", 1.0)?);
    let profile =
        Profile::harmonics(&[Harmonic { number: 1, amplitude, phase: 0.0 }]).map_err(|refusal| refused(table, "amplitude", &refusal))?;
    Ok(SceneSurface { word: "wave", profile, period, notes: Vec::new() })
}

/// The period of a reduced scene is 2π; in SI units it is given, or there is a default.
fn period(table: &Section<'_>, default: Option<f64>) -> Result<f64, SceneError> {
    match (table.units(), table.number("period")?) {
        (Units::Reduced, None) => Ok(TAU),
        (Units::Reduced, Some(_)) => {
            let message = format!("`{}`: in reduced units the period is 2π", table.full("period"));
            Err(table.wrong("period", message, "leave it out"))
        }
        (Units::Si, Some(period)) => Ok(period),
        (Units::Si, None) => default.map_or_else(|| table.required_number("period"), Ok),
    }
}

/// Refuses keys that belong to another way to give the surface.
fn without(table: &Section<'_>, keys: &[&'static str], way: &str) -> Result<(), SceneError> {
    match keys.iter().find(|key| table.node().get(key).is_some()) {
        Some(key) => {
            let message = format!("`{}` has no effect where `{}` is given", table.full(key), table.full(way));
            Err(SceneError::at(&table.key_place(key), message, "leave it out"))
        }
        None => Ok(()),
    }
}

fn profile(table: &Section<'_>, document: &Document) -> Result<SceneSurface, SceneError> {
    match table.exactly_one(&["harmonics", "file", "roughness"])? {
        "harmonics" => {
            without(table, &["columns", "levelling", "ends"], "harmonics")?;
            let period = period(table, None)?;
            let waves = table
                .items("harmonics")
                .iter()
                .map(|item| {
                    let (number, amplitude) = (item.required_number("number")? as u32, item.required_number("amplitude")?);
                    Ok(Harmonic { number, amplitude, phase: item.number("phase")?.unwrap_or(0.0) })
                })
                .collect::<Result<Vec<_>, SceneError>>()?;
            let profile = Profile::harmonics(&waves).map_err(|refusal| refused(table, "harmonics", &refusal))?;
            Ok(SceneSurface { word: "harmonics", profile, period, notes: Vec::new() })
        }
        "roughness" => {
            without(table, &["columns", "levelling", "ends"], "roughness")?;
            roughness(table, true)
        }
        _ => {
            without(table, &["period"], "file")?;
            let grid = surface_points::profile(table, document)?;
            measured(table, grid, 1, "measured profile")
        }
    }
}

fn map(table: &Section<'_>, document: &Document) -> Result<SceneSurface, SceneError> {
    if table.exactly_one(&["file", "roughness"])? == "roughness" {
        without(table, &["columns", "levelling", "ends", "pixel", "height_unit", "direction"], "roughness")?;
        return roughness(table, false);
    }
    without(table, &["period"], "file")?;
    let mut grid = surface_points::map(table, document)?;
    let mut rows = grid.heights.len() / grid.across.max(1);
    if table.text("direction") == Some("y") {
        let (across, old) = (grid.across, &grid.heights);
        grid.heights = (0..across).flat_map(|i| (0..rows).map(move |j| old[j * across + i])).collect();
        grid.pitch.swap(0, 1);
        grid.across = rows;
        rows = across;
    }
    measured(table, grid, rows, "measured map")
}

fn roughness(table: &Section<'_>, is_line: bool) -> Result<SceneSurface, SceneError> {
    let given = table.required_table("roughness", "it is the surface")?;
    let (longest, shortest) = (given.required_number("longest")?, given.required_number("shortest")?);
    if shortest > longest {
        let message = format!("`{}` ({shortest:e}) is longer than the longest wave ({longest:e})", given.full("shortest"));
        return Err(given.wrong("shortest", message, "must be at most the longest wave"));
    }
    let period = period(table, Some(longest))?;
    if longest > period * (1.0 + 1e-9) {
        let message = format!("`{}` ({longest:e}) is longer than the period ({period:e})", given.full("longest"));
        return Err(given.wrong("longest", message, "must fit into the period"));
    }
    let roughness = Roughness {
        hurst: given.required_number("hurst")?,
        rms_height: given.required_number("rms_height")?,
        lowest: period / longest,
        highest: period / shortest,
        seed: given.number("seed")?.unwrap_or(0.0) as u32,
    };
    let profile = rough(&roughness, is_line).map_err(|refusal| refused(table, "roughness", &refusal))?;
    Ok(SceneSurface { word: if is_line { "rough profile" } else { "rough surface" }, profile, period, notes: Vec::new() })
}

/// A measured grid, levelled and made periodic.
fn measured(table: &Section<'_>, mut grid: Grid, rows: usize, word: &'static str) -> Result<SceneSurface, SceneError> {
    let (levelling, levelled) = match table.text("levelling") {
        Some("mean") => (Levelling::Mean, "its mean is taken off"),
        _ => (Levelling::Plane, "its least-squares line or plane is taken off"),
    };
    let (ends, made) = match table.text("ends") {
        Some("window") => (Ends::Window, "its heights fall to the mean over a tenth of its length at each end, so that it is periodic"),
        Some("periodic") => (Ends::Periodic, "it is taken as a whole period"),
        _ => (Ends::Mirror, "its mirror image follows it, so that it is periodic"),
    };
    level(grid.across, &mut grid.heights, levelling);
    let (nx, ny, heights) = periodic(grid.across, rows, &grid.heights, ends).map_err(|refusal| refused(table, "file", &refusal))?;
    let aspect = if ny == 1 { 1.0 } else { ny as f64 * grid.pitch[1] / (nx as f64 * grid.pitch[0]) };
    let profile = Profile::surface(nx, ny, aspect, heights).map_err(|refusal| refused(table, "file", &refusal))?;
    let period = if table.units() == Units::Reduced { TAU } else { nx as f64 * grid.pitch[0] };
    let mut notes = grid.notes;
    let size = if rows == 1 { format!("{} heights", grid.across) } else { format!("{} × {rows} heights", grid.across) };
    notes.push(format!("{:?}: {size}; {levelled}; {made}", table.text("file").unwrap_or("")));
    Ok(SceneSurface { word, profile, period, notes })
}

fn control(sliding: &Section<'_>) -> Result<SurfaceLoad, SceneError> {
    let key = sliding.exactly_one(&["mean_pressure", "mean_gap"])?;
    let value = sliding.required_number(key)?;
    match (key, sliding.number("frame_stiffness")?) {
        ("mean_gap", Some(stiffness)) => Ok(SurfaceLoad::Frame { stiffness, mean_gap: value }),
        ("mean_gap", None) => Ok(SurfaceLoad::MeanGap(value)),
        (_, None) => Ok(SurfaceLoad::MeanPressure(value)),
        (_, Some(_)) => {
            let message = "`sliding.frame_stiffness` needs the place of the far end of the frame, but the mean pressure is given";
            Err(sliding
                .wrong("frame_stiffness", message, "leave it out")
                .help("or give sliding.mean_gap, at which the frame carries nothing"))
        }
    }
}

fn task(sliding: &Section<'_>, control: SurfaceLoad) -> Result<SurfaceTask, SceneError> {
    let SurfaceLoad::MeanPressure(pressure) = control else {
        if let Some(key) = ["loop", "branch"].into_iter().find(|key| sliding.node().get(key).is_some()) {
            let message = format!("`{}` starts at a mean pressure, but a mean gap is given", sliding.full(key));
            return Err(SceneError::at(&sliding.key_place(key), message, "give sliding.mean_pressure"));
        }
        return Ok(SurfaceTask::State);
    };
    Ok(match sliding.at_most_one(&["loop", "branch"])? {
        None => SurfaceTask::State,
        Some("loop") => {
            let table = sliding.required_table("loop", "it is the way")?;
            let to = table.required_number("to")?;
            if to <= pressure {
                let message = format!("`{}` ({to:e}) is not above the mean pressure at the start ({pressure:e})", table.full("to"));
                return Err(table.wrong("to", message, "must be larger than sliding.mean_pressure"));
            }
            SurfaceTask::Loop { to, points: table.number("points")?.unwrap_or(DEFAULT_LOOP_POINTS) as u32 }
        }
        Some(_) => {
            let table = sliding.required_table("branch", "it is the curve")?;
            if table.required_text("parameter")? != "mean_pressure" {
                let message = "with a law of attraction, or of a profile, a branch runs along the mean pressure";
                return Err(table.wrong("parameter", message, "must be \"mean_pressure\""));
            }
            if let Some(key) = ["from", "to", "branches", "frame_stiffness"].into_iter().find(|key| table.node().get(key).is_some()) {
                let message = format!("`{}`: with a law of attraction, or of a profile, a branch is followed to its ends", table.full(key));
                return Err(SceneError::at(&table.key_place(key), message, "leave it out"));
            }
            SurfaceTask::Branch { points: table.number("points")?.unwrap_or(DEFAULT_BRANCH_POINTS) as u32 }
        }
    })
}

fn contacts(sliding: &Section<'_>, with_adhesion: bool, task: SurfaceTask) -> Result<Vec<SlidingContact>, SceneError> {
    let words = sliding.texts("contacts");
    let own = if with_adhesion { SlidingContact::Adhesive } else { SlidingContact::Adhesiveless };
    if words.contains(&"adhesive") && !with_adhesion {
        let message = "`sliding.contacts` names an adhesive contact, but the scene has no [adhesion]";
        return Err(sliding.wrong("contacts", message, "add [adhesion], or leave \"adhesive\" out"));
    }
    if words.is_empty() {
        return Ok(vec![own]);
    }
    if task != SurfaceTask::State && words.len() > 1 {
        return Err(sliding.wrong("contacts", "a loop or branch is of one kind of contact", "name one"));
    }
    Ok(words.into_iter().map(|word| if word == "adhesive" { SlidingContact::Adhesive } else { SlidingContact::Adhesiveless }).collect())
}

fn layer(sliding: &Section<'_>, material: &SceneMaterial) -> Result<Option<SceneLayer>, SceneError> {
    let Some(table) = sliding.table("layer") else { return Ok(None) };
    let thickness = table.required_number("thickness")?;
    let backing = if table.text("backing") == Some("free") { Backing::Free } else { Backing::Confined };
    let given = table.number("poisson_ratio")?;
    let poisson_ratio = match (table.units(), material.poisson()) {
        (Units::Reduced, _) => given.unwrap_or(0.5),
        (Units::Si, _) if given.is_some() => {
            let message = format!("`{}`: in SI units the Poisson ratio is that of the material", table.full("poisson_ratio"));
            return Err(table.wrong("poisson_ratio", message, "leave it out, and give material.poisson_ratio"));
        }
        (Units::Si, PoissonRatio::Following(_)) => {
            let message = "a layer needs one Poisson ratio at all times, but the material has shear and bulk moduli of their own";
            return Err(SceneError::at(&table.header(), message, "give material.poisson_ratio instead"));
        }
        (Units::Si, ratio) => ratio.constant().unwrap_or(0.5),
    };
    Ok(Some(SceneLayer { thickness, backing, poisson_ratio }))
}

fn reached_by(sliding: &Section<'_>, control: SurfaceLoad, task: SurfaceTask) -> Result<SurfacePath, SceneError> {
    let Some(word) = sliding.text("reached_by") else { return Ok(SurfacePath::LongRange) };
    if task != SurfaceTask::State {
        let message = "`sliding.reached_by` picks one of several states, but a loop or a branch goes through them";
        return Err(sliding.wrong("reached_by", message, "leave it out"));
    }
    match (word, control) {
        ("long_range", _) => Ok(SurfacePath::LongRange),
        ("every", _) => Ok(SurfacePath::Every),
        (word, SurfaceLoad::MeanPressure(_)) => Ok(if word == "unloading" { SurfacePath::Unloading } else { SurfacePath::Loading }),
        _ => {
            let message = "`sliding.reached_by` tells how a mean pressure was reached, but a mean gap is given";
            Err(sliding.wrong("reached_by", message, "leave it out"))
        }
    }
}
