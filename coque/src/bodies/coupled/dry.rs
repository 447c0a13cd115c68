//! Faces of shells that a scene leaves dry, and water at them: it feels no shell there, and goes through.

use explicit_dynamics::{BoundaryState, ThinLayout};
use sph_core::{CellList, Vec3};

use crate::scene::WetFaces;

/// Distance from a dry face up to which water stands at it, in spacings of the fluid: half of one where it touches, and no wall fits in
/// between.
const AT_FACE: f64 = 1.0;
/// Way along a face from the nearest of its columns, a spacing apart, beyond which a place lies past an edge, in spacings.
const PAST_EDGE: f64 = 0.75;

/// A shell of which one face is dry.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dry {
    /// Its number among the structures.
    pub structure: usize,
    /// Which of its faces is dry: one along the normals, minus one against them.
    side: f64,
    thickness: f64,
    /// Spacing of the fluid \[L\].
    spacing: f64,
    dimensions: usize,
    /// When water was first found at the face \[T\], negative before; and the most particles of it.
    pub since: f64,
    pub most: f64,
}

impl Dry {
    /// The dry face of a structure that shows one face only.
    pub fn new(
        structure: usize,
        wet: WetFaces,
        thin: Option<&ThinLayout>,
        spacing: f64,
        dimensions: usize,
    ) -> Option<Self> {
        let side = match wet {
            WetFaces::Both => return None,
            WetFaces::Front => -1.0,
            WetFaces::Back => 1.0,
        };
        let thickness = thin?.thickness;
        Some(Self { structure, side, thickness, spacing, dimensions, since: -1.0, most: 0.0 })
    }

    /// Its name in a scene.
    pub fn word(&self) -> &'static str {
        if self.side > 0.0 { "front" } else { "back" }
    }

    /// Particles of a fluid at the dry face, and at the wet one.
    pub fn beside(&self, state: &BoundaryState, fluid: &[Vec3]) -> [usize; 2] {
        let plane = |x: &[f64; 3]| Vec3::new(x[0], x[1], if self.dimensions == 2 { 0.0 } else { x[2] });
        let middle: Vec<Vec3> = state.middle.iter().map(plane).collect();
        let normals: Vec<Vec3> = state.normals.iter().map(plane).collect();
        let across = 0.5 * self.thickness + AT_FACE * self.spacing;
        let along = PAST_EDGE * self.spacing;
        let reach = libm::hypot(across, along);
        let (low, high) = corners(&middle);
        let list = CellList::new(&middle, reach);
        let (mut found, mut count) = (Vec::new(), [0; 2]);
        for x in fluid {
            if (0..3).any(|k| x[k] < low[k] - reach || x[k] > high[k] + reach) {
                continue;
            }
            list.within(x, reach, &mut found);
            let square = |&place: &u32| (x - middle[place as usize]).norm_squared();
            let Some(place) = found.iter().copied().min_by(|a, b| square(a).total_cmp(&square(b))) else {
                continue;
            };
            let (away, normal) = (x - middle[place as usize], normals[place as usize]);
            let height = away.dot(&normal);
            if height.abs() <= across && (away - normal * height).norm() <= along {
                count[usize::from(self.side * height < 0.0)] += 1;
            }
        }
        count
    }

    /// Keeps what a look at a time found.
    pub fn keep(&mut self, time: f64, particles: usize) {
        if particles > 0 && self.since < 0.0 {
            self.since = time;
        }
        self.most = self.most.max(particles as f64);
    }
}

/// Least and greatest coordinates.
pub(super) fn corners(points: &[Vec3]) -> (Vec3, Vec3) {
    let none = (Vec3::repeat(f64::INFINITY), Vec3::repeat(f64::NEG_INFINITY));
    points.iter().fold(none, |(low, high), x| (low.inf(x), high.sup(x)))
}
