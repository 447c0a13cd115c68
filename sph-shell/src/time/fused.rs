//! Cells in one sweep: points block by block, each particle as soon as its last point is done.
//!
//! Slots live in a ring just long enough for the particles under way, so they stay in the cache: a step moves
//! about half the memory of two passes over all points and all particles. The new state is written beside the
//! old one, which all points read. Each thread owns a range of particles and sweeps every point that touches
//! it; points on a border are swept twice. Every particle adds the same slots in the same order whatever the
//! ranges: the bits are the same for any number of threads (tested).
//!
//! The same sweep finds forces without a step: then particles keep the sum of their slots.

use std::ops::Range;

use explicit_dynamics::Work;
use shell_kinematics::LANES;

use crate::dispatch::{WideWork, fullest};
use crate::gather::{Gather, Places};
use crate::packs::{Packs, Row};
use crate::points::ring::Ring;
use crate::points::sweep::Sweep;
use crate::registers::{Fours, Registers};
use crate::time::particle::{Rows, Slots, Update};

/// Packs swept before the particles they complete are moved on: 64 points.
const BLOCK: usize = 16;

/// The plan of a sweep, with its rings.
#[derive(Clone, Debug)]
pub(crate) struct Fused {
    /// Those with particles that others need, which come first.
    border: Vec<Part>,
    parts: Vec<Part>,
    /// The first particle of all.
    first: usize,
    /// Whether parts go to several threads.
    split: bool,
}

/// One thread's share.
#[derive(Clone, Debug)]
struct Part {
    particles: Range<usize>,
    packs: Range<usize>,
    /// For each block of packs the particle up to which all are complete when the block is done.
    ready: Vec<u32>,
    ring: Ring,
    /// Where in the ring the forces on each particle lie.
    lists: Gather,
    /// Energy of each pack, filled on request \[F L\].
    energies: Vec<f64>,
}

/// What is done with particles as their forces are complete.
trait Task: Sized + Send {
    /// Those before and after a particle, counted from the first.
    fn split(self, at: usize) -> (Self, Self);

    /// Takes a range of particles, whose forces lie in `slots`; `first` is the first of all.
    fn take<const P: usize, R: Registers<P>>(
        &mut self,
        registers: R,
        particles: Range<usize>,
        first: usize,
        slots: Slots<'_>,
    );
}

/// Particles are moved, with the work of every chunk.
struct Move<'a> {
    update: &'a Update<'a>,
    rows: Rows<'a>,
    work: &'a mut [Work],
}

/// Particles keep their forces.
struct Keep<'a>(&'a mut [Row]);

impl Fused {
    /// Plans the sweep over cells for a range of particles and its interior, in whole chunks: what is before and behind the interior comes first.
    pub fn plan(packs: &Packs, places: &Places, [own, interior]: [Range<usize>; 2], threads: usize) -> Self {
        let chunks = interior.len().div_ceil(parallel::CHUNK);
        let seam =
            |part: usize| (interior.start + chunks * part / threads * parallel::CHUNK).min(interior.end);
        let ends = [own.start..interior.start, interior.end..own.end];
        let ends = ends.into_iter().filter(|end| !end.is_empty());
        Self {
            border: ends.map(|end| Part::plan(packs, places, end)).collect(),
            parts: (0..threads).map(|part| Part::plan(packs, places, seam(part)..seam(part + 1))).collect(),
            first: own.start,
            split: threads > 1,
        }
    }

    fn all(&self) -> impl Iterator<Item = &Part> {
        self.border.iter().chain(&self.parts)
    }

    /// The packs that are swept, a range that holds them.
    pub fn packs(&self) -> Range<usize> {
        let parts = || self.all().filter(|part| !part.packs.is_empty());
        let first = parts().map(|part| part.packs.start).min().unwrap_or(0);
        first..parts().map(|part| part.packs.end).max().unwrap_or(first)
    }

    /// Sweeps all points and moves all particles on, with the work of every chunk; the new rows are shown when those on the border are done.
    pub fn advance(
        &mut self,
        sweep: &Sweep<'_>,
        update: &Update<'_>,
        rows: Rows<'_>,
        work: &mut [Work],
        show: impl FnOnce(&[Row]),
    ) {
        work.fill(Work::default());
        let Self { border, parts, first, split } = self;
        let Rows { state, next, rates } = rows;
        let rows = Rows { state, next: &mut *next, rates: &mut *rates };
        run(sweep, border, *first, *split, Move { update, rows, work: &mut *work });
        show(next);
        run(sweep, parts, *first, *split, Move { update, rows: Rows { state, next, rates }, work });
    }

    /// Sweeps all points for the forces on all particles.
    pub fn forces(&mut self, sweep: &Sweep<'_>, forces: &mut [Row]) {
        let Self { border, parts, first, split } = self;
        run(sweep, border, *first, *split, Keep(&mut *forces));
        run(sweep, parts, *first, *split, Keep(forces));
    }

    /// Energy of a pack, by the last sweep that was asked for it \[F L\]; packs on a border have the same in both parts.
    pub fn energy(&self, pack: usize) -> f64 {
        let part = self.all().find(|part| part.packs.contains(&pack));
        part.map_or(0.0, |part| part.energies[pack - part.packs.start])
    }

    /// Bytes of rings and lists.
    pub fn bytes(&self) -> usize {
        let part = |part: &Part| part.ring.bytes() + part.lists.bytes() + size_of_val(&part.energies[..]);
        self.all().map(part).sum()
    }
}

impl Part {
    fn plan(packs: &Packs, places: &Places, particles: Range<usize>) -> Self {
        let touched = || particles.clone().flat_map(|a| places.of(a)).map(|place| place.0 as usize);
        let first = touched().min().unwrap_or(0);
        let end = touched().max().map_or(first, |last| last + 1);
        let blocks = (end - first).div_ceil(BLOCK);
        let mut ready = vec![particles.start as u32; blocks];
        let (mut block, mut longest) = (0, 1);
        // Four at a time, in order: none before those in front of it.
        for a in particles.clone().step_by(LANES) {
            let four = a..(a + LANES).min(particles.end);
            let (mut lowest, mut highest) = (end, first);
            for place in four.clone().flat_map(|a| places.of(a)) {
                let pack = place.0 as usize;
                (lowest, highest) = (lowest.min(pack), highest.max(pack));
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
        let ring = Ring::new(packs, first, longest);
        let lists = Gather::new(places, particles.clone(), |place| ring.slot(place), ring.zero());
        Self { particles, packs: first..end, ready, ring, lists, energies: vec![0.0; end - first] }
    }

    /// Sweeps the part's packs and hands its particles to the task.
    fn run<T: Task>(&mut self, sweep: &Sweep<'_>, mut task: T) {
        let Self { particles, packs, ready, ring, lists, energies } = self;
        let mut done = particles.start;
        for (block, &ready) in ready.iter().enumerate() {
            let start = packs.start + block * BLOCK;
            let block = start..(start + BLOCK).min(packs.end);
            let energies = &mut energies[block.start - packs.start..block.end - packs.start];
            fullest(Points { sweep, packs: block, ring, energies });
            let slots = Slots { rows: ring.rows(), lists, first: particles.start };
            fullest(Particles {
                task: &mut task,
                particles: done..ready as usize,
                first: particles.start,
                slots,
            });
            done = ready as usize;
        }
    }
}

/// A block of points on its way through the sweep.
struct Points<'a, 'b> {
    sweep: &'b Sweep<'a>,
    packs: Range<usize>,
    ring: &'b mut Ring,
    energies: &'b mut [f64],
}

impl WideWork for Points<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run<const P: usize, R: Registers<P>>(self, registers: R) {
        self.sweep.block(registers, self.packs, self.ring, self.energies);
    }
}

/// The particles that a block has completed.
struct Particles<'b, T> {
    task: &'b mut T,
    particles: Range<usize>,
    first: usize,
    slots: Slots<'b>,
}

impl<T: Task> WideWork for Particles<'_, T> {
    type Output = ();

    #[inline(always)]
    fn run<const P: usize, R: Registers<P>>(self, registers: R) {
        self.task.take(registers, self.particles, self.first, self.slots);
    }
}

impl Task for Move<'_> {
    fn split(self, at: usize) -> (Self, Self) {
        let Self { update, rows: Rows { state, next, rates }, work } = self;
        let (next, rates) = (next.split_at_mut(at), rates.split_at_mut(at));
        let work = work.split_at_mut(at / parallel::CHUNK);
        (
            Self { update, rows: Rows { state, next: next.0, rates: rates.0 }, work: work.0 },
            Self { update, rows: Rows { state, next: next.1, rates: rates.1 }, work: work.1 },
        )
    }

    #[inline(always)]
    fn take<const P: usize, R: Registers<P>>(
        &mut self,
        registers: R,
        particles: Range<usize>,
        first: usize,
        slots: Slots<'_>,
    ) {
        let own = particles.start - first..particles.end - first;
        let rows = Rows {
            state: self.rows.state,
            next: &mut self.rows.next[own.clone()],
            rates: &mut self.rows.rates[own],
        };
        self.update.run::<true, P, R>(registers, particles, first, rows, Some(slots), self.work);
    }
}

impl Task for Keep<'_> {
    fn split(self, at: usize) -> (Self, Self) {
        let (left, right) = self.0.split_at_mut(at);
        (Self(left), Self(right))
    }

    #[inline(always)]
    fn take<const P: usize, R: Registers<P>>(
        &mut self,
        registers: R,
        particles: Range<usize>,
        first: usize,
        slots: Slots<'_>,
    ) {
        let own = particles.start - first..particles.end - first;
        let registers = registers.single();
        let zeros = [[registers.splat(0.0); 2]; LANES];
        for (i, forces) in self.0[own].chunks_mut(LANES).enumerate() {
            let group = (particles.start - first) / LANES + i;
            let sums = slots.lists.add(registers, group, slots.rows, zeros);
            let [sums] = registers.rows(registers.turned(sums));
            forces.copy_from_slice(&sums[..forces.len()]);
        }
    }
}

/// Parts, ascending, with a task that counts from some particle; halved until each thread has one where they are split between threads.
fn run<T: Task>(sweep: &Sweep<'_>, parts: &mut [Part], first: usize, split: bool, task: T) {
    let half = parts.len() / 2;
    match parts {
        [] => {}
        [part] => part.run(sweep, task.split(part.particles.start - first).1),
        _ => {
            let cut = parts[half].particles.start;
            let (left, right) = parts.split_at_mut(half);
            let (left_task, right_task) = task.split(cut - first);
            let left = || run(sweep, left, first, split, left_task);
            let right = || run(sweep, right, cut, split, right_task);
            if split {
                rayon::join(left, right);
            } else {
                left();
                right();
            }
        }
    }
}
