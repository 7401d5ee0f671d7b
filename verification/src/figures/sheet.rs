//! The contact sheet: every panel with its plot, its table and what was checked, on one page of HTML.

use super::feature::FeatureResult;
use super::report::Report;
use super::shown::{ShownFeature, ShownFigure, ShownPanel};
use viscotack_program::outcome::folder::FolderError;
use viscotack_program::outcome::owned::OwnedFolder;
use viscotack_program::outcome::page::{closed, duration, escaped, number, opened};

/// Writes `index.html` of the figures in the folder.
pub(super) fn write(report: &Report, figures: &[ShownFigure], out: &mut OwnedFolder) -> Result<(), FolderError> {
    let failed: usize = figures.iter().map(|figure| figure.count(FeatureResult::Failed)).sum();
    let (class, word) = if failed == 0 { ("good", "No feature failed") } else { ("bad", "Features failed") };
    let mut page = opened("Figures of the thesis");
    page.push_str(&format!(
        "<header>\n<p class=\"name\">viscotack figures</p>\n<h1 class=\"{class}\">{word}</h1>\n\
         <p>Figures of the thesis, computed and checked. ✓ holds, ○ claimed by the thesis and not confirmed, ✗ failed. \
         Behind each feature: where the thesis states it, what was expected and measured, and which mutations of the data break it.</p>\n</header>\n"
    ));
    page.push_str(&earlier(figures));
    page.push_str(&overview(figures));
    for figure in figures {
        page.push_str(&section(figure));
    }
    for (id, reason) in &report.not_reproduced {
        page.push_str(&format!("<h2>Figure {id}</h2>\n<p>Not reproduced: {}</p>\n", escaped(reason)));
    }
    page.push_str(&closed(&report.program));
    out.replace("index.html", page.as_bytes())
}

/// How many panels earlier runs left.
fn earlier(figures: &[ShownFigure]) -> String {
    match figures.iter().flat_map(|figure| &figure.panels).filter(|panel| panel.earlier).count() {
        0 => String::new(),
        1 => "<p>One panel is of an earlier run; its caption says of which day.</p>\n".to_owned(),
        count => format!("<p>{count} panels are of earlier runs; their captions say of which day.</p>\n"),
    }
}

fn overview(figures: &[ShownFigure]) -> String {
    let mut table = "<div class=\"wide\"><table class=\"overview\">\n<thead><tr><th>figure</th><th>passed</th><th>not confirmed</th><th>failed</th><th>time</th></tr></thead>\n<tbody>\n".to_owned();
    for figure in figures {
        let [passed, open, failed] =
            [FeatureResult::Passed, FeatureResult::NotConfirmed, FeatureResult::Failed].map(|result| figure.count(result));
        let class = if failed > 0 { " class=\"failed\"" } else { "" };
        let (id, title, time) = (&figure.id, escaped(&figure.title), duration(figure.seconds));
        table.push_str(&format!(
            "<tr{class}><td><a href=\"#f{id}\">{id} {title}</a></td><td>{passed}</td><td>{open}</td><td>{failed}</td><td>{time}</td></tr>\n"
        ));
    }
    table.push_str("</tbody></table></div>\n");
    table
}

fn section(figure: &ShownFigure) -> String {
    let mut text = format!(
        "<section>\n<h2 id=\"f{}\">Figure {}: {}</h2>\n<p>Thesis Sec {}. Stated there: {} Chosen here: {}</p>\n",
        figure.id,
        figure.id,
        escaped(&figure.title),
        escaped(&figure.section),
        escaped(&figure.stated),
        escaped(&figure.chosen)
    );
    for remark in &figure.remarks {
        text.push_str(&format!("<p><small>No value: {}</small></p>\n", escaped(remark)));
    }
    text.push_str("<div class=\"plots\">\n");
    for panel in &figure.panels {
        text.push_str(&of_panel(panel));
    }
    text.push_str("</div>\n</section>\n");
    text
}

fn of_panel(panel: &ShownPanel) -> String {
    let mut text = format!(
        "<figure><a href=\"{0}.svg\"><img class=\"plot\" src=\"{0}.svg\" alt=\"panel {0}\" loading=\"lazy\"></a>\n<figcaption><b>{0}</b> {1} <a href=\"{0}.csv\">Points (CSV)</a>{2}</figcaption>\n<ul class=\"checks\">\n",
        panel.id,
        escaped(&panel.title),
        when(panel)
    );
    for feature in &panel.features {
        text.push_str(&of_feature(feature));
    }
    text.push_str("</ul></figure>\n");
    text
}

/// When an earlier panel was made, by what, and what its table was.
fn when(panel: &ShownPanel) -> String {
    if !panel.earlier {
        return String::new();
    }
    let digits: String = panel.digest.chars().take(12).collect();
    let now = if panel.altered { ", which was altered since" } else { "" };
    format!(" <small>Of {}, by {}; the SHA-256 of its table begins {digits}{now}.</small>", escaped(&panel.date), escaped(&panel.program))
}

fn of_feature(feature: &ShownFeature) -> String {
    let source = if feature.source.is_empty() { "ours".to_owned() } else { escaped(&feature.source) };
    let numbers = feature.measured.iter().map(|value| value.parse().map_or_else(|_| escaped(value), number)).collect::<Vec<_>>().join(", ");
    let broken = escaped(&feature.broken_by.join(", "));
    let why = if feature.why.is_empty() { String::new() } else { format!(" {}", escaped(&feature.why)) };
    format!(
        "<li class=\"{}\">{}{why} <small>({source}; expected {}; measured {numbers}; broken by: {broken})</small></li>\n",
        match feature.result {
            FeatureResult::Passed => "passed",
            FeatureResult::NotConfirmed => "stated",
            FeatureResult::Failed => "failed",
        },
        escaped(&feature.claim),
        escaped(&feature.expected)
    )
}
