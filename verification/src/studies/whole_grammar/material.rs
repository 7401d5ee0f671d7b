//! Materials: every form in which a scene may give one.

use super::text::{COMPLIANCE, ENERGY_PER_MOLE, NUMBER, PRESSURE, RATE, TEMPERATURE, TIME, Text, VISCOSITY, quoted};

/// What the rest of a scene is measured by.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scales {
    /// Relaxed plane modulus E0* (Pa), about.
    pub(super) modulus: f64,
    /// Longest time (s), about.
    pub(super) time: f64,
    /// E∞/E0, about.
    pub(super) beta: f64,
    /// From the longest time to the shortest.
    pub(super) decades: f64,
}

/// The scales of the materials that files and decks hold.
const OF_FILES: Scales = Scales { modulus: 1e6, time: 1.0, beta: 10.0, decades: 2.0 };

/// How a material is given.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Form {
    Fractions,
    Compliances,
    Moduli,
    RelaxationFractions,
    Elastic,
    Flowing,
    ShearAndBulk,
    PowerLaw,
    FractionalZener,
    File,
    Data,
    Deck,
}

/// Series are half of all; laws, tables and decks cost a fit or an expansion each.
const FORMS: [Form; 20] = [
    Form::Fractions,
    Form::Fractions,
    Form::Fractions,
    Form::Compliances,
    Form::Compliances,
    Form::Moduli,
    Form::Moduli,
    Form::Moduli,
    Form::RelaxationFractions,
    Form::RelaxationFractions,
    Form::RelaxationFractions,
    Form::Elastic,
    Form::Flowing,
    Form::ShearAndBulk,
    Form::PowerLaw,
    Form::FractionalZener,
    Form::File,
    Form::Data,
    Form::Data,
    Form::Deck,
];
/// Those that have reduced groups.
const REDUCED: [Form; 5] = [Form::Fractions, Form::Fractions, Form::RelaxationFractions, Form::Moduli, Form::Elastic];

/// What a problem takes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Taken {
    pub(super) liquids: bool,
    /// Largest β.
    pub(super) stiffest: f64,
    pub(super) most_terms: usize,
    pub(super) decades: f64,
}

/// Times of a series, in units of the longest, and the weights.
fn series(text: &mut Text, taken: Taken) -> (Vec<(f64, f64)>, f64) {
    let terms = 1 + text.draw.below(taken.most_terms);
    let decades = if terms == 1 { 0.0 } else { text.draw.between(0.3, taken.decades) };
    let weights: Vec<f64> = (0..terms).map(|_| text.draw.log_between(0.2, 5.0)).collect();
    let total: f64 = weights.iter().sum();
    let pairs = weights.iter().enumerate().map(|(index, weight)| {
        let place = if index == 0 { 0.0 } else { (index as f64 + text.draw.between(-0.4, 0.4)) / terms as f64 };
        (weight / total, 10f64.powf(-decades * place))
    });
    (pairs.collect(), decades)
}

fn listed(items: Vec<String>) -> String {
    format!("[{}]", items.join(", "))
}

/// Writes `[material]`; the scales that the rest of the scene is drawn by.
pub(super) fn write(text: &mut Text, taken: Taken) -> Scales {
    let forms: Vec<Form> = if text.reduced { REDUCED.to_vec() } else { FORMS.to_vec() };
    let mut form = forms.get(text.draw.below(forms.len())).copied().unwrap_or(Form::Fractions);
    if form == Form::Flowing && !taken.liquids {
        form = Form::Compliances;
    }
    if text.chance(0.1) {
        text.put("material.name", quoted("drawn"));
        text.put("material.cautions", quoted("the table of this scene is invented"));
    }
    if text.chance(0.05) {
        text.put("material.leave_out", "0");
    }
    // A fit, an expansion and a conversion of two moduli turn on the last digits of what they are made from.
    text.plain = matches!(form, Form::Data | Form::ShearAndBulk | Form::PowerLaw | Form::FractionalZener);
    let scales = match form {
        Form::File | Form::Data | Form::Deck => {
            match form {
                Form::File => of_a_file(text),
                Form::Data => data(text),
                _ => deck(text),
            }
            OF_FILES
        }
        _ => own(text, form, taken),
    };
    text.plain = false;
    scales
}

fn own(text: &mut Text, form: Form, taken: Taken) -> Scales {
    let beta = 1.0 + text.draw.log_between(0.1, taken.stiffest);
    let (modulus, time) = if text.reduced { (1.0, 1.0) } else { (text.draw.log_between(1e3, 1e9), text.draw.log_between(1e-3, 1e3)) };
    let (pairs, decades) = series(text, taken);
    let scales = Scales { modulus, time, beta: if form == Form::Elastic { 1.0 } else { beta }, decades };
    if !text.reduced && form != Form::ShearAndBulk {
        let ratio = text.draw.between(-0.2, 0.5);
        text.put("material.poisson_ratio", format!("{ratio:.3}"));
    }
    let relaxed_and_glassy = |text: &mut Text, glassy: bool| {
        if !text.reduced {
            text.put_number("material.relaxed_modulus", 1.0, modulus, PRESSURE);
        }
        if glassy {
            text.put_number("material.glassy_modulus", beta, modulus, PRESSURE);
        }
    };
    match form {
        Form::Fractions | Form::RelaxationFractions => {
            relaxed_and_glassy(text, true);
            let (key, time_key) = match form {
                Form::Fractions => ("material.creep", "retardation_time"),
                _ => ("material.relaxation", "relaxation_time"),
            };
            // The last part makes the sum one to the last bit that a decimal number has.
            let mut left = 1.0;
            let count = pairs.len();
            let items = pairs.iter().enumerate().map(|(index, (weight, place))| {
                let part = if index + 1 == count { left } else { *weight };
                left -= part;
                let rate = form == Form::RelaxationFractions && text.chance(0.3);
                let own = if rate {
                    format!("decay_rate = {}", text.number(1.0 / place, 1.0 / time, RATE))
                } else {
                    format!("{time_key} = {}", text.number(*place, time, TIME))
                };
                format!("{{ fraction = {part:e}, {own} }}")
            });
            let items = items.collect();
            text.put(key, listed(items));
        }
        Form::Compliances | Form::Flowing => {
            relaxed_and_glassy_of_creep(text, form, (modulus, beta, time), &pairs);
        }
        Form::Moduli => {
            if text.reduced {
                text.put_number("material.glassy_modulus", beta, 1.0, PRESSURE);
            } else {
                text.put_number("material.relaxed_modulus", 1.0, modulus, PRESSURE);
            }
            let items = pairs.iter().map(|(weight, place)| {
                let (value, when) = (text.number((beta - 1.0) * weight, modulus, PRESSURE), text.number(*place, time, TIME));
                format!("{{ modulus = {value}, relaxation_time = {when} }}")
            });
            let items = items.collect();
            text.put("material.relaxation", listed(items));
        }
        Form::Elastic => {
            if text.reduced {
                text.put("material.glassy_modulus", "1");
            } else {
                relaxed_and_glassy(text, false);
            }
        }
        Form::ShearAndBulk => shear_and_bulk(text, modulus, time, beta),
        Form::PowerLaw | Form::FractionalZener => {
            relaxed_and_glassy(text, true);
            let key = if form == Form::PowerLaw { "material.power_law" } else { "material.fractional_zener" };
            let exponent = text.draw.between(0.3, 0.8);
            text.put(&format!("{key}.exponent"), format!("{exponent:.3}"));
            text.put_number(&format!("{key}.time"), 0.1, time, TIME);
            text.put("material.expansion.accuracy", "1e-2");
            text.put_number("material.expansion.slowest_time", 1e2, time, TIME);
            text.put_number("material.expansion.fastest_time", 1e-3, time, TIME);
        }
        Form::File | Form::Data | Form::Deck => {}
    }
    if !text.reduced && form != Form::Elastic && text.chance(0.25) {
        shift(text, false);
    }
    scales
}

fn relaxed_and_glassy_of_creep(text: &mut Text, form: Form, (modulus, beta, time): (f64, f64, f64), pairs: &[(f64, f64)]) {
    text.put_number("material.glassy_modulus", beta, modulus, PRESSURE);
    if form == Form::Flowing {
        text.put_number("material.viscosity", 1.0, modulus * time, VISCOSITY);
    }
    let items = pairs.iter().map(|(weight, place)| {
        let gained = (1.0 - 1.0 / beta) * weight;
        let (value, when) = (text.number(gained, 1.0 / modulus, COMPLIANCE), text.number(*place, time, TIME));
        format!("{{ compliance = {value}, retardation_time = {when} }}")
    });
    let items = items.collect();
    text.put("material.creep", listed(items));
}

fn shear_and_bulk(text: &mut Text, modulus: f64, time: f64, beta: f64) {
    let long_term = text.chance(0.5);
    text.put("material.moduli", quoted(if long_term { "long_term" } else { "instantaneous" }));
    let shear = if long_term { 0.4 } else { 0.4 * beta };
    text.put_number("material.shear_modulus", shear, modulus, PRESSURE);
    text.put_number("material.bulk_modulus", 4.0 * shear, modulus, PRESSURE);
    let lost = 1.0 - 1.0 / beta;
    for (key, part) in [("material.shear_relaxation", 1.0), ("material.bulk_relaxation", 0.3)] {
        let by_rate = text.chance(0.5);
        let value = if long_term {
            format!("modulus = {}", text.number(part * (beta - 1.0) * shear, modulus, PRESSURE))
        } else {
            format!("fraction = {:e}", part * lost)
        };
        let when = if by_rate {
            format!("decay_rate = {}", text.number(1.0, 1.0 / time, RATE))
        } else {
            format!("relaxation_time = {}", text.number(1.0, time, TIME))
        };
        text.put(key, format!("[{{ {value}, {when} }}]"));
    }
}

/// A temperature near the reference and factors between both.
fn shift(text: &mut Text, of_data: bool) {
    let temperature = 293.15 + text.draw.between(-4.0, 9.0);
    text.put_number("material.temperature", temperature, 1.0, TEMPERATURE);
    text.put_number("material.reference_temperature", 293.15, 1.0, TEMPERATURE);
    match text.draw.below(if of_data { 2 } else { 4 }) {
        0 => {
            text.put("material.shift.wlf.c1", "10.0");
            text.put_number("material.shift.wlf.c2", 100.0, 1.0, NUMBER);
        }
        1 => text.put_number("material.shift.arrhenius.activation_energy", 5e4, 1.0, ENERGY_PER_MOLE),
        2 => text.put(
            "material.shift.factors",
            "[{ temperature = 283.15, factor = 4.0 }, { temperature = 293.15, factor = 1.0 }, { temperature = 313.15, factor = 0.1 }]",
        ),
        _ => text.put_file("material.shift.table", "shift.csv", "temperature (°C), factor\n10, 4\n20, 1\n30, 0.1\n40, 0.02\n"),
    }
}

fn of_a_file(text: &mut Text) {
    text.put_file(
        "material.file",
        "solid.toml",
        "[material]\nrelaxed_modulus = 1e6\nglassy_modulus = 1e7\npoisson_ratio = 0.4\ncreep = [{ fraction = 0.7, retardation_time = 1.0 }, { fraction = 0.3, retardation_time = 0.05 }]\n",
    );
}

const FREQUENCIES: &str =
    "a, b, c, d\n0.01, 0.02, 1.0e6, 1.0e5\n0.1, 0.2, 1.3e6, 5e5\n1, 2, 3.2e6, 1.9e6\n10, 20, 8e6, 2e6\n100, 200, 9.8e6, 5e5\n";
const TANGENTS: &str =
    "a, b, c, d\n0.01, 0.02, 1.0e6, 0.1\n0.1, 0.2, 1.3e6, 0.4\n1, 2, 3.2e6, 0.6\n10, 20, 8e6, 0.25\n100, 200, 9.8e6, 0.05\n";
const ISOTHERMS: &str = "a, b, c, d, e\n0.01, 0.01, 1.092e+06, 3.562e+05, 293.15\n0.03, 0.03, 1.488e+06, 7.086e+05, 293.15\n0.1, 0.1, 2.089e+06, 9.363e+05, 293.15\n0.3, 0.3, 2.942e+06, 1.329e+06, 293.15\n1, 1, 3.952e+06, 1.338e+06, 293.15\n3, 3, 4.947e+06, 1.934e+06, 293.15\n10, 10, 7.119e+06, 1.723e+06, 293.15\n0.01, 0.01, 1.062e+06, 6.103e+04, 303.15\n0.03, 0.03, 1.081e+06, 1.805e+05, 303.15\n0.1, 0.1, 1.257e+06, 5.204e+05, 303.15\n0.3, 0.3, 1.808e+06, 8.295e+05, 303.15\n1, 1, 2.463e+06, 1.153e+06, 303.15\n3, 3, 3.558e+06, 1.431e+06, 303.15\n10, 10, 4.462e+06, 1.563e+06, 303.15\n";
const RELAXATION: &str = "a, c\n0.001, 9.9e6\n0.01, 9e6\n0.1, 4.3e6\n1, 1.05e6\n10, 1e6\n";
const CREEP: &str = "a, c\n0.001, 1.01e-7\n0.01, 1.1e-7\n0.1, 2e-7\n1, 6.7e-7\n10, 1e-6\n";

fn data(text: &mut Text) {
    text.put("material.poisson_ratio", "0.4");
    text.put("material.fit_error", "0.1");
    let columns = |text: &mut Text, columns: &[(&str, &str)]| {
        for (key, header) in columns {
            text.put(&format!("material.columns.{key}"), quoted(header));
        }
    };
    let of = text.draw.below(3);
    if of < 2 {
        text.put("material.columns.of", quoted(if of == 0 { "tension" } else { "shear" }));
    }
    if text.chance(0.1) {
        let word = text.word(&["none", "propagate"]);
        text.put("material.uncertainty", quoted(word));
    }
    match text.draw.below(6) {
        0 => {
            text.put_file("material.data", "moduli.csv", FREQUENCIES);
            let axis = if text.chance(0.5) { ("frequency", "a in Hz") } else { ("angular_frequency", "a in rad/s") };
            columns(text, &[axis, ("storage_modulus", "c in Pa"), ("loss_modulus", "d in Pa")]);
            if text.chance(0.5) {
                shift(text, true);
            }
        }
        1 => {
            text.put_file("material.data", "tangents.csv", TANGENTS);
            columns(text, &[("frequency", "a in Hz"), ("storage_modulus", "c in Pa"), ("loss_tangent", "d in 1")]);
        }
        2 => {
            text.put_file("material.data", "phases.csv", TANGENTS);
            columns(text, &[("frequency", "a in Hz"), ("complex_modulus", "c in Pa"), ("phase_angle", "d in rad")]);
        }
        3 => {
            text.put_file("material.data", "isotherms.csv", ISOTHERMS);
            columns(
                text,
                &[("frequency", "a in Hz"), ("storage_modulus", "c in Pa"), ("loss_modulus", "d in Pa"), ("temperature", "e in K")],
            );
            text.put("material.temperature", "298.15");
            text.put("material.reference_temperature", "293.15");
            text.put("material.temperature_tolerance", "\"0.5 K\"");
            let word = text.word(&["automatic", "automatic_with_vertical"]);
            text.put("material.shift", quoted(word));
        }
        4 => {
            text.put_file("material.data", "relaxation.csv", RELAXATION);
            columns(text, &[("time", "a in s"), ("relaxation_modulus", "c in Pa")]);
        }
        _ => {
            text.put_file("material.data", "creep.csv", CREEP);
            columns(text, &[("time", "a in s"), ("creep_compliance", "c in 1/Pa")]);
        }
    }
}

fn deck(text: &mut Text) {
    text.put("material.deck_units.pressure", quoted("MPa"));
    text.put("material.deck_units.time", quoted("s"));
    match text.draw.below(5) {
        0 => {
            let card = "*MATERIAL, NAME=ONE\n*ELASTIC, MODULI=INSTANTANEOUS\n 10., 0.4\n*VISCOELASTIC, TIME=PRONY\n 0.5, 0., 0.1\n*MATERIAL, NAME=TWO\n*ELASTIC, MODULI=INSTANTANEOUS\n 11., 0.4\n*VISCOELASTIC, TIME=PRONY\n 0.5, 0.1, 0.1\n*TRS\n 20., 8., 100.\n";
            text.put_file("material.abaqus", "card.inp", card);
            text.put("material.deck_material", quoted("TWO"));
            text.put("material.deck_units.temperature", quoted("°C"));
            text.put("material.temperature", "300.0");
        }
        1 => text.put_file("material.ansys", "card.dat", "MP,EX,1,10\nMP,NUXY,1,0.4\nTB,PRONY,1,,1,SHEAR\nTBDATA,1,0.5,0.1\n"),
        2 => text.put_file("material.ls_dyna", "card.k", "*MAT_006\n1,1e-9,50.,4.,1.,10.\n"),
        3 => {
            text.put_file("material.comsol", "card.txt", "G 2[MPa]\nK 40\nG1 1\ntau1 0.1\n");
            text.put("material.moduli", quoted("long_term"));
        }
        _ => text.put_file(
            "material.moose",
            "card.i",
            "[m]\ntype = GeneralizedMaxwellModel\nyoung_modulus = 10\npoisson_ratio = 0.4\ncreep_modulus = 5\ncreep_viscosity = 0.1\n[]\n",
        ),
    }
}
