//! The sweep over all bonds: dilatations, then forces `∂U/∂x`, energy, and which bonds go beyond their limit.
//!
//! A bond of extension e along M pulls its node with `(c e + θ̂ᵢ Dᵢⱼ + θ̂ⱼ Dⱼᵢ) M`, c its stiffness and
//! `θ̂ = (λ − μ) V θ`. Each direction of a bond is worked out at its own node. The extension is the same from both ends to
//! the last bit, and so is the pull: forces sum to zero but for rounding, and a bond breaks at both ends in one step.

use rayon::prelude::*;

use super::network::{LANES, Network, Pack, Row};
use crate::dispatch::widest;

/// Nodes a chunk of the sweep; fixed, so that sums do not depend on threads.
pub(crate) const NODE_CHUNK: usize = 256;
/// Least length of a present bond \[L\]: one that has collapsed pulls nowhere.
const COLLAPSED: f64 = 1e-300;

/// Which bonds may break, and beyond which stretch.
#[derive(Clone, Debug)]
pub(crate) struct Watch {
    /// A bit for each lane of each pack: the bond is whole and may break.
    pub lanes: Vec<u8>,
    /// Greatest stretch.
    pub tension: f64,
    /// Least stretch; −∞ where none breaks under compression.
    pub compression: f64,
}

/// What the sweep works with beside the bonds, by chunks of nodes.
#[derive(Clone, Debug)]
pub(crate) struct Scratch {
    /// `(λ − μ) V θ` of each node; empty without a dilatation.
    dilatations: Vec<f64>,
    /// Energy of each chunk.
    energies: Vec<f64>,
    /// Lanes of packs that go beyond their limit, of each chunk.
    beyond: Vec<Vec<u32>>,
}

impl Scratch {
    pub fn new(network: &Network) -> Self {
        let chunks = network.len().div_ceil(NODE_CHUNK);
        Self {
            dilatations: if network.dilatation.is_some() { vec![0.0; network.len()] } else { Vec::new() },
            energies: vec![0.0; chunks],
            beyond: vec![Vec::new(); chunks],
        }
    }

    /// Lanes `4 · pack + lane` of bonds that went beyond their limit in the last sweep, ascending.
    pub fn beyond(&self) -> impl Iterator<Item = u32> {
        self.beyond.iter().flatten().copied()
    }
}

/// Adds up one chunk of nodes.
struct Chunk<'a, const ENERGY: bool, const WATCH: bool> {
    network: &'a Network,
    rows: &'a [Row],
    first: usize,
    forces: &'a mut [Row],
    watch: Option<&'a Watch>,
    beyond: &'a mut Vec<u32>,
}

/// Four bonds at the present: extension, and components of the direction.
struct Present {
    extension: Pack,
    direction: [Pack; 3],
    dilatation: Pack,
}

#[inline(always)]
fn present(own: &Row, others: &[u32; LANES], lengths: &Pack, rows: &[Row]) -> Present {
    let far: [Row; LANES] = std::array::from_fn(|lane| rows[others[lane] as usize]);
    let mut out = Present { extension: [0.0; LANES], direction: [[0.0; LANES]; 3], dilatation: [0.0; LANES] };
    for lane in 0..LANES {
        let [x, y, z] = [far[lane][0] - own[0], far[lane][1] - own[1], far[lane][2] - own[2]];
        let length = (x * x + y * y + z * z).sqrt().max(COLLAPSED);
        out.extension[lane] = length - lengths[lane];
        out.direction[0][lane] = x / length;
        out.direction[1][lane] = y / length;
        out.direction[2][lane] = z / length;
        out.dilatation[lane] = far[lane][3];
    }
    out
}

impl<const ENERGY: bool, const WATCH: bool> Chunk<'_, ENERGY, WATCH> {
    #[inline(always)]
    fn run(self) -> f64 {
        let Self { network, rows, first, forces, watch, beyond } = self;
        let mut energy = 0.0;
        for (i, force) in forces.iter_mut().enumerate() {
            let node = first + i;
            let own = rows[node];
            let mut sum = [[0.0; LANES]; 3];
            let mut stored = [0.0; LANES];
            for pack in network.packs_of(node) {
                let lengths = &network.lengths[pack];
                let bond = present(&own, &network.others[pack], lengths, rows);
                let stiffness = &network.stiffness[pack];
                let mut pull = [0.0; LANES];
                for lane in 0..LANES {
                    pull[lane] = stiffness[lane] * bond.extension[lane];
                    if ENERGY {
                        stored[lane] += pull[lane] * bond.extension[lane];
                    }
                }
                if let Some(dilatation) = &network.dilatation {
                    let (here, there) = (&dilatation.own[pack], &dilatation.twin[pack]);
                    for lane in 0..LANES {
                        // The sum of the two products first: the same from both ends.
                        pull[lane] += own[3] * here[lane] + bond.dilatation[lane] * there[lane];
                    }
                }
                for axis in 0..3 {
                    for lane in 0..LANES {
                        sum[axis][lane] += pull[lane] * bond.direction[axis][lane];
                    }
                }
                if WATCH && let Some(watch) = watch {
                    let mut any = false;
                    for lane in 0..LANES {
                        let (e, r) = (bond.extension[lane], lengths[lane]);
                        any |= e > watch.tension * r || e < watch.compression * r;
                    }
                    if any {
                        note(watch, pack, &bond.extension, lengths, beyond);
                    }
                }
            }
            // ∂U/∂x of the node is minus the pull of its bonds.
            *force = [-total(&sum[0]), -total(&sum[1]), -total(&sum[2]), 0.0];
            if ENERGY {
                // Half of each bond's energy belongs to each of its ends, and each bond is met at both.
                energy += 0.25 * total(&stored);
                if let Some(dilatation) = &network.dilatation
                    && dilatation.factors[node] != 0.0
                {
                    energy += 0.5 * own[3] * own[3] / dilatation.factors[node];
                }
            }
        }
        energy
    }
}

/// Notes whole bonds of a pack that are beyond their limit.
#[cold]
#[inline(never)]
fn note(watch: &Watch, pack: usize, extension: &Pack, lengths: &Pack, beyond: &mut Vec<u32>) {
    for lane in 0..LANES {
        let (e, r) = (extension[lane], lengths[lane]);
        let over = e > watch.tension * r || e < watch.compression * r;
        if over && watch.lanes[pack] & (1 << lane) != 0 {
            beyond.push((LANES * pack + lane) as u32);
        }
    }
}

#[inline(always)]
fn total(pack: &Pack) -> f64 {
    (pack[0] + pack[1]) + (pack[2] + pack[3])
}

impl<const ENERGY: bool, const WATCH: bool> pulp::NullaryFnOnce for Chunk<'_, ENERGY, WATCH> {
    type Output = f64;

    #[inline(always)]
    fn call(self) -> f64 {
        self.run()
    }
}

/// Dilatations of one chunk of nodes.
struct Dilate<'a> {
    network: &'a Network,
    rows: &'a [Row],
    first: usize,
    out: &'a mut [f64],
}

impl pulp::NullaryFnOnce for Dilate<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self { network, rows, first, out } = self;
        let Some(dilatation) = &network.dilatation else { return };
        for (i, value) in out.iter_mut().enumerate() {
            let node = first + i;
            let mut sum = [0.0; LANES];
            for pack in network.packs_of(node) {
                let bond = present(&rows[node], &network.others[pack], &network.lengths[pack], rows);
                for lane in 0..LANES {
                    sum[lane] += dilatation.own[pack][lane] * bond.extension[lane];
                }
            }
            *value = dilatation.factors[node] * total(&sum);
        }
    }
}

/// What one sweep does.
#[derive(Clone, Copy)]
pub(crate) struct Wanted<'a> {
    /// Whether the stored energy is summed.
    pub energy: bool,
    /// Limits that bonds are held against, if any.
    pub watch: Option<&'a Watch>,
    /// Threads, at least one.
    pub threads: usize,
}

impl Network {
    /// Internal forces `∂U/∂x` of all nodes at the positions in `rows`, whose last places take the dilatations; returns the
    /// stored energy \[F L\], zero unless wanted.
    pub fn evaluate(
        &self,
        rows: &mut [Row],
        forces: &mut [Row],
        scratch: &mut Scratch,
        wanted: Wanted<'_>,
    ) -> f64 {
        if self.dilatation.is_some() {
            self.dilate(rows, &mut scratch.dilatations, wanted.threads);
        }
        match (wanted.energy, wanted.watch.is_some()) {
            (false, false) => self.sweep::<false, false>(rows, forces, scratch, wanted),
            (true, false) => self.sweep::<true, false>(rows, forces, scratch, wanted),
            (false, true) => self.sweep::<false, true>(rows, forces, scratch, wanted),
            (true, true) => self.sweep::<true, true>(rows, forces, scratch, wanted),
        }
        scratch.energies.iter().sum()
    }

    fn dilate(&self, rows: &mut [Row], out: &mut [f64], threads: usize) {
        let chunk = |(number, out): (usize, &mut [f64])| {
            widest(Dilate { network: self, rows, first: number * NODE_CHUNK, out });
        };
        if threads > 1 {
            out.par_chunks_mut(NODE_CHUNK).enumerate().for_each(chunk);
        } else {
            out.chunks_mut(NODE_CHUNK).enumerate().for_each(chunk);
        }
        for (row, value) in rows.iter_mut().zip(out) {
            row[3] = *value;
        }
    }

    fn sweep<const ENERGY: bool, const WATCH: bool>(
        &self,
        rows: &[Row],
        forces: &mut [Row],
        scratch: &mut Scratch,
        wanted: Wanted<'_>,
    ) {
        type Parts<'a> = (usize, ((&'a mut [Row], &'a mut f64), &'a mut Vec<u32>));
        let chunk = |(number, ((forces, energy), beyond)): Parts<'_>| {
            beyond.clear();
            let first = number * NODE_CHUNK;
            *energy = widest(Chunk::<ENERGY, WATCH> {
                network: self,
                rows,
                first,
                forces,
                watch: wanted.watch,
                beyond,
            });
        };
        let Scratch { energies, beyond, .. } = scratch;
        if wanted.threads > 1 {
            forces
                .par_chunks_mut(NODE_CHUNK)
                .zip(energies.par_iter_mut())
                .zip(beyond.par_iter_mut())
                .enumerate()
                .for_each(chunk);
        } else {
            forces
                .chunks_mut(NODE_CHUNK)
                .zip(energies.iter_mut())
                .zip(beyond.iter_mut())
                .enumerate()
                .for_each(chunk);
        }
    }
}
