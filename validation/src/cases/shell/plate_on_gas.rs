//! plate-on-gas: a plate over a chamber of gas, under a pressure from outside and in its first mode.
//!
//! ```text
//!  ↓↓↓↓↓↓↓ q       p/q = k s/(1 + k s)            k = κ p_a/V, s the volume that a unit of pressure bends the plate by
//! △━━━━━━━△        1 + k Σ 64/(π⁴ m² n² (ω²_mn − ω²)) = 0       m and n odd
//!  ░gas░░░
//! ```

use std::f64::consts::PI;

use libm::pow;

use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/plate-on-gas.toml");
const BORNE: &str = "pressure of the gas";
const FIRST: &str = "first frequency";
const PRESSED: &str = "21×21, pressed";
const FREE: &str = "21×21, free";
/// κ p_a/V \[F/L⁵\].
const STIFFNESS: f64 = 1.4 * 21.0 / 0.05;
/// Pressure from outside \[F/L²\].
const OUTSIDE: f64 = 0.01;
/// Half waves of the series either way, odd.
const WAVES: u32 = 99;

/// Errors \[%\].
const MEASURED: Measured = Measured(&[(STATIC, &[(PRESSED, 0.21), (FREE, 0.31)])]);

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "plate-on-gas",
        title: "A plate over a chamber of gas",
        about: "A simply supported square plate, one pressure in the chamber below that goes with the volume: how it shares a pressure from outside with the \
                gas, and the first frequency, which the gas raises by two fifths.",
        citation: "Navier's series of the thin plate, one equation for the gas",
        variants: vec![
            Variant::scene(STATIC, SCENE, PRESSED).quick_if(true),
            Variant::scene(STATIC, SCENE, FREE).set("analysis.modal.modes", 3).quick_if(true),
        ],
        each,
        headline: Some(Headline::new(BORNE, 0.1)),
        ..Case::default()
    }
}

/// Sums over all odd m and n of a function of m, n and ω²_mn.
fn over_waves(of: impl Fn(f64, f64) -> f64) -> f64 {
    let odd = || (1..=WAVES).step_by(2).map(f64::from);
    odd()
        .flat_map(|m| odd().map(move |n| [m, n]))
        .map(|[m, n]| of(m * n, pow(PI, 4.0) * pow(m * m + n * n, 2.0)))
        .sum()
}

/// The least ω² at which the plate and the gas swing together, by halving between the first two of the plate that change the volume.
fn first() -> f64 {
    let left = |square: f64| {
        1.0 + STIFFNESS * over_waves(|mn, own| 64.0 / (pow(PI, 4.0) * mn * mn * (own - square)))
    };
    let (mut low, mut high) = (4.0 * pow(PI, 4.0) * (1.0 + 1e-9), 100.0 * pow(PI, 4.0) * (1.0 - 1e-9));
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if left(middle) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    low.sqrt()
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let measured = MEASURED.of(run)?;
    if run.variant.grid == FREE {
        let found =
            run.column("circular_frequency")?.first().map(|found| 100.0 * (found / first() - 1.0).abs());
        let reason = "of second order in the spacing over the wave; mass and stiffness together";
        return Ok(vec![Metric::error(FIRST, found, "%").near(measured, reason)]);
    }
    let bent = over_waves(|mn, own| 64.0 / (pow(PI, 4.0) * mn * mn * own));
    let exact = OUTSIDE * STIFFNESS * bent / (1.0 + STIFFNESS * bent);
    let found = run.last("p_gas")?.map(|found| 100.0 * (found / exact - 1.0).abs());
    Ok(vec![
        Metric::error(BORNE, found, "%")
            .near(measured, "cells of second order: the volume of a wave by its corners"),
    ])
}
