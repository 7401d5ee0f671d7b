//! Source: the report of `viscotack verify`.
//!
//! Goal: one page that needs nothing besides itself, holds every section, plot, table and check, is as safe as its texts are strange, and says so when a
//! check fails; a study whose order is falsified fails.
//!
//! Parameters: a made-up section with everything in it, and a real study that takes no time. Oracle: the text of the page. Tolerance: none.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use viscotack_program::outcome::plot::{Axis, Figure};
use viscotack_verification::studies::{
    Cell, Check, CheckResult, Column, Effort, PAGE, Plot, Progress, Report, STUDIES, Section, Study, Table, chosen, failures, files, ours,
    rival, run, stored_curve,
};

fn section(_: Effort, progress: &Progress) -> Section {
    progress.expect(2);
    progress.advance(2);
    let mut section = Section::new("made_up", "Made up <b>& sons</b>");
    section.say("A paragraph with <script>alert(1)</script> in it.");
    let figure = Figure::new(Axis::logarithmic("time (s)"), Axis::logarithmic("error"))
        .with_curve(ours("ours, order 2.00", vec![(1.0, 1e-2), (2.0, 1e-3)]))
        .with_curve(rival("theirs", vec![(1.0, 1e-1), (2.0, 1e-2)]))
        .with_curve(stored_curve("stored", vec![(1.0, 2e-1), (2.0, 2e-2)]))
        .with_curve(failures("no result: theirs, N = 3", vec![(3.0, 1.0)]));
    section.plots.push(Plot::new("cost", "What \"it\" costs.", figure).headline());
    let mut table = Table::new("numbers", "Numbers.", vec![Column::words("name"), Column::new("length", "m")]);
    table.rows.push(vec![Cell::Word("a, \"b\"".into()), Cell::Number(Some(1.5e-7))]);
    table.rows.push(vec![Cell::Word("none".into()), Cell::Number(None)]);
    section.tables.push(table.clone());
    section.tables.push(Table { identifier: "folded".into(), ..table }.folded());
    section.checks.push(Check::new("holds", "it holds", "it held", true));
    section.checks.push(Check::statement("wins", "it wins", "it lost", false));
    section
}

fn panicking(_: Effort, _: &Progress) -> Section {
    panic!("a defect")
}

fn failing(effort: Effort, progress: &Progress) -> Section {
    let mut section = section(effort, progress);
    section.identifier = "failing".into();
    section.checks.push(Check::new("order: falsified", "order 3", "order 2.00", false));
    section
}

fn of(studies: &[Study]) -> Report {
    run(studies, Effort::Reduced, &Progress::silent())
}

fn made_up() -> Report {
    of(&[Study { identifier: "made_up", alone: true, in_pieces: false, compute: section }])
}

fn page(report: &Report) -> String {
    let (name, bytes) = files(report).unwrap().remove(0);
    assert_eq!(name, PAGE);
    String::from_utf8(bytes).unwrap()
}

/// Nothing that a browser would fetch or run.
fn assert_self_contained(page: &str) {
    for word in ["http", "src=", "<script", "@import", "url(", "<link", "<iframe", "javascript:", "onload"] {
        assert!(!page.contains(word), "the page names {word}");
    }
    assert!(page.starts_with("<!doctype html>") && page.trim_end().ends_with("</html>"));
    assert!(page.contains("prefers-color-scheme:dark") && page.contains("width=device-width"));
}

#[test]
fn the_page_is_whole_and_alone() {
    let report = made_up();
    let page = page(&report);
    assert_self_contained(&page);
    assert!(page.contains("&lt;script&gt;") && page.contains("Made up &lt;b&gt;&amp; sons&lt;/b&gt;"));
    assert!(page.contains("id=\"made_up\"") && page.contains("href=\"#made_up\""));
    assert!(
        page.contains("No check failed") && !page.contains("All checks hold") && page.contains("it lost") && page.contains("1.50·10⁻⁷")
    );
    let drawn = page.matches("<svg").count();
    if cfg!(feature = "plots") {
        assert_eq!(drawn, 2, "at the top and in its section");
        assert!(page.contains("var(--curve-0)") && page.contains("currentColor") && page.contains("var(--paper)"));
        for white in ["fill=\"white\"", "\"#000000\"", "\"#ffffff\""] {
            assert!(!page.contains(white), "{white} would not follow the scheme");
        }
    } else {
        assert!(drawn == 0 && page.contains("draws no plots"));
    }
}

#[test]
fn every_table_and_plot_has_its_file() {
    let files = files(&made_up()).unwrap();
    let names: Vec<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
    let wanted = [PAGE, "summary.json", "checks.csv", "made_up_numbers.csv", "made_up_folded.csv", "made_up_cost_plot.csv"];
    assert_eq!(names, wanted);
    let text = |name: &str| String::from_utf8(files.iter().find(|file| file.0 == name).unwrap().1.clone()).unwrap();
    assert!(text("made_up_numbers.csv").starts_with("name,length [m]\n\"a, \"\"b\"\"\",1.5e-7\nnone,\n"));
    assert!(text("made_up_cost_plot.csv").lines().count() == 8);
    let summary: serde_json::Value = serde_json::from_str(&text("summary.json")).unwrap();
    assert!(summary["passed"] == 1 && summary["stated"] == 1 && summary["failed"] == 0);
}

#[test]
fn a_failure_and_a_panic_are_loud() {
    let report = of(&[
        Study { identifier: "made_up", alone: false, in_pieces: false, compute: section },
        Study { identifier: "failing", alone: false, in_pieces: false, compute: failing },
        Study { identifier: "panicking", alone: true, in_pieces: false, compute: panicking },
    ]);
    assert_eq!((report.count(CheckResult::Passed), report.count(CheckResult::Stated), report.count(CheckResult::Failed)), (2, 2, 2));
    let page = page(&report);
    assert!(
        page.contains("Checks failed") && page.contains("What failed") && page.contains("order: falsified") && page.contains("it panicked")
    );
    assert!(report.table().contains("FAILED failing: order: falsified"));
    assert!(report.closing_line().contains("2 failed"));
}

#[test]
fn studies_are_chosen_by_name_and_their_names_are_their_own() {
    assert_eq!(chosen(&[]).unwrap().len(), STUDIES.len());
    let one = chosen(&["convergence_crack".to_owned()]).unwrap();
    assert!(one.len() == 1 && one[0].identifier == "convergence_crack");
    let error = chosen(&["convergense".to_owned()]).unwrap_err().to_string();
    assert!(error.contains("`convergense`") && error.contains("convergence_crack"));
    let mut names: Vec<&str> = STUDIES.iter().map(|study| study.identifier).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), STUDIES.len());
}

/// A real study, its page and its orders.
#[test]
fn a_real_study_passes_and_is_on_its_page() {
    let report = of(&chosen(&["convergence_crack".to_owned()]).unwrap());
    print!("{}", report.table());
    assert!(report.count(CheckResult::Failed) == 0 && report.count(CheckResult::Passed) >= 4);
    assert!(report.sections[0].identifier == "convergence_crack", "a section has the name of its study");
    let page = page(&report);
    assert_self_contained(&page);
    assert!(page.contains("thesis’s stepping") || page.contains("thesis's stepping"));
}
