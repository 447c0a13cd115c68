//! Half of a body with a mirror against the whole.

use super::{
    common::{last, torn},
    difference, judge, ran,
};
use coque::Outcome;

/// The upper half or all of a bar pulled at its ends, its middle plane at y = 0. It is read at one node: the mean over an end counts nodes in
/// the plane as often as others in the half.
fn bar(half: bool, formulation: &str, loads: &str) -> String {
    let (width, origin) = if half { (0.5, 0.0) } else { (1.0, -0.5) };
    let mirror = if half { ", { on = \"y0\", symmetry = { normal = [0, 1, 0] } }" } else { "" };
    format!(
        "title = \"Bar\"\nunits = {{ length = \"m\", force = \"N\", time = \"s\" }}\nanalysis.linear = {{}}\n\
         supports = [{{ on = \"x0\", clamped = {{}} }}{mirror}]\nloads = [{{ on = \"x1\", traction = {{ value = {loads} }} }}]\n\
         sets.end = {{ nearest = [4.0, 0.5, 0.5] }}\n\
         curve = [{{ name = \"u\", of = \"displacement\", on = \"end\", direction = [1, 0, 0] }}]\n\
         [bodies.bar.solid]\n\
         geometry.block = {{ lengths = [4.0, {width}, 1.0], origin = [0.0, {origin}, 0.0], spacing = 0.25 }}\n\
         material.elastic = {{ young = 1e3, poisson = 0.3, density = 1.0 }}\nformulation.{formulation}\n"
    )
}

#[test]
fn half_a_bar_moves_as_the_whole() {
    let mut failures = Vec::new();
    for (name, formulation, bound) in [
        ("galerkin", "galerkin = { basis = \"quadratic\", support.ellipsoid = 2.5 }", 1e-9),
        ("state-based", "state-based = { horizon = 3.015 }", 1e-6),
    ] {
        let [half, whole] =
            [true, false].map(|half| last(&ran(&bar(half, formulation, "[1.0, 0.0, 0.0]"), &[], 1), "u"));
        judge(&mut failures, "half", name, ((half / whole - 1.0).abs(), "u".into()), bound);
    }
    assert!(failures.is_empty(), "{failures:#?}");
}

/// A strip tears along its middle: the same forces before and after bonds break, half of the energies, the same sets one after another.
#[test]
fn half_a_strip_tears_as_the_whole() {
    let mut failures = Vec::new();
    let [half, whole] = [true, false].map(|half| ran(&torn::strip(half), &[], 1));
    let factors: Vec<_> =
        half.curve.columns.iter().map(|column| if column.name == "internal" { 2.0 } else { 1.0 }).collect();
    judge(&mut failures, "half", "torn strip", difference(&half, &whole, &factors), 1e-9);
    assert!(failures.is_empty(), "{failures:#?}");
    let broken = |outcome: &Outcome| outcome.summary.record.breaking.clone().unwrap();
    let [half, whole] = [broken(&half), broken(&whole)];
    assert_eq!(half.sets, whole.sets);
    assert!((2.0 * half.energy / whole.energy - 1.0).abs() < 1e-9, "{half:?} {whole:?}");
    assert!((2.0 * half.released / whole.released - 1.0).abs() < 1e-9, "{half:?} {whole:?}");
}

/// A plate clamped at one end with a blade along its middle line, all of it or the half on one side of the plane that cuts the blade along.
fn ribbed(half: bool, analysis: &str) -> String {
    let (width, origin, counts, share) = if half { (2.0, 0.0, 5, 0.5) } else { (4.0, -2.0, 9, 1.0) };
    let plane = if half { ", { on = \"v0\", symmetry = { normal = [0, 1, 0] } }" } else { "" };
    let load = if half { 3.0 } else { 6.0 };
    format!(
        "title = \"Rib\"\nunits = {{ length = \"mm\", force = \"N\", time = \"s\" }}\nanalysis.{analysis}\n\
         geometry.plate = {{ lengths = [10.0, {width:?}], particles = [13, {counts}] }}\n\
         placed = {{ origin = [0.0, {origin:?}, 0.0], u = [1, 0, 0], v = [0, 1, 0] }}\n\
         material.elastic = {{ young = 70e3, poisson = 0.3, density = 2.7e-9 }}\nsection.homogeneous.thickness = 0.2\n\
         sets.rib.plane = {{ point = [0, 0, 0], normal = [0, 1, 0] }}\nsets.tip.nearest = [10.0, 0.0, 0.0]\n\
         supports = [{{ on = \"u0\", clamped = {{}} }}{plane}]\nloads = [{{ on = \"u1\", force = {{ total = [0.0, 0.0, {load:?}] }} }}]\n\
         stiffeners = [{{ on = \"rib\", side = \"top\", section.rectangle = {{ width = 0.2, height = 0.8 }}, share = {share:?} }}]\n\
         curve = [{{ name = \"w\", of = \"displacement\", on = \"tip\", direction = [0, 0, 1] }}, \
         {{ name = \"u\", of = \"displacement\", on = \"tip\", direction = [1, 0, 0] }}]\n"
    )
}

/// Half a blade on the plane of symmetry: the same motion; the first mode is even, and has the same frequency but for what masses of modes move along an edge, for which
/// the half takes the plane: 1.3e-5 here, 4e-5 of the first mode without a blade that bends across.
#[test]
fn half_a_plate_with_half_a_rib_moves_as_the_whole() {
    let mut failures = Vec::new();
    let [half, whole] = [true, false].map(|half| ran(&ribbed(half, "static.levels = 2"), &[], 1));
    let factors: Vec<_> =
        half.curve.columns.iter().map(|column| if column.name == "internal" { 2.0 } else { 1.0 }).collect();
    judge(&mut failures, "half", "rib", difference(&half, &whole, &factors), 1e-9);
    let first = |half: bool| {
        let text = ribbed(half, "modal.modes = 1").replace("curve = [{", "unread = [{");
        let text = text.split("unread").next().unwrap().to_string();
        ran(&text, &[], 1).curve.rows[0][1]
    };
    let [half, whole] = [true, false].map(first);
    judge(&mut failures, "half", "rib, modes", ((half / whole - 1.0).abs(), "omega".into()), 4e-5);
    assert!(failures.is_empty(), "{failures:#?}");
}
