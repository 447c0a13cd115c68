//! Random numbers that are the same on every machine.

/// SplitMix64 of Steele, Lea and Flood \[steele2014\]: eight lines, the same numbers on every machine.
pub(crate) struct SplitMix {
    pub state: u64,
}

impl SplitMix {
    /// Next number of [0, 1).
    pub fn next(&mut self) -> f64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^= z >> 31;
        (z >> 11) as f64 / (1u64 << 53) as f64
    }
}
