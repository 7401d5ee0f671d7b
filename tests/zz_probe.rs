#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]
use viscotack::Material;
use viscotack::sliding::steady::*;
#[test]
fn probe() {
    let material = Material::standard_solid(1.0, 10.0, 1.0).unwrap();
    for zone in [1e-3, 1e-2] {
        for rate in [1e-3, 0.03, 1.0, 100.0] {
            for a in [0.8, 1.2, 1.6] {
                for accuracy in [1e-3, 1e-4, 1e-6, 1e-10] {
                    let adhesion = WaveAdhesion { reduced_work: 0.003, trailing_zone: zone, leading_zone: zone };
                    let problem = SlidingProblem {
                        rate,
                        indenter: Indenter::Wave,
                        adhesion: Some(adhesion),
                        control: SlidingControl::HalfWidth(a),
                        accuracy,
                    };
                    let text = match steady_sliding(&material, &problem) {
                        Ok(SlidingOutcome::Partial(c)) => {
                            format!("p {:.8} e {:.8} work {:?}", c.values.mean_pressure.value, c.values.eccentricity.value, c.work)
                        }
                        Ok(SlidingOutcome::Full(f)) => format!("full {}", f.limit_name),
                        Err(r) => format!("ERR {r}"),
                    };
                    println!("{zone} {rate} {a} {accuracy:e}: {text}");
                }
            }
        }
    }
}
