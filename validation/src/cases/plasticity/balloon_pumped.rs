//! balloon-pumped: a balloon of rubber that air, or water, is pumped into, past its greatest pressure.
//!
//! ```text
//!    ╭───╮  air: (p_a + p) λ³ = p_a + p₀ level       water: λ³ = 1 + ΔV level/V₀ but for what it gives
//!    ╰─┬─╯  p R/t = 4 c₁ (1/λ − 1/λ⁷)
//! ```

use libm::pow;

use super::balloon_inflating::{RADIUS, on_octant, pressure};
use crate::judge::{Case, Headline, Lattices, Measured, Run, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/meshes/balloon-pumped.toml");
const PRESSURE: &str = "greatest error of the pressure";
const STRETCH: &str = "greatest error of the stretch";
/// t/R at rest.
const SLENDER: f64 = 0.01;
/// Pressure of the surroundings, and of all the air in the volume at rest \[MPa\].
const AIR: [f64; 2] = [0.1, 2.78];
/// Volume at rest of an eighth, and of all the water that is added \[mm³\]; its bulk modulus \[MPa\].
const WATER: [f64; 2] = [13614.0, 2200.0];

/// Errors \[%\].
const MEASURED: [Measured; 2] = [
    Measured(&[(STATIC, &[("8 cells, air", 0.23), ("16 cells, air", 0.057), ("8 cells, water", 0.23)])]),
    Measured(&[(STATIC, &[("8 cells, air", 0.012), ("16 cells, air", 0.0029), ("8 cells, water", 0.016)])]),
];

/// The scene, its reference, and how far the two may differ.
pub fn case() -> Case {
    let air = [8, 16].into_iter().map(|cells| balloon(cells, "air"));
    Case {
        name: "balloon-pumped",
        title: "A balloon of rubber, pumped up",
        about: "An eighth of a sphere to three times its radius by what is pumped in, air under the pressure outside or water that gives hardly at all: the \
                pressure at the stretch of every level from 1.02 on, through its greatest, and the stretch that belongs to what is in. No arc length and no \
                critical point: what is enclosed makes the path stable.",
        citation: "closed form of thin walls, and of the gas",
        variants: air.chain([balloon(8, "water")]).collect(),
        each,
        headline: Some(Headline::new(PRESSURE, 0.1)),
        ..Case::default()
    }
}

fn balloon(cells: usize, content: &'static str) -> Variant {
    let [added, bulk] = WATER;
    let of = move |cells: usize| {
        let water = format!("{{ on = \"all\", volume = {{ added = {added}, bulk_modulus = {bulk} }} }}");
        let set = [("loads[0]", water.as_str())];
        on_octant(SCENE, cells, if content == "water" { &set } else { &[] })
    };
    let grid = format!("{cells} cells, {content}");
    Variant::study_on(STATIC, &grid, Lattices::of(cells, of)).quick_if(cells == 8)
}

/// The stretch of a level, by halving.
fn stretch_of(level: f64, content: &str, rest: f64) -> f64 {
    let over = |stretch: f64| {
        let p = SLENDER * pressure(stretch, 0.0);
        match content {
            "air" => (AIR[0] + p) * pow(stretch, 3.0) - AIR[0] - level * AIR[1],
            _ => (1.0 + p / WATER[1]) * pow(stretch, 3.0) - 1.0 - level * WATER[0] / rest,
        }
    };
    let (mut low, mut high) = (1.0, 4.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if over(middle) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let content = if run.variant.grid.ends_with("water") { "water" } else { "air" };
    let [r, p, level, volume] = ["r", "p", "level", "V"].map(|name| run.column(name));
    let (r, p, level) = (r?, p?, level?);
    let rest = volume?.first().copied().unwrap_or(f64::NAN);
    let mut worst = [0.0_f64; 2];
    for ((r, p), level) in r.iter().zip(&p).zip(&level).filter(|((r, _), _)| **r > 1.02 * RADIUS) {
        let stretch = r / RADIUS;
        worst[0] = worst[0].max((p / (SLENDER * pressure(stretch, 0.0)) - 1.0).abs());
        worst[1] = worst[1].max((stretch / stretch_of(*level, content, rest) - 1.0).abs());
    }
    let [pressure, stretch] = worst.map(|error| Some(100.0 * error).filter(|_| run.done()));
    let reason = "cells of second order";
    Ok(vec![
        Metric::error(PRESSURE, pressure, "%").near(MEASURED[0].of(run)?, reason),
        Metric::error(STRETCH, stretch, "%").near(MEASURED[1].of(run)?, reason),
    ])
}
