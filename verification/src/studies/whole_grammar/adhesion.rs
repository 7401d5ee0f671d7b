//! Draws of works of adhesion that follow the speed.

use super::text::{ENERGY_PER_AREA, NUMBER, SPEED, Text};

/// Writes `adhesion.by_speed`: a law, a table, or the file `works.csv`; works and speeds as (reduced, scale), the works of both edges if they may differ.
pub(super) fn by_speed(text: &mut Text, form: usize, (work, work_scale): (f64, f64), (speed, speed_scale): (f64, f64), per_edge: bool) {
    match form {
        0 => {
            text.put_number("adhesion.work_of_adhesion", work, work_scale, ENERGY_PER_AREA);
            text.put_number("adhesion.by_speed.speed", 2.0 * speed, speed_scale, SPEED);
            let exponent = text.draw.between(0.1, 0.9);
            text.put_number("adhesion.by_speed.exponent", exponent, 1.0, NUMBER);
        }
        1 => {
            let mut items = Vec::new();
            for (slower, factor) in [(1e-6, 0.9), (0.3, 1.0), (1e6, 1.2)] {
                let when = text.number(speed * slower, speed_scale, SPEED);
                let trailing = text.number(work * factor, work_scale, ENERGY_PER_AREA);
                items.push(if per_edge {
                    let leading = text.number(0.7 * work * factor, work_scale, ENERGY_PER_AREA);
                    format!("{{ speed = {when}, trailing_work_of_adhesion = {trailing}, leading_work_of_adhesion = {leading} }}")
                } else {
                    format!("{{ speed = {when}, work_of_adhesion = {trailing} }}")
                });
            }
            text.put("adhesion.by_speed.table", format!("[{}]", items.join(", ")));
        }
        _ => text.put("adhesion.by_speed.file", "\"works.csv\""),
    }
}

/// A file of works about one work and one speed, as the scene's plain numbers are.
pub(super) fn works_file(work: f64, speed: f64) -> String {
    format!("speed, work_of_adhesion\n{:e}, {:e}\n{speed:e}, {work:e}\n{:e}, {:e}\n", 1e-6 * speed, 0.8 * work, 1e6 * speed, 1.3 * work)
}
