//! The plots of a material: moduli, loss tangent, creep, relaxation, terms; the data on top of the fit.

use super::MaterialReport;
use crate::outcome::plot::{Axis, Curve, Figure, Line, Marker};
use crate::scene::typed::{MaterialOrigin, MeasuredRow, MeasuredSort, Units};
use viscotack::material::fit::Quantity;

pub(super) fn figures(report: &MaterialReport) -> Vec<(String, Figure)> {
    let si = report.units == Units::Si;
    let label = |name: &str, of_si: &str, reduced: &str| format!("{name} {}", if si { of_si } else { reduced });
    let frequency = || Axis::logarithmic(label("angular frequency", r"$\omega$ (rad/s)", r"$\omega\tau$"));
    let time = || Axis::logarithmic(label("time", "$t$ (s)", r"$t/\tau$"));
    let modulus = |name: &str, symbol: &str| Axis::logarithmic(label(name, &format!("{symbol} (Pa)"), &format!("{symbol}$/E_0$")));
    let curve = |quantity: Quantity, places: &[f64]| -> Vec<(f64, f64)> {
        places.iter().filter_map(|&at| Some((at, report.value(quantity, at)?.value))).collect()
    };
    let measured = |sort: MeasuredSort, value: &dyn Fn(&MeasuredRow) -> Option<f64>| -> Option<Vec<(f64, f64)>> {
        let MaterialOrigin::Data(fitted) = &report.material.origin else { return None };
        let factor = report.factor();
        let place = |at: f64| if sort == MeasuredSort::Moduli { at / factor } else { at * factor };
        // Rows of many temperatures do not follow each other along the axis.
        (fitted.data.sort == sort).then(|| fitted.data.rows.iter().filter_map(|row| Some((place(row.at), value(row)?))).collect())
    };
    let with_data = |figure: Figure, name: &str, points: Option<Vec<(f64, f64)>>, marker: Marker, colour: usize| match points {
        Some(points) => figure.with_curve(Curve::new(name, points).with_line(Line::None).with_marker(marker).with_colour(colour)),
        None => figure,
    };
    let line =
        |name: &str, points: Vec<(f64, f64)>, stroke: Line, colour: usize| Curve::new(name, points).with_line(stroke).with_colour(colour);
    let (frequencies, times) = (report.frequencies(), report.times());
    let (storage, loss) = (curve(Quantity::Storage, &frequencies), curve(Quantity::Loss, &frequencies));
    let tangent: Vec<(f64, f64)> = storage.iter().zip(&loss).map(|(storage, loss)| (storage.0, loss.1 / storage.1)).collect();

    let mut moduli = Figure::new(frequency(), modulus("moduli", "$E'$, $E''$"));
    moduli = with_data(moduli, "$E'$ measured", measured(MeasuredSort::Moduli, &|row| Some(row.value)), Marker::OpenCircle, 0);
    moduli = with_data(moduli, "$E''$ measured", measured(MeasuredSort::Moduli, &|row| row.loss), Marker::OpenSquare, 1);
    moduli = moduli.with_curve(line("$E'$", storage, Line::Solid, 0)).with_curve(line("$E''$", loss, Line::Dashed, 1));

    let mut losses = Figure::new(frequency(), Axis::linear(r"loss tangent $\tan\delta$"));
    losses = with_data(losses, "measured", measured(MeasuredSort::Moduli, &|row| Some(row.loss? / row.value)), Marker::OpenCircle, 0);
    losses = losses.with_curve(line("", tangent, Line::Solid, 0));

    let compliance = Axis::logarithmic(label("creep compliance", "$J$ (1/Pa)", "$JE_0$"));
    let mut creep = Figure::new(time(), compliance);
    creep = with_data(creep, "measured", measured(MeasuredSort::Creep, &|row| Some(row.value)), Marker::OpenCircle, 0);
    creep = creep.with_curve(line("", curve(Quantity::Creep, &times), Line::Solid, 0));

    let mut relaxation = Figure::new(time(), modulus("relaxation modulus", "$R$"));
    relaxation = with_data(relaxation, "measured", measured(MeasuredSort::Relaxation, &|row| Some(row.value)), Marker::OpenCircle, 0);
    relaxation = relaxation.with_curve(line("", curve(Quantity::Relaxation, &times), Line::Solid, 0));

    let terms: Vec<(f64, f64)> =
        report.material.series.relaxation_terms().iter().map(|term| (term.relaxation_time, term.modulus)).collect();
    let spectrum =
        Figure::new(Axis::logarithmic(label("relaxation time", r"$\rho_i$ (s)", r"$\rho_i/\tau$")), modulus("modulus of a term", "$E_i$"))
            .with_curve(Curve::new("", terms.clone()).with_line(Line::Dotted).with_marker(Marker::Circle).with_colour(0));

    let mut all = vec![
        ("moduli".to_owned(), moduli),
        ("loss_tangent".to_owned(), losses),
        ("creep".to_owned(), creep),
        ("relaxation".to_owned(), relaxation),
    ];
    if !terms.is_empty() {
        all.push(("terms".to_owned(), spectrum));
    }
    all.extend(misfit(report).map(|figure| ("fit_error".to_owned(), figure)));
    all
}

/// How far each number of the data is from the fit, over the number, with the fit's own stated error.
fn misfit(report: &MaterialReport) -> Option<Figure> {
    let MaterialOrigin::Data(fitted) = &report.material.origin else { return None };
    let factor = report.factor();
    let (axis, parts): (_, &[(Quantity, &str, &str)]) = match fitted.data.sort {
        MeasuredSort::Moduli => (
            Axis::logarithmic(r"angular frequency $\omega$ (rad/s)"),
            &[(Quantity::Storage, "$E'$", "error of the fit, $E'$"), (Quantity::Loss, "$E''$", "error of the fit, $E''$")],
        ),
        MeasuredSort::Relaxation => (Axis::logarithmic("time $t$ (s)"), &[(Quantity::Relaxation, "$R$", "error of the fit")]),
        MeasuredSort::Creep => (Axis::logarithmic("time $t$ (s)"), &[(Quantity::Creep, "$J$", "error of the fit")]),
    };
    let mut figure = Figure::new(axis, Axis::logarithmic("misfit, relative"));
    for (index, &(quantity, name, bar)) in parts.iter().enumerate() {
        let measured = |row: &MeasuredRow| if quantity == Quantity::Loss { row.loss } else { Some(row.value) };
        let place = |row: &MeasuredRow| if fitted.data.sort == MeasuredSort::Moduli { row.at / factor } else { row.at * factor };
        let mut known: Vec<(f64, f64)> = Vec::new();
        let mut misses: Vec<(f64, f64)> = Vec::new();
        for row in &fitted.data.rows {
            let (at, Some(value)) = (place(row), measured(row)) else { continue };
            let Some(fit) = report.value(quantity, at) else { continue };
            misses.push((at, (fit.value / value - 1.0).abs()));
            known.push((at, fit.error / fit.value.abs()));
        }
        // A logarithm shows no zero.
        misses.retain(|point| point.1 > 0.0 && point.1.is_finite());
        known.retain(|point| point.1 > 0.0 && point.1.is_finite());
        known.sort_by(|one, other| one.0.total_cmp(&other.0));
        let marker = if index == 0 { Marker::OpenCircle } else { Marker::OpenSquare };
        figure = figure
            .with_curve(Curve::new(name, misses).with_line(Line::None).with_marker(marker).with_colour(index))
            .with_curve(Curve::new(bar, known).with_line(if index == 0 { Line::Solid } else { Line::Dashed }).with_colour(index));
    }
    Some(figure)
}
