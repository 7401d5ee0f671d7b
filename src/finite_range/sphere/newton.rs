//! One elastic adhesive contact: Newton's method on the gap with a kept factorisation and active columns.
//!
//! Unknown are u at the nodes and the penetration Δ:
//!   g(u) + λ (w(u) − w(u_old)) = g₀ − Δ + m A (C p(u) + H),   a Δ + b F = c,
//! g₀ the undeformed gap, H the creep strains of the stage, λ the pseudo-time of a jump (0 otherwise), w the gap or, on a hard wall, what the
//! pressure would close of it over a unit length, and the last equation the control.
//! Where the law is flat (far outside) a column of the Jacobian is that of the unit matrix: those nodes are eliminated.

use faer::linalg::solvers::{PartialPivLu, Solve};
use faer::{Mat, MatMut};

use super::mesh::Mesh;
use super::surface::{Local, Surface};

/// A correction must fall by this factor, or the Jacobian is made anew.
const CONTRACTION: f64 = 0.3;
/// Factorisations after which the stage is given up.
const FACTORISATIONS: usize = 8;
/// The same for a law with a hard wall, where replacements of columns count as well.
const WALL_FACTORISATIONS: usize = 32;
/// Nodes that have changed sides of a hard wall since the factorisation, at most, over all: their columns are replaced in it.
const FOLLOWED: f64 = 0.15;
/// Corrections after such replacements that need not fall.
const PATIENCE: usize = 25;
/// A node that has changed sides so often is open from then on: collocation may leave the last node of a contact no side, pulled too much when it
/// touches, and closed by a hair when it does not.
const MOST_CHANGES: u8 = 3;
/// Iterations after which the stage is given up.
const ITERATIONS: usize = 80;
/// A kept factorisation serves compliances within this ratio.
const NEAR_COMPLIANCE: f64 = 0.2;
/// Columns whose entries would sum to less than this are left out of the Jacobian.
const FLAT: f64 = 0.02;

/// a·penetration + b·force = c.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Row {
    pub(super) penetration: f64,
    pub(super) force: f64,
    pub(super) value: f64,
}

/// The equations of a contact.
pub(super) struct Equation<'a> {
    pub(super) mesh: &'a Mesh,
    /// g₀.
    pub(super) undeformed: &'a [f64],
    /// m.
    pub(super) coupling: f64,
    /// C.
    pub(super) compliance: f64,
    /// H.
    pub(super) history: &'a [f64],
    /// λ and u_old.
    pub(super) pseudo: Option<(f64, &'a [f64])>,
    pub(super) row: Row,
    pub(super) tolerance: f64,
    /// By how much a node without a side may lie beyond a hard wall.
    pub(super) overlap: f64,
    /// A correction below this that does not fall any more is rounding.
    pub(super) rounding: f64,
}

/// The law at the nodes, with those that are kept open.
struct Nodes<'a> {
    surface: &'a Surface,
    changes: Vec<u8>,
    touched: Vec<bool>,
}

impl<'a> Nodes<'a> {
    fn new(surface: &'a Surface, u: &[f64]) -> Self {
        let touched = if surface.has_wall() { u.iter().map(|&u| surface.touches(u)).collect() } else { Vec::new() };
        Self { surface, changes: vec![0; touched.len()], touched }
    }

    fn is_kept_open(&self, i: usize) -> bool {
        self.changes.get(i).is_some_and(|changes| *changes >= MOST_CHANGES)
    }

    /// Counts changes of sides.
    fn see(&mut self, u: &[f64]) {
        for ((changes, touched), &u) in self.changes.iter_mut().zip(&mut self.touched).zip(u) {
            if *changes < MOST_CHANGES && self.surface.touches(u) != *touched {
                (*changes, *touched) = (*changes + 1, !*touched);
            }
        }
    }

    fn touches(&self, i: usize, u: f64) -> bool {
        self.surface.touches(u) && !self.is_kept_open(i)
    }

    fn at(&self, i: usize, u: f64) -> Local {
        if self.is_kept_open(i) { Local { gap: u, ..self.surface.at(self.surface.gap(u)) } } else { self.surface.at(u) }
    }

    fn gap(&self, i: usize, u: f64) -> f64 {
        if self.is_kept_open(i) { u } else { self.surface.gap(u) }
    }

    fn yielded(&self, i: usize, u: f64, yielding: f64) -> f64 {
        if self.is_kept_open(i) { u } else { self.surface.yielded(u, yielding) }
    }

    fn pressure(&self, i: usize, u: f64) -> f64 {
        self.surface.pressure(if self.is_kept_open(i) { self.surface.gap(u) } else { u })
    }

    /// How far the nodes that are kept open lie beyond the wall.
    fn overlap(&self, u: &[f64]) -> f64 {
        let beyond = |(i, &u): (usize, &f64)| if self.is_kept_open(i) { self.surface.gap(u) - u } else { 0.0 };
        u.iter().enumerate().map(beyond).fold(0.0, f64::max)
    }
}

/// A solved contact.
#[derive(Debug, Clone)]
pub(super) struct Contact {
    pub(super) u: Vec<f64>,
    pub(super) p: Vec<f64>,
    pub(super) penetration: f64,
    pub(super) force: f64,
}

/// What Newton's method keeps between calls, and how much it did.
#[derive(Default)]
pub(super) struct Newton {
    kept: Option<Factor>,
    pub(super) factorisations: usize,
    pub(super) iterations: usize,
    pub(super) last_correction: f64,
}

struct Factor {
    serial: u64,
    compliance: f64,
    scale: f64,
    /// What nodes on a hard wall have in the place of `scale`.
    on_wall: f64,
    active: Vec<usize>,
    passive: Vec<usize>,
    lu: PartialPivLu<f64>,
    /// Influence of active nodes on passive ones, by columns.
    border: Vec<f64>,
    /// Coupling times slope of the pressure, of active nodes.
    strengths: Vec<f64>,
    /// Which nodes touch a hard wall, at the factorisation.
    touching: Vec<bool>,
    /// Columns of nodes that have changed sides since.
    replaced: Option<Replaced>,
    /// The response of u to Δ.
    unit: Vec<f64>,
    /// Area times slope of the pressure.
    force: Vec<f64>,
}

/// Columns replaced in a factorisation: (J + D Eᵀ)⁻¹ r = y − Z (1 + EᵀZ)⁻¹ Eᵀ y, with y = J⁻¹ r and Z = J⁻¹ D.
struct Replaced {
    /// Nodes.
    nodes: Vec<usize>,
    /// Their places among the active ones.
    places: Vec<usize>,
    /// Z, by columns.
    responses: Vec<Vec<f64>>,
    strengths: Vec<f64>,
    small: PartialPivLu<f64>,
}

/// Whether a factorisation knows which nodes touch a hard wall.
#[derive(PartialEq, Eq)]
enum Sides {
    Same,
    Followed,
    TooFar,
}

impl Newton {
    /// Solves from a first guess; nothing if it does not converge.
    pub(super) fn solve(&mut self, surface: &Surface, equation: &Equation, guess: &[f64], mut penetration: f64) -> Option<Contact> {
        let Equation { mesh, row, .. } = *equation;
        let n = mesh.nodes();
        let scale = 1.0 + equation.pseudo.map_or(0.0, |(lambda, _)| lambda);
        let yielding = equation.coupling * equation.compliance;
        let (mut u, mut p, mut q, mut image, mut residual) = (guess.to_vec(), vec![0.0; n], vec![0.0; n], vec![0.0; n], vec![0.0; n]);
        if row.force == 0.0 {
            penetration = row.value / row.penetration;
        }
        let (mut previous, mut made, mut followed) = (f64::INFINITY, 0, 0);
        let mut nodes = Nodes::new(surface, guess);
        let most = if surface.has_wall() { WALL_FACTORISATIONS } else { FACTORISATIONS };
        for _ in 0..ITERATIONS {
            self.iterations += 1;
            nodes.see(&u);
            (0..n).for_each(|i| p[i] = nodes.pressure(i, u[i]));
            (0..n).for_each(|i| q[i] = equation.compliance * p[i] + equation.history[i]);
            mesh.apply(&q, &mut image);
            for i in 0..n {
                let moved = |old: &[f64]| nodes.yielded(i, u[i], yielding) - surface.yielded(old[i], yielding);
                let damping = equation.pseudo.map_or(0.0, |(lambda, old)| lambda * moved(old));
                residual[i] = nodes.gap(i, u[i]) + damping - equation.undeformed[i] + penetration - equation.coupling * image[i];
            }
            let outside = surface.outside(penetration);
            let force = mesh.integral(|i| p[i]) + outside.0;
            let off = row.penetration * penetration + row.force * force - row.value;
            let mut usable = self.kept.as_ref().is_some_and(|kept| kept.serves(equation, scale));
            let mut free = false;
            if usable {
                let sides = self.kept.as_mut().map_or(Sides::TooFar, |kept| kept.follow(&nodes, equation, &u));
                usable = sides != Sides::TooFar;
                followed += usize::from(sides == Sides::Followed);
                free = sides == Sides::Followed && followed <= PATIENCE;
            }
            if !usable {
                self.renew(&nodes, equation, &u, scale)?;
                made += 1;
            }
            let mut correction = self.correct(&residual, off, row, outside.1)?;
            // Where the gap is wide, or the pressure on a wall is large, its relative change counts: rounding is relative too.
            let size =
                |c: &(Vec<f64>, f64)| c.0.iter().zip(&u).fold(c.1.abs(), |most, (value, u)| most.max(value.abs() / u.abs().max(1.0)));
            let allowed = (CONTRACTION * previous).max(equation.tolerance);
            if usable && ((size(&correction) > allowed && !free) || !correction.1.is_finite()) {
                if made + followed >= most {
                    return None;
                }
                self.renew(&nodes, equation, &u, scale)?;
                made += 1;
                correction = self.correct(&residual, off, row, outside.1)?;
            }
            let size = size(&correction);
            if !size.is_finite() {
                self.kept = None;
                return None;
            }
            let fraction = (0..n).fold(1.0_f64, |least, i| least.min(surface.reach(u[i]) / correction.0[i].abs().max(1e-300)));
            (0..n).for_each(|i| u[i] += fraction * correction.0[i]);
            penetration += fraction * correction.1;
            if fraction < 1.0 {
                if made + followed >= most {
                    return None;
                }
                self.kept = None;
                previous = f64::INFINITY;
                continue;
            }
            let converged = size <= equation.tolerance || (size <= equation.rounding && size > CONTRACTION * previous);
            previous = size;
            if converged {
                self.last_correction = size;
                if nodes.overlap(&u) > equation.overlap {
                    return None;
                }
                (0..n).filter(|&i| nodes.is_kept_open(i)).for_each(|i| u[i] = surface.opened(u[i]));
                (0..n).for_each(|i| p[i] = nodes.pressure(i, u[i]));
                let force = mesh.integral(|i| p[i]) + surface.outside(penetration).0;
                let finite = force.is_finite() && penetration.is_finite() && u.iter().all(|u| u.is_finite());
                return finite.then_some(Contact { u, p, penetration, force });
            }
        }
        None
    }

    /// Factors the Jacobian at u.
    fn renew(&mut self, nodes: &Nodes, equation: &Equation, u: &[f64], scale: f64) -> Option<()> {
        self.factorisations += 1;
        self.kept = None;
        let mesh = equation.mesh;
        let n = mesh.nodes();
        let local: Vec<_> = u.iter().enumerate().map(|(i, &u)| nodes.at(i, u)).collect();
        let strength = equation.coupling * equation.compliance;
        let on_wall = (scale - 1.0) * strength;
        let flat = FLAT * scale / (strength * 4.0);
        let (active, passive): (Vec<usize>, Vec<usize>) =
            (0..n).partition(|&i| local[i].gap_slope == 0.0 || local[i].pressure_slope.abs() > flat);
        let column = |j: usize| (strength * local[j].pressure_slope, &mesh.matrix[j * n..(j + 1) * n]);
        let mut jacobian = Mat::<f64>::zeros(active.len(), active.len());
        let mut border = Vec::with_capacity(active.len() * passive.len());
        for (k, &j) in active.iter().enumerate() {
            let (factor, influence) = column(j);
            active.iter().enumerate().for_each(|(l, &i)| jacobian[(l, k)] = -factor * influence[i]);
            jacobian[(k, k)] += if local[j].gap_slope > 0.0 { scale } else { on_wall };
            border.extend(passive.iter().map(|&i| influence[i]));
        }
        let lu = jacobian.partial_piv_lu();
        let force = (0..n).map(|i| mesh.area[i] * local[i].pressure_slope).collect();
        let mut factor = Factor {
            serial: mesh.serial,
            compliance: strength,
            scale,
            on_wall,
            strengths: active.iter().map(|&j| column(j).0).collect(),
            touching: u.iter().enumerate().map(|(i, &u)| nodes.touches(i, u)).collect(),
            active,
            passive,
            lu,
            border,
            replaced: None,
            unit: Vec::new(),
            force,
        };
        let unit = factor.apply(&vec![1.0; n]);
        factor.unit = unit;
        self.kept = factor.unit.iter().all(|value| value.is_finite()).then_some(factor);
        self.kept.as_ref().map(|_| ())
    }

    /// The corrections of u and Δ.
    fn correct(&self, residual: &[f64], off: f64, row: Row, outside_slope: f64) -> Option<(Vec<f64>, f64)> {
        let kept = self.kept.as_ref()?;
        let mut correction = kept.apply(residual);
        let mut penetration = 0.0;
        if row.force == 0.0 {
            correction.iter_mut().for_each(|value| *value = -*value);
        } else {
            let along = |v: &[f64]| kept.force.iter().zip(v).map(|(f, v)| f * v).sum::<f64>();
            let slope = row.penetration + row.force * (outside_slope - along(&kept.unit));
            penetration = (row.force * along(&correction) - off) / slope;
            correction.iter_mut().zip(&kept.unit).for_each(|(value, unit)| *value = -*value - unit * penetration);
        }
        Some((correction, penetration))
    }
}

impl Factor {
    fn serves(&self, equation: &Equation, scale: f64) -> bool {
        let strength = equation.coupling * equation.compliance;
        self.serial == equation.mesh.serial
            && (strength / self.compliance - 1.0).abs() <= NEAR_COMPLIANCE
            && (scale / self.scale - 1.0).abs() <= NEAR_COMPLIANCE
    }

    /// Replaces the columns of nodes that have changed sides of a hard wall.
    fn follow(&mut self, law: &Nodes, equation: &Equation, u: &[f64]) -> Sides {
        if !law.surface.has_wall() {
            return Sides::Same;
        }
        let nodes: Vec<usize> = (0..u.len()).filter(|&i| law.touches(i, u[i]) != self.touching[i]).collect();
        let known = self.replaced.as_ref().map_or(&[][..], |replaced| &replaced.nodes);
        if nodes == known {
            return Sides::Same;
        }
        if nodes.len() as f64 > FOLLOWED * u.len() as f64 {
            return Sides::TooFar;
        }
        let Some(places) = nodes.iter().map(|node| self.active.binary_search(node).ok()).collect::<Option<Vec<usize>>>() else {
            return Sides::TooFar;
        };
        let n = u.len();
        let (count, earlier) = (nodes.len(), self.replaced.take());
        let (mut responses, mut strengths) = (Vec::with_capacity(count), Vec::with_capacity(count));
        for (&node, &place) in nodes.iter().zip(&places) {
            let kept = earlier.as_ref().and_then(|earlier| Some((earlier, earlier.nodes.binary_search(&node).ok()?)));
            if let Some((earlier, index)) = kept {
                responses.push(earlier.responses[index].clone());
                strengths.push(earlier.strengths[index]);
                continue;
            }
            let local = law.at(node, u[node]);
            let strength = self.compliance * local.pressure_slope;
            let influence = &equation.mesh.matrix[node * n..(node + 1) * n];
            let mut column: Vec<f64> = self.active.iter().map(|&i| (self.strengths[place] - strength) * influence[i]).collect();
            column[place] += if self.touching[node] { self.scale - self.on_wall } else { self.on_wall - self.scale };
            let length = column.len();
            self.lu.solve_in_place(MatMut::from_column_major_slice_mut(&mut column, length, 1));
            responses.push(column);
            strengths.push(strength);
        }
        for &node in nodes.iter().chain(earlier.iter().flat_map(|earlier| &earlier.nodes)) {
            self.force[node] = equation.mesh.area[node] * law.at(node, u[node]).pressure_slope;
        }
        let mut small = Mat::<f64>::identity(count, count);
        for (k, response) in responses.iter().enumerate() {
            places.iter().enumerate().for_each(|(l, &place)| small[(l, k)] += response[place]);
        }
        let small = small.partial_piv_lu();
        self.replaced = Some(Replaced { nodes, places, responses, strengths, small });
        self.unit = self.apply(&vec![1.0; n]);
        if self.unit.iter().all(|value| value.is_finite()) { Sides::Followed } else { Sides::TooFar }
    }

    /// J⁻¹ r.
    fn apply(&self, right: &[f64]) -> Vec<f64> {
        let mut solution = vec![0.0; right.len()];
        let mut active: Vec<f64> = self.active.iter().map(|&i| right[i]).collect();
        let count = active.len();
        if count > 0 {
            self.lu.solve_in_place(MatMut::from_column_major_slice_mut(&mut active, count, 1));
        }
        let mut strengths = std::borrow::Cow::Borrowed(&self.strengths);
        if let Some(replaced) = self.replaced.as_ref().filter(|replaced| !replaced.nodes.is_empty()) {
            let mut parts: Vec<f64> = replaced.places.iter().map(|&place| active[place]).collect();
            let count = parts.len();
            replaced.small.solve_in_place(MatMut::from_column_major_slice_mut(&mut parts, count, 1));
            for (part, response) in parts.iter().zip(&replaced.responses) {
                active.iter_mut().zip(response).for_each(|(value, response)| *value -= part * response);
            }
            let strengths = strengths.to_mut();
            replaced.places.iter().zip(&replaced.strengths).for_each(|(&place, &strength)| strengths[place] = strength);
        }
        let mut passive: Vec<f64> = self.passive.iter().map(|&i| right[i] / self.scale).collect();
        if !passive.is_empty() {
            for ((value, strength), column) in active.iter().zip(strengths.iter()).zip(self.border.chunks_exact(passive.len())) {
                let moved = value * strength / self.scale;
                passive.iter_mut().zip(column).for_each(|(p, c)| *p += c * moved);
            }
        }
        self.active.iter().zip(&active).for_each(|(&i, &value)| solution[i] = value);
        self.passive.iter().zip(&passive).for_each(|(&i, &value)| solution[i] = value);
        solution
    }
}
