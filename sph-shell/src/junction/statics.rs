//! Groups without time: six unknowns each, their place among the blocks of the tangent, and their motion.

use implicit_statics::BlockPattern;
use std::ops::DerefMut;

use nalgebra::Matrix3;
use sph_core::Vec3;

use crate::Shell;
use crate::conditions::body::Block;
use crate::conditions::supports::{Constraint, DirectorHold};
use crate::junction::group::{Group, Junctions, director, place};
use crate::packs::Row;
use crate::statics::dofs::Basis;
use crate::statics::static_shell::StaticShell;

impl Junctions {
    /// Moves a group as its first particle's unknowns say; the others of a group go with it.
    pub fn move_first(&self, state: &mut [Row], particle: usize, u: &Vec3, theta: &Vec3) {
        if let Some(group) = self.of(particle).filter(|group| group.first() == particle) {
            let way = group.way_of_pole(state, u, theta);
            group.turn(state, &way, theta);
        }
    }

    /// Adds the pairs of first particles to the pairs of particles that share a block, row by row.
    pub fn add_pairs(&self, rows: &mut [Vec<u32>]) {
        if self.is_empty() {
            return;
        }
        for a in 0..rows.len() {
            for number in 0..rows[a].len() {
                let (row, column) = (self.first(a) as u32, self.first(rows[a][number] as usize) as u32);
                rows[row.max(column) as usize].push(row.min(column));
            }
        }
    }

    /// Turns blocks between particles into blocks between unknowns, `Σ_kl T_kᵀ H_kl T_l`, with the first particles of groups in the
    /// place of all. The lower triangle is that of a symmetric matrix, or of a skew one with sign −1.
    pub fn tie(&self, state: &[Row], pattern: &BlockPattern, blocks: &mut [Block], sign: f64) {
        if self.is_empty() {
            return;
        }
        let arms = self.arms(state);
        let levers: Vec<_> = self.groups.iter().map(|group| group.lever(state)).collect();
        // What a force on a particle adds to the torque that is conjugate to the rotation.
        let moment = |a: usize, force: Vec3| {
            let own = arms.get(a).map_or(Vec3::zeros(), |arm| arm.cross(&force));
            let lever = self.number(a).and_then(|number| levers[number]);
            lever.map_or(own, |lever| own - lever.torque(&force))
        };
        for (a, b, number) in pattern.pairs() {
            let block = &mut blocks[number];
            if self.of(a).is_some() {
                let d = director(&state[a]);
                for column in 0..6 {
                    let of = |first: usize| Vec3::from_fn(|k, _| block[first + k][column]);
                    let torque = d.cross(&of(3)) + moment(a, of(0));
                    (0..3).for_each(|i| block[3 + i][column] = torque[i]);
                }
            }
            if self.of(b).is_some() {
                let d = director(&state[b]);
                for row in block.iter_mut() {
                    let turned = d.cross(&director(row)) + moment(b, place(row));
                    row[3..].copy_from_slice(turned.as_slice());
                }
            }
        }
        for (a, b, number) in pattern.pairs() {
            let (row, column) = (self.first(a), self.first(b));
            if (row, column) == (a, b) {
                continue;
            }
            let Some(target) = pattern.find(row.max(column) as u32, row.min(column) as u32) else { continue };
            let block = blocks[number];
            let plain = if row >= column { 1.0 } else { 0.0 };
            // A pair within one group comes once and stands for both orders.
            let transposed = if row < column || (row == column && a != b) { sign } else { 0.0 };
            for i in 0..6 {
                for j in 0..6 {
                    blocks[target][i][j] += plain * block[i][j] + transposed * block[j][i];
                }
            }
        }
    }

    /// Arm of each particle from the pole of its rigid body; empty without bodies.
    fn arms(&self, state: &[Row]) -> Vec<Vec3> {
        if self.groups.iter().all(|group| group.body.is_none()) {
            return Vec::new();
        }
        let mut arms = vec![Vec3::zeros(); state.len()];
        for group in &self.groups {
            let Some(pole) = group.far_pole(state) else { continue };
            group.particles.iter().for_each(|&a| arms[a as usize] = place(&state[a as usize]) - pole);
        }
        arms
    }

    /// Adds the second variation along the rotations to the blocks of the first particles, `p` being the rows `[f, n]` less the loads.
    pub fn add_rotation_blocks(
        &self,
        state: &[Row],
        pattern: &BlockPattern,
        blocks: &mut [Block],
        p: impl Fn(usize) -> Row,
    ) {
        for group in &self.groups {
            let first = group.first() as u32;
            let Some(target) = pattern.find(first, first) else { continue };
            let block = group.rotation_block(state, &p);
            for i in 0..3 {
                for j in 0..3 {
                    blocks[target][3 + i][3 + j] += block[(i, j)];
                }
            }
        }
    }
}

impl Group {
    /// Directions of the unknowns of a particle of the group: the first has up to three translations and three rotations,
    /// the others have none.
    pub fn basis(&self, state: &[Row], constraint: Option<&Constraint>, particle: usize, arc: f64) -> Basis {
        let mut basis = Basis::empty(arc);
        let Some(constraint) = constraint.filter(|_| self.first() == particle) else {
            return basis;
        };
        for direction in constraint.held.free() {
            basis.push(direction);
        }
        basis.move_first(basis.count);
        match constraint.director {
            DirectorHold::Free => {
                let axes = self.turning_axes(state);
                (0..3).for_each(|i| basis.push(axes.column(i).into()));
            }
            DirectorHold::InPlane(normal) => basis.push(normal),
            DirectorHold::Fixed => {}
        }
        basis
    }

    /// `Σ_k [½(p_k d_kᵀ + d_k p_kᵀ) − (p_k·d_k) 1]`, of a body the same of forces and arms too.
    fn rotation_block(&self, state: &[Row], p: impl Fn(usize) -> Row) -> Matrix3<f64> {
        let of = |p: &Vec3, d: &Vec3| {
            let outer = p * d.transpose();
            (outer + outer.transpose()) * 0.5 - Matrix3::identity() * p.dot(d)
        };
        let part = |&a: &u32| of(&director(&p(a as usize)), &director(&state[a as usize]));
        let sum: Matrix3<f64> = self.particles.iter().map(part).sum();
        let Some(body) = &self.body else { return sum };
        let pole = self.pole(state);
        let arm = |&a: &u32| of(&place(&p(a as usize)), &(place(&state[a as usize]) - pole));
        let whole =
            sum + self.particles.iter().map(arm).sum::<Matrix3<f64>>() + body.load_block(&self.triad(state));
        self.lever(state).map_or(whole, |lever| {
            let force = self.particles.iter().map(|&a| place(&p(a as usize))).sum::<Vec3>() - body.load[0];
            whole - of(&(lever.held * force), &lever.arm)
        })
    }
}

impl<S: DerefMut<Target = Shell>> StaticShell<S> {
    /// Adds the loads on rigid bodies, as last evaluated, along the unknowns.
    pub(crate) fn add_body_loads(&self, out: &mut [f64]) {
        for group in self.shell.dependents.junctions.groups.iter().filter(|group| group.body.is_some()) {
            let a = group.first();
            let load =
                group.along_unknowns(&self.shell.motion.state, self.shell.dependents.junctions.body_load(a));
            let present = self.basis(a);
            let basis = self.carried.get(a).unwrap_or(&present);
            let mut own = [0.0; 6];
            basis.project(&load, &mut own[..basis.count]);
            out[self.dofs.of(a)].iter_mut().zip(own).for_each(|(sum, part)| *sum += part);
        }
    }
}
