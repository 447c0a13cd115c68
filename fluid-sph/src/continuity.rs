//! The rate of density: `dρ_a/dt = Σ_b m F_ab v_ab·r_ab` over all neighbours, and its diffusion over those of the fluid
//! \[molteni2009\], free of what gravity makes of the density as in \[fourtakas2019\]:
//!
//! ```text
//! dρ_a/dt += δ h c₀ Σ_b 2 ψ_ab (−F r²)/(r² + η²) 2m/(ρ_a + ρ_b),   ψ_ab = ρ_b − ρ_a − (ρ₀/c₀²) g·(r_b − r_a)
//! ```
//!
//! The mean density in the volume makes the exchange of mass antisymmetric.

use lanes::{Lanes, Reals, Sweep, Vector};
use sph_core::Vec3;

use crate::cells::Grid;
use crate::formulation::Formulation;
use crate::kernel::Wendland;
use crate::liquid::Liquid;
use crate::neighbours::{CellCursor, Pairs, Scratch, gather};
use crate::pair::{Four, Row, Shape};
use crate::sorted::Sorted;

/// What the exchange needs beside the pair.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Diffusion {
    /// 4δhc₀ \[L²/T\]; none at zero.
    pub strength: f64,
    /// Density gradient of rest `(ρ₀/c₀²) g` \[M/L⁴\].
    pub rest: [f64; 3],
}

impl Diffusion {
    /// That of a formulation.
    pub fn new(formulation: &Formulation, liquid: &Liquid, kernel: &Wendland, gravity: &Vec3) -> Self {
        let Liquid { density, sound_speed } = *liquid;
        Self {
            strength: 4.0 * formulation.density_diffusion * kernel.h * sound_speed,
            rest: (gravity * (density / (sound_speed * sound_speed))).into(),
        }
    }
}

/// What pairs need beside themselves.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Continuity {
    pub kernel: Wendland,
    /// Mass of a particle \[M\].
    pub mass: f64,
    pub diffusion: Diffusion,
}

/// Numbers of all pairs, in lanes.
#[derive(Clone, Copy)]
struct Constants<L: Lanes, const D: usize> {
    shape: Shape<L>,
    rest: Vector<L, D>,
}

impl<L: Lanes, const D: usize> Constants<L, D> {
    #[inline(always)]
    fn new(lanes: L, Continuity { kernel, diffusion, .. }: &Continuity) -> Self {
        Self { shape: Shape::new(lanes, kernel), rest: lanes.vector(diffusion.rest) }
    }
}

/// The sum over the neighbours of one particle, without the factors of all pairs; `DIFFUSED` those that exchange density.
struct Rate<L: Lanes, const D: usize, const DIFFUSED: bool> {
    constants: Constants<L, D>,
    own: Four<L, D>,
    divergence: Reals<L>,
    exchange: Reals<L>,
}

impl<L: Lanes, const D: usize, const DIFFUSED: bool> Rate<L, D, DIFFUSED> {
    #[inline(always)]
    fn new(lanes: L, constants: Constants<L, D>, row: &Row) -> Self {
        let zero = constants.shape.zero;
        Self { constants, own: Four::all(lanes, row), divergence: zero, exchange: zero }
    }
}

impl<L: Lanes, const D: usize, const DIFFUSED: bool> Pairs<L, D> for Rate<L, D, DIFFUSED> {
    #[inline(always)]
    fn add(&mut self, four: Four<L, D>) {
        let (Constants { shape, rest }, own) = (self.constants, self.own);
        let pair = shape.pair(&own, &four);
        self.divergence += pair.slope * pair.closing;
        if DIFFUSED {
            let excess = four.density - own.density + rest.dot(pair.way);
            let volume = (pair.square + shape.eta2) * (own.density + four.density);
            self.exchange += pair.slope * pair.square * excess / volume;
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
        let mut cursor = CellCursor::new(grid, of, first, sets, kernel.reach());
        let mut scratch = Scratch::new();
        for (slot, out) in (first..).zip(out) {
            if of.is_left(slot) {
                continue;
            }
            cursor.go(slot, &mut scratch);
            *out = [0.0; 2];
            if let Some(search) = cursor.own(slot) {
                if strength != 0.0 {
                    let mut rate = Rate::<L, D, true>::new(lanes, constants, &of.rows[slot]);
                    gather::<L, _, D>(lanes, search, &mut scratch, &mut rate);
                    *out = [factor * rate.divergence.total(), -strength * factor * rate.exchange.total()];
                } else {
                    let mut rate = Rate::<L, D, false>::new(lanes, constants, &of.rows[slot]);
                    gather::<L, _, D>(lanes, search, &mut scratch, &mut rate);
                    out[0] = factor * rate.divergence.total();
                }
            }
            if let Some(search) = cursor.other(slot) {
                let mut rate = Rate::<L, D, false>::new(lanes, constants, &of.rows[slot]);
                gather::<L, _, D>(lanes, search, &mut scratch, &mut rate);
                out[0] += factor * rate.divergence.total();
            }
        }
    }
}
