//! Paths of equilibria: load, displacement and arc-length control with adaptive steps and restarts.

use std::ops::ControlFlow;

use crate::critical::{CriticalOptions, CriticalPoint};
use crate::error::require;
use crate::passage::{Passage, look_for_critical};
use crate::stepper::{Made, Stepper};
use crate::{Converged, Equilibrium, EquilibriumError, Increment, Inertia, NewtonOptions};

/// Part of the first step above which a load step that may have strayed is halved.
const STRAY: f64 = 0.1;
/// Part of the first step down to which an arc is halved while it strays.
const FINE: f64 = 1e-3;

/// What drives a path.
#[derive(Debug, Clone, PartialEq)]
pub enum Control {
    /// The level goes to `until` in steps of `step`; ends at the first limit point.
    Load {
        /// First change of level \[–\].
        step: f64,
        /// Last level, met exactly \[–\].
        until: f64,
    },
    /// The functional `c·Δq` of the increments goes to `until`; passes limit points, not turning points of `c·q`.
    Displacement {
        /// The unknowns and their weights `c`.
        functional: Vec<(usize, f64)>,
        /// First change of the functional \[its unit\].
        step: f64,
        /// Total change of the functional from the start, with its sign, met exactly \[its unit\].
        until: f64,
    },
    /// The spherical arc length; passes limit points and turning points \[crisfield1981\].
    ArcLength {
        /// Change of level of a linear first step; its sign is the first direction, its size the first radius.
        first: f64,
        /// The path ends when the level leaves this range; the bound that is crossed is met exactly \[–\].
        range: (f64, f64),
    },
}

/// Which way an arc-length step starts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Direction {
    /// Not back along the last step \[feng1996\]; passes limit, turning and bifurcation points.
    #[default]
    Secant,
    /// Level rises while the number of negative pivots is even; turns back at simple bifurcations.
    Inertia,
    /// Level rises while the increment of work `p·K⁻¹p` is positive \[bergan1978\]; turns back at turning points
    /// of the displacement.
    Work,
}

/// The norm of an increment in the arc length.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Measure {
    /// Root mean square with the masses as weights, the same for any mesh and unit \[L\]; plain without masses.
    #[default]
    Mass,
    /// Every unknown counts alike.
    Plain,
    /// Given weights, one for each unknown.
    Given(Vec<f64>),
}

/// How a path is followed.
#[derive(Debug, Clone, PartialEq)]
pub struct PathOptions {
    /// What drives the path.
    pub control: Control,
    /// How every step is corrected.
    pub newton: NewtonOptions,
    /// Steps grow or shrink by √(target/iterations), between halves and doubles; default 5.
    pub target_iterations: usize,
    /// Largest step in units of the first; default 10.
    pub largest: f64,
    /// Least step in units of the first, below which the path has failed; default 1e-6.
    pub smallest: f64,
    /// Steps allowed; default 1000.
    pub steps: usize,
    /// Which way arc-length steps start; default secant.
    pub direction: Direction,
    /// Norm of the arc length; default by mass.
    pub measure: Measure,
    /// What the level counts in the arc length against the linear response to it at the start; default 1.
    pub load_share: f64,
    /// Whether steps are watched for what is critical: whether and how critical points are located where the number of
    /// negative pivots changes, and steps checked for having left their branch; default not.
    pub critical: Option<CriticalOptions>,
}

impl PathOptions {
    /// Defaults for a control.
    pub fn new(control: Control) -> Self {
        Self {
            control,
            newton: NewtonOptions::default(),
            target_iterations: 5,
            largest: 10.0,
            smallest: 1e-6,
            steps: 1000,
            direction: Direction::default(),
            measure: Measure::default(),
            load_share: 1.0,
            critical: None,
        }
    }

    fn check<E: Equilibrium + ?Sized>(&self, system: &E) -> Result<(), EquilibriumError> {
        let unknowns = system.unknowns();
        let first = match &self.control {
            Control::Load { step, .. } => *step,
            Control::Displacement { functional, step, .. } => {
                for &(unknown, _) in functional {
                    let inside = unknown < unknowns;
                    require(inside, "controlled unknown", unknown as f64, "below the number of unknowns")?;
                }
                *step
            }
            Control::ArcLength { first, range } => {
                require(range.0 < range.1, "range of levels, its upper bound", range.1, "above the lower")?;
                *first
            }
        };
        require(first != 0.0 && first.is_finite(), "first step", first, "finite and not zero")?;
        require(self.target_iterations > 0, "target iterations", 0.0, "one at least")?;
        require(self.largest >= 1.0, "largest step", self.largest, "one first step at least")?;
        require(
            self.smallest > 0.0 && self.smallest <= 1.0,
            "smallest step",
            self.smallest,
            "above 0 and at most one first step",
        )?;
        require(self.load_share >= 0.0, "load share", self.load_share, "not negative")
    }
}

/// Where a path starts: the present state of the system at a level.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Start {
    /// Level of the present state \[–\].
    pub level: f64,
    /// The increment that led here: gives arc length its direction and first radius.
    pub heading: Option<Increment>,
}

/// A converged point of a path.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// Number, 0 at the start.
    pub step: usize,
    /// Level, iterations, residuals and inertia.
    pub converged: Converged,
    /// Step size that led here: level, functional or arc length.
    pub size: f64,
    /// Trials that failed before.
    pub restarts: usize,
    /// Directions in which the equilibrium is unstable under the control: negative pivots; where a displacement is
    /// given by a force along it, less the one that it holds.
    pub unstable: usize,
}

impl Point {
    /// Load level \[–\].
    pub fn level(&self) -> f64 {
        self.converged.level
    }

    /// Inertia of the tangent.
    pub fn inertia(&self) -> Inertia {
        self.converged.inertia
    }
}

/// Why a path ended well.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// The bound of the control was met.
    Reached,
    /// The observer stopped it.
    Stopped,
    /// The allowed number of steps was made.
    Steps,
}

/// A path as far as it went; the system stands at its last converged point.
#[derive(Debug, Clone)]
pub struct Path {
    /// Converged points, the start first.
    pub points: Vec<Point>,
    /// Critical points located, in order.
    pub critical: Vec<CriticalPoint>,
    /// What was passed without being located.
    pub passages: Vec<Passage>,
    /// Whence it can be continued.
    pub restart: Start,
    /// How it ended.
    pub end: Result<End, EquilibriumError>,
}

impl Path {
    /// Nothing yet.
    pub(crate) fn new(start: &Start) -> Self {
        Self {
            points: Vec::new(),
            critical: Vec::new(),
            passages: Vec::new(),
            restart: start.clone(),
            end: Ok(End::Steps),
        }
    }
}

/// Told every converged point and the step that led there.
type Observer<'a, E> = dyn FnMut(&Point, Option<&Increment>, &mut E) -> ControlFlow<()> + 'a;

/// Follows equilibria from the present state; the observer sees every converged point and may stop.
///
/// A step that fails is repeated with half the size from the last converged state. All converged points are
/// kept whatever happens later.
pub fn follow<E: Equilibrium + ?Sized>(
    system: &mut E,
    start: &Start,
    options: &PathOptions,
    mut observer: impl FnMut(&Point, &mut E) -> ControlFlow<()>,
) -> Path {
    let mut path = Path::new(start);
    path.end = march(system, start, options, &mut path, &mut |point, _, system| observer(point, system));
    path
}

pub(crate) fn march<E: Equilibrium + ?Sized>(
    system: &mut E,
    start: &Start,
    options: &PathOptions,
    path: &mut Path,
    observer: &mut Observer<'_, E>,
) -> Result<End, EquilibriumError> {
    options.check(system)?;
    let (mut stepper, converged, (mut size, first)) = Stepper::new(system, start, options)?;
    let unstable = converged.inertia.negative;
    let point = Point { step: 0, converged, size: 0.0, restarts: 0, unstable };
    let stop = observer(&point, None, system);
    path.points.push(point);
    if stop.is_break() {
        return Ok(End::Stopped);
    }
    let mut travelled = 0.0;
    for step in 1..=options.steps {
        stepper.newton.step = step;
        let saved = system.save();
        let mut restarts = 0;
        let (made, bound) = loop {
            let trial = clip(size, travelled, stepper.level, &options.control);
            match step_within(&mut stepper, system, &saved, trial, &options.control) {
                Ok(done) if !strayed(&done.0, path, trial, first, &options.control) => break done,
                Ok(_) => {
                    stepper.newton.go_back(system, &saved);
                    restarts += 1;
                    size = 0.5 * trial;
                }
                Err(cause) => {
                    stepper.newton.go_back(system, &saved);
                    restarts += 1;
                    size = 0.5 * trial;
                    let smallest = options.smallest * first;
                    if size < smallest {
                        let (level, cause) = (stepper.level, Box::new(cause));
                        return Err(EquilibriumError::StepTooSmall { step, level, size, smallest, cause });
                    }
                }
            }
        };
        let size_made = stepper.size(&made.increment);
        travelled += size_made;
        if let Some(critical) = &options.critical {
            look_for_critical(&mut stepper, system, (&saved, &made, size_made), critical, options, path);
        }
        let Made { converged, increment, unstable, .. } = made;
        let ratio = options.target_iterations as f64 / converged.iterations.max(1) as f64;
        stepper.accept(converged.level, increment);
        system.accept();
        path.restart = Start { level: stepper.level, heading: stepper.last.clone() };
        let point = Point { step, converged, size: size_made, restarts, unstable };
        let stop = observer(&point, stepper.last.as_ref(), system);
        path.points.push(point);
        if stop.is_break() {
            return Ok(End::Stopped);
        }
        if bound || reached(travelled, stepper.level, first, &options.control) {
            return Ok(End::Reached);
        }
        size = (size * ratio.sqrt().clamp(0.5, 2.0)).min(options.largest * first);
    }
    Ok(End::Steps)
}

/// Whether Newton may have strayed to another branch and a smaller step is to be tried, while it is not yet small: a load
/// step after which several more pivots are negative, since critical points are passed one at a time but for symmetry;
/// an arc far from its tangents.
fn strayed(made: &Made, path: &Path, size: f64, first: f64, control: &Control) -> bool {
    let before = path.points.last().map_or(0, |point| point.inertia().negative);
    let load = matches!(control, Control::Load { .. });
    let several = load && made.converged.inertia.negative > before + 1 && size > STRAY * first;
    // Arcs that turn back or leave their branch are halved; load and displacement go where they are told.
    let arc = matches!(control, Control::ArcLength { .. });
    several || arc && made.strays && size > FINE * first
}

/// Makes one step; an arc that leaves the range of levels is replaced by a step to the bound.
fn step_within<E: Equilibrium + ?Sized>(
    stepper: &mut Stepper,
    system: &mut E,
    saved: &[f64],
    size: f64,
    control: &Control,
) -> Result<(Made, bool), EquilibriumError> {
    let made = stepper.advance(system, size)?;
    let Control::ArcLength { range: (low, high), .. } = *control else {
        return Ok((made, false));
    };
    let bound = made.converged.level.clamp(low, high);
    if bound == made.converged.level || made.strays {
        return Ok((made, false)); // one that strayed is made again
    }
    let beyond = system.save();
    stepper.newton.go_back(system, saved);
    match stepper.reach_level(system, bound, &made.increment) {
        Ok(short) => Ok((short, true)),
        Err(_) => {
            stepper.newton.go_back(system, &beyond);
            Ok((made, true))
        }
    }
}

fn clip(size: f64, travelled: f64, level: f64, control: &Control) -> f64 {
    match control {
        Control::Load { until, .. } => size.min((until - level).abs()),
        Control::Displacement { until, .. } => size.min(until.abs() - travelled),
        Control::ArcLength { .. } => size,
    }
}

fn reached(travelled: f64, level: f64, first: f64, control: &Control) -> bool {
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-12 * first;
    match control {
        Control::Load { until, .. } => near(level, *until),
        Control::Displacement { until, .. } => near(travelled, until.abs()),
        Control::ArcLength { range, .. } => level <= range.0 || level >= range.1,
    }
}
