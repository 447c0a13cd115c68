//! The buckling of a simply supported plate with one bar along its middle: two half plates on a bar, in closed form but for a root.
//!
//! A plate a long and b wide is pressed evenly along a by N by length, and the bar of area A and bending stiffness EI, whose centroid lies in the plane of the plate, by its own
//! share N A/h. In one half wave, `w(y) sin μx` with μ = π/a, either half obeys Kirchhoff's equation with `w = w″ = 0` on its edge. On the bar, at c = b/2, it has no slope, and
//! the halves hand over their shear forces \[timoshenko1961, §9.11\]:
//!
//! ```text
//! r = √(N/D)     α² = μ(r + μ)     β² = μ(r − μ)
//! w = β cos βc sinh αy − α cosh αc sin βy
//! (EI μ⁴ − N (A/h) μ²) w(c) = 2D w‴(c) = 2D αβ(α² + β²) cos βc cosh αc
//! ```

use std::f64::consts::PI;

/// `k = N b²/π²D` for `a/b`, `γ = EI/bD` and `δ = A/bh`, where the plate bends with the bar: below that at which its halves buckle by themselves.
///
/// # Panics
/// For stiffnesses without a root between that of half a wave along the plate and that of halves: the bar does not bend then.
pub fn coefficient(aspect: f64, gamma: f64, delta: f64) -> f64 {
    let (mu, c) = (PI / aspect, 0.5);
    let lack = |k: f64| {
        let load = k * PI * PI;
        let root = load.sqrt();
        let (alpha, beta) = ((mu * (root + mu)).sqrt(), (mu * (root - mu)).sqrt());
        let [sinh, cosh] = [libm::sinh(alpha * c), libm::cosh(alpha * c)];
        let [sin, cos] = [libm::sin(beta * c), libm::cos(beta * c)];
        let bent = beta * cos * sinh - alpha * cosh * sin;
        let pushed = alpha * beta * (alpha * alpha + beta * beta) * cos * cosh;
        (gamma * mu.powi(4) - load * delta * mu * mu) * bent - 2.0 * pushed
    };
    // Without a bar the plate buckles in one wave across, held on it its halves do in one each.
    let plate = |waves: f64| (1.0 / aspect + waves * waves * aspect).powi(2);
    let (mut low, mut high) = (plate(1.0) / (1.0 + delta), plate(2.0));
    low = low.max((1.0 / aspect).powi(2) * (1.0 + 1e-9));
    assert!(lack(low) * lack(high) < 0.0, "no root of γ = {gamma}, δ = {delta}");
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if lack(low) * lack(middle) > 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The energy of two sines across, `sin πy/b + r sin 3πy/b`, least over r, is an upper bound, near by as the next of them is small.
    fn two_terms(aspect: f64, gamma: f64, delta: f64) -> f64 {
        let square = aspect * aspect;
        let of = |r: f64| {
            let on_bar = (1.0 - r).powi(2);
            let stored = (1.0 + square).powi(2) + (r * (1.0 + 9.0 * square)).powi(2) + 2.0 * gamma * on_bar;
            stored / (square * (1.0 + r * r + 2.0 * delta * on_bar))
        };
        (-400..=400).map(|i| of(f64::from(i) / 1000.0)).fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn two_terms_of_a_series_lie_a_little_above() {
        for (aspect, gamma, delta) in [
            (0.8, 5.0, 0.1),
            (1.0, 5.0, 0.05),
            (1.0, 5.0, 0.1),
            (1.0, 5.0, 0.2),
            (1.2, 5.0, 0.05),
            (1.2, 5.0, 0.2),
        ] {
            let (found, bound) = (coefficient(aspect, gamma, delta), two_terms(aspect, gamma, delta));
            assert!(found < bound && found > 0.97 * bound, "{aspect} {gamma} {delta}: {found} {bound}");
        }
    }

    /// Without a bar: 4 of a square.
    #[test]
    fn a_plate_without_a_bar_is_that_of_bryan() {
        assert!((coefficient(1.0, 1e-9, 1e-12) / 4.0 - 1.0).abs() < 1e-6);
    }
}
