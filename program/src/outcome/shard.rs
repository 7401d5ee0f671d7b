//! A part of the states of a sweep: those whose number leaves a given rest. Many machines solve a part each.

use serde::{Deserialize, Serialize};
use std::fmt;
use std::str::FromStr;

/// The states whose number is `part` modulo `of`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "[usize; 2]", into = "[usize; 2]")]
pub struct Shard {
    part: usize,
    of: usize,
}

impl Default for Shard {
    fn default() -> Self {
        Self::WHOLE
    }
}

impl Shard {
    /// All states.
    pub const WHOLE: Self = Self { part: 0, of: 1 };
    /// No sweep has more states.
    const MOST: usize = 20_000_000;

    /// A part, from 0, of so many.
    #[must_use]
    pub const fn new(part: usize, of: usize) -> Option<Self> {
        if part < of && of <= Self::MOST { Some(Self { part, of }) } else { None }
    }

    /// Whether it is all states.
    #[must_use]
    pub const fn is_whole(self) -> bool {
        self.of == 1
    }

    /// Which part, from 0.
    #[must_use]
    pub const fn part(self) -> usize {
        self.part
    }

    /// Of how many parts.
    #[must_use]
    pub const fn of(self) -> usize {
        self.of
    }

    /// How many of so many states belong to it.
    #[must_use]
    pub const fn states(self, total: usize) -> usize {
        if total > self.part { (total - self.part).div_ceil(self.of) } else { 0 }
    }

    /// The number in the sweep of its state `index`, from 0.
    #[must_use]
    pub const fn state(self, index: usize) -> usize {
        self.part + self.of * index
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}/{}", self.part, self.of)
    }
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers = text.split_once('/').and_then(|(part, of)| Some((part.parse().ok()?, of.parse().ok()?)));
        let (part, of) = numbers.ok_or("write i/n, such as 0/8, which are the states 0, 8, 16 …")?;
        match Self::new(part, of) {
            Some(shard) => Ok(shard),
            None if of == 0 => Err("there must be at least one shard: write 0/1".to_owned()),
            None if of > Self::MOST => Err(format!("at most {} shards", Self::MOST)),
            None => Err(format!("shards are counted from 0: the last of {of} is {}/{of}", of - 1)),
        }
    }
}

impl TryFrom<[usize; 2]> for Shard {
    type Error = String;

    fn try_from([part, of]: [usize; 2]) -> Result<Self, String> {
        Self::new(part, of).ok_or_else(|| format!("{part}/{of} is no shard"))
    }
}

impl From<Shard> for [usize; 2] {
    fn from(shard: Shard) -> Self {
        [shard.part, shard.of]
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::Shard;

    #[test]
    fn each_state_belongs_to_one_shard() {
        for total in [0, 1, 2, 7, 24, 25] {
            for of in [1, 2, 3, 8, 40] {
                let mut states: Vec<usize> = (0..of)
                    .flat_map(|part| {
                        let shard = Shard::new(part, of).unwrap();
                        (0..shard.states(total)).map(move |index| shard.state(index))
                    })
                    .collect();
                states.sort_unstable();
                assert_eq!(states, (0..total).collect::<Vec<_>>(), "{total} states in {of}");
            }
        }
    }

    #[test]
    fn what_is_typed_is_read_or_refused() {
        assert_eq!("2/5".parse(), Ok(Shard::new(2, 5).unwrap()));
        for wrong in ["5/5", "1/0", "-1/3", "1", "a/b", "1/3/4", "0/99999999999", ""] {
            assert!(wrong.parse::<Shard>().is_err(), "{wrong}");
        }
        assert_eq!(serde_json::to_string(&Shard::new(2, 5).unwrap()).unwrap(), "[2,5]");
        assert!(serde_json::from_str::<Shard>("[5,5]").is_err());
    }
}
