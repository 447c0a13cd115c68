//! Tools that shells touch, in scenes: what is refused, the same bits, a plate dropped in time, analyses against each other.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::sittings::stopped_again_and_again;
use crate::common::{Replaced, column, last, overridden, ran, run, text};
use coque::{Ended, Outcome, Rendering, render};

const RING: &str = "ring-between-plates.toml";

fn done(outcome: Outcome) -> Outcome {
    assert_eq!(outcome.ended, Ended::Done, "{}", outcome.summary.ended);
    outcome
}

/// Reads and builds the ring after replacements; renders what is refused.
fn refused(replaced: Replaced) -> String {
    match overridden(&text(RING), "ring.toml", replaced).and_then(|scene| scene.build(1).map(|_| ())) {
        Ok(()) => "not refused".into(),
        Err(error) => render(&error, Rendering { width: 100, colour: false }),
    }
}

#[test]
fn broken_tools() {
    let two = "[{ name = 'a', sphere = { centre = [0, 0, 3], radius = 1 } }, { name = 'a', sphere = { centre = [0, 0, 4], radius = 1 } }]";
    let cases: [(&str, Replaced); 13] = [
        ("no shape", &[("tools", "[{ name = 'a' }]")]),
        ("two shapes", &[("tools[0].sphere", "{ centre = [0, 0, 9], radius = 1 }")]),
        ("no name", &[("tools", "[{ sphere = { centre = [0, 0, 3], radius = 1 } }]")]),
        ("one name twice", &[("tools", two)]),
        ("a radius of zero", &[("tools", "[{ name = 'a', sphere = { centre = [0, 0, 3], radius = 0 } }]")]),
        ("no direction", &[("tools[0].plane.normal", "[0, 0, 0]")]),
        ("rounded into the barrier", &[("tools[0].rounding", "0.2")]),
        ("within the shell", &[("tools[0].plane.point", "[0, 0, 1.009]")]),
        ("in a linear analysis", &[("analysis", "{ linear = {} }")]),
        ("in modes", &[("analysis", "{ modal = { modes = 3 } }")]),
        ("a course without time", &[("tools[0].amplitude", "{ ramp = 1.0 }")]),
        (
            "at once in time",
            &[("analysis", "{ explicit = { transient = { duration = 1, record_every = 0.1 } } }")],
        ),
        ("nothing drives it", &[("tools[0].moved", "[0, 0, 0]")]),
    ];
    let said = cases.map(|(name, replaced)| format!("== {name}\n{}\n", refused(replaced)));
    insta::assert_snapshot!(said.concat());
}

#[test]
fn contact_goes_on_to_the_same_bits_and_threads_change_none() {
    let coarse = ("geometry.cylinder.particles", "[21, 3]");
    let short = ("tools[0].moved", "[0, 0, -0.2]");
    let quasi = ("analysis", "{ explicit = { quasi-static = { levels = 3 } } }");
    stopped_again_and_again("pressed-static", &text(RING), &[coarse, short], 3);
    stopped_again_and_again("pressed-marched", &text(RING), &[coarse, short, quasi], 4);
    let bits = |threads: usize| -> Vec<u64> {
        let replaced =
            [("geometry.cylinder.particles", "[201, 7]"), short, ("analysis", "{ static = { levels = 2 } }")];
        let outcome = overridden(&text(RING), "ring.toml", &replaced)
            .unwrap()
            .build(threads)
            .unwrap()
            .run(&mut coque::Silent);
        done(outcome).curve.rows.iter().flatten().map(|x| x.to_bits()).collect()
    };
    assert_eq!(bits(1), bits(3));
}

/// With and without time the same force; the law of marches is rounded, so that it lets in deeper by .05 of half a thickness.
#[test]
fn marches_and_statics_bear_the_same() {
    let coarse = ("geometry.cylinder.particles", "[21, 3]");
    let short = ("tools[0].moved", "[0, 0, -0.2]");
    let still = done(run(RING, &[coarse, short, ("analysis", "{ static = { levels = 1 } }")]));
    let marched =
        done(run(RING, &[coarse, short, ("analysis", "{ explicit = { quasi-static = { levels = 4 } } }")]));
    let sharp = done(run(
        RING,
        &[
            coarse,
            short,
            ("tools[0].rounding", "0"),
            ("analysis", "{ explicit = { quasi-static = { levels = 4 } } }"),
        ],
    ));
    let off = |outcome: &Outcome| last(outcome, "P") / last(&still, "P") - 1.0;
    println!("{:.1e} {:.1e}", off(&marched), off(&sharp));
    assert!(off(&sharp).abs() < 1e-3 && off(&marched).abs() < 1e-2);
}

const DROP: &str = r#"
title = "A plate dropped on a ball"
units = { length = "m", force = "N", time = "s" }
geometry.plate = { lengths = [1.0, 1.0], particles = [17, 17] }
material.elastic = { young = 1e9, poisson = 0.3, density = 1000.0 }
section.homogeneous.thickness = 0.05
velocity = { linear = [0.0, 0.0, -2.0] }
tools = [{ name = "ball", sphere = { centre = [0.5, 0.5, -0.53], radius = 0.5 } }]
analysis.explicit.transient = { duration = 0.05, record_every = 5e-4 }
curve = [{ name = "v", of = "velocity", on = "all", direction = [0, 0, 1] },
         { name = "F", of = "contact-force", on = "all", direction = [0, 0, 1] }]
"#;

/// It bounces with all of its energy: measured 5e-4 of it at most are missing on the way. Its mass, 50, takes the impulse of the ball.
#[test]
fn a_plate_that_is_dropped_on_a_ball_keeps_its_energy() {
    let outcome = done(ran(overridden(DROP, "drop.toml", &[])));
    let [kinetic, internal, external] =
        ["kinetic", "internal", "external"].map(|name| column(&outcome, name));
    let start = kinetic[0];
    assert!((start / 100.0 - 1.0).abs() < 1e-9, "{start}");
    let missing = (0..kinetic.len()).map(|i| (kinetic[i] + internal[i] - external[i] - start).abs() / start);
    let worst = missing.fold(0.0, f64::max);
    let force = column(&outcome, "F");
    let most = force.iter().copied().fold(0.0, f64::max);
    println!("missing {worst:.1e}, greatest force {most:.3e}, leaves with {:.3}", last(&outcome, "v"));
    assert!(worst < 1.5e-3, "{worst:.1e}");
    assert!(most > 0.0 && last(&outcome, "F") == 0.0 && last(&outcome, "v") > 0.5, "{most}");
}
