//! Surfaces of bodies: what bounds tetrahedra, with the groups of its faces; sheets are refused them as before.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use mesh_io::surface::{Format, parse, parse_body};

/// A cube of six tetrahedra round its diagonal, two of them inside out; a physical surface on top, another one inside.
fn cube(tetrahedra: &str) -> String {
    format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 7 \"top\"\n3 1 \"body\"\n$EndPhysicalNames\n\
         $Nodes\n8\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n6 1 0 1\n7 1 1 1\n8 0 1 1\n$EndNodes\n\
         $Elements\n9\n1 2 2 7 1 5 7 6\n2 2 2 7 1 5 7 8\n3 2 2 8 2 1 2 7\n{tetrahedra}$EndElements\n"
    )
}

const SIX: &str = "4 4 2 1 1 1 2 3 7\n5 4 2 1 1 1 3 4 7\n6 4 2 1 1 1 8 4 7\n7 4 2 1 1 1 8 5 7\n8 4 2 1 1 1 5 6 7\n9 4 2 1 1 1 6 2 7\n";

#[test]
fn tetrahedra_are_bounded_by_their_outer_faces() {
    let surface = parse_body("cube.msh", Format::Gmsh, cube(SIX).as_bytes()).unwrap();
    assert_eq!((surface.faces.len(), surface.pieces, surface.turned), (12, 1, 0));
    let at = |node: u32| surface.positions[node as usize];
    let volume: f64 = surface
        .faces
        .iter()
        .map(|face| at(face.corners[0]).dot(&at(face.corners[1]).cross(&at(face.corners[2]))) / 6.0)
        .sum();
    assert!((volume - 1.0).abs() < 1e-15, "{volume}");
    // The group has the faces of its triangles, which look outwards now; what lies inside is no face.
    let top = &surface.face_sets["top"];
    assert!(
        top.len() == 2
            && top.iter().all(|&f| surface.faces[f as usize].particles().iter().all(|&a| at(a).z == 1.0))
    );
    assert!(
        surface.notes.iter().any(|note| note == "faces that do not bound the tetrahedra, left out: 1"),
        "{:?}",
        surface.notes
    );
    // A face that the file has once for each of its groups belongs to all of them.
    let twice = cube(SIX)
        .replace("$PhysicalNames\n2\n", "$PhysicalNames\n3\n2 9 \"loaded\"\n")
        .replace("$Elements\n9\n", "$Elements\n10\n10 2 2 9 1 5 7 6\n");
    let both = parse_body("cube.msh", Format::Gmsh, twice.as_bytes()).unwrap();
    assert_eq!(both.face_sets["top"].len(), 2);
    assert!(
        both.face_sets["loaded"].len() == 1 && both.face_sets["top"].contains(&both.face_sets["loaded"][0])
    );
    // A surface alone is read as ever.
    let alone = cube("").replace("\n9\n1 2", "\n2\n1 2").replace("3 2 2 8 2 1 2 7\n", "");
    assert_eq!(parse_body("cube.msh", Format::Gmsh, alone.as_bytes()).unwrap().faces.len(), 2);
}

#[test]
fn broken_tetrahedra_and_sheets_of_them_are_refused() {
    let refused = |tetrahedra: &str| {
        let text = cube(tetrahedra);
        parse_body("cube.msh", Format::Gmsh, text.as_bytes()).unwrap_err().to_string()
    };
    let flat = SIX.replace("1 8 4 7", "1 1 4 7");
    assert!(refused(&flat).contains("line 27: tetrahedron 6 has no volume"), "{}", refused(&flat));
    let thrice = SIX
        .replace("6 4 2 1 1 1 8 4 7", "6 4 2 1 1 1 2 3 6")
        .replace("9 4 2 1 1 1 6 2 7", "9 4 2 1 1 1 2 3 8");
    assert!(refused(&thrice).contains("belongs to more than two"), "{}", refused(&thrice));
    let sheets = parse("cube.msh", Format::Gmsh, cube(SIX).as_bytes()).unwrap_err().to_string();
    assert!(sheets.contains("element 4 is a solid (type 4)"), "{sheets}");
}

#[test]
fn broken_ply_files_are_refused() {
    let plate = include_str!("meshes/plate.ply");
    for (from, to, said) in [
        ("ply\n", "plz\n", "a header from ply to end_header"),
        ("ascii", "utf8", "line 2: format \"utf8\""),
        ("property double x", "property decimal x", "line 5: \"property decimal x\" is no line of a header"),
        ("double x", "double u", "vertices have no properties x, y and z"),
        ("vertex_indices", "corners", "faces have no list vertex_indices"),
        ("4 0 3 4 1", "4 0 3 44 1", "face 0 names node 44"),
        ("4 0 3 4 1", "4 0 3 -4 1", "face 0 names node"),
        ("4 0 3 4 1", "2 0 3", "face 0 has 2 corners"),
        ("vertex 9", "vertex 900000000000", "the file ends where y of vertex 17 should stand"),
        ("face 5", "face 500000000000", "the file ends where vertex_indices of face 5 should stand"),
    ] {
        assert!(plate.contains(from), "{from}");
        let text = plate.replacen(from, to, 1);
        let found = parse("plate.ply", Format::Ply, text.as_bytes()).unwrap_err().to_string();
        assert!(found.contains(said), "{from}: {found}");
    }
}
