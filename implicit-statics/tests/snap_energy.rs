//! The energy that a snap sets free between two levels of a relaxation, and that a path does not.

#![allow(clippy::unwrap_used)] // a failed test may stop here

mod common;

use std::ops::ControlFlow;

use common::bars::Bars;
use common::hardening::Hardening;
use common::pendulum::Pendulum;
use common::{Arch, Flat, Potential, Softening};
use implicit_statics::{Equilibrium, Relaxation, RelaxationOptions, SnapEnergy};

/// Levels one after the other, each with what it set free.
fn releases<E: Equilibrium>(system: &mut E, levels: &[f64]) -> Vec<SnapEnergy> {
    let options = RelaxationOptions { tolerance: 1e-9, ..RelaxationOptions::default() };
    let mut relaxation = Relaxation::new(&options).unwrap();
    let mut before = 0.0;
    let mut to = |&level: &f64| {
        let found = relaxation.to_level(system, (before, level), |_| ControlFlow::Continue(())).unwrap();
        before = level;
        found.release
    };
    levels.iter().map(&mut to).collect()
}

/// A von Mises arch whose apex is pushed through a spring by an end that the level moves.
struct Pushed {
    arch: Arch,
    spring: f64,
    end: f64,
    q: [f64; 1],
}

impl Pushed {
    fn new(spring: f64) -> Self {
        Self { arch: Arch { half: 10.0, height: 1.0, sideways: false }, spring, end: 0.0, q: [0.0] }
    }

    /// The level that holds the apex a way down.
    fn level(&self, way: f64) -> f64 {
        way + self.arch.level(way) / self.spring
    }
}

impl Equilibrium for Pushed {
    fn unknowns(&self) -> usize {
        1
    }
    fn pattern(&self) -> Vec<(usize, usize)> {
        vec![(0, 0)]
    }
    fn internal(&mut self, level: f64, out: &mut [f64]) {
        self.end = level;
        self.arch.gradient(&self.q, out);
        out[0] -= self.spring * (self.end - self.q[0]);
    }
    fn external(&mut self, _: f64, out: &mut [f64]) {
        out.fill(0.0);
    }
    fn load_rate(&mut self, _: f64, out: &mut [f64]) {
        out[0] = self.spring;
    }
    fn tangent(&mut self, _: f64, values: &mut [f64]) {
        values[0] = self.spring;
        self.arch.hessian(&self.q, &mut |_, _, k| values[0] += k);
    }
    fn has_moving_supports(&self) -> bool {
        true
    }
    fn driving_force(&self) -> f64 {
        (self.spring * (self.end - self.q[0])).abs()
    }
    fn update(&mut self, increment: &[f64]) {
        self.q[0] += increment[0];
    }
    fn save(&self) -> Vec<f64> {
        vec![self.q[0], self.end]
    }
    fn restore(&mut self, saved: &[f64]) {
        (self.q[0], self.end) = (saved[0], saved[1]);
    }
    fn energy(&mut self) -> f64 {
        self.arch.energy(&self.q) + 0.5 * self.spring * (self.end - self.q[0]).powi(2)
    }
    fn masses(&self) -> Vec<f64> {
        vec![1.0]
    }
    fn name_unknown(&self, _: usize) -> String {
        "the apex".into()
    }
}

/// Levels from the first on, so many to one unit.
fn steps(last: f64, number: usize) -> Vec<f64> {
    (1..=number).map(|i| last * i as f64 / number as f64).collect()
}

/// Both kinds of levels over a snap: one level sets energy free, and it is that of the closed form.
#[test]
fn the_energy_of_a_snap_is_that_of_its_closed_form() {
    // Under a force: U of the arch is ℓ ε², ε = (z² − h²)/2ℓ²; the force does its mean over the step, on the way across.
    let arch = Arch { half: 10.0, height: 1.0, sideways: false };
    let levels = steps(1.5 * arch.limit(), 10);
    let mut ways = vec![0.0];
    for &level in &levels {
        let at = |range: [f64; 2]| bisected(range, |w| arch.level(w) - level);
        let top = 1.0 - 1.0 / 3.0_f64.sqrt();
        ways.push(if level < arch.limit() { at([0.0, top]) } else { at([2.0, 3.0]) });
    }
    let mut energies = Vec::new();
    for (i, &level) in levels.iter().enumerate() {
        let before = if i == 0 { 0.0 } else { levels[i - 1] };
        let gained = arch.energy(&[ways[i + 1]]) - arch.energy(&[ways[i]]);
        energies.push(0.5 * (before + level) * (ways[i + 1] - ways[i]) - gained);
    }
    reported(&releases(&mut Flat::new(arch), &levels), &energies, 6, "force");
    // Under a motion, through a spring too soft to hold the arch: its force falls from branch to branch.
    let mut pushed = Pushed::new(0.25 / libm::hypot(10.0_f64, 1.0).powi(3));
    let levels = steps(3.1, 12);
    let mut state = (0.0, 0.0, 0.0);
    let (mut energies, mut snap) = (Vec::new(), None);
    for (i, &level) in levels.iter().enumerate() {
        // The first way from where it stands at which the level is met: the end of the stable branch comes before.
        let mut way = state.0;
        while pushed.level(way) < level {
            way += 1e-5;
        }
        if way - state.0 > 1.0 {
            snap = Some(i);
        }
        let way = bisected([way - 1e-5, way], |w| pushed.level(w) - level);
        (pushed.q[0], pushed.end) = (way, level);
        let (energy, force) = (pushed.energy(), pushed.spring * (level - way));
        energies.push(0.5 * (level / (i + 1) as f64) * (state.2 + force) - (energy - state.1));
        state = (way, energy, force);
    }
    (pushed.q[0], pushed.end) = (0.0, 0.0);
    reported(&releases(&mut pushed, &levels), &energies, snap.unwrap(), "motion");
}

/// What was set free is the energy of the closed form; one level alone, the given one, is a snap.
fn reported(found: &[SnapEnergy], exact: &[f64], snap: usize, name: &str) {
    for (i, (release, exact)) in found.iter().zip(exact).enumerate() {
        println!("{name} {i}: {:.6e} {exact:.6e} of {:.6e}", release.energy, release.most);
        let scale = release.energy.abs().max(release.most);
        assert!((release.energy - exact).abs() < 1e-5 * scale, "{name} {i}: {release:?} {exact:e}");
        assert_eq!(release.snapped(), i == snap, "{name} {i}: {release:?}");
    }
    assert!(found[snap].energy > 3.0 * found[snap].most, "{:?}", found[snap]);
}

/// Half of the limit load at once: the motion carries the arch across below its limit, and that is reported as well.
#[test]
fn a_motion_that_overshoots_is_reported() {
    let arch = Arch { half: 10.0, height: 1.0, sideways: false };
    let levels = steps(0.995 * arch.limit(), 2);
    let mut system = Flat::new(arch);
    let found = releases(&mut system, &levels);
    assert!(system.q[0] > 2.0 && !found[0].snapped() && found[1].snapped(), "{:?} {found:?}", system.q);
}

fn bisected(range: [f64; 2], f: impl Fn(f64) -> f64) -> f64 {
    let [mut low, mut high] = range;
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if f(middle) < 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// Stiff paths and soft ones, coarse steps and fine ones, there and back.
#[test]
fn what_is_joined_by_stable_states_sets_no_energy_free() {
    let quiet = |name: &str, found: Vec<SnapEnergy>| {
        let worst = found.iter().map(|release| release.energy / release.most).fold(f64::MIN, f64::max);
        println!("{name}: {worst:.3} of what a path may leave over");
        assert!(found.iter().all(|release| !release.snapped()), "{name}: {found:?}");
    };
    // So much of the limit load as the motion of a step does not carry across.
    for (number, part) in [(2, 0.7), (5, 0.9), (40, 0.995)] {
        let arch = || Arch { half: 10.0, height: 1.0, sideways: false };
        let there = steps(part * arch().limit(), number);
        let back: Vec<f64> = there.iter().rev().skip(1).copied().collect();
        let levels = [&there[..], &back, &[0.0]].concat();
        quiet("arch", releases(&mut Flat::new(arch()), &levels));
        quiet("softening", releases(&mut Flat::new(Softening), &steps(0.36, number)));
        quiet("hardening", releases(&mut Flat::new(Hardening), &steps(20.0, number)));
        quiet("chain of directors", releases(&mut Pendulum::new(12), &steps(0.02, number)));
        quiet("bars", releases(&mut Bars::new(10), &steps(0.5, number)));
        // A spring stiff enough to hold the arch all the way: the force falls, and nothing snaps.
        quiet("pushed", releases(&mut Pushed::new(0.01), &steps(3.0, 4 * number)));
    }
}
