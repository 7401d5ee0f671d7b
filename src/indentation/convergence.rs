//! What is left of the error of a number, from its changes over three marches.
//!
//! The steps of a march follow the error of each, so that two marches take different ones and the errors of single numbers scatter: a small last change may be
//! an accident. What falls from march to march is the worst change of all numbers. So the part that one more march would leave is taken from the worst changes,
//! and a number's own last change counts as no less than a regular one would be.

/// Each march is tighter than the one before by this.
pub(super) const TIGHTER: f64 = 0.1;

/// Changes of one number: |finest − second|, and |second − first| where there were three marches.
#[derive(Debug, Clone, Copy)]
pub(super) struct Changes {
    pub(super) last: f64,
    pub(super) before: Option<f64>,
}

impl Changes {
    /// Of a value, by those of the marches before, the newest first; infinite without any.
    pub(super) fn of(value: f64, others: [Option<f64>; 2]) -> Self {
        let last = others[0].map_or(f64::INFINITY, |other| (value - other).abs());
        let before = others[0].zip(others[1]).map(|(second, first)| (second - first).abs());
        Self { last, before }
    }

    fn scaled(self, factor: f64) -> Self {
        Self { last: self.last * factor, before: self.before.map(|before| before * factor) }
    }
}

/// The worst changes so far, over the scales of their quantities.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Convergence {
    last: f64,
    before: f64,
}

impl Convergence {
    /// Takes the changes of a number in; `scale` as of its quantity.
    pub(super) fn see(&mut self, changes: Changes, scale: f64) {
        if scale > 0.0 {
            let changes = changes.scaled(1.0 / scale);
            self.last = self.last.max(changes.last);
            self.before = self.before.max(changes.before.unwrap_or(0.0));
        }
    }

    /// The part of a last change that is left: as the worst changes fell, from a regular tenth to all of it.
    fn left(&self) -> f64 {
        if self.before > 0.0 { (self.last / self.before).clamp(TIGHTER, 1.0) } else { 1.0 }
    }

    /// What is left of the error of a number.
    pub(super) fn remaining(&self, changes: Changes) -> f64 {
        match changes.before {
            Some(before) => self.left() * changes.last.max(TIGHTER * before),
            None => changes.last,
        }
    }
}
