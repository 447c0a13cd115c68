//! Smooth contact in relaxations and along paths by arc length: the answers of Newton's method, a snap that lands, the same bits, what is refused.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::sittings::stopped_again_and_again;
use crate::common::{Replaced, column, last, overridden, refusal, run, text};
use coque::{Ended, Outcome, WarningKind};

const ARCH: &str = "arch-onto-flat.toml";
const PINCHED: [(&str, &str); 2] = [
    ("geometry.cylinder.particles", "[41, 3]"),
    (
        "loads",
        "[{ on = 'u0', force = { total = [0, 0, -10.0] } }, { on = 'u1', force = { total = [0, 0, 10.0] } }]",
    ),
];

fn done(outcome: Outcome) -> Outcome {
    assert_eq!(outcome.ended, Ended::Done, "{}", outcome.summary.ended);
    outcome
}

fn warned(outcome: &Outcome, kind: WarningKind) -> bool {
    outcome.summary.record.warnings.iter().any(|own| own.kind == kind)
}

/// Greatest difference of the columns of both over their greatest, `iterations` and energies left out.
fn apart(a: &Outcome, b: &Outcome) -> f64 {
    let own = a.curve.columns.iter().skip(2).filter(|own| !own.name.contains("iterations"));
    own.filter(|own| own.name != "negative_pivots").fold(0.0, |most: f64, own| {
        let [one, other] = [a, b].map(|outcome| column(outcome, &own.name));
        let scale = one.iter().fold(f64::MIN_POSITIVE, |most, x| most.max(x.abs()));
        assert_eq!(one.len(), other.len(), "{}", own.name);
        one.iter().zip(&other).fold(most, |most, (x, y)| most.max((x - y).abs() / scale))
    })
}

/// Tools that stand, a tool that moves, a shell with itself. Measured 5e-7, 5e-8, 7e-8 and 6e-7, by a relaxation to 1e-6.
#[test]
fn relaxation_comes_to_the_states_of_newton() {
    let scenes: [(&str, Replaced, &str); 4] = [
        ("strip-over-drum.toml", &[("geometry.plate.particles", "[26, 3]")], "levels = 8"),
        ("cantilever-on-flat.toml", &[], "levels = [0.00347222, 0.0138889, 0.0625, 0.173611, 1.0]"),
        ("ring-between-plates.toml", &[("geometry.cylinder.particles", "[21, 3]")], "levels = 10"),
        ("ring-in-itself.toml", &PINCHED, "levels = 10"),
    ];
    for (name, replaced, levels) in scenes {
        let [balanced, relaxed] = ["static", "relaxation"].map(|word| {
            let analysis = format!("{{ {word} = {{ {levels} }} }}");
            done(run(name, &[replaced, &[("analysis", &analysis[..])]].concat()))
        });
        let off = apart(&balanced, &relaxed);
        println!("{name}: {off:.1e}");
        assert!(off < 3e-6, "{name}: {off:.1e}");
        assert!(!warned(&relaxed, WarningKind::PassedCritical), "{name}: a path is taken for a snap");
    }
}

/// Up to where it lands the path is that without a flat, to the bit, and so are its limit points; it goes on to where a relaxation snaps to.
#[test]
fn an_arch_that_snaps_lands_and_the_path_goes_on() {
    let landed = done(run(ARCH, &[]));
    let free = done(run(ARCH, &[("tools", "[]"), ("curve", FREE), ("output", "{}")]));
    let (force, [with, without]) = (column(&landed, "F"), [&landed, &free].map(|one| column(one, "w")));
    let lands = force.iter().position(|force| *force > 0.0).unwrap();
    assert!(lands > 10 && force[lands..].iter().all(|force| *force > 0.0));
    assert_eq!(with[..lands], without[..lands]);
    let limits = |one: &Outcome| -> Vec<u64> {
        one.summary.record.critical.iter().map(|point| point.level.to_bits()).collect()
    };
    assert!(limits(&landed).len() == 4 && limits(&landed) == limits(&free));
    let relaxed = done(run(ARCH, &[("analysis", "{ relaxation = { levels = [0.1, 0.2, 0.3, 1.0, 3.0] } }")]));
    assert!(warned(&relaxed, WarningKind::PassedCritical), "no warning of the snap");
    // Measured 7e-8.
    for name in ["w", "F"] {
        let [path, snapped] = [&landed, &relaxed].map(|one| last(one, name));
        assert!((snapped / path - 1.0).abs() < 3e-7, "{name}: {path} {snapped}");
    }
}

const FREE: &str = "[{ name = 'w', of = 'displacement', on = 'u0', direction = [0, 0, -1] }]";

/// A tool that moves by the level, a tool that stands, a shell with itself: the last point is that of load levels. Measured 1e-7 at most.
#[test]
fn arc_length_comes_to_the_states_of_levels() {
    let scenes: [(&str, Replaced); 3] = [
        ("strip-over-drum.toml", &[("geometry.plate.particles", "[26, 3]")]),
        ("ring-between-plates.toml", &[("geometry.cylinder.particles", "[21, 3]")]),
        ("ring-in-itself.toml", &PINCHED),
    ];
    for (name, replaced) in scenes {
        let [mut levels, mut path] =
            ["{ static = { levels = 10 } }", "{ arc-length = { until = 1.0, radius = 0.05, steps = 100 } }"]
                .map(|analysis| done(run(name, &[replaced, &[("analysis", analysis)]].concat())));
        for one in [&mut levels, &mut path] {
            one.curve.rows = one.curve.rows.split_off(one.curve.rows.len() - 1);
        }
        let off = apart(&levels, &path);
        println!("{name}: {off:.1e}");
        assert!(off < 3e-7, "{name}: {off:.1e}");
    }
}

#[test]
fn a_relaxation_in_contact_goes_on_to_the_same_bits_and_threads_change_none() {
    const RING: &str = "ring-between-plates.toml";
    let relaxed = ("analysis", "{ relaxation = { levels = 4 } }");
    let coarse = [("geometry.cylinder.particles", "[21, 3]"), ("tools[0].moved", "[0, 0, -0.2]"), relaxed];
    stopped_again_and_again("pressed-relaxed", &text(RING), &coarse, 3);
    let itself = [&PINCHED[..], &[relaxed]].concat();
    stopped_again_and_again("pinched-relaxed", &text("ring-in-itself.toml"), &itself, 3);
    let bits = |threads: usize, name: &str, replaced: Replaced| -> Vec<u64> {
        let scene = overridden(&text(name), name, replaced).unwrap();
        let outcome = done(scene.build(threads).unwrap().run(&mut coque::Silent));
        outcome.curve.rows.iter().flatten().map(|x| x.to_bits()).collect()
    };
    let fine = [("geometry.cylinder.particles", "[201, 7]"), ("tools[0].moved", "[0, 0, -0.05]"), relaxed];
    assert_eq!(bits(1, RING, &fine), bits(3, RING, &fine));
    assert_eq!(bits(1, ARCH, &[]), bits(2, ARCH, &[]));
}

/// A tool that is far changes no state; masses have room for it, so that a relaxation takes another way there. Measured 1e-6 of the displacement.
#[test]
fn a_tool_that_is_far_changes_nothing() {
    let far = ("tools[+]", "{ name = 'far', sphere = { centre = [0.3, 0.0, 9.0], radius = 1.0 } }");
    let bits = |replaced: Replaced| -> Vec<Vec<f64>> { done(run(ARCH, replaced)).curve.rows };
    assert_eq!(bits(&[]), bits(&[far]));
    let relaxed = ("analysis", "{ relaxation = { levels = [0.1, 0.15] } }");
    let off = apart(&done(run(ARCH, &[relaxed])), &done(run(ARCH, &[relaxed, far])));
    assert!(off < 3e-6, "{off:.1e}");
}

#[test]
fn what_does_not_go_together() {
    let relaxed = ("analysis", "{ relaxation = { levels = 4 } }");
    let cases: [(&str, &str, Replaced); 4] = [
        ("friction on a tool along a path", ARCH, &[("tools[0].friction", "0.3")]),
        ("friction of the shell on itself", ARCH, &[relaxed, ("contact", "[{ friction = 0.3 }]")]),
        ("two bodies", "two-cantilevers.toml", &[relaxed]),
        ("a linear answer", ARCH, &[("analysis", "{ linear = {} }")]),
    ];
    let said = cases.map(|(name, scene, replaced)| format!("== {name}\n{}\n", refusal(scene, replaced, 100)));
    insta::assert_snapshot!(said.concat());
}

/// What a preload presses on stays so while the path begins.
#[test]
fn a_tool_of_the_preload_stands_where_the_preload_left_it() {
    let tool = (
        "tools",
        "[{ name = 'flat', plane = { point = [0, 0, 1.009], normal = [0, 0, -1] }, moved = [0, 0, -0.0015], preload = true }]",
    );
    let path = done(run(
        ARCH,
        &[tool, ("analysis", "{ static = { levels = 2 } }"), ("loads[0].force.total", "[0, 0, 4.0]")],
    ));
    let (w, force) = (column(&path, "w"), column(&path, "F"));
    assert!(w[0] > 0.0004 && force[0] < -0.01, "{w:?} {force:?}");
    // The load lifts the crown against the tool, which bears all of it but what the arch takes of the way by which contact gives: 1.3 %.
    assert!(w[2] > 0.0004 && w[2] < w[0] && (force[2] - force[0] + 4.0).abs() < 0.16, "{w:?} {force:?}");
}
