//! Steady vibration of chains: closed forms, modes against factors, exchange and balance.

#![allow(clippy::unwrap_used)] // a failed test may stop here

mod common;

use common::{Flat, Potential};
use implicit_statics::{
    Complex, DirectResponse, Equilibrium, EquilibriumError, HarmonicDamping, HarmonicMotion, RankOne,
    ReducedResponse, natural_modes, unwatched,
};

const DAMPINGS: [HarmonicDamping; 2] =
    [HarmonicDamping::Structural(0.04), HarmonicDamping::Rayleigh { mass: 0.03, stiffness: 0.02 }];

/// A chain of unequal springs and masses, held at both ends, loaded at one mass.
struct Chain {
    links: Vec<f64>,
    at: usize,
}

impl Chain {
    fn new(masses: usize, at: usize) -> Flat<Self> {
        let link = |i: usize| 3.0 + libm::sin(1.7 * i as f64);
        let mut chain = Flat::new(Self { links: (0..=masses).map(link).collect(), at });
        chain.masses = (0..masses).map(|i| 1.0 + 0.4 * libm::cos(2.3 * i as f64)).collect();
        chain
    }
}

impl Potential for Chain {
    fn unknowns(&self) -> usize {
        self.links.len() - 1
    }
    fn energy(&self, q: &[f64]) -> f64 {
        let place = |i: usize| if i == 0 { 0.0 } else { q.get(i - 1).copied().unwrap_or(0.0) };
        let link = |(i, k): (usize, &f64)| 0.5 * k * (place(i + 1) - place(i)).powi(2);
        self.links.iter().enumerate().map(link).sum()
    }
    fn gradient(&self, q: &[f64], out: &mut [f64]) {
        let place = |i: usize| if i == 0 { 0.0 } else { q.get(i - 1).copied().unwrap_or(0.0) };
        for (i, force) in out.iter_mut().enumerate() {
            *force =
                self.links[i] * (place(i + 1) - place(i)) - self.links[i + 1] * (place(i + 2) - place(i + 1));
        }
    }
    fn hessian(&self, _: &[f64], add: &mut dyn FnMut(usize, usize, f64)) {
        for i in 0..self.unknowns() {
            add(i, i, self.links[i] + self.links[i + 1]);
            if i > 0 {
                add(i, i - 1, -self.links[i]);
            }
        }
    }
    fn load(&self, _: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        out[self.at] = 2.0;
    }
}

fn direct<E: Equilibrium>(system: &mut E, damping: HarmonicDamping, omega: f64) -> HarmonicMotion {
    DirectResponse::new(system, 0.0, damping).unwrap().at(omega).unwrap()
}

fn reduced<E: Equilibrium>(system: &mut E, damping: HarmonicDamping, count: usize) -> ReducedResponse {
    let modes = natural_modes(system, 0.0, count, 0.0, &mut unwatched).unwrap().modes;
    ReducedResponse::new(system, 0.0, modes, 0.0, damping).unwrap()
}

/// Greatest distance of two motions over the greatest of one.
fn apart(a: &HarmonicMotion, b: &HarmonicMotion) -> f64 {
    let parts = |m: &HarmonicMotion| m.real.iter().chain(&m.imaginary).copied().collect::<Vec<f64>>();
    let (a, b) = (parts(a), parts(b));
    let most = a.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    a.iter().zip(&b).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs())) / most
}

/// `u = p / (k − mω² + i c(ω))`, k of two springs.
#[test]
fn one_unknown_swings_as_its_closed_form_says() {
    let (k, m, p) = (3.0 + 3.0 + libm::sin(1.7), 1.4, 2.0);
    let natural = (k / m).sqrt();
    let cases = [
        (HarmonicDamping::Structural(0.05), Box::new(|_| 0.05 * k) as Box<dyn Fn(f64) -> f64>),
        (
            HarmonicDamping::Rayleigh { mass: 0.1, stiffness: 0.02 },
            Box::new(|omega| omega * (0.1 * m + 0.02 * k)),
        ),
        (HarmonicDamping::Ratio(0.03), Box::new(|omega| 2.0 * 0.03 * omega * (k * m).sqrt())),
        (HarmonicDamping::None, Box::new(|_| 0.0)),
    ];
    for (damping, lag) in cases {
        for share in [0.1, 0.9, 1.001, 5.0] {
            let omega = share * natural;
            let exact = Complex::new(k - m * omega * omega, lag(omega)).under(p);
            let modal = reduced(&mut Chain::new(1, 0), damping, 1);
            let modal = modal.motion(&modal.at(omega).unwrap());
            let mut found = vec![modal];
            if !matches!(damping, HarmonicDamping::Ratio(_)) {
                found.push(direct(&mut Chain::new(1, 0), damping, omega));
            }
            for motion in found {
                // Near the peak k − mω² loses three digits.
                let error = libm::hypot(motion.real[0] - exact.re, motion.imaginary[0] - exact.im);
                assert!(error < 2e-12 * exact.amplitude(), "{damping:?} {share} {error:e}");
            }
        }
    }
}

#[test]
fn all_modes_and_the_direct_answer_agree() {
    let count = 12;
    for damping in DAMPINGS {
        let modal = reduced(&mut Chain::new(count, 3), damping, count);
        assert_eq!(modal.shapes().len(), count);
        for omega in [0.05, 0.4, 1.1, 2.0, 3.9] {
            let motion = modal.motion(&modal.at(omega).unwrap());
            let error = apart(&direct(&mut Chain::new(count, 3), damping, omega), &motion);
            assert!(error < 1e-9, "{damping:?} {omega} {error:e}");
        }
    }
}

/// At rest the vector that stands for the modes left out makes the answer whole; up to half of the last mode it leaves a share that
/// goes with the fourth power of the frequency.
#[test]
fn few_modes_are_exact_at_rest_and_near_it() {
    let damping = HarmonicDamping::Structural(0.04);
    let modal = reduced(&mut Chain::new(60, 20), damping, 5);
    assert_eq!(modal.shapes().len(), 6);
    let last = natural_modes(&mut Chain::new(60, 20), 0.0, 5, 0.0, &mut unwatched).unwrap().modes[4]
        .circular_frequency();
    let error = |share: f64| {
        let motion = modal.motion(&modal.at(share * last).unwrap());
        apart(&direct(&mut Chain::new(60, 20), damping, share * last), &motion)
    };
    assert!(error(1e-4) < 1e-9, "{:e}", error(1e-4));
    assert!(error(0.5) < 0.01, "{:e}", error(0.5));
}

#[test]
fn what_comes_in_is_taken() {
    for damping in DAMPINGS {
        for omega in [0.3, 1.0, 2.2] {
            let mut direct = DirectResponse::new(&mut Chain::new(15, 4), 0.0, damping).unwrap();
            let motion = direct.at(omega).unwrap();
            let whole = direct.energies(&motion, omega);
            assert!((whole.external / whole.dissipated - 1.0).abs() < 1e-11, "{whole:?}");
            let modal = reduced(&mut Chain::new(15, 4), damping, 15);
            let parts = modal.energies(&modal.at(omega).unwrap(), omega);
            for (one, other) in [
                (whole.internal, parts.internal),
                (whole.kinetic, parts.kinetic),
                (whole.dissipated, parts.dissipated),
            ] {
                assert!((one / other - 1.0).abs() < 1e-8, "{whole:?} {parts:?}");
            }
        }
    }
}

#[test]
fn force_and_way_can_be_exchanged() {
    for damping in DAMPINGS {
        for omega in [0.3, 1.0, 2.2] {
            let there = direct(&mut Chain::new(15, 4), damping, omega);
            let back = direct(&mut Chain::new(15, 11), damping, omega);
            let size = libm::hypot(there.real[11], there.imaginary[11]);
            let error = libm::hypot(there.real[11] - back.real[4], there.imaginary[11] - back.imaginary[4]);
            assert!(error < 1e-12 * size, "{error:e}");
        }
    }
}

#[test]
fn without_damping_pivots_count_and_resonance_is_refused() {
    let mut chain = Chain::new(10, 2);
    let modes = natural_modes(&mut chain, 0.0, 10, 0.0, &mut unwatched).unwrap().modes;
    let mut direct = DirectResponse::new(&mut chain, 0.0, HarmonicDamping::None).unwrap();
    for (number, pair) in modes.windows(2).enumerate() {
        let omega = 0.5 * (pair[0].circular_frequency() + pair[1].circular_frequency());
        let motion = direct.at(omega).unwrap();
        assert!(motion.imaginary.iter().all(|&u| u == 0.0));
        assert_eq!(direct.below(), Some(number + 1));
    }
    // Of one unknown the frequency is known to the last bit.
    let mut one = Chain::new(1, 0);
    one.masses = vec![(one.potential.links[0] + one.potential.links[1]) / 4.0];
    let mut direct = DirectResponse::new(&mut one, 0.0, HarmonicDamping::None).unwrap();
    assert_eq!(direct.at(2.0).unwrap_err(), EquilibriumError::Resonance { omega: 2.0 });
    let modal = reduced(&mut one, HarmonicDamping::None, 1);
    assert_eq!(modal.at(2.0).unwrap_err(), EquilibriumError::Resonance { omega: 2.0 });
    let ratio = DirectResponse::new(&mut one, 0.0, HarmonicDamping::Ratio(0.1)).err();
    assert!(matches!(ratio, Some(EquilibriumError::Option { name: "damping ratio", .. })));
}

/// A chain with a stiffness that couples all of it beside its pattern.
struct Enclosed {
    chain: Flat<Chain>,
    term: RankOne,
    dense: bool,
}

impl Equilibrium for Enclosed {
    fn unknowns(&self) -> usize {
        self.chain.unknowns()
    }
    fn pattern(&self) -> Vec<(usize, usize)> {
        self.chain.pattern()
    }
    fn internal(&mut self, level: f64, out: &mut [f64]) {
        self.chain.internal(level, out);
    }
    fn external(&mut self, level: f64, out: &mut [f64]) {
        self.chain.external(level, out);
    }
    fn load_rate(&mut self, level: f64, out: &mut [f64]) {
        self.chain.load_rate(level, out);
    }
    fn tangent(&mut self, level: f64, values: &mut [f64]) {
        self.chain.tangent(level, values);
        if self.dense {
            let term = &self.term;
            for ((i, j), value) in self.chain.pattern().into_iter().zip(values) {
                *value += term.factor * term.along[i] * term.along[j];
            }
        }
    }
    fn beside_pattern(&mut self, _: f64) -> Vec<RankOne> {
        if self.dense { Vec::new() } else { vec![self.term.clone()] }
    }
    fn update(&mut self, increment: &[f64]) {
        self.chain.update(increment);
    }
    fn save(&self) -> Vec<f64> {
        self.chain.save()
    }
    fn restore(&mut self, saved: &[f64]) {
        self.chain.restore(saved);
    }
    fn energy(&mut self) -> f64 {
        self.chain.energy()
    }
    fn masses(&self) -> Vec<f64> {
        self.chain.masses()
    }
    fn name_unknown(&self, unknown: usize) -> String {
        self.chain.name_unknown(unknown)
    }
}

#[test]
fn terms_beside_the_pattern_are_damped_alike() {
    let enclosed = |dense: bool| {
        let term = RankOne { factor: 0.7, along: (0..9).map(|i| libm::cos(0.9 * f64::from(i))).collect() };
        Enclosed { chain: Chain::new(9, 2), term, dense }
    };
    for damping in DAMPINGS.into_iter().chain([HarmonicDamping::None]) {
        for omega in [0.4, 1.3, 2.6] {
            let beside = direct(&mut enclosed(false), damping, omega);
            let error = apart(&beside, &direct(&mut enclosed(true), damping, omega));
            assert!(error < 1e-11, "{damping:?} {omega} {error:e}");
            let modal = reduced(&mut enclosed(false), damping, 9);
            let error = apart(&beside, &modal.motion(&modal.at(omega).unwrap()));
            assert!(error < 1e-9, "{damping:?} {omega} {error:e}");
        }
    }
}
