//! Dashpots between places and to the ground: a force against the rate of elongation, in time.
//!
//! Central differences know velocities half a step before the places at which forces are asked for. A dashpot carries the last two on to the present
//! instant, each with the instant it belongs to:
//!
//! ```text
//! v(t) ≈ v₁ + (v₁ − v₀)(t − t₁)/(t₁ − t₀)        f_near = c n·(v_far − v_near) n = −f_far
//! ```
//!
//! of second order in the step. A motion that decays at the rate `λ = c (1/m_a + 1/m_b)` beside a frequency ω is stable to `(½ω Δt)² + λ Δt ≤ 1`: the
//! characteristic polynomial of both rules has its root −1 there.

use sph_core::Vec3;

use crate::reach::Reach;

/// A dashpot.
#[derive(Clone, Debug)]
pub struct Dashpot {
    /// Ends and line.
    pub reach: Reach,
    /// Force by rate of elongation \[F T/L\].
    pub damping: f64,
}

/// Velocities of all places at an instant.
#[derive(Clone, Debug, Default)]
struct Seen {
    at: f64,
    velocities: Vec<[f64; 3]>,
}

/// Dashpots between places, with what they have seen of their motion.
#[derive(Clone, Debug)]
pub struct Dashpots {
    dashpots: Vec<Dashpot>,
    rest: Vec<Vec3>,
    /// The instant of the last step, if one was taken \[T\].
    stepped: Option<f64>,
    /// The velocities before the last step, and those now: of an instant of their own.
    before: Option<Seen>,
    now: Seen,
    /// The present instant \[T\].
    time: f64,
    /// Velocities carried on to it.
    carried: Vec<[f64; 3]>,
}

impl Dashpots {
    /// Dashpots between places that stand here at rest \[L\].
    pub fn new(dashpots: Vec<Dashpot>, rest: Vec<Vec3>) -> Self {
        let carried = vec![[0.0; 3]; rest.len()];
        Self { dashpots, rest, stepped: None, before: None, now: Seen::default(), time: 0.0, carried }
    }

    /// Takes note of velocities at an instant: those in the middle of the step that led there, at the start its own.
    pub fn see(&mut self, time: f64, velocities: &[[f64; 3]]) {
        let at = self.stepped.map_or(time, |last| 0.5 * (last + time));
        self.now.at = at;
        self.now.velocities.clear();
        self.now.velocities.extend_from_slice(velocities);
        self.time = time;
        self.carried.copy_from_slice(velocities);
        if let Some(before) = self.before.as_ref().filter(|before| before.at < at) {
            let factor = (time - at) / (at - before.at);
            for (carried, old) in self.carried.iter_mut().zip(&before.velocities) {
                (0..3).for_each(|k| carried[k] += factor * (carried[k] - old[k]));
            }
        }
    }

    /// Fills in the forces at places, of the velocities last seen.
    pub fn evaluate(&self, places: &[[f64; 3]], forces: &mut [[f64; 3]]) {
        forces.fill([0.0; 3]);
        for Dashpot { reach, damping } in &self.dashpots {
            let (_, n, _) = reach.drawn(places, &self.rest);
            reach.pull(&(n * (damping * reach.rate(&n, &self.carried))), forces);
        }
    }

    /// Takes note that a step was taken from the instant last seen.
    pub fn step(&mut self) {
        self.stepped = Some(self.time);
        std::mem::swap(self.before.get_or_insert_with(Seen::default), &mut self.now);
    }

    /// A bound of the rate at which motions of places of these masses \[M\] decay, by sums over rows \[1/T\].
    pub fn fastest(&self, masses: &[f64]) -> f64 {
        let mut sums = vec![0.0; masses.len()];
        for Dashpot { reach, damping } in &self.dashpots {
            reach.bound(*damping, masses, &mut sums);
        }
        sums.into_iter().fold(0.0, f64::max)
    }

    /// What a state keeps of it: the last two instants, and velocities by place; nothing before the first step.
    pub fn kept(&self) -> Vec<f64> {
        let (Some(stepped), Some(before)) = (self.stepped, &self.before) else { return Vec::new() };
        [stepped, before.at].into_iter().chain(before.velocities.iter().flatten().copied()).collect()
    }

    /// Takes that up; false, and nothing done, if it is that of another.
    pub fn take_up(&mut self, kept: &[f64]) -> bool {
        match kept {
            [] => (self.stepped, self.before) = (None, None),
            [stepped, at, velocities @ ..] if velocities.len() == 3 * self.rest.len() => {
                let velocities = velocities.chunks_exact(3).map(|v| [v[0], v[1], v[2]]).collect();
                (self.stepped, self.before) = (Some(*stepped), Some(Seen { at: *at, velocities }));
            }
            _ => return false,
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reach::{Far, Span};

    /// A mass on a spring and a dashpot to the ground, by central differences of this step: its place after a time.
    fn end(stiffness: f64, damping: f64, dt: f64, steps: usize) -> f64 {
        let reach = Reach { near: 0, far: Far::Ground(Vec3::zeros()), span: Span::Along(-Vec3::x()) };
        let mut dashpots = Dashpots::new(vec![Dashpot { reach, damping }], vec![Vec3::zeros()]);
        let (mut x, mut v, mut forces) = (1.0, 0.0, [[0.0; 3]]);
        for step in 0..steps {
            dashpots.see(step as f64 * dt, &[[v, 0.0, 0.0]]);
            dashpots.evaluate(&[[x, 0.0, 0.0]], &mut forces);
            let kick = if step == 0 { 0.5 * dt } else { dt };
            v += kick * (forces[0][0] - stiffness * x);
            x += dt * v;
            dashpots.step();
            // A state that is kept and taken up goes on alike.
            let kept = dashpots.kept();
            assert!(dashpots.take_up(&kept) && !dashpots.take_up(&kept[1..]));
        }
        x
    }

    /// `x = e^{−ζt}(cos ω_d t + ζ/ω_d sin ω_d t)` with ω = 1, ζ = .2: errors fall by four where steps are halved.
    #[test]
    fn a_damped_mass_decays_as_it_should_by_the_square_of_the_step() {
        let (zeta, t) = (0.2, 3.0);
        let w = (1.0_f64 - zeta * zeta).sqrt();
        let exact = libm::exp(-zeta * t) * (libm::cos(w * t) + zeta / w * libm::sin(w * t));
        let error = |steps: usize| end(1.0, 2.0 * zeta, t / steps as f64, steps) - exact;
        let [coarse, fine] = [60, 120].map(error);
        assert!(coarse.abs() < 1e-3 && (coarse / fine - 4.0).abs() < 0.2, "{coarse} {fine}");
    }

    /// `(½ω Δt)² + λ Δt = 1` divides what dies out from what grows.
    #[test]
    fn steps_are_stable_up_to_the_bound() {
        for stiffness in [0.0, 1.0, 3.0] {
            let damping = 1.0 - 0.25 * stiffness;
            assert!(end(stiffness, 0.98 * damping, 1.0, 400).abs() < 2.0);
            assert!(end(stiffness, 1.02 * damping + 0.01, 1.0, 400).abs() > 10.0 || stiffness == 0.0);
        }
        // Alone it slows the mass down to rest, or throws it about.
        let thrown = |damping: f64| {
            let (mut v, mut old) = (1.0_f64, 1.0_f64);
            for _ in 0..400 {
                (v, old) = (v - damping * (1.5 * v - 0.5 * old), v);
            }
            v.abs()
        };
        assert!(thrown(0.98) < 0.1 && thrown(1.02) > 10.0);
    }

    #[test]
    fn both_ends_feel_the_same_force_against_the_rate() {
        let reach = Reach { near: 1, far: Far::Place(0), span: Span::Length(0.3) };
        let rest = vec![Vec3::zeros(), Vec3::new(1.0, 2.0, 2.0)];
        let mut dashpots = Dashpots::new(vec![Dashpot { reach, damping: 2.0 }], rest);
        dashpots.see(0.0, &[[0.0; 3], [3.0, 0.0, 0.0]]);
        let mut forces = [[0.0; 3]; 2];
        dashpots.evaluate(&[[0.0; 3], [1.0, 2.0, 2.0]], &mut forces);
        // The line is (1, 2, 2)/3, the rate one.
        for k in 0..3 {
            assert_eq!(forces[0][k], -forces[1][k]);
            assert!((forces[0][k] - 2.0 * [1.0, 2.0, 2.0][k] / 3.0).abs() < 1e-15);
        }
    }
}
