//! Mutations of curves: what a feature must notice.

use super::curve::Curve;

/// A change of the data that leaves it a curve and makes it another one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mutation {
    /// y three times as large.
    Scaled,
    /// y of the opposite sign.
    Negated,
    /// y turned upside down between its smallest and its largest.
    Flipped,
    /// y everywhere as at the first point.
    Flat,
    /// x three times as large.
    Stretched,
    /// x of the opposite sign.
    Mirrored,
    /// Every other curve that the feature names is the first one.
    Merged,
    /// The curves that the feature names, in the opposite order.
    Swapped,
}

impl Mutation {
    /// All of them.
    pub const ALL: [Self; 8] =
        [Self::Scaled, Self::Negated, Self::Flipped, Self::Flat, Self::Stretched, Self::Mirrored, Self::Merged, Self::Swapped];

    /// Its word in tables.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Scaled => "scaled",
            Self::Negated => "negated",
            Self::Flipped => "flipped",
            Self::Flat => "flat",
            Self::Stretched => "stretched",
            Self::Mirrored => "mirrored",
            Self::Merged => "merged",
            Self::Swapped => "swapped",
        }
    }

    /// The curves that a feature names, the first one (or the order of all) mutated.
    pub(super) fn of(self, curves: &[Curve]) -> Vec<Curve> {
        let mut mutated = curves.to_vec();
        let Some(first) = curves.first() else { return mutated };
        let mut change = |change: &dyn Fn(f64, f64) -> (f64, f64)| {
            if let Some(own) = mutated.first_mut() {
                for point in &mut own.points {
                    (point.x, point.y) = change(point.x, point.y);
                }
            }
        };
        let solved = first.solved();
        let (low, high) = solved.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), (_, y)| (low.min(*y), high.max(*y)));
        match self {
            Self::Scaled => change(&|x, y| (x, 3.0 * y)),
            Self::Negated => change(&|x, y| (x, -y)),
            Self::Flipped => change(&|x, y| (x, low + (high - y))),
            Self::Flat => {
                let level = solved.first().map_or(0.0, |(_, y)| *y);
                change(&|x, y| (x, if y.is_finite() { level } else { y }));
            }
            Self::Stretched => change(&|x, y| (3.0 * x, y)),
            Self::Mirrored => change(&|x, y| (-x, y)),
            Self::Merged => {
                for own in mutated.iter_mut().skip(1) {
                    own.points.clone_from(&first.points);
                }
            }
            Self::Swapped => {
                let points: Vec<_> = curves.iter().rev().map(|curve| curve.points.clone()).collect();
                for (own, points) in mutated.iter_mut().zip(points) {
                    own.points = points;
                }
            }
        }
        mutated
    }
}
