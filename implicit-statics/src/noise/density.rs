//! The power of noise by frequency.

/// One-sided power spectral density over frequency, straight between logarithms; nothing beyond its ends.
#[derive(Clone, Debug, PartialEq)]
pub struct PowerDensity {
    /// `[frequency, density]`, both above zero, frequencies ascending \[1/T, as the square of what it is of by frequency\].
    pub points: Vec<[f64; 2]>,
}

impl PowerDensity {
    /// The density at a frequency \[1/T\].
    pub fn at(&self, frequency: f64) -> f64 {
        let next = self.points.partition_point(|point| point[0] < frequency);
        match (next.checked_sub(1).and_then(|i| self.points.get(i)), self.points.get(next)) {
            (Some([f0, g0]), Some([f1, g1])) => {
                let share = libm::log(frequency / f0) / libm::log(f1 / f0);
                g0 * libm::exp(share * libm::log(g1 / g0))
            }
            (None, Some([first, density])) if *first == frequency => *density,
            _ => 0.0,
        }
    }

    /// Its mean square, in closed form.
    pub fn mean_square(&self) -> f64 {
        let piece = |pair: &[[f64; 2]]| {
            let [[f0, g0], [f1, g1]] = [pair[0], pair[1]];
            let octaves = libm::log(f1 / f0);
            let power = libm::log(g1 / g0) / octaves + 1.0;
            // ∫ g₀ (f/f₀)^(p−1) df, p = 0 of what falls by 1/f.
            let by =
                if (power * octaves).abs() < 1e-12 { octaves } else { libm::expm1(power * octaves) / power };
            g0 * f0 * by
        };
        self.points.windows(2).map(piece).sum()
    }
}
