//! Structures and walls do not feel each other but for shells whose scene names the contact: which structure stands in a wall, and which got
//! into one.
//!
//! How deep a place is in a wall is reported exactly of basins and blocks at rest. Of other walls, and of those that move, it is found by the
//! balls of half a spacing about their particles, which lie within the wall: that is at least how deep a place is, and rows behind the
//! last are not found from what lies beyond.

use std::ops::Range;

use fluid_sph::Fluid;
use sph_core::{CellList, Vec3};

use super::dry::corners;
use crate::bodies::fluid::walls::BuiltWalls;
use crate::scene::WallGeometry;
use crate::scene::bounded::numbers;
use crate::scene::sets::OF_WALLS;

/// Depth up to which nothing is in a wall, in spacings of the fluid; and way beyond which what began in a wall moves in it.
const DEPTH: f64 = 0.25;
/// The same by the balls about particles of walls: rounding.
const IN_BALL: f64 = 1e-6;

/// A body of walls, as structures may get into it.
#[derive(Clone, Debug)]
struct Watched {
    name: String,
    shape: Shape,
    /// Its pieces among the walls of the fluid.
    pieces: Range<usize>,
    moves: bool,
    /// By structure: whether it touches the walls, and cannot get into them.
    touched: Vec<bool>,
}

#[derive(Clone, Debug)]
enum Shape {
    /// Inside of a box; which of its sides have a wall.
    Basin(Vec3, Vec3, [bool; 6]),
    /// Outside of a box.
    Block(Vec3, Vec3),
    /// Particles.
    Rows,
}

/// A structure in a wall.
#[derive(Clone, Copy, Debug)]
pub(super) struct Inside {
    /// The body of walls.
    pub wall: usize,
    /// Greatest depth of a particle of the structure \[L\].
    pub depth: f64,
}

/// What a structure did at records so far.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entered {
    /// When it was first found in a wall \[T\]; negative before.
    pub since: f64,
    /// That wall.
    pub wall: f64,
    /// The greatest depth so far \[L\], and its time \[T\].
    pub depth: f64,
    pub at: f64,
}

/// The walls of a scene, and what structures did to them.
#[derive(Clone, Debug, Default)]
pub(super) struct Contact {
    walls: Vec<Watched>,
    /// Spacing of the fluid \[L\].
    spacing: f64,
    /// By structure: whether a particle stands in a wall at the start.
    begins: Vec<Vec<bool>>,
    /// By structure.
    pub entered: Vec<Entered>,
}

impl Watched {
    fn new(body: &BuiltWalls<'_>, pieces: Range<usize>, structures: &[&str]) -> Self {
        let corner =
            |list: &[f64], none: f64| Vec3::from([0, 1, 2].map(|k| list.get(k).copied().unwrap_or(none)));
        let shape = match &body.scene.geometry {
            _ if body.scene.motion.is_some() => Shape::Rows,
            WallGeometry::Basin(basin) => {
                let closed = |side: usize| basin.open.iter().all(|open| open != OF_WALLS[side + 1]);
                let (min, max) = (corner(&basin.min, f64::NEG_INFINITY), corner(&basin.max, f64::INFINITY));
                Shape::Basin(min, max, [0, 1, 2, 3, 4, 5].map(closed))
            }
            WallGeometry::Block(block) => {
                let plane = block.lengths.len() == 2;
                let mut origin = corner(block.origin.as_deref().unwrap_or_default(), 0.0);
                let mut end = origin + corner(&numbers(&block.lengths), 0.0);
                if plane {
                    (origin.z, end.z) = (f64::NEG_INFINITY, f64::INFINITY);
                }
                Shape::Block(origin, end)
            }
            WallGeometry::Polyline(_) | WallGeometry::Surface(_) => Shape::Rows,
        };
        let touches =
            |name: &&str| body.view.scene.contact.iter().any(|own| own.other(body.view.name) == Some(*name));
        let touched = structures.iter().map(touches).collect();
        Self { name: body.view.name.into(), shape, pieces, moves: body.scene.motion.is_some(), touched }
    }

    /// How deep each of some places is in it \[L\], those no deeper than what counts left out.
    fn depths(&self, fluid: &Fluid, spacing: f64, places: &[Vec3]) -> Vec<(usize, f64)> {
        let numbered = || places.iter().enumerate();
        match &self.shape {
            Shape::Basin(min, max, closed) => {
                let beyond = |x: &Vec3, side: usize| match side % 2 {
                    0 => min[side / 2] - x[side / 2],
                    _ => x[side / 2] - max[side / 2],
                };
                // What left by an open side may be anywhere.
                let left = |x: &Vec3| (0..6).any(|side| !closed[side] && beyond(x, side) > 0.0);
                let depth = |x: &Vec3| (0..6).map(|side| beyond(x, side)).fold(0.0, f64::max);
                let all = numbered().map(|(a, x)| (a, if left(x) { 0.0 } else { depth(x) }));
                all.filter(|(_, depth)| *depth > DEPTH * spacing).collect()
            }
            Shape::Block(min, max) => {
                let depth = |x: &Vec3| (x - min).inf(&(max - x)).min();
                numbered().map(|(a, x)| (a, depth(x))).filter(|(_, depth)| *depth > DEPTH * spacing).collect()
            }
            Shape::Rows => {
                let particles: Vec<Vec3> = self
                    .pieces
                    .clone()
                    .flat_map(|piece| fluid.wall_positions(piece).iter().copied())
                    .collect();
                let (low, high) = corners(places);
                let radius = 0.5 * spacing;
                let near = |x: &&Vec3| (0..3).all(|k| x[k] > low[k] - radius && x[k] < high[k] + radius);
                let near: Vec<Vec3> = particles.iter().filter(near).copied().collect();
                let list = CellList::new(&near, radius);
                let all = numbered().map(|(a, x)| (a, radius - list.nearest(x, 1).min(radius)));
                all.filter(|(_, depth)| *depth > IN_BALL * spacing).collect()
            }
        }
    }
}

impl Contact {
    /// The walls about some structures, whose names and places in the plane of the fluid are given; a wall's pieces are those of the fluid.
    pub fn new(
        walls: &[BuiltWalls<'_>],
        pieces: &[Range<usize>],
        fluid: &Fluid,
        (names, structures): (&[&str], &[Vec<Vec3>]),
    ) -> Self {
        let watched =
            |(body, pieces): (&BuiltWalls<'_>, &Range<usize>)| Watched::new(body, pieces.clone(), names);
        let walls = walls.iter().zip(pieces).map(watched).collect();
        let begins = structures.iter().map(|places| vec![false; places.len()]).collect();
        let none = Entered { since: -1.0, wall: 0.0, depth: 0.0, at: 0.0 };
        let entered = vec![none; structures.len()];
        let mut contact = Self { walls, spacing: fluid.spacing(), begins, entered };
        for (number, places) in structures.iter().enumerate() {
            for wall in &contact.walls {
                for (particle, _) in wall.depths(fluid, contact.spacing, places) {
                    contact.begins[number][particle] = true;
                }
            }
        }
        contact
    }

    /// The name of a wall.
    pub fn wall(&self, number: usize) -> &str {
        self.walls.get(number).map_or("", |wall| &wall.name)
    }

    /// Where places of a structure are deepest in a wall at the start.
    pub fn at_start(&self, fluid: &Fluid, places: &[Vec3]) -> Option<Inside> {
        self.deepest(fluid, places, |_, _| true)
    }

    /// Looks where a structure is at a time: its places, and those at rest.
    pub fn look(&mut self, time: f64, number: usize, fluid: &Fluid, places: &[Vec3], rest: &[Vec3]) {
        let far = DEPTH * self.spacing;
        let begins = &self.begins[number];
        // What began in a wall is held there, unless it moves in it.
        let counts = |particle: usize, wall: &Watched| {
            !wall.touched[number]
                && (!begins[particle] || !wall.moves && (places[particle] - rest[particle]).norm() > far)
        };
        let Some(Inside { wall, depth }) = self.deepest(fluid, places, counts) else { return };
        let entered = &mut self.entered[number];
        if entered.since < 0.0 {
            (entered.since, entered.wall) = (time, wall as f64);
        }
        if depth > entered.depth {
            (entered.depth, entered.at) = (depth, time);
        }
    }

    fn deepest(
        &self,
        fluid: &Fluid,
        places: &[Vec3],
        counts: impl Fn(usize, &Watched) -> bool,
    ) -> Option<Inside> {
        let all = self.walls.iter().enumerate().flat_map(|(number, wall)| {
            let depths = wall.depths(fluid, self.spacing, places).into_iter();
            let counted = depths.filter(|&(particle, _)| counts(particle, wall)).collect::<Vec<_>>();
            counted.into_iter().map(move |(_, depth)| Inside { wall: number, depth })
        });
        all.max_by(|a, b| a.depth.total_cmp(&b.depth))
    }
}
