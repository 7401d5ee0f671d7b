//! The common points of two conics in the projective plane: at most four, all of them.
//!
//! ```text
//! uᵀA u = 0,  uᵀB u = 0,      u = (x : y : z) up to a factor
//! ```
//! Eliminating z leaves a quartic in x : y, whose roots are the eigenvalues of its companion matrix. Two passes with different axes, and Newton's method on both forms,
//! make up for the digits that the elimination loses.

use nalgebra::{Matrix2, Matrix3, Matrix4, Vector2, Vector3};

/// A real root may come out with an imaginary part of this, relative to its size: half the digits where two roots meet.
const NEARLY_REAL: f64 = 1e-3;
/// Residual over the size of the terms above which a point lies on no common point.
const RESIDUAL: f64 = 1e-11;
/// Two points nearer than this are one.
const SAME: f64 = 1e-9;

/// Two symmetric forms, scaled so that their diagonals are of order one.
struct Scaled {
    forms: [Matrix3<f64>; 2],
    scales: Vector3<f64>,
}

impl Scaled {
    fn new(first: &Matrix3<f64>, second: &Matrix3<f64>) -> Self {
        let scales = Vector3::from_fn(|index, _| {
            let size = first[(index, index)].abs() / first.norm() + second[(index, index)].abs() / second.norm();
            if size > 0.0 { size.sqrt().recip() } else { 1.0 }
        });
        let by = Matrix3::from_diagonal(&scales);
        let forms = [first, second].map(|form| {
            let form = by * form * by;
            form / form.norm()
        });
        Self { forms, scales }
    }
}

/// Every common point, each as a unit vector in the scaled coordinates, scaled back.
#[must_use]
pub fn common_points(first: &Matrix3<f64>, second: &Matrix3<f64>) -> Vec<Vector3<f64>> {
    let Scaled { forms, scales } = Scaled::new(first, second);
    let mut found: Vec<Vector3<f64>> = Vec::new();
    // Rotations that leave no axis special: one of them has no root near infinity.
    for (angle, tilt) in [(0.7, 0.4), (2.1, -0.9), (-0.5, 1.2)] {
        let axes = nalgebra::Rotation3::from_euler_angles(angle, tilt, 0.3 * angle + tilt).into_inner();
        let turned = forms.map(|form| axes.transpose() * form * axes);
        for point in by_elimination(&turned) {
            let Some(point) = polished(&forms, axes * point) else { continue };
            let same = |other: &Vector3<f64>| (other - point).norm().min((other + point).norm()) < SAME;
            if !found.iter().any(same) {
                found.push(point);
            }
        }
    }
    found.into_iter().map(|point| point.component_mul(&scales)).collect()
}

/// Coefficients in growing powers of t of the form at (1, t, z): of z⁰ (t⁰ t¹ t²), of z¹ (t⁰ t¹) and of z².
fn in_powers(form: &Matrix3<f64>) -> ([f64; 3], [f64; 2], f64) {
    ([form[(0, 0)], 2.0 * form[(0, 1)], form[(1, 1)]], [2.0 * form[(0, 2)], 2.0 * form[(1, 2)]], form[(2, 2)])
}

fn product(first: &[f64], second: &[f64]) -> Vec<f64> {
    let mut out = vec![0.0; first.len() + second.len() - 1];
    for (i, a) in first.iter().enumerate() {
        for (j, b) in second.iter().enumerate() {
            if let Some(value) = out.get_mut(i + j) {
                *value += a * b;
            }
        }
    }
    out
}

fn combined(first: &[f64], factor: f64, second: &[f64]) -> Vec<f64> {
    let at = |list: &[f64], index: usize| list.get(index).copied().unwrap_or(0.0);
    (0..first.len().max(second.len())).map(|index| at(first, index) + factor * at(second, index)).collect()
}

fn by_elimination(forms: &[Matrix3<f64>; 2]) -> Vec<Vector3<f64>> {
    let [(c1, b1, a1), (c2, b2, a2)] = forms.each_ref().map(in_powers);
    // Resultant of a z² + b z + c: (a₁c₂ − a₂c₁)² − (a₁b₂ − a₂b₁)(b₁c₂ − b₂c₁).
    let outer = combined(&c2.map(|value| a1 * value), -1.0, &c1.map(|value| a2 * value));
    let inner = combined(&b2.map(|value| a1 * value), -1.0, &b1.map(|value| a2 * value));
    let mixed = combined(&product(&b1, &c2), -1.0, &product(&b2, &c1));
    let quartic = combined(&product(&outer, &outer), -1.0, &product(&inner, &mixed));
    let [q0, q1, q2, q3, q4] = quartic[..] else { return Vec::new() };
    let companion = Matrix4::new(
        -q3 / q4,
        -q2 / q4,
        -q1 / q4,
        -q0 / q4, //
        1.0,
        0.0,
        0.0,
        0.0, //
        0.0,
        1.0,
        0.0,
        0.0, //
        0.0,
        0.0,
        1.0,
        0.0,
    );
    if companion.iter().any(|value| !value.is_finite()) {
        return Vec::new();
    }
    let at = |list: &[f64], t: f64| list.iter().rev().fold(0.0, |sum, value| sum * t + value);
    let mut points = Vec::new();
    for root in companion.complex_eigenvalues().iter() {
        if root.im.abs() > NEARLY_REAL * root.re.abs().max(1.0) {
            continue;
        }
        let t = root.re;
        // Both quadratics share a root z; where the linear combination loses it, both roots of either are tried.
        let (linear, constant) = (at(&inner, t), at(&outer, t));
        points.push(Vector3::new(1.0, t, -constant / linear));
        for (c, b, a) in [(at(&c1, t), at(&b1, t), a1), (at(&c2, t), at(&b2, t), a2)] {
            let root = (0.25 * b * b - a * c).max(0.0).sqrt();
            points.push(Vector3::new(1.0, t, (-0.5 * b + root) / a));
            points.push(Vector3::new(1.0, t, (-0.5 * b - root) / a));
        }
    }
    points.retain(|point| point.iter().all(|value| value.is_finite()));
    points
}

/// Newton's method on both forms on the unit sphere; none if it does not end on both.
fn polished(forms: &[Matrix3<f64>; 2], start: Vector3<f64>) -> Option<Vector3<f64>> {
    let mut point = start.normalize();
    let residual = |point: &Vector3<f64>| Vector2::new(point.dot(&(forms[0] * point)), point.dot(&(forms[1] * point)));
    for _ in 0..30 {
        let value = residual(&point);
        if value.norm() < 1e-16 {
            break;
        }
        // Any two directions across the point.
        let least = point.iamin();
        let mut axis = Vector3::zeros();
        axis[least] = 1.0;
        let one = point.cross(&axis).normalize();
        let other = point.cross(&one);
        let slopes = forms.map(|form| form * point * 2.0);
        let jacobian = Matrix2::new(slopes[0].dot(&one), slopes[0].dot(&other), slopes[1].dot(&one), slopes[1].dot(&other));
        let Some(step) = jacobian.lu().solve(&value) else { break };
        let length = step.norm();
        let step = if length > 0.3 { step * (0.3 / length) } else { step };
        let next = (point - one * step[0] - other * step[1]).normalize();
        if residual(&next).norm() >= value.norm() && length < 1e-6 {
            break;
        }
        point = next;
    }
    (residual(&point).norm() < RESIDUAL).then_some(point)
}
