//! exploratory
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]
use std::time::Instant;
use viscotack::Material;
use viscotack::material::CreepTerm;
use viscotack::rivals::sliding_collocation::richardson::{extrapolated, observed_order};
use viscotack::rivals::sliding_collocation::{Layout, SlidingCollocation};
use viscotack::sliding::contact::{ContactMemory, ContactState, Edge, Prescribed, WaveContact, edge_work};
use viscotack::sliding::equilibrium::WaveAdhesion;

fn material(relaxed: f64, beta: f64, times: &[f64]) -> Material {
    let gained = (1.0 - 1.0 / beta) / relaxed;
    let terms: Vec<CreepTerm> =
        times.iter().map(|&retardation_time| CreepTerm { compliance: gained / times.len() as f64, retardation_time }).collect();
    Material::from_creep(relaxed * beta, &terms, None).unwrap()
}

#[test]
fn explore() {
    let density: f64 = std::env::var("DENS").unwrap_or("3".into()).parse().unwrap();
    let mapped = std::env::var("MAPPED").is_ok();
    let levels: u32 = std::env::var("LEVELS").unwrap_or("4".into()).parse().unwrap();
    let n0: usize = std::env::var("N0").unwrap_or("50".into()).parse().unwrap();
    for (beta, zeta, e) in [(1.0001, 0.3, 0.0), (10.0, 0.01, 0.0), (10.0, 0.3, 0.1), (10.0, 30.0, -0.05), (1000.0, 0.01, -0.1), (1000.0, 1.0, 0.1), (1000., 30., 0.1)] {
        let m = material(1.0, beta, &[1.0]);
        let memory = ContactMemory::new(&m, zeta).unwrap();
        let c = WaveContact { half_width: 1.1, eccentricity: e };
        let zone = 1e-3;
        let ours = ContactState::new(&memory, c, Prescribed::Penetration(0.3)).unwrap();
        let held = Prescribed::Penetration(0.3);
        let mt = ContactState::new(&memory, WaveContact { half_width: c.half_width + 0.5 * zone, eccentricity: e - 0.5 * zone }, held).unwrap();
        let ml = ContactState::new(&memory, WaveContact { half_width: c.half_width + 0.5 * zone, eccentricity: e + 0.5 * zone }, held).unwrap();
        let adhesion = WaveAdhesion { reduced_work: 0.01, trailing_zone: zone, leading_zone: zone };
        let fac = 2.0 * std::f64::consts::PI * 0.01 * zone;
        let p_at = [0.01, 0.3, 1.0, 1.7, 2.19];
        let mut reference = vec![
            ours.mean_pressure(),
            ours.friction_stress(),
            ours.interface_work(),
            edge_work(&ours, &mt, Edge::Trailing, zone),
            edge_work(&ours, &ml, Edge::Leading, zone),
            (mt.interface_work() - ours.interface_work()) / fac,
            (ml.interface_work() - ours.interface_work()) / fac,
        ];
        reference.extend(p_at.iter().map(|&d| ours.pressure(ours.inside_trailing(d).unwrap())));
        let mut table: Vec<Vec<f64>> = vec![];
        let mut times = vec![];
        for level in 0..levels {
            let n = n0 << level;
            let t = Instant::now();
            let layout = if mapped { Layout::Mapped } else { Layout::WindowAligned { window_elements: n / 2 } };
            let s = SlidingCollocation::new(memory.kernel(), layout, n, density).unwrap();
            let r = match s.closures(&adhesion, held, c) { Ok(r) => r, Err(e) => { println!("{e}"); continue } };
            times.push(t.elapsed().as_secs_f64());
            let (g1, g2) = r.releases(&adhesion);
            let mut row = vec![r.contact.mean_pressure(), r.contact.friction_stress(), r.contact.interface_work(), r.trailing_work, r.leading_work, g1, g2];
            row.extend(p_at.iter().map(|&d| r.contact.pressure(ours.inside_trailing(d).unwrap())));
            table.push(row);
        }
        println!("β={beta} ζ={zeta} times {times:.3?}");
        for (i, name) in ["p̄", "τ", "U", "W1", "W2", "G1", "G2", "p.01", "p.3", "p1", "p1.7", "p2.19"].iter().enumerate() {
            let v: Vec<f64> = table.iter().map(|r| r[i]).collect();
            let err: Vec<f64> = v.iter().map(|x| x - reference[i]).collect();
            let o: Vec<f64> = v.windows(3).map(|w| observed_order(w[0], w[1], w[2])).collect();
            let oe: Vec<f64> = err.windows(2).map(|w| (w[0]/w[1]).abs().log2()).collect();
            println!("  {name:6} ref {:.8e} err {} order {o:.2?} vs ref {oe:.2?} ext(2,3,4) {:.1e} ext(2,4) {:.1e}", reference[i], err.iter().map(|x| format!("{x:9.1e}")).collect::<Vec<_>>().join(" "), extrapolated(&v, &[2., 3., 4.]) - reference[i], extrapolated(&v, &[2., 4.]) - reference[i]);
        }
    }
}
