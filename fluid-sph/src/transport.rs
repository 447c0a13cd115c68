//! XSPH \[monaghan1992\]: particles move with a share of the mean velocity about them, `ε Σ_b 2m/(ρ_a + ρ_b) (v_b − v_a) W`.

use lanes::{Lanes, Sweep, Vector};

use crate::cells::Grid;
use crate::kernel::Wendland;
use crate::neighbours::{CellCursor, Pairs, Scratch, gather};
use crate::pair::{Four, Shape};
use crate::sorted::Sorted;

/// The sum over the neighbours of one particle, without the factor of all pairs.
struct Drag<L: Lanes, const D: usize> {
    shape: Shape<L>,
    own: Four<L, D>,
    sum: Vector<L, D>,
}

impl<L: Lanes, const D: usize> Pairs<L, D> for Drag<L, D> {
    #[inline(always)]
    fn add(&mut self, four: Four<L, D>) {
        let way = self.own.at - four.at;
        let weight = self.shape.value(way.dot(way)) / (self.own.density + four.density);
        self.sum += (four.velocity - self.own.velocity) * weight;
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
        let mut cursor = CellCursor::new(grid, fluid, first, [Some(fluid), None], kernel.reach());
        let mut scratch = Scratch::new();
        for (slot, out) in (first..).zip(out) {
            if fluid.is_left(slot) {
                continue;
            }
            cursor.go(slot, &mut scratch);
            let own = Four::all(lanes, &fluid.rows[slot]);
            let mut drag = Drag::<L, D> { shape, own, sum: Vector([shape.zero; 3]) };
            if let Some(search) = cursor.own(slot) {
                gather::<L, _, D>(lanes, search, &mut scratch, &mut drag);
            }
            *out = drag.sum.totals().map(|sum| factor * sum);
        }
    }
}
