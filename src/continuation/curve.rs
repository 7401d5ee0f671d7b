//! Two equations in three unknowns, and the points of the curve on which both hold.

use crate::refusal::Refusal;
use nalgebra::Vector3;

/// Usual step of difference quotients, in scaled unknowns.
const DIFFERENCE: f64 = 1e-6;

/// Two equations in three unknowns.
pub trait CurveEquations {
    /// What an evaluation leaves besides numbers.
    type State: Clone;

    /// The equations at a point.
    ///
    /// # Errors
    /// Where they mean nothing.
    fn evaluate(&self, unknowns: [f64; 3]) -> Result<Evaluated<Self::State>, Refusal>;

    /// What each unknown is measured in near a point; positive.
    fn scales(&self, unknowns: [f64; 3]) -> [f64; 3];

    /// The steps of the difference quotients near a point, in scaled unknowns.
    fn differences(&self, _unknowns: [f64; 3]) -> [f64; 3] {
        [DIFFERENCE; 3]
    }

    /// By how much each unknown must change to change the equations by about one; where that is less than their scales, differences are taken over it.
    fn natural(&self, unknowns: [f64; 3]) -> [f64; 3] {
        self.scales(unknowns)
    }

    /// Whether a solution can exist.
    ///
    /// # Errors
    /// Those of the check itself.
    fn admissible(&self, state: &Self::State) -> Result<bool, Refusal>;
}

/// What the equations give at a point.
#[derive(Debug, Clone)]
pub struct Evaluated<S> {
    /// The two residuals, of order one away from the curve.
    pub residual: [f64; 2],
    /// A further quantity whose turning is of interest.
    pub watched: f64,
    /// What rounding leaves uncertain of each residual.
    pub rounding: [f64; 2],
    /// What the evaluation leaves besides.
    pub state: S,
}

/// A quantity that may turn along a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// One of the three unknowns (0, 1 or 2).
    Unknown(usize),
    /// The watched quantity.
    Watched,
}

impl Quantity {
    /// Its value at a point.
    #[must_use]
    pub fn of(self, unknowns: [f64; 3], watched: f64) -> f64 {
        match self {
            Self::Unknown(index) => unknowns.get(index).copied().unwrap_or(f64::NAN),
            Self::Watched => watched,
        }
    }
}

/// A point of a curve with its tangent.
#[derive(Debug, Clone)]
pub struct CurvePoint<S> {
    /// The unknowns.
    pub unknowns: [f64; 3],
    /// The watched quantity.
    pub watched: f64,
    /// What the equations left.
    pub state: S,
    /// The scales of the unknowns here.
    pub scales: [f64; 3],
    /// Unit tangent in scaled unknowns.
    pub tangent: [f64; 3],
    /// Derivatives of both residuals and of the watched quantity in scaled unknowns.
    pub rows: [[f64; 3]; 3],
    /// Arclength from the start, in the local scales of each step; negative on the other side.
    pub arclength: f64,
}

impl<S> CurvePoint<S> {
    /// The value of a quantity.
    #[must_use]
    pub fn value(&self, quantity: Quantity) -> f64 {
        quantity.of(self.unknowns, self.watched)
    }

    /// d quantity/d arclength.
    #[must_use]
    pub fn slope(&self, quantity: Quantity) -> f64 {
        match quantity {
            Quantity::Unknown(index) => self.tangent.get(index).zip(self.scales.get(index)).map_or(f64::NAN, |(part, scale)| part * scale),
            Quantity::Watched => self.rows[2].iter().zip(&self.tangent).map(|(row, part)| row * part).sum(),
        }
    }
}

/// The tangent and the derivatives at a point of a curve; three evaluations.
///
/// # Errors
/// Those of the equations; [`Refusal::NotConverged`] where both equations have the same gradient.
pub(crate) fn linearized<E: CurveEquations>(
    equations: &E,
    unknowns: [f64; 3],
    here: &Evaluated<E::State>,
) -> Result<([[f64; 3]; 3], Vector3<f64>), Refusal> {
    let (scales, differences) = (equations.scales(unknowns), equations.differences(unknowns));
    let mut rows = [[0.0; 3]; 3];
    for (index, difference) in differences.into_iter().enumerate() {
        let mut moved = unknowns;
        if let (Some(unknown), Some(scale)) = (moved.get_mut(index), scales.get(index)) {
            *unknown += difference * scale;
        }
        let there = equations.evaluate(moved)?;
        for (row, change) in
            rows.iter_mut().zip([there.residual[0] - here.residual[0], there.residual[1] - here.residual[1], there.watched - here.watched])
        {
            row[index] = change / difference;
        }
    }
    Ok((rows, tangent_of(&rows)?))
}

/// The unit vector along which neither equation changes.
///
/// # Errors
/// [`Refusal::NotConverged`] where both equations have the same gradient.
pub(crate) fn tangent_of(rows: &[[f64; 3]; 3]) -> Result<Vector3<f64>, Refusal> {
    // Of nearly equal gradients the difference is taken first: it is exact.
    let (first, second) = (Vector3::from(rows[0]), Vector3::from(rows[1]));
    let other = if (second - first).norm() < second.norm() { second - first } else { second };
    let cross = first.normalize().cross(&other.normalize());
    let length = cross.norm();
    if length > 1e-12 {
        Ok(cross / length)
    } else {
        Err(Refusal::NotConverged { what: "the tangent of a curve", detail: "both equations have the same gradient".into() })
    }
}
