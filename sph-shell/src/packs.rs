//! Layout of the sampling points for the sweep: four points a pack, constants in one stream.
//!
//! Stencils are stored in difference form: the first particle of a stencil is its base, and the
//! other entries act on `x_k − x_base`. Translation then costs nothing, to the last bit, and the
//! forces of a point sum to zero exactly. Each (point, particle) pair owns a slot into which the
//! sweep writes its force; particles add up their slots in ascending order, so the result does not
//! depend on threads.

use shell_kinematics::{LANES, Measures, Pack};
use sph_core::SamplingOperator;

/// Position and director of a particle, or the forces on them: `[x, y, z, d_x, d_y, d_z]`.
pub(crate) type Row = [f64; 6];

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

/// All packs, and for each particle the slots it adds up.
#[derive(Clone, Debug)]
pub(crate) struct Packs {
    pub points: Vec<PointPack>,
    pub entries: Vec<Entry>,
    /// Sampling point in each lane of each pack.
    pub order: Vec<[u32; LANES]>,
    /// First slot of each particle in `slots`, and the end.
    pub offsets: Vec<u32>,
    /// Slot numbers, ascending for each particle.
    pub slots: Vec<u32>,
}

impl PointPack {
    /// First slot of pack number `index`.
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
            offsets: Vec::new(),
            slots: Vec::new(),
        };
        for lanes in order.chunks(LANES) {
            packs.push(operator, lanes);
        }
        packs.find_slots(operator);
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

    /// The transpose: which slots belong to each particle.
    fn find_slots(&mut self, operator: &SamplingOperator) {
        let mut owned: Vec<(u32, u32)> = Vec::with_capacity(operator.particles.len());
        let mut point = 0;
        for (index, pack) in self.points.iter().enumerate() {
            for lane in 0..LANES {
                // The last pack's filling lanes own no slots.
                if point == operator.points.len() {
                    break;
                }
                point += 1;
                let stencil = operator.stencil(self.order[index][lane] as usize);
                for (k, &particle) in stencil.particles.iter().enumerate() {
                    owned.push((particle, (pack.first_slot(index) + k * LANES + lane) as u32));
                }
            }
        }
        owned.sort_unstable();
        self.offsets = vec![0; operator.particle_count + 1];
        for &(particle, _) in &owned {
            self.offsets[particle as usize + 1] += 1;
        }
        for i in 0..operator.particle_count {
            self.offsets[i + 1] += self.offsets[i];
        }
        self.slots = owned.into_iter().map(|(_, slot)| slot).collect();
    }

    /// Slots altogether.
    pub fn slot_count(&self) -> usize {
        (self.entries.len() + self.points.len()) * LANES
    }

    /// The slots of one particle.
    #[inline(always)]
    pub fn slots_of(&self, particle: usize) -> &[u32] {
        &self.slots[self.offsets[particle] as usize..self.offsets[particle + 1] as usize]
    }
}
