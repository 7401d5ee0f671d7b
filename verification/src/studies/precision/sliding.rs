//! An adhesive contact on a sliding wave: all methods look for the edges that a stored Chebyshev collocation of another program has.

use super::{Diagram, Method, Sample};
use crate::rivals::sliding_collocation::richardson::extrapolated;
use crate::rivals::sliding_collocation::{Layout, SlidingCollocation};
use crate::studies::convergence::stored_sliding::material_of;
use crate::studies::reference::{SLIDING_WAVE, rows};
use crate::studies::section::{Check, Effort, Progress, Section};
use crate::studies::timing::{Timed, timed};
use viscotack::material::PlaneMaterial;
use viscotack::refusal::Refusal;
use viscotack::sliding::contact::{ContactMemory, Prescribed, WaveContact};
use viscotack::sliding::steady::{
    Indenter, PartialValues, SlidingControl, SlidingOutcome, SlidingProblem, Start, WaveAdhesion, steady_sliding, steady_sliding_near,
};

/// a, e, Δ, friction stress, G₁, G₂.
type Numbers = [f64; 6];
/// The numbers of a contact, none for full contact, with evaluations of both closures and contacts solved.
type Values = (Option<Numbers>, [u64; 2]);
const QUANTITIES: [&str; 5] = ["eccentricity", "penetration", "friction_stress", "trailing_release", "leading_release"];
/// Orders of the aligned collocation, removed in turn.
const ORDERS: [f64; 3] = [3.0, 3.0, 4.0];
/// What is drawn as work: the linear systems of all evaluations, a dense one costing the cube of its unknowns.
const UNKNOWNS: &str = "unknowns of all linear systems";
const ACCURACIES: [f64; 7] = [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-11, 1e-12];

/// A stored contact of another program.
pub(super) struct State {
    pub(super) material: PlaneMaterial,
    pub(super) memory: ContactMemory,
    pub(super) adhesion: WaveAdhesion,
    pub(super) pressure: f64,
    truth: Numbers,
}

impl State {
    pub(super) fn stored(case: &str) -> Result<Self, Refusal> {
        let all = rows(SLIDING_WAVE);
        let own = || all.iter().filter(|row| row.text("asked") == "equilibrium" && row.text("case") == case);
        let value = |quantity: &str| own().find(|row| row.text("quantity") == quantity).map_or(f64::NAN, |row| row.number("value"));
        let row = own().next().ok_or_else(|| Refusal::Undefined { quantity: "the stored contact", reason: format!("no case {case}") })?;
        let material = material_of(row)?;
        let memory = ContactMemory::new(&material, 1.0)?;
        let mut truth = [row.number("a"); 6];
        truth.iter_mut().skip(1).zip(QUANTITIES).for_each(|(number, quantity)| *number = value(quantity));
        let adhesion = WaveAdhesion::even(value("reduced_work"), row.number("zone"));
        Ok(Self { material, memory, adhesion, pressure: row.number("mean_pressure"), truth })
    }

    /// One percent off: the warm start of a sweep, and all that the rivals get.
    pub(super) fn start(&self) -> WaveContact {
        WaveContact { half_width: 0.99 * self.truth[0], eccentricity: self.truth[1] + 0.005 }
    }

    pub(super) fn problem(&self, accuracy: f64) -> SlidingProblem<'static> {
        SlidingProblem {
            rate: 1.0,
            indenter: Indenter::Wave,
            adhesion: Some(self.adhesion),
            work_by_speed: None,
            control: SlidingControl::MeanPressure(self.pressure),
            accuracy,
        }
    }

    fn error(&self, numbers: &Numbers) -> f64 {
        numbers
            .iter()
            .zip(&self.truth)
            .map(|(value, truth)| (value - truth).abs() / truth.abs().max(1.0))
            .fold(0.0, |worst: f64, error| if error.is_nan() { f64::INFINITY } else { worst.max(error) })
    }

    fn collocated(&self, layout: Layout, elements: usize, density: f64, tolerance: f64) -> Result<(Numbers, u32), Refusal> {
        let scheme = SlidingCollocation::new(self.memory.kernel(), layout, elements, density)?;
        let found = scheme.equilibrium(&self.adhesion, Prescribed::MeanPressure(self.pressure), self.start(), tolerance)?;
        let contact = &found.closures.contact;
        let numbers = [
            found.edges.half_width,
            found.edges.eccentricity,
            contact.penetration(),
            contact.friction_stress(),
            found.trailing_release,
            found.leading_release,
        ];
        Ok((numbers, found.evaluations))
    }
}

fn numbers(values: &PartialValues) -> Option<Numbers> {
    let adhesion = values.adhesion?;
    Some([
        values.half_width.value,
        values.eccentricity.value,
        values.penetration.value,
        values.friction_stress.value,
        adhesion.trailing_release.value,
        adhesion.leading_release.value,
    ])
}

/// This program without a start, and from the start of the rivals.
fn own(state: &State) -> [Method; 2] {
    let sample = |accuracy: f64, Timed { seconds, runs, result: found }: Timed<Result<Values, Refusal>>| {
        let setting = format!("{accuracy:.0e}");
        let (error, counted) = match found {
            Ok((numbers, [evaluations, contacts])) => {
                (numbers.map(|numbers| state.error(&numbers)).ok_or_else(|| "not a partial contact".to_owned()), {
                    let unknowns = (contacts * state.material.creep_terms().len() as u64) as f64;
                    vec![(UNKNOWNS, unknowns), ("evaluations of both closures", evaluations as f64), ("contacts", contacts as f64)]
                })
            }
            Err(refusal) => (Err(refusal.to_string()), Vec::new()),
        };
        Sample { setting, seconds, runs, counted, error }
    };
    let cold = ACCURACIES.map(|accuracy| {
        let problem = state.problem(accuracy);
        sample(
            accuracy,
            timed(|| {
                Ok(match steady_sliding(&state.material, &problem)? {
                    SlidingOutcome::Partial(contact) => {
                        (numbers(&contact.values), [contact.work.closure_evaluations, contact.work.contacts])
                    }
                    SlidingOutcome::Full(full) => (None, [full.work.closure_evaluations, full.work.contacts]),
                })
            }),
        )
    });
    let warm = ACCURACIES.map(|accuracy| {
        let (problem, start) = (state.problem(accuracy), state.start());
        let start = Start::at(start.half_width, start.eccentricity);
        sample(
            accuracy,
            timed(|| {
                let contact = steady_sliding_near(&state.material, &problem, &start)?;
                Ok((numbers(&contact.values), [contact.work.closure_evaluations, contact.work.contacts]))
            }),
        )
    });
    [
        Method { name: "this program, no start".into(), own: true, samples: cold.to_vec() },
        Method { name: "this program, rivals' start".into(), own: true, samples: warm.to_vec() },
    ]
}

fn rivals(state: &State, meshes: &[usize]) -> Vec<Method> {
    let mut methods = Vec::new();
    for (name, density, aligned) in [("thesis, n = 1", 1.0, false), ("thesis, n = 3", 3.0, false), ("window-aligned, n = 2", 2.0, true)] {
        let (mut samples, mut levels, mut spent, mut unknowns) = (Vec::new(), Vec::new(), 0.0, 0.0);
        let mut richer = Vec::new();
        for &elements in meshes {
            let layout = if aligned { Layout::WindowAligned { window_elements: (elements / 3).max(4) } } else { Layout::Mapped };
            // A closure that is no better than a percent needs no finer Newton; the aligned one is asked for what extrapolation uses.
            let Timed { seconds, runs, result: found } = timed(|| state.collocated(layout, elements, density, 1e-8));
            let setting = format!("N = {elements}");
            let counted = found.as_ref().map_or_else(
                |_| Vec::new(),
                |(_, evaluations)| {
                    // Three contacts an evaluation, of which each edge moved out has its process zone besides.
                    let unknowns = 3 * elements + if aligned { 2 * (elements / 3).max(4) } else { 0 };
                    vec![(UNKNOWNS, f64::from(*evaluations) * unknowns as f64), ("evaluations of both closures", f64::from(*evaluations))]
                },
            );
            spent += seconds;
            if let Ok((numbers, _)) = &found {
                levels.push(*numbers);
            }
            unknowns += counted.first().map_or(0.0, |counted| counted.1);
            samples.push(Sample {
                setting,
                seconds,
                runs,
                counted,
                error: found.map(|(numbers, _)| state.error(&numbers)).map_err(|refusal| refusal.to_string()),
            });
            if levels.len() >= 2 && levels.len() == samples.len() {
                let at = |column: usize| {
                    extrapolated(&levels.iter().filter_map(|level| level.get(column).copied()).collect::<Vec<_>>(), &ORDERS)
                };
                let error = Ok(state.error(&std::array::from_fn(at)));
                richer.push(Sample {
                    setting: format!("up to N = {elements}"),
                    seconds: spent,
                    runs,
                    counted: vec![(UNKNOWNS, unknowns)],
                    error,
                });
            }
        }
        methods.push(Method { name: name.to_owned(), own: false, samples });
        if aligned {
            methods.push(Method { name: "aligned, extrapolated".into(), own: false, samples: richer });
        }
    }
    methods
}

fn diagram(case: &str, identifier: &'static str, words: &str, meshes: &[usize], headline: bool) -> Result<Diagram, Refusal> {
    let state = State::stored(case)?;
    let mut methods = own(&state).to_vec();
    methods.extend(rivals(&state, meshes));
    Ok(Diagram {
        identifier: identifier.to_owned(),
        caption: format!(
            "An adhesive contact on a sliding wave, {words}: largest error of both edges, penetration, friction and both release rates, over max(|value|, 1), against a \
             stored Chebyshev collocation of another program (eleven digits)."
        ),
        error: "largest error",
        counted: UNKNOWNS,
        methods,
        headline,
    })
}

pub(in crate::studies) fn study(effort: Effort, progress: &Progress) -> Section {
    let mut section = Section::new("precision_sliding", "Work and precision: sliding contacts");
    progress.expect(2);
    section.say(
        "Every method finds both edges of the same contact with the same Newton's method. The rivals start one percent off; this program also without any start, by its path in \
         speed. An evaluation of the rivals is three dense systems of N equations, one of this program three systems of as many equations as the solid has terms. This program \
         gives an error bound with each number, the rivals give none.",
    );
    let meshes = effort.choose(vec![25, 50, 100], vec![25, 50, 100, 200, 400]);
    let cases = [
        ("one", "sliding_one_term", "one retardation time (β = 10, ζ = 0.6, ka = 1)", true),
        ("twelve", "sliding_twelve_terms", "twelve retardation times (β = 15, ζ from 0.01 to 30, ka = 0.9)", false),
    ];
    for (case, identifier, words, headline) in cases {
        match diagram(case, identifier, words, &meshes, headline) {
            Ok(diagram) => diagram.into_section(&mut section),
            Err(refusal) => section.checks.push(Check::new(identifier, "the contact is found", refusal.to_string(), false)),
        }
        progress.advance(1);
    }
    section
}
