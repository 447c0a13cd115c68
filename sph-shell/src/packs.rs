//! Layout of the sampling points for the sweep: four points a pack, constants in one stream.
//!
//! Stencils are stored in difference form: the first particle of a stencil is its base, and the
//! other entries act on `x_k − x_base`. Translation then costs nothing, to the last bit, and the
//! forces of a point sum to zero exactly.

use shell_kinematics::{LANES, Measures, Pack};
use sph_core::SamplingOperator;

use crate::registers::Registers;

pub(crate) use crate::registers::Row;

/// Particles a chunk of the update sweep; fixed, so that sums do not depend on threads.
pub(crate) const PARTICLE_CHUNK: usize = 512;

/// Points are sorted by the size of their stencil inside blocks of this many, so that packs waste few lanes.
const BLOCK: usize = 64;

/// Constants of four sampling points.
#[derive(Clone, Debug)]
pub(crate) struct PointPack {
    /// First particle of each stencil.
    pub base: [u32; LANES],
    /// First of the pack's entries.
    pub first: u32,
    /// Entries beyond the base.
    pub width: u32,
    /// Areas w_p \[L²\]; zero in lanes that only fill up the last pack.
    pub weight: Pack,
    /// Measures of the reference configuration.
    pub reference: Measures,
}

/// One more particle of each of four stencils.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    pub particles: [u32; LANES],
    pub phi: Pack,
    pub g1: Pack,
    pub g2: Pack,
}

/// All packs.
#[derive(Clone, Debug)]
pub(crate) struct Packs {
    pub points: Vec<PointPack>,
    pub entries: Vec<Entry>,
    /// Sampling point in each lane of each pack.
    pub order: Vec<[u32; LANES]>,
}

impl Entry {
    /// φ, G₁ and G₂ in registers.
    #[inline(always)]
    pub fn load<R: Registers>(&self, registers: R) -> [R::Four; 3] {
        [registers.load(&self.phi), registers.load(&self.g1), registers.load(&self.g2)]
    }
}

impl PointPack {
    /// First slot of pack number `index` where slots of all packs follow each other.
    pub fn first_slot(&self, index: usize) -> usize {
        (self.first as usize + index) * LANES
    }

    /// Slots of the pack.
    pub fn slot_count(&self) -> usize {
        (self.width as usize + 1) * LANES
    }
}

impl Packs {
    /// Lays out an operator; reference measures are filled in by the caller, who knows the pipeline.
    pub fn new(operator: &SamplingOperator) -> Self {
        let count = operator.points.len();
        let mut order: Vec<u32> = (0..count as u32).collect();
        let size = |p: u32| operator.stencil(p as usize).particles.len();
        for block in order.chunks_mut(BLOCK) {
            block.sort_by_key(|&p| size(p));
        }
        let mut packs = Self {
            points: Vec::with_capacity(count.div_ceil(LANES)),
            entries: Vec::new(),
            order: Vec::with_capacity(count.div_ceil(LANES)),
        };
        for lanes in order.chunks(LANES) {
            packs.push(operator, lanes);
        }
        packs
    }

    fn push(&mut self, operator: &SamplingOperator, points: &[u32]) {
        // Lanes beyond the last point repeat it with no weight.
        let lane_points: [u32; LANES] = std::array::from_fn(|lane| points[lane.min(points.len() - 1)]);
        let stencils = lane_points.map(|p| operator.stencil(p as usize));
        let width = stencils.iter().map(|s| s.particles.len()).max().unwrap_or(1) - 1;
        let first = self.entries.len() as u32;
        for k in 1..=width {
            // Stencils shorter than the pack end in their base with zero for numbers.
            let pick =
                |values: [&[f64]; LANES]| Pack::from_fn(|lane| values[lane].get(k).copied().unwrap_or(0.0));
            self.entries.push(Entry {
                particles: stencils.map(|s| s.particles.get(k).copied().unwrap_or(s.particles[0])),
                phi: pick(stencils.map(|s| s.phi)),
                g1: pick(stencils.map(|s| s.g1)),
                g2: pick(stencils.map(|s| s.g2)),
            });
        }
        self.points.push(PointPack {
            base: stencils.map(|s| s.particles[0]),
            first,
            width: width as u32,
            weight: Pack::from_fn(|lane| {
                if lane < points.len() { operator.points[lane_points[lane] as usize].weight } else { 0.0 }
            }),
            reference: Measures::default(),
        });
        self.order.push(lane_points);
    }

    /// Slots altogether.
    pub fn slot_count(&self) -> usize {
        (self.entries.len() + self.points.len()) * LANES
    }
}
