use viscotack::Material;
use viscotack::sliding::steady::*;
use viscotack::material::CreepTerm;
#[test]
fn f() {
  for dec in [2.0, 4.0, 6.0, 8.0] { for z in [1e-5, 1e-3, 0.1, 10.0, 1e3] {
    let t: Vec<CreepTerm> = (0..12).map(|k| CreepTerm{compliance: (1.0-1.0/700.0)/1.3e6/12.0, retardation_time: 0.37*10f64.powf(-dec*(k as f64)/12.0)}).collect();
    let m = Material::from_creep(1.3e6*700.0, &t, None).unwrap();
        let p = SlidingProblem { rate: z/0.37, indenter: Indenter::Wave, adhesion: None, control: SlidingControl::Penetration(0.48), accuracy: 1e-10};
        let q = SlidingProblem { accuracy: 1e-7, ..p};
        match (steady_sliding(&m,&p), steady_sliding(&m,&q)) { (Ok(SlidingOutcome::Partial(c)),Ok(SlidingOutcome::Partial(d))) => println!("dec {dec} z {z}: cond {:.1e} acc {:.1e} e {:.3e}±{:.1e} fr {:.2e}±{:.1e} a±{:.1e} |da| {:.1e} |dfr| {:.1e}", c.certificate.condition, c.certificate.accuracy, c.values.eccentricity.value, c.values.eccentricity.error,  c.values.friction_stress.value, c.values.friction_stress.error, c.values.half_width.error, d.values.half_width.value-c.values.half_width.value,d.values.friction_stress.value-c.values.friction_stress.value), o=>println!("{o:?}") }
  }}
}
