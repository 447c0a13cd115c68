//! A couple on directors: about an axis fixed in space, or about the edge as it moves; with what turns the surface about its normal, drilling.rs.

mod drilling;
mod spin;

use std::ops::Range;

use nalgebra::Matrix3;
use sph_core::Vec3;

use crate::conditions::body::{Block, Body, place_block};
use crate::conditions::loads::{AddLoad, Load, LoadOnShare, check_set};
use crate::error::ShellError;
use crate::reference::Reference;

pub use drilling::DrillingCouple;

/// The axis of a couple.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CoupleAxis {
    /// A direction fixed in space (unit vector).
    Fixed(Vec3),
    /// The edge's own present direction, from its first to its last particle: a material axis.
    Edge,
}

/// A couple on an edge, `τ_a = M (l_a/Σl)(e × d_a)`; its work is `M δθ` for a turn δθ about e. What of it stands along a director is lost: where
/// there is any, take a [`DrillingCouple`].
///
/// Neither axis makes the load conservative out of the plane of bending; in the plane all three
/// readings (fixed, material, conservative) agree.
#[derive(Clone, Debug)]
pub struct EdgeCouple {
    /// Particles with their tributary lengths \[L\] or other shares, about the edge in a row along it.
    pub edge: Vec<(u32, f64)>,
    /// The whole couple \[F L\].
    pub moment: f64,
    /// Its axis.
    pub axis: CoupleAxis,
}

impl EdgeCouple {
    fn axis_at(&self, i: usize, state: &[[f64; 6]]) -> Vec3 {
        match self.axis {
            CoupleAxis::Fixed(axis) => axis,
            CoupleAxis::Edge => self.along(i, state).normalize(),
        }
    }

    /// The particles between which the direction of the edge at its i-th particle is taken, by their place in the row.
    fn ends(&self, i: usize) -> [usize; 2] {
        [i.saturating_sub(1), (i + 1).min(self.edge.len() - 1)]
    }

    fn along(&self, i: usize, state: &[[f64; 6]]) -> Vec3 {
        let [from, to] = self.ends(i).map(|k| {
            let row = &state[self.edge[k].0 as usize];
            Vec3::new(row[0], row[1], row[2])
        });
        to - from
    }

    /// Length of the whole edge.
    fn length(&self) -> f64 {
        self.edge.iter().map(|e| e.1).sum()
    }

    /// Adds the couple of some places in the row, of an edge of this length.
    fn add_of(
        &self,
        places: impl Iterator<Item = usize>,
        length: f64,
        scale: f64,
        body: &Body<'_>,
        forces: &mut [[f64; 6]],
    ) {
        for i in places {
            let (particle, part) = self.edge[i];
            let row = &body.state[particle as usize];
            let director = Vec3::new(row[3], row[4], row[5]);
            let torque = self.axis_at(i, body.state).cross(&director) * (scale * self.moment * part / length);
            for k in 0..3 {
                forces[particle as usize][3 + k] += torque[k];
            }
        }
    }
}

impl Load for EdgeCouple {
    fn add(&self, scale: f64, body: &Body<'_>, forces: &mut [[f64; 6]]) {
        self.add_of(0..self.edge.len(), self.length(), scale, body, forces);
    }

    fn on_share(&self, own: &Range<usize>, _: &Reference) -> Option<LoadOnShare> {
        let is_own = |i: &usize| own.contains(&(self.edge[*i].0 as usize));
        let places: Vec<usize> = (0..self.edge.len()).filter(is_own).collect();
        let ends = places.iter().flat_map(|&i| self.ends(i));
        let reads = ends.map(|i| self.edge[i].0).collect();
        let (couple, length) = (self.clone(), self.length());
        let add: AddLoad = Box::new(move |scale, body, forces| {
            couple.add_of(places.iter().copied(), length, scale, body, forces);
        });
        Some(LoadOnShare { add, reads })
    }

    /// `∂τ/∂d = m [e]×`, and for an axis along the edge, `e = u/|u|`, `∂τ/∂u = −m [d]× (1 − e eᵀ)/|u|`.
    fn stiffness(&self, scale: f64, body: &Body<'_>, put: &mut dyn FnMut(u32, u32, &Block)) {
        let length = self.length();
        for (i, &(particle, part)) in self.edge.iter().enumerate() {
            let moment = scale * self.moment * part / length;
            let axis = self.axis_at(i, body.state);
            put(particle, particle, &place_block(3, 3, &(axis.cross_matrix() * moment)));
            if self.axis == CoupleAxis::Edge {
                let row = &body.state[particle as usize];
                let director = Vec3::new(row[3], row[4], row[5]);
                let across =
                    (Matrix3::identity() - axis * axis.transpose()) / self.along(i, body.state).norm();
                let change = director.cross_matrix() * across * moment;
                let [from, to] = self.ends(i).map(|k| self.edge[k].0);
                put(particle, from, &place_block(3, 0, &change));
                put(particle, to, &place_block(3, 0, &-change));
            }
        }
    }

    fn check(&self, reference: &Reference) -> Result<(), ShellError> {
        check_set("an edge couple", self.edge.iter().map(|e| e.0), reference)?;
        if self.edge.len() < 2 && self.axis == CoupleAxis::Edge {
            return Err(ShellError::NotAnEdge("a couple about the edge"));
        }
        Ok(())
    }
}
