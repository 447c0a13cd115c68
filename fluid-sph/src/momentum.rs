//! Forces: `dv_a/dt = −Σ_b m (P_a/ρ_a² + P_b/ρ_b² + Π_ab) F_ab r_ab` \[monaghan1992\], friction within Π.
//!
//! Every expression of a pair changes no bit, or its sign only, when a and b change places: forces are opposite to the bit.
//! All act along the line of centres, so that they exert no moment on the pair.
//!
//! # Friction
//!
//! Between two particles: the artificial viscosity of \[monaghan1992\], and laminar flow.
//!
//! ```text
//! a_a = −Σ m_b Π_ab F r_ab
//! Π_ab = −α c̄ h min(v_ab·r_ab, 0)/[ρ̄ (r² + η²)] − 4(d + 2) ν v_ab·r_ab/[(ρ_a + ρ_b) κh²],   κ = 10/9 in a plane, 4/3 in space
//! ```
//!
//! The second acts along the line of centres, as that of \[monaghan2005\] does, so that it exerts no moment and does not
//! resist a rigid rotation. To second order `v_ab = (r·∇)v − ½(r·∇)²v`. The first term sums to zero by symmetry; with
//! `∫F r² dV = −d` and `κh² = ∫F r⁴ dV/∫F r² dV`
//!
//! ```text
//! ∫ F r_i r_j r_k r_l/(κh²) dV = −(δ_ij δ_kl + δ_ik δ_jl + δ_il δ_jk)/(d + 2)
//! ```
//!
//! leaves ν∇²v + 2ν∇(∇·v): the friction of a Newtonian fluid where the volume hardly changes. The published weight
//! F/(r² + η²) has the same integral but gives the nearest so much that a square lattice of h = 1.3 Δx is 20 % too soft in
//! shear along its rows and 12 % too stiff across; F/(κh²) is within 5 % for any direction (h/Δx from 1.3 to 2). Forces
//! along v_ab \[lo2002\] stand for the stress ν∇v, which resists rotation: torques on curved walls are wrong by ν v/r.

use lanes::{Lanes, Reals, Sweep, Vector};

use crate::cells::Grid;
use crate::formulation::Formulation;
use crate::kernel::Wendland;
use crate::liquid::Liquid;
use crate::neighbours::{CellCursor, Pairs, Scratch, gather};
use crate::pair::{Four, Row, Shape};
use crate::sorted::Sorted;

/// What both need beside the pair.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Viscosity {
    /// `α h c₀/ρ₀³`: with it `Π = −artificial (ρ_a³ + ρ_b³) min(v·r, 0)/[(ρ_a + ρ_b)(r² + η²)]`, as c ∝ ρ³.
    pub artificial: f64,
    /// `4(d + 2)ν/(κh²)` \[1/T\].
    pub laminar: f64,
}

impl Viscosity {
    /// Those of a formulation, in so many dimensions.
    pub fn new(dimensions: usize, formulation: &Formulation, liquid: &Liquid, kernel: &Wendland) -> Self {
        let (d, ratio) = if dimensions == 2 { (2.0, 10.0 / 9.0) } else { (3.0, 4.0 / 3.0) };
        let cube = liquid.density * liquid.density * liquid.density;
        Self {
            artificial: formulation.viscosity * kernel.h * liquid.sound_speed / cube,
            laminar: 4.0 * (d + 2.0) * formulation.kinematic_viscosity / (ratio * kernel.h * kernel.h),
        }
    }
}

impl Viscosity {
    /// None.
    pub const NONE: Self = Self { artificial: 0.0, laminar: 0.0 };
}

/// What pairs need beside themselves.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Momentum {
    pub kernel: Wendland,
    /// Mass of a particle \[M\].
    pub mass: f64,
    pub viscosity: Viscosity,
    /// Friction against walls and structures: the same, or none where they let the fluid slip.
    pub at_walls: Viscosity,
    /// `c₀/ρ₀³`: the speed of sound is so many ρ³.
    pub sound: f64,
}

/// What a chunk of particles feels beside their accelerations.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct ForceSum {
    /// Greatest `c_a + max_b |h v_ab·r_ab/(r² + η²)| 2ρ_a/(ρ_a + ρ_b)` \[L/T\].
    pub signal: f64,
    /// Greatest square of an acceleration \[L²/T⁴\].
    pub square: f64,
}

impl ForceSum {
    /// Of two chunks together.
    pub fn and(self, other: &Self) -> Self {
        Self { signal: self.signal.max(other.signal), square: self.square.max(other.square) }
    }
}

/// Numbers of all pairs, in lanes.
#[derive(Clone, Copy)]
struct Constants<L: Lanes> {
    shape: Shape<L>,
    artificial: Reals<L>,
    laminar: Reals<L>,
}

impl<L: Lanes> Constants<L> {
    #[inline(always)]
    fn new(lanes: L, kernel: &Wendland, viscosity: &Viscosity) -> Self {
        Self {
            shape: Shape::new(lanes, kernel),
            artificial: lanes.same(viscosity.artificial),
            laminar: lanes.same(viscosity.laminar),
        }
    }
}

/// The sum over the neighbours of one particle, without the factor of all pairs; `WALL` where fluid and walls meet,
/// `LAMINAR` with laminar friction.
struct Force<L: Lanes, const D: usize, const WALL: bool, const LAMINAR: bool> {
    constants: Constants<L>,
    own: Four<L, D>,
    /// Velocity with which friction does work on the particle, where its neighbours bear the rest of it.
    slide: Vector<L, D>,
    /// `ρ_a³`.
    cube: Reals<L>,
    acceleration: Vector<L, D>,
    friction: Reals<L>,
    approach: Reals<L>,
}

impl<L: Lanes, const D: usize, const WALL: bool, const LAMINAR: bool> Force<L, D, WALL, LAMINAR> {
    #[inline(always)]
    fn new(lanes: L, constants: Constants<L>, row: &Row, velocity: [f64; 3]) -> Self {
        let (own, zero) = (Four::all(lanes, row), constants.shape.zero);
        Self {
            constants,
            slide: lanes.vector(velocity),
            cube: own.density * own.density * own.density,
            own,
            acceleration: Vector([zero; 3]),
            friction: zero,
            approach: zero,
        }
    }
}

impl<L: Lanes, const D: usize, const WALL: bool, const LAMINAR: bool> Pairs<L, D>
    for Force<L, D, WALL, LAMINAR>
{
    #[inline(always)]
    fn add(&mut self, four: Four<L, D>) {
        let (Constants { shape, artificial, laminar }, own) = (self.constants, self.own);
        let pair = shape.pair(&own, &four);
        let square = pair.square + shape.eta2;
        // v·r/[(r² + η²)(ρ_a + ρ_b)].
        let speed = pair.closing * (shape.one / (square * (own.density + four.density)));
        let cubes = self.cube + four.density * four.density * four.density;
        // −Π.
        let mut friction = artificial * cubes * speed.min(shape.zero);
        if LAMINAR {
            friction += laminar * (speed * square);
        }
        let stress = own.p_over_rho2 + four.p_over_rho2 - friction;
        self.acceleration += pair.way * (pair.slope * stress);
        let power = if WALL { self.slide.dot(pair.way) } else { pair.closing };
        self.friction += pair.slope * friction * power;
        self.approach = self.approach.max(speed.max(shape.zero - speed));
    }
}

/// Forces on a chunk of sorted particles, from neighbours of their own kind and of another.
pub(crate) struct Forces<'a, 'b, const D: usize> {
    pub momentum: &'a Momentum,
    pub grid: &'a Grid,
    /// The particles themselves.
    pub of: &'a Sorted,
    /// First slot of the chunk.
    pub first: usize,
    /// Neighbours of their own kind if they act, for walls feel the fluid only; and of the other kind.
    pub sets: [Option<&'a Sorted>; 2],
    /// What acts on each unit of mass beside them \[L/T²\].
    pub gravity: [f64; 3],
    /// By particle of a boundary: its velocity, where that of its row is mirrored \[L/T\].
    pub velocities: &'a [sph_core::Vec3],
    /// By slot of the chunk: accelerations \[L/T²\].
    pub out: &'b mut [[f64; 3]],
    /// By slot of the chunk: power that friction takes a unit of mass \[L²/T³\].
    pub powers: &'b mut [f64],
}

impl<const D: usize> Sweep for Forces<'_, '_, D> {
    type Output = ForceSum;

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> ForceSum {
        if self.momentum.viscosity.laminar == 0.0 {
            self.sum::<L, false>(lanes)
        } else {
            self.sum::<L, true>(lanes)
        }
    }
}

impl<const D: usize> Forces<'_, '_, D> {
    #[inline(always)]
    fn sum<L: Lanes, const LAMINAR: bool>(self, lanes: L) -> ForceSum {
        let Self { momentum, grid, of, first, sets, gravity, velocities, out, powers } = self;
        let Momentum { kernel, mass, sound, .. } = momentum;
        let constants = Constants::new(lanes, kernel, &momentum.viscosity);
        let at_walls = Constants::new(lanes, kernel, &momentum.at_walls);
        let factor = -mass * kernel.slope;
        let mut cursor = CellCursor::new(grid, of, first, sets, kernel.reach());
        let (mut scratch, mut sum) = (Scratch::new(), ForceSum::default());
        for (slot, (out, power)) in (first..).zip(out.iter_mut().zip(powers)) {
            if of.is_left(slot) {
                continue;
            }
            cursor.go(slot, &mut scratch);
            let row = &of.rows[slot];
            let velocity = velocities.get(of.order[slot] as usize).map_or(row.velocity(), |v| (*v).into());
            let (mut acceleration, mut friction, mut approach) = ([0.0; 3], 0.0, 0.0);
            if let Some(search) = cursor.own(slot) {
                let mut force = Force::<L, D, false, LAMINAR>::new(lanes, constants, row, velocity);
                gather::<L, _, D>(lanes, search, &mut scratch, &mut force);
                acceleration = force.acceleration.totals();
                // The other of the pair counts the other half.
                friction = 0.5 * force.friction.total();
                approach = force.approach.greatest();
            }
            if let Some(search) = cursor.other(slot) {
                let mut force = Force::<L, D, true, LAMINAR>::new(lanes, at_walls, row, velocity);
                gather::<L, _, D>(lanes, search, &mut scratch, &mut force);
                for (sum, more) in acceleration.iter_mut().zip(force.acceleration.totals()) {
                    *sum += more;
                }
                friction += force.friction.total();
                approach = approach.max(force.approach.greatest());
            }
            let [x, y, z] = acceleration;
            *out = [factor * x + gravity[0], factor * y + gravity[1], factor * z + gravity[2]];
            let density = row.density();
            *power = factor * friction;
            sum = sum.and(&ForceSum {
                signal: sound * (density * density * density) + 2.0 * kernel.h * density * approach,
                square: out[0] * out[0] + out[1] * out[1] + out[2] * out[2],
            });
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Shear along the rows of a lattice and across, from the sums over the lattice themselves: measured −4.0 to +4.4 % of ν.
    #[test]
    fn friction_of_a_lattice_hardly_depends_on_the_direction() {
        let liquid = Liquid { density: 1.0, sound_speed: 1.0 };
        for dimensions in [2, 3] {
            for smoothing in [1.3, 1.55, 2.0] {
                let kernel = Wendland::new(dimensions, smoothing);
                let formulation = Formulation { kinematic_viscosity: 1.0, ..Formulation::default() };
                let laminar = Viscosity::new(dimensions, &formulation, &liquid, &kernel).laminar;
                let (mut rows, mut along) = (0.0, 0.0);
                let depth = if dimensions == 2 { 0 } else { 4 };
                for (i, j) in (-4_i32..=4).flat_map(|i| (-4_i32..=4).map(move |j| (i, j))) {
                    for k in -depth..=depth {
                        let [x, y] = [i, j].map(f64::from);
                        // Of v_y = ½x² the sum is −¼ Σ 4(d + 2)ν/(κh²) F x²y², masses and densities one.
                        let weight = -0.25 * laminar * kernel.factor(f64::from(i * i + j * j + k * k).sqrt());
                        rows += weight * x * x * y * y;
                        along += weight * x * x * x * x;
                    }
                }
                // Turned by 45°, x²y² becomes ¼(x² − y²)².
                for found in [rows, 0.5 * (along - rows)] {
                    assert!((found - 1.0).abs() < 0.06, "{dimensions} {smoothing}: {found}");
                }
            }
        }
    }
}
