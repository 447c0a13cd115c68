//! Heat that runs along a shell: one temperature at each particle, the same through the thickness.
//!
//! ```text
//! −∇·(k t ∇T) = q + h (T_∞ − T) + ε σ (T_s⁴ − T⁴)        by area of the mid-surface, T⁴ from absolute zero
//! ```
//!
//! Cells sample the gradient as they do that of a motion, with their own stencils, which are exact for temperatures that are linear in space. What one point of
//! four particles does not see, the pattern (1, −1, 1, −1), conducts as it would by the bilinear interpolation of a parallelogram (cells.rs): nothing but a uniform
//! temperature runs free of heat. Sources, films and radiation act at particles, by their areas. Particles of several sheets that are joined are one.
//!
//! The heat that enters a particle is a derivative of a convex function of the temperatures, so that there is one answer, and Newton's method finds it; without
//! radiation in one solve ([`Conduction::steady`]). Cells may conduct by their temperature (tables.rs): then each solve takes what they conduct from the one before. In time the left side has `ρ c t ∂T/∂t` beside it ([`HeatCourse`]).

mod cells;
mod course;
mod error;
mod given;
mod steady;
mod system;
mod tables;

use explicit_dynamics::Amplitude;
use sph_core::{Cloud, SamplingOperator, Vec3, cell_operator};

use cells::CellMatrix;
pub use course::HeatCourse;
pub use error::ConductionError;
use given::{Changing, Given, What};
pub use steady::{HeatBalance, Temperatures};
use tables::Tables;

/// How a cell conducts heat.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conductor {
    /// Conductivity times thickness along the first axis, along the second, and between them \[F L/(T Θ)\].
    pub tensor: [f64; 3],
    /// Direction whose projection on the surface is the first axis; any where both conduct alike.
    pub axis: Option<Vec3>,
}

impl Conductor {
    /// One that conducts alike in all directions: conductivity times thickness \[F L/(T Θ)\].
    pub fn isotropic(conductance: f64) -> Self {
        Self { tensor: [conductance, conductance, 0.0], axis: None }
    }

    /// A sheet whose first axis lies at an angle \[rad\] to the first of these axes, about the normal, with such conductivities times thickness along and across
    /// \[F L/(T Θ)\], as a tensor in these axes.
    pub fn ply([along, across]: [f64; 2], angle: f64) -> [f64; 3] {
        cells::turned([along, across, 0.0], [libm::cos(angle), -libm::sin(angle)])
    }
}

/// A surface that radiates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Radiation {
    /// Emissivity times the constant of Stefan and Boltzmann, of all faces together \[F/(L T Θ⁴)\].
    pub factor: f64,
    /// Temperature of what surrounds it \[Θ\].
    pub surroundings: f64,
    /// Absolute zero \[Θ\].
    pub zero: f64,
}

/// A surface that conducts heat, with what holds and feeds it.
#[derive(Clone, Debug)]
pub struct Conduction {
    operator: SamplingOperator,
    /// Conductance of each cell in the frame of its point \[F L/(T Θ)\].
    tensors: Vec<[f64; 3]>,
    cells: Vec<CellMatrix>,
    /// Node of each particle: of those that are joined the first.
    node: Vec<u32>,
    pieces: Vec<Vec<u32>>,
    /// What is given whenever it is, and how films and radiation join nodes to what goes by a course.
    given: Given,
    changing: Vec<Changing>,
    courses: Vec<Amplitude>,
    /// The one by which goes what is given now.
    course: Option<usize>,
    /// How cells conduct by temperature, where some do.
    tables: Tables,
}

impl Conduction {
    /// A surface of cells, with how each of them conducts.
    ///
    /// # Errors
    /// [`ConductionError`] for a cloud without cells, conductors that are not one a cell or conduct not at all in some direction, and axes that stand on the surface.
    pub fn new(cloud: &Cloud, conductors: &[Conductor]) -> Result<Self, ConductionError> {
        if cloud.cells.is_empty() || conductors.len() != cloud.cells.len() {
            return Err(ConductionError::Cells { cells: cloud.cells.len(), conductors: conductors.len() });
        }
        let operator = cell_operator(cloud)?;
        let mut node: Vec<u32> = (0..cloud.len() as u32).collect();
        for group in &cloud.joined {
            let first = group.iter().copied().min().unwrap_or_default();
            group.iter().for_each(|&a| node[a as usize] = first);
        }
        let tensors = cells::in_frames(&operator, conductors)?;
        let cells =
            (0..tensors.len()).map(|c| CellMatrix::new(&operator, c, &tensors[c], &cloud.positions, &node));
        let count = cloud.len();
        Ok(Self {
            cells: cells.collect(),
            operator,
            tensors,
            node,
            pieces: cloud.pieces(),
            given: Given::none(count),
            changing: Vec::new(),
            courses: Vec::new(),
            course: None,
            tables: Tables::default(),
        })
    }

    /// Lets cells conduct by a factor that goes with the mean temperature of their corners, on straight lines between `[temperature, factor]` \[Θ, –\].
    pub fn by_temperature(&mut self, cells: &[u32], factors: Vec<[f64; 2]>) {
        self.tables.put(cells, factors, self.cells.len());
    }

    /// Lets temperatures and heat that are given meanwhile go by a course in time, which multiplies them; film coefficients and emissivities stay.
    pub fn in_course<R>(&mut self, course: Amplitude, give: impl FnOnce(&mut Self) -> R) -> R {
        let before = self.course.replace(self.courses.len());
        self.courses.push(course);
        let given = give(self);
        self.course = before;
        given
    }

    /// Holds particles at a temperature \[Θ\].
    ///
    /// # Errors
    /// [`ConductionError::Contradiction`] for one that is held at another already, or by another course.
    pub fn hold(&mut self, particles: &[u32], temperature: f64) -> Result<(), ConductionError> {
        let own = self.course.map(|course| (&self.courses[course], temperature));
        let start = own.map_or(temperature, |(course, _)| course.value(0.0) * temperature);
        let nodes: Vec<u32> = particles.iter().map(|&a| self.node[a as usize]).collect();
        for (&node, &particle) in nodes.iter().zip(particles) {
            let held = self.given.held[node as usize];
            if let Some(other) = held.filter(|&other| other != start || self.holds(node) != own) {
                return Err(ConductionError::Contradiction { particle, temperatures: [other, start] });
            }
        }
        for node in nodes {
            self.given.held[node as usize] = Some(start);
            self.goes_by_course(node, temperature, What::Held);
        }
        Ok(())
    }

    /// By which course a node is held, and at what.
    fn holds(&self, node: u32) -> Option<(&Amplitude, f64)> {
        let own = self.changing.iter().find(|own| own.node == node && own.what == What::Held)?;
        Some((&self.courses[own.course], own.number))
    }

    /// Whether what is given to a node goes by a course; notes it.
    fn goes_by_course(&mut self, node: u32, number: f64, what: What) -> bool {
        self.changing.extend(self.course.map(|course| Changing { course, node, number, what }));
        self.course.is_some()
    }

    /// Supplies heat to particles \[F L/T\].
    pub fn supply(&mut self, heat: &[(u32, f64)]) {
        for &(a, heat) in heat {
            let node = self.node[a as usize];
            if !self.goes_by_course(node, heat, What::Supplied) {
                self.given.supplied[node as usize] += heat;
            }
        }
    }

    /// A film between areas of particles \[L²\] and something of an ambient temperature \[Θ\], by its coefficient \[F/(L T Θ)\].
    pub fn film(&mut self, areas: &[(u32, f64)], coefficient: f64, ambient: f64) {
        for &(a, area) in areas {
            let (node, by_degree) = (self.node[a as usize], coefficient * area);
            self.given.film[node as usize][0] += by_degree;
            if !self.goes_by_course(node, by_degree * ambient, What::Film) {
                self.given.film[node as usize][1] += by_degree * ambient;
            }
        }
    }

    /// Areas of particles that radiate \[L²\].
    pub fn radiate(&mut self, areas: &[(u32, f64)], radiation: Radiation) {
        for &(a, area) in areas {
            let node = self.node[a as usize];
            self.goes_by_course(node, radiation.surroundings, What::Surroundings(self.given.radiating.len()));
            self.given.radiating.push((node, Radiation { factor: radiation.factor * area, ..radiation }));
        }
    }

    /// The first particle of a piece whose temperature nothing tells: neither is it held nor is there a film or radiation. None where there is no such piece.
    pub fn untold(&self) -> Option<u32> {
        let Given { held, film, radiating, .. } = &self.given;
        let mut known: Vec<bool> =
            held.iter().zip(film).map(|(held, film)| held.is_some() || film[0] > 0.0).collect();
        radiating.iter().filter(|(_, own)| own.factor > 0.0).for_each(|(a, _)| known[*a as usize] = true);
        let piece =
            self.pieces.iter().find(|piece| piece.iter().all(|&a| !known[self.node[a as usize] as usize]));
        piece.and_then(|piece| piece.first().copied())
    }
}
