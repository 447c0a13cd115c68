//! Sets that are made of other sets, and lists of sets: the same models bit for bit as without, and what is refused.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::common::fluids::{DAM, GATE};
use crate::common::refused::refused;
use crate::common::solids::BAR;
use crate::common::{galerkin, overridden, ran};
use crate::strip::{THIN, strip};
use coque::mesh::Arrays;
use coque::{Scene, Silent};

/// A load on the whole strip's tip half, a column of the stress there.
const LOADS: &str = "loads = [{ on = \"tip\", pressure = { value = 1.0 } }]";

/// Runs both; their curves are the same bits.
fn same(without: &str, with: &str) {
    let [without, with] = [without, with].map(|text| ran(overridden(text, "scene.toml", &[])).curve);
    assert!(!without.rows.is_empty());
    assert_eq!(without, with);
}

/// Cells and particles of what is made of boxes are those of one box.
#[test]
fn what_is_made_of_boxes_is_a_box() {
    let text = strip(THIN, LOADS);
    let tip = "tip.box = { min = [6.0, 0.0, 0.0], max = [10.0, 1.0, 0.0] }";
    assert!(text.contains(tip));
    let parts = "a.box = { min = [6.0, 0.0, 0.0], max = [8.0, 1.0, 0.0] }\n\
                 b.box = { min = [8.0, 0.0, 0.0], max = [10.0, 1.0, 0.0] }\n";
    let wide = "a.box = { min = [0.0, 0.0, 0.0], max = [10.0, 1.0, 0.0] }\n\
                b.box = { min = [6.0, -1.0, 0.0], max = [20.0, 2.0, 0.0] }\n";
    for made in [
        format!("{parts}tip.union = [\"a\", \"b\"]"),
        format!("{parts}tip.union = [\"b\", \"a\", \"a\"]"),
        format!("{wide}tip.intersection = [\"a\", \"b\"]"),
        format!("{wide}tip.difference = [\"a\", \"c\"]\nc.difference = [\"all\", \"b\"]"),
        "tip.intersection = [\"all\", \"a\"]\na.union = [\"c\"]\nc.plane = { point = [8, 0, 0], normal = [1, 0, 0], within = 2.0 }"
            .into(),
    ] {
        same(&text, &text.replace(tip, &made));
    }
}

/// A ball takes what lies in it, its border included: here a point, the row beside it.
#[test]
fn a_ball_takes_what_lies_in_it() {
    let text = strip(THIN, "loads = [{ on = \"end\", force = { total = [0.0, 0.0, 1.0] } }]");
    let end = |sets: &str| text.replace("[sets]\n", &format!("[sets]\n{sets}\n"));
    let ball = end("end.near = { point = [10.0, 0.5, 0.0], distance = 0.25 }");
    // The middle of the edge, and a spacing from it one particle before it and one on either side.
    let by_hand = end("end.difference = [\"square\", \"corners\"]\ncorners.union = [\"low\", \"high\"]\n\
                       square.box = { min = [9.75, 0.25, 0.0], max = [10.0, 0.75, 0.0] }\n\
                       low.nearest = [9.75, 0.25, 0.0]\nhigh.nearest = [9.75, 0.75, 0.0]");
    same(&by_hand, &ball);
}

/// A list is a union: two supports as one, a load on two ends, a column of two.
#[test]
fn a_list_of_sets_is_their_union() {
    let text = strip(THIN, LOADS);
    let two = text.replace(
        "supports = [{ on = \"u0\", clamped = {} }]",
        "supports = [{ on = \"u0\", clamped = {} }, { on = \"v0\", clamped = {} }]",
    );
    let list = text.replace("on = \"u0\", clamped", "on = [\"v0\", \"u0\"], clamped");
    same(&two, &list);
    let names = |text: &str| {
        let model =
            Scene::parse(&format!("{text}[output.fields]\n"), "scene.toml").unwrap().build(1).unwrap();
        model.sets.values().flat_map(|sets| sets.keys().cloned()).collect::<Vec<_>>()
    };
    assert!(names(&list).contains(&"v0, u0".to_string()), "{:?}", names(&list));
    let declared = text.replace("root.box", "ends.union = [\"u1\", \"tip\"]\nroot.box");
    let declared =
        declared.replace("of = \"displacement\"\non = \"u1\"", "of = \"displacement\"\non = \"ends\"");
    let list =
        text.replace("of = \"displacement\"\non = \"u1\"", "of = \"displacement\"\non = [\"u1\", \"tip\"]");
    same(&declared, &list);
    // A list of one is that set, edge and all.
    same(&text, &text.replace("of = \"displacement\"\non = \"u1\"", "of = \"displacement\"\non = [\"u1\"]"));
}

/// Faces, layers and regions of solids; of bonds and without.
#[test]
fn sets_of_solids_are_made_of_faces_and_layers() {
    let two = BAR.replace(
        "supports = [{ on = \"x0\", clamped = {} }]",
        "supports = [{ on = \"x0\", clamped = {} }, { on = \"z0\", clamped = {} }]",
    );
    same(&two, &BAR.replace("on = \"x0\", clamped", "on = [\"x0\", \"z0\"], clamped"));
    let layer = "analysis.static = { levels = 1 }\nsets.end.layer = { face = \"x1\", depth = 0.5 }";
    let with = |sets: &str| {
        let text = BAR.replace("analysis.static = { levels = 1 }", sets);
        text.replace(
            "on = \"x1\", traction = { value = [1.0, 0.0, 0.0] }",
            "on = \"end\", force = { total = [1.0, 0.0, 0.0] }",
        )
    };
    let made = "analysis.static = { levels = 1 }\nsets.end.difference = [\"all\", \"rest\"]\n\
                sets.rest.box = { min = [0.0, 0.0, 0.0], max = [3.5, 1.0, 1.0] }";
    same(&with(layer), &with(made));
    let bar = galerkin::BAR;
    assert!(bar.contains("on = \"x0\""), "{bar}");
    let named = bar.replacen("on = \"x0\"", "on = \"held\"", 1) + "[sets]\nheld.union = [\"x0\"]\n";
    same(bar, &named);
}

/// Whose a set is follows from what it is made of; walls and fluids have such sets too.
#[test]
fn sets_of_several_bodies_belong_to_the_body_of_their_sets() {
    let gate = GATE.replace("on = \"root\", clamped", "on = [\"root\", \"gate.y1\"], clamped");
    let declared =
        GATE.replace("sets.root = {", "sets.held = { union = [\"gate.y1\", \"root\"] }\nsets.root = {");
    let declared = declared.replace("on = \"root\", clamped", "on = \"held\", clamped");
    same(&declared, &gate);
    // All nodes of the top edge lie in the box.
    same(GATE, &gate);
    let dam = |sets: &str, on: &str| {
        let text = DAM.replace("sets.gauge = {", &format!("{sets}\nsets.gauge = {{"));
        text.replace("on = \"water.all\", take", &format!("on = {on}, take"))
    };
    let halves = "sets.left = { of = \"water\", box = { min = [0, 0, 0], max = [0.05, 1, 0] } }\n\
                  sets.right = { difference = [\"water.all\", \"left\"] }";
    same(DAM, &dam(halves, "[\"left\", \"right\"]"));
    same(
        DAM,
        &dam(
            &format!("{halves}\nsets.both = {{ of = \"water\", union = [\"right\", \"all\"] }}"),
            "\"both\"",
        ),
    );
}

/// Groups of a mesh, particles and cells.
#[test]
fn groups_of_a_mesh_are_united() {
    let at = |i: u32, j: u32| i * 5 + j;
    let face = |i: u32, j: u32| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
    let faces: Vec<[u32; 4]> = (0..16).map(|c| face(c / 4, c % 4)).collect();
    let points = (0..25).map(|a| [f64::from(a / 5) * 0.25, f64::from(a % 5) * 0.25, 0.0]).collect();
    let all = Arrays {
        points,
        faces,
        sets: BTreeMap::from([("left".into(), (0..5).collect()), ("right".into(), (20..25).collect())]),
        face_sets: BTreeMap::from([
            ("low".into(), (0..8).collect()),
            ("high".into(), (8..16).collect()),
            ("most".into(), (0..12).collect()),
        ]),
    };
    let run = |sets: &str, on: &str, part: &str| {
        let text = format!(
            "title = \"Plate\"\nunits = {{ length = \"m\", force = \"N\", time = \"s\" }}\nanalysis.linear = {{}}\n\
             geometry.mesh = {{ file = \"plate\" }}\nmaterial.elastic = {{ young = 1e6, poisson = 0.3, density = 1.0 }}\n\
             section.homogeneous = {{ thickness = 0.05 }}\n{sets}\n\
             parts = [{{ on = \"{part}\", section.homogeneous = {{ thickness = 0.1 }} }}]\n\
             supports = [{{ on = \"left\", clamped = {{}} }}]\nloads = [{{ on = {on}, pressure = {{ value = 1.0 }} }}]\n\
             curve = [{{ name = \"w\", of = \"displacement\", on = \"right\", direction = [0, 0, 1] }}]"
        );
        let mut scene = Scene::parse(&text, "scene.toml").unwrap().into_scene();
        scene.surfaces.insert("plate".into(), Arc::new(all.clone()));
        scene.check().unwrap().build(1).unwrap().run(&mut Silent).curve
    };
    let plain = run("", "\"all\"", "high");
    assert_eq!(plain, run("", "[\"low\", \"high\"]", "high"));
    assert_eq!(plain, run("sets.part.difference = [\"all\", \"low\"]", "\"all\"", "part"));
    let quarter =
        "sets.part.union = [\"high\", \"quarter\"]\nsets.quarter.intersection = [\"high\", \"most\"]";
    assert_eq!(plain, run(quarter, "\"all\"", "part"));
}

#[test]
fn what_no_set_can_be_made_of() {
    let text = strip(THIN, LOADS);
    let root = "root.box = { min = [0.0, 0.0, 0.0], max = [6.0, 1.0, 0.0] }";
    let on = "on = \"u0\", clamped";
    let of_shells = refused(
        &text,
        &[
            ("a set of itself", root, "root.union = [\"u0\", \"root\"]"),
            (
                "a circle",
                root,
                "root.union = [\"a\"]\na.difference = [\"all\", \"b\"]\nb.intersection = [\"u1\", \"root\"]",
            ),
            ("an unknown set", root, "root.union = [\"u0\", \"u9\"]"),
            ("no set", root, "root.union = []"),
            ("one set less nothing", root, "root.difference = [\"u0\"]"),
            ("two ways", root, "root = { union = [\"u0\"], difference = [\"all\", \"u0\"] }"),
            ("nothing in common", root, "root.intersection = [\"u0\", \"u1\"]"),
            ("nothing left", root, "root.difference = [\"u0\", \"all\"]"),
            ("no cell left", LOADS, "loads = [{ on = [\"u0\", \"u1\"], pressure = { value = 1.0 } }]"),
            ("a ball without a size", root, "root.near = { point = [0, 0, 0], distance = 0.0 }"),
            ("an unknown set of a list", on, "on = [\"u0\", \"w0\"], clamped"),
            ("an empty list", on, "on = [], clamped"),
            ("a list of numbers", on, "on = [\"u0\", 1], clamped"),
            (
                "a line of two edges",
                LOADS,
                "loads = [{ on = [\"u0\", \"u1\"], couple = { moment = 1.0, axis = \"edge\" } }]",
            ),
        ],
    );
    let both = text.replace(on, "on = [\"u0\", \"u1\"], clamped");
    let called =
        refused(&both, &[("a set that is called like a list", root, "\"u0, u1\".nearest = [0, 0, 0]")]);
    let mut deep: String =
        (1..=14).map(|i| format!("s{i}.union = [\"s{}\", \"s{}\"]\n", i - 1, i - 1)).collect();
    deep.push_str("s0.nearest = [0, 0, 0]");
    let doubled = refused(&text, &[("doubled over and over", root, &deep)]);
    let of_several = refused(
        GATE,
        &[
            ("sets of two bodies", "on = \"root\", clamped", "on = [\"root\", \"tank.x0\"], clamped"),
            (
                "another body",
                "sets.root = {",
                "sets.two = { of = \"gate\", union = [\"tank.x0\"] }\nsets.root = {",
            ),
            ("every body", "on = \"root\", clamped", "on = [\"root\", \"all\"], clamped"),
            ("no body", "on = \"root\", clamped", "on = [\"x0\", \"x1\"], clamped"),
        ],
    );
    let of_solids = refused(galerkin::BAR, &[("pressed by area", "on = \"x1\"", "on = [\"x1\", \"z1\"]")]);
    insta::assert_snapshot!([of_shells, called, doubled, of_several, of_solids].concat());
}
