//! Joints of rigid bodies in a fluid: beside supports that say the same, momentum, kept and resumed.

use crate::common::fluids::AFLOAT;
use crate::common::sittings::stopped_again_and_again;
use crate::common::{Replaced, column, last, overridden, ran};
use coque::Outcome;

fn afloat(replaced: Replaced) -> Outcome {
    ran(overridden(AFLOAT, "afloat.toml", replaced))
}

const CURVE: &str = "[
    { name = 'x', of = 'displacement', on = 'float.all', direction = [1, 0, 0] },
    { name = 'y', of = 'displacement', on = 'float.all', direction = [0, 1, 0] },
    { name = 'roll', of = 'rotation', on = 'float.all', direction = [0, 0, 1] },
    { name = 'lift', of = 'force', on = 'float.all', direction = [0, 1, 0] },
    { name = 'borne', of = 'BORNE', on = 'float.all', direction = [0, 1, 0] },
    { name = 'across', of = 'BORNE', on = 'float.all', direction = [1, 0, 0] },
]";

/// A hinge at the centre is a support that holds the centre, a slider along y one that lets it rise alone: paths and what they bear are the same to rounding,
/// which grows to 1e-9 in two hundred steps of water.
#[test]
fn a_joint_at_the_centre_is_the_support_that_says_the_same() {
    let joint = |kind: &str| format!("[{{ on = 'float', at = [0.24, 0.2, 0.0], {kind} }}]");
    let held = |way: &str| format!("[{{ on = 'float.all', held = {way} }}]");
    let velocity = "bodies.float.rigid.velocity";
    let cases = [
        (
            joint("hinge.axis = [0, 0, 1]"),
            held("{ displacement = [[1, 0, 0], [0, 1, 0]] }"),
            "{ spin = { axis = [0, 0, 1], point = [0.24, 0.2, 0.0], rate = 2.0 } }",
            "roll",
        ),
        (
            joint("slider.axis = [0, 2, 0]"),
            held("{ displacement = [[1, 0, 0]], director = [[1, 0, 0]] }"),
            "{ linear = [0.0, 0.2, 0.0] }",
            "y",
        ),
    ];
    let [of_joint, of_support] = ["joint-force", "reaction"].map(|word| CURVE.replace("BORNE", word));
    for (joints, supports, start, moves) in &cases {
        let jointed = afloat(&[("curve", &of_joint), ("joints", joints), (velocity, start)]);
        let held = afloat(&[("curve", &of_support), ("supports", supports), (velocity, start)]);
        assert!(last(&held, moves).abs() > 1e-3, "{moves}");
        for name in ["x", "y", "roll", "lift", "borne", "across", "kinetic"] {
            let [one, other] = [&jointed, &held].map(|outcome| column(outcome, name));
            let most = other.iter().fold(1e-3_f64, |most, value| most.max(value.abs()));
            for (a, b) in one.into_iter().zip(other) {
                assert!((a - b).abs() < 1e-7 * most, "{name} of {joints}: {a} {b}");
            }
        }
    }
}

/// Two boxes in flight, hinged to each other, the lower of which a jet hits: momentum of water and boxes stays what it was. Both are so heavy that they take one step in one
/// of the water.
#[test]
fn hinged_boxes_keep_the_momentum_of_a_jet() {
    let outcome = ran(overridden(HINGED, "hinged.toml", &[]));
    let at = |name: &str| column(&outcome, name);
    let (water, lower, upper) = (60.0 * 0.02 * 0.02 * 1000.0, 500.0 * 0.12 * 0.24, 1500.0 * 0.12 * 0.12);
    for (axis, start) in [("u", 2.0 * water), ("v", 0.0)] {
        let [of_water, of_lower, of_upper] =
            ["water", "lower", "upper"].map(|body| at(&format!("{axis}_{body}")));
        for ((a, b), c) in of_water.iter().zip(&of_lower).zip(&of_upper).skip(1) {
            let sum = water * a + lower * b + upper * c;
            assert!((sum - start).abs() < 1e-11 * 2.0 * water, "{axis}: {}", sum - start);
        }
    }
    assert!(last(&outcome, "turn").abs() > 0.01, "the hinge bends: {}", last(&outcome, "turn"));
    let [up, down] = ["on_upper", "on_lower"].map(at);
    assert!(up.iter().any(|force| force.abs() > 1.0) && up.iter().zip(&down).all(|(a, b)| *a == -b));
}

#[test]
fn a_jointed_run_goes_on_to_the_same_bits() {
    let short = ("analysis.explicit.transient.duration", "0.06");
    stopped_again_and_again("hinged", HINGED, &[short], 2);
}

const HINGED: &str = r#"title = "A jet hits two boxes"
units = { length = "m", force = "N", time = "s" }
analysis.explicit.transient = { duration = 0.1, record_every = 0.02 }
joints = [{ name = "pin", on = "upper", to = "lower", at = [0.3, 0.15, 0.05], hinge.axis = [0, 0, 1] }]
curve = [
    { name = "u_water", of = "velocity", on = "water.all", take = "mean", direction = [1, 0, 0] },
    { name = "v_water", of = "velocity", on = "water.all", take = "mean", direction = [0, 1, 0] },
    { name = "u_lower", of = "velocity", on = "lower.all", direction = [1, 0, 0] },
    { name = "v_lower", of = "velocity", on = "lower.all", direction = [0, 1, 0] },
    { name = "u_upper", of = "velocity", on = "upper.all", direction = [1, 0, 0] },
    { name = "v_upper", of = "velocity", on = "upper.all", direction = [0, 1, 0] },
    { name = "turn", of = "rotation", on = "upper.all", direction = [0, 0, 1] },
    { name = "on_upper", of = "joint-force", on = "upper.all", joint = "pin", direction = [1, 0, 0] },
    { name = "on_lower", of = "joint-force", on = "lower.all", direction = [1, 0, 0] },
]
[bodies.water.fluid]
geometry.block = { lengths = [0.24, 0.1], spacing = 0.02 }
material.liquid = { density = 1000.0, sound_speed = 30.0 }
velocity.linear = [2.0, 0.0, 0.0]
[bodies.lower.rigid]
geometry.box = { min = [0.24, -0.1, 0.0], max = [0.36, 0.14, 0.1], spacing = 0.12 }
density = 500.0
[bodies.upper.rigid]
geometry.box = { min = [0.24, 0.16, 0.0], max = [0.36, 0.28, 0.1], spacing = 0.12 }
density = 1500.0
"#;
