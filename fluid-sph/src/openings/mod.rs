//! Openings: particles that come into a fluid and go out of it.
//!
//! # What is given, and what comes from inside
//!
//! Small disturbances of a slightly compressible flow u along n, into the fluid, go along characteristics:
//!
//! ```text
//! P + ρc u·n   goes in with u·n + c      P − ρc u·n   comes out with u·n − c      what the water carries goes with u·n
//! ```
//!
//! Flows are slower than sound: one of the first two comes in and the other out at any opening. So one number is given of pressure and
//! velocity across, and the other taken from inside \[lastiwka2009\]; a given velocity sends sound back as a wall does, a given pressure as a
//! free surface does. Waves on the surface have the same with √(gh) for c: in slower flow either velocity or level is given, in faster flow both where it comes in
//! and none where it goes out.
//!
//! # The zone
//!
//! Behind an opening points fill a zone as wide as the kernel reaches \[lastiwka2009, federico2012, tafuni2018\]. They are points of the boundary, with pressures that
//! are carried there from the fluid by gravity, as those of walls \[adami2012\], unless a pressure is given; so their forces are opposite to those on the
//! fluid, and their work is in the balance. A point that comes through the opening becomes a particle where it stands, and a particle that goes through
//! it a point: no place changes. Points are fed at the outer end in rows of the lattice that the fluid has at the start, a spacing apart, and end where they leave the
//! zone. With a given velocity and no level rows are fed up to where the water beside stands, by the number of its particles.
//!
//! # Room
//!
//! Numbers of particles are lent: who goes out leaves its number to who comes in, the lowest first. A fluid has room for as many as is asked for; no step
//! allocates, and one that has no room ends the run (src/time/bounds.rs). What comes and goes has its energy with it, which is work from outside.

mod exchange;
mod opening;
pub(crate) mod zone;

pub use opening::{Given, Opening};

use sph_core::Vec3;

use crate::liquid::Liquid;
use crate::openings::zone::Zone;

/// Openings of a fluid, and who is in the flow.
#[derive(Clone, Debug)]
pub(crate) struct Openings {
    pub zones: Vec<Zone>,
    /// By particle: whether it is in the flow.
    pub here: Vec<bool>,
    /// By point of the boundary: whether it is in a zone, or of a wall.
    pub near: Vec<bool>,
    /// By particle: where it was when it came in \[L\].
    pub since: Vec<Vec3>,
    /// Whether one found no room.
    pub full: bool,
}

impl Openings {
    /// The numbers that change: who is in the flow, where they came in, what rows have gone, velocities and counts.
    pub fn state(&self) -> Vec<f64> {
        let flags = self.here.iter().chain(&self.near).map(|&flag| f64::from(u8::from(flag)));
        let since = self.since.iter().flat_map(|at| [at.x, at.y, at.z]);
        let of = |zone: &Zone| {
            let rows = zone.rows.iter().map(|row| row.gone);
            let numbers = [zone.velocity, zone.fed, zone.mean, zone.asked, zone.asked_mean];
            let own = numbers.into_iter().chain([zone.came as f64, zone.went as f64]);
            rows.chain(own).collect::<Vec<f64>>()
        };
        flags.chain(since).chain(self.zones.iter().flat_map(of)).collect()
    }

    /// Puts the numbers of [`Openings::state`] back, which are as many.
    pub fn set_state(&mut self, numbers: &[f64]) {
        let mut next = numbers.iter().copied();
        let mut number = || next.next().unwrap_or(0.0);
        self.here.iter_mut().chain(&mut self.near).for_each(|flag| *flag = number() != 0.0);
        self.since.iter_mut().for_each(|at| *at = Vec3::from([(); 3].map(|()| number())));
        for zone in &mut self.zones {
            zone.rows.iter_mut().for_each(|row| row.gone = number());
            (zone.velocity, zone.fed, zone.mean) = (number(), number(), number());
            (zone.asked, zone.asked_mean) = (number(), number());
            (zone.came, zone.went) = (number() as u64, number() as u64);
        }
        self.full = false;
    }

    /// Energy of a unit of mass of what comes in \[L²/T²\].
    fn energy(liquid: &Liquid, velocity: &Vec3, density: f64) -> f64 {
        0.5 * velocity.norm_squared() + liquid.compression(density)
    }
}
