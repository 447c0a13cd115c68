//! A Galerkin solid as a body: what can be measured on it, what it keeps, what it offers analyses without time.

use std::borrow::Cow;

use implicit_statics::{Equilibrium, OutOfBounds};
use sph_core::Vec3;

use super::fields::fields;
use super::solid::GalerkinSolid;
use super::warnings::large_strain;
use crate::bodies::body::{Body, Configuration, Mismatch, StateArray, StaticBody};
use crate::bodies::yielding::beyond_data;
use crate::bodies::{FieldRequest, FieldSource, Outline, Yielding};
use crate::scene::Measured;
use crate::warning::Warning;

impl Body for GalerkinSolid {
    fn configuration(&self) -> Configuration<'_> {
        let rest = self.galerkin.rest();
        let present = rest.iter().enumerate().map(|(a, x)| x + self.galerkin.displacement(a)).collect();
        Configuration { rest, present, cells: &self.outer }
    }

    fn read(&self, of: Measured, a: usize, along: &Vec3) -> f64 {
        match of {
            Measured::Displacement => self.galerkin.displacement(a).dot(along),
            Measured::Position => (self.galerkin.rest()[a] + self.galerkin.displacement(a)).dot(along),
            Measured::Reaction => self.reactions[a].dot(along),
            // The checks leave it no other column.
            _ => 0.0,
        }
    }

    fn fields<'a>(&'a self, shown: &FieldRequest<'a>) -> Box<dyn FieldSource + 'a> {
        fields(self, shown)
    }

    fn stresses(&self, _body: usize) -> Vec<[f64; 6]> {
        self.stresses_at_nodes()
    }

    /// By node: the greatest plastic strain of the points of the cells round it, and its share of what they dissipated.
    fn yielding(&self, _body: usize) -> Vec<Yielding> {
        self.flowed_at_nodes()
    }

    /// Its outer faces, on which nodes lie.
    fn outlines(&self) -> Vec<Outline> {
        vec![Outline::of_cells(self.galerkin.rest().len(), self.outer.clone(), 0.0, false)]
    }

    fn state(&self) -> Vec<StateArray<'_>> {
        let numbers = Cow::Owned(self.galerkin.save());
        vec![StateArray { name: "parameters and history".into(), numbers }]
    }

    fn set_state(&mut self, arrays: &[StateArray<'_>]) -> Result<(), Mismatch> {
        let [array] = arrays else { return Err(Mismatch) };
        if array.numbers.len() != self.galerkin.save().len() {
            return Err(Mismatch);
        }
        self.galerkin.restore(&array.numbers);
        Ok(())
    }
}

impl StaticBody for GalerkinSolid {
    fn refresh(&mut self, level: f64) -> f64 {
        match &self.supports {
            Some(supports) => supports.forces(&mut self.galerkin, level, &mut self.reactions),
            None => self.galerkin.internal(level, &mut self.scratch),
        }
        self.galerkin.energy()
    }

    fn functional(&self, particle: usize, along: Vec3) -> Vec<f64> {
        self.galerkin.functional(&[particle as u32], along)
    }

    /// The least extent of the body: the thickness of a plate.
    fn linear_reach(&self) -> f64 {
        let rest = self.galerkin.rest();
        let ends =
            |axis: usize, pick: fn(f64, f64) -> f64| rest.iter().map(|x| x[axis]).reduce(pick).unwrap_or(0.0);
        (0..3).map(|axis| ends(axis, f64::max) - ends(axis, f64::min)).fold(f64::INFINITY, f64::min)
    }

    /// By the bound of Gerschgorin on the highest frequency of the unloaded body.
    fn stable_step(&mut self) -> f64 {
        let mut sums = vec![0.0; self.unknowns()];
        self.row_sums(0.0, &mut sums);
        let highest = sums.iter().zip(self.masses()).map(|(sum, mass)| sum / mass).fold(0.0, f64::max);
        if highest > 0.0 { 2.0 / highest.sqrt() } else { 0.0 }
    }

    /// Reactions of all nodes, then stress, strain and angle of all nodes.
    fn forces(&self) -> Vec<f64> {
        let mut out: Vec<f64> = self.reactions.iter().flat_map(|force| <[f64; 3]>::from(*force)).collect();
        out.extend(self.at_nodes().iter().flatten());
        out
    }

    fn warnings(&self) -> Vec<Warning> {
        let flowed = self.galerkin.flowed();
        let beyond = beyond_data(flowed.iter().filter_map(|[strain, _]| Some((*strain, self.data_until?))));
        large_strain(self.galerkin.greatest_strain(), !flowed.is_empty()).into_iter().chain(beyond).collect()
    }
}

/// All of it is that of the solid.
impl Equilibrium for GalerkinSolid {
    fn unknowns(&self) -> usize {
        self.galerkin.unknowns()
    }

    fn pattern(&self) -> Vec<(usize, usize)> {
        self.galerkin.pattern()
    }

    fn coordinates(&self) -> Option<Vec<[f64; 3]>> {
        self.galerkin.coordinates()
    }

    fn keeps_factor(&self) -> bool {
        self.galerkin.keeps_factor()
    }

    fn internal(&mut self, level: f64, out: &mut [f64]) {
        self.galerkin.internal(level, out);
    }

    fn external(&mut self, level: f64, out: &mut [f64]) {
        self.galerkin.external(level, out);
    }

    fn load_rate(&mut self, level: f64, out: &mut [f64]) {
        self.galerkin.load_rate(level, out);
    }

    fn tangent(&mut self, level: f64, values: &mut [f64]) {
        self.galerkin.tangent(level, values);
    }

    fn tangent_is_of_the_step(&self) -> bool {
        self.galerkin.tangent_is_of_the_step()
    }

    fn has_moving_supports(&self) -> bool {
        self.galerkin.has_moving_supports()
    }

    fn commit(&mut self) {
        self.galerkin.commit();
    }

    fn stress_forces(&self, level: f64) -> f64 {
        self.galerkin.stress_forces(level)
    }

    fn driving_force(&self) -> f64 {
        self.galerkin.driving_force()
    }

    fn update(&mut self, increment: &[f64]) {
        self.galerkin.update(increment);
    }

    fn save(&self) -> Vec<f64> {
        self.galerkin.save()
    }

    fn restore(&mut self, saved: &[f64]) {
        self.galerkin.restore(saved);
    }

    fn energy(&mut self) -> f64 {
        self.galerkin.energy()
    }

    fn masses(&self) -> Vec<f64> {
        self.galerkin.masses()
    }

    fn name_unknown(&self, unknown: usize) -> String {
        self.galerkin.name_unknown(unknown)
    }

    fn within_bounds(&self) -> Result<(), OutOfBounds> {
        self.galerkin.within_bounds()
    }
}
