//! Groups of faces and what a file gives to them: sections, materials; and the side of the normals.

#![allow(clippy::unwrap_used)] // a failed test may stop here

mod common;

use common::{obj, plate};
use mesh_io::surface::{Format, Surface, parse, side};

#[test]
fn groups_of_faces_stay_groups_of_cells() {
    // Two rows of triangles in a strip, one group each half: joined freely, pairs lie across the middle.
    let mut text = String::new();
    for i in 0..5 {
        text.push_str(&format!("v {i} 0 0\nv {i} 1 0\n"));
    }
    for (i, group) in ["left", "left", "right", "right"].into_iter().enumerate() {
        let [a, b, c, d] = [2 * i + 1, 2 * i + 3, 2 * i + 4, 2 * i + 2];
        text.push_str(&format!("g {group}\nf {a} {b} {c}\nf {a} {c} {d}\n"));
    }
    let surface = obj(&text);
    let faces: Vec<usize> = surface.face_sets.values().map(Vec::len).collect();
    let names: Vec<&str> = surface.face_sets.keys().map(String::as_str).collect();
    assert_eq!((names, faces), (vec!["left", "right"], vec![4, 4]));
    let kinds: Vec<u32> = (0..8).map(|face| u32::from(surface.face_sets["right"].contains(&face))).collect();
    let (cloud, _, of_cells) = surface.cloud_of_kinds(surface.node_normals(), &kinds).unwrap();
    for (cell, kind) in cloud.cells.iter().zip(&of_cells) {
        let x = cell.geometry(&cloud.positions).centroid.x;
        assert_eq!(*kind == 1, x > 2.0, "the cell at {x}");
    }
    // One kind for all is what the plain cloud is.
    let alike = surface.cloud_of_kinds(surface.node_normals(), &[7; 8]).unwrap().0;
    assert_eq!(alike, surface.cloud(surface.node_normals()).unwrap().0);
    // Groups of surfaces in Gmsh, element sets in Abaqus.
    assert_eq!(plate("plate-22.msh").face_sets["plate"].len(), plate("plate-22.msh").faces.len());
    assert_eq!(plate("plate.inp").face_sets["first"], [0]);
}

fn inp(more: &str) -> Surface {
    let text = format!(
        "*Node\n1, 0, 0, 0\n2, 1, 0, 0\n3, 2, 0, 0\n4, 0, 1, 0\n5, 1, 1, 0\n6, 2, 1, 0\n\
         *Element, type=S4, elset=One\n1, 1, 2, 5, 4\n*Element, type=S4, elset=two\n2, 2, 3, 6, 5\n{more}"
    );
    parse("test.inp", Format::Abaqus, text.as_bytes()).unwrap()
}

#[test]
fn sections_of_abaqus_files_are_read() {
    let surface = inp(
        "*Shell Section, elset=ONE, material=Steel, offset=SPOS\n0.2D0, 5\n*Shell Section, elset=two, material=alu\n0.1\n\
         *Material, name=STEEL\n*Elastic\n2.1e5, 0.3, 20.0\n1.9e5, 0.3, 400.0\n*Density\n7.8e-9,\n*Plastic\n250.0, 0.0\n\
         *Material, name=alu\n*Elastic, type=ISOTROPIC\n7e4, 0.33\n",
    );
    let [one, two] = &surface.sections[..] else { panic!("{:?}", surface.sections) };
    assert_eq!((one.group.as_str(), &one.faces[..], one.thickness, one.offset), ("ONE", &[0][..], 0.2, -0.5));
    assert_eq!((two.group.as_str(), &two.faces[..], two.thickness, two.offset), ("two", &[1][..], 0.1, 0.0));
    assert_eq!(surface.materials["steel"].elastic, Some([2.1e5, 0.3]));
    assert_eq!((surface.materials["steel"].density, surface.materials["alu"].density), (Some(7.8e-9), None));
    assert!(surface.notes.iter().any(|note| note.contains("*plastic")), "{:?}", surface.notes);
    let (scaled, flipped) = (surface.clone().scaled(10.0), surface.flipped());
    assert_eq!((scaled.sections[0].thickness, flipped.sections[0].offset), (2.0, 0.5));
}

#[test]
fn sections_that_are_not_plain_are_passed_over_with_a_note() {
    for (text, note) in [
        (
            "*Shell Section, elset=one, composite\n0.1, 3, steel\n",
            "*shell section that is not plainly homogeneous",
        ),
        (
            "*Shell Section, elset=one, material=a, offset=field\n0.1\n",
            "*shell section that is not plainly homogeneous",
        ),
        ("*Shell Section, elset=one, material=a\n", "*shell section without a thickness"),
        ("*Shell Section, elset=one, material=a\n<t>\n", "*shell section without a thickness"),
        ("*Material, name=a\n*Elastic, type=LAMINA\n1, 2, 3\n", "*elastic that is not isotropic"),
        ("*Elastic\n1, 0.3\n", "*elastic that is not isotropic"),
    ] {
        let surface = inp(text);
        assert!(
            surface.sections.is_empty() && surface.notes.iter().any(|n| n.contains(note)),
            "{text} {surface:?}"
        );
    }
}

#[test]
fn surfaces_of_abaqus_files_are_groups_of_faces() {
    let surface = inp(
        "*Elset, elset=_S1, internal\n1, 2\n*Surface, type=ELEMENT, name=Top\n_S1, SPOS\n*Surface, name=under\n2, SNEG\n\
         *Surface, name=part\nOne\n*Surface, name=two\nOne, SPOS\n*Surface, name=rim\nOne, E1\n*Surface, type=NODE, name=n\n1\n",
    );
    assert_eq!((&surface.face_sets["Top"][..], &surface.face_sets["under"][..]), (&[0, 1][..], &[1][..]));
    assert_eq!(surface.face_sets["part"], [0]);
    // An element set goes before a surface of its name; what is not made of faces is reported.
    assert_eq!(surface.face_sets["two"], [1]);
    assert!(!surface.face_sets.contains_key("rim") && !surface.sets.contains_key("n"));
    assert!(surface.notes.iter().any(|note| note.contains("*surface that is not made of faces")));
}

#[test]
fn the_side_of_the_normals_is_reported() {
    let said = |surface: &Surface| side(&common::cloud(surface));
    let flat = plate("plate.obj");
    assert_eq!(said(&flat), "along [0, 0, 1] at [0, 0, 0]");
    assert_eq!(said(&flat.flipped()), "along [0, 0, -1] at [0, 0, 0]");
    // A box without a lid, its faces outward.
    let tent = obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n");
    assert!(said(&tent).starts_with("away from the centroid on 100 % of the area, along"), "{}", said(&tent));
    assert!(said(&tent.flipped()).starts_with("away from the centroid on 0 % of the area, along"));
}
