//! The shortest body that is not ours: beads of unit mass on springs of unit stiffness, pulled at the end by the level.
//!
//! `Dynamics` and `Equilibrium` are its mechanics; what coque asks beside them begins at [`Body`].

use std::borrow::Cow;

use coque::scene::Measured;
use coque::{At, Body, Configuration, Connectivity, DynamicBody, FieldSource, FieldWriter, Kind, StaticBody};
use coque::{FieldRequest, Mismatch, Part, StateArray, Values, rows};
use explicit_dynamics::{Bounds, Dynamics, Instant, MarchError, StableStep, Step, Work};
use implicit_statics::Equilibrium;
use sph_core::Vec3;

pub struct Chain {
    rest: Vec<Vec3>,
    /// Displacement, velocity and force of each bead along x.
    u: Vec<f64>,
    v: Vec<f64>,
    f: Vec<f64>,
}

impl Chain {
    pub fn new(beads: usize) -> Self {
        let rest = (1..=beads).map(|i| Vec3::new(i as f64, 0.0, 0.0)).collect();
        Self { rest, u: vec![0.0; beads], v: vec![0.0; beads], f: vec![0.0; beads] }
    }

    fn stretch(&self, i: usize) -> f64 {
        self.u[i] - if i > 0 { self.u[i - 1] } else { 0.0 }
    }

    fn pull(&self, i: usize) -> f64 {
        self.stretch(i) - if i + 1 < self.u.len() { self.stretch(i + 1) } else { 0.0 }
    }
}

impl Dynamics for Chain {
    fn evaluate(&mut self, at: Instant) -> f64 {
        self.f = (0..self.u.len()).map(|i| -self.pull(i)).collect();
        let last = self.f.len() - 1;
        self.f[last] += at.level;
        self.energy()
    }

    fn kick(&mut self, step: &Step) -> Work {
        let (decay, last, mut work) = (step.decay(), self.v.len() - 1, Work::default());
        for (i, v) in self.v.iter_mut().enumerate() {
            let before = *v;
            *v = decay.kicked(before, step.kick * self.f[i]);
            let mean = 0.5 * (before + *v);
            work.kinetic += 0.5 * mean * mean;
            work.dissipated += step.damping * mean * mean * step.kick;
            work.external += if i == last { step.from.level * mean * step.kick } else { 0.0 };
        }
        work
    }

    fn drift(&mut self, step: &Step) {
        self.u.iter_mut().zip(&self.v).for_each(|(u, v)| *u += v * step.drift());
    }

    fn stable_step(&mut self, safety: f64) -> Result<StableStep, MarchError> {
        Ok(StableStep { dt: safety, holds: u64::MAX })
    }

    fn within_bounds(&self, _: Bounds) -> Result<(), explicit_dynamics::OutOfBounds> {
        Ok(())
    }

    fn stop(&mut self) {
        self.v.fill(0.0);
    }
}

impl Equilibrium for Chain {
    fn unknowns(&self) -> usize {
        self.u.len()
    }

    fn pattern(&self) -> Vec<(usize, usize)> {
        (0..self.u.len()).flat_map(|i| (i.saturating_sub(1)..=i).map(move |j| (i, j))).collect()
    }

    fn internal(&mut self, _: f64, out: &mut [f64]) {
        out.iter_mut().enumerate().for_each(|(i, out)| *out = self.pull(i));
    }

    fn external(&mut self, level: f64, out: &mut [f64]) {
        out.fill(0.0);
        out[self.u.len() - 1] = level;
    }

    fn load_rate(&mut self, _: f64, out: &mut [f64]) {
        self.external(1.0, out);
    }

    fn tangent(&mut self, _: f64, values: &mut [f64]) {
        let last = self.u.len() - 1;
        let entry = |(i, j): (usize, usize)| if i != j { -1.0 } else { 2.0 - f64::from(i == last) };
        values.iter_mut().zip(self.pattern()).for_each(|(value, at)| *value = entry(at));
    }

    fn update(&mut self, increment: &[f64]) {
        self.u.iter_mut().zip(increment).for_each(|(u, more)| *u += more);
    }

    fn save(&self) -> Vec<f64> {
        self.u.clone()
    }

    fn restore(&mut self, saved: &[f64]) {
        self.u.copy_from_slice(saved);
    }

    fn energy(&mut self) -> f64 {
        (0..self.u.len()).map(|i| 0.5 * self.stretch(i).powi(2)).sum()
    }

    fn masses(&self) -> Vec<f64> {
        vec![1.0; self.u.len()]
    }

    fn name_unknown(&self, unknown: usize) -> String {
        format!("bead {unknown}")
    }
}

impl Body for Chain {
    fn configuration(&self) -> Configuration<'_> {
        let present = self.rest.iter().zip(&self.u).map(|(x, u)| x + Vec3::x() * *u).collect();
        Configuration { rest: &self.rest, present, cells: &[] }
    }

    fn read(&self, of: Measured, bead: usize, along: &Vec3) -> f64 {
        match of {
            Measured::Displacement => self.u[bead] * along.x,
            Measured::Position => (self.rest[bead] + Vec3::x() * self.u[bead]).dot(along),
            _ => 0.0,
        }
    }

    fn fields<'a>(&'a self, _: &FieldRequest<'a>) -> Box<dyn FieldSource + 'a> {
        Box::new(|_: Part, to: &mut dyn FieldWriter| {
            let (count, cell) = (self.u.len(), |bead: usize| (Kind::Vertex, [bead as u32; 8]));
            let points = rows(count, |bead| [self.rest[bead].x + self.u[bead], 0.0, 0.0]);
            to.geometry(&points, Connectivity { count, cell: &cell })?;
            let moved = rows(count, |bead| [self.u[bead], 0.0, 0.0]);
            to.numbers(At::Points, "displacement", "m", &[], Values::Double(&moved))
        })
    }

    fn state(&self) -> Vec<StateArray<'_>> {
        vec![StateArray::new("u", &self.u), StateArray::new("v", &self.v)]
    }

    fn set_state(&mut self, arrays: &[StateArray<'_>]) -> Result<(), Mismatch> {
        let [u, v] = arrays else { return Err(Mismatch) };
        if [u, v].iter().any(|array| array.numbers.len() != self.u.len()) {
            return Err(Mismatch);
        }
        [self.u, self.v] = [u, v].map(|array| Cow::into_owned(array.numbers.clone()));
        Ok(())
    }
}

impl DynamicBody for Chain {}

impl StaticBody for Chain {
    fn refresh(&mut self, _: f64) -> f64 {
        self.energy()
    }
}
