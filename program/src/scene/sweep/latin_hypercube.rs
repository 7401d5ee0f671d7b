//! A Latin hypercube (McKay, Beckman and Conover 1979): as many equal parts of each number as there are states, each part taken once.

use crate::scene::catalogue;
use crate::scene::check;
use crate::scene::diagnostic::SceneError;
use crate::scene::document::Node;
use viscotack::special::split_mix::SplitMix;

/// How many states, and the seed of their random numbers.
pub(super) struct Cube {
    states: u32,
    seed: u64,
}

impl Cube {
    /// Reads the table `latin_hypercube`.
    pub(super) fn read(node: &Node) -> Result<Self, SceneError> {
        let Some(states) = node.get("states") else {
            let meaning = catalogue::key("latin_hypercube.states").map_or("", |entry| entry.meaning);
            return Err(SceneError::at(&super::first_line(&node.place), "`latin_hypercube.states` is missing", "in this table")
                .help(format!("latin_hypercube.states: {meaning}")));
        };
        let states = check::count(states, "latin_hypercube.states", 2, 10_000_000)?;
        let seed = node.get("seed").map_or(Ok(0), |seed| check::count(seed, "latin_hypercube.seed", 0, u32::MAX))?;
        Ok(Self { states, seed: seed.into() })
    }

    /// Where each state lies in sweep `number`: a part from 0 to 1 of the way.
    pub(super) fn parts(&self, number: u64) -> Vec<f64> {
        let mut random = SplitMix::of(self.seed, number);
        let mut parts: Vec<f64> = (0..self.states).map(f64::from).collect();
        // Fisher and Yates: every order is as likely.
        for last in (1..parts.len()).rev() {
            let other = ((last + 1) as f64 * part_of(&mut random)) as usize;
            parts.swap(last, other.min(last));
        }
        let count = f64::from(self.states);
        parts.into_iter().map(|part| (part + part_of(&mut random)) / count).collect()
    }
}

/// From 0 up to, but without, 1.
fn part_of(random: &mut SplitMix) -> f64 {
    (random.bits() >> 11) as f64 / (1_u64 << 53) as f64
}
