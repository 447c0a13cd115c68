//! A fluid under way.

use explicit_dynamics::{BoundaryDriven, BoundaryState};
use sph_core::Vec3;

use crate::beach::Beach;
use crate::boundary::points::Boundary;
use crate::cells::Grid;
use crate::continuity::{Continuity, Diffusion};
use crate::current::Current;
use crate::error::FluidError;
use crate::formulation::{Formulation, Scheme, WallRule};
use crate::kernel::Wendland;
use crate::ledger::{Ledger, Sums};
use crate::liquid::Liquid;
use crate::momentum::{ForceSum, Momentum, Viscosity};
use crate::openings::Openings;
use crate::pair::Row;
use crate::parts::{Parts, Start};
use crate::periods::{Copies, Periodic, Periods};
use crate::share::Share;
use crate::sorted::Sorted;
use crate::start;
use crate::state::State;

/// Width of a cell over the reach of the kernel: particles may go so far before they are sorted anew.
pub(crate) const CELL: f64 = 1.02;

/// Bounds of a stable step, before the part of them that is taken \[T\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct StepBounds {
    /// `√(h/|a|)` of the greatest acceleration.
    pub force: f64,
    /// `h/(c + |h v·r/(r² + η²)|)` of the fastest signal.
    pub sound: f64,
}

/// A weakly compressible fluid.
#[derive(Clone, Debug)]
pub struct Fluid {
    pub(crate) dimensions: usize,
    pub(crate) spacing: f64,
    pub(crate) mass: f64,
    pub(crate) liquid: Liquid,
    pub(crate) formulation: Formulation,
    /// A zone that takes the motion out of waves.
    pub(crate) beach: Option<Beach>,
    /// A zone that carries the water along.
    pub(crate) current: Option<Current>,
    pub(crate) gravity: Vec3,
    pub(crate) domain: Option<[Vec3; 2]>,
    pub(crate) threads: usize,
    pub(crate) momentum: Momentum,
    pub(crate) continuity: Continuity,
    pub(crate) rest: Vec<Vec3>,
    /// Of the particles that it knows: all, unless others march it too.
    pub(crate) present: State,
    pub(crate) share: Share,
    /// Sides that are one.
    pub(crate) periodic: Option<Periodic>,
    /// Where the particles stand, and their copies across such sides.
    pub(crate) copies: Copies,
    /// Where particles come in and go out.
    pub(crate) openings: Option<Box<Openings>>,
    pub(crate) boundary: Boundary,
    pub(crate) grid: Grid,
    pub(crate) sorted: Sorted,
    /// By slot: accelerations, powers, rates of density, and what XSPH adds to velocities, by the slots for which it was found.
    pub(crate) accelerations: Vec<[f64; 3]>,
    /// Power that friction takes a unit of mass \[L²/T³\].
    pub(crate) powers: Vec<f64>,
    pub(crate) rates: Vec<[f64; 2]>,
    pub(crate) drags: Vec<[f64; 3]>,
    /// By chunk.
    pub(crate) force_sums: Vec<ForceSum>,
    pub(crate) sums: Vec<Sums>,
    pub(crate) force_sum: ForceSum,
    /// Whether forces belong to the present state.
    pub(crate) fresh: bool,
    /// Greatest speed at the last kick \[L/T\].
    pub(crate) fastest: f64,
    pub(crate) bounds: StepBounds,
    pub(crate) ledger: Ledger,
}

impl Fluid {
    /// Builds a fluid at rest or in motion.
    ///
    /// # Errors
    /// [`FluidError`] for numbers out of bounds, lists of wrong lengths, and particles less than half a spacing apart.
    pub fn new(parts: Parts) -> Result<Self, FluidError> {
        Self::built(parts, None)
    }

    /// The same in a box with periodic sides: particles may be given anywhere, and stand in the box; so do particles of walls, wherever they
    /// move.
    ///
    /// # Errors
    /// As [`Fluid::new`]; [`FluidError::Period`] for periods that are shorter than the kernel is wide, and [`FluidError::NotPeriodic`] for
    /// structures, the predictor and corrector, and walls with densities of their own.
    pub fn repeated(parts: Parts, periods: Periods) -> Result<Self, FluidError> {
        let refusals = [
            (!parts.structures.is_empty(), "a structure in it"),
            (parts.formulation.scheme == Scheme::PredictorCorrector, "a predictor and corrector"),
            (parts.formulation.walls == WallRule::Dynamic, "walls of the published method"),
        ];
        match refusals.iter().find(|(refused, _)| *refused) {
            Some((_, what)) => Err(FluidError::NotPeriodic(what)),
            None => Self::built(parts, Some(periods)),
        }
    }

    fn built(parts: Parts, periods: Option<Periods>) -> Result<Self, FluidError> {
        start::check(&parts)?;
        let Parts { dimensions, spacing, liquid, formulation, domain, threads, .. } = parts;
        let plane = |v: &Vec3| if dimensions == 2 { Vec3::new(v.x, v.y, 0.0) } else { *v };
        let gravity = plane(&parts.gravity);
        let mass = liquid.density * spacing.powi(dimensions as i32);
        let kernel = Wendland::new(dimensions, formulation.smoothing * spacing);
        periods.map_or(Ok(()), |periods| periods.check(dimensions, CELL * kernel.reach()))?;
        let boundary = Boundary::new(&parts, 3.0 * kernel.h)?;
        let count = parts.positions.len();
        let positions: Vec<Vec3> = parts.positions.iter().map(plane).collect();
        let velocities: Vec<Vec3> = if parts.velocities.is_empty() {
            vec![Vec3::zeros(); count]
        } else {
            parts.velocities.iter().map(plane).collect()
        };
        let densities = match (parts.start, &periods) {
            (Start::Uniform, _) => vec![liquid.density; count],
            (_, None) => start::hydrostatic(dimensions, spacing, &positions, &gravity, &liquid, None),
            (_, Some(periods)) => {
                let across = periods.across(&gravity);
                start::hydrostatic(dimensions, spacing, &positions, &across, &liquid, Some(periods))
            }
        };
        let sound = liquid.sound_speed / (liquid.density * liquid.density * liquid.density);
        let viscosity = Viscosity::new(dimensions, &formulation, &liquid, &kernel);
        let at_walls = if formulation.slip { Viscosity::NONE } else { viscosity };
        let momentum = Momentum { kernel, mass, viscosity, at_walls, sound };
        let diffusion = Diffusion::new(&formulation, &liquid, &kernel, &gravity);
        let continuity = Continuity { kernel, mass, diffusion };
        let mut fluid = Self {
            dimensions,
            spacing,
            mass,
            liquid,
            formulation,
            beach: None,
            current: None,
            gravity,
            domain,
            threads: threads.max(1),
            momentum,
            continuity,
            rest: positions.clone(),
            present: State { positions, velocities, densities },
            share: Share::default(),
            periodic: periods.map(|periods| Periodic { periods, gone: vec![[0.0; 3]; count] }),
            copies: Copies::default(),
            openings: None,
            boundary,
            grid: Grid::around(dimensions, std::iter::empty(), 1.0),
            sorted: Sorted::default(),
            accelerations: vec![[0.0; 3]; count],
            powers: vec![0.0; count],
            rates: vec![[0.0; 2]; count],
            drags: Vec::new(),
            force_sums: Vec::new(),
            sums: Vec::new(),
            force_sum: ForceSum::default(),
            fresh: false,
            fastest: 0.0,
            bounds: StepBounds::default(),
            ledger: Ledger::default(),
        };
        fluid.go_round();
        fluid.sort(0.0, 0.0);
        fluid.check_overlap()?;
        Ok(fluid)
    }

    /// Number of particles; of a fluid with openings, that which it has room for.
    pub fn len(&self) -> usize {
        self.rest.len()
    }

    /// Whether there is none; never of a fluid that was built.
    pub fn is_empty(&self) -> bool {
        self.rest.is_empty()
    }

    /// Two or three.
    pub fn dimensions(&self) -> usize {
        self.dimensions
    }

    /// Distance of neighbouring particles at the start \[L\].
    pub fn spacing(&self) -> f64 {
        self.spacing
    }

    /// Smoothing length h \[L\].
    pub fn smoothing_length(&self) -> f64 {
        self.momentum.kernel.h
    }

    /// Mass of a particle \[M; M/L in a plane\].
    pub fn mass(&self) -> f64 {
        self.mass
    }

    /// Gravity g \[L/T²\], in the plane of a plane fluid.
    pub fn gravity(&self) -> Vec3 {
        self.gravity
    }

    /// The liquid.
    pub fn liquid(&self) -> &Liquid {
        &self.liquid
    }

    /// Lets waves run out in a zone, of a fluid that is marched by kicks and drifts.
    pub fn absorb(&mut self, beach: Beach) {
        self.beach = Some(beach);
    }

    /// The method.
    pub fn formulation(&self) -> &Formulation {
        &self.formulation
    }

    /// Places at the start \[L\].
    pub fn rest(&self) -> &[Vec3] {
        &self.rest
    }

    /// Present places \[L\].
    pub fn positions(&self) -> &[Vec3] {
        &self.shown().positions
    }

    /// Velocities \[L/T\]: of kick, drift and kick half a step before the places.
    pub fn velocities(&self) -> &[Vec3] {
        &self.shown().velocities
    }

    /// Densities \[M/L³\].
    pub fn densities(&self) -> &[f64] {
        &self.shown().densities
    }

    /// Pressures \[F/L²\].
    pub fn pressures(&self) -> Vec<f64> {
        self.densities().iter().map(|&density| self.liquid.pressure(density)).collect()
    }

    /// Number of walls.
    pub fn walls(&self) -> usize {
        self.boundary.walls()
    }

    /// Places of the particles of a wall \[L\].
    pub fn wall_positions(&self, wall: usize) -> &[Vec3] {
        &self.boundary.points[self.boundary.wall(wall)]
    }

    /// Forces of the fluid on the particles of a wall \[F; F/L in a plane\], of the last evaluation.
    pub fn wall_forces(&self, wall: usize) -> &[[f64; 3]] {
        &self.boundary.forces[self.boundary.wall(wall)]
    }

    /// Force of the fluid on a wall \[F; F/L in a plane\], of the last evaluation.
    pub fn wall_force(&self, wall: usize) -> Vec3 {
        self.wall_forces(wall).iter().map(|force| Vec3::from(*force)).sum()
    }

    /// Moment of the fluid on a wall about a point \[F L; F in a plane\], of the last evaluation.
    pub fn wall_moment(&self, wall: usize, about: Vec3) -> Vec3 {
        let range = self.boundary.wall(wall);
        let pairs = self.boundary.points[range.clone()].iter().zip(&self.boundary.forces[range]);
        pairs.map(|(point, force)| (point - about).cross(&Vec3::from(*force))).sum()
    }

    /// Force of the fluid on a structure \[F; F/L in a plane\], of the last evaluation.
    pub fn structure_force(&self, structure: usize) -> Vec3 {
        let range = self.boundary.structure(structure);
        self.boundary.forces[range].iter().map(|force| Vec3::from(*force)).sum()
    }

    /// Bytes held for each particle, boundaries included.
    pub fn bytes_per_particle(&self) -> usize {
        let by_slot = 24 * (self.accelerations.len() + self.drags.len())
            + 8 * self.powers.len()
            + 16 * self.rates.len();
        let chunks = size_of::<ForceSum>() * self.force_sums.len() + size_of::<Sums>() * self.sums.len();
        let fluid = (24 + 56) * self.len() + by_slot + chunks;
        (fluid + self.sorted.bytes() + self.boundary.bytes()) / self.len()
    }

    /// A row so far away that it adds nothing to any sum.
    pub(crate) fn far(&self) -> Row {
        let far = 1e9 * self.momentum.kernel.h;
        let third = if self.dimensions == 2 { 0.0 } else { far };
        Row::new(Vec3::new(far, far, third), self.liquid.density, Vec3::zeros(), 0.0)
    }
}

impl BoundaryDriven for Fluid {
    fn set_boundary(&mut self, structure: usize, end: &BoundaryState, velocities: &[[f64; 3]]) {
        if self.share.shared().is_some() {
            if self.boundary.is_put_off(structure) {
                self.settle();
            }
            self.boundary.put_off(structure, end, velocities);
        } else {
            self.boundary.set_structure(structure, self.dimensions, end, velocities);
        }
        self.fresh = false;
    }

    fn boundary_forces(&self, structure: usize) -> &[[f64; 3]] {
        &self.boundary.forces[self.boundary.structure(structure)]
    }

    fn apply_reactions(&mut self, structure: usize, impulses: &[[f64; 3]]) {
        self.return_impulses(structure, impulses);
    }

    fn impedance(&self) -> f64 {
        self.liquid.impedance()
    }

    fn greatest_displacement(&self) -> f64 {
        0.25 * self.momentum.kernel.h
    }
}
