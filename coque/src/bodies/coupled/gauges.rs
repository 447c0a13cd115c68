//! Where a fluid is looked at beside its particles: points that stay, points that go with walls, sections.

use fluid_sph::{Fluid, Section};
use sph_core::Vec3;

use crate::scene::{Measured, Through};

/// A place of a fluid at which a number is read.
#[derive(Clone, Debug)]
pub(super) enum Gauge {
    /// A point that stays \[L\].
    InSpace(Vec3),
    /// A point that goes with rigid walls.
    OnWalls(Carried),
    /// What flows of some particles through a line or a face.
    Section(Section, Vec<u32>),
}

impl Gauge {
    /// A pressure, a level, a wet length or a flux; no pressure where it is dry.
    pub fn read(&self, of: Measured, fluid: &Fluid) -> f64 {
        match self {
            Self::InSpace(point) => at_point(of, fluid, *point),
            Self::OnWalls(carried) => at_point(of, fluid, carried.place(fluid)),
            Self::Section(section, particles) => fluid.flux(section, particles.iter().map(|&a| a as usize)),
        }
    }
}

/// A pressure, a level or a wet length at a point; no pressure where it is dry.
pub(super) fn at_point(of: Measured, fluid: &Fluid, point: Vec3) -> f64 {
    match of {
        Measured::Level => fluid.level_at(point),
        Measured::WetLength => fluid.wet_length_at(point),
        _ => fluid.pressure_at(point).unwrap_or(0.0),
    }
}

/// The section that a scene describes.
pub(super) fn section(through: &Through) -> Section {
    let bound = |given: Option<[f64; 3]>, none: f64| given.map_or_else(|| Vec3::repeat(none), Vec3::from);
    Section {
        point: through.point.into(),
        normal: Vec3::from(through.normal).normalize(),
        min: bound(through.min, f64::NEG_INFINITY),
        max: bound(through.max, f64::INFINITY),
    }
}

/// A point that goes with rigid walls: its coordinates in a frame on three of their particles, which any motion takes along.
///
/// ```text
/// x = p₀ + Σ_i c_i e_i,    e₁ ∥ p₁ − p₀,   e₂ in the plane of p₂,   e₃ = e₁ × e₂
/// ```
#[derive(Clone, Debug)]
pub(super) struct Carried {
    /// Pieces of walls, and numbers of the particles in them.
    corners: [(usize, usize); 3],
    coordinates: Vec3,
}

impl Carried {
    /// A point with walls whose particles are these, by piece and number; none where they do not span their space, so that
    /// no frame stands on them.
    pub fn new(point: Vec3, particles: &[((usize, usize), Vec3)], dimensions: usize) -> Option<Self> {
        let farthest = |distance: &dyn Fn(&Vec3) -> f64| {
            let greater = |a: &&((usize, usize), Vec3), b: &&((usize, usize), Vec3)| {
                distance(&a.1).total_cmp(&distance(&b.1))
            };
            particles.iter().max_by(greater).copied()
        };
        let first = farthest(&|x| -(x - point).norm_squared())?;
        let second = farthest(&|x| (x - first.1).norm_squared())?;
        let along = (second.1 - first.1).try_normalize(0.0)?;
        let third = farthest(&|x| along.cross(&(x - first.1)).norm_squared())?;
        let frame = frame([first.1, second.1, third.1], dimensions)?;
        let away = point - first.1;
        let coordinates = Vec3::from(frame.map(|axis| axis.dot(&away)));
        Some(Self { corners: [first.0, second.0, third.0], coordinates })
    }

    /// Where it is at present.
    pub fn place(&self, fluid: &Fluid) -> Vec3 {
        let at = |(piece, particle): (usize, usize)| {
            fluid.wall_positions(piece).get(particle).copied().unwrap_or_default()
        };
        let corners = self.corners.map(at);
        let frame = frame(corners, fluid.dimensions()).unwrap_or([Vec3::x(), Vec3::y(), Vec3::z()]);
        corners[0] + frame.iter().zip(&self.coordinates).map(|(axis, c)| axis * *c).sum::<Vec3>()
    }
}

/// Three axes on three points; in a plane the third is across it.
fn frame([first, second, third]: [Vec3; 3], dimensions: usize) -> Option<[Vec3; 3]> {
    let along = (second - first).try_normalize(0.0)?;
    let up = match dimensions {
        2 => Vec3::z(),
        _ => along.cross(&(third - first)).try_normalize(0.0)?,
    };
    Some([along, up.cross(&along), up])
}
