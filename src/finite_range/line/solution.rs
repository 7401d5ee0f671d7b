//! The numbers of a state on one grid, with the identities that a right state meets.

use super::grid::{Equations, State, mean};
use super::newton::Report;
use rustfft::num_complex::Complex64;

/// The numbers of a state (units of [`Problem`](super::Problem)).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Numbers {
    /// Mean pressure (E0*kΛ/2), compression positive.
    pub mean_pressure: f64,
    /// Mean gap (Λ).
    pub mean_gap: f64,
    /// Mean of −p h′ (E0*k²Λ²/2): the resistance per area to sliding, positive when it opposes the motion; computed from what the waves of the
    /// pressure lose in the body.
    pub friction_stress: f64,
    /// Part of the area in contact, 0 to 1: with the hard wall, or under repulsion where the law has no wall. Edges lie between nodes (lines).
    pub contact_fraction: f64,
    /// Tension, averaged over the whole area (E0*kΛ/2): zero or negative.
    pub adhesive_pressure: f64,
    /// Contact pressure or repulsion, averaged over the whole area (E0*kΛ/2): zero or more. The two means add up to the mean pressure.
    pub repulsive_pressure: f64,
    /// Energy per area of the interface, −∫tension from the gap to infinity (E0*kΛ²/2): zero at wide gaps, negative in contact.
    pub interface_energy: f64,
}

impl Numbers {
    /// The values in a fixed order, for differences between grids.
    pub(super) const fn list(&self) -> [f64; 7] {
        [
            self.mean_pressure,
            self.mean_gap,
            self.friction_stress,
            self.contact_fraction,
            self.adhesive_pressure,
            self.repulsive_pressure,
            self.interface_energy,
        ]
    }

    pub(super) const fn from_list(v: [f64; 7]) -> Self {
        Self {
            mean_pressure: v[0],
            mean_gap: v[1],
            friction_stress: v[2],
            contact_fraction: v[3],
            adhesive_pressure: v[4],
            repulsive_pressure: v[5],
            interface_energy: v[6],
        }
    }
}

/// How well one grid's state meets its equations. The three frictions (E0*k²Λ²/2) are equal but for the discretisation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Certificate {
    /// Friction from the pressure and the slope of the profile, −⟨p h′⟩.
    pub friction_by_profile: f64,
    /// Friction from the pressure and the slope of the displaced surface, −⟨p w′⟩; differs by the discretisation of the gap.
    pub friction_by_surface: f64,
    /// Friction from the loss of each wave of the pressure, Σ n Im K |p|².
    pub friction_by_loss: f64,
    /// Largest residual of the pressure (E0*kΛ/2).
    pub residual: f64,
    /// Least contact pressure with the wall (E0*kΛ/2); not below minus the residual.
    pub least_contact_pressure: f64,
    /// Least gap over the wall off contact (Λ, zero or more); without a wall the least gap; zero where everything is in contact.
    pub least_gap: f64,
    /// Newton steps of the last solve.
    pub newton_steps: usize,
    /// Products with the stiffness in the last solve.
    pub products: usize,
}

impl Certificate {
    /// By how much the friction by the loss and that by the profile differ: the discretisation of the gap.
    pub(super) const fn spread(&self) -> f64 {
        (self.friction_by_loss - self.friction_by_profile).abs()
    }
}

/// The fields of a state, row by row along x: node (i, j) of `nx` × `ny` is entry j·nx + i.
#[derive(Debug, Clone, PartialEq)]
pub struct Fields {
    /// Nodes along x.
    pub nx: usize,
    /// Nodes along y; 1 for a line.
    pub ny: usize,
    /// Pressure between the bodies (E0*kΛ/2), compression positive.
    pub pressure: Vec<f64>,
    /// Gap (Λ).
    pub gap: Vec<f64>,
    /// Heights of the profile (Λ), of zero mean, positive towards the body.
    pub profile: Vec<f64>,
    /// Displacement of the body's surface about its mean (Λ), positive into the body.
    pub surface: Vec<f64>,
    /// Nodes in contact (see [`Numbers::contact_fraction`]).
    pub contact: Vec<bool>,
}

/// All numbers, checks and fields of a state on its grid.
pub(super) fn evaluate(equations: &mut Equations, state: &State, report: Report) -> (Numbers, Certificate, Fields) {
    let n = equations.len();
    let nodes = n as f64;
    let (nx, ny) = (equations.grid.nx(), equations.grid.ny());
    let mut pressure = vec![0.0; n];
    equations.pressure(state, &mut pressure);
    let wall = equations.wall();
    let mut numbers = Numbers { mean_pressure: mean(&pressure), mean_gap: state.mean_gap(), ..Numbers::default() };
    let (mut excess, mut contact, mut least_gap) = (vec![0.0; n], vec![false; n], f64::INFINITY);
    for i in 0..n {
        let stress = equations.law.stress(state.gap[i]);
        let (tension, push) = if state.contact[i] { (stress, pressure[i] - stress) } else { (stress.min(0.0), stress.max(0.0)) };
        contact[i] = state.contact[i] || push > 0.0;
        excess[i] = push;
        numbers.adhesive_pressure += tension / nodes;
        numbers.repulsive_pressure += push / nodes;
        numbers.interface_energy -= equations.law.work_left(state.gap[i]) / nodes;
        if !state.contact[i] {
            least_gap = least_gap.min(state.gap[i] - if wall.is_finite() { wall } else { 0.0 });
        }
    }
    let bare = contact.iter().filter(|c| **c).count() as f64 / nodes;
    numbers.contact_fraction = match (wall.is_finite(), ny) {
        (true, 1) => line_contact(&excess, &contact),
        (true, _) => bare,
        (false, _) => part_below(&state.gap, [nx, ny], equations.law.equilibrium_gap()),
    };
    let surface: Vec<f64> = {
        let mean_gap = numbers.mean_gap;
        state.gap.iter().zip(&equations.heights).map(|(g, h)| g + h - mean_gap).collect()
    };
    let friction_by_profile = -mean_product(&pressure, &derivative(equations, |e| e.heights.clone()));
    let friction_by_surface = -mean_product(&pressure, &derivative(equations, |_| surface.clone()));
    let friction_by_loss = loss(equations, &pressure);
    // A sum of losses: exact where the body is elastic, never negative, and mostly closer than the product with the slope.
    numbers.friction_stress = friction_by_loss;
    let certificate = Certificate {
        friction_by_profile,
        friction_by_surface,
        friction_by_loss,
        residual: report.residual,
        least_contact_pressure: report.least_contact_pressure,
        least_gap: if least_gap.is_finite() { least_gap } else { 0.0 },
        newton_steps: report.steps,
        products: report.products,
    };
    let fields = Fields { nx, ny, pressure, gap: state.gap.clone(), profile: equations.heights.clone(), surface, contact };
    (numbers, certificate, fields)
}

/// The contact fraction of a line: towards an edge the square of the contact pressure falls linearly to zero.
fn line_contact(push: &[f64], contact: &[bool]) -> f64 {
    let n = push.len();
    let mut length = contact.iter().filter(|c| **c).count() as f64;
    for i in 0..n {
        if !contact[i] {
            continue;
        }
        for side in [1, n - 1] {
            let inward = n - side;
            let (outside, second, third) = ((i + side) % n, (i + inward) % n, (i + 2 * inward) % n);
            if contact[outside] {
                continue;
            }
            // Nodes second and third from the edge; the first one carries the error of the edge. A count of nodes has half a cell beyond each end.
            let (near, far) = (push[second].powi(2), push[third].powi(2));
            let usable = contact[second] && contact[third] && far > near;
            let beyond = if usable { near / (far - near) - 1.0 } else { 0.5 };
            length += beyond.clamp(-0.5, 1.5) - 0.5;
        }
    }
    (length / n as f64).clamp(0.0, 1.0)
}

/// The part of the area where a field lies below a level, linear between nodes (on triangles in two dimensions).
fn part_below(field: &[f64], [nx, ny]: [usize; 2], level: f64) -> f64 {
    let over = |x: usize, y: usize| field[y % ny * nx + x % nx] - level;
    let mut sum = 0.0;
    for y in 0..ny {
        for x in 0..nx {
            let here = over(x, y);
            let right = over(x + 1, y);
            if ny == 1 {
                sum += below_on_segment(here, right);
                continue;
            }
            let (up, across) = (over(x, y + 1), over(x + 1, y + 1));
            sum += 0.5 * (below_on_triangle([here, right, across]) + below_on_triangle([here, up, across]));
        }
    }
    (sum / (nx * ny) as f64).clamp(0.0, 1.0)
}

/// The part of a segment where a linear function with these ends is negative.
fn below_on_segment(a: f64, b: f64) -> f64 {
    match (a < 0.0, b < 0.0) {
        (true, true) => 1.0,
        (false, false) => 0.0,
        (true, false) => a / (a - b),
        (false, true) => b / (b - a),
    }
}

/// The part of a triangle where a linear function with these corners is negative.
fn below_on_triangle(mut corners: [f64; 3]) -> f64 {
    corners.sort_by(f64::total_cmp);
    let [a, b, c] = corners;
    if a >= 0.0 {
        0.0
    } else if c < 0.0 {
        1.0
    } else if b >= 0.0 {
        a * a / ((a - b) * (a - c))
    } else {
        1.0 - c * c / ((c - a) * (c - b))
    }
}

fn mean_product(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>() / a.len() as f64
}

/// ∂/∂x of a field; the highest wave number has no derivative on the grid.
fn derivative(equations: &mut Equations, field: impl Fn(&Equations) -> Vec<f64>) -> Vec<f64> {
    let field = field(equations);
    let grid = &mut equations.grid;
    let (nx, ny, nodes) = (grid.nx(), grid.ny(), grid.len() as f64);
    let mut out = vec![0.0; field.len()];
    for (entry, value) in grid.forward(&field).iter_mut().enumerate() {
        let number = entry / ny;
        *value *= Complex64::new(0.0, if 2 * number == nx { 0.0 } else { number as f64 / nodes });
    }
    grid.inverse(&mut out);
    out
}

/// Σ n Im K |p|² over all waves, K = 1/A.
fn loss(equations: &mut Equations, pressure: &[f64]) -> f64 {
    let Equations { grid, stiffness, .. } = equations;
    let (nx, ny, nodes) = (grid.nx(), grid.ny(), grid.len() as f64);
    let spectrum = grid.forward(pressure);
    let mut sum = 0.0;
    for (entry, (p, a)) in spectrum.iter().zip(stiffness.iter()).enumerate() {
        let number = entry / ny;
        if number > 0 && 2 * number < nx {
            // The stored stiffness is A over the number of nodes.
            sum += 2.0 * number as f64 * a.inv().im * p.norm_sqr() / nodes.powi(3);
        }
    }
    sum
}

/// What rounding and the residual leave of pressure and gap at a node.
pub(super) fn field_floors(equations: &Equations, report: &Report) -> [f64; 2] {
    let nodes = equations.len() as f64;
    let height = equations.heights.iter().fold(0.0_f64, |m, h| m.max(h.abs()));
    let rounding = 16.0 * f64::EPSILON * height;
    let softest = equations.stiffness.iter().skip(1).map(|a| a.norm() * nodes).fold(f64::INFINITY, f64::min);
    [2.0 * report.residual + rounding * equations.stiffest, 10.0 * report.mean_residual / softest + rounding]
}

/// The last differences of pressure and gap between grids, brought to the nodes of the finest one; the newest first.
#[derive(Debug, Clone, Default)]
pub(super) struct Differences {
    newest_first: Vec<[Vec<f64>; 2]>,
}

impl Differences {
    /// With the difference between two more grids: at each node the largest of the nodes around it that both have.
    pub(super) fn on_finer_grid(&self, coarse: &Fields, fine: &Fields, ages: usize) -> Self {
        if coarse.nx * 2 != fine.nx || !(coarse.ny == fine.ny || coarse.ny * 2 == fine.ny) {
            return Self::default();
        }
        let step_y = fine.ny / coarse.ny;
        let around = |index: usize, count: usize, step: usize| {
            let (low, high) = (index / step, index.div_ceil(step));
            // One further on each side where the node is on both grids.
            let widen = usize::from(low == high && step > 1);
            [(low + count - widen) % count, low % count, high % count, (high + widen) % count]
        };
        let carried = |values: &[f64]| -> Vec<f64> {
            (0..fine.nx * fine.ny)
                .map(|node| {
                    let (xs, ys) = (around(node % fine.nx, coarse.nx, 2), around(node / fine.nx, coarse.ny, step_y));
                    ys.iter().flat_map(|y| xs.iter().map(move |x| y * coarse.nx + x)).map(|c| values[c]).fold(0.0, f64::max)
                })
                .collect()
        };
        let difference = |a: &[f64], b: &[f64]| -> Vec<f64> {
            let at = |c: usize| (a[c] - b[(c / coarse.nx) * step_y * fine.nx + 2 * (c % coarse.nx)]).abs();
            carried(&(0..a.len()).map(at).collect::<Vec<f64>>())
        };
        let newest = [difference(&coarse.pressure, &fine.pressure), difference(&coarse.gap, &fine.gap)];
        let older = self.newest_first.iter().take(ages.saturating_sub(1)).map(|[pressure, gap]| [carried(pressure), carried(gap)]);
        Self { newest_first: std::iter::once(newest).chain(older).collect() }
    }

    /// At each node the largest of the differences, each times the weight of its age.
    pub(super) fn largest(&self, nodes: usize, weight: impl Fn(usize) -> f64) -> [Vec<f64>; 2] {
        if self.newest_first.is_empty() {
            return [vec![f64::INFINITY; nodes], vec![f64::INFINITY; nodes]];
        }
        let of = |which: usize, node: usize| {
            self.newest_first.iter().enumerate().map(|(age, lists)| weight(age) * lists[which][node]).fold(0.0, f64::max)
        };
        [0, 1].map(|which| (0..nodes).map(|node| of(which, node)).collect())
    }
}

/// Patches of contact: connected sets of nodes on the periodic grid (neighbours along x and y).
pub(super) fn patches(fields: &Fields) -> usize {
    let (nx, ny) = (fields.nx, fields.ny);
    let mut seen: Vec<bool> = fields.contact.iter().map(|c| !c).collect();
    let mut count = 0;
    let mut queue = Vec::new();
    for start in 0..seen.len() {
        if seen[start] {
            continue;
        }
        count += 1;
        seen[start] = true;
        queue.push(start);
        while let Some(node) = queue.pop() {
            let (x, y) = (node % nx, node / nx);
            let neighbours = [y * nx + (x + 1) % nx, y * nx + (x + nx - 1) % nx, (y + 1) % ny * nx + x, (y + ny - 1) % ny * nx + x];
            for next in neighbours {
                if !seen[next] {
                    seen[next] = true;
                    queue.push(next);
                }
            }
        }
    }
    count
}
