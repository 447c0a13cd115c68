//! A fluid, its walls and the structures in it as one body that is marched.

use std::any::Any;
use std::borrow::Cow;
use std::ops::Range;

use contact::NodalContact;
use explicit_dynamics::{
    Bounds, Dynamics, Instant, MarchError, OutOfBounds, Shortened, StableStep, Step, TwoClocks, Wetted, Work,
};
use fluid_sph::{Fluid, FluidError};
use sph_core::{Cell, Vec3};

use super::gauges::at_point;
use super::layout::{Layout, Place};
use super::watch::Watch;
use crate::bodies::body::{Body, Configuration, Diagnostics, DynamicBody, Mismatch, StateArray};
use crate::bodies::fluid::escaped::{Sides, lost};
use crate::bodies::fluid::figures::Speeds;
use crate::bodies::fluid::{fields, figures};
use crate::bodies::together::{JointedBodies, MayBeRigid, Parts, kept_between, take_up_between};
use crate::bodies::{ContactNow, FieldRequest, FieldSource, NotShared, Outline, With, Yielding};
use crate::ranks::Ranks;
use crate::scene::Measured;

/// A structure that a fluid wets, as the application asks of it.
pub(in crate::bodies) trait Structure: Body + Wetted + Any {}

impl<S: Body + Wetted + Any> Structure for S {}

impl MayBeRigid for dyn Structure {
    fn any(&self) -> &dyn Any {
        self
    }

    fn any_mut(&mut self) -> &mut dyn Any {
        self
    }
}

/// A fluid and structures on their clocks.
pub(super) type Clocks = TwoClocks<Fluid, dyn Structure>;

/// Name of the array of the clocks in a state; those of bodies have their names in front.
const OF_CLOCKS: &str = "clocks";
/// The same of what was seen where the run recorded.
const OF_WATCH: &str = "watch";

/// A fluid with its walls and the structures in it.
pub(super) struct Coupled {
    pub clocks: Clocks,
    pub layout: Layout,
    /// Particles at rest, all bodies one behind the other \[L\].
    pub rest: Vec<Vec3>,
    /// Cells of the structures, by these numbers.
    pub cells: Vec<Cell>,
    /// `ρ₀c₀Δt/(ρ_s t)` of each structure at the start \[–\].
    pub added_mass: Vec<f64>,
    /// Basins that the fluid may leave.
    pub basins: Vec<Sides>,
    /// Speeds of the fluid so far.
    pub speeds: Speeds,
    /// What is looked at where a run records.
    pub watch: Watch,
    /// Those who march it together; none where one process does.
    pub ranks: Option<Ranks>,
}

impl Coupled {
    fn structure(&self, number: usize) -> Option<&dyn Structure> {
        self.clocks.structures().nth(number)
    }

    /// The structure that one of the bodies is, and its particles.
    fn structure_of(&self, body: usize) -> Option<(usize, &Range<usize>)> {
        let number = body.checked_sub(1)?;
        self.layout.structures.get(number).map(|range| (number, range))
    }

    /// Where the fluid is looked at for a pressure or a level.
    fn looked_at(&self, (piece, particle): (usize, usize)) -> Vec3 {
        let positions = self.clocks.fluid().wall_positions(piece);
        positions.get(particle).copied().unwrap_or_default()
    }
}

impl Body for Coupled {
    fn configuration(&self) -> Configuration<'_> {
        let fluid = self.clocks.fluid();
        let mut present = fluid.positions().to_vec();
        for structure in self.clocks.structures() {
            present.extend(structure.configuration().present);
        }
        for piece in 0..self.layout.pieces.len() {
            present.extend(fluid.wall_positions(piece).iter().map(|x| fluid.within(*x)));
        }
        Configuration { rest: &self.rest, present, cells: &self.cells }
    }

    fn joints_exert(&self, body: usize, joint: Option<usize>) -> [Vec3; 2] {
        let joints = self.clocks.bracing().and_then(|own| (own as &dyn Any).downcast_ref::<JointedBodies>());
        let name = self.layout.names.get(body);
        joints.zip(name).map_or([Vec3::zeros(); 2], |(joints, name)| joints.exerted(name, joint))
    }

    fn counts_turns(&self, number: usize) -> bool {
        match self.layout.place(number) {
            Place::Structure(k, own) => {
                self.structure(k).is_some_and(|structure| structure.counts_turns(own))
            }
            _ => false,
        }
    }

    fn read(&self, of: Measured, number: usize, along: &Vec3) -> f64 {
        let fluid = self.clocks.fluid();
        match self.layout.place(number) {
            Place::Fluid(a) => match of {
                Measured::Position => fluid.positions()[a].dot(along),
                Measured::Displacement => fluid.displacement(a).dot(along),
                Measured::Velocity => fluid.velocities()[a].dot(along),
                Measured::Pressure => fluid.liquid().pressure(fluid.densities()[a]),
                Measured::Density => fluid.densities()[a],
                _ => 0.0,
            },
            Place::Structure(k, a) if of == Measured::LinkForce => {
                let links = self.layout.links.clone();
                links.map(|number| self.clocks.force_on(number, k, a)).sum::<Vec3>().dot(along)
            }
            Place::Structure(k, a) => self.clocks.read(&self.layout.contacts, of, [k, a], along),
            Place::Wall(piece, a) => match of {
                Measured::Position => self.looked_at((piece, a)).dot(along),
                Measured::Displacement => (self.looked_at((piece, a)) - self.rest[number]).dot(along),
                of => at_point(of, fluid, self.looked_at((piece, a))),
            },
            Place::Piece(piece) => {
                let shares = self.layout.shares.get(piece).into_iter().flatten();
                let shared = shares.map(|share| {
                    let force = Vec3::from(fluid.wall_forces(share.piece)[share.particle]);
                    let place = fluid.wall_positions(share.piece)[share.particle];
                    (place, force.component_mul(&share.part))
                });
                match of {
                    Measured::Moment => {
                        let own = fluid.wall_moment(piece, Vec3::zeros());
                        (own + shared.map(|(place, force)| place.cross(&force)).sum::<Vec3>()).dot(along)
                    }
                    _ => (fluid.wall_force(piece) + shared.map(|(_, force)| force).sum::<Vec3>()).dot(along),
                }
            }
            Place::Whole(structure) => match of {
                Measured::Moment => fluid.structure_moment(structure, Vec3::zeros()).dot(along),
                _ => fluid.structure_force(structure).dot(along),
            },
            Place::Gauge(gauge) => self.layout.gauges.get(gauge).map_or(0.0, |gauge| gauge.read(of, fluid)),
        }
    }

    /// Those of the fluid.
    fn fields<'a>(&'a self, shown: &FieldRequest<'a>) -> Box<dyn FieldSource + 'a> {
        fields::of_fluid(self.clocks.fluid(), shown)
    }

    fn bodies(&self) -> Vec<&str> {
        self.layout.names.iter().map(String::as_str).collect()
    }

    fn fields_of<'a>(&'a self, body: usize, shown: &FieldRequest<'a>) -> Box<dyn FieldSource + 'a> {
        let structures = self.layout.structures.len();
        match body.checked_sub(1) {
            Some(number) if number < structures => match self.structure(number) {
                Some(structure) => {
                    let own = if shown.contact {
                        structure.fields_with_contact(shown, self.contact_fields(body))
                    } else {
                        structure.fields(shown)
                    };
                    let rest = &self.rest[self.layout.structures[number].clone()];
                    self.clocks.with_tools(&self.layout.contacts, (number, rest), own, shown.units)
                }
                None => self.fields(shown),
            },
            Some(number) => {
                let pieces = self.layout.walls.get(number - structures).cloned().unwrap_or_default();
                fields::of_walls(self.clocks.fluid(), pieces, shown)
            }
            None => self.fields(shown),
        }
    }

    fn place(&self, particle: usize) -> (usize, usize) {
        match self.layout.place(particle) {
            Place::Structure(number, own) => (number + 1, own),
            _ => (0, particle),
        }
    }

    fn nodal_contact(&self, body: usize) -> Vec<NodalContact> {
        let Some((number, range)) = self.structure_of(body) else { return Vec::new() };
        self.clocks.nodal_contact(&self.layout.contacts, number, range.len())
    }

    fn yielding(&self, body: usize) -> Vec<Yielding> {
        let structure =
            self.structure_of(body).and_then(|(number, _)| self.clocks.each().get(number).copied());
        structure.map_or_else(Vec::new, |part| part.yielding(0))
    }

    fn gaps(&self, body: usize, particles: &[u32]) -> Vec<f64> {
        let Some((number, _)) = self.structure_of(body) else { return vec![f64::INFINITY; particles.len()] };
        self.clocks.gaps(&self.layout.contacts, number, particles)
    }

    fn contacts(&self) -> Vec<ContactNow> {
        let behind = |own: ContactNow| ContactNow {
            body: own.body + 1,
            with: match own.with {
                With::Body(other) => With::Body(other + 1),
                with => with,
            },
            ..own
        };
        self.clocks.contacts(&self.layout.contacts).into_iter().map(behind).collect()
    }

    fn has_tools(&self, body: usize) -> bool {
        let structure =
            self.structure_of(body).and_then(|(number, _)| Some((number, self.structure(number)?)));
        let tools = |number| !self.clocks.tools_of(&self.layout.contacts, number).is_empty();
        structure.is_some_and(|(number, of)| of.has_tools(0) || tools(number))
    }

    fn outlines(&self) -> Vec<Outline> {
        let names = self.layout.names.iter().skip(1).zip(&self.layout.structures);
        let named = |(structure, (name, range)): (&dyn Structure, (&String, &Range<usize>))| {
            let own = structure.outlines().into_iter();
            own.map(|own| own.named(name, range.start)).collect::<Vec<_>>()
        };
        self.clocks.structures().zip(names).flat_map(named).collect()
    }

    fn diagnostics(&self) -> Diagnostics {
        let lost = lost(self.clocks.fluid(), &self.basins);
        let counts = self.clocks.counts();
        let mut found = figures::found(self.clocks.fluid(), &counts, &self.added_mass, self.speeds, lost);
        found.warnings.extend(self.watch.warnings());
        found
    }

    fn state(&self) -> Vec<StateArray<'_>> {
        let named =
            |of: &str, name: &str, numbers| StateArray { name: Cow::Owned(format!("{of}: {name}")), numbers };
        let fluid = self.clocks.fluid().state();
        let mut all: Vec<_> =
            fluid.into_iter().map(|(name, numbers)| named(&self.layout.names[0], name, numbers)).collect();
        let mut clocks = self.clocks.state();
        clocks.extend([self.speeds.greatest, self.speeds.fast, self.speeds.ran]);
        all.push(StateArray { name: OF_CLOCKS.into(), numbers: Cow::Owned(clocks) });
        all.push(StateArray { name: OF_WATCH.into(), numbers: Cow::Owned(self.watch.state()) });
        for (structure, name) in self.clocks.structures().zip(&self.layout.names[1..]) {
            all.extend(structure.state().into_iter().map(|array| named(name, &array.name, array.numbers)));
        }
        all.extend(kept_between(&self.clocks.kept()));
        all
    }

    fn set_state(&mut self, arrays: &[StateArray<'_>]) -> Result<(), Mismatch> {
        // Nothing is changed by the state of another body: what a part took up it gives back.
        let own: Vec<StateArray<'static>> = self.state().into_iter().map(owned).collect();
        let done = self.take_up(arrays);
        if done.is_err() {
            let _ = self.take_up(&own);
        }
        done
    }
}

impl Coupled {
    fn take_up(&mut self, arrays: &[StateArray<'_>]) -> Result<(), Mismatch> {
        let of = |part: &str| -> Vec<StateArray<'_>> {
            let start = format!("{part}: ");
            let own = arrays.iter().filter_map(|array| {
                let name = array.name.strip_prefix(&start)?;
                Some(StateArray { name: Cow::Owned(name.into()), numbers: Cow::Borrowed(&array.numbers) })
            });
            own.collect()
        };
        let fluid = of(&self.layout.names[0]);
        let fluid: Vec<(&str, &[f64])> =
            fluid.iter().map(|array| (array.name.as_ref(), array.numbers.as_ref())).collect();
        self.clocks.fluid_mut().set_state(&fluid).map_err(|_| Mismatch)?;
        let parts: Vec<_> =
            self.layout.names[1..=self.layout.structures.len()].iter().map(|name| of(name)).collect();
        for (structure, part) in self.clocks.structures_mut().zip(&parts) {
            structure.set_state(part)?;
        }
        if !take_up_between(&mut self.clocks, arrays) {
            return Err(Mismatch);
        }
        let clocks = arrays.iter().find(|array| array.name == OF_CLOCKS).ok_or(Mismatch)?;
        let (clocks, &[greatest, fast, ran]) = clocks.numbers.split_last_chunk().ok_or(Mismatch)?;
        if !self.clocks.set_state(clocks) {
            return Err(Mismatch);
        }
        let watch = arrays.iter().find(|array| array.name == OF_WATCH).ok_or(Mismatch)?;
        if !self.watch.set_state(&watch.numbers) {
            return Err(Mismatch);
        }
        self.speeds = Speeds { greatest, fast, ran, ..self.speeds };
        Ok(())
    }
}

fn owned(array: StateArray<'_>) -> StateArray<'static> {
    StateArray { name: Cow::Owned(array.name.into_owned()), numbers: Cow::Owned(array.numbers.into_owned()) }
}

impl Dynamics for Coupled {
    fn evaluate(&mut self, at: Instant) -> f64 {
        self.clocks.evaluate(at)
    }

    fn kick(&mut self, step: &Step) -> Work {
        let work = self.clocks.kick(step);
        self.speeds.watch(self.clocks.fluid(), self.ranks.as_mut());
        work
    }

    fn drift(&mut self, step: &Step) {
        self.clocks.drift(step);
    }

    fn advance(&mut self, step: &Step) -> Work {
        let work = self.clocks.advance(step);
        self.speeds.watch(self.clocks.fluid(), self.ranks.as_mut());
        work
    }

    fn stable_step(&mut self, safety: f64) -> Result<StableStep, MarchError> {
        self.clocks.stable_step(safety)
    }

    fn shortened(&mut self, stable: f64, safety: f64) -> f64 {
        self.clocks.shortened(stable, safety)
    }

    fn within_bounds(&self, bounds: Bounds) -> Result<(), OutOfBounds> {
        self.clocks.within_bounds(bounds)
    }

    fn stop(&mut self) {
        self.clocks.stop();
    }
}

impl DynamicBody for Coupled {
    fn share(&mut self, ranks: &Ranks) -> Result<(), NotShared> {
        self.clocks.fluid_mut().share(ranks.peers()).map_err(|refused| match refused {
            FluidError::NotShared(what) => NotShared::Part(what),
            _ => NotShared::Kind,
        })?;
        self.ranks = Some(ranks.clone());
        Ok(())
    }

    fn bring(&mut self) {
        let Some(ranks) = &mut self.ranks else { return };
        self.clocks.fluid_mut().bring();
        self.speeds.bring(ranks);
    }

    fn look(&mut self, time: f64) {
        self.watch.look(time, &self.clocks);
    }

    fn slowed(&self) -> Shortened {
        self.clocks.slowed()
    }
}
