//! Source: this crate's claim that a contact which cannot exist is refused with a witness; `sliding::steady`, thesis Secs 3.2 and 3.3 for the conditions.
//!
//! Goal: half-widths, loads and process zones at which both edge conditions hold only with a pressed edge or with faces that meet outside the contact are no such
//! state, and the limit that is named is one: contacts on its near side, none on its far side. What turns unlocated must say so.
//!
//! Parameters: the four scenes of the calibration study that were refused as not converged (cylinders, numbers as drawn, rounded); an elastic wave and cylinder with
//! zones as long as the contact or works ten thousand times apart; the elastic reference contact of Γ = 0.002, ζ = 10, δ = 1e-3.
//!
//! Oracle: every contact of a half-width by its quadratic forms, which needs no path (`contacts_of_width`); the gap on a fine grid; contacts beside the limit.
//!
//! Tolerance: contacts within 2e-3 of a limit on one side, none on the other (branches end within 1e-5 of arclength).
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use std::sync::Arc;
use viscotack::material::{CreepTerm, PlaneMaterial, RelaxationTerm};
use viscotack::refusal::Refusal;
use viscotack::sliding::branch::{BranchProblem, contacts_of_width};
use viscotack::sliding::contact::{ContactMemory, ContactState, Prescribed, Resolution, WaveContact};
use viscotack::sliding::elastic_reference::elastic_reference_strength;
use viscotack::sliding::steady::{Indenter, PartialContact, SlidingControl, SlidingOutcome, SlidingProblem, WaveAdhesion, steady_sliding};

const BESIDE: f64 = 2e-3;

fn one_term(relaxed: f64, modulus: f64, relaxation_time: f64) -> PlaneMaterial {
    PlaneMaterial::from_relaxation(relaxed, &[RelaxationTerm { modulus, relaxation_time }]).unwrap()
}

fn cylinder(rate: f64, work: f64, zones: [f64; 2], control: SlidingControl) -> SlidingProblem<'static> {
    let adhesion = WaveAdhesion { trailing_zone: zones[0], leading_zone: zones[1], ..WaveAdhesion::even(work, zones[0]) };
    SlidingProblem { rate, indenter: Indenter::Parabola, adhesion: Some(adhesion), work_by_speed: None, control, accuracy: 1e-6 }
}

fn contact(material: &PlaneMaterial, problem: &SlidingProblem<'_>) -> PartialContact {
    match steady_sliding(material, problem).unwrap() {
        SlidingOutcome::Partial(contact) => *contact,
        SlidingOutcome::Full(full) => panic!("full contact: {}", full.limit_name),
    }
}

fn refused(material: &PlaneMaterial, problem: &SlidingProblem<'_>) -> (String, &'static str, f64) {
    match steady_sliding(material, problem) {
        Err(Refusal::NoSuchState { reason, limit_name, limit }) => (reason, limit_name, limit),
        Err(other) => panic!("{other}"),
        Ok(_) => panic!("a contact"),
    }
}

/// Contacts of a half-width, whatever the load.
fn known(material: &PlaneMaterial, problem: &SlidingProblem<'_>, half_width: f64) -> usize {
    let loads = BranchProblem::loads(problem.rate, problem.adhesion.unwrap(), 1e-6);
    let loads = BranchProblem { indenter: problem.indenter, half_widths: [1e-3, 3.0], ..loads };
    contacts_of_width(material, &loads, half_width).unwrap().len()
}

/// The least gap ahead of the leading edge within five half-widths, on a fine grid.
fn least_gap(material: &PlaneMaterial, problem: &SlidingProblem<'_>, contact: &PartialContact) -> f64 {
    let memory = Arc::new(ContactMemory::new(material, problem.rate).unwrap());
    let values = &contact.values;
    let edges = WaveContact { half_width: values.half_width.value, eccentricity: values.eccentricity.value };
    let load = Prescribed::MeanPressure(values.mean_pressure.value);
    let state = ContactState::at_resolution(&memory, problem.indenter, edges, load, Resolution::Finest).unwrap();
    (1..2000)
        .map(|index| state.gap(state.ahead_of_leading(5.0 * edges.half_width * f64::from(index) / 2000.0).unwrap()))
        .fold(f64::INFINITY, f64::min)
}

#[test]
fn narrow_contacts_behind_a_steep_cylinder_touch_ahead() {
    let two = [
        CreepTerm { compliance: 2.848_194_996_594_574e-6, retardation_time: 1.016_392_183_205_477_6e-4 },
        CreepTerm { compliance: 1.459_390_126_302_792e-6, retardation_time: 1.574_083_928_552_265_7e-5 },
    ];
    let cases = [
        (
            PlaneMaterial::from_creep(70_138_233.268_308_36, &two, None).unwrap(),
            cylinder(3661.8948, 0.021_171_729, [2.212_593_77e-4, 0.024_895_006], SlidingControl::HalfWidth(0.658_410_51)),
        ),
        (
            one_term(1_132_129.083_228, 1_049_263_001.026, 375.485_770_66),
            cylinder(6.956_803_8e-8, 0.016_098_97, [4.315_299e-4, 1.111_936_5e-3], SlidingControl::HalfWidth(0.566_834_36)),
        ),
    ];
    for (material, problem) in cases {
        let SlidingControl::HalfWidth(asked) = problem.control else { panic!() };
        let (reason, name, narrowest) = refused(&material, &problem);
        println!("{reason}: {name} {narrowest}");
        assert!(reason.contains("faces would meet") && name.contains("narrowest half-width") && narrowest > asked);
        assert_eq!(known(&material, &problem, asked), 0);
        assert_eq!(known(&material, &problem, narrowest * (1.0 - BESIDE)), 0);
        assert_eq!(known(&material, &problem, narrowest * (1.0 + BESIDE)), 1);
        // Just wider the faces are apart everywhere, though by little.
        let wider = SlidingProblem { control: SlidingControl::HalfWidth(narrowest * (1.0 + BESIDE)), ..problem };
        let found = contact(&material, &wider);
        let gap = least_gap(&material, &wider, &found);
        println!("least gap beside the limit {gap:e}");
        assert!(found.certificate.admissible && gap > 0.0 && gap < 1e-2);
    }
}

#[test]
fn a_load_below_the_smallest_of_all_contacts_is_none() {
    let material = one_term(2_214.827_360_157_48, 695_035.269_627_283, 0.262_248_624_140_239_9);
    let problem = cylinder(
        0.017_562_703_924_864_18,
        4.053_867_6e-4,
        [0.016_208_943_8, 5.440_837_8e-4],
        SlidingControl::MeanPressure(-1.842_826_5e-3),
    );
    let (reason, name, limit) = refused(&material, &problem);
    println!("{reason}: {name} {limit}");
    assert!(reason.contains("leading edge would be pressed") && name.contains("smallest mean pressure"));
    let above = SlidingProblem { control: SlidingControl::MeanPressure(limit * (1.0 + BESIDE)), ..problem };
    assert!(contact(&material, &above).certificate.admissible);
    let below = SlidingProblem { control: SlidingControl::MeanPressure(limit * (1.0 - BESIDE)), ..problem };
    assert!(refused(&material, &below).1.contains("smallest mean pressure"));
}

#[test]
fn zones_too_long_for_their_work_are_refused_with_the_longest() {
    let material = PlaneMaterial::elastic(1e6).unwrap();
    let uneven =
        |trailing_work: f64, leading_work: f64, zone: f64| WaveAdhesion { trailing_work, leading_work, ..WaveAdhesion::even(1.0, zone) };
    let problem = |indenter: Indenter, adhesion: WaveAdhesion, control: SlidingControl| SlidingProblem {
        rate: 0.0,
        indenter,
        adhesion: Some(adhesion),
        work_by_speed: None,
        control,
        accuracy: 1e-6,
    };
    let (load, depth, width) = (SlidingControl::MeanPressure(0.05), SlidingControl::Penetration(0.2), SlidingControl::HalfWidth(1.0));
    for case in [
        problem(Indenter::Wave, uneven(1e-3, 1e-3, 0.3), depth),
        problem(Indenter::Wave, uneven(1e-3, 1e-5, 0.1), load),
        problem(Indenter::Wave, uneven(1e-2, 1e-6, 0.05), depth),
        problem(Indenter::Parabola, uneven(1e-3, 1e-5, 0.1), width),
        problem(Indenter::Parabola, uneven(1e-2, 1e-5, 0.02), load),
    ] {
        let (reason, name, limit) = refused(&material, &case);
        println!("{:?} {:?}: {reason}: {name} {limit}", case.indenter, case.control);
        if name.contains("penetration") || name.contains("pressure") {
            // The last contact with these zones is nearer than the zones that hold what is asked for: contacts below it, none above.
            let with = |held: f64| match case.control {
                SlidingControl::MeanPressure(_) => SlidingProblem { control: SlidingControl::MeanPressure(held), ..case },
                _ => SlidingProblem { control: SlidingControl::Penetration(held), ..case },
            };
            assert!(reason.contains("pressed"), "{reason}");
            assert!(contact(&material, &with(limit * (1.0 - BESIDE))).certificate.admissible);
            refused(&material, &with(limit * (1.0 + BESIDE)));
            continue;
        }
        assert!(reason.contains("too long") && name.contains("process zones") && limit > 0.0 && limit < 1.0, "{reason} {name} {limit}");
        let with = |factor: f64| SlidingProblem { adhesion: Some(case.adhesion.unwrap().with_zones_times(factor)), ..case };
        assert!(contact(&material, &with(limit * (1.0 - BESIDE))).certificate.admissible);
        // There the end of the branch of loads may be nearer, and named.
        refused(&material, &with(limit * (1.0 + BESIDE)));
    }
    // Every contact of that half-width: none.
    let of_width = problem(Indenter::Wave, uneven(1e-3, 1e-3, 0.3), width);
    println!("{:?}", refused(&material, &of_width));
    assert_eq!(known(&material, &of_width, 1.0), 0);
}

#[test]
fn a_pull_off_at_the_rounding_of_its_equations_is_found() {
    let material = PlaneMaterial::from_creep(10.0, &[CreepTerm { compliance: 0.9, retardation_time: 1.0 }], None).unwrap();
    let problem = BranchProblem::loads(10.0, WaveAdhesion::even(0.002, 1e-3), 1e-4);
    let reference = elastic_reference_strength(&material, &problem).unwrap();
    let (work, elastic) = (0.002 / reference.modulus.value, reference.found);
    let pull_off = elastic.pull_off.unwrap().value.value;
    assert!(elastic.unlocated.is_empty());
    // Johnson: the least p̄ = s² − 2√(Γ tan(a/2)) over a; a zone of 1e-3 shifts it by a few per cent.
    let johnson = (1..3000).map(|index| 1e-3 * f64::from(index)).map(|a| (0.5 * a).sin().powi(2) - 2.0 * (work * (0.5 * a).tan()).sqrt());
    let johnson = johnson.fold(f64::INFINITY, f64::min);
    println!("{pull_off} {johnson}");
    assert!((pull_off / johnson - 1.0).abs() < 0.02);
}
