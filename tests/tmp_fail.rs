use viscotack::Material;
use viscotack::sliding::steady::*;
use viscotack::sliding::edge_balance::*;
use viscotack::sliding::contact::*;
use std::sync::Arc;
#[test]
fn f() {
    let m = Material::standard_solid(1.3e6, 1.3e6*107.0, 0.37).unwrap();
    let ad = Some(WaveAdhesion{reduced_work:0.0003866,trailing_zone:0.004058,leading_zone:0.005135});
    for (range, start) in [((0..30).map(|k| 1.0*1.15f64.powi(k)).collect::<Vec<_>>(),[0.46799,0.06924]),((0..40).map(|k| 1e4*0.8f64.powi(k)).collect(),[0.50924,0.00164])] {
        let mut x = start; let mut j=None;
        for z in range {
            let b = EdgeBalance::new(Arc::new(ContactMemory::new(&m,z/0.37).unwrap()), Indenter::Wave, ad, SlidingControl::Penetration(0.23467), Resolution::Fine);
            match b.solve(x, j, 1e-10) { Ok(s) => { x = s.unknowns; j=s.jacobian; let a = b.admissibility(&s.solution).unwrap(); let (t,l)=s.solution.moved.clone().unwrap();
              println!("{z:.2e} a {:.5} e {:.5} k {:?} kt {:?} kl {:?} gap {:.2e} p {:.4}", x[0],x[1], s.solution.state.edge_amplitudes(), t.edge_amplitudes(), l.edge_amplitudes(), a.smallest_gap, s.solution.state.mean_pressure());
              let st=&s.solution.state; if a.smallest_gap<=0.0 { for d in [1e-4,1e-3,1e-2,0.1,0.5,1.0,2.0] { print!(" {:.3e}/{:.3e}", st.gap(st.behind_trailing(d).unwrap()), st.gap(st.ahead_of_leading(d).unwrap())); } println!(); break;}
            } Err(e) => { println!("{z:.2e} {e}"); break } }
        }
    }
}
