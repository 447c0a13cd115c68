//! What the fluid is at a place beside it \[adami2012\], by the mean over the fluid within reach:
//!
//! ```text
//! P_w = Σ_f [P_f + ρ_f (g − a_w)·(r_w − r_f)] W_wf / Σ_f W_wf,   a_w = 0: with it light structures are unstable
//! ```

use lanes::{Lanes, Reals, Sweep, Vector};

use crate::cells::Grid;
use crate::kernel::Wendland;
use crate::neighbours::{CellCursor, Pairs, Scratch, gather};
use crate::pair::{Four, Shape};
use crate::sorted::Sorted;

/// The fluid at a place.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct WallMean {
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
    own: Four<L, D>,
    gravity: Vector<L, D>,
    weight: Reals<L>,
    pressure: Reals<L>,
    velocity: Vector<L, D>,
}

impl<L: Lanes, const D: usize> Pairs<L, D> for Mean<L, D> {
    #[inline(always)]
    fn add(&mut self, four: Four<L, D>) {
        let way = self.own.at - four.at;
        let weight = self.shape.value(way.dot(way));
        let pressure = four.p_over_rho2 * four.density * four.density + four.density * self.gravity.dot(way);
        self.weight += weight;
        self.pressure += weight * pressure;
        self.velocity += four.velocity * weight;
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
    pub out: &'b mut [WallMean],
}

impl<const D: usize> Sweep for Means<'_, '_, D> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) {
        let Self { kernel, gravity, grid, of, first, fluid, out } = self;
        let shape = Shape::new(lanes, kernel);
        let gravity = lanes.vector(gravity);
        let mut cursor = CellCursor::new(grid, of, first, [None, Some(fluid)], kernel.reach());
        let mut scratch = Scratch::new();
        for (slot, out) in (first..).zip(out) {
            cursor.go(slot, &mut scratch);
            *out = WallMean::default();
            let Some(search) = cursor.other(slot) else { continue };
            let zero = shape.zero;
            let own = Four::all(lanes, &of.rows[slot]);
            let mut mean = Mean::<L, D> {
                shape,
                own,
                gravity,
                weight: zero,
                pressure: zero,
                velocity: Vector([zero; 3]),
            };
            gather::<L, _, D>(lanes, search, &mut scratch, &mut mean);
            *out = WallMean {
                weight: mean.weight.total(),
                pressure: mean.pressure.total(),
                velocity: mean.velocity.totals(),
            };
        }
    }
}
