//! Lines in the way of the tip: evenly apart, and graded over the zone after a start.
//!
//! Just after a start the fastest terms answer while the tip crosses ℓ = ẋ₀/l_max of a zone, often far less than a line. Lines graded from there
//! keep the order of stepping: with i lines passed, s = i/m and x in zones,
//! ```text
//! dx/ds = min(1, (x + ℓ)/σ)      x(2) = 1 sets σ: twice as many lines in the first zone
//! x = ℓ(e^{s/σ} − 1)             up to dx/ds = 1; evenly from there
//! ```
//! The map does not know m, so lines of a coarse grid are lines of a finer one and the error goes by powers of 1/m. The second zone
//! starts at its kink, where the places of the graded lines leave the process zone, with a grading of its own.

use serde::{Deserialize, Serialize};

/// Layers wider than this are resolved by even lines.
const WIDEST_LAYER: f64 = 0.1;

/// Finer layers are of no weight for the place, and lines come near the rounding of places.
const FINEST_LAYER: f64 = 1e-6;

/// A line that is nearer ahead than this part of the distance to the one after it counts as reached: where a step ends is rounded, and a step between two
/// roundings of one line would be decided by rounding alone.
const REACHED: f64 = 1e-3;

/// The grading of a zone.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
struct Grading {
    layer: f64,
    sigma: f64,
    /// s and x where the lines become even.
    even_from: [f64; 2],
}

impl Grading {
    /// Zones of even lines that the graded zone costs.
    const ZONES: f64 = 2.0;

    fn new(layer: f64) -> Self {
        // σ(ln(σ/ℓ) − 1) + ℓ = 1 rises with σ ≥ ℓ: by its derivative ln(σ/ℓ), and convex, so Newton comes from above.
        let mut sigma = 1.0_f64;
        for _ in 0..20 {
            sigma -= (sigma * ((sigma / layer).ln() - 1.0) + layer - (Self::ZONES - 1.0)) / (sigma / layer).ln();
        }
        Self { layer, sigma, even_from: [sigma * (sigma / layer).ln(), sigma - layer] }
    }

    fn place(&self, s: f64) -> f64 {
        let [s_even, x_even] = self.even_from;
        if s >= Self::ZONES {
            1.0 + (s - Self::ZONES)
        } else if s >= s_even {
            x_even + (s - s_even)
        } else {
            self.layer * (s / self.sigma).exp_m1()
        }
    }
}

/// The lines, counted from a start.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(super) struct Grid {
    /// In places of the memory.
    start: f64,
    zone: f64,
    lines_per_zone: u32,
    passed: u64,
    grading: Option<Grading>,
}

impl Grid {
    /// Even lines from a place on.
    pub(super) const fn even(start: f64, zone: f64, lines_per_zone: u32) -> Self {
        Self { start, zone, lines_per_zone, passed: 0, grading: None }
    }

    /// Lines from a place on where the fastest term answers over `layer` zones.
    pub(super) fn graded(start: f64, zone: f64, lines_per_zone: u32, layer: f64) -> Self {
        let grading = (layer < WIDEST_LAYER).then(|| Grading::new(layer.max(FINEST_LAYER)));
        Self { grading, ..Self::even(start, zone, lines_per_zone) }
    }

    /// The layer that the lines are graded for, in zones.
    pub(super) fn layer(&self) -> f64 {
        self.grading.map_or(WIDEST_LAYER, |grading| grading.layer)
    }

    /// Grades a grid that no line has been passed of for a finer layer, if that is one.
    pub(super) fn refine(&mut self, layer: f64) {
        if layer < self.layer() {
            *self = Self::graded(self.start, self.zone, self.lines_per_zone, layer);
        }
    }

    fn offset(&self, line: u64) -> f64 {
        let s = line as f64 / f64::from(self.lines_per_zone);
        self.zone * self.grading.map_or(s, |grading| grading.place(s))
    }

    /// The next line, in places of the memory.
    pub(super) fn next_line(&self) -> f64 {
        self.start + self.offset(self.passed + 1)
    }

    /// Whether the lines are even here.
    pub(super) fn is_even(&self) -> bool {
        self.grading.is_none_or(|_| self.passed as f64 >= Grading::ZONES * f64::from(self.lines_per_zone))
    }

    /// Passes the lines that a step to this place has reached; whether there are any.
    pub(super) fn reach(&mut self, place: f64) -> bool {
        let before = self.passed;
        while self.next_line() - place <= REACHED * (self.offset(self.passed + 2) - self.offset(self.passed + 1)) {
            self.passed += 1;
        }
        self.passed > before
    }

    /// The line just reached is here, and the lines ahead are those of another zone.
    pub(super) fn rescale(&mut self, place: f64, zone: f64) {
        self.zone = zone;
        self.start = place - self.offset(self.passed);
    }

    /// The zero of places is moved ahead.
    pub(super) fn shift(&mut self, distance: f64) {
        self.start -= distance;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A step that ends on a line, to rounding, has reached it: the next line is a whole distance ahead, however the end was rounded.
    #[test]
    fn no_line_is_left_within_rounding_of_the_place() {
        for layer in [1e-6, 3e-4, 0.02, 1.0] {
            for lines in [32, 223, 960, 16_384] {
                for ulps in [-2_i32, -1, 0, 1, 2] {
                    let mut grid = Grid::graded(3.7, 0.3, lines, layer);
                    let mut place = 3.7;
                    for line in 1..=3 * u64::from(lines) {
                        let wanted = grid.start + grid.offset(line);
                        let step = grid.next_line() - place;
                        assert!(step > 0.99 * (grid.offset(line) - grid.offset(line - 1)), "{layer} {lines} {ulps} {line}: {step:e}");
                        place = wanted + f64::from(ulps) * 4.5e-16;
                        assert!(grid.reach(place), "{layer} {lines} {ulps} {line}");
                        assert_eq!(grid.passed, line);
                    }
                }
            }
        }
    }

    #[test]
    fn graded_lines_are_nested_start_in_the_layer_and_end_even() {
        for layer in [1e-9, 1e-6, 3e-4, 0.02, 0.0999] {
            let grid = |lines| Grid::graded(0.0, 1.0, lines, layer);
            let (coarse, fine) = (grid(16), grid(64));
            let mut last_step = 0.0;
            for line in 0..80_u64 {
                let place = coarse.offset(line);
                assert!((place - fine.offset(4 * line)).abs() <= 1e-15, "{layer} {line}");
                let step = coarse.offset(line + 1) - place;
                // Never wider than even lines, and never narrower than the line before.
                assert!(step > 0.0 && step <= 1.0 / 16.0 + 1e-14 && step >= last_step * (1.0 - 1e-9), "{layer} {line} {step}");
                last_step = step;
            }
            assert!((coarse.offset(32) - 1.0).abs() < 1e-14 && (coarse.offset(31) - 1.0 + 1.0 / 16.0).abs() < 1e-12);
            assert!(fine.offset(1) < coarse.layer(), "{layer}");
        }
    }
}
