//! Waters that several march together.

use explicit_dynamics::Amplitude;
use fluid_sph::{Course, Motion, Parts, Rotation, Start, Wall};
use sph_core::Vec3;

use crate::common::{disorder, lattice, pool};

/// A column that falls and runs along the bottom of a basin.
pub fn dam(dimensions: usize, spacing: f64) -> Parts {
    let (water, basin) =
        if dimensions == 2 { ([0.5, 1.0, 0.0], [1.6, 1.0, 0.0]) } else { ([0.4, 0.3, 0.5], [0.9, 0.3, 0.5]) };
    let mut parts = pool(dimensions, water, basin, spacing);
    disorder(&mut parts, 0.2, 0.3);
    // Faster over the sound than a fluid should be, so that particles come far in few steps.
    parts.liquid.sound_speed *= 0.5;
    parts
}

/// A tank that is pushed to and fro, and turned.
pub fn tank(dimensions: usize, spacing: f64) -> Parts {
    let size = if dimensions == 2 { [1.2, 0.4, 0.0] } else { [0.6, 0.3, 0.3] };
    let mut parts = pool(dimensions, size, size.map(|x| 1.2 * x), spacing);
    parts.walls[0].points.iter_mut().for_each(|point| *point -= Vec3::x() * 0.05);
    parts.positions.iter_mut().for_each(|point| *point += Vec3::x() * 0.02);
    parts.start = Start::Uniform;
    let to_and_fro: Course = Amplitude::Table(vec![[0.0, 0.0], [0.1, 1.0], [0.3, -1.0], [0.5, 1.0]]).into();
    let rotation = Rotation {
        centre: Vec3::new(0.5, 0.0, 0.1),
        axis: if dimensions == 2 { Vec3::z() } else { Vec3::y() },
        by: 0.2,
        angle: to_and_fro.clone(),
    };
    parts.walls[0].motion =
        Some(Motion { translation: Some((Vec3::x() * 0.2, to_and_fro)), rotation: Some(rotation) });
    parts
}

/// Blocks that fly through each other's way, without walls; one particle far off, if so, and then ever farther.
pub fn blocks(dimensions: usize, seed: usize, lost: bool) -> Parts {
    let side = |k: usize| 0.2 + 0.1 * ((seed >> k) & 3) as f64;
    let size =
        if dimensions == 2 { [side(0), 2.0 * side(1), 0.0] } else { [side(0), side(1), 0.5 * side(2)] };
    let mut parts = pool(dimensions, size, size, if dimensions == 2 { 0.02 } else { 0.05 });
    parts.walls.clear();
    parts.start = Start::Uniform;
    let count = parts.positions.len();
    let shift = Vec3::new(0.9, 0.13 * seed as f64, 0.0);
    for i in 0..count {
        let other = parts.positions[i] + shift;
        parts.positions.push(other);
    }
    disorder(&mut parts, 0.3, 0.5);
    for (i, velocity) in parts.velocities.iter_mut().enumerate() {
        *velocity += Vec3::x() * if i < count { 2.0 } else { -1.0 };
    }
    if lost {
        parts.positions.push(Vec3::new(-3.0, 40.0, 0.0));
        parts.velocities.push(Vec3::new(-5.0, 8.0, 0.0));
    }
    parts
}

/// Two streams past each other at so much of the speed of sound, so long that each who marches them knows a small part; between walls of
/// which one runs along, if so.
pub fn streams(dimensions: usize, part: f64, walls: bool) -> Parts {
    let spacing = if dimensions == 2 { 0.02 } else { 0.05 };
    let size = [4.0, 0.2, if dimensions == 2 { 0.0 } else { 0.1 }];
    let mut parts = pool(dimensions, size, size, spacing);
    parts.walls.clear();
    parts.start = Start::Uniform;
    parts.gravity = Vec3::zeros();
    disorder(&mut parts, 0.1, 0.1);
    let sound = parts.liquid.sound_speed;
    for (position, velocity) in parts.positions.iter().zip(&mut parts.velocities) {
        velocity.x += part * if position.y > 0.1 { sound } else { -sound };
    }
    if walls {
        let rows = |y: f64| lattice([-1.0, y, -0.5 * spacing], [300, 3, 1], spacing);
        let along = (Vec3::x(), Amplitude::Table(vec![[0.0, 0.0], [1.0, -0.2 * sound]]).into());
        let motion = Some(Motion { translation: Some(along), rotation: None });
        parts.walls.push(Wall { points: rows(-3.0 * spacing), motion });
        parts.walls.push(Wall { points: rows(0.2), motion: None });
    }
    parts
}
