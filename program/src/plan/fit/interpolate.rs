//! Values between the points of a way: cubic within smooth pieces, along one abscissa that rises or falls.

/// A branch of a curve: abscissa rising, ordinate, piece of each point.
#[derive(Debug, Clone)]
pub(super) struct Branch {
    at: Vec<f64>,
    piece: Vec<u32>,
    /// Places among the points of the way.
    places: Vec<usize>,
    /// +1 if the abscissa rises along the way, −1 if it falls.
    sign: f64,
}

impl Branch {
    /// Of points from a place to another; where the abscissa goes back, points are passed over.
    pub(super) fn of(abscissa: &[f64], pieces: &[u32], places: std::ops::RangeInclusive<usize>) -> Self {
        let ends = abscissa.get(*places.start()).zip(abscissa.get(*places.end()));
        let sign = if ends.is_some_and(|(first, last)| last < first) { -1.0 } else { 1.0 };
        let mut branch = Self { at: Vec::new(), piece: Vec::new(), places: Vec::new(), sign };
        for place in places {
            let (Some(value), Some(piece)) = (abscissa.get(place), pieces.get(place)) else { continue };
            let here = sign * value;
            if branch.at.last().is_some_and(|last| here <= *last) {
                // Of two points at one place the later one counts: what was at once is over.
                if branch.at.last().is_some_and(|last| here >= *last)
                    && let (Some(last), Some(own)) = (branch.places.last_mut(), branch.piece.last_mut())
                {
                    (*last, *own) = (place, *piece);
                }
                continue;
            }
            branch.at.push(here);
            branch.piece.push(*piece);
            branch.places.push(place);
        }
        branch
    }

    /// The ordinate at an abscissa, held beyond the ends.
    pub(super) fn value(&self, ordinate: &[f64], abscissa: f64) -> Option<f64> {
        let sought = self.sign * abscissa;
        let y = |index: usize| self.places.get(index).and_then(|place| ordinate.get(*place)).copied();
        let next = self.at.partition_point(|at| *at < sought);
        let Some(before) = next.checked_sub(1) else { return y(0) };
        if next >= self.at.len() {
            return y(before);
        }
        let (from, to) = (*self.at.get(before)?, *self.at.get(next)?);
        let (first, second) = (y(before)?, y(next)?);
        let (width, rise) = (to - from, second - first);
        let chord = rise / width;
        // Slopes by parabolas through the neighbours of the same piece; a piece's first point ends the one before.
        let piece = *self.piece.get(next)?;
        let slope = |left: Option<usize>, right: Option<usize>, middle: usize| -> f64 {
            let (Some(left), Some(right)) = (left, right) else { return chord };
            let (Some(x0), Some(x1), Some(x2)) = (self.at.get(left), self.at.get(middle), self.at.get(right)) else { return chord };
            let (Some(y0), Some(y1), Some(y2)) = (y(left), y(middle), y(right)) else { return chord };
            let (one, two) = ((y1 - y0) / (x1 - x0), (y2 - y1) / (x2 - x1));
            (one * (x2 - x1) + two * (x1 - x0)) / (x2 - x0)
        };
        let same = |index: Option<usize>| index.filter(|index| self.piece.get(*index) == Some(&piece));
        let starts = self.piece.get(before) != Some(&piece);
        let left = slope(if starts { None } else { before.checked_sub(1) }, Some(next), before);
        let right = slope(Some(before), same(Some(next + 1)), next);
        let part = (sought - from) / width;
        let (a, b) = (left * width - rise, rise - right * width);
        Some(first + part * (rise + (1.0 - part) * (a * (1.0 - part) + b * part)))
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::Branch;

    #[test]
    fn parabolas_are_met_within_a_piece_both_ways() {
        let at: Vec<f64> = [0.0, 0.4, 1.0, 1.3, 2.0].to_vec();
        let down: Vec<f64> = at.iter().map(|x| -x).collect();
        let y: Vec<f64> = at.iter().map(|x| 1.0 + x * x).collect();
        for (abscissa, sign) in [(&at, 1.0), (&down, -1.0)] {
            let branch = Branch::of(abscissa, &[0; 5], 0..=4);
            assert!((branch.value(&y, sign * 0.7).unwrap() - 1.49).abs() < 1e-14);
            assert!((branch.value(&y, sign * 9.0).unwrap() - 5.0).abs() < 1e-14);
        }
    }

    #[test]
    fn a_kink_between_pieces_stays_sharp() {
        let (at, y) = ([0.0, 1.0, 2.0, 3.0, 4.0], [0.0, 1.0, 2.0, 1.0, 0.0]);
        let branch = Branch::of(&at, &[0, 0, 0, 1, 1], 0..=4);
        assert!((branch.value(&y, 1.9).unwrap() - 1.9).abs() < 1e-14);
        assert!((branch.value(&y, 2.1).unwrap() - 1.9).abs() < 1e-14);
    }
}
