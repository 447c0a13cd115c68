//! Forces: `dv_a/dt = −Σ_b m (P_a/ρ_a² + P_b/ρ_b² + Π_ab) F_ab r_ab` \[monaghan1992\], friction within Π.
//!
//! Every expression of a pair changes no bit, or its sign only, when a and b change places: forces are opposite to the bit.
//! All act along the line of centres, so that they exert no moment on the pair.

use sph_core::lanes::{Lanes, Sweep};

use crate::cells::Grid;
use crate::gather::{Pairs, Room, gather};
use crate::kernel::Wendland;
use crate::pair::Shape;
use crate::row::{Four, Row};
use crate::sorted::Sorted;
use crate::viscosity::Viscosity;
use crate::walk::Walk;

/// What pairs need beside themselves.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Momentum {
    pub kernel: Wendland,
    /// Mass of a particle \[M\].
    pub mass: f64,
    pub viscosity: Viscosity,
    /// `c₀/ρ₀³`: the speed of sound is so many ρ³.
    pub sound: f64,
}

/// What a chunk of particles feels beside their accelerations.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Felt {
    /// Sum over the particles: power that friction takes a unit of mass \[L²/T³\].
    pub friction: f64,
    /// Greatest `c_a + max_b |h v_ab·r_ab/(r² + η²)| 2ρ_a/(ρ_a + ρ_b)` \[L/T\].
    pub signal: f64,
    /// Greatest square of an acceleration \[L²/T⁴\].
    pub square: f64,
}

impl Felt {
    /// Of two chunks together.
    pub fn and(self, other: &Self) -> Self {
        Self {
            friction: self.friction + other.friction,
            signal: self.signal.max(other.signal),
            square: self.square.max(other.square),
        }
    }
}

/// Numbers of all pairs, in lanes.
struct Constants<L: Lanes> {
    shape: Shape<L>,
    artificial: L::Four,
    laminar: L::Four,
}

impl<L: Lanes> Clone for Constants<L> {
    fn clone(&self) -> Self {
        *self
    }
}
impl<L: Lanes> Copy for Constants<L> {}

impl<L: Lanes> Constants<L> {
    #[inline(always)]
    fn new(lanes: L, Momentum { kernel, viscosity, .. }: &Momentum) -> Self {
        Self {
            shape: Shape::new(lanes, kernel),
            artificial: lanes.splat(viscosity.artificial),
            laminar: lanes.splat(viscosity.laminar),
        }
    }
}

/// The sum over the neighbours of one particle, without the factor of all pairs; `WALL` where fluid and walls meet,
/// `LAMINAR` with laminar friction.
struct Force<L: Lanes, const D: usize, const WALL: bool, const LAMINAR: bool> {
    constants: Constants<L>,
    own: Four<L>,
    /// Velocity with which friction does work on the particle, where its neighbours bear the rest of it.
    slide: [L::Four; 3],
    cube: L::Four,
    acceleration: [L::Four; 3],
    friction: L::Four,
    approach: L::Four,
}

impl<L: Lanes, const D: usize, const WALL: bool, const LAMINAR: bool> Force<L, D, WALL, LAMINAR> {
    #[inline(always)]
    fn new(lanes: L, constants: Constants<L>, row: &Row, velocity: [f64; 3]) -> Self {
        let (own, zero) = (Four::all(lanes, row), constants.shape.zero);
        Self {
            constants,
            slide: velocity.map(|v| lanes.splat(v)),
            cube: lanes.mul(lanes.mul(own.density, own.density), own.density),
            own,
            acceleration: [zero; 3],
            friction: zero,
            approach: zero,
        }
    }
}

impl<L: Lanes, const D: usize, const WALL: bool, const LAMINAR: bool> Pairs<L>
    for Force<L, D, WALL, LAMINAR>
{
    #[inline(always)]
    fn add(&mut self, lanes: L, four: Four<L>) {
        let Constants { shape, artificial, laminar } = self.constants;
        let pair = shape.pair::<D>(lanes, &self.own, &four);
        let densities = lanes.add(self.own.density, four.density);
        let volume = lanes.mul(lanes.add(pair.square, shape.eta2), densities);
        let inverse = lanes.div(shape.one, volume);
        let cubes = lanes.add(self.cube, lanes.mul(lanes.mul(four.density, four.density), four.density));
        let speed = lanes.mul(pair.closing, inverse);
        // −Π.
        let mut friction = lanes.mul(lanes.mul(artificial, cubes), lanes.min(speed, shape.zero));
        if LAMINAR {
            let speed = lanes.mul(speed, lanes.add(pair.square, shape.eta2));
            friction = lanes.add(friction, lanes.mul(laminar, speed));
        }
        let stress = lanes.sub(lanes.add(self.own.share, four.share), friction);
        let along = lanes.mul(pair.slope, stress);
        self.acceleration = lanes.add_scaled::<D>(&self.acceleration, along, &pair.way);
        let power = if WALL { lanes.dot::<D>(&self.slide, &pair.way) } else { pair.closing };
        self.friction = lanes.add(self.friction, lanes.mul(lanes.mul(pair.slope, friction), power));
        self.approach = lanes.max(self.approach, lanes.max(speed, lanes.sub(shape.zero, speed)));
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
}

impl<const D: usize> Sweep for Forces<'_, '_, D> {
    type Output = Felt;

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> Felt {
        if self.momentum.viscosity.laminar == 0.0 {
            self.sum::<L, false>(lanes)
        } else {
            self.sum::<L, true>(lanes)
        }
    }
}

impl<const D: usize> Forces<'_, '_, D> {
    #[inline(always)]
    fn sum<L: Lanes, const LAMINAR: bool>(self, lanes: L) -> Felt {
        let Self { momentum, grid, of, first, sets, gravity, velocities, out } = self;
        let Momentum { kernel, mass, sound, .. } = momentum;
        let constants = Constants::new(lanes, momentum);
        let factor = -mass * kernel.slope;
        let mut walk = Walk::new(grid, of, first, sets, kernel.reach());
        let (mut room, mut felt) = (Room::new(), Felt::default());
        for (slot, out) in (first..).zip(out) {
            walk.go(slot, &mut room);
            let row = &of.rows[slot];
            let velocity = velocities.get(of.order[slot] as usize).map_or(row.velocity(), |v| (*v).into());
            let (mut acceleration, mut friction, mut approach) = ([0.0; 3], 0.0, 0.0);
            if let Some(search) = walk.own(slot) {
                let mut force = Force::<L, D, false, LAMINAR>::new(lanes, constants, row, velocity);
                gather::<L, _, D>(lanes, search, &mut room, &mut force);
                acceleration = lanes.totals(&force.acceleration);
                // The other of the pair counts the other half.
                friction = 0.5 * lanes.total(force.friction);
                approach = lanes.greatest(force.approach);
            }
            if let Some(search) = walk.other(slot) {
                let mut force = Force::<L, D, true, LAMINAR>::new(lanes, constants, row, velocity);
                gather::<L, _, D>(lanes, search, &mut room, &mut force);
                for (sum, more) in acceleration.iter_mut().zip(lanes.totals(&force.acceleration)) {
                    *sum += more;
                }
                friction += lanes.total(force.friction);
                approach = approach.max(lanes.greatest(force.approach));
            }
            let [x, y, z] = acceleration;
            *out = [factor * x + gravity[0], factor * y + gravity[1], factor * z + gravity[2]];
            let density = row.density();
            felt = felt.and(&Felt {
                friction: factor * friction,
                signal: sound * (density * density * density) + 2.0 * kernel.h * density * approach,
                square: out[0] * out[0] + out[1] * out[1] + out[2] * out[2],
            });
        }
        felt
    }
}
