//! Files that are refused: each message names file, line, entity and repair.

#![allow(clippy::unwrap_used)] // a failed test may stop here

mod common;

use std::fs;

use common::folder;
use mesh_io::surface::{Format, parse};

#[test]
fn broken_files() {
    let ok_msh = fs::read_to_string(folder().join("plate-41.msh")).unwrap();
    let old_msh = fs::read_to_string(folder().join("plate-22.msh")).unwrap();
    let inp = fs::read_to_string(folder().join("plate.inp")).unwrap();
    let csv = fs::read_to_string(folder().join("plate.csv")).unwrap();
    let vtu = fs::read_to_string(folder().join("plate-ascii.vtu")).unwrap();
    let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    let obj = |faces: &str| format!("{square}{faces}");
    let put = |text: &str, from: &str, to: &str| {
        assert!(text.contains(from), "no {from}");
        text.replacen(from, to, 1)
    };
    let cases: Vec<(&str, Format, String)> = vec![
        ("binary", Format::Gmsh, put(&ok_msh, "4.1 0 8", "4.1 1 8")),
        ("old version", Format::Gmsh, put(&ok_msh, "4.1 0 8", "4.0 0 8")),
        ("not Gmsh", Format::Gmsh, "solid\n".into()),
        ("second order", Format::Gmsh, put(&old_msh, "6 3 2 7 1 1 4 5 2", "6 10 2 7 1 1 4 5 2 3 6 7 8 9")),
        ("solid", Format::Gmsh, put(&old_msh, "6 3 2 7 1 1 4 5 2", "6 4 2 7 1 1 4 5 2")),
        ("no such node", Format::Gmsh, put(&old_msh, "6 3 2 7 1 1 4 5 2", "6 3 2 7 1 1 4 55 2")),
        ("node twice", Format::Gmsh, put(&old_msh, "\n2 0 1 0", "\n1 0 1 0")),
        ("not finite", Format::Gmsh, put(&old_msh, "\n2 0 1 0", "\n2 0 nan 0")),
        ("huge count", Format::Gmsh, put(&old_msh, "$Nodes\n9", "$Nodes\n18446744073709551615")),
        ("cut off", Format::Gmsh, old_msh[..old_msh.len() / 2].into()),
        ("no faces", Format::Gmsh, "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n".into()),
        ("curved", Format::Abaqus, put(&inp, "type=S4R", "type=S8R")),
        ("solid elements", Format::Abaqus, put(&inp, "type=S4R", "type=C3D8")),
        ("no type", Format::Abaqus, put(&inp, "type=S4R,", "")),
        ("too few nodes", Format::Abaqus, put(&inp, "1, 10, 40, 50, 20", "1, 10, 40, 50\n")),
        ("too many nodes", Format::Abaqus, put(&inp, "1, 10, 40, 50, 20", "1, 10, 40, 50, 20, 60")),
        ("second part", Format::Abaqus, put(&inp, "*End Part", "*End Part\n*Part, name=B")),
        ("generated", Format::Abaqus, put(&inp, "*Nset, nset=middle\n50", "*Ngen\n10, 30, 10")),
        ("included", Format::Abaqus, put(&inp, "*End Part", "*Include, input=more.inp")),
        (
            "moved instance",
            Format::Abaqus,
            put(&inp, "*End Part", "*Instance, name=A, part=PLATE\n1.0, 0., 0."),
        ),
        ("unknown set", Format::Abaqus, put(&inp, "Fixed, TIP", "Fixed, TOP")),
        ("range", Format::Abaqus, put(&inp, "10, 30, 10", "30, 10, 10")),
        ("element not there", Format::Abaqus, put(&inp, "elset=first\n1", "elset=first\n11")),
        ("polygon", Format::Obj, obj("v 0 2 0\nf 1 2 3 4 5\n")),
        ("corner beyond", Format::Obj, obj("f 1 2 3 7\n")),
        ("corner word", Format::Obj, obj("f 1 2 3 x\n")),
        ("two numbers", Format::Obj, "v 0 0\n".into()),
        ("too far", Format::Obj, "v 0 0 1e40\n".into()),
        ("node twice in a face", Format::Obj, obj("f 1 2 2 4\n")),
        ("no area", Format::Obj, obj("v 2 0 0\nf 1 2 5\n")),
        ("face twice", Format::Obj, obj("f 1 2 3 4\nf 2 3 4 1\n")),
        ("too many faces at an edge", Format::Obj, obj(&fan(65))),
        ("hanging node", Format::Obj, obj("v 1 0.5 0\nv 2 0 0\nv 2 1 0\nf 1 2 3 4\nf 2 6 5\nf 5 6 7 3\n")),
        ("one node in common", Format::Obj, obj("v 2 1 0\nv 2 2 0\nv 1 2 0\nf 1 2 3 4\nf 3 5 6 7\n")),
        ("normal the other way", Format::Obj, obj("vn 0 0 1\nvn 0 0 -1\nf 1//1 2//1 3//1 4//2\n")),
        ("reserved name", Format::Obj, obj("v 2 0 0\nv 2 1 0\ng all\nf 1 2 3 4\ng b\nf 2 5 6 3\n")),
        ("neither STL", Format::Stl, "nonsense".into()),
        ("binary cut off", Format::Stl, format!("{}\u{9}\0\0\0", " ".repeat(80))),
        (
            "four vertices",
            Format::Stl,
            "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0"
                .into(),
        ),
        ("not XML", Format::Vtu, vtu[..vtu.len() / 2].into()),
        (
            "compressed",
            Format::Vtu,
            put(&vtu, "header_type", "compressor=\"vtkZLibDataCompressor\" header_type"),
        ),
        (
            "appended",
            Format::Vtu,
            put(
                &vtu,
                "Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\"",
                "Name=\"Points\" format=\"appended\"",
            ),
        ),
        ("polydata", Format::Vtu, put(&vtu, "type=\"UnstructuredGrid\"", "type=\"PolyData\"")),
        ("hexahedron", Format::Vtu, put(&vtu, "9 9 9 9", "9 9 9 12")),
        ("offset beyond", Format::Vtu, put(&vtu, "4 8 12 16", "4 8 12 17")),
        ("unknown column", Format::Csv, put(&csv, "x,y,z", "x,y,zz")),
        ("missing column", Format::Csv, put(&csv, ",area", "")),
        ("short row", Format::Csv, put(&csv, "1,1,0,0,0,1,1,0.1", "1,1,0,0,0,1,1")),
        ("no normal", Format::Csv, put(&csv, "1,1,0,0,0,1,1,0.1", "1,1,0,0,0,0,1,0.1")),
        ("no area at a point", Format::Csv, put(&csv, "1,1,0,0,0,1,1,0.1", "1,1,0,0,0,1,0,0.1")),
    ];
    let mut all = String::new();
    for (name, format, text) in cases {
        let file = format!("broken.{}", format.ending());
        match parse(&file, format, text.as_bytes()) {
            Ok(_) => panic!("{name}: not refused"),
            Err(error) => all.push_str(&format!("━━━ {name} ━━━\n{error}\n")),
        }
    }
    insta::assert_snapshot!(all);
}

/// So many triangles round the edge from vertex 1 to vertex 2.
fn fan(count: u32) -> String {
    let triangle = |i: u32| {
        let (sin, cos) = libm::sincos(f64::from(i) / f64::from(count) * std::f64::consts::TAU);
        format!("v 0.5 {cos:.6} {sin:.6}\nf 1 2 {}\n", i + 5)
    };
    (0..count).map(triangle).collect()
}

#[test]
fn counts_that_contradict_their_data_are_refused() {
    let read = |name: &str| fs::read_to_string(folder().join(name)).unwrap();
    let (new, old, vtu) = (read("plate-41.msh"), read("plate-22.msh"), read("plate-ascii.vtu"));
    let points = "Name=\"Points\" NumberOfComponents=\"3\"";
    for (format, text, from, to) in [
        (Format::Gmsh, &new, "$Nodes\n4 9 1 9", "$Nodes\n4 8 1 9"),
        (Format::Gmsh, &new, "$Nodes\n4 9 1 9", "$Nodes\n4 99999999999 1 9"),
        (Format::Gmsh, &new, "$Nodes\n4 9 1 9", "$Nodes\n3 9 1 9"),
        (Format::Gmsh, &old, "$Nodes\n9", "$Nodes\n8"),
        (Format::Gmsh, &old, "$Nodes\n9", "$Nodes\n10"),
        (Format::Vtu, &vtu, "NumberOfPoints=\"9\"", "NumberOfPoints=\"8\""),
        (Format::Vtu, &vtu, "NumberOfPoints=\"9\"", "NumberOfPoints=\"many\""),
        (Format::Vtu, &vtu, "NumberOfCells=\"4\"", "NumberOfCells=\"400000000000\""),
        (Format::Vtu, &vtu, points, "Name=\"Points\" NumberOfComponents=\"9\""),
    ] {
        assert!(text.contains(from), "no {from}");
        assert!(parse("ok", format, text.as_bytes()).is_ok());
        assert!(parse("broken", format, text.replacen(from, to, 1).as_bytes()).is_err(), "{to}");
    }
}
