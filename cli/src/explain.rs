//! `viscotack explain`: what a scene simulates and leaves out, by which method, at what cost; nothing is solved.

use super::scene_source::SceneSource;
use super::{Failure, SceneArguments, print, print_json};
use serde_json::json;
use std::fmt::Write as _;
use viscotack_program::plan::Plan;
use viscotack_program::scene::history_written_out;

pub(super) fn explain(arguments: &SceneArguments, json: bool) -> Result<u8, Failure> {
    arguments.threads.start();
    let source = SceneSource::load(arguments)?;
    let plan = Plan::new(&source.scene)?;
    let work = plan.predicted_work();
    let written_out = history_written_out(&source.scene, &source.document);
    if json {
        let value = json!({
            "title": source.scene.title,
            "problem": plan.problem(),
            "states": plan.states(),
            "effects": plan.effects(),
            "method": plan.method(),
            "groups": plan.groups(),
            "cautions": plan.cautions(),
            "history": written_out,
            "predicted_work": work,
            "predicted_memory_bytes": plan.predicted_memory(),
            "predicted_seconds": plan.predicted_seconds(),
            "predicted_disk_bytes": plan.predicted_disk(),
            "accuracy": source.scene.accuracy,
        });
        print_json(|out| write!(out, "{value:#}"))?;
        return Ok(0);
    }
    let mut text = format!(
        "{}\nproblem: {}, {}, accuracy {:e}\n",
        source.scene.title,
        plan.problem(),
        counted(plan.states(), "state"),
        source.scene.accuracy
    );
    let _ = writeln!(text, "\neffects");
    for effect in plan.effects() {
        let _ = writeln!(text, "  {:3}  {:22} {}", if effect.on { "on" } else { "off" }, effect.name, effect.why);
    }
    let _ = writeln!(text, "\nmethod");
    for sentence in plan.method() {
        let _ = writeln!(text, "  {sentence}");
    }
    if let Some(segments) = written_out {
        let _ = writeln!(text, "\nhistory, written out ({})", counted(segments.len(), "segment"));
        for segment in &segments {
            let _ = writeln!(text, "  [[history]]");
            for line in segment.lines() {
                let _ = writeln!(text, "  {line}");
            }
        }
    }
    let _ = writeln!(text, "\ncharacteristic numbers");
    for group in plan.groups() {
        let unit = if group.unit == "1" { "" } else { &group.unit };
        let line = format!("  {:32} {:.6e} {unit}", group.name, group.value);
        let _ = writeln!(text, "{}", line.trim_end());
    }
    let cautions = plan.cautions();
    if !cautions.is_empty() {
        let _ = writeln!(text, "\ncautions");
        for caution in &cautions {
            let _ = writeln!(text, "  CAUTION  {caution}");
        }
    }
    let _ = writeln!(text, "\npredicted work\n  {work}, at most {} MB of memory", plan.predicted_memory().div_ceil(1_000_000));
    let disk = plan.predicted_disk().div_ceil(1_000_000);
    let seconds = duration(plan.predicted_seconds());
    let _ = writeln!(text, "  about {seconds} (within a factor of ten), and with --out at most {disk} MB on disk");
    let _ = writeln!(text, "\nfiles (with --out)\n  {}", files(&plan));
    print(&text)?;
    Ok(0)
}

/// Which table holds what.
fn files(plan: &Plan) -> &'static str {
    match (plan.layout().is_some(), plan.states() > 1) {
        (true, true) => "states.csv: one row a state, with its answer; path.csv: instants and events on the way of each state",
        (true, false) => "states.csv: the answer; path.csv: instants and events on the way to it",
        (false, _) => "states.csv: one row a state and kind of row",
    }
}

/// Seconds in words.
fn duration(seconds: f64) -> String {
    match seconds {
        short if short < 1.0 => "1 s or less".to_owned(),
        short if short < 120.0 => format!("{short:.0} s"),
        middle if middle < 7200.0 => format!("{:.0} min", middle / 60.0),
        long => format!("{:.0} h", long / 3600.0),
    }
}

/// `1 state`, `2 states`.
fn counted(number: usize, what: &str) -> String {
    if number == 1 { format!("1 {what}") } else { format!("{number} {what}s") }
}
