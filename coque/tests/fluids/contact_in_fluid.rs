//! Structures in a fluid that touch each other and its walls: beams, what each does to the other, the same bits however it is said and cut.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::fluids::PAIR;
use crate::common::sittings::stopped_again_and_again;
use crate::common::{column, overridden, ran, text};
use coque::Outcome;

fn pair(replaced: &[(&str, &str)]) -> Outcome {
    ran(overridden(PAIR, "pair.toml", replaced))
}

fn refused(replaced: &[(&str, &str)]) -> String {
    let scene = overridden(PAIR, "pair.toml", replaced);
    scene.and_then(|scene| scene.build(1).map(drop)).unwrap_err().to_string()
}

const ALONE: &str = "[{ name = 'F', of = 'contact-force', on = 'first.all', direction = [1, 0, 0] }, \
                      { name = 'G', of = 'contact-force', on = 'second.all', direction = [1, 0, 0] }]";

/// Without the sill each feels what the other does.
#[test]
fn what_one_structure_feels_the_other_does() {
    let outcome = pair(&[("contact", "[{ between = [\"first\", \"second\"] }]"), ("curve", ALONE)]);
    let [f, g] = ["F", "G"].map(|name| column(&outcome, name));
    let most = f.iter().fold(0.0_f64, |most, f| most.max(f.abs()));
    assert!(most > 1.0, "{most}");
    assert!(f.iter().zip(&g).all(|(f, g)| (f + g).abs() < 1e-13 * most));
}

#[test]
fn the_second_stops_at_the_sill() {
    let outcome = pair(&[]);
    let summary = &outcome.summary.record;
    assert!(summary.warnings.is_empty(), "{:?}", summary.warnings);
    let names: Vec<&str> = summary.contacts.iter().map(|own| own.between.as_str()).collect();
    assert_eq!(names, ["`second` with the tool `sill`", "`first` with `second`"]);
    assert!(summary.contacts.iter().all(|own| own.greatest_area > 0.0), "{:?}", summary.contacts);
    // Faces are .002 apart at the start: the foot stands at the sill but for the depth, without it the foot goes on.
    let most = |outcome: &Outcome| column(outcome, "dx").into_iter().fold(0.0, f64::max);
    assert!((0.002..0.005).contains(&most(&outcome)), "{}", most(&outcome));
    let open = pair(&[("contact", "[{ between = [\"first\", \"second\"] }]")]);
    assert!(most(&open) > 1.8 * most(&outcome), "{}", most(&open));
    let gap = column(&outcome, "gap");
    assert!(gap[0] > 0.007 && gap.iter().fold(1.0_f64, |least, gap| least.min(*gap)) < 0.0);
}

/// A wall that a shell touches is a tool of the shell by its shape.
#[test]
fn walls_are_tools_to_the_bit() {
    let tool = "[{ name = 'sill', block = { min = [0.15, 0.0, -9.0], max = [0.2, 0.05, 9.0] } }]";
    let said = [("contact", "[{ between = [\"first\", \"second\"] }]"), ("bodies.second.shell.tools", tool)];
    assert_eq!(pair(&said).curve.rows, pair(&[]).curve.rows);
    // Walls that move to and fro are a tool that does.
    let course = "amplitude = { sine = { period = 0.04 } }";
    let walls = format!("{{ translation = {{ by = [-0.004, 0, 0], {course} }} }}");
    let tool = tool.replace(" }]", &format!(", moved = [-0.004, 0, 0], {course} }}]"));
    let motion = ("bodies.sill.walls.motion", &walls[..]);
    let moved = pair(&[motion]);
    assert!(moved.curve.rows != pair(&[]).curve.rows);
    let said = [said[0], ("bodies.second.shell.tools", &tool[..]), motion];
    assert_eq!(pair(&said).curve.rows, moved.curve.rows);
}

#[test]
fn whichever_is_named_first_and_on_any_threads_the_bits_are_the_same() {
    let rows = pair(&[]).curve.rows;
    let swapped = "[{ between = [\"sill\", \"second\"] }, { between = [\"second\", \"first\"] }]";
    assert_eq!(pair(&[("contact", swapped)]).curve.rows, rows);
    let scene = overridden(PAIR, "pair.toml", &[]).unwrap();
    for threads in [2, 3] {
        assert_eq!(scene.build(threads).unwrap().run(&mut coque::Silent).curve.rows, rows, "{threads}");
    }
}

#[test]
fn runs_of_touching_structures_go_on_to_the_same_bits() {
    stopped_again_and_again("wet-pair", PAIR, &[], 4);
}

/// A shell of several bodies that may touch itself, and does not, moves as one that may not.
#[test]
fn a_shell_with_itself_among_others() {
    let contact = "[{ between = [\"first\", \"second\"] }, { between = [\"second\", \"sill\"] }, { between = [\"first\", \"first\"] }]";
    let short = ("analysis.explicit.transient.duration", "0.03");
    let (with, without) = (pair(&[("contact", contact), short]), pair(&[short]));
    assert!(with.summary.body.modelled.iter().any(|line| line.contains("contact with itself")));
    let [own, other] = [&with, &without].map(|outcome| column(outcome, "gap"));
    // Its step counts that it may touch: the motion is the same but for that.
    assert!(own[0] - own[15] > 0.005 && own != other);
    assert!(
        own.iter().zip(&other).all(|(a, b)| (a - b).abs() < 1e-2 * (own[0] - own[15])),
        "{own:?} {other:?}"
    );
}

/// In millimetres every length is a thousand times as great; columns follow, but for energies, which a plane fluid has by depth and a shell by its width.
#[test]
fn structures_that_touch_do_so_in_other_units() {
    let mut scene: toml::Table = PAIR.parse().unwrap();
    scale(&mut scene, 1e3);
    let scaled = toml::to_string(&scene).unwrap();
    let (one, other) = (pair(&[]), ran(overridden(&scaled, "pair.toml", &[])));
    for (name, factor) in [("F", 1.0), ("G", 1.0), ("dx", 1e3), ("depth", 1.0), ("gap", 1e3)] {
        let [one, other] = [&one, &other].map(|outcome| column(outcome, name));
        let most = one.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let off = one.iter().zip(&other).fold(0.0_f64, |most, (x, y)| most.max((x - y / factor).abs()));
        // Sums of water in another rounding, kept apart by pressures: measured 3e-13.
        assert!(off < 1e-12 * most, "{name}: {off} of {most}");
    }
}

/// Every length, and what is made of it, in a unit of which there are so many in one.
fn scale(table: &mut toml::Table, factor: f64) {
    for (key, value) in table.iter_mut() {
        let power = match key.as_str() {
            "origin" | "lengths" | "spacing" | "min" | "max" | "thickness" | "sound_speed"
            | "acceleration" => 1,
            "young" => -2,
            "density" => -4,
            _ => 0,
        };
        each(value, power, factor);
        if key == "length" {
            *value = "mm".into();
        }
    }
}

fn each(value: &mut toml::Value, power: i32, factor: f64) {
    match value {
        toml::Value::Table(table) => scale(table, factor),
        toml::Value::Array(list) => list.iter_mut().for_each(|value| each(value, power, factor)),
        toml::Value::Float(number) => *number *= f64::powi(factor, power),
        _ => {}
    }
}

/// A block of bonds falls beside the water of a tank in space.
const STONE: &str = r#"title = "A stone on the floor"
units = { length = "m", force = "N", time = "s" }
analysis.explicit.transient = { duration = 0.02, record_every = 0.0005 }
loads = [{ on = "all", gravity = { acceleration = [0.0, 0.0, -10.0] } }]
contact = [{ between = ["stone", "tank"] }]
curve = [
    { name = "v", of = "velocity", on = "stone.all", direction = [0, 0, 1], take = "mean" },
    { name = "z", of = "position", on = "stone.all", direction = [0, 0, 1], take = "min" },
    { name = "F", of = "contact-force", on = "stone.all", direction = [0, 0, 1] },
]
[bodies.water.fluid]
geometry.block = { lengths = [0.1, 0.1, 0.06], spacing = 0.02 }
material.liquid = { density = 1000.0, sound_speed = 20.0 }
[bodies.tank.walls]
geometry.basin = { min = [0.0, 0.0, 0.0], max = [0.3, 0.1, 0.3], open = ["z1"] }
[bodies.stone.solid]
geometry.block = { lengths = [0.06, 0.06, 0.06], origin = [0.2, 0.02, 0.005], spacing = 0.02 }
material.elastic = { young = 2e6, poisson = 0.25, density = 2000.0 }
formulation.bond-based = { horizon = 3.015 }
velocity = { linear = [0.0, 0.0, -1.0] }
"#;

/// The tank that holds the water holds the stone; without the contact it goes through the floor, which the run says.
#[test]
fn a_stone_lands_on_the_floor_of_the_tank() {
    let stone = |replaced: &[(&str, &str)]| ran(overridden(STONE, "stone.toml", replaced));
    let landed = stone(&[]);
    let [z, v, f] = ["z", "v", "F"].map(|name| column(&landed, name));
    let lowest = z.iter().fold(1.0_f64, |least, z| least.min(*z));
    let most = f.iter().fold(0.0_f64, |most, f| most.max(*f));
    // The lowest nodes begin half a spacing above the lower face, .015.
    assert!((0.006..0.01).contains(&lowest) && most > 1.0, "{lowest} {most}");
    assert!(v[0] < -0.9 && v.last().is_some_and(|v| *v > 0.3) && f.last() == Some(&0.0), "{v:?}");
    let floor = "[{ name = 'floor', plane = { point = [0, 0, 0], normal = [0, 0, 1] } }]";
    let tool = stone(&[("contact", "[]"), ("bodies.stone.solid.tools", floor)]);
    assert_eq!(tool.curve.rows, landed.curve.rows);
    let curve = "[{ name = 'z', of = 'position', on = 'stone.all', direction = [0, 0, 1], take = 'min' }]";
    let through = stone(&[("contact", "[]"), ("curve", curve)]);
    assert!(column(&through, "z").last().is_some_and(|z| *z < 0.0));
    let words: Vec<&str> =
        through.summary.record.warnings.iter().map(|warning| warning.kind.word()).collect();
    assert!(words.contains(&"no-contact"), "{words:?}");
    stopped_again_and_again("stone", STONE, &[], 3);
}

/// The water presses the flap on a round sill below its foot: force on the sill against a beam that is propped there, both over the
/// thrust of the water, which swings.
#[test]
fn a_flap_bears_on_its_sill_as_a_propped_beam() {
    let sill = "[{ name = 'sill', cylinder = { point = [0.112, 0, 0], axis = [0, 0, 1], radius = 0.005 } }]";
    let replaced = [("contact", "[]"), ("bodies.flap.shell.tools", sill), ("output", "{}")];
    let outcome = ran(overridden(&text("gate-on-sill.toml"), "sill.toml", &replaced));
    let mean = |name: &str| {
        let times = column(&outcome, "time");
        let settled = column(&outcome, name).into_iter().zip(times).filter(|(_, time)| *time >= 0.1);
        let all: Vec<f64> = settled.map(|(value, _)| value).collect();
        all.iter().sum::<f64>() / all.len() as f64
    };
    let (long, thick, wide, gap) = (0.079_f64, 0.005_f64, 0.02, 0.002);
    let bending = 12e6 / (1.0 - 0.4 * 0.4) * thick.powi(3) / 12.0;
    let weight = 9810.0;
    let (above, below) = (weight * 0.061, weight * long);
    // A cantilever under even and growing pressure, and what brings its foot back to the gap.
    let free = (above / 8.0 + below * 11.0 / 120.0) * long.powi(4) / bending;
    let back = 3.0 * bending / long.powi(3) * wide;
    let thrust = (above + 0.5 * below) * long;
    let found = (mean("sill") + back * gap) / mean("water_mean");
    let error = found / (back * free / thrust) - 1.0;
    // Measured −1.0 %: the pressure of a swinging column is not that of one at rest.
    assert!(error.abs() < 0.03, "{error}");
}

#[test]
fn what_cannot_touch_is_refused() {
    let sill = |geometry: &str| format!("{{ geometry = {geometry} }}");
    let line = sill("{ polyline = { points = [[0.16, 0.0], [0.16, 0.05], [0.3, 0.05]], side = 'right' } }");
    for (replaced, says) in [
        (vec![("bodies.sill.walls", line.as_str())], "a `basin` or a `block`"),
        (vec![("contact", "[{ between = ['water', 'second'] }]")], "a shell, a solid or a rigid body"),
        (vec![("contact", "[{ between = ['tank', 'sill'] }]")], "a rigid body beside the walls"),
        (
            vec![("contact", "[{ between = ['second', 'sill'] }, { between = ['sill', 'second'] }]")],
            "named once: contact[0]",
        ),
        (
            vec![("contact", "[{ between = ['first', 'first'] }, { between = ['first', 'first'] }]")],
            "named once: contact[0]",
        ),
        (vec![("contact", "[{ between = ['sill', 'sill'] }]")], "two bodies, or a shell twice"),
        (
            vec![(
                "bodies.sill.walls.motion",
                "{ rotation = { axis = [0, 0, 1], by = 10.0, amplitude = { ramp = 1.0 } } }",
            )],
            "move without turning",
        ),
        (vec![("bodies.second.shell.placed.origin", "[0.155, 0.0, -0.04]")], "`contact[1]` is `sill`"),
        (
            vec![(
                "bodies.second.shell.tools",
                "[{ name = 'sill', sphere = { centre = [0.3, 0.3, 0], radius = 0.01 } }]",
            )],
            "another name than the tool `sill`",
        ),
        (vec![("bodies.second.shell.placed.origin", "[0.125, 0.0, -0.04]")], "apart"),
    ] {
        let error = refused(&replaced);
        assert!(error.contains(says), "{says}: {error}");
    }
}
