//! Buckling driven by prescribed motions: the same as by forces, at rest in any frame, and converging.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::{last, ran};
use coque::Scene;

const HEAD: &str = "title = \"Buckling\"\nunits = { length = \"m\", force = \"N\", time = \"s\" }\n";
const BUCKLING: &str = "analysis.buckling.modes = 1\nanalysis.buckling.sign = \"either\"\n";

/// The last value of a column of a scene.
fn found(text: &str, name: &str) -> f64 {
    last(&ran(Scene::parse(&format!("{HEAD}{text}"), "scene.toml")), name)
}

/// A column 1 × .1 of membranes in its plane, clamped at `u0`, its end guided.
fn column_of_shell(cells: usize) -> String {
    format!(
        "geometry.plate = {{ lengths = [1.0, 0.1], particles = [{}, {}] }}\n\
         material.elastic = {{ young = 1e6, poisson = 0.0, density = 1.0 }}\nsection.homogeneous.thickness = 0.1\n",
        10 * cells + 1,
        cells + 1
    )
}

/// A strip on its edge, ten times as long as deep, a tenth as thick.
fn strip(cells: usize) -> String {
    format!(
        "geometry.plate = {{ lengths = [10.0, 1.0], particles = [{}, {}] }}\n\
         material.elastic = {{ young = 1.2e6, poisson = 0.0, density = 1.0 }}\nsection.homogeneous.thickness = 0.1\n",
        10 * cells + 1,
        cells + 1
    )
}

/// The same column of bonds.
fn column_of_bonds(cells: usize) -> String {
    format!(
        "[bodies.column.solid]\ngeometry.block = {{ lengths = [1.0, 0.1], spacing = {}, nodes = \"edges\" }}\n\
         material.elastic = {{ young = 1e6, poisson = 0.3333333333333333, density = 1.0 }}\n\
         formulation.bond-based = {{ plane = \"stress\", horizon = 3.015 }}\n",
        0.1 / cells as f64
    )
}

fn moved(on: &str, direction: [f64; 3], by: f64) -> String {
    format!("{{ on = \"{on}\", moved = {{ direction = {direction:?}, by = {by:?} }} }}")
}

/// A dead force on the end of the strip, and the motion of the end that calls for it: .0003 % apart on every lattice, and the
/// differences from lattice to lattice fall. As far as it went by what is free alone, the motion came to .82 and then to .54 of the force.
#[test]
fn a_strip_buckles_aside_alike_by_force_and_by_motion() {
    let clamped = "{ on = \"u0\", clamped = {} }";
    let up = [0.0, 1.0, 0.0];
    let mut forces = Vec::new();
    for cells in [4, 8, 12, 16] {
        let body = strip(cells);
        let pushed =
            format!("supports = [{clamped}]\nloads = [{{ on = \"u1\", force.total = [0, 1, 0] }}]\n");
        let by_force = found(&format!("{body}{pushed}{BUCKLING}"), "level").abs();
        let held = format!("supports = [{clamped}, {}]\n", moved("u1", up, 0.1));
        let level = found(&format!("{body}{held}{BUCKLING}"), "level").abs();
        let curve = "curve = [{ name = \"R\", of = \"reaction\", on = \"u1\", direction = [0, 1, 0] }]\n";
        let by_motion = level * found(&format!("{body}{held}analysis.linear = {{}}\n{curve}"), "R");
        println!("{cells}: {by_force} {by_motion}");
        assert!((by_motion / by_force - 1.0).abs() < 1e-4, "{cells}: {by_motion} {by_force}");
        forces.push(by_force);
    }
    let steps: Vec<f64> = forces.windows(2).map(|pair| (pair[0] - pair[1]).abs()).collect();
    assert!(steps.is_sorted_by(|a, b| a > b) && steps[2] < 1e-3 * forces[3], "{forces:?}");
}

/// With its end guided, π²EI/L² over 1 + π²EI/(κGAL²) is 80.65 N, at 10 N a millimetre; when it buckles, the column is
/// .8 % shorter. Found: 6.62, 7.68, 7.90, 7.95; as far as it went by what is free alone 4.28, 3.27, 1.92, 1.02.
#[test]
fn a_column_of_membranes_buckles_in_its_plane_by_motion() {
    let mut levels = Vec::new();
    for cells in [2, 4, 8, 16] {
        let flat = "{ on = \"all\", held = { displacement = [[0, 0, 1]] } }";
        let pushed = moved("u1", [-1.0, 0.0, 0.0], 0.001);
        let held = format!("supports = [{{ on = \"u0\", clamped = {{}} }}, {flat}, {pushed}]\n");
        levels.push(found(&format!("{}{held}{BUCKLING}", column_of_shell(cells)), "level"));
    }
    println!("{levels:?}");
    let steps: Vec<f64> = levels.windows(2).map(|pair| pair[1] - pair[0]).collect();
    assert!(steps.is_sorted_by(|a, b| *a > 2.0 * b) && steps[2] > 0.0, "{levels:?}");
    assert!((levels[3] / 8.065 - 1.0).abs() < 0.025, "{levels:?}");
}

/// The derivative with the change of shape and that with stresses alone differ by the strain at which the column buckles, .8 %.
#[test]
fn a_column_of_bonds_buckles_by_motion_as_its_stresses_say() {
    let mut levels = Vec::new();
    for cells in [4, 6, 8, 12] {
        let held = format!(
            "supports = [{{ on = \"x0\", clamped = {{}} }}, {}]\n",
            moved("x1", [-1.0, 0.0, 0.0], 0.001)
        );
        let stress = "analysis.buckling.prebuckling = \"stress\"\n";
        let [whole, alone] = ["", stress]
            .map(|more| found(&format!("{held}{BUCKLING}{more}{}", column_of_bonds(cells)), "level"));
        assert!((whole / alone - 1.0).abs() < 0.015, "{cells}: {whole} {alone}");
        levels.push(whole);
    }
    println!("{levels:?}");
    assert!(levels.is_sorted() && levels[3] - levels[2] < levels[1] - levels[0] + 0.05, "{levels:?}");
}

/// Who moves is nobody's business: one end against the other, both by half, both along with a frame that moves as well.
#[test]
fn it_does_not_matter_which_end_moves() {
    let along = [1.0, 0.0, 0.0];
    let flat = "{ on = \"all\", held = { displacement = [[0, 0, 1]] } }, ";
    let across = "{ on = \"u0\", held = { displacement = [[0, 1, 0]] } }, ";
    for (body, ends, more) in [
        (column_of_shell(4), ["u0", "u1"], format!("{flat}{across}")),
        (column_of_bonds(4), ["x0", "x1"], across.replace("u0", "x0")),
    ] {
        let of = |first: f64, second: f64| {
            let [first, second] = [moved(ends[0], along, first), moved(ends[1], along, second)];
            found(&format!("supports = [{more}{first}, {second}]\n{BUCKLING}{body}"), "level")
        };
        let one = of(0.0005, -0.0005);
        for (first, second) in [(0.001, 0.0), (0.0, -0.001), (0.003, 0.002), (-0.02, -0.021)] {
            let other = of(first, second);
            println!("{first} {second}: {one} {other}");
            assert!((other / one - 1.0).abs() < 1e-6, "{first} {second}: {one} {other}");
        }
    }
}
