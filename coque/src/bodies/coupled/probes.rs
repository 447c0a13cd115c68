//! Columns of the curve on any of several bodies.

use fluid_sph::Fluid;
use sph_core::Vec3;

use super::gauges::{Carried, Gauge, section};
use super::layout::Layout;
use crate::bodies::Probe;
use crate::bodies::fluid::sets::{OnWalls, of_fluid, of_walls};
use crate::bodies::fluid::walls::BuiltWalls;
use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::SceneError;
use crate::scene::owner::Owner;
use crate::scene::{Measured, Probe as Column};

/// What columns are found from; gauges are added to the layout.
pub(super) struct Measuring<'a> {
    pub of_fluid: &'a BodyInScene<'a>,
    pub fluid: &'a Fluid,
    pub walls: &'a [BuiltWalls<'a>],
    pub layout: &'a mut Layout,
}

/// The columns in the order of the scene; `own` are those that the scenes of the structures alone gave.
pub(super) fn probes(mut of: Measuring<'_>, own: Vec<Vec<Probe>>) -> Result<Vec<Probe>, SceneError> {
    let mut own: Vec<_> = own.into_iter().map(Vec::into_iter).collect();
    let mut all = Vec::new();
    let scene = of.of_fluid.scene;
    for (i, column) in scene.curve.iter().enumerate() {
        let Owner::Of(body, set) = Owner::of(scene, &format!("curve[{i}].on"), &column.on)? else { continue };
        let structures = of.layout.structures.len();
        let number = of.layout.names.iter().position(|name| *name == body);
        let contact = column.of.is_of_contact();
        let particles = match number.unwrap_or_default() {
            0 => of.on_fluid(column, set)?,
            number if number <= structures && contact => vec![of.layout.whole(number - 1)],
            number if number <= structures => {
                let first = of.layout.structures[number - 1].start as u32;
                if let Some(mut probe) = own[number - 1].next() {
                    probe.particles.iter_mut().for_each(|particle| *particle += first);
                    all.push(probe);
                }
                continue;
            }
            number => of.on_walls(number - structures - 1, column, set)?,
        };
        let direction = column.direction.map_or_else(Vec3::zeros, |v| Vec3::from(v).normalize());
        all.push(Probe::of_column(scene, column, particles, direction));
    }
    Ok(all)
}

impl Measuring<'_> {
    fn gauge(&mut self, gauge: Gauge) -> Vec<u32> {
        let number = self.layout.gauge(self.layout.gauges.len());
        self.layout.gauges.push(gauge);
        vec![number]
    }

    /// Numbers of what is measured on a set of the fluid: a gauge at a point or through a section, else particles.
    fn on_fluid(&mut self, column: &Column, set: &str) -> Result<Vec<u32>, SceneError> {
        if let Some(point) = column.at {
            return Ok(self.gauge(Gauge::InSpace(point.into())));
        }
        let particles = of_fluid(self.of_fluid, set, self.fluid.rest(), self.fluid.spacing())?;
        Ok(match &column.through {
            Some(through) => self.gauge(Gauge::Section(section(through), particles)),
            None => particles,
        })
    }

    /// A point that goes with walls, if they move.
    fn beside(&self, walls: usize, point: Vec3) -> Gauge {
        let BuiltWalls { scene, rows, .. } = &self.walls[walls];
        let first = self.layout.walls[walls].start;
        let particles: Vec<_> = (rows.pieces.iter().enumerate())
            .flat_map(|(piece, of)| of.points.iter().enumerate().map(move |(a, x)| ((first + piece, a), *x)))
            .collect();
        let carried =
            scene.motion.as_ref().and_then(|_| Carried::new(point, &particles, self.fluid.dimensions()));
        carried.map_or(Gauge::InSpace(point), Gauge::OnWalls)
    }

    /// Numbers of what is measured on a set of walls: pieces for forces, a gauge at a point, else particles.
    fn on_walls(&mut self, walls: usize, column: &Column, set: &str) -> Result<Vec<u32>, SceneError> {
        if let Some(point) = column.at {
            let gauge = self.beside(walls, point.into());
            return Ok(self.gauge(gauge));
        }
        let first = self.layout.walls[walls].start;
        let OnWalls { particles, pieces, point } =
            of_walls(self.walls[walls].view, set, &self.walls[walls].rows.pieces, self.fluid.spacing())?;
        let place = |&(piece, a): &(usize, usize)| (self.layout.pieces[first + piece].start + a) as u32;
        match (column.of, point) {
            (Measured::Force | Measured::Moment, _) => {
                Ok(pieces.iter().map(|piece| self.layout.piece(first + piece)).collect())
            }
            (Measured::Pressure | Measured::Level | Measured::WetLength, Some(point)) => {
                let gauge = self.beside(walls, point);
                Ok(self.gauge(gauge))
            }
            _ => Ok(particles.iter().map(place).collect()),
        }
    }
}
