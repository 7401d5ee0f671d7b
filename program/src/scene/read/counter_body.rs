//! The second body of a contact: elastic, and of an indentation round or flat.

use super::section::Section;
use crate::scene::check::Units;
use crate::scene::diagnostic::SceneError;
use crate::scene::typed::{CounterBody, ElasticBody, IndentationShape};

/// `counter_body` of a table, if it is there: both elastic constants.
pub(super) fn elastic(parent: &Section<'_>) -> Result<Option<ElasticBody>, SceneError> {
    let Some(table) = in_si(parent)? else { return Ok(None) };
    Ok(Some(ElasticBody { modulus: table.required_number("modulus")?, poisson_ratio: table.required_number("poisson_ratio")? }))
}

/// `indentation.counter_body`, and the shape of the gap between both bodies.
pub(super) fn of_indentation(parent: &Section<'_>, shape: IndentationShape) -> Result<(IndentationShape, Option<CounterBody>), SceneError> {
    let Some(table) = in_si(parent)? else { return Ok((shape, None)) };
    let rimmed = matches!(shape, IndentationShape::FlatPunch { .. }) || parent.node().get("rim_radius").is_some();
    let elastic = match (table.number("modulus")?, table.number("poisson_ratio")?, table.number("radius")?) {
        (None, None, Some(_)) => None,
        _ => elastic(parent)?,
    };
    if rimmed && elastic.is_some() {
        let message = format!(
            "`{}`: a body that ends with a sharp rim is no half-space, so both compliances do not add",
            parent.full("counter_body")
        );
        return Err(parent.wrong("counter_body", message, "leave it out: a body with a rim is rigid here"));
    }
    let radius = table.number("radius")?;
    let gap = match (radius, shape) {
        (Some(second), IndentationShape::Sphere { radius }) => IndentationShape::Sphere { radius: 1.0 / (1.0 / radius + 1.0 / second) },
        (Some(_), _) => {
            let message = format!("`{}` belongs to two spheres, and the first body is none", table.full("radius"));
            return Err(table.wrong("radius", message, "leave it out: the second body is flat"));
        }
        (None, shape) => shape,
    };
    Ok((gap, Some(CounterBody { elastic, radius })))
}

fn in_si<'s>(parent: &Section<'s>) -> Result<Option<Section<'s>>, SceneError> {
    let Some(table) = parent.table("counter_body") else { return Ok(None) };
    if table.units() == Units::Reduced {
        let message = format!("`{}`: in reduced units the moduli are those of both bodies together", parent.full("counter_body"));
        return Err(parent.wrong("counter_body", message, "leave it out").help("or write the scene in SI units"));
    }
    Ok(Some(table))
}
