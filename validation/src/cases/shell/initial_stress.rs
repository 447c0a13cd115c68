//! initial-stress: frequencies of a plate in tension, its buckling under stress, a strip that rolls up by one, against closed forms.

use std::f64::consts::PI;

use crate::judge::{Case, Headline, Run, Variant, measure};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const PLATE: &str = include_str!("../../../../scenes/tensioned-plate.toml");
const STRIP: &str = include_str!("../../../../scenes/relieved-strip.toml");
const NAME: &str = "frequencies";

/// As in the scene of the plate: modulus, Poisson's ratio, density, thickness, sides, stresses \[N, m, kg\].
const YOUNG: f64 = 70e9;
const POISSON: f64 = 0.3;
const DENSITY: f64 = 2700.0;
const THICK: f64 = 0.002;
const SIDES: [f64; 2] = [0.5, 0.4];
const STRESS: [f64; 2] = [30e6, 15e6];
/// Length of the strip, which rolls up to a quarter of a circle \[m\].
const LENGTH: f64 = 0.5;

/// The scenes, their references, and how far they may differ.
pub fn case() -> Case {
    let plate = |counts| Variant::new(STATIC, PLATE, "plate", counts).quick().on("plate in tension");
    let pressed = |counts| {
        let pressed = Variant::new(STATIC, PLATE, "plate", counts).quick().on("plate pressed by its stress");
        pressed
            .set("initial_stress.0.membrane", "[-1e6, -1e6, 0.0]")
            .set("analysis", "{ buckling = { modes = 1 } }")
    };
    // What is left of the stress is rounding, and no figure to keep.
    let curve = "[{ name = 'w_end', of = 'displacement', on = 'u1', direction = [0, 0, 1] }]";
    let strip = |counts| {
        let strip = Variant::new(STATIC, STRIP, "plate", counts).quick();
        strip.set("curve", curve).on("strip rolled by its stress")
    };
    Case {
        name: "initial-stress",
        title: "Plate and strip under initial stress",
        about: "Stress of the unloaded shell: the frequencies of a plate on hinged edges in tension, the stress at which it buckles, and a \
                strip that a stress through its thickness rolls up to a quarter of a circle.",
        citation: "closed forms of the theory of plates and beams",
        variants: vec![
            plate([21, 17]).judged(|run, _| sung(run, 20.0)),
            plate([41, 33]).judged(|run, _| sung(run, 40.0)),
            pressed([21, 17]).judged(|run, _| buckled(run, 20.0)),
            pressed([41, 33]).judged(|run, _| buckled(run, 40.0)),
            strip([21, 3]).judged(|run, _| rolled(run, 20.0)),
            strip([41, 3]).judged(|run, _| rolled(run, 40.0)),
        ],
        headline: Some(Headline::new(NAME, 0.5)),
        ..Case::default()
    }
}

fn bending() -> f64 {
    YOUNG * THICK.powi(3) / (12.0 * (1.0 - POISSON * POISSON))
}

/// Squares of the wave numbers of so many half waves \[1/m²\].
fn waves([m, n]: [u32; 2]) -> [f64; 2] {
    [(f64::from(m) * PI / SIDES[0]).powi(2), (f64::from(n) * PI / SIDES[1]).powi(2)]
}

fn sung(run: &Run, cells: f64) -> Result<Vec<Metric>, JudgeError> {
    let exact = [[1, 1], [2, 1], [1, 2], [2, 2]].map(|mode| {
        let [k1, k2] = waves(mode);
        let stiffness = bending() * (k1 + k2).powi(2) + THICK * (STRESS[0] * k1 + STRESS[1] * k2);
        (stiffness / (DENSITY * THICK)).sqrt()
    });
    let found = run.column("circular_frequency")?;
    let off = found.iter().zip(exact).map(|(found, exact)| Some(100.0 * (found / exact - 1.0).abs()));
    let error = if found.len() == 4 { measure::largest(off) } else { None };
    // .45 % with 40 cells.
    let reason = "three times what one gradient a cell leaves of two half waves, of second order";
    Ok(vec![Metric::error(NAME, error, "%").within(3.0 * 0.45 * (40.0 / cells).powi(2), reason)])
}

fn buckled(run: &Run, cells: f64) -> Result<Vec<Metric>, JudgeError> {
    let [k1, k2] = waves([1, 1]);
    let exact = bending() * (k1 + k2) / (THICK * 1e6);
    let percent = run.last("level")?.map(|found| 100.0 * (found / exact - 1.0));
    // .16 % with 40 cells.
    let reason =
        "three times what one curvature and one gradient a cell leave of a half wave, of second order";
    Ok(vec![
        Metric::error("critical stress", percent, "%").within(3.0 * 0.16 * (40.0 / cells).powi(2), reason),
    ])
}

fn rolled(run: &Run, cells: f64) -> Result<Vec<Metric>, JudgeError> {
    let radius = 2.0 * LENGTH / PI;
    let percent = run.last("w_end")?.map(|found| 100.0 * (found / -radius - 1.0));
    // .0064 % with 40 cells.
    let reason = "three times what chords in place of arcs leave between the particles, of second order";
    Ok(vec![
        Metric::error("end of the strip", percent, "%").within(3.0 * 0.0064 * (40.0 / cells).powi(2), reason),
    ])
}
