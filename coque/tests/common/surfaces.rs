//! Closed surfaces in OBJ files, and what becomes of them: turned, mirrored, counted otherwise, joined to an image.

use std::collections::HashMap;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

/// Vertices, and faces by group.
#[derive(Clone)]
pub struct Obj {
    pub vertices: Vec<[f64; 3]>,
    pub groups: Vec<(String, Vec<Vec<usize>>)>,
}

impl Obj {
    pub fn parse(text: &str) -> Self {
        let mut out = Self { vertices: Vec::new(), groups: Vec::new() };
        for line in text.lines() {
            let words: Vec<&str> = line.split_whitespace().collect();
            match words[..] {
                ["v", x, y, z] => out.vertices.push([x, y, z].map(|word| word.parse().unwrap())),
                ["g", name] => out.groups.push((name.into(), Vec::new())),
                ["f", ref corners @ ..] => {
                    let face = corners.iter().map(|word| word.parse::<usize>().unwrap() - 1).collect();
                    out.groups.last_mut().unwrap().1.push(face);
                }
                _ => {}
            }
        }
        out
    }

    /// A box, each of its sides a group.
    pub fn cuboid(low: [f64; 3], high: [f64; 3]) -> Self {
        let corner = |code: usize| [0, 1, 2].map(|k| if code >> k & 1 == 1 { high[k] } else { low[k] });
        let sides = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
        let groups = sides.iter().enumerate().map(|(i, side)| (format!("side{i}"), vec![side.to_vec()]));
        Self { vertices: (0..8).map(corner).collect(), groups: groups.collect() }
    }

    /// With another one beside it.
    pub fn with(mut self, other: &Self) -> Self {
        let first = self.vertices.len();
        self.vertices.extend(&other.vertices);
        for (name, faces) in &other.groups {
            let faces = faces.iter().map(|face| face.iter().map(|k| k + first).collect());
            self.groups.push((format!("other-{name}"), faces.collect()));
        }
        self
    }

    pub fn mapped(mut self, place: impl Fn([f64; 3]) -> [f64; 3]) -> Self {
        self.vertices.iter_mut().for_each(|x| *x = place(*x));
        self
    }

    /// Its faces look to the other side: the mirror image of one that looks outwards does so again.
    pub fn reversed(mut self) -> Self {
        self.groups.iter_mut().flat_map(|(_, faces)| faces).for_each(|face| face.reverse());
        self
    }

    /// Triangles in another order, four for each.
    pub fn divided(self) -> Self {
        let mut out = Self { vertices: self.vertices.clone(), groups: Vec::new() };
        let mut middles = HashMap::new();
        for (name, faces) in self.groups.iter().rev() {
            let mut all = Vec::new();
            for face in faces.iter().rev() {
                for i in 2..face.len() {
                    let [a, b, c] = [face[i], face[0], face[i - 1]];
                    let [p, q, r] = [(a, b), (b, c), (c, a)].map(|(from, to)| {
                        *middles.entry((from.min(to), from.max(to))).or_insert_with(|| {
                            let [x, y] = [from, to].map(|k| self.vertices[k]);
                            out.vertices.push([0, 1, 2].map(|k| 0.5 * (x[k] + y[k])));
                            out.vertices.len() - 1
                        })
                    });
                    all.extend([vec![a, p, r], vec![p, b, q], vec![r, q, c], vec![p, q, r]]);
                }
            }
            out.groups.push((name.clone(), all));
        }
        out
    }

    /// With its image in the plane z = 0, both without the faces in it.
    pub fn doubled(mut self) -> Self {
        let flat = |vertices: &[[f64; 3]], face: &[usize]| face.iter().all(|&k| vertices[k][2] == 0.0);
        for (_, faces) in &mut self.groups {
            faces.retain(|face| !flat(&self.vertices, face));
        }
        let mut image = HashMap::new();
        for k in 0..self.vertices.len() {
            let [x, y, z] = self.vertices[k];
            image.insert(k, if z == 0.0 { k } else { self.vertices.len() });
            if z != 0.0 {
                self.vertices.push([x, y, -z]);
            }
        }
        for (_, faces) in &mut self.groups {
            let mirrored: Vec<Vec<usize>> =
                faces.iter().map(|face| face.iter().rev().map(|k| image[k]).collect()).collect();
            faces.extend(mirrored);
        }
        self
    }

    /// Writes it and returns its file.
    pub fn write(&self, name: &str) -> String {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("surfaces");
        fs::create_dir_all(&folder).unwrap();
        let mut text = String::new();
        for [x, y, z] in &self.vertices {
            writeln!(text, "v {x:?} {y:?} {z:?}").unwrap();
        }
        for (name, faces) in &self.groups {
            writeln!(text, "g {name}").unwrap();
            for face in faces {
                let corners: Vec<String> = face.iter().map(|k| (k + 1).to_string()).collect();
                writeln!(text, "f {}", corners.join(" ")).unwrap();
            }
        }
        let file = folder.join(format!("{name}.obj"));
        fs::write(&file, text).unwrap();
        file.to_str().unwrap().into()
    }
}
