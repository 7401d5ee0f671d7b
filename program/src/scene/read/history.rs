//! The `[[history]]` tables, one a segment.

use super::record::record;
use super::relative;
use super::repeat::Tables;
use super::section::Section;
use super::until;
use crate::scene::catalogue::{Key, Kind, Range};
use crate::scene::check::{Units, check_range, number};
use crate::scene::diagnostic::SceneError;
use crate::scene::document::{Document, Node, Value};
use crate::scene::typed::{CycleWave, History, HistoryOscillation, HistoryQuantity, HistorySegment, OscillationExtent, Pace};
use crate::scene::units::Dimension;
use viscotack::indentation::FrequencySweep;

/// What a segment does, apart from going to a value of a quantity.
const FORMS: [&str; 6] = ["by", "repeat", "hold", "table", "cycles", "oscillation"];
/// Keys that only some segments have, and which: `target` stands for a quantity.
const BELONGS_TO: [(&str, &[&str]); 14] = [
    ("duration", &["target", "by"]),
    ("rate", &["target", "by"]),
    ("until", &["target", "by", "hold"]),
    ("segments", &["repeat"]),
    ("quantity", &["by", "table", "cycles"]),
    ("columns", &["table"]),
    ("contact_point", &["table"]),
    ("invert", &["table"]),
    ("tolerance", &["table"]),
    ("noise", &["table"]),
    ("period", &["cycles"]),
    ("lower", &["cycles"]),
    ("upper", &["cycles"]),
    ("wave", &["cycles"]),
];

/// Reads the history of a checked document by itself; as a problem reads it, but for keys that nobody reads.
///
/// # Errors
/// The first thing that is wrong.
pub fn read_alone(document: &Document, allowed: &[HistoryQuantity], owner: &str) -> Result<Option<History>, SceneError> {
    read(&Section::top(&document.root, Units::of(&document.root)), document, allowed, owner)
}

/// Reads the history of a checked document, of the quantities that its problem lets one control; none if there is no `[[history]]`.
/// `owner` is the problem in messages ("a crack").
///
/// # Errors
/// The first thing that is wrong.
pub(super) fn read(
    top: &Section<'_>,
    document: &Document,
    allowed: &[HistoryQuantity],
    owner: &str,
) -> Result<Option<History>, SceneError> {
    let Some(node) = document.root.get("history") else { return Ok(None) };
    let items = top.items("history");
    if items.is_empty() {
        return Err(SceneError::at(&node.place, "`history` is an empty list", "give at least one segment"));
    }
    let accuracy = top.number("accuracy")?.unwrap_or(if allowed.contains(&HistoryQuantity::Penetration) {
        super::INDENTATION_ACCURACY
    } else {
        super::DELAYED_ACCURACY
    });
    let mut tables = Tables::default();
    for item in &items {
        match segment(item, document, (allowed, owner), tables.last_quantity(), accuracy)? {
            Some(segment) => tables.add(segment),
            None => tables.repeat(item)?,
        }
    }
    let mut history = tables.written_out();
    if !allowed.contains(&HistoryQuantity::Penetration) {
        relative::absolute(&mut history, &items)?;
    }
    Ok(Some(history))
}

fn words(allowed: &[HistoryQuantity]) -> String {
    allowed.iter().map(|quantity| format!("`{}`", quantity.word())).collect::<Vec<_>>().join(", ")
}

/// A segment; none if the table repeats those before it.
fn segment(
    item: &Section<'_>,
    document: &Document,
    (allowed, owner): (&[HistoryQuantity], &str),
    last: Option<HistoryQuantity>,
    accuracy: f64,
) -> Result<Option<HistorySegment>, SceneError> {
    let foreign = |quantity: &HistoryQuantity| !allowed.contains(quantity) && item.node().get(quantity.word()).is_some();
    if let Some(quantity) = HistoryQuantity::ALL.into_iter().find(foreign) {
        let message = format!("`{}` is not controlled in {owner}", item.full(quantity.word()));
        let error = SceneError::at(&item.key_place(quantity.word()), message, format!("allowed: {}", words(allowed)));
        return Err(match (quantity, allowed) {
            (HistoryQuantity::Force, [HistoryQuantity::Stress]) => error.help(
                "the stress of a strip is its force divided by width times thickness: stress = \"0.2 MPa\" is 50 N on 50 mm times 5 mm",
            ),
            _ => error,
        });
    }
    let forms: Vec<&'static str> = allowed.iter().map(|quantity| quantity.word()).chain(FORMS).collect();
    let form = item.exactly_one(&forms)?;
    let kind = if FORMS.contains(&form) { form } else { "target" };
    if let Some((key, _)) = BELONGS_TO.iter().find(|(key, kinds)| item.node().get(key).is_some() && !kinds.contains(&kind)) {
        let message = format!("`{}` does not belong to a segment with `{form}`", item.full(key));
        let with: Vec<&str> = BELONGS_TO.iter().filter(|(_, kinds)| kinds.contains(&kind)).map(|(key, _)| *key).collect();
        let known = if with.is_empty() { "it stands alone".to_owned() } else { format!("it may have: {}", with.join(", ")) };
        return Err(SceneError::at(&item.key_place(key), message, "leave it out").help(format!("`{form}`: {known}")));
    }
    let segment = match form {
        "repeat" => return Ok(None),
        "by" => {
            let quantity = quantity(item, allowed, owner)?;
            HistorySegment::By {
                quantity,
                change: dependent(item, "by", quantity.dimension(), Range::Finite)?,
                pace: pace(item, quantity)?,
            }
        }
        "hold" => HistorySegment::Hold { quantity: last, duration: item.required_number("hold")? },
        "table" => {
            let quantity = quantity(item, allowed, owner)?;
            let further = format!("{quantity:?} {accuracy:e}");
            let table = document.records().of(item, &[], &further, || record(item, document, quantity, accuracy))?;
            HistorySegment::Table { quantity, table }
        }
        "cycles" => cycles(item, quantity(item, allowed, owner)?)?,
        "oscillation" => HistorySegment::Oscillation(oscillation(item, allowed, owner)?),
        target => {
            let Some(quantity) = HistoryQuantity::of_word(target) else { return Err(item.missing(target)) };
            let value = item.required_number(target)?;
            match pace(item, quantity)? {
                None => HistorySegment::Step { quantity, value },
                Some(pace) => HistorySegment::Ramp { quantity, value, pace },
            }
        }
    };
    until::ended(item, segment, allowed.contains(&HistoryQuantity::Penetration)).map(Some)
}

/// How fast a value is gone to; none for at once.
fn pace(item: &Section<'_>, quantity: HistoryQuantity) -> Result<Option<Pace>, SceneError> {
    Ok(match item.at_most_one(&["duration", "rate"])? {
        None => None,
        Some("rate") => Some(Pace::Rate(dependent(item, "rate", quantity.rate_dimension(), Range::Positive)?)),
        Some(_) => Some(Pace::Duration(item.required_number("duration")?)),
    })
}

/// What a table or cycles control.
fn quantity(item: &Section<'_>, allowed: &[HistoryQuantity], owner: &str) -> Result<HistoryQuantity, SceneError> {
    let named = match (item.text("quantity"), allowed) {
        (Some(word), _) => HistoryQuantity::of_word(word),
        (None, [only]) => Some(*only),
        (None, _) => None,
    };
    let Some(quantity) = named else { return Err(item.missing("quantity")) };
    if allowed.contains(&quantity) {
        return Ok(quantity);
    }
    let message = format!("`{}` = {:?} is not controlled in {owner}", item.full("quantity"), quantity.word());
    Err(item.wrong("quantity", message, format!("allowed: {}", words(allowed))))
}

fn cycles(item: &Section<'_>, quantity: HistoryQuantity) -> Result<HistorySegment, SceneError> {
    let lower = dependent(item, "lower", quantity.dimension(), quantity.range())?;
    let upper = dependent(item, "upper", quantity.dimension(), quantity.range())?;
    if upper <= lower {
        let message = format!("`{}` ({upper:e}) is not above `{}` ({lower:e})", item.full("upper"), item.full("lower"));
        return Err(item.wrong("upper", message, "must be the larger one"));
    }
    let wave = match item.text("wave") {
        Some("square") => CycleWave::Square,
        _ => CycleWave::Triangle,
    };
    let count = item.required_number("cycles")? as u32;
    Ok(HistorySegment::Cycles { quantity, count, period: item.required_number("period")?, lower, upper, wave })
}

/// The table of an oscillation, which has everything within itself.
fn oscillation(item: &Section<'_>, allowed: &[HistoryQuantity], owner: &str) -> Result<HistoryOscillation, SceneError> {
    if !allowed.iter().any(|quantity| quantity.oscillates()) {
        let message = format!("`{}`: nothing oscillates in {owner}", item.full("oscillation"));
        let help = "a crack goes through `cycles` with period, lower, upper and wave";
        return Err(SceneError::at(&item.key_place("oscillation"), message, "leave it out").help(help));
    }
    let table = item.required_table("oscillation", "it is the segment")?;
    let Some(quantity) = HistoryQuantity::of_word(table.required_text("quantity")?) else { return Err(table.missing("quantity")) };
    let amplitude = dependent(&table, "amplitude", quantity.dimension(), Range::Positive)?;
    let frequency = table.required_number("frequency")?;
    let flag = |key: &str| matches!(table.value(key).map(|node| &node.value), Some(Value::Flag(true)));
    if flag("periodic") {
        let others = ["cycles", "duration", "to", "to_frequency", "frequency_sweep", "phase", "until_stationary"];
        if let Some(key) = others.into_iter().find(|key| table.node().get(key).is_some()) {
            let message =
                format!("`{}` = true excludes `{}`: its one cycle repeats itself for ever", table.full("periodic"), table.full(key));
            return Err(SceneError::at(&table.key_place(key), message, "leave one of the two out"));
        }
        let extent = OscillationExtent::Periodic;
        return Ok(HistoryOscillation {
            quantity,
            amplitude,
            frequency,
            sweep: None,
            extent,
            phase: 0.0,
            to: None,
            until_stationary: false,
        });
    }
    let extent = match table.exactly_one(&["cycles", "duration"])? {
        "cycles" => OscillationExtent::Cycles(table.required_number("cycles")? as u32),
        _ => OscillationExtent::Duration(table.required_number("duration")?),
    };
    let sweep = match (table.number("to_frequency")?, table.text("frequency_sweep")) {
        (Some(end), Some("logarithmic")) => Some((end, FrequencySweep::Logarithmic)),
        (Some(end), _) => Some((end, FrequencySweep::Linear)),
        (None, Some(_)) => {
            let message = format!("`{}` says how the frequency goes to `to_frequency`, which is missing", table.full("frequency_sweep"));
            return Err(table.wrong("frequency_sweep", message, "leave it out, or give to_frequency"));
        }
        (None, None) => None,
    };
    let to = table.value("to").map(|_| dependent(&table, "to", quantity.dimension(), quantity.range())).transpose()?;
    let phase = table.number("phase")?.unwrap_or(0.0);
    let until_stationary = flag("until_stationary");
    if until_stationary {
        let moving = ["to", "to_frequency"].into_iter().find(|key| table.node().get(key).is_some());
        if let Some(key) = moving {
            let message = format!(
                "`{}` = true excludes `{}`: what goes elsewhere is never stationary",
                table.full("until_stationary"),
                table.full(key)
            );
            return Err(SceneError::at(&table.key_place(key), message, "leave one of the two out"));
        }
        if matches!(extent, OscillationExtent::Duration(_)) {
            let message =
                format!("`{}` = true ends after a whole cycle: it needs `cycles`, their largest number", table.full("until_stationary"));
            return Err(SceneError::at(&table.key_place("duration"), message, "give `cycles` instead"));
        }
    }
    Ok(HistoryOscillation { quantity, amplitude, frequency, sweep, extent, phase, to, until_stationary })
}

/// A number whose dimension is that of the segment's quantity.
pub(super) fn dependent(item: &Section<'_>, key: &str, dimension: Dimension, range: Range) -> Result<f64, SceneError> {
    let Some(node) = item.value(key) else {
        return Err(item.missing(key).help(format!("`{}` is {}", item.full(key), dimension.example())));
    };
    let path = item.full(key);
    let value = number(node, &path, dimension, item.units())?;
    check_range(node, &path, value, range).map(|()| value)
}

/// The dimension and range of a swept `rate`, `lower`, `upper`, `amplitude`, `tolerance`, `contact_point`, `by` or `to`, by the quantity of its segment.
/// None for any other key.
pub(in crate::scene) fn dependent_kind(root: &Node, path: &str, key: &Key) -> Option<(Dimension, Range)> {
    if !matches!(key.kind, Kind::NumberOfSweptKey) || !key.path.starts_with("history[].") {
        return None;
    }
    let item = root.at(path.rsplit_once('.')?.0)?;
    let named = match item.get("quantity").map(|node| &node.value) {
        Some(Value::Text(word)) => HistoryQuantity::of_word(word),
        _ => HistoryQuantity::ALL.into_iter().find(|quantity| item.get(quantity.word()).is_some()),
    };
    // Only a cracked strip and a crack let the quantity of cycles go unnamed.
    let strip = root.at("crack.strip").is_some();
    let quantity = named.unwrap_or(if strip { HistoryQuantity::Stress } else { HistoryQuantity::StressIntensity });
    Some(match key.path.rsplit('.').next() {
        Some("rate") => (quantity.rate_dimension(), Range::Positive),
        Some("amplitude") => (quantity.dimension(), Range::Positive),
        Some("tolerance") => (quantity.dimension(), Range::NonNegative),
        Some("contact_point" | "by") => (quantity.dimension(), Range::Finite),
        _ => (quantity.dimension(), quantity.range()),
    })
}
