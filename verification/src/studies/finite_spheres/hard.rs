//! Named hard histories: two runs each, the second tighter, and the energy balance of it.

use crate::studies::cells::{count, number, word};
use crate::studies::{Check, Column, Section, Table};
use rayon::prelude::*;
use viscotack::finite_range::law::Law;
use viscotack::finite_range::sphere::{Accuracy, Assessed, Control, Creep, Leg, Mesher, Motion, Problem, Start, assessed};

/// Tolerance of the first run.
const TOLERANCE: f64 = 1e-4;
/// What both runs may differ by in the pull-off or the time of detachment, relative.
const AGREE: f64 = 1e-3;
/// What the energy balance may leave, over the largest energy.
const BALANCE: f64 = 1e-3;

/// A history with its Tabor number, stiffening and number of terms.
struct Case {
    name: &'static str,
    tabor: f64,
    stiffening: f64,
    terms: usize,
    start: f64,
    legs: Vec<Leg>,
}

fn cases() -> Vec<Case> {
    let leg = |control, motion| Leg { control, motion };
    let pull = |from: f64, to: f64, rate: f64| leg(Control::Penetration, Motion::Ramp { to, duration: (from - to) / rate });
    let case = |name, tabor, stiffening, terms, start, legs| Case { name, tabor, stiffening, terms, start, legs };
    let cycles = Motion::Oscillation { amplitude: 2.0, period: 0.5, cycles: 100.0 };
    vec![
        case("Tabor number 0.01, stiffening 1000", 0.01, 1000.0, 1, 3.0, vec![pull(3.0, -8.0, 100.0)]),
        case("Tabor number 9", 9.0, 20.0, 1, 30.0, vec![pull(30.0, -60.0, 4.0)]),
        case("twelve terms, stiffening 1000", 1.0, 1000.0, 12, 8.0, vec![pull(8.0, -40.0, 10.0)]),
        case("frozen body, rate 1e6", 2.9, 12.0, 1, 6.0, vec![pull(6.0, -16.0, 1e6)]),
        case(
            "pulled by a force to detachment",
            1.5,
            30.0,
            3,
            5.0,
            vec![leg(Control::Force, Motion::Ramp { to: -40.0, duration: 20.0 }), leg(Control::Force, Motion::Hold(1e4))],
        ),
        case("a hundred cycles", 1.0, 20.0, 3, 6.0, vec![leg(Control::Penetration, cycles), pull(6.0, -12.0, 4.0)]),
        case("rest of 1e6 times", 1.2, 100.0, 3, 6.0, vec![leg(Control::Penetration, Motion::Hold(1e6)), pull(6.0, -16.0, 50.0)]),
        case("relaxed Tabor number 100", 100.0, 1000.0, 1, 100.0, vec![pull(100.0, -600.0, 1e3)]),
    ]
}

impl Case {
    fn problem(&self) -> Problem {
        let weight = 1.0 / self.terms as f64;
        let times = (0..self.terms).map(|k| 10_f64.powf(0.5 * (k as f64 - 0.5 * (self.terms - 1) as f64))).collect();
        let creep = Creep { stiffening: self.stiffening, fractions: vec![weight; self.terms], times };
        Problem::new(Law::LennardJones, self.tabor, creep, Start::Relaxed(self.start), self.legs.clone())
    }
}

/// By how much both runs differ, and what the balance of the second leaves.
fn compared(found: &Assessed) -> (f64, f64) {
    let force = found.run.pull_off_force().abs().max(1.0);
    let off = found.legs.iter().map(|leg| leg.largest_tension / force).fold(0.0, f64::max);
    let ended = found.detachment_time.zip(found.run.detachment).map_or(0.0, |(bound, row)| bound / row.time);
    (off.max(ended), found.run.certificate.energy_residual / found.run.certificate.energy_scale.max(1.0))
}

/// Adds the cases to the section of the study.
pub(super) fn add_to(section: &mut Section) {
    let columns = vec![
        Column::words("history"),
        Column::new("change of the pull-off or of the time of detachment", "1"),
        Column::new("energy defect", "1"),
        Column::new("steps", "1"),
        Column::new("nodes", "1"),
    ];
    let mut table = Table::new("hard_histories", "Hard histories: two runs, the second with every tolerance tightened.", columns);
    let all: Vec<_> = cases()
        .into_par_iter()
        .map(|case| {
            let accuracy = Accuracy::new(TOLERANCE);
            let found = assessed(&case.problem(), accuracy, &mut Mesher::new(accuracy.order));
            (case.name, found)
        })
        .collect();
    for (name, found) in all {
        let wanted = format!("both runs have the same events and agree within {AGREE:e}; energy is balanced within {BALANCE:e}");
        match found {
            Ok(found) => {
                let (change, defect) = compared(&found);
                let sound = found.consistent && change < AGREE && defect < BALANCE;
                section.checks.push(Check::new(name, wanted, format!("{change:.1e} and {defect:.1e}"), sound));
                let certificate = found.run.certificate;
                table.rows.push(vec![word(name), number(change), number(defect), count(certificate.steps), count(certificate.nodes)]);
            }
            Err(refusal) => section.checks.push(Check::new(name, wanted, refusal.to_string(), false)),
        }
    }
    section.tables.push(table);
}
