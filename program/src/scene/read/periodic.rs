//! What an oscillation that has gone on for ever cannot be asked together with.

use super::section::Section;
use crate::scene::diagnostic::SceneError;
use crate::scene::typed::{History, HistoryQuantity, HistorySegment, IndentationShape, IndentationStart};
use viscotack::indentation::EdgeLaw;

/// What integrates the cycles that lead to the periodic one instead.
const INSTEAD: &str =
    "write cycles = 1000, until_stationary = true in place of periodic = true: the cycles that lead to the stationary one are integrated";

/// Refuses what a periodic state does not have, or its solver does not solve.
pub(super) fn possible(
    top: &Section<'_>,
    table: &Section<'_>,
    history: &History,
    shape: &IndentationShape,
    (start, given, rim, edge_law): (IndentationStart, HistoryQuantity, Option<f64>, &EdgeLaw),
) -> Result<(), SceneError> {
    let periodic = |segment: &HistorySegment| match segment {
        HistorySegment::Oscillation(oscillation) if oscillation.is_periodic() => Some(oscillation.quantity),
        _ => None,
    };
    let items = top.items("history");
    let found = history.segments.iter().enumerate().find_map(|(index, segment)| {
        let quantity = periodic(segment)?;
        items.get(history.table(index)).map(|item| (quantity, item))
    });
    let Some((quantity, item)) = found else { return Ok(()) };
    let oscillation = item.required_table("oscillation", "it is the segment")?;
    let name = oscillation.full("periodic");
    let refused = |why: &str, help: &str| {
        let message = format!("`{name}` = true: {why}");
        SceneError::at(&oscillation.key_place("periodic"), message, "in this segment").help(help)
    };
    if history.segments.len() > 1 {
        let why = "a cycle that repeats itself for ever has nothing before it or after it, and this history has other segments";
        return Err(refused(why, "leave them out; the mean is indentation.penetration, with start = \"relaxed\""));
    }
    if quantity != HistoryQuantity::Penetration {
        return Err(refused("only a penetration oscillates for ever", INSTEAD));
    }
    if top.table("adhesion").is_none() {
        return Err(refused("the contact has no adhesion", INSTEAD));
    }
    if start != IndentationStart::Relaxed || given != HistoryQuantity::Penetration {
        let message = format!("`{name}` = true needs indentation.start = \"relaxed\" and, as the mean, indentation.penetration");
        let key = if start == IndentationStart::Relaxed { given.word() } else { "start" };
        return Err(
            SceneError::at(&table.key_place(key), message, "in this table").help("write start = \"relaxed\" and penetration = \"2 µm\"")
        );
    }
    if rim.is_some() || matches!(shape, IndentationShape::FlatPunch { .. }) {
        return Err(refused("the indenter has a rim", INSTEAD));
    }
    if *edge_law != EdgeLaw::CONSTANT {
        return Err(refused("the work of adhesion or the process zone changes with the edge", INSTEAD));
    }
    for key in ["energies", "fields"] {
        if table.node().get(key).is_some() {
            let message = format!(
                "`{name}` = true excludes `{}`: of a cycle that repeats itself there are stiffness, work and path",
                table.full(key)
            );
            return Err(SceneError::at(&table.key_place(key), message, "leave it out").help(INSTEAD));
        }
    }
    Ok(())
}
