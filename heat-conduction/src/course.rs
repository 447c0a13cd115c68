//! Temperatures in time, by an implicit rule of second order that damps whatever a step cannot follow.
//!
//! ```text
//! C Ṫ = f(T, t)        C_a = Σ ρ c t A at the particles of a shell, where films and sources act as well; C_ab = ∫ ρ c φ_a φ_b dV where shape functions carry a solid
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
use super::steady::{Entering, LEFT, ROUNDING};
use super::system::System;
use super::{Capacity, Conduction, ConductionError, Conducts, HeatBalance, Temperatures};

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

/// The course of temperatures of a body in time.
pub struct HeatCourse {
    system: System,
    capacity: Capacity,
    values: Vec<f64>,
    time: f64,
    came: HeatBalance,
    stored: f64,
    overshoot: f64,
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
    /// Rates at its end \[Θ/T\].
    rates: Vec<f64>,
    came: HeatBalance,
    stored: f64,
    error: f64,
}

impl HeatCourse {
    /// Of a body at rest at some parameters \[Θ\], with what it stores; what is held from the start is there at once.
    ///
    /// # Errors
    /// [`ConductionError::Capacity`] for parameters that store nothing, [`ConductionError`] for a matrix that cannot be analysed; none is known.
    pub fn new<C: Conducts>(
        of: &Conduction<C>,
        capacity: Capacity,
        temperatures: &[f64],
    ) -> Result<Self, ConductionError> {
        let mut system = System::new(of, Some(&capacity))?;
        let is_poor = |&&a: &&u32| !(capacity.own[a as usize] > 0.0 && capacity.own[a as usize].is_finite());
        if let Some(&particle) = system.free.iter().find(is_poor) {
            return Err(ConductionError::Capacity { particle, capacity: capacity.own[particle as usize] });
        }
        let given = of.given_at(0.0);
        let mut values = temperatures.to_vec();
        system.put(&given, &mut values);
        if !capacity.pairs.is_empty() {
            // What holds nodes moves parameters that others have a part of: of all with these held, the free ones are as near to the start as heat tells.
            let moved: Vec<f64> = values.iter().zip(temperatures).map(|(to, from)| from - to).collect();
            let mut change = system.project(&capacity.stored(&moved));
            system.factor(of, &given, &values, (0.0, Some(&capacity)))?;
            system.solver.solve(&mut change)?;
            system.free.iter().zip(&change).for_each(|(&a, change)| values[a as usize] += change);
            system.put(&given, &mut values);
        }
        // Held nodes store at once what they are made warmer by, and what holds them gives it.
        let jumps: Vec<f64> = values.iter().zip(temperatures).map(|(to, from)| to - from).collect();
        let stored = capacity.stored(&jumps).iter().sum::<f64>();
        let entering = of.entering(&given, &values);
        let found = of.found(&system, &given, (&values, &entering), 0);
        let came = HeatBalance { held: stored, ..HeatBalance::default() };
        let known =
            of.conductor.at_nodes(temperatures).into_iter().chain(given.held.iter().copied().flatten());
        let [least, most] =
            known.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], t| [low.min(t), high.max(t)]);
        let overshoot = found.values.iter().fold(0.0, |far: f64, t| far.max(t - most).max(least - t));
        Ok(Self {
            system,
            capacity,
            values,
            time: 0.0,
            came,
            stored,
            overshoot,
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
    pub fn advance<C: Conducts>(
        &mut self,
        of: &Conduction<C>,
        until: f64,
        tolerance: f64,
    ) -> Result<(), ConductionError> {
        let within = |time: &f64| self.time < *time && *time < until;
        let mut ends: Vec<f64> = of.courses.iter().flat_map(Amplitude::corners).filter(within).collect();
        ends.push(until);
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        ends.into_iter().try_for_each(|end| self.go_on(of, end, tolerance))
    }

    fn go_on<C: Conducts>(
        &mut self,
        of: &Conduction<C>,
        until: f64,
        tolerance: f64,
    ) -> Result<(), ConductionError> {
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

    /// Puts parameters that are not held elsewhere \[Θ\], without a heat that counts.
    pub fn put<C: Conducts>(&mut self, of: &Conduction<C>, parameters: &[f64]) {
        let given = of.given_at(self.time);
        self.values = parameters.to_vec();
        self.system.put(&given, &mut self.values);
        let entering = of.entering(&given, &self.values);
        self.found = of.found(&self.system, &given, (&self.values, &entering), self.solves);
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

    /// How far nodes are at the start beyond the temperatures that they had and those at which some are held \[Θ\]: where shape functions carry a body they swing beside a
    /// jump.
    pub fn overshoot(&self) -> f64 {
        self.overshoot
    }

    /// Sum of the estimates of all steps, the greatest of the body each \[Θ\].
    pub fn error(&self) -> f64 {
        self.error
    }

    /// Steps taken.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Tries a step of a length.
    fn step<C: Conducts>(&mut self, of: &Conduction<C>, h: f64) -> Result<Trial, ConductionError> {
        let given = [0.0, GAMMA * h, h].map(|more| of.given_at(self.time + more));
        let f0 = of.entering(&given[0], &self.values);
        let weighted = |parts: &[(f64, &Entering)], a: usize| -> f64 {
            parts.iter().map(|(weight, f)| h * weight * f.net[a]).sum()
        };
        let (middle, f1) = self.stage(of, &given[1], h, |a| weighted(&[(D, &f0)], a))?;
        let (values, f2) = self.stage(of, &given[2], h, |a| weighted(&[(W, &f0), (W, &f1)], a))?;
        let companion = [((4.0 * W - 1.0) / 3.0, &f0), (-1.0 / 3.0, &f1), (2.0 * D / 3.0, &f2)];
        let all = |parts: &[(f64, &Entering)]| -> Vec<f64> {
            (0..self.values.len()).map(|a| weighted(parts, a)).collect()
        };
        let mut errors = self.system.project(&all(&companion));
        self.system.solver.solve(&mut errors)?;
        self.solves += 1;
        let error =
            errors.into_iter().fold(0.0, |most: f64, e| if e.is_nan() { e } else { most.max(e.abs()) });
        let rule = [(W, &f0), (W, &f1), (D, &f2)];
        let [start, between, end] = [(&given[0], &self.values), (&given[1], &middle), (&given[2], &values)]
            .map(|(g, t)| of.enters(g, t));
        let sum = |of: fn(&HeatBalance) -> f64| h * (W * (of(&start) + of(&between)) + D * of(&end));
        let gained: Vec<f64> = values.iter().zip(&self.values).map(|(to, from)| to - from).collect();
        let warmed = self.capacity.stored(&gained);
        let stored = warmed.iter().sum();
        let rest: Vec<f64> = warmed.iter().enumerate().map(|(a, own)| own - weighted(&rule, a)).collect();
        let held = self.system.at_held(&rest).iter().sum();
        let rate = |a: usize| (gained[a] - 2.0 * W / GAMMA * (middle[a] - self.values[a])) / (D * h);
        let rates = (0..values.len()).map(rate).collect();
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
    fn stage<C: Conducts>(
        &mut self,
        of: &Conduction<C>,
        given: &Given,
        h: f64,
        rest: impl Fn(usize) -> f64,
    ) -> Result<(Vec<f64>, Entering), ConductionError> {
        let mut values = self.values.clone();
        self.system.put(given, &mut values);
        let mut entering = of.entering(given, &values);
        let mut solves = 0;
        loop {
            let gained: Vec<f64> = values.iter().zip(&self.values).map(|(to, from)| to - from).collect();
            let (warmed, sizes) = (self.capacity.stored(&gained), self.capacity.sizes(&gained));
            let levels = self.capacity.sizes(&values);
            let all = 0..values.len();
            let [left, size, level] = [
                Vec::from_iter(all.clone().map(|a| rest(a) + D * h * entering.net[a] - warmed[a])),
                all.clone().map(|a| rest(a).abs() + D * h * entering.size[a] + sizes[a]).collect(),
                all.map(|a| D * h * entering.level[a] + levels[a]).collect(),
            ];
            let bound = LEFT * self.system.size(&size) + ROUNDING * self.system.size(&level);
            if solves > 0 && self.system.norm(&left) <= bound {
                self.solves += solves;
                return Ok((values, entering));
            }
            if solves == MOST_SOLVES {
                return Err(ConductionError::NotFound { iterations: solves });
            }
            // Lengths of intervals differ by rounding; the residual is that of the step itself.
            let other = self.factored.is_none_or(|own| (own / h - 1.0).abs() > SAME);
            let old = other || solves > 0 && solves.is_multiple_of(OLD);
            let bent = !given.radiating.is_empty() || of.conductor.goes_with_temperature();
            if old || solves == 0 && bent {
                self.system.factor(of, given, &values, (D * h, Some(&self.capacity)))?;
                self.factored = Some(h);
            }
            let mut change = self.system.project(&left);
            self.system.solver.solve(&mut change)?;
            self.system.free.iter().zip(&change).for_each(|(&a, change)| values[a as usize] += change);
            self.system.put(given, &mut values);
            entering = of.entering(given, &values);
            solves += 1;
        }
    }

    /// Takes a step that ends at a time.
    fn take<C: Conducts>(
        &mut self,
        of: &Conduction<C>,
        trial: Trial,
        time: f64,
    ) -> Result<(), ConductionError> {
        let Trial { values, given, entering, rates, came, stored, error } = trial;
        of.refuse_below_zero(&given, &values)?;
        of.conductor.refuse_beyond_tables(&values)?;
        self.found = of.found(&self.system, &given, (&values, &entering), self.solves);
        for (a, more) in self.system.at_held(&self.capacity.stored(&rates)).into_iter().enumerate() {
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
