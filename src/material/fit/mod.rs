//! From data to a series: the least number of terms, all strengths positive, that meet a wanted error, and how well the data fix them.
//!
//! ```text
//! data ──► non-negative least squares on log-spaced times ──► neighbours joined, strengths and times refined together
//!      ──► terms added while the gradient asks for one: the best fit that positive strengths allow
//!      ──► terms taken away one by one, refined each time: the least number for the wanted error, or for the scatter of the data
//! ```
//! A series with positive strengths obeys Kramers and Kronig's relations exactly, so what it cannot follow is scatter or no passive solid.
//! Sources: Lawson and Hanson (1974) for the first stage; Levenberg (1944) and Marquardt (1963) for the refinement; Schwarz (1978), *Ann.
//! Stat.* 6, 461, for the number of terms where no error is asked for.

mod band;
mod best;
mod choose;
pub mod consistency;

mod distortion;
mod draws;
mod fixed_times;
mod joint;
mod law;
mod observation;
pub mod overlap;
mod plateau;
mod rest;
mod sample;
mod series;
mod shape;
mod starts;
pub mod superposition;

pub use band::Band;
pub use choose::{SeriesFit, Wanted, fit};
pub use draws::Drawn;
pub use law::LawFit;
pub use observation::{Observation, Quantity, complex_modulus};
pub use plateau::Plateau;
pub use rest::AtRest;
pub use shape::SeriesShape;
