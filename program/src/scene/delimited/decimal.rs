//! The decimal sign of a table, from all its numbers; what would change a number and stays open is refused.

use super::number::{Decimal, Shape};
use super::split::Cell;

/// The first cells that show something.
#[derive(Debug, Default)]
pub(super) struct Evidence {
    point: Option<Cell>,
    comma: Option<Cell>,
    comma_groups: Option<Cell>,
    point_groups: Option<Cell>,
    ambiguous_point: Option<Cell>,
    ambiguous_comma: Option<Cell>,
    /// An ambiguous comma outside quotation marks.
    bare_comma: Option<Cell>,
}

/// What the numbers do not settle.
#[derive(Debug, Clone, Copy)]
pub(super) enum Open {
    /// Both signs break numbers: in the first cell and in the second.
    Both(Cell, Cell),
    /// This number has a mark before three digits: the sign if it is one, and whether other numbers have the other sign.
    Ambiguous { cell: Cell, sign: Decimal, other: bool },
}

/// The sign, and a number in which the other one groups thousands.
#[derive(Debug, Clone, Copy)]
pub(super) struct Chosen {
    pub(super) decimal: Decimal,
    pub(super) grouped: Option<Cell>,
    /// A number whose point is taken as the decimal sign, where no other number shows that it is.
    pub(super) taken: Option<Cell>,
}

impl Evidence {
    pub(super) fn add(&mut self, cell: Cell, shape: Shape) {
        let slot = match shape {
            Shape::Broken(Decimal::Point) => &mut self.point,
            Shape::Broken(Decimal::Comma) => &mut self.comma,
            Shape::Grouped(Decimal::Point) => &mut self.comma_groups,
            Shape::Grouped(Decimal::Comma) => &mut self.point_groups,
            Shape::Ambiguous(Decimal::Point) => &mut self.ambiguous_point,
            Shape::Ambiguous(Decimal::Comma) => {
                if !cell.quoted {
                    self.bare_comma.get_or_insert(cell);
                }
                &mut self.ambiguous_comma
            }
            Shape::Text | Shape::Missing | Shape::Whole => return,
        };
        slot.get_or_insert(cell);
    }

    /// The sign, if the numbers settle it.
    pub(super) fn decide(&self) -> Result<Chosen, Open> {
        let (point, comma) = (self.point.or(self.comma_groups), self.comma.or(self.point_groups));
        let by_groups = |decimal| match decimal {
            Decimal::Point => self.comma_groups.or(self.ambiguous_comma),
            Decimal::Comma => self.point_groups.or(self.ambiguous_point),
        };
        let decimal = match (point, comma) {
            (Some(one), Some(other)) => return Err(Open::Both(one, other)),
            (None, Some(_)) => {
                if let (Some(cell), None) = (self.ambiguous_point, self.point_groups) {
                    return Err(Open::Ambiguous { cell, sign: Decimal::Point, other: true });
                }
                Decimal::Comma
            }
            (Some(_), None) => {
                // In quotation marks, commas between digits were protected from being separators: thousands, since the sign is a point.
                if let (Some(cell), None) = (self.bare_comma, self.comma_groups) {
                    return Err(Open::Ambiguous { cell, sign: Decimal::Comma, other: true });
                }
                Decimal::Point
            }
            (None, None) => match self.ambiguous_comma {
                Some(cell) => return Err(Open::Ambiguous { cell, sign: Decimal::Comma, other: false }),
                None => Decimal::Point,
            },
        };
        let taken = if point.is_none() && decimal == Decimal::Point { self.ambiguous_point } else { None };
        Ok(Chosen { decimal, grouped: by_groups(decimal), taken })
    }
}
