//! The contact sheet: every panel with its plot, its table and what was checked, on one page of HTML.

use super::feature::{Checked, Verdict};
use super::report::{FigureReport, PanelReport, Report};
use viscotack_program::outcome::folder::FolderError;
use viscotack_program::outcome::owned::OwnedFolder;

const STYLE: &str = "body{font:15px/1.45 system-ui,sans-serif;max-width:1180px;margin:2em auto;padding:0 1em;color:#111}\
h2{border-top:1px solid #bbb;padding-top:.8em}.panels{display:flex;flex-wrap:wrap;gap:1.5em}figure{margin:0;width:360px}\
img{width:100%;border:1px solid #ddd}figcaption{font-size:13px}li{margin:.25em 0}.passed::marker{content:'✓ ';color:#0a7d50}\
.not-confirmed::marker{content:'○ ';color:#b36200}.failed::marker{content:'✗ ';color:#b00020}.failed{color:#b00020}\
small{color:#555}table{border-collapse:collapse}td,th{padding:.15em .8em;text-align:right}td:first-child,th:first-child{text-align:left}\
ul{padding-left:1.4em}";

/// Writes `index.html`.
pub(super) fn write(report: &Report, out: &mut OwnedFolder) -> Result<(), FolderError> {
    let mut page = format!(
        "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>Figures of the thesis</title>\n<style>{STYLE}</style>\n\
         <h1>Figures of the thesis, computed and checked</h1>\n<p>{}. ✓ holds, ○ claimed by the thesis and not confirmed, ✗ failed. \
         Behind each feature: where the thesis states it, what was expected and measured, and which mutations of the data break it.</p>\n",
        escaped(&report.program)
    );
    page.push_str(&overview(report));
    for figure in &report.figures {
        page.push_str(&section(figure));
    }
    for (id, reason) in &report.not_reproduced {
        page.push_str(&format!("<h2>Figure {id}</h2>\n<p>Not reproduced: {}</p>\n", escaped(reason)));
    }
    page.push_str("</html>\n");
    out.replace("index.html", page.as_bytes())
}

fn overview(report: &Report) -> String {
    let mut table = "<table>\n<tr><th>figure<th>passed<th>not confirmed<th>failed<th>seconds</tr>\n".to_owned();
    for figure in &report.figures {
        let [passed, open, failed] = [Verdict::Passed, Verdict::NotConfirmed, Verdict::Failed].map(|verdict| figure.count(verdict));
        let id = &figure.id;
        table.push_str(&format!("<tr><td><a href=\"#f{id}\">{id}</a><td>{passed}<td>{open}<td>{failed}<td>{:.2}</tr>\n", figure.seconds));
    }
    table.push_str("</table>\n");
    table
}

fn section(figure: &FigureReport) -> String {
    let entry = &figure.entry;
    let mut text = format!(
        "<h2 id=\"f{}\">Figure {}: {}</h2>\n<p>Thesis Sec {}. Stated there: {} Chosen here: {}</p>\n",
        figure.id,
        figure.id,
        escaped(&entry.title),
        escaped(&entry.section),
        escaped(&entry.stated),
        escaped(&entry.chosen)
    );
    for remark in &figure.remarks {
        text.push_str(&format!("<p><small>No value: {}</small></p>\n", escaped(remark)));
    }
    text.push_str("<div class=\"panels\">\n");
    for panel in &figure.panels {
        text.push_str(&of_panel(panel));
    }
    text.push_str("</div>\n");
    text
}

fn of_panel(panel: &PanelReport) -> String {
    let mut text = format!(
        "<figure><a href=\"{0}.svg\"><img src=\"{0}.svg\" alt=\"panel {0}\" loading=\"lazy\"></a>\n<figcaption><b>{0}</b> {1} <a href=\"{0}.csv\">table</a>\n<ul>\n",
        panel.id,
        escaped(&panel.entry.title)
    );
    for feature in &panel.features {
        text.push_str(&of_feature(feature));
    }
    text.push_str("</ul></figcaption></figure>\n");
    text
}

fn of_feature(feature: &Checked) -> String {
    let source = if feature.source.is_empty() { "ours".to_owned() } else { escaped(&feature.source) };
    let numbers = feature.measured.iter().map(|number| short(*number)).collect::<Vec<_>>().join(", ");
    let broken = feature.broken_by.iter().map(|mutation| mutation.word()).collect::<Vec<_>>().join(", ");
    let why = if feature.why.is_empty() { String::new() } else { format!(" {}", escaped(&feature.why)) };
    format!(
        "<li class=\"{}\">{}{why} <small>({source}; expected {}; measured {numbers}; broken by: {broken})</small></li>\n",
        feature.verdict.word().replace(' ', "-"),
        escaped(&feature.claim),
        escaped(&feature.expected)
    )
}

/// Four digits.
fn short(number: f64) -> String {
    if number == 0.0 || (1e-2..1e4).contains(&number.abs()) { format!("{number:.4}") } else { format!("{number:.3e}") }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
