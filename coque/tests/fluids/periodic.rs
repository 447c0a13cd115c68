//! Periodic sides of fluids in scenes: the same flow turned, in a mirror, in other units, in sittings; what is refused.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::fluids::apart;
use crate::common::refused::refused;
use crate::common::sittings::stopped_again_and_again;
use crate::common::{Replaced, column, overridden, ran, text};
use coque::Outcome;

/// Water over a rough bed of two blocks, driven by gravity along it.
const STREAM: &str = r#"title = "A stream"
units = { length = "m", force = "N", time = "s" }
analysis.explicit.transient = { duration = 0.2, record_every = 0.02 }
loads = [{ on = "all", gravity = { acceleration = [1.0, -9.81, 0.0] } }]
curve = [{ name = "u", of = "velocity", on = "water.all", take = "mean", direction = [1, 0, 0] }, { name = "q", of = "flux", on = "water.all", through = { point = [0.0, 0, 0], normal = [1, 0, 0] } }, { name = "f", of = "force", on = "block.all", direction = [1, 0, 0] }]
[bodies.water.fluid]
geometry.block = { lengths = [0.4, 0.1], spacing = 0.01, origin = [0.0, 0.02] }
material.liquid = { density = 1000.0, sound_speed = 15.0 }
periodic = { x = [0.0, 0.4] }
[bodies.bed.walls]
geometry.block = { lengths = [0.4, 0.04], origin = [0.0, -0.04] }
[bodies.block.walls]
geometry.block = { lengths = [0.1, 0.02], origin = [0.25, 0.0] }
"#;

fn stream(replaced: Replaced) -> Outcome {
    let filled = ("bodies.water.fluid.geometry", FILLED);
    let all: Vec<(&str, &str)> = [filled].into_iter().chain(replaced.iter().copied()).collect();
    ran(overridden(STREAM, "stream.toml", &all))
}

/// The water before and behind the block, and over both.
const FILLED: &str = "{ blocks = { spacing = 0.01, parts = [{ lengths = [0.4, 0.08], origin = [0.0, 0.02] }, { lengths = [0.25, 0.02], origin = [0.0, 0.0] }, \
                      { lengths = [0.05, 0.02], origin = [0.35, 0.0] }] } }";

/// In the mirror of x the stream flows back.
#[test]
fn a_stream_in_a_mirror_is_the_same() {
    let mirrored = [
        ("loads[0].gravity.acceleration", "[-1.0, -9.81, 0.0]"),
        (
            "bodies.water.fluid.geometry",
            "{ blocks = { spacing = 0.01, parts = [{ lengths = [0.4, 0.08], origin = [0.0, 0.02] }, { lengths = [0.25, 0.02], origin = [0.15, 0.0] }, \
             { lengths = [0.05, 0.02], origin = [0.0, 0.0] }] } }",
        ),
        ("bodies.block.walls.geometry.block.origin", "[0.05, 0.0]"),
    ];
    let [one, other] = [stream(&[]), stream(&mirrored)];
    assert!(column(&one, "u")[10] > 0.15, "{:?}", column(&one, "u"));
    assert!(one.summary.record.warnings.is_empty(), "{:?}", one.summary.record.warnings);
    for name in ["u", "q", "f"] {
        let off = apart(&one, &other, name, -1.0);
        assert!(off < 1e-7, "{name}: {off:e}");
    }
}

/// Turned by a quarter it flows along y, with what is up along −x.
#[test]
fn a_stream_turned_by_a_quarter_is_the_same() {
    let turned = [
        ("loads[0].gravity.acceleration", "[9.81, 1.0, 0.0]"),
        (
            "bodies.water.fluid.geometry",
            "{ blocks = { spacing = 0.01, parts = [{ lengths = [0.08, 0.4], origin = [-0.1, 0.0] }, { lengths = [0.02, 0.25], origin = [-0.02, 0.0] }, \
             { lengths = [0.02, 0.05], origin = [-0.02, 0.35] }] } }",
        ),
        ("bodies.water.fluid.periodic", "{ y = [0.0, 0.4] }"),
        ("bodies.bed.walls.geometry.block", "{ lengths = [0.04, 0.4], origin = [0.0, 0.0] }"),
        ("bodies.block.walls.geometry.block", "{ lengths = [0.02, 0.1], origin = [-0.02, 0.25] }"),
        ("curve[0].direction", "[0, 1, 0]"),
        ("curve[1].through", "{ point = [0, 0, 0], normal = [0, 1, 0] }"),
        ("curve[2].direction", "[0, 1, 0]"),
    ];
    let [one, other] = [stream(&[]), stream(&turned)];
    for name in ["u", "q", "f"] {
        let off = apart(&one, &other, name, 1.0);
        assert!(off < 1e-7, "{name}: {off:e}");
    }
}

/// A zone at the left that carries water at rest to the right, and in a mirror one at the right that carries it to the left.
#[test]
fn a_current_in_a_mirror_is_the_same() {
    let level = ("loads[0].gravity.acceleration", "[0.0, -9.81, 0.0]");
    let zone = ("bodies.water.fluid.current", "{ from = [0.05, 0, 0], length = 0.15, velocity = 0.4 }");
    let mirrored = [
        level,
        (
            "bodies.water.fluid.current",
            "{ from = [0.35, 0, 0], along = [-1, 0, 0], length = 0.15, velocity = 0.4 }",
        ),
        (
            "bodies.water.fluid.geometry",
            "{ blocks = { spacing = 0.01, parts = [{ lengths = [0.4, 0.08], origin = [0.0, 0.02] }, { lengths = [0.25, 0.02], origin = [0.15, 0.0] }, \
             { lengths = [0.05, 0.02], origin = [0.0, 0.0] }] } }",
        ),
        ("bodies.block.walls.geometry.block.origin", "[0.05, 0.0]"),
    ];
    let [one, other] = [stream(&[level, zone]), stream(&mirrored)];
    assert!(column(&one, "u")[10] > 0.1, "{:?}", column(&one, "u"));
    for name in ["u", "q", "f"] {
        let off = apart(&one, &other, name, -1.0);
        assert!(off < 1e-7, "{name}: {off:e}");
    }
}

/// In mm, N and s: forces are the same, speeds a thousand times the number.
#[test]
fn a_stream_in_other_units_is_the_same() {
    let scaled = [
        ("units", "{ length = 'mm', force = 'N', time = 's' }"),
        ("loads[0].gravity.acceleration", "[1000.0, -9810.0, 0]"),
        (
            "bodies.water.fluid.geometry",
            "{ blocks = { spacing = 10.0, parts = [{ lengths = [400.0, 80.0], origin = [0.0, 20.0] }, { lengths = [250.0, 20.0], origin = [0.0, 0.0] }, \
             { lengths = [50.0, 20.0], origin = [350.0, 0.0] }] } }",
        ),
        ("bodies.water.fluid.material.liquid", "{ density = 1000e-12, sound_speed = 15000.0 }"),
        ("bodies.water.fluid.periodic", "{ x = [0.0, 400.0] }"),
        ("bodies.bed.walls.geometry.block", "{ lengths = [400.0, 40.0], origin = [0.0, -40.0] }"),
        ("bodies.block.walls.geometry.block", "{ lengths = [100.0, 20.0], origin = [250.0, 0.0] }"),
    ];
    let [one, other] = [stream(&[]), stream(&scaled)];
    for (name, factor) in [("u", 1e3), ("q", 1e6), ("f", 1e-3)] {
        let off = apart(&one, &other, name, factor);
        assert!(off < 1e-7, "{name}: {off:e}");
    }
}

/// The same bits for any threads, and of a run in sittings.
#[test]
fn a_stream_is_the_same_bits_however_it_is_run() {
    let filled = ("bodies.water.fluid.geometry", FILLED);
    let short = [filled, ("analysis.explicit.transient.duration", "0.1")];
    let one = stream(&short[1..]).curve.rows;
    let scene = overridden(STREAM, "stream.toml", &short).unwrap();
    assert_eq!(scene.build(2).unwrap().run(&mut coque::Silent).curve.rows, one);
    stopped_again_and_again("stream", STREAM, &short, 3);
}

/// The flow of the scene at its last is that of the parabola, `g d³/12ν`: .6 % beyond, as walls hold to the first order of the spacing; what the plates bear is the weight.
#[test]
fn the_flow_between_plates_ends_as_its_parabola() {
    let outcome = ran(overridden(&text("flow-between-plates.toml"), "flow-between-plates.toml", &[]));
    let (flow, drag) = (column(&outcome, "flow"), column(&outcome, "drag"));
    let exact = 4.0 / (12.0 * 0.5);
    let last = flow.len() - 1;
    assert!((flow[last] / exact - 1.0).abs() < 0.02, "{} {exact}", flow[last]);
    assert!((drag[last] / 2000.0 - 1.0).abs() < 0.01, "{}", drag[last]);
    assert!(outcome.summary.record.warnings.is_empty(), "{:?}", outcome.summary.record.warnings);
}

#[test]
fn sides_that_cannot_be_periodic_are_refused() {
    let sides = "periodic = { x = [0.0, 0.4] }";
    let float = "[bodies.float.rigid]\ngeometry.box = { min = [0.1, 0.05, 0.0], max = [0.14, 0.09, 0.04], spacing = 0.02 }\ndensity = 500.0\n[bodies.bed.walls]";
    insta::assert_snapshot!(refused(
        STREAM,
        &[
            ("no axis", sides, "periodic = {}"),
            ("short", sides, "periodic = { x = [0.0, 0.05] }"),
            ("turned round", sides, "periodic = { x = [0.4, 0.0] }"),
            ("between rows", sides, "periodic = { x = [0.0, 0.405] }"),
            ("shorter than the fluid", sides, "periodic = { x = [0.0, 0.3] }"),
            ("across the plane", sides, "periodic = { x = [0.0, 0.4], z = [0.0, 0.4] }"),
            (
                "the published march",
                sides,
                "periodic = { x = [0.0, 0.4] }\nformulation.weakly-compressible = { method = \"source\" }"
            ),
            (
                "the published walls",
                sides,
                "periodic = { x = [0.0, 0.4] }\nformulation.weakly-compressible = { walls = \"dynamic\" }"
            ),
            (
                "a closed basin",
                "geometry.block = { lengths = [0.4, 0.04], origin = [0.0, -0.04] }",
                "geometry.basin = { min = [0.0, 0.0], max = [0.4, 0.4], open = [\"x0\", \"y1\"] }"
            ),
            ("a structure", "[bodies.bed.walls]", float),
        ],
    ));
}

#[test]
fn currents_that_carry_nothing_are_refused() {
    let sides = "periodic = { x = [0.0, 0.4] }";
    let with = |current: &str| format!("{sides}\ncurrent = {{ {current} }}");
    let cases = [
        ("short", with("from = [0.1, 0, 0], length = 0.05, velocity = 0.4")),
        ("fast", with("from = [0.1, 0, 0], length = 0.1, velocity = 4.0")),
        ("across a side", with("from = [0.35, 0, 0], length = 0.1, velocity = 0.4")),
        ("above the water", with("from = [0.1, 0.2, 0], along = [0, 1, 0], length = 0.1, velocity = 0.4")),
        ("no direction", with("from = [0.1, 0, 0], along = [0, 0, 0], length = 0.1, velocity = 0.4")),
        (
            "the published march",
            "current = { from = [0.1, 0, 0], length = 0.1, velocity = 0.4 }\nformulation.weakly-compressible = { method = \"source\" }".into(),
        ),
    ];
    let cases: Vec<_> = cases.iter().map(|(name, to)| (*name, sides, to.as_str())).collect();
    insta::assert_snapshot!(refused(STREAM, &cases));
}

/// Walls, zones and sections that would end at a side are refused.
#[test]
fn what_would_end_at_a_side_is_refused() {
    let fault = |replaced: Replaced| {
        let found = overridden(STREAM, "stream.toml", replaced).and_then(|scene| scene.build(1));
        found.map(|_| ()).unwrap_err().to_string()
    };
    let slanted = "[{ name = \"q\", of = \"flux\", on = \"water.all\", through = { point = [0.1, 0, 0], normal = [1, 0.1, 0] } }]";
    assert!(fault(&[("curve", slanted)]).contains("a slanted section ends at a side"));
    let zone = "{ from = [0.1, 0.0, 0.0], along = [1.0, 1.0, 0.0], length = 0.2, velocity = 0.5 }";
    assert!(fault(&[("bodies.water.fluid.current", zone)]).contains("a slanted zone would end at its sides"));
    // Half of the block beyond the side, all of the bed a period farther on.
    for (wall, at) in [("block", "[0.35, 0.0]"), ("bed", "[0.4, -0.04]")] {
        let key = format!("bodies.{wall}.walls.geometry.block.origin");
        let found = fault(&[(&key, at)]);
        assert!(found.contains("beyond a periodic side of the fluid"), "{wall}: {found}");
    }
}

/// Along a flow that goes round nothing has a height: gravity that drives it does not lean its levels.
#[test]
fn levels_are_measured_across_what_goes_round() {
    let gauge = |name: &str, x: f64| {
        format!("{{ name = \"{name}\", of = \"level\", on = \"water.all\", at = [{x:?}, 0, 0] }}")
    };
    let curve = format!("[{}, {}]", gauge("near", 0.1), gauge("far", 0.2));
    let found = stream(&[("curve", &curve)]);
    for name in ["near", "far"] {
        // The water is .1 m deep; a gauge sees where particles fill half of space, to a hundredth of a spacing.
        let level = column(&found, name)[0];
        assert!((level - 0.1).abs() < 3e-4, "{name}: {level}");
    }
}
