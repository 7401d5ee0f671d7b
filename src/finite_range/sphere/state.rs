//! A state of the run, and the energies in it.

use std::sync::Arc;

use super::chain::Chain;
use super::kernel::Rule;
use super::mesh::{Mesh, Mesher};
use super::surface::{HAIR, Surface};
use crate::continuation::bracket::halved;

/// Everything a run needs to go on from an instant. Each state keeps its own mesh.
#[derive(Clone)]
pub(super) struct State {
    pub(super) mesh: Arc<Mesh>,
    /// The gap over the undeformed plane at penetration zero.
    pub(super) undeformed: Arc<[f64]>,
    pub(super) time: f64,
    pub(super) penetration: f64,
    pub(super) force: f64,
    /// The unknown of [`Surface`] at the nodes.
    pub(super) u: Vec<f64>,
    pub(super) p: Vec<f64>,
    /// Creep strains v_j.
    pub(super) strains: Vec<Vec<f64>>,
    /// Rates of u and of the penetration at the end of the last step; empty after a start or a jump.
    pub(super) rate: Option<(Vec<f64>, f64)>,
    /// ∫ F dΔ since the start.
    pub(super) work: f64,
    /// m ∫ Σ v̇_j·A p dt since the start: what went into the Voigt elements, stored or lost.
    pub(super) viscous: f64,
    /// Energy lost in jumps since the start.
    pub(super) released: f64,
}

/// Energies of a state, in RΔγh₀.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Energies {
    /// Elastic energy in the instant springs, zero or more.
    pub instant: f64,
    /// Elastic energy in the springs of the Voigt elements, zero or more.
    pub delayed: f64,
    /// Energy of the attraction: zero across a wide gap, negative where the surfaces attract.
    pub interface: f64,
}

/// a·A b, weighted by area.
fn product(mesh: &Mesh, a: &[f64], b: &[f64], image: &mut [f64]) -> f64 {
    mesh.apply(b, image);
    mesh.integral(|i| a[i] * image[i])
}

impl State {
    /// The energies.
    pub(super) fn energies(&self, surface: &Surface, chain: &Chain, coupling: f64) -> Energies {
        let mut image = vec![0.0; self.mesh.nodes()];
        let instant = 0.5 * coupling * chain.instant * product(&self.mesh, &self.p, &self.p, &mut image);
        let delayed =
            chain.terms.iter().zip(&self.strains).map(|(&(j, _), v)| 0.5 * coupling / j * product(&self.mesh, v, v, &mut image)).sum();
        Energies { instant, delayed, interface: self.interface(surface) }
    }

    /// The energy of the attraction.
    pub(super) fn interface(&self, surface: &Surface) -> f64 {
        self.mesh.integral(|i| surface.interface(self.u[i])) + surface.outside(self.penetration).2
    }

    /// The energy that can change at once: instant springs and attraction, and the work of the instant strains on the frozen ones.
    pub(super) fn instantaneous(&self, surface: &Surface, chain: &Chain, coupling: f64) -> f64 {
        let mut image = vec![0.0; self.mesh.nodes()];
        0.5 * coupling * chain.instant * product(&self.mesh, &self.p, &self.p, &mut image) + self.interface(surface)
    }

    /// The same state on another mesh: polynomials are carried as they are, the unknown less its undeformed part.
    pub(super) fn on(&self, mesh: &Arc<Mesh>, mesher: &Mesher, surface: &Surface) -> Self {
        let mut new = self.clone();
        new.mesh = Arc::clone(mesh);
        new.undeformed = mesh.x.iter().map(|&x| surface.undeformed(x)).collect();
        new.u = self.carried(&self.u, &new, mesher, surface);
        if let Some((rate, _)) = &mut new.rate {
            let touching: Vec<bool> = self.u.iter().map(|&u| surface.touches(u)).collect();
            let on_side = |side: bool| rate.iter().zip(&touching).map(|(rate, touch)| if *touch == side { *rate } else { 0.0 }).collect();
            let [mut open, mut closed]: [Vec<f64>; 2] = [on_side(false), on_side(true)];
            mesher.carry(&self.mesh, mesh, &mut [&mut open, &mut closed]);
            let side = |((open, closed), &u): ((f64, f64), &f64)| if surface.touches(u) { closed } else { open };
            *rate = open.into_iter().zip(closed).zip(&new.u).map(side).collect();
        }
        let mut fields: Vec<&mut Vec<f64>> = vec![&mut new.p];
        fields.extend(new.strains.iter_mut());
        mesher.carry(&self.mesh, mesh, &mut fields);
        if surface.has_wall() {
            new.p.iter_mut().zip(&new.u).for_each(|(p, &u)| *p = surface.pressure(u));
        }
        new
    }

    /// Values of the unknown on the mesh of this state, carried to the mesh of another one of the same radius. On a hard wall it is a pressure on one
    /// side of the edge and a gap on the other, which no polynomial joins: each is carried by itself.
    pub(super) fn carried(&self, unknown: &[f64], to: &Self, mesher: &Mesher, surface: &Surface) -> Vec<f64> {
        let mut lifted: Vec<f64> = unknown.iter().zip(self.undeformed.iter()).map(|(&u, flat)| surface.gap(u) - flat).collect();
        let mut pressed: Vec<f64> = unknown.iter().map(|&u| surface.gap(u) - u).collect();
        mesher.carry(&self.mesh, &to.mesh, &mut [&mut lifted, &mut pressed]);
        // A polynomial may overshoot below every gap there was, where the law is without bound.
        let least = unknown.iter().fold(f64::INFINITY, |least, &u| least.min(surface.gap(u)));
        let x = &self.mesh.x;
        // Whether a place lies between two nodes that touch, and whether it touches.
        let on_wall = |place: f64, pressed: f64| {
            let after = x.partition_point(|&x| x < place);
            let sides = [after.saturating_sub(1), after.min(x.len() - 1)].map(|i| surface.touches(unknown[i]));
            (sides[0] && sides[1], pressed > 0.0 && (sides[0] || sides[1]))
        };
        let joined = |(((lifted, flat), pressed), &place): (((&f64, &f64), &f64), &f64)| {
            let gap = (lifted + flat).max(least);
            // Between two nodes that touch nothing opens, though the polynomial may fall below zero.
            let (inside, touches) = on_wall(place, *pressed);
            if inside || touches { surface.gap(f64::NEG_INFINITY) - pressed.max(HAIR) } else { gap }
        };
        lifted.iter().zip(to.undeformed.iter()).zip(&pressed).zip(&to.mesh.x).map(joined).collect()
    }

    /// The radius where the tension is largest, by a parabola through its neighbours; zero if that is at the centre.
    pub(super) fn tension_radius(&self) -> f64 {
        let (p, x) = (&self.p, &self.mesh.x);
        let least = (0..p.len()).min_by(|&i, &k| p[i].total_cmp(&p[k])).unwrap_or(0);
        if least == 0 || least + 1 == p.len() {
            return if least == 0 { 0.0 } else { self.mesh.radius() };
        }
        let (left, right) = (x[least] - x[least - 1], x[least + 1] - x[least]);
        let (down, up) = ((p[least] - p[least - 1]) / left, (p[least + 1] - p[least]) / right);
        let curvature = (up - down) / (0.5 * (left + right));
        let slope = (down * right + up * left) / (left + right);
        if curvature > 0.0 { (x[least] - slope / curvature).clamp(x[least - 1], x[least + 1]) } else { x[least] }
    }

    /// By how much the gap at the axis is wider than that of the largest tension.
    pub(super) fn open_at_axis(&self, rule: &Rule, surface: &Surface) -> f64 {
        let lifted: Vec<f64> = self.u.iter().zip(self.undeformed.iter()).map(|(u, flat)| u - flat).collect();
        surface.undeformed(0.0) + self.mesh.value_at(rule, &lifted, 0.0).unwrap_or(0.0) - surface.peak_gap()
    }

    /// The edge of a contact with a hard wall before a node: the pressure falls to it as a square root, so its square on the last two nodes leads
    /// there. Beyond it the gap opens too flat to say.
    fn edge_on_wall(&self, outside: usize, gap: f64, surface: &Surface) -> Option<f64> {
        let (u, x) = (&self.u, &self.mesh.x);
        let last = outside.checked_sub(1).filter(|&i| surface.touches(u[i]))?;
        let halfway = 0.5 * (x[last] + x[outside]);
        let Some(before) = last.checked_sub(1).filter(|&i| surface.touches(u[i])) else { return Some(halfway) };
        let [one, other] = [before, last].map(|i| (u[i] - gap).powi(2));
        let place = x[last] + other * (x[last] - x[before]) / (one - other);
        Some(if one > other { place.min(x[outside]) } else { halfway })
    }

    /// The innermost radius where the gap passes a value, by the polynomial of its element; zero if the gap is larger everywhere.
    pub(super) fn radius_at_gap(&self, gap: f64, rule: &Rule, surface: &Surface) -> f64 {
        let (u, x) = (&self.u, &self.mesh.x);
        let Some(i) = (0..u.len()).find(|&i| surface.gap(u[i]) > gap) else { return self.mesh.radius() };
        if let Some(place) = self.edge_on_wall(i, gap, surface) {
            return place;
        }
        let lifted: Vec<f64> = self.u.iter().zip(self.undeformed.iter()).map(|(u, flat)| u - flat).collect();
        let open = |x: f64| self.mesh.value_at(rule, &lifted, x).map_or(0.0, |lift| surface.undeformed(x) + lift - gap);
        let inside = if i == 0 { 0.0 } else { x[i - 1] };
        if i == 0 && open(0.0) >= 0.0 {
            return 0.0;
        }
        halved([inside, x[i]], |x| open(x) <= 0.0)[0]
    }
}
