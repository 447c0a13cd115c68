//! Heat that runs through a solid: temperatures are sums of the same shape functions as displacements, `T(X) = Σ_I φ_I(X) θ_I`.
//!
//! ```text
//! K_IJ = Σ_g V_g ∇φ_I·k ∇φ_J        C_IJ = Σ_g V_g ρc φ_I φ_J        s_I = ∫ φ_I q dA
//! ```
//!
//! with the points of the background cells. Rows of K sum to zero, for the shape functions sum to one. Films and radiation act at points of faces. A node that is held has
//! the temperature itself, `Σ_J φ_J(X_I) θ_J`, by the same elimination as supports have ([`Essential::Collocation`](crate::Essential::Collocation)): between nodes it leaves what the
//! crate's page says of affine displacements, some thousandths of the greatest difference. An image behind a plane of symmetry has the parameter of its node: through the plane no heat runs.

use heat_conduction::{Capacity, ConductionError, Conducts, Eliminated, Entry, Radiation, Temperatures};
use implicit_statics::BlockPattern;
use rayon::prelude::*;
use solid_kinematics::Tensor;
use sph_core::{FacePoint, PointShape, Vec3};

use crate::body::Galerkin;
use crate::error::GalerkinError;
use crate::essential::held_alone;

/// What a solid conducts: a symmetric matrix of parameters, its upper half, with the shape functions at the nodes.
#[derive(Clone, Debug)]
pub struct Gradients {
    pattern: BlockPattern,
    values: Vec<f64>,
    nodal: Vec<Vec<(u32, f64)>>,
}

impl Conducts for Gradients {
    fn parameters(&self) -> usize {
        self.nodal.len()
    }

    fn visit(&self, _temperatures: &[f64], mut found: impl FnMut(Entry)) {
        for (row, column, at) in self.pattern.pairs() {
            let (row, column, value) = (row as u32, column as u32, self.values[at]);
            found(Entry { row, column, value, factor: 1.0 });
            if row != column {
                found(Entry { row: column, column: row, value, factor: 1.0 });
            }
        }
    }

    fn eliminate(&self, held: &[u32]) -> Option<Vec<Eliminated>> {
        let rows: Vec<&[(u32, f64)]> = held.iter().map(|&a| self.nodal[a as usize].as_slice()).collect();
        let mut solved = held_alone(&rows, self.nodal.len());
        solved.iter_mut().flat_map(|own| &mut own.moves).for_each(|own| own.0 = held[own.0 as usize]);
        Some(solved)
    }

    fn at_nodes(&self, parameters: &[f64]) -> Vec<f64> {
        let at = |shape: &Vec<(u32, f64)>| shape.iter().map(|&(a, phi)| phi * parameters[a as usize]).sum();
        self.nodal.iter().map(at).collect()
    }
}

/// A solid that conducts heat, with what holds and feeds it.
#[derive(Clone, Debug)]
pub struct Conduction {
    heat: heat_conduction::Conduction<Gradients>,
    /// Conductivity \[F/(T Θ)\].
    conductivity: Tensor,
}

impl Galerkin {
    /// The solid as one that conducts heat by a symmetric tensor \[F/(T Θ)\]: of an isotropic material a multiple of the unit tensor.
    pub fn conduction(&self, conductivity: &Tensor) -> Conduction {
        let space = &self.space;
        let lists: Vec<Vec<u32>> = space.cells.iter().map(|cell| space.images.reals(&cell.nodes)).collect();
        let mut of: Vec<Vec<u32>> = vec![Vec::new(); space.nodes.len()];
        for (number, list) in lists.iter().enumerate() {
            list.iter().for_each(|&node| of[node as usize].push(number as u32));
        }
        let mut seen = vec![usize::MAX; space.nodes.len()];
        let pattern = BlockPattern::new(space.nodes.len(), |node, row| {
            let others = of[node].iter().flat_map(|&list| &lists[list as usize]);
            row.extend(others.filter(|&&other| {
                other as usize >= node && std::mem::replace(&mut seen[other as usize], node) != node
            }));
        });
        let local = |number: usize| {
            let cell = &space.cells[number];
            let count = cell.nodes.len();
            let mut own = vec![0.0; count * count];
            for (point, volume) in cell.volumes.iter().enumerate() {
                let g = [0, 1, 2].map(|k| cell.gradient(point, k));
                for a in 0..count {
                    let flux = conductivity * Vec3::new(g[0][a], g[1][a], g[2][a]) * *volume;
                    for b in 0..count {
                        own[a * count + b] += flux.x * g[0][b] + flux.y * g[1][b] + flux.z * g[2][b];
                    }
                }
            }
            own
        };
        let mut values = vec![0.0; pattern.blocks()];
        self.add_cells(&pattern, &mut values, |number| Ok(local(number))).unwrap_or_default();
        let nodal = space.nodal.iter().map(|shape| self.parts_of(shape)).collect();
        let heat = heat_conduction::Conduction::with_places(Gradients { pattern, values, nodal });
        Conduction { heat, conductivity: *conductivity }
    }

    /// Adds matrices of cells, which are found in batches and added in their order.
    fn add_cells(
        &self,
        pattern: &BlockPattern,
        values: &mut [f64],
        local: impl Fn(usize) -> Result<Vec<f64>, GalerkinError> + Sync,
    ) -> Result<(), GalerkinError> {
        const BATCH: usize = 64;
        let space = &self.space;
        for begin in (0..space.cells.len()).step_by(BATCH) {
            let numbers = begin..(begin + BATCH).min(space.cells.len());
            let found = numbers.clone().into_par_iter().map(&local).collect::<Result<Vec<_>, _>>()?;
            for (number, own) in numbers.zip(found) {
                let nodes: Vec<u32> =
                    space.cells[number].nodes.iter().map(|&node| space.images.real(node).0).collect();
                for (a, &row) in nodes.iter().enumerate() {
                    for (b, &column) in nodes.iter().enumerate().filter(|(_, column)| **column >= row) {
                        if let Some(at) = pattern.find(row, column) {
                            values[at] += own[a * nodes.len() + b];
                        }
                    }
                }
            }
        }
        Ok(())
    }

    /// Parameters and weights of a temperature.
    fn parts_of(&self, shape: &PointShape) -> Vec<(u32, f64)> {
        let real = |(&number, &phi): (&u32, &f64)| (self.space.images.real(number).0, phi);
        shape.nodes.iter().zip(&shape.values).map(real).collect()
    }

    /// Temperatures at the points of the quadrature, from the parameters \[Θ\].
    ///
    /// # Errors
    /// [`GalerkinError`] for points without shape functions; none is known, for the body has them.
    pub fn temperatures_at_points(&self, parameters: &[f64]) -> Result<Vec<f64>, GalerkinError> {
        let at = |place: &Vec3| {
            let parts = self.parts_of(&self.squares.at(place)?);
            Ok(parts.iter().map(|&(a, phi)| phi * parameters[a as usize]).sum())
        };
        self.space.places.par_iter().map(at).collect()
    }
}

impl Conduction {
    /// Lets temperatures and heat that are given meanwhile go by a course in time, which multiplies them; film coefficients and emissivities stay.
    pub fn in_course<R>(
        &mut self,
        course: explicit_dynamics::Amplitude,
        give: impl FnOnce(&mut Self) -> R,
    ) -> R {
        let before = self.heat.begin_course(course);
        let given = give(self);
        self.heat.end_course(before);
        given
    }

    /// Holds nodes at a temperature \[Θ\].
    ///
    /// # Errors
    /// [`ConductionError::Contradiction`] for one that is held at another already, or by another course.
    pub fn hold(&mut self, nodes: &[u32], temperature: f64) -> Result<(), ConductionError> {
        self.heat.hold(nodes, temperature)
    }

    /// Supplies heat by area at points of a face \[F/(L T)\].
    ///
    /// # Errors
    /// [`GalerkinError`] for points that the nodes do not reach.
    pub fn supply(&mut self, of: &Galerkin, points: &[FacePoint], flux: f64) -> Result<(), GalerkinError> {
        for point in points {
            let heat = flux * point.area().norm();
            self.supply_at(of, &point.place, heat)?;
        }
        Ok(())
    }

    /// Supplies heat at a place \[F L/T\].
    ///
    /// # Errors
    /// [`GalerkinError`] for a place that the nodes do not reach.
    pub fn supply_at(&mut self, of: &Galerkin, place: &Vec3, heat: f64) -> Result<(), GalerkinError> {
        let parts = of.parts_of(&of.squares.at(place)?);
        parts.into_iter().for_each(|(a, phi)| self.heat.supply(a, phi * heat));
        Ok(())
    }

    /// Supplies heat to the whole by volume \[F/(L² T)\].
    pub fn source(&mut self, of: &Galerkin, by_volume: f64) {
        for (number, integral) in (0..).zip(&of.space.integrals) {
            self.heat.supply(of.space.images.real(number).0, by_volume * integral[0]);
        }
    }

    /// A film between points of a face and something of an ambient temperature \[Θ\], by its coefficient \[F/(L T Θ)\].
    ///
    /// # Errors
    /// [`GalerkinError`] for points that the nodes do not reach.
    pub fn film(
        &mut self,
        of: &Galerkin,
        points: &[FacePoint],
        coefficient: f64,
        ambient: f64,
    ) -> Result<(), GalerkinError> {
        for point in points {
            let place = self.heat.place(of.parts_of(&of.squares.at(&point.place)?));
            self.heat.film(place, coefficient * point.area().norm(), ambient);
        }
        Ok(())
    }

    /// Points of a face that radiate.
    ///
    /// # Errors
    /// [`GalerkinError`] for points that the nodes do not reach.
    pub fn radiate(
        &mut self,
        of: &Galerkin,
        points: &[FacePoint],
        radiation: Radiation,
    ) -> Result<(), GalerkinError> {
        for point in points {
            let place = self.heat.place(of.parts_of(&of.squares.at(&point.place)?));
            let factor = radiation.factor * point.area().norm();
            self.heat.radiate(place, Radiation { factor, ..radiation });
        }
        Ok(())
    }

    /// Whether nothing tells the temperature: no node is held, and there is neither a film nor radiation.
    pub fn is_untold(&self) -> bool {
        !self.heat.known().contains(&true)
    }

    /// The temperatures in balance under what is given at the start of all courses.
    ///
    /// # Errors
    /// [`ConductionError`] where nothing tells the temperature, and for balances that are not found.
    pub fn steady(&self) -> Result<Temperatures, ConductionError> {
        if self.is_untold() { Err(ConductionError::Untold { particle: 0 }) } else { self.heat.steady() }
    }

    /// What parameters store by degree, of a heat by volume and degree \[F/(L² Θ)\].
    ///
    /// # Errors
    /// [`GalerkinError`] for points without shape functions; none is known, for the body has them.
    pub fn capacity(&self, of: &Galerkin, by_volume: f64) -> Result<Capacity, GalerkinError> {
        let (space, pattern) = (&of.space, &self.heat.conductor().pattern);
        let local = |number: usize| {
            let cell = &space.cells[number];
            let count = cell.nodes.len();
            let mut own = vec![0.0; count * count];
            for (point, volume) in cell.volumes.iter().enumerate() {
                let shape = of.squares.at(&space.places[number * space.points + point])?;
                let at = |node: &u32| cell.nodes.binary_search(node).ok();
                let seen: Vec<(usize, f64)> = shape
                    .nodes
                    .iter()
                    .zip(&shape.values)
                    .filter_map(|(a, phi)| Some((at(a)?, *phi)))
                    .collect();
                for &(a, left) in &seen {
                    seen.iter().for_each(|&(b, right)| {
                        own[a * count + b] += by_volume * volume * left * right;
                    });
                }
            }
            Ok(own)
        };
        let mut values = vec![0.0; pattern.blocks()];
        of.add_cells(pattern, &mut values, local)?;
        let mut out = Capacity { own: vec![0.0; space.nodes.len()], pairs: Vec::new() };
        for (row, column, at) in pattern.pairs() {
            if row == column {
                out.own[row] = values[at];
            } else {
                out.pairs.push((row as u32, column as u32, values[at]));
            }
        }
        Ok(out)
    }

    /// What holds and feeds it, for courses in time.
    pub fn heat(&self) -> &heat_conduction::Conduction<Gradients> {
        &self.heat
    }

    /// Heat that runs through each node, by area across it \[F/(L T)\].
    pub fn flux(&self, of: &Galerkin, parameters: &[f64]) -> Vec<Vec3> {
        let at = |shape: &PointShape| {
            let parts = shape.nodes.iter().zip(&shape.gradients);
            let slope: Vec3 = parts
                .map(|(&number, g)| Vec3::from(*g) * parameters[of.space.images.real(number).0 as usize])
                .sum();
            -(self.conductivity * slope)
        };
        of.space.nodal.iter().map(at).collect()
    }
}
