//! Whether a table is of shear: its moduli become Young's.

use super::column_names::Strained;
use super::material_choice::Choice;
use super::material_columns::Column;
use super::material_rows::Columns;
use super::section::Section;
use crate::scene::diagnostic::SceneError;
use crate::scene::typed::MeasuredSort;

/// What the moduli of a table are multiplied by to be Young's: 2(1 + ν) of shear; its inverse for compliances.
pub(super) fn stretch_to_young(
    table: &Section<'_>,
    columns: &Columns,
    choice: &Choice,
    poisson_ratio: Option<f64>,
) -> Result<f64, SceneError> {
    let mut named: [Option<&Column>; 2] = [None, None];
    for role in [Some(choice.main), choice.second].into_iter().flatten() {
        let Some(column) = columns.get(role)? else { continue };
        match column.strained {
            Some(Strained::Shear) => named[0] = named[0].or(Some(column)),
            Some(Strained::Tension) => named[1] = named[1].or(Some(column)),
            None => {}
        }
    }
    let said = table.table("columns").and_then(|columns| columns.text("of").map(str::to_owned));
    let [shear, tension] = named;
    let (place, text) = match (said.as_deref(), shear, tension) {
        (Some("shear"), ..) => shear.map_or((&columns.header, ""), |column| (&column.place, column.text.as_str())),
        (Some(_), ..) | (None, None, _) => return Ok(1.0),
        (None, Some(one), Some(other)) => {
            let message = format!("`{}` is named like a modulus of shear, and `{}` like one of tension", one.text, other.text);
            return Err(SceneError::at(&one.place, message, "of shear or of tension?")
                .help("write of = \"shear\" or of = \"tension\" into [material.columns]"));
        }
        (None, Some(column), None) if column.by_scene => {
            let message = format!("`{}` is named like a shear modulus, and [material.columns] does not say of what it is", column.text);
            return Err(SceneError::at(&column.place, message, "of shear or of tension?")
                .help("write of = \"shear\" or of = \"tension\" into [material.columns]"));
        }
        (None, Some(column), None) => (&column.place, column.text.as_str()),
    };
    let ratio = poisson_ratio.ok_or_else(|| {
        SceneError::at(place, format!("`{text}` is of shear, a material is given by Young's modulus"), "of shear")
            .help("give material.poisson_ratio: E = 2(1 + ν)G; or of = \"tension\" in [material.columns] if it is Young's modulus")
    })?;
    let stretch = 2.0 * (1.0 + ratio);
    Ok(if choice.sort == MeasuredSort::Creep { 1.0 / stretch } else { stretch })
}
