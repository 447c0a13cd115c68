//! Regular waves of small height on water of a depth d, and the strokes of walls that make them \[dean1991\].
//!
//! ```text
//! ω² = g k tanh kd      c_g = ½ (ω/k) (1 + 2kd/sinh 2kd)
//! piston          H/S = 2 (cosh 2kd − 1)/(sinh 2kd + 2kd)
//! flap on the floor   H/S = 4 (sinh kd/kd) (kd sinh kd − cosh kd + 1)/(sinh 2kd + 2kd)
//! ```
//!
//! H is the height from trough to crest, S the whole stroke at the surface.

/// Part of a wave number within which it is found.
const FOUND: f64 = 1e-14;
/// Rounds of Newton's method at most: it doubles its digits from the first.
const ROUNDS: usize = 50;

/// kd beyond which hyperbolic functions are exponentials to rounding, and would overflow not far from there.
const DEEP: f64 = 300.0;

/// Waves of one period on water at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Waves {
    /// Period \[T\].
    pub period: f64,
    /// Depth of the water \[L\].
    pub depth: f64,
    /// Gravity \[L/T²\].
    pub gravity: f64,
}

impl Waves {
    /// Wave number times depth, the root of `x tanh x = ω²d/g`.
    fn number_times_depth(&self) -> f64 {
        let omega = std::f64::consts::TAU / self.period;
        let wanted = omega * omega * self.depth / self.gravity;
        // Deep and shallow water at once, near enough for Newton's method at every depth.
        let mut x = wanted / libm::tanh(wanted.sqrt()).max(f64::MIN_POSITIVE);
        for _ in 0..ROUNDS {
            let tanh = libm::tanh(x);
            let step = (x * tanh - wanted) / (tanh + x * (1.0 - tanh * tanh));
            x -= step;
            if step.abs() <= FOUND * x {
                break;
            }
        }
        x
    }

    /// Length \[L\].
    pub fn length(&self) -> f64 {
        std::f64::consts::TAU * self.depth / self.number_times_depth()
    }

    /// Velocity of their groups \[L/T\].
    pub fn group_velocity(&self) -> f64 {
        let x = self.number_times_depth();
        0.5 * self.length() / self.period * (1.0 + 2.0 * x / libm::sinh(2.0 * x.min(DEEP)))
    }

    /// Height over the stroke of a piston.
    pub fn of_piston(&self) -> f64 {
        let x = self.number_times_depth();
        if x > DEEP {
            return 2.0;
        }
        2.0 * (libm::cosh(2.0 * x) - 1.0) / (libm::sinh(2.0 * x) + 2.0 * x)
    }

    /// Height over the stroke, at the surface, of a flap that is hinged at the floor.
    pub fn of_flap(&self) -> f64 {
        let x = self.number_times_depth();
        if x > DEEP {
            return 2.0 - 2.0 / x;
        }
        let by_height = x * libm::sinh(x) - libm::cosh(x) + 1.0;
        4.0 * libm::sinh(x) / x * by_height / (libm::sinh(2.0 * x) + 2.0 * x)
    }

    /// The height beyond which they break, `.142 L tanh kd` \[L\].
    pub fn breaking_height(&self) -> f64 {
        0.142 * self.length() * libm::tanh(self.number_times_depth())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn waves(depth: f64) -> Waves {
        Waves { period: 1.0, depth, gravity: 9.81 }
    }

    /// Deep water: L = gT²/2π, c_g half of c, H/S = 2 of a piston; shallow water: c = √(gd), H/S = kd of a piston and half of it of a flap.
    #[test]
    fn limits_of_deep_and_shallow_water() {
        let deep = waves(3.0);
        let length = 9.81 / std::f64::consts::TAU;
        assert!((deep.length() / length - 1.0).abs() < 1e-9);
        assert!((deep.group_velocity() / (0.5 * length) - 1.0).abs() < 1e-6);
        assert!((deep.of_piston() - 2.0).abs() < 1e-6);
        let deepest = waves(3000.0);
        assert!(
            deepest.of_piston() == 2.0
                && (deepest.of_flap() - 2.0).abs() < 1e-3
                && deepest.group_velocity().is_finite()
        );
        let shallow = waves(1e-4);
        let x = std::f64::consts::TAU * 1e-4 / shallow.length();
        assert!((shallow.length() / (9.81_f64 * 1e-4).sqrt() - 1.0).abs() < 1e-4);
        assert!((shallow.of_piston() / x - 1.0).abs() < 1e-3);
        assert!((shallow.of_flap() / (0.5 * x) - 1.0).abs() < 1e-3);
    }

    /// The power of a wave is that of the piston's pressure: over the depth the velocity of the wave, `∫ cosh k(z + d) dz`, balances that of the piston, in
    /// the expansion in modes of the channel whose first term is this one.
    #[test]
    fn the_piston_moves_the_share_of_the_wave_in_its_own_motion() {
        for depth in [0.05, 0.3, 1.0] {
            let own = waves(depth);
            let (k, steps) = (std::f64::consts::TAU / own.length(), 20_000);
            let step = depth / f64::from(steps);
            let at = |i: i32| libm::cosh(k * (f64::from(i) + 0.5) * step);
            let (first, square) =
                (0..steps).fold((0.0, 0.0), |(a, b), i| (a + at(i) * step, b + at(i) * at(i) * step));
            // U = ½ω S of the piston has the part first/square of cosh; a wave of height H has ½ω H/sinh kd of it.
            let height = first / square * libm::sinh(k * depth);
            assert!((own.of_piston() / height - 1.0).abs() < 1e-6);
            let flap = (0..steps).map(|i| at(i) * (f64::from(i) + 0.5) * step / depth * step).sum::<f64>();
            let height = flap / square * libm::sinh(k * depth);
            assert!((own.of_flap() / height - 1.0).abs() < 1e-6);
        }
    }

    /// On both sides of the depth from which exponentials stand for hyperbolic functions, kd = 300, formulas are their limits to rounding, and far beyond finite:
    /// 2 of a piston, 2 − 2/kd of a flap, half of the speed of the wave of the group.
    #[test]
    fn deep_water_joins_its_limit() {
        for depth in [70.0, 74.5, 74.6, 80.0, 1e3, 1e6] {
            let own = waves(depth);
            let x = std::f64::consts::TAU * depth / own.length();
            assert!((own.of_piston() / 2.0 - 1.0).abs() < 1e-14, "{depth}: {}", own.of_piston());
            assert!((own.of_flap() / (2.0 - 2.0 / x) - 1.0).abs() < 1e-14, "{depth}: {}", own.of_flap());
            assert!((own.group_velocity() / (0.5 * own.length()) - 1.0).abs() < 1e-14, "{depth}");
        }
    }
}
