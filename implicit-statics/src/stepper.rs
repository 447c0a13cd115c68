//! One continuation step from a converged state: predictor, corrector, and what is kept between steps.

use crate::breaking::Gone;
use crate::newton::{Constraint, within_reach};
use crate::options::{Control, PathOptions};
use crate::path::Start;
use crate::vectors::dot;
use crate::{Breach, Converged, Equilibrium, EquilibriumError, Increment, Newton};

/// Part of a step left unexplained by the tangents at its ends above which it may have left its branch.
///
/// A ring rolled up in two steps, 90° a step, leaves .09, the coarsest paths of shells tried .29; a step over a limit
/// point .9, a step back 1.
const MISS: f64 = 0.5;
/// The same where Newton passed by a state with more negative pivots than both ends. Rings rolled up do so, and leave .12.
const WILD_MISS: f64 = 0.25;
/// What the tangent at one end leaves counts so many times.
const ALONE: f64 = 10.0;

/// Part of a step by its tangent up to which the bend of the path is trusted, and sizes of the last step it is extrapolated over.
const BEND: f64 = 0.5;
const BEYOND: f64 = 4.0;

/// A step made.
pub(crate) struct StepOutcome {
    pub converged: Converged,
    pub increment: Increment,
    /// Whether it may have left its branch, by what the tangents at its two ends leave unexplained; where that was asked for.
    pub strays: bool,
    /// Directions in which the equilibrium is unstable under the control.
    pub unstable: usize,
    /// Change of level of the predictor.
    pub predicted: f64,
}

/// Steps of a path: the state stands at the last converged point whenever no step is being made.
pub(crate) struct Stepper<'a> {
    pub newton: &'a mut Newton,
    pub level: f64,
    pub last: Option<Increment>,
    control: &'a Control,
    /// Weights of the functional, or of the norm of an increment.
    weights: Vec<f64>,
    /// ψ², what a change of level counts in the norm.
    load: f64,
    sign: f64,
    /// Whether steps are compared with the tangents at their ends.
    compares: bool,
    /// Whether steps are predicted along the bend of the path: the last one lies in the present tangent space.
    bends: bool,
    /// Negative pivots and response at the last converged point, once a step set out from there.
    departure: Option<(usize, Option<Vec<f64>>)>,
}

impl<'a> Stepper<'a> {
    /// Brings the starting state to balance; measures the first step, and the step that bounds are relative to.
    pub fn new<E: Equilibrium + ?Sized>(
        newton: &'a mut Newton,
        system: &mut E,
        start: &Start,
        options: &'a PathOptions,
    ) -> Result<(Self, Converged, (f64, f64)), EquilibriumError> {
        newton.begin(system, start.stiffness.as_deref())?;
        let arc = matches!(options.control, Control::ArcLength { .. });
        let bends = !arc && system.motion_to(&system.save(), &mut vec![0.0; system.unknowns()]);
        let mut stepper = Self {
            newton,
            level: start.level,
            last: start.heading.clone(),
            control: &options.control,
            weights: Vec::new(),
            load: 0.0,
            sign: 1.0,
            compares: options.critical.is_some(),
            bends,
            departure: None,
        };
        let response = stepper.newton.response(system, start.level)?;
        let (change, sizes) = match &options.control {
            Control::Load { step, until } => {
                stepper.sign = (until - start.level).signum();
                (*step, (step.abs(), step.abs()))
            }
            Control::Displacement { functional, step, until } => {
                stepper.weights = vec![0.0; system.unknowns()];
                functional.iter().for_each(|&(unknown, weight)| stepper.weights[unknown] += weight);
                stepper.sign = until.signum();
                (step / dot(&stepper.weights, &response), (step.abs(), step.abs()))
            }
            Control::ArcLength { first, .. } => {
                stepper.weights = arc_weights(system);
                stepper.sign = first.signum();
                let compliance = stepper.product(&response, &response);
                // a load that moves nothing yet (a column before it buckles) leaves the level alone as the arc
                stepper.load = if compliance > 0.0 { options.load_share * compliance } else { 1.0 };
                let linear = first.abs() * (compliance + stepper.load).sqrt();
                let heading = start.heading.as_ref().map(|heading| stepper.length(heading));
                (*first, (heading.unwrap_or(linear), linear.max(heading.unwrap_or(0.0))))
            }
        };
        if change.is_finite() {
            stepper.newton.expect(change, &response);
        }
        let converged = stepper.newton.settle(system, start.level, start.stiffness.is_some())?;
        Ok((stepper, converged, sizes))
    }

    /// Tries a step of the given size; on failure the state is not put back.
    pub fn advance<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
        size: f64,
    ) -> Result<StepOutcome, EquilibriumError> {
        let zero = vec![0.0; system.unknowns()];
        let mut increment = Increment { motion: zero, level: 0.0 };
        let (before, from) = self.depart(system)?;
        let predicted;
        let converged = match (self.control, &from) {
            (Control::Load { .. }, _) => {
                predicted = self.sign * size;
                increment.level = predicted;
                let level = self.level + increment.level;
                let mut bent = false;
                if let Some(response) = from.as_ref().filter(|_| system.has_moving_supports() || self.bends) {
                    let predict = system.has_moving_supports() || self.last.is_some();
                    if predict {
                        bent = self.predict(system, &mut increment, predicted, response)?;
                    }
                }
                let converged =
                    self.newton.correct(system, level, &mut increment, &Constraint::Level, bent)?;
                if converged.inertia.negative != before {
                    self.newton.same_side(system, level, &increment)?;
                }
                converged
            }
            (Control::Displacement { .. }, Some(response)) => {
                let rate = dot(&self.weights, response);
                let target = self.sign * size;
                predicted = target / rate;
                let bent = self.predict(system, &mut increment, predicted, response)?;
                let constraint = Constraint::Functional { weights: &self.weights, target };
                self.newton.correct(
                    system,
                    self.level + increment.level,
                    &mut increment,
                    &constraint,
                    bent,
                )?
            }
            (Control::ArcLength { .. }, Some(response)) => {
                let length = (self.product(response, response) + self.load).sqrt();
                let sign = self.heading(response);
                predicted = sign * size / length;
                self.predict(system, &mut increment, predicted, response)?;
                let constraint = Constraint::Sphere { weights: &self.weights, load: self.load, radius: size };
                self.newton.correct(
                    system,
                    self.level + increment.level,
                    &mut increment,
                    &constraint,
                    false,
                )?
            }
            (_, None) => unreachable!("asked for at the departure"),
        };
        let most_negative = self.newton.most_negative;
        let unstable = self.unstable(system, &converged)?;
        let strays = match from.filter(|_| self.compares) {
            Some(from) => {
                let arc = matches!(self.control, Control::ArcLength { .. });
                let wild = !arc && most_negative > before.max(converged.inertia.negative);
                let bound = if wild { WILD_MISS } else { MISS };
                self.miss(system, (&from, predicted), &converged, &increment)? > bound
            }
            None => false,
        };
        Ok(StepOutcome { converged, increment, strays, unstable, predicted })
    }

    /// Negative pivots at the last converged point, and the response to the load where steps are predicted by it or
    /// compared with it.
    fn depart<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
    ) -> Result<(usize, Option<Vec<f64>>), EquilibriumError> {
        if let Some(known) = &self.departure {
            return Ok(known.clone());
        }
        let by_load = matches!(self.control, Control::Load { .. });
        let predicts = !by_load || system.has_moving_supports() || self.bends && self.last.is_some();
        let negative = self.newton.tangent(system, self.level)?.negative;
        let response =
            if predicts || self.compares { Some(self.newton.response(system, self.level)?) } else { None };
        self.departure = Some((negative, response.clone()));
        Ok((negative, response))
    }

    /// Part of a step that the mean of the tangents at its two ends, each over the whole step, leaves unexplained, or one of them alone.
    ///
    /// Along a smooth branch the mean leaves what the trapezoidal rule does of `∫q′ds`, of third order in the step. Where something comes to touch, or lets go,
    /// at one end, the branch has a kink there and follows the tangent of the other, nearly straight: it has to explain ten times as well. Over a limit point
    /// `q′` has a pole between the ends, and a step to another branch is long where the tangents are short; a step back is 1.
    fn miss<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
        (from, first): (&[f64], f64),
        converged: &Converged,
        increment: &Increment,
    ) -> Result<f64, EquilibriumError> {
        let to = self.newton.response(system, converged.level)?;
        // Change of level for which the tangent at the end makes a step of the same size, as `first` does at the start.
        let last = match self.control {
            Control::Load { .. } => increment.level,
            Control::Displacement { .. } => dot(&self.weights, &increment.motion) / dot(&self.weights, &to),
            Control::ArcLength { .. } => {
                let along = self.product(&to, &increment.motion) + self.load * increment.level;
                let unit = (self.product(&to, &to) + self.load).sqrt();
                self.length(increment).copysign(along) / unit
            }
        };
        let left = |[a, b]: [f64; 2]| {
            let explained = |(q, (from, to)): (&f64, (&f64, &f64))| q - a * first * from - b * last * to;
            let rest = Increment {
                motion: increment.motion.iter().zip(from.iter().zip(&to)).map(explained).collect(),
                level: increment.level - a * first - b * last,
            };
            if let Control::ArcLength { .. } = self.control {
                return self.length(&rest) / self.length(increment);
            }
            let rounding = self.newton.is_rounding(&rest.motion, increment);
            let share = self.newton.length(&rest.motion) / self.newton.length(&increment.motion);
            if rounding || share.is_nan() { 0.0 } else { share }
        };
        let alone = left([1.0, 0.0]).min(left([0.0, 1.0]));
        Ok(left([0.5, 0.5]).min(ALONE * alone))
    }

    /// Negative pivots; where a displacement is given, less the one that it holds.
    ///
    /// The tangent bordered by the functional c has one negative pivot more than its free part, and by Sylvester's law
    /// those of K and of −c·K⁻¹c together; c is along the load that brings the displacement about.
    fn unstable<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
        converged: &Converged,
    ) -> Result<usize, EquilibriumError> {
        let negative = converged.inertia.negative;
        if negative == 0 || !matches!(self.control, Control::Displacement { .. }) {
            return Ok(negative);
        }
        let response = self.newton.response(system, converged.level)?;
        Ok(negative - usize::from(dot(&self.weights, &response) < 0.0))
    }

    /// Goes to a given level, predicted on the way of an increment that crosses it; the state is not put back.
    pub fn reach_level<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
        level: f64,
        crossing: &Increment,
    ) -> Result<StepOutcome, EquilibriumError> {
        let share = (level - self.level) / crossing.level;
        let mut motion: Vec<f64> = crossing.motion.iter().map(|q| share * q).collect();
        within_reach(system, &mut motion);
        let mut increment = Increment { motion, level: level - self.level };
        self.newton.advance(system, &increment.motion);
        let converged = self.newton.correct(system, level, &mut increment, &Constraint::Level, false)?;
        let (unstable, predicted) = (converged.inertia.negative, level - self.level);
        Ok(StepOutcome { converged, increment, strays: false, unstable, predicted })
    }

    /// Takes the step from a saved state over, which led to the present one as the new last point.
    pub fn accept<E: Equilibrium + ?Sized>(
        &mut self,
        system: &E,
        saved: &[f64],
        level: f64,
        mut increment: Increment,
    ) {
        self.newton.accept(&increment);
        if self.bends && system.motion_to(saved, &mut increment.motion) {
            increment.motion.iter_mut().for_each(|q| *q = -*q);
        }
        self.level = level;
        self.last = Some(increment);
        self.departure = None;
    }

    /// Breaks what the last point takes furthest beyond its limit, and goes over to the balance without it, where the
    /// controlled quantity is as it was; none where all is within its limits.
    pub fn give_way<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
    ) -> Result<Option<(Converged, usize, Breach)>, EquilibriumError> {
        let constraint = match self.control {
            Control::Displacement { .. } => Constraint::Functional { weights: &self.weights, target: 0.0 },
            _ => Constraint::Level,
        };
        let gone = self.newton.break_critical(system, self.level, &constraint)?;
        let Some(Gone { breach, converged, increment }) = gone else { return Ok(None) };
        self.newton.accept(&increment);
        (self.level, self.departure) = (converged.level, None);
        // The path has a corner here: its bend tells nothing of what follows.
        if !matches!(self.control, Control::ArcLength { .. }) {
            self.last = None;
        }
        let unstable = self.unstable(system, &converged)?;
        Ok(Some((converged, unstable, breach)))
    }

    /// Whence the path goes on.
    pub fn restart(&self) -> Start {
        let stiffness = Some(self.newton.solver.first_stiffness().to_vec());
        Start { level: self.level, heading: self.last.clone(), stiffness }
    }

    /// Length of an increment in the norm of the arc.
    pub fn length(&self, increment: &Increment) -> f64 {
        (self.product(&increment.motion, &increment.motion) + self.load * increment.level.powi(2)).sqrt()
    }

    /// The controlled quantity of an increment: level, functional or arc length.
    pub fn size(&self, increment: &Increment) -> f64 {
        match self.control {
            Control::Load { .. } => increment.level.abs(),
            Control::Displacement { .. } => dot(&self.weights, &increment.motion).abs(),
            Control::ArcLength { .. } => self.length(increment),
        }
    }

    /// Moves along the response by a change of level, and along the bend of the path; whether it had one.
    fn predict<E: Equilibrium + ?Sized>(
        &mut self,
        system: &mut E,
        increment: &mut Increment,
        change: f64,
        response: &[f64],
    ) -> Result<bool, EquilibriumError> {
        if !change.is_finite() {
            let (step, level) = (self.newton.step, self.level);
            return Err(EquilibriumError::Uncontrolled { step, level, rate: dot(&self.weights, response) });
        }
        increment.level = change;
        for (motion, response) in increment.motion.iter_mut().zip(response) {
            *motion = change * response;
        }
        let bend = self.bend(increment);
        if let Some(bend) = &bend {
            increment.level += bend.level;
            increment.motion.iter_mut().zip(&bend.motion).for_each(|(q, b)| *q += b);
        }
        within_reach(system, &mut increment.motion);
        self.newton.advance(system, &increment.motion);
        Ok(bend.is_some())
    }

    /// What a parabola through the last two points adds to a step `t` along the tangent at the second: with the last step
    /// `l` and the ratio c of their sizes `c t − c² l`.
    fn bend(&self, tangent: &Increment) -> Option<Increment> {
        let last = self.last.as_ref().filter(|_| self.bends)?;
        let size = |step: &Increment| match self.control {
            Control::Displacement { .. } => dot(&self.weights, &step.motion),
            _ => step.level,
        };
        let ratio = size(tangent) / size(last);
        if !(ratio > 0.0 && ratio <= BEYOND) {
            return None;
        }
        let bent = |t: f64, l: f64| ratio * (t - ratio * l);
        let motion: Vec<f64> = tangent.motion.iter().zip(&last.motion).map(|(t, l)| bent(*t, *l)).collect();
        let trusted = self.newton.length(&motion) <= BEND * self.newton.length(&tangent.motion);
        trusted.then(|| Increment { motion, level: bent(tangent.level, last.level) })
    }

    /// Sign of the predictor's change of level: not back along the last step \[feng1996\].
    fn heading(&self, response: &[f64]) -> f64 {
        let forward = match &self.last {
            Some(last) => self.product(&last.motion, response) + self.load * last.level,
            None => self.sign,
        };
        if forward < 0.0 { -1.0 } else { 1.0 }
    }

    fn product(&self, a: &[f64], b: &[f64]) -> f64 {
        (0..a.len()).map(|i| self.weights[i] * a[i] * b[i]).sum()
    }
}

/// Weights of the norm of an increment: masses over their sum, the same for any mesh and unit; plain without masses.
pub(crate) fn arc_weights<E: Equilibrium + ?Sized>(system: &E) -> Vec<f64> {
    let masses = system.masses();
    let total: f64 = masses.iter().sum();
    if total > 0.0 { masses.iter().map(|m| m / total).collect() } else { vec![1.0; system.unknowns()] }
}
