//! A CSV file of a material: what instruments and spreadsheets write, read without guessing more than a header tells.
//!
//! ```text
//! # a comment
//! temperature (°C), frequency (Hz), storage modulus (MPa), loss modulus (MPa)
//! -40,              0.1,            812.0,                 96.1
//! ```
//! Cells are separated by commas, semicolons or tabs. A unit stands in the header after the name, in (…) or […], or in a line of its own
//! below the names, or in `material.columns` of the scene. Other columns are passed over.

use super::material_columns::{Column, EXAMPLE, Role, column, stated_columns, word};
use super::measured_table::{lines_of, written};
use super::section::Section;
use crate::scene::diagnostic::{Place, SceneError, SourceText, nearest};
use crate::scene::document::{Document, Value, read_text};
use crate::scene::typed::{MaterialData, MeasuredRow, MeasuredSort};
use crate::scene::units::parse_quantity;

/// Reads the files that the material of a document names.
pub(super) fn resolve(document: &mut Document) -> Result<(), SceneError> {
    for path in ["material.data", "material.shift.table"].into_iter().chain(super::decks::PATHS) {
        let Some(node) = document.root.at(path) else { continue };
        let (Value::Text(name), place) = (node.value.clone(), node.place.clone()) else { continue };
        if document.attached(&name).is_some() {
            continue;
        }
        let text = read_text(&document.folder().join(&name)).map_err(|error| {
            SceneError::at(&place, format!("`{path}` = {name:?} cannot be read: {error}"), "this file")
                .help("relative paths start at the scene")
        })?;
        document.attach(&name, SourceText::new(&name, text));
    }
    Ok(())
}

/// Rows of a table with the columns that have a role.
struct Rows {
    columns: Vec<Column>,
    rows: Vec<Vec<(Place, f64)>>,
}

impl Rows {
    fn index(&self, role: Role) -> Option<usize> {
        self.columns.iter().position(|column| column.role == role)
    }

    fn cell<'r>(&self, row: &'r [(Place, f64)], role: Role) -> Option<&'r (Place, f64)> {
        row.get(self.index(role)?)
    }
}

/// The table that `material.data` names.
pub(super) fn material_data(table: &Section<'_>, document: &Document, poisson_ratio: Option<f64>) -> Result<MaterialData, SceneError> {
    let file = table.required_text("data")?;
    let (rows, header) = read(table, document, "data", file)?;
    let wrong = |message: String| SceneError::at(&header, message, "in this header").help(EXAMPLE);
    let has = |role: Role| rows.index(role).is_some();
    let sort = match (has(Role::Storage), has(Role::Relaxation), has(Role::Creep)) {
        (true, false, false) => MeasuredSort::Moduli,
        (false, true, false) => MeasuredSort::Relaxation,
        (false, false, true) => MeasuredSort::Creep,
        (false, false, false) => {
            return Err(wrong(format!("{file:?} has no column with a storage modulus, a relaxation modulus or a creep compliance")));
        }
        _ => return Err(wrong(format!("{file:?} holds more than one of storage modulus, relaxation modulus and creep compliance"))),
    };
    let place = match sort {
        MeasuredSort::Moduli => match (has(Role::Frequency), has(Role::AngularFrequency)) {
            (true, false) => Role::Frequency,
            (false, true) => Role::AngularFrequency,
            (true, true) => return Err(wrong(format!("{file:?} has both a frequency and an angular frequency"))),
            (false, false) => return Err(wrong(format!("{file:?} has no column with a frequency"))),
        },
        _ if has(Role::Time) => Role::Time,
        _ => return Err(wrong(format!("{file:?} has no column with a time"))),
    };
    if sort == MeasuredSort::Moduli && has(Role::Loss) == has(Role::LossTangent) {
        let message = if has(Role::Loss) {
            "has both a loss modulus and a loss tangent"
        } else {
            "has no column with a loss modulus or a loss tangent"
        };
        return Err(wrong(format!("{file:?} {message}")));
    }
    let main = match sort {
        MeasuredSort::Moduli => Role::Storage,
        MeasuredSort::Relaxation => Role::Relaxation,
        MeasuredSort::Creep => Role::Creep,
    };
    for (role, ..) in stated_columns(table)? {
        let of_moduli = matches!(role, Role::Frequency | Role::AngularFrequency | Role::Storage | Role::Loss | Role::LossTangent);
        let used = role == Role::Temperature || if sort == MeasuredSort::Moduli { of_moduli } else { role == Role::Time || role == main };
        if let (false, Some(columns)) = (used, table.table("columns")) {
            let message = format!("`{}` has no effect on a table of the {}", columns.full(word(role)), word(main).replace('_', " "));
            return Err(columns.wrong(word(role), message, "leave it out"));
        }
    }
    let stretch = stretch_to_young(table, &rows, sort, poisson_ratio, &header)?;
    let mut data = MaterialData { file: file.to_owned(), sort, rows: Vec::with_capacity(rows.rows.len()), warnings: Vec::new() };
    for row in &rows.rows {
        let positive = |role: Role| -> Result<f64, SceneError> {
            let Some((place, value)) = rows.cell(row, role) else { return Ok(f64::NAN) };
            if *value > 0.0 {
                return Ok(*value);
            }
            Err(SceneError::at(
                place,
                format!("`{}` = {} in line {} is not positive", word(role), written(place), line(place)),
                "must be greater than 0",
            ))
        };
        let value = positive(main)? * stretch;
        let loss = match sort {
            MeasuredSort::Moduli => {
                let role = if has(Role::Loss) { Role::Loss } else { Role::LossTangent };
                let Some((place, loss)) = rows.cell(row, role) else { continue };
                if *loss < 0.0 {
                    let message = format!(
                        "`{}` = {} in line {} is negative: a passive solid loses energy, it gives none",
                        word(role),
                        written(place),
                        line(place)
                    );
                    return Err(SceneError::at(place, message, "must be 0 or more"));
                }
                Some(if role == Role::Loss { loss * stretch } else { loss * value })
            }
            _ => None,
        };
        let at = positive(place)? * if place == Role::Frequency { std::f64::consts::TAU } else { 1.0 };
        let temperature = rows.cell(row, Role::Temperature).map(|cell| cell.1);
        if temperature.is_some_and(|kelvin| kelvin <= 0.0) {
            positive(Role::Temperature)?;
        }
        data.rows.push(MeasuredRow { temperature, at, value, loss });
    }
    if data.rows.len() < 4 {
        return Err(SceneError::at(
            &header,
            format!("{file:?} has {} rows of numbers", data.rows.len()),
            "needs at least four below this line",
        ));
    }
    if data.rows.len() > MOST_ROWS {
        let message = format!("{file:?} has {} rows", data.rows.len());
        return Err(SceneError::at(&header, message, format!("at most {MOST_ROWS}: leave every other one out")));
    }
    data.warnings = oddities(&data);
    Ok(data)
}

/// Temperatures and shift factors of the table that `material.shift.table` names.
pub(super) fn shift_table(shift: &Section<'_>, document: &Document) -> Result<Vec<(f64, f64)>, SceneError> {
    let file = shift.required_text("table")?;
    let (rows, header) = read(shift, document, "table", file)?;
    let help = "the header is such as: temperature (°C), log10_factor";
    let wrong = |message: String| SceneError::at(&header, message, "in this header").help(help);
    if rows.index(Role::Temperature).is_none() {
        return Err(wrong(format!("{file:?} has no column `temperature`")));
    }
    let role = match (rows.index(Role::Factor), rows.index(Role::LogFactor)) {
        (Some(_), None) => Role::Factor,
        (None, Some(_)) => Role::LogFactor,
        _ => return Err(wrong(format!("{file:?} needs one column `factor` or `log10_factor`"))),
    };
    let mut points = Vec::with_capacity(rows.rows.len());
    for row in &rows.rows {
        let (Some((_, kelvin)), Some((place, value))) = (rows.cell(row, Role::Temperature), rows.cell(row, role)) else { continue };
        let factor = if role == Role::Factor { *value } else { 10f64.powf(*value) };
        if !(factor.is_finite() && factor > 0.0) {
            return Err(SceneError::at(
                place,
                format!("`{}` = {} in line {} is no shift factor", word(role), written(place), line(place)),
                "a factor is greater than 0",
            ));
        }
        points.push((*kelvin, factor));
    }
    points.sort_by(|left, right| left.0.total_cmp(&right.0));
    Ok(points)
}

/// The line of a file that a place stands in, counted from one.
fn line(place: &Place) -> usize {
    1 + place.source.text().get(..place.span.start).unwrap_or("").matches('\n').count()
}

/// Reads the columns that have a role; gives the header line, too.
fn read(table: &Section<'_>, document: &Document, key: &str, file: &str) -> Result<(Rows, Place), SceneError> {
    let Some(source) = document.attached(file) else {
        return Err(table.wrong(key, format!("`{}` = {file:?} was not read with the scene", table.full(key)), "this file"));
    };
    let mut lines = lines_of(source).peekable();
    let Some(header) = lines.next() else {
        return Err(SceneError::at(&Place { source: source.clone(), span: 0..0 }, format!("{file:?} is empty"), "here").help(EXAMPLE));
    };
    let separator = [';', '\t'].into_iter().find(|&one| written(&header).contains(one)).unwrap_or(',');
    let names = cells(&header, separator);
    // A second line without a number holds the units.
    let no_number = |place: &Place| cells(place, separator).iter().all(|cell| written(cell).parse::<f64>().is_err());
    let units = lines.peek().filter(|second| no_number(second)).map(|second| cells(second, separator));
    if units.is_some() {
        lines.next();
    }
    let stated = stated_columns(table)?;
    let mut columns: Vec<Option<Column>> = Vec::with_capacity(names.len());
    for (index, place) in names.iter().enumerate() {
        let unit_below = units.as_ref().and_then(|units| units.get(index)).map(|cell| written(cell).to_owned());
        let column = column(place, unit_below, &stated)?;
        if let Some(new) = &column
            && columns.iter().flatten().any(|old| old.role == new.role)
        {
            return Err(SceneError::at(place, format!("two columns hold the {}", word(new.role).replace('_', " ")), "the second")
                .help("name the right one in [material.columns]"));
        }
        columns.push(column);
    }
    for (role, name, _) in &stated {
        if !columns.iter().flatten().any(|column| column.role == *role) {
            let headers: Vec<&str> = names.iter().map(written).collect();
            let near = nearest(name, headers.iter().copied()).map_or_else(String::new, |name| format!("; did you mean {name:?}?"));
            let message = format!("`material.columns.{}` = {name:?} is no header of {file:?}{near}", word(*role));
            return Err(SceneError::at(&header, message, "the headers"));
        }
    }
    let mut rows = Vec::new();
    for place in lines {
        let found = cells(&place, separator);
        if found.len() != names.len() {
            let message = format!("line {} of {file:?} has {} cells, the header {}", line(&place), found.len(), names.len());
            return Err(SceneError::at(&place, message, "in this row"));
        }
        let mut row = Vec::new();
        for (cell, column) in found.iter().zip(&columns) {
            if let Some(column) = column {
                row.push((cell.clone(), number(cell, column)?));
            }
        }
        rows.push(row);
    }
    Ok((Rows { columns: columns.into_iter().flatten().collect(), rows }, header))
}

/// The cells of a line, without spaces and quotation marks around them.
fn cells(line: &Place, separator: char) -> Vec<Place> {
    let mut start = line.span.start;
    written(line)
        .split(separator)
        .map(|cell| {
            let inner = cell.trim();
            let inner = inner.strip_prefix('"').and_then(|rest| rest.strip_suffix('"')).filter(|inner| !inner.is_empty()).unwrap_or(inner);
            let begin = start + cell.find(inner).unwrap_or(0);
            start += cell.len() + separator.len_utf8();
            Place { source: line.source.clone(), span: begin..begin + inner.len() }
        })
        .collect()
}

/// A cell in SI units.
fn number(cell: &Place, column: &Column) -> Result<f64, SceneError> {
    let text = written(cell);
    let plain = text.parse::<f64>().ok().filter(|value| value.is_finite());
    let value = plain
        .and_then(|_| parse_quantity(&format!("{text} {}", column.unit)).ok())
        .map(|quantity| quantity.value)
        .filter(|value| value.is_finite());
    value.ok_or_else(|| {
        let what = if text.is_empty() { "is empty".to_owned() } else { format!("= {text:?} is no number") };
        let place = if text.is_empty() { &column.place } else { cell };
        SceneError::at(place, format!("`{}` {what}, in line {}", word(column.role), line(cell)), "must be a finite number without a unit")
    })
}

/// What the moduli of a table, or the inverse of its compliances, are multiplied by to be Young's: 2(1 + ν) of shear.
fn stretch_to_young(
    table: &Section<'_>,
    rows: &Rows,
    sort: MeasuredSort,
    poisson_ratio: Option<f64>,
    header: &Place,
) -> Result<f64, SceneError> {
    let named = rows.columns.iter().find(|column| column.named_shear);
    let said = table.table("columns").and_then(|columns| columns.text("of").map(str::to_owned));
    let place = match (said.as_deref(), named) {
        (Some("shear"), _) => named.map_or(header, |column| &column.place),
        (Some(_), _) | (None, None) => return Ok(1.0),
        (None, Some(column)) if column.by_scene => {
            return Err(SceneError::at(
                &column.place,
                format!("`{}` is named like a shear modulus, and [material.columns] does not say of what it is", written(&column.place)),
                "of shear or of tension?",
            )
            .help("write of = \"shear\" or of = \"tension\" into [material.columns]"));
        }
        (None, Some(column)) => &column.place,
    };
    let ratio = poisson_ratio.ok_or_else(|| {
        SceneError::at(place, format!("`{}` is of shear, a material is given by Young's modulus", written(place)), "of shear")
            .help("give material.poisson_ratio: E = 2(1 + ν)G; or of = \"tension\" in [material.columns] if it is Young's modulus")
    })?;
    let stretch = 2.0 * (1.0 + ratio);
    Ok(if sort == MeasuredSort::Creep { 1.0 / stretch } else { stretch })
}

/// More rows than these are a recording, not a table.
const MOST_ROWS: usize = 20_000;
/// Moduli outside are no solid's: a unit is wrong.
const USUAL_MODULI: [f64; 2] = [10.0, 1e12];
/// Frequencies and times outside are no instrument's (a factor 2π and a few decades granted).
const USUAL_TIMES: [f64; 2] = [1e-9, 1e9];

/// What is odd about a table, but can be read.
fn oddities(data: &MaterialData) -> Vec<String> {
    let mut odd = Vec::new();
    let same = |left: &MeasuredRow, right: &MeasuredRow| left.temperature == right.temperature;
    let falls = data.rows.windows(2).filter(|pair| same(&pair[0], &pair[1])).map(|pair| pair[1].at > pair[0].at).collect::<Vec<_>>();
    let rises = falls.iter().filter(|&&up| up).count();
    let repeated = data.rows.windows(2).filter(|pair| same(&pair[0], &pair[1]) && pair[1].at.total_cmp(&pair[0].at).is_eq()).count();
    if rises.min(falls.len() - rises) > repeated {
        odd.push("the rows are not in the order of frequency or time; they are sorted".to_owned());
    }
    let mut places: Vec<(u64, u64)> = data.rows.iter().map(|row| (row.temperature.unwrap_or(0.0).to_bits(), row.at.to_bits())).collect();
    places.sort_unstable();
    let double = places.windows(2).filter(|pair| pair[0] == pair[1]).count();
    if double > 0 {
        odd.push(format!("{double} rows repeat a frequency or time at the same temperature; all are used"));
    }
    let mut values: Vec<f64> =
        data.rows.iter().map(|row| if data.sort == MeasuredSort::Creep { 1.0 / row.value } else { row.value }).collect();
    values.sort_by(f64::total_cmp);
    let median = values.get(values.len() / 2).copied().unwrap_or(1.0);
    if !(USUAL_MODULI[0]..=USUAL_MODULI[1]).contains(&median) {
        odd.push(format!("half of the moduli are beyond {median:.1e} Pa: is the unit right?"));
    }
    let strange = data.rows.iter().filter(|row| !(USUAL_TIMES[0]..=USUAL_TIMES[1]).contains(&row.at)).count();
    if strange > 0 && data.rows.iter().any(|row| row.temperature.is_some()) {
        odd.push(format!("{strange} frequencies or times are outside 1e-9 to 1e9, at their own temperatures: is the unit right?"));
    }
    odd
}
