//! The three theories of a steady crack behind one type, for tests that hold for all of them.
#![allow(dead_code, unreachable_pub, clippy::unwrap_used, clippy::panic, missing_docs)]

use viscotack::crack::cohesive_zone::CohesiveZone;
use viscotack::crack::persson_brener::PerssonBrener;
use viscotack::crack::steep_closing::Correction;
use viscotack::crack::virtual_work::VirtualWork;
use viscotack::crack::{CrackBody, CurvePoint, Interface, Motion, ProcessZone, SteadyCurve};
use viscotack::{PlaneMaterial, Refusal};

pub enum Theory<'a> {
    Work(VirtualWork<'a>),
    Loss(PerssonBrener<'a>),
    Zone(CohesiveZone<'a>),
}

impl SteadyCurve for Theory<'_> {
    fn point(&self, crossing_time: f64) -> Result<CurvePoint, Refusal> {
        match self {
            Self::Work(curve) => curve.point(crossing_time),
            Self::Loss(curve) => curve.point(crossing_time),
            Self::Zone(curve) => curve.point(crossing_time),
        }
    }

    fn material(&self) -> &PlaneMaterial {
        match self {
            Self::Work(curve) => curve.material(),
            Self::Loss(curve) => curve.material(),
            Self::Zone(curve) => curve.material(),
        }
    }

    fn motion(&self) -> Motion {
        match self {
            Self::Work(curve) => curve.motion(),
            Self::Loss(curve) => curve.motion(),
            Self::Zone(curve) => curve.motion(),
        }
    }

    fn length_is_bounded_by_its_limits(&self) -> bool {
        match self {
            Self::Work(curve) => curve.length_is_bounded_by_its_limits(),
            Self::Loss(curve) => curve.length_is_bounded_by_its_limits(),
            Self::Zone(curve) => curve.length_is_bounded_by_its_limits(),
        }
    }

    fn sharpened(&self, speed: f64, crossing_time: f64) -> Option<Correction> {
        match self {
            Self::Work(curve) => curve.sharpened(speed, crossing_time),
            Self::Loss(curve) => curve.sharpened(speed, crossing_time),
            Self::Zone(curve) => curve.sharpened(speed, crossing_time),
        }
    }
}

/// Numbers of an interface that are nothing like one.
pub const WORK: f64 = 0.17;
pub const STRESS: f64 = 9.7e5;

pub fn interface(process_zone: ProcessZone) -> Interface {
    Interface { work_of_adhesion: WORK, process_zone, body: CrackBody::AgainstRigid }
}

/// α times the length of the relaxed zone grows with G.
pub fn growing(factor: f64) -> ProcessZone {
    ProcessZone::Growing { cohesive_stress: STRESS, factor }
}

/// Every theory with every law that exists in this motion, with a name.
pub fn theories<'a>(material: &'a PlaneMaterial, motion: Motion) -> Vec<(String, Theory<'a>)> {
    let mut laws = vec![ProcessZone::Constant { length: 2.3e-7 }, growing(0.37)];
    if motion == Motion::Closing {
        laws.push(ProcessZone::Schapery { cohesive_stress: STRESS, factor: 0.8 });
    }
    let mut result = Vec::new();
    for law in laws {
        result
            .push((format!("virtual work {motion:?} {law:?}"), Theory::Work(VirtualWork::new(material, motion, interface(law)).unwrap())));
        result.push((format!("loss {motion:?} {law:?}"), Theory::Loss(PerssonBrener::new(material, motion, interface(law)).unwrap())));
    }
    let zone = CohesiveZone::new(material, motion, WORK, STRESS, CrackBody::AgainstRigid).unwrap();
    result.push((format!("cohesive zone {motion:?}"), Theory::Zone(zone)));
    result
}

pub const MOTIONS: [Motion; 2] = [Motion::Opening, Motion::Closing];
