//! Fits with a known truth: scenes, free numbers between bounds, rows.

use super::super::draw::Draw;

/// The noise of a case.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Scatter {
    /// Of the largest magnitude of the curve.
    OfTheLargest,
    /// Of each value.
    OfEach,
}

/// A family of fits.
#[derive(Debug, Clone, Copy)]
pub(super) struct Case {
    /// What it is called.
    pub(super) name: &'static str,
    /// The scene, with its [fit]; the data are `data.csv`.
    pub(super) scene: &'static str,
    /// Bounds within which the truth is drawn, by logarithm, of each free number; offsets are drawn evenly.
    pub(super) truth: &'static [(f64, f64)],
    /// The header of the data.
    pub(super) header: &'static str,
    /// Places of the rows.
    pub(super) rows: (f64, f64, usize),
    /// Whether they have equal ratios.
    pub(super) logarithmic: bool,
    /// The noise.
    pub(super) scatter: Scatter,
}

/// A sphere is pulled off a rubber through a frame.
const PULL_OFF: Case = Case {
    name: "work of adhesion and frame from a pull-off",
    scene: "[material]\ncreep = [{ compliance = 0.6e-6, retardation_time = 0.4 }]\nglassy_modulus = 2.5e6\npoisson_ratio = 0.5\n\
            [adhesion]\nwork_of_adhesion = 0.1\nprocess_zone = { length = 1e-6 }\n\
            [indentation]\nsphere = { radius = 1e-3 }\nstart = \"relaxed\"\nforce = 5e-4\nframe_stiffness = 100\n\
            [[history]]\nframe = -3e-5\nduration = 16\n\
            [fit]\ncompare = \"force\"\nfree = [{ key = \"adhesion.work_of_adhesion\", from = 1e-3, to = 1 }, { key = \"indentation.frame_stiffness\", from = 10, to = 1e4 }]\n\
            [[fit.test]]\ndata = \"data.csv\"\n",
    truth: &[(0.02, 0.2), (60.0, 600.0)],
    header: "time (s), force (N)",
    rows: (0.0, 16.0, 160),
    logarithmic: false,
    scatter: Scatter::OfTheLargest,
};

/// A sphere is pressed on and held: modulus, time, and the force of the empty stage.
const RELAXATION: Case = Case {
    name: "compliance, time and force offset from a hold without adhesion",
    scene: "[material]\nglassy_modulus = 2e6\ncreep = [{ compliance = 1.5e-6, retardation_time = 1 }]\npoisson_ratio = 0.5\n\
            [indentation]\nsphere = { radius = 1e-3 }\n\
            [[history]]\npenetration = 2e-5\nduration = 0.5\n[[history]]\nhold = 9.5\n\
            [fit]\ncompare = \"force\"\nfree = [{ key = \"material.creep.0.compliance\", from = 1e-8, to = 1e-4 }, { key = \"material.creep.0.retardation_time\", from = 0.01, to = 100 }, { key = \"fit.force_offset\" }]\n\
            [[fit.test]]\ndata = \"data.csv\"\n",
    truth: &[(5e-7, 5e-6), (0.2, 4.0), (-2e-4, 2e-4)],
    header: "time (s), force (N)",
    rows: (0.05, 10.0, 120),
    logarithmic: false,
    scatter: Scatter::OfTheLargest,
};

/// A rubber sheet is torn.
const TEARING: Case = Case {
    name: "work of adhesion and retardation time from G against the speed of a crack",
    scene: "[material]\nglassy_modulus = 1e8\ncreep = [{ compliance = 9e-7, retardation_time = 1e-3 }]\n\
            [adhesion]\nwork_of_adhesion = 10\nprocess_zone = { length = 1e-7 }\n\
            [crack]\nmotion = \"opening\"\nbody = \"two_halves\"\nplane = \"stress\"\ntheories = [\"virtual_work\"]\nspeed = 1e-3\n\
            [fit]\ncompare = \"energy_release_rate\"\nagainst = \"crack.speed\"\nfree = [{ key = \"adhesion.work_of_adhesion\", from = 0.1, to = 1e3 }, { key = \"material.creep.0.retardation_time\", from = 1e-7, to = 10 }]\n\
            [[fit.test]]\ndata = \"data.csv\"\n",
    truth: &[(3.0, 100.0), (1e-4, 1e-2)],
    header: "speed (m/s), energy_release_rate (J/m²)",
    rows: (1e-7, 1e-1, 24),
    logarithmic: true,
    scatter: Scatter::OfEach,
};

/// A wavy body slides without adhesion.
const FRICTION: Case = Case {
    name: "two compliances' times from friction against speed",
    scene: "units = \"reduced\"\n[material]\nglassy_modulus = 30\ncreep = [{ fraction = 0.4, retardation_time = 0.05 }, { fraction = 0.6, retardation_time = 1 }]\n\
            [sliding]\nwave = {}\nspeed = 1\nmean_pressure = 0.1\n\
            [fit]\ncompare = \"friction_coefficient\"\nagainst = \"sliding.speed\"\nfree = [{ key = \"material.glassy_modulus\", from = 2, to = 1e3 }, { key = \"material.creep.0.retardation_time\", from = 1e-4, to = 0.5 }]\n\
            [[fit.test]]\ndata = \"data.csv\"\n",
    truth: &[(10.0, 100.0), (0.005, 0.1)],
    header: "speed, friction_coefficient",
    rows: (1e-2, 1e3, 30),
    logarithmic: true,
    scatter: Scatter::OfEach,
};

/// All families.
pub(super) const CASES: [Case; 4] = [PULL_OFF, RELAXATION, TEARING, FRICTION];

impl Case {
    /// Truth number `draw`.
    pub(super) fn truth(&self, draw: &mut Draw) -> Vec<f64> {
        self.truth.iter().map(|&(low, high)| if low > 0.0 { draw.log_between(low, high) } else { draw.between(low, high) }).collect()
    }

    /// The places of the rows.
    pub(super) fn places(&self) -> Vec<f64> {
        let (from, to, count) = self.rows;
        let part = |row: usize| row as f64 / (count - 1) as f64;
        (0..count).map(|row| if self.logarithmic { from * (to / from).powf(part(row)) } else { from + (to - from) * part(row) }).collect()
    }
}
