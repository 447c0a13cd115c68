//! A shell with its supports and loads: the system that Newton and the path followers see.

mod driven;

use super::assembly::Assembly;
use super::director::Director;
use super::element::{self, Forces, Stresses};
use super::geometry::{Corners, Geometry};
use super::load::{Load, shares};
use super::mesh::Mesh;
use super::rows::Tangent;
use super::section::Section;
use super::support::{Frame, Support, frame};
use implicit_statics::Equilibrium;
use nalgebra::Vector3;
use thiserror::Error;

/// Numbers kept per node of a saved state: position, director, first axis.
const SAVED: usize = 9;
/// Part of the level over which the pull of moved nodes is differenced.
const DIFFERENCE: f64 = 1e-6;

/// Why a shell cannot be built.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum FeShellError {
    /// An element without area, or with the material axis upright on it.
    #[error(
        "element {element} has no area or stands across the material axis {axis:?}; move its nodes or turn the axis"
    )]
    Degenerate {
        /// The element, counted from 0.
        element: usize,
        /// The material axis.
        axis: [f64; 3],
    },
    /// A plane in which a director should stay but does not lie.
    #[error(
        "the director of node {node} leaves the plane with normal {normal:?}; hold it with a clamp, or repair the mesh"
    )]
    OutOfPlane {
        /// The node, counted from 0.
        node: usize,
        /// The normal of the plane.
        normal: [f64; 3],
    },
}

/// A node's loads at level one.
#[derive(Debug, Clone, Copy, Default)]
struct NodeLoad {
    force: Vector3<f64>,
    couple: Vector3<f64>,
}

/// A finite-element shell.
#[derive(Debug, Clone)]
pub struct Model {
    section: Section,
    elements: Vec<([usize; 4], Geometry)>,
    frames: Vec<Frame>,
    loads: Vec<NodeLoad>,
    /// Reference area of each node \[L²\].
    areas: Vec<f64>,
    reference: Vec<Vector3<f64>>,
    positions: Vec<Vector3<f64>>,
    directors: Vec<Director>,
    assembly: Assembly,
    /// Nodes whose held displacement goes with the level, and what it is at level one \[L\].
    moved: Vec<(usize, Vector3<f64>)>,
    /// Whether increments are followed by predicted resultants, and those of the last one.
    predicts: bool,
    predicted: Vec<Stresses>,
}

impl Model {
    /// A shell over `mesh`; plies count their angles from the projection of `axis` onto the surface.
    pub fn new(
        mesh: &Mesh,
        section: Section,
        axis: Vector3<f64>,
        supports: &[Support],
        loads: &[Load],
    ) -> Result<Self, FeShellError> {
        let connectivity = mesh.elements();
        let mut directors: Vec<Director> =
            mesh.directors.iter().map(|&normal| Director::new(normal)).collect();
        let mut areas = vec![0.0; directors.len()];
        let mut elements = Vec::with_capacity(connectivity.len());
        for (index, nodes) in connectivity.into_iter().enumerate() {
            let corners = Corners {
                positions: nodes.map(|node| mesh.positions[node]),
                directors: nodes.map(|node| mesh.directors[node]),
            };
            let geometry = Geometry::new(&corners, &axis, &section)
                .ok_or(FeShellError::Degenerate { element: index, axis: axis.into() })?;
            for point in &geometry.points {
                for (node, shape) in nodes.iter().zip(point.shape) {
                    areas[*node] += point.area * shape;
                }
            }
            elements.push((nodes, geometry));
        }
        let mut own: Vec<Vec<&Support>> = vec![Vec::new(); directors.len()];
        for support in supports {
            support.nodes.iter().for_each(|&node| own[node].push(support));
        }
        let mut frames = Vec::with_capacity(directors.len());
        for (node, director) in directors.iter_mut().enumerate() {
            let frame = frame(&own[node], director)
                .map_err(|normal| FeShellError::OutOfPlane { node, normal: normal.into() })?;
            frames.push(frame);
        }
        let loads = node_loads(loads, &mesh.positions, &areas);
        let assembly = Assembly::new(&frames, elements.iter().map(|(nodes, _)| *nodes));
        let positions = mesh.positions.clone();
        Ok(Self {
            section,
            elements,
            frames,
            loads,
            areas,
            reference: positions.clone(),
            positions,
            directors,
            assembly,
            moved: Vec::new(),
            predicts: false,
            predicted: Vec::new(),
        })
    }

    /// Lets the tangent take its resultants from the last increment by first order instead of from the state.
    ///
    /// Newton's method on displacements and resultants together, the resultants eliminated at each point
    /// \[magisano2017\]: the same equilibria, but steps are not cut short by the spurious stretch of large linear
    /// rotations. The tangent equals the derivative of the forces only once the iteration has converged (and after
    /// [`Equilibrium::restore`]); line searches on the forces must be off.
    pub fn predict_resultants(mut self) -> Self {
        self.predicts = true;
        self
    }

    /// Mean spacing of the nodes: the square root of their mean area \[L\].
    pub fn spacing(&self) -> f64 {
        (self.areas.iter().sum::<f64>() / self.areas.len() as f64).sqrt()
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.positions.len()
    }

    /// Displacement of a node \[L\].
    pub fn displacement(&self, node: usize) -> Vector3<f64> {
        self.positions[node] - self.reference[node]
    }

    /// The director of a node.
    pub fn director(&self, node: usize) -> Vector3<f64> {
        self.directors[node].normal
    }

    /// The unknown that is the displacement of a node along a direction of its frame; `None` if it is held or oblique.
    pub fn unknown(&self, node: usize, direction: &Vector3<f64>) -> Option<usize> {
        let axis = self.frames[node].axes.iter().position(|axis| axis.dot(direction) > 1.0 - 1e-12)?;
        self.assembly.unknown(node, axis)
    }

    /// The displacement of a node as it follows from an increment of the unknowns, to first order \[L\].
    pub fn displacement_in(&self, increment: &[f64], node: usize) -> Vector3<f64> {
        (0..3).map(|axis| self.frames[node].axes[axis] * self.part(increment, node, axis)).sum()
    }

    /// The change of a director by first order.
    fn turn_in(&self, increment: &[f64], node: usize) -> Vector3<f64> {
        let [first, second] = self.directors[node].axes();
        first * self.part(increment, node, 3) + second * self.part(increment, node, 4)
    }

    /// A dof's part of an increment; zero where it is held.
    fn part(&self, increment: &[f64], node: usize, dof: usize) -> f64 {
        self.assembly.unknown(node, dof).map_or(0.0, |unknown| increment[unknown])
    }

    fn corners(&self, nodes: &[usize; 4]) -> Corners {
        Corners {
            positions: nodes.map(|node| self.positions[node]),
            directors: nodes.map(|node| self.directors[node].normal),
        }
    }

    /// Adds a force and a force on the director to the degrees of freedom of a node.
    fn add(&self, node: usize, force: &Vector3<f64>, on_director: &Vector3<f64>, out: &mut [f64]) {
        let tangents = self.directors[node].axes();
        for dof in 0..5 {
            if let Some(unknown) = self.assembly.unknown(node, dof) {
                out[unknown] += match dof {
                    0..3 => self.frames[node].axes[dof].dot(force),
                    _ => tangents[dof - 3].dot(on_director),
                };
            }
        }
    }

    fn add_element(&self, nodes: &[usize; 4], forces: &Forces, out: &mut [f64]) {
        for (corner, &node) in nodes.iter().enumerate() {
            let force = forces.fixed_rows::<3>(3 * corner).into_owned();
            let on_director = forces.fixed_rows::<3>(12 + 3 * corner).into_owned();
            self.add(node, &force, &on_director, out);
        }
    }

    /// The element's tangent by its twenty degrees of freedom: the lower triangle.
    ///
    /// Directors move on spheres: the second derivative along a great circle is −d, hence −(f_d·d) on the diagonal.
    fn project(&self, nodes: &[usize; 4], forces: &Forces, tangent: &Tangent) -> [[f64; 20]; 20] {
        let mut out = [[0.0; 20]; 20];
        let bases = nodes.map(|node| {
            let (axes, tangents) = (&self.frames[node].axes, self.directors[node].axes());
            [axes[0], axes[1], axes[2], tangents[0], tangents[1]]
        });
        let start = |corner: usize, dof: usize| 3 * corner + if dof < 3 { 0 } else { 12 };
        for (j, basis) in bases.iter().enumerate() {
            for (b, direction) in basis.iter().enumerate() {
                let column: Forces = tangent.fixed_columns::<3>(start(j, b)) * direction;
                for (i, other) in bases.iter().enumerate().skip(j) {
                    for (a, direction) in other.iter().enumerate() {
                        out[5 * i + a][5 * j + b] = direction.dot(&column.fixed_rows::<3>(start(i, a)));
                    }
                }
            }
            let director = &self.directors[nodes[j]].normal;
            let pull = forces.fixed_rows::<3>(12 + 3 * j).dot(director);
            out[5 * j + 3][5 * j + 3] -= pull;
            out[5 * j + 4][5 * j + 4] -= pull;
        }
        out
    }
}

/// Every load at level one, brought to the nodes.
fn node_loads(loads: &[Load], positions: &[Vector3<f64>], areas: &[f64]) -> Vec<NodeLoad> {
    let mut out = vec![NodeLoad::default(); positions.len()];
    for load in loads {
        match load {
            Load::Node(node, force) => out[*node].force += force,
            Load::Edge(nodes, total) => {
                for (node, share) in shares(nodes, positions) {
                    out[node].force += total * share;
                }
            }
            Load::EdgeCouple(nodes, total) => {
                for (node, share) in shares(nodes, positions) {
                    out[node].couple += total * share;
                }
            }
            Load::Area(pressure) => {
                for (load, area) in out.iter_mut().zip(areas) {
                    load.force += pressure * *area;
                }
            }
        }
    }
    out
}

impl Equilibrium for Model {
    fn unknowns(&self) -> usize {
        self.assembly.unknowns()
    }

    fn pattern(&self) -> Vec<(usize, usize)> {
        self.assembly.pattern()
    }

    fn internal(&mut self, level: f64, out: &mut [f64]) {
        self.put(level);
        out.fill(0.0);
        for (nodes, geometry) in &self.elements {
            let forces = element::forces(geometry, &self.corners(nodes), &self.section.stiffness);
            self.add_element(nodes, &forces, out);
        }
    }

    fn external(&mut self, level: f64, out: &mut [f64]) {
        self.loads(out);
        for value in out {
            *value *= level;
        }
    }

    /// The pull of moved nodes is a central difference over this part of the level: the forces are cubic in it.
    fn load_rate(&mut self, level: f64, out: &mut [f64]) {
        self.loads(out);
        if self.moved.is_empty() {
            return;
        }
        let mut forces = vec![0.0; out.len()];
        for sign in [1.0, -1.0] {
            self.internal(level + sign * DIFFERENCE, &mut forces);
            out.iter_mut().zip(&forces).for_each(|(out, f)| *out -= sign * f / (2.0 * DIFFERENCE));
        }
        self.put(level);
    }

    fn has_moving_supports(&self) -> bool {
        !self.moved.is_empty()
    }

    fn driving_force(&self) -> f64 {
        let nodes: Vec<usize> = self.moved.iter().map(|(node, _)| *node).collect();
        self.moved.first().map_or(0.0, |(_, along)| along.normalize().dot(&self.reaction(&nodes)).abs())
    }

    fn tangent(&mut self, level: f64, values: &mut [f64]) {
        self.put(level);
        values.fill(0.0);
        for (index, (nodes, geometry)) in self.elements.iter().enumerate() {
            let (corners, given) = (self.corners(nodes), self.predicted.get(index));
            let (forces, tangent) = element::tangent(geometry, &corners, &self.section.stiffness, given);
            self.assembly.scatter(index, &self.project(nodes, &forces, &tangent), values);
        }
    }

    fn update(&mut self, increment: &[f64]) {
        if self.predicts {
            let of_element = |(nodes, geometry): &([usize; 4], Geometry)| {
                let change = Corners {
                    positions: nodes.map(|node| self.displacement_in(increment, node)),
                    directors: nodes.map(|node| self.turn_in(increment, node)),
                };
                element::predicted(geometry, &self.corners(nodes), &change, &self.section.stiffness)
            };
            self.predicted = self.elements.iter().map(of_element).collect();
        }
        for node in 0..self.nodes() {
            let moved = self.displacement_in(increment, node);
            self.positions[node] += moved;
            let turn = [3, 4].map(|dof| self.part(increment, node, dof));
            self.directors[node].turn(turn);
        }
    }

    fn save(&self) -> Vec<f64> {
        let nodes = self.positions.iter().zip(&self.directors);
        nodes
            .flat_map(|(x, director)| [x, &director.normal, &director.first].map(|v| [v.x, v.y, v.z]))
            .flatten()
            .collect()
    }

    fn restore(&mut self, saved: &[f64]) {
        self.predicted.clear();
        let nodes = self.positions.iter_mut().zip(&mut self.directors);
        for ((x, director), values) in nodes.zip(saved.chunks_exact(SAVED)) {
            let vector = |start: usize| Vector3::from_column_slice(&values[start..start + 3]);
            *x = vector(0);
            *director = Director { normal: vector(3), first: vector(6) };
        }
    }

    fn energy(&mut self) -> f64 {
        let of_element = |(nodes, geometry): &([usize; 4], Geometry)| {
            element::energy(geometry, &self.corners(nodes), &self.section.stiffness)
        };
        self.elements.iter().map(of_element).sum()
    }

    /// Row sums of the consistent mass: the node's area times mass and rotary inertia per area.
    fn masses(&self) -> Vec<f64> {
        let mut masses = vec![0.0; self.unknowns()];
        for (node, area) in self.areas.iter().enumerate() {
            for dof in 0..5 {
                if let Some(unknown) = self.assembly.unknown(node, dof) {
                    masses[unknown] = area * if dof < 3 { self.section.mass } else { self.section.rotary };
                }
            }
        }
        masses
    }

    fn name_unknown(&self, unknown: usize) -> String {
        let (node, dof) = self.assembly.owner(unknown);
        match dof {
            0..3 => {
                let axis = self.frames[node].axes[dof];
                format!("displacement of node {node} along ({:.3}, {:.3}, {:.3})", axis.x, axis.y, axis.z)
            }
            _ => {
                let axis = self.directors[node].axes()[dof - 3];
                format!(
                    "turn of the director of node {node} towards ({:.3}, {:.3}, {:.3})",
                    axis.x, axis.y, axis.z
                )
            }
        }
    }
}
