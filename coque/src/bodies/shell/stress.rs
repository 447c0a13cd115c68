//! Stresses at the faces of a homogeneous section, and what von Mises makes of them.

use sph_shell::PointResult;

/// `σ11, σ22, σ12` \[F/L²\] at the face on the side of the director (`side` = 1) or the other (−1):
/// `σ = N/t ± 6M/t²`, the linear course of a homogeneous elastic section.
///
/// Components along the frame of the point, per reference area; membrane strains are assumed small.
pub(crate) fn face(result: &PointResult, thickness: f64, side: f64) -> [f64; 3] {
    let bending = side * 6.0 / (thickness * thickness);
    std::array::from_fn(|i| result.force[i] / thickness + bending * result.moment[i])
}

/// `√(σ11² + σ22² − σ11 σ22 + 3 σ12²)`, plane stress \[F/L²\].
pub(crate) fn von_mises([s11, s22, s12]: [f64; 3]) -> f64 {
    (s11 * s11 + s22 * s22 - s11 * s22 + 3.0 * s12 * s12).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faces_integrate_back_to_the_resultants() {
        let (n, m, t) = ([3.0, -1.0, 0.5], [0.2, 0.4, -0.1], 0.3);
        let result = PointResult { force: n, moment: m, ..PointResult::default() };
        let (top, bottom) = (face(&result, t, 1.0), face(&result, t, -1.0));
        for i in 0..3 {
            // N = t (σ_top + σ_bottom)/2 and M = t² (σ_top − σ_bottom)/12 for a linear course.
            assert!((t * (top[i] + bottom[i]) / 2.0 - n[i]).abs() < 1e-14);
            assert!((t * t * (top[i] - bottom[i]) / 12.0 - m[i]).abs() < 1e-14);
        }
    }

    #[test]
    fn von_mises_of_tension_and_of_shear() {
        assert!((von_mises([-2.0, 0.0, 0.0]) - 2.0).abs() < 1e-15);
        // Pure shear τ, as itself and as ±τ at 45°: √3 τ.
        assert!((von_mises([0.0, 0.0, 1.0]) - 3.0_f64.sqrt()).abs() < 1e-15);
        assert!((von_mises([1.0, -1.0, 0.0]) - 3.0_f64.sqrt()).abs() < 1e-15);
    }
}
