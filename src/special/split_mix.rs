//! Numbers from a seed, the same on every machine: splitmix64 (Steele, Lea and Flood, 2014, [10.1145/2714064.2660195](https://doi.org/10.1145/2714064.2660195)).

/// A stream of 64-bit numbers.
#[derive(Debug, Clone)]
pub struct SplitMix(u64);

impl SplitMix {
    /// The stream of a number within a seed: any of them can be made alone, in any order, on any number of threads.
    pub fn of(seed: u64, number: u64) -> Self {
        let mut stream = Self(seed ^ number.wrapping_mul(0xd1b5_4a32_d192_ed03));
        stream.bits();
        stream
    }

    /// The next number.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^ (bits >> 31)
    }
}
