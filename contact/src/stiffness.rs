//! How stiff a contact is.

/// Share of the square of a sheet's greatest frequency that contact on both of its sides may add.
const SHARE: f64 = 0.2;

/// Stiffness κ of a unit of area \[F/L³\] of a sheet against a rigid tool: `min(2E/t, κ_Δt)`.
///
/// `young` is E \[F/L²\], `thickness` t, `spacing` h \[L\]. What the thickness gives is 2E/t. The fastest motion of a sheet of cells of size h
/// that is thicker than a tenth of h or so is that of its membrane, `ω² ≈ 4 E/(ρ h²)`; contact on both sides adds `2κ/(ρ t)`, which is
/// a fifth of that for `κ_Δt = .4 E t/h²`: steps shorten by `1/√1.2`, to .913.
pub fn stiffness(young: f64, thickness: f64, spacing: f64) -> f64 {
    let [of_thickness, of_step] = bounds(young, thickness, spacing);
    of_thickness.min(of_step)
}

/// Whether what the thickness gives is the lesser of the two bounds of [`stiffness`], not the step in time.
pub fn thickness_bounds(thickness: f64, spacing: f64) -> bool {
    let [of_thickness, of_step] = bounds(1.0, thickness, spacing);
    of_thickness < of_step
}

/// What the thickness gives, and what a step in time bears.
fn bounds(young: f64, thickness: f64, spacing: f64) -> [f64; 2] {
    [2.0 * young / thickness, 0.5 * SHARE * 4.0 * young * thickness / (spacing * spacing)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_smaller_of_both_bounds_holds() {
        assert_eq!(stiffness(1.0, 1.0, 0.1), 2.0);
        assert!((stiffness(1.0, 0.1, 1.0) - 0.04).abs() < 1e-15);
        assert!(thickness_bounds(1.0, 0.1) && !thickness_bounds(0.1, 1.0));
    }
}
