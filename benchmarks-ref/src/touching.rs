//! What touches rigid tools, itself or another: a ring between plates and under pressure, a strip on a cylinder, by the inextensible elastica;
//! two cantilevers; friction on an incline and a drum.

use libm::{cos, exp, sin, sqrt};

use crate::catalogue::{Reference, reference};
use crate::error::ReferenceError;

/// Distance of the mid-surfaces H/R at which a ring between plates flattens, and its force P R²/B there.
pub const FLATTENS: [f64; 2] = [1.435_540_022_092_259_4, 2.786_407_859_371_354_6];
/// P H²/B from there on.
const FLAT: f64 = 5.742_160_09;
/// Panels of the quadrature.
const PANELS: u32 = 400;

/// Length of a quarter over R, and half of the height H/R, of an arc whose curvature is `κ² = κ₀² + p sin θ`: `∫ dθ/κ` and
/// `∫ sin θ dθ/κ` over a right angle. By θ = s², which takes the root at κ₀ = 0, and Simpson's rule.
fn quarter(start: f64, force: f64) -> [f64; 2] {
    let end = sqrt(std::f64::consts::FRAC_PI_2);
    let h = end / f64::from(2 * PANELS);
    let mut sums = [0.0; 2];
    for i in 0..=2 * PANELS {
        let s = h * f64::from(i);
        let sine = sin(s * s);
        let curvature = sqrt(start * start + force * sine);
        // At κ₀ = 0 the integrand has the limit 2/√p.
        let part = if curvature > 0.0 { 2.0 * s / curvature } else { 2.0 / sqrt(force) };
        let weight = if i == 0 || i == 2 * PANELS { 1.0 } else { 2.0 + 2.0 * f64::from(i % 2) };
        sums[0] += weight * part * h / 3.0;
        sums[1] += weight * part * sine * h / 3.0;
    }
    sums
}

/// Halves an interval until the root of a rising function is known to rounding.
fn root(mut low: f64, mut high: f64, lack: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if lack(middle) < 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// Force P R²/B of a unit of width on a ring that is pressed to a distance H/R of its mid-surfaces between smooth plates.
///
/// A quarter has the length π/2 R: that gives κ₀ by p, and p by the height. From H/R = 1.43554 on it lies flat on the plates.
pub fn pressed_ring(height: f64) -> f64 {
    if height <= FLATTENS[0] {
        return FLAT / (height * height);
    }
    let start = |force: f64| root(0.0, 1.0, |start| std::f64::consts::FRAC_PI_2 - quarter(start, force)[0]);
    root(0.0, FLATTENS[1], |force| 0.5 * height - quarter(start(force), force)[1])
}

/// A cantilever of length one on top of a cylinder whose mid-surface radius is one, under a dead force at its tip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wrapped {
    /// Length that lies on the cylinder.
    pub wrapped: f64,
    /// Force P L²/B of a unit of width.
    pub force: f64,
    /// Tip along the strip, and down.
    pub tip: [f64; 2],
}

/// The rows of the elastica, by shooting.
///
/// # Errors
/// [`ReferenceError`] if the table is not there.
pub fn wrapped_strips() -> Result<Vec<Wrapped>, ReferenceError> {
    let table: Reference = reference("contact_strip_on_cylinder")?;
    let elastica = (0..table.rows.len()).filter(|&row| table.rows[row][0].as_str() == Some("elastica"));
    let strip = |row: usize| {
        let number = |column: &str| table.number(row, column);
        Ok(Wrapped {
            wrapped: number("a/L")?,
            force: number("P L^2/B (linear: P R L/B)")?,
            tip: [number("tip x/L")?, number("tip down/L (linear: R/L^2)")?],
        })
    };
    elastica.map(strip).collect()
}

/// Two equal strips clamped one above the other, the lower one as long as a part λ of the upper, their faces a gap apart: what the upper one exerts on
/// the lower one, and how far both tips have come, by a force at the upper tip \[B g/L³, g, g\].
///
/// `F = (P λ² (3 − λ)/6 − 1)·3/(2λ³)` from the first touch on, at the lower tip alone.
pub fn two_cantilevers(part: f64, force: f64) -> [f64; 3] {
    let cube = part * part * part;
    let arm = part * part * (3.0 - part) / 6.0;
    let borne = ((force * arm - 1.0) * 1.5 / cube).max(0.0);
    [borne, force / 3.0 - borne * arm, borne * cube / 3.0]
}

/// Acceleration over that of gravity with which a sheet slides down a slope \[rad\] with a friction; zero where it sticks.
pub fn incline(friction: f64, slope: f64) -> f64 {
    (sin(slope) - friction * cos(slope)).max(0.0)
}

/// Acceleration over that of gravity of a solid ball on such a slope: it rolls with five sevenths of what pulls it, for which friction bears
/// `2/7 m g sin φ`, up to `tan φ = 7/2 μ`; beyond it slides.
pub fn rolling(friction: f64, slope: f64) -> f64 {
    if sin(slope) <= 3.5 * friction * cos(slope) { 5.0 / 7.0 * sin(slope) } else { incline(friction, slope) }
}

/// Rate of its spin times its radius over the acceleration of gravity: that of rolling, or `5/2 μ cos φ` by the moment of the friction.
pub fn spinning(friction: f64, slope: f64) -> f64 {
    (5.0 / 7.0 * sin(slope)).min(2.5 * friction * cos(slope))
}

/// Ratio of the tensions of a belt that slips on a drum over an angle \[rad\], by Euler and Eytelwein.
pub fn capstan(friction: f64, angle: f64) -> f64 {
    exp(friction * angle)
}

/// A ring of radius one under external pressure, whose walls touch or not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Collapsed {
    /// Pressure p R³/B.
    pub pressure: f64,
    /// Half of the distance of the mid-surfaces of its walls.
    pub opening: f64,
    /// Force F R²/B of a unit of width between the walls.
    pub force: f64,
}

/// The rows of the elastica whose walls have a thickness t/R: before they touch, where they do, and after.
///
/// # Errors
/// [`ReferenceError`] if the table is not there.
pub fn collapsed_rings(thickness: f64) -> Result<Vec<Collapsed>, ReferenceError> {
    let table: Reference = reference("contact_ring_under_pressure")?;
    let ring = |row: usize| {
        let number = |column: &str| table.number(row, column);
        let found = Collapsed {
            pressure: number("p R^3/B")?,
            opening: number("half opening b/R")?,
            force: number("F R^2/B")?,
        };
        // Free rings are those of any thickness, until they touch.
        let own = number("t/R")? == thickness;
        let free = table.rows[row][0].as_str() == Some("free") && found.opening > 0.5 * thickness;
        Ok((own || free).then_some(found))
    };
    (0..table.rows.len()).filter_map(|row| ring(row).transpose()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pressed_ring_is_that_of_the_table() {
        let table = reference("contact_ring_between_plates").unwrap();
        for row in 0..table.rows.len() {
            let [height, force] = ["H/R", "P R^2/B"].map(|column| table.number(row, column).unwrap());
            let found = pressed_ring(height);
            assert!((found / force - 1.0).abs() < 1e-7, "{height}: {found} {force}");
        }
    }

    #[test]
    fn two_cantilevers_are_those_of_the_table() {
        let table = reference("contact_two_cantilevers").unwrap();
        for row in 0..table.rows.len() {
            let number = |column: &str| table.number(row, column).unwrap();
            let found = two_cantilevers(number("lambda"), number("P"));
            let wanted = ["F", "tip deflection of the upper", "tip deflection of the lower"].map(number);
            for (found, wanted) in found.into_iter().zip(wanted) {
                // The table has nine digits of forces, four of deflections.
                assert!((found - wanted).abs() < 6e-4, "row {row}: {found} {wanted}");
            }
        }
    }

    #[test]
    fn friction_is_that_of_the_table() {
        let table = reference("contact_friction_closed_forms").unwrap();
        for row in 0..table.rows.len() {
            let [mu, degrees, known] =
                ["mu", "phi", "a/g or T2/T1"].map(|column| table.number(row, column).unwrap());
            let law = if table.rows[row][0].as_str() == Some("incline") { incline } else { capstan };
            let found = law(mu, degrees.to_radians());
            assert!((found - known).abs() < 1e-8 * known.max(1.0), "{mu} {degrees}: {found} {known}");
        }
    }

    /// A ring that is hardly pressed is as stiff as a ring of small deflection: `P = (2R − H)/(π/4 − 2/π)`.
    #[test]
    fn a_ring_hardly_pressed_is_that_of_small_deflections() {
        let stiffness = 1.0 / (std::f64::consts::FRAC_PI_4 - 2.0 / std::f64::consts::PI);
        assert!((pressed_ring(2.0 - 1e-4) / (1e-4 * stiffness) - 1.0).abs() < 2e-4);
    }

    /// Upper half of a ring that touches: the pressure on what it spans carries the force between the walls and the thrust at its sides,
    /// which curvature bends about them. The pressures rise, the openings fall, and the force begins where they touch.
    #[test]
    fn rings_touch_once_and_bear_more_and_more() {
        for thickness in [0.02, 0.05, 0.1] {
            let rings = collapsed_rings(thickness).unwrap();
            assert!(rings.len() > 10);
            for pair in rings.windows(2) {
                assert!(
                    pair[0].pressure < pair[1].pressure && pair[0].opening >= pair[1].opening,
                    "{pair:?}"
                );
                assert!(pair[0].force <= pair[1].force && pair[1].opening >= 0.5 * thickness);
            }
            let touching = rings.iter().filter(|ring| ring.opening == 0.5 * thickness);
            assert_eq!(touching.clone().next().unwrap().force, 0.0);
            assert!(touching.count() > 5);
        }
    }

    /// Moments about the clamp: the tip's force, the force at lift-off and the pressure on what is wrapped make the moment B/R there.
    #[test]
    fn strips_are_in_balance_with_their_curvature_on_the_drum() {
        for strip in wrapped_strips().unwrap() {
            let a = strip.wrapped;
            // At lift-off the moment of the tip's force is that of the radius.
            let arm = strip.tip[0] - sin(a);
            assert!((strip.force * arm - 1.0).abs() < 1e-7, "{strip:?}");
        }
    }
}
