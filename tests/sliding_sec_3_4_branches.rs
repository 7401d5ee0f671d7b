//! probe
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]
use viscotack::Material;
use viscotack::sliding::branch::*;
use viscotack::sliding::steady::{SlidingControl, WaveAdhesion};

fn adhesion(work: f64, zone: f64) -> WaveAdhesion {
    WaveAdhesion { reduced_work: work, trailing_zone: zone, leading_zone: zone }
}

fn show(name: &str, material: &Material, problem: &BranchProblem) {
    let begin = std::time::Instant::now();
    match trace(material, problem) {
        Ok(branch) => {
            println!(
                "{name}: {} curve points, {} kept, {} left out, {:?}, {:.3} s",
                branch.outline().len(),
                branch.points.len(),
                branch.left_out.len(),
                branch.work,
                begin.elapsed().as_secs_f64()
            );
            println!("   begins {:?} ends {:?}", branch.begins, branch.ends);
            for fold in &branch.folds {
                println!(
                    "   {:?} {:?} {:.12} ± {:.1e} a = {:.10} ± {:.1e} p̄ = {:.12} ± {:.1e} Δ = {:.10} ± {:.1e}; residual {:.1e} load {:?} pen {:?}",
                    fold.quantity,
                    fold.turn,
                    fold.value.value,
                    fold.value.error,
                    fold.contact.half_width.value,
                    fold.contact.half_width.error,
                    fold.contact.mean_pressure.value,
                    fold.contact.mean_pressure.error,
                    fold.contact.penetration.value,
                    fold.contact.penetration.error,
                    fold.residual,
                    fold.variations.under_load(),
                    fold.variations.under_penetration()
                );
                let det =
                    |m: [[f64; 2]; 2]| (m[0][0] * m[1][1] - m[0][1] * m[1][0]) / ((m[0][0] * m[1][1]).abs() + (m[0][1] * m[1][0]).abs());
                println!(
                    "      det load {:.1e} pen {:.1e} softest {:?} borders {}",
                    det(fold.variations.in_frame_matrix(0.0)),
                    det(fold.variations.in_frame_matrix(f64::INFINITY)),
                    fold.variations.softest_frame(), fold.borders_stable
                );
            }
            for zero in &branch.zero_load {
                println!("   zero load a = {:.10} Δ = {:.10}", zero.half_width.value, zero.penetration.value);
            }
            for (at, refusal) in branch.left_out.iter().take(3) {
                println!("   left out {at:.3}: {refusal}");
            }
            for lost in &branch.unlocated {
                println!("   UNLOCATED {lost:?}");
            }
            let mut last = String::new();
            for point in &branch.points {
                let now = format!("load {:?} pen {:?}", point.variations.under_load(), point.variations.under_penetration());
                if now != last {
                    println!(
                        "   from a = {:.6} e = {:.6} p̄ = {:.6} parameter {:.6e}: {now}",
                        point.values.half_width.value,
                        point.values.eccentricity.value,
                        point.values.mean_pressure.value,
                        point.parameter.value
                    );
                    last = now;
                }
            }
        }
        Err(refusal) => println!("{name}: REFUSED {refusal} {:.3} s", begin.elapsed().as_secs_f64()),
    }
}

#[test]
fn probe() {
    let elastic = Material::elastic(1.0).unwrap();
    show("elastic", &elastic, &BranchProblem { points: 40, ..BranchProblem::loads(0.0, adhesion(0.01, 1e-3), 1e-8) });
    for beta in [10.0, 200.0] {
        let material = Material::standard_solid(1.0, beta, 1.0).unwrap();
        for zeta in [1e-3, 0.03, 1.0, 100.0] {
            show(
                &format!("β {beta} ζ {zeta}"),
                &material,
                &BranchProblem { points: 40, ..BranchProblem::loads(zeta, adhesion(0.003, 1e-2), 1e-8) },
            );
        }
        let begin = std::time::Instant::now();
        match toughness(&material, &BranchProblem::loads(0.03, adhesion(0.003, 1e-2), 1e-8)) {
            Ok(found) => println!("toughness {:?} {:.3} s", found.value, begin.elapsed().as_secs_f64()),
            Err(refusal) => println!("toughness {refusal}"),
        }
        for pressure in [0.0, 0.1, 0.3] {
            let problem = BranchProblem {
                points: 30,
                ..BranchProblem::speeds(SlidingControl::MeanPressure(pressure), [1e-5, 1e5], BranchStart::Slow, adhesion(0.003, 1e-2), 1e-8)
            };
            show(&format!("slow β {beta} p {pressure}"), &material, &problem);
            show(&format!("fast β {beta} p {pressure}"), &material, &BranchProblem { start: BranchStart::Fast, ..problem });
        }
    }
}
