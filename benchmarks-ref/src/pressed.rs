//! Drums and balls pressed on a layer: Hertz's contact of small half width, corrected for the layer and for its images.
//!
//! A layer of height H on a smooth base meets a pressure `cos kx` of its face by a displacement `2 m(kH)/(E* k)`,
//! `m(q) = (cosh 2q − 1)/(sinh 2q + 2q)`, and an even one by `H/M` of it, M the modulus of confined compression. A block whose sides are planes of
//! symmetry a length L apart is a layer with images a length 2L apart: waves `k = nπ/L`, so that no part of the answer is an endless one.
//! The pressure is Hertz's, whose Fourier transform has a closed form; the half width is that at which the face fits the round at its middle and
//! its rim, and what else the layer and the images change of the pressure is of order `(a/L)⁴`.

use libm::{cos, cosh, hypot, j1, sin, sinh};
use std::f64::consts::PI;

/// Half widths times wave numbers up to which waves are summed.
const LAST: f64 = 100.0;
/// The same of balls, whose pressure has waves that fall faster.
const LAST_OF_BALLS: f64 = 40.0;

/// A round rigid tool on a block between planes of symmetry, its base smooth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block {
    /// Young's modulus \[F/L²\].
    pub young: f64,
    /// Poisson's ratio.
    pub poisson: f64,
    /// From the middle of the contact to a side \[L\].
    pub length: f64,
    /// Height \[L\].
    pub height: f64,
    /// Radius of the tool \[L\].
    pub radius: f64,
}

/// What a tool does at an approach.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pressed {
    /// Half width of the contact, or radius \[L\].
    pub half: f64,
    /// Force on the whole contact, of a drum by its length \[F/L\], of a ball \[F\].
    pub force: f64,
    /// Greatest pressure \[F/L²\].
    pub pressure: f64,
    /// How far the tool has come since it touched \[L\].
    pub approach: f64,
}

impl Block {
    /// `E/(1 − ν²)` \[F/L²\].
    pub fn plane_modulus(&self) -> f64 {
        self.young / (1.0 - self.poisson * self.poisson)
    }

    /// Modulus of compression between walls \[F/L²\].
    fn confined(&self) -> f64 {
        self.young * (1.0 - self.poisson) / ((1.0 + self.poisson) * (1.0 - 2.0 * self.poisson))
    }

    /// Displacement of the face by a pressure of a wave number \[L/(F/L²)\].
    fn gives(&self, wave: f64) -> f64 {
        let q = wave * self.height;
        // Beyond, what the base changes is below rounding.
        let layer = if q > 20.0 { 1.0 } else { (cosh(2.0 * q) - 1.0) / (sinh(2.0 * q) + 2.0 * q) };
        2.0 * layer / (self.plane_modulus() * wave)
    }

    /// A drum whose contact has a half width.
    pub fn under_drum(&self, half: f64) -> Pressed {
        let (mut middle, mut falls) = (self.height / (2.0 * self.length * self.confined()), 0.0);
        for n in (1..).map(f64::from) {
            let wave = n * PI / self.length;
            let reach = wave * half;
            if reach > LAST {
                break;
            }
            let part = self.gives(wave) * 2.0 * j1(reach) / (reach * self.length);
            middle += part;
            falls += part * (1.0 - cos(reach));
        }
        let force = half * half / (2.0 * self.radius * falls);
        Pressed { half, force, pressure: 2.0 * force / (PI * half), approach: force * middle }
    }

    /// A ball whose contact has a radius, on a block that is square in plan.
    pub fn under_ball(&self, half: f64) -> Pressed {
        let area = 4.0 * self.length * self.length;
        let (mut middle, mut falls) = (self.height / (area * self.confined()), 0.0);
        let waves = || (0..).map(|n| f64::from(n) * PI / self.length);
        for x in waves().take_while(|x| x * half <= LAST_OF_BALLS) {
            for y in waves().take_while(|y| hypot(x, *y) * half <= LAST_OF_BALLS) {
                let wave = hypot(x, y);
                if wave == 0.0 {
                    continue;
                }
                let reach = wave * half;
                let shape = 3.0 * (sin(reach) - reach * cos(reach)) / (reach * reach * reach);
                let both = |k: f64| if k > 0.0 { 2.0 } else { 1.0 };
                let part = self.gives(wave) * shape * both(x) * both(y) / area;
                middle += part;
                // At the rim, on the mean of both axes.
                falls += part * (1.0 - 0.5 * (cos(x * half) + cos(y * half)));
            }
        }
        let force = half * half / (2.0 * self.radius * falls);
        Pressed { half, force, pressure: 1.5 * force / (PI * half * half), approach: force * middle }
    }

    /// What a tool does that has come a way \[L\], by what it does at a half width.
    pub fn at(&self, approach: f64, of: impl Fn(&Self, f64) -> Pressed) -> Pressed {
        let (mut low, mut high) = (1e-3 * self.length, 0.6 * self.length);
        for _ in 0..40 {
            let half = 0.5 * (low + high);
            if of(self, half).approach < approach { low = half } else { high = half }
        }
        of(self, 0.5 * (low + high))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LARGE: Block = Block { young: 2.0, poisson: 0.3, length: 1.0, height: 1.0, radius: 10.0 };

    /// Force and pressure are Hertz's where the contact is small beside the block; what is left out of a sum of waves, and a block 20 times as
    /// large, are below 4e-3.
    #[test]
    fn a_small_contact_is_that_of_hertz() {
        let (a, modulus, radius) = (0.05, LARGE.plane_modulus(), LARGE.radius);
        let drum = LARGE.under_drum(a);
        assert!((drum.force / (PI * modulus * a * a / (4.0 * radius)) - 1.0).abs() < 4e-3, "{drum:?}");
        assert!((drum.pressure / (0.5 * a * modulus / radius) - 1.0).abs() < 4e-3, "{drum:?}");
        let ball = LARGE.under_ball(a);
        assert!((ball.force / (4.0 / 3.0 * modulus * a * a * a / radius) - 1.0).abs() < 4e-3, "{ball:?}");
        // On a half space the approach is a²/R; the block is stiffer, by a part of the order of a/L.
        let stiffer = 1.0 - ball.approach * radius / (a * a);
        assert!(stiffer > 0.0 && stiffer < a, "{stiffer}");
    }

    /// The approach of a drum grows with the height as that of a layer does under an even pressure, `P/(2 L M)`.
    #[test]
    fn a_higher_block_gives_as_a_column_does() {
        let high = Block { height: 3.0, ..LARGE };
        let higher = Block { height: 4.0, ..LARGE };
        let [a, b] = [high, higher].map(|block| block.under_drum(0.1));
        assert!((b.force / a.force - 1.0).abs() < 1e-6);
        let grown = a.force / (2.0 * LARGE.length * LARGE.confined());
        assert!(((b.approach - a.approach) / grown - 1.0).abs() < 1e-4, "{a:?} {b:?}");
        // And it is the root of its own approach.
        let again = high.at(a.approach, Block::under_drum);
        assert!((again.half / 0.1 - 1.0).abs() < 1e-9, "{again:?}");
    }

    /// The face under Hertz's pressure fits the drum between its middle and its rim too, to a part of the correction itself.
    #[test]
    fn the_face_fits_the_drum_within_the_contact() {
        let a = 0.2;
        let drum = LARGE.under_drum(a);
        let falls = |x: f64| -> f64 {
            let waves = (1..4000).map(|n| f64::from(n) * PI / LARGE.length);
            let part = |wave: f64| {
                LARGE.gives(wave) * 2.0 * j1(wave * a) / (wave * a * LARGE.length) * (1.0 - cos(wave * x))
            };
            drum.force * waves.map(part).sum::<f64>()
        };
        for x in [0.25 * a, 0.5 * a, 0.75 * a] {
            let fits = falls(x) * 2.0 * LARGE.radius / (x * x);
            assert!((fits - 1.0).abs() < 2e-3, "{x}: {fits}");
        }
    }
}
