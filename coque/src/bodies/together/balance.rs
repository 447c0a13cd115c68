//! Several bodies whose equilibria are sought: all of it is that of the systems together.

use implicit_statics::{Equilibrium, Front, OutOfBounds, RankOne};
use sph_core::Vec3;

use super::body::Together;
use super::parts::Balanced;
use crate::Warning;
use crate::bodies::body::StaticBody;

impl Equilibrium for Together<Balanced> {
    fn unknowns(&self) -> usize {
        self.system.unknowns()
    }

    fn pattern(&self) -> Vec<(usize, usize)> {
        self.system.pattern()
    }

    fn pattern_changed(&mut self, level: f64) -> bool {
        self.system.pattern_changed(level)
    }

    fn coordinates(&self) -> Option<Vec<[f64; 3]>> {
        self.system.coordinates()
    }

    fn rigid_motions(&self) -> Option<Vec<[f64; 6]>> {
        self.system.rigid_motions()
    }

    fn internal(&mut self, level: f64, out: &mut [f64]) {
        self.system.internal(level, out);
    }

    fn external(&mut self, level: f64, out: &mut [f64]) {
        self.system.external(level, out);
    }

    fn load_rate(&mut self, level: f64, out: &mut [f64]) {
        self.system.load_rate(level, out);
    }

    fn tangent(&mut self, level: f64, values: &mut [f64]) {
        self.system.tangent(level, values);
    }

    fn beside_pattern(&mut self, level: f64) -> Vec<RankOne> {
        self.system.beside_pattern(level)
    }

    fn keeps_factor(&self) -> bool {
        self.system.keeps_factor()
    }

    fn tangent_is_of_the_step(&self) -> bool {
        self.system.tangent_is_of_the_step()
    }

    fn has_moving_supports(&self) -> bool {
        self.system.has_moving_supports()
    }

    fn has_moving_tools(&self) -> bool {
        self.system.has_moving_tools()
    }

    fn commit(&mut self) {
        self.system.commit();
    }

    fn utilisation(&mut self) -> f64 {
        self.system.utilisation()
    }

    fn break_critical(&mut self) -> f64 {
        self.system.break_critical()
    }

    fn row_sums(&mut self, level: f64, out: &mut [f64]) {
        self.system.row_sums(level, out);
    }

    fn stressed_tangent(&mut self, level: f64, motion: &[f64], values: &mut [f64]) -> bool {
        self.system.stressed_tangent(level, motion, values)
    }

    fn turned_tangent(&mut self, levels: [f64; 2], motion: &[f64], values: &mut [f64]) {
        self.system.turned_tangent(levels, motion, values);
    }

    fn stress_forces(&self, level: f64) -> f64 {
        self.system.stress_forces(level)
    }

    fn driving_force(&self) -> f64 {
        self.system.driving_force()
    }

    fn reach(&mut self, increment: &[f64]) -> f64 {
        self.system.reach(increment)
    }

    fn stages_of_contact(&self) -> Vec<f64> {
        self.system.stages_of_contact()
    }

    fn soften_contact(&mut self, length: Option<f64>) {
        self.system.soften_contact(length);
    }

    fn front(&mut self, level: f64) -> Front {
        self.system.front(level)
    }

    fn update(&mut self, increment: &[f64]) {
        self.system.update(increment);
    }

    fn transport(&mut self, motion: &mut [f64]) {
        self.system.transport(motion);
    }

    fn motion_to(&self, saved: &[f64], out: &mut [f64]) -> bool {
        self.system.motion_to(saved, out)
    }

    fn save(&self) -> Vec<f64> {
        self.system.save()
    }

    fn restore(&mut self, saved: &[f64]) {
        self.system.restore(saved);
    }

    fn energy(&mut self) -> f64 {
        self.system.energy()
    }

    fn masses(&self) -> Vec<f64> {
        self.system.masses()
    }

    fn vibrating_masses(&self) -> Vec<f64> {
        self.system.vibrating_masses()
    }

    fn name_unknown(&self, unknown: usize) -> String {
        let bodies = self.system.systems().iter().zip(&self.layout.names).enumerate();
        let mut own = bodies.map(|(number, named)| (self.system.unknowns_of(number), named));
        match own.find(|(range, _)| range.contains(&unknown)) {
            Some((range, (body, name))) => format!("{name}: {}", body.name_unknown(unknown - range.start)),
            None => self.system.name_unknown(unknown),
        }
    }

    fn within_bounds(&self) -> Result<(), OutOfBounds> {
        self.system.within_bounds()
    }
}

impl StaticBody for Together<Balanced> {
    fn refresh(&mut self, level: f64) -> f64 {
        let between = self.system.act(level);
        self.system.systems_mut().iter_mut().map(|part| part.refresh(level)).sum::<f64>() + between
    }

    fn functional(&self, particle: usize, along: Vec3) -> Vec<f64> {
        let (body, own) = self.layout.place(particle);
        let mut all = vec![0.0; self.system.unknowns()];
        let weights = self.system.systems()[body].functional(own, along);
        all[self.system.unknowns_of(body)].copy_from_slice(&weights);
        all
    }

    fn opens_and_closes(&self) -> bool {
        !(self.layout.contacts.is_empty() && self.layout.links.is_empty())
            || self.system.systems().iter().any(|part| part.opens_and_closes())
    }

    fn slips(&self) -> bool {
        self.system.remembers() || self.system.systems().iter().any(|part| part.slips())
    }

    fn linear_reach(&self) -> f64 {
        self.system.systems().iter().map(|part| part.linear_reach()).fold(f64::INFINITY, f64::min)
    }

    fn stable_step(&mut self) -> f64 {
        let steps = self.system.systems_mut().iter_mut().map(|part| part.stable_step());
        steps.fold(f64::INFINITY, f64::min)
    }

    fn skew_load_share(&self) -> f64 {
        self.system.systems().iter().map(|part| part.skew_load_share()).fold(0.0, f64::max)
    }

    fn warnings(&self) -> Vec<Warning> {
        let mut all = Vec::new();
        for (part, name) in self.system.systems().iter().zip(&self.layout.names) {
            let own = part.warnings().into_iter();
            all.extend(own.map(|own| Warning::new(own.kind, format!("{name}: {}", own.message))));
        }
        all
    }

    fn forces(&self) -> Vec<f64> {
        self.system.systems().iter().flat_map(|part| part.forces()).collect()
    }
}
