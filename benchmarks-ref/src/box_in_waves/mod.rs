//! A box that floats in waves: linear potential flow in the plane, by eigenfunctions on either side of the faces of the box \[mei1969, newman1977\].
//!
//! Water of a depth h goes on to both sides without an end. x is counted from the middle of the box, z from the floor, a is half of the breadth of the box, S the height of
//! the gap below it. All goes with `exp(−iωt)`. What is even in x and what is odd are two problems, each on its right half:
//!
//! ```text
//! x > a       φ = φ_I + Σ Aₙ fₙ(z) exp(−κₙ(x − a))      fₙ = cos κₙz/Nₙ      κ₀ = −ik,  ω² = g k tanh kh,  ω² = −g κₙ tan κₙh
//! |x| < a     φ = φ_P + Σ Bₘ cos λₘz {cosh λₘx/cosh λₘa, sinh λₘx/sinh λₘa}      λₘ = mπ/S
//! ```
//!
//! fₙ have the square one over the depth and no products. φ_P moves with the lower face: `(z² − x²)/2S` where the box goes up by a unit of velocity, `(x z² − x³/3)/2S` where it
//! turns by one. The velocity across x = a is that of the gap on 0 < z < S and that of the side of the box above, which gives A by B; that potentials are the same on the
//! gap, weighed by each cos λₘz, gives B.
//!
//! Forces follow from the pressure, `iωρφ`. Where the box moves, they are `−μ a − ν v`, with added mass μ and damping ν: three ways, to the side, up, and the turn about its
//! centre. The velocity at its lower corners is singular, φ ~ r^⅔, which so many terms tell to some tenths of a per cent: by twenty the roll in waves is .4 % off, by forty .15 %, heave and sway .03 %.
//!
//! The response to a wave of unit amplitude is `ξ = [C − ω²(M + μ) − iων]⁻¹ X`, C what buoyancy and mooring give. Let go from rest with flat water, velocities are
//! `(2/π) ∫ Re V cos ωt dω`, `[−iω(M + μ) + ν + iC/ω] V = −iC x₀/ω` \[cummins1962\]. Momentum of the waves far away gives the mean force, `(ρg/2)(1 + |R|² − |T|²) c_g/c`
//! over the square of the amplitude \[maruo1960, newman1977\].

mod matching;

use nalgebra::{Complex, Matrix3, Vector3};

use matching::Matching;

/// A number with a phase, of `exp(−iωt)`.
pub type Phased = Complex<f64>;
/// Sway, heave, roll: to the side of the waves, up, against the clock.
pub type Ways<T> = [T; 3];

const I: Phased = Complex::new(0.0, 1.0);
/// Frequencies of the answer to a start: greatest one over √(g/draught), and their number.
const FREQUENCIES: (f64, usize) = (5.0, 400);

/// A box with the same density all over that floats in water without ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoxInWaves {
    /// Depth of the water \[L\].
    pub depth: f64,
    /// Breadth and height of the box \[L\].
    pub section: [f64; 2],
    /// How deep its lower face lies at rest \[L\].
    pub draught: f64,
    /// Stiffness along x at its centre, over the density of water and by width \[L²/T²\].
    pub mooring: f64,
    /// Gravity \[L/T²\].
    pub gravity: f64,
}

/// What the water does at one frequency, over its density and by width.
#[derive(Clone, Debug)]
pub struct Coefficients {
    /// Circular frequency \[1/T\].
    pub frequency: f64,
    /// Number of the waves \[1/L\].
    pub number: f64,
    /// Speed of their groups \[L/T\].
    pub group: f64,
    /// Added mass \[L²\], with a turn \[L³\], of two \[L⁴\].
    pub added: Matrix3<f64>,
    /// Damping, the same by time.
    pub damping: Matrix3<f64>,
    /// Force and moment of a wave of unit amplitude on the box that is held.
    pub push: Vector3<Phased>,
    /// Waves that go to the right by a unit of velocity.
    pub sent: Ways<Phased>,
    /// What the box that is held sends back, and what goes on behind it.
    pub held: [Phased; 2],
}

/// Response to waves of unit amplitude.
#[derive(Clone, Debug)]
pub struct Response {
    /// Sway, heave, and roll by length.
    pub moved: Vector3<Phased>,
    /// Waves that come back and go on.
    pub waves: [Phased; 2],
    /// Mean force to the side, over ρ \[L²/T²\].
    pub drift: f64,
}

impl BoxInWaves {
    /// What the water does at a circular frequency \[1/T\]; none where the equations have no solution.
    pub fn coefficients(&self, frequency: f64, terms: usize) -> Option<Coefficients> {
        Matching::new(*self, frequency, terms).coefficients()
    }

    /// Righting moment by angle of heel, over ρ and by width \[L⁴/T²\]: what it displaces times its metacentric height and gravity.
    pub fn righting(&self) -> f64 {
        let ([breadth, height], displaced) = (self.section, self.section[0] * self.draught);
        self.gravity * (breadth * breadth * breadth / 12.0 + 0.5 * displaced * (self.draught - height))
    }

    /// Masses and stiffnesses over ρ, by width.
    fn body(&self) -> [Matrix3<f64>; 2] {
        let ([breadth, height], displaced) = (self.section, self.section[0] * self.draught);
        let inertia = displaced * (breadth * breadth + height * height) / 12.0;
        let stiffness = Vector3::new(self.mooring, self.gravity * breadth, self.righting());
        [Vector3::new(displaced, displaced, inertia), stiffness].map(|own| Matrix3::from_diagonal(&own))
    }

    /// Response to waves; `free` says which of the three ways it may go.
    pub fn response(&self, water: &Coefficients, free: Ways<bool>) -> Option<Response> {
        let ([mass, stiffness], omega) = (self.body(), water.frequency);
        let real = stiffness - (mass + water.added) * (omega * omega);
        let mut matrix = real.map(Complex::from) - water.damping.map(Complex::from) * (I * omega);
        let mut push = water.push;
        for way in (0..3).filter(|way| !free[*way]) {
            push[way] = Complex::ZERO;
            for other in 0..3 {
                (matrix[(way, other)], matrix[(other, way)]) = (Complex::ZERO, Complex::ZERO);
            }
            matrix[(way, way)] = Complex::ONE;
        }
        let moved = matrix.lu().solve(&push)?;
        let [sway, heave, roll] = [0, 1, 2].map(|way| -I * omega * moved[way] * water.sent[way]);
        let waves = [water.held[0] + heave - sway - roll, water.held[1] + heave + sway + roll];
        let [back, on] = waves.map(|wave| wave.norm_sqr());
        let drift = 0.5 * self.gravity * (1.0 + back - on) * water.group * water.number / omega;
        Some(Response { moved, waves, drift })
    }

    /// Sway, heave and roll at times, where it is let go from rest in flat water, so far from where it floats.
    pub fn released(&self, start: Ways<f64>, times: &[f64], terms: usize) -> Option<Vec<Ways<f64>>> {
        let [mass, stiffness] = self.body();
        let (most, count) = FREQUENCIES;
        let step = most * (self.gravity / self.draught).sqrt() / count as f64;
        let mut rows = vec![start; times.len()];
        for number in 0..count {
            let omega = (number as f64 + 0.5) * step;
            let water = self.coefficients(omega, terms)?;
            let back = stiffness * Vector3::from(start) / omega;
            let matrix = ((mass + water.added) * -omega + stiffness / omega).map(|part| I * part)
                + water.damping.map(Complex::from);
            let speed = matrix.lu().solve(&back.map(|part| -I * part))?;
            // The integral of cos ωt over time is sin ωt/ω.
            for (row, time) in rows.iter_mut().zip(times) {
                let weight = 2.0 / std::f64::consts::PI * step * libm::sin(omega * time) / omega;
                (0..3).for_each(|way| row[way] += weight * speed[way].re);
            }
        }
        Some(rows)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;
    use crate::floating_box::{FloatingBox, ORDER};

    const BOX: BoxInWaves =
        BoxInWaves { depth: 0.3, section: [0.3, 0.12], draught: 0.06, mooring: 0.0, gravity: 9.81 };
    const FREE: Ways<bool> = [true; 3];

    fn near(found: f64, exact: f64, part: f64) {
        assert!((found - exact).abs() <= part * exact.abs(), "{found} {exact}");
    }

    /// The work of the damping goes out with the waves on both sides, and the force of a wave follows from the waves that the same motion sends towards it
    /// [newman1977]; what is held, what rises alone and what is free sends on what comes. All but rounding.
    #[test]
    fn waves_carry_what_damping_takes_and_push_by_haskinds_relation() {
        for frequency in [3.0, 6.0, 9.0] {
            let water = BOX.coefficients(frequency, 10).unwrap();
            for way in 0..3 {
                let sent = water.sent[way].norm();
                near(water.damping[(way, way)], 2.0 * BOX.gravity * water.group * sent * sent, 1e-10);
                near(water.push[way].norm(), 2.0 * BOX.gravity * water.group * sent, 1e-10);
            }
            for free in [[false; 3], [false, true, false], FREE] {
                let waves = BOX.response(&water, free).unwrap().waves;
                near(waves[0].norm_sqr() + waves[1].norm_sqr(), 1.0, 1e-10);
            }
        }
    }

    /// Sway that turns and roll that pushes are the same, and moments about another centre follow by its distance.
    #[test]
    fn masses_are_reciprocal_and_moments_go_with_the_centre() {
        let (off, one) = (0.05, BOX.coefficients(6.0, 10).unwrap());
        let other = BoxInWaves { section: [0.3, 0.12 + 2.0 * off], ..BOX }.coefficients(6.0, 10).unwrap();
        for (low, high) in [(one.added, other.added), (one.damping, other.damping)] {
            near(low[(0, 2)], low[(2, 0)], 1e-10);
            // A turn about a higher centre is one about the lower with a sway of the distance.
            near(high[(0, 2)], low[(0, 2)] + off * low[(0, 0)], 1e-10);
            near(high[(2, 2)], low[(2, 2)] + 2.0 * off * low[(0, 2)] + off * off * low[(0, 0)], 1e-10);
        }
        assert!((other.push[2] - one.push[2] - one.push[0] * off).norm() < 1e-10 * one.push[0].norm());
    }

    /// In waves a hundred breadths long it goes with the water: up and down by the waves, to and fro by the way of the surface, turned by its slope; the errors go with
    /// the breadth over the length. Nothing comes back.
    #[test]
    fn in_long_waves_it_goes_with_the_water() {
        let frequency = 0.36;
        let water = BOX.coefficients(frequency, 20).unwrap();
        assert!((water.number * BOX.section[0] - TAU / 100.0).abs() < 0.01, "{}", water.number);
        let response = BOX.response(&water, FREE).unwrap();
        near(response.moved[1].norm(), 1.0, 2e-3);
        near(response.moved[0].norm(), 1.0 / libm::tanh(water.number * BOX.depth), 5e-3);
        near(response.moved[2].norm(), water.number, 5e-3);
        assert!(response.waves[0].norm() < 1e-3 && response.drift >= 0.0 && response.drift < 1e-5);
    }

    /// Errors go with the 4/3 of the number of terms: twice as many leave less than half, and twenty .3 %.
    #[test]
    fn terms_converge() {
        let of = |terms| {
            let water = BOX.coefficients(6.3, terms).unwrap();
            let moved = BOX.response(&water, FREE).unwrap().moved;
            [water.added[(0, 0)], water.added[(1, 1)], water.added[(2, 2)], moved[1].norm(), moved[2].norm()]
        };
        let [coarse, middle, fine] = [10, 20, 40].map(of);
        for k in 0..5 {
            let [first, second] = [coarse[k] - middle[k], middle[k] - fine[k]].map(f64::abs);
            assert!(second < 0.5 * first && second < 4e-3 * fine[k], "{k}: {first} {second} {}", fine[k]);
        }
    }

    /// So fast that no wave goes out it has half of the added mass of a square that moves in water without end, 1.5134 π/4 of what it displaces [newman1977]: by the limit of
    /// two numbers of terms .5 % more, which the floor adds.
    #[test]
    fn a_fast_box_has_half_of_the_added_mass_of_a_square() {
        let deep = BoxInWaves { depth: 1.0, section: [0.2, 0.2], draught: 0.1, ..BOX };
        let [coarse, fine] = [20, 40].map(|terms| deep.coefficients(60.0, terms).unwrap().added[(1, 1)]);
        // As deep as that hyperbolic functions are not finite.
        let deeper = BoxInWaves { depth: 1e3, ..deep }.coefficients(60.0, 20).unwrap();
        assert!(deeper.sent.iter().chain(&deeper.held).all(|part| part.norm().is_finite()));
        let limit = fine + (fine - coarse) / (libm::pow(2.0, ORDER) - 1.0);
        near(limit / 0.02, 1.5134 * std::f64::consts::PI / 4.0, 0.01);
    }

    /// Let go it heaves as finite volumes in a wide tank say, before waves are back from its ends. There the water stands lower at the start by what the box has left of
    /// it, all over, and it goes so much lower with it.
    #[test]
    fn it_heaves_as_by_finite_volumes() {
        let tank = FloatingBox { tank: [6.0, 0.4], section: [0.3, 0.1], gravity: 9.81 };
        let lower = 0.3 / 5.7;
        let times: Vec<f64> = (0..=90).map(|i| 0.01 * f64::from(i)).collect();
        let wide = BoxInWaves { depth: 0.4, section: [0.3, 0.2], draught: 0.1, ..BOX };
        let rows = wide.released([0.0, 1.0, 0.0], &times, 10).unwrap();
        let [coarse, fine] = [2, 4].map(|cells| tank.heave(cells, 0.01, 90));
        for i in (10..=90).step_by(10) {
            let limit = fine[i][1] + (fine[i][1] - coarse[i][1]) / (libm::pow(2.0, ORDER) - 1.0);
            let found = (1.0 + lower) * rows[i][1] - lower;
            assert!((found - limit).abs() < 0.01, "{i} {found} {limit}");
        }
    }
}
