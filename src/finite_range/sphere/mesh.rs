//! Spectral elements in the radius on a dyadic mesh, and the influence matrix on them.
//!
//! Pressure and creep strains are polynomials on every element, without continuity between elements. A block of the influence matrix
//! depends only on the two intervals, so blocks are kept: a new mesh computes only the pairs that never met before.

use std::collections::HashMap;
use std::f64::consts::PI;
use std::sync::Arc;

use super::kernel::{Points, Quadrature, Rule};

/// Lengths of neighbours differ by this factor at most.
pub(super) const GRADING: f64 = 4.0;
/// No element is halved more often: the shortest is 1e-9 of its root.
const DEEPEST: u32 = 30;
/// Bytes of the blocks kept before their store is emptied, and what a block takes besides its numbers.
const STORE: usize = 24 << 20;
const OF_A_BLOCK: usize = 100;

/// A dyadic piece of a root interval.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct Cell {
    /// The ends of the root, as the bits of their numbers: cells are keys.
    root: [u64; 2],
    level: u32,
    index: u64,
}

impl Cell {
    /// The roots [0, 4], [4, 8], [8, 16], [16, 64], [64, 128], … up to a radius, and to a rim at most.
    fn roots(radius: f64, rim: f64) -> Vec<Self> {
        let mut roots = Vec::new();
        for count in 0.. {
            let (from, to) = root_interval(count);
            roots.push(Self { root: [from, to.min(rim)].map(f64::to_bits), level: 0, index: 0 });
            if to >= rim || (count >= 3 && to >= radius) {
                break;
            }
        }
        roots
    }

    /// Its ends.
    pub(super) fn interval(self) -> (f64, f64) {
        let [a, b] = self.root.map(f64::from_bits);
        let length = (b - a) / (1_u64 << self.level) as f64;
        (a + length * self.index as f64, a + length * (self.index + 1) as f64)
    }

    pub(super) fn length(self) -> f64 {
        let (a, b) = self.interval();
        b - a
    }

    fn halves(self) -> [Self; 2] {
        [0, 1].map(|side| Self { root: self.root, level: self.level + 1, index: 2 * self.index + side })
    }

    /// The parent, if this is its left half and `next` its right one.
    pub(super) fn parent_with(self, next: Self) -> Option<Self> {
        let siblings = self.level > 0
            && self.root == next.root
            && self.level == next.level
            && self.index.is_multiple_of(2)
            && next.index == self.index + 1;
        siblings.then(|| Self { root: self.root, level: self.level - 1, index: self.index / 2 })
    }
}

fn root_interval(root: u32) -> (f64, f64) {
    match root {
        0 => (0.0, 4.0),
        1 => (4.0, 8.0),
        2 => (8.0, 16.0),
        3 => (16.0, 64.0),
        _ => (64.0 * 2_f64.powi(root as i32 - 4), 64.0 * 2_f64.powi(root as i32 - 3)),
    }
}

/// Elements, nodes and the influence matrix.
pub(super) struct Mesh {
    pub(super) cells: Vec<Cell>,
    /// Radii of the nodes.
    pub(super) x: Vec<f64>,
    /// 2πx·weight: the area of a node.
    pub(super) area: Vec<f64>,
    /// w = A q, by columns.
    pub(super) matrix: Vec<f64>,
    /// A number that no other mesh has.
    pub(super) serial: u64,
}

impl Mesh {
    pub(super) fn nodes(&self) -> usize {
        self.x.len()
    }

    /// The outer radius.
    pub(super) fn radius(&self) -> f64 {
        self.cells.last().map_or(0.0, |cell| cell.interval().1)
    }

    /// out = A q, in the widest vectors of the machine.
    pub(super) fn apply(&self, q: &[f64], out: &mut [f64]) {
        pulp::Arch::new().dispatch(Product { matrix: &self.matrix, q, out });
    }

    /// The value at a radius of a field that is a polynomial in every element; nothing outside.
    pub(super) fn value_at(&self, rule: &Rule, field: &[f64], radius: f64) -> Option<f64> {
        let e = self.cells.partition_point(|cell| cell.interval().1 < radius);
        let (a, b) = self.cells.get(e)?.interval();
        let order = rule.nodes.len();
        let mut basis = vec![0.0; order];
        rule.basis((2.0 * radius - a - b) / (b - a), &mut basis);
        Some(basis.iter().zip(&field[e * order..(e + 1) * order]).map(|(b, v)| b * v).sum())
    }

    /// ∫ f dA.
    pub(super) fn integral(&self, f: impl Fn(usize) -> f64) -> f64 {
        (0..self.nodes()).map(|i| self.area[i] * f(i)).sum()
    }
}

/// A matrix by columns times a vector.
struct Product<'a> {
    matrix: &'a [f64],
    q: &'a [f64],
    out: &'a mut [f64],
}

impl pulp::WithSimd for Product<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) {
        let n = self.out.len();
        self.out.fill(0.0);
        let mut columns = self.matrix.chunks_exact(4 * n);
        let mut values = self.q.chunks_exact(4);
        for (four, q) in columns.by_ref().zip(values.by_ref()) {
            let (a, rest) = four.split_at(n);
            let (b, rest) = rest.split_at(n);
            let (c, d) = rest.split_at(n);
            for ((((out, a), b), c), d) in self.out.iter_mut().zip(a).zip(b).zip(c).zip(d) {
                *out += (a * q[0] + b * q[1]) + (c * q[2] + d * q[3]);
            }
        }
        for (column, q) in columns.remainder().chunks_exact(n).zip(values.remainder()) {
            self.out.iter_mut().zip(column).for_each(|(out, a)| *out += a * q);
        }
    }
}

/// Makes meshes of one order; owns the blocks of all of them.
pub struct Mesher {
    pub(super) quadrature: Quadrature,
    points: Points,
    blocks: HashMap<(Cell, Cell), Arc<[f64]>>,
    made: u64,
}

impl Mesher {
    /// With this many nodes an element, 4 to 16 and equal to [`Accuracy::order`](super::Accuracy): 10 is a good choice, 6 where the law is kinked.
    #[must_use]
    pub fn new(order: usize) -> Self {
        Self { quadrature: Quadrature::new(order), points: Points::default(), blocks: HashMap::new(), made: 0 }
    }

    /// Nodes of an element.
    #[must_use]
    pub fn order(&self) -> usize {
        self.quadrature.rule.nodes.len()
    }

    /// The elements of the coarsest mesh that reaches a radius, or the rim of the tip.
    pub(super) fn coarsest(radius: f64, rim: Option<f64>) -> Vec<Cell> {
        Cell::roots(radius, rim.unwrap_or(f64::INFINITY))
    }

    /// Elements and nodes without an influence matrix.
    pub(super) fn outline(&mut self, cells: Vec<Cell>) -> Mesh {
        let order = self.order();
        let n = cells.len() * order;
        let (mut x, mut area) = (Vec::with_capacity(n), Vec::with_capacity(n));
        for cell in &cells {
            let (a, b) = cell.interval();
            for (node, weight) in self.quadrature.rule.nodes.iter().zip(&self.quadrature.rule.weights) {
                let radius = 0.5 * (a + b) + 0.5 * (b - a) * node;
                x.push(radius);
                area.push(PI * (b - a) * weight * radius);
            }
        }
        self.made += 1;
        Mesh { cells, x, area, matrix: Vec::new(), serial: self.made }
    }

    /// The mesh of these elements.
    pub(super) fn build(&mut self, cells: Vec<Cell>) -> Arc<Mesh> {
        let mesh = self.outline(cells);
        self.filled(mesh)
    }

    /// The same with its influence matrix.
    pub(super) fn filled(&mut self, mut mesh: Mesh) -> Arc<Mesh> {
        let (order, n) = (self.order(), mesh.nodes());
        let mut matrix = vec![0.0; n * n];
        if self.blocks.len() * (8 * order * order + OF_A_BLOCK) > STORE {
            self.blocks.clear();
        }
        for (j, &source) in mesh.cells.iter().enumerate() {
            for (i, &target) in mesh.cells.iter().enumerate() {
                let block = self.block(target, source);
                for (k, column) in block.chunks_exact(order).enumerate() {
                    let start = (j * order + k) * n + i * order;
                    matrix[start..start + order].copy_from_slice(column);
                }
            }
        }
        mesh.matrix = matrix;
        Arc::new(mesh)
    }

    /// The block of a pair, by columns.
    fn block(&mut self, target: Cell, source: Cell) -> Arc<[f64]> {
        if let Some(block) = self.blocks.get(&(target, source)) {
            return Arc::clone(block);
        }
        let order = self.order();
        let rule = &self.quadrature.rule;
        let ((a, b), ends) = (target.interval(), source.interval());
        let at = |(a, b): (f64, f64), k: usize| 0.5 * (a + b) + 0.5 * (b - a) * rule.nodes[k];
        let (mut row, mut block, mut all_far) = (vec![0.0; order], vec![0.0; order * order], true);
        for i in 0..order {
            let x = at((a, b), i);
            all_far &= self.quadrature.is_far(x, ends) && self.quadrature.is_far(at(ends, i), (a, b));
            self.quadrature.row(x, ends, &mut self.points, &mut row);
            (0..order).for_each(|k| block[k * order + i] = row[k]);
        }
        if all_far {
            // Both ways by the plain rule: the transpose is known, because area·A is symmetric.
            let (half, half_back) = (0.5 * (ends.1 - ends.0), 0.5 * (b - a));
            let mut back = vec![0.0; order * order];
            for i in 0..order {
                for k in 0..order {
                    let (there, here) = (half * rule.weights[k] * at(ends, k), half_back * rule.weights[i] * at((a, b), i));
                    back[i * order + k] = block[k * order + i] * here / there;
                }
            }
            self.blocks.insert((source, target), back.into());
        }
        let block: Arc<[f64]> = block.into();
        self.blocks.insert((target, source), Arc::clone(&block));
        block
    }

    /// The elements with the flagged ones halved, and others until neighbours differ by the allowed factor.
    pub(super) fn halved(all: &[Cell], flagged: &[bool]) -> Vec<Cell> {
        let mut cells: Vec<Cell> = Vec::with_capacity(2 * all.len());
        for (&cell, &flag) in all.iter().zip(flagged) {
            if flag && cell.level < DEEPEST { cells.extend(cell.halves()) } else { cells.push(cell) }
        }
        loop {
            let long = |i: usize, j: usize| cells[i].length() > GRADING * 1.001 * cells[j].length();
            let found = (0..cells.len()).find(|&i| (i > 0 && long(i, i - 1)) || (i + 1 < cells.len() && long(i, i + 1)));
            let Some(i) = found else { break };
            let halves = cells[i].halves();
            cells.splice(i..=i, halves);
        }
        cells
    }

    /// Carries fields from one mesh to another of the same radius.
    pub(super) fn carry(&self, from: &Mesh, to: &Mesh, fields: &mut [&mut Vec<f64>]) {
        let order = self.order();
        let mut basis = vec![0.0; order];
        let mut new: Vec<Vec<f64>> = fields.iter().map(|_| vec![0.0; to.nodes()]).collect();
        let mut e = 0;
        for (i, &x) in to.x.iter().enumerate() {
            while e + 1 < from.cells.len() && from.cells[e].interval().1 < x {
                e += 1;
            }
            if from.cells[e] == to.cells[i / order] {
                let k = e * order + i % order;
                new.iter_mut().zip(fields.iter()).for_each(|(new, old)| new[i] = old[k]);
                continue;
            }
            let (a, b) = from.cells[e].interval();
            self.quadrature.rule.basis((2.0 * x - a - b) / (b - a), &mut basis);
            for (new, old) in new.iter_mut().zip(fields.iter()) {
                new[i] = basis.iter().zip(&old[e * order..(e + 1) * order]).map(|(b, v)| b * v).sum();
            }
        }
        fields.iter_mut().zip(new).for_each(|(old, new)| **old = new);
    }
}
