//! XSPH \[monaghan1992\]: particles move with a share of the mean velocity about them, `ε Σ_b 2m/(ρ_a + ρ_b) (v_b − v_a) W`.

use crate::cells::{Grid, NOWHERE, Ranges};
use crate::dispatch::Sweep;
use crate::gather::{Pairs, Room, gather};
use crate::kernel::Wendland;
use crate::lanes::Lanes;
use crate::sorted::Sorted;

/// The sum over the neighbours of one particle.
struct Drag<L: Lanes, const D: usize> {
    place: [L::Four; 4],
    motion: [L::Four; 4],
    half: L::Four,
    scale: L::Four,
    four: L::Four,
    one: L::Four,
    zero: L::Four,
    sum: [L::Four; 3],
}

impl<L: Lanes, const D: usize> Pairs<L> for Drag<L, D> {
    #[inline(always)]
    fn add(&mut self, lanes: L, place: [L::Four; 4], motion: [L::Four; 4]) {
        let r = lanes.difference::<D>(&self.place, &place);
        let square =
            lanes.add(lanes.add(lanes.mul(r[0], r[0]), lanes.mul(r[1], r[1])), lanes.mul(r[2], r[2]));
        let half = lanes.mul(self.half, lanes.sqrt(square));
        let s = lanes.max(lanes.sub(self.one, half), self.zero);
        let square = lanes.mul(s, s);
        let shape = lanes.mul(lanes.mul(square, square), lanes.add(lanes.mul(self.four, half), self.one));
        let weight = lanes.div(lanes.mul(self.scale, shape), lanes.add(self.place[3], place[3]));
        self.sum = lanes.add_scaled::<D>(&self.sum, weight, &lanes.difference::<D>(&motion, &self.motion));
    }
}

/// What XSPH adds to the velocities with which a chunk of sorted particles moves.
pub(crate) struct Transport<'a, 'b, const D: usize> {
    pub kernel: &'a Wendland,
    /// `2εm` \[M\].
    pub share: f64,
    pub grid: &'a Grid,
    pub fluid: &'a Sorted,
    /// First slot of the chunk.
    pub first: usize,
    /// By slot of the chunk \[L/T\].
    pub out: &'b mut [[f64; 3]],
}

impl<const D: usize> Sweep for Transport<'_, '_, D> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) {
        let Self { kernel, share, grid, fluid, first, out } = self;
        let (mut room, mut last, mut near) = (Room::new(), NOWHERE, Ranges::default());
        for (slot, out) in (first..).zip(out) {
            let (row, cell) = (&fluid.rows[slot], fluid.cell(slot));
            if cell != last {
                (near, last) = (grid.beside(cell, &fluid.starts), cell);
            }
            let zero = lanes.splat(0.0);
            let mut drag = Drag::<L, D> {
                place: lanes.splats(&row.place),
                motion: lanes.splats(&row.motion),
                half: lanes.splat(kernel.half),
                scale: lanes.splat(kernel.scale),
                four: lanes.splat(4.0),
                one: lanes.splat(1.0),
                zero,
                sum: [zero; 3],
            };
            let (hidden, reach2, room) = (fluid.hidden_sides(slot), kernel.reach2, &mut room);
            gather::<L, _, D>(lanes, fluid, &near, row.at(), reach2, hidden, room, &mut drag);
            let [u, v, w] = lanes.totals(&drag.sum);
            *out = [share * u, share * v, share * w];
        }
    }
}
