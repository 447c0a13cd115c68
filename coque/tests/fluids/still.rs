//! Modes of shells in still water against closed forms, and what holds between two of them.

use std::f64::consts::TAU;

use coque::{Ended, Outcome, Rendering, Scene, SceneError, render};

use crate::common::{self, Replaced, column, overridden};

/// A floor of a tank that only goes up and down, on springs, under water of .6 m.
const SPRUNG: &str = include_str!("../../../validation/src/cases/coupled/sprung-floor.toml");
/// Its weight alone.
const WEIGHT: &str = "[{ on = \"all\", gravity = { acceleration = [0.0, -10.0, 0.0] } }]";
const SCENE: &str = "plate-in-water-modes.toml";

fn modes(text: &str, replaced: Replaced) -> (Vec<f64>, Outcome) {
    let outcome = common::ran(overridden(text, "scene.toml", replaced));
    assert_eq!(outcome.ended, Ended::Done, "{}", outcome.summary.ended);
    (column(&outcome, "frequency"), outcome)
}

fn frequencies(text: &str, replaced: Replaced) -> Vec<f64> {
    modes(text, replaced).0
}

fn refused(text: &str, replaced: Replaced) -> String {
    let built = overridden(text, "scene.toml", replaced).and_then(|scene| scene.build(1).map(drop));
    let error: SceneError = built.expect_err("not refused");
    render(&error, Rendering { width: 120, colour: false })
}

fn warned(outcome: &Outcome) -> Vec<&'static str> {
    outcome.summary.record.warnings.iter().map(|warning| warning.kind.word()).collect()
}

/// All of the water above it moves with a floor that moves as one: √(k/(m + ρH)), in a plane and in space.
#[test]
fn a_floor_on_springs_lifts_its_water() {
    let modal = ("analysis", "{ modal.modes = 1 }");
    let free = ("loads", WEIGHT);
    let exact = (145_800.0 / 0.27 / (100.0 + 600.0_f64)).sqrt() / TAU;
    let [plane, space] = [
        &[modal, free][..],
        &[
            modal,
            free,
            ("bodies.water.fluid.geometry.block.lengths", "[0.6, 0.6, 0.45]"),
            ("bodies.water.fluid.geometry.block.origin", "[0.0, 0.0, -0.225]"),
            ("bodies.tank.walls.geometry.basin.min", "[0.0, -0.15, -0.225]"),
            ("bodies.tank.walls.geometry.basin.max", "[0.6, 0.9, 0.225]"),
        ],
    ]
    .map(|replaced| frequencies(SPRUNG, replaced)[0] / exact - 1.0);
    // The column is exact; springs are shared by particles and masses by area, so that the floor bends: 3e-8 of the frequency.
    println!("floor on springs: {plane:e} {space:e}");
    assert!(plane.abs() < 1e-7 && space.abs() < 1e-7 && (plane - space).abs() < 1e-9, "{plane:e} {space:e}");
}

/// A hinged plate as the floor of a tank against the series of water between its walls (benchmarks-ref/data/plate_in_water.json): within .4 % at forty
/// spacings, of the second order in them.
#[test]
fn a_hinged_floor_swings_as_its_series_says() {
    let text = common::text(SCENE);
    let series = [5.829886, 30.68461, 85.57690];
    let worst = |found: &[f64]| {
        let each = found.iter().zip(series).map(|(found, exact)| (found / exact - 1.0).abs());
        each.fold(0.0, f64::max)
    };
    let found = frequencies(&text, &[("analysis.modal.modes", "3")]);
    // .04, .17 and .40 %: the thin plate of the series leaves out shear, half of the rest.
    assert!(worst(&found) < 0.012, "{found:?}");
}

/// Water without mass leaves the dry plate; in water of great mass frequencies go with 1/√ρ.
#[test]
fn light_and_heavy_water() {
    let text = common::text(SCENE);
    let in_water = |density: &str| {
        frequencies(
            &text,
            &[("bodies.water.fluid.material.liquid.density", density), ("analysis.modal.modes", "3")],
        )
    };
    let light = in_water("1e-9");
    let dry = [1.0, 4.0, 9.0].map(|squares| 24.10876 * squares);
    for (found, exact) in light.iter().zip(dry) {
        assert!((found / exact - 1.0).abs() < 2e-3, "{light:?}");
    }
    let [heavy, heavier] = ["1e8", "4e8"].map(in_water);
    for (one, half) in heavy.iter().zip(&heavier) {
        assert!((one / half / 2.0 - 1.0).abs() < 1e-5, "{heavy:?} {heavier:?}");
    }
}

/// A tank with a plate in its left wall, in its right one, or in both, each on one end; or all of it turned upside down about the diagonal.
fn tank(plates: &[(&str, bool)], swapped: bool) -> String {
    let pair = |x: f64, y: f64| if swapped { format!("[{y:?}, {x:?}]") } else { format!("[{x:?}, {y:?}]") };
    let space = |x: f64, y: f64, z: f64| {
        if swapped { format!("[{y:?}, {x:?}, {z:?}]") } else { format!("[{x:?}, {y:?}, {z:?}]") }
    };
    let sides = if swapped { "\"y0\", \"y1\", \"x1\"" } else { "\"x0\", \"x1\", \"y1\"" };
    let mut text = format!(
        "title = \"Tank\"\nunits = {{ length = \"m\", force = \"N\", time = \"s\" }}\nanalysis.modal.modes = 3\n\
         [bodies.water.fluid]\ngeometry.block = {{ lengths = {}, spacing = 0.05 }}\nmaterial.liquid = {{ density = 1000.0, sound_speed = 60.0 }}\n\
         [bodies.floor.walls]\ngeometry.basin = {{ min = {}, max = {}, open = [{sides}] }}\n\
         [[loads]]\non = \"all\"\ngravity = {{ acceleration = {} }}\n",
        pair(0.6, 1.0),
        pair(-0.15, 0.0),
        pair(0.75, 1.2),
        space(0.0, -9.81, 0.0)
    );
    for (name, left) in plates {
        let x = if *left { -0.01 } else { 0.61 };
        // The director is along x, swapped along y: u × v.
        let (z, across) = if swapped { (0.05, -1.0) } else { (-0.05, 1.0) };
        let wet = if *left { "front" } else { "back" };
        text += &format!(
            "[bodies.{name}.shell]\ngeometry.plate = {{ lengths = [1.0, 0.1], particles = [41, 2] }}\n\
             placed = {{ origin = {}, u = {}, v = [0.0, 0.0, {across:?}] }}\nwet = \"{wet}\"\n\
             material.elastic = {{ young = 70e9, poisson = 0.3, density = 2700.0 }}\nsection.homogeneous.thickness = 0.02\n\
             [[supports]]\non = \"{name}.u0\"\nclamped = {{}}\n[[supports]]\non = \"{name}.v0\"\nsymmetry.normal = [0, 0, 1]\n\
             [[supports]]\non = \"{name}.v1\"\nsymmetry.normal = [0, 0, 1]\n",
            space(x, 0.0, z),
            space(0.0, 1.0, 0.0),
        );
    }
    // Where a wall has no plate it is one.
    for left in [true, false] {
        if !plates.iter().any(|(_, side)| *side == left) {
            let (name, x) = if left { ("left", -0.15) } else { ("right", 0.6) };
            text += &format!(
                "[bodies.{name}.walls]\ngeometry.block = {{ lengths = {}, origin = {} }}\n",
                pair(0.15, 1.2),
                pair(x, 0.0)
            );
        }
    }
    text
}

fn alike(a: &[f64], b: &[f64], bound: f64) {
    for (a, b) in a.iter().zip(b) {
        assert!((a / b - 1.0).abs() < bound, "{a} {b}");
    }
}

/// The plate in the other wall, and the tank swapped about its diagonal, swing alike.
#[test]
fn mirrored_and_swapped() {
    let first = frequencies(&tank(&[("plate", true)], false), &[]);
    alike(&first, &frequencies(&tank(&[("plate", false)], false), &[]), 1e-9);
    alike(&first, &frequencies(&tank(&[("plate", true)], true), &[]), 1e-9);
    // The clamped foot of a dry plate has .161533 √(E/12(1 − ν²)ρ) t/l²: water makes that a third.
    assert!(first[0] < 0.5 * 17.2 && first[0] > 0.1 * 17.2, "{first:?}");
}

/// Two plates that shut the water in between them swing with and against each other; whichever is named first.
#[test]
fn two_plates_in_one_water() {
    let one = frequencies(&tank(&[("a", true), ("b", false)], false), &[]);
    alike(&one, &frequencies(&tank(&[("b", true), ("a", false)], false), &[]), 1e-9);
    // Against each other they pump the water up: that is the slow mode.
    let alone = frequencies(&tank(&[("plate", true)], false), &[]);
    assert!(one[0] < alone[0] && one[1] > alone[0], "{one:?} {alone:?}");
}

/// Half of the tank with a plane of symmetry in place of a wall has the even modes of the whole.
#[test]
fn half_of_a_tank() {
    let text = common::text(SCENE);
    let whole = frequencies(&text, &[("analysis.modal.modes", "3")]);
    let half = text.replace("lengths = [1.0, 0.5]", "lengths = [0.5, 0.5]");
    let half = half.replace("max = [1.0, 0.7]", "max = [0.5, 0.7]");
    let half = half
        .replace("lengths = [1.0, 0.1], particles = [81, 2]", "lengths = [0.5, 0.1], particles = [41, 2]");
    let half = half
        .replace("on = \"plate.u1\"\nhinged = {}", "on = \"plate.u1\"\nsymmetry = { normal = [1, 0, 0] }");
    let half = frequencies(&half, &[("analysis.modal.modes", "2")]);
    alike(&half, &[whole[0], whole[2]], 1e-9);
}

/// Millimetres and kilonewtons change nothing but units.
#[test]
fn other_units() {
    let first = frequencies(SPRUNG, &[("analysis", "{ modal.modes = 1 }"), ("loads", WEIGHT)])[0];
    let scaled = "title = \"\"\nunits = { length = \"mm\", force = \"N\", time = \"s\" }\nanalysis.modal.modes = 1\n\
        [bodies.water.fluid]\ngeometry.block = { lengths = [600.0, 600.0], spacing = 50.0 }\nmaterial.liquid = { density = 1e-9, sound_speed = 45e3 }\n\
        [bodies.tank.walls]\ngeometry.basin = { min = [0.0, -150.0], max = [600.0, 900.0], open = [\"y0\", \"y1\"] }\n\
        [bodies.floor.shell]\ngeometry.plate = { lengths = [600.0, 450.0], particles = [13, 10] }\n\
        placed = { origin = [0.0, -25.0, 225.0], u = [1.0, 0.0, 0.0], v = [0.0, 0.0, -1.0] }\nwet = \"front\"\n\
        material.elastic = { young = 1e3, poisson = 0.0, density = 2e-9 }\nsection.homogeneous.thickness = 50.0\n\
        [[supports]]\non = \"floor.all\"\nheld = { displacement = [[1, 0, 0], [0, 0, 1]], director = [[0, 0, 1]] }\n\
        [[supports]]\non = \"floor.all\"\nspring = { direction = [0, 1, 0], stiffness = 145.8 }\n";
    let other = frequencies(scaled, &[])[0];
    assert!((first / other - 1.0).abs() < 1e-9, "{first} {other}");
}

/// Gravity is left out: of a floor that goes up and down as one what its waves add is what its pressure at rest takes, whatever the spring; a plate of 3 mm under
/// half a metre of water loses more by that than its waves give, and the warning says so.
#[test]
fn what_gravity_does_to_slow_modes_is_said() {
    let soft = SPRUNG.replace("stiffness = 145800.0", "stiffness = 2000.0");
    for floor in [&soft, SPRUNG] {
        let (_, outcome) = modes(floor, &[("analysis", "{ modal.modes = 1 }"), ("loads", WEIGHT)]);
        assert!(warned(&outcome).is_empty(), "{:?}", outcome.summary.record.warnings);
    }
    let thin = ("bodies.plate.shell.section.homogeneous.thickness", "0.003");
    let (_, outcome) = modes(&common::text(SCENE), &[thin, ("analysis.modal.modes", "1")]);
    let said = &outcome.summary.record.warnings;
    assert!(warned(&outcome) == ["surface-waves"] && said[0].message.contains("% lower"), "{said:?}");
}

/// What has no modes in still water is refused by the key that is in the way.
#[test]
fn refusals() {
    let modal = ("analysis", "{ modal.modes = 1 }");
    for (replaced, says) in [
        (("bodies.water.fluid.velocity", "{ linear = [1.0, 0.0, 0.0] }"), "the water is still"),
        (
            (
                "bodies.water.fluid.geometry",
                "{ disc = { centre = [0.3, 0.3], radius = 0.2, spacing = 0.05 } }",
            ),
            "blocks",
        ),
        (
            (
                "bodies.tank.walls.motion",
                "{ translation = { by = [1.0, 0.0, 0.0], amplitude = { ramp = 1.0 } } }",
            ),
            "in which walls stand",
        ),
        (
            ("bodies.tank.walls.geometry.basin", "{ min = [0.0, -0.15], max = [0.6, 0.6], open = [\"y0\"] }"),
            "no free surface",
        ),
        (("bodies.floor.shell.wet", "\"back\""), "no wet face has water"),
        (
            (
                "bodies.tank.walls.geometry.basin",
                "{ min = [0.0, -0.15], max = [0.6, 0.9], open = [\"x1\", \"y0\", \"y1\"] }",
            ),
            "do not look up",
        ),
        (
            (
                "bodies.float.rigid",
                "{ geometry.box = { min = [0.2, 0.3, 0.0], max = [0.3, 0.4, 0.1], spacing = 0.05 }, density = 500.0 }",
            ),
            "only shells have modes",
        ),
    ] {
        let message = refused(SPRUNG, &[modal, ("loads", WEIGHT), replaced]);
        assert!(message.contains(says), "{replaced:?}: {message}");
    }
    let static_one = refused(SPRUNG, &[("analysis", "{ static.levels = 1 }")]);
    assert!(static_one.contains("modes of shells in still water"), "{static_one}");
    assert!(Scene::parse(SPRUNG, "scene.toml").is_ok());
}

/// Water that begins a part of a spacing above the face of the floor reaches down to it: its column is that much higher. Beyond half a spacing the face is dry.
#[test]
fn water_reaches_over_a_gap_to_the_floor() {
    let at = |gap: f64| format!("[0.0, {:?}, 0.225]", -0.025 - gap);
    let modal = [("analysis", "{ modal.modes = 1 }"), ("loads", WEIGHT)];
    for part in [0.1, 0.2, 0.4, 0.49] {
        let gap = 0.05 * part;
        let exact = (145_800.0_f64 / 0.27 / (100.0 + 1000.0 * (0.6 + gap))).sqrt() / TAU;
        let origin = at(gap);
        let found = frequencies(SPRUNG, &[modal[0], modal[1], ("bodies.floor.shell.placed.origin", &origin)]);
        let off = found[0] / exact - 1.0;
        // As without a gap, 3e-8: springs are shared by particles and masses by area.
        assert!(off.abs() < 1e-7, "{part}: {off:e}");
    }
    let beyond = at(0.51 * 0.05);
    let dry = refused(SPRUNG, &[modal[0], modal[1], ("bodies.floor.shell.placed.origin", &beyond)]);
    assert!(dry.contains("no wet face has water"), "{dry}");
}

/// A fluid in a plane has one width, that of its shells; water stands in no wall and at no place twice, blocks side by side are one.
#[test]
fn water_stands_once_and_has_one_width() {
    let both = tank(&[("a", true), ("b", false)], false);
    let wide = refused(&both, &[("bodies.b.shell.geometry.plate.lengths", "[1.0, 0.2]")]);
    assert!(wide.contains("several widths"), "{wide}");
    let (modal, weight) = (("analysis", "{ modal.modes = 1 }"), ("loads", WEIGHT));
    let blocks = |parts: &str| format!("{{ blocks = {{ spacing = 0.05, parts = [{parts}] }} }}");
    let of = |geometry: &str| refused(SPRUNG, &[modal, weight, ("bodies.water.fluid.geometry", geometry)]);
    for lengths in ["lengths = [0.65, 0.6]", "lengths = [0.6, 0.6], origin = [0.05, 0.0]"] {
        let said = of(&format!("{{ block = {{ {lengths}, spacing = 0.05 }} }}"));
        assert!(said.contains("stands at [0.6250, 0.0250, 0.0000]") && said.contains("wall"), "{said}");
    }
    let twice = of(&blocks("{ lengths = [0.6, 0.6] }, { lengths = [0.3, 0.3] }"));
    assert!(twice.contains("two particles of the fluid stand at [0.0250, 0.0250, 0.0000]"), "{twice}");
    let beside = blocks("{ lengths = [0.3, 0.6] }, { lengths = [0.3, 0.6], origin = [0.3, 0.0] }");
    let beside = frequencies(SPRUNG, &[modal, weight, ("bodies.water.fluid.geometry", &beside)])[0];
    // Cells in another order: rounding of a factor, 6e-16 of the frequency measured.
    assert!((beside / frequencies(SPRUNG, &[modal, weight])[0] - 1.0).abs() < 1e-12);
}
