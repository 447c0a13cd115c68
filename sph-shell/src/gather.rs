//! Where the forces of the points on each particle lie: the transpose of the stencils, four particles at a time.
//!
//! The sweep writes the force of each (point, particle) pair into a slot of its own. A particle adds up its slots in
//! ascending order of packs, entries and lanes, so the result does not depend on threads.

use std::ops::Range;

use shell_kinematics::LANES;
use sph_core::SamplingOperator;

use crate::packs::{Packs, Row};
use crate::registers::Fours;

/// Slots of particles in ascending order; four particles have lists of one length, filled up with a slot of zeros.
#[derive(Clone, Debug)]
pub(crate) struct Gather {
    /// First list entry of each four particles, and the end.
    offsets: Vec<u32>,
    /// One slot of each of four particles.
    slots: Vec<[u32; LANES]>,
}

impl Gather {
    /// Lists of some particles, from the places `(pack, entry, lane)` of each and the slot of a place; `zero` is a slot
    /// that holds nothing.
    pub fn new(places: &Places, particles: Range<usize>, slot: impl Fn(Place) -> usize, zero: usize) -> Self {
        let mut lists = Self { offsets: vec![0], slots: Vec::new() };
        for a in particles.clone().step_by(LANES) {
            let of: [&[Place]; LANES] =
                std::array::from_fn(|lane| if a + lane < particles.end { places.of(a + lane) } else { &[] });
            let most = of.iter().map(|places| places.len()).max().unwrap_or(0);
            for k in 0..most {
                lists.slots.push(of.map(|places| places.get(k).map_or(zero, |&place| slot(place)) as u32));
            }
            lists.offsets.push(lists.slots.len() as u32);
        }
        lists
    }

    /// Adds the slots of the four particles of a group to their rows, in halves.
    #[inline(always)]
    pub fn add<R: Fours>(
        &self,
        registers: R,
        group: usize,
        slots: &[Row],
        mut sums: [[R::Numbers; 2]; LANES],
    ) -> [[R::Numbers; 2]; LANES] {
        for four in &self.slots[self.offsets[group] as usize..self.offsets[group + 1] as usize] {
            for lane in 0..LANES {
                let [low, high] = registers.halves(&slots[four[lane] as usize]);
                sums[lane][0] += low;
                sums[lane][1] += high;
            }
        }
        sums
    }

    /// The slots of one particle, where its list is filled up the slot of zeros.
    pub fn of(&self, particle: usize) -> impl Iterator<Item = u32> + '_ {
        let (group, lane) = (particle / LANES, particle % LANES);
        self.slots[self.offsets[group] as usize..self.offsets[group + 1] as usize]
            .iter()
            .map(move |four| four[lane])
    }

    /// Bytes of the lists.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.offsets[..]) + size_of_val(&self.slots[..])
    }
}

/// A particle's place in a stencil: pack, entry (0 the base) and lane; ordered as particles add up their forces.
pub(crate) type Place = (u32, u16, u8);

/// The places of every particle.
pub(crate) struct Places {
    offsets: Vec<u32>,
    places: Vec<Place>,
}

impl Places {
    /// The places that the particles of an operator have in its packs; lanes that only fill up the last pack are none.
    pub fn new(packs: &Packs, operator: &SamplingOperator) -> Self {
        let mut owned: Vec<(u32, Place)> = Vec::with_capacity(operator.particles.len());
        let points = packs.order.iter().flatten().take(operator.points.len());
        for (number, &point) in points.enumerate() {
            let (pack, lane) = ((number / LANES) as u32, (number % LANES) as u8);
            for (entry, &particle) in operator.stencil(point as usize).particles.iter().enumerate() {
                owned.push((particle, (pack, entry as u16, lane)));
            }
        }
        owned.sort_unstable();
        let mut offsets = vec![0; operator.particle_count + 1];
        for &(particle, _) in &owned {
            offsets[particle as usize + 1] += 1;
        }
        for i in 0..operator.particle_count {
            offsets[i + 1] += offsets[i];
        }
        Self { offsets, places: owned.into_iter().map(|(_, place)| place).collect() }
    }

    /// The places of one particle, ascending.
    pub fn of(&self, particle: usize) -> &[Place] {
        &self.places[self.offsets[particle] as usize..self.offsets[particle + 1] as usize]
    }
}
