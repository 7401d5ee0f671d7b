//! Values relative to the one before, of a history whose one quantity is always known: that of a crack.

use super::section::Section;
use crate::scene::diagnostic::SceneError;
use crate::scene::typed::{History, HistorySegment};

/// Replaces every `by` by the value that it leads to, from zero at the start.
pub(super) fn absolute(history: &mut History, items: &[Section<'_>]) -> Result<(), SceneError> {
    let mut present = 0.0;
    for (segment, table) in history.segments.iter_mut().zip(&history.tables) {
        if let HistorySegment::By { quantity, change, pace } = *segment {
            let value = present + change;
            if let (false, Some(item)) = (quantity.range().holds(value), items.get(*table)) {
                let message = format!("`{}` leads from {present:e} to {value:e}", item.full("by"));
                return Err(item.wrong("by", message, format!("`{}` must stay {}", quantity.word(), quantity.range().words())));
            }
            *segment = match pace {
                Some(pace) => HistorySegment::Ramp { quantity, value, pace },
                None => HistorySegment::Step { quantity, value },
            };
        }
        present = match segment {
            HistorySegment::Step { value, .. } | HistorySegment::Ramp { value, .. } => *value,
            HistorySegment::Table { table, .. } => table.values.last().copied().unwrap_or(present),
            HistorySegment::Cycles { lower, .. } => *lower,
            _ => present,
        };
    }
    Ok(())
}
