//! Forces: `dv_a/dt = −Σ_b m (P_a/ρ_a² + P_b/ρ_b² + Π_ab) F_ab r_ab + laminar friction` \[monaghan1992\].
//!
//! Every expression of a pair changes no bit, or its sign only, when a and b change places: forces are opposite to the bit.

use crate::cells::{Grid, NOWHERE, Ranges};
use crate::dispatch::Sweep;
use crate::gather::{Pairs, Room, gather};
use crate::kernel::Wendland;
use crate::lanes::Lanes;
use crate::sorted::{Row, Sorted};
use crate::viscosity::Viscosity;

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
    /// Greatest `c_a + max_b |h v_ab·r_ab/(r² + η²)|` \[L/T\].
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

/// The sum over the neighbours of one particle.
struct Force<L: Lanes, const D: usize> {
    constants: Constants<L>,
    place: [L::Four; 4],
    motion: [L::Four; 4],
    cube: L::Four,
    laminar: bool,
    acceleration: [L::Four; 3],
    friction: L::Four,
    approach: L::Four,
}

struct Constants<L: Lanes> {
    half: L::Four,
    slope: L::Four,
    eta2: L::Four,
    h: L::Four,
    artificial: L::Four,
    laminar: L::Four,
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
    fn new(lanes: L, momentum: &Momentum) -> Self {
        let Momentum { kernel, mass, viscosity, .. } = momentum;
        Self {
            half: lanes.splat(kernel.half),
            slope: lanes.splat(-mass * kernel.slope),
            eta2: lanes.splat(kernel.eta2),
            h: lanes.splat(kernel.h),
            artificial: lanes.splat(viscosity.artificial),
            laminar: lanes.splat(viscosity.laminar),
            one: lanes.splat(1.0),
            zero: lanes.splat(0.0),
        }
    }
}

impl<L: Lanes, const D: usize> Force<L, D> {
    #[inline(always)]
    fn new(lanes: L, constants: Constants<L>, row: &Row, laminar: bool) -> Self {
        let [x, y, z, density] = lanes.splats(&row.place);
        let zero = constants.zero;
        Self {
            constants,
            place: [x, y, z, density],
            motion: lanes.splats(&row.motion),
            cube: lanes.mul(lanes.mul(density, density), density),
            laminar,
            acceleration: [zero; 3],
            friction: zero,
            approach: zero,
        }
    }
}

impl<L: Lanes, const D: usize> Pairs<L> for Force<L, D> {
    #[inline(always)]
    fn add(&mut self, lanes: L, place: [L::Four; 4], motion: [L::Four; 4]) {
        let Constants { half, slope, eta2, h, artificial, laminar, one, zero } = self.constants;
        let r = lanes.difference::<D>(&self.place, &place);
        let v = lanes.difference::<D>(&self.motion, &motion);
        let square = lanes.dot::<D>(&r, &r);
        let s = lanes.max(lanes.sub(one, lanes.mul(half, lanes.sqrt(square))), zero);
        // −m F, never negative.
        let pull = lanes.mul(slope, lanes.mul(lanes.mul(s, s), s));
        let vr = lanes.dot::<D>(&v, &r);
        let densities = lanes.add(self.place[3], place[3]);
        let inverse = lanes.div(one, lanes.mul(lanes.add(square, eta2), densities));
        let cubes = lanes.add(self.cube, lanes.mul(lanes.mul(place[3], place[3]), place[3]));
        let closing = lanes.min(vr, zero);
        let friction = lanes.mul(lanes.mul(artificial, cubes), lanes.mul(closing, inverse));
        // −Π, never positive.
        let stress = lanes.sub(lanes.add(self.motion[3], motion[3]), friction);
        let along = lanes.mul(pull, stress);
        self.acceleration = lanes.add_scaled::<D>(&self.acceleration, along, &r);
        self.friction = lanes.add(self.friction, lanes.mul(lanes.mul(pull, friction), vr));
        if self.laminar {
            let across = lanes.mul(lanes.mul(laminar, inverse), lanes.mul(pull, square));
            self.acceleration = lanes.sub_scaled::<D>(&self.acceleration, across, &v);
            self.friction = lanes.add(self.friction, lanes.mul(across, lanes.dot::<D>(&v, &v)));
        }
        let speed = lanes.max(vr, lanes.sub(zero, vr));
        let approach = lanes.mul(lanes.mul(h, speed), lanes.mul(inverse, densities));
        self.approach = lanes.max(self.approach, approach);
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
    /// Whether those of their own kind act: walls feel the fluid only.
    pub own: bool,
    /// Neighbours of the other kind.
    pub other: &'a Sorted,
    /// What acts on each unit of mass beside them \[L/T²\].
    pub gravity: [f64; 3],
    /// By slot of the chunk: accelerations \[L/T²\].
    pub out: &'b mut [[f64; 3]],
}

impl<const D: usize> Sweep for Forces<'_, '_, D> {
    type Output = Felt;

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> Felt {
        let Self { momentum, grid, of, first, own, other, gravity, out } = self;
        let constants = Constants::new(lanes, momentum);
        let (reach2, laminar) = (momentum.kernel.reach2, momentum.viscosity.laminar != 0.0);
        let (mut room, mut last, mut felt) = (Room::new(), NOWHERE, Felt::default());
        let mut near = [Ranges::default(); 2];
        for (slot, out) in (first..).zip(out) {
            let (row, cell) = (&of.rows[slot], of.cell(slot));
            if cell != last {
                near[0] = if own { grid.beside(cell, &of.starts) } else { Ranges::default() };
                near[1] = grid.beside(cell, &other.starts);
                last = cell;
            }
            let mut force = Force::<L, D>::new(lanes, constants, row, laminar);
            if own {
                let hidden = of.hidden_sides(slot);
                gather::<L, _, D>(lanes, of, &near[0], row.at(), reach2, hidden, &mut room, &mut force);
                // The other of the pair counts the other half.
                force.friction = lanes.mul(force.friction, lanes.splat(0.5));
            }
            if !near[1].filled().is_empty() {
                if laminar {
                    // Velocities of boundaries are mirrored, so that a pair slides twice as fast as it does at the face.
                    force.friction = lanes.add(force.friction, force.friction);
                }
                let hidden = of.hidden_faces(slot, other);
                gather::<L, _, D>(lanes, other, &near[1], row.at(), reach2, hidden, &mut room, &mut force);
                if laminar {
                    force.friction = lanes.mul(force.friction, lanes.splat(0.5));
                }
            }
            let [x, y, z] = lanes.totals(&force.acceleration);
            *out = [x + gravity[0], y + gravity[1], z + gravity[2]];
            let sound = momentum.sound * (row.density() * row.density() * row.density());
            felt = felt.and(&Felt {
                friction: lanes.total(force.friction),
                signal: sound + lanes.greatest(force.approach),
                square: out[0] * out[0] + out[1] * out[1] + out[2] * out[2],
            });
        }
        felt
    }
}
