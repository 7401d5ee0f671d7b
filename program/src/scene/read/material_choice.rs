//! Which columns of a material's table are used: the quantity, where it was measured, and how a complex modulus is given.

use super::column_names::{EXAMPLE, Role, spoken, word};
use super::material_columns::{StatedColumn, lines_to_type};
use super::material_rows::Columns;
use crate::scene::diagnostic::SceneError;
use crate::scene::typed::MeasuredSort;

/// The columns that are used of a block.
pub(super) struct Choice {
    pub(super) sort: MeasuredSort,
    /// Of the value.
    pub(super) main: Role,
    /// Of the frequency or time.
    pub(super) place: Role,
    /// Of what completes a complex modulus.
    pub(super) second: Option<Role>,
    /// The loss tangent, if the loss modulus is used and it stands beside.
    pub(super) tangent_beside: Option<Role>,
    /// The frequency, if the angular one is used and it stands beside.
    pub(super) frequency_beside: Option<Role>,
    /// All roles that are used or compared.
    pub(super) roles: Vec<Role>,
    /// Their columns.
    pub(super) used: Vec<usize>,
    pub(super) notes: Vec<String>,
}

/// The storage and the loss modulus from two columns.
pub(super) fn complex_parts(main: Role, value: f64, role: Role, second: f64) -> (f64, f64) {
    match (main, role) {
        (Role::Complex, Role::LossTangent) => (value * second.atan().cos(), value * second.atan().sin()),
        (Role::Complex, _) => (value * second.cos(), value * second.sin()),
        (_, Role::LossTangent) => (value, value * second),
        (_, Role::Phase) => (value, value * second.tan()),
        _ => (value, second),
    }
}

pub(super) fn chosen(columns: &Columns, stated: &[StatedColumn], file: &str) -> Result<Choice, SceneError> {
    let wrong = |message: String| {
        let guessed = columns.guessed(&[Role::Frequency, Role::Storage, Role::Loss]);
        let help = if guessed.is_empty() {
            EXAMPLE.to_owned()
        } else {
            format!("{EXAMPLE}; such as, if these columns are meant:\n{}", lines_to_type(&guessed))
        };
        SceneError::at(&columns.header, message, "in this header").help(help)
    };
    let says = |role: Role| stated.iter().any(|entry| entry.0 == role);
    let has = |role: Role| columns.has(role);
    let sorts = [
        (MeasuredSort::Moduli, [Role::Storage, Role::Complex]),
        (MeasuredSort::Relaxation, [Role::Relaxation; 2]),
        (MeasuredSort::Creep, [Role::Creep; 2]),
    ];
    let of = |has: &dyn Fn(Role) -> bool| -> Vec<MeasuredSort> {
        sorts.iter().filter(|(_, mains)| mains.iter().any(|role| has(*role))).map(|(sort, _)| *sort).collect()
    };
    let by_scene = of(&says);
    let sort = match (by_scene.as_slice(), of(&has).as_slice()) {
        ([one], _) | ([], [one]) => *one,
        (_, []) => {
            return Err(wrong(format!("{file:?} has no column with a storage modulus, a relaxation modulus or a creep compliance")));
        }
        _ => return Err(wrong(format!("{file:?} holds more than one of storage modulus, relaxation modulus and creep compliance"))),
    };
    let mut choice = Choice {
        sort,
        main: Role::Storage,
        place: Role::Time,
        second: None,
        tangent_beside: None,
        frequency_beside: None,
        roles: Vec::new(),
        used: Vec::new(),
        notes: Vec::new(),
    };
    match sort {
        MeasuredSort::Moduli => moduli(&mut choice, columns, &says, &wrong, file)?,
        _ => {
            choice.main = if sort == MeasuredSort::Creep { Role::Creep } else { Role::Relaxation };
            if !has(Role::Time) {
                return Err(wrong(format!("{file:?} has no column with a time")));
            }
        }
    }
    let temperature = has(Role::Temperature).then_some(Role::Temperature);
    let roles = [Some(choice.main), Some(choice.place), choice.second, choice.tangent_beside, choice.frequency_beside, temperature];
    // All that lack a unit are named at once.
    let lines = columns.lines(&roles.into_iter().flatten().collect::<Vec<_>>());
    for role in roles.into_iter().flatten() {
        // A unit that cannot be read counts from here on.
        let column = columns.get(role).map_err(|error| if lines.len() > 1 { error.help(lines_to_type(&lines)) } else { error });
        if let Some(column) = column? {
            choice.used.push(column.index);
            choice.roles.push(role);
        }
    }
    Ok(choice)
}

/// The columns of a complex modulus and of its frequency.
fn moduli(
    choice: &mut Choice,
    columns: &Columns,
    says: &dyn Fn(Role) -> bool,
    wrong: &dyn Fn(String) -> SceneError,
    file: &str,
) -> Result<(), SceneError> {
    let has = |role: Role| columns.has(role);
    choice.place = match (has(Role::Frequency), has(Role::AngularFrequency)) {
        (true, false) => Role::Frequency,
        (false, true) => Role::AngularFrequency,
        (true, true) => {
            choice.frequency_beside = Some(Role::Frequency);
            choice.notes.push(format!("{file:?}: the angular frequency is used; the frequency beside it agrees"));
            Role::AngularFrequency
        }
        (false, false) => return Err(wrong(format!("{file:?} has no column with a frequency"))),
    };
    choice.main = if has(Role::Storage) && (says(Role::Storage) || !says(Role::Complex)) { Role::Storage } else { Role::Complex };
    // Two columns of it come before what may be missing.
    if columns.count(choice.main) > 1 {
        columns.get(choice.main)?;
    }
    let seconds: &[Role] =
        if choice.main == Role::Storage { &[Role::Loss, Role::LossTangent, Role::Phase] } else { &[Role::Phase, Role::LossTangent] };
    let given = seconds.iter().copied().filter(|role| has(*role));
    let second = given.clone().find(|role| says(*role)).or_else(|| given.clone().next());
    let Some(second) = second else {
        let names: Vec<String> = seconds.iter().map(|role| spoken(*role)).collect();
        return Err(wrong(format!("{file:?} has a {}, and no column with a {}", spoken(choice.main), names.join(" or a "))));
    };
    choice.second = Some(second);
    choice.tangent_beside = (second == Role::Loss && has(Role::LossTangent) && !says(Role::LossTangent)).then_some(Role::LossTangent);
    let beside = has(Role::Loss) || (has(Role::Phase) && has(Role::LossTangent));
    if choice.tangent_beside.is_none() && beside && (second != Role::Loss || choice.main == Role::Complex) {
        choice.notes.push(format!("{file:?}: the complex modulus is taken from `{}` and `{}`", word(choice.main), word(second)));
    }
    Ok(())
}
