//! Warnings about solids: each rule fires on a scene made to break it and keeps still on sound ones.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::solids::{BAR, PLATE, SHEETS};
use crate::common::{Replaced, overridden, scene};
use coque::WarningKind;

fn warned(text: &str, replaced: Replaced) -> Vec<WarningKind> {
    let model = overridden(text, "scene.toml", replaced).unwrap().build(1).unwrap();
    model.warnings().iter().map(|warning| warning.kind).collect()
}

#[test]
fn sound_solids_raise_no_warning() {
    for text in [BAR, PLATE, SHEETS] {
        assert_eq!(warned(text, &[]), []);
    }
    // Waves and forces do not mind a short horizon, sheets are best with one.
    assert_eq!(warned(BAR, &[("bodies.bar.solid.formulation.state-based.horizon", "1.5")]), []);
}

#[test]
fn each_rule_fires_on_a_solid_that_breaks_it() {
    let plate = "bodies.plate.solid";
    let horizon = format!("{plate}.formulation.bond-based.horizon");
    assert_eq!(warned(PLATE, &[(&horizon, "2.015")]), [WarningKind::OddHorizon]);
    assert_eq!(warned(PLATE, &[(&horizon, "7.0")]), [WarningKind::OddHorizon]);
    let spacing = format!("{plate}.geometry.block.spacing");
    assert_eq!(warned(PLATE, &[(&spacing, "[0.25, 0.1]")]), [WarningKind::FlatCells]);
    assert_eq!(warned(PLATE, &[(&spacing, "[0.25, 0.2]")]), []);
    let across = ("loads[0].traction.value", "[0.0, 0.0, 1.0]");
    assert_eq!(warned(BAR, &[across]), [WarningKind::FewLayers]);
    // Eight layers lack a tenth of the stiffness at this horizon, ten less than a twentieth at half of it, which is reported as what may be.
    let fine = ("bodies.bar.solid.geometry.block.spacing", "0.125");
    assert_eq!(warned(BAR, &[across, fine]), [WarningKind::FewLayers]);
    let short = ("bodies.bar.solid.formulation.state-based.horizon", "1.5");
    let finer = ("bodies.bar.solid.geometry.block.spacing", "0.1");
    let model = overridden(BAR, "scene.toml", &[across, finer, short]).unwrap().build(1).unwrap();
    assert!(model.warnings().len() == 1 && model.warnings()[0].message.contains("may come out about"));
    // Modes bend whatever the loads are; the estimate is that of the lattice.
    let long = ("bodies.bar.solid.geometry.block.lengths", "[8.0, 1.0, 1.0]");
    for analysis in ["{ modal = { modes = 1 } }", "{ buckling = { modes = 1 } }"] {
        assert_eq!(warned(BAR, &[long, ("analysis", analysis)]), [WarningKind::FewLayers], "{analysis}");
    }
    // Nodes on faces lack bonds beyond them: the loaded one moves two spacings of strain too far, of sixteen.
    let edges = ("bodies.bar.solid.geometry.block.nodes", "\"edges\"");
    assert_eq!(warned(BAR, &[edges]), [WarningKind::LoadedFace]);
    let balanced = ("bodies.bar.solid.formulation.state-based.correction", "\"balanced\"");
    assert_eq!(warned(BAR, &[edges, balanced]), []);
    let moved =
        |on: &str| format!("{{ on = \"{on}\", moved = {{ direction = [1.0, 0.0, 0.0], by = 0.1 }} }}");
    let layer = ("sets.end.layer", "{ face = \"x1\", depth = 0.76 }");
    assert_eq!(warned(BAR, &[layer, ("supports[+]", &moved("x1"))]), [WarningKind::ThinLayer]);
    assert_eq!(warned(BAR, &[layer, ("supports[+]", &moved("end"))]), []);
    // The bar is two cells thick: that is all there is of it, and no depth of the layer.
    let thin = ("bodies.bar.solid.geometry.block.lengths", "[4.0, 0.5, 0.5]");
    assert!(!warned(BAR, &[thin, layer, ("supports[+]", &moved("end"))]).contains(&WarningKind::ThinLayer));
}

/// Five layers with one factor a bond have all of their stiffness in bending, but clamps on nodes at centres of cells hold behind their faces: the
/// deflection under a load all over is 4.2 % off.
#[test]
fn a_clamp_behind_its_face_is_reported() {
    const GATE: &str = r#"
title = "Gate"
units = { length = "m", force = "N", time = "s" }
[bodies.gate.solid]
geometry.block = { lengths = [0.082, 0.005], spacing = 0.001, origin = [-0.003, -0.0025] }
material.elastic = { young = 12e6, poisson = 0.4, density = 1100.0 }
formulation.state-based = { plane = "strain", correction = "energy-factor" }
[[supports]]
on = "clamp"
held = { displacement = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]] }
[[loads]]
on = "y0"
traction = { value = [0.0, 10.0, 0.0] }
[sets]
clamp = { layer = { face = "x0", depth = 0.003 } }
[analysis.linear]
"#;
    let model = overridden(GATE, "gate.toml", &[]).unwrap().build(1).unwrap();
    let [warning] = model.warnings() else { panic!("{:?}", model.warnings()) };
    assert_eq!(warning.kind, WarningKind::FewLayers);
    assert!(
        warning.message.contains("1.3 % longer: deflections may come out about +2 % off"),
        "{}",
        warning.message
    );
}

/// Held along its thickness over the face, the edge of a plate cannot turn: 3.4 % of the deflection. On a line, clamped, or for small motion
/// there is nothing to tell.
#[test]
fn a_plate_held_over_its_face_is_reported() {
    let warned = |replaced: Replaced| -> Vec<WarningKind> {
        let model = scene("plate-solid.toml", replaced).unwrap().build(1).unwrap();
        model.warnings().iter().map(|warning| warning.kind).collect()
    };
    let over = ("supports[2]", "{ on = \"x1\", held = { displacement = [[0, 0, 1]] } }");
    let clamped = ("supports[2]", "{ on = \"x1\", held = { displacement = [[1, 0, 0], [0, 0, 1]] } }");
    assert_eq!(warned(&[]), []);
    assert_eq!(warned(&[over]), [WarningKind::HeldFace]);
    assert_eq!(warned(&[clamped]), []);
    assert_eq!(warned(&[over, ("analysis", "{ linear = {} }")]), []);
}

#[test]
fn a_soft_skin_is_reported_where_it_is_touched() {
    let soft = |name: &str, replaced: Replaced| {
        let model = scene(name, replaced).unwrap().build(1).unwrap();
        model.warnings().iter().any(|warning| warning.kind == WarningKind::SoftSkin)
    };
    let none = |body: &str| format!("bodies.{body}.solid.formulation.bond-based.correction");
    assert!(!soft("drum-on-bonds.toml", &[]));
    assert!(soft("drum-on-bonds.toml", &[(&none("block"), "'none'")]));
    // Cracks want none, and nothing touches the plate.
    assert!(!soft("crack-branching.toml", &[]));
    assert!(soft("fragments-on-shell.toml", &[]));
}
