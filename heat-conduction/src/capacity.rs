//! What parameters store by degree: each by itself, or in pairs as well.

/// A symmetric matrix of capacities \[F L/Θ\].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Capacity {
    /// Of each parameter by its own degrees.
    pub own: Vec<f64>,
    /// Of two parameters, each by degrees of the other; none where every parameter stores by itself.
    pub pairs: Vec<(u32, u32, f64)>,
}

impl Capacity {
    /// Heat that each parameter stores as it is warmer by so much \[F L\].
    pub(crate) fn stored(&self, warmer: &[f64]) -> Vec<f64> {
        let mut out: Vec<f64> = self.own.iter().zip(warmer).map(|(own, warmer)| own * warmer).collect();
        for &(a, b, c) in &self.pairs {
            out[a as usize] += c * warmer[b as usize];
            out[b as usize] += c * warmer[a as usize];
        }
        out
    }

    /// The same by magnitudes.
    pub(crate) fn sizes(&self, sizes: &[f64]) -> Vec<f64> {
        let mut out: Vec<f64> = self.own.iter().zip(sizes).map(|(own, size)| own * size.abs()).collect();
        for &(a, b, c) in &self.pairs {
            out[a as usize] += (c * sizes[b as usize]).abs();
            out[b as usize] += (c * sizes[a as usize]).abs();
        }
        out
    }
}
