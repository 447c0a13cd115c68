//! A hollow ball whose nodes fill a surface from a file: turned, mirrored, in other units, its faces counted and divided otherwise, half against whole.

use super::{Outcome, common::surfaces::Obj, common::text, difference, judge, ran};

const SCENE: &str = "meshes/hollow-ball.toml";
const FILE: &str = "bodies.ball.solid.geometry.filled";

/// On a coarse lattice of 8 cells along each axis, of the whole 16; `more` replaces and adds.
fn ball(surface: &Obj, name: &str, more: &[(&str, &str)]) -> Outcome {
    let filled = format!("{{ file = {:?}, spacing = 12.52 }}", surface.write(name));
    let mut replaced = vec![(FILE, filled.as_str())];
    replaced.extend(more);
    ran(&text(SCENE), &replaced, 1)
}

fn surface() -> Obj {
    Obj::parse(&text("meshes/hollow-ball.obj"))
}

fn held(relation: &str, one: &Outcome, other: &Outcome, factors: &[f64], bound: f64) {
    let mut failures = Vec::new();
    judge(&mut failures, relation, "a filled ball", difference(one, other, factors), bound);
    assert!(failures.is_empty(), "{failures:#?}");
}

/// Conjugate gradients end at 1e-10 of the load, on other orders of the nodes at other places of that.
const BOUND: f64 = 1e-8;

#[test]
fn turned_mirrored_and_counted_otherwise_it_is_the_same() {
    let still = ball(&surface(), "still", &[]);
    let ones = vec![1.0; still.curve.columns.len()];
    let turned = [
        ("sets.outer.nearest", "[0.0, 100.0, 0.0]"),
        ("sets.middle.nearest", "[3.125, 78.125, 3.125]"),
        ("curve[0].direction", "[0.0, 1.0, 0.0]"),
        ("curve[1].direction", "[0.0, 1.0, 0.0]"),
    ];
    let around = surface().mapped(|[x, y, z]| [z, x, y]);
    held("turned", &still, &ball(&around, "turned", &turned), &ones, BOUND);
    let mirrored = [
        ("sets.outer.nearest", "[-100.0, 0.0, 0.0]"),
        ("sets.middle.nearest", "[-78.125, 3.125, 3.125]"),
        ("supports[0].on", "\"x1\""),
        ("curve[0].direction", "[-1.0, 0.0, 0.0]"),
        ("curve[1].direction", "[-1.0, 0.0, 0.0]"),
    ];
    let image = surface().mapped(|[x, y, z]| [-x, y, z]).reversed();
    held("mirrored", &still, &ball(&image, "mirrored", &mirrored), &ones, BOUND);
    held("counted otherwise", &still, &ball(&surface().divided(), "divided", &[]), &ones, BOUND);
}

#[test]
fn in_metres_it_is_the_same() {
    let still = ball(&surface(), "in-mm", &[]);
    let filled = format!("{{ file = {:?}, spacing = 0.01252, scale = 1e-3 }}", surface().write("in-m"));
    let replaced = [
        (FILE, filled.as_str()),
        ("units", "{ length = \"m\", force = \"N\", time = \"s\" }"),
        ("bodies.ball.solid.material.elastic", "{ young = 210e9, poisson = 0.3, density = 7850.0 }"),
        ("sets.outer.nearest", "[0.1, 0.0, 0.0]"),
        ("sets.middle.nearest", "[0.078125, 0.003125, 0.003125]"),
        ("loads[0].pressure.value", "100e6"),
    ];
    let metres = ran(&text(SCENE), &replaced, 1);
    let factor = |name: &str| if ["level", "negative_pivots"].contains(&name) { 1.0 } else { 1e-3 };
    let factors: Vec<f64> = still.curve.columns.iter().map(|column| factor(&column.name)).collect();
    held("units", &still, &metres, &factors, BOUND);
}

/// By shape functions, whose nodes lie on the surface: where it is as near in several places the mean of these tells none of them from the others. A direct
/// solver leaves less than conjugate gradients.
#[test]
fn by_shape_functions_it_is_the_same() {
    let scene = "meshes/hollow-ball-galerkin.toml";
    let ball = |surface: &Obj, name: &str, scale: &str, more: &[(&str, &str)]| {
        let filled = format!("{{ file = {:?}, {scale} }}", surface.write(name));
        let mut replaced = vec![(FILE, filled.as_str())];
        replaced.extend(more);
        ran(&text(scene), &replaced, 1)
    };
    let spacing = "spacing = 16.71";
    let still = ball(&surface(), "shapes-still", spacing, &[]);
    let ones = vec![1.0; still.curve.columns.len()];
    let turned = [
        ("sets.outer.nearest", "[0.0, 100.0, 0.0]"),
        ("sets.inner.nearest", "[0.0, 50.0, 0.0]"),
        ("curve[0].direction", "[0.0, 1.0, 0.0]"),
        ("curve[1].direction", "[0.0, 1.0, 0.0]"),
    ];
    let around = surface().mapped(|[x, y, z]| [z, x, y]);
    held("turned", &still, &ball(&around, "shapes-turned", spacing, &turned), &ones, BOUND);
    let mirrored = [
        ("sets.outer.nearest", "[-100.0, 0.0, 0.0]"),
        ("sets.inner.nearest", "[-50.0, 0.0, 0.0]"),
        ("supports[0].on", "\"x1\""),
        ("curve[0].direction", "[-1.0, 0.0, 0.0]"),
        ("curve[1].direction", "[-1.0, 0.0, 0.0]"),
    ];
    let image = surface().mapped(|[x, y, z]| [-x, y, z]).reversed();
    held("mirrored", &still, &ball(&image, "shapes-mirrored", spacing, &mirrored), &ones, BOUND);
    held(
        "counted otherwise",
        &still,
        &ball(&surface().divided(), "shapes-divided", spacing, &[]),
        &ones,
        BOUND,
    );
    let metres = [
        ("units", "{ length = \"m\", force = \"N\", time = \"s\" }"),
        ("bodies.ball.solid.material.elastic", "{ young = 210e9, poisson = 0.3, density = 7850.0 }"),
        ("sets.outer.nearest", "[0.1, 0.0, 0.0]"),
        ("sets.inner.nearest", "[0.05, 0.0, 0.0]"),
        ("loads[0].pressure.value", "100e6"),
    ];
    let scaled = ball(&surface(), "shapes-in-m", "spacing = 0.01671, scale = 1e-3", &metres);
    let factor = |name: &str| if ["level", "negative_pivots"].contains(&name) { 1.0 } else { 1e-3 };
    let factors: Vec<f64> = still.curve.columns.iter().map(|column| factor(&column.name)).collect();
    held("units", &still, &scaled, &factors, BOUND);
}

/// A quarter, its third plane of symmetry left out: one node is held there, which bears nothing.
#[test]
fn half_of_it_is_half_of_the_whole() {
    let half = ball(&surface(), "half", &[]);
    let held_once = [("supports[2]", "{ on = \"outer\", held = { displacement = [[0.0, 0.0, 1.0]] } }")];
    let whole = ball(&surface().doubled(), "whole", &held_once);
    let factor = |name: &str| if name == "internal" { 2.0 } else { 1.0 };
    let factors: Vec<f64> = half.curve.columns.iter().map(|column| factor(&column.name)).collect();
    held("half", &half, &whole, &factors, BOUND);
}
