//! What is imposed at once: a step, a relaxed start, a contact that is lost with its force.

use super::course::Course;
use super::drive::DEGREE;
use super::law::Law;
use crate::indentation::history::Controlled;
use crate::refusal::Refusal;

impl Course<'_> {
    /// The contact is lost with its force.
    pub(super) fn let_go(&mut self) -> Result<(), Refusal> {
        let depth = self.line.penetration - self.line.pressing_at(0.0);
        self.line.leap(depth, None)?;
        self.line.release_all();
        Ok(())
    }

    /// Meets an imposed value at once.
    pub(super) fn settle(&mut self, controlled: Controlled, value: f64) -> Result<(), Refusal> {
        let (asked, unit) = self.asked(controlled);
        let pulls = matches!(controlled, Controlled::Force | Controlled::ContactRadius);
        let open = self.line.radius() == 0.0;
        let depth = if controlled == Controlled::Penetration
            || (open && controlled == Controlled::Frame && value <= self.line.surface_after(0.0))
        {
            value
        } else if pulls && value <= 0.0 {
            return if open { Ok(()) } else { self.let_go() };
        } else if open && self.line.profile.is_flat() {
            // All of a punch is touched at once: from where it touches.
            self.line.went_to(self.line.surface_after(0.0));
            self.line.touch_rim();
            return self.settle(controlled, value);
        } else {
            let law = Law::new(&self.line, self.fresh, 0.0);
            self.evaluations += 1;
            let met = law.met(asked, &[unit * value; DEGREE], None)?;
            met.ok_or_else(|| Refusal::NotConverged { what: "a step", detail: format!("at t = {:e}", self.now()) })?.depths[DEGREE - 1]
        };
        self.line.leap(depth, (controlled == Controlled::ContactRadius).then_some(value))?;
        if controlled == Controlled::Frame && self.line.radius() == 0.0 {
            // Nothing carries any more: the frame takes the indenter along.
            self.line.went_to(value);
        }
        Ok(())
    }

    /// A contact that has been held at a value until it has relaxed.
    pub(super) fn relaxed(&mut self, controlled: Controlled, value: f64) -> Result<(), Refusal> {
        let modulus = self.chain.relaxed;
        if modulus == 0.0 && value > 0.0 {
            return Err(Refusal::Undefined {
                quantity: "the relaxed contact",
                reason: "the material has no relaxed modulus: it flows for ever; start untouched and hold".into(),
            });
        }
        let depth = match controlled {
            Controlled::Penetration => value,
            Controlled::ContactRadius => self.line.profile.line(value),
            Controlled::Force => self.fresh.depth(0.5 * value / modulus)?,
            Controlled::Frame => {
                // Δ + 2E0*Φ/k_f = value: the load rises with Δ.
                let stiffness = self.problem.frame_stiffness.unwrap_or(f64::INFINITY);
                let (mut low, mut high) = (value.min(0.0), value);
                for _ in 0..200 {
                    let middle = 0.5 * (low + high);
                    let deeper = self.fresh.depth(0.5 * stiffness * (value - middle) / modulus).map_or(true, |depth| depth > middle);
                    if deeper { low = middle } else { high = middle }
                }
                if value > 0.0 { 0.5 * (low + high) } else { value }
            }
        };
        self.line.rested(depth)
    }
}
