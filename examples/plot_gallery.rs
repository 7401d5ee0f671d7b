//! Draws one figure of every kind the plotting room has to cope with, from invented curves: `cargo run --example plot_gallery -- DIRECTORY`.

use std::{error::Error, fs, path::Path};

use viscotack_program::outcome::plot::{self, Axis, Colour, Curve, Figure, Inset, LegendPlace, Line, Marker, Residuals, Width};

fn main() -> Result<(), Box<dyn Error>> {
    let directory = std::env::args().nth(1).unwrap_or_else(|| "plot_gallery".to_owned());
    fs::create_dir_all(&directory)?;
    for (name, figure) in gallery() {
        let path = Path::new(&directory).join(name);
        fs::write(path.with_extension("svg"), plot::svg(&figure)?)?;
        fs::write(path.with_extension("png"), plot::png(&figure)?)?;
        println!("{}", path.display());
    }
    Ok(())
}

fn gallery() -> Vec<(&'static str, Figure)> {
    vec![
        ("sigmoids", sigmoids()),
        ("linear", linear()),
        ("twelve_curves", twelve_curves()),
        ("one_point", one_point()),
        ("gaps", gaps()),
        ("negative_values", negative_values()),
        ("tiny_range", tiny_range()),
        ("long_legend", long_legend()),
        ("wide", wide()),
        ("one_decade", one_decade()),
        ("huge_range", huge_range()),
        ("nothing", nothing()),
        ("inset", inset()),
        ("residuals", residuals()),
        ("characters", characters()),
    ]
}

fn logarithmic_grid(from: f64, to: f64, count: u32) -> Vec<f64> {
    (0..=count).map(|index| 10_f64.powf(from + (to - from) * f64::from(index) / f64::from(count))).collect()
}

fn sample(grid: &[f64], of: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    grid.iter().map(|x| (*x, of(*x))).collect()
}

/// Toughness against speed: from 1 to `ratio` over the decades around `speed`.
fn sigmoid(speed: f64, ratio: f64, width: f64) -> impl Fn(f64) -> f64 {
    move |v| {
        let s = (v / speed).powf(width);
        (1.0 + ratio * s) / (1.0 + s)
    }
}

fn sigmoids() -> Figure {
    let grid = logarithmic_grid(-12.0, 12.0, 480);
    let mut figure =
        Figure::new(Axis::logarithmic(r"reduced crack speed $v\tau/a_0$"), Axis::logarithmic(r"energy release rate $G/\Delta\gamma$"));
    let signs = [Marker::Circle, Marker::OpenSquare, Marker::Triangle, Marker::OpenDiamond, Marker::Plus];
    for (index, exponent) in (1..=5).enumerate() {
        let ratio = 10_f64.powi(exponent);
        figure = figure.with_curve(
            Curve::new(format!(r"$E_\infty/E_0 = 10^{{{exponent}}}$"), sample(&grid, sigmoid(1.0, ratio, 0.5)))
                .with_line(Line::Solid)
                .with_sparse_marker(signs[index]),
        );
    }
    figure.with_curve(Curve::new("rival & its scheme", sample(&grid, sigmoid(3e2, 1e4, 0.33))).with_line(Line::Dashed).with_colour(2))
}

fn linear() -> Figure {
    let grid: Vec<f64> = (0..=200).map(|i| f64::from(i) * 0.05).collect();
    Figure::new(Axis::linear("time $t$ (s)"), Axis::linear("penetration $d$ (µm)"))
        .with_title("Indentation and delayed growth")
        .with_curve(Curve::new(r"$\tau = 1$ s", sample(&grid, |t| 0.4 + 1.2 * (1.0 - (-t).exp()))))
        .with_curve(Curve::new(r"$\tau = 3$ s", sample(&grid, |t| 0.4 + 1.2 * (1.0 - (-t / 3.0).exp()))))
        .with_curve(
            Curve::new("experiment", (0..11).map(|i| (f64::from(i), 0.45 + 1.1 * (1.0 - (-f64::from(i) / 2.0).exp()))).collect())
                .with_line(Line::None)
                .with_marker(Marker::OpenCircle),
        )
}

fn twelve_curves() -> Figure {
    let grid = logarithmic_grid(-3.0, 6.0, 300);
    (0..12).fold(
        Figure::new(Axis::logarithmic("sliding speed $V$ (mm/s)"), Axis::linear(r"friction coefficient $\mu$")),
        |figure, index| {
            let peak = 10_f64.powf(-1.5 + 0.5 * f64::from(index));
            let bell = move |v: f64| (0.2 + 0.07 * f64::from(index)) * 2.0 * (v / peak) / (1.0 + (v / peak).powi(2));
            figure.with_curve(Curve::new(format!("$k = {}$", index + 1), sample(&grid, bell)))
        },
    )
}

fn one_point() -> Figure {
    Figure::new(Axis::linear("load $P$ (mN)"), Axis::logarithmic("contact radius $a$ (m)"))
        .with_curve(Curve::new("pull-off", vec![(-3.2, 4.5e-6)]))
}

fn gaps() -> Figure {
    let grid = logarithmic_grid(-6.0, 2.0, 160);
    let broken = |v: f64| if (-4.5..-3.6).contains(&v.log10()) || (-1.0..-0.2).contains(&v.log10()) { f64::NAN } else { 1.0 + v.powf(0.4) };
    let mut failures = sample(&logarithmic_grid(-4.4, -3.7, 4), |_| 0.0);
    failures.iter_mut().for_each(|point| point.1 = 1.1);
    Figure::new(Axis::logarithmic("$v$ (m/s)"), Axis::linear("$G$ (J/m²)"))
        .with_curve(Curve::new("solved", sample(&grid, broken)).with_line(Line::Solid))
        .with_curve(Curve::new("no solution", failures).with_line(Line::None).with_marker(Marker::Cross).with_colour(4))
        .with_curve(Curve::new("lonely point", vec![(1e-5, 2.0), (1e-4, f64::NAN), (1e-1, 3.0)]).with_line(Line::Dotted).with_colour(2))
}

fn negative_values() -> Figure {
    let branch = |sign: f64| -> Vec<(f64, f64)> {
        (0..=150)
            .map(|i| {
                let a = f64::from(i) / 100.0;
                (a * a / 2.0 - sign * 0.8 * a.sqrt(), (a.powi(3) - sign * (2.0 * a.powi(3)).sqrt()) * 1e-4)
            })
            .collect()
    };
    Figure::new(Axis::linear(r"penetration $d/d^*$"), Axis::linear("force $F$ (N)"))
        .with_curve(Curve::new("JKR, stable and unstable", branch(1.0)).with_line(Line::Solid))
        .with_curve(Curve::new("mirror branch", branch(-1.0)).with_line(Line::Dashed))
}

fn tiny_range() -> Figure {
    let points = (0..=40).map(|i| (1e6 + f64::from(i) * 1e-3, 2.0 + 1e-9 * (f64::from(i) / 6.0).sin())).collect();
    Figure::new(Axis::linear("number of steps $N$"), Axis::linear("pressure $p/p_0$"))
        .with_curve(Curve::new("drift", points).with_line(Line::Solid))
}

fn long_legend() -> Figure {
    let grid = logarithmic_grid(0.0, 4.0, 100);
    let labels = [
        "memory Clausen integral, two fields, adaptive quadrature with 64 nodes at each edge",
        r"reduced form, $\lambda = 0.5$, $\hat{p} = p/E^*_\infty$",
        r"rival: first order in time, $\Delta t = 10^{-3}\tau$ (name & name, year), steps halved until nothing changes",
        "relaxed elastic limit",
        "glassy elastic limit",
    ];
    labels.iter().enumerate().fold(
        Figure::new(Axis::logarithmic("cost (kernel evaluations)"), Axis::logarithmic("relative error")),
        |figure, (index, label)| {
            let order = 0.5 + 0.5 * index as f64;
            figure.with_curve(
                Curve::new(*label, sample(&grid, |n| n.powf(-order).max(1e-10)))
                    .with_sparse_marker([Marker::Circle, Marker::Square, Marker::Cross, Marker::OpenTriangle, Marker::None][index]),
            )
        },
    )
}

fn wide() -> Figure {
    sigmoids().with_width(Width::TwoColumns).with_title(r"Peeling of a strip, $\gamma = 0.05\,\mathrm{J/m^2}$, all speeds")
}

fn one_decade() -> Figure {
    let grid = logarithmic_grid(0.25, 1.05, 60);
    Figure::new(
        Axis::logarithmic(r"$\sigma_\mathrm{c}/\dot{\epsilon}$"),
        Axis::logarithmic("$G''(\\omega)$ (kPa)").with_range(2000.0, 2100.0),
    )
    .with_curve(Curve::new("loss modulus", sample(&grid, |x| 2010.0 * x.powf(0.02))))
}

fn huge_range() -> Figure {
    Figure::new(Axis::logarithmic("$x$"), Axis::linear("$y$")).with_curve(
        Curve::new("all of it", vec![(1e-300, -1e300), (1e-100, 3e299), (1.0, 1e100), (1e300, 1e300)]).with_marker(Marker::Square),
    )
}

fn nothing() -> Figure {
    Figure::new(Axis::logarithmic("$v$ (m/s)"), Axis::logarithmic("$G$ (J/m²)"))
        .with_curve(Curve::new("all negative", vec![(-1.0, 1.0), (-2.0, 2.0)]))
}

fn inset() -> Figure {
    let gap = |x: f64| (x * x - 1.0).max(0.0).sqrt() * x - (x + (x * x - 1.0).max(0.0).sqrt()).ln();
    let grid: Vec<f64> = (0..=300).map(|i| 1.0 + f64::from(i) * 0.01).collect();
    let near = Curve::new("", sample(&grid[..30], gap)).with_line(Line::Solid);
    let mut figure = Figure::new(Axis::linear(r"$x/a$"), Axis::linear(r"$\pi g/\hat{g}_\infty$"))
        .with_curve(Curve::new(r"gap behind the edge, $\Delta\gamma \gg 0$", sample(&grid, gap)).with_sparse_marker(Marker::OpenSquare));
    figure.inset = Some(Box::new(Inset {
        horizontal: Axis::linear("$x/a$"),
        vertical: Axis::linear(r"$\dot{g}^2_0$"),
        curves: vec![near],
        place: LegendPlace::TopLeft,
    }));
    figure
}

/// A measured curve and a computed one, with what is between them.
fn residuals() -> Figure {
    let grid: Vec<f64> = (0..=80).map(|i| f64::from(i) / 20.0).collect();
    let off = |t: f64| 3e-6 * (37.0 * t).sin() * (11.0 * t * t).cos();
    let measured: Vec<(f64, f64)> = grid.iter().map(|t| (*t, 1e-4 * (-t).exp() - off(*t))).collect();
    Figure::new(Axis::linear("time $t$ (s)"), Axis::linear("force $F$ (N)"))
        .with_curve(Curve::new("measured", measured).with_line(Line::None).with_marker(Marker::of_measured(81)).with_colour(1))
        .with_curve(Curve::new("computed", sample(&grid, |t| 1e-4 * (-t).exp())).with_colour(0).with_line(Line::Solid))
        .with_residuals(Residuals {
            vertical: Axis::linear("residual (N)"),
            points: sample(&grid, off),
            marker: Marker::of_measured(81),
            colour: Colour::Index(1),
            root_mean_square: Some(1.46e-6),
            determination: Some(0.99663),
        })
}

/// Every character that a label may well contain, accents over letters of any height, and two that the typeface of the PNG does not have.
fn characters() -> Figure {
    let lines = [
        "AaBbCcDdEeFfGgHhIiJjKkLlMmNnOoPpQqRrSsTtUuVvWwXxYyZz 0123456789",
        r#"!#"%&'()*+,-./:;<=>?@[\]^_`{|}~ §©«®°±²³µ¶·¹»¼½¾¿×÷ –—‘’“”†•…‰"#,
        "ÀÁÂÃÄÅÆÇÈÉÊËÌÍÎÏÐÑÒÓÔÕÖØÙÚÛÜÝÞß àáâãäåæçèéêëìíîïðñòóôõöøùúûüýþÿ čřšžąęłőűğış",
        "ΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡΣΤΥΦΧΨΩ αβγδεζηθικλμνξοπρστυφχψω ϑϕϵ ЖЯжя",
        "$ABCDEFGHIJKLMNOPQRSTUVWXYZ abcdefghijklmnopqrstuvwxyz αβγδεζηθικλμνξοπρστυφχψω ϑϕϵℓ∂$",
        "→∂∇∑−∘√∝∞∥∫∼≃≈≠≤≥≪≫⊥⋅⟨⟩ℏℓ′″←↔⇒∈∠≅≡≲≳",
        r"$\hat{a}\hat{d}\hat{E}\hat{\sigma}\hat{\gamma}\hat{\lambda}\hat{i}$, $\bar{a}\bar{p}\bar{P}\bar{u}\bar{\omega}\bar{W}$, $\dot{a}\dot{\epsilon}\dot{h}\dot{V}$, $\tilde{r}\tilde{\Delta}\tilde{E}\tilde{t}$, $\mathrm{\hat{x}\hat{L}}$",
        r"$K_\mathrm{I}^{2}/E'_{0}$, $x^{y^{z}}$, $a_{0_{1}}$, $\sqrt{2\pi a}$, $10^{-12}$; 漢 and 😀 are boxes",
    ];
    let axis = || Axis::linear(r"turned and level: $\hat{\sigma}_\infty^{2}(\tilde{x})\,/\,\dot{\epsilon}$ (µm·s⁻¹)").with_range(0.0, 1.0);
    let figure = Figure::new(axis(), axis()).with_width(Width::TwoColumns).with_legend(LegendPlace::Below);
    lines.iter().enumerate().fold(figure, |figure, (index, line)| {
        let height = 0.1 + 0.1 * index as f64;
        figure.with_curve(Curve::new(*line, vec![(0.0, height), (1.0, height + 0.01 * index as f64)]))
    })
}
