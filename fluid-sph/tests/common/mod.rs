//! Fluids that several tests march.

#![allow(clippy::unwrap_used, dead_code)] // a test may stop where it stands, and each uses some of these

use explicit_dynamics::{Clock, Dynamics, March, Record, Transient};
use fluid_sph::{Fluid, Formulation, Liquid, Parts, Start, Wall};
use sph_core::Vec3;

pub const GRAVITY: f64 = 9.81;

/// A lattice of `counts` particles whose first corner lies at `corner`.
pub fn lattice(corner: [f64; 3], counts: [usize; 3], spacing: f64) -> Vec<Vec3> {
    let place = |k: usize, n: usize| corner[k] + (n as f64 + 0.5) * spacing;
    let mut points = Vec::new();
    for k in 0..counts[2] {
        for j in 0..counts[1] {
            for i in 0..counts[0] {
                points.push(Vec3::new(place(0, i), place(1, j), place(2, k)));
            }
        }
    }
    points
}

/// Three rows of particles around a box from the origin on, open at its top where `lid` is false.
pub fn basin(dimensions: usize, size: [f64; 3], spacing: f64, lid: bool) -> Wall {
    let rows = 3;
    let count = |k: usize| if k < dimensions { (size[k] / spacing).round() as usize } else { 1 };
    let up = dimensions - 1;
    let counts: [usize; 3] = std::array::from_fn(|k| if k < dimensions { count(k) + 2 * rows } else { 1 });
    let corner: [f64; 3] =
        std::array::from_fn(|k| if k < dimensions { -(rows as f64) * spacing } else { -0.5 * spacing });
    let inside = |p: &Vec3| {
        (0..dimensions).all(|k| p[k] > 0.0 && (p[k] < size[k] || (k == up && !lid)))
            || (!lid && p[up] > size[up])
    };
    let points = lattice(corner, counts, spacing).into_iter().filter(|p| !inside(p)).collect();
    Wall { points, motion: None }
}

/// A block of water at rest in the corner of an open basin, heights along the last axis.
pub fn pool(dimensions: usize, water: [f64; 3], basin_size: [f64; 3], spacing: f64) -> Parts {
    let counts: [usize; 3] =
        std::array::from_fn(|k| if k < dimensions { (water[k] / spacing).round() as usize } else { 1 });
    let corner = if dimensions == 2 { [0.0, 0.0, -0.5 * spacing] } else { [0.0; 3] };
    let mut gravity = Vec3::zeros();
    gravity[dimensions - 1] = -GRAVITY;
    let height = water[dimensions - 1];
    Parts {
        dimensions,
        spacing,
        positions: lattice(corner, counts, spacing),
        velocities: Vec::new(),
        liquid: Liquid { density: 1000.0, sound_speed: 20.0 * (GRAVITY * height).sqrt() },
        formulation: Formulation::default(),
        gravity,
        start: Start::Hydrostatic,
        walls: vec![basin(dimensions, basin_size, spacing, false)],
        structures: Vec::new(),
        domain: None,
        threads: 1,
    }
}

/// Marches to a time and calls after every step; returns the clock.
pub fn march(fluid: &mut Fluid, until: f64, mut each: impl FnMut(&Clock, &Fluid)) -> Clock {
    let mut clock = Clock::start(fluid, 1.0, 1.0, 0.0).unwrap();
    while clock.now.time < until - 1e-9 * until {
        let left = until - clock.now.time;
        clock.step(fluid, left, |_| 1.0).unwrap();
        each(&clock, fluid);
    }
    fluid.within_bounds(explicit_dynamics::Bounds::Motion).unwrap();
    fluid.within_bounds(explicit_dynamics::Bounds::Configuration).unwrap();
    clock
}

/// Moves particles by up to a part of the spacing and gives them velocities of such a size, the same on every machine.
pub fn disorder(parts: &mut Parts, part: f64, speed: f64) {
    let mut state = 1_u64;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
    };
    parts.velocities = vec![Vec3::zeros(); parts.positions.len()];
    for (position, velocity) in parts.positions.iter_mut().zip(&mut parts.velocities) {
        for k in 0..parts.dimensions {
            position[k] += part * parts.spacing * next();
            velocity[k] = 2.0 * speed * next();
        }
    }
}

/// Marches with records at equal intervals.
pub fn recorded(fluid: &mut Fluid, duration: f64, record_every: f64) -> Vec<Record> {
    let run = Transient { duration, record_every, damping: 0.0, safety: 1.0 };
    let (mut records, mut march) = (Vec::new(), March::start(run, fluid).unwrap());
    while let Some(record) = march.next_record(fluid).unwrap() {
        records.push(record);
    }
    records
}
