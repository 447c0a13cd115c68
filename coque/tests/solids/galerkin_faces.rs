//! Loads on parts of faces of Galerkin solids: force and moment are those of the area that the set holds.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::galerkin::{ARC, BAR};
use crate::common::{Replaced, overridden};
use sph_core::Vec3;

/// Force and moment about the origin of the loads of a scene.
fn resultant(text: &str, replaced: Replaced) -> [Vec3; 2] {
    overridden(text, "galerkin.toml", replaced).unwrap().build_galerkin(1).unwrap().load_resultant(1.0)
}

fn refusal(text: &str, replaced: Replaced) -> String {
    overridden(text, "galerkin.toml", replaced).unwrap().build(1).expect_err("a refusal").to_string()
}

/// Of a rectangle under a pressure.
fn of_rectangle(x: [f64; 2], y: [f64; 2], z: f64, pressure: f64) -> [Vec3; 2] {
    let force = Vec3::new(0.0, 0.0, -pressure * (x[1] - x[0]) * (y[1] - y[0]));
    [force, Vec3::new(0.5 * (x[0] + x[1]), 0.5 * (y[0] + y[1]), z).cross(&force)]
}

fn same(found: [Vec3; 2], wanted: [Vec3; 2], name: &str) {
    let miss = (found[0] - wanted[0]).norm().max((found[1] - wanted[1]).norm());
    assert!(miss < 1e-13 * wanted[0].norm().max(1e-3), "{name}: {found:?} for {wanted:?}");
}

/// Borders of a box that run between nodes cut the cells: spacing .5 on 2 by 1.
#[test]
fn a_box_presses_on_the_area_that_it_holds() {
    let pressed = ("loads", "[{ on = 'part', pressure = { value = 2.0, follower = true } }]");
    for (name, low, high) in [
        ("whole cells", [0.0, 0.0], [1.0, 1.0]),
        ("beyond nodes", [0.0, 0.0], [1.3, 0.9]),
        ("short of nodes", [0.1, 0.2], [1.4, 0.95]),
        ("within cells of every row", [0.3, 0.05], [1.9, 0.55]),
        ("one cell", [0.6, 0.1], [1.05, 0.6]),
    ] {
        let region = format!(
            "{{ box = {{ min = [{}, {}, 0.9], max = [{}, {}, 1.1] }} }}",
            low[0], low[1], high[0], high[1]
        );
        let found = resultant(BAR, &[("sets.part", &region), pressed]);
        same(found, of_rectangle([low[0], high[0]], [low[1], high[1]], 1.0, 2.0), name);
    }
    // A margin round the box meets the sides beside the face, and loads none of them.
    let margin = ("sets.part", "{ box = { min = [-0.1, -0.1, 0.9], max = [1.3, 1.1, 1.1] } }");
    same(resultant(BAR, &[margin, pressed]), of_rectangle([0.0, 1.3], [0.0, 1.0], 1.0, 2.0), "margin");
    // Over an edge, two sides.
    let edge = ("sets.part", "{ box = { min = [0, 0, 0.3], max = [1.2, 0.7, 1] } }");
    let [force, _] = resultant(BAR, &[edge, pressed]);
    let wanted = Vec3::new(0.7 * 0.7, 1.2 * 0.7, -1.2 * 0.7) * 2.0;
    assert!((force - wanted).norm() < 1e-13, "{force}");
}

/// A band aslant, a layer, and tractions as pressures.
#[test]
fn bands_layers_and_tractions_are_cut_as_well() {
    let traction = ("loads", "[{ on = 'part', traction = { value = [1.0, 2.0, 3.0] } }]");
    let band = "{ plane = { point = [1, 0.5, 0.5], normal = [1, 1, 0], within = 0.8 } }";
    let [force, _] = resultant(BAR, &[("sets.part", band), traction]);
    // What two corners of top and bottom, legs c, and strips of the sides as wide leave of the whole surface of ten.
    let c = 1.5 - 0.8 * 2.0_f64.sqrt();
    let area = 10.0 - 2.0 * c * c - 4.0 * c;
    assert!((force - Vec3::new(1.0, 2.0, 3.0) * area).norm() < 1e-12, "{force} for {area}");
    let layer = ("sets.part", "{ layer = { face = 'x1', depth = 0.7 } }");
    let [force, _] = resultant(BAR, &[layer, traction]);
    assert!((force - Vec3::new(1.0, 2.0, 3.0) * (1.0 + 4.0 * 0.7)).norm() < 1e-12, "{force}");
    // Half of an arc, by a layer that ends between nodes: the facets of the outer face are as long as their chords.
    let layer = ("sets.part", "{ layer = { face = 'x0', depth = 1.0 } }");
    let loads = ("loads", "[{ on = 'part', pressure = { value = 1.0, follower = true } }]");
    let [force, _] = resultant(ARC, &[layer, loads]);
    assert!(force.norm().is_finite());
    let plane = ("sets.part", "{ plane = { point = [0, 0, 1], normal = [0, 0, 1] } }");
    let pressed = ("loads", "[{ on = 'part', pressure = { value = 2.0, follower = true } }]");
    same(resultant(BAR, &[plane, pressed]), of_rectangle([0.0, 2.0], [0.0, 1.0], 1.0, 2.0), "a plane");
}

#[test]
fn a_set_without_a_face_is_refused() {
    let loads = ("loads", "[{ on = 'part', pressure = { value = 2.0, follower = true } }]");
    for region in
        ["{ nearest = [2, 0.5, 0.5] }", "{ box = { min = [0.9, 0.4, 0.4], max = [1.1, 0.6, 0.6] } }"]
    {
        let found = refusal(BAR, &[("sets.part", region), loads]);
        assert!(found.contains("holds no whole face of a cell"), "{found}");
    }
}
