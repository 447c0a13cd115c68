//! XSPH \[monaghan1992\]: particles move with a share of the mean velocity about them, `ε Σ_b 2m/(ρ_a + ρ_b) (v_b − v_a) W`.

use sph_core::lanes::{Lanes, Sweep};

use crate::cells::Grid;
use crate::gather::{Pairs, Room, gather};
use crate::kernel::Wendland;
use crate::pair::Shape;
use crate::row::Four;
use crate::sorted::Sorted;
use crate::walk::Walk;

/// The sum over the neighbours of one particle, without the factor of all pairs.
struct Drag<L: Lanes, const D: usize> {
    shape: Shape<L>,
    own: Four<L>,
    sum: [L::Four; 3],
}

impl<L: Lanes, const D: usize> Pairs<L> for Drag<L, D> {
    #[inline(always)]
    fn add(&mut self, lanes: L, four: Four<L>) {
        let way = lanes.difference::<D>(&self.own.at, &four.at);
        let value = self.shape.value(lanes, lanes.dot::<D>(&way, &way));
        let weight = lanes.div(value, lanes.add(self.own.density, four.density));
        let ahead = lanes.difference::<D>(&four.velocity, &self.own.velocity);
        self.sum = lanes.add_scaled::<D>(&self.sum, weight, &ahead);
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
        let shape = Shape::new(lanes, kernel);
        let factor = share * kernel.scale;
        let mut walk = Walk::new(grid, fluid, first, [Some(fluid), None], kernel.reach());
        let mut room = Room::new();
        for (slot, out) in (first..).zip(out) {
            walk.go(slot, &mut room);
            let own = Four::all(lanes, &fluid.rows[slot]);
            let mut drag = Drag::<L, D> { shape, own, sum: [shape.zero; 3] };
            if let Some(search) = walk.own(slot) {
                gather::<L, _, D>(lanes, search, &mut room, &mut drag);
            }
            *out = lanes.totals(&drag.sum).map(|sum| factor * sum);
        }
    }
}
