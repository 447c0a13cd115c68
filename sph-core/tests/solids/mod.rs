//! Closed surfaces of simple bodies.

use nalgebra::Rotation3;
use sph_core::{ClosedSurface, SurfaceFault, Vec3};

#[derive(Clone)]
pub struct Triangles {
    pub vertices: Vec<Vec3>,
    pub triangles: Vec<[u32; 3]>,
}

impl Triangles {
    pub fn closed(&self) -> Result<ClosedSurface, SurfaceFault> {
        ClosedSurface::new(self.vertices.clone(), self.triangles.clone())
    }

    pub fn area(&self) -> f64 {
        let area = |corners: &[u32; 3]| {
            let [a, b, c] = corners.map(|corner| self.vertices[corner as usize]);
            0.5 * (b - a).cross(&(c - a)).norm()
        };
        self.triangles.iter().map(area).sum()
    }

    pub fn add(&mut self, other: Self) {
        let first = self.vertices.len() as u32;
        self.vertices.extend(other.vertices);
        self.triangles
            .extend(other.triangles.into_iter().map(|corners| corners.map(|corner| first + corner)));
    }

    pub fn mapped(mut self, place: impl Fn(&Vec3) -> Vec3) -> Self {
        self.vertices.iter_mut().for_each(|x| *x = place(x));
        self
    }

    pub fn moved(self, by: Vec3) -> Self {
        self.mapped(|x| x + by)
    }

    pub fn turned(self, by: Vec3) -> Self {
        let turn = Rotation3::new(by);
        self.mapped(|x| turn * x)
    }

    pub fn inside_out(mut self) -> Self {
        self.triangles.iter_mut().for_each(|corners| corners.swap(1, 2));
        self
    }

    /// The same with its triangles in another order, each from another corner.
    pub fn renumbered(mut self) -> Self {
        self.triangles.reverse();
        self.triangles.iter_mut().for_each(|corners| corners.rotate_left(1));
        let half = self.triangles.len() / 3;
        self.triangles.rotate_left(half);
        self
    }

    /// Four triangles for each, with vertices of their own, merged by place.
    pub fn divided(&self) -> Self {
        let mut out = Self { vertices: self.vertices.clone(), triangles: Vec::new() };
        let mut middles = std::collections::HashMap::new();
        for &[a, b, c] in &self.triangles {
            let [p, q, r] = [(a, b), (b, c), (c, a)].map(|(from, to)| {
                *middles.entry((from.min(to), from.max(to))).or_insert_with(|| {
                    out.vertices.push(0.5 * (self.vertices[from as usize] + self.vertices[to as usize]));
                    out.vertices.len() as u32 - 1
                })
            });
            out.triangles.extend([[a, p, r], [p, b, q], [r, q, c], [p, q, r]]);
        }
        out
    }
}

pub fn cuboid(low: Vec3, high: Vec3) -> Triangles {
    let corner = |code: usize| Vec3::from_fn(|k, _| if code >> k & 1 == 1 { high[k] } else { low[k] });
    let quads = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    let triangles = quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    Triangles { vertices: (0..8).map(corner).collect(), triangles }
}

pub fn tetrahedron(edge: f64) -> Triangles {
    let vertices = vec![Vec3::zeros(), Vec3::x() * edge, Vec3::y() * edge, Vec3::z() * edge];
    Triangles { vertices, triangles: vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]] }
}

/// A ball, each face of an octahedron divided so often in two.
pub fn ball(radius: f64, times: u32) -> Triangles {
    let axes = [Vec3::x(), Vec3::y(), Vec3::z(), -Vec3::x(), -Vec3::y(), -Vec3::z()];
    let mut triangles = Vec::new();
    for code in 0..8_u32 {
        let [a, b, c] = [0, 1, 2].map(|k| k + 3 * (code >> k & 1));
        let even = code.count_ones() % 2 == 0;
        triangles.push(if even { [a, b, c] } else { [a, c, b] });
    }
    let mut out = Triangles { vertices: axes.to_vec(), triangles };
    for _ in 0..times {
        out = out.divided().mapped(|x| x.normalize());
    }
    out.mapped(|x| x * radius)
}

/// A ball with a round cavity.
pub fn hollow(radius: f64, inner: f64, times: u32) -> Triangles {
    let mut out = ball(radius, times);
    out.add(ball(inner, times).inside_out());
    out
}
