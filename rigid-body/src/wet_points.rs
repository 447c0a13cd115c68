//! Points behind the faces of a body that a fluid wets, and what the fluid puts on them.
//!
//! The points go with the body, `x = p + Q A`. The load stays as it is for a step of the fluid while the arms turn, so that of the points two sums are
//! enough:
//!
//! ```text
//! Σ f        Σ f aᵀ = (Σ f Aᵀ) Qᵀ, whose skew part is the moment Σ a × f
//! ```
//!
//! Where the body takes several steps in one of the fluid, points next to a face that bear a load resist what they move, along the direction n of that load,
//! beyond what the fluid saw: `f = −ρ₀c₀A [(v − v_seen)·n] n`, the pressure of a plane wave.

use explicit_dynamics::{BoundaryLayout, BoundaryLoad};
use nalgebra::Matrix3;
use sph_core::Vec3;

use crate::conditions::Wrench;

/// Points behind the faces of a body at rest, each a particle of a wall of the fluid.
#[derive(Clone, Debug)]
pub struct WetPoints {
    /// Where they are \[L\]; in a plane problem at the third coordinate of the centre of mass.
    pub points: Vec<Vec3>,
    /// By point: whether it stands next to a face.
    pub first: Vec<bool>,
    /// Area of faces that one of those stands for \[L²; L in a plane problem\].
    pub area: f64,
    /// Width of the body across a plane problem \[L\].
    pub width: Option<f64>,
    /// ρ₀c₀ of the fluid, by which steps of the body are bounded \[F T/L³\].
    pub impedance: f64,
}

/// A point that resists while a step of the fluid lasts.
#[derive(Clone, Copy, Debug)]
struct Resisting {
    point: usize,
    /// ρ₀c₀A \[F T/L\].
    resistance: f64,
    /// Direction of the load.
    along: Vec3,
    /// Velocity along it with which the fluid saw the point \[L/T\].
    seen: f64,
}

/// How a body moves at present.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Moving {
    /// Principal axes as columns.
    pub axes: Matrix3<f64>,
    /// Velocity of the centre \[L/T\].
    pub velocity: Vec3,
    /// Spin \[1/T\].
    pub spin: Vec3,
}

/// The wet surface of a body.
#[derive(Clone, Debug)]
pub(crate) struct Surface {
    pub layout: BoundaryLayout,
    /// Arms from the centre in principal axes \[L\].
    pub arms: Vec<Vec3>,
    first: Vec<bool>,
    width: Option<f64>,
    /// ρ₀c₀A of a point next to a face \[F T/L\].
    resistance: f64,
    /// Load of the fluid: Σ f \[F\] and Σ f Aᵀ \[F L\].
    force: Vec3,
    spread: Matrix3<f64>,
    resisting: Vec<Resisting>,
}

impl Surface {
    /// The points about a centre, in principal axes that are the columns of a matrix.
    pub fn new(points: &WetPoints, centre: &Vec3, axes: &Matrix3<f64>) -> Self {
        let WetPoints { points, first, area, width, impedance } = points;
        Self {
            layout: BoundaryLayout { points: points.len(), areas: vec![*area; points.len()], thin: None },
            arms: points.iter().map(|x| axes.tr_mul(&(x - centre))).collect(),
            first: first.clone(),
            width: *width,
            resistance: impedance * area * width.unwrap_or(1.0),
            force: Vec3::zeros(),
            spread: Matrix3::zeros(),
            resisting: Vec::new(),
        }
    }

    /// Takes up a load.
    pub fn take(&mut self, load: &BoundaryLoad<'_>) {
        self.force = Vec3::zeros();
        self.spread = Matrix3::zeros();
        self.resisting.clear();
        for (force, arm) in load.forces.iter().zip(&self.arms) {
            let force = self.whole(force);
            self.force += force;
            self.spread += force * arm.transpose();
        }
        if load.impedance == 0.0 {
            return;
        }
        let resistance = load.impedance * self.width.unwrap_or(1.0);
        for (point, found) in load.found.iter().enumerate().filter(|(point, _)| self.first[*point]) {
            let Some(along) = self.whole(found).try_normalize(0.0) else { continue };
            let seen = Vec3::from(load.seen[point]).dot(&along);
            let resistance = resistance * self.layout.areas[point];
            self.resisting.push(Resisting { point, resistance, along, seen });
        }
    }

    /// What the fluid exerts on a body that moves so, and `Σ f aᵀ` of it.
    pub fn push(&self, moving: &Moving) -> (Wrench, Matrix3<f64>) {
        let mut lever = self.spread * moving.axes.transpose();
        let moment = |i: usize, j: usize, lever: &Matrix3<f64>| lever[(i, j)] - lever[(j, i)];
        let moment = Vec3::new(moment(2, 1, &lever), moment(0, 2, &lever), moment(1, 0, &lever));
        let mut wrench = Wrench { force: self.force, moment };
        for (point, force) in self.resistances(moving) {
            let arm = moving.axes * self.arms[point];
            wrench.add(&force, &arm);
            lever += force * arm.transpose();
        }
        (wrench, lever)
    }

    /// Adds to the impulses of the points what they resist over a span \[T\] \[F T; F T/L in a plane problem\].
    pub fn add_impulses(&self, moving: &Moving, span: f64, impulses: &mut [[f64; 3]]) {
        let part = span / self.width.unwrap_or(1.0);
        for (point, force) in self.resistances(moving) {
            (0..3).for_each(|k| impulses[point][k] += part * force[k]);
        }
    }

    /// Arms of the points next to a face, and ρ₀c₀A of each \[F T/L\].
    pub fn at_faces(&self) -> (Vec<Vec3>, f64) {
        let arms = self.arms.iter().zip(&self.first).filter(|(_, first)| **first);
        (arms.map(|(arm, _)| *arm).collect(), self.resistance)
    }

    /// Points that resist, with their forces.
    fn resistances<'a>(&'a self, moving: &'a Moving) -> impl Iterator<Item = (usize, Vec3)> + 'a {
        self.resisting.iter().map(move |&Resisting { point, resistance, along, seen }| {
            let velocity = moving.velocity + moving.spin.cross(&(moving.axes * self.arms[point]));
            (point, along * (-resistance * (velocity.dot(&along) - seen)))
        })
    }

    /// A force on all of the width of the body \[F\].
    fn whole(&self, force: &[f64; 3]) -> Vec3 {
        match self.width {
            Some(width) => Vec3::new(width * force[0], width * force[1], 0.0),
            None => (*force).into(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use sph_core::rotated;

    /// A load on points of a turned body: its moment is that of the forces at their arms, of the spread of them to rounding.
    #[test]
    fn the_moment_is_that_of_the_forces_at_their_arms_however_the_body_turned() {
        let axes = |theta: Vec3| {
            Matrix3::from_columns(&[Vec3::x(), Vec3::y(), Vec3::z()].map(|e| rotated(&e, &theta)))
        };
        let (rest, centre) = (axes(Vec3::new(0.2, 0.5, -0.4)), Vec3::new(1.0, -2.0, 0.5));
        let points: Vec<Vec3> =
            (0..7).map(|i| Vec3::new(f64::from(i % 3), f64::from(i / 2), 0.3 * f64::from(i))).collect();
        let first = (0..7).map(|i| i % 2 == 0).collect();
        let points = WetPoints { points, first, area: 0.25, width: None, impedance: 3.0 };
        let mut surface = Surface::new(&points, &centre, &rest);
        let forces: Vec<[f64; 3]> =
            (0..7).map(|i| [1.0 - f64::from(i), 0.5 * f64::from(i), f64::from(i * i) - 9.0]).collect();
        let seen = vec![[0.1, -0.2, 0.3]; 7];
        let load = BoundaryLoad { forces: &forces, found: &forces, seen: &seen, impedance: 3.0 };
        surface.take(&load);
        let turned = axes(Vec3::new(-1.0, 0.3, 0.8)) * rest;
        let still = Moving { axes: turned, velocity: Vec3::zeros(), spin: Vec3::zeros() };
        let moving = Moving { velocity: Vec3::new(2.0, 0.0, -1.0), spin: Vec3::new(0.0, 3.0, 1.0), ..still };
        for moving in [still, moving] {
            let mut impulses = forces.clone();
            surface.add_impulses(&moving, 1.0, &mut impulses);
            let (found, lever) = surface.push(&moving);
            let mut exact = Wrench::default();
            for (force, arm) in impulses.iter().zip(&surface.arms) {
                exact.add(&Vec3::from(*force), &(turned * arm));
            }
            let size = exact.force.norm() + exact.moment.norm();
            assert!((found.force - exact.force).norm() < 1e-14 * size);
            assert!((found.moment - exact.moment).norm() < 1e-14 * size);
            assert!((lever[(2, 1)] - lever[(1, 2)] - found.moment.x).abs() < 1e-13 * size);
        }
        // Points behind the first row, and all of them where the fluid asks for none, resist nothing.
        let resisting: Vec<usize> = surface.resistances(&moving).map(|(point, _)| point).collect();
        assert_eq!(resisting, [0, 2, 4, 6]);
        surface.take(&BoundaryLoad { impedance: 0.0, ..load });
        assert_eq!(surface.resistances(&moving).count(), 0);
    }
}
