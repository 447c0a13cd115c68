//! heavy-end: a strip with a heavy rigid body at its end against the closed forms of a beam.

use crate::judge::{Case, Headline, Run, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/heavy-end.toml");
const NAME: &str = "frequencies";

/// As in the scene: modulus, width, length, thickness, density \[N, m, kg\].
const YOUNG: f64 = 210e9;
const WIDTH: f64 = 0.06;
const LENGTH: f64 = 0.6;
const THICK: f64 = 0.003;
const DENSITY: f64 = 7850.0;
/// The body: how far beyond the end its centre lies, its mass, its moment of inertia about y \[m, kg, kg m²\].
const BEYOND: f64 = 0.03;
const MASS: f64 = 0.5;
const INERTIA: f64 = 4e-4;
/// Force and couple on the body in the linear answer \[N, N m\].
const FORCE: f64 = 2.0;
const COUPLE: f64 = 0.5;

/// The scene, its references, and how far they may differ.
pub fn case() -> Case {
    let strip = |counts| Variant::new(STATIC, SCENE, "plate", counts).quick();
    let pushed = |counts| {
        let loads = format!(
            "[{{ on = 'u1', force = {{ total = [0, 0, {FORCE:?}] }} }}, {{ on = 'u1', couple = {{ moment = {COUPLE:?}, axis = [0, -1, 0] }} }}]"
        );
        let curve = "[{ name = 'w_end', of = 'displacement', on = 'u1', direction = [0, 0, 1] }, \
                     { name = 'M_clamp', of = 'reaction-moment', on = 'u0', direction = [0, 1, 0] }]";
        let pushed = strip(counts).set("loads", loads).set("curve", curve);
        pushed.set("analysis", "{ linear = {} }").on("force and couple on the body")
    };
    Case {
        name: "heavy-end",
        title: "Strip with a heavy rigid body at its end",
        about: "A rigid set with mass and inertia beyond the edge: frequencies of a beam with such a body, and the deflection under a \
                force and a couple at the body's reference point.",
        citation: "closed forms of the theory of beams",
        variants: vec![
            strip([21, 3]).judged(|run, _| vibrating(run, 20.0)),
            strip([41, 3]).judged(|run, _| vibrating(run, 40.0)),
            pushed([21, 3]).judged(|run, _| bent(run, 20.0)),
            pushed([41, 3]).judged(|run, _| bent(run, 40.0)),
        ],
        headline: Some(Headline::new(NAME, 0.5)),
        ..Case::default()
    }
}

/// Bending stiffness \[N m²\] and mass by length \[kg/m\].
fn beam() -> [f64; 2] {
    [YOUNG * WIDTH * THICK.powi(3) / 12.0, DENSITY * WIDTH * THICK]
}

/// `−EI w''' = ω²M (w + e w')`, `EI w'' = ω²[(J + Me²) w' + M e w]` at the end, of `w = A (cosh − cos) + B (sinh − sin)`: zero at an `x = βL`
/// of a mode.
fn determinant(x: f64) -> f64 {
    let (beta, square) = (x / LENGTH, (x / LENGTH).powi(4) / beam()[1]);
    let (sin, cos) = libm::sincos(x);
    let (sinh, cosh) = (libm::sinh(x), libm::cosh(x));
    let row = |[w, w1, w2, w3]: [f64; 4]| {
        let force = beta.powi(3) * w3 + square * MASS * (w + BEYOND * beta * w1);
        let turning = (INERTIA + MASS * BEYOND * BEYOND) * beta * w1 + MASS * BEYOND * w;
        [force, beta.powi(2) * w2 - square * turning]
    };
    let a = row([cosh - cos, sinh + sin, cosh + cos, sinh - sin]);
    let b = row([sinh - sin, cosh - cos, sinh + sin, cosh + cos]);
    a[0] * b[1] - a[1] * b[0]
}

/// The first three circular frequencies \[1/s\].
fn exact() -> Vec<f64> {
    let [stiffness, mass] = beam();
    let crossing = |i: u32| {
        let [mut low, mut high] = [i, i + 1].map(|i| 0.05 * f64::from(i));
        if determinant(low) * determinant(high) >= 0.0 {
            return None;
        }
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if determinant(low) * determinant(middle) <= 0.0 {
                high = middle;
            } else {
                low = middle;
            }
        }
        Some((low / LENGTH).powi(2) * (stiffness / mass).sqrt())
    };
    (1..300).filter_map(crossing).take(3).collect()
}

/// The worst of three frequencies, each against the nearest mode: others lie in the plane of the strip or twist it.
fn vibrating(run: &Run, cells: f64) -> Result<Vec<Metric>, JudgeError> {
    let found = run.column("circular_frequency")?;
    let off = |exact: f64| {
        let errors = found.iter().map(move |value| 100.0 * (value / exact - 1.0).abs());
        errors.fold(f64::INFINITY, f64::min)
    };
    let worst = exact().into_iter().map(off).reduce(f64::max);
    // Errors of 40 cells are .002, .05 and .13 %.
    let bound = 0.4 * (40.0 / cells).powi(2);
    let reason = "three times what one curvature a cell leaves of the third wave, of second order";
    Ok(vec![Metric::error(NAME, worst, "%").within(bound, reason)])
}

/// `w = P L³/3EI + (P e + C) L²/2EI` and shear, with so many cells along the strip.
fn bent(run: &Run, cells: f64) -> Result<Vec<Metric>, JudgeError> {
    let [stiffness, _] = beam();
    let shear = 5.0 / 6.0 * 0.5 * YOUNG * WIDTH * THICK;
    let couple = FORCE * BEYOND + COUPLE;
    let bending = FORCE * LENGTH.powi(3) / 3.0 + couple * LENGTH.powi(2) / 2.0;
    let w = bending / stiffness + FORCE * LENGTH / shear;
    let percent = |column: &str, exact: f64| -> Result<_, JudgeError> {
        Ok(run.last(column)?.map(|found| 100.0 * (found / exact - 1.0)))
    };
    // A quarter of 1/n² of the part of the force.
    let bound = 0.05 * (40.0 / cells).powi(2);
    Ok(vec![
        Metric::error("deflection", percent("w_end", w)?, "%")
            .within(bound, "three times what one curvature a cell leaves of a moment that varies, 1/4n²"),
        Metric::error("moment of the clamp", percent("M_clamp", FORCE * LENGTH + couple)?, "%")
            .within(0.001, "balance of the loads on the body at its reference point; differences of a linear answer are left"),
    ])
}
