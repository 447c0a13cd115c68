//! Openings of a fluid as it is built, and what has gone through them.

use sph_core::{CellList, Vec3};

use crate::cells::NOWHERE;
use crate::error::FluidError;
use crate::fluid::{CELL, Fluid};
use crate::formulation::{Scheme, WallRule};
use crate::openings::zone::{NEAR, Zone};
use crate::openings::{Given, Opening, Openings};

/// Points that a zone has room for, over those that fill it.
const ROOM: usize = 2;
/// Distance below which points of a zone and of a wall overlap, in spacings.
const OVERLAP: f64 = 0.5;

impl Fluid {
    /// Lets particles go out through openings and points come in, and feeds the zones.
    pub(crate) fn exchange(&mut self) {
        let Self { openings, present, boundary, ledger, liquid, mass, .. } = self;
        let Some(openings) = openings else { return };
        let gained = openings.go_out(present, boundary, liquid) + openings.come_in(present, boundary, liquid);
        ledger.external += *mass * gained;
        openings.feed(present, boundary, liquid);
    }

    /// Moves the points of zones through a step that ends at a time \[T\].
    pub(crate) fn advance_openings(&mut self, time: f64, dt: f64) {
        let Self { openings, boundary, .. } = self;
        let Some(Openings { zones, near, .. }) = openings.as_deref_mut() else { return };
        zones.iter_mut().for_each(|zone| zone.advance(boundary, near, time, dt));
    }
}

impl Fluid {
    /// Opens the fluid, that has just been built, to what comes in and goes out, with room for so many particles.
    ///
    /// # Errors
    /// [`FluidError::Opening`] for openings that are not across an axis or at which no fluid stands, beyond which there is fluid or a wall, and for less
    /// room than there are particles; [`FluidError::NotOpen`] for structures, the predictor and corrector, and walls with densities of
    /// their own.
    pub fn open(&mut self, openings: Vec<Opening>, most: usize) -> Result<(), FluidError> {
        let refusals = [
            (!self.boundary.wet().is_empty(), "a structure in it"),
            (self.formulation.scheme == Scheme::PredictorCorrector, "a predictor and corrector"),
            (self.formulation.walls == WallRule::Dynamic, "walls of the published method"),
        ];
        if let Some((_, what)) = refusals.iter().find(|(refused, _)| *refused) {
            return Err(FluidError::NotOpen(what));
        }
        let count = self.present.positions.len();
        let mut zones = Vec::new();
        for (number, opening) in openings.into_iter().enumerate() {
            let zone = self.zone(opening).map_err(|what| FluidError::Opening { number, what })?;
            zones.push(zone);
        }
        if most < count {
            return Err(FluidError::Opening { number: 0, what: "has less room than there are particles" });
        }
        let mut near = vec![true; self.boundary.points.len()];
        for zone in &mut zones {
            let (into, spacing, columns) = (zone.opening.into, zone.spacing, zone.columns);
            // The first layer of the fluid and the rows, as they stand in the plane of the opening.
            let flat = |x: &Vec3| x - into * x.dot(&into);
            let first = |x: &&Vec3| (0.0..spacing).contains(&zone.distance(x));
            let layer: Vec<Vec3> = self.present.positions.iter().filter(first).map(flat).collect();
            let (layer, mut found) = (CellList::new(&layer, spacing), Vec::new());
            let base = zone.rows.iter().filter(|row| {
                layer.within(&flat(&row.place), NEAR * spacing, &mut found);
                !found.is_empty()
            });
            let filled = base.flat_map(|row| {
                (0..columns).map(move |k| row.place + into * (row.gone + k as f64 * spacing))
            });
            let filled: Vec<Vec3> = filled.collect();
            let room = ROOM * (zone.columns + 1) * zone.rows.len();
            zone.points = self.boundary.add(room, zone.aside(), self.liquid.density);
            near.resize(self.boundary.points.len(), false);
            for (point, at) in zone.points.clone().zip(filled) {
                near[point] = true;
                self.boundary.points[point] = at;
                let velocity = zone.velocity_at(zone.up.dot(&at));
                self.boundary.velocities[point] = into * velocity;
            }
        }
        let aside = zones.first().map_or_else(Vec3::zeros, Zone::aside);
        let here = (0..most).map(|i| i < count).collect();
        for list in [&mut self.rest, &mut self.present.positions] {
            list.resize(most, aside);
        }
        self.present.velocities.resize(most, Vec3::zeros());
        self.present.densities.resize(most, self.liquid.density);
        if let Some(periodic) = &mut self.periodic {
            periodic.gone.resize(most, [0.0; 3]);
        }
        let since = self.rest.clone();
        self.openings = Some(Box::new(Openings { zones, here, near, since, full: false }));
        self.make_room(most);
        self.fresh = false;
        self.sort(0.0, 0.0);
        self.check_zones()
    }

    /// The zone of an opening, or what is wrong with it.
    fn zone(&self, opening: Opening) -> Result<Zone, &'static str> {
        let into = opening.into;
        let axis = into.iamax();
        let along = Vec3::ith(axis, into[axis].signum());
        if into != along || axis >= self.dimensions {
            return Err("is not across an axis of the fluid; give a unit vector along one");
        }
        if self.periods().is_some_and(|periods| periods.lengths[axis] != 0.0) {
            return Err(
                "lies across an axis along which the fluid goes round; take the axis out of the periodic sides",
            );
        }
        if !opening.at.iter().all(|x| x.is_finite()) {
            return Err("has a place that is no number; give three");
        }
        let (up, gravity) = (self.up(), self.gravity_across());
        let strength = gravity.norm();
        let along = if gravity.dot(&into).abs() < NEAR * strength { strength } else { 0.0 };
        let columns = libm::ceil(CELL * self.momentum.kernel.reach() / self.spacing) as usize;
        let mut zone = Zone::new(opening, &self.present.positions, self.spacing, columns, up, along);
        if zone.rows.is_empty() {
            return Err("has no fluid within a spacing inside at the start; put it at a face of the fluid");
        }
        if let Given::Velocity { course, .. } = &zone.opening.given {
            zone.velocity = course.value(0.0);
        }
        let inside = |at: &Vec3| (0.0..self.spacing).contains(&zone.distance(at)) && zone.holds(at);
        let present = self.present.positions.iter().zip(&self.present.velocities);
        let beside = present.filter(|(at, _)| inside(at)).map(|(_, velocity)| velocity.dot(&into));
        let (sum, count) = beside.fold((0.0, 0.0), |(sum, count), own| (sum + own, count + 1.0));
        // The wave that it makes begins with the fluid as it is.
        zone.asked = sum / f64::max(count, 1.0);
        zone.asked_mean = zone.asked;
        if along > 0.0 && zone.fed <= 0.0 {
            return Err("has a level below the fluid there; raise it");
        }
        let outside = |x: &Vec3| (-zone.depth()..0.0).contains(&zone.distance(x)) && zone.holds(x);
        if self.present.positions.iter().any(outside) {
            return Err("has fluid outside; end the fluid there, or turn its direction round");
        }
        Ok(zone)
    }

    /// Makes room for so many particles, so that no step needs more.
    fn make_room(&mut self, most: usize) {
        let Self { sorted, accelerations, powers, rates, boundary, .. } = self;
        accelerations.reserve(most);
        powers.reserve(most);
        rates.reserve(most);
        sorted.reserve(most);
        let points = boundary.points.len();
        boundary.means.reserve(points);
        boundary.accelerations.reserve(points);
        boundary.powers.reserve(points);
        boundary.rates.reserve(points);
        boundary.sorted.reserve(points);
    }

    /// Refuses walls that stand in a zone.
    fn check_zones(&self) -> Result<(), FluidError> {
        let Some(openings) = &self.openings else { return Ok(()) };
        let (boundary, sorted) = (&self.boundary, &self.boundary.sorted);
        for (number, zone) in openings.zones.iter().enumerate() {
            for point in zone.points.clone().filter(|&point| openings.near[point]) {
                let at = boundary.points[point];
                let cell = self.grid.cell(&at.into());
                if cell == NOWHERE {
                    continue;
                }
                let beside = self.grid.beside(cell, &sorted.starts);
                let others =
                    beside.filled().iter().flat_map(|&(from, to)| &sorted.order[from as usize..to as usize]);
                let overlaps = |&&other: &&u32| {
                    let other = boundary.copies.source(other as usize);
                    other != point && (boundary.points[other] - at).norm() < OVERLAP * self.spacing
                };
                if others.into_iter().any(|other| overlaps(&other)) {
                    let what = "has a wall beyond it; open the wall there, its particles stand where water is to come or go";
                    return Err(FluidError::Opening { number, what });
                }
            }
        }
        Ok(())
    }

    /// Particles in the flow: all, unless some may come and go.
    pub fn held(&self) -> usize {
        let here = |openings: &Openings| openings.here.iter().filter(|here| **here).count();
        self.openings.as_deref().map_or(self.len(), here)
    }

    /// Whether a particle is in the flow.
    pub fn is_here(&self, particle: usize) -> bool {
        self.openings.as_deref().is_none_or(|openings| openings.here[particle])
    }

    /// By opening: how many particles have come in and gone out.
    pub fn passed(&self) -> Vec<[u64; 2]> {
        let zones = self.openings.iter().flat_map(|openings| &openings.zones);
        zones.map(|zone| [zone.came, zone.went]).collect()
    }
}
