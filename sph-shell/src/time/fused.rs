//! The whole step in one sweep: points block by block, each particle as soon as its last point is done.
//!
//! Slots live in a ring just long enough for the particles under way, so they stay in the cache: a step moves
//! about half the memory of two passes over all points and all particles. The new state is written beside the
//! old one, which all points read. Each thread owns a range of particles and sweeps every point that touches
//! it; points on a border are swept twice. Every particle adds the same slots in the same order as in two
//! passes: the bits are the same, for any number of threads (tested).

use std::ops::Range;

use explicit_dynamics::Work;
use shell_kinematics::LANES;

use crate::dispatch::{Work as Sweeping, widest};
use crate::packs::{PARTICLE_CHUNK, Packs, Row};
use crate::points::sweep::Sweep;
use crate::registers::Registers;
use crate::time::particle::{Slots, Update, put};

/// Packs swept before the particles they complete are moved on: 64 points.
const BLOCK: usize = 16;

/// The plan of a fused step, and the buffers it needs.
#[derive(Clone, Debug)]
pub(crate) struct Fused {
    parts: Vec<Part>,
    /// State at the end of the step, before it takes the place of the old one.
    pub next: Vec<Row>,
}

/// One thread's share.
#[derive(Clone, Debug)]
struct Part {
    particles: Range<usize>,
    packs: Range<usize>,
    /// For each block of packs the particle up to which all are complete when the block is done.
    ready: Vec<u32>,
    ring: Vec<Row>,
}

impl Fused {
    /// Plans a step for stencils of four particles (cells); others have no plan.
    pub fn plan(packs: &Packs, particles: usize, threads: usize) -> Option<Self> {
        let rows = packs.points.first()?.slot_count();
        if packs.points.iter().any(|pack| pack.slot_count() != rows) || !rows.is_power_of_two() {
            return None;
        }
        let chunks = particles.div_ceil(PARTICLE_CHUNK);
        let border = |part: usize| (chunks * part / threads * PARTICLE_CHUNK).min(particles);
        let parts =
            (0..threads).map(|part| Part::plan(packs, border(part)..border(part + 1), rows)).collect();
        Some(Self { parts, next: vec![[0.0; 6]; particles] })
    }

    /// Sweeps all points and moves all particles on, into `next`, with the work of every chunk.
    pub fn run(&mut self, sweep: &Sweep<'_>, update: &Update<'_>, rates: &mut [Row], work: &mut [Work]) {
        run_parts(sweep, update, &mut self.parts, &mut self.next, rates, work);
    }

    /// Bytes of rings and of the second state.
    pub fn bytes(&self) -> usize {
        let rings: usize = self.parts.iter().map(|part| size_of_val(&part.ring[..])).sum();
        rings + size_of_val(&self.next[..])
    }
}

impl Part {
    fn plan(packs: &Packs, particles: Range<usize>, rows: usize) -> Self {
        let pack_of = |slot: u32| slot as usize / rows;
        let slots =
            &packs.slots[packs.offsets[particles.start] as usize..packs.offsets[particles.end] as usize];
        let first = slots.iter().map(|&s| pack_of(s)).min().unwrap_or(0);
        let end = slots.iter().map(|&s| pack_of(s) + 1).max().unwrap_or(first);
        let blocks = (end - first).div_ceil(BLOCK);
        let mut ready = vec![particles.start as u32; blocks];
        let (mut block, mut longest) = (0, 0);
        // Four at a time, in order: none before those in front of it.
        for a in particles.clone().step_by(LANES) {
            let four = a..(a + LANES).min(particles.end);
            let (mut lowest, mut highest) = (end, first);
            for &slot in four.clone().flat_map(|a| packs.slots_of(a)) {
                (lowest, highest) = (lowest.min(pack_of(slot)), highest.max(pack_of(slot)));
            }
            if lowest <= highest {
                block = block.max((highest - first) / BLOCK);
                let swept = (first + (block + 1) * BLOCK).min(end);
                longest = longest.max(swept - lowest);
            }
            ready[block] = four.end as u32;
        }
        for b in 1..blocks {
            ready[b] = ready[b].max(ready[b - 1]);
        }
        let ring = vec![[0.0; 6]; (longest * rows).next_power_of_two()];
        Self { particles, packs: first..end, ready, ring }
    }
}

/// One thread's sweep.
struct Run<'a, 'b> {
    sweep: &'b Sweep<'a>,
    update: &'b Update<'a>,
    part: &'b mut Part,
    next: &'b mut [Row],
    rates: &'b mut [Row],
    work: &'b mut [Work],
}

impl Run<'_, '_> {
    fn blocks(self) {
        let Self { sweep, update, part, next, rates, work } = self;
        let Part { particles, packs, ready, ring } = part;
        let mask = ring.len() - 1;
        let first = particles.start;
        work.fill(Work::default());
        let mut done = first;
        for (block, &ready) in ready.iter().enumerate() {
            let start = packs.start + block * BLOCK;
            let packs = start..(start + BLOCK).min(packs.end);
            widest(Points { sweep, packs, ring, mask });
            let particles = done..ready as usize;
            let own = done - first..ready as usize - first;
            widest(Particles {
                update,
                state: sweep.state,
                slots: Slots { rows: ring, mask },
                first,
                particles,
                next: &mut next[own.clone()],
                rates: &mut rates[own],
                work,
            });
            done = ready as usize;
        }
    }
}

/// A block of points on its way through the sweep.
struct Points<'a, 'b> {
    sweep: &'b Sweep<'a>,
    packs: Range<usize>,
    ring: &'b mut [Row],
    mask: usize,
}

impl Sweeping for Points<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run<R: Registers>(self, registers: R) {
        self.sweep.block(registers, self.packs, self.ring, self.mask);
    }
}

/// The particles that a block has completed.
struct Particles<'a, 'b> {
    update: &'b Update<'a>,
    state: &'b [Row],
    slots: Slots<'b>,
    /// First particle of the part, from which chunks of work are counted.
    first: usize,
    particles: Range<usize>,
    next: &'b mut [Row],
    rates: &'b mut [Row],
    work: &'b mut [Work],
}

impl Particles<'_, '_> {
    #[inline(always)]
    fn all<const LOADED: bool, R: Registers>(self, registers: R) {
        let Self { update, state, slots, first, particles, next, rates, work } = self;
        let rows = state[particles.clone()].chunks(LANES);
        let groups = rows.zip(next.chunks_mut(LANES)).zip(rates.chunks_mut(LANES));
        for (a, ((rows, next), rates)) in particles.step_by(LANES).zip(groups) {
            let tally = &mut work[(a - first) / PARTICLE_CHUNK];
            let [places, kicked] = update.four::<true, LOADED, R>(registers, a, rows, rates, slots, tally);
            put(next, &places);
            put(rates, &kicked);
        }
    }
}

impl Sweeping for Particles<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run<R: Registers>(self, registers: R) {
        if self.update.external.is_empty() {
            self.all::<false, R>(registers)
        } else {
            self.all::<true, R>(registers)
        }
    }
}

/// All parts, halved until each thread has one.
fn run_parts(
    sweep: &Sweep<'_>,
    update: &Update<'_>,
    parts: &mut [Part],
    next: &mut [Row],
    rates: &mut [Row],
    work: &mut [Work],
) {
    match parts {
        [] => {}
        [part] => Run { sweep, update, part, next, rates, work }.blocks(),
        _ => {
            let half = parts.len() / 2;
            let cut = parts[half].particles.start - parts[0].particles.start;
            let (left, right) = parts.split_at_mut(half);
            let (left_next, right_next) = next.split_at_mut(cut);
            let (left_rates, right_rates) = rates.split_at_mut(cut);
            let (left_work, right_work) = work.split_at_mut(cut / PARTICLE_CHUNK);
            rayon::join(
                || run_parts(sweep, update, left, left_next, left_rates, left_work),
                || run_parts(sweep, update, right, right_next, right_rates, right_work),
            );
        }
    }
}
