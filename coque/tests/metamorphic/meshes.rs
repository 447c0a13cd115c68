//! Meshes whose nodes are counted, mirrored or placed otherwise: the same curve.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use super::{Outcome, common::text, difference, judge, ran};

/// Scenes on meshes of the repository, with their lengths: a roof through its limit, sheets that meet, parts of their own, a rib that is tied to
/// lines of its host.
const MESHED: [(&str, f64); 4] =
    [("roof", 254.0), ("t-frame", 1.0), ("bracket-gmsh", 100.0), ("tied-rib", 1.0)];

/// A mesh of the format 2.2 of Gmsh: its lines before the nodes, the nodes, the elements as numbers.
struct Mesh {
    head: String,
    nodes: Vec<[f64; 3]>,
    elements: Vec<Vec<usize>>,
}

impl Mesh {
    fn read(name: &str) -> Self {
        let text = text(&format!("meshes/{}.msh", name.trim_end_matches("-gmsh")));
        let (head, rest) = text.split_once("$Nodes\n").unwrap();
        let (nodes, rest) = rest.split_once("$EndNodes\n$Elements\n").unwrap();
        let rows = |block: &str| -> Vec<Vec<String>> {
            block.lines().skip(1).map(|line| line.split_whitespace().map(str::to_string).collect()).collect()
        };
        let place = |row: Vec<String>| std::array::from_fn(|axis| row[axis + 1].parse().unwrap());
        let numbers = |row: Vec<String>| row[1..].iter().map(|word| word.parse().unwrap()).collect();
        Self {
            head: head.into(),
            nodes: rows(nodes).into_iter().map(place).collect(),
            elements: rows(rest.split_once("$EndElements").unwrap().0).into_iter().map(numbers).collect(),
        }
    }

    /// Writes the mesh and returns its file.
    fn write(&self, name: &str) -> String {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("metamorphic");
        fs::create_dir_all(&folder).unwrap();
        let mut out = format!("{}$Nodes\n{}\n", self.head, self.nodes.len());
        for (number, [x, y, z]) in self.nodes.iter().enumerate() {
            writeln!(out, "{} {x} {y} {z}", number + 1).unwrap();
        }
        writeln!(out, "$EndNodes\n$Elements\n{}", self.elements.len()).unwrap();
        for (number, element) in self.elements.iter().enumerate() {
            let words: Vec<_> = element.iter().map(usize::to_string).collect();
            writeln!(out, "{} {}", number + 1, words.join(" ")).unwrap();
        }
        out.push_str("$EndElements\n");
        let file = folder.join(format!("{name}.msh"));
        fs::write(&file, out).unwrap();
        file.to_str().unwrap().into()
    }

    /// Counts nodes and elements in another order, and begins elements at another corner.
    fn renumbered(mut self) -> Self {
        // A step without a divisor in common with the count visits every node once.
        let count = self.nodes.len();
        let coprime =
            |step: &usize| (2..=*step).all(|d| !(step.is_multiple_of(d) && count.is_multiple_of(d)));
        let step = (count / 3..).find(coprime).unwrap();
        let new = |old: usize| (old * step + 5) % count;
        let mut nodes = self.nodes.clone();
        self.nodes.iter().enumerate().for_each(|(old, &place)| nodes[new(old)] = place);
        self.nodes = nodes;
        for element in &mut self.elements {
            let corners = corners(element);
            corners.iter_mut().for_each(|node| *node = new(*node - 1) + 1);
            if corners.len() > 2 {
                corners.rotate_left(1);
            }
        }
        self.elements.reverse();
        self
    }

    /// Turns elements of a mesh in a mirror back, so that faces keep the side of their normals.
    fn turned_back(mut self) -> Self {
        self.elements.iter_mut().for_each(|element| corners(element).reverse());
        self
    }

    fn placed(mut self, place: impl Fn([f64; 3]) -> [f64; 3]) -> Self {
        self.nodes.iter_mut().for_each(|node| *node = place(*node));
        self
    }
}

/// The nodes of an element: behind its kind, the number of its tags, and these.
fn corners(element: &mut [usize]) -> &mut [usize] {
    let tags = element[1];
    &mut element[2 + tags..]
}

/// A scene on another mesh, with places and directions taken along.
fn scene(name: &str, file: String, place: &dyn Fn([f64; 3]) -> [f64; 3]) -> String {
    let mut scene = toml::Value::Table(text(&format!("meshes/{name}.toml")).parse().unwrap());
    scene["geometry"]["mesh"]["file"] = file.into();
    take_along(&mut scene, place);
    toml::to_string(&scene).unwrap()
}

/// Replaces places by where they go; directions by the difference from where their tail goes.
fn take_along(value: &mut toml::Value, place: &dyn Fn([f64; 3]) -> [f64; 3]) {
    let read = |value: &toml::Value| -> Option<[f64; 3]> {
        let list = value.as_array()?;
        let number = |value: &toml::Value| value.as_float().or_else(|| value.as_integer().map(|i| i as f64));
        let numbers: Vec<f64> = list.iter().map(number).collect::<Option<_>>()?;
        numbers.try_into().ok()
    };
    let write = |[x, y, z]: [f64; 3]| toml::Value::from(vec![x, y, z]);
    let tail = place([0.0; 3]);
    let direction = |d| {
        let tip = place(d);
        write(std::array::from_fn(|axis| tip[axis] - tail[axis]))
    };
    match value {
        toml::Value::Table(table) => {
            let corners = [table.get("min"), table.get("max")].map(|value| value.and_then(read));
            if let [Some(min), Some(max)] = corners.map(|corner| corner.map(place)) {
                table["min"] = write(std::array::from_fn(|axis| min[axis].min(max[axis])));
                table["max"] = write(std::array::from_fn(|axis| min[axis].max(max[axis])));
            }
            for (key, value) in table.iter_mut() {
                match (key.as_str(), read(value)) {
                    ("nearest", Some(at)) => *value = write(place(at)),
                    ("direction" | "normal" | "total", Some(along)) => *value = direction(along),
                    ("displacement", _) => {
                        let axes = value.as_array_mut();
                        axes.into_iter().flatten().for_each(|axis| {
                            if let Some(along) = read(axis) {
                                *axis = direction(along);
                            }
                        });
                    }
                    _ => take_along(value, place),
                }
            }
        }
        toml::Value::Array(list) => list.iter_mut().for_each(|value| take_along(value, place)),
        _ => {}
    }
}

/// Puts all meshes through a relation; `place` receives the length of the mesh.
fn hold(
    relation: &str,
    change: impl Fn(Mesh) -> Mesh,
    place: impl Fn([f64; 3], f64) -> [f64; 3],
    bound: f64,
) {
    let mut failures = Vec::new();
    for (name, length) in MESHED {
        let place = |at| place(at, length);
        let same = scene(name, Mesh::read(name).write(&format!("{name}-same-{relation}")), &|at| at);
        let file = change(Mesh::read(name).placed(place)).write(&format!("{name}-{relation}"));
        let (one, other) = (ran(&same, &[], 1), ran(&scene(name, file, &place), &[], 1));
        let ones = vec![1.0; one.curve.columns.len()];
        judge(&mut failures, relation, name, difference(&one, &other, &ones), bound);
        let iterations = |outcome: &Outcome| outcome.summary.record.newton_iterations;
        // A residual near its bound falls to either side of it.
        let [one, other] = [iterations(&one), iterations(&other)];
        assert!(one.abs_diff(other) <= 1 + one / 20, "{relation} {name}: {one} {other}");
    }
    assert!(failures.is_empty(), "{failures:#?}");
}

#[test]
fn a_mesh_that_is_counted_otherwise_gives_the_same_curve() {
    hold("renumbered", Mesh::renumbered, |at, _| at, 1e-9);
}

#[test]
fn a_mesh_that_is_mirrored_gives_the_same_curve() {
    hold("mirrored", Mesh::turned_back, |[x, y, z], _| [-x, y, z], 1e-9);
}

/// Ties find their hosts whatever rounding does to distances that are equal.
#[test]
fn a_mesh_that_is_shifted_gives_the_same_curve() {
    for (number, shift) in [[3.3, -2.1, 0.7], [-0.123, 17.9, 0.031], [0.1, 0.1, 0.1]].into_iter().enumerate()
    {
        let place = move |at: [f64; 3], _| std::array::from_fn(|axis| at[axis] + shift[axis]);
        hold(&format!("shifted {number}"), |mesh| mesh, place, 1e-9);
    }
}

/// Ten thousand lengths away places have twelve digits; displacements keep theirs.
#[test]
fn a_mesh_far_away_gives_the_same_curve() {
    let place = |at: [f64; 3], length| std::array::from_fn(|axis| at[axis] + [9e3, -4e3, 3e3][axis] * length);
    hold("far away", |mesh| mesh, place, 1e-9);
}
