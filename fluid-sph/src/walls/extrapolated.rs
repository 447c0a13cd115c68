//! What the fluid is at a place beside it \[adami2012\], by the mean over the fluid within reach:
//!
//! ```text
//! P_w = Σ_f [P_f + ρ_f (g − a_w)·(r_w − r_f)] W_wf / Σ_f W_wf,   a_w = 0: with it light structures are unstable
//! ```

use sph_core::lanes::{Lanes, Sweep};

use crate::cells::Grid;
use crate::gather::{Pairs, Room, gather};
use crate::kernel::Wendland;
use crate::pair::Shape;
use crate::row::Four;
use crate::sorted::Sorted;
use crate::walk::Walk;

/// The fluid at a place.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Seen {
    /// Σ W over its factor \[–\]; zero where there is no fluid.
    pub weight: f64,
    /// Σ of pressures carried to the place, times the same.
    pub pressure: f64,
    /// Σ of velocities, times the same.
    pub velocity: [f64; 3],
}

/// The sums of one place, without the factor of the kernel.
struct Mean<L: Lanes, const D: usize> {
    shape: Shape<L>,
    own: Four<L>,
    gravity: [L::Four; 3],
    weight: L::Four,
    pressure: L::Four,
    velocity: [L::Four; 3],
}

impl<L: Lanes, const D: usize> Pairs<L> for Mean<L, D> {
    #[inline(always)]
    fn add(&mut self, lanes: L, four: Four<L>) {
        let way = lanes.difference::<D>(&self.own.at, &four.at);
        let weight = self.shape.value(lanes, lanes.dot::<D>(&way, &way));
        let own = lanes.mul(lanes.mul(four.share, four.density), four.density);
        let carried = lanes.add(own, lanes.mul(four.density, lanes.dot::<D>(&self.gravity, &way)));
        self.weight = lanes.add(self.weight, weight);
        self.pressure = lanes.add(self.pressure, lanes.mul(weight, carried));
        self.velocity = lanes.add_scaled::<D>(&self.velocity, weight, &four.velocity);
    }
}

/// Means of the fluid at a chunk of sorted places.
pub(crate) struct Means<'a, 'b, const D: usize> {
    pub kernel: &'a Wendland,
    pub gravity: [f64; 3],
    pub grid: &'a Grid,
    /// The places.
    pub of: &'a Sorted,
    /// First slot of the chunk.
    pub first: usize,
    pub fluid: &'a Sorted,
    /// By slot of the chunk.
    pub out: &'b mut [Seen],
}

impl<const D: usize> Sweep for Means<'_, '_, D> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) {
        let Self { kernel, gravity, grid, of, first, fluid, out } = self;
        let shape = Shape::new(lanes, kernel);
        let gravity = gravity.map(|g| lanes.splat(g));
        let mut walk = Walk::new(grid, of, first, [None, Some(fluid)], kernel.reach());
        let mut room = Room::new();
        for (slot, out) in (first..).zip(out) {
            walk.go(slot, &mut room);
            *out = Seen::default();
            let Some(search) = walk.other(slot) else { continue };
            let zero = shape.zero;
            let own = Four::all(lanes, &of.rows[slot]);
            let mut mean =
                Mean::<L, D> { shape, own, gravity, weight: zero, pressure: zero, velocity: [zero; 3] };
            gather::<L, _, D>(lanes, search, &mut room, &mut mean);
            *out = Seen {
                weight: lanes.total(mean.weight),
                pressure: lanes.total(mean.pressure),
                velocity: lanes.totals(&mean.velocity),
            };
        }
    }
}
