//! Solids of bonds that yield, in scenes: what is refused, the balance of energies, marches that go on, threads.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::sittings::stopped_again_and_again;
use crate::common::{Replaced, column, done, last, overridden, refusal, text};

const BAR: &str = "bar-bonds-yielding.toml";
const MATERIAL: &str = "bodies.bar.solid.material.plastic";
const SHORT: (&str, &str) = ("analysis.explicit.transient.duration", "2.5e-4");

#[test]
fn bonds_that_cannot_yield() {
    let of = |key: &str| format!("{MATERIAL}.{key}");
    let (hardening, rate, kinematic) = (of("hardening"), of("rate"), of("kinematic"));
    let moved = "[{ on = \"x0\", held = { displacement = [[1.0, 0.0, 0.0]] } }, { on = \"x1\", moved = { direction = [1.0, 0.0, 0.0], by = 0.08 } }]";
    let cases: [(&str, &str, Replaced); 10] = [
        (
            "another hardening",
            BAR,
            &[(&hardening, "{ swift = { factor = 500.0, offset = 0.01, exponent = 0.2 } }")],
        ),
        ("a rate", BAR, &[(&rate, "{ cowper-symonds = { reference = 40.0, exponent = 5.0 } }")]),
        ("a back stress", BAR, &[(&kinematic, "100.0")]),
        (
            "pairwise bonds",
            BAR,
            &[
                ("bodies.bar.solid.formulation", "{ bond-based = { horizon = 2.015 } }"),
                ("bodies.bar.solid.material.plastic.poisson", "0.25"),
            ],
        ),
        (
            "a plane",
            BAR,
            &[
                (
                    "bodies.bar.solid.geometry.block",
                    "{ lengths = [16.0, 4.0], thickness = 1.0, spacing = 1.0 }",
                ),
                ("bodies.bar.solid.formulation.state-based.plane", "\"stress\""),
            ],
        ),
        ("weights as they are", BAR, &[("bodies.bar.solid.formulation.state-based.correction", "\"none\"")]),
        (
            "at rest",
            BAR,
            &[
                ("analysis", "{ static = { levels = 2 } }"),
                ("supports[1]", "{ on = \"x1\", moved = { direction = [1.0, 0.0, 0.0], by = 0.08 } }"),
            ],
        ),
        (
            "by a fast ramp",
            BAR,
            &[("analysis", "{ explicit.quasi-static = { levels = 2 } }"), ("supports", moved)],
        ),
        (
            "by kinetic damping",
            BAR,
            &[
                (
                    "analysis",
                    "{ explicit.quasi-static = { levels = 2, ramp = 30.0, damping = \"kinetic\" } }",
                ),
                ("supports", moved),
            ],
        ),
        (
            "in modes",
            BAR,
            &[
                ("analysis", "{ modal = { modes = 2 } }"),
                ("supports[1]", "{ on = \"x1\", held = { displacement = [[1.0, 0.0, 0.0]] } }"),
            ],
        ),
    ];
    let said = cases.map(|(what, name, replaced)| format!("== {what}\n{}\n", refusal(name, replaced, 100)));
    insta::assert_snapshot!(said.concat());
}

/// What the end is drawn by is stored, dissipated by damping and by flow, the more nearly the smaller the steps.
#[test]
fn the_energy_of_a_drawn_bar_closes() {
    let open = |safety: &str| {
        let outcome = done(BAR, &[("analysis.explicit.safety", safety)]);
        let [kinetic, internal, external, dissipated, lost] =
            ["kinetic", "internal", "external", "dissipated", "lost"].map(|name| column(&outcome, name));
        let rows = 0..kinetic.len();
        let open = rows.map(|i| {
            (external[i] - kinetic[i] - internal[i] - dissipated[i]).abs() / external[external.len() - 1]
        });
        assert!(lost.windows(2).all(|pair| pair[1] >= pair[0]), "{lost:?}");
        assert!(lost[lost.len() - 1] > 0.8 * external[external.len() - 1]);
        open.fold(0.0, f64::max)
    };
    let [coarse, fine] = ["0.8", "0.2"].map(open);
    println!("{coarse:.1e} {fine:.1e}");
    // Of the first order in the step: 4.9e-4 and 1.2e-4.
    assert!(coarse < 1.5e-3 && fine < 4e-4 && fine < coarse, "{coarse:e} {fine:e}");
}

/// A yield stress that is never reached leaves the elastic bar's numbers.
#[test]
fn below_yield_a_bar_is_elastic() {
    let strong = done(BAR, &[(&format!("{MATERIAL}.hardening.linear.yield-stress"), "1e6"), SHORT]);
    assert_eq!(last(&strong, "plastic"), 0.0);
    let elastic: Replaced = &[
        ("bodies.bar.solid.material", "{ elastic = { young = 200e3, poisson = 0.3, density = 7.85e-9 } }"),
        ("curve", "[{ name = \"F\", of = \"reaction\", on = \"x0\", direction = [-1.0, 0.0, 0.0] }]"),
        ("output", "{}"),
        SHORT,
    ];
    let elastic = done(BAR, elastic);
    let miss =
        column(&strong, "F").into_iter().zip(column(&elastic, "F")).map(|(a, b)| (a - b).abs() / 12000.0);
    let miss = miss.fold(0.0, f64::max);
    println!("{miss:.1e}");
    assert!(miss < 1e-11, "{miss:e}");
}

#[test]
fn a_bar_goes_on_to_the_same_bits_for_any_threads() {
    stopped_again_and_again("bonds", &text(BAR), &[SHORT], 3);
    let bits = |threads: usize| -> Vec<u64> {
        let finer = [
            SHORT,
            ("bodies.bar.solid.geometry.block.spacing", "0.5"),
            ("analysis.explicit.transient.duration", "1.5e-4"),
        ];
        let scene = overridden(&text(BAR), "../scenes/scene.toml", &finer).unwrap();
        let outcome = scene.build(threads).unwrap().run(&mut coque::Silent);
        outcome.curve.rows.iter().flatten().map(|x| x.to_bits()).collect()
    };
    let one = bits(1);
    assert!(one == bits(2) && one == bits(3));
}
