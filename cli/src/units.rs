//! `viscotack units`: every unit that is read, from the one list that reads them.

use super::{Failure, print};
use serde_json::{Value, json};
use std::fmt::Write as _;
use viscotack_program::scene::units::{UnitGroup, groups};

pub(super) fn units(as_json: bool) -> Result<u8, Failure> {
    let groups = groups();
    print(&if as_json { format!("{:#}\n", Value::from(groups.iter().map(group_as_json).collect::<Vec<_>>())) } else { table(&groups) })?;
    Ok(0)
}

fn group_as_json(group: &UnitGroup) -> Value {
    let unit = |unit: &viscotack_program::scene::units::ListedUnit| json!({ "unit": unit.unit, "size": unit.size, "zero": unit.zero, "prefixes": unit.prefixes });
    json!({ "what": group.what, "si_unit": group.dimension.si_unit(), "units": group.units.iter().map(unit).collect::<Vec<_>>() })
}

fn table(groups: &[UnitGroup]) -> String {
    let mut text = String::new();
    for group in groups {
        // Writing to a String cannot fail.
        let si = group.dimension.si_unit();
        let _ = writeln!(text, "{}", group.what);
        for unit in &group.units {
            let prefixes = if unit.prefixes { "  (with prefixes)" } else { "" };
            let zero = if unit.zero == 0.0 { String::new() } else { format!(", 0 is {:.2} {si}", unit.zero) };
            let size = if (1e-3..1e6).contains(&unit.size) { format!("{}", unit.size) } else { format!("{:e}", unit.size) };
            let line = format!("  {:12} = {size} {}{zero}{prefixes}", unit.unit, if si == "1" { "" } else { &si });
            let _ = writeln!(text, "{}", line.trim_end());
        }
    }
    text.push_str(
        "\nprefixes: f p n µ (or u) m c k M G T. Products: `kPa s`, `kPa·s`, `Pa.s`, `Pa*s`; quotients: `N/m2`, `J/(mol)`; powers: `m2`, `m^2`, `m²`, `m**2`, `m^-1`, `m⁻¹`, `√m`, `m^0.5`, `m^(1/2)`.\n",
    );
    text
}
