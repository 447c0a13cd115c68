//! Back stresses that recover, in scenes: what is refused, the same bits, energies, iterations.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::sittings::stopped_again_and_again;
use crate::common::{Replaced, column, done, refusal, text};

const STRUCK: &str = "../coque/tests/yielding/struck.toml";
const CYCLED: &str = "strip-cycled.toml";
const HEMISPHERE: &str = "hemisphere-yielding.toml";
const BACKS: &str = "material.plastic.back-stresses";
/// Of the struck strip, whose yield stress is 2e5 \[N/m²\].
const TWO: &str = "[{ modulus = 2e7, recovery = 150.0 }, { modulus = 2e6, recovery = 20.0 }]";

#[test]
fn back_stresses_that_cannot_be_had() {
    let one = "{ modulus = 1.0, recovery = 1.0 }";
    let four = format!("[{one}, {one}, {one}, {one}]");
    let cases: [(&str, &str, Replaced); 4] = [
        ("four", CYCLED, &[(BACKS, &four)]),
        ("no recovery", CYCLED, &[(BACKS, "[{ modulus = 1.0, recovery = 0.0 }]")]),
        ("no modulus", CYCLED, &[(BACKS, "[{ recovery = 1.0 }]")]),
        (
            "of a solid",
            "cylinder-bursting.toml",
            &[("bodies.tube.solid.material.plastic.back-stresses", TWO)],
        ),
    ];
    let said = cases.map(|(what, name, replaced)| format!("== {what}\n{}\n", refusal(name, replaced, 100)));
    insta::assert_snapshot!(said.concat());
}

#[test]
fn back_stresses_go_on_to_the_same_bits() {
    stopped_again_and_again(
        "cycled",
        &text(CYCLED),
        &[("analysis.static.levels", "[0.2, 0.6, 1.0, 0.5, 0.0]")],
        3,
    );
    let both = [
        ("analysis.explicit.transient.duration", "0.005"),
        (BACKS, TWO),
        ("material.plastic.rate", "{ cowper-symonds = { reference = 1000.0, exponent = 4.0 } }"),
    ];
    stopped_again_and_again("struck", &text(STRUCK), &both, 4);
}

/// Motion turns into what is stored and what is dissipated, and the sum stays; what is dissipated never comes back.
#[test]
fn the_energy_of_a_struck_strip_closes_with_back_stresses() {
    let of = |safety: &str| {
        let outcome = done(STRUCK, &[("analysis.explicit.safety", safety), (BACKS, TWO)]);
        let [kinetic, internal, lost] = ["kinetic", "internal", "lost"].map(|name| column(&outcome, name));
        let start = kinetic[0] + internal[0];
        assert!(lost.windows(2).all(|pair| pair[1] >= pair[0]), "{lost:?}");
        let open = kinetic.iter().zip(&internal).map(|(k, i)| (k + i - start).abs() / start);
        (open.fold(0.0, f64::max), lost[lost.len() - 1] / start)
    };
    let ((coarse, _), (fine, lost)) = (of("0.4"), of("0.2"));
    println!("{coarse:.1e} {fine:.1e}, dissipated {lost:.3}");
    // 1.7e-3, 6.3e-4.
    assert!(fine < 2e-3 && fine < 0.5 * coarse && lost > 0.3, "{coarse:.1e} {fine:.1e} {lost:.3}");
}

/// Half of a tangent that is not symmetric costs some iterations, and no answer.
#[test]
fn a_hemisphere_with_back_stresses_comes_to_balance() {
    let coarse =
        [("geometry.sphere.particles", "[13, 13]"), ("analysis.static.levels", "[0.1, 0.2, 0.3, 0.4]")];
    let of = |material: (&str, &str)| {
        let outcome = done(HEMISPHERE, &[coarse[0], coarse[1], material]);
        let iterations: f64 = column(&outcome, "iterations").iter().sum();
        (iterations, column(&outcome, "inward"))
    };
    let (linear, without) = of(("material.plastic.kinematic", "9.0"));
    let (recovering, way) = of((BACKS, "[{ modulus = 9.0, recovery = 30.0 }]"));
    println!("{linear} {recovering}, {without:?} {way:?}");
    // 29 and 30.
    assert!(recovering < 1.3 * linear && way != without, "{linear} {recovering}");
}

/// Newton's method, a relaxation and a quasi-static march find one answer.
#[test]
fn relaxation_and_march_agree_with_newtons_method() {
    let of = |analysis: &str| {
        let outcome = done(
            HEMISPHERE,
            &[
                ("geometry.sphere.particles", "[9, 9]"),
                ("analysis", analysis),
                (BACKS, "[{ modulus = 90.0, recovery = 30.0 }]"),
            ],
        );
        let inward = column(&outcome, "inward");
        inward[inward.len() - 1]
    };
    let levels = "levels = [0.1, 0.2, 0.3, 0.4]";
    let exact = of(&format!("{{ static = {{ {levels} }} }}"));
    let relaxed = of(&format!("{{ relaxation = {{ {levels} }} }}")) / exact - 1.0;
    let marched = of(&format!("{{ explicit.quasi-static = {{ {levels} }} }}")) / exact - 1.0;
    println!("{relaxed:.1e} {marched:.1e}");
    // 2.9e-8, by where the relaxation stops; -3.8e-5, by what its hold leaves missing.
    assert!(relaxed.abs() < 1e-7 && marched.abs() < 1.2e-4, "{relaxed:.1e} {marched:.1e}");
}
