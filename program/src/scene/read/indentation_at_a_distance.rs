//! What an indenter that attracts at a distance cannot be asked for, each with what can be typed instead.

use super::section::Section;
use crate::scene::diagnostic::SceneError;
use crate::scene::typed::{History, HistoryQuantity, HistorySegment};

/// Refuses starts and histories that the solver of the finite range does not take.
pub(super) fn possible(top: &Section<'_>, table: &Section<'_>, history: &History) -> Result<(), SceneError> {
    if table.node().get("contact_radius").is_some() {
        let message = format!("`{}`: surfaces that attract at a distance have no sharp edge", table.full("contact_radius"));
        return Err(SceneError::at(&table.key_place("contact_radius"), message, "in this table")
            .help("give indentation.penetration or indentation.force"));
    }
    let items = top.items("history");
    for (index, segment) in history.segments.iter().enumerate() {
        // The segments of a standard test are what this theory takes.
        let Some(item) = items.get(history.table(index)) else { break };
        if segment.quantity() == Some(HistoryQuantity::ContactRadius) {
            let message = "a history that controls `contact_radius` imposes an edge, and surfaces that attract at a distance have none";
            return Err(SceneError::at(&item.header(), message, "in this segment").help("control penetration, force or frame"));
        }
        let HistorySegment::Oscillation(oscillation) = segment else { continue };
        let endless = [("until_stationary", oscillation.until_stationary), ("periodic", oscillation.is_periodic())];
        if let Some((key, _)) = endless.into_iter().find(|(_, asked)| *asked) {
            let own = item.required_table("oscillation", "it is the segment")?;
            let message = format!("`{}` = true: with a law of attraction every cycle is integrated", own.full(key));
            return Err(SceneError::at(&own.key_place(key), message, "leave it out").help("write cycles = 20"));
        }
    }
    Ok(())
}
