//! Steady and delayed cracks, and the closure itself.

use crate::arrays::{Numbers, array, mapped_estimates, pair, refused, unknown};
use crate::material::PyMaterial;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use viscotack::closure::{EdgeFields, process_zone_work};
use viscotack::crack::cohesive_zone::CohesiveZone;
use viscotack::crack::delayed::trajectory::tends_to;
use viscotack::crack::delayed::{GrowthProblem, LoadHistory, LoadSegment, Onset, Resolution, TipState, onset, trajectory};
use viscotack::crack::near_tip::{ClosingTip, OpeningTip};
use viscotack::crack::persson_brener::PerssonBrener;
use viscotack::crack::virtual_work::VirtualWork;
use viscotack::crack::{CrackBody, Interface, Motion, ProcessZone, SteadyCurve, SteadyState, at_drive, at_speed};

pub(crate) fn motion(word: &str) -> PyResult<Motion> {
    match word {
        "opening" => Ok(Motion::Opening),
        "closing" => Ok(Motion::Closing),
        _ => Err(unknown("motion", word)),
    }
}

fn body(word: &str) -> PyResult<CrackBody> {
    match word {
        "against_rigid" => Ok(CrackBody::AgainstRigid),
        "two_halves" => Ok(CrackBody::TwoHalves),
        _ => Err(unknown("body", word)),
    }
}

/// The zone of a kind, from its numbers: a length; or a cohesive stress and a factor.
fn zone(kind: &str, numbers: &Numbers) -> PyResult<ProcessZone> {
    match (kind, numbers.0.as_slice()) {
        ("constant", &[length]) => Ok(ProcessZone::Constant { length }),
        ("growing", &[cohesive_stress, factor]) => Ok(ProcessZone::Growing { cohesive_stress, factor }),
        ("schapery", &[cohesive_stress, factor]) => Ok(ProcessZone::Schapery { cohesive_stress, factor }),
        _ => Err(unknown("process zone", kind)),
    }
}

/// A steady crack at a speed, or under a drive: theory `virtual_work`, `persson_brener` or `cohesive_zone` (zone: the cohesive stress alone).
#[pyfunction]
#[pyo3(signature = (material, motion_word, theory, work_of_adhesion, zone_kind, zone_numbers, speed = None, drive = None, body_word = "against_rigid", tolerance = 1e-15))]
#[expect(clippy::too_many_arguments, reason = "keyword arguments of a Python function")]
fn steady_crack<'py>(
    py: Python<'py>,
    material: &PyMaterial,
    motion_word: &str,
    theory: &str,
    work_of_adhesion: f64,
    zone_kind: &str,
    zone_numbers: Numbers,
    speed: Option<f64>,
    drive: Option<f64>,
    body_word: &str,
    tolerance: f64,
) -> PyResult<Bound<'py, PyDict>> {
    fn solved(curve: &impl SteadyCurve, speed: Option<f64>, drive: Option<f64>, tolerance: f64) -> PyResult<SteadyState> {
        match (speed, drive) {
            (Some(speed), None) => at_speed(curve, speed, tolerance).map_err(refused),
            (None, Some(drive)) => at_drive(curve, drive, tolerance).map_err(refused),
            _ => Err(unknown("the control", "give either a speed or a drive")),
        }
    }
    let (material, motion, body) = (&material.0, motion(motion_word)?, body(body_word)?);
    let state = if theory == "cohesive_zone" {
        let &[stress] = zone_numbers.0.as_slice() else { return Err(unknown("process zone", zone_kind)) };
        solved(&CohesiveZone::new(material, motion, work_of_adhesion, stress, body).map_err(refused)?, speed, drive, tolerance)?
    } else {
        let interface = Interface { work_of_adhesion, process_zone: zone(zone_kind, &zone_numbers)?, body };
        match theory {
            "virtual_work" => solved(&VirtualWork::new(material, motion, interface).map_err(refused)?, speed, drive, tolerance)?,
            "persson_brener" => solved(&PerssonBrener::new(material, motion, interface).map_err(refused)?, speed, drive, tolerance)?,
            _ => return Err(unknown("theory", theory)),
        }
    };
    let out = PyDict::new(py);
    out.set_item("speed", pair(state.speed))?;
    out.set_item("crossing_time", state.crossing_time)?;
    out.set_item("crossing_length", pair(state.crossing_length))?;
    out.set_item("drive", pair(state.drive))?;
    out.set_item("intensity_squared", body.intensity_squared(work_of_adhesion, state.drive.value))?;
    out.set_item("energy_release_rate_ratio", state.energy_release_rate_ratio.map(pair))?;
    out.set_item("speed_exponent", state.speed_exponent)?;
    out.set_item("residual", state.residual)?;
    Ok(out)
}

/// Displacement behind an opening tip of stress intensity K, or behind a closing one of displacement intensity K₁/E0.
#[pyfunction]
#[pyo3(signature = (material, motion_word, intensity, speed, distances, body_word = "against_rigid"))]
fn tip_displacement<'py>(
    py: Python<'py>,
    material: &PyMaterial,
    motion_word: &str,
    intensity: f64,
    speed: f64,
    distances: Numbers,
    body_word: &str,
) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
    let body = body(body_word)?;
    match motion(motion_word)? {
        Motion::Opening => {
            let tip = OpeningTip::new(&material.0, body, intensity, speed).map_err(refused)?;
            mapped_estimates(py, &distances, |distance| tip.displacement(distance))
        }
        Motion::Closing => {
            let tip = ClosingTip::new(&material.0, body, intensity, speed).map_err(refused)?;
            mapped_estimates(py, &distances, |distance| tip.displacement(distance))
        }
    }
}

/// Stress ahead of a closing tip of displacement intensity K₁/E0.
#[pyfunction]
fn closing_stress<'py>(
    py: Python<'py>,
    material: &PyMaterial,
    intensity: f64,
    speed: f64,
    distances: Numbers,
) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
    let tip = ClosingTip::new(&material.0, CrackBody::AgainstRigid, intensity, speed).map_err(refused)?;
    mapped_estimates(py, &distances, |distance| tip.stress(distance))
}

/// The growth problem of a material: the zone of the reference intensity, or, without one, one that follows the load.
fn growth<'a>(
    material: &'a PyMaterial,
    work_of_adhesion: f64,
    zone_kind: &str,
    zone_numbers: &Numbers,
    reference: Option<f64>,
) -> PyResult<GrowthProblem<'a>> {
    let interface = Interface { work_of_adhesion, process_zone: zone(zone_kind, zone_numbers)?, body: CrackBody::AgainstRigid };
    match reference {
        Some(reference) => GrowthProblem::new(&material.0, interface, reference),
        None => GrowthProblem::following(&material.0, interface),
    }
    .map_err(refused)
}

/// Delay and initial speed under a constant load: none if the crack never grows; zero and infinity if it grows at once.
#[pyfunction]
fn delayed_onset(
    material: &PyMaterial,
    work_of_adhesion: f64,
    zone_kind: &str,
    zone_numbers: Numbers,
    intensity: f64,
) -> PyResult<Option<[(f64, f64); 2]>> {
    let problem = growth(material, work_of_adhesion, zone_kind, &zone_numbers, Some(intensity))?;
    Ok(match onset(&problem, intensity).map_err(refused)? {
        Onset::Never => None,
        Onset::After { delay, initial_speed, .. } => Some([pair(delay), pair(initial_speed)]),
        Onset::AtOnce => Some([(0.0, 0.0), (f64::INFINITY, 0.0)]),
    })
}

/// (speed, bound) of the steady motion to which growth under a constant load tends.
#[pyfunction]
fn delayed_tends_to(
    material: &PyMaterial,
    work_of_adhesion: f64,
    zone_kind: &str,
    zone_numbers: Numbers,
    intensity: f64,
) -> PyResult<(f64, f64)> {
    let problem = growth(material, work_of_adhesion, zone_kind, &zone_numbers, Some(intensity))?;
    tends_to(&problem, intensity, 1e-15).map(|state| pair(state.speed)).map_err(refused)
}

/// Places and speeds of a tip at output times, under ramps: `loads` holds the load at time zero, then pairs (duration, load at its end), zero for a step.
#[pyfunction]
#[pyo3(signature = (material, work_of_adhesion, zone_kind, zone_numbers, loads, outputs, reference = None, lines_per_zone = 64))]
#[expect(clippy::too_many_arguments, reason = "keyword arguments of a Python function")]
fn delayed_trajectory<'py>(
    py: Python<'py>,
    material: &PyMaterial,
    work_of_adhesion: f64,
    zone_kind: &str,
    zone_numbers: Numbers,
    loads: Numbers,
    outputs: Numbers,
    reference: Option<f64>,
    lines_per_zone: u32,
) -> PyResult<Bound<'py, PyDict>> {
    let problem = growth(material, work_of_adhesion, zone_kind, &zone_numbers, reference)?;
    let [first, rest @ ..] = loads.0.as_slice() else { return Err(unknown("load history", "no load")) };
    let mut segments = vec![LoadSegment::Step { load: *first }];
    segments.extend(rest.chunks_exact(2).map(|part| match part[0] {
        0.0 => LoadSegment::Step { load: part[1] },
        duration => LoadSegment::Ramp { duration, load: part[1] },
    }));
    let history = LoadHistory::from_segments(&segments).map_err(refused)?;
    let resolution = Resolution { lines_per_zone, ..Resolution::default() };
    let found = trajectory(&problem, &history, &outputs.0, resolution).map_err(refused)?;
    let numbers = |of: fn(&viscotack::crack::delayed::Sample) -> f64| array(py, &found.samples.iter().map(of).collect::<Vec<_>>());
    let out = PyDict::new(py);
    out.set_item("growth", numbers(|sample| sample.growth.map_or(f64::INFINITY, |growth| growth.value))?)?;
    out.set_item("growth_error", numbers(|sample| sample.growth.map_or(0.0, |growth| growth.error))?)?;
    out.set_item("speed", numbers(|sample| sample.speed.map_or(f64::INFINITY, |speed| speed.value))?)?;
    out.set_item("speed_error", numbers(|sample| sample.speed.map_or(0.0, |speed| speed.error))?)?;
    out.set_item("grows", numbers(|sample| f64::from(u8::from(sample.state != TipState::Resting)))?)?;
    out.set_item("residual", found.residual)?;
    Ok(out)
}

/// Two Python functions of a distance to the edge; an exception is kept and its value is not a number.
struct Callbacks<'py> {
    fields: [Bound<'py, PyAny>; 2],
    failure: std::cell::RefCell<Option<PyErr>>,
}

impl Callbacks<'_> {
    fn call(&self, which: usize, distance: f64) -> f64 {
        self.fields[which].call1((distance,)).and_then(|value| value.extract()).unwrap_or_else(|error| {
            self.failure.borrow_mut().get_or_insert(error);
            f64::NAN
        })
    }
}

impl EdgeFields for Callbacks<'_> {
    fn tension(&self, distance_inside: f64) -> f64 {
        self.call(0, distance_inside)
    }

    fn gap(&self, distance_outside: f64) -> f64 {
        self.call(1, distance_outside)
    }
}

/// The closure: (1/2δ)∫ tension(d) gap(δ − d) dd, with its error bound.
#[pyfunction]
fn closure(tension: Bound<'_, PyAny>, gap: Bound<'_, PyAny>, process_zone: f64, tolerance: f64) -> PyResult<(f64, f64)> {
    let fields = Callbacks { fields: [tension, gap], failure: std::cell::RefCell::new(None) };
    let work = process_zone_work(&fields, process_zone, tolerance);
    if let Some(error) = fields.failure.into_inner() {
        return Err(error);
    }
    work.map(|work| (work.value, work.error)).map_err(refused)
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(steady_crack, module)?)?;
    module.add_function(wrap_pyfunction!(tip_displacement, module)?)?;
    module.add_function(wrap_pyfunction!(closing_stress, module)?)?;
    module.add_function(wrap_pyfunction!(delayed_onset, module)?)?;
    module.add_function(wrap_pyfunction!(delayed_trajectory, module)?)?;
    module.add_function(wrap_pyfunction!(delayed_tends_to, module)?)?;
    module.add_function(wrap_pyfunction!(closure, module)?)
}
