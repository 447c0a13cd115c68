//! Small systems with closed forms: a potential in plain coordinates, loaded in proportion to the level.

#![allow(dead_code)] // every test file takes its own share of these systems

pub mod bars;
pub mod hardening;
pub mod pendulum;

use std::ops::Range;

use implicit_statics::{Equilibrium, OutOfBounds};

/// Energy and its derivatives in plain coordinates; the load is `λ load(q)`.
pub trait Potential {
    fn unknowns(&self) -> usize;
    fn energy(&self, q: &[f64]) -> f64;
    fn gradient(&self, q: &[f64], out: &mut [f64]);
    /// Adds `∂²U/∂qᵢ∂qⱼ` for `i ≥ j` by calls of `add`.
    fn hessian(&self, q: &[f64], add: &mut dyn FnMut(usize, usize, f64));
    fn load(&self, q: &[f64], out: &mut [f64]);
    /// Adds `∂loadᵢ/∂qⱼ`, `i ≥ j`; none for dead loads.
    fn load_tangent(&self, _q: &[f64], _add: &mut dyn FnMut(usize, usize, f64)) {}
    fn name(&self, unknown: usize) -> String {
        format!("unknown {unknown}")
    }
    fn within_bounds(&self, _q: &[f64]) -> Result<(), OutOfBounds> {
        Ok(())
    }
}

/// A potential with its present state, as a system to balance.
pub struct Flat<P> {
    pub potential: P,
    pub q: Vec<f64>,
    pub masses: Vec<f64>,
    /// Levels at which there is no load to be had.
    pub forceless: Option<Range<f64>>,
    /// Whether it tells the motion to a saved state.
    pub tells_motions: bool,
}

impl<P: Potential> Flat<P> {
    pub fn new(potential: P) -> Self {
        let n = potential.unknowns();
        Self { potential, q: vec![0.0; n], masses: vec![1.0; n], forceless: None, tells_motions: false }
    }
}

impl<P: Potential> Equilibrium for Flat<P> {
    fn unknowns(&self) -> usize {
        self.q.len()
    }

    fn pattern(&self) -> Vec<(usize, usize)> {
        (0..self.q.len()).flat_map(|i| (0..=i).map(move |j| (i, j))).collect()
    }

    fn internal(&mut self, _level: f64, out: &mut [f64]) {
        self.potential.gradient(&self.q, out);
    }

    fn external(&mut self, level: f64, out: &mut [f64]) {
        self.potential.load(&self.q, out);
        out.iter_mut().for_each(|f| *f *= level);
        if self.forceless.as_ref().is_some_and(|levels| levels.contains(&level)) {
            out.fill(f64::NAN);
        }
    }

    fn load_rate(&mut self, _level: f64, out: &mut [f64]) {
        self.potential.load(&self.q, out);
    }

    fn tangent(&mut self, level: f64, values: &mut [f64]) {
        values.fill(0.0);
        self.potential.hessian(&self.q, &mut |i, j, k| values[i * (i + 1) / 2 + j] += k);
        self.potential.load_tangent(&self.q, &mut |i, j, k| values[i * (i + 1) / 2 + j] -= level * k);
    }

    fn update(&mut self, increment: &[f64]) {
        self.q.iter_mut().zip(increment).for_each(|(q, d)| *q += d);
    }

    fn motion_to(&self, saved: &[f64], out: &mut [f64]) -> bool {
        out.iter_mut().zip(saved).zip(&self.q).for_each(|((out, to), from)| *out = to - from);
        self.tells_motions
    }

    fn save(&self) -> Vec<f64> {
        self.q.clone()
    }

    fn restore(&mut self, saved: &[f64]) {
        self.q.copy_from_slice(saved);
    }

    fn energy(&mut self) -> f64 {
        self.potential.energy(&self.q)
    }

    fn masses(&self) -> Vec<f64> {
        self.masses.clone()
    }

    fn name_unknown(&self, unknown: usize) -> String {
        self.potential.name(unknown)
    }

    fn within_bounds(&self) -> Result<(), OutOfBounds> {
        self.potential.within_bounds(&self.q)
    }
}

/// Two bars of Green–Lagrange strain, EA = 1, meeting at an apex of height `height` over half a span `half`;
/// pushed down by λ. Unknown 0 is the way down, unknown 1 (if free) the way aside.
pub struct Arch {
    pub half: f64,
    pub height: f64,
    pub sideways: bool,
}

impl Arch {
    pub fn bar(&self) -> f64 {
        libm::hypot(self.half, self.height)
    }

    /// λ(w) on the symmetric path: z (h² − z²)/ℓ³, z = h − w.
    pub fn level(&self, w: f64) -> f64 {
        let z = self.height - w;
        z * (self.height.powi(2) - z * z) / self.bar().powi(3)
    }

    /// Limit load, at z = h/√3.
    pub fn limit(&self) -> f64 {
        2.0 * self.height.powi(3) / (27.0_f64.sqrt() * self.bar().powi(3))
    }

    fn bars(&self, q: &[f64]) -> [(f64, f64, f64); 2] {
        let aside = if self.sideways { q[1] } else { 0.0 };
        let z = self.height - q[0];
        [self.half + aside, self.half - aside].map(|run| {
            let square = self.bar().powi(2);
            ((run * run + z * z - square) / (2.0 * square), run, z)
        })
    }
}

impl Potential for Arch {
    fn unknowns(&self) -> usize {
        1 + usize::from(self.sideways)
    }

    fn energy(&self, q: &[f64]) -> f64 {
        self.bars(q).iter().map(|(strain, ..)| 0.5 * self.bar() * strain * strain).sum()
    }

    fn gradient(&self, q: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        for ((strain, run, z), side) in self.bars(q).into_iter().zip([1.0, -1.0]) {
            out[0] -= strain * z / self.bar();
            if self.sideways {
                out[1] += side * strain * run / self.bar();
            }
        }
    }

    fn hessian(&self, q: &[f64], add: &mut dyn FnMut(usize, usize, f64)) {
        let cube = self.bar().powi(3);
        for ((strain, run, z), side) in self.bars(q).into_iter().zip([1.0, -1.0]) {
            add(0, 0, strain / self.bar() + z * z / cube);
            if self.sideways {
                add(1, 1, strain / self.bar() + run * run / cube);
                add(1, 0, -side * run * z / cube);
            }
        }
    }

    fn load(&self, _q: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        out[0] = 1.0;
    }

    fn name(&self, unknown: usize) -> String {
        format!("apex, {}", ["down", "aside"][unknown])
    }
}

/// The arch (unknown 0) pushed through a spring whose other end is unknown 1: snaps back when the spring is soft.
pub struct ArchWithSpring {
    pub arch: Arch,
    pub spring: f64,
}

impl Potential for ArchWithSpring {
    fn unknowns(&self) -> usize {
        2
    }

    fn energy(&self, q: &[f64]) -> f64 {
        self.arch.energy(&q[..1]) + 0.5 * self.spring * (q[1] - q[0]).powi(2)
    }

    fn gradient(&self, q: &[f64], out: &mut [f64]) {
        self.arch.gradient(&q[..1], &mut out[..1]);
        let force = self.spring * (q[1] - q[0]);
        out[0] -= force;
        out[1] = force;
    }

    fn hessian(&self, q: &[f64], add: &mut dyn FnMut(usize, usize, f64)) {
        self.arch.hessian(&q[..1], add);
        add(0, 0, self.spring);
        add(1, 0, -self.spring);
        add(1, 1, self.spring);
    }

    fn load(&self, _q: &[f64], out: &mut [f64]) {
        out.copy_from_slice(&[0.0, 1.0]);
    }
}

/// A rigid bar of length 1 on a rotational spring of stiffness 1, pressed along its axis: P = θ/sin θ.
pub struct RigidColumn;

impl Potential for RigidColumn {
    fn unknowns(&self) -> usize {
        1
    }

    fn energy(&self, q: &[f64]) -> f64 {
        0.5 * q[0] * q[0]
    }

    fn gradient(&self, q: &[f64], out: &mut [f64]) {
        out[0] = q[0];
    }

    fn hessian(&self, _q: &[f64], add: &mut dyn FnMut(usize, usize, f64)) {
        add(0, 0, 1.0);
    }

    fn load(&self, q: &[f64], out: &mut [f64]) {
        out[0] = libm::sin(q[0]);
    }

    fn load_tangent(&self, q: &[f64], add: &mut dyn FnMut(usize, usize, f64)) {
        add(0, 0, libm::cos(q[0]));
    }
}

/// A spring that softens, λ = w exp(−w): no equilibrium above 1/e.
pub struct Softening;

impl Potential for Softening {
    fn unknowns(&self) -> usize {
        1
    }

    fn energy(&self, q: &[f64]) -> f64 {
        1.0 - (1.0 + q[0]) * libm::exp(-q[0])
    }

    fn gradient(&self, q: &[f64], out: &mut [f64]) {
        out[0] = q[0] * libm::exp(-q[0]);
    }

    fn hessian(&self, q: &[f64], add: &mut dyn FnMut(usize, usize, f64)) {
        add(0, 0, (1.0 - q[0]) * libm::exp(-q[0]));
    }

    fn load(&self, _q: &[f64], out: &mut [f64]) {
        out[0] = 1.0;
    }
}

/// Hencky's chain: `links` rigid links of length 1/links between two hinges, rotational springs EI/a with EI = 1
/// at the joints, pressed along the axis. Unknowns are the deflections of the joints.
pub struct Hencky {
    pub links: usize,
}

impl Hencky {
    fn link(&self) -> f64 {
        1.0 / self.links as f64
    }

    /// Critical load m of the chain, (4c/a) sin²(mπ/2n) with c = EI/a.
    pub fn critical(&self, m: usize) -> f64 {
        let a = self.link();
        4.0 / (a * a) * libm::sin(m as f64 * std::f64::consts::PI / (2.0 * self.links as f64)).powi(2)
    }

    fn slope(&self, q: &[f64], link: usize) -> f64 {
        let left = if link == 0 { 0.0 } else { q[link - 1] };
        let right = if link + 1 == self.links { 0.0 } else { q[link] };
        (right - left) / self.link()
    }

    /// Joints of a link with the signs of their deflections in its slope.
    fn ends(&self, link: usize) -> Vec<(usize, f64)> {
        let left = (link > 0).then(|| (link - 1, -1.0 / self.link()));
        let right = (link + 1 < self.links).then(|| (link, 1.0 / self.link()));
        left.into_iter().chain(right).collect()
    }
}

impl Potential for Hencky {
    fn unknowns(&self) -> usize {
        self.links - 1
    }

    fn energy(&self, q: &[f64]) -> f64 {
        let angle = |link| libm::asin(self.slope(q, link));
        (1..self.links).map(|l| 0.5 / self.link() * (angle(l) - angle(l - 1)).powi(2)).sum()
    }

    fn gradient(&self, q: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        for joint in 1..self.links {
            let turn = libm::asin(self.slope(q, joint)) - libm::asin(self.slope(q, joint - 1));
            for (link, sign) in [(joint, 1.0), (joint - 1, -1.0)] {
                let rate = 1.0 / (1.0 - self.slope(q, link).powi(2)).sqrt();
                for (i, share) in self.ends(link) {
                    out[i] += turn / self.link() * sign * rate * share;
                }
            }
        }
    }

    fn hessian(&self, q: &[f64], add: &mut dyn FnMut(usize, usize, f64)) {
        for joint in 1..self.links {
            let turn =
                (libm::asin(self.slope(q, joint)) - libm::asin(self.slope(q, joint - 1))) / self.link();
            let mut rates: Vec<(usize, f64)> = Vec::new();
            for (link, sign) in [(joint, 1.0), (joint - 1, -1.0)] {
                let s = self.slope(q, link);
                let root = (1.0 - s * s).sqrt();
                for (i, share) in self.ends(link) {
                    rates.push((i, sign * share / root));
                    for (j, other) in self.ends(link).into_iter().filter(|&(j, _)| j <= i) {
                        add(i, j, turn * sign * share * other * s / root.powi(3));
                    }
                }
            }
            for &(i, a) in &rates {
                for &(j, b) in rates.iter().filter(|&&(j, _)| j <= i) {
                    add(i, j, a * b / self.link());
                }
            }
        }
    }

    fn load(&self, q: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        for link in 0..self.links {
            let s = self.slope(q, link);
            for (i, share) in self.ends(link) {
                out[i] += self.link() * s / (1.0 - s * s).sqrt() * share;
            }
        }
    }

    fn load_tangent(&self, q: &[f64], add: &mut dyn FnMut(usize, usize, f64)) {
        for link in 0..self.links {
            let root = (1.0 - self.slope(q, link).powi(2)).sqrt();
            for (i, share) in self.ends(link) {
                for (j, other) in self.ends(link).into_iter().filter(|&(j, _)| j <= i) {
                    add(i, j, self.link() * share * other / root.powi(3));
                }
            }
        }
    }
}
