//! Temperatures in time, by an implicit rule of second order that damps whatever a step cannot follow.
//!
//! ```text
//! C Ṫ = f(T, t)        C_a = Σ ρ c t A, at the particles, where films and sources act as well
//! C (T_γ − T_0) = d h (f_0 + f_γ)                       γ = 2 − √2, d = γ/2, w = √2/4        the trapezoidal rule to t + γh
//! C (T_1 − T_0) = h (w f_0 + w f_γ + d f_1)             two steps back from there            \[bank1985\], as \[hosea1996\] write it
//! C e = h (⅓(4w − 1) f_0 − ⅓ f_γ + ⅔ d f_1)             less a rule of third order of the same f
//! ```
//!
//! Both stages have the matrix C + d h K, whose factor stays as long as the step does; radiation and tables of conductivities take it anew in each. What a step leaves of a temperature that decays by rate λ goes to zero
//! as λh grows (L-stable): a sudden change does not ring. The estimate solves that matrix too in place of C, else it would see what is damped \[hosea1996\].
//!
//! The heat of a step by each way is summed with the weights of the rule, what holds nodes gives the rest of what they store: in all as much enters as is stored,
//! to rounding. A capacity at the particles alone warms them by less than what is around them, where K has no positive entry aside from its diagonal; frequencies
//! of the lattice come out low by the square of the cells, by as much as those of a capacity spread along cells come out high.

use std::f64::consts::SQRT_2;

use explicit_dynamics::Amplitude;

use super::given::Given;
use super::steady::{Entering, LEFT, ROUNDING, norm};
use super::system::System;
use super::{Conduction, ConductionError, HeatBalance, Temperatures};

/// Where the trapezoidal rule ends, in parts of a step.
const GAMMA: f64 = 2.0 - SQRT_2;
const D: f64 = 0.5 * GAMMA;
const W: f64 = 0.25 * SQRT_2;
/// Less than this part of what is allowed, and a step of twice the length keeps to it: its estimate goes with the third power.
const LONGER: f64 = 1.0 / 12.0;
/// Steps whose lengths differ by less have one factor.
const SAME: f64 = 1e-9;
/// Halvings of an interval: a billionth of it.
const MOST_HALVINGS: u32 = 30;
/// Solves of a stage, and after how many of them a factor is made anew.
const MOST_SOLVES: usize = 100;
const OLD: usize = 4;

/// The course of temperatures of a surface in time.
pub struct HeatCourse {
    system: System,
    /// Heat that each node stores by degree \[F L/Θ\].
    capacity: Vec<f64>,
    values: Vec<f64>,
    time: f64,
    came: HeatBalance,
    stored: f64,
    error: f64,
    steps: u64,
    solves: usize,
    /// How often the interval is cut in halves.
    halvings: u32,
    /// The step whose matrix is factorised.
    factored: Option<f64>,
    found: Temperatures,
}

/// A step that may be taken.
struct Trial {
    values: Vec<f64>,
    given: Given,
    entering: Entering,
    /// Rate of held nodes at its end \[Θ/T\].
    rates: Vec<f64>,
    came: HeatBalance,
    stored: f64,
    error: f64,
}

impl HeatCourse {
    /// Of a surface at rest at temperatures of its particles \[Θ\], of which areas store heat by degree \[F L/Θ\]; what is held from the start is there at once.
    ///
    /// # Errors
    /// [`ConductionError::Capacity`] for particles of cells that store nothing, [`ConductionError`] for a matrix that cannot be analysed; none is known.
    pub fn new(
        of: &Conduction,
        capacities: &[(u32, f64)],
        temperatures: &[f64],
    ) -> Result<Self, ConductionError> {
        let system = System::new(of)?;
        let mut capacity = vec![0.0; of.node.len()];
        capacities.iter().for_each(|&(a, own)| capacity[of.node[a as usize] as usize] += own);
        let is_poor = |&&a: &&u32| !(capacity[a as usize] > 0.0 && capacity[a as usize].is_finite());
        if let Some(&particle) = system.free.iter().find(is_poor) {
            return Err(ConductionError::Capacity { particle, capacity: capacity[particle as usize] });
        }
        let given = of.given_at(0.0);
        let values: Vec<f64> =
            given.held.iter().zip(temperatures).map(|(held, start)| held.unwrap_or(*start)).collect();
        // Held nodes store at once what they are made warmer by, and what holds them gives it.
        let jumps = (0..values.len()).map(|a| capacity[a] * (values[a] - temperatures[of.node[a] as usize]));
        let stored = jumps.sum::<f64>();
        let entering = of.entering(&given, &values);
        let found = of.at(&given, &values, &entering, 0);
        let came = HeatBalance { held: stored, ..HeatBalance::default() };
        Ok(Self {
            system,
            capacity,
            values,
            time: 0.0,
            came,
            stored,
            error: 0.0,
            steps: 0,
            solves: 0,
            halvings: 0,
            factored: None,
            found,
        })
    }

    /// Goes on to a time \[T\], in halves of the way so small that the estimate of each step is within a tolerance \[Θ\]. A step ends
    /// wherever a course of what is given has a corner: between them the rule sees all of it.
    ///
    /// # Errors
    /// [`ConductionError`] where no step is short enough, a stage is not solved, or what radiates would be colder than absolute zero.
    pub fn advance(&mut self, of: &Conduction, until: f64, tolerance: f64) -> Result<(), ConductionError> {
        let within = |time: &f64| self.time < *time && *time < until;
        let mut ends: Vec<f64> = of.courses.iter().flat_map(Amplitude::corners).filter(within).collect();
        ends.push(until);
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        ends.into_iter().try_for_each(|end| self.go_on(of, end, tolerance))
    }

    fn go_on(&mut self, of: &Conduction, until: f64, tolerance: f64) -> Result<(), ConductionError> {
        let (from, length) = (self.time, until - self.time);
        let mut at = 0;
        while at < 1 << self.halvings {
            let h = length / f64::from(1 << self.halvings);
            let trial = self.step(of, h)?;
            if trial.error > tolerance || !trial.error.is_finite() {
                if self.halvings == MOST_HALVINGS {
                    return Err(ConductionError::Step { time: self.time, step: h });
                }
                (self.halvings, at) = (self.halvings + 1, 2 * at);
                continue;
            }
            at += 1;
            let time = if at == 1 << self.halvings { until } else { from + f64::from(at) * h };
            let longer = trial.error < LONGER * tolerance;
            self.take(of, trial, time)?;
            if longer && self.halvings > 0 && at % 2 == 0 {
                (self.halvings, at) = (self.halvings - 1, at / 2);
            }
        }
        Ok(())
    }

    /// Puts particles that are not held at other temperatures \[Θ\], without a heat that counts.
    pub fn put(&mut self, of: &Conduction, temperatures: &[f64]) {
        let given = of.given_at(self.time);
        let put = given.held.iter().zip(temperatures).map(|(held, own)| held.unwrap_or(*own));
        self.values = put.collect();
        let entering = of.entering(&given, &self.values);
        self.found = of.at(&given, &self.values, &entering, self.solves);
    }

    /// Time \[T\].
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Temperatures now, and the heat that enters now: its sum is stored.
    pub fn temperatures(&self) -> &Temperatures {
        &self.found
    }

    /// Heat that has entered since the start, by each way \[F L\].
    pub fn came(&self) -> &HeatBalance {
        &self.came
    }

    /// Heat that is stored since the start \[F L\].
    pub fn stored(&self) -> f64 {
        self.stored
    }

    /// Sum of the estimates of all steps, the greatest of the surface each \[Θ\].
    pub fn error(&self) -> f64 {
        self.error
    }

    /// Steps taken.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Tries a step of a length.
    fn step(&mut self, of: &Conduction, h: f64) -> Result<Trial, ConductionError> {
        let given = [0.0, GAMMA * h, h].map(|more| of.given_at(self.time + more));
        let f0 = of.entering(&given[0], &self.values);
        let weighted = |parts: &[(f64, &Entering)], a: usize| -> f64 {
            parts.iter().map(|(weight, f)| h * weight * f.net[a]).sum()
        };
        let (middle, f1) = self.stage(of, &given[1], h, |a| weighted(&[(D, &f0)], a))?;
        let (values, f2) = self.stage(of, &given[2], h, |a| weighted(&[(W, &f0), (W, &f1)], a))?;
        let companion = [((4.0 * W - 1.0) / 3.0, &f0), (-1.0 / 3.0, &f1), (2.0 * D / 3.0, &f2)];
        let mut errors: Vec<f64> =
            self.system.free.iter().map(|&a| weighted(&companion, a as usize)).collect();
        self.system.solver.solve(&mut errors)?;
        self.solves += 1;
        let error =
            errors.into_iter().fold(0.0, |most: f64, e| if e.is_nan() { e } else { most.max(e.abs()) });
        let rule = [(W, &f0), (W, &f1), (D, &f2)];
        let [start, between, end] =
            [(&given[0], &self.values), (&given[1], &middle), (&given[2], &values)].map(|(g, t)| g.enters(t));
        let sum = |of: fn(&HeatBalance) -> f64| h * (W * (of(&start) + of(&between)) + D * of(&end));
        let (mut held, mut stored, mut rates) = (0.0, 0.0, vec![0.0; values.len()]);
        for a in 0..values.len() {
            let (to, from) = (values[a], self.values[a]);
            stored += self.capacity[a] * (to - from);
            if given[2].held[a].is_some() {
                held += self.capacity[a] * (to - from) - weighted(&rule, a);
                rates[a] = (to - from - 2.0 * W / GAMMA * (middle[a] - from)) / (D * h);
            }
        }
        let came = HeatBalance {
            supplied: sum(|b| b.supplied),
            held,
            film: sum(|b| b.film),
            radiated: sum(|b| b.radiated),
        };
        let [_, _, given] = given;
        Ok(Trial { values, given, entering: f2, rates, came, stored, error })
    }

    /// Solves `C (T − T_0) = rest + d h f(T)`.
    fn stage(
        &mut self,
        of: &Conduction,
        given: &Given,
        h: f64,
        rest: impl Fn(usize) -> f64,
    ) -> Result<(Vec<f64>, Entering), ConductionError> {
        let mut values: Vec<f64> =
            given.held.iter().zip(&self.values).map(|(held, before)| held.unwrap_or(*before)).collect();
        let mut entering = of.entering(given, &values);
        let mut solves = 0;
        loop {
            let residual = |a: usize| {
                rest(a) + D * h * entering.net[a] - self.capacity[a] * (values[a] - self.values[a])
            };
            let size = |a: usize| {
                rest(a).abs()
                    + D * h * entering.size[a]
                    + self.capacity[a] * (values[a] - self.values[a]).abs()
            };
            let level = |a: usize| D * h * entering.level[a] + self.capacity[a] * values[a].abs();
            let all = 0..values.len();
            let [left, size, level] = [
                Vec::from_iter(all.clone().map(residual)),
                all.clone().map(size).collect(),
                all.map(level).collect(),
            ];
            let bound = LEFT * norm(&self.system, &size) + ROUNDING * norm(&self.system, &level);
            if solves > 0 && norm(&self.system, &left) <= bound {
                self.solves += solves;
                return Ok((values, entering));
            }
            if solves == MOST_SOLVES {
                return Err(ConductionError::NotFound { iterations: solves });
            }
            // Lengths of intervals differ by rounding; the residual is that of the step itself.
            let other = self.factored.is_none_or(|own| (own / h - 1.0).abs() > SAME);
            let old = other || solves > 0 && solves.is_multiple_of(OLD);
            let bent = !(given.radiating.is_empty() && of.tables.is_empty());
            if old || solves == 0 && bent {
                let capacity = &self.capacity;
                self.system.factor(of, given, &values, D * h, |a| capacity[a])?;
                self.factored = Some(h);
            }
            let mut change: Vec<f64> = self.system.free.iter().map(|&a| left[a as usize]).collect();
            self.system.solver.solve(&mut change)?;
            self.system.free.iter().zip(&change).for_each(|(&a, change)| values[a as usize] += change);
            entering = of.entering(given, &values);
            solves += 1;
        }
    }

    /// Takes a step that ends at a time.
    fn take(&mut self, of: &Conduction, trial: Trial, time: f64) -> Result<(), ConductionError> {
        let Trial { values, given, entering, rates, came, stored, error } = trial;
        given.refuse_below_zero(&values)?;
        of.refuse_beyond_tables(&values)?;
        self.found = of.at(&given, &values, &entering, self.solves);
        for (a, rate) in rates.into_iter().enumerate() {
            let more = self.capacity[a] * rate;
            self.found.held[a] += more;
            self.found.balance.held += more;
        }
        (self.values, self.time) = (values, time);
        self.came.supplied += came.supplied;
        self.came.held += came.held;
        self.came.film += came.film;
        self.came.radiated += came.radiated;
        self.stored += stored;
        self.error += error;
        self.steps += 1;
        Ok(())
    }
}
