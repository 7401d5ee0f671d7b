//! Where a model may fail: numbers formed for every row, and the assessment of the worst of them.

use crate::outcome::{Assessment, Row, Validity};
use crate::scene::typed::PoissonRatio;

/// Which way an assumption fails.
#[derive(Clone, Copy)]
pub(super) enum Limit {
    Below(f64),
    Above(f64),
}

/// One assumption of a model, assessed by a number of every row.
pub(super) struct Assumption {
    pub(super) name: &'static str,
    pub(super) limit: Limit,
    pub(super) meaning: &'static str,
}

/// The assessment of the worst number of each assumption; nothing on one that no row has a number for.
pub(super) fn assessed(assumptions: &[Assumption], rows: &[Row]) -> Vec<Validity> {
    let assessment = |(index, assumption): (usize, &Assumption)| {
        let values = rows.iter().filter_map(|row| row.assumptions.get(index).copied().flatten());
        let (worst, good) = match assumption.limit {
            Limit::Below(limit) => values.reduce(f64::max).map(|worst| (worst, worst < limit)),
            Limit::Above(limit) => values.reduce(f64::min).map(|worst| (worst, worst > limit)),
        }?;
        Some(Validity {
            name: assumption.name.into(),
            value: Some(worst),
            assessment: if good { Assessment::Good } else { Assessment::Caution },
            meaning: assumption.meaning.into(),
        })
    };
    assumptions.iter().enumerate().filter_map(assessment).collect()
}

/// An assumption that the scene holds no number for.
pub(super) fn not_assessed(name: &str, value: Option<f64>, meaning: &str) -> Validity {
    Validity { name: name.into(), value, assessment: Assessment::NotAssessed, meaning: meaning.into() }
}

/// The assumption of a constant Poisson ratio; none where it follows from the bulk modulus.
pub(super) fn constant_poisson_ratio(ratio: PoissonRatio) -> Option<Validity> {
    let meaning = "assumed at all times; it rises by up to 0.1 from the glassy to the rubbery state";
    (!matches!(ratio, PoissonRatio::Following(_))).then(|| not_assessed("constant Poisson ratio", ratio.constant(), meaning))
}
