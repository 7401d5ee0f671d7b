//! `report.html` of a run: the answer first, then the plots, the validity of the model in words, what was simulated and how, the cost, the provenance.

use super::page::{closed, escaped, opened};
use super::shown_units::in_unit;
use super::{Assessment, Outcome, Row, Status, screen};
use crate::terminal_text;
use std::fmt::Write as _;

/// Name of the page.
pub const PAGE: &str = "report.html";
/// A picture larger than this (bytes) stays a file of its own, which the page shows.
const LARGEST_INLINE: usize = 400_000;

/// A picture of the run: its file stem, and the page's part that shows it.
#[derive(Debug)]
pub struct Shown {
    pub(super) stem: String,
    pub(super) part: String,
}

impl Shown {
    /// A picture that was drawn as vectors, and perhaps as pixels.
    #[must_use]
    pub fn new(stem: &str, svg: Option<&str>) -> Self {
        let label = words(stem);
        let part = match svg {
            Some(svg) if svg.len() <= LARGEST_INLINE => super::plot::inlined(svg, &label),
            Some(_) => image(stem, "svg"),
            None => image(stem, "png"),
        };
        Self { stem: stem.to_owned(), part }
    }
}

fn image(stem: &str, ending: &str) -> String {
    format!("<img class=\"plot\" src=\"{0}.{ending}\" alt=\"{1}\">", escaped(stem), escaped(&words(stem)))
}

fn words(stem: &str) -> String {
    stem.replace(['_', '-'], " ")
}

/// The whole page of an outcome with its pictures; `files` are named at its end. The same outcome gives the same bytes.
#[must_use]
pub fn page(outcome: &Outcome, pictures: &[Shown], files: &[String]) -> String {
    let mut text = opened(&outcome.title);
    head(&mut text, outcome);
    answer(&mut text, outcome);
    drawn(&mut text, outcome, pictures);
    validity(&mut text, outcome);
    done(&mut text, outcome);
    cost(&mut text, outcome);
    provenance(&mut text, outcome, files);
    text.push_str(&closed(&format!("viscotack {}", crate::VERSION_AND_COMMIT)));
    text
}

/// How it ended, before all else.
fn head(text: &mut String, outcome: &Outcome) {
    let tally = &outcome.tally;
    let states = if tally.states == 1 { "one state".to_owned() } else { format!("{} states", tally.states) };
    let _ = write!(
        text,
        "<header>\n<p class=\"name\">viscotack run, {}, {states}</p>\n<h1>{}</h1>\n<ul class=\"counts\">\n",
        escaped(&outcome.problem.replace('_', " ")),
        escaped(&outcome.title)
    );
    for status in Status::ALL {
        let ended = tally.ended(status);
        // What lies on the way is worth a word where it is not solved.
        let on_the_way = if status == Status::Solved { 0 } else { ended.rows - ended.states };
        for (count, one, many) in [(ended.states, "state", "states"), (on_the_way, "row on the way", "rows on the way")] {
            if count > 0 {
                let (noun, word) = (if count == 1 { one } else { many }, status.word().replace('_', " "));
                let _ = writeln!(text, "<li class=\"{}\"><b>{count}</b> {noun} {word}</li>", class(status));
            }
        }
    }
    text.push_str("</ul>\n</header>\n");
}

const fn class(status: Status) -> &'static str {
    match status {
        Status::Solved => "passed",
        Status::Inaccurate | Status::NoSuchState | Status::Undefined => "stated",
        Status::Invalid | Status::NotConverged | Status::Inadmissible => "failed",
    }
}

fn answer(text: &mut String, outcome: &Outcome) {
    text.push_str("<h2>Answer</h2>\n");
    let states: Vec<&Row> = outcome.rows.iter().filter(|row| outcome.is_state(row)).collect();
    if outcome.swept.is_empty() && states.len() <= screen::MOST_BLOCKS {
        states.iter().for_each(|row| state(text, outcome, row));
        return;
    }
    let (shown, lines) = screen::cells(outcome, &states, true, screen::MOST_ROWS_OF_A_PAGE);
    text.push_str("<div class=\"wide\"><table>\n");
    for (index, line) in lines.iter().enumerate() {
        let cell = if index == 0 { "th" } else { "td" };
        // Long names may break after their words.
        let shown = |word: &str| if index == 0 { escaped(word).replace('_', "_<wbr>").replace('.', ".<wbr>") } else { escaped(word) };
        let cells = line.iter().fold(String::new(), |all, word| format!("{all}<{cell}>{}</{cell}>", shown(word)));
        let line = format!("<tr>{cells}</tr>\n");
        text.push_str(&if index == 0 { format!("<thead>{line}</thead>\n<tbody>\n") } else { line });
    }
    text.push_str("</tbody></table></div>\n");
    let mut remarks = String::new();
    screen::remarks(&mut remarks, outcome, &states, &shown, true);
    for line in remarks.lines() {
        let _ = writeln!(text, "<p class=\"caption\">{}</p>", escaped(line));
    }
}

/// One state: a line a value, with what it means.
fn state(text: &mut String, outcome: &Outcome, row: &Row) {
    let words: Vec<&str> = row.labels.iter().map(String::as_str).filter(|word| !word.is_empty()).collect();
    let _ = writeln!(text, "<p class=\"caption\">{}: {}</p>", escaped(&words.join(", ")), escaped(&row.status.word().replace('_', " ")));
    if let Some(reason) = &row.reason {
        let _ = writeln!(text, "<p>{}</p>", escaped(&terminal_text::one_line(reason)));
    }
    let order: Vec<usize> = outcome.layout.as_ref().map_or_else(|| (0..outcome.columns.len()).collect(), |layout| layout.states.clone());
    let mut lines = String::new();
    for index in order {
        if let (Some(column), Some(estimate)) = (outcome.columns.get(index), row.values.get(index).copied().flatten()) {
            let (unit, size) = outcome.unit(index);
            let unit = if unit == "1" { "" } else { unit };
            let material =
                row.material_deviation(index).map_or_else(String::new, |deviation| format!("; material ± {:.1e}", deviation / size));
            let _ = writeln!(
                lines,
                "<tr><th>{}</th><td class=\"word\">{}{material} {}</td><td class=\"sentence\">{}</td></tr>",
                escaped(column.name),
                screen::with_error(in_unit(estimate, size)),
                escaped(unit),
                escaped(column.meaning)
            );
        }
    }
    if !lines.is_empty() {
        let _ = write!(text, "<div class=\"wide\"><table>\n<tbody>\n{lines}</tbody></table></div>\n");
    }
    if let Some(certificate) = row.certificate {
        let admissible = if certificate.admissible { "The state was checked and can exist" } else { "The state can NOT exist" };
        let _ = writeln!(
            text,
            "<p class=\"caption\">{admissible}. Residual of the equations {:.1e}; a relative change of the input changes the output {:.1e} times as much.</p>",
            certificate.residual, certificate.condition
        );
    }
}

fn drawn(text: &mut String, outcome: &Outcome, pictures: &[Shown]) {
    if pictures.is_empty() {
        return;
    }
    text.push_str("<h2>Plots</h2>\n<div class=\"plots\">\n");
    let swept = outcome.swept.last().map(|swept| words(swept.key.rsplit('.').next().unwrap_or(&swept.key)));
    let caption = |stem: &str| match &swept {
        Some(swept) => words(stem).replace("against sweep", &format!("against {swept}")),
        None => words(stem),
    };
    for picture in pictures {
        let endings = [("svg", outcome.pictures.svg), ("png", outcome.pictures.png)];
        let links = endings.into_iter().filter(|(_, drawn)| *drawn).fold(String::new(), |all, (ending, _)| {
            format!("{all} <a href=\"{}.{ending}\">{}</a>", escaped(&picture.stem), ending.to_uppercase())
        });
        let _ =
            write!(text, "<figure>\n{}\n<figcaption>{}{links}</figcaption>\n</figure>\n", picture.part, escaped(&caption(&picture.stem)));
    }
    text.push_str("</div>\n");
}

fn validity(text: &mut String, outcome: &Outcome) {
    if outcome.validity.is_empty() {
        return;
    }
    text.push_str("<h2>Whether the model holds</h2>\n<p>Error bounds say how well the equations are solved. These lines say whether the equations fit the case.</p>\n<ul class=\"checks\">\n");
    for entry in &outcome.validity {
        let class = match entry.assessment {
            Assessment::Good => "passed",
            Assessment::Caution => "stated",
            Assessment::NotAssessed => "unknown",
        };
        let value = entry.value.map_or_else(String::new, |value| format!(" = {value:.2e}"));
        let _ = writeln!(text, "<li class=\"{class}\"><b>{}</b>{value}: {}</li>", escaped(&entry.name), escaped(&entry.meaning));
    }
    text.push_str("</ul>\n");
}

/// What was simulated, what was left out, by which method.
fn done(text: &mut String, outcome: &Outcome) {
    text.push_str("<h2>What was simulated</h2>\n<div class=\"beside\">\n<div class=\"wide\"><table>\n<tbody>\n");
    for effect in &outcome.effects {
        let word = if effect.on { "simulated" } else { "left out" };
        let _ = writeln!(
            text,
            "<tr><th>{}</th><td class=\"word\">{word}</td><td class=\"sentence\">{}</td></tr>",
            escaped(effect.name),
            escaped(&effect.why)
        );
    }
    text.push_str("</tbody></table></div>\n<div>\n<ul>\n");
    for sentence in &outcome.method {
        let _ = writeln!(text, "<li>{}</li>", escaped(sentence));
    }
    text.push_str("</ul>\n");
    if !outcome.groups.is_empty() {
        text.push_str("<div class=\"wide\"><table>\n<tbody>\n");
        for group in &outcome.groups {
            let unit = if group.unit == "1" { "" } else { &group.unit };
            let (name, value) = (escaped(&group.name), super::page::number(group.value));
            let _ = writeln!(text, "<tr><th>{name}</th><td>{value} {}</td></tr>", escaped(unit));
        }
        text.push_str("</tbody></table></div>\n");
    }
    text.push_str("</div>\n</div>\n");
}

fn cost(text: &mut String, outcome: &Outcome) {
    let _ = write!(text, "<h2>Cost</h2>\n<p>{}.</p>\n", escaped(&outcome.work().to_string()));
    if outcome.draws > 0 {
        let _ = writeln!(text, "<p>Each state was solved for {} further materials that the data leave possible.</p>", outcome.draws);
    }
}

fn provenance(text: &mut String, outcome: &Outcome, files: &[String]) {
    let _ = write!(
        text,
        "<h2>Where it comes from</h2>\n<p>viscotack {}. SHA-256 of the scene and all that it names: <code>{}</code>. Wanted accuracy: {:e}.</p>\n<p>Files beside this page:",
        escaped(crate::VERSION_AND_COMMIT),
        escaped(&outcome.scene_hash),
        outcome.accuracy
    );
    for (index, file) in files.iter().enumerate() {
        let _ = write!(text, "{} <a href=\"{1}\">{1}</a>", if index == 0 { "" } else { "," }, escaped(file));
    }
    text.push_str(".</p>\n");
}
