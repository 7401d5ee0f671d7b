use std::collections::BTreeMap;
use viscotack_verification::studies::calibration::{sphere, tally::Truth, wide_spectrum};
fn main() {
    let n: u64 = std::env::args().nth(1).unwrap().parse().unwrap();
    let from: u64 = std::env::args().nth(2).unwrap().parse().unwrap();
    let mut table: BTreeMap<&str, (usize, usize, Vec<f64>, f64)> = BTreeMap::new();
    let mut troubles = 0;
    for scene in from..from + n {
        for j in [Some(sphere::judged(scene)), (scene % 8 == 0).then(|| wide_spectrum::judged(scene))].into_iter().flatten() {
            if let Some(t) = &j.trouble { troubles += 1; println!("scene {scene}: {t}"); }
            if j.truth == Truth::Another { continue }
            for c in &j.compared {
                let e = table.entry(c.quantity).or_default();
                e.0 += 1;
                let over = (c.found.value - c.truth.value).abs() / (c.found.error + c.truth.error);
                if c.is_missed() { e.1 += 1; println!("scene {scene} {} found {:?} truth {:?}", c.quantity, c.found, c.truth); }
                if let Some(w) = c.width() { e.2.push(w) }
                let share = c.found.error / j.accuracy / c.scale.max(c.found.value.abs());
                e.3 = e.3.max(share);
                let _ = over;
            }
        }
    }
    println!("troubles {troubles}");
    for (k, (n, miss, mut w, share)) in table {
        w.sort_by(f64::total_cmp);
        let q = |p: f64| w.get((p * w.len() as f64) as usize).copied().unwrap_or(f64::NAN);
        println!("{k:40} {n:6} missed {miss} widths {} median {:.1} p95 {:.1}; largest bound over accuracy {share:.2}", w.len(), q(0.5), q(0.95));
    }
}
