//! What an indenter that attracts at a distance cannot be asked for, each with what can be typed instead.

use super::section::Section;
use crate::scene::diagnostic::SceneError;
use crate::scene::typed::{History, HistoryQuantity, HistorySegment, IndentationShape};

/// The theory that has what this one has not.
const EDGE: &str = "leave it out, or give adhesion.process_zone in place of the law: the theory of an edge";

/// Refuses shapes and histories that the solver of the finite range does not take.
pub(super) fn possible(top: &Section<'_>, table: &Section<'_>, history: &History, shape: &IndentationShape) -> Result<(), SceneError> {
    let shape_key = match shape {
        IndentationShape::FlatPunch { .. } => Some("flat_punch"),
        IndentationShape::Table { .. } => Some("profile"),
        _ => None,
    };
    if let Some(key) = shape_key {
        let message = format!("`{}`: with a law of attraction only a sphere, a cone and a power law are solved", table.full(key));
        return Err(SceneError::at(&table.key_place(key), message, "this shape")
            .help("give adhesion.process_zone in place of the law, or a shape of these three"));
    }
    if let IndentationShape::PowerLaw { exponent, .. } = shape
        && *exponent < 1.0
    {
        let message = format!("`indentation.power_law.exponent` = {exponent}: with a law of attraction it is 1 or more");
        let body = table.required_table("power_law", "it is the indenter")?;
        return Err(body.wrong("exponent", message, "must be at least 1"));
    }
    for key in ["rim_radius", "contact_radius"] {
        if table.node().get(key).is_some() {
            let message = format!("`{}`: surfaces that attract at a distance have no sharp edge", table.full(key));
            let help = if key == "rim_radius" { EDGE } else { "give indentation.penetration or indentation.force" };
            return Err(SceneError::at(&table.key_place(key), message, "in this table").help(help));
        }
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
