//! Sliding states under a held load, penetration or half-width, compared with all contacts of all half-widths.
//!
//! ```text
//! conics     the common points of two conics: all of them
//! width      ──► all contacts of a half-width                        no start, no path
//! curve      ──► all contacts of a speed, joined
//! pieces     ──► cut at the turns of the load (or depth)             limits
//! stability  ──► which of them stay, by second variations
//! states     ──► which contact a held value has, and its limits      compared with the solver (answer)
//! ```
//! The comparison shares the fields of a contact with given edges with the solver (they have references of their own: `reference_data/sliding_wave.csv`), and nothing
//! of the way to the edges: no continuation in speed or load, no choice of a root.

pub mod answer;
pub mod conics;
pub mod curve;
pub mod draws;
pub mod pieces;
pub mod stability;
pub mod states;
pub mod width;

use super::cells::{count, number, word};
use super::draw::Draw;
use super::{Check, Column, Effort, Progress, Section, Table};
use answer::{Answer, FRAME, answer};
use draws::{Asked, CONTROLS, Control, Drawn, asked, drawn};
use rayon::prelude::*;
use stability::Held;
use states::{Expected, Reached, Speed};
use viscotack::estimate::Estimate;
use viscotack::sliding::steady::{PartialValues, SlidingControl, SlidingProblem};
use width::Equilibrium;

/// The seed of the problems that are reported.
pub const SEED: u64 = 0x36_51de_c017;
/// The seed of problems to develop with: never reported.
pub const TUNING_SEED: u64 = 0x36_51de_7e57;
/// States of a problem.
const STATES: usize = 20;
/// Accuracy that is asked for.
const ACCURACY: f64 = 1e-6;
/// Another contact is shown by a half-width that is further off, relative to it.
const SAME: f64 = 1e-3;
/// A limit may be off by this part of it.
const LIMIT: f64 = 1e-3;
/// A margin of stability nearer to zero is not compared.
const MARGIN: f64 = 1e-4;
/// What the compared values are uncertain by themselves, over their scale.
const KNOWN: f64 = 1e-8;
/// Failures that are listed.
const LISTED: usize = 200;

/// How a state came out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Fault {
    /// Another contact than the right one, or a contact where there is none.
    Wrong,
    /// Refused, or not converged, where there is a contact.
    FalselyRefused,
    /// Full contact where there is a partial one.
    FalselyFull,
    /// Full contact or refused as it should be, with a limit that is not that of this speed.
    WrongLimit,
    /// Reported stable where it is not, or the other way round.
    WrongStability,
    /// The number of other stable contacts is wrong.
    Alternatives,
    /// A bound does not cover the error.
    Bound,
}

/// Names of the faults in the tables.
pub const FAULTS: [(Fault, &str); 7] = [
    (Fault::Wrong, "wrong contact"),
    (Fault::FalselyRefused, "falsely refused"),
    (Fault::FalselyFull, "falsely full"),
    (Fault::WrongLimit, "wrong limit"),
    (Fault::WrongStability, "wrong stability"),
    (Fault::Alternatives, "wrong number of others"),
    (Fault::Bound, "bound does not cover the error"),
];

/// A compared state.
#[derive(Debug, Clone)]
pub struct Compared {
    /// The problem.
    pub problem: u64,
    /// What was asked.
    pub asked: Asked,
    /// What is wrong; none if nothing is.
    pub fault: Option<Fault>,
    /// In words, of a fault.
    pub detail: String,
    /// Whether nothing could be compared.
    pub unknown: bool,
    /// Bound over error of the values, where the error is above what is known.
    pub ratios: Vec<f64>,
}

/// What a problem came to.
#[derive(Debug, Clone, Default)]
pub struct Assessed {
    /// Its states.
    pub states: Vec<Compared>,
    /// In words.
    pub described: String,
    /// Half-widths computed.
    pub rows: usize,
    /// Segments of contacts stable under their load.
    pub stable: usize,
    /// Pieces whose stability changes between two turns of what is held.
    pub changes: usize,
}

/// Draws a problem and its states, and compares all of them.
#[must_use]
pub fn assessed(seed: u64, problem: u64) -> Assessed {
    let mut draw = Draw::of(seed, problem);
    let Ok(drawn) = drawn(&mut draw) else { return Assessed::default() };
    let Ok(speed) = drawn.speed() else { return Assessed { described: drawn.described, ..Assessed::default() } };
    let states = (0..STATES).filter_map(|_| asked(&mut draw, &speed)).map(|asked| compared(problem, &drawn, &speed, asked)).collect();
    Assessed { states, described: drawn.described.clone(), rows: speed.rows, stable: speed.by_load.len(), changes: speed.changes }
}

fn control(asked: Asked) -> SlidingControl {
    match asked.control {
        Control::MeanPressure | Control::LoadPerWidth => SlidingControl::MeanPressure(asked.value),
        Control::Penetration => SlidingControl::Penetration(asked.value),
        Control::HalfWidth => SlidingControl::HalfWidth(asked.value),
    }
}

/// Asks the solver and compares.
#[must_use]
pub fn compared(problem: u64, drawn: &Drawn, speed: &Speed, asked: Asked) -> Compared {
    let given = SlidingProblem {
        rate: drawn.rate,
        indenter: drawn.indenter,
        adhesion: drawn.adhesion,
        work_by_speed: None,
        control: control(asked),
        accuracy: ACCURACY,
    };
    against(problem, speed, asked, &answer(&drawn.material, &given, asked.reached))
}

/// Compares an answer, from wherever it comes.
#[must_use]
pub fn against(problem: u64, speed: &Speed, asked: Asked, found: &Answer) -> Compared {
    let mut compared = Compared { problem, asked, fault: None, detail: String::new(), unknown: false, ratios: Vec::new() };
    if asked.control == Control::HalfWidth {
        of_width(&mut compared, speed, found);
        return compared;
    }
    let held = if asked.control == Control::Penetration { Held::Penetration } else { Held::Load };
    let expected = speed.expected(held, asked.value, asked.reached);
    let fail = |compared: &mut Compared, fault: Fault| {
        compared.fault = Some(fault);
        compared.detail = format!("{}; right: {}", in_words(found), right(&expected));
    };
    match (&expected, found) {
        (Expected::Unknown, _) => compared.unknown = true,
        (Expected::Contact { contact, others }, Answer::Contact { values, stable, others: reported }) => {
            if off(values, contact) > SAME {
                fail(&mut compared, Fault::Wrong);
                return compared;
            }
            let contradicted = |reported: Option<bool>, held: Held| {
                let margin = || if speed.bodies.adhesion.is_some() { speed.margin(contact, held) } else { 1.0 };
                reported.is_some_and(|reported| {
                    let margin = margin();
                    margin.abs() > MARGIN && reported != (margin > 0.0)
                })
            };
            let each = [Held::Load, Held::Penetration, Held::Frame(FRAME)];
            if stable.iter().zip(each).any(|(reported, held)| contradicted(*reported, held)) {
                fail(&mut compared, Fault::WrongStability);
            } else if reported.is_some_and(|reported| reported != *others) {
                fail(&mut compared, Fault::Alternatives);
            }
            bounds(&mut compared, values, contact);
        }
        (Expected::Contact { .. }, Answer::Full(_)) => fail(&mut compared, Fault::FalselyFull),
        (Expected::Contact { .. }, Answer::Nothing(_) | Answer::Failed(_)) => fail(&mut compared, Fault::FalselyRefused),
        (Expected::Full(limit), Answer::Full(reported)) | (Expected::Nothing(limit), Answer::Nothing(reported)) => {
            if !near(*reported, *limit) {
                fail(&mut compared, Fault::WrongLimit);
            }
        }
        // Full contact has one penetration only: beyond the limit of a held penetration it may be named or refused, with the limit of this speed.
        (Expected::Full(limit) | Expected::Nothing(limit), Answer::Full(reported) | Answer::Nothing(reported))
            if held == Held::Penetration && asked.value > *limit =>
        {
            if !near(*reported, *limit) {
                fail(&mut compared, Fault::WrongLimit);
            }
        }
        (Expected::NoPartial, Answer::Full(_) | Answer::Nothing(_)) => {}
        (Expected::NoPartial, Answer::Contact { .. }) => fail(&mut compared, Fault::Wrong),
        (Expected::NoPartial, Answer::Failed(_)) => fail(&mut compared, Fault::FalselyRefused),
        (Expected::Full(_), Answer::Nothing(_) | Answer::Failed(_)) => fail(&mut compared, Fault::FalselyRefused),
        (Expected::Nothing(_), Answer::Full(_)) => fail(&mut compared, Fault::FalselyFull),
        (Expected::Nothing(_), Answer::Failed(_)) => fail(&mut compared, Fault::WrongLimit),
        (Expected::Full(_) | Expected::Nothing(_), Answer::Contact { .. }) => fail(&mut compared, Fault::Wrong),
    }
    compared
}

fn near(reported: f64, limit: f64) -> bool {
    (reported - limit).abs() <= LIMIT * limit.abs().max(1e-2)
}

/// At a held half-width any contact of it is right, a stable one where there is one.
fn of_width(compared: &mut Compared, speed: &Speed, found: &Answer) {
    let contacts = speed.of_width(compared.asked.value);
    let stable = |contact: &&Equilibrium| speed.bodies.adhesion.is_none() || speed.margin(contact, Held::Load) > MARGIN;
    let listed = || {
        contacts
            .iter()
            .map(|contact| format!("e {:.6} p {:.6e}", contact.eccentricity, contact.mean_pressure))
            .collect::<Vec<_>>()
            .join(", ")
    };
    let fault = match found {
        Answer::Contact { values, .. } => {
            let same = |contact: &&Equilibrium| off(values, contact) < SAME;
            match contacts.iter().find(same) {
                Some(contact) => {
                    let any = contacts.iter().any(|contact| stable(&contact));
                    bounds(compared, values, contact);
                    (any && !stable(&contact)).then_some(Fault::Wrong)
                }
                None => Some(Fault::Wrong),
            }
        }
        _ if contacts.is_empty() => {
            compared.unknown = true;
            None
        }
        Answer::Full(_) => Some(Fault::FalselyFull),
        _ => Some(Fault::FalselyRefused),
    };
    if let Some(fault) = fault {
        compared.fault = Some(fault);
        compared.detail = format!("{}; right: {}", in_words(found), listed());
    }
}

/// How far a contact is from another one, over its own size.
fn off(values: &PartialValues, contact: &Equilibrium) -> f64 {
    let width = (values.half_width.value - contact.half_width).abs() / contact.half_width;
    let ahead = (values.eccentricity.value - contact.eccentricity).abs() / contact.half_width.min(1.0);
    let load = (values.mean_pressure.value - contact.mean_pressure).abs() / (contact.mean_pressure.abs() + contact.half_width.powi(2));
    width.max(ahead).max(load)
}

/// Bounds against errors.
fn bounds(compared: &mut Compared, values: &PartialValues, contact: &Equilibrium) {
    let pairs: [(&str, Estimate, f64); 5] = [
        ("half-width", values.half_width, contact.half_width),
        ("eccentricity", values.eccentricity, contact.eccentricity),
        ("penetration", values.penetration, contact.penetration),
        ("mean pressure", values.mean_pressure, contact.mean_pressure),
        ("friction stress", values.friction_stress, contact.friction_stress),
    ];
    for (name, found, right) in pairs {
        let error = (found.value - right).abs();
        let known = KNOWN * right.abs().max(1e-2);
        if error > known {
            compared.ratios.push(found.error / error);
        }
        if (error > found.error + known || error.is_nan()) && compared.fault.is_none() {
            compared.fault = Some(Fault::Bound);
            compared.detail = format!("{name} {:.12e} ± {:.1e}, right: {right:.12e}", found.value, found.error);
        }
    }
}

fn in_words(answer: &Answer) -> String {
    match answer {
        Answer::Contact { values, stable, others } => format!(
            "a {:.6} e {:.6} p {:.6e} (stable {stable:?}, others {others:?})",
            values.half_width.value, values.eccentricity.value, values.mean_pressure.value
        ),
        Answer::Full(limit) => format!("full, limit {limit:.6e}"),
        Answer::Nothing(limit) => format!("refused, limit {limit:.6e}"),
        Answer::Failed(reason) => reason.clone(),
    }
}

fn right(expected: &Expected) -> String {
    match expected {
        Expected::Contact { contact, others } => {
            format!(
                "a {:.6} e {:.6} p {:.6e} Δ {:.6} ({others} other)",
                contact.half_width, contact.eccentricity, contact.mean_pressure, contact.penetration
            )
        }
        Expected::Full(limit) => format!("full, limit {limit:.6e}"),
        Expected::Nothing(limit) => format!("none, limit {limit:.6e}"),
        Expected::NoPartial => "no partial contact at this speed".into(),
        Expected::Unknown => "not known".into(),
    }
}

/// The section of `viscotack verify`.
#[must_use]
pub fn study(effort: Effort, progress: &Progress) -> Section {
    let problems: u64 = effort.choose(40, 1010);
    progress.expect(problems);
    let all: Vec<Assessed> = (0..problems)
        .into_par_iter()
        .map(|problem| {
            let assessed = assessed(SEED, problem);
            progress.advance(1);
            assessed
        })
        .collect();
    section(&all)
}

/// Tables and checks of compared problems.
#[must_use]
pub fn section(all: &[Assessed]) -> Section {
    let mut section = Section::new("held_contacts", "Sliding: the contact that is held");
    let states: Vec<&Compared> = all.iter().flat_map(|assessed| &assessed.states).collect();
    let rows: usize = all.iter().map(|assessed| assessed.rows).sum();
    section.say(format!(
        "{} sliding states of {} random problems (β 1.2 to 1000, 1 to 6 terms, Γ 3e-4 to 0.05, δ 1e-5 to 0.05, sliding ratio 1e-3 to 1e4; waves and cylinders, equal and unequal works and \
         zones, one in ten without adhesion), most of them near a limit of what is held. Each is compared with all contacts of all half-widths: at {rows} half-widths the contacts are the common \
         points of two conics, found by algebra; which of them stay follows from second variations by differences. Nothing is followed from a known contact.",
        states.len(),
        all.len()
    ));
    let several = all.iter().filter(|assessed| assessed.stable > 1).count();
    let changes: usize = all.iter().map(|assessed| assessed.changes).sum();
    section.say(format!(
        "{several} of the problems have more than one segment of contacts that are stable under their load; on {changes} segments stability changes where neither load nor penetration turns."
    ));
    let mut table = Table::new(
        "counts",
        "States by what is held, and what was wrong.",
        [
            vec![Column::words("held"), Column::words("reached by"), Column::new("states", "1"), Column::new("not compared", "1")],
            FAULTS.iter().map(|(_, name)| Column::new(*name, "1")).collect(),
        ]
        .concat(),
    );
    for (control, name) in CONTROLS {
        for (reached, by) in [(Reached::Loading, "loading"), (Reached::Unloading, "unloading")] {
            let these: Vec<&&Compared> =
                states.iter().filter(|state| state.asked.control == control && state.asked.reached == reached).collect();
            let mut row = vec![word(name), word(by), count(these.len()), count(these.iter().filter(|state| state.unknown).count())];
            row.extend(FAULTS.iter().map(|(fault, _)| count(these.iter().filter(|state| state.fault == Some(*fault)).count())));
            table.rows.push(row);
        }
    }
    section.tables.push(table);
    let mut ratios: Vec<f64> = states.iter().flat_map(|state| state.ratios.iter().copied()).collect();
    ratios.sort_by(f64::total_cmp);
    let quantile = |part: f64| ratios.get((part * ratios.len().saturating_sub(1) as f64) as usize).copied().unwrap_or(f64::NAN);
    let mut table = Table::new(
        "bounds",
        "Bound over error, where the error is above 1e-8 of the value.",
        vec![Column::new("values", "1"), Column::new("least", "1"), Column::new("median", "1"), Column::new("95th percentile", "1")],
    );
    table.rows.push(vec![count(ratios.len()), number(quantile(0.0)), number(quantile(0.5)), number(quantile(0.95))]);
    section.tables.push(table);
    let mut table = Table::new(
        "faults",
        format!("What was wrong (at most {LISTED})."),
        vec![
            Column::new("problem", "1"),
            Column::words("material and adhesion"),
            Column::words("held"),
            Column::new("value", "1"),
            Column::words("reached by"),
            Column::words("fault"),
            Column::words("found; right"),
        ],
    )
    .folded();
    for assessed in all {
        for state in assessed.states.iter().filter(|state| state.fault.is_some()) {
            if table.rows.len() < LISTED {
                let name = |fault: Option<Fault>| FAULTS.iter().find(|(kind, _)| Some(*kind) == fault).map_or("", |(_, name)| *name);
                let held = CONTROLS.iter().find(|(control, _)| *control == state.asked.control).map_or("", |(_, name)| *name);
                table.rows.push(vec![
                    number(state.problem as f64),
                    word(&assessed.described),
                    word(held),
                    number(state.asked.value),
                    word(if state.asked.reached == Reached::Loading { "loading" } else { "unloading" }),
                    word(name(state.fault)),
                    word(&state.detail),
                ]);
            }
        }
    }
    section.tables.push(table);
    for (fault, name) in FAULTS {
        let found = states.iter().filter(|state| state.fault == Some(fault)).count();
        section.checks.push(Check::new(name, "none", format!("{found} of {}", states.len()), found == 0 && !states.is_empty()));
    }
    let unknown = states.iter().filter(|state| state.unknown).count();
    section.checks.push(Check::new(
        "states that could not be compared",
        "fewer than one in ten: their contact has a gap narrower than three zones",
        format!("{unknown} of {}", states.len()),
        unknown * 10 < states.len(),
    ));
    section
}
