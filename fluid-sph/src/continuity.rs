//! The rate of density: `dρ_a/dt = Σ_b m F_ab v_ab·r_ab` over all neighbours, and its diffusion over those of the fluid.

use sph_core::lanes::{Lanes, Sweep};

use crate::cells::Grid;
use crate::diffusion::Diffusion;
use crate::gather::{Pairs, Room, gather};
use crate::kernel::Wendland;
use crate::pair::Shape;
use crate::row::{Four, Row};
use crate::sorted::Sorted;
use crate::walk::Walk;

/// What pairs need beside themselves.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Continuity {
    pub kernel: Wendland,
    /// Mass of a particle \[M\].
    pub mass: f64,
    pub diffusion: Diffusion,
}

/// Numbers of all pairs, in lanes.
struct Constants<L: Lanes> {
    shape: Shape<L>,
    rest: [L::Four; 3],
}

impl<L: Lanes> Clone for Constants<L> {
    fn clone(&self) -> Self {
        *self
    }
}
impl<L: Lanes> Copy for Constants<L> {}

impl<L: Lanes> Constants<L> {
    #[inline(always)]
    fn new(lanes: L, Continuity { kernel, diffusion, .. }: &Continuity) -> Self {
        let [x, y, z] = diffusion.rest;
        Self { shape: Shape::new(lanes, kernel), rest: [lanes.splat(x), lanes.splat(y), lanes.splat(z)] }
    }
}

/// The sum over the neighbours of one particle, without the factors of all pairs; `DIFFUSED` those that exchange density.
struct Rate<L: Lanes, const D: usize, const DIFFUSED: bool> {
    constants: Constants<L>,
    own: Four<L>,
    divergence: L::Four,
    exchange: L::Four,
}

impl<L: Lanes, const D: usize, const DIFFUSED: bool> Rate<L, D, DIFFUSED> {
    #[inline(always)]
    fn new(lanes: L, constants: Constants<L>, row: &Row) -> Self {
        let zero = constants.shape.zero;
        Self { constants, own: Four::all(lanes, row), divergence: zero, exchange: zero }
    }
}

impl<L: Lanes, const D: usize, const DIFFUSED: bool> Pairs<L> for Rate<L, D, DIFFUSED> {
    #[inline(always)]
    fn add(&mut self, lanes: L, four: Four<L>) {
        let Constants { shape, rest } = self.constants;
        let pair = shape.pair::<D>(lanes, &self.own, &four);
        self.divergence = lanes.add(self.divergence, lanes.mul(pair.slope, pair.closing));
        if DIFFUSED {
            let densities = lanes.add(self.own.density, four.density);
            let volume = lanes.mul(lanes.add(pair.square, shape.eta2), densities);
            let level = lanes.dot::<D>(&rest, &pair.way);
            let excess = lanes.add(lanes.sub(four.density, self.own.density), level);
            let share = lanes.mul(lanes.mul(pair.slope, pair.square), excess);
            self.exchange = lanes.add(self.exchange, lanes.div(share, volume));
        }
    }
}

/// Rates of density of a chunk of sorted particles.
pub(crate) struct Rates<'a, 'b, const D: usize> {
    pub continuity: &'a Continuity,
    pub grid: &'a Grid,
    /// The particles themselves.
    pub of: &'a Sorted,
    /// First slot of the chunk.
    pub first: usize,
    /// Neighbours of their own kind if they count, for walls see the fluid only; and of the other kind.
    pub sets: [Option<&'a Sorted>; 2],
    /// By slot of the chunk: rate, and what diffusion adds to it \[M/(L³ T)\].
    pub out: &'b mut [[f64; 2]],
}

impl<const D: usize> Sweep for Rates<'_, '_, D> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) {
        let Self { continuity, grid, of, first, sets, out } = self;
        let Continuity { kernel, mass, diffusion } = continuity;
        let constants = Constants::new(lanes, continuity);
        let (factor, strength) = (mass * kernel.slope, diffusion.strength);
        let mut walk = Walk::new(grid, of, first, sets, kernel.reach());
        let mut room = Room::new();
        for (slot, out) in (first..).zip(out) {
            walk.go(slot, &mut room);
            *out = [0.0; 2];
            if let Some(search) = walk.own(slot) {
                if strength != 0.0 {
                    let mut rate = Rate::<L, D, true>::new(lanes, constants, &of.rows[slot]);
                    gather::<L, _, D>(lanes, search, &mut room, &mut rate);
                    *out = [
                        factor * lanes.total(rate.divergence),
                        -strength * factor * lanes.total(rate.exchange),
                    ];
                } else {
                    let mut rate = Rate::<L, D, false>::new(lanes, constants, &of.rows[slot]);
                    gather::<L, _, D>(lanes, search, &mut room, &mut rate);
                    out[0] = factor * lanes.total(rate.divergence);
                }
            }
            if let Some(search) = walk.other(slot) {
                let mut rate = Rate::<L, D, false>::new(lanes, constants, &of.rows[slot]);
                gather::<L, _, D>(lanes, search, &mut room, &mut rate);
                out[0] += factor * lanes.total(rate.divergence);
            }
        }
    }
}
