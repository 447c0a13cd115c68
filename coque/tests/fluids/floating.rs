//! Rigid bodies in fluids: Archimedes, momentum, added mass, light ones, walls that they touch; relations between two runs; what is refused.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::fluids::AFLOAT;
use crate::common::refused::refused;
use crate::common::sittings::stopped_again_and_again;
use crate::common::{Replaced, column, last, overridden, ran};
use coque::Outcome;

fn afloat(replaced: Replaced) -> Outcome {
    ran(overridden(AFLOAT, "afloat.toml", replaced))
}

const BOX: &str = "bodies.float.rigid.geometry.box";
const VELOCITY: &str = "bodies.float.rigid.velocity";
const STILL: (&str, &str) = (VELOCITY, "{ linear = [0, 0, 0] }");
const DURATION: &str = "analysis.explicit.transient.duration";
/// A cube under water that fills .4 m, .06 m from the floor.
const DEEP: [(&str, &str); 4] = [
    STILL,
    (BOX, "{ min = [0.22, 0.1, -0.04], max = [0.38, 0.26, 0.04], spacing = 0.08 }"),
    ("bodies.water.fluid.geometry.block.lengths", "[0.6, 0.4]"),
    ("bodies.tank.walls.geometry.basin.max", "[0.6, 0.6]"),
];

/// Mean of a column from a row on.
fn mean(outcome: &Outcome, name: &str, from: usize) -> f64 {
    let all = column(outcome, name);
    all[from..].iter().sum::<f64>() / (all.len() - from) as f64
}

/// Greatest difference of a column over its greatest value, the other's times a factor.
fn apart(one: &Outcome, other: &Outcome, name: &str, factor: f64) -> f64 {
    let [one, other] = [one, other].map(|outcome| column(outcome, name));
    let most = one.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    one.iter().zip(&other).fold(0.0_f64, |most, (x, y)| most.max((x - factor * y).abs())) / most
}

/// Held under water it is lifted by the weight of the water that it displaces, 256 N/m: .04 % measured here, .3 % in other tanks, where particles settle.
#[test]
fn a_body_that_is_held_is_lifted_by_what_it_displaces() {
    let held = [
        DEEP[0],
        DEEP[1],
        DEEP[2],
        DEEP[3],
        (DURATION, "1.0"),
        ("supports", "[{ on = 'float.all', clamped = {} }]"),
    ];
    let outcome = afloat(&held);
    let lift = mean(&outcome, "lift", 30);
    assert!((lift / 256.0 - 1.0).abs() < 0.005, "{lift}");
    let line = |line: &String| line.contains("64 particles of the geometry left out");
    assert!(outcome.summary.body.modelled.iter().any(line), "{:?}", outcome.summary.body.modelled);
}

/// A body as dense as water stays where it is, to the settling of particles: .004 spacings measured.
#[test]
fn a_body_of_waters_density_stays_where_it_is() {
    let outcome = afloat(&[
        DEEP[0],
        DEEP[1],
        DEEP[2],
        DEEP[3],
        (DURATION, "0.4"),
        ("bodies.float.rigid.density", "1000.0"),
    ]);
    for name in ["x", "y"] {
        assert!(column(&outcome, name).iter().all(|way| way.abs() < 0.02 * 0.02), "{name}");
    }
}

/// Let go under water, bodies from a tenth of its density to four times sink or rise by `(m − ρV) g/(m + a)`: with the one added mass a. From the way in .06 s;
/// that of a square is 1.19 ρV without walls, which are near here, and the layers of friction about it add to that: 1.33 to 1.36 measured.
#[test]
fn all_densities_find_the_same_added_mass() {
    let added = |density: &str| {
        let outcome = afloat(&[
            DEEP[0],
            DEEP[1],
            DEEP[2],
            DEEP[3],
            (DURATION, "0.06"),
            ("bodies.float.rigid.density", density),
        ]);
        let acceleration = -2.0 * last(&outcome, "y") / (0.06 * 0.06);
        let ratio: f64 = density.parse::<f64>().unwrap() / 1000.0;
        (ratio - 1.0) * 10.0 / acceleration - ratio
    };
    let found = ["100.0", "500.0", "2000.0", "4000.0"].map(added);
    let mean = found.iter().sum::<f64>() / 4.0;
    assert!(mean > 1.19 && mean < 1.6, "{found:?}");
    assert!(found.iter().all(|own| (own / mean - 1.0).abs() < 0.06), "{found:?}");
}

/// A jet hits a body in flight: momentum and moment of momentum of both stay what they were. One step of the body in one of the water.
#[test]
fn momentum_goes_from_the_water_to_the_body() {
    let outcome = ran(overridden(JET, "jet.toml", &[]));
    let at = |name: &str| column(&outcome, name);
    let (water, body) = (60.0 * 0.02 * 0.02 * 1000.0, 500.0 * 0.12 * 0.24);
    for (axis, start) in [("u", 2.0 * water), ("v", 0.0)] {
        let [of_water, of_body] = [format!("{axis}_water"), format!("{axis}_body")].map(|name| at(&name));
        for (a, b) in of_water.iter().zip(&of_body).skip(1) {
            assert!(
                (water * a + body * b - start).abs() < 1e-12 * 2.0 * water,
                "{axis}: {}",
                water * a + body * b - start
            );
        }
    }
    let turned = at("roll").last().copied().unwrap();
    assert!(turned.abs() > 0.01, "it turns: {turned}");
}

const JET: &str = r#"title = "A jet hits a body"
units = { length = "m", force = "N", time = "s" }
analysis.explicit.transient = { duration = 0.1, record_every = 0.02 }
curve = [
    { name = "u_water", of = "velocity", on = "water.all", take = "mean", direction = [1, 0, 0] },
    { name = "v_water", of = "velocity", on = "water.all", take = "mean", direction = [0, 1, 0] },
    { name = "u_body", of = "velocity", on = "body.all", direction = [1, 0, 0] },
    { name = "v_body", of = "velocity", on = "body.all", direction = [0, 1, 0] },
    { name = "roll", of = "rotation", on = "body.all", direction = [0, 0, 1] },
]
[bodies.water.fluid]
geometry.block = { lengths = [0.24, 0.1], spacing = 0.02 }
material.liquid = { density = 1000.0, sound_speed = 30.0 }
velocity.linear = [2.0, 0.0, 0.0]
[bodies.body.rigid]
geometry.box = { min = [0.24, -0.1, 0.0], max = [0.36, 0.14, 0.1], spacing = 0.12 }
density = 500.0
"#;

/// A hundredth as dense as water it swings as a tenth does, in many steps of its own to one of the water: the balance closes to a hundredth.
#[test]
fn a_light_body_swings_and_gains_nothing() {
    let outcome = afloat(&[STILL, (DURATION, "0.6"), ("bodies.float.rigid.density", "10.0")]);
    let record = &outcome.summary.record;
    let figures = record.fluid.as_ref().unwrap();
    assert!(figures.most_substeps > 5, "{}", figures.most_substeps);
    let balance = record.balance.as_ref().unwrap();
    assert!(balance.worst.abs() < 0.02 * balance.turned_over, "{balance:?}");
    assert!(column(&outcome, "y").iter().all(|y| y.abs() < 0.15));
}

/// It falls to the floor, which its coat presses on, and lets no water below it: what bears it there is its weight and what the water presses on it.
#[test]
fn a_heavy_body_rests_on_the_floor() {
    let heavy = [
        STILL,
        (BOX, "{ min = [0.22, 0.04, -0.04], max = [0.38, 0.12, 0.04], spacing = 0.08 }"),
        ("bodies.float.rigid.density", "2500.0"),
        ("bodies.float.rigid.coat", "{ young = 1e5, thickness = 0.004 }"),
        ("contact", "[{ between = ['float', 'tank'] }]"),
        ("curve[+]", "{ name = 'C', of = 'contact-force', on = 'float.all', direction = [0, 1, 0] }"),
        (DURATION, "1.0"),
    ];
    let outcome = afloat(&heavy);
    let [borne, lift] = ["C", "lift"].map(|name| mean(&outcome, name, 50));
    let (weight, width) = (2500.0 * 10.0 * 0.16 * 0.08 * 0.08, 0.08);
    assert!(borne > weight, "the water presses on it: {borne}");
    assert!((borne / (weight - width * lift) - 1.0).abs() < 0.02, "{borne} {weight} {lift}");
    assert!((last(&outcome, "y") + 0.04).abs() < 0.005, "{}", last(&outcome, "y"));
}

/// In the mirror of x.
#[test]
fn mirrored_it_is_the_same() {
    let (one, other) = (
        afloat(&[]),
        afloat(&[
            (BOX, "{ min = [0.28, 0.14, -0.04], max = [0.44, 0.26, 0.04], spacing = 0.04 }"),
            (
                VELOCITY,
                "{ linear = [-0.2, 0.0, 0.0], spin = { axis = [0, 0, 1], point = [0.36, 0.2, 0.0], rate = -2.0 } }",
            ),
        ]),
    );
    for (name, factor) in [("x", -1.0), ("y", 1.0), ("roll", -1.0), ("lift", 1.0)] {
        let off = apart(&one, &other, name, factor);
        assert!(off < 1e-7, "{name}: {off:e}");
    }
    let turned = column(&one, "roll").iter().fold(0.0_f64, |most, roll| most.max(roll.abs()));
    assert!(turned > 0.01, "{turned}");
}

/// In mm, N and s.
#[test]
fn in_other_units_it_is_the_same() {
    let scaled = [
        ("units", "{ length = 'mm', force = 'N', time = 's' }"),
        ("loads[0].gravity.acceleration", "[0, -10000.0, 0]"),
        ("bodies.water.fluid.geometry.block", "{ lengths = [600.0, 200.0], spacing = 20.0 }"),
        ("bodies.water.fluid.material.liquid", "{ density = 1000e-12, sound_speed = 20000.0 }"),
        ("bodies.tank.walls.geometry.basin", "{ min = [0.0, 0.0], max = [600.0, 400.0], open = ['y1'] }"),
        (BOX, "{ min = [160.0, 140.0, -40.0], max = [320.0, 260.0, 40.0], spacing = 40.0 }"),
        ("bodies.float.rigid.density", "500e-12"),
        (
            VELOCITY,
            "{ linear = [200.0, 0.0, 0.0], spin = { axis = [0, 0, 1], point = [240.0, 200.0, 0.0], rate = 2.0 } }",
        ),
    ];
    let (one, other) = (afloat(&[]), afloat(&scaled));
    for (name, factor) in [("x", 1e-3), ("y", 1e-3), ("roll", 1.0), ("lift", 1e3)] {
        let off = apart(&one, &other, name, factor);
        assert!(off < 1e-7, "{name}: {off:e}");
    }
}

/// Seen by one who moves against it: the jet and the body without walls.
#[test]
fn moved_against_moved_it_is_the_same() {
    let moved = [
        ("bodies.water.fluid.velocity.linear", "[1.0, 0.5, 0.0]"),
        ("bodies.body.rigid.velocity", "{ linear = [-1.0, 0.5, 0.0] }"),
    ];
    let (one, other) = (ran(overridden(JET, "jet.toml", &[])), ran(overridden(JET, "jet.toml", &moved)));
    for (name, by) in [("u_body", 1.0), ("v_body", -0.5), ("roll", 0.0)] {
        let [one, other] = [&one, &other].map(|outcome| column(outcome, name));
        let off = one.iter().zip(&other).fold(0.0_f64, |off, (x, y)| off.max((x - y - by).abs()));
        let [least, most] = [f64::min, f64::max].map(|of| one.iter().copied().reduce(of).unwrap());
        // Sums of numbers that are moved round otherwise: 3.3e-14 of its own range measured.
        assert!(off < 1e-13 * (most - least), "{name}: {off:e} {least} {most}");
    }
}

/// Two bodies afloat: whichever comes first by its name, their motions are the same but for the order of sums; and the same bits for any threads.
#[test]
fn whichever_is_first_it_is_the_same() {
    let second = |name: &str| {
        AFLOAT.replace("bodies.float", &format!("bodies.{name}")).replace("float.all", &format!("{name}.all"))
            + "[bodies.middle.rigid]\ngeometry.box = { min = [0.4, 0.14, -0.04], max = [0.5, 0.26, 0.04], spacing = 0.1 }\ndensity = 400.0\n"
    };
    let [first, last] = ["first", "second"].map(|name| ran(overridden(&second(name), "two.toml", &[])));
    for name in ["x", "y", "roll", "lift"] {
        let off = apart(&first, &last, name, 1.0);
        assert!(off < 1e-7, "{name}: {off:e}");
    }
    let scene = overridden(AFLOAT, "afloat.toml", &[]).unwrap();
    let one = afloat(&[]).curve.rows;
    for threads in [2, 3] {
        assert_eq!(scene.build(threads).unwrap().run(&mut coque::Silent).curve.rows, one, "{threads}");
    }
}

/// Moored by a spring to the ground, to a body that is held, or to one that is moved by nothing: the first two are the same to rounding; between two that are free
/// the spring gives each what it takes of the other.
#[test]
fn a_spring_to_a_body_that_is_held_is_one_to_the_ground() {
    let post = "[bodies.post.rigid]\ngeometry.box = { min = [0.4, 0.14, -0.04], max = [0.5, 0.26, 0.04], spacing = 0.1 }\ndensity = 400.0\n";
    let with_post = AFLOAT.to_string() + post;
    let spring = |to: &str| {
        format!("{{ on = 'float.all', spring = {{ direction = [1, 0, 0], stiffness = 50.0{to} }} }}")
    };
    let held = "{ on = 'post.all', clamped = {} }";
    let to_ground = format!("[{}, {held}]", spring(""));
    let to_post = format!("[{}, {held}]", spring(", to = 'post.all'"));
    let moored = |supports: &str| ran(overridden(&with_post, "moored.toml", &[("supports", supports)]));
    let [ground, body] = [&to_ground, &to_post].map(|supports| moored(supports));
    for name in ["x", "y", "roll"] {
        let off = apart(&ground, &body, name, 1.0);
        assert!(off < 1e-7, "{name}: {off:e}");
    }
    let loose = ran(overridden(&with_post, "moored.toml", &[("supports", &format!("[{held}]"))]));
    let [drifted, kept] = [&loose, &body].map(|outcome| last(outcome, "x"));
    assert!(kept < 0.9 * drifted, "{kept} {drifted}");
    let springs = |line: &String| line.contains("springs between bodies: 1");
    assert!(body.summary.body.modelled.iter().any(springs));
}

/// Between two that are free a spring takes of each what it gives the other: with the water that hits one of them momentum stays what it was.
#[test]
fn a_spring_between_free_bodies_keeps_momentum() {
    let second = "[bodies.other.rigid]\ngeometry.box = { min = [0.5, -0.1, 0.0], max = [0.62, 0.14, 0.1], spacing = 0.12 }\ndensity = 300.0\n";
    let way = |name: &str| {
        format!("{{ name = '{name}', of = 'velocity', on = '{name}.all', direction = [1, 0, 0] }}")
    };
    let curve = format!(
        "[{}, {}, {{ name = 'water', of = 'velocity', on = 'water.all', take = 'mean', direction = [1, 0, 0] }}]",
        way("body"),
        way("other")
    );
    let joined = |on: &str, to: &str| {
        let spring = format!(
            "[{{ on = '{on}.all', spring = {{ direction = [1, 0, 0], stiffness = 2e4, to = '{to}.all' }} }}]"
        );
        ran(overridden(&format!("{JET}{second}"), "jet.toml", &[("curve", &curve), ("supports", &spring)]))
    };
    let (one, other) = (joined("body", "other"), joined("other", "body"));
    let [water, body, second] = ["water", "body", "other"].map(|name| column(&one, name));
    let masses = [60.0 * 0.02 * 0.02 * 1000.0, 500.0 * 0.12 * 0.24, 300.0 * 0.12 * 0.24];
    for ((a, b), c) in water.iter().zip(&body).zip(&second) {
        let sum = masses[0] * a + masses[1] * b + masses[2] * c;
        assert!((sum - 2.0 * masses[0]).abs() < 1e-12 * 2.0 * masses[0], "{sum}");
    }
    assert!(second.iter().any(|speed| *speed > 0.1), "the spring takes it along: {second:?}");
    for name in ["body", "other", "water"] {
        let off = apart(&one, &other, name, 1.0);
        assert!(off < 1e-7, "whichever names the spring, {name}: {off:e}");
    }
}

#[test]
fn runs_go_on_to_the_same_bits() {
    stopped_again_and_again(
        "afloat",
        AFLOAT,
        &[(DURATION, "0.05"), ("bodies.float.rigid.density", "100.0")],
        3,
    );
}

/// A ball in space, four spacings in radius: its polyhedron and the sphere of rows behind its faces are lifted as the ball is, within 5 %.
#[test]
fn a_ball_in_space_is_lifted() {
    let outcome = ran(overridden(BALL, "ball.toml", &[]));
    let lift = mean(&outcome, "lift", 5);
    let exact = 1e4 * 4.0 / 3.0 * std::f64::consts::PI * 0.1_f64.powi(3);
    assert!((lift / exact - 1.0).abs() < 0.05, "{lift} {exact}");
}

const BALL: &str = r#"title = "A ball under water"
units = { length = "m", force = "N", time = "s" }
analysis.explicit.transient = { duration = 0.15, record_every = 0.01 }
loads = [{ on = "all", gravity = { acceleration = [0.0, 0.0, -10.0] } }]
curve = [{ name = "lift", of = "force", on = "float.all", direction = [0, 0, 1] }]
supports = [{ on = "float.all", clamped = {} }]
[bodies.water.fluid]
geometry.block = { lengths = [0.4, 0.4, 0.4], spacing = 0.025 }
material.liquid = { density = 1000.0, sound_speed = 25.0 }
[bodies.tank.walls]
geometry.basin = { min = [0.0, 0.0, 0.0], max = [0.4, 0.4, 0.5], open = ["z1"] }
[bodies.float.rigid]
geometry.ball = { centre = [0.2, 0.2, 0.2], radius = 0.1, spacing = 0.025 }
density = 500.0
"#;

#[test]
fn what_a_body_in_a_fluid_cannot_have_is_refused() {
    let geometry = "geometry.box = { min = [0.16, 0.14, -0.04], max = [0.32, 0.26, 0.04], spacing = 0.04 }";
    let cases = [
        (
            "a ball in a plane",
            geometry,
            "geometry.ball = { centre = [0.2, 0.2, 0.0], radius = 0.06, spacing = 0.02 }",
        ),
        ("a thin box", "max = [0.32, 0.26, 0.04]", "max = [0.18, 0.26, 0.04]"),
        ("a box between spacings", "max = [0.32, 0.26, 0.04]", "max = [0.25, 0.26, 0.04]"),
        ("a velocity out of the plane", "linear = [0.2, 0.0, 0.0]", "linear = [0.2, 0.0, 0.1]"),
        ("a spin out of the plane", "spin = { axis = [0, 0, 1]", "spin = { axis = [0, 1, 1]"),
        (
            "a support that moves it out of the plane",
            "[bodies.water.fluid]",
            "[[supports]]\non = \"float.all\"\nmoved = { direction = [0, 0, 1], by = 1.0 }\namplitude.ramp = 1.0\n[bodies.water.fluid]",
        ),
        (
            "contact with walls without a coat",
            "[bodies.water.fluid]",
            "[[contact]]\nbetween = [\"float\", \"tank\"]\n[bodies.water.fluid]",
        ),
        (
            "a spring to another body",
            "[bodies.water.fluid]",
            "[[supports]]\non = \"float.all\"\nspring = { direction = [0, 1, 0], stiffness = 1.0, to = \"water.all\" }\n[bodies.water.fluid]",
        ),
        (
            "a spring to another body out of the plane",
            "[bodies.water.fluid]",
            "[[supports]]\non = \"float.all\"\nspring = { direction = [0, 1, 1], stiffness = 1.0, to = \"post.all\" }\n[bodies.post.rigid]\ngeometry.box = { min = [0.4, 0.14, -0.04], max = [0.5, 0.26, 0.04], spacing = 0.1 }\ndensity = 400.0\n[bodies.water.fluid]",
        ),
        (
            "contact with walls that make waves",
            "[bodies.water.fluid]",
            "[[contact]]\nbetween = [\"float\", \"piston\"]\n[bodies.piston.walls]\ngeometry.block = { lengths = [0.08, 0.2], origin = [-0.08, 0.0] }\nmotion.waves = { height = 0.01, period = 0.5, depth = 0.2 }\n[bodies.water.fluid]",
        ),
    ];
    insta::assert_snapshot!(refused(AFLOAT, &cases));
}
