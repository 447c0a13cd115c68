//! What the fluid is at a place beside it \[adami2012\], by the mean over the fluid within reach:
//!
//! ```text
//! P_w = Σ_f [P_f + ρ_f (g − a_w)·(r_w − r_f)] W_wf / Σ_f W_wf,   a_w = 0: with it light structures are unstable
//! ```

use crate::cells::{Grid, NOWHERE, Ranges};
use crate::dispatch::Sweep;
use crate::gather::{Pairs, Room, gather};
use crate::kernel::Wendland;
use crate::lanes::Lanes;
use crate::sorted::{Row, Sorted};

/// The fluid at a place.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Seen {
    /// Σ W \[1/L²; 1/L³\]; zero where there is no fluid.
    pub weight: f64,
    /// Σ of pressures carried to the place, times W.
    pub pressure: f64,
    /// Σ v W.
    pub velocity: [f64; 3],
}

/// The sums of one place.
struct Mean<L: Lanes, const D: usize> {
    place: [L::Four; 4],
    gravity: [L::Four; 3],
    half: L::Four,
    scale: L::Four,
    four: L::Four,
    one: L::Four,
    zero: L::Four,
    weight: L::Four,
    pressure: L::Four,
    velocity: [L::Four; 3],
}

impl<L: Lanes, const D: usize> Pairs<L> for Mean<L, D> {
    #[inline(always)]
    fn add(&mut self, lanes: L, place: [L::Four; 4], motion: [L::Four; 4]) {
        let r = lanes.difference::<D>(&self.place, &place);
        // q/2, so that 2q + 1 = 4 (q/2) + 1.
        let half = lanes.mul(self.half, lanes.sqrt(lanes.dot::<D>(&r, &r)));
        let s = lanes.max(lanes.sub(self.one, half), self.zero);
        let square = lanes.mul(s, s);
        let shape = lanes.mul(lanes.mul(square, square), lanes.add(lanes.mul(self.four, half), self.one));
        let weight = lanes.mul(self.scale, shape);
        let density = place[3];
        let own = lanes.mul(lanes.mul(motion[3], density), density);
        let carried = lanes.add(own, lanes.mul(density, lanes.dot::<D>(&self.gravity, &r)));
        self.weight = lanes.add(self.weight, weight);
        self.pressure = lanes.add(self.pressure, lanes.mul(weight, carried));
        let [u, v, w, _] = motion;
        self.velocity = lanes.add_scaled::<D>(&self.velocity, weight, &[u, v, w]);
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
        let (mut room, mut last, mut near) = (Room::new(), NOWHERE, Ranges::default());
        for (slot, out) in (first..).zip(out) {
            let (row, cell): (&Row, u32) = (&of.rows[slot], of.cell(slot));
            if cell != last {
                (near, last) = (grid.beside(cell, &fluid.starts), cell);
            }
            *out = Seen::default();
            if near.filled().is_empty() {
                continue;
            }
            let zero = lanes.splat(0.0);
            let mut mean = Mean::<L, D> {
                place: lanes.splats(&row.place),
                gravity: [lanes.splat(gravity[0]), lanes.splat(gravity[1]), lanes.splat(gravity[2])],
                half: lanes.splat(kernel.half),
                scale: lanes.splat(kernel.scale),
                four: lanes.splat(4.0),
                one: lanes.splat(1.0),
                zero,
                weight: zero,
                pressure: zero,
                velocity: [zero; 3],
            };
            let hidden = of.hidden_faces(slot, fluid);
            let (reach2, room) = (kernel.reach2, &mut room);
            gather::<L, _, D>(lanes, fluid, &near, row.at(), reach2, hidden, room, &mut mean);
            *out = Seen {
                weight: lanes.total(mean.weight),
                pressure: lanes.total(mean.pressure),
                velocity: lanes.totals(&mean.velocity),
            };
        }
    }
}
