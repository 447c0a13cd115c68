//! A solid with its supports and loads: the system that Newton's method sees.

use implicit_statics::Equilibrium;
use nalgebra::Vector3;

use super::element::{Moduli, NODES, Point, tensor};
use super::mesh::Mesh;

/// Degrees of freedom of a brick.
const DOF: usize = 3 * NODES;
/// Marks an entry of a brick that belongs to a held freedom.
const HELD: u32 = u32::MAX;

/// A displacement that is held: a node, an axis, and where it goes with a unit of level \[L\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Held {
    /// The node.
    pub node: usize,
    /// The axis, 0 to 2.
    pub axis: usize,
    /// Displacement at level one \[L\].
    pub by: f64,
}

/// A finite-element solid.
#[derive(Debug, Clone)]
pub struct Model {
    elements: Vec<([usize; NODES], Vec<Point>)>,
    moduli: Moduli,
    /// Unknown of each freedom; none where it is held.
    numbers: Vec<Option<usize>>,
    held: Vec<Held>,
    /// Loads at level one, by dofs \[F\].
    loads: Vec<f64>,
    /// Places at rest and displacements \[L\].
    rest: Vec<Vector3<f64>>,
    moved: Vec<Vector3<f64>>,
    /// Positions (row, column), row ≥ column, and the place there of each entry of each brick.
    pattern: Vec<(usize, usize)>,
    places: Vec<Vec<u32>>,
}

impl Model {
    /// A solid of bricks with two or three Gauss points along an edge; none where a brick is turned inside out.
    pub fn new(
        mesh: &Mesh,
        moduli: Moduli,
        rule: usize,
        held: &[Held],
        loads: &[(usize, Vector3<f64>)],
    ) -> Option<Self> {
        let count = mesh.positions.len();
        let mut free = vec![true; 3 * count];
        held.iter().for_each(|held| free[3 * held.node + held.axis] = false);
        let mut unknowns = 0..;
        let numbers: Vec<Option<usize>> =
            free.iter().map(|&free| if free { unknowns.next() } else { None }).collect();
        let bricks = mesh.elements.iter().enumerate();
        let elements: Vec<_> = bricks
            .map(|(at, nodes)| Some((*nodes, Point::of(&mesh.corners(at), rule)?)))
            .collect::<Option<_>>()?;
        let entries = |nodes: &[usize; NODES]| {
            let unknown = |freedom: usize| numbers[3 * nodes[freedom / 3] + freedom % 3];
            let mut out = Vec::with_capacity(DOF * (DOF + 1) / 2);
            for row in 0..DOF {
                for column in 0..=row {
                    out.push(unknown(row).zip(unknown(column)).map(|(a, b)| (a.max(b), a.min(b))));
                }
            }
            out
        };
        let entries: Vec<Vec<Option<(usize, usize)>>> = mesh.elements.iter().map(entries).collect();
        let mut pattern: Vec<(usize, usize)> = entries.iter().flatten().flatten().copied().collect();
        pattern.sort_unstable();
        pattern.dedup();
        let place = |entry: &Option<(usize, usize)>| {
            entry.and_then(|entry| pattern.binary_search(&entry).ok()).map_or(HELD, |at| at as u32)
        };
        let places = entries.iter().map(|own| own.iter().map(place).collect()).collect();
        let mut forces = vec![0.0; 3 * count];
        for (node, force) in loads {
            (0..3).for_each(|k| forces[3 * node + k] += force[k]);
        }
        let (rest, moved) = (mesh.positions.clone(), vec![Vector3::zeros(); count]);
        Some(Self {
            elements,
            moduli,
            numbers,
            held: held.to_vec(),
            loads: forces,
            rest,
            moved,
            pattern,
            places,
        })
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.rest.len()
    }

    /// Displacement of a node \[L\].
    pub fn displacement(&self, node: usize) -> Vector3<f64> {
        self.moved[node]
    }

    /// Force that supports exert on some nodes together, at a level \[F\].
    pub fn reaction(&mut self, nodes: &[usize], level: f64) -> Vector3<f64> {
        let forces = self.forces(level);
        let of_node =
            |&node: &usize| Vector3::from_fn(|k, _| forces[3 * node + k] - level * self.loads[3 * node + k]);
        nodes.iter().map(of_node).sum()
    }

    /// Puts held displacements where a level has them.
    fn put(&mut self, level: f64) {
        for held in &self.held {
            self.moved[held.node][held.axis] = level * held.by;
        }
    }

    /// Internal forces by dofs \[F\].
    fn forces(&mut self, level: f64) -> Vec<f64> {
        self.put(level);
        let mut out = vec![0.0; self.loads.len()];
        for (nodes, points) in &self.elements {
            let moved = nodes.map(|node| self.moved[node]);
            for point in points {
                let (gradient, _, stress) = point.state(&moved, &self.moduli);
                let piola = gradient * tensor(&stress) * point.volume;
                for (node, slope) in nodes.iter().zip(&point.gradients) {
                    let force = piola * slope;
                    (0..3).for_each(|k| out[3 * node + k] += force[k]);
                }
            }
        }
        out
    }

    /// The tangent of a brick: the lower triangle, by rows.
    fn stiffness(&self, element: usize) -> Vec<[f64; DOF]> {
        let (nodes, points) = &self.elements[element];
        let moved = nodes.map(|node| self.moved[node]);
        let mut out = vec![[0.0; DOF]; DOF];
        for point in points {
            let (gradient, _, stress) = point.state(&moved, &self.moduli);
            let stress = tensor(&stress);
            for b in 0..NODES {
                let column = self.moduli.0 * point.rates(&gradient, b) * point.volume;
                let pull = stress * point.gradients[b] * point.volume;
                for a in b..NODES {
                    let part = point.rates(&gradient, a).transpose() * column;
                    let along = point.gradients[a].dot(&pull);
                    for i in 0..3 {
                        (0..3).for_each(|j| out[3 * a + i][3 * b + j] += part[(i, j)]);
                        out[3 * a + i][3 * b + i] += along;
                    }
                }
            }
        }
        out
    }

    /// Takes the numbers of free degrees of freedom.
    fn project(&self, all: &[f64], out: &mut [f64]) {
        for (number, value) in self.numbers.iter().zip(all) {
            if let Some(unknown) = number {
                out[*unknown] = *value;
            }
        }
    }
}

impl Equilibrium for Model {
    fn unknowns(&self) -> usize {
        self.numbers.iter().flatten().count()
    }

    fn pattern(&self) -> Vec<(usize, usize)> {
        self.pattern.clone()
    }

    fn internal(&mut self, level: f64, out: &mut [f64]) {
        let forces = self.forces(level);
        self.project(&forces, out);
    }

    fn external(&mut self, level: f64, out: &mut [f64]) {
        self.project(&self.loads, out);
        out.iter_mut().for_each(|force| *force *= level);
    }

    /// Loads less what held displacements pull as they go: the columns of the tangent that belong to them.
    fn load_rate(&mut self, level: f64, out: &mut [f64]) {
        self.put(level);
        let mut all = self.loads.clone();
        let mut rates = vec![0.0; all.len()];
        self.held.iter().for_each(|held| rates[3 * held.node + held.axis] = held.by);
        for element in 0..self.elements.len() {
            let dofs: Vec<usize> =
                self.elements[element].0.iter().flat_map(|node| [0, 1, 2].map(|k| 3 * node + k)).collect();
            if dofs.iter().all(|&dof| rates[dof] == 0.0) {
                continue;
            }
            let matrix = self.stiffness(element);
            for (i, row) in dofs.iter().enumerate() {
                for (j, column) in dofs.iter().enumerate() {
                    all[*row] -= matrix[i.max(j)][i.min(j)] * rates[*column];
                }
            }
        }
        self.project(&all, out);
    }

    fn has_moving_supports(&self) -> bool {
        self.held.iter().any(|held| held.by != 0.0)
    }

    fn tangent(&mut self, level: f64, values: &mut [f64]) {
        self.put(level);
        values.fill(0.0);
        for element in 0..self.elements.len() {
            let matrix = self.stiffness(element);
            let lower = matrix.iter().enumerate().flat_map(|(row, entries)| &entries[..=row]);
            for (&place, value) in self.places[element].iter().zip(lower) {
                if place != HELD {
                    values[place as usize] += value;
                }
            }
        }
    }

    fn update(&mut self, increment: &[f64]) {
        for (freedom, number) in self.numbers.iter().enumerate() {
            if let Some(unknown) = number {
                self.moved[freedom / 3][freedom % 3] += increment[*unknown];
            }
        }
    }

    fn save(&self) -> Vec<f64> {
        self.moved.iter().flat_map(|u| [u.x, u.y, u.z]).collect()
    }

    fn restore(&mut self, saved: &[f64]) {
        for (u, saved) in self.moved.iter_mut().zip(saved.chunks_exact(3)) {
            u.copy_from_slice(saved);
        }
    }

    fn energy(&mut self) -> f64 {
        let of_brick = |(nodes, points): &([usize; NODES], Vec<Point>)| {
            let moved = nodes.map(|node| self.moved[node]);
            let energy = |point: &Point| {
                let (_, strain, stress) = point.state(&moved, &self.moduli);
                0.5 * point.volume * strain.dot(&stress)
            };
            points.iter().map(energy).sum::<f64>()
        };
        self.elements.iter().map(of_brick).sum()
    }

    /// Of density one: the volume of a brick in proportion to the integrals of the squares of its functions.
    fn masses(&self) -> Vec<f64> {
        let mut all = vec![0.0; self.loads.len()];
        for (nodes, points) in &self.elements {
            let square =
                |a: usize| points.iter().map(|point| point.volume * point.values[a].powi(2)).sum::<f64>();
            let squares: [f64; NODES] = std::array::from_fn(square);
            let volume = points.iter().map(|point| point.volume).sum::<f64>();
            let scale = volume / squares.iter().sum::<f64>();
            for (node, square) in nodes.iter().zip(squares) {
                (0..3).for_each(|k| all[3 * node + k] += scale * square);
            }
        }
        let mut out = vec![0.0; self.unknowns()];
        self.project(&all, &mut out);
        out
    }

    fn name_unknown(&self, unknown: usize) -> String {
        let freedom = self.numbers.iter().position(|number| *number == Some(unknown)).unwrap_or(0);
        format!("displacement of node {} along {}", freedom / 3, ["x", "y", "z"][freedom % 3])
    }
}
