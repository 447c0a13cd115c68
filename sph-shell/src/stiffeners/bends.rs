//! Bars that bend in the surface: at each particle of a line between two others, the turn of its centroid line about the director.
//!
//! Places `x + e d` of three neighbours are the line, the [`LineBend`] of `shell-kinematics` what its turn stores, over half of both pieces. At an end of the line
//! nothing acts, as on a bar that ends there, unless it is held: then the direction of its last piece stays as at rest, over half of that piece.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use implicit_statics::BlockPattern;
use shell_kinematics::{LineBend, LinePlacement};
use sph_core::{Cloud, Vec3};

use super::vectors;
use crate::conditions::body::Block;
use crate::error::StiffenerError;
use crate::packs::Row;

/// Sine of the turn of a line at a particle, and cosine, beyond which it is a corner.
const STRAIGHT: f64 = 0.7;

/// What a bar is against bending in the surface.
#[derive(Clone, Debug, Default)]
pub struct InSurface {
    /// EI about the director \[F L²\].
    pub bending: f64,
    /// Particles at ends of the line where its direction is held.
    pub held: Vec<u32>,
}

/// A place of the line, the part of its position and of its director in the way before, the way behind, and the director.
#[derive(Clone, Copy, Debug)]
struct End {
    particle: u32,
    parts: [[f64; 2]; 3],
}

/// A turn of a line.
#[derive(Clone, Debug)]
pub(super) struct Turn {
    ends: Vec<End>,
    /// The way before of an end that is held; zero of others.
    fixed: Vec3,
    bend: LineBend,
}

impl Turn {
    fn new(ends: Vec<End>, fixed: Vec3, bending: f64, length: f64, rest: &[Row]) -> Self {
        let placement = placed(&ends, &fixed, rest);
        Self { bend: LineBend::new(bending, length, &placement), ends, fixed }
    }

    fn placement(&self, state: &[Row]) -> LinePlacement {
        placed(&self.ends, &self.fixed, state)
    }

    /// The moment by which what holds its direction bears it; none of a turn between two pieces \[F L\].
    pub fn held(&self, state: &[Row]) -> Option<Vec3> {
        if self.fixed == Vec3::zeros() {
            return None;
        }
        let forces = self.bend.forces(&self.placement(state));
        Some(self.fixed.cross(&Vec3::new(forces[0], forces[1], forces[2])))
    }

    /// Whether particles of a range feel it.
    pub fn touches(&self, own: &Range<usize>) -> bool {
        self.particles().any(|particle| own.contains(&(particle as usize)))
    }

    /// Particles of the turn, that which turns first.
    pub fn particles(&self) -> impl Iterator<Item = u32> {
        self.ends.iter().map(|end| end.particle)
    }

    /// Its energy \[F L\].
    pub fn energy(&self, state: &[Row]) -> f64 {
        self.bend.energy(&self.placement(state))
    }

    /// Adds `[∂U/∂x, ∂U/∂d]` to the rows of a range of particles.
    pub fn add_forces(&self, state: &[Row], own: &Range<usize>, rows: &mut [Row]) {
        if !self.touches(own) {
            return;
        }
        let forces = self.bend.forces(&self.placement(state));
        for end in self.ends.iter().filter(|end| own.contains(&(end.particle as usize))) {
            let row = &mut rows[end.particle as usize];
            for (vector, [x, d]) in end.parts.into_iter().enumerate() {
                for k in 0..3 {
                    row[k] += x * forces[3 * vector + k];
                    row[3 + k] += d * forces[3 * vector + k];
                }
            }
        }
    }

    /// Adds its second derivatives to blocks, with the moment of another state if one is given.
    pub fn add_blocks(
        &self,
        state: &[Row],
        stressed: Option<&[Row]>,
        pattern: &BlockPattern,
        blocks: &mut [Block],
    ) {
        let there = stressed.map(|state| self.placement(state));
        let tangent = self.bend.tangent(&self.placement(state), there.as_ref());
        for one in &self.ends {
            for two in self.ends.iter().filter(|two| two.particle <= one.particle) {
                let Some(number) = pattern.find(one.particle, two.particle) else { continue };
                let block = &mut blocks[number];
                for (i, j) in (0..6).flat_map(|i| (0..6).map(move |j| (i, j))) {
                    let sum = |(u, v): (usize, usize)| {
                        one.parts[u][i / 3] * two.parts[v][j / 3] * tangent[(3 * u + i % 3, 3 * v + j % 3)]
                    };
                    block[i][j] += (0..3).flat_map(|u| (0..3).map(move |v| (u, v))).map(sum).sum::<f64>();
                }
            }
        }
    }

    /// Whether one who marches a range of particles counts its energy.
    pub fn is_of(&self, own: &Range<usize>) -> bool {
        self.particles().next().is_some_and(|particle| own.contains(&(particle as usize)))
    }
}

fn placed(ends: &[End], fixed: &Vec3, state: &[Row]) -> LinePlacement {
    let mut sums = [*fixed, Vec3::zeros(), Vec3::zeros()];
    for End { particle, parts } in ends {
        let [x, d] = vectors(&state[*particle as usize]);
        sums.iter_mut().zip(parts).for_each(|(sum, [of_x, of_d])| *sum += x * *of_x + d * *of_d);
    }
    let [before, after, d] = sums;
    LinePlacement { before, after, d }
}

/// The turns of a bar along edges, its centroid at a height over the particles.
///
/// # Errors
/// [`StiffenerError`] for lines that fork or have corners, and particles that are held and no ends.
pub(super) fn turns(
    cloud: &Cloud,
    rest: &[Row],
    edges: &BTreeSet<[u32; 2]>,
    (number, height): (usize, f64),
    lateral: &InSurface,
) -> Result<Vec<Turn>, StiffenerError> {
    let mut next: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for &[a, b] in edges {
        next.entry(a).or_default().push(b);
        next.entry(b).or_default().push(a);
    }
    if let Some(&particle) = lateral.held.iter().find(|a| next.get(a).is_none_or(|own| own.len() != 1)) {
        return Err(StiffenerError::NoEnd { number, particle });
    }
    let way = |from: u32, to: u32| {
        let at = |a: u32| vectors(&rest[a as usize])[0] + vectors(&rest[a as usize])[1] * height;
        at(to) - at(from)
    };
    let h = height;
    let mut all = Vec::new();
    for (&particle, own) in &next {
        match own[..] {
            [to] if lateral.held.contains(&particle) => {
                let fixed = way(particle, to);
                let ends = vec![
                    End { particle, parts: [[0.0; 2], [-1.0, -h], [0.0, 1.0]] },
                    End { particle: to, parts: [[0.0; 2], [1.0, h], [0.0; 2]] },
                ];
                let length = 0.5 * fixed.norm();
                all.push(Turn::new(ends, fixed, lateral.bending, length, rest));
            }
            [_] => {}
            [from, to] => {
                let (before, after) = (way(from, particle), way(particle, to));
                let ends = vec![
                    End { particle, parts: [[1.0, h], [-1.0, -h], [0.0, 1.0]] },
                    End { particle: from, parts: [[-1.0, -h], [0.0; 2], [0.0; 2]] },
                    End { particle: to, parts: [[0.0; 2], [1.0, h], [0.0; 2]] },
                ];
                let turn = LinePlacement { before, after, d: cloud.frames[particle as usize].n }.turn();
                if turn.abs() > STRAIGHT || before.dot(&after) < STRAIGHT * before.norm() * after.norm() {
                    return Err(StiffenerError::Corner { number, particle });
                }
                let length = 0.5 * (before.norm() + after.norm());
                all.push(Turn::new(ends, Vec3::zeros(), lateral.bending, length, rest));
            }
            _ => return Err(StiffenerError::Forks { number, particle }),
        }
    }
    Ok(all)
}
