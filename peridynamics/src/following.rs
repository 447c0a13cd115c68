//! A pressure that stays normal to the surface of a body as that deforms.
//!
//! Nodes carry the vertices of the surface ([`Carried`]). A triangle with the present edges e₁, e₂ bears `−p ½ e₁ × e₂`, a third of it at each corner: on a
//! closed surface that is `p ∂V/∂x` of the volume V under the triangles, so that its resultant and its moment vanish to rounding and its work is `p ΔV`.

use explicit_dynamics::{Amplitude, Instant};
use sph_core::{Carried, Vec3};

use crate::bonds::network::Row;

/// A pressure that follows a surface.
#[derive(Clone, Debug)]
pub struct FollowingPressure {
    /// What it presses on.
    pub surface: Carried,
    /// The pressure at level one and amplitude one, against the outward normal \[F/L²\].
    pub pressure: f64,
    /// Its course in time.
    pub amplitude: Amplitude,
}

impl FollowingPressure {
    /// Adds its forces on nodes at an instant \[F\].
    pub(crate) fn add(&self, at: Instant, rows: &[Row], out: &mut [Vec3]) {
        let surface = &self.surface;
        let sixth = -self.pressure * at.level * self.amplitude.value(at.time) / 6.0;
        let place = |[x, y, z, _]: Row| Vec3::new(x, y, z);
        let places = surface.places(|node| place(rows[node as usize]));
        let mut forces = vec![Vec3::zeros(); places.len()];
        for corners in &surface.triangles {
            let [a, b, c] = corners.map(|corner| places[corner as usize]);
            let force = (b - a).cross(&(c - a)) * sixth;
            corners.iter().for_each(|&corner| forces[corner as usize] += force);
        }
        for (vertex, force) in forces.iter().enumerate().filter(|(_, force)| **force != Vec3::zeros()) {
            for &(node, weight) in surface.bearers(vertex) {
                out[node as usize] += force * weight;
            }
        }
    }
}
