//! The way of a history as columns of numbers without bounds: what is compared with a measured curve.

/// Points in the order of time, in the units of the scene.
#[derive(Debug, Clone, PartialEq)]
pub struct PathCurve {
    /// Words and numbers: `time` first.
    pub columns: Vec<(&'static str, Vec<f64>)>,
    /// Smooth piece of each point.
    pub pieces: Vec<u32>,
    /// First and last point in contact; none without contact.
    pub contact: Option<[usize; 2]>,
    /// Values of the columns where the surface jumped into contact first; none if it did not.
    pub gained: Option<Vec<f64>>,
    /// Values of the columns where the contact was lost for good; none if it was not.
    pub lost: Option<Vec<f64>>,
    /// Whether a force acts without contact.
    pub at_a_distance: bool,
}

impl PathCurve {
    /// A column by its word.
    #[must_use]
    pub fn column(&self, word: &str) -> Option<&[f64]> {
        self.columns.iter().find(|column| column.0 == word).map(|column| column.1.as_slice())
    }

    /// Where the surface jumped into contact, of a column.
    #[must_use]
    pub fn gained_at(&self, word: &str) -> Option<f64> {
        self.gained.as_ref()?.get(self.place(word)?).copied()
    }

    /// Where the contact was lost, of a column.
    #[must_use]
    pub fn lost_at(&self, word: &str) -> Option<f64> {
        self.lost.as_ref()?.get(self.place(word)?).copied()
    }

    fn place(&self, word: &str) -> Option<usize> {
        self.columns.iter().position(|column| column.0 == word)
    }
}
