use viscotack::Material;
use viscotack::sliding::steady::*;
use viscotack::material::CreepTerm;
use std::time::Instant;
#[test]
fn f() {
    let one = Material::standard_solid(1.3e6, 1.3e6*30.0, 0.37).unwrap();
    let t: Vec<CreepTerm> = (0..12).map(|k| CreepTerm{compliance: (1.0-1.0/30.0)/1.3e6/12.0, retardation_time: 0.37*10f64.powf(-(k as f64))}).collect();
    let twelve = Material::from_creep(1.3e6*30.0, &t, None).unwrap();
    for (name, m, reps) in [("twelve", twelve, 10)] {
      for z in [0.1] {
        for acc in [1e-8] {
        let p = SlidingProblem { rate: z/0.37, indenter: Indenter::Wave, adhesion: Some(WaveAdhesion{reduced_work:0.003,trailing_zone:0.004,leading_zone:0.005}), control: SlidingControl::MeanPressure(0.1), accuracy: acc};
        let t0 = Instant::now();
        let Ok(SlidingOutcome::Partial(c)) = steady_sliding(&m,&p) else { panic!() };
        let cold = t0.elapsed();
        let q = SlidingProblem { rate: p.rate*1.02, ..p };
        let t0 = Instant::now();
        let mut ev = 0;
        for _ in 0..reps { ev = steady_sliding_near(&m, &q, &c.start).unwrap().work.closure_evaluations; }
        println!("{name} z {z} acc {acc:e}: cold {:?} (ev {} steps {}) warm {:?} ev {} bar {:.1e}", cold, c.work.closure_evaluations, c.work.path_steps, t0.elapsed()/reps, ev, c.certificate.accuracy);
        }
      }
    }
}
