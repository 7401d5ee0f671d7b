//! Adhesive contact and fracture of linear viscoelastic solids, from one energy balance at the edge.
//!
//! Near a moving edge a rubbery solid is stiff, far from it soft, and energy is lost in between. One balance at the edge closes cracks, sliding contacts and indenters:
//! what the edge takes, Δγ, is what comes in from far away less what the body loses. Every number comes as an [`Estimate`], a value with a bound on its error;
//! what cannot be solved is a [`Refusal`] with its reason.
//!
//! | module | what it solves |
//! |---|---|
//! | [`material`] | creep and relaxation series of any length, from moduli, terms or measured data |
//! | [`crack`] | steady cracks that open or close; [`crack::delayed`]: growth under a load history, with its delay |
//! | [`sliding`] | steady sliding of a wave or a cylinder, with adhesion or without; [`sliding::branch`]: curves of contacts, pull-off, snap-in |
//! | [`indentation`] | sphere, cone, punch, any axisymmetric shape, under a history of penetration, force or a frame |
//! | [`finite_range`] | surfaces that attract at a distance: lines, maps, and the sphere in time |
//! | [`fit`] | parameters of any model from data, with intervals |
//!
//! SI units, but for sliding and surfaces, which are solved in reduced units: their modules say which. Contacts and cracks take a [`PlaneMaterial`], whose moduli are E*
//! = E/(1 − ν²).
//!
//! # A material
//! ```
//! use viscotack::Material;
//! // E0 = 1 MPa, E∞ = 100 MPa, one retardation time of 0.1 s.
//! let rubber = Material::standard_solid(1e6, 1e8, 0.1)?;
//! let modulus = rubber.complex_modulus(1e3)?; // at 1000 rad/s
//! assert!((modulus.magnitude() / 1e8 - 1.0).abs() < 0.5);
//! # Ok::<(), viscotack::Refusal>(())
//! ```
//! # A material from data
//! ```
//! use viscotack::Material;
//! use viscotack::material::fit::{Wanted, complex_modulus, fit};
//! let measured = Material::standard_solid(1e6, 1e8, 0.1)?; // stands for a measurement
//! let mut data = Vec::new();
//! for tenth in -20..40 {
//!     let frequency = 10f64.powf(0.1 * f64::from(tenth));
//!     let modulus = measured.complex_modulus(frequency)?;
//!     data.extend(complex_modulus(frequency, modulus.storage, modulus.loss));
//! }
//! let found = fit(&data, Wanted::Error(1e-6))?;
//! assert_eq!(found.material.creep_terms().len(), 1);
//! assert!((found.material.glassy_modulus() / 1e8 - 1.0).abs() < 1e-4);
//! # Ok::<(), viscotack::Refusal>(())
//! ```
//! # A steady crack
//! ```
//! use viscotack::PlaneMaterial;
//! use viscotack::crack::virtual_work::VirtualWork;
//! use viscotack::crack::{CrackBody, Interface, Motion, ProcessZone, at_speed};
//! let rubber = PlaneMaterial::standard_solid(1e6, 1e8, 0.1)?; // moduli of the plane problem
//! let process_zone = ProcessZone::Constant { length: 1e-6 };
//! let interface = Interface { work_of_adhesion: 10.0, process_zone, body: CrackBody::TwoHalves };
//! let opening = VirtualWork::new(&rubber, Motion::Opening, interface)?;
//! let slow = at_speed(&opening, 1e-9, 1e-12)?.energy_release_rate_ratio.unwrap();
//! let fast = at_speed(&opening, 1e3, 1e-12)?.energy_release_rate_ratio.unwrap();
//! // From Δγ to Δγ·E∞/E0.
//! assert!((slow.value - 1.0).abs() < 1e-3 && (fast.value / 100.0 - 1.0).abs() < 1e-3);
//! # Ok::<(), viscotack::Refusal>(())
//! ```
//! # A delayed crack
//! ```
//! use viscotack::PlaneMaterial;
//! use viscotack::crack::delayed::{GrowthProblem, Onset, onset};
//! use viscotack::crack::{CrackBody, Interface, ProcessZone};
//! let rubber = PlaneMaterial::standard_solid(1e6, 1e8, 0.1)?; // moduli of the plane problem
//! let interface = Interface { work_of_adhesion: 10.0, process_zone: ProcessZone::Constant { length: 1e-6 }, body: CrackBody::TwoHalves };
//! let load = 5e3; // K in Pa √m; the relaxed limit of two halves is √(Δγ E0) = 3.16e3
//! let problem = GrowthProblem::new(&rubber, interface, load)?;
//! let Onset::After { delay, .. } = onset(&problem, load)? else { panic!("no delay") };
//! // One term: K²J(t) = Δγ gives t = −τ ln[(1/E0 − Δγ/K²)/(1/E0 − 1/E∞)].
//! let expected = -0.1 * ((1e-6 - 10.0 / load.powi(2)) / (1e-6 - 1e-8_f64)).ln();
//! assert!((delay.value - expected).abs() < delay.error + 1e-12);
//! # Ok::<(), viscotack::Refusal>(())
//! ```
//! # A sliding contact
//! ```
//! use viscotack::PlaneMaterial;
//! use viscotack::sliding::steady::{SlidingControl, SlidingOutcome, SlidingProblem, WaveAdhesion, steady_sliding};
//! let solid = PlaneMaterial::standard_solid(1.0, 10.0, 0.1)?; // only E/E0 and kvτ count
//! let adhesion = WaveAdhesion::even(0.002, 1e-3); // Γ, δ
//! let problem = SlidingProblem::wave(1.0, Some(adhesion), SlidingControl::MeanPressure(0.1), 1e-9); // kv, …, accuracy
//! let SlidingOutcome::Partial(contact) = steady_sliding(&solid, &problem)? else { panic!("full contact") };
//! // Friction is what the two edges release differently and what the bulk loses: it opposes the motion.
//! assert!(contact.values.friction_stress.value > 0.0 && contact.values.friction_stress.error < 1e-9);
//! # Ok::<(), viscotack::Refusal>(())
//! ```
//! # An equilibrium curve of sliding contacts
//! ```
//! use viscotack::PlaneMaterial;
//! use viscotack::sliding::branch::{BranchProblem, strength};
//! use viscotack::sliding::steady::WaveAdhesion;
//! let solid = PlaneMaterial::standard_solid(1.0, 10.0, 0.1)?;
//! let curve = BranchProblem::loads(1.0, WaveAdhesion::even(0.002, 1e-3), 1e-9); // kv, Γ and δ, accuracy
//! let turns = strength(&solid, &curve)?;
//! // A contact exists between the pull-off pressure and the pressure of snap-in.
//! let (least, largest) = (turns.pull_off.unwrap().value, turns.snap_in.unwrap().value);
//! assert!(least.value < 0.0 && largest.value > 0.0);
//! # Ok::<(), viscotack::Refusal>(())
//! ```
//! # An indenter in time
//! ```
//! use viscotack::elastic::PlaneState;
//! use viscotack::{Material, PlaneMaterial};
//! use viscotack::indentation::{Adhesion, History, IndentationProblem, Profile, run};
//! let youngs = Material::standard_solid(1e6, 1e8, 0.1)?;
//! let plane = PlaneMaterial::of_youngs(&youngs, PlaneState::Strain, 0.5)?; // E* of ν = 1/2
//! let sphere = Profile::Paraboloid { radius: 1e-3 };
//! let adhesion = Adhesion { work_of_adhesion: 0.05, process_zone: 1e-7 };
//! // A relaxed contact, pulled off at 1 µm/s.
//! let history = History::penetration(2e-6).at_speed(-20e-6, 1e-6);
//! let problem = IndentationProblem::new(sphere, Some(adhesion), history).relaxed();
//! let solution = run(&plane, &problem)?;
//! let pull_off = solution.pull_off_force().unwrap();
//! // Above the elastic limit 1.5πRΔγ.
//! assert!(pull_off.value > 1.5 * std::f64::consts::PI * 1e-3 * 0.05 && pull_off.error < 1e-3 * pull_off.value);
//! # Ok::<(), viscotack::Refusal>(())
//! ```
//!
//! Programs that print tables are in `examples/`.

pub mod closure;
pub mod continuation;
pub mod crack;
pub mod elastic;
pub mod estimate;
pub mod finite_range;
pub mod fit;
pub mod indentation;
pub mod material;
pub mod refusal;
pub mod sliding;
pub mod special;

pub use estimate::Estimate;
pub use material::{Material, PlaneMaterial};
pub use refusal::Refusal;
