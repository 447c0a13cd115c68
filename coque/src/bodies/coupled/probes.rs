//! Columns of the curve on any of several bodies.

use fluid_sph::Fluid;
use sph_core::Vec3;

use super::layout::{Gauge, Layout};
use crate::bodies::Probe;
use crate::bodies::fluid::sets::{OnWalls, of_fluid, of_walls};
use crate::bodies::fluid::walls::BuiltWalls;
use crate::scene::alone::Owner;
use crate::scene::error::SceneError;
use crate::scene::units::Quantity;
use crate::scene::{Measured, Scene};

/// What columns are found from; gauges are added to the layout.
pub(super) struct Measuring<'a> {
    pub scene: &'a Scene,
    pub fluid: &'a Fluid,
    pub walls: &'a [BuiltWalls<'a>],
    pub layout: &'a mut Layout,
}

/// The columns in the order of the scene; `own` are those that the scenes of the structures alone gave.
pub(super) fn probes(mut of: Measuring<'_>, own: Vec<Vec<Probe>>) -> Result<Vec<Probe>, SceneError> {
    let mut own: Vec<_> = own.into_iter().map(Vec::into_iter).collect();
    let mut all = Vec::new();
    for (i, column) in of.scene.curve.iter().enumerate() {
        let Owner::Of(body, set) = of.scene.owner(&format!("curve[{i}].on"), &column.on)? else { continue };
        let structures = of.layout.structures.len();
        let number = of.layout.names.iter().position(|name| *name == body);
        let contact = column.of.is_of_contact();
        let particles = match number.unwrap_or_default() {
            0 => {
                let alone = of.scene.alone(&body)?;
                of_fluid(&alone, &set, of.fluid.rest(), of.fluid.spacing())?
            }
            number if number <= structures && contact => vec![of.layout.whole(number - 1)],
            number if number <= structures => {
                let first = of.layout.structures[number - 1].start as u32;
                if let Some(mut probe) = own[number - 1].next() {
                    probe.particles.iter_mut().for_each(|particle| *particle += first);
                    all.push(probe);
                }
                continue;
            }
            number => of.on_walls(number - structures - 1, column.of, &body, &set)?,
        };
        let direction = column.direction.map_or_else(Vec3::zeros, |v| Vec3::from(v).normalize());
        let mut probe = Probe::new(&column.name, column.of, particles, direction);
        (probe.take, probe.factor) = (column.taken(), column.factor);
        probe.about = column.about.map_or_else(Vec3::zeros, Vec3::from);
        if of.fluid.dimensions() == 2 {
            probe.quantity = by_depth(probe.quantity);
        }
        all.push(probe);
    }
    Ok(all)
}

impl Measuring<'_> {
    /// Numbers of what is measured on a set of walls: pieces for forces, a gauge at the one point of a set, else particles.
    fn on_walls(
        &mut self,
        walls: usize,
        of: Measured,
        body: &str,
        set: &str,
    ) -> Result<Vec<u32>, SceneError> {
        let alone = self.scene.alone(body)?;
        let first = self.layout.walls[walls].start;
        let OnWalls { particles, pieces, point } =
            of_walls(&alone, set, &self.walls[walls].rows.pieces, self.fluid.spacing())?;
        let place = |&(piece, a): &(usize, usize)| (self.layout.pieces[first + piece].start + a) as u32;
        match (of, point, &particles[..]) {
            (Measured::Force | Measured::Moment, ..) => {
                Ok(pieces.iter().map(|piece| self.layout.piece(first + piece)).collect())
            }
            (Measured::Pressure | Measured::Level, Some(point), &[(piece, a)]) => {
                let beside = point - self.walls[walls].rows.pieces[piece].points[a];
                let number = self.layout.gauge(self.layout.gauges.len());
                self.layout.gauges.push(Gauge { at: (first + piece, a), beside });
                Ok(vec![number])
            }
            _ => Ok(particles.iter().map(place).collect()),
        }
    }
}

/// The unit of a force by depth.
fn by_depth(quantity: Quantity) -> Quantity {
    match quantity {
        Quantity::Force => Quantity::ForcePerLength,
        Quantity::Energy => Quantity::MomentPerLength,
        other => other,
    }
}
