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
