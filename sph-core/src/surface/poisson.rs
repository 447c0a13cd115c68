//! Poisson-disk clouds: particles thrown at random on a patch, none nearer to another than a bound.

use std::f64::consts::TAU;

use libm::{cos, sin, sqrt};

use crate::Vec3;
use crate::error::SpaceError;
use crate::random::SplitMix;
use crate::surface::cloud::Cloud;
use crate::surface::patch::Patch;
use crate::surface::sides::Sides;
use crate::surface::surface_mesh::{INTERVALS, area, cells_on, mean_lengths};

/// Least distance between particles, in spacings: with it there is about one particle per spacing squared.
const LEAST_DISTANCE: f64 = 0.8;

/// Throws from a particle before it is left: as published \[bridson2007\].
const THROWS: usize = 30;

/// Bounds what a scene may allocate: ten million particles take about ten gigabytes.
const MOST_PARTICLES: f64 = 1e7;

/// Cloud of particles scattered over `patch`, about one per `spacing`² `[L²]`, none nearer than 0.8 `spacing` to another.
///
/// Particles on the edges stand evenly, `spacing` apart as nearly as their number allows, corners included; inside,
/// particles are thrown around those already there, at one to two times the least distance, until no throw of thirty fits
/// (Bridson \[bridson2007\], distances in space). Cells come from Delaunay triangles in pairs. Normals are those of the
/// patch. The same seed gives the same cloud on every machine.
///
/// # Errors
/// [`SpaceError::Spacing`] if the spacing is larger than the shortest edge, or would take more than ten million
/// particles.
pub fn poisson_cloud(patch: &dyn Patch, spacing: f64, seed: u64) -> Result<Cloud, SpaceError> {
    let outline = Outline::new(patch);
    let shortest = outline.lengths.iter().copied().fold(f64::INFINITY, f64::min);
    let least = sqrt(area(patch) / MOST_PARTICLES);
    if !(least..=shortest).contains(&spacing) {
        return Err(SpaceError::Spacing { value: spacing, least, greatest: shortest });
    }
    let mut scatter = Scatter::new(patch, LEAST_DISTANCE * spacing, area(patch));
    outline.points(spacing).into_iter().for_each(|x| scatter.add(x));
    scatter.fill(&mut SplitMix { state: seed });
    let parameters = in_strips(patch, spacing, scatter.parameters);
    let positions: Vec<Vec3> = parameters.iter().map(|x| patch.position(x[0], x[1])).collect();
    let normals = parameters.iter().map(|x| patch.normal(x[0], x[1])).collect();
    let cells = cells_on(patch, &parameters, &positions)?;
    let sides = sides(patch, &parameters);
    Ok(Cloud { sides: Some(sides), ..Cloud::from_cells(positions, Some(normals), cells)? })
}

/// The four edges of a patch, measured.
struct Outline {
    range: [[f64; 2]; 2],
    /// Arc length `[L]` from the first end at equal steps of the parameter: v on u0 and u1, u on v0 and v1.
    arcs: [Vec<f64>; 4],
    lengths: [f64; 4],
}

impl Outline {
    fn new(patch: &dyn Patch) -> Outline {
        let range @ [[u0, u1], [v0, v1]] = patch.range();
        let at = |[first, last]: [f64; 2], s: f64| first + (last - first) * s;
        let arc = |speed: &dyn Fn(f64) -> f64| {
            // Simpson's rule in each interval.
            let steps = 4 * INTERVALS;
            let place = |i: usize, half: f64| (i as f64 + half) / steps as f64;
            let mut arc = vec![0.0];
            for i in 0..steps {
                let mean = (speed(place(i, 0.0)) + 4.0 * speed(place(i, 0.5)) + speed(place(i, 1.0))) / 6.0;
                arc.push(arc[i] + mean / steps as f64);
            }
            arc
        };
        let along_v = |u: f64| arc(&|s| patch.tangents(u, at(range[1], s)).1.norm() * (v1 - v0));
        let along_u = |v: f64| arc(&|s| patch.tangents(at(range[0], s), v).0.norm() * (u1 - u0));
        let arcs = [along_v(u0), along_v(u1), along_u(v0), along_u(v1)];
        let lengths = arcs.each_ref().map(|arc| arc[arc.len() - 1]);
        Outline { range, arcs, lengths }
    }

    /// Parameters of particles about `spacing` apart on the edges, each corner once.
    fn points(&self, spacing: f64) -> Vec<[f64; 2]> {
        let [[u0, u1], [v0, v1]] = self.range;
        let mut points = vec![[u0, v0], [u1, v0], [u0, v1], [u1, v1]];
        for (side, (arc, length)) in self.arcs.iter().zip(self.lengths).enumerate() {
            let intervals = (length / spacing).round().max(1.0);
            for i in 1..intervals as usize {
                let part = inverse(arc, length * i as f64 / intervals);
                points.push(match side {
                    0 => [u0, v0 + (v1 - v0) * part],
                    1 => [u1, v0 + (v1 - v0) * part],
                    2 => [u0 + (u1 - u0) * part, v0],
                    _ => [u0 + (u1 - u0) * part, v1],
                });
            }
        }
        points
    }
}

/// Where in (0, 1) a table of arc lengths at equal steps reaches `length`, by straight lines.
fn inverse(arc: &[f64], length: f64) -> f64 {
    let end = arc.partition_point(|&x| x < length).clamp(1, arc.len() - 1);
    let part = (length - arc[end - 1]) / (arc[end] - arc[end - 1]);
    ((end - 1) as f64 + part) / (arc.len() - 1) as f64
}

/// Particles under way, found again by the box of space they stand in.
struct Scatter<'a> {
    patch: &'a dyn Patch,
    /// Least distance `[L]`, and the edge of a box.
    least: f64,
    parameters: Vec<[f64; 2]>,
    positions: Vec<Vec3>,
    /// First particle of each chain; boxes share chains, which costs a look at its distance.
    heads: Vec<u32>,
    /// Next particle of the same chain.
    next: Vec<u32>,
}

/// End of a chain.
const END: u32 = u32::MAX;

impl<'a> Scatter<'a> {
    fn new(patch: &'a dyn Patch, least: f64, area: f64) -> Scatter<'a> {
        let chains = (2.0 * area / (least * least)) as usize;
        let heads = vec![END; chains.next_power_of_two().max(64)];
        Scatter { patch, least, parameters: Vec::new(), positions: Vec::new(), heads, next: Vec::new() }
    }

    fn chain(&self, place: [i64; 3]) -> usize {
        // Three large odd numbers scatter neighbouring boxes over the table.
        let [x, y, z] = place.map(|i| i as u64);
        let mixed = x.wrapping_mul(0x9e37_79b9_7f4a_7c15)
            ^ y.wrapping_mul(0xc2b2_ae3d_27d4_eb4f)
            ^ z.wrapping_mul(0x1656_67b1_9e37_79f9);
        (mixed >> 20) as usize & (self.heads.len() - 1)
    }

    fn box_of(&self, x: &Vec3) -> [i64; 3] {
        [x.x, x.y, x.z].map(|x| (x / self.least).floor() as i64)
    }

    fn add(&mut self, parameters: [f64; 2]) {
        let position = self.patch.position(parameters[0], parameters[1]);
        let chain = self.chain(self.box_of(&position));
        self.next.push(self.heads[chain]);
        self.heads[chain] = self.positions.len() as u32;
        self.parameters.push(parameters);
        self.positions.push(position);
    }

    /// Whether no particle is nearer than the least distance.
    fn free(&self, x: &Vec3) -> bool {
        let [i, j, k] = self.box_of(x);
        let bound = self.least * self.least;
        for di in -1..=1 {
            for dj in -1..=1 {
                for dk in -1..=1 {
                    let mut a = self.heads[self.chain([i + di, j + dj, k + dk])];
                    while a != END {
                        if (self.positions[a as usize] - x).norm_squared() < bound {
                            return false;
                        }
                        a = self.next[a as usize];
                    }
                }
            }
        }
        true
    }

    /// Throws until every particle has had its throws in vain.
    fn fill(&mut self, random: &mut SplitMix) {
        let mut active: Vec<usize> = (0..self.positions.len()).collect();
        while !active.is_empty() {
            let pick = ((random.next() * active.len() as f64) as usize).min(active.len() - 1);
            let thrown = (0..THROWS).find_map(|_| self.throw(active[pick], random));
            match thrown {
                Some(parameters) => {
                    active.push(self.positions.len());
                    self.add(parameters);
                }
                None => {
                    active.swap_remove(pick);
                }
            }
        }
    }

    /// Parameters of a place at one to two least distances from particle `a`, if it is inside and free.
    fn throw(&self, a: usize, random: &mut SplitMix) -> Option<[f64; 2]> {
        let (distance, angle) = (self.least * (1.0 + random.next()), TAU * random.next());
        let [u, v] = self.parameters[a];
        let (along_u, along_v) = self.patch.tangents(u, v);
        let first = along_u.normalize();
        let second = along_u.cross(&along_v).cross(&along_u).normalize();
        let step = distance * (cos(angle) * first + sin(angle) * second);
        // step = along_u·du + along_v·dv in the tangent plane.
        let (e, f, g) = (along_u.norm_squared(), along_u.dot(&along_v), along_v.norm_squared());
        let (p, q) = (step.dot(&along_u), step.dot(&along_v));
        let determinant = e * g - f * f;
        let (u, v) = (u + (g * p - f * q) / determinant, v + (e * q - f * p) / determinant);
        let inside = |[first, last]: [f64; 2], x: f64| first < x && x < last;
        let [range_u, range_v] = self.patch.range();
        let sound = inside(range_u, u) && inside(range_v, v) && self.free(&self.patch.position(u, v));
        sound.then_some([u, v])
    }
}

/// The parameters in strips a spacing wide along v, strip after strip along u: like the rows of a lattice, so that
/// neighbours have neighbouring numbers.
fn in_strips(patch: &dyn Patch, spacing: f64, mut parameters: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    let [first, last] = patch.range()[0];
    let strips = (mean_lengths(patch)[0] / spacing).max(1.0);
    // Particles on the edges stand a spacing apart: in the middle of strips, where rounding moves none to another.
    let strip = |x: &[f64; 2]| (strips * (x[0] - first) / (last - first)).round() as u64;
    parameters
        .sort_by(|x, y| strip(x).cmp(&strip(y)).then(x[1].total_cmp(&y[1])).then(x[0].total_cmp(&y[0])));
    parameters
}

/// Particles on the four edges, each in the order of its parameter.
fn sides(patch: &dyn Patch, parameters: &[[f64; 2]]) -> Sides {
    let [[u0, u1], [v0, v1]] = patch.range();
    let edge = |fixed: usize, at: f64| {
        let on = |&a: &u32| parameters[a as usize][fixed] == at;
        let mut edge: Vec<u32> = (0..parameters.len() as u32).filter(on).collect();
        let place = |a: u32| parameters[a as usize][1 - fixed];
        edge.sort_by(|&a, &b| place(a).total_cmp(&place(b)));
        edge
    };
    Sides::new([edge(0, u0), edge(0, u1), edge(1, v0), edge(1, v1)])
}
