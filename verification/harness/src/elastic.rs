//! Elastic closed forms.

use crate::arrays::{pair, refused, unknown};
use pyo3::prelude::*;
use viscotack::Estimate;
use viscotack::elastic::johnson_wave::WaveBranch;
use viscotack::elastic::westergaard_wave::WaveState;
use viscotack::elastic::{Control, EquilibriumBranch, HertzSphere, JkrSphere, JohnsonWave, KendallPunch, TaborNumber, WestergaardWave};

/// Half-width and gap half-width, each with its bound, mean pressure, penetration.
type WaveNumbers = ((f64, f64), (f64, f64), f64, f64);

fn branch(word: &str) -> PyResult<EquilibriumBranch> {
    match word {
        "stable" => Ok(EquilibriumBranch::Stable),
        "unstable" => Ok(EquilibriumBranch::Unstable),
        _ => Err(unknown("branch", word)),
    }
}

/// (contact radius with its bound, penetration, force) of a JKR sphere held at a `force` or a `penetration`.
#[pyfunction]
fn jkr(radius: f64, modulus: f64, work_of_adhesion: f64, held: &str, value: f64, branch_word: &str) -> PyResult<((f64, f64), f64, f64)> {
    let sphere = JkrSphere::new(radius, modulus, work_of_adhesion).map_err(refused)?;
    let branch = branch(branch_word)?;
    let state = match held {
        "force" => sphere.state_by_force(value, branch),
        "penetration" => sphere.state_by_penetration(value, branch),
        _ => return Err(unknown("control", held)),
    }
    .map_err(refused)?;
    Ok((pair(Estimate::relative(state.contact_radius, state.relative_error)), state.penetration, state.force))
}

/// (contact radius, penetration, force) of a Hertz sphere held at a force.
#[pyfunction]
fn hertz(radius: f64, modulus: f64, force: f64) -> PyResult<(f64, f64, f64)> {
    let state = HertzSphere::new(radius, modulus).and_then(|sphere| sphere.state_by_force(force)).map_err(refused)?;
    Ok((state.contact_radius, state.penetration, state.force))
}

/// Pull-off force of a flat punch.
#[pyfunction]
fn kendall_pull_off(radius: f64, modulus: f64, work_of_adhesion: f64) -> PyResult<f64> {
    KendallPunch::new(radius, modulus, work_of_adhesion).and_then(|punch| punch.pull_off_force()).map_err(refused)
}

/// (half-width with its bound, gap half-width with its bound, mean pressure, penetration) of an adhesive wave. `asked`: `mean_pressure`,
/// `penetration` or `half_width` with a value and, of the first two, a branch; or `pull_off`, `separation`, `snap_in`.
#[pyfunction]
#[pyo3(signature = (modulus, wavelength, amplitude, work_of_adhesion, asked, value = 0.0, branch_word = "stable"))]
fn johnson_wave(
    modulus: f64,
    wavelength: f64,
    amplitude: f64,
    work_of_adhesion: f64,
    asked: &str,
    value: f64,
    branch_word: &str,
) -> PyResult<WaveNumbers> {
    let wave =
        WestergaardWave::new(modulus, wavelength, amplitude).and_then(|wave| JohnsonWave::new(wave, work_of_adhesion)).map_err(refused)?;
    let state: WaveState = match asked {
        "mean_pressure" => {
            let branch = match branch_word {
                "stable" => WaveBranch::Stable,
                "narrow" => WaveBranch::Narrow,
                "wide" => WaveBranch::Wide,
                _ => return Err(unknown("branch", branch_word)),
            };
            wave.state_by_mean_pressure(value, branch)
        }
        "penetration" => wave.state_by_penetration(value, branch(branch_word)?),
        "half_width" => wave.state_by_contact_half_width(value),
        "pull_off" => wave.pull_off(Control::Load),
        "separation" => wave.pull_off(Control::Penetration),
        "snap_in" => wave.snap_in(),
        _ => return Err(unknown("control", asked)),
    }
    .map_err(refused)?;
    Ok((
        pair(Estimate::relative(state.contact_half_width, state.relative_error)),
        pair(Estimate::relative(state.gap_half_width, state.relative_error)),
        state.mean_pressure,
        state.penetration,
    ))
}

/// (half-width, penetration) of a wave without adhesion under a mean pressure.
#[pyfunction]
fn westergaard_wave(modulus: f64, wavelength: f64, amplitude: f64, mean_pressure: f64) -> PyResult<(f64, f64)> {
    let state = WestergaardWave::new(modulus, wavelength, amplitude).and_then(|wave| wave.state_by_mean_pressure(mean_pressure));
    state.map(|state| (state.contact_half_width, state.penetration)).map_err(refused)
}

/// Tabor's number.
#[pyfunction]
fn tabor_number(radius: f64, modulus: f64, work_of_adhesion: f64, interaction_range: f64) -> PyResult<f64> {
    TaborNumber::new(radius, modulus, work_of_adhesion, interaction_range).map(TaborNumber::value).map_err(refused)
}

/// Gap of an adhesive wave of a contact half-width at a position.
#[pyfunction]
fn johnson_wave_gap(modulus: f64, wavelength: f64, amplitude: f64, work_of_adhesion: f64, half_width: f64, position: f64) -> PyResult<f64> {
    let wave =
        WestergaardWave::new(modulus, wavelength, amplitude).and_then(|wave| JohnsonWave::new(wave, work_of_adhesion)).map_err(refused)?;
    wave.gap(half_width, position).map_err(refused)
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(jkr, module)?)?;
    module.add_function(wrap_pyfunction!(hertz, module)?)?;
    module.add_function(wrap_pyfunction!(kendall_pull_off, module)?)?;
    module.add_function(wrap_pyfunction!(johnson_wave, module)?)?;
    module.add_function(wrap_pyfunction!(johnson_wave_gap, module)?)?;
    module.add_function(wrap_pyfunction!(westergaard_wave, module)?)?;
    module.add_function(wrap_pyfunction!(tabor_number, module)?)
}
