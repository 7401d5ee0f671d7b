//! Published boundary-element runs of an adhesive viscoelastic sphere, solved again.
//!
//! ```text
//! published   rows as they were published, their spectrum as terms
//! solved      each row by two runs of different tolerances, and by the theory of an edge     compared with what was published
//! ```
//! The public table (9005 rows) stays outside of the repository; 80 of its rows are `reference_data/published_spheres.csv`. The full study takes
//! every 17th row of the table besides, if it lies in `../shared/data`.

pub mod published;
mod solved;

use super::cells::{count, number, word};
use super::{Cell, Check, Column, Effort, Plot, Progress, Section, Table};
use published::Published;
use rayon::prelude::*;
use solved::{Solved, ZONES, solved};
use viscotack_program::outcome::plot::{Axis, Curve, Figure, Line, Marker};

/// One row of the table in so many.
const EVERY: usize = 17;
/// One row in so many is also solved by the theory of an edge, which takes seconds with forty terms.
const EDGE_EVERY: usize = 5;
/// What both runs of ours may differ by.
const OURS: f64 = 1e-4;
/// What the energy balance may leave, over the largest energy.
const BALANCE: f64 = 1e-3;
/// From this Tabor number on the range of attraction is short enough for the theory of an edge.
const LARGE_TABOR: f64 = 2.5;
/// A row that is further off is listed.
const LISTED: f64 = 1e-2;

/// Why a row is in a class of its own, and how far the published value may be off there.
struct Class {
    name: &'static str,
    allowed: f64,
    holds: fn(&Published) -> bool,
}

/// Classes in which the published runs are converged: their own repeated states agree there.
const CLASSES: [Class; 3] = [
    Class {
        name: "fast, Tabor number 3.24, exponent 1.6, rate 1e4",
        allowed: 2.5e-3,
        holds: |row| same(row.tabor, 3.24) && same(row.exponent, 1.6) && same(row.rate, 1e4) && row.preload < 75.0,
    },
    Class {
        name: "small: Tabor number up to 0.3, preload up to 5, exponent from 0.6, rate up to 1e6",
        allowed: 3e-3,
        holds: |row| row.tabor <= 0.3 && row.preload <= 5.0 && row.exponent >= 0.6 && row.rate <= 1e6,
    },
    Class {
        name: "large: Tabor number from 3, preload below 60, rate from 100",
        allowed: 6e-3,
        holds: |row| row.tabor >= 3.0 && row.preload < 60.0 && row.rate >= 100.0,
    },
];

fn same(a: f64, b: f64) -> bool {
    (a / b - 1.0).abs() < 1e-3
}

/// The study.
pub fn study(effort: Effort, progress: &Progress) -> Section {
    let mut section = Section::new("published_spheres", "Published runs of an adhesive viscoelastic sphere");
    let (rows, everything) = match effort {
        Effort::Reduced => (published::kept().into_iter().step_by(2).collect(), None),
        Effort::Full => {
            let table = published::table();
            let mut rows: Vec<Published> = table.iter().flatten().copied().step_by(EVERY).collect();
            rows.extend(published::kept());
            (rows, table)
        }
    };
    let with_edge = effort == Effort::Full;
    progress.expect(rows.len() as u64);
    let all: Vec<(Published, Result<Solved, String>)> = rows
        .par_iter()
        .enumerate()
        .map(|(index, row)| {
            let answer = solved(row, with_edge && index.is_multiple_of(EDGE_EVERY));
            progress.advance(1);
            (*row, answer)
        })
        .collect();
    let good: Vec<(Published, Solved)> = all.iter().filter_map(|(row, answer)| Some((*row, answer.clone().ok()?))).collect();
    section.paragraphs.push(format!(
        "{} rows of the public table ML4Adh (Maghami, Wang, Tricarico, Ciavarella, Li & Papangelo 2024; Maghami, Stender & Papangelo 2025; boundary elements, Lennard-Jones law) are solved by the law of \
         attraction of finite range. The ratio is ours over theirs. Our own error is the change between two runs, the second with tenfold tighter tolerances.",
        rows.len()
    ));
    checks(&mut section, &all, &good, everything.as_deref());
    section.tables.push(rows_table(&all));
    section.tables.push(quantiles_table(&good));
    if let Some(table) = &everything {
        section.tables.push(repeats_table(table));
    }
    if with_edge {
        section.tables.push(edge_table(&good));
    }
    section.tables.push(outliers_table(&good));
    section.plots.push(ratio_plot(&good));
    section.plots.push(curves_plot(&good));
    section
}

fn off(row: &Published, solved: &Solved) -> f64 {
    (solved.ratio / row.ratio - 1.0).abs()
}

fn quantile(values: &mut [f64], part: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get((part * values.len().saturating_sub(1) as f64).round() as usize).copied().unwrap_or(f64::NAN)
}

fn checks(section: &mut Section, all: &[(Published, Result<Solved, String>)], good: &[(Published, Solved)], table: Option<&[Published]>) {
    let failed: Vec<String> = all.iter().filter_map(|(row, answer)| Some(format!("{row:?}: {}", answer.as_ref().err()?))).collect();
    section.checks.push(Check::new(
        "every row is solved",
        "none is refused: all are states of a solid with a relaxed start",
        failed.first().cloned().unwrap_or_else(|| format!("{} solved", good.len())),
        failed.is_empty(),
    ));
    let worst = good.iter().map(|(_, solved)| solved.error / solved.ratio).fold(0.0, f64::max);
    section.checks.push(Check::new(
        "our two runs agree",
        format!("within {OURS:e}: tolerances are 3e-5 and 3e-6"),
        format!("at most {worst:.1e} off"),
        worst < OURS,
    ));
    let balance = good.iter().map(|(_, solved)| solved.defect).fold(0.0, f64::max);
    section.checks.push(Check::new(
        "energy is balanced",
        format!("within {BALANCE:e} of the largest energy"),
        format!("at most {balance:.1e} off"),
        balance < BALANCE,
    ));
    let prototype = good.iter().filter_map(|(row, solved)| Some((solved.ratio / row.prototype? - 1.0).abs())).fold(0.0, f64::max);
    section.checks.push(Check::new(
        "an independent prototype of the same equations, in another language, agrees",
        format!("within {OURS:e}, its own tolerance"),
        format!("at most {prototype:.1e} off"),
        prototype < OURS,
    ));
    for class in &CLASSES {
        let own: Vec<f64> = good.iter().filter(|(row, _)| (class.holds)(row)).map(|(row, solved)| off(row, solved)).collect();
        let worst = own.iter().copied().fold(0.0, f64::max);
        // Where the whole table is there, it says how far its repeated states of the class are from each other.
        let spread = table.map_or(0.0, |table| spreads(table, class.holds).into_iter().fold(0.0, f64::max));
        let allowed = class.allowed.max(spread);
        section.checks.push(Check::new(
            format!("published runs, {}", class.name),
            format!("all within {allowed:.1e}: their repeated states agree no better there"),
            format!("{} rows, at most {worst:.1e} off", own.len()),
            !own.is_empty() && worst < allowed,
        ));
    }
    let near: Vec<[f64; 2]> = good
        .iter()
        .filter(|(row, _)| row.tabor > LARGE_TABOR)
        .filter_map(|(_, solved)| Some([solved.edge[0]? / solved.ratio, solved.edge[1]? / solved.ratio]))
        .collect();
    if !near.is_empty() {
        let [constant, growing] = [0, 1].map(|zone| {
            let mut off: Vec<f64> = near.iter().map(|ratios| (ratios[zone] - 1.0).abs()).collect();
            [quantile(&mut off, 0.5), quantile(&mut off, 1.0)]
        });
        section.checks.push(Check::new(
            format!("the theory of an edge with a growing zone, Tabor number from {LARGE_TABOR}"),
            "nearer to ours than with a constant zone, and nowhere off by more than a fifth",
            format!(
                "{} rows: median {:.3}, largest {:.3} off; constant zone {:.3} and {:.3}",
                near.len(),
                growing[0],
                growing[1],
                constant[0],
                constant[1]
            ),
            growing[0] < constant[0] && growing[1] < 0.2,
        ));
    }
    let mut all: Vec<f64> = good.iter().map(|(row, solved)| off(row, solved)).collect();
    let [half, most] = [0.5, 0.9].map(|part| quantile(&mut all, part));
    section.checks.push(Check::new(
        "published runs, all",
        "half of them within 2e-3, nine in ten within 2e-2: their repeated states differ by 2e-4 in the median, by 7e-3 in one of ten and by up to 19 %",
        format!("median {half:.1e}, 90 % {most:.1e}"),
        half < 2e-3 && most < 2e-2,
    ));
}

fn of_row(row: &Published) -> Vec<Cell> {
    vec![number(row.tabor), number(row.modulus_ratio), number(row.exponent), number(row.rate), number(row.preload), number(row.ratio)]
}

fn columns(further: &[(&str, &str)]) -> Vec<Column> {
    let own = [("Tabor number", "1"), ("E0/E∞", "1"), ("exponent", "1"), ("rate", "r/τ"), ("preload", "r"), ("published", "1.5πRΔγ")];
    own.iter().chain(further).map(|(name, unit)| Column::new(*name, *unit)).collect()
}

fn rows_table(all: &[(Published, Result<Solved, String>)]) -> Table {
    let further = [
        ("ours", "1.5πRΔγ"),
        ("our error", "1.5πRΔγ"),
        ("ratio", "1"),
        ("edge, constant zone, over ours", "1"),
        ("edge, growing zone, over ours", "1"),
        ("nodes", "1"),
        ("steps", "1"),
        ("energy defect", "1"),
    ];
    let mut table = Table::new("rows", "Every row, with ours beside it.", columns(&further)).folded();
    for (row, answer) in all {
        let mut cells = of_row(row);
        match answer {
            Ok(solved) => cells.extend([
                number(solved.ratio),
                number(solved.error),
                number(solved.ratio / row.ratio),
                Cell::Number(solved.edge[0].map(|edge| edge / solved.ratio)),
                Cell::Number(solved.edge[1].map(|edge| edge / solved.ratio)),
                count(solved.nodes),
                count(solved.steps),
                number(solved.defect),
            ]),
            Err(reason) => {
                cells.push(word(reason.clone()));
                cells.resize(6 + further.len(), word(""));
            }
        }
        table.rows.push(cells);
    }
    table
}

fn quantiles_table(good: &[(Published, Solved)]) -> Table {
    let columns = ["Tabor number from", "to", "rows", "median", "90 %", "largest"].map(|name| Column::new(name, "1")).to_vec();
    let mut table = Table::new("ratio_by_tabor", "How far ours and theirs are from each other, relative.", columns);
    for [from, to] in [[0.0, 0.1], [0.1, 0.3], [0.3, 0.9], [0.9, 2.0], [2.0, 3.0], [3.0, 10.0]] {
        let mut own: Vec<f64> =
            good.iter().filter(|(row, _)| row.tabor > from && row.tabor <= to).map(|(row, solved)| off(row, solved)).collect();
        if own.is_empty() {
            continue;
        }
        let [half, most, all] = [0.5, 0.9, 1.0].map(|part| quantile(&mut own, part));
        table.rows.push(vec![number(from), number(to), count(own.len()), number(half), number(most), number(all)]);
    }
    table
}

/// Largest over smallest published value of each state that the table holds more than once, less one.
fn spreads(table: &[Published], holds: impl Fn(&Published) -> bool) -> Vec<f64> {
    let mut sorted: Vec<&Published> = table.iter().filter(|row| holds(row)).collect();
    sorted.sort_by_key(|row| row.state());
    let mut spreads: Vec<f64> = Vec::new();
    for group in sorted.chunk_by(|a, b| a.state() == b.state()).filter(|group| group.len() > 1) {
        let (low, high) = group.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), row| (low.min(row.ratio), high.max(row.ratio)));
        spreads.push(high / low - 1.0);
    }
    spreads
}

/// How far the published values of one and the same state are from each other.
fn repeats_table(table: &[Published]) -> Table {
    let mut spreads = spreads(table, |_| true);
    let columns = ["states", "median", "90 %", "largest"].map(|name| Column::new(name, "1")).to_vec();
    let mut quantiles =
        Table::new("repeated_states", "States that the public table holds more than once: largest over smallest value, less one.", columns);
    let number_of_states = spreads.len();
    let [half, most, all] = [0.5, 0.9, 1.0].map(|part| quantile(&mut spreads, part));
    quantiles.rows.push(vec![count(number_of_states), number(half), number(most), number(all)]);
    quantiles
}

/// Intervals of the relaxed Tabor number, of the preload in ranges and of the rate, from which the map of the theory of an edge is made.
const TABOR: [[f64; 2]; 5] = [[0.0, 0.1], [0.1, 0.3], [0.3, 1.0], [1.0, 2.5], [2.5, 10.0]];
const PRELOAD: [[f64; 2]; 3] = [[0.0, 5.0], [5.0, 20.0], [20.0, 1e3]];
const RATE: [[f64; 2]; 4] = [[0.0, 1.0], [1.0, 100.0], [100.0, 1e4], [1e4, 1e13]];
/// How near the theory of an edge is to ours.
const NEAR: [f64; 3] = [0.01, 0.05, 0.2];

fn within([from, to]: [f64; 2], value: f64) -> bool {
    value > from && value <= to
}

/// Shares of rows at which the theory of an edge is near, the median of its ratio, and rows in which it has no contact or is refused.
fn shares(own: &[&Solved], zone: usize) -> Vec<Cell> {
    let mut ratios: Vec<f64> = own.iter().filter_map(|solved| Some(solved.edge.get(zone).copied().flatten()? / solved.ratio)).collect();
    let share = |width: f64| ratios.iter().filter(|ratio| (*ratio - 1.0).abs() <= width).count() as f64 / own.len() as f64;
    let mut cells: Vec<Cell> = NEAR.map(share).map(number).to_vec();
    cells.push(Cell::Number((!ratios.is_empty()).then(|| quantile(&mut ratios, 0.5))));
    cells.push(count(own.len() - ratios.len()));
    cells
}

/// Where the theory of an edge is near, with a constant and with a growing zone.
fn edge_table(good: &[(Published, Solved)]) -> Table {
    let names = [
        "Tabor number from",
        "to",
        "preload from",
        "to",
        "rate from",
        "to",
        "rows",
        "constant zone: within 1 %",
        "within 5 %",
        "within 20 %",
        "median ratio",
        "no contact, or refused",
        "growing zone: within 1 %",
        "within 5 %",
        "within 20 %",
        "median ratio",
        "no contact, or refused",
    ];
    let caption =
        "The theory of an edge with the process zone (π²/4)a₀ of the peak of the law, constant or times G/Δγ, over ours: shares of rows.";
    let mut table = Table::new("edge_theory", caption, names.map(|name| Column::new(name, "1")).to_vec());
    let asked: Vec<&(Published, Solved)> =
        good.iter().enumerate().filter(|(index, _)| index.is_multiple_of(EDGE_EVERY)).map(|(_, row)| row).collect();
    let whole = |intervals: &[[f64; 2]]| [intervals.first().map_or(0.0, |first| first[0]), intervals.last().map_or(0.0, |last| last[1])];
    let everything = (whole(&TABOR), whole(&PRELOAD), whole(&RATE));
    let mut cases = vec![everything];
    for tabor in TABOR {
        cases.push((tabor, everything.1, everything.2));
        for preload in PRELOAD {
            cases.extend(RATE.map(|rate| (tabor, preload, rate)));
        }
    }
    for (tabor, preload, rate) in cases {
        let inside = |row: &Published| within(tabor, row.tabor) && within(preload, row.preload) && within(rate, row.rate);
        let own: Vec<&Solved> = asked.iter().filter(|(row, _)| inside(row)).map(|(_, solved)| solved).collect();
        if own.is_empty() {
            continue;
        }
        let mut cells: Vec<Cell> = [tabor, preload, rate].as_flattened().iter().copied().map(number).collect();
        cells.push(count(own.len()));
        (0..ZONES.len()).for_each(|zone| cells.extend(shares(&own, zone)));
        table.rows.push(cells);
    }
    table
}

/// Rows that are further off than any class allows, with our evidence.
fn outliers_table(good: &[(Published, Solved)]) -> Table {
    let further = [("ours", "1.5πRΔγ"), ("our error", "1.5πRΔγ"), ("ratio", "1"), ("nodes", "1"), ("steps", "1"), ("energy defect", "1")];
    let caption = "Rows more than 1 % off: our two runs, the mesh, the steps and the energy balance say how well ours is known.";
    let mut table = Table::new("far_rows", caption, columns(&further)).folded();
    let mut far: Vec<&(Published, Solved)> = good.iter().filter(|(row, solved)| off(row, solved) > LISTED).collect();
    far.sort_by(|a, b| off(&b.0, &b.1).total_cmp(&off(&a.0, &a.1)));
    for (row, solved) in far {
        let mut cells = of_row(row);
        cells.extend([number(solved.ratio), number(solved.error), number(solved.ratio / row.ratio)]);
        cells.extend([count(solved.nodes), count(solved.steps), number(solved.defect)]);
        table.rows.push(cells);
    }
    table
}

fn ratio_plot(good: &[(Published, Solved)]) -> Plot {
    let mut figure = Figure::new(Axis::logarithmic("rate (range over time)"), Axis::linear("ours over published").with_range(0.9, 1.1));
    for (index, [from, to]) in [[0.0, 0.3], [0.3, 1.0], [1.0, 10.0]].into_iter().enumerate() {
        let own = good.iter().filter(|(row, _)| row.tabor > from && row.tabor <= to);
        let points = own.map(|(row, solved)| (row.rate, solved.ratio / row.ratio)).collect();
        let label = format!("Tabor number {from} to {to}");
        figure = figure.with_curve(Curve::new(label, points).with_line(Line::None).with_marker(Marker::OpenCircle).with_colour(index));
    }
    Plot::new("ratio", "Pull-off, ours over published, against the rate of unloading.", figure)
}

fn curves_plot(good: &[(Published, Solved)]) -> Plot {
    let mut figure = Figure::new(Axis::logarithmic("published pull-off over JKR's"), Axis::logarithmic("ours over JKR's"));
    let points: Vec<(f64, f64)> = good.iter().map(|(row, solved)| (row.ratio, solved.ratio)).collect();
    let most = points.iter().fold(1.0_f64, |most, point| most.max(point.0));
    figure = figure.with_curve(Curve::new("equal", vec![(1.0, 1.0), (most, most)]).with_line(Line::Dashed).with_colour(2));
    figure = figure.with_curve(Curve::new("rows", points).with_line(Line::None).with_marker(Marker::OpenCircle).with_colour(0));
    for (zone, (name, _)) in ZONES.iter().enumerate() {
        let edge: Vec<(f64, f64)> = good.iter().filter_map(|(row, solved)| Some((row.ratio, solved.edge.get(zone).copied()??))).collect();
        if !edge.is_empty() {
            let curve = Curve::new(format!("edge, {name}"), edge).with_line(Line::None).with_marker(Marker::Cross);
            figure = figure.with_curve(curve.with_colour([1, 3][zone]));
        }
    }
    Plot::new("pull_off", "Pull-off, ours against published.", figure)
}
