//! Yield stresses that grow with the rate of plastic strain, in scenes: what is refused, energies, steps, the same bits.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::sittings::stopped_again_and_again;
use crate::common::{Replaced, column, done, last, overridden, refusal, text};
use coque::Ended;

const STRUCK: &str = "../coque/tests/yielding/struck.toml";
const RATE: &str = "material.plastic.rate";
/// At 50/s it bears nearly half as much again.
const COWPER: &str = "{ cowper-symonds = { reference = 1000.0, exponent = 4.0 } }";
const JOHNSON: &str = "{ johnson-cook = { reference = 0.1, factor = 0.05 } }";

#[test]
fn rates_that_cannot_be_had() {
    let ply = "{ axis = [1, 0, 0], plies = [{ thickness = 1.0, angle = 0.0, material.plastic = { young = 2e5, poisson = 0.3, density = 1e-9, \
               hardening = { linear = { yield-stress = 250 } }, rate = { cowper-symonds = { reference = 40, exponent = 5 } } } }] }";
    let cases: [(&str, &str, Replaced); 7] = [
        (
            "an exponent below one",
            STRUCK,
            &[(RATE, "{ cowper-symonds = { reference = 40.0, exponent = 0.2 } }")],
        ),
        ("a rate of zero", STRUCK, &[(RATE, "{ johnson-cook = { reference = 0.0, factor = 0.1 } }")]),
        (
            "two laws",
            STRUCK,
            &[(RATE, JOHNSON), ("material.plastic.rate.cowper-symonds", "{ reference = 1.0 }")],
        ),
        ("at rest", "strip-springback.toml", &[(RATE, COWPER)]),
        (
            "in a quasi-static run",
            "strip-springback.toml",
            &[(RATE, COWPER), ("analysis", "{ explicit.quasi-static = { levels = 2 } }")],
        ),
        ("of a ply at rest", "plate-yielding.toml", &[("section", &format!("{{ layered = {ply} }}"))]),
        ("of a solid", "cylinder-bursting.toml", &[("bodies.tube.solid.material.plastic.rate", JOHNSON)]),
    ];
    let said = cases.map(|(what, name, replaced)| format!("== {what}\n{}\n", refusal(name, replaced, 100)));
    insta::assert_snapshot!(said.concat());
}

/// Motion turns into what is stored and what is dissipated, more of it where flow is resisted; it goes less far.
#[test]
fn the_energy_of_a_struck_strip_closes_with_rates() {
    let slow = done(STRUCK, &[("analysis.explicit.safety", "0.2")]);
    let far = |way: &[f64]| way.iter().fold(0.0_f64, |most, w| most.max(*w));
    for rate in [COWPER, JOHNSON] {
        let of = |safety: &str| {
            let outcome = done(STRUCK, &[("analysis.explicit.safety", safety), (RATE, rate)]);
            let [kinetic, internal, lost] =
                ["kinetic", "internal", "lost"].map(|name| column(&outcome, name));
            let start = kinetic[0] + internal[0];
            let open = kinetic.iter().zip(&internal).map(|(k, i)| (k + i - start).abs() / start);
            assert!(lost.windows(2).all(|pair| pair[1] >= pair[0]), "{lost:?}");
            (open.fold(0.0, f64::max), lost[lost.len() - 1] / start, outcome)
        };
        let ((coarse, _, _), (fine, lost, outcome)) = (of("0.4"), of("0.2"));
        let less = far(&column(&outcome, "w")) / far(&column(&slow, "w"));
        let strain = last(&outcome, "plastic") / last(&slow, "plastic");
        println!("{rate}: {coarse:.1e} {fine:.1e}, dissipated {lost:.3}, way {less:.3}, strain {strain:.3}");
        assert!(fine < 9e-4 && fine < coarse, "{coarse:.1e} {fine:.1e}");
        // .94 and .91 by Cowper and Symonds.
        assert!(less < 0.97 && strain < 0.95 && lost > 0.3, "{less} {strain} {lost}");
    }
}

/// A law that hardly feels the rates is none.
#[test]
fn what_hardly_feels_rates_is_slow() {
    let of = |rate: Replaced| column(&done(STRUCK, rate), "w");
    let (none, weak) = (of(&[]), of(&[(RATE, "{ cowper-symonds = { reference = 1e16, exponent = 1.0 } }")]));
    let apart = none.iter().zip(&weak).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    println!("{apart:.1e}");
    // Overstresses of 1e-14 of the yield stress leave 1.5e-16 of a way of a tenth.
    assert!(apart < 1e-14, "{apart:.1e}");
}

/// Half of the struck ring is two quarters.
#[test]
fn half_of_the_ring_is_two_quarters() {
    let half: Replaced =
        &[("geometry.cylinder.angles", "[0.0, 180.0]"), ("geometry.cylinder.particles", "[49, 3]")];
    let upright =
        text("ring-struck.toml").replacen("normal = [0.0, 0.0, 1.0]", "normal = [1.0, 0.0, 0.0]", 1);
    let scene = overridden(&upright, "../scenes/ring-struck.toml", half).unwrap();
    let whole = scene.build(1).unwrap().run(&mut coque::Silent);
    let quarter = done("ring-struck.toml", &[]);
    for (name, times) in [("plastic", 1.0), ("lost", 2.0), ("internal", 2.0)] {
        let (one, two) = (column(&quarter, name), column(&whole, name));
        let most = two.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        let apart = one.iter().zip(&two).map(|(one, two)| (times * one - two).abs()).fold(0.0, f64::max);
        println!("{name}: {:.1e}", apart / most);
        // 8e-14: rounding.
        assert!(apart < 3e-13 * most && most > 0.0, "{name}: {:.1e}", apart / most);
    }
}

#[test]
fn rates_go_on_to_the_same_bits_for_any_threads() {
    let short = [("analysis.explicit.transient.duration", "0.005"), (RATE, COWPER)];
    stopped_again_and_again("rated", &text(STRUCK), &short, 4);
    let bits = |threads: usize| -> Vec<u64> {
        let wide = [
            ("geometry.plate.particles", "[101, 31]"),
            ("analysis.explicit.transient.duration", "0.001"),
            (RATE, JOHNSON),
        ];
        let scene = overridden(&text(STRUCK), "../scenes/scene.toml", &wide).unwrap();
        let outcome = scene.build(threads).unwrap().run(&mut coque::Silent);
        assert_eq!(outcome.ended, Ended::Done, "{}", outcome.summary.ended);
        outcome.curve.rows.iter().flatten().map(|value| value.to_bits()).collect()
    };
    let one = bits(1);
    assert!(bits(2) == one && bits(3) == one);
}
