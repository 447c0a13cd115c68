//! Meshes as generators write them, brought in by the reader of meshes: blocks, triangles, zigzags, folds, octants, poles.

use std::collections::BTreeMap;
use std::fmt::Write;

use coque::mesh::{Format, Surface, parse};
use sph_core::{Cloud, Vec3};

use super::studies::RandomNumbers;

/// Places closer than this are one node where blocks are welded.
const WELD: f64 = 1e-7;

/// Columns and rows of quadrangles, and the image of the unit square that they make.
pub type Patch<'a> = ([usize; 2], &'a dyn Fn(f64, f64) -> Vec3);

/// Nodes and faces with three or four corners, and normals where the surface is known.
#[derive(Clone, Default)]
pub struct Mesh {
    /// Nodes \[L\].
    pub places: Vec<Vec3>,
    /// Faces.
    pub faces: Vec<Vec<u32>>,
    /// Normals at the nodes; none where they are to be found from the faces.
    pub normals: Vec<Vec3>,
}

impl Mesh {
    /// Blocks of columns × rows quadrangles, each the image of the unit square, welded where they touch.
    ///
    /// A face whose corners fall together, as at a pole, keeps those that differ.
    pub fn blocks(counts: [usize; 2], blocks: &[&dyn Fn(f64, f64) -> Vec3]) -> Self {
        Self::patches(&blocks.iter().map(|&block| (counts, block)).collect::<Vec<_>>())
    }

    /// The same of blocks with counts of their own, which agree where blocks touch.
    pub fn patches(patches: &[Patch<'_>]) -> Self {
        let mut mesh = Self::default();
        let mut known: BTreeMap<[i64; 3], u32> = BTreeMap::new();
        for &([columns, rows], block) in patches {
            let mut node = |i: usize, j: usize| {
                let place = block(i as f64 / columns as f64, j as f64 / rows as f64);
                let key = [place.x, place.y, place.z].map(|x| (x / WELD).round() as i64);
                *known.entry(key).or_insert_with(|| {
                    mesh.places.push(place);
                    mesh.places.len() as u32 - 1
                })
            };
            for (i, j) in (0..columns).flat_map(|i| (0..rows).map(move |j| (i, j))) {
                let mut face = vec![node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)];
                face.dedup();
                if face.first() == face.last() {
                    face.pop();
                }
                mesh.faces.push(face);
            }
        }
        mesh
    }

    /// The mesh with its image in the plane through the origin across an axis, welded in that plane.
    #[must_use]
    pub fn mirrored(mut self, axis: usize) -> Self {
        let count = self.places.len();
        let mut image = |a: usize| {
            let mut place = self.places[a];
            if place[axis].abs() < WELD {
                return a as u32;
            }
            place[axis] = -place[axis];
            self.places.push(place);
            self.places.len() as u32 - 1
        };
        let images: Vec<u32> = (0..count).map(&mut image).collect();
        let other = |face: &Vec<u32>| face.iter().rev().map(|&a| images[a as usize]).collect();
        let others: Vec<Vec<u32>> = self.faces.iter().map(other).collect();
        self.faces.extend(others);
        self
    }

    /// The faces of a cloud.
    pub fn of(cloud: &Cloud) -> Self {
        let faces = cloud.cells.iter().map(|cell| cell.particles().to_vec()).collect();
        Self { places: cloud.positions.clone(), faces, normals: Vec::new() }
    }

    /// The unit square in blocks of n × n quadrangles round a node in the middle where `valence` of them meet: 3 or 5.
    pub fn star(valence: usize, n: usize) -> Self {
        let middle = [0.5, 0.5];
        // Ends of the lines from the middle, and the corner between each and the next.
        let (ends, corners): (&[[f64; 2]], &[[f64; 2]]) = if valence == 3 {
            (&[[0.0, 0.45], [0.55, 0.0], [1.0, 1.0]], &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])
        } else {
            (
                &[[0.0, 0.5], [0.3, 0.0], [0.7, 0.0], [1.0, 0.5], [0.5, 1.0]],
                &[[0.0, 0.0], [0.5, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
            )
        };
        let maps: Vec<_> = (0..ends.len())
            .map(|k| {
                let quad = [middle, ends[k], corners[k], ends[(k + 1) % ends.len()]];
                move |u: f64, v: f64| {
                    let shape = [(1.0 - u) * (1.0 - v), u * (1.0 - v), u * v, (1.0 - u) * v];
                    let at = |axis: usize| quad.iter().zip(shape).map(|(x, n)| n * x[axis]).sum();
                    Vec3::new(at(0), at(1), 0.0)
                }
            })
            .collect();
        let maps: Vec<&dyn Fn(f64, f64) -> Vec3> = maps.iter().map(|map| map as _).collect();
        Self::blocks([n, n], &maps)
    }

    /// The unit square in n rows of triangles with equal sides, about; halves at the ends of every other row.
    pub fn rows_of_triangles(n: usize) -> Self {
        let columns = (n as f64 * 0.75_f64.sqrt()).round() as usize;
        let mut mesh = Self::default();
        let mut rows = Vec::new();
        for j in 0..=n {
            let first = mesh.places.len() as u32;
            let (width, y) = (1.0 / columns as f64, j as f64 / n as f64);
            let mut along: Vec<f64> = (0..=columns).map(|i| i as f64 * width).collect();
            if j % 2 == 1 {
                along = (0..columns).map(|i| (i as f64 + 0.5) * width).collect();
                along.insert(0, 0.0);
                along.push(1.0);
            }
            mesh.places.extend(along.iter().map(|&x| Vec3::new(x, y, 0.0)));
            rows.push((first, along));
        }
        for pair in rows.windows(2) {
            let [(low, below), (high, above)] = pair else { continue };
            // The two rows are zipped from left to right, the nearer node next.
            let (mut i, mut j) = (0, 0);
            while i + 1 < below.len() || j + 1 < above.len() {
                let (a, b) = (low + i as u32, high + j as u32);
                let ahead = |row: &[f64], at: usize| row.get(at + 1).copied().unwrap_or(f64::INFINITY);
                if ahead(below, i) <= ahead(above, j) {
                    mesh.faces.push(vec![a, a + 1, b]);
                    i += 1;
                } else {
                    mesh.faces.push(vec![a, b + 1, b]);
                    j += 1;
                }
            }
        }
        mesh
    }

    /// The unit square in n × n squares, each cut into four triangles at its middle.
    pub fn crossed(n: usize) -> Self {
        let mut mesh = Self::square([n, n]);
        for face in std::mem::take(&mut mesh.faces) {
            let middle = face.iter().map(|&a| mesh.places[a as usize]).sum::<Vec3>() / 4.0;
            let centre = mesh.places.len() as u32;
            mesh.places.push(middle);
            mesh.faces.extend((0..4).map(|k| vec![face[k], face[(k + 1) % 4], centre]));
        }
        mesh
    }

    /// The unit square in columns × rows rectangles.
    pub fn square(counts: [usize; 2]) -> Self {
        Self::blocks(counts, &[&|u, v| Vec3::new(u, v, 0.0)])
    }

    /// The unit square whose rows inside are shifted to and fro until corners of some cells are as sharp as this \[°\].
    pub fn zigzag(n: usize, degrees: f64) -> Self {
        let step = 1.0 / n as f64;
        let mut mesh = Self::square([n, n]);
        let sway = 0.5 * step / libm::tan(degrees.to_radians());
        for place in &mut mesh.places {
            let row = (place.y / step).round();
            if row > 0.5 && row < n as f64 - 0.5 {
                let side = if (row as usize).is_multiple_of(2) { 1.0 } else { -1.0 };
                place.x += side * sway * libm::sin(std::f64::consts::PI * place.x);
            }
        }
        mesh
    }

    /// Every quadrangle cut along its shorter diagonal.
    #[must_use]
    pub fn triangles(mut self) -> Self {
        let length = |a: u32, b: u32| (self.places[a as usize] - self.places[b as usize]).norm();
        let cut = |face: &Vec<u32>| match face[..] {
            [a, b, c, d] if length(a, c) <= length(b, d) => vec![vec![a, b, c], vec![a, c, d]],
            [a, b, c, d] => vec![vec![a, b, d], vec![b, c, d]],
            _ => vec![face.clone()],
        };
        self.faces = self.faces.iter().flat_map(cut).collect();
        self
    }

    /// Moves nodes at random in the plane z = 0 by up to a part of a spacing, except those that stay.
    #[must_use]
    pub fn jittered(mut self, reach: f64, seed: u64, stays: impl Fn(&Vec3) -> bool) -> Self {
        let mut dice = RandomNumbers(seed);
        // The first rolls of small seeds are alike.
        for _ in 0..8 {
            dice.roll();
        }
        for place in &mut self.places {
            let shift = Vec3::new(dice.roll(), dice.roll(), 0.0) * reach;
            if !stays(place) {
                *place += shift;
            }
        }
        self
    }

    /// Moves every node inside to the mean of its neighbours, some times: what generators do last.
    #[must_use]
    pub fn smoothed(mut self, times: usize) -> Self {
        let mut edges: Vec<(u32, u32)> = Vec::new();
        for face in &self.faces {
            edges.extend((0..face.len()).map(|k| (face[k], face[(k + 1) % face.len()])));
        }
        let inside = |a: u32, edges: &[(u32, u32)]| {
            edges.iter().filter(|e| e.0 == a).all(|e| edges.contains(&(e.1, e.0)))
        };
        let free: Vec<bool> = (0..self.places.len() as u32).map(|a| inside(a, &edges)).collect();
        for _ in 0..times {
            let mut sums = vec![(Vec3::zeros(), 0.0); self.places.len()];
            for &(a, b) in &edges {
                let sum = &mut sums[a as usize];
                *sum = (sum.0 + self.places[b as usize], sum.1 + 1.0);
            }
            for ((place, (sum, count)), _) in
                self.places.iter_mut().zip(sums).zip(&free).filter(|(_, free)| **free)
            {
                *place = sum / count;
            }
        }
        self
    }

    /// The mesh laid on another surface.
    #[must_use]
    pub fn mapped(mut self, map: impl Fn(&Vec3) -> Vec3) -> Self {
        self.places = self.places.iter().map(map).collect();
        self
    }

    /// With normals of the surface that was meshed, as functions of the place.
    #[must_use]
    pub fn with_normals(mut self, normal: impl Fn(&Vec3) -> Vec3) -> Self {
        self.normals = self.places.iter().map(normal).collect();
        self
    }

    /// The cloud that the reader of meshes makes of it; a refusal in words.
    pub fn cloud(&self) -> Result<Cloud, String> {
        of_surface(&self.surface()?)
    }

    /// The same with one particle and one normal at folds, for stencils that reach across them.
    pub fn undivided(&self) -> Result<Cloud, String> {
        of_surface(&self.surface()?.undivided().map_err(|error| error.to_string())?)
    }

    fn surface(&self) -> Result<Surface, String> {
        let mut text = String::new();
        let wrote = |_| "no room for a mesh".to_owned();
        for place in &self.places {
            writeln!(text, "v {} {} {}", place.x, place.y, place.z).map_err(wrote)?;
        }
        for normal in &self.normals {
            writeln!(text, "vn {} {} {}", normal.x, normal.y, normal.z).map_err(wrote)?;
        }
        for face in &self.faces {
            text.push('f');
            for corner in face.iter().map(|a| a + 1) {
                let normal = if self.normals.is_empty() { String::new() } else { format!("//{corner}") };
                write!(text, " {corner}{normal}").map_err(wrote)?;
            }
            text.push('\n');
        }
        parse("mesh.obj", Format::Obj, text.as_bytes()).map_err(|error| error.to_string())
    }
}

fn of_surface(surface: &Surface) -> Result<Cloud, String> {
    surface.cloud(surface.node_normals()).map(|(cloud, _)| cloud).map_err(|error| error.to_string())
}

/// An eighth of a sphere of radius one in three blocks of n × n quadrangles round the direction (1, 1, 1): no pole.
pub fn octant(n: usize) -> Mesh {
    let (third, half) = (1.0 / 3.0_f64.sqrt(), 0.5_f64.sqrt());
    let middle = Vec3::new(third, third, third);
    let block = move |corner: Vec3, left: Vec3, right: Vec3| {
        move |u: f64, v: f64| {
            // Great circles by angle on both sides of the block, and between them.
            let (low, high) = (arc(&corner, &left, u), arc(&right, &middle, u));
            arc(&low, &high, v)
        }
    };
    let (x, y, z) = (Vec3::x(), Vec3::y(), Vec3::z());
    let (xy, yz, zx) = (Vec3::new(half, half, 0.0), Vec3::new(0.0, half, half), Vec3::new(half, 0.0, half));
    let blocks = [block(x, xy, zx), block(y, yz, xy), block(z, zx, yz)];
    Mesh::blocks([n, n], &[&blocks[0], &blocks[1], &blocks[2]]).with_normals(|x| *x)
}

/// An eighth of a sphere of radius one in n rows of latitude and longitude: triangles round the pole z.
pub fn poled_octant(n: usize) -> Mesh {
    let quarter = std::f64::consts::FRAC_PI_2;
    let place = |u: f64, v: f64| {
        let (sin, cos) = libm::sincos(quarter * u);
        // A row of exact poles welds.
        let sin = if u == 0.0 { 0.0 } else { sin };
        Vec3::new(sin * libm::cos(quarter * v), sin * libm::sin(quarter * v), cos)
    };
    Mesh::blocks([n, n], &[&place]).with_normals(|x| *x)
}

/// The point at a part of the great circle from one unit vector to another.
fn arc(from: &Vec3, to: &Vec3, part: f64) -> Vec3 {
    let angle = from.angle(to);
    if angle < 1e-12 {
        return *from;
    }
    (from * libm::sin((1.0 - part) * angle) + to * libm::sin(part * angle)) / libm::sin(angle)
}

/// The particles at places that fulfil a condition.
pub fn particles(cloud: &Cloud, condition: impl Fn(&Vec3) -> bool) -> Vec<u32> {
    (0..cloud.len() as u32).filter(|&a| condition(&cloud.positions[a as usize])).collect()
}

/// The particle nearest to a place.
pub fn nearest(cloud: &Cloud, place: Vec3) -> u32 {
    let distance = |a: &u32| (cloud.positions[*a as usize] - place).norm();
    (0..cloud.len() as u32).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0)
}
