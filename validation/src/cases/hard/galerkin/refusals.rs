//! galerkin-refusals: what cannot be followed is said, with the place: steps that turn or crush too far, too few nodes, a cycle of
//! strain that leaves stress.

use coque::{Scene, Silent};
use solid_kinematics::{Formulation, Material, Moduli, PointState, StressMeasure, Tensor, Update};

use crate::judge::{Case, Headline, Outcome, Run, Solver, Variant};
use crate::support::studies::figure;
use crate::{JudgeError, Metric};

const CANTILEVER: &str = include_str!("../../../../../scenes/cantilever-solid.toml");
const METHOD: &str = "galerkin";
const SAID: &str = "refused with its cause";
const LEFT: &str = "stress left over Young's modulus";

/// What is tried, and what has to be said.
pub fn case() -> Case {
    Case {
        name: "galerkin-refusals",
        title: "Galerkin solids: too far, too few, round and back",
        about: "A step that turns a point inside out, one that turns it by more than a right angle, supports of shape \
                functions with too few nodes, a body that is free to move: each ends with a sentence that names the cause. A closed cycle of stretch and shear \
                leaves a stress: the law of increments has no energy.",
        citation: "reference: what the method can do; residual stresses of the cycle by the prototype",
        variants: variants(),
        headline: Some(Headline::new(SAID, 0.5)),
        ..Case::default()
    }
}

fn variants() -> Vec<Variant> {
    let tried = |grid: &str, set: &'static [(&'static str, &'static str)], words: &'static str| {
        Variant::study(METHOD, grid, move || Ok(said(set, words)))
            .judged(|run, _| Ok(vec![figure(run, SAID, "-")?.within(0.0, "the sentence names the cause")]))
            .quick()
    };
    let mut variants = vec![
        tried(
            "too few nodes",
            &[("bodies.beam.solid.formulation.galerkin.support", "{ ellipsoid = 1.2 }")],
            "nodes in less do not determine the basis",
        ),
        tried(
            "free to move",
            &[("supports", "[{ on = \"x0\", symmetry = { normal = [1, 0, 0] } }]")],
            "free to move",
        ),
    ];
    for (grid, update, gradient, words) in [
        ("turned by 85° and stretched by 10 % in a step", Update::StepStart, turned(85.0) * 1.1, "sin θ"),
        ("turned inside out", Update::Midpoint, Tensor::from_diagonal(&[-0.1, 1.0, 1.0].into()), "det F"),
    ] {
        let variant = Variant::study(METHOD, grid, move || refused(update, &gradient, words));
        variants.push(
            variant.quick().judged(|run, _| {
                Ok(vec![figure(run, SAID, "-")?.within(0.0, "the sentence names the cause")])
            }),
        );
    }
    for (amplitude, left) in [(0.02, 1.5e-6), (0.05, 2.3e-5), (0.1, 1.8e-4), (0.2, 1.4e-3)] {
        let variant = Variant::study(METHOD, &format!("cycle of {amplitude}"), move || cycle(amplitude));
        variants.push(variant.quick().judged(move |run, _| judged(run, left)));
    }
    variants
}

/// A rotation about the third axis \[degrees\].
fn turned(angle: f64) -> Tensor {
    let (sine, cosine) = (libm::sin(angle.to_radians()), libm::cos(angle.to_radians()));
    Tensor::new(cosine, -sine, 0.0, sine, cosine, 0.0, 0.0, 0.0, 1.0)
}

/// The material of the studies.
fn material(update: Update) -> Result<Material, String> {
    let moduli = Moduli::isotropic(1.0, 0.3).map_err(|error| error.to_string())?;
    Ok(Material {
        moduli,
        formulation: Formulation::StrainRotation { update, measure: StressMeasure::Kirchhoff },
        plastic: None,
    })
}

/// Zero where a step from rest to a deformation is refused in some words, else one.
fn refused(update: Update, gradient: &Tensor, words: &str) -> Result<Outcome, String> {
    let tried = material(update)?.trial(&PointState::rest(Tensor::identity()), gradient);
    let named = tried.is_err_and(|error| error.to_string().contains(words));
    Ok(Outcome::row(Solver::Static, &[(SAID, "-", if named { 0.0 } else { 1.0 })]))
}

/// Zero where a scene is refused, or ends at rest, with a sentence that holds some words, else one.
fn said(set: &[(&str, &str)], words: &str) -> Outcome {
    let pairs: Vec<_> = set.iter().map(|(path, value)| (path.to_string(), value.to_string())).collect();
    let built = Scene::with_overrides(CANTILEVER, "hard case", &pairs).and_then(|scene| scene.build(1));
    let sentence = match built {
        Err(refusal) => refusal.to_string(),
        Ok(model) => {
            let outcome = model.run(&mut Silent);
            let rows = outcome.curve.rows.len();
            if rows > 1 { format!("{rows} rows") } else { outcome.ended.to_string() }
        }
    };
    let missed = if sentence.contains(words) { 0.0 } else { 1.0 };
    Outcome::row(Solver::Static, &[(SAID, "-", missed)])
}

/// Stretch, then shear, then back in the same order, in steps of a hundredth of the way.
fn cycle(amplitude: f64) -> Result<Outcome, String> {
    let material = material(Update::Midpoint)?;
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0]];
    let mut state = PointState::rest(Tensor::identity());
    for pair in corners.windows(2) {
        for step in 1..=100 {
            let part = f64::from(step) / 100.0;
            let [stretch, shear] =
                [0, 1].map(|k| amplitude * (pair[0][k] + part * (pair[1][k] - pair[0][k])));
            let gradient = Tensor::new(1.0 + stretch, shear, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0);
            state = material.trial(&state, &gradient).map_err(|error| error.to_string())?.state;
        }
    }
    let left = state.stress.iter().fold(0.0, |most: f64, s| most.max(s.abs()));
    Ok(Outcome::row(Solver::Static, &[(LEFT, "-", left)]))
}

fn judged(run: &Run, left: f64) -> Result<Vec<Metric>, JudgeError> {
    let found = Metric::compared(LEFT, run.last(LEFT)?, "-", left);
    Ok(vec![found.within(0.05 * left, "two digits of the prototype are known")])
}
