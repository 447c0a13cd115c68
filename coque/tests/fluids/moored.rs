//! Moorings in a fluid: cables that are slack, that are taut, on both sides of a box, with a dashpot.

use crate::common::fluids::AFLOAT;
use crate::common::sittings::stopped_again_and_again;
use crate::common::{Replaced, column, last, overridden, ran};
use coque::Outcome;

fn afloat(replaced: Replaced) -> Outcome {
    ran(overridden(AFLOAT, "afloat.toml", replaced))
}

const STILL: (&str, &str) = ("bodies.float.rigid.velocity", "{ linear = [0, 0, 0] }");

#[test]
fn a_slack_cable_changes_no_bit() {
    let cable =
        "[{ on = 'float.all', point = [0.24, 0.0, 0.0], length = 0.9, stiffness = 50.0, bears = 'tension' }]";
    let [free, moored] = [&[][..], &[("links", cable)]].map(afloat);
    for name in ["x", "y", "roll", "lift", "kinetic", "internal", "dissipated"] {
        assert_eq!(column(&free, name), column(&moored, name), "{name}");
    }
}

/// A box that rises and falls alone, on a cable straight down to the floor: while it is taut that is a spring with the force of its pretension beside it, `k (d − ℓ)` of
/// 5 N. Rounding alone: 1e-12 of the way.
#[test]
fn a_taut_cable_is_a_spring_and_its_pretension() {
    let held = "{ on = 'float.all', held = { displacement = [[1, 0, 0]], director = [[1, 0, 0]] } }";
    let light = ("bodies.float.rigid.density", "250.0");
    let cable = "[{ on = 'float.all', point = [0.24, 0.0, 0.0], length = 0.19, stiffness = 500.0, bears = 'tension' }]";
    let spring =
        format!("[{held}, {{ on = 'float.all', spring = {{ direction = [0, 1, 0], stiffness = 500.0 }} }}]");
    let force = "[{ on = 'all', gravity = { acceleration = [0.0, -10.0, 0.0] } }, { on = 'float.all', force = { total = [0, -5.0, 0] } }]";
    let moored = afloat(&[STILL, light, ("supports", &format!("[{held}]")), ("links", cable)]);
    let sprung = afloat(&[STILL, light, ("supports", &spring), ("loads", force)]);
    for (a, b) in column(&moored, "y").into_iter().zip(column(&sprung, "y")) {
        assert!((a - b).abs() < 1e-11 * 0.002, "{a} {b}");
    }
}

/// Two cables to the floor and a dashpot hold a box that drifts: it comes back, and the run goes on from a checkpoint to the same bits.
#[test]
fn two_cables_keep_a_box_from_drifting() {
    let links = "[
        { on = 'float.all', point = [0.1, 0.0, 0.0], length = 0.244, stiffness = 400.0, bears = 'tension' },
        { on = 'float.all', point = [0.38, 0.0, 0.0], length = 0.244, stiffness = 400.0, bears = 'tension' },
        { on = 'float.all', direction = [1, 0, 0], damping = 2.0 },
    ]";
    let drifts = ("bodies.float.rigid.velocity", "{ linear = [0.3, 0, 0] }");
    let [free, moored] = [&[drifts][..], &[drifts, ("links", links)]].map(afloat);
    assert!(last(&free, "x") > 2.0 * last(&moored, "x"), "{} {}", last(&free, "x"), last(&moored, "x"));
    let short = ("analysis.explicit.transient.duration", "0.05");
    stopped_again_and_again("moored", AFLOAT, &[drifts, ("links", links), short], 2);
}

#[test]
fn forces_of_links_and_joints_that_are_not_there_are_refused_with_their_key() {
    for (of, key) in [("link-force", "[[links]]"), ("joint-force", "[[joints]]")] {
        let curve = format!("[{{ name = 'f', of = '{of}', on = 'float.all', direction = [1, 0, 0] }}]");
        let error = overridden(AFLOAT, "afloat.toml", &[("curve", &curve), ("output", "{}")]).unwrap_err();
        assert!(error.fault().repair.contains(key), "{error}");
    }
}
