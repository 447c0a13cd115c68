//! The steady vibration of a cantilever by Timoshenko's theory of beams, with a complex stiffness: its transfer functions in closed form.
//!
//! ```text
//! κGA (w″ − θ′) + ρAω² w = 0        EI θ″ + κGA (w′ − θ) + ρIω² θ = 0        E, G → (1 + iη) E, (1 + iη) G
//! w = Σ C e^{kx},  θ = Σ C (k² + a)/k e^{kx}        k⁴ + (a + b) k² + ab − c = 0
//! a = ρω²/κG,  b = ρω²/E,  c = ρAω²/EI
//! ```
//!
//! At the clamp w is that of the base and θ = 0; at the end `EI θ′ = 0` and `κGA (w′ − θ) = −ρAω² Σ C e^{kL}/k` is the force \[timoshenko1921\].

use implicit_statics::Complex;

const ONE: Complex = Complex::new(1.0, 0.0);

/// A cantilever of rectangular section, deflecting along its thickness.
#[derive(Clone, Copy, Debug)]
pub struct ShakenBeam {
    /// Young's modulus \[F/L²\].
    pub young: f64,
    /// Shear modulus times the shear factor \[F/L²\].
    pub shear: f64,
    /// Mass by volume \[M/L³\].
    pub density: f64,
    /// Length \[L\].
    pub length: f64,
    /// Width \[L\].
    pub width: f64,
    /// Thickness \[L\].
    pub thickness: f64,
    /// Loss factor η \[–\].
    pub loss: f64,
}

impl ShakenBeam {
    /// Displacement of the end by a unit of a force there, as `Re[z exp(iωt)]` of a force `cos ωt` \[L/F\].
    pub fn receptance(&self, omega: f64) -> Complex {
        self.end(omega, [0.0, 1.0])
    }

    /// Displacement of the end with respect to the clamp by a unit of the clamp's acceleration \[T²\].
    pub fn relative(&self, omega: f64) -> Complex {
        let base = -1.0 / (omega * omega);
        self.end(omega, [base, 0.0]) + Complex::new(-base, 0.0)
    }

    /// Displacement of the end where the clamp moves and a force acts at the end.
    fn end(&self, omega: f64, [base, force]: [f64; 2]) -> Complex {
        let Self { young, shear, density, length, width, thickness, loss } = *self;
        let section = width * thickness;
        let inertia = density * omega * omega;
        // 1/(1 + iη) of both moduli.
        let soft = over(ONE, Complex::new(1.0, loss));
        let (a, b) = (soft * (inertia / shear), soft * (inertia / young));
        let c = soft * (12.0 * inertia / (young * thickness * thickness));
        let difference = a + b * -1.0;
        let root = root(difference * difference + c * 4.0);
        let squares = [(root + (a + b) * -1.0) * 0.5, (root + a + b) * -0.5];
        let waves = squares.map(self::root).into_iter().flat_map(|k| [k, k * -1.0]);
        // Each wave is one where it is greatest.
        let columns = waves.map(|k| {
            let far = k.re > 0.0;
            let [here, there] = [0.0, length].map(|x| exp(k * (if far { x - length } else { x })));
            let turn = over(k * k + a, k);
            [here, here * turn, there * turn * k, over(there, k) * (-section * inertia), there]
        });
        let columns: Vec<[Complex; 5]> = columns.collect();
        let row = |i: usize| -> [Complex; 4] { std::array::from_fn(|j| columns[j][i]) };
        let right = [base, 0.0, 0.0, force].map(|value| Complex::new(value, 0.0));
        let shares = solved([row(0), row(1), row(2), row(3)], right);
        shares.iter().zip(row(4)).fold(Complex::default(), |sum, (&share, end)| sum + share * end)
    }
}

fn over(a: Complex, b: Complex) -> Complex {
    a * b.under(1.0)
}

fn exp(z: Complex) -> Complex {
    let (sin, cos) = libm::sincos(z.im);
    Complex::new(cos, sin) * libm::exp(z.re)
}

/// The root with a real part that is not negative.
fn root(z: Complex) -> Complex {
    let (sin, cos) = libm::sincos(0.5 * z.phase());
    Complex::new(cos, sin) * z.amplitude().sqrt()
}

/// Elimination with the largest pivot of each column, rows scaled.
fn solved(mut matrix: [[Complex; 4]; 4], mut right: [Complex; 4]) -> [Complex; 4] {
    for (row, value) in matrix.iter_mut().zip(&mut right) {
        let size = row.iter().fold(0.0_f64, |most, z| most.max(z.amplitude()));
        row.iter_mut().chain([value]).for_each(|z| *z = *z * (1.0 / size));
    }
    for k in 0..4 {
        let best = (k..4)
            .fold(k, |best, i| if matrix[i][k].amplitude() > matrix[best][k].amplitude() { i } else { best });
        matrix.swap(k, best);
        right.swap(k, best);
        for i in k + 1..4 {
            let factor = over(matrix[i][k], matrix[k][k]) * -1.0;
            for j in k..4 {
                matrix[i][j] = matrix[i][j] + factor * matrix[k][j];
            }
            right[i] = right[i] + factor * right[k];
        }
    }
    for k in (0..4).rev() {
        let known = (k + 1..4).fold(Complex::default(), |sum, j| sum + matrix[k][j] * right[j]);
        right[k] = over(right[k] + known * -1.0, matrix[k][k]);
    }
    right
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vibration::cantilever_frequency;

    fn beam(thickness: f64, loss: f64) -> ShakenBeam {
        let (young, density) = (2e11, 8000.0);
        ShakenBeam { young, shear: young * 5.0 / 12.0, density, length: 0.5, width: 0.05, thickness, loss }
    }

    /// At rest an end force bends and shears; a clamp that is accelerated loads the beam evenly.
    #[test]
    fn slow_loads_are_those_at_rest() {
        let own = beam(0.05, 0.1);
        let (section, bending) =
            (own.width * own.thickness, own.young * own.width * own.thickness.powi(3) / 12.0);
        let soft = over(ONE, Complex::new(1.0, own.loss));
        let force = soft * (own.length.powi(3) / (3.0 * bending) + own.length / (own.shear * section));
        let even = soft
            * (-own.density
                * section
                * (own.length.powi(4) / (8.0 * bending) + own.length.powi(2) / (2.0 * own.shear * section)));
        for (found, exact) in [(own.receptance(0.5), force), (own.relative(0.5), even)] {
            let error = (found + exact * -1.0).amplitude() / exact.amplitude();
            // Inertia counts by the square of .5 over the first frequency, 660.
            assert!(error < 2e-6, "{error:e}");
        }
    }

    /// `w/F = L³/(EI λ³) (sin λ cosh λ − cos λ sinh λ)/(1 + cos λ cosh λ)` of a slender beam, λ⁴ = ρAω²L⁴/EI.
    #[test]
    fn slender_beams_are_those_of_euler_and_bernoulli() {
        let own = beam(5e-5, 0.0);
        let bending = own.young * own.width * own.thickness.powi(3) / 12.0;
        let first = cantilever_frequency(bending, own.density * own.width * own.thickness, own.length);
        for share in [0.5, 0.99, 3.0, 17.0, 40.0] {
            let omega = share * first;
            let lambda = 1.875_104_068_711_961 * share.sqrt();
            let ((sin, cos), sinh, cosh) = (libm::sincos(lambda), libm::sinh(lambda), libm::cosh(lambda));
            let exact = own.length.powi(3) / (bending * lambda.powi(3)) * (sin * cosh - cos * sinh)
                / (1.0 + cos * cosh);
            // Shear and rotary inertia count by (t/L)² = 1e-8, a hundredfold near the first frequency.
            assert!((own.receptance(omega).re / exact - 1.0).abs() < 1e-5, "{share}");
        }
    }

    /// What the force brings in during a cycle is 2π η times the greatest energy stored, which is above zero: the end lags.
    #[test]
    fn the_end_lags_behind_the_force() {
        let own = beam(0.005, 0.05);
        for omega in [10.0, 100.0, 105.0, 110.0, 650.0, 1000.0, 1800.0] {
            assert!(own.receptance(omega).im < 0.0, "{omega}");
        }
    }
}
