//! `viscotack explain`: what a scene simulates and leaves out, by which method, at what cost; nothing is solved.

use super::scene_source::SceneSource;
use super::{Failure, SceneArguments, print, print_json};
use crate::plan::Plan;
use serde_json::json;
use std::fmt::Write as _;

pub(super) fn explain(arguments: &SceneArguments, json: bool) -> Result<u8, Failure> {
    let source = SceneSource::load(arguments)?;
    let plan = Plan::new(&source.scene)?;
    let work = plan.predicted_work();
    if json {
        let value = json!({
            "title": source.scene.title,
            "problem": plan.problem(),
            "states": plan.states(),
            "effects": plan.effects(),
            "method": plan.method(),
            "groups": plan.groups(),
            "predicted_work": work,
            "predicted_memory_bytes": plan.predicted_memory(),
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
    let _ = writeln!(text, "\ncharacteristic numbers");
    for group in plan.groups() {
        let unit = if group.unit == "1" { "" } else { &group.unit };
        let line = format!("  {:32} {:.6e} {unit}", group.name, group.value);
        let _ = writeln!(text, "{}", line.trim_end());
    }
    let _ = writeln!(text, "\npredicted work\n  {work}, at most {} MB of memory", plan.predicted_memory().div_ceil(1_000_000));
    print(&text)?;
    Ok(0)
}

/// `1 state`, `2 states`.
fn counted(number: usize, what: &str) -> String {
    if number == 1 { format!("1 {what}") } else { format!("{number} {what}s") }
}
