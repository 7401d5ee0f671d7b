//! The `[indentation]`, `[adhesion]` and `[[history]]` tables of an indenter.

use super::attraction;
use super::counter_body;
use super::indentation_at_a_distance as at_a_distance;
use super::section::Section;
use super::shape_points::shape_points;
use super::standard_test;
use super::works;
use super::{DEFAULT_FACTOR, DEFAULT_FIELD_POINTS, history, periodic, without_cohesive_stress};
use crate::scene::check::{Units, number};
use crate::scene::diagnostic::SceneError;
use crate::scene::document::{Document, Value};
use crate::scene::typed::{
    Condition, History, HistoryOscillation, HistoryQuantity, HistorySegment, Indentation, IndentationAdhesion, IndentationFields,
    IndentationShape, IndentationStart, IndentationZone, Pace, SceneMaterial,
};
use crate::scene::units::Dimension;
use viscotack::indentation::EdgeLaw;

/// What a history of an indenter may control.
const CONTROLLED: &[HistoryQuantity] =
    &[HistoryQuantity::Penetration, HistoryQuantity::Force, HistoryQuantity::ContactRadius, HistoryQuantity::Frame];
/// Rows of a ramp where a scene names no number.
const DEFAULT_INSTANTS: f64 = 40.0;

pub(super) fn read(document: &Document, top: &Section<'_>, material: &SceneMaterial) -> Result<Indentation, SceneError> {
    let table = top.required_table("indentation", "it is the problem")?;
    if table.units() == Units::Si && !material.has_plane_strain_modulus() {
        let help = "the half-space is deformed with E* = E/(1 − ν²): an indenter needs material.poisson_ratio, of rubber poisson_ratio = 0.49 in [material]";
        return Err(top.required_table("material", "")?.missing("poisson_ratio").help(help));
    }
    if top.node().get("fields").is_some() {
        let message = "`fields` belongs to cracks and sliding contacts";
        return Err(top.wrong("fields", message, "write [indentation.fields] with its times"));
    }
    let shape = shape(&table, document)?;
    let rim_radius = rim_radius(&table, &shape)?;
    let (shape, counter_body) = counter_body::of_indentation(&table, shape)?;
    let attraction = attraction::read(top, document, 1.0)?;
    // A law acts everywhere: there is no edge.
    let (adhesion, edge_law) = if attraction.is_some() { (None, None) } else { adhesion(top)?.unzip() };
    let edge_law = edge_law.unwrap_or_default();
    let frame_stiffness = table.number("frame_stiffness")?;
    let rig = standard_test::Rig { shape: &shape, frame_stiffness, at_a_distance: attraction.is_some() };
    let written_out = standard_test::read(top, &rig)?;
    let Some(history) = written_out.map_or_else(|| history::read(top, document, CONTROLLED, "an indentation"), |test| Ok(Some(test)))?
    else {
        return Err(SceneError::at(&top.end(), "the history is missing: it is what is done to the indenter", "the scene ends here")
            .help("add [[history]] tables, such as: [[history]] penetration = \"2 µm\", rate = \"1 µm/s\"; or [test] with its kind"));
    };
    let start = match table.text("start") {
        Some("relaxed") => IndentationStart::Relaxed,
        _ => IndentationStart::Untouched,
    };
    if attraction.is_some() {
        at_a_distance::possible(top, &table, &history)?;
    }
    let at_start = at_start(&table, start, adhesion.is_some(), &history)?;
    periodic::possible(top, &table, &history, &shape, (start, at_start.0, rim_radius, &edge_law))?;
    means_are_known(top, &history, at_start.0)?;
    let framed = |segment: &HistorySegment| {
        let until = matches!(segment, HistorySegment::Until { condition: Condition::Reaches(HistoryQuantity::Frame, _), .. });
        until || segment.quantity() == Some(HistoryQuantity::Frame)
    };
    if let (None, Some(index)) = (frame_stiffness, history.segments.iter().position(framed)) {
        let message =
            "the history controls `frame`, or ends a segment at it: the far end of a frame, but `indentation.frame_stiffness` is missing";
        let place = top.items("history").get(history.table(index)).map_or_else(|| table.header(), Section::header);
        return Err(SceneError::at(&place, message, "in this segment").help("add indentation.frame_stiffness, or write `penetration`"));
    }
    let fields = fields(&table, &history)?;
    Ok(Indentation {
        shape,
        counter_body,
        rim_radius,
        start,
        at_start,
        adhesion,
        attraction,
        edge_law,
        frame_stiffness,
        history,
        speed_factor: table.number("speed_factor")?.unwrap_or(1.0),
        instants: table.number("instants")?.unwrap_or(DEFAULT_INSTANTS) as u32,
        energies: table.value("energies").is_some(),
        fields,
    })
}

fn shape(table: &Section<'_>, document: &Document) -> Result<IndentationShape, SceneError> {
    let name = table.exactly_one(&["sphere", "cone", "flat_punch", "power_law", "profile"])?;
    if name == "profile" {
        let shape = document.shapes().of(table, &[name, "scan"], "", || shape_points(table, document, name))?;
        let (points, measured) = shape.as_ref().clone();
        return Ok(IndentationShape::Table { points: points.into(), measured: measured.into() });
    }
    if table.node().get("scan").is_some() {
        let message = format!("`{}` belongs to a profile of a file", table.full("scan"));
        return Err(SceneError::at(&table.key_place("scan"), message, "leave it out"));
    }
    let body = table.required_table(name, "it is the indenter")?;
    let radius = || match (body.units(), body.number("radius")?) {
        (Units::Si, _) => body.required_number("radius"),
        (Units::Reduced, None) => Ok(1.0),
        (Units::Reduced, Some(_)) => {
            let message = format!("`{}`: in reduced units the size of the indenter is the unit", body.full("radius"));
            Err(body.wrong("radius", message, "leave it out, as in sphere = {}"))
        }
    };
    Ok(match name {
        "sphere" => IndentationShape::Sphere { radius: radius()? },
        "flat_punch" => IndentationShape::FlatPunch { radius: radius()? },
        "cone" => IndentationShape::Cone { slope: body.required_number("slope")? },
        _ => IndentationShape::PowerLaw { radius: radius()?, exponent: body.required_number("exponent")? },
    })
}

/// Where a shape ends, if it does: within the last point of a table, and not twice.
fn rim_radius(table: &Section<'_>, shape: &IndentationShape) -> Result<Option<f64>, SceneError> {
    let Some(rim) = table.number("rim_radius")? else { return Ok(None) };
    let last = match shape {
        IndentationShape::Table { points, .. } => points.last().map_or(f64::INFINITY, |(r, _)| *r),
        IndentationShape::FlatPunch { .. } => {
            let message = format!("`{}`: a flat punch ends at its own radius", table.full("rim_radius"));
            return Err(table.wrong("rim_radius", message, "leave it out"));
        }
        _ => f64::INFINITY,
    };
    if rim > last {
        let message = format!("`{}`: the shape is known to {last:e} only", table.full("rim_radius"));
        return Err(table.wrong("rim_radius", message, "at most the radius of the last row"));
    }
    Ok(Some(rim))
}

/// What is given at time zero; of an untouched surface first touch, if nothing is.
fn at_start(table: &Section<'_>, start: IndentationStart, adhesive: bool, history: &History) -> Result<(HistoryQuantity, f64), SceneError> {
    const KEYS: [&str; 3] = ["penetration", "force", "contact_radius"];
    let key = match start {
        IndentationStart::Relaxed => Some(table.exactly_one(&KEYS)?),
        IndentationStart::Untouched => table.at_most_one(&KEYS)?,
    };
    let Some(key) = key else {
        // First touch is the zero of whatever is controlled first.
        let first = history.segments.first().and_then(HistorySegment::quantity).unwrap_or(HistoryQuantity::Penetration);
        if first == HistoryQuantity::ContactRadius && adhesive {
            let message =
                "an adhesive contact jumps in to a radius of its own: a history that controls `contact_radius` needs the first one";
            return Err(table.wrong("start", message, "in this table").help("give indentation.contact_radius"));
        }
        return Ok((first, 0.0));
    };
    let quantity = HistoryQuantity::of_word(key).unwrap_or(HistoryQuantity::Penetration);
    Ok((quantity, table.required_number(key)?))
}

/// An oscillation without `to` needs its mean.
fn means_are_known(top: &Section<'_>, history: &History, first: HistoryQuantity) -> Result<(), SceneError> {
    let mut controlled = first;
    let items = top.items("history");
    for (index, segment) in history.segments.iter().enumerate() {
        let Some(item) = items.get(history.table(index)) else { break };
        if let HistorySegment::Oscillation(HistoryOscillation { quantity, to: None, .. }) = segment
            && *quantity != controlled
        {
            let message = format!(
                "`{}`: before this segment `{}` is controlled, and about which `{}` it would oscillate is only known when the history is solved",
                item.full("oscillation"),
                controlled.word(),
                quantity.word()
            );
            return Err(SceneError::at(&item.key_place("oscillation"), message, "give `to`, or go to a value of it first"));
        }
        controlled = segment.quantity().unwrap_or(controlled);
    }
    Ok(())
}

fn adhesion(top: &Section<'_>) -> Result<Option<(IndentationAdhesion, EdgeLaw)>, SceneError> {
    let (Some(table), Some(works)) = (top.table("adhesion"), works::of_indenter(top)?) else { return Ok(None) };
    let [work_of_adhesion, leading_work] = works.given;
    let mut edge_law = EdgeLaw { leading_ratio: leading_work / work_of_adhesion, by_speed: works.law, growing_zone: false };
    let zone = table.table("process_zone").ok_or_else(|| table.missing("process_zone"))?;
    zone.without(&["trailing_length", "leading_length"], "a sliding contact")?;
    let process_zone = match zone.exactly_one(&["length", "cohesive_stress"])? {
        "length" => {
            without_cohesive_stress(&zone)?;
            IndentationZone::Length(zone.required_number("length")?)
        }
        _ => {
            edge_law.growing_zone = match zone.text("law") {
                None | Some("constant") => false,
                Some("growing") => true,
                Some(law) => {
                    let message = format!("`{}` = {law:?} is no law of an indenter's process zone", zone.full("law"));
                    return Err(zone.wrong("law", message, "must be \"growing\" or \"constant\""));
                }
            };
            IndentationZone::Cohesive {
                cohesive_stress: zone.required_number("cohesive_stress")?,
                factor: zone.number("factor")?.unwrap_or(DEFAULT_FACTOR),
            }
        }
    };
    let adhesion = IndentationAdhesion { work_of_adhesion, process_zone, interaction_range: table.number("interaction_range")? };
    Ok(Some((adhesion, edge_law)))
}

fn fields(table: &Section<'_>, history: &History) -> Result<Option<IndentationFields>, SceneError> {
    let Some(fields) = table.table("fields") else { return Ok(None) };
    let Some(node) = fields.value("times") else { return Err(fields.missing("times")) };
    let Value::List(items) = &node.value else { return Err(fields.missing("times")) };
    if items.is_empty() {
        return Err(SceneError::at(&node.place, "`indentation.fields.times` is an empty list", "name at least one time"));
    }
    let known_end = duration(history);
    let mut times: Vec<f64> = Vec::with_capacity(items.len());
    for item in items {
        let path = fields.full("times");
        let time = number(item, &path, Dimension::TIME, fields.units())?;
        let rising = times.last().is_none_or(|before| time > *before);
        if time < 0.0 || !rising {
            return Err(SceneError::at(
                &item.place,
                format!("`{path}`: {time:e} is not later than the time before it"),
                "times rise from 0",
            ));
        }
        if let Some(end) = known_end
            && time > end * (1.0 + 1e-12)
        {
            let message = format!("`{path}`: {time:e} is after the end of the history ({end:e})");
            return Err(SceneError::at(&item.place, message, "must lie within the history"));
        }
        times.push(time);
    }
    let points = fields.number("points")?.unwrap_or(DEFAULT_FIELD_POINTS) as u32;
    Ok(Some(IndentationFields { times, to: fields.number("to")?, points }))
}

/// How long the history takes at speed factor one; none if that is only known when it is solved.
fn duration(history: &History) -> Option<f64> {
    history.segments.iter().try_fold(0.0, |total, segment| {
        Some(
            total
                + match segment {
                    HistorySegment::Step { .. } | HistorySegment::By { pace: None, .. } => 0.0,
                    HistorySegment::Ramp { pace: Pace::Duration(time), .. }
                    | HistorySegment::By { pace: Some(Pace::Duration(time)), .. }
                    | HistorySegment::Hold { duration: time, .. } => *time,
                    HistorySegment::By { change, pace: Some(Pace::Rate(rate)), .. } => (change / rate).abs(),
                    HistorySegment::Ramp { pace: Pace::Rate(_), .. } | HistorySegment::Until { .. } => return None,
                    HistorySegment::Table { table, .. } => table.times.last().copied().unwrap_or(0.0),
                    HistorySegment::Cycles { count, period, .. } => f64::from(*count) * period,
                    HistorySegment::Oscillation(oscillation) if oscillation.until_stationary => return None,
                    HistorySegment::Oscillation(oscillation) => oscillation.duration(),
                },
        )
    })
}
