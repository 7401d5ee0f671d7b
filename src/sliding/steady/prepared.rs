//! The edge conditions of one speed and adhesion at every level of resolution, prepared once for many contacts.

use crate::material::Material;
use crate::refusal::Refusal;
use crate::sliding::contact::{ContactMemory, Indenter, Resolution};
use crate::sliding::edge_balance::{EdgeBalance, SlidingControl, WaveAdhesion};
use std::cell::RefCell;
use std::sync::Arc;

/// Prepared conditions.
#[derive(Debug)]
pub(in crate::sliding) struct Prepared {
    memory: Arc<ContactMemory>,
    indenter: Indenter,
    adhesion: Option<WaveAdhesion>,
    levels: RefCell<Vec<(Resolution, EdgeBalance)>>,
}

impl Prepared {
    /// Of a material at a rate kv (1/s).
    ///
    /// # Errors
    /// Those of the material at that rate.
    pub(in crate::sliding) fn new(
        material: &Material,
        rate: f64,
        indenter: Indenter,
        adhesion: Option<WaveAdhesion>,
    ) -> Result<Self, Refusal> {
        Ok(Self { memory: Arc::new(ContactMemory::new(material, rate)?), indenter, adhesion, levels: RefCell::new(Vec::new()) })
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
