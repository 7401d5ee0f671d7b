//! The plan of a steady crack: which theories, by which control, with which fields.

mod columns;
mod describe;
mod figures;
mod solve;
mod validity;

use crate::outcome::plot::Figure;
use crate::outcome::{Column, Effect, Group, Row, Validity, Work};
use crate::plan::ProblemPlan;
use crate::plan::citations::Citation;
use crate::plan::maps::Answer;
use crate::plan::state_watch::StateWatch;
use crate::scene::typed::{CohesiveLaw, CrackControl, PoissonRatio, ProcessZoneLaw, Scene, SteadyCrack, Strip, StripLoad, Theory, Units};
use viscotack::crack::cohesive_zone::CohesiveZone;
use viscotack::crack::curve::{CurvePoint, SteadyCurve};
use viscotack::crack::persson_brener::PerssonBrener;
use viscotack::crack::steep_closing::Correction;
use viscotack::crack::virtual_work::VirtualWork;
use viscotack::crack::{Interface, Motion, ProcessZone};
use viscotack::elastic::PureShearStrip;
use viscotack::material::{Material, PlaneMaterial};
use viscotack::refusal::Refusal;

/// A steady crack, ready to be solved.
#[derive(Debug, Clone)]
pub(super) struct SteadyCrackPlan {
    crack: SteadyCrack,
    /// Both series with plane moduli.
    plane_material: PlaneMaterial,
    /// Young's moduli and the Poisson ratio, for strips and for the description.
    youngs_material: Material,
    poisson_ratio: PoissonRatio,
    units: Units,
    accuracy: f64,
    /// Whether a sweep follows.
    swept: bool,
}

/// The drive that a control prescribes, or a speed.
enum Prescribed {
    Speed(f64),
    Drive(f64),
}

impl SteadyCrackPlan {
    pub(super) fn new(scene: &Scene, crack: &SteadyCrack) -> Result<Self, Refusal> {
        let youngs_material = scene.material.series.clone();
        let plan = Self {
            crack: crack.clone(),
            plane_material: scene.material.plane_series(scene.units, crack.plane)?,
            youngs_material,
            poisson_ratio: scene.material.poisson(),
            units: scene.units,
            accuracy: scene.accuracy,
            swept: !scene.sweeps.is_empty(),
        };
        let viscous = plan.plane_material.relaxed_modulus() == 0.0;
        if plan.characteristic_numbers().iter().all(|group| group.value.is_finite() && (group.value > 0.0 || viscous)) {
            Ok(plan)
        } else {
            Err(Refusal::Undefined {
                quantity: "the scale of the crack",
                reason: "the moduli, the work of adhesion and the cohesive stress are so far apart that numbers overflow".into(),
            })
        }
    }

    /// The interface that a theory sees.
    fn interface(&self, theory: Theory) -> Interface {
        let process_zone = match self.crack.process_zone {
            ProcessZoneLaw::Length(length) => ProcessZone::Constant { length },
            ProcessZoneLaw::Cohesive { cohesive_stress, factor, law } => {
                // Persson and Brener's cut-off is a = a₀G/Δγ itself: their theory has no α.
                let factor = if theory == Theory::PerssonBrener { 1.0 } else { factor };
                match law {
                    CohesiveLaw::Growing => ProcessZone::Growing { cohesive_stress, factor },
                    CohesiveLaw::Schapery => ProcessZone::Schapery { cohesive_stress, factor },
                    CohesiveLaw::Constant => ProcessZone::Constant { length: factor * self.relaxed_zone(cohesive_stress) },
                }
            }
        };
        Interface { work_of_adhesion: self.crack.work_of_adhesion, process_zone, body: self.crack.body }
    }

    /// a₀ for a cohesive stress (m).
    fn relaxed_zone(&self, cohesive_stress: f64) -> f64 {
        let squared = self.crack.body.intensity_squared(self.crack.work_of_adhesion, self.plane_material.relaxed_modulus());
        squared / (std::f64::consts::TAU * cohesive_stress * cohesive_stress)
    }

    /// The curve of a theory.
    fn curve(&self, theory: Theory) -> Result<TheoryCurve<'_>, Refusal> {
        let (material, motion, interface) = (&self.plane_material, self.crack.motion, self.interface(theory));
        Ok(match (theory, self.crack.process_zone) {
            (Theory::CohesiveZone, ProcessZoneLaw::Cohesive { cohesive_stress, .. }) => TheoryCurve::CohesiveZone(CohesiveZone::new(
                material,
                motion,
                self.crack.work_of_adhesion,
                cohesive_stress,
                self.crack.body,
            )?),
            (Theory::CohesiveZone, ProcessZoneLaw::Length(_)) => {
                return Err(Refusal::Undefined {
                    quantity: "the cohesive-zone theory",
                    reason: "the process zone is given as a length, so there is no cohesive stress".into(),
                });
            }
            (Theory::PerssonBrener, _) => TheoryCurve::PerssonBrener(PerssonBrener::new(material, motion, interface)?),
            (Theory::VirtualWork, _) => TheoryCurve::VirtualWork(VirtualWork::new(material, motion, interface)?),
        })
    }

    /// Turns the control into a speed or a drive.
    fn prescribed(&self) -> Result<Prescribed, Refusal> {
        let work = self.crack.work_of_adhesion;
        let drive_of_intensity = |intensity: f64| -> Result<f64, Refusal> {
            Ok(match self.crack.motion {
                Motion::Opening => self.crack.body.drive(work, intensity),
                Motion::Closing => {
                    let modulus = self.plane_material.solid_modulus("a remote stress intensity of a closing crack")?;
                    self.crack.body.drive(work, intensity / modulus)
                }
            })
        };
        Ok(match self.crack.control {
            CrackControl::Speed(speed) => Prescribed::Speed(speed),
            CrackControl::EnergyReleaseRate(rate) => {
                let modulus = self.plane_material.solid_modulus("an energy release rate far from the tip")?;
                Prescribed::Drive(match self.crack.motion {
                    Motion::Opening => modulus * (rate / work),
                    Motion::Closing => rate / work / modulus,
                })
            }
            CrackControl::StressIntensity(intensity) => Prescribed::Drive(drive_of_intensity(intensity)?),
            CrackControl::Strip(strip) => {
                let stress = self.strip_stress(&strip)?;
                Prescribed::Drive(drive_of_intensity(self.strip(&strip)?.stress_intensity_factor(stress)?)?)
            }
        })
    }

    fn strip(&self, strip: &Strip) -> Result<PureShearStrip, Refusal> {
        PureShearStrip::new(strip.half_height, strip.lateral, self.crack.plane, self.poisson_ratio.constant().unwrap_or(0.0))
    }

    /// Stress far ahead of the tip (Pa): given, or that of the relaxed material at the given strain.
    fn strip_stress(&self, strip: &Strip) -> Result<f64, Refusal> {
        match strip.load {
            StripLoad::Stress(stress) => Ok(stress),
            StripLoad::Strain(strain) => {
                let modulus = self.youngs_material.solid_modulus("the stress of a strip held at a strain")?;
                self.strip(strip)?.stress_by_grip_displacement(strain * strip.half_height, modulus)
            }
        }
    }

    /// Kernel evaluations of one point of a theory's curve.
    fn kernels_per_point(&self, theory: Theory) -> u64 {
        let creep = self.plane_material.creep_kernel_count();
        let relaxation = self.plane_material.relaxation_kernel_count();
        let zone = match self.crack.process_zone {
            ProcessZoneLaw::Cohesive { law: CohesiveLaw::Schapery, .. } => creep,
            _ => 0,
        };
        match (theory, self.crack.motion) {
            (Theory::CohesiveZone, Motion::Opening) => creep,
            (Theory::CohesiveZone, Motion::Closing) => 2 * creep,
            (_, Motion::Opening) => creep,
            (_, Motion::Closing) => relaxation + zone,
        }
    }

    /// What one state is expected to take.
    fn work_of_a_state(&self) -> Work {
        // Balances of one state, measured over the 400 kinds of scenes in tests/program/explain_predicts_work.rs, at accuracies from 1e-3 to 1e-13:
        // at a given speed 4 to 10, on average 6 (two limits, the Newton steps, the certificate); under a given load 7 to 11, on average 9
        // (some to bracket the root instead of the limits).
        let points = match (self.crack.control, self.plane_material.is_elastic()) {
            // At rest the limit is the answer.
            (CrackControl::Speed(0.0), _) => 1,
            (_, true) => 4,
            (CrackControl::Speed(_), _) => 6,
            _ => 9,
        };
        let mut work = Work::default();
        for &theory in &self.crack.theories {
            work.closure_evaluations += points;
            work.kernel_evaluations += points * self.kernels_per_point(theory);
            if theory == Theory::VirtualWork
                && let Some(fields) = self.crack.fields
            {
                work.field_evaluations += u64::from(fields.points);
            }
        }
        work
    }
}

impl ProblemPlan for SteadyCrackPlan {
    fn name(&self) -> &'static str {
        "steady crack"
    }

    fn labels(&self) -> &'static [&'static str] {
        &["theory"]
    }

    fn effects(&self) -> Vec<Effect> {
        self.effect_list()
    }

    fn method(&self) -> Vec<String> {
        self.sentences()
    }

    fn groups(&self) -> Vec<Group> {
        self.characteristic_numbers()
    }

    fn predicted_work(&self, states: u64) -> Work {
        self.work_of_a_state() * states
    }

    fn rows_of_a_state(&self) -> u64 {
        self.crack.theories.len() as u64
    }

    fn visited_times(&self) -> Option<[f64; 2]> {
        let CrackControl::Speed(speed) = self.crack.control else { return None };
        let beta = self.plane_material.stiffening_ratio();
        if speed <= 0.0 || !beta.is_finite() {
            return None;
        }
        // The zone of each theory is within a factor of this range; fields lie at their own distances.
        let [mut from, mut to] = match self.crack.process_zone {
            ProcessZoneLaw::Length(length) => [length, length],
            ProcessZoneLaw::Cohesive { cohesive_stress, factor, .. } => {
                let zone = self.relaxed_zone(cohesive_stress);
                [zone * factor.min(1.0) / beta, zone * factor.max(1.0) * beta]
            }
        };
        if let Some(fields) = self.crack.fields {
            (from, to) = (from.min(fields.from), to.max(fields.to));
        }
        Some([0.1 * from / speed, 10.0 * to / speed])
    }

    fn columns(&self) -> Vec<Column> {
        columns::columns(self.units)
    }

    fn field_columns(&self) -> Vec<Column> {
        columns::field_columns(self.units)
    }

    fn solve(&self, state: usize, swept: &[f64], _: &StateWatch<'_>) -> Vec<Row> {
        self.crack.theories.iter().map(|&theory| self.row(theory, state, swept)).collect()
    }

    fn validity(&self, rows: &[Row]) -> Vec<Validity> {
        self.assessments(rows)
    }

    fn figures(&self, scene: &Scene, rows: &[Row]) -> Vec<(String, Figure)> {
        self.drawings(scene, rows)
    }

    fn answer(&self, _: &[Row]) -> Option<Answer> {
        Some(self.main_answer())
    }

    fn citations(&self) -> Vec<&'static Citation> {
        self.papers()
    }
}

/// The curve of any theory.
enum TheoryCurve<'a> {
    VirtualWork(VirtualWork<'a>),
    PerssonBrener(PerssonBrener<'a>),
    CohesiveZone(CohesiveZone<'a>),
}

impl TheoryCurve<'_> {
    fn inner(&self) -> &dyn SteadyCurve {
        match self {
            Self::VirtualWork(curve) => curve,
            Self::PerssonBrener(curve) => curve,
            Self::CohesiveZone(curve) => curve,
        }
    }
}

impl SteadyCurve for TheoryCurve<'_> {
    fn point(&self, crossing_time: f64) -> Result<CurvePoint, Refusal> {
        self.inner().point(crossing_time)
    }

    fn material(&self) -> &PlaneMaterial {
        self.inner().material()
    }

    fn motion(&self) -> Motion {
        self.inner().motion()
    }

    fn length_is_bounded_by_its_limits(&self) -> bool {
        self.inner().length_is_bounded_by_its_limits()
    }

    fn sharpened(&self, speed: f64, crossing_time: f64) -> Option<Correction> {
        self.inner().sharpened(speed, crossing_time)
    }
}
