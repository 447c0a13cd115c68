//! Layout of the sampling points for the sweep: four points a pack, equal constants once.
//!
//! Stencils are stored in difference form: the first particle of a stencil is its base, and the
//! other entries act on `x_k − x_base`. Translation then costs nothing, to the last bit, and the
//! forces of a point sum to zero exactly.

use shell_kinematics::{LANES, Measures, Pack};
use sph_core::SamplingOperator;

use crate::shared::{Interned, Shared};

pub(crate) use crate::registers::Row;

/// Points are sorted by the size of their stencil inside blocks of this many, so that packs waste few lanes.
const BLOCK: usize = 64;

/// Stencils of four sampling points, and where their constants are kept.
#[derive(Clone, Debug)]
pub(crate) struct PointPack {
    /// First particle of each stencil.
    pub base: [u32; LANES],
    /// First of the pack's particles beyond the base.
    pub first: u32,
    /// Entries beyond the base.
    pub width: u32,
    /// First of the pack's entries.
    pub entries: u32,
}

/// Constants of four sampling points.
#[derive(Clone, Debug)]
pub(crate) struct Constants {
    /// Areas w_p \[L²\]; zero in lanes that only fill up the last pack.
    pub weight: Pack,
    /// Measures of the reference configuration.
    pub reference: Measures,
}

/// Numbers of one more particle of each of four stencils.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    pub phi: Pack,
    pub g1: Pack,
    pub g2: Pack,
}

/// All packs.
#[derive(Clone, Debug)]
pub(crate) struct Packs {
    pub points: Vec<PointPack>,
    /// Particles beyond the base, entry by entry.
    pub particles: Vec<[u32; LANES]>,
    /// Numbers of entries; stencils with the same numbers share them.
    pub entries: Vec<Entry>,
    pub constants: Shared<Constants>,
    /// Sampling point in each lane of each pack.
    pub order: Vec<[u32; LANES]>,
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
            particles: Vec::with_capacity(operator.particles.len() / LANES),
            entries: Vec::new(),
            constants: Shared::new([], Constants::numbers),
            order: Vec::with_capacity(count.div_ceil(LANES)),
        };
        let mut seen = Interned::default();
        let constants: Vec<Constants> =
            order.chunks(LANES).map(|lanes| packs.push(operator, lanes, &mut seen)).collect();
        packs.keep(constants);
        packs
    }

    /// Keeps the constants of all packs.
    pub fn keep(&mut self, constants: Vec<Constants>) {
        self.constants = Shared::new(constants, Constants::numbers);
    }

    /// Lays out four stencils; returns their constants, measures still to be found.
    fn push(&mut self, operator: &SamplingOperator, points: &[u32], seen: &mut Interned) -> Constants {
        // Lanes beyond the last point repeat it with no weight.
        let lane_points: [u32; LANES] = std::array::from_fn(|lane| points[lane.min(points.len() - 1)]);
        let stencils = lane_points.map(|p| operator.stencil(p as usize));
        let width = stencils.iter().map(|s| s.particles.len()).max().unwrap_or(1) - 1;
        let first = self.particles.len() as u32;
        let mut entries = Vec::with_capacity(width);
        for k in 1..=width {
            // Stencils shorter than the pack end in their base with zero for numbers.
            let pick =
                |values: [&[f64]; LANES]| Pack::from_fn(|lane| values[lane].get(k).copied().unwrap_or(0.0));
            self.particles.push(stencils.map(|s| s.particles.get(k).copied().unwrap_or(s.particles[0])));
            entries.push(Entry {
                phi: pick(stencils.map(|s| s.phi)),
                g1: pick(stencils.map(|s| s.g1)),
                g2: pick(stencils.map(|s| s.g2)),
            });
        }
        let numbers = entries.iter().flat_map(|entry| [entry.phi, entry.g1, entry.g2]);
        let place = seen.place(numbers, self.entries.len() as u32);
        if place as usize == self.entries.len() {
            self.entries.append(&mut entries);
        }
        let base = stencils.map(|s| s.particles[0]);
        self.points.push(PointPack { base, first, width: width as u32, entries: place });
        self.order.push(lane_points);
        Constants {
            weight: Pack::from_fn(|lane| {
                if lane < points.len() { operator.points[lane_points[lane] as usize].weight } else { 0.0 }
            }),
            reference: Measures::default(),
        }
    }

    /// Slots altogether.
    pub fn slot_count(&self) -> usize {
        (self.particles.len() + self.points.len()) * LANES
    }

    /// Bytes of all that a sweep touches.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.points[..])
            + size_of_val(&self.particles[..])
            + size_of_val(&self.entries[..])
            + self.constants.bytes()
    }
}

impl Constants {
    fn numbers(&self) -> impl Iterator<Item = Pack> + use<> {
        let Measures { membrane, curvature, shear } = self.reference;
        membrane.into_iter().chain(curvature).chain(shear).chain([self.weight])
    }
}
