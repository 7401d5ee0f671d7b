//! Bounds against true errors: misses, how wide bounds are, and what accuracy takes.
//!
//! A bound is missed where |value − truth| > bound + bound of the truth. How wide it is, bound/|value − truth|, can be known where the truth is known ten times better
//! than the bound and the bound is above rounding and stated floors; an error below what is known of the truth counts as that much.

use viscotack::estimate::Estimate;

/// Bounds below so many ulp of the value or of its scale are rounding.
const ROUNDING: f64 = 4096.0 * f64::EPSILON;
/// So are bounds that are less than so many times a stated floor, most of which is the floor.
const FLOORS: f64 = 2.0;
/// The truth must be known so much better than the bound.
const BETTER: f64 = 10.0;

/// Where a truth comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Truth {
    /// The solver, asked for a thousand times more or its floor.
    Tighter,
    /// Another route: [`crate::studies::known_states`].
    Another,
}

/// One number beside its truth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Compared {
    /// Which.
    pub quantity: &'static str,
    /// As returned.
    pub found: Estimate,
    /// The truth, with what is not known of it.
    pub truth: Estimate,
    /// What rounding is relative to, besides the value: the scale of the quantity.
    pub scale: f64,
    /// What the solver states that it can't tell at any accuracy.
    pub floor: f64,
}

impl Compared {
    /// Whether the bound does not reach the truth.
    #[must_use]
    pub fn is_missed(&self) -> bool {
        let off = (self.found.value - self.truth.value).abs();
        let reach = self.found.error + self.truth.error;
        // A NaN is a miss.
        off.is_nan() || reach.is_nan() || off > reach
    }

    /// Bound over true error, where it can be known.
    #[must_use]
    pub fn width(&self) -> Option<f64> {
        let floor = (ROUNDING * self.found.value.abs().max(self.scale)).max(FLOORS * self.floor);
        let known = BETTER * self.truth.error <= self.found.error;
        let off = (self.found.value - self.truth.value).abs();
        (known && self.found.error > floor && self.found.error.is_finite())
            .then(|| self.found.error / off.max(self.truth.error).max(f64::MIN_POSITIVE))
    }
}

/// One scene: its numbers beside their truths, or what went wrong.
#[derive(Debug, Clone)]
pub struct Assessed {
    /// Its number in the stream.
    pub scene: u64,
    /// The accuracy asked for.
    pub accuracy: f64,
    /// In words and numbers that draw it again.
    pub described: String,
    /// The numbers; empty where no such state exists, which both answers must say.
    pub compared: Vec<Compared>,
    /// Where the truth comes from.
    pub truth: Truth,
    /// What went wrong besides missed bounds: an answer that is lost at another accuracy, or an accuracy that was not reached.
    pub trouble: Option<String>,
}

/// Bounds of a problem, counted.
#[derive(Debug, Clone, Default)]
pub struct Tally {
    /// Scenes.
    pub scenes: usize,
    /// Scenes with numbers.
    pub solved: usize,
    /// Scenes whose truth is another route's.
    pub by_another_route: usize,
    /// Numbers compared.
    pub values: usize,
    /// Missed bounds: scene, quantity, value, bound, truth.
    pub misses: Vec<(u64, Compared)>,
    /// Scenes with trouble.
    pub troubles: Vec<(u64, String)>,
    /// Bound over true error, sorted.
    pub widths: Vec<f64>,
}

impl Tally {
    /// Counts scenes.
    #[must_use]
    pub fn of(assessed: &[Assessed]) -> Self {
        let mut tally = Self { scenes: assessed.len(), ..Self::default() };
        for scene in assessed {
            tally.solved += usize::from(!scene.compared.is_empty());
            tally.by_another_route += usize::from(scene.truth == Truth::Another);
            tally.values += scene.compared.len();
            tally.misses.extend(scene.compared.iter().filter(|one| one.is_missed()).map(|one| (scene.scene, *one)));
            tally.widths.extend(scene.compared.iter().filter_map(Compared::width));
            tally.troubles.extend(scene.trouble.iter().map(|trouble| (scene.scene, format!("{trouble}: {}", scene.described))));
        }
        tally.widths.sort_by(f64::total_cmp);
        tally
    }

    /// A quantile of bound over true error; none without any.
    #[must_use]
    pub fn width(&self, part: f64) -> Option<f64> {
        let last = self.widths.len().checked_sub(1)?;
        self.widths.get((part * last as f64).round() as usize).copied()
    }
}
