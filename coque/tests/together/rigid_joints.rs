//! Hinges, sliders and ball joints of rigid bodies: closed forms, relations, kept and resumed, refused.

use crate::common::refused::refused;
use crate::common::sittings::stopped_again_and_again;
use crate::common::{Replaced, column, overridden, ran, text};
use coque::Outcome;

const CRANK: &str = "slider-crank.toml";

/// The scene that is drawn; its numbers are some 1, rounding 1e-16 of that a step.
#[test]
fn a_piston_goes_where_its_crank_leads_it() {
    let outcome = ran(overridden(&text(CRANK), CRANK, &[]));
    let (r, l) = (0.1_f64, 0.3_f64);
    for (x, turn) in column(&outcome, "x").into_iter().zip(column(&outcome, "turn")) {
        let exact = r * libm::cos(turn) + (l * l - (r * libm::sin(turn)).powi(2)).sqrt() - r - l;
        assert!((x - exact).abs() < 1e-12, "{turn}: {x} {exact}");
    }
    let kinetic = column(&outcome, "kinetic");
    let off = kinetic.iter().map(|own| (own - kinetic[0]).abs()).fold(0.0, f64::max);
    assert!(off < 1e-4 * kinetic[0], "nothing takes energy: {off} {}", kinetic[0]);
    assert!(outcome.summary.body.modelled.iter().any(|line| line.starts_with("joints of rigid bodies: 4")));
}

/// The wheel led at ten radians a second: the pin gives the piston its mass times x¨ of the same formula, the rod feels the opposite. Half of the records are within 4e-8 of
/// m r ω²; where the step changes from one interval of records to the next, central differences are of the first order in that change, 4.7e-5 at worst: asked 1.5e-4.
#[test]
fn a_pin_bears_the_mass_of_the_piston_times_its_acceleration() {
    let pin = |name: &str, of: &str, on: &str, axis: [f64; 3]| {
        format!("{{ name = '{name}', of = '{of}', on = '{on}.all', joint = 'pin', direction = {axis:?} }}")
    };
    let curve = [
        pin("on_piston", "joint-force", "piston", [1.0, 0.0, 0.0]),
        pin("on_rod", "joint-force", "rod", [1.0, 0.0, 0.0]),
    ];
    let led = "[{ on = 'wheel.all', rotated = { axis = [0, 1, 0], by = 1375.0987083139758 }, amplitude = { table = [[0, 0], [2.4, 1]] } }]";
    let curve = format!("[{}]", curve.join(", "));
    let outcome =
        ran(overridden(&text(CRANK), CRANK, &[("curve", &curve), ("supports", led), ("output", "{}")]));
    let (r, l, omega, mass) = (0.1_f64, 0.3_f64, 10.0_f64, 2700.0 * 0.1 * 0.06 * 0.08);
    let mut all = Vec::new();
    let [times, on_piston, on_rod] = ["time", "on_piston", "on_rod"].map(|name| column(&outcome, name));
    for ((time, piston), rod) in times.into_iter().zip(on_piston).zip(on_rod) {
        let (sine, cosine) = (libm::sin(omega * time), libm::cos(omega * time));
        let reach = (l * l - (r * sine).powi(2)).sqrt();
        let bend = -r * r * (cosine * cosine - sine * sine) / reach
            - r.powi(4) * (sine * cosine).powi(2) / reach.powi(3);
        let exact = mass * omega * omega * (bend - r * cosine);
        all.push((piston - exact).abs() / (mass * r * omega * omega));
        assert_eq!(piston, -rod);
    }
    all.sort_by(f64::total_cmp);
    let (median, worst) = (all[all.len() / 2], all[all.len() - 1]);
    println!("pin: median {median:e}, worst {worst:e}");
    assert!(worst < 1.5e-4, "{worst}");
}

/// A bar let go level: its hinge bears `m (a − g)` of the closed form at the angle that is found, and no moment about its axis. Steps of 1/5000 s of a period of 1.8 s: asked 1e-5 of
/// the weight.
#[test]
fn a_hinge_bears_a_pendulum() {
    let bar = r#"title = "A pendulum"
units = { length = "m", force = "N", time = "s" }
analysis.explicit.transient = { duration = 0.8, record_every = 0.02 }
loads = [{ on = "all", gravity = { acceleration = [0.0, 0.0, -10.0] } }]
joints = [{ on = "bar", at = [0.0, 0.0, 0.0], hinge.axis = [0.0, 1.0, 0.0] }]
curve = [
    { name = "turn", of = "rotation", on = "bar.all", direction = [0, 1, 0] },
    { name = "x", of = "joint-force", on = "bar.all", direction = [1, 0, 0] },
    { name = "z", of = "joint-force", on = "bar.all", direction = [0, 0, 1] },
    { name = "couple", of = "joint-moment", on = "bar.all", direction = [0, 1, 0] },
    { name = "about_end", of = "joint-moment", on = "bar.all", direction = [0, 1, 0], about = [1.0, 0.0, 0.0] },
]
[bodies.bar.rigid]
geometry.box = { min = [0.0, -0.1, -0.1], max = [1.0, 0.1, 0.1], spacing = 0.5 }
density = 100.0
"#;
    let outcome = ran(overridden(bar, "pendulum.toml", &[]));
    let (mass, arm, g) = (4.0, 0.5, 10.0);
    let inertia = mass * (1.04 / 12.0 + arm * arm);
    let all = ["turn", "x", "z", "couple", "about_end"].map(|name| column(&outcome, name));
    for i in 0..all[0].len() {
        let [turn, x, z, couple, about_end] = [0, 1, 2, 3, 4].map(|k| all[k][i]);
        let (sine, cosine) = (libm::sin(turn), libm::cos(turn));
        let [square, rate] = [2.0 * sine, cosine].map(|part| mass * g * arm * part / inertia);
        let exact = [
            -mass * arm * (cosine * square + sine * rate),
            mass * (g + arm * (sine * square - cosine * rate)),
        ];
        let off = (x - exact[0]).abs().max((z - exact[1]).abs()) / (mass * g);
        assert!(off < 1e-5, "{turn}: {x} {z} {exact:?}");
        assert!(couple.abs() < 1e-12 * mass * g, "{couple}");
        // Of a force at the origin about a place a metre along x.
        assert!((about_end - z).abs() < 1e-12 * mass * g, "{about_end} {z}");
    }
}

/// A bar on a hinge, a second one on a ball joint to it, on a spring besides, under gravity.
const CHAIN: &str = r#"title = "A chain"
units = { length = "m", force = "N", time = "s" }
analysis.explicit.transient = { duration = 0.6, record_every = 0.02 }
loads = [{ on = "all", gravity = { acceleration = [0.0, 0.0, -10.0] } }]
curve = [
    { name = "x", of = "displacement", on = "b.all", direction = [1, 0, 0] },
    { name = "z", of = "displacement", on = "b.all", direction = [0, 0, 1] },
    { name = "turn", of = "rotation", on = "a.all", direction = [0, 1, 0] },
]
joints = [
    { on = "a", at = [0.0, 0.0, 0.0], hinge.axis = [0.2, 1.0, 0.0] },
    { on = "b", to = "a", at = [1.0, 0.0, 0.0], ball = {} },
]
links = [{ on = "b.all", point = [1.5, 0.0, 1.0], length = 0.9, stiffness = 30.0, bears = "tension" }]
[bodies.a.rigid]
geometry.box = { min = [0.0, -0.1, -0.1], max = [1.0, 0.1, 0.1], spacing = 0.5 }
density = 100.0
[bodies.b.rigid]
geometry.box = { min = [1.0, -0.2, -0.1], max = [2.0, 0.2, 0.1], spacing = 0.5 }
density = 100.0
"#;

fn chain(replaced: Replaced) -> Outcome {
    ran(overridden(CHAIN, "chain.toml", replaced))
}

/// Greatest difference of each column over its greatest value; the other's times a factor each.
fn apart(one: &Outcome, other: &Outcome, factors: [f64; 3]) -> f64 {
    let each = ["x", "z", "turn"].into_iter().zip(factors).map(|(name, factor)| {
        let [one, other] = [one, other].map(|outcome| column(outcome, name));
        let most = one.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        assert!(most > 0.1, "{name}");
        one.iter().zip(&other).fold(0.0_f64, |most, (x, y)| most.max((x - factor * y).abs())) / most
    });
    each.fold(0.0, f64::max)
}

/// Rounding alone: below 1e-12 of the greatest value in some hundred steps.
#[test]
fn mirrored_turned_in_other_units_and_renamed_it_is_the_same() {
    let still = chain(&[]);
    let [kinetic, internal, external] = ["kinetic", "internal", "external"].map(|name| column(&still, name));
    let sum = |i: usize| kinetic[i] + internal[i] - external[i];
    let off = (0..kinetic.len()).map(|i| (sum(i) - sum(0)).abs()).fold(0.0, f64::max);
    let most = kinetic.iter().copied().fold(0.0, f64::max);
    assert!(off < 1e-4 * most, "{off} {most}");
    let mirrored = chain(&[
        ("curve[2].direction", "[0, -1, 0]"),
        ("curve[0].direction", "[-1, 0, 0]"),
        ("joints[0].hinge.axis", "[-0.2, 1.0, 0.0]"),
        ("joints[1].at", "[-1, 0, 0]"),
        ("links[0].point", "[-1.5, 0.0, 1.0]"),
        ("bodies.a.rigid.geometry.box", "{ min = [-1.0, -0.1, -0.1], max = [0.0, 0.1, 0.1], spacing = 0.5 }"),
        (
            "bodies.b.rigid.geometry.box",
            "{ min = [-2.0, -0.2, -0.1], max = [-1.0, 0.2, 0.1], spacing = 0.5 }",
        ),
    ]);
    let found = apart(&still, &mirrored, [1.0; 3]);
    assert!(found < 1e-10, "mirrored: {found}");
    // x becomes y, y becomes z, z becomes x.
    let turned = chain(&[
        ("loads[0].gravity.acceleration", "[-10, 0, 0]"),
        ("curve[0].direction", "[0, 1, 0]"),
        ("curve[1].direction", "[1, 0, 0]"),
        ("curve[2].direction", "[0, 0, 1]"),
        ("joints[0].hinge.axis", "[0, 0.2, 1.0]"),
        ("joints[1].at", "[0, 1, 0]"),
        ("links[0].point", "[1.0, 1.5, 0.0]"),
        ("bodies.a.rigid.geometry.box", "{ min = [-0.1, 0.0, -0.1], max = [0.1, 1.0, 0.1], spacing = 0.5 }"),
        ("bodies.b.rigid.geometry.box", "{ min = [-0.1, 1.0, -0.2], max = [0.1, 2.0, 0.2], spacing = 0.5 }"),
    ]);
    let found = apart(&still, &turned, [1.0; 3]);
    assert!(found < 1e-10, "turned: {found}");
    // The other body first by name, and the joint from its other side.
    let renamed = ran(overridden(
        &CHAIN
            .replace("bodies.b.", "bodies.A.")
            .replace("\"b.all\"", "\"A.all\"")
            .replace("on = \"b\", to = \"a\"", "on = \"a\", to = \"A\""),
        "chain.toml",
        &[],
    ));
    let found = apart(&still, &renamed, [1.0; 3]);
    assert!(found < 1e-10, "renamed: {found}");
    let small = chain(&[
        ("units.length", "'mm'"),
        ("loads[0].gravity.acceleration", "[0, 0, -10000]"),
        ("joints[1].at", "[1000, 0, 0]"),
        ("links[0].point", "[1500, 0, 1000]"),
        ("links[0].length", "900"),
        ("links[0].stiffness", "0.03"),
        ("bodies.a.rigid.geometry.box", "{ min = [0, -100, -100], max = [1000, 100, 100], spacing = 500 }"),
        (
            "bodies.b.rigid.geometry.box",
            "{ min = [1000, -200, -100], max = [2000, 200, 100], spacing = 500 }",
        ),
        ("bodies.a.rigid.density", "1e-10"),
        ("bodies.b.rigid.density", "1e-10"),
    ]);
    let found = apart(&still, &small, [1e-3, 1e-3, 1.0]);
    assert!(found < 1e-10, "in millimetres: {found}");
}

/// Two bars drawn through each other about their pin are meant to pass; a third one that comes through both is seen.
#[test]
fn bars_about_a_pin_may_lie_in_each_other() {
    let post = "[bodies.post.rigid]\ngeometry.box = { min = [1.2, -0.3, -3.0], max = [1.5, 0.3, -0.25], spacing = 0.25 }\nmass = 1.0\n";
    let seen = |text: &str, supports: &str| {
        let replaced = [
            ("joints[1].at", "[0.95, 0.0, 0.0]"),
            ("joints[0].hinge.axis", "[0, 1, 0]"),
            ("bodies.b.rigid.geometry.box.min", "[0.9, -0.2, -0.15]"),
            ("supports", supports),
        ];
        let warnings = ran(overridden(text, "pinned.toml", &replaced)).summary.record.warnings;
        let touching = warnings.into_iter().filter(|own| own.kind == coque::WarningKind::TouchingUnseen);
        touching.map(|own| own.message).collect::<Vec<_>>()
    };
    assert_eq!(seen(CHAIN, "[]"), Vec::<String>::new());
    let all = seen(&format!("{CHAIN}{post}"), "[{ on = 'post.all', clamped = {} }]");
    assert!(all.iter().any(|message| message.contains("`post`")), "{all:?}");
}

#[test]
fn a_stopped_run_goes_on_to_the_same_bits() {
    stopped_again_and_again("rigid-joints", CHAIN, &[("analysis.explicit.transient.duration", "0.2")], 3);
}

#[test]
fn what_a_joint_cannot_be_is_refused() {
    let ball = "{ on = \"b\", to = \"a\", at = [1.0, 0.0, 0.0], ball = {} }";
    let water = "[bodies.water.fluid]\ngeometry.block = { lengths = [1, 1], spacing = 0.5 }\nmaterial.liquid = { density = 1, sound_speed = 9 }\nformulation.weakly-compressible = {}\n[bodies.a.rigid]";
    let said = refused(
        CHAIN,
        &[
            ("no such body", "to = \"a\"", "to = \"c\""),
            ("to itself", "to = \"a\"", "to = \"b\""),
            ("no kind", ball, "{ on = \"b\", to = \"a\", at = [1.0, 0.0, 0.0] }"),
            ("two kinds", "ball = {}", "ball = {}, hinge.axis = [1, 0, 0]"),
            ("no axis", "[0.2, 1.0, 0.0]", "[0, 0, 0]"),
            (
                "at rest",
                "analysis.explicit.transient = { duration = 0.6, record_every = 0.02 }",
                "analysis.static = { levels = 1 }",
            ),
            ("out of the plane of a fluid", "[bodies.a.rigid]", water),
            (
                "a column of no joint",
                "on = \"b.all\", direction = [1, 0, 0]",
                "on = \"b.all\", direction = [1, 0, 0], joint = \"pin\"",
            ),
            (
                "a joint without a name",
                "of = \"displacement\", on = \"b.all\", direction = [1, 0, 0]",
                "of = \"joint-force\", on = \"b.all\", direction = [1, 0, 0], joint = \"pin\"",
            ),
            (
                "one name for two",
                "joints = [",
                "joints = [\n    { name = \"pin\", on = \"a\", at = [0, 0, 0], ball = {} },\n    { name = \"pin\", on = \"a\", at = [0, 0, 0], ball = {} },",
            ),
        ],
    );
    insta::assert_snapshot!(said);
}

/// A support that moves a body out of its joint: the run ends and names the joints, at once. One that agrees with a slider lets it go.
#[test]
fn supports_and_joints_hold_together_or_say_so() {
    let scene = |supports: &str, joint: &str| {
        format!(
            "title = \"Held\"\nunits = {{ length = \"m\", force = \"N\", time = \"s\" }}\n\
             analysis.explicit.transient = {{ duration = 0.2, record_every = 0.02 }}\n\
             curve = [{{ name = \"x\", of = \"displacement\", on = \"a.all\", direction = [1, 0, 0] }}]\n\
             supports = {supports}\njoints = [{{ on = \"a\", at = [0, 0, 0], {joint} }}]\n[bodies.a.rigid]\n\
             geometry.box = {{ min = [-0.1, -0.1, -0.1], max = [0.1, 0.1, 0.1], spacing = 0.1 }}\nmass = 2.0\n"
        )
    };
    let moved = |v: &str| {
        format!(
            "{{ on = \"a.all\", moved = {{ direction = {v}, by = 0.05 }}, amplitude = {{ smooth = 0.2 }} }}"
        )
    };
    let against = overridden(&scene(&format!("[{}]", moved("[1, 0, 0]")), "ball = {}"), "held.toml", &[]);
    let outcome = against.unwrap().build(1).unwrap().run(&mut coque::Silent);
    assert!(outcome.summary.ended.contains("the gap of [[joints]]"), "{}", outcome.summary.ended);
    let held = "{ on = \"a.all\", held = { displacement = [[0.8, -0.6, 0.0], [0.0, 0.0, 1.0]] } }";
    let along = scene(&format!("[{held}, {}]", moved("[0.6, 0.8, 0.0]")), "slider.axis = [0.6, 0.8, 0.0]");
    let found = column(&ran(overridden(&along, "held.toml", &[])), "x");
    assert!((found.last().unwrap() - 0.03).abs() < 1e-9, "{found:?}");
}
