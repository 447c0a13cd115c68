//! Runs with frames of fields, and the files of a frame read back.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use coque::scene::Fields;
use coque::{Checked, FieldSink, Outcome, RunOptions, Scene, Silent};
use sph_core::Vec3;

pub const EVERYTHING: Fields = Fields { extruded: true, stresses: true, ..Fields::MOTION };

pub fn scene(name: &str, replaced: &[(&str, &str)]) -> Checked {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes").join(name);
    let pairs: Vec<_> = replaced.iter().map(|(path, value)| (path.to_string(), value.to_string())).collect();
    Scene::with_overrides(&fs::read_to_string(path).unwrap(), name, &pairs).unwrap()
}

/// Holds the sheet of the patch test without time, where a motion of zero would drive it.
pub const HINGE: (&str, &str) = ("supports[2]", "{ on = \"u0v0\", hinged = {} }");

/// An empty folder of a test's own.
pub fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("fields").join(name);
    if folder.exists() {
        fs::remove_dir_all(&folder).unwrap();
    }
    folder
}

pub fn run(scene: &Checked, sink: &mut dyn FieldSink) -> Outcome {
    let options = RunOptions { progress: &mut Silent, checkpoints: None, fields: Some(sink), from: None };
    scene.build(1).unwrap().run_with(options).unwrap()
}

/// A file read back: numbers by name, and where the array stood.
pub struct Read {
    arrays: BTreeMap<String, (String, Vec<f64>)>,
}

impl Read {
    pub fn new(path: &Path) -> Self {
        let text = fs::read_to_string(path).unwrap();
        let document = roxmltree::Document::parse(&text).unwrap();
        let root = document.root_element();
        assert_eq!(root.attribute("version"), Some("1.0"));
        assert_eq!(root.attribute("header_type"), Some("UInt64"));
        assert_eq!(root.attribute("byte_order"), Some("LittleEndian"));
        let mut arrays = BTreeMap::new();
        for node in document.descendants().filter(|node| node.has_tag_name("DataArray")) {
            let bytes = STANDARD.decode(node.text().unwrap().trim()).unwrap();
            let (length, data) = bytes.split_at(8);
            assert_eq!(u64::from_le_bytes(length.try_into().unwrap()) as usize, data.len());
            let numbers: Vec<f64> = match node.attribute("type").unwrap() {
                "Float64" => {
                    data.chunks_exact(8).map(|b| f64::from_le_bytes(b.try_into().unwrap())).collect()
                }
                "Float32" => data
                    .chunks_exact(4)
                    .map(|b| f64::from(f32::from_le_bytes(b.try_into().unwrap())))
                    .collect(),
                "Int32" => data
                    .chunks_exact(4)
                    .map(|b| f64::from(i32::from_le_bytes(b.try_into().unwrap())))
                    .collect(),
                "UInt8" => data.iter().map(|&b| f64::from(b)).collect(),
                other => panic!("{other}"),
            };
            let place = node.parent_element().unwrap().tag_name().name().to_string();
            arrays.insert(node.attribute("Name").unwrap().to_string(), (place, numbers));
        }
        let piece = document.descendants().find(|node| node.has_tag_name("Piece")).unwrap();
        let count = |name: &str| piece.attribute(name).unwrap().parse::<usize>().unwrap();
        let read = Self { arrays };
        assert_eq!(read.get("Points").len(), 3 * count("NumberOfPoints"));
        assert_eq!(read.get("offsets").len(), count("NumberOfCells"));
        assert_eq!(read.get("types").len(), count("NumberOfCells"));
        assert_eq!(read.get("offsets").last().copied(), Some(read.get("connectivity").len() as f64));
        read
    }

    pub fn get(&self, name: &str) -> &[f64] {
        &self.arrays[name].1
    }

    pub fn place(&self, name: &str) -> Option<&str> {
        self.arrays.get(name).map(|(place, _)| place.as_str())
    }

    /// Corners of a cell, as points.
    pub fn corners(&self, cell: usize) -> Vec<Vec3> {
        let offset = |c: usize| self.get("offsets")[c] as usize;
        let first = if cell == 0 { 0 } else { offset(cell - 1) };
        let points = self.get("Points");
        let at = |i: f64| Vec3::from_column_slice(&points[3 * i as usize..3 * i as usize + 3]);
        self.get("connectivity")[first..offset(cell)].iter().map(|&i| at(i)).collect()
    }
}

/// Files and values of a `.pvd`.
pub fn listed(list: &Path) -> Vec<(f64, PathBuf)> {
    let text = fs::read_to_string(list).unwrap();
    let document = roxmltree::Document::parse(&text).unwrap();
    assert_eq!(document.root_element().attribute("type"), Some("Collection"));
    let sets = document.descendants().filter(|node| node.has_tag_name("DataSet"));
    sets.map(|set| {
        let file = list.parent().unwrap().join(set.attribute("file").unwrap());
        (set.attribute("timestep").unwrap().parse().unwrap(), file)
    })
    .collect()
}

pub fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<_> = entries.map(|e| e.unwrap().file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}
