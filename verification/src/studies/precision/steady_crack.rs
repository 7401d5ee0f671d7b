//! G(v) of a twelve-term solid: the collapsed closure beside the double integral as printed.

use super::{Diagram, Method, Sample};
use crate::rivals::raw_crack_work::RawCrackWork;
use crate::studies::reference::{Row, STEADY_CRACK, STEADY_CRACK_MATERIALS, rows};
use crate::studies::section::{Check, Effort, Progress, Section};
use crate::studies::timing::{Timed, timed};
use viscotack::crack::virtual_work::VirtualWork;
use viscotack::crack::{CrackBody, Interface, Motion, ProcessZone, SteadyCurve, at_speed};
use viscotack::material::{CreepTerm, PlaneMaterial, RelaxationTerm};
use viscotack::refusal::Refusal;

/// A material of the reference file.
fn material(name: &str) -> Result<PlaneMaterial, Refusal> {
    let all = rows(STEADY_CRACK_MATERIALS);
    let of = |key: &str| -> Vec<f64> {
        all.iter().filter(|row| row.text("material") == name && row.text("key") == key).map(|row| row.number("value")).collect()
    };
    let first = |key: &str| of(key).first().copied();
    if let Some(glassy) = first("glassy_modulus") {
        let terms: Vec<CreepTerm> = of("creep_strength")
            .into_iter()
            .zip(of("retardation_time"))
            .map(|(compliance, retardation_time)| CreepTerm { compliance, retardation_time })
            .collect();
        return PlaneMaterial::from_creep(glassy, &terms, first("flow_viscosity"));
    }
    let terms: Vec<RelaxationTerm> = of("relaxation_strength")
        .into_iter()
        .zip(of("relaxation_time"))
        .map(|(modulus, relaxation_time)| RelaxationTerm { modulus, relaxation_time })
        .collect();
    PlaneMaterial::from_relaxation(first("relaxed_modulus").unwrap_or(f64::NAN), &terms)
}

/// One speed: v, its interface, G/Δγ.
struct Asked {
    speed: f64,
    interface: Interface,
    truth: f64,
}

fn asked(name: &str, motion: &str) -> Vec<Asked> {
    let of = |row: &Row| Asked {
        speed: row.number("speed"),
        interface: Interface {
            work_of_adhesion: row.number("work_of_adhesion"),
            process_zone: ProcessZone::Growing { cohesive_stress: row.number("cohesive_stress"), factor: row.number("alpha") },
            body: CrackBody::AgainstRigid,
        },
        truth: row.number("value"),
    };
    let wanted = |row: &&Row| {
        row.text("material") == name
            && row.text("motion") == motion
            && row.text("process_zone") == "growing"
            && row.text("model") == "energy_closure"
            && row.text("quantity") == "energy_release_rate_ratio"
    };
    rows(STEADY_CRACK).iter().filter(wanted).map(of).collect()
}

/// The largest relative error over all speeds; points of the curve and kernels.
type ErrorAndWork = (f64, [u64; 2]);

fn solved<C: SteadyCurve>(
    asked: &[Asked],
    tolerance: f64,
    curve: impl Fn(Interface) -> Result<C, Refusal>,
) -> Result<ErrorAndWork, Refusal> {
    let (mut worst, mut work) = (0.0_f64, [0, 0]);
    for one in asked {
        let state = at_speed(&curve(one.interface)?, one.speed, tolerance)?;
        let found = state.energy_release_rate_ratio.map_or(f64::NAN, |ratio| ratio.value);
        let error = (found / one.truth - 1.0).abs();
        worst = if error.is_nan() { f64::INFINITY } else { worst.max(error) };
        work[0] += state.curve_points;
        work[1] += state.kernel_evaluations;
    }
    Ok((worst, work))
}

fn diagram(name: &str, words: &'static str, motion: Motion, identifier: &'static str, effort: Effort) -> Result<Diagram, Refusal> {
    let material = material(name)?;
    let asked: Vec<Asked> = asked(name, words).into_iter().step_by(effort.choose(4, 1)).collect();
    if asked.is_empty() {
        return Err(Refusal::Undefined { quantity: "the stored cracks", reason: format!("no rows of {name}") });
    }
    let sample = |tolerance: f64, Timed { seconds, runs, result: found }: Timed<Result<ErrorAndWork, Refusal>>| {
        // Full and reduced studies take different speeds: work over both would have one name.
        let setting = format!("{tolerance:.0e}, {} speeds", asked.len());
        let seconds = seconds / asked.len() as f64;
        match found {
            Ok((error, [points, kernels])) => Sample {
                setting,
                seconds,
                runs,
                counted: vec![("kernels", kernels as f64), ("points of the curve", points as f64)],
                error: Ok(error),
            },
            Err(refusal) => Sample { setting, seconds, runs, counted: Vec::new(), error: Err(refusal.to_string()) },
        }
    };
    let own = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-15].map(|tolerance| {
        sample(tolerance, timed(|| solved(&asked, tolerance, |interface| VirtualWork::new(&material, motion, interface))))
    });
    let tolerances = effort.choose(vec![1e-2, 1e-4, 1e-6], vec![1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12]);
    let theirs = tolerances
        .into_iter()
        .map(|tolerance| {
            sample(
                tolerance,
                timed(|| solved(&asked, tolerance, |interface| RawCrackWork::new(&material, motion, interface, 0.1 * tolerance))),
            )
        })
        .collect();
    Ok(Diagram {
        identifier: identifier.to_owned(),
        caption: format!(
            "G(v) of a {words} crack in a solid of twelve terms, growing process zone, {} speeds: largest relative error against nested quadrature at 32 digits (stored).",
            asked.len()
        ),
        error: r"largest error of $G$",
        counted: "kernel evaluations, all speeds",
        methods: vec![
            Method { name: "this program, collapsed".into(), own: true, samples: own.to_vec() },
            Method { name: "raw double integral".into(), own: false, samples: theirs },
        ],
        headline: false,
    })
}

pub(in crate::studies) fn study(effort: Effort, progress: &Progress) -> Section {
    let mut section = Section::new("precision_steady_crack", "Work and precision: steady cracks");
    progress.expect(2);
    section.say(
        "The same root is sought along the same curve; what differs is a point of it: one running mean of the memory in closed form, or the double integral as the thesis prints it. \
         The time is of one speed. With the closed form an accuracy costs next to nothing: the tolerance is that of the root.",
    );
    let cases = [
        ("creep_12_beta1e3", "opening", Motion::Opening, "steady_crack_opening"),
        ("relaxation_12_beta1e3", "closing", Motion::Closing, "steady_crack_closing"),
    ];
    for (name, words, motion, identifier) in cases {
        match diagram(name, words, motion, identifier, effort) {
            Ok(diagram) => diagram.into_section(&mut section),
            Err(refusal) => section.checks.push(Check::new(identifier, "every speed is solved", refusal.to_string(), false)),
        }
        progress.advance(1);
    }
    section
}
