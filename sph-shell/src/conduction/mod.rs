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
//! radiation in one solve ([`Conduction::steady`]).

mod cells;
mod error;
mod steady;
mod system;

use sph_core::{Cloud, SamplingOperator, Vec3, cell_operator};

use cells::CellMatrix;
pub use error::ConductionError;
pub use steady::{HeatBalance, Temperatures};

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
    held: Vec<Option<f64>>,
    /// Heat that is supplied to each node \[F L/T\].
    supplied: Vec<f64>,
    /// Film coefficient times area of each node \[F L/(T Θ)\], and the same times the ambient temperature \[F L/T\].
    film: Vec<[f64; 2]>,
    /// Nodes that radiate, with the factor times the area.
    radiating: Vec<(u32, Radiation)>,
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
            held: vec![None; count],
            supplied: vec![0.0; count],
            film: vec![[0.0; 2]; count],
            radiating: Vec::new(),
        })
    }

    /// Holds particles at a temperature \[Θ\].
    ///
    /// # Errors
    /// [`ConductionError::Contradiction`] for one that is held at another already.
    pub fn hold(&mut self, particles: &[u32], temperature: f64) -> Result<(), ConductionError> {
        for &particle in particles {
            let own = &mut self.held[self.node[particle as usize] as usize];
            match *own {
                Some(other) if other != temperature => {
                    return Err(ConductionError::Contradiction {
                        particle,
                        temperatures: [other, temperature],
                    });
                }
                _ => *own = Some(temperature),
            }
        }
        Ok(())
    }

    /// Supplies heat to particles \[F L/T\].
    pub fn supply(&mut self, heat: &[(u32, f64)]) {
        heat.iter().for_each(|&(a, heat)| self.supplied[self.node[a as usize] as usize] += heat);
    }

    /// A film between areas of particles \[L²\] and something of an ambient temperature \[Θ\], by its coefficient \[F/(L T Θ)\].
    pub fn film(&mut self, areas: &[(u32, f64)], coefficient: f64, ambient: f64) {
        for &(a, area) in areas {
            let [by_degree, heat] = &mut self.film[self.node[a as usize] as usize];
            *by_degree += coefficient * area;
            *heat += coefficient * area * ambient;
        }
    }

    /// Areas of particles that radiate \[L²\].
    pub fn radiate(&mut self, areas: &[(u32, f64)], radiation: Radiation) {
        let of = |&(a, area): &(u32, f64)| {
            (self.node[a as usize], Radiation { factor: radiation.factor * area, ..radiation })
        };
        let own: Vec<_> = areas.iter().map(of).collect();
        self.radiating.extend(own);
    }

    /// The first particle of a piece whose temperature nothing tells: neither is it held nor is there a film or radiation. None where there is no such piece.
    pub fn untold(&self) -> Option<u32> {
        let mut known: Vec<bool> =
            (0..self.held.len()).map(|a| self.held[a].is_some() || self.film[a][0] > 0.0).collect();
        self.radiating
            .iter()
            .filter(|(_, own)| own.factor > 0.0)
            .for_each(|(a, _)| known[*a as usize] = true);
        let piece =
            self.pieces.iter().find(|piece| piece.iter().all(|&a| !known[self.node[a as usize] as usize]));
        piece.and_then(|piece| piece.first().copied())
    }
}
