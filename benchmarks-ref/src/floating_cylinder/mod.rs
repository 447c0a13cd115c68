//! A circular cylinder that floats half immersed and heaves, by linear potential flow in the plane: in deep water without ends, and in a tank.
//!
//! **Led up and down** in deep water, by a source and multipoles that send no waves \[ursell1949\]. Lengths are over the radius a, circular frequencies u over √(g/a), times τ over
//! √(a/g); K = u². z is down, ζ = z + ix = r exp(iθ) a complex number whose i is not that of exp(−iuτ), here j:
//!
//! ```text
//! φ = A Re[−exp(−Kζ) Ei(Kζ) + jπ exp(−Kζ)] + Σ Aₘ Re[ζ^(−2m) + K/(2m − 1) ζ^(−(2m−1))]      ψ = sin θ on r = 1
//! 1 + Λ = 1 − (4/π) ∫₀^{π/2} φ cos θ dθ
//! ```
//!
//! ψ is the imaginary part of the same, and the condition is met by least squares. The real part of Λ is the added mass over what the cylinder displaces, `½ρπa²`, its imaginary part
//! the damping over that and the frequency. The waves on either side have the height πK/|A| for one of the motion.
//!
//! **Let go** at rest from a height y₀, over flat water, it is at y₀ h₂(τ) \[ursell1964, maskell1970\]:
//!
//! ```text
//! h₂ = −(i/8) ∫ u(1 + Λ) exp(−iuτ)/D du = (2/π) ∫₀^∞ Im(1/D)/u cos uτ du      D = 1 − ¼π u² (1 + Λ)      h₂ ~ −4/(πτ²)
//! ```
//!
//! the second since nothing moves before. **In a tank** ([`Tank`]) the same by boundary elements: level and depth change the motion far more than they change its period.

mod tank;

use std::f64::consts::{FRAC_PI_2, PI};

use nalgebra::{Complex, DMatrix};

pub use tank::Tank;

/// Euler's constant.
const EULER: f64 = 0.577_215_664_901_532_9;
/// Frequencies of the motion from a start, in √(g/a): the greatest, and their number.
const FREQUENCIES: (f64, usize) = (3.0, 400);

/// What the water does to a cylinder that is led up and down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Led {
    /// Added mass over what the cylinder displaces \[–\].
    pub added: f64,
    /// Damping over what it displaces and √(g/a) \[–\].
    pub damping: f64,
    /// Amplitude of the waves over that of the motion \[–\].
    pub waves: f64,
}

/// The complex exponential integral Ei on the right half of the plane, by its series: `|z|` of a few units loses no digit that counts.
fn exponential_integral(z: Complex<f64>) -> Complex<f64> {
    let (mut sum, mut term) = (z.ln() + EULER, Complex::ONE);
    let most = 20 + 4 * libm::ceil(z.norm()) as usize;
    for n in 1..=most {
        term *= z / n as f64;
        sum += term / n as f64;
    }
    sum
}

/// The cylinder led at a frequency over √(g/a), with so many multipoles; none where the equations have no solution. Errors go with the square of the multipoles: twelve
/// leave .06 % of the waves up to 1, .4 % at 2.
pub fn led(frequency: f64, multipoles: usize) -> Option<Led> {
    let number = frequency * frequency;
    // Close to the surface, where the flow turns, places are closer by the square.
    let places = 2 * multipoles;
    let at = |j: usize| {
        let s = FRAC_PI_2 * (j as f64 + 0.5) / places as f64;
        (FRAC_PI_2 * libm::sin(s), FRAC_PI_2 * libm::cos(s) * FRAC_PI_2 / places as f64)
    };
    let (mut flows, mut given) = (DMatrix::zeros(places, multipoles + 1), DMatrix::zeros(places, 2));
    let mut potentials = DMatrix::zeros(places, multipoles + 1);
    let mut sources = vec![[0.0; 2]; places];
    for j in 0..places {
        let angle = at(j).0;
        let z = Complex::from_polar(number, angle);
        let wave = (-z).exp();
        let source = [-wave * exponential_integral(z), wave * PI];
        for k in 0..2 {
            given[(j, k)] = -source[k].im;
            sources[j][k] = source[k].re;
        }
        for m in 1..=multipoles {
            let (even, odd) = ((2 * m) as f64, (2 * m - 1) as f64);
            let pole =
                Complex::from_polar(1.0, -even * angle) + Complex::from_polar(number / odd, -odd * angle);
            flows[(j, m - 1)] = pole.im;
            potentials[(j, m - 1)] = pole.re;
        }
        // The source is taken as one: the amplitude of the motion is what is sought.
        flows[(j, multipoles)] = -libm::sin(angle);
    }
    let found = flows.svd(true, true).solve(&given, 0.0).ok()?;
    let potentials = &potentials * &found;
    let moved = Complex::new(found[(multipoles, 0)], found[(multipoles, 1)]);
    let force: Complex<f64> = (0..places)
        .map(|j| {
            let (angle, width) = at(j);
            let part = |k: usize| sources[j][k] + potentials[(j, k)];
            Complex::new(part(0), part(1)) * (width * libm::cos(angle))
        })
        .sum();
    let force = force / moved * (-4.0 / PI);
    Some(Led { added: force.re, damping: force.im * frequency, waves: PI * number / moved.norm() })
}

/// The height at times over √(a/g), over the one at the start, of a cylinder that is let go at rest; none where the equations have no solution.
pub fn released(times: &[f64], multipoles: usize) -> Option<Vec<f64>> {
    let (most, count) = FREQUENCIES;
    let step = most / count as f64;
    let mut heights = vec![0.0; times.len()];
    for number in 0..count {
        let u = (number as f64 + 0.5) * step;
        let water = led(u, multipoles)?;
        let below =
            Complex::new(1.0 - 0.25 * PI * u * u * (1.0 + water.added), -0.25 * PI * u * water.damping);
        let weight = 2.0 / PI * step * below.inv().im / u;
        heights.iter_mut().zip(times).for_each(|(height, time)| *height += weight * libm::cos(u * time));
    }
    Some(heights)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::reference;
    use crate::floating_box::crossings;

    fn near(found: f64, exact: f64, part: f64) {
        assert!((found - exact).abs() <= part * exact.abs(), "{found} {exact}");
    }

    /// Ei on the real axis, and Ci + i(Si + π/2) on the imaginary one.
    #[test]
    fn the_exponential_integral_has_its_published_values() {
        let of = |x: f64, y: f64| exponential_integral(Complex::new(x, y));
        near(of(1.0, 0.0).re, 1.895_117_816_355_936_8, 1e-14);
        near(of(9.0, 0.0).re, 1_037.878_290_717_09, 1e-14);
        near(of(0.0, 1.0).re, 0.337_403_922_900_968_1, 1e-14);
        near(of(0.0, 1.0).im, 0.946_083_070_367_183 + FRAC_PI_2, 1e-14);
    }

    /// The power of the damping goes out with the waves on both sides, which two numbers of multipoles keep the better the more there are.
    #[test]
    fn waves_carry_what_damping_takes() {
        for u in [0.3, 0.6, 0.9, 1.2, 1.5] {
            let missing = |multipoles| {
                let Led { damping, waves, .. } = led(u, multipoles).unwrap();
                (waves * waves / (FRAC_PI_2 * u * u * u * damping) - 1.0).abs()
            };
            let [coarse, fine] = [12, 24].map(missing);
            assert!(fine < 0.4 * coarse && fine < 1e-3, "{u} {coarse} {fine}");
        }
    }

    /// So slow that it only takes and gives back water the waves have 2Ka of its height. So fast that none go out φ = −cos θ/r, zero on the surface, is half of the flow about a
    /// whole cylinder: the added mass is what is displaced. What moves the surface a little takes ρ/K ∫ (∂φ/∂z)² dx of that, both sides 2/(3K).
    #[test]
    fn slow_it_is_a_source_and_fast_half_of_a_whole_cylinder() {
        for u in [0.03, 0.06] {
            // What is left goes with Ka and its logarithm.
            near(led(u, 24).unwrap().waves / (u * u), 2.0, 6.0 * u * u);
        }
        let [one, other] = [2.5_f64, 3.5].map(|u| (1.0 - led(u, 24).unwrap().added) * u * u);
        near(one, 4.0 / (3.0 * PI), 0.2);
        near(other, 4.0 / (3.0 * PI), 0.1);
    }

    /// Vugts' measured points, from .6 on: below it waves are longer than his tank was deep.
    #[test]
    fn it_is_what_vugts_measured() {
        let off = |name: &str, column: &str, of: fn(Led) -> f64| {
            let table = reference(name).unwrap();
            let (at, found) = (table.column("frequency").unwrap(), table.column(column).unwrap());
            let squares: Vec<f64> = at
                .iter()
                .zip(&found)
                .filter(|(u, _)| **u > 0.6)
                .map(|(u, found)| libm::pow(found - of(led(*u, 12).unwrap()), 2.0))
                .collect();
            assert!(squares.len() >= 16);
            (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
        };
        let added = off("vugts_heave_added_mass", "added_mass", |led| led.added);
        let damping = off("vugts_heave_damping", "damping", |led| led.damping);
        println!("added mass {added:.4}, damping {damping:.4}");
        assert!(added < 0.03 && damping < 0.02, "{added} {damping}");
    }

    /// It begins at one, at rest, and ends as −4/(πτ²) [ursell1964].
    #[test]
    fn it_begins_at_rest_and_ends_without_swinging() {
        let times = [0.0, 0.01, 0.02, 85.0, 90.0];
        let heights = released(&times, 12).unwrap();
        near(heights[0], 1.0, 1e-4);
        // −y'' at the start: what buoyancy gives over what moves, which is twice what is displaced.
        near((heights[0] - heights[2]) / (0.5 * 0.02 * 0.02), 2.0 / PI, 0.01);
        near((heights[0] - heights[1]) / (0.5 * 0.01 * 0.01), 2.0 / PI, 0.01);
        for i in [3, 4] {
            near(heights[i], -4.0 / (PI * times[i] * times[i]), 0.05);
        }
    }

    /// Two hundred radii to both walls and a hundred to the floor: the motion is that of water without ends.
    #[test]
    fn in_a_wide_and_deep_tank_it_moves_as_in_water_without_ends() {
        let rows = Tank { half: 200.0, depth: 100.0 }.released(0.06, 0.05, 200).unwrap();
        let times: Vec<f64> = rows.iter().map(|row| row[0]).collect();
        let free = released(&times, 12).unwrap();
        let most = rows.iter().zip(&free).map(|(row, free)| (row[1] - free).abs()).fold(0.0, f64::max);
        let exact: Vec<[f64; 2]> = times.iter().zip(&free).map(|(time, free)| [*time, *free]).collect();
        println!("{most} {:?} {:?}", crossings(&rows), crossings(&exact));
        assert!(most < 2e-3, "{most}");
    }

    /// Half the pieces, a quarter of what the added mass lacks; less than a thousandth of the motion.
    #[test]
    fn pieces_converge() {
        let tank = Tank { half: 30.0, depth: 10.0 };
        let [coarse, middle, fine] = [0.12, 0.06, 0.03].map(|size| tank.added_mass(size).unwrap());
        println!("{coarse} {middle} {fine}");
        assert!((middle - fine).abs() < 0.6 * (coarse - middle).abs() && (middle - fine).abs() < 2e-3);
        let [coarse, fine] = [0.06, 0.03].map(|size| tank.released(size, 0.05, 200).unwrap());
        let most = coarse.iter().zip(&fine).map(|(a, b)| (a[1] - b[1]).abs()).fold(0.0, f64::max);
        println!("{most} {:?} {:?}", crossings(&coarse), crossings(&fine));
        assert!(most < 1e-3, "{most}");
    }
}
