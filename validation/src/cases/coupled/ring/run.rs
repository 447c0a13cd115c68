//! A ring that swings as an oval, empty inside, with a fluid between it and a rigid wall.
//!
//! The fluid starts with the potential flow of the mode, so that no sound is left behind by a start at once:
//!
//! ```text
//! φ = A (r² + b⁴/r²) cos 2θ,   ∂φ/∂r = V cos 2θ at the face of the ring r = R, none at the wall r = b
//! ```

use std::error::Error;
use std::f64::consts::{FRAC_PI_2, TAU};

use fluid_sph::{Liquid, Parts, Start};
use sph_core::Vec3;
use sph_shell::{Shell, WetFaces};

use crate::support::coupled::{ROWS, Strip, coupled, march, water, wetting};

/// Radius of the middle line, thickness, radius of the wall \[m\].
pub const RADIUS: f64 = 1.0;
pub const THICKNESS: f64 = 0.1;
pub const WALL: f64 = 1.5;
/// Speed at the start \[m/s\].
const SPEED: f64 = 1.5e-3;
/// Sound speed: sound goes round the annulus more than six times in a period of the stiffest ring \[m/s\].
const SOUND: f64 = 10.0;
/// Periods that are counted.
const PERIODS: f64 = 2.0;

/// A ring.
#[derive(Clone, Copy, Debug)]
pub struct Ring {
    /// Density of the fluid; none of a dry ring \[kg/m³\].
    pub density: Option<f64>,
    /// Particles of the fluid, and stations of the ring, over a thickness.
    pub layers: usize,
    /// Period to expect \[s\].
    pub period: f64,
}

/// What a run leaves behind.
#[derive(Clone, Debug, Default)]
pub struct Oval {
    /// Time \[s\], half the difference of the ways outwards at 0° and 90° \[mm\], energy missing \[J/m\].
    pub rows: Vec<[f64; 3]>,
    pub particles: usize,
    pub steps: u64,
    pub seconds: f64,
}

impl Oval {
    /// Angular frequency from the first and the last time that the ring goes through its rest on the way
    /// back \[1/s\].
    pub fn frequency(&self) -> Option<f64> {
        let crossings: Vec<f64> = self
            .rows
            .windows(2)
            .skip(1)
            .filter(|pair| pair[0][1] > 0.0 && pair[1][1] <= 0.0)
            .map(|pair| {
                let [a, b] = [pair[0], pair[1]];
                a[0] + (b[0] - a[0]) * a[1] / (a[1] - b[1])
            })
            .collect();
        let (first, last) = (crossings.first()?, crossings.last()?);
        let periods = crossings.len().checked_sub(1).filter(|&n| n > 0)?;
        Some(TAU * periods as f64 / (last - first))
    }
}

fn shell(layers: usize, wet: bool) -> Result<(Shell, f64), Box<dyn Error>> {
    let spacing = THICKNESS / layers as f64;
    // A multiple of four: stations stand at 0° and 90°.
    let count = 4 * (0.25 * TAU * RADIUS / spacing).round() as usize;
    let at = |i: usize| {
        let angle = TAU * i as f64 / count as f64;
        [RADIUS * libm::cos(angle), RADIUS * libm::sin(angle)]
    };
    let strip = Strip {
        line: (0..count).map(at).collect(),
        closed: true,
        young: 1e6,
        poisson: 0.3,
        thickness: THICKNESS,
        density: 1000.0,
        gravity: 0.0,
        held: Vec::new(),
    };
    let width = strip.width();
    let mut shell = strip.builder()?;
    if wet {
        shell = shell.wetted(wetting(spacing, WetFaces::Front, &[]));
    }
    let mut shell = shell.build()?;
    for a in 0..shell.len() {
        let angle = TAU * (a / 2) as f64 / count as f64;
        let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
        let (out, along) = (Vec3::new(cosine, sine, 0.0), Vec3::new(-sine, cosine, 0.0));
        let (c2, s2) = (libm::cos(2.0 * angle), libm::sin(2.0 * angle));
        let rate = along * (1.5 * SPEED / RADIUS * s2);
        shell.set_rate(a, out * (SPEED * c2) - along * (0.5 * SPEED * s2), rate);
    }
    Ok((shell, width))
}

/// Rings of points between two radii, as far apart along a ring as the rings are from each other.
fn rings(from: f64, to: f64, spacing: f64) -> Vec<Vec3> {
    let count = ((to - from) / spacing).round() as usize;
    let ring = |k: usize| {
        let radius = from + (k as f64 + 0.5) * (to - from) / count as f64;
        let points = (TAU * radius / spacing).round() as usize;
        (0..points).map(move |i| {
            let angle = TAU * (i as f64 + 0.5 * (k % 2) as f64) / points as f64;
            Vec3::new(radius * libm::cos(angle), radius * libm::sin(angle), 0.0)
        })
    };
    (0..count).flat_map(ring).collect()
}

/// Velocity of the fluid around the second mode of the ring \[m/s\].
fn potential_flow(at: &Vec3) -> Vec3 {
    let (face, wall) = (RADIUS + 0.5 * THICKNESS, WALL.powi(4));
    let scale = SPEED / (2.0 * face - 2.0 * wall / face.powi(3));
    let (radius, angle) = (libm::hypot(at.x, at.y), libm::atan2(at.y, at.x));
    let (out, along) = (Vec3::new(at.x, at.y, 0.0) / radius, Vec3::new(-at.y, at.x, 0.0) / radius);
    let outward = 2.0 * (radius - wall / radius.powi(3)) * libm::cos(2.0 * angle);
    let around = -2.0 * (radius + wall / radius.powi(3)) * libm::sin(2.0 * angle);
    (out * outward + along * around) * scale
}

fn annulus(density: f64, spacing: f64) -> Parts {
    let wall = rings(WALL, WALL + ROWS as f64 * spacing, spacing);
    let positions = rings(RADIUS + 0.5 * THICKNESS, WALL, spacing);
    let velocities = positions.iter().map(potential_flow).collect();
    Parts {
        liquid: Liquid { density, sound_speed: SOUND },
        velocities,
        gravity: Vec3::zeros(),
        start: Start::Uniform,
        ..water(spacing, positions, SOUND, vec![wall])
    }
}

fn way(shell: &Shell) -> f64 {
    let count = shell.len() / 2;
    let out = |station: usize, angle: f64| {
        let way = shell.displacement(2 * station);
        way.x * libm::cos(angle) + way.y * libm::sin(angle)
    };
    0.5 * (out(0, 0.0) - out(count / 4, FRAC_PI_2))
}

/// Runs the ring.
///
/// # Errors
/// A motion that diverges.
pub fn swing(ring: &Ring) -> Result<Oval, Box<dyn Error>> {
    let started = std::time::Instant::now();
    let spacing = THICKNESS / ring.layers as f64;
    let (mut shell, width) = shell(ring.layers, ring.density.is_some())?;
    let mut found = Oval::default();
    let rows = &mut found.rows;
    // The first way back comes after half a period.
    let times = [(PERIODS + 0.6) * ring.period, ring.period / 200.0];
    if let Some(density) = ring.density {
        let mut system = coupled(annulus(density, spacing), vec![shell])?;
        found.particles = system.fluid().len();
        found.steps = march(&mut system, times, 0.0, |system, record| {
            let way = system.structures().next().map_or(f64::NAN, way);
            rows.push([record.at.time, 1e3 * way, record.balance_error]);
        })?;
    } else {
        found.particles = shell.len();
        found.steps = march(&mut shell, times, 0.0, |shell, record| {
            rows.push([record.at.time, 1e3 * way(shell), record.balance_error / width]);
        })?;
    }
    found.seconds = started.elapsed().as_secs_f64();
    Ok(found)
}
