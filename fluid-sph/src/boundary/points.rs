//! Walls and structures as one set of particles.
//!
//! Their work on the fluid is that of their motion, and that of the pressure that they have of themselves.
//!
//! A pair of fluid a and boundary w exchanges `T + U` at the rate of the force on a times v_w, as between bodies, and besides
//!
//! ```text
//! −m (P_w/ρ_w²) m F (v_a − v_w)·r_aw:   summed over a, −m (P_w/ρ_w²) D_w,   D_w = Σ_a m F v_wa·r_wa
//! ```
//!
//! for the pressure of the boundary acts on fluid that comes nearer, and D_w is the rate of density that the boundary would
//! have. Where it has one, that is energy of compression stored in the wall; a pressure carried over from the fluid is no
//! function of any density, and what it takes and gives is work from outside. Rates belong to the middle of a step, forces
//! and pressures to its ends: each end gets half.

use std::ops::Range;

use explicit_dynamics::BoundaryState;
use peers::Exact;
use sph_core::Vec3;

use crate::books::put;
use crate::boundary::check::check;
use crate::boundary::ledger::Ledger;
use crate::boundary::pending::Pending;
use crate::boundary::sides::Thin;
use crate::cells::{Grid, NOWHERE};
use crate::error::FluidError;
use crate::pair::Row;
use crate::parts::{Motion, Parts, Structure, Wall};
use crate::periods::{Copies, Periods};
use crate::sorted::Sorted;
use crate::walls::extrapolated::WallMean;
use crate::walls::motion::Pose;

/// A wall: its particles, and where they are when its motion is zero.
#[derive(Clone, Debug)]
pub(super) struct WallPart {
    pub range: Range<usize>,
    pub rest: Vec<Vec3>,
    pub motion: Option<Motion>,
}

/// A structure: its points, and its sides if it is thin.
#[derive(Clone, Debug)]
struct StructurePart {
    range: Range<usize>,
    thin: Option<usize>,
}

/// All of them, walls first.
#[derive(Clone, Debug, Default)]
pub(crate) struct Boundary {
    /// Places at the end of the step \[L\].
    pub points: Vec<Vec3>,
    /// Mean velocities over the last step \[L/T\].
    pub velocities: Vec<Vec3>,
    /// Densities, where each has its own \[M/L³\].
    pub densities: Vec<f64>,
    /// Forces of the fluid \[F; F/L in a plane\].
    pub forces: Vec<[f64; 3]>,
    /// As the sweeps read them.
    pub sorted: Sorted,
    /// By slot: means of the fluid beside, forces, rates of density.
    pub means: Vec<WallMean>,
    pub accelerations: Vec<[f64; 3]>,
    /// By slot: power that friction takes a unit of mass \[L²/T³\].
    pub powers: Vec<f64>,
    pub rates: Vec<[f64; 2]>,
    /// Where points stand, and their copies across periodic sides.
    pub copies: Copies,
    /// Structures with two sides.
    pub thin: Vec<Thin>,
    /// Greatest way of a point over the last step \[L\].
    pub advance: f64,
    /// Work that is recorded at both ends of a step.
    pub ledger: Ledger,
    /// By structure: where it is to be, of one who marches with others.
    pub(super) pending: Vec<Pending>,
    /// Densities kept.
    kept: Vec<f64>,
    /// By point: bit of its face.
    faces: Vec<u32>,
    pub(super) walls: Vec<WallPart>,
    structures: Vec<StructurePart>,
}

impl Boundary {
    /// The walls and structures of a fluid, where they are at time zero.
    pub fn new(parts: &Parts, reach: f64) -> Result<Self, FluidError> {
        let mut all = Self::default();
        for (number, Wall { points, motion }) in parts.walls.iter().enumerate() {
            if let Some(index) = points.iter().position(|p| !p.iter().all(|x| x.is_finite())) {
                return Err(FluidError::NotFinite { what: "particle of a wall", index });
            }
            let axis =
                motion.as_ref().and_then(|motion| motion.rotation.as_ref()).map(|turn| turn.axis.norm());
            if axis.is_some_and(|length| !(length > 0.0 && length.is_finite())) {
                return Err(FluidError::Axis(number));
            }
            let first = all.points.len();
            let rest: Vec<Vec3> = if motion.is_some() { points.clone() } else { Vec::new() };
            let pose = motion.as_ref().map(|motion| Pose::of(motion, 0.0));
            all.points.extend(points.iter().map(|p| pose.as_ref().map_or(*p, |pose| pose.place(p))));
            all.walls.push(WallPart { range: first..all.points.len(), rest, motion: motion.clone() });
        }
        all.faces.resize(all.points.len(), 0);
        for (number, Structure { layout, state }) in parts.structures.iter().enumerate() {
            check(number, layout, state)?;
            let first = all.points.len();
            all.points.extend(state.points.iter().map(|p| Vec3::from(*p)));
            let thin = layout.thin.as_ref().map(|layout| {
                all.thin.push(Thin::new(all.thin.len(), parts.dimensions, layout, state, reach));
                all.thin.len() - 1
            });
            if all.thin.len() > 16 {
                return Err(FluidError::ThinStructures(all.thin.len()));
            }
            match (thin, &layout.thin) {
                (Some(number), Some(layout)) => {
                    let bits = layout.faces.iter().map(|&face| all.thin[number].bit(face));
                    all.faces.extend(bits);
                }
                _ => all.faces.resize(all.points.len(), 0),
            }
            all.structures.push(StructurePart { range: first..all.points.len(), thin });
        }
        if all.thin.is_empty() {
            all.faces.clear();
        }
        let count = all.points.len();
        if parts.dimensions == 2 {
            all.points.iter_mut().for_each(|point| point.z = 0.0);
        }
        all.velocities = vec![Vec3::zeros(); count];
        all.densities = vec![parts.liquid.density; count];
        all.forces = vec![[0.0; 3]; count];
        all.ledger = Ledger::new(count);
        all.pending = vec![Pending::default(); all.structures.len()];
        Ok(all)
    }

    /// The particles of a wall.
    pub fn wall(&self, number: usize) -> Range<usize> {
        self.walls[number].range.clone()
    }

    /// The points of a structure.
    pub fn structure(&self, number: usize) -> Range<usize> {
        self.structures[number].range.clone()
    }

    /// Number of walls.
    pub fn walls(&self) -> usize {
        self.walls.len()
    }

    /// The points of all structures.
    pub fn wet(&self) -> Range<usize> {
        let walls = self.walls.last().map_or(0, |wall| wall.range.end);
        walls..self.points.len()
    }

    /// What a particle is called.
    pub fn name(&self, particle: usize) -> String {
        let of = |kind: &str, number: usize, first: usize| {
            format!("particle {} of {kind} {number}", particle - first)
        };
        let wall = self.walls.iter().position(|wall| wall.range.contains(&particle));
        let structure = self.structures.iter().position(|structure| structure.range.contains(&particle));
        match (wall, structure) {
            (Some(k), _) => of("wall", k, self.walls[k].range.start),
            (_, Some(k)) => of("structure", k, self.structures[k].range.start),
            _ => format!("boundary particle {particle}"),
        }
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        let rest: usize = self.walls.iter().map(|wall| wall.rest.len()).sum();
        let slots = (size_of::<WallMean>() + 24 + 8 + 16) * self.means.len();
        (80 + 16) * self.points.len() + 4 * self.faces.len() + 24 * rest + slots + self.sorted.bytes()
    }

    /// Puts walls where they are at a time, and finds their velocities by the way they went in so long a time \[T\].
    pub fn move_walls(&mut self, time: f64, dt: f64) {
        for WallPart { range, rest, motion } in &self.walls {
            let Some(motion) = motion else { continue };
            let pose = Pose::of(motion, time);
            for (point, rest) in range.clone().zip(rest) {
                let end = pose.place(rest);
                let way = end - self.points[point];
                self.advance = self.advance.max(way.norm());
                self.velocities[point] = way / dt;
                self.points[point] = end;
            }
        }
    }

    /// The greatest way of a wall's particle to where it is at a time \[L\].
    pub fn way_to(&self, time: f64) -> f64 {
        let mut farthest: f64 = 0.0;
        for WallPart { range, rest, motion } in &self.walls {
            let Some(motion) = motion else { continue };
            let pose = Pose::of(motion, time);
            for (point, rest) in self.points[range.clone()].iter().zip(rest) {
                farthest = farthest.max((pose.place(rest) - point).norm());
            }
        }
        farthest
    }

    /// Puts a structure where it is.
    pub fn set_structure(
        &mut self,
        number: usize,
        dimensions: usize,
        end: &BoundaryState,
        velocities: &[[f64; 3]],
    ) {
        let StructurePart { range, thin } = &self.structures[number];
        for ((point, place), velocity) in range.clone().zip(&end.points).zip(velocities) {
            let (mut place, mut velocity) = (Vec3::from(*place), Vec3::from(*velocity));
            if dimensions == 2 {
                (place.z, velocity.z) = (0.0, 0.0);
            }
            self.advance = self.advance.max((place - self.points[point]).norm());
            self.points[point] = place;
            self.velocities[point] = velocity;
        }
        if let Some(thin) = thin {
            self.thin[*thin].place(end);
        }
    }

    /// Sorts those that are near, all if nothing is said, into the cells of the fluid, where they were so long a time before the end of the
    /// step \[T\]; with copies in a width of periodic sides \[L\]. Those that are not present, all are if nothing is said, stand nowhere.
    pub fn sort(
        &mut self,
        grid: &Grid,
        before: f64,
        near: &[bool],
        periods: Option<(&Periods, f64)>,
        present: &[bool],
    ) {
        let Self { points, velocities, copies, .. } = self;
        let at = |i: usize| points[i] - velocities[i] * before;
        if let Some((periods, width)) = periods {
            copies.find(periods, points.len(), width, at);
        }
        // Beyond all cells; where they are cut off and have no end, all are near.
        let beyond = [f64::INFINITY; 3];
        let place = |number: usize, _: &[u32]| match is_one(near, number) {
            true if !is_one(present, copies.source(number)) => None,
            true => Some(copies.place(number, at).into()),
            false => Some(beyond),
        };
        self.sorted.sort(1, grid, copies.all(points.len()), place);
        let Sorted { order, faces, left, .. } = &mut self.sorted;
        if !copies.is_empty() {
            left.clear();
            left.extend(order.iter().map(|&number| number as usize >= points.len()));
        }
        faces.clear();
        if !self.faces.is_empty() {
            faces.extend(order.iter().map(|&i| self.faces[i as usize]));
        }
        let count = self.sorted.len();
        self.means.resize(count, WallMean::default());
        self.accelerations.resize(count, [0.0; 3]);
        self.powers.resize(count, 0.0);
        self.rates.resize(count, [0.0; 2]);
    }

    /// Fills what the sweeps read of them, where they were so long a time before the end of the step \[T\].
    pub fn fill(&mut self, dimensions: usize, grid: &Grid, far: Row, before: f64) {
        let (points, velocities, copies) = (&self.points, &self.velocities, &self.copies);
        self.sorted.fill(1, dimensions, grid, far, |number, _, _, _| {
            let place = copies.place(number, |i| points[i] - velocities[i] * before);
            Row::new(place, 0.0, velocities[copies.source(number)], 0.0)
        });
    }

    /// Gives copies the pressures of their points, and the velocities that these hold the fluid with.
    pub fn press_copies(&mut self) {
        let Sorted { slots, rows, .. } = &mut self.sorted;
        self.copies.each(self.points.len(), slots, |copy, own| {
            let row = rows[own];
            rows[copy].press(row.density(), row.p_over_rho2());
            rows[copy].set_velocity(row.velocity());
        });
    }

    /// Hands forces found by slot back to the points that are one's own, all if nothing is said.
    pub fn keep_forces(&mut self, mass: f64, owns: &[bool]) {
        for (point, (force, &slot)) in self.forces.iter_mut().zip(&self.sorted.slots).enumerate() {
            if !is_one(owns, point) {
                continue;
            }
            let acceleration = if slot == NOWHERE { [0.0; 3] } else { self.accelerations[slot as usize] };
            *force = acceleration.map(|a| mass * a);
        }
    }

    /// Keeps the densities for [`Boundary::recall_densities`].
    pub fn remember_densities(&mut self) {
        self.kept.clone_from(&self.densities);
    }

    /// Puts the densities back that were kept.
    pub fn recall_densities(&mut self) {
        self.densities.clone_from(&self.kept);
    }

    /// The greatest speed of a point \[L/T\].
    pub fn speed(&self) -> f64 {
        self.velocities.iter().map(|v| v.norm_squared()).fold(0.0, f64::max).sqrt()
    }

    /// Power of the motion of all points on the fluid \[F L/T\]: minus that of the fluid on them.
    pub fn power(&self) -> f64 {
        let power = |(force, velocity): (&[f64; 3], &Vec3)| -Vec3::from(*force).dot(velocity);
        self.forces.iter().zip(&self.velocities).map(power).sum()
    }

    /// Power of the pressure of all points on the fluid, over the mass of a particle, from rows and rates as they are.
    pub fn pressing(&self) -> f64 {
        let power = |(row, rate): (&Row, &[f64; 2])| -row.p_over_rho2() * rate[0];
        self.sorted.rows.iter().zip(&self.rates).map(power).sum()
    }

    /// Adds what friction takes at the points that are swept.
    pub fn rub(&self, sum: &mut Exact) {
        (0..self.sorted.len())
            .filter(|&slot| !self.sorted.is_left(slot))
            .for_each(|slot| put(sum, self.powers[slot]));
    }

    /// Work of the half step after the last forces, from the rates in the middle of a step, of the points that are one's own: of their
    /// pressure over the mass of a particle, and of their motion over the time, which the ledger then tells.
    pub fn work_before(&mut self, dt: f64, owns: &[bool]) -> [Exact; 2] {
        let Self { sorted, rates, ledger: Ledger { shares, owed, time }, .. } = self;
        let mut pressing = Exact::new();
        for (point, &slot) in
            sorted.slots[..owed.len()].iter().enumerate().filter(|(point, _)| is_one(owns, *point))
        {
            let rate = if slot == NOWHERE { 0.0 } else { rates[slot as usize][0] };
            owed[point] = 0.5 * dt * rate;
            put(&mut pressing, -shares[point] * owed[point]);
        }
        *time = 0.5 * dt;
        [pressing, self.powers_of_motion(owns)]
    }

    /// Work of the half step before the present forces, likewise, and the time; asked twice, the second time there is none.
    pub fn work_after(&mut self, owns: &[bool]) -> ([Exact; 2], f64) {
        let Self { sorted, ledger: Ledger { shares, owed, time }, .. } = self;
        let mut pressing = Exact::new();
        for (point, &slot) in
            sorted.slots[..owed.len()].iter().enumerate().filter(|(point, _)| is_one(owns, *point))
        {
            let share = if slot == NOWHERE { 0.0 } else { sorted.rows[slot as usize].p_over_rho2() };
            shares[point] = share;
            put(&mut pressing, -share * std::mem::take(&mut owed[point]));
        }
        let time = std::mem::take(time);
        ([pressing, self.powers_of_motion(owns)], time)
    }

    /// The terms of [`Boundary::power`], added exactly.
    fn powers_of_motion(&self, owns: &[bool]) -> Exact {
        let mut sum = Exact::new();
        for (point, (force, velocity)) in self.forces.iter().zip(&self.velocities).enumerate() {
            if is_one(owns, point) {
                put(&mut sum, -Vec3::from(*force).dot(velocity));
            }
        }
        sum
    }
}

/// Whether it is one of those marked; all are if nothing is said.
fn is_one(marked: &[bool], point: usize) -> bool {
    marked.get(point).is_none_or(|marked| *marked)
}
