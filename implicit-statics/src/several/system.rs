//! Several systems as one whose equilibria are sought.

use std::cell::OnceCell;
use std::ops::Range;

use super::acting::Acting;
use super::interaction::{Interaction, Joinable};
use crate::bounds::OutOfBounds;
use crate::equilibrium::{Equilibrium, Front};
use crate::rank_one::RankOne;

/// Part of the greatest utilisation from which on others break with it: equal systems are as far but for rounding.
const ALIKE: f64 = 1e-9;

/// Systems that are solved together, and what they do to each other.
pub struct Several<S: ?Sized> {
    pub(super) systems: Vec<Box<S>>,
    /// First unknown of each, and the end.
    pub(super) first: Vec<usize>,
    /// First entry of each in the pattern, and the end; found when a tangent is first asked for.
    entries: OnceCell<Vec<usize>>,
    pub(super) acting: Vec<Acting>,
}

impl<S: Joinable + ?Sized> Several<S> {
    /// Systems, with all that they do to each other; particles of each interaction ascend.
    pub fn new(systems: Vec<Box<S>>, interactions: Vec<Box<dyn Interaction>>) -> Self {
        let ends = |of: &dyn Fn(&S) -> usize| -> Vec<usize> {
            let mut end = 0;
            let next = systems.iter().map(|system| {
                end += of(system);
                end
            });
            std::iter::once(0).chain(next).collect()
        };
        let first = ends(&|system| system.unknowns());
        let mut several = Self { systems, first, entries: OnceCell::new(), acting: Vec::new() };
        for interaction in interactions {
            let pattern = several.pattern();
            several.acting.push(Acting::new(interaction, &several.systems, &several.first, &pattern));
        }
        several
    }

    /// Lets them act on each other in the present state at a level; the energy of that \[F L\].
    pub fn act(&mut self, level: f64) -> f64 {
        if self.acting.is_empty() {
            return 0.0;
        }
        for system in &mut self.systems {
            system.put(level);
            system.release();
        }
        self.acting.iter_mut().map(|acting| acting.act(&mut self.systems, level)).sum()
    }

    /// An interaction, in the order in which they were given.
    pub fn interaction(&self, number: usize) -> Option<&dyn Interaction> {
        self.acting.get(number).map(Acting::interaction)
    }

    /// What an interaction last exerted on a particle of a system \[F\].
    pub fn force_on(&self, interaction: usize, system: usize, particle: u32) -> [f64; 3] {
        self.acting.get(interaction).map_or([0.0; 3], |acting| acting.force_on(system, particle))
    }

    /// Whether any interaction has a history.
    pub fn remembers(&self) -> bool {
        self.acting.iter().any(|acting| acting.interaction().remembers())
    }

    /// Energy that an interaction lost at a particle of a system until the last commit \[F L\].
    pub fn lost_at(&self, interaction: usize, system: usize, particle: u32) -> f64 {
        self.acting.get(interaction).map_or(0.0, |acting| acting.lost_at(system, particle))
    }

    /// That of each system, without what acts between them.
    fn pattern_of_systems(&self) -> Vec<(usize, usize)> {
        let mut all = Vec::new();
        for (system, first) in self.systems.iter().zip(&self.first) {
            all.extend(system.pattern().into_iter().map(|(row, column)| (first + row, first + column)));
        }
        all
    }

    pub(super) fn entries(&self) -> &Vec<usize> {
        self.entries.get_or_init(|| {
            let mut end = 0;
            let next = self.systems.iter().map(|system| {
                end += system.pattern().len();
                end
            });
            std::iter::once(0).chain(next).collect()
        })
    }

    /// A number of each system for every unknown, one behind the other.
    fn gather(&self, of: impl Fn(&S) -> Vec<f64>) -> Vec<f64> {
        self.systems.iter().flat_map(|system| of(system)).collect()
    }

    fn any(&self, of: impl Fn(&S) -> bool) -> bool {
        self.systems.iter().any(|system| of(system))
    }
}

impl<S: ?Sized> Several<S> {
    /// The systems in their order.
    pub fn systems(&self) -> &[Box<S>] {
        &self.systems
    }

    /// The same, to put them into other states.
    pub fn systems_mut(&mut self) -> &mut [Box<S>] {
        &mut self.systems
    }

    /// What each interaction keeps with a state, in the order in which they were given.
    pub fn kept(&self) -> Vec<Vec<f64>> {
        self.acting.iter().map(|acting| acting.interaction().kept()).collect()
    }

    /// Takes that up; false if it is that of others.
    pub fn take_up(&mut self, kept: &[&[f64]]) -> bool {
        let fits = kept.len() == self.acting.len();
        fits && self.acting.iter_mut().zip(kept).all(|(acting, kept)| acting.take_up(kept))
    }

    /// Unknowns of a system.
    pub fn unknowns_of(&self, system: usize) -> Range<usize> {
        self.first[system]..self.first[system + 1]
    }

    /// Each system with its part of a list.
    pub(super) fn parts(
        &mut self,
        ends: fn(&Self) -> &Vec<usize>,
    ) -> impl Iterator<Item = (&mut Box<S>, Range<usize>)> {
        let ends = ends(self).clone();
        self.systems
            .iter_mut()
            .enumerate()
            .map(move |(number, system)| (system, ends[number]..ends[number + 1]))
    }
}

impl<S: Joinable + ?Sized> Equilibrium for Several<S> {
    fn unknowns(&self) -> usize {
        self.first.last().copied().unwrap_or(0)
    }

    fn pattern(&self) -> Vec<(usize, usize)> {
        let mut all = self.pattern_of_systems();
        all.extend(self.acting.iter().flat_map(|acting| acting.own.iter().copied()));
        all
    }

    fn pattern_changed(&mut self, level: f64) -> bool {
        let mut changed = false;
        self.systems.iter_mut().for_each(|system| changed |= system.pattern_changed(level));
        if !self.acting.is_empty() {
            self.systems.iter_mut().for_each(|system| system.put(level));
        }
        for acting in &mut self.acting {
            changed |= acting.changed(&self.systems, level);
        }
        if changed {
            self.entries = OnceCell::new();
            let mut pattern = self.pattern_of_systems();
            for acting in &mut self.acting {
                acting.enter(&self.systems, &self.first, &pattern);
                pattern.extend(&acting.own);
            }
        }
        changed
    }

    fn coordinates(&self) -> Option<Vec<[f64; 3]>> {
        let all = self.systems.iter().map(|system| system.coordinates()).collect::<Option<Vec<_>>>()?;
        Some(all.concat())
    }

    fn rigid_motions(&self) -> Option<Vec<[f64; 6]>> {
        let all = self.systems.iter().map(|system| system.rigid_motions()).collect::<Option<Vec<_>>>()?;
        Some(all.concat())
    }

    fn internal(&mut self, level: f64, out: &mut [f64]) {
        self.parts(|own| &own.first).for_each(|(system, range)| system.internal(level, &mut out[range]));
    }

    fn external(&mut self, level: f64, out: &mut [f64]) {
        self.act(level);
        self.parts(|own| &own.first).for_each(|(system, range)| system.external(level, &mut out[range]));
    }

    fn load_rate(&mut self, level: f64, out: &mut [f64]) {
        let led = self.led(level);
        self.act(level);
        self.parts(|own| &own.first).for_each(|(system, range)| system.load_rate(level, &mut out[range]));
        self.acting.iter().for_each(|acting| acting.add_rates(&self.systems, &self.first, out));
        for (acting, ways) in self.acting.iter().zip(&led) {
            acting.add_led(ways, &self.systems, &self.first, out);
        }
    }

    fn tangent(&mut self, level: f64, values: &mut [f64]) {
        self.act(level);
        self.parts(Self::entries).for_each(|(system, range)| system.tangent(level, &mut values[range]));
        self.add_stiffness(values);
    }

    fn beside_pattern(&mut self, level: f64) -> Vec<RankOne> {
        self.beside(level)
    }

    fn keeps_factor(&self) -> bool {
        self.any(Equilibrium::keeps_factor)
    }

    fn tangent_is_of_the_step(&self) -> bool {
        self.remembers() || self.any(Equilibrium::tangent_is_of_the_step)
    }

    fn has_moving_supports(&self) -> bool {
        self.any(Equilibrium::has_moving_supports)
    }

    fn has_moving_tools(&self) -> bool {
        self.acting.iter().any(|acting| acting.interaction().moves())
            || self.any(Equilibrium::has_moving_tools)
    }

    fn commit(&mut self) {
        self.systems.iter_mut().for_each(|system| system.commit());
        self.acting.iter_mut().for_each(Acting::commit);
    }

    fn utilisation(&mut self) -> f64 {
        self.systems.iter_mut().map(|system| system.utilisation()).fold(0.0, f64::max)
    }

    fn break_critical(&mut self) -> f64 {
        let each: Vec<f64> = self.systems.iter_mut().map(|system| system.utilisation()).collect();
        let most = each.iter().copied().fold(0.0, f64::max);
        let critical = self.systems.iter_mut().zip(each).filter(|(_, own)| *own >= most * (1.0 - ALIKE));
        critical.map(|(system, _)| system.break_critical()).sum()
    }

    fn row_sums(&mut self, level: f64, out: &mut [f64]) {
        self.act(level);
        self.parts(|own| &own.first).for_each(|(system, range)| system.row_sums(level, &mut out[range]));
        self.acting.iter().for_each(|acting| acting.add_row_sums(&self.systems, &self.first, out));
    }

    fn stressed_tangent(&mut self, level: f64, motion: &[f64], values: &mut [f64]) -> bool {
        let here = self.act_after([level, level], motion);
        let first = self.first.clone();
        let offered = self.parts(Self::entries).enumerate().all(|(number, (system, range))| {
            let motion = &motion[first[number]..first[number + 1]];
            system.stressed_tangent(level, motion, &mut values[range])
        });
        if offered {
            self.add_stressed(&here, values);
        }
        offered
    }

    /// Of what they do to each other the forces are those of the state at the end of the motion.
    fn turned_tangent(&mut self, levels: [f64; 2], motion: &[f64], values: &mut [f64]) {
        let here = self.act_after(levels, motion);
        let first = self.first.clone();
        for (number, (system, range)) in self.parts(Self::entries).enumerate() {
            let motion = &motion[first[number]..first[number + 1]];
            system.turned_tangent(levels, motion, &mut values[range]);
        }
        self.add_stressed(&here, values);
    }

    fn stress_forces(&self, level: f64) -> f64 {
        self.systems.iter().map(|system| system.stress_forces(level).powi(2)).sum::<f64>().sqrt()
    }

    fn driving_force(&self) -> f64 {
        self.systems.iter().map(|system| system.driving_force().powi(2)).sum::<f64>().sqrt()
    }

    fn reach(&mut self, increment: &[f64]) -> f64 {
        let own = self.parts(|own| &own.first).map(|(system, range)| system.reach(&increment[range]));
        let least = own.fold(1.0, f64::min);
        if self.acting.is_empty() {
            return least;
        }
        let see = |several: &mut Self| -> Vec<Vec<[f64; 3]>> {
            let Self { systems, acting, .. } = several;
            acting.iter_mut().map(|acting| acting.seen(systems)).collect()
        };
        let (saved, here) = (self.save(), see(self));
        self.update(increment);
        let there = see(self);
        self.restore(&saved);
        let each = self.acting.iter().zip(here.iter().zip(&there));
        each.map(|(acting, (here, there))| acting.interaction().reach(here, there)).fold(least, f64::min)
    }

    fn stages_of_contact(&self) -> Vec<f64> {
        let mut all: Vec<f64> = self.systems.iter().flat_map(|system| system.stages_of_contact()).collect();
        all.sort_unstable_by(|a, b| b.total_cmp(a));
        all.dedup();
        all
    }

    fn soften_contact(&mut self, length: Option<f64>) {
        self.systems.iter_mut().for_each(|system| system.soften_contact(length));
    }

    fn front(&mut self, level: f64) -> Front {
        let each = self.systems.iter_mut().map(|system| system.front(level));
        each.reduce(|all, own| Front {
            set: all.set.rotate_left(1) ^ own.set,
            depth: all.depth.max(own.depth),
        })
        .unwrap_or_default()
    }

    fn update(&mut self, increment: &[f64]) {
        self.parts(|own| &own.first).for_each(|(system, range)| system.update(&increment[range]));
    }

    fn transport(&mut self, motion: &mut [f64]) {
        self.parts(|own| &own.first).for_each(|(system, range)| system.transport(&mut motion[range]));
    }

    fn motion_to(&self, saved: &[f64], out: &mut [f64]) -> bool {
        let parts = self.parts_of(saved);
        self.systems.iter().enumerate().all(|(number, system)| {
            system.motion_to(parts[number], &mut out[self.first[number]..self.first[number + 1]])
        })
    }

    fn save(&self) -> Vec<f64> {
        let own = self.systems.iter().map(|system| system.save());
        let parts: Vec<Vec<f64>> =
            own.chain(self.acting.iter().map(|acting| acting.interaction().history())).collect();
        let lengths = parts.iter().map(|part| part.len() as f64);
        parts.iter().flatten().copied().chain(lengths).collect()
    }

    fn restore(&mut self, saved: &[f64]) {
        let parts = self.parts_of(saved);
        let (own, histories) = parts.split_at(self.systems.len());
        self.systems.iter_mut().zip(own).for_each(|(system, part)| system.restore(part));
        self.acting.iter_mut().zip(histories).for_each(|(acting, history)| acting.recall(history));
    }

    /// What they do to each other is work of external forces.
    fn energy(&mut self) -> f64 {
        self.systems.iter_mut().map(|system| system.energy()).sum()
    }

    fn masses(&self) -> Vec<f64> {
        self.gather(|system| system.masses())
    }

    fn vibrating_masses(&self) -> Vec<f64> {
        self.gather(|system| system.vibrating_masses())
    }

    fn name_unknown(&self, unknown: usize) -> String {
        let system = self.first.partition_point(|&first| first <= unknown) - 1;
        let name = self.systems[system].name_unknown(unknown - self.first[system]);
        format!("system {system}: {name}")
    }

    fn within_bounds(&self) -> Result<(), OutOfBounds> {
        self.systems.iter().try_for_each(|system| system.within_bounds())
    }
}

impl<S: Joinable + ?Sized> Several<S> {
    /// What each system and then each interaction has in a saved state, at whose end their lengths stand: histories grow and shrink.
    fn parts_of<'a>(&self, saved: &'a [f64]) -> Vec<&'a [f64]> {
        let (mut rest, lengths) = saved.split_at(saved.len() - self.systems.len() - self.acting.len());
        let part = |length: &f64| {
            let (part, after) = rest.split_at(*length as usize);
            rest = after;
            part
        };
        lengths.iter().map(part).collect()
    }

    /// Adds the stiffness of what they do to each other, whose entries follow those of the systems.
    fn add_stiffness(&self, values: &mut [f64]) {
        values[self.entries()[self.systems.len()]..].fill(0.0);
        for acting in &self.acting {
            acting.add_stiffness(&self.systems, &self.first, values);
        }
    }
}
