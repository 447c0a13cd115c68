//! Scenes of fluids in space, in walls from a file and in walls that move, by every method and order, against what is known.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::fs;
use std::path::{Path, PathBuf};

use crate::common::fluids::{CUBE, DAM, PISTON, ROLLING, ROLLING_IN_SPACE, SHELL_GATE};
use crate::common::{self, Replaced, column, last, overridden};
use coque::{Ended, Outcome, Scene, Silent};

fn ran(text: &str, replaced: Replaced) -> Outcome {
    let outcome = common::ran(overridden(text, "scene.toml", replaced));
    assert_eq!(outcome.ended, Ended::Done, "{:?}", outcome.summary.record.warnings);
    outcome
}

fn warned(outcome: &Outcome) -> Vec<&'static str> {
    outcome.summary.record.warnings.iter().map(|warning| warning.kind.word()).collect()
}

/// Gauges read ρg times a depth at once; the force of a lattice that has not settled is short by a spacing of head, of ten
/// rows 11 % measured. A fluid that is symmetric turns nothing about its middle, to round-off, and nothing flows.
#[test]
fn a_cube_of_water_stands_on_a_plate() {
    let outcome = ran(CUBE, &[]);
    let first = |name: &str| column(&outcome, name)[0];
    let weight = 1000.0 * 10.0 * 0.2 * 0.2 * 0.2;
    assert!((first("F") / -weight - 1.0).abs() < 0.15, "{} of {weight}", first("F"));
    assert!(first("Mc").abs() < 1e-9 * weight, "{}", first("Mc"));
    // About the origin the force acts an arm of .1 along y away: M_x = y F_z.
    assert!((first("Mx") / (0.1 * first("F")) - 1.0).abs() < 1e-9, "{}", first("Mx"));
    assert!((first("p") / (1000.0 * 10.0 * 0.15) - 1.0).abs() < 1e-3, "{}", first("p"));
    assert!((first("h") - 0.2).abs() < 0.005, "{}", first("h"));
    assert!(column(&outcome, "Q").iter().all(|q| q.abs() < 1e-3 * 0.04), "{:?}", column(&outcome, "Q"));
    assert!(last(&outcome, "w") < -1e-7, "{:?}", column(&outcome, "w"));
    let units: Vec<&str> = outcome.curve.columns.iter().map(|column| column.unit.as_str()).collect();
    assert_eq!(units[6..], ["N", "N", "N m", "N m", "N m", "N m", "m", "N/m²", "m", "m³/s"]);
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("fluid_scenes").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// An open box of triangles, in no order.
fn tub(lengths: [f64; 3], height: f64) -> String {
    let corner = |i: usize| {
        let at = |axis: usize| if i >> axis & 1 == 1 { lengths[axis] } else { 0.0 };
        [at(0), at(1), if i >> 2 & 1 == 1 { height } else { 0.0 }]
    };
    let faces = [[0, 1, 3, 2], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let mut text = String::from("solid tub\n");
    for [a, b, c, d] in faces {
        for triangle in [[a, b, c], [a, c, d]] {
            text += "facet normal 0 0 0\nouter loop\n";
            for [x, y, z] in triangle.map(corner) {
                text += &format!("vertex {x} {y} {z}\n");
            }
            text += "endloop\nendfacet\n";
        }
    }
    text + "endsolid tub\n"
}

/// Water in walls from a file bears on them with its weight, at the start less a spacing of head; nothing leaks.
#[test]
fn water_stands_in_walls_from_a_file() {
    let folder = folder("tub");
    fs::write(folder.join("tub.stl"), tub([200.0, 200.0, 200.0], 300.0)).unwrap();
    let from = CUBE.find("supports = [").unwrap()..CUBE.find("curve = [").unwrap();
    let mut text = CUBE.to_string();
    text.replace_range(from, "");
    let plate = text.find("[bodies.plate").unwrap();
    text.truncate(plate);
    let lines = |line: &str| !(line.contains("plate.all") || line.starts_with("geometry.basin"));
    let mut text: String = text.lines().filter(|line| lines(line)).map(|line| format!("{line}\n")).collect();
    text += "geometry.surface = { file = \"tub.stl\", inside = [0.1, 0.1, 0.1], scale = 1e-3 }\n";
    let force = "curve = [{ name = \"F\", of = \"force\", on = \"tank.all\", direction = [0, 0, 1] },";
    let text = text.replace("curve = [", force).replace("duration = 0.004", "duration = 0.1");
    let scene = Scene::parse(&text, &folder.join("scene.toml").to_string_lossy()).unwrap();
    let outcome = scene.build(1).unwrap().run(&mut Silent);
    assert_eq!(outcome.ended, Ended::Done);
    let weight = 1000.0 * 10.0 * 0.2 * 0.2 * 0.2;
    let forces = column(&outcome, "F");
    assert!((forces[0] / -weight - 1.0).abs() < 0.15, "{} of {weight}", forces[0]);
    // At rest walls bear all of the weight.
    let mean = forces[50..].iter().sum::<f64>() / forces[50..].len() as f64;
    assert!((mean / -weight - 1.0).abs() < 0.05, "{mean}");
    assert!(warned(&outcome).is_empty(), "{:?}", outcome.summary.record.warnings);
    assert!(outcome.shapes.last().unwrap().positions[..1000].iter().all(|x| x.z > 0.0), "leaks");
}

/// A piston that takes a fifth of the length raises the level by a quarter; what flows through the middle is what the other
/// half gained.
#[test]
fn a_piston_pushes_water_up() {
    let outcome = ran(PISTON, &[]);
    let ways = column(&outcome, "x");
    // Its foremost row stands half a spacing behind its face.
    assert!((ways[0] + 0.005).abs() < 1e-12 && (last(&outcome, "x") - 0.035).abs() < 1e-12, "{ways:?}");
    let levels = column(&outcome, "h");
    let mean = |of: &[f64]| of.iter().sum::<f64>() / of.len() as f64;
    // A fifth of a second of sloshing, twelve rows deep: a third of a spacing.
    let level = mean(&levels[160..]);
    assert!((level - 0.125).abs() < 0.004, "{level}");
    let volume = 0.005 * column(&outcome, "Q").iter().sum::<f64>();
    // Five percent too much: the other half is the higher one at the end of the run.
    assert!((volume / (0.1 * (0.125 - 0.1)) - 1.0).abs() < 0.1, "{volume}");
    assert!(column(&outcome, "F").iter().all(|f| *f < 0.0));
    let figures = outcome.summary.record.fluid.clone().unwrap();
    assert_eq!((figures.mass, figures.lost), (1000.0 * 0.2 * 0.1, 0));
}

/// A gauge on walls that turn turns with them, one on the fluid stays.
#[test]
fn gauges_turn_with_a_rolling_tank() {
    let outcome = ran(ROLLING, &[]);
    let (dry, corner) = (column(&outcome, "dry"), column(&outcome, "corner"));
    for (row, (dry, corner)) in dry.iter().zip(&corner).enumerate() {
        let angle = 20.0_f64.to_radians() * row as f64 * 0.1;
        let (sin, cos) = libm::sincos(angle);
        let height = |x: f64, y: f64| 0.1 + (x - 0.2) * sin + (y - 0.1) * cos;
        // Where there is no water over a point its level is its own height.
        assert!((dry - height(0.7, 0.35)).abs() < 1e-12, "{row}: {dry}");
        // The particle of the wall nearest to that corner.
        assert!((corner - height(0.41, 0.39)).abs() < 1e-12, "{row}: {corner}");
    }
    let (wet, fixed) = (column(&outcome, "wet"), column(&outcome, "fixed"));
    assert!((wet[0] - fixed[0]).abs() < 1e-9 && (wet[0] / 1000.0 - 1.0).abs() < 0.01, "{wet:?} {fixed:?}");
    // The floor rises past the point that stays: that one is dry behind it, the other stands on it.
    assert!(fixed[10] == 0.0 && wet[10] > 300.0, "{wet:?} {fixed:?}");
}

/// In space a gauge goes the way of the particle of the wall that it stands on.
#[test]
fn gauges_turn_with_walls_in_space() {
    let outcome = ran(ROLLING_IN_SPACE, &[]);
    let (dry, particle) = (column(&outcome, "dry"), column(&outcome, "z"));
    assert!((particle[5] - particle[0]).abs() > 0.02, "{particle:?}");
    assert!(dry.iter().zip(&particle).all(|(a, b)| (a - b).abs() < 1e-12), "{dry:?} {particle:?}");
}

/// The published method on the same scene: its own defaults, and a front as fast to within a row.
#[test]
fn the_published_method_runs_a_dam_break() {
    let ours = ran(DAM, &[("analysis.explicit.transient.duration", "0.15")]);
    let method = ("bodies.water.fluid.formulation", "{ weakly-compressible = { method = \"source\" } }");
    let source = ran(DAM, &[("analysis.explicit.transient.duration", "0.15"), method]);
    let modelled = &source.summary.body.modelled;
    let says =
        |words: &str| assert!(modelled.iter().any(|line| line.contains(words)), "{words}: {modelled:?}");
    says("predictor and corrector, smoothing length 1.3 spacings, artificial viscosity 0.1");
    // The published width, at which waves are too fast; the default one is warned of nothing but its viscosity on so few particles.
    assert!(warned(&source).contains(&"stiff-lattice"));
    assert_eq!(warned(&ours), ["late-front"]);
    says("walls with densities of their own");
    says("particles carried by the mean velocity");
    let (ours, theirs) = (last(&ours, "front"), last(&source, "front"));
    assert!((ours - theirs).abs() < 0.05, "{ours}, {theirs}");
    let error = source.summary.record.energies.balance_error;
    assert!(error.abs() < 0.1 * last(&source, "external"), "{error}");
}

/// The order of published couplings runs, and is warned of.
#[test]
fn the_order_that_pumps_is_warned_of() {
    let replaced = [("coupling", "{ order = \"fluid-first\", impedance = false }")];
    let outcome = ran(SHELL_GATE, &replaced);
    assert_eq!(warned(&outcome), ["fluid-first"]);
    assert!(outcome.summary.record.warnings[0].message.contains("order = \"structure-first\""));
    assert!(warned(&ran(SHELL_GATE, &[])).is_empty());
}

/// Boundaries that pull on a fluid while they give way are warned of; without structures they are not.
#[test]
fn structures_that_a_fluid_may_pull_are_warned_of() {
    let confined = [("bodies.water.fluid.formulation.weakly-compressible", "{ confined = true }")];
    assert_eq!(warned(&ran(SHELL_GATE, &confined)), ["pulling-boundary"]);
}
