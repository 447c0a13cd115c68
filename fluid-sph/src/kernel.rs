//! The kernel: Wendland's C2 \[wendland1995\], of support 2h, without a division.

/// Wendland's kernel of one smoothing length: `W = α (1 − q/2)⁴ (2q + 1)`, `q = r/h ≤ 2`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Wendland {
    /// Smoothing length h \[L\].
    pub h: f64,
    /// `1/(2h)` \[1/L\].
    pub half: f64,
    /// α: `7/(4πh²)` in a plane \[1/L²\], `21/(16πh³)` in space \[1/L³\].
    pub scale: f64,
    /// `∇W = F r`, `F = slope (1 − q/2)³`: slope = −5α/h².
    pub slope: f64,
    /// η² = 0.01 h² of quotients by a distance \[L²\].
    pub eta2: f64,
    /// 4h² \[L²\].
    pub reach2: f64,
}

impl Wendland {
    /// The kernel of a smoothing length in a plane or in space.
    pub fn new(dimensions: usize, h: f64) -> Self {
        let pi = std::f64::consts::PI;
        let scale = if dimensions == 2 { 7.0 / (4.0 * pi * h * h) } else { 21.0 / (16.0 * pi * h * h * h) };
        Self {
            h,
            half: 0.5 / h,
            scale,
            slope: -5.0 * scale / (h * h),
            eta2: 0.01 * h * h,
            reach2: 4.0 * h * h,
        }
    }

    /// 2h \[L\].
    pub fn reach(&self) -> f64 {
        2.0 * self.h
    }

    /// The kernel at a distance.
    pub fn value(&self, distance: f64) -> f64 {
        let s = (1.0 - self.half * distance).max(0.0);
        let square = s * s;
        self.scale * (square * square) * (2.0 * distance / self.h + 1.0)
    }

    /// F at a distance.
    pub fn factor(&self, distance: f64) -> f64 {
        let s = (1.0 - self.half * distance).max(0.0);
        self.slope * (s * s * s)
    }

    /// ∂F/∂r at a distance.
    pub fn factor_slope(&self, distance: f64) -> f64 {
        let s = (1.0 - self.half * distance).max(0.0);
        -3.0 * self.half * self.slope * (s * s)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The midpoint rule of 4000 rings has an error of 1e-7.
    #[test]
    fn its_integral_is_one_and_its_factor_is_its_derivative() {
        for dimensions in [2, 3] {
            let kernel = Wendland::new(dimensions, 0.7);
            let rings = 4000;
            let width = 1.4 / rings as f64;
            let ring = |k: usize| {
                let r = (k as f64 + 0.5) * width;
                let around = std::f64::consts::PI * if dimensions == 2 { 2.0 * r } else { 4.0 * r * r };
                around * kernel.value(r) * width
            };
            let sum: f64 = (0..rings).map(ring).sum();
            assert!((sum - 1.0).abs() < 1e-6, "{dimensions}: {sum}");
            for r in [0.1, 0.5, 1.2] {
                let slope = (kernel.value(r + 1e-5) - kernel.value(r - 1e-5)) / 2e-5;
                assert!((slope - kernel.factor(r) * r).abs() < 1e-8 * kernel.scale / kernel.h, "{r}");
            }
        }
    }
}
