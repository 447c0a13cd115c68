//! joined-cantilevers: two bodies joined by a spring, deflections and first modes against closed forms.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::judge::{Case, Headline, Run, Variant};
use crate::methods::STATIC;
use crate::{JudgeError, Metric};

const SCENE: &str = include_str!("../../../../scenes/joined-cantilevers.toml");
const NAME: &str = "deflection of the loaded tip";

/// As in the scene: bending stiffness \[N m²\], mass by length \[kg/m\], length \[m\], stiffness of the spring \[N/m\], force \[N\].
const BENDING: f64 = 0.1;
const MASS: f64 = 1.0;
const LENGTH: f64 = 1.0;
const SPRING: f64 = 0.3;
const FORCE: f64 = -0.01;

/// The scene, its references, and how far they may differ.
pub fn case() -> Case {
    let modes = Variant::scene(STATIC, SCENE, "41×5 modes")
        .set("analysis", "{ modal = { modes = 2 } }")
        .set("loads", "[]")
        .set("curve", "[]");
    Case {
        name: "joined-cantilevers",
        title: "Two cantilevers joined by a spring",
        about: "Two bodies in one balance: the deflections of both tips under a force on one; the mode in which both swing together, and \
                the one in which they swing against each other, as one cantilever does on a spring of twice the stiffness.",
        citation: "closed forms of the theory of beams",
        variants: vec![
            Variant::scene(STATIC, SCENE, "41×5").judged(|run, _| deflections(run)),
            modes.judged(|run, _| frequencies(run)),
        ],
        headline: Some(Headline::new(NAME, 0.01)),
        ..Case::default()
    }
}

/// Springs in a row beside a spring: the force goes through the tip itself, and through the spring and the other tip.
fn deflections(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let tip = 3.0 * BENDING / LENGTH.powi(3);
    let through = 1.0 / (1.0 / SPRING + 1.0 / tip);
    let loaded = FORCE / (tip + through);
    let other = loaded * through / tip;
    let percent = |column: &str, exact: f64| -> Result<_, JudgeError> {
        Ok(run.last(column)?.map(|found| 100.0 * (found / exact - 1.0)))
    };
    let curvature = "three times what one curvature a cell leaves of a moment that varies, .008 and .013 %";
    Ok(vec![
        Metric::error(NAME, percent("w_upper", loaded)?, "%").within(0.024, curvature),
        Metric::error("deflection of the other tip", percent("w_lower", other)?, "%")
            .within(0.039, curvature),
    ])
}

fn frequencies(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let found = run.column("circular_frequency")?;
    let reason = "three times the errors of the lattice, .0055 and .0049 %, of second order in the spacing over the wave";
    let metric = |name: &'static str, number: usize, spring: f64, within: f64| {
        let exact = frequency(spring);
        let percent = found.get(number).map(|value| 100.0 * (value / exact - 1.0));
        Metric::error(name, percent, "%").within(within, reason)
    };
    Ok(vec![
        metric("frequency of both together", 0, 0.0, 0.017),
        metric("frequency against each other", 1, 2.0 * SPRING, 0.015),
    ])
}

/// First frequency of a cantilever with a spring at its tip: `b³ (1 + cos b cosh b) + (sL³/EI) (sin b cosh b − cos b sinh b) = 0`,
/// b from π/2, where the left side is above zero, to 5π/4, the end of a beam that is hinged there.
fn frequency(spring: f64) -> f64 {
    let s = spring * LENGTH.powi(3) / BENDING;
    let left = |b: f64| {
        let (sin, cos) = libm::sincos(b);
        let (sinh, cosh) = (libm::sinh(b), libm::cosh(b));
        b.powi(3) * (1.0 + cos * cosh) + s * (sin * cosh - cos * sinh)
    };
    let (mut low, mut high) = (FRAC_PI_2, 1.25 * PI);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if left(middle) > 0.0 { low = middle } else { high = middle }
    }
    (low / LENGTH).powi(2) * (BENDING / MASS).sqrt()
}
