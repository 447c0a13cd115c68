//! Surfaces from files: one plate in every format, its sets and its report; what files ask for and how soon it is answered.

#![allow(clippy::unwrap_used)] // a failed test may stop here

mod common;

use std::fs;

use common::{PLATES, canonical, cloud, folder, obj, plate};
use mesh_io::surface::{Format, Surface, parse, report};
use sph_core::{EndWeights, Plate, lattice};

#[test]
fn every_format_gives_the_same_plate() {
    let native = lattice(&Plate { lengths: [2.0, 2.0] }, [3, 3], EndWeights::Trapezoid).unwrap();
    for name in PLATES {
        assert_eq!(canonical(&cloud(&plate(name))), canonical(&native), "{name}");
    }
    let points = cloud(&plate("plate.csv"));
    assert_eq!((&points.positions, &points.areas), (&native.positions, &native.areas));
    assert!(points.cells.is_empty());
}

#[test]
fn groups_of_the_file_are_sets() {
    // Places, since files number nodes as they like.
    let places = |surface: &Surface, name: &str| -> Vec<[f64; 3]> {
        let set = surface.set(name).unwrap_or_else(|| panic!("{}: no set {name}", surface.file));
        set.iter().map(|&a| surface.positions[a as usize].into()).collect()
    };
    let edge = |x: f64| [[x, 0.0, 0.0], [x, 1.0, 0.0], [x, 2.0, 0.0]];
    for name in ["plate-22.msh", "plate-41.msh", "plate.inp", "plate-ascii.vtu", "plate-binary.vtu"] {
        let surface = plate(name);
        let mut tip = places(&surface, "tip");
        tip.sort_by(|a, b| a.partial_cmp(b).unwrap());
        assert_eq!(tip, edge(2.0), "{name}");
        assert_eq!(places(&surface, "fixed"), edge(0.0), "{name}");
    }
    let abaqus = plate("plate.inp");
    // Names of sets are found whatever their case; element sets stand for the nodes of their elements.
    assert_eq!(places(&abaqus, "ends").len(), 6);
    assert_eq!(places(&abaqus, "first").len(), 4);
    assert_eq!(abaqus.labels[0], 10);
    assert_eq!(places(&plate("plate.obj"), "rest").len(), 8);
    assert_eq!(places(&plate("plate-41.msh"), "middle"), [[1.0, 1.0, 0.0]]);
}

#[test]
fn the_report_of_a_plate() {
    let mut surface = plate("plate-41.msh");
    surface.file = "plate-41.msh".into();
    insta::assert_snapshot!(report(&surface, |_| Vec::new()).unwrap());
    let reported = report(&surface, |cloud| vec![format!("{} particles", cloud.len())]).unwrap();
    assert!(reported.ends_with("  warning    9 particles\n"), "{reported}");
}

#[test]
fn abaqus_parts_and_assemblies() {
    let text = fs::read_to_string(folder().join("plate.inp")).unwrap();
    // As a pre-processor writes it: the part, its instance, a reference point with a number of its own.
    let assembly = "*End Part\n*Assembly, name=A\n*Instance, name=P-1, part=PLATE\n*End Instance\n*Node\n 10, 5., 5., 5.\n\
        *Nset, nset=RP\n 10,\n*Nset, nset=loaded, instance=P-1\n 10, 20\n*Nset, nset=corner, elset=first, instance=P-1\n\
        *End Assembly";
    let surface = parse("a.inp", Format::Abaqus, text.replace("*End Part", assembly).as_bytes()).unwrap();
    assert_eq!(surface.positions.len(), 9);
    assert_eq!((surface.set("RP"), surface.set("loaded")), (None, Some(&[0, 1][..])));
    assert_eq!(surface.set("corner"), surface.set("first"));
    assert!(surface.notes[0].contains("*node of the assembly"), "{:?}", surface.notes);
}

#[test]
fn short_lines_cannot_ask_for_long_sets() {
    let mut text = String::from("*Node\n");
    (0..300).for_each(|i| text.push_str(&format!("{}, {}, {}, 0.\n", i + 1, i / 2, i % 2)));
    text.push_str("*Element, type=S4\n");
    (0..149).for_each(|i| {
        text.push_str(&format!("{}, {}, {}, {}, {}\n", i + 1, 2 * i + 1, 2 * i + 3, 2 * i + 4, 2 * i + 2))
    });
    text.push_str("*Nset, nset=s0, generate\n1, 300, 1\n");
    assert!(parse("a.inp", Format::Abaqus, text.as_bytes()).is_ok());
    (1..300).for_each(|i| text.push_str(&format!("*Nset, nset=s{i}\ns0\n")));
    let error = parse("a.inp", Format::Abaqus, text.as_bytes()).unwrap_err();
    assert!(error.what.contains("all sets together"), "{error}");
    // Every face in a thousand groups.
    let groups: String = (0..1000).map(|i| format!(" g{i}")).collect();
    let mut text = format!("g{groups}\n");
    (0..300).for_each(|i| text.push_str(&format!("v {} {} 0\n", i / 2, i % 2)));
    (0..149)
        .for_each(|i| text.push_str(&format!("f {} {} {} {}\n", 2 * i + 1, 2 * i + 3, 2 * i + 4, 2 * i + 2)));
    let error = parse("a.obj", Format::Obj, text.as_bytes()).unwrap_err();
    assert!(error.what.contains("all sets together"), "{error}");
}

#[test]
fn crowds_and_needles_are_answered_soon() {
    // Triangles that all have a corner of their own on one place.
    let mut crowd = String::new();
    for i in 0..3000 {
        let corner = |part: f64| {
            let turn = std::f64::consts::TAU * (f64::from(i) + part) / 3000.0;
            format!("v {} {} 0\n", libm::cos(turn), libm::sin(turn))
        };
        let [a, b, c] = [1, 2, 3].map(|corner| 3 * i + corner);
        crowd.push_str(&format!("v 0 0 0\n{}{}f {a} {b} {c}\n", corner(0.0), corner(0.5)));
    }
    let error = parse("crowd.obj", Format::Obj, crowd.as_bytes()).unwrap_err();
    assert!(error.what.contains("nodes stand on the place"), "{error}");
    // A comb of needles: long edges beside each other.
    let mut comb = String::new();
    for i in 0..20_000 {
        let y = 1e-3 * i as f64;
        comb.push_str(&format!(
            "v 0 {y} 0\nv 30 {y} 0\nv 0 {} 0\nf {} {} {}\n",
            y + 5e-4,
            3 * i + 1,
            3 * i + 2,
            3 * i + 3
        ));
    }
    assert_eq!(obj(&comb).pieces, 20_000);
    // One vertex far out makes the tolerance of STL larger than all the rest.
    let mut far = String::from(
        "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1e9 0 0\nvertex 0 1e9 0\nendloop\nendfacet\n",
    );
    for i in 0..10_000 {
        far.push_str(&format!("facet normal 0 0 1\nouter loop\nvertex {i}e-3 0 0\nvertex {i}e-3 1 0\nvertex {i}.5e-3 1 0\nendloop\nendfacet\n"));
    }
    let surface = parse("far.stl", Format::Stl, far.as_bytes()).unwrap();
    assert_eq!(surface.faces.len(), 1);
}

#[test]
fn stl_vertices_that_nearly_coincide_are_merged() {
    let text = "solid\nfacet normal nan nan nan\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n\
        facet normal 0 0 0\nouter loop\nvertex 1 0 1e-8\nvertex 1 1 0\nvertex 1e-8 1 -0\nendloop\nendfacet\n\
        facet normal 0 0 0\nouter loop\nvertex 1 0 0\nvertex 1 0 1e-8\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n";
    let surface = parse("near.stl", Format::Stl, text.as_bytes()).unwrap();
    assert_eq!((surface.positions.len(), surface.faces.len()), (4, 2));
    let notes = surface.notes.join("\n");
    assert!(notes.contains("collapsed") && notes.contains("2 of the merged places differed"), "{notes}");
}
