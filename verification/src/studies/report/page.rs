//! The page: what passed and failed, the headline plots, then every section. No scripts, nothing from elsewhere.

use super::{plot_name, table_name};
use crate::studies::run::Report;
use crate::studies::section::{Cell, Check, CheckResult, Plot, Section, Table};
use std::fmt::Write as _;
use viscotack_program::outcome::page::{closed, duration, escaped, number, opened};
use viscotack_program::outcome::plot::{self, PlotError};

/// More checks than this are folded away, but for those that failed or are stated.
const MOST_OPEN: usize = 6;
/// Words of a table longer than this are broken over lines.
const LONG_WORDS: usize = 36;

/// The whole page.
pub(super) fn page(report: &Report) -> String {
    let mut text = opened(&format!("viscotack verify: {}", result(report).to_lowercase()));
    text.push_str(&head(report));
    text.push_str(&loud(report));
    text.push_str(&headlines(report));
    text.push_str(&overview(report));
    for section in &report.sections {
        text.push_str(&of_section(section));
    }
    text.push_str(&closed(&stamp(report)));
    text
}

fn stamp(report: &Report) -> String {
    let stamp = &report.stamp;
    let cores = if stamp.cores == 1 { "one core".to_owned() } else { format!("{} cores", stamp.cores) };
    format!("{} · {} · {} · {cores} · {} · {}", stamp.program, stamp.date, stamp.machine, stamp.compiler, duration(report.seconds))
}

/// What a reader wants to know first: what is stated does not fail, but does not hold either.
fn result(report: &Report) -> &'static str {
    match [CheckResult::Failed, CheckResult::Stated].map(|result| report.count(result)) {
        [0, 0] => "All checks hold",
        [0, _] => "No check failed",
        _ => "Checks failed",
    }
}

fn head(report: &Report) -> String {
    let [passed, stated, failed] = [CheckResult::Passed, CheckResult::Stated, CheckResult::Failed].map(|result| report.count(result));
    let extent = report.extent();
    let word = result(report);
    let class = if failed == 0 { "good" } else { "bad" };
    format!(
        "<header>\n<p class=\"name\">viscotack verify, {extent} run</p>\n<h1 class=\"{class}\">{word}</h1>\n<ul class=\"counts\">\n\
         <li class=\"passed\"><b>{passed}</b> passed</li>\n<li class=\"stated\"><b>{stated}</b> stated</li>\n<li class=\"failed{}\"><b>{failed}</b> failed</li>\n</ul>\n\
         <p class=\"stamp\">{}</p>\n\
         <p>What accuracy costs, where it is hard, what each effect adds. Each check says beforehand what is expected and why. <i>Stated</i> is what does not hold \
         and is said with numbers, as a rival that wins somewhere: times are stated and never fail. Every table and plot has its CSV beside this page.</p>\n</header>\n",
        if failed == 0 { " none" } else { "" },
        escaped(&stamp(report))
    )
}

/// What did not hold, before anything else.
fn loud(report: &Report) -> String {
    let mut text = String::new();
    for (result, heading) in [(CheckResult::Failed, "What failed"), (CheckResult::Stated, "What does not hold and is only stated")] {
        let all: Vec<(&Section, &Check)> = report.ended(result).collect();
        if all.is_empty() {
            continue;
        }
        let _ = write!(text, "<h2>{heading}</h2>\n<ul class=\"checks\">\n");
        for (section, check) in all {
            text.push_str(&of_check(check, Some(section)));
        }
        text.push_str("</ul>\n");
    }
    text
}

fn headlines(report: &Report) -> String {
    let mut text = String::new();
    for section in &report.sections {
        for plot in section.plots.iter().filter(|plot| plot.headline) {
            text.push_str(&of_plot(section, plot, true));
        }
    }
    if text.is_empty() { text } else { format!("<h2>At a glance</h2>\n<div class=\"plots\">\n{text}</div>\n") }
}

fn overview(report: &Report) -> String {
    let mut text = "<h2>Sections</h2>\n<div class=\"wide\"><table class=\"overview\">\n<thead><tr><th>section</th><th>passed</th><th>stated</th><th>failed</th><th>time</th></tr></thead>\n<tbody>\n".to_owned();
    for section in &report.sections {
        let [passed, stated, failed] = [CheckResult::Passed, CheckResult::Stated, CheckResult::Failed].map(|result| section.count(result));
        let class = if failed > 0 { " class=\"failed\"" } else { "" };
        let _ = writeln!(
            text,
            "<tr{class}><td><a href=\"#{}\">{}</a></td><td>{passed}</td><td>{stated}</td><td>{failed}</td><td>{}</td></tr>",
            escaped(&section.identifier),
            escaped(&section.title),
            duration(section.seconds)
        );
    }
    text.push_str("</tbody></table></div>\n");
    text
}

fn of_section(section: &Section) -> String {
    let mut text = format!("<section id=\"{}\">\n<h2>{}</h2>\n", escaped(&section.identifier), escaped(&section.title));
    for paragraph in &section.paragraphs {
        let _ = writeln!(text, "<p>{}</p>", escaped(paragraph));
    }
    if !section.plots.is_empty() {
        text.push_str("<div class=\"plots\">\n");
        for plot in &section.plots {
            text.push_str(&of_plot(section, plot, false));
        }
        text.push_str("</div>\n");
    }
    text.push_str(&of_checks(&section.checks));
    for table in &section.tables {
        text.push_str(&of_table(section, table));
    }
    text.push_str("</section>\n");
    text
}

fn of_plot(section: &Section, plot: &Plot, linked: bool) -> String {
    let file = plot_name(&section.identifier, plot);
    let drawn = match plot::inline_svg(&plot.figure, &plot.caption) {
        Ok(svg) => svg,
        Err(PlotError::NotBuilt) => format!(
            "<p class=\"absent\">This build draws no plots: build it with the feature plots. The points are in {}.</p>",
            escaped(&file)
        ),
        Err(error) => format!("<p class=\"absent\">{}</p>", escaped(&error.to_string())),
    };
    let more = if linked {
        format!("<a href=\"#{}\">{}</a>", escaped(&section.identifier), escaped(&section.title))
    } else {
        format!("<a href=\"{}\">Points (CSV)</a>", escaped(&file))
    };
    format!("<figure>\n{drawn}\n<figcaption>{} {more}</figcaption>\n</figure>\n", escaped(&plot.caption))
}

/// What failed or is stated is open; so is what passed, if it is not much.
fn of_checks(checks: &[Check]) -> String {
    let list = |wanted: &dyn Fn(&Check) -> bool| {
        checks.iter().filter(|check| wanted(check)).fold(String::new(), |all, check| all + &of_check(check, None))
    };
    let passed = checks.iter().filter(|check| check.result == CheckResult::Passed).count();
    let mut text = String::new();
    let open = list(&|check| check.result != CheckResult::Passed || passed <= MOST_OPEN);
    if !open.is_empty() {
        let _ = write!(text, "<ul class=\"checks\">\n{open}</ul>\n");
    }
    if passed > MOST_OPEN {
        let folded = list(&|check| check.result == CheckResult::Passed);
        let _ = write!(text, "<details>\n<summary>{passed} checks passed</summary>\n<ul class=\"checks\">\n{folded}</ul>\n</details>\n");
    }
    text
}

fn of_check(check: &Check, section: Option<&Section>) -> String {
    let class = match check.result {
        CheckResult::Passed => "passed",
        CheckResult::Stated => "stated",
        CheckResult::Failed => "failed",
    };
    let place = section
        .map_or_else(String::new, |section| format!(" <a href=\"#{}\">{}</a>", escaped(&section.identifier), escaped(&section.title)));
    format!(
        "<li class=\"{class}\"><b>{}</b>: {}{place} <small>Expected: {}.</small></li>\n",
        escaped(&check.name),
        escaped(&check.found),
        escaped(check.expected.trim_end_matches('.'))
    )
}

fn of_table(section: &Section, table: &Table) -> String {
    let file = escaped(&table_name(&section.identifier, table));
    let mut body = "<div class=\"wide\"><table>\n<thead><tr>".to_owned();
    for column in &table.columns {
        let unit = if column.unit.is_empty() || column.unit == "1" {
            String::new()
        } else {
            format!(" <span class=\"unit\">{}</span>", escaped(&column.unit))
        };
        let class = if column.unit.is_empty() { " class=\"word\"" } else { "" };
        let _ = write!(body, "<th{class}>{}{unit}</th>", escaped(&column.name));
    }
    body.push_str("</tr></thead>\n<tbody>\n");
    for row in &table.rows {
        body.push_str("<tr>");
        for cell in row {
            let _ = match cell {
                Cell::Word(word) => {
                    let class = if word.chars().count() > LONG_WORDS { "word long" } else { "word" };
                    write!(body, "<td class=\"{class}\">{}</td>", escaped(word))
                }
                Cell::Number(value) => write!(body, "<td>{}</td>", value.map_or_else(String::new, number)),
            };
        }
        body.push_str("</tr>\n");
    }
    body.push_str("</tbody></table></div>\n");
    let link = format!("<a href=\"{file}\">CSV</a>");
    if table.folded {
        format!(
            "<details>\n<summary>{} ({} rows)</summary>\n{body}<p class=\"caption\">{link}</p>\n</details>\n",
            escaped(&table.caption),
            table.rows.len()
        )
    } else {
        format!("<p class=\"caption\">{} {link}</p>\n{body}", escaped(&table.caption))
    }
}
