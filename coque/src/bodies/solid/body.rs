//! A solid as a body: what can be measured on it, what it keeps, and what it offers analyses without time.

use std::borrow::Cow;
use std::ops::DerefMut;

use explicit_dynamics::{Dynamics, Exert};
use peridynamics::{Solid, SolidError, StaticSolid};
use sph_core::Vec3;

use super::fields::{fields, stress_of};
use crate::bodies::body::{Body, Configuration, DynamicBody, Mismatch, StateArray, StaticBody};
use crate::bodies::{FieldRequest, FieldSource, NotShared, Outline, Yielding};
use crate::ranks::Ranks;
use crate::scene::Measured;

impl Body for Solid {
    fn configuration(&self) -> Configuration<'_> {
        let block = self.block();
        let present = (0..self.len()).map(|a| self.position(a)).collect();
        Configuration { rest: &block.positions, present, cells: &block.cells }
    }

    fn read(&self, of: Measured, a: usize, along: &Vec3) -> f64 {
        match of {
            Measured::Displacement => self.displacement(a).dot(along),
            Measured::Position => self.position(a).dot(along),
            Measured::Velocity => self.velocity(a).dot(along),
            Measured::Reaction => self.reaction(a).dot(along),
            Measured::ReactionMoment => self.position(a).cross(&self.reaction(a)).dot(along),
            Measured::Director | Measured::Rotation => self.director(a).map_or(0.0, |d| d.dot(along)),
            Measured::Damage => self.damage(a),
            Measured::FractureEnergy => self.fracture_energy(a),
            Measured::StrainEnergy => self.strain_energy(a),
            Measured::Pieces => self.fragments().len() as f64,
            // The checks leave a solid no other column.
            _ => 0.0,
        }
    }

    fn fields<'a>(&'a self, shown: &FieldRequest<'a>) -> Box<dyn FieldSource + 'a> {
        fields(self, shown)
    }

    fn stresses(&self, _body: usize) -> Vec<[f64; 6]> {
        (0..self.len()).map(|a| stress_of(self, a)).collect()
    }

    fn yielding(&self, _body: usize) -> Vec<Yielding> {
        let volumes = &self.block().volumes;
        let of = |node: usize| {
            let plastic_strain = self.plastic_strain(node)?;
            let dissipated = self.plastic_work(node)? * volumes[node];
            Some(Yielding { plastic_strain, dissipated, ..Yielding::default() })
        };
        (0..self.len()).map_while(of).collect()
    }

    fn outlines(&self) -> Vec<Outline> {
        let least = self.block().spacing.into_iter().filter(|own| *own > 0.0).fold(f64::INFINITY, f64::min);
        vec![Outline::of_particles(self.len(), 0.5 * least)]
    }

    fn state(&self) -> Vec<StateArray<'_>> {
        let [rows, rates] = self.motion().map(<[[f64; 4]]>::as_flattened);
        let [bonds, energies, works] = self.broken();
        let owned =
            |name: &'static str, numbers| StateArray { name: name.into(), numbers: Cow::Owned(numbers) };
        let [plastic, past] = self.flowed();
        let mut all = vec![
            StateArray::new("positions and directors", rows),
            StateArray::new("their rates", rates),
            owned("broken bonds", bonds),
            owned("energies of broken bonds", energies),
            owned("work on bonds", works),
        ];
        if !plastic.is_empty() {
            all.extend([
                owned("plastic extensions of bonds", plastic),
                owned("plastic strains and works", past),
            ]);
        }
        all
    }

    fn set_state(&mut self, arrays: &[StateArray<'_>]) -> Result<(), Mismatch> {
        let [rows, rates, broken @ ..] = arrays else { return Err(Mismatch) };
        let [bonds, energies, works, flowed @ ..] = broken else { return Err(Mismatch) };
        let flowed = match flowed {
            [] => [&[][..]; 2],
            [plastic, past] => [&plastic.numbers[..], &past.numbers],
            _ => return Err(Mismatch),
        };
        let (rows, left) = rows.numbers.as_chunks();
        let (rates, over) = rates.numbers.as_chunks();
        let broken = [bonds, energies, works].map(|array| array.numbers.as_ref());
        let fits = left.is_empty()
            && over.is_empty()
            && self.take_up([rows, rates], broken)
            && self.take_up_flow(flowed);
        if fits { Ok(()) } else { Err(Mismatch) }
    }
}

impl DynamicBody for Solid {
    fn share(&mut self, ranks: &Ranks) -> Result<(), NotShared> {
        Solid::share(self, ranks.peers()).map_err(|refused| match refused {
            SolidError::NotShared(what) => NotShared::Part(what),
            _ => NotShared::Kind,
        })
    }

    fn bring(&mut self) {
        Solid::bring(self);
    }

    fn push(&mut self, exert: Exert) -> Result<(), Exert> {
        Solid::push(self, exert);
        Ok(())
    }

    fn at_rest(&mut self) -> Option<Box<dyn StaticBody + '_>> {
        // Of bonds that yield the tangent hangs on the way.
        self.check_statics().ok()?;
        Some(Box::new(StaticSolid::lent(self)))
    }
}

impl<S: DerefMut<Target = Solid> + Send> Body for StaticSolid<S> {
    fn configuration(&self) -> Configuration<'_> {
        self.solid().configuration()
    }

    fn read(&self, of: Measured, particle: usize, along: &Vec3) -> f64 {
        self.solid().read(of, particle, along)
    }

    fn fields<'a>(&'a self, shown: &FieldRequest<'a>) -> Box<dyn FieldSource + 'a> {
        fields(self.solid(), shown)
    }

    fn stresses(&self, body: usize) -> Vec<[f64; 6]> {
        self.solid().stresses(body)
    }

    fn yielding(&self, body: usize) -> Vec<Yielding> {
        self.solid().yielding(body)
    }

    fn outlines(&self) -> Vec<Outline> {
        self.solid().outlines()
    }

    fn state(&self) -> Vec<StateArray<'_>> {
        self.solid().state()
    }

    fn set_state(&mut self, arrays: &[StateArray<'_>]) -> Result<(), Mismatch> {
        Body::set_state(self.solid_mut(), arrays)
    }
}

impl<S: DerefMut<Target = Solid> + Send> StaticBody for StaticSolid<S> {
    fn refresh(&mut self, level: f64) -> f64 {
        self.evaluate(level);
        self.solid().internal_energy()
    }

    fn functional(&self, particle: usize, along: Vec3) -> Vec<f64> {
        StaticSolid::functional(self, &[particle as u32], along)
    }

    /// The thickness of a plate, else the spacing of nodes.
    fn linear_reach(&self) -> f64 {
        let block = self.solid().block();
        match self.solid().director(0) {
            Some(_) => block.spacing[2],
            None => block.greatest_spacing(),
        }
    }

    fn stable_step(&mut self) -> f64 {
        Dynamics::stable_step(self.solid_mut(), 1.0).map_or(0.0, |step| step.dt)
    }

    /// Reactions of all nodes, then stresses of all nodes.
    fn forces(&self) -> Vec<f64> {
        let (solid, nodes) = (self.solid(), 0..self.solid().len());
        let mut out: Vec<f64> = nodes.clone().flat_map(|a| <[f64; 3]>::from(solid.reaction(a))).collect();
        out.extend(nodes.flat_map(|a| stress_of(solid, a)));
        out
    }
}
