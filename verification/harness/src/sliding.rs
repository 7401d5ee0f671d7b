//! Steady sliding: contacts with given edges, contacts in equilibrium, branches. Reduced units.

use crate::arrays::{Numbers, array, mapped, pair, refused, unknown};
use crate::material::PyMaterial;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;
use viscotack::sliding::branch::{BranchProblem, Scan, contacts_of_width, every_branch, strength, trace};
use viscotack::sliding::contact::{ContactMemory, ContactState, Edge, Indenter, Prescribed, Resolution, WaveContact, edge_work};
use viscotack::sliding::edge_balance::EdgeBalance;
use viscotack::sliding::steady::{
    PartialValues, SlidingControl, SlidingOutcome, SlidingProblem, WaveAdhesion, full_contact_friction, steady_sliding,
};

fn control(word: &str, value: f64) -> PyResult<SlidingControl> {
    match word {
        "mean_pressure" => Ok(SlidingControl::MeanPressure(value)),
        "penetration" => Ok(SlidingControl::Penetration(value)),
        "half_width" => Ok(SlidingControl::HalfWidth(value)),
        _ => Err(unknown("control", word)),
    }
}

/// Γ and δ of both edges, as (trailing work, leading work, trailing zone, leading zone).
type Edges = [f64; 4];

const fn adhesion([trailing_work, leading_work, trailing_zone, leading_zone]: Edges) -> WaveAdhesion {
    WaveAdhesion { trailing_work, leading_work, trailing_zone, leading_zone }
}

/// Friction stress of full contact, ½Im E(kv)/E0.
#[pyfunction]
fn full_contact(material: &PyMaterial, rate: f64) -> PyResult<(f64, f64)> {
    full_contact_friction(&material.0, rate).map(pair).map_err(refused)
}

/// A contact of a wave with given edges.
#[pyclass(frozen)]
struct SlidingContact {
    memory: ContactMemory,
    state: ContactState,
}

#[pymethods]
impl SlidingContact {
    /// Half-width, eccentricity, and either the mean pressure or the penetration.
    #[new]
    fn new(material: &PyMaterial, rate: f64, half_width: f64, eccentricity: f64, held: &str, value: f64) -> PyResult<Self> {
        let prescribed = match held {
            "mean_pressure" => Prescribed::MeanPressure(value),
            "penetration" => Prescribed::Penetration(value),
            _ => return Err(unknown("control", held)),
        };
        let memory = ContactMemory::new(&material.0, rate).map_err(refused)?;
        let state = ContactState::new(&memory, WaveContact { half_width, eccentricity }, prescribed).map_err(refused)?;
        Ok(Self { memory, state })
    }

    /// Totals and edge amplitudes.
    fn totals<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let out = PyDict::new(py);
        let (trailing, leading) = self.state.edge_amplitudes();
        for (name, value) in [
            ("mean_pressure", self.state.mean_pressure()),
            ("penetration", self.state.penetration()),
            ("friction_stress", self.state.friction_stress()),
            ("interface_work", self.state.interface_work()),
            ("trailing_amplitude", trailing),
            ("leading_amplitude", leading),
            ("condition", self.state.condition()),
        ] {
            out.set_item(name, value)?;
        }
        Ok(out)
    }

    /// Pressure at y/a between −1 and 1.
    fn pressure<'py>(&self, py: Python<'py>, parts: Numbers) -> PyResult<Bound<'py, PyAny>> {
        let half_width = self.state.contact().half_width;
        mapped(py, &parts, |part| {
            let point = if part < 0.0 {
                self.state.inside_trailing((1.0 + part) * half_width)
            } else {
                self.state.inside_leading((1.0 - part) * half_width)
            };
            Ok(self.state.pressure(point?))
        })
    }

    /// Gap at parts of the opening, from the trailing edge backwards.
    fn gap<'py>(&self, py: Python<'py>, parts: Numbers) -> PyResult<Bound<'py, PyAny>> {
        let open = 2.0 * (std::f64::consts::PI - self.state.contact().half_width);
        mapped(py, &parts, |part| Ok(self.state.gap(self.state.behind_trailing(part * open)?)))
    }

    /// Works (1/2δ)∫ tension gap of the trailing and the leading edge, each moved out by its zone and solved again at the same penetration.
    fn edge_works(&self, zones: [f64; 2]) -> PyResult<[f64; 2]> {
        let WaveContact { half_width, eccentricity } = self.state.contact();
        let held = Prescribed::Penetration(self.state.penetration());
        let work = |edge: Edge, zone: f64| {
            let ahead = if edge == Edge::Leading { 0.5 * zone } else { -0.5 * zone };
            let contact = WaveContact { half_width: half_width + 0.5 * zone, eccentricity: eccentricity + ahead };
            ContactState::new(&self.memory, contact, held).map(|moved| edge_work(&self.state, &moved, edge, zone)).map_err(refused)
        };
        Ok([work(Edge::Trailing, zones[0])?, work(Edge::Leading, zones[1])?])
    }
}

fn put_values(out: &Bound<'_, PyDict>, values: &PartialValues) -> PyResult<()> {
    for (name, value) in [
        ("half_width", values.half_width),
        ("eccentricity", values.eccentricity),
        ("penetration", values.penetration),
        ("mean_pressure", values.mean_pressure),
        ("friction_stress", values.friction_stress),
        ("interface_work", values.interface_work),
    ] {
        out.set_item(name, pair(value))?;
    }
    out.set_item("friction_coefficient", values.friction_coefficient.map(pair))?;
    if let Some(adhesion) = values.adhesion {
        out.set_item("trailing_release", pair(adhesion.trailing_release))?;
        out.set_item("leading_release", pair(adhesion.leading_release))?;
        out.set_item("adhesive_friction_stress", pair(adhesion.adhesive_friction_stress))?;
    }
    Ok(())
}

/// The adhesive contact near given edges, or near the given eccentricity and mean pressure if the half-width is held; to rounding, checked to be admissible.
#[pyfunction]
#[pyo3(signature = (material, rate, edges, held, value, start, tolerance = 1e-12))]
#[expect(clippy::too_many_arguments, reason = "keyword arguments of a Python function")]
fn sliding_equilibrium<'py>(
    py: Python<'py>,
    material: &PyMaterial,
    rate: f64,
    edges: Edges,
    held: &str,
    value: f64,
    start: [f64; 2],
    tolerance: f64,
) -> PyResult<Bound<'py, PyDict>> {
    let memory = Arc::new(ContactMemory::new(&material.0, rate).map_err(refused)?);
    let balance = EdgeBalance::new(memory, Indenter::Wave, Some(adhesion(edges)), control(held, value)?, Resolution::Finest);
    let (found, admissibility) = balance.solve_admissible(start, None, tolerance).map_err(refused)?;
    let releases = balance.releases(&found.solution).map_err(refused)?;
    let state = &found.solution.state;
    let out = PyDict::new(py);
    for (name, value) in [
        ("half_width", state.contact().half_width),
        ("eccentricity", state.contact().eccentricity),
        ("mean_pressure", state.mean_pressure()),
        ("penetration", state.penetration()),
        ("friction_stress", state.friction_stress()),
        ("interface_work", state.interface_work()),
        ("trailing_release", releases.map_or(0.0, |(trailing, _)| trailing.value)),
        ("leading_release", releases.map_or(0.0, |(_, leading)| leading.value)),
        ("residual", found.residual),
    ] {
        out.set_item(name, value)?;
    }
    out.set_item("admissible", admissibility.holds())?;
    Ok(out)
}

/// A steady contact by the path that the program takes; `state` is `partial` or `full`.
#[pyfunction]
#[pyo3(signature = (material, rate, held, value, edges = None, accuracy = 1e-9, indenter = "wave"))]
#[expect(clippy::too_many_arguments, reason = "keyword arguments of a Python function")]
fn sliding_steady<'py>(
    py: Python<'py>,
    material: &PyMaterial,
    rate: f64,
    held: &str,
    value: f64,
    edges: Option<Edges>,
    accuracy: f64,
    indenter: &str,
) -> PyResult<Bound<'py, PyDict>> {
    let indenter = match indenter {
        "wave" => Indenter::Wave,
        "parabola" => Indenter::Parabola,
        _ => return Err(unknown("indenter", indenter)),
    };
    let problem =
        SlidingProblem { rate, indenter, adhesion: edges.map(adhesion), work_by_speed: None, control: control(held, value)?, accuracy };
    let out = PyDict::new(py);
    match steady_sliding(&material.0, &problem).map_err(refused)? {
        SlidingOutcome::Partial(contact) => {
            out.set_item("state", "partial")?;
            out.set_item("admissible", contact.certificate.admissible)?;
            put_values(&out, &contact.values)?;
        }
        SlidingOutcome::Full(full) => {
            out.set_item("state", "full")?;
            out.set_item("friction_stress", pair(full.friction_stress))?;
            out.set_item("limit", (full.limit_name, full.limit))?;
        }
    }
    Ok(out)
}

/// The branch of all loads at a rate: its coarse curve (a, e, p̄, Δ row by row) and its turns (quantity, value, bound).
#[pyfunction]
fn sliding_branch<'py>(py: Python<'py>, material: &PyMaterial, rate: f64, edges: Edges, accuracy: f64) -> PyResult<Bound<'py, PyDict>> {
    let branch = trace(&material.0, &BranchProblem::loads(rate, adhesion(edges), accuracy)).map_err(refused)?;
    let out = PyDict::new(py);
    out.set_item("outline", array(py, &branch.outline().concat())?.call_method1("reshape", (-1, 4))?)?;
    let folds: Vec<(String, f64, f64)> =
        branch.folds.iter().map(|fold| (format!("{:?}", fold.quantity), fold.value.value, fold.value.error)).collect();
    out.set_item("folds", folds)?;
    Ok(out)
}

/// Pull-off, snap-in, separation and toughness at a rate: each (value, bound), or none.
#[pyfunction]
fn sliding_strength<'py>(py: Python<'py>, material: &PyMaterial, rate: f64, edges: Edges, accuracy: f64) -> PyResult<Bound<'py, PyDict>> {
    let found = strength(&material.0, &BranchProblem::loads(rate, adhesion(edges), accuracy)).map_err(refused)?;
    let out = PyDict::new(py);
    out.set_item("pull_off", found.pull_off.as_ref().map(|fold| pair(fold.value)))?;
    out.set_item("snap_in", found.snap_in.as_ref().map(|fold| pair(fold.value)))?;
    out.set_item("separation", found.separation.as_ref().map(|fold| pair(fold.value)))?;
    out.set_item("toughness", found.toughness.as_ref().ok().map(|toughness| pair(toughness.value)))?;
    Ok(out)
}

/// Every contact of a half-width, without a start: half-width, eccentricity, mean pressure, penetration row by row.
#[pyfunction]
fn sliding_contacts_of_width<'py>(
    py: Python<'py>,
    material: &PyMaterial,
    rate: f64,
    edges: Edges,
    half_width: f64,
) -> PyResult<Bound<'py, PyAny>> {
    let found = contacts_of_width(&material.0, &BranchProblem::loads(rate, adhesion(edges), 1e-6), half_width).map_err(refused)?;
    let rows: Vec<f64> = found.iter().flat_map(|one| [one.half_width, one.eccentricity, one.mean_pressure, one.penetration]).collect();
    array(py, &rows)?.call_method1("reshape", (-1, 4))
}

/// Every branch of loads at a rate: the number of points of the outline and of turns of each.
#[pyfunction]
fn sliding_every_branch(material: &PyMaterial, rate: f64, edges: Edges, accuracy: f64) -> PyResult<Vec<(usize, usize)>> {
    let problem = BranchProblem::loads(rate, adhesion(edges), accuracy);
    let found = every_branch(&material.0, &problem, Scan::of(&problem)).map_err(refused)?;
    Ok(found.branches.iter().map(|branch| (branch.outline().len(), branch.folds.len())).collect())
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<SlidingContact>()?;
    module.add_function(wrap_pyfunction!(full_contact, module)?)?;
    module.add_function(wrap_pyfunction!(sliding_equilibrium, module)?)?;
    module.add_function(wrap_pyfunction!(sliding_steady, module)?)?;
    module.add_function(wrap_pyfunction!(sliding_branch, module)?)?;
    module.add_function(wrap_pyfunction!(sliding_strength, module)?)?;
    module.add_function(wrap_pyfunction!(sliding_contacts_of_width, module)?)?;
    module.add_function(wrap_pyfunction!(sliding_every_branch, module)?)
}
