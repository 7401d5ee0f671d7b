//! The edge conditions of one speed and adhesion at every level of resolution, and its equilibrium curve, prepared once for many contacts.

use crate::material::PlaneMaterial;
use crate::refusal::Refusal;
use crate::sliding::contact::{ContactMemory, Indenter, Resolution};
use crate::sliding::edge_balance::{EdgeBalance, SlidingControl, WaveAdhesion};
use crate::sliding::equilibrium::{ContactsOfWidth, EquilibriumCurve};
use std::cell::RefCell;
use std::rc::Rc;
use std::sync::Arc;

/// The resolution of the curve: about seven digits.
const CURVE: Resolution = Resolution::Medium;

thread_local! {
    /// The material of the last contact, and what was prepared for it.
    static LAST: RefCell<Option<(PlaneMaterial, Rc<Prepared>)>> = const { RefCell::new(None) };
}

/// Prepared conditions.
#[derive(Debug)]
pub(in crate::sliding) struct Prepared {
    memory: Arc<ContactMemory>,
    indenter: Indenter,
    adhesion: Option<WaveAdhesion>,
    rate: f64,
    levels: RefCell<Vec<(Resolution, EdgeBalance)>>,
    /// With the size that it was asked for.
    curve: RefCell<Option<(f64, Rc<EquilibriumCurve>)>>,
}

impl Prepared {
    /// Of a material at a rate kv (1/s).
    ///
    /// # Errors
    /// Those of the material at that rate.
    pub(in crate::sliding) fn new(
        material: &PlaneMaterial,
        rate: f64,
        indenter: Indenter,
        adhesion: Option<WaveAdhesion>,
    ) -> Result<Self, Refusal> {
        let memory = Arc::new(ContactMemory::new(material, rate)?);
        Ok(Self { memory, indenter, adhesion, rate, levels: RefCell::new(Vec::new()), curve: RefCell::new(None) })
    }

    /// The same, shared with the last contact of this thread where nothing but what is held differs: the loads of one speed share its curve.
    ///
    /// # Errors
    /// As [`Prepared::new`].
    pub(super) fn shared(
        material: &PlaneMaterial,
        rate: f64,
        indenter: Indenter,
        adhesion: Option<WaveAdhesion>,
    ) -> Result<Rc<Self>, Refusal> {
        LAST.with_borrow_mut(|last| {
            if let Some((of, prepared)) = last
                && of == material
                && (prepared.rate.to_bits(), prepared.indenter, prepared.adhesion) == (rate.to_bits(), indenter, adhesion)
            {
                prepared.forget_counts();
                return Ok(Rc::clone(prepared));
            }
            let prepared = Rc::new(Self::new(material, rate, indenter, adhesion)?);
            *last = Some((material.clone(), Rc::clone(&prepared)));
            Ok(prepared)
        })
    }

    /// A contact that was refused leaves counts of its checks on the curve: they are not work of the next one, which would then depend on the one before it.
    fn forget_counts(&self) {
        if let Some((_, curve)) = &*self.curve.borrow() {
            curve.evaluations();
        }
    }

    /// kv (1/s).
    pub(super) const fn rate(&self) -> f64 {
        self.rate
    }

    /// Whether nothing is remembered at this rate.
    pub(super) fn is_elastic(&self) -> bool {
        self.memory.kernel().terms().is_empty()
    }

    /// The contacts of any half-width.
    pub(super) fn contacts_of_width(&self) -> ContactsOfWidth {
        ContactsOfWidth::new(self.curve_balance())
    }

    /// The conditions of the curve, whatever is held.
    pub(super) fn curve_balance(&self) -> EdgeBalance {
        self.balance(SlidingControl::MeanPressure(0.0), CURVE)
    }

    /// The equilibrium curve; of a cylinder around a half-width.
    pub(super) fn curve(&self, size: f64) -> Rc<EquilibriumCurve> {
        if let Some((known, curve)) = &*self.curve.borrow()
            && (known.to_bits() == size.to_bits() || self.indenter == Indenter::Wave)
        {
            return Rc::clone(curve);
        }
        let curve = Rc::new(EquilibriumCurve::new(self.curve_balance(), size));
        *self.curve.borrow_mut() = Some((size, Rc::clone(&curve)));
        curve
    }

    /// The conditions under a control at a level.
    pub(in crate::sliding) fn balance(&self, control: SlidingControl, resolution: Resolution) -> EdgeBalance {
        let mut levels = self.levels.borrow_mut();
        if let Some((_, balance)) = levels.iter().find(|(level, _)| *level == resolution) {
            return balance.under(control);
        }
        let balance = EdgeBalance::new(Arc::clone(&self.memory), self.indenter, self.adhesion, control, resolution);
        levels.push((resolution, balance.clone()));
        balance
    }
}
