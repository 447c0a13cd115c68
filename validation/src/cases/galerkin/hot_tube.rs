//! hot-tube: heat through the wall of a tube and the stresses that it brings, heat round a crack of bonds, against closed forms.

use std::f64::consts::PI;

use super::INCREMENTS;
use crate::judge::{Case, Headline, Run, Variant};
use crate::{JudgeError, Metric};

const TUBE: &str = include_str!("../../../../scenes/tube-hot.toml");
const CRACKED: &str = include_str!("../../../../scenes/slab-cracked-hot.toml");
/// Bonds with weights that balance uniform strains.
const BONDS: &str = "bonds, balanced";
const HOOP: &str = "hoop stress within";

/// The tube and the plate, their closed forms, and how far they may differ.
pub fn case() -> Case {
    let tube = |cells: &'static str, finer: f64| {
        Variant::scene(INCREMENTS, TUBE, cells)
            .set("bodies.tube.solid.geometry.arc.cells", cells)
            .judged(move |run, _| judged_tube(run, finer))
    };
    // Between two columns of nodes.
    let cracked = |spacing: f64| {
        let x = 0.05 + 0.5 * spacing;
        Variant::scene(BONDS, CRACKED, spacing.to_string())
            .set("bodies.plate.solid.geometry.block.spacing", spacing)
            .set("bodies.plate.solid.cracks", format!("[{{ from = [{x}, 0.025], to = [{x}, 0.075] }}]"))
            .judged(move |run, _| judged_crack(run, spacing))
    };
    Case {
        name: "hot-tube",
        title: "Heat through solids: a tube that is hot within, a crack that heat goes round",
        about: "A quarter of a thick tube conducts heat from its inner face to the water round it: its hoop stresses in plane strain and how far its outer face moves. A plate of bonds with a crack across half of its width is heated at one end.",
        citation: "closed forms [boley1960, carslaw1959]; flow round a barrier in a channel",
        variants: vec![
            tube("[12, 2, 8]", 1.0),
            tube("[18, 2, 12]", 8.0 / 12.0),
            cracked(0.002),
            cracked(0.001),
        ],
        headline: Some(Headline::new(HOOP, 1.0)),
        ..Case::default()
    }
}

/// Stresses of a tube that is warm by a logarithm, and what follows.
fn judged_tube(run: &Run, finer: f64) -> Result<Vec<Metric>, JudgeError> {
    let (a, b, conducts, film, young, expansion, poisson) =
        (50.0_f64, 100.0_f64, 20.0, 0.66, 2e5, 12e-6, 0.3);
    let log = libm::log(b / a);
    let outer = (conducts * 300.0 / (b * log) + film * 20.0) / (film + conducts / (b * log));
    let warmth = 300.0 - outer;
    let (squares, size) = (b * b - a * a, young * expansion * warmth / (2.0 * (1.0 - poisson) * log));
    // ∫ T r dr over the wall, T over 20 degrees.
    let level = 280.0 * 0.5 * squares;
    let fall = warmth / log * (0.5 * b * b * log - 0.25 * squares);
    let wider = (1.0 + poisson) / (1.0 - poisson) * expansion * (level - fall) / b
        * (1.0 + ((1.0 - 2.0 * poisson) * b * b + a * a) / squares);
    let exact = [
        (HOOP, "hoop_within", size * (1.0 - 2.0 * b * b / squares * log), WITHIN),
        ("hoop stress without", "hoop_without", size * (1.0 - 2.0 * a * a / squares * log), WITHOUT),
        ("outer face", "wider", wider, WIDER),
    ];
    let metric = |(name, column, exact, off): (&'static str, &'static str, f64, f64)| {
        let percent = run.last(column)?.map(|found| 100.0 * (found / exact - 1.0));
        let reason = "three times what 8 cells across leave at nodes, of second order";
        Ok(Metric::error(name, percent, "%").within(3.0 * off * finer * finer, reason))
    };
    exact.into_iter().map(metric).collect()
}

/// What 8 cells across the wall leave \[%\].
const WITHIN: f64 = 0.31;
const WITHOUT: f64 = 1.15;
const WIDER: f64 = 0.011;

/// Heat that goes round a crack once the plate is warm.
fn judged_crack(run: &Run, spacing: f64) -> Result<Vec<Metric>, JudgeError> {
    let (half, crack, long) = (0.05, 0.025, 0.1);
    let longer = -4.0 * half / PI * libm::log(libm::cos(PI * crack / (2.0 * half)));
    let exact = 45.0 * 0.1 * 0.001 * 100.0 / (long + longer);
    let percent = run.last("cold")?.map(|found| 100.0 * (-found / exact - 1.0));
    let reason = "a crack of bonds conducts as one that is longer by a spacing at each tip, which takes 3.4 % of the heat on 50 spacings and half of it on twice as many: twice that";
    Ok(vec![Metric::error("heat round the crack", percent, "%").within(6.8 * spacing / 0.002, reason)])
}
