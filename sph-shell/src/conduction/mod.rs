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
//! How balances and courses are found is the page of the crate `heat-conduction`. Cells may conduct by their temperature (tables.rs). In time the left side has `ρ c t ∂T/∂t` beside it, stored at the particles ([`HeatCourse`]).

mod cells;
mod course;
mod error;
mod tables;

use explicit_dynamics::Amplitude;
use heat_conduction::{Conducts, Entry};
use sph_core::{Cloud, SamplingOperator, Vec3, cell_operator};

use cells::CellMatrix;
pub use course::HeatCourse;
pub use error::ConductorError;
pub use heat_conduction::{ConductionError, HeatBalance, Radiation};
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

/// A surface that conducts heat, with what holds and feeds it.
#[derive(Clone, Debug)]
pub struct Conduction {
    operator: SamplingOperator,
    /// Conductance of each cell in the frame of its point \[F L/(T Θ)\].
    tensors: Vec<[f64; 3]>,
    /// Node of each particle: of those that are joined the first.
    node: Vec<u32>,
    pieces: Vec<Vec<u32>>,
    heat: heat_conduction::Conduction<Cells>,
}

/// What cells conduct between nodes.
#[derive(Clone, Debug)]
struct Cells {
    nodes: usize,
    cells: Vec<CellMatrix>,
    /// How cells conduct by temperature, where some do.
    tables: Tables,
}

/// Temperatures of a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Temperatures {
    /// Of each particle \[Θ\].
    pub values: Vec<f64>,
    /// Heat that enters at each particle by what holds its temperature \[F L/T\]; of joined particles at the first.
    pub held: Vec<f64>,
    /// Heat that runs through each cell, by length across it \[F/T\].
    pub flux: Vec<Vec3>,
    /// Where heat comes from.
    pub balance: HeatBalance,
    /// Solves made.
    pub iterations: usize,
}

impl Conducts for Cells {
    fn parameters(&self) -> usize {
        self.nodes
    }

    fn visit(&self, temperatures: &[f64], mut found: impl FnMut(Entry)) {
        for (c, cell) in self.cells.iter().enumerate() {
            let (factor, nodes) = (self.conducts(c, temperatures), &cell.nodes[..cell.count]);
            for (&row, entries) in nodes.iter().zip(&cell.entries) {
                for (&column, &value) in nodes.iter().zip(entries) {
                    found(Entry { row, column, value, factor });
                }
            }
        }
    }

    fn goes_with_temperature(&self) -> bool {
        !self.tables.is_empty()
    }

    fn refuse_beyond_tables(&self, temperatures: &[f64]) -> Result<(), ConductionError> {
        self.refuse_other_temperatures(temperatures)
    }
}

impl Conduction {
    /// A surface of cells, with how each of them conducts.
    ///
    /// # Errors
    /// [`ConductorError`] for a cloud without cells, conductors that are not one a cell or conduct not at all in some direction, and axes that stand on the surface.
    pub fn new(cloud: &Cloud, conductors: &[Conductor]) -> Result<Self, ConductorError> {
        if cloud.cells.is_empty() || conductors.len() != cloud.cells.len() {
            return Err(ConductorError::Cells { cells: cloud.cells.len(), conductors: conductors.len() });
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
        let cells = Cells { nodes: cloud.len(), cells: cells.collect(), tables: Tables::default() };
        let (pieces, heat) = (cloud.pieces(), heat_conduction::Conduction::new(cells));
        Ok(Self { operator, tensors, node, pieces, heat })
    }

    /// Lets cells conduct by a factor that goes with the mean temperature of their corners, on straight lines between `[temperature, factor]` \[Θ, –\].
    pub fn by_temperature(&mut self, cells: &[u32], factors: Vec<[f64; 2]>) {
        let own = self.heat.conductor_mut();
        own.tables.put(cells, factors, own.cells.len());
    }

    /// Lets temperatures and heat that are given meanwhile go by a course in time, which multiplies them; film coefficients and emissivities stay.
    pub fn in_course<R>(&mut self, course: Amplitude, give: impl FnOnce(&mut Self) -> R) -> R {
        let before = self.heat.begin_course(course);
        let given = give(self);
        self.heat.end_course(before);
        given
    }

    /// Holds particles at a temperature \[Θ\].
    ///
    /// # Errors
    /// [`ConductionError::Contradiction`] for one that is held at another already, or by another course.
    pub fn hold(&mut self, particles: &[u32], temperature: f64) -> Result<(), ConductionError> {
        let nodes: Vec<u32> = particles.iter().map(|&a| self.node[a as usize]).collect();
        self.heat.hold(&nodes, temperature)
    }

    /// Supplies heat to particles \[F L/T\].
    pub fn supply(&mut self, heat: &[(u32, f64)]) {
        heat.iter().for_each(|&(a, heat)| self.heat.supply(self.node[a as usize], heat));
    }

    /// A film between areas of particles \[L²\] and something of an ambient temperature \[Θ\], by its coefficient \[F/(L T Θ)\].
    pub fn film(&mut self, areas: &[(u32, f64)], coefficient: f64, ambient: f64) {
        areas
            .iter()
            .for_each(|&(a, area)| self.heat.film(self.node[a as usize], coefficient * area, ambient));
    }

    /// Areas of particles that radiate \[L²\].
    pub fn radiate(&mut self, areas: &[(u32, f64)], radiation: Radiation) {
        for &(a, area) in areas {
            let own = Radiation { factor: radiation.factor * area, ..radiation };
            self.heat.radiate(self.node[a as usize], own);
        }
    }

    /// The first particle of a piece whose temperature nothing tells: neither is it held nor is there a film or radiation. None where there is no such piece.
    pub fn untold(&self) -> Option<u32> {
        let known = self.heat.known();
        let is_known = |&a: &u32| known[self.node[a as usize] as usize];
        let piece = self.pieces.iter().find(|piece| !piece.iter().any(is_known));
        piece.and_then(|piece| piece.first().copied())
    }

    /// The temperatures in balance under what is given at the start of all courses.
    ///
    /// # Errors
    /// [`ConductionError`] for pieces whose temperature nothing tells, and for balances that are not found.
    pub fn steady(&self) -> Result<Temperatures, ConductionError> {
        match self.untold() {
            Some(particle) => Err(ConductionError::Untold { particle }),
            None => Ok(self.seen(&self.heat.steady()?)),
        }
    }

    /// Temperatures of particles and heat through cells.
    fn seen(&self, found: &heat_conduction::Temperatures) -> Temperatures {
        let values: Vec<f64> = self.node.iter().map(|&a| found.values[a as usize]).collect();
        let cells = self.heat.conductor();
        let factors = Vec::from_iter((0..cells.cells.len()).map(|c| cells.conducts(c, &found.values)));
        let flux = self.operator.gradient(&values).into_iter().enumerate().map(|(c, [g1, g2])| {
            let ([k11, k22, k12], frame) = (self.tensors[c], &self.operator.points[c].frame);
            -(frame.t1 * (k11 * g1 + k12 * g2) + frame.t2 * (k12 * g1 + k22 * g2)) * factors[c]
        });
        let flux = flux.collect();
        Temperatures {
            values,
            held: found.held.clone(),
            flux,
            balance: found.balance,
            iterations: found.iterations,
        }
    }
}
