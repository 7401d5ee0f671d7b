//! What ends a segment before it ends by itself.

use super::section::Section;
use crate::scene::diagnostic::SceneError;
use crate::scene::typed::{Condition, HistoryQuantity, HistorySegment};

/// What a condition may be of; the first four are quantities.
const CONDITIONS: [&str; 6] = ["force", "penetration", "contact_radius", "frame", "event", "time"];

/// A segment with its condition, if it has one; only an indenter's may.
pub(super) fn ended(item: &Section<'_>, segment: HistorySegment, indents: bool) -> Result<HistorySegment, SceneError> {
    let Some(table) = item.table("until") else { return Ok(segment) };
    if !indents {
        let message = format!("`{}`: only the history of an indenter has conditions", item.full("until"));
        return Err(SceneError::at(&item.key_place("until"), message, "leave it out"));
    }
    let at_once = match &segment {
        HistorySegment::Step { quantity, .. } | HistorySegment::By { quantity, pace: None, .. } => Some(*quantity),
        _ => None,
    };
    if let Some(quantity) = at_once {
        let message = format!("`{}`: this segment goes to its value at once, and has no way to stop on", item.full("until"));
        let rate = if quantity == HistoryQuantity::Force { "rate = \"1 mN/s\"" } else { "rate = \"1 µm/s\"" };
        return Err(SceneError::at(&item.key_place("until"), message, "in this segment").help(format!("add {rate}, or a duration")));
    }
    let condition = match table.exactly_one(&CONDITIONS)? {
        "event" => table.required_text("event").map(|_| Condition::Detachment)?,
        "time" => Condition::Time(table.required_number("time")?),
        word => {
            let Some(quantity) = HistoryQuantity::of_word(word) else { return Err(table.missing(word)) };
            Condition::Reaches(quantity, table.required_number(word)?)
        }
    };
    Ok(HistorySegment::Until { segment: Box::new(segment), condition })
}
