//! Real Fourier transforms of a periodic line or surface, and the application of a symbol (a factor for every wave number).
//!
//! A field of `nx × ny` values is stored row by row, x fastest; a line has `ny = 1`. Its spectrum holds the wave numbers
//! n_x = 0 … nx/2 and all n_y, stored as `[n_x][n_y]`: the coefficient of e^{i(n_x x + n_y y)} times the number of nodes.

use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};
use rustfft::num_complex::Complex64;
use rustfft::{Fft, FftPlanner};
use std::sync::{Arc, Mutex};

/// Fields with fewer values than this are transformed on one core: starting a thread costs as much as the work.
const PARALLEL_FROM: usize = 1 << 15;

/// The transforms along y.
#[derive(Clone)]
struct Columns {
    forward: Arc<dyn Fft<f64>>,
    inverse: Arc<dyn Fft<f64>>,
}

/// The transforms of one grid, with their work space.
#[derive(Clone)]
pub(super) struct Transform {
    nx: usize,
    ny: usize,
    real_forward: Arc<dyn RealToComplex<f64>>,
    real_inverse: Arc<dyn ComplexToReal<f64>>,
    columns: Option<Columns>,
    rows: Vec<Complex64>,
    spectrum: Vec<Complex64>,
    field: Vec<f64>,
    scratch: Vec<Complex64>,
    threads: usize,
}

impl Transform {
    /// The transforms of a grid of `nx` by `ny` nodes; both counts should be products of small primes, `nx` even.
    pub(super) fn new(nx: usize, ny: usize) -> Self {
        let mut real = RealFftPlanner::new();
        let (real_forward, real_inverse) = (real.plan_fft_forward(nx), real.plan_fft_inverse(nx));
        let columns = (ny > 1).then(|| {
            let mut complex = FftPlanner::new();
            Columns { forward: complex.plan_fft_forward(ny), inverse: complex.plan_fft_inverse(ny) }
        });
        let size = (nx / 2 + 1) * ny;
        let scratch = real_forward.get_scratch_len().max(real_inverse.get_scratch_len());
        let cores = std::thread::available_parallelism().map_or(1, usize::from).min(4);
        Self {
            nx,
            ny,
            real_forward,
            real_inverse,
            columns,
            rows: vec![Complex64::default(); if ny > 1 { size } else { 0 }],
            spectrum: vec![Complex64::default(); size],
            field: vec![0.0; nx * ny],
            scratch: vec![Complex64::default(); scratch],
            threads: if ny > 1 && nx * ny >= PARALLEL_FROM { cores } else { 1 },
        }
    }

    /// Nodes along x.
    pub(super) const fn nx(&self) -> usize {
        self.nx
    }

    /// Nodes along y.
    pub(super) const fn ny(&self) -> usize {
        self.ny
    }

    /// Nodes in all.
    pub(super) const fn len(&self) -> usize {
        self.nx * self.ny
    }

    /// Wave numbers (n_x, n_y) of an entry of the spectrum; the y number is signed.
    pub(super) fn wave_numbers(&self, entry: usize) -> (usize, isize) {
        let (nx, ny) = (entry / self.ny, entry % self.ny);
        (nx, if 2 * ny > self.ny { ny as isize - self.ny as isize } else { ny as isize })
    }

    /// The spectrum of a field.
    pub(super) fn forward(&mut self, input: &[f64]) -> &mut [Complex64] {
        self.field.copy_from_slice(input);
        let half = self.nx / 2 + 1;
        let Some(Columns { forward: columns, .. }) = &self.columns else {
            // The lengths are those of the plan, so the transform cannot fail.
            let _ = self.real_forward.process_with_scratch(&mut self.field, &mut self.spectrum, &mut self.scratch);
            return &mut self.spectrum;
        };
        let (nx, ny, plan) = (self.nx, self.ny, &self.real_forward);
        let share = ny.div_ceil(self.threads);
        in_parallel(self.field.chunks_mut(share * nx).zip(self.rows.chunks_mut(share * half)), |_, (field, rows)| {
            let mut scratch = plan.make_scratch_vec();
            for (from, to) in field.chunks_exact_mut(nx).zip(rows.chunks_exact_mut(half)) {
                let _ = plan.process_with_scratch(from, to, &mut scratch);
            }
        });
        let share = half.div_ceil(self.threads);
        let rows = &self.rows;
        in_parallel(self.spectrum.chunks_mut(share * ny), |part, spectrum| {
            gather(rows, half, part * share, spectrum, ny);
            columns.process(spectrum);
        });
        &mut self.spectrum
    }

    /// The field of the spectrum that [`Transform::forward`] returned (and the caller changed), not normalised.
    pub(super) fn inverse(&mut self, output: &mut [f64]) {
        let half = self.nx / 2 + 1;
        let Some(Columns { inverse: columns, .. }) = &self.columns else {
            real_ends(&mut self.spectrum);
            let _ = self.real_inverse.process_with_scratch(&mut self.spectrum, output, &mut self.scratch);
            return;
        };
        let (nx, ny, plan) = (self.nx, self.ny, &self.real_inverse);
        let share = half.div_ceil(self.threads);
        in_parallel(self.spectrum.chunks_mut(share * ny), |_, spectrum| columns.process(spectrum));
        let share = ny.div_ceil(self.threads);
        let spectrum = &self.spectrum;
        in_parallel(output.chunks_mut(share * nx).zip(self.rows.chunks_mut(share * half)), |part, (field, rows)| {
            let mut scratch = plan.make_scratch_vec();
            gather(spectrum, ny, part * share, rows, half);
            for (to, from) in field.chunks_exact_mut(nx).zip(rows.chunks_exact_mut(half)) {
                real_ends(from);
                let _ = plan.process_with_scratch(from, to, &mut scratch);
            }
        });
    }

    /// `output` = the field whose spectrum is `symbol` times that of `input`; the symbol carries the factor 1/number of nodes.
    pub(super) fn apply(&mut self, symbol: &[Complex64], input: &[f64], output: &mut [f64]) {
        for (value, factor) in self.forward(input).iter_mut().zip(symbol) {
            *value *= factor;
        }
        self.inverse(output);
    }
}

/// The first and last coefficient of a real field are real.
fn real_ends(spectrum: &mut [Complex64]) {
    let last = spectrum.len() - 1;
    spectrum[0].im = 0.0;
    spectrum[last].im = 0.0;
}

/// Rows `first…` of the transpose of `from` (rows of length `width`) into `to` (rows of length `height`), by blocks that stay in cache.
fn gather(from: &[Complex64], width: usize, first: usize, to: &mut [Complex64], height: usize) {
    const BLOCK: usize = 16;
    let count = to.len() / height;
    for start in (0..count).step_by(BLOCK) {
        let stop = (start + BLOCK).min(count);
        for y in 0..height {
            for x in start..stop {
                to[x * height + y] = from[y * width + first + x];
            }
        }
    }
}

/// Does the parts of a job on one thread each (the last one on the present thread).
fn in_parallel<T: Send>(parts: impl Iterator<Item = T>, job: impl Fn(usize, T) + Sync) {
    let mut parts: Vec<T> = parts.collect();
    let last = parts.pop();
    let count = parts.len();
    // What no thread takes is left here for the present one.
    let parts: Vec<Mutex<Option<T>>> = parts.into_iter().map(|part| Mutex::new(Some(part))).collect();
    let take = |index: usize| parts.get(index).and_then(|part| part.lock().ok()?.take());
    std::thread::scope(|scope| {
        let (job, take) = (&job, &take);
        let work = move |index| take(index).into_iter().for_each(|part| job(index, part));
        let refused: Vec<usize> =
            (0..count).filter(|&index| std::thread::Builder::new().spawn_scoped(scope, move || work(index)).is_err()).collect();
        if let Some(part) = last {
            job(count, part);
        }
        refused.into_iter().for_each(work);
    });
}
