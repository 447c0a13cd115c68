//! The rate of density: `dρ_a/dt = Σ_b m F_ab v_ab·r_ab` over all neighbours, and its diffusion over those of the fluid.

use crate::cells::{Grid, NOWHERE, Ranges};
use crate::diffusion::Diffusion;
use crate::dispatch::Sweep;
use crate::gather::{Pairs, Room, gather};
use crate::kernel::Wendland;
use crate::lanes::Lanes;
use crate::sorted::{Row, Sorted};

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
    half: L::Four,
    slope: L::Four,
    eta2: L::Four,
    strength: L::Four,
    rest: [L::Four; 3],
    one: L::Four,
    zero: L::Four,
}

impl<L: Lanes> Clone for Constants<L> {
    fn clone(&self) -> Self {
        *self
    }
}
impl<L: Lanes> Copy for Constants<L> {}

impl<L: Lanes> Constants<L> {
    #[inline(always)]
    fn new(lanes: L, continuity: &Continuity) -> Self {
        let Continuity { kernel, mass, diffusion } = continuity;
        Self {
            half: lanes.splat(kernel.half),
            slope: lanes.splat(mass * kernel.slope),
            eta2: lanes.splat(kernel.eta2),
            strength: lanes.splat(diffusion.strength),
            rest: [
                lanes.splat(diffusion.rest[0]),
                lanes.splat(diffusion.rest[1]),
                lanes.splat(diffusion.rest[2]),
            ],
            one: lanes.splat(1.0),
            zero: lanes.splat(0.0),
        }
    }
}

/// The sum over the neighbours of one particle; `DIFFUSED` those that exchange density with it.
struct Rate<L: Lanes, const D: usize, const DIFFUSED: bool> {
    constants: Constants<L>,
    place: [L::Four; 4],
    motion: [L::Four; 4],
    divergence: L::Four,
    exchange: L::Four,
}

impl<L: Lanes, const D: usize, const DIFFUSED: bool> Rate<L, D, DIFFUSED> {
    #[inline(always)]
    fn new(lanes: L, constants: Constants<L>, row: &Row) -> Self {
        Self {
            constants,
            place: lanes.splats(&row.place),
            motion: lanes.splats(&row.motion),
            divergence: constants.zero,
            exchange: constants.zero,
        }
    }
}

impl<L: Lanes, const D: usize, const DIFFUSED: bool> Pairs<L> for Rate<L, D, DIFFUSED> {
    #[inline(always)]
    fn add(&mut self, lanes: L, place: [L::Four; 4], motion: [L::Four; 4]) {
        let Constants { half, slope, eta2, strength, rest, one, zero } = self.constants;
        let r = lanes.difference::<D>(&self.place, &place);
        let v = lanes.difference::<D>(&self.motion, &motion);
        let square = lanes.dot::<D>(&r, &r);
        let s = lanes.max(lanes.sub(one, lanes.mul(half, lanes.sqrt(square))), zero);
        let factor = lanes.mul(slope, lanes.mul(lanes.mul(s, s), s));
        self.divergence = lanes.add(self.divergence, lanes.mul(factor, lanes.dot::<D>(&v, &r)));
        if DIFFUSED {
            let densities = lanes.add(self.place[3], place[3]);
            let inverse = lanes.div(one, lanes.mul(lanes.add(square, eta2), densities));
            let excess = lanes.add(lanes.sub(place[3], self.place[3]), lanes.dot::<D>(&rest, &r));
            let share = lanes.mul(lanes.mul(strength, inverse), lanes.mul(factor, square));
            self.exchange = lanes.sub(self.exchange, lanes.mul(share, excess));
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
    /// Whether those of their own kind count: walls see the fluid only.
    pub own: bool,
    /// Neighbours of the other kind.
    pub other: &'a Sorted,
    /// By slot of the chunk: rate, and what diffusion adds to it \[M/(L³ T)\].
    pub out: &'b mut [[f64; 2]],
}

impl<const D: usize> Sweep for Rates<'_, '_, D> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) {
        let Self { continuity, grid, of, first, own, other, out } = self;
        let constants = Constants::new(lanes, continuity);
        let (reach2, diffused) = (continuity.kernel.reach2, continuity.diffusion.strength != 0.0);
        let (mut room, mut last) = (Room::new(), NOWHERE);
        let mut near = [Ranges::default(); 2];
        for (slot, out) in (first..).zip(out) {
            let (row, cell) = (&of.rows[slot], of.cell(slot));
            if cell != last {
                near[0] = if own { grid.beside(cell, &of.starts) } else { Ranges::default() };
                near[1] = grid.beside(cell, &other.starts);
                last = cell;
            }
            *out = [0.0; 2];
            if own && diffused {
                let mut rate = Rate::<L, D, true>::new(lanes, constants, row);
                let hidden = of.hidden_sides(slot);
                gather::<L, _, D>(lanes, of, &near[0], row.at(), reach2, hidden, &mut room, &mut rate);
                *out = [lanes.total(rate.divergence), lanes.total(rate.exchange)];
            } else if own {
                let mut rate = Rate::<L, D, false>::new(lanes, constants, row);
                let hidden = of.hidden_sides(slot);
                gather::<L, _, D>(lanes, of, &near[0], row.at(), reach2, hidden, &mut room, &mut rate);
                out[0] = lanes.total(rate.divergence);
            }
            if !near[1].filled().is_empty() {
                let mut rate = Rate::<L, D, false>::new(lanes, constants, row);
                let hidden = of.hidden_faces(slot, other);
                gather::<L, _, D>(lanes, other, &near[1], row.at(), reach2, hidden, &mut room, &mut rate);
                out[0] += lanes.total(rate.divergence);
            }
        }
    }
}
