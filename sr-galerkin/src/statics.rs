//! The body as a system whose equilibria are sought.

use implicit_statics::{Equilibrium, OutOfBounds};
use solid_kinematics::{Flow, PointState, Tangent, Tensor};

use crate::body::Galerkin;

/// Tangents of a trial after which its failure is laid to the tangent.
const TRIED: usize = 2;
/// Numbers of a point's state, and of what flow has left there.
const POINT: usize = 24;
const FLOW: usize = 7;
const AXES: [char; 3] = ['x', 'y', 'z'];

impl Equilibrium for Galerkin {
    fn unknowns(&self) -> usize {
        self.unknowns.count()
    }

    fn pattern(&self) -> Vec<(usize, usize)> {
        self.reduction.pattern.clone()
    }

    /// Places of the parameters in units of the support.
    fn coordinates(&self) -> Option<Vec<[f64; 3]>> {
        let place = |&parameter: &u32| {
            let x = self.space.nodes[parameter as usize / 3];
            std::array::from_fn(|k| x[k] / self.radii[k])
        };
        Some(self.unknowns.parameters.iter().map(place).collect())
    }

    /// Where a point cannot follow, the forces on its nodes are no numbers, and [`Galerkin::trouble`] says why.
    fn internal(&mut self, level: f64, out: &mut [f64]) {
        self.evaluate_internal(level);
        self.unknowns.project(&self.internal, out);
    }

    fn external(&mut self, level: f64, out: &mut [f64]) {
        self.put(level);
        self.evaluate_external(level);
        self.unknowns.project(&self.external, out);
    }

    fn load_rate(&mut self, level: f64, out: &mut [f64]) {
        self.put(level);
        self.loads.forces(1.0, (&self.space.images, &self.parameters), &mut self.external);
        if self.unknowns.moves {
            self.assemble(level);
            let mut rates = vec![0.0; self.parameters.len()];
            self.unknowns.held.iter().for_each(|held| rates[held.parameter as usize] = held.rate);
            let mut forces = vec![0.0; rates.len()];
            self.blocks.product(&rates, &mut forces);
            self.external.iter_mut().zip(&forces).for_each(|(out, force)| *out -= force);
            let external = &mut self.external;
            self.loads.stiffness((&self.space.images, &self.parameters), |row, column, k| {
                for i in 0..3 {
                    let way = |j: usize| rates[3 * column as usize + j];
                    external[3 * row as usize + i] += level * (0..3).map(|j| k[i][j] * way(j)).sum::<f64>();
                }
            });
        }
        self.take_heat_rate(level);
        self.unknowns.project(&self.external, out);
    }

    fn stress_forces(&self, level: f64) -> f64 {
        self.heat_exerts(level)
    }

    fn tangent(&mut self, level: f64, values: &mut [f64]) {
        // At the state that the step starts from a solver may have a factor already: none of the trial.
        self.tangents += usize::from(self.accepted != self.parameters);
        self.assemble(level);
        self.add_load_stiffness(level);
        self.reduction.reduce(&self.blocks, values);
    }

    /// A stiffness and its factor cost ten times what forces and a solve do.
    fn keeps_factor(&self) -> bool {
        true
    }

    /// The consistent one is the derivative over the step, and any of a material that flows.
    fn tangent_is_of_the_step(&self) -> bool {
        let of_the_step = self.tangent == Tangent::Consistent || self.flows();
        let over_the_step = of_the_step && self.accepted != self.parameters;
        self.remembers() && (self.insists || over_the_step)
    }

    fn has_moving_supports(&self) -> bool {
        self.unknowns.moves
    }

    /// Takes deformation, axes and stress of all points as those that the next step starts from.
    fn commit(&mut self) {
        (self.tangents, self.insists) = (0, false);
        if self.accepted == self.parameters {
            return;
        }
        self.evaluate_internal(self.level);
        for (state, trial) in self.history.iter_mut().zip(&self.trials) {
            *state = trial.state;
        }
        self.accepted.copy_from_slice(&self.parameters);
        self.evaluated = false;
    }

    fn driving_force(&self) -> f64 {
        let moved = self.unknowns.held.iter().filter(|held| held.rate != 0.0);
        moved.map(|held| self.internal[held.parameter as usize].powi(2)).sum::<f64>().sqrt()
    }

    fn update(&mut self, increment: &[f64]) {
        for (parameter, change) in self.unknowns.parameters.iter().zip(increment) {
            self.parameters[*parameter as usize] += change;
        }
        self.evaluated = false;
    }

    /// Parameters; where stress has a history, the state that the present step starts from as well.
    fn save(&self) -> Vec<f64> {
        let mut out = self.parameters.clone();
        if self.remembers() {
            out.reserve(self.accepted.len() + self.numbers() * self.history.len());
            out.extend_from_slice(&self.accepted);
            for state in &self.history {
                out.extend_from_slice(state.gradient.as_slice());
                out.extend_from_slice(state.axes.as_slice());
                out.extend_from_slice(&state.stress);
                if self.flows() {
                    out.push(state.flow.strain);
                    out.extend_from_slice(&state.flow.back);
                }
            }
        }
        out
    }

    /// Comes back to a saved state. A trial that is given up after two tangents or more is made again with the consistent one.
    fn restore(&mut self, saved: &[f64]) {
        let count = self.parameters.len();
        self.parameters.copy_from_slice(&saved[..count]);
        if saved.len() > count {
            self.accepted.copy_from_slice(&saved[count..2 * count]);
            let (numbers, flows) = (self.numbers(), self.flows());
            for (state, from) in self.history.iter_mut().zip(saved[2 * count..].chunks_exact(numbers)) {
                let flow =
                    |from: &[f64]| Flow { strain: from[0], back: std::array::from_fn(|i| from[1 + i]) };
                *state = PointState {
                    gradient: Tensor::from_column_slice(&from[..9]),
                    axes: Tensor::from_column_slice(&from[9..18]),
                    stress: std::array::from_fn(|i| from[18 + i]),
                    flow: if flows { flow(&from[POINT..]) } else { Flow::default() },
                };
            }
        }
        self.insists |= self.tangents >= TRIED && self.accepted == self.parameters;
        self.evaluated = false;
    }

    fn energy(&mut self) -> f64 {
        self.evaluate_internal(self.level);
        let volumes = self.space.cells.iter().flat_map(|cell| &cell.volumes);
        let all = self.trials.iter().zip(volumes);
        let Some(heat) = &self.heat else {
            return all.map(|(trial, v)| v * self.material.energy(&trial.state)).sum();
        };
        all.zip(&heat.stretch).map(|((trial, v), s)| v * s * s * s * self.material.energy(&trial.state)).sum()
    }

    fn masses(&self) -> Vec<f64> {
        let mass = |parameter: u32| self.masses[parameter as usize / 3];
        let mut out: Vec<f64> = self.unknowns.parameters.iter().map(|&parameter| mass(parameter)).collect();
        for held in &self.unknowns.held {
            held.terms.iter().for_each(|&(u, t)| out[u as usize] += t * t * mass(held.parameter));
        }
        out
    }

    fn name_unknown(&self, unknown: usize) -> String {
        let parameter = self.unknowns.parameters[unknown] as usize;
        let (node, axis) = (parameter / 3, AXES[parameter % 3]);
        let x = self.space.nodes[node];
        let place = format!("node {node} at ({:.4}, {:.4}, {:.4}), moving along {axis}", x.x, x.y, x.z);
        match self.trouble() {
            None => place,
            Some((at, error)) => {
                format!("{place}; at the Gauss point ({:.4}, {:.4}, {:.4}) {error}", at.x, at.y, at.z)
            }
        }
    }

    fn within_bounds(&self) -> Result<(), OutOfBounds> {
        self.turns_within_bounds()
    }
}

impl Galerkin {
    /// Whether its material yields.
    pub(crate) fn flows(&self) -> bool {
        self.material.plastic.is_some()
    }

    /// Numbers of a point that are kept.
    fn numbers(&self) -> usize {
        POINT + if self.flows() { FLOW } else { 0 }
    }
}
