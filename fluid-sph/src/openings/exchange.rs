//! Who comes in and who goes out in a step, and what points of the zones feel of the fluid.

use std::ops::Range;

use sph_core::Vec3;

use crate::boundary::points::Boundary;
use crate::cells::NOWHERE;
use crate::liquid::Liquid;
use crate::openings::Openings;
use crate::openings::opening::Given;
use crate::openings::zone::NEAR;
use crate::state::State;

/// The first of what is left of a range that is free, which takes it and those before out of it.
fn free(taken: &[bool], range: &mut Range<usize>) -> Option<usize> {
    range.find(|&number| !taken[number])
}

impl Openings {
    /// Particles behind an opening become points of its zone; the energy of a unit of mass that the fluid gains \[L²/T²\].
    pub fn go_out(&mut self, present: &mut State, boundary: &mut Boundary, liquid: &Liquid) -> f64 {
        let mut gained = 0.0;
        for zone in &mut self.zones {
            let (depth, mut room) = (zone.depth(), zone.points.clone());
            for i in 0..self.here.len() {
                let at = present.positions[i];
                let distance = zone.distance(&at);
                if !(self.here[i] && distance < 0.0 && distance >= -depth && zone.holds(&at)) {
                    continue;
                }
                let (velocity, density) = (present.velocities[i], present.densities[i]);
                gained -= Self::energy(liquid, &velocity, density);
                zone.went += 1;
                if let Some(point) = free(&self.near, &mut room) {
                    self.near[point] = true;
                    boundary.points[point] = at;
                    boundary.densities[point] = density;
                    boundary.velocities[point] = match zone.opening.given {
                        Given::Velocity { .. } => zone.opening.into * zone.velocity_at(zone.up.dot(&at)),
                        _ => zone.opening.into * velocity.dot(&zone.opening.into),
                    };
                }
                self.here[i] = false;
                present.positions[i] = zone.aside();
                present.velocities[i] = Vec3::zeros();
                present.densities[i] = liquid.density;
            }
        }
        gained
    }

    /// Points within an opening become particles, and those beyond the outer end of a zone leave it; the energy of a unit of mass that the
    /// fluid gains \[L²/T²\].
    pub fn come_in(&mut self, present: &mut State, boundary: &mut Boundary, liquid: &Liquid) -> f64 {
        let (mut gained, mut room) = (0.0, 0..self.here.len());
        for zone in &mut self.zones {
            let end = -zone.depth() - NEAR * zone.spacing;
            for point in zone.points.clone() {
                let at = boundary.points[point];
                let distance = zone.distance(&at);
                if !self.near[point] || (end..0.0).contains(&distance) {
                    continue;
                }
                if distance >= 0.0 {
                    let Some(i) = free(&self.here, &mut room) else {
                        self.full = true;
                        continue;
                    };
                    self.here[i] = true;
                    self.since[i] = at;
                    present.positions[i] = at;
                    present.velocities[i] = boundary.velocities[point];
                    present.densities[i] = boundary.densities[point];
                    gained += Self::energy(liquid, &present.velocities[i], present.densities[i]);
                    zone.came += 1;
                }
                self.near[point] = false;
                boundary.points[point] = zone.aside();
                boundary.velocities[point] = Vec3::zeros();
                boundary.densities[point] = liquid.density;
                boundary.ledger.owed[point] = 0.0;
            }
        }
        gained
    }

    /// Puts the next point of every row that has gone a spacing to the outer end of its zone.
    pub fn feed(&mut self, present: &State, boundary: &mut Boundary, liquid: &Liquid) {
        for zone in &mut self.zones {
            if zone.follows() {
                let all = present.positions.iter().zip(&self.here);
                zone.count = all.filter(|(at, here)| **here && zone.counts(at)).count();
            }
            let (apart, mut room) = (zone.apart(), zone.points.clone());
            for number in 0..zone.rows.len() {
                while zone.rows[number].gone >= apart {
                    zone.rows[number].gone -= apart;
                    let (row, height) = (zone.rows[number], zone.height(number));
                    if !zone.feeds(number) {
                        continue;
                    }
                    let Some(point) = free(&self.near, &mut room) else {
                        self.full = true;
                        continue;
                    };
                    self.near[point] = true;
                    boundary.points[point] =
                        row.place + zone.up * (height - row.height) + zone.opening.into * row.gone;
                    boundary.velocities[point] = zone.opening.into * zone.velocity_at(height);
                    boundary.densities[point] = liquid.density;
                }
            }
        }
    }

    /// Gives the points what the opening says and takes the rest from the fluid, when pressures of boundaries are known; `weight` is ρ₀g \[F/L³\],
    /// `confined` that pressures below zero count.
    pub fn press(&mut self, boundary: &mut Boundary, liquid: &Liquid, weight: f64, confined: bool) {
        for zone in &mut self.zones {
            let into = zone.opening.into;
            let slot = |point: usize, boundary: &Boundary| {
                let slot = boundary.sorted.slots[point];
                (slot != NOWHERE).then_some(slot as usize)
            };
            // How much of what goes out by itself does: with noise in it, each as it goes, more would than the mean, and the zone grow empty.
            let mut part = 1.0;
            if !matches!(zone.opening.given, Given::Velocity { .. }) {
                let (mut flow, mut out, mut weights) = (0.0, 0.0, 0.0);
                for slot in zone.points.clone().filter_map(|point| slot(point, boundary)) {
                    let mean = &boundary.means[slot];
                    let own = Vec3::from(mean.velocity).dot(&into);
                    flow += own;
                    out += own.min(0.0);
                    weights += mean.weight;
                }
                part = if out < 0.0 { (flow.min(0.0) / out).min(1.0) } else { 0.0 };
                zone.velocity = if weights > 0.0 { flow / weights } else { 0.0 };
                if zone.opening.given == Given::Free {
                    zone.velocity = zone.velocity.min(0.0);
                }
            }
            for point in zone.points.clone() {
                let Some(slot) = slot(point, boundary) else { continue };
                let (mean, row) = (&boundary.means[slot], &mut boundary.sorted.rows[slot]);
                match zone.opening.given {
                    Given::Velocity { .. } => {}
                    // Water that comes in has one velocity; what goes out has its own.
                    _ if zone.velocity > 0.0 || mean.weight == 0.0 => {
                        boundary.velocities[point] = into * zone.velocity;
                    }
                    _ => {
                        let own = Vec3::from(mean.velocity).dot(&into) / mean.weight;
                        boundary.velocities[point] = into * (own.min(0.0) * part);
                    }
                }
                if let Given::Pressure { at_level, level } = zone.opening.given {
                    let height = zone.up.dot(&Vec3::from(row.at()));
                    let pressure = at_level + weight * (level - height);
                    let pressure = if confined { pressure } else { pressure.max(0.0) };
                    let density = liquid.density_at(pressure);
                    row.press(density, pressure / (density * density));
                }
                row.set_velocity(boundary.velocities[point].into());
                boundary.densities[point] = row.density();
            }
        }
    }
}
