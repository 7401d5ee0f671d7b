//! The sphere and other axisymmetric indenters.

use crate::arrays::{Numbers, array, mapped, pair, refused, unknown};
use crate::material::PyMaterial;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use viscotack::indentation::{
    Adhesion, Contact, Controlled, History, IndentationProblem, Panel, Profile, Springs, Start, SurfaceFields, Sweep, Zone,
    elastic_contact, integrate, run, zone_work,
};

/// The indenter of a kind, from its numbers: radius; slope; radius; coefficient and exponent; r, z, r, z… of a table.
fn profile(kind: &str, numbers: &Numbers) -> PyResult<Profile> {
    match (kind, numbers.0.as_slice()) {
        ("paraboloid", &[radius]) => Ok(Profile::Paraboloid { radius }),
        ("cone", &[slope]) => Ok(Profile::Cone { slope }),
        ("flat_punch", &[radius]) => Ok(Profile::FlatPunch { radius }),
        ("power_law", &[coefficient, exponent]) => Ok(Profile::PowerLaw { coefficient, exponent }),
        ("table", points) => Profile::table(&points.chunks_exact(2).map(|pair| (pair[0], pair[1])).collect::<Vec<_>>()).map_err(refused),
        _ => Err(unknown("indenter", kind)),
    }
}

fn start(word: &str) -> PyResult<Start> {
    match word {
        "untouched" => Ok(Start::Untouched),
        "relaxed" => Ok(Start::Relaxed),
        _ => Err(unknown("start", word)),
    }
}

fn controlled(word: &str) -> PyResult<Controlled> {
    match word {
        "penetration" => Ok(Controlled::Penetration),
        "force" => Ok(Controlled::Force),
        "contact_radius" => Ok(Controlled::ContactRadius),
        "frame" => Ok(Controlled::Frame),
        _ => Err(unknown("control", word)),
    }
}

/// Line profile f(s) of an indenter.
#[pyfunction]
fn line_profile<'py>(py: Python<'py>, kind: &str, numbers: Numbers, places: Numbers) -> PyResult<Bound<'py, PyAny>> {
    let profile = profile(kind, &numbers)?;
    mapped(py, &places, |place| Ok(profile.line(place)))
}

/// A contact whose radius and penetration are prescribed, linear in time between rows (radius, penetration, duration); each row also asks for the
/// displacement and pressure at `places`. Returns forces, stress intensities, closure works at `process_zone` (0 for none), and both fields row by row.
#[pyfunction]
#[pyo3(signature = (material, kind, numbers, start_word, radius, penetration, path, places, process_zone = 0.0))]
#[expect(clippy::too_many_arguments, reason = "keyword arguments of a Python function")]
fn prescribed_contact<'py>(
    py: Python<'py>,
    material: &PyMaterial,
    kind: &str,
    numbers: Numbers,
    start_word: &str,
    radius: f64,
    penetration: f64,
    path: Numbers,
    places: Numbers,
    process_zone: f64,
) -> PyResult<Bound<'py, PyDict>> {
    let springs = Springs::new(&material.0).map_err(refused)?;
    let profile = profile(kind, &numbers)?;
    let mut contact = match start(start_word)? {
        Start::Untouched => Contact::untouched(&springs, profile, radius, penetration),
        Start::Relaxed => Contact::relaxed(&springs, profile, radius, penetration),
    }
    .map_err(refused)?;
    let (mut force, mut intensity, mut work, mut displacement, mut pressure) = (Vec::new(), Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for row in path.0.chunks_exact(3) {
        contact = contact.moved(row[0], row[1], row[2], Sweep::Linear).map_err(refused)?;
        force.push(contact.force());
        intensity.push(contact.stress_intensity_factor());
        if process_zone > 0.0 {
            work.push(contact.zone_work(process_zone).map_err(refused)?);
        }
        let fields = SurfaceFields::of(&contact);
        for &place in &places.0 {
            displacement.push(fields.displacement(place).map_err(refused)?);
            pressure.push(fields.pressure(place).map_err(refused)?);
        }
    }
    let out = PyDict::new(py);
    for (name, values) in [
        ("force", &force),
        ("stress_intensity_factor", &intensity),
        ("zone_work", &work),
        ("displacement", &displacement),
        ("pressure", &pressure),
    ] {
        out.set_item(name, array(py, values)?)?;
    }
    Ok(out)
}

/// A history solved to an accuracy, or, with a `tolerance`, one integration. `segments` are (control, end, duration).
#[pyfunction]
#[pyo3(signature = (material, kind, numbers, start_word, control, start_value, segments, work_of_adhesion = None, process_zone = None, frame_stiffness = None, instants_per_segment = 1, accuracy = 1e-4, energies = false, tolerance = None))]
#[expect(clippy::too_many_arguments, reason = "keyword arguments of a Python function")]
fn indentation<'py>(
    py: Python<'py>,
    material: &PyMaterial,
    kind: &str,
    numbers: Numbers,
    start_word: &str,
    control: &str,
    start_value: f64,
    segments: Vec<(String, f64, f64)>,
    work_of_adhesion: Option<f64>,
    process_zone: Option<f64>,
    frame_stiffness: Option<f64>,
    instants_per_segment: u32,
    accuracy: f64,
    energies: bool,
    tolerance: Option<f64>,
) -> PyResult<Bound<'py, PyDict>> {
    let mut history = History::from(controlled(control)?, start_value);
    for (word, end, duration) in segments {
        history = history.then(controlled(&word)?, end, duration);
    }
    let adhesion = match (work_of_adhesion, process_zone) {
        (Some(work_of_adhesion), Some(process_zone)) => Some(Adhesion { work_of_adhesion, process_zone }),
        _ => None,
    };
    let problem = IndentationProblem {
        start: start(start_word)?,
        frame_stiffness,
        instants_per_segment,
        energies,
        accuracy,
        ..IndentationProblem::new(profile(kind, &numbers)?, adhesion, history)
    };
    let out = PyDict::new(py);
    if let Some(tolerance) = tolerance {
        let trace = integrate(&material.0, &problem, tolerance).map_err(refused)?;
        let column = |of: fn(&viscotack::indentation::PathPoint) -> f64| array(py, &trace.path.iter().map(of).collect::<Vec<_>>());
        out.set_item("time", column(|point| point.time)?)?;
        out.set_item("penetration", column(|point| point.penetration)?)?;
        out.set_item("force", column(|point| point.force)?)?;
        out.set_item("contact_radius", column(|point| point.contact_radius)?)?;
        out.set_item("largest_tension", trace.largest_tension())?;
        out.set_item("balance_defect", trace.balance_defect())?;
        return Ok(out);
    }
    let solution = run(&material.0, &problem).map_err(refused)?;
    let instants = &solution.instants;
    let column = |of: fn(&viscotack::indentation::Instant) -> f64| array(py, &instants.iter().map(of).collect::<Vec<_>>());
    out.set_item("time", column(|instant| instant.time)?)?;
    out.set_item("penetration", column(|instant| instant.penetration.value)?)?;
    out.set_item("penetration_error", column(|instant| instant.penetration.error)?)?;
    out.set_item("force", column(|instant| instant.force.value)?)?;
    out.set_item("force_error", column(|instant| instant.force.error)?)?;
    out.set_item("contact_radius", column(|instant| instant.contact_radius.value)?)?;
    out.set_item("contact_radius_error", column(|instant| instant.contact_radius.error)?)?;
    out.set_item("stress_intensity_factor", column(|instant| instant.stress_intensity_factor.value)?)?;
    out.set_item("largest_tension", solution.pull_off_force().map(pair))?;
    out.set_item("balance_defect", solution.balance_defect)?;
    out.set_item("reached", solution.reached)?;
    let events: Vec<(String, f64)> = solution.events.iter().map(|event| (format!("{:?}", event.kind), event.time.value)).collect();
    out.set_item("events", events)?;
    Ok(out)
}

/// Radius, penetration, force and stress intensity of the stable elastic contact at a penetration.
#[pyfunction]
fn elastic_indentation(
    kind: &str,
    numbers: Numbers,
    modulus: f64,
    work_of_adhesion: f64,
    process_zone: f64,
    penetration: f64,
) -> PyResult<[f64; 4]> {
    let state = elastic_contact(&profile(kind, &numbers)?, modulus, work_of_adhesion, process_zone, penetration).map_err(refused)?;
    Ok([state.contact_radius, state.penetration, state.force, state.stress_intensity_factor])
}

/// C of Eq 4.9 from line load and gap factor, each given as functions of s on panels with the given ends.
#[pyfunction]
fn sphere_closure(
    radius: f64,
    process_zone: f64,
    load_ends: Numbers,
    load: Bound<'_, PyAny>,
    factor_ends: Numbers,
    factor: Bound<'_, PyAny>,
) -> PyResult<f64> {
    let sampled = |ends: &Numbers, function: &Bound<'_, PyAny>| -> PyResult<Vec<Panel>> {
        let failure = std::cell::RefCell::new(None);
        let panels = ends
            .0
            .windows(2)
            .map(|pair| {
                Panel::sampled(pair[0], pair[1], |s| {
                    function.call1((s,)).and_then(|value| value.extract()).unwrap_or_else(|error| {
                        failure.borrow_mut().get_or_insert(error);
                        f64::NAN
                    })
                })
            })
            .collect();
        failure.into_inner().map_or(Ok(panels), Err)
    };
    let zone = Zone::new(radius, process_zone).map_err(refused)?;
    Ok(zone_work(&zone, &sampled(&load_ends, &load)?, &sampled(&factor_ends, &factor)?))
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(line_profile, module)?)?;
    module.add_function(wrap_pyfunction!(prescribed_contact, module)?)?;
    module.add_function(wrap_pyfunction!(indentation, module)?)?;
    module.add_function(wrap_pyfunction!(elastic_indentation, module)?)?;
    module.add_function(wrap_pyfunction!(sphere_closure, module)?)
}
