//! Shells that touch themselves, in scenes: what is refused, the same bits after a stop, the force with and without time.

#![allow(clippy::unwrap_used)] // a failed test may stop here

mod common;

use common::sittings::stopped_again_and_again;
use common::{Replaced, column, overridden, run, text};
use coque::{Ended, Rendering, render};

const RING: &str = "ring-in-itself.toml";
const COARSE: (&str, &str) = ("geometry.cylinder.particles", "[21, 3]");

fn refused(replaced: Replaced) -> String {
    match overridden(&text(RING), "ring.toml", replaced).and_then(|scene| scene.build(1).map(|_| ())) {
        Ok(()) => "not refused".into(),
        Err(error) => render(&error, Rendering { width: 400, colour: false }),
    }
}

#[test]
fn broken_contacts_say_where_and_why() {
    let tube =
        ("geometry.cylinder", "{ radius = 1.0, angles = [0.0, 359.0], length = 0.1, particles = [360, 3] }");
    let still = ("analysis", "{ explicit = { transient = { duration = 1.0, record_every = 0.1 } } }");
    let thin = ("parts", "[{ on = 'upper', section = { homogeneous = { thickness = 0.04 } } }]");
    let cases: [(&str, Replaced, &str); 7] = [
        (
            "two bodies",
            &[("contact", "[{ between = ['a', 'b'] }]")],
            "a shell, a solid or a rigid body of the scene",
        ),
        ("twice", &[("contact", "[{}, {}]")], "another contact"),
        ("a linear analysis", &[("analysis", "{ linear = {} }")], "nothing opens or closes"),
        ("a stiffness of zero", &[("contact", "[{ stiffness = 0.0 }]")], "contact[0].stiffness"),
        ("rounded into the barrier", &[("contact", "[{ rounding = 0.2 }]")], "contact[0].rounding"),
        ("ends that stand in each other", &[tube, still, ("supports", "[]"), ("loads", "[]")], "apart"),
        ("two thicknesses", &[thin], "has one thickness"),
    ];
    for (name, replaced, words) in cases {
        let said = refused(replaced);
        assert!(said.contains(words), "{name}: {said}");
    }
}

/// Stopped again and again, before walls touch and while they do.
#[test]
fn contact_goes_on_to_the_same_bits() {
    let thrown = [
        COARSE,
        ("analysis", "{ explicit = { transient = { duration = 1.6, record_every = 0.1 } } }"),
        ("velocity", "{ on = 'upper', linear = [0.0, 0.0, -2.5] }"),
        ("loads", "[]"),
    ];
    stopped_again_and_again("thrown", &text(RING), &thrown, 2);
}

/// Walls that press on each other do so as hard in a march that comes to rest.
#[test]
fn marches_and_statics_press_alike() {
    let force = |analysis: &str| {
        let outcome = run(RING, &[COARSE, ("analysis", analysis)]);
        assert_eq!(outcome.ended, Ended::Done, "{}", outcome.summary.ended);
        column(&outcome, "F").last().copied().unwrap()
    };
    let still = force("{ static = { levels = [0.28, 0.31, 0.35, 0.45, 0.6] } }");
    let marched = force("{ explicit = { quasi-static = { levels = [0.28, 0.35, 0.45, 0.6] } } }");
    println!("{still:.5} {marched:.5}");
    assert!(still > 0.5 && (marched / still - 1.0).abs() < 0.02, "{still} {marched}");
}
