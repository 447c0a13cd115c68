//! Numbers without structure, glued points moved by them, two sheets of unlike cells that may touch.

#![allow(dead_code)] // each test uses some

use contact::{Glue, Law, Mesh, Node, SurfaceContact, SurfaceTouch, Touching};
use nalgebra::{Matrix3, Rotation3};
use sph_core::{Cell, Vec3};

pub const TOUCHING: Touching =
    Touching { distance: 0.2, law: Law::SHARP, stiffness: 7.0, skin: 0.3, edges: false };

/// A number from −1 to 1.
pub fn number(seed: usize) -> f64 {
    let x = libm::sin(12.9898 * seed as f64 + 4.1) * 43758.5453;
    2.0 * (x - libm::floor(x)) - 1.0
}

/// Places after motions of a size.
pub fn moved(places: &[[f64; 3]], by: f64) -> Vec<[f64; 3]> {
    let at = |(a, x): (usize, &[f64; 3])| std::array::from_fn(|k| x[k] + by * number(3 * a + k));
    places.iter().enumerate().map(at).collect()
}

/// Energy and forces of glue.
pub fn forces(glue: &Glue, places: &[[f64; 3]]) -> (f64, Vec<[f64; 3]>) {
    let mut forces = vec![[0.0; 3]; places.len()];
    (glue.evaluate(places, &mut forces), forces)
}

/// Squares of a size over a corner of a plane, turned in it, each node moved off its place by a part of a cell.
pub fn sheet(count: u32, size: f64, turned: f64, rugged: f64) -> (Vec<Cell>, Vec<Vec3>) {
    let turn = Rotation3::from_axis_angle(&Vec3::z_axis(), turned);
    let place = |a: u32| {
        let off = Vec3::from_fn(|k, _| number(3 * a as usize + k)) * rugged;
        turn * ((Vec3::new(f64::from(a % (count + 1)), f64::from(a / (count + 1)), 0.0) + off) * size)
    };
    let rest = (0..(count + 1) * (count + 1)).map(place).collect();
    let cell = |i: u32| {
        let a = i % count + (i / count) * (count + 1);
        Cell { corners: [a, a + 1, a + count + 2, a + count + 1], count: 4 }
    };
    ((0..count * count).map(cell).collect(), rest)
}

/// Places of the nodes of two bodies.
pub type At = [Vec<Vec3>; 2];

/// Two sheets of unlike cells with their nodes.
pub struct Two {
    pub contact: SurfaceContact,
    pub at: At,
}

impl Two {
    /// A sheet of so many squares of .6 along a side, a way above one of six squares of one.
    pub fn new(count: u32, up: Vec3, rugged: f64, touching: Touching, friction: f64) -> Self {
        let (cells, below) = sheet(6, 1.0, 0.0, rugged);
        let (others, mut above) = sheet(count, 0.6, 0.1, rugged);
        above.iter_mut().for_each(|x| *x += up);
        let meshes = [Mesh::new(&cells, &below, |_| 0.1), Mesh::new(&others, &above, |_| 0.1)];
        let contact = SurfaceContact::between(meshes, [&below, &above], touching).with_friction(friction);
        Self { contact, at: [below, above] }
    }

    pub fn look(&mut self) -> SurfaceTouch {
        let Self { contact, at } = self;
        contact.look(|(body, a)| at[body][a as usize])
    }

    pub fn forces(&self) -> At {
        let mut forces = [0, 1].map(|body: usize| vec![Vec3::zeros(); self.at[body].len()]);
        self.contact.forces(|(body, a), force| forces[body][a as usize] += force);
        forces
    }

    /// What the tangent makes of a motion.
    pub fn tangent(&self, way: &At) -> At {
        let mut out = [0, 1].map(|body: usize| vec![Vec3::zeros(); self.at[body].len()]);
        let at = |(body, a): Node| self.at[body][a as usize];
        self.contact.tangent(at, |(b, a), (c, d), block: &Matrix3<f64>| {
            out[b][a as usize] += block * way[c][d as usize];
        });
        out
    }

    /// Places after a part of a motion.
    pub fn moved(&self, way: &At, by: f64) -> At {
        [0, 1].map(|b| self.at[b].iter().zip(&way[b]).map(|(x, u)| x + u * by).collect())
    }

    /// Moves the second sheet.
    pub fn shift(&mut self, by: Vec3) {
        self.at[1].iter_mut().for_each(|x| *x += by);
    }
}
