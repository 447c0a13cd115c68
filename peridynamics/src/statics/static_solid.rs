//! A peridynamic body whose equilibria are sought: its unknowns, forces and tangent, held sets moved by level.

use std::cell::OnceCell;
use std::ops::DerefMut;

use explicit_dynamics::Instant;
use implicit_statics::{BlockPattern, Equilibrium, OutOfBounds, row_sums};
use sph_core::{Vec3, fitted_spins};

use crate::Solid;
use crate::bonds::couplings::{Coupling, product, transposed_product};
use crate::bonds::network::Row;
use crate::solid::vector;
use crate::unknowns::Unknowns;

/// Present over reference length of a bond below which a state is refused.
const SHORTEST: f64 = 0.1;

/// A peridynamic body with what Newton's method and relaxation need.
///
/// Contact is not in the tangent: bodies with it belong in time. Built only when a static analysis asks for it. The body is its own, or lent (`&mut Solid`) for a look at the tangent of
/// a state. Bonds break in [`Equilibrium::break_critical`] alone, those nearest to their limits first, and the path finds the
/// balance without them before others do. Broken bonds stay broken, whatever state is restored.
pub struct StaticSolid<S = Box<Solid>> {
    solid: S,
    unknowns: Unknowns,
    /// Which rows couple; found when a tangent is first asked for.
    couplings: OnceCell<BlockPattern>,
    /// Rows with a prescribed displacement.
    moved: Vec<u32>,
    /// Whether heat goes with the level.
    warms: bool,
    /// The level at which they were put last.
    level: f64,
}

impl StaticSolid {
    /// Numbers the free degrees of freedom of a body. What its supports move goes with the level, and its heat.
    pub fn new(solid: Solid) -> Self {
        let moved = solid.constraints.moved().map(|(row, _)| row as u32).collect();
        let warms = solid.heat.is_some();
        Self { moved, warms, ..Self::lent(Box::new(solid)) }
    }
}

impl<S: DerefMut<Target = Solid>> StaticSolid<S> {
    /// The same of a body that goes on afterwards: [`Equilibrium::tangent`] and the forces leave its motion as it is, that
    /// of prescribed values too, and its heat.
    pub fn lent(solid: S) -> Self {
        let unknowns = Unknowns::new(&solid.constraints, solid.len(), solid.block.greatest_spacing());
        Self { solid, unknowns, couplings: OnceCell::new(), moved: Vec::new(), warms: false, level: 0.0 }
    }

    /// The body in its present state; its forces are those last evaluated.
    pub fn solid(&self) -> &Solid {
        &self.solid
    }

    /// The same, to put it into another state; whatever is evaluated is that of the state before.
    pub fn solid_mut(&mut self) -> &mut Solid {
        &mut self.solid
    }

    /// Evaluates internal forces and energy, and the loads at a level, so that probes can read them.
    pub fn evaluate(&mut self, level: f64) {
        self.put(level);
        self.solid.evaluate_internal(true);
        self.external_at(level);
    }

    /// The mean displacement of nodes along a direction, as weights of the unknowns: what displacement control prescribes.
    pub fn functional(&self, nodes: &[u32], direction: Vec3) -> Vec<f64> {
        let mut weights = vec![0.0; self.unknowns.count()];
        let share = direction.normalize() / nodes.len() as f64;
        for &node in nodes {
            for unknown in self.unknowns.of(node as usize) {
                weights[unknown] += self.unknowns.direction(unknown).dot(&share);
            }
        }
        weights
    }

    /// Unknowns of a node with the way that it goes for a unit of each.
    pub(super) fn directions(&self, node: usize) -> impl Iterator<Item = (usize, Vec3)> {
        self.unknowns.of(node).map(|unknown| (unknown, *self.unknowns.direction(unknown)))
    }

    fn couplings(&self) -> &BlockPattern {
        self.couplings.get_or_init(|| self.solid.mechanics.couplings())
    }

    /// Second derivatives of the stored energy at the present state, with the stresses of another one if it is given.
    fn blocks(&mut self, stressed: Option<&[Row]>) -> Vec<Coupling> {
        let mut blocks = vec![[[0.0; 3]; 3]; self.couplings().blocks()];
        let solid = &*self.solid;
        let pattern = self.couplings();
        solid.mechanics.second_derivatives(
            (&solid.rows, stressed),
            pattern,
            &mut blocks,
            solid.share.threads(),
        );
        blocks
    }

    /// Block, row and column of the entries between the unknowns, in the order of the pattern.
    fn entries(&self) -> impl Iterator<Item = (usize, usize, usize)> {
        self.couplings().entries(|row| self.unknowns.of(row))
    }

    /// Entries between the unknowns from the blocks, in the order of the pattern.
    fn assemble(&self, blocks: &[Coupling], values: &mut [f64]) {
        for ((block, row, column), value) in self.entries().zip(values) {
            let (left, right) = (self.unknowns.direction(row), self.unknowns.direction(column));
            *value = left.dot(&product(&blocks[block], right));
        }
    }

    /// How far each node turns with a motion, what is prescribed going from one level to another.
    fn spins(&self, [from, to]: [f64; 2], motion: &[f64]) -> Vec<Vec3> {
        let (solid, couplings) = (&*self.solid, self.couplings());
        let nodes = solid.len();
        let positions: Vec<Vec3> = solid.rows[..nodes].iter().map(vector).collect();
        let velocity = |row| {
            let own = self.unknowns.of(row);
            own.map(|unknown| self.unknowns.direction(unknown) * motion[unknown]).sum()
        };
        let mut velocities: Vec<Vec3> = (0..nodes).map(velocity).collect();
        for &row in self.moved.iter().filter(|&&row| (row as usize) < nodes) {
            velocities[row as usize] += self.prescribed_rate(row as usize, from) * (to - from);
        }
        let pairs = couplings.pairs().take_while(|&(a, _, _)| a < nodes);
        fitted_spins(&positions, &velocities, pairs.map(|(a, b, _)| (a, b)))
    }

    /// Puts prescribed values where a level has them, and gives bonds its heat.
    pub(super) fn put(&mut self, level: f64) {
        self.level = level;
        if self.warms {
            self.solid.expand(level);
        }
        let solid = &mut *self.solid;
        for &row in &self.moved {
            if let Some(constraint) = solid.constraints.get(row as usize) {
                constraint.put(Instant { time: 0.0, level }, &mut solid.rows[row as usize]);
            }
        }
    }

    fn external_at(&mut self, level: f64) {
        self.solid.evaluate_external(Instant { time: 0.0, level });
    }

    /// Rates of a row's prescribed displacement per unit of level, at a level.
    fn prescribed_rate(&self, row: usize, level: f64) -> Vec3 {
        self.solid.constraints.get(row).map_or_else(Vec3::zeros, |constraint| constraint.rate(level))
    }

    /// Rows of `∂(external − internal)/∂λ`: the loads, `−K_fc ċ` of the prescribed values c, and what heat pulls with.
    fn level_rates(&mut self, level: f64) -> Vec<Vec3> {
        self.put(level);
        self.solid.evaluate_loads(Instant { time: 0.0, level: 1.0 });
        let count = self.solid.rows.len();
        let mut rates = vec![Vec3::zeros(); count];
        for &row in &self.moved {
            rates[row as usize] = self.prescribed_rate(row as usize, level);
        }
        let mut rows: Vec<Vec3> = (0..count).map(|row| self.solid.external_force(row)).collect();
        if self.warms {
            self.take_heat_rate(level, &mut rows);
        }
        if self.moved.is_empty() {
            return rows;
        }
        let blocks = self.blocks(None);
        for (a, b, number) in self.couplings().pairs() {
            rows[a] -= product(&blocks[number], &rates[b]);
            if a != b {
                rows[b] -= transposed_product(&blocks[number], &rates[a]);
            }
        }
        rows
    }

    /// Takes off what heat adds to internal forces by the level, the rows staying: lengths are linear in the level, and pulls in lengths, so that the
    /// difference over one level is the derivative.
    fn take_heat_rate(&mut self, level: f64, out: &mut [Vec3]) {
        for (at, sign) in [(level + 0.5, -1.0), (level - 0.5, 1.0)] {
            self.solid.expand(at);
            self.solid.evaluate_internal(false);
            out.iter_mut().zip(&self.solid.internal).for_each(|(out, force)| *out += vector(force) * sign);
        }
        self.solid.expand(level);
        self.solid.evaluate_internal(false);
    }
}

impl<S: DerefMut<Target = Solid>> Equilibrium for StaticSolid<S> {
    fn unknowns(&self) -> usize {
        self.unknowns.count()
    }

    fn pattern(&self) -> Vec<(usize, usize)> {
        self.entries().map(|(_, row, column)| (row, column)).collect()
    }

    fn internal(&mut self, level: f64, out: &mut [f64]) {
        self.put(level);
        self.solid.evaluate_internal(false);
        self.unknowns.project(|row| vector(&self.solid.internal[row]), out);
    }

    fn external(&mut self, level: f64, out: &mut [f64]) {
        self.put(level);
        self.external_at(level);
        self.unknowns.project(|row| self.solid.external_force(row), out);
    }

    fn load_rate(&mut self, level: f64, out: &mut [f64]) {
        // Loads are proportional to the level.
        if self.moved.is_empty() && !self.warms {
            self.solid.evaluate_loads(Instant { time: 0.0, level: 1.0 });
            return self.unknowns.project(|row| self.solid.external_force(row), out);
        }
        let rows = self.level_rates(level);
        self.unknowns.project(|row| rows[row], out);
    }

    fn tangent(&mut self, level: f64, values: &mut [f64]) {
        self.put(level);
        let blocks = self.blocks(None);
        self.assemble(&blocks, values);
    }

    fn has_moving_supports(&self) -> bool {
        !self.moved.is_empty()
    }

    fn stress_forces(&self, level: f64) -> f64 {
        if self.warms { self.solid.heat_exerts(level) } else { 0.0 }
    }

    /// Counts the work done on bonds. None breaks.
    fn commit(&mut self) {
        self.solid.count_work();
    }

    fn utilisation(&mut self) -> f64 {
        self.solid.utilisation()
    }

    fn break_critical(&mut self) -> f64 {
        self.solid.break_critical()
    }

    /// Without a matrix: exact where no dilatation counts, else a bound. All unknowns of a node take the largest of theirs
    /// where the stiff directions turn with the body.
    fn row_sums(&mut self, level: f64, out: &mut [f64]) {
        self.put(level);
        let solid = &*self.solid;
        if !solid.mechanics.row_sums(&solid.rows, &self.unknowns, out) {
            let pattern = self.pattern();
            let mut values = vec![0.0; pattern.len()];
            self.tangent(level, &mut values);
            row_sums(&pattern, &values, out);
        }
        let turning = if self.solid.mechanics.keeps_directions() { 0 } else { self.solid.rows.len() };
        for row in 0..turning {
            let own = &mut out[self.unknowns.of(row)];
            let largest = own.iter().copied().fold(0.0, f64::max);
            own.fill(largest);
        }
    }

    fn stressed_tangent(&mut self, level: f64, motion: &[f64], values: &mut [f64]) -> bool {
        let rest = self.save();
        self.update(motion);
        self.put(level);
        let stressed = self.solid.rows.clone();
        self.restore(&rest);
        let blocks = self.blocks(Some(&stressed));
        self.assemble(&blocks, values);
        true
    }

    /// Nodes turn as their neighbours do about them. Sheets on directors keep fixed axes: nodes that turned without their
    /// directors would show the shear between them.
    fn turned_tangent(&mut self, levels: [f64; 2], motion: &[f64], values: &mut [f64]) {
        let directors = self.solid.rows.len() > self.solid.len();
        let turned = self.unknowns.turned(&if directors { Vec::new() } else { self.spins(levels, motion) });
        let rest = self.save();
        self.update(motion);
        let fixed = std::mem::replace(&mut self.unknowns, turned);
        self.tangent(levels[1], values);
        self.unknowns = fixed;
        self.restore(&rest);
    }

    fn driving_force(&self) -> f64 {
        let along = |&row: &u32| {
            let row = row as usize;
            let way = self.prescribed_rate(row, self.level);
            let force = vector(&self.solid.internal[row]);
            if way.norm() > 0.0 { force.dot(&way.normalize()).powi(2) } else { 0.0 }
        };
        self.moved.iter().map(along).sum::<f64>().sqrt()
    }

    fn update(&mut self, increment: &[f64]) {
        for (row, place) in self.solid.rows.iter_mut().enumerate() {
            for unknown in self.unknowns.of(row) {
                let direction = self.unknowns.direction(unknown);
                (0..3).for_each(|k| place[k] += increment[unknown] * direction[k]);
            }
        }
    }

    /// Positions and directors; bonds that broke are not among them, they stay broken.
    fn save(&self) -> Vec<f64> {
        self.solid.rows.iter().flat_map(|row| [row[0], row[1], row[2]]).collect()
    }

    fn restore(&mut self, saved: &[f64]) {
        for (row, from) in self.solid.rows.iter_mut().zip(saved.chunks_exact(3)) {
            row[..3].copy_from_slice(from);
        }
    }

    fn energy(&mut self) -> f64 {
        self.solid.evaluate_internal(true);
        self.solid.internal_energy
    }

    fn masses(&self) -> Vec<f64> {
        let of = |unknown: usize| {
            let (row, direction) = self.unknowns.find(unknown);
            self.solid.masses[row] * direction.norm_squared()
        };
        (0..self.unknowns.count()).map(of).collect()
    }

    fn name_unknown(&self, unknown: usize) -> String {
        let (row, direction) = self.unknowns.find(unknown);
        let (node, n) = (row % self.solid.len(), direction.normalize());
        let x = self.solid.rest[node];
        let what = if row < self.solid.len() { "moving" } else { "its director turning" };
        format!(
            "node {node} at ({:.4}, {:.4}, {:.4}), {what} along ({:.2}, {:.2}, {:.2})",
            x.x, x.y, x.z, n.x, n.y, n.z
        )
    }

    fn within_bounds(&self) -> Result<(), OutOfBounds> {
        if self.solid.mechanics.yields() {
            return Err(OutOfBounds {
                place: "a solid of bonds".into(),
                what: "bodies whose bonds yield",
                value: 1.0,
                bound: "none in statics: their equilibria hang on the way there; take a quasi-static march",
            });
        }
        match self.solid.mechanics.shortest(&self.solid.rows) {
            (node, ratio) if ratio < SHORTEST => Err(OutOfBounds {
                place: format!("the shortest bond of node {node}"),
                what: "present length over that at rest",
                value: ratio,
                bound: "0.1 at least: nodes are about to pass through each other",
            }),
            _ => Ok(()),
        }
    }
}
