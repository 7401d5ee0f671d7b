//! The plotting room: curves on two axes, drawn as a journal would print them.
//!
//! A [`Figure`] is plain data: two [`Axis`], a list of [`Curve`], a place for the legend. Whoever computes fills it; [`svg()`] and [`png()`] draw
//! it, both from one layout. The same figure always gives the same bytes: no dates, no random identifiers, no font looked up on the machine.
//!
//! ```
//! use viscotack_program::outcome::plot::{self, Axis, Curve, Figure, Line, PlotError};
//!
//! let speeds = [1e-6, 1e-3, 1.0, 1e3, 1e6];
//! let toughness = |speed: f64| 1.0 + 99.0 * speed / (1.0 + speed);
//! let figure = Figure::new(Axis::logarithmic("crack speed $v$ (m/s)"), Axis::logarithmic(r"$G/\Delta\gamma$"))
//!     .with_curve(Curve::new("steady state", speeds.iter().map(|v| (*v, toughness(*v))).collect()).with_line(Line::Solid))
//!     .with_curve(Curve::new("no memory", vec![(1e-6, 1.0), (1e6, 1.0)]).with_line(Line::Dashed));
//! match plot::svg(&figure) {
//!     Ok(text) => assert!(text.starts_with("<svg")),
//!     Err(PlotError::NotBuilt) => {} // this build has no plots: nothing else changes for the caller
//!     Err(other) => panic!("{other}"),
//! }
//! ```
//!
//! # Labels
//! Plain text, with mathematics between dollars: `"$E_\infty$ (MPa)"`, `"$a/R$"`, `r"$\Delta\gamma$"`, `"$10^{3}$"`. Latin letters and small Greek
//! letters are slanted, digits, capitals of Greek and `\mathrm{...}` are upright, `^` and `_` raise and lower, `\hat`, `\bar`, `\dot` and `\tilde`
//! put an accent, an unknown `\command` is written out. Greek and raised characters typed directly (`τ`, `m²`) work as well. `\$` is a dollar.
//!
//! # What is drawn and what is not
//! A NaN or an infinity, and on a logarithmic axis zero or a negative number, is a gap: the line stops before it and starts again after it. A point with
//! gaps on both sides is drawn as a dot. A figure without a single point that its axes can show says so in the frame.
//!
//! # The build
//! Drawing needs the feature `plots` (on by default). Without it the data model is the same and drawing answers [`PlotError::NotBuilt`].

mod figure;

#[cfg(feature = "plots")]
mod canvas;
#[cfg(feature = "plots")]
mod inline;
#[cfg(feature = "plots")]
mod inset;
#[cfg(feature = "plots")]
mod interval;
#[cfg(feature = "plots")]
mod label;
#[cfg(feature = "plots")]
mod legend;
#[cfg(feature = "plots")]
mod map;
#[cfg(feature = "plots")]
mod panel;
#[cfg(feature = "plots")]
mod raster;
#[cfg(feature = "plots")]
mod render;
#[cfg(feature = "plots")]
mod style;
#[cfg(feature = "plots")]
mod ticks;
#[cfg(feature = "plots")]
mod typeface;
#[cfg(feature = "plots")]
mod vector;

pub use figure::{Axis, Colour, Curve, Figure, Inset, LegendPlace, Line, Map, Marker, MarkerSpacing, Residuals, Scale, Width};

use thiserror::Error;

/// Why a figure is not drawn.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum PlotError {
    /// This build has no plots.
    #[error("this build of viscotack draws no plots: build it with the feature `plots`")]
    NotBuilt,
    /// The range asked for cannot be an axis.
    #[error("the axis \"{axis}\" cannot run from {lower:e} to {upper:e}: {reason}")]
    UnusableRange {
        /// The label of the axis.
        axis: String,
        /// The lower end asked for.
        lower: f64,
        /// The upper end asked for.
        upper: f64,
        /// What is wrong, in words.
        reason: &'static str,
    },
    /// The image could not be made.
    #[error("the picture could not be written: {detail}")]
    NotWritten {
        /// What the reason is.
        detail: String,
    },
}

/// Draws the figure as an SVG document: vectors and text, sized in millimetres.
///
/// # Errors
/// [`PlotError::UnusableRange`] for an impossible axis range, [`PlotError::NotBuilt`] without the feature `plots`.
pub fn svg(figure: &Figure) -> Result<String, PlotError> {
    #[cfg(feature = "plots")]
    {
        render::svg(figure)
    }
    #[cfg(not(feature = "plots"))]
    {
        let _ = figure;
        Err(PlotError::NotBuilt)
    }
}

/// Draws the figure as a PNG image, 400 dots per inch on white, with a typeface carried inside the program.
///
/// # Errors
/// Those of [`svg`], and [`PlotError::NotWritten`] if the image cannot be encoded.
pub fn png(figure: &Figure) -> Result<Vec<u8>, PlotError> {
    #[cfg(feature = "plots")]
    {
        render::png(figure)
    }
    #[cfg(not(feature = "plots"))]
    {
        let _ = figure;
        Err(PlotError::NotBuilt)
    }
}

/// A document of [`svg()`] as a part of an HTML page, as [`inline_svg`] draws it.
#[must_use]
pub fn inlined(document: &str, label: &str) -> String {
    #[cfg(feature = "plots")]
    {
        inline::inline(document, label)
    }
    #[cfg(not(feature = "plots"))]
    {
        let _ = label;
        document.to_owned()
    }
}

/// Draws the figure as a part of an HTML page: an `<svg>` element as wide as its place, described by `label`, whose ink is the colour of the text around it,
/// whose paper is `var(--paper)` and whose curves take `var(--curve-0)` to `var(--curve-6)`, see [`curve_colours`].
///
/// # Errors
/// Those of [`svg`].
pub fn inline_svg(figure: &Figure, label: &str) -> Result<String, PlotError> {
    #[cfg(feature = "plots")]
    {
        Ok(inline::inline(&render::svg(figure)?, label))
    }
    #[cfg(not(feature = "plots"))]
    {
        let _ = (figure, label);
        Err(PlotError::NotBuilt)
    }
}

/// The colours of curves on white paper, as `#rrggbb`, by index; none in a build without plots.
#[must_use]
pub fn curve_colours() -> Vec<String> {
    #[cfg(feature = "plots")]
    {
        inline::palette()
    }
    #[cfg(not(feature = "plots"))]
    {
        Vec::new()
    }
}
