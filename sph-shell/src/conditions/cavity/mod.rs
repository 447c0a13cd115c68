//! A gas or a liquid enclosed by cells: one pressure that depends on the whole volume, and follows the motion.
//!
//! ```text
//! f = p(V) g      g = ∂V/∂x      −∂f/∂x = −p ∂g/∂x − p′ g gᵀ
//! ```
//!
//! The first part of the stiffness lies in the cells; the second, positive since pressure falls with the volume, couples all that encloses it
//! ([`implicit_statics::RankOne`]). Forces are the gradient of a potential, so that the tangent is symmetric \[schweizerhof1984\].

mod content;
mod rim;
mod volume;

use std::sync::{Mutex, OnceLock, PoisonError};

use sph_core::{Cell, Vec3};

pub use content::{Content, Volumes};

use crate::conditions::body::{Block, Body, place_block};
use crate::conditions::constraints::Constraints;
use crate::error::EnclosedError;
use crate::packs::Row;
use crate::reference::Reference;
use rim::{RimEnd, closing, rims};
use volume::{Field, area_changes, areas};

/// A pressure this far below zero, over the greatest, is rounding.
const ROUNDING: f64 = 1e-6;
/// A volume below this share of the area to the power of three halves is rounding.
const FLAT: f64 = 1e-9;

/// What some cells enclose.
///
/// A surface that is not closed is closed over its rims, which must be held, or slide in planes that have a point in common, or in parallel
/// ones. Normals may point out of it or into it.
pub struct Enclosed {
    cells: Vec<u32>,
    content: Content,
    beside: f64,
    closed: OnceLock<Closed>,
    kept: Mutex<Kept>,
}

/// How the surface bounds a volume.
struct Closed {
    field: Field,
    /// One where normals point out of it, less one where they point into it.
    sign: f64,
    /// Volume at rest, with what stands beside \[L³\].
    rest: f64,
    /// The particles of the cells, ascending.
    particles: Vec<u32>,
}

/// What was last evaluated.
#[derive(Clone, Copy, Default)]
struct Kept {
    /// Pressure \[F/L²\].
    pressure: f64,
    /// Volume \[L³\].
    volume: f64,
    /// The volume to the first order of the last correction, for the stiffness.
    predicted: Option<f64>,
    /// Least pressure, and greatest magnitude, of the states that were kept \[F/L²\].
    extremes: [f64; 2],
}

impl Enclosed {
    /// A content enclosed by cells, each once, and by a volume of its own beside them, such as a tank that does not give \[L³\].
    pub fn new(cells: Vec<u32>, content: Content, beside: f64) -> Self {
        Self { cells, content, beside, closed: OnceLock::new(), kept: Mutex::default() }
    }

    /// Finds how its rims are closed and the volume at rest; of the load of a number, for messages.
    ///
    /// # Errors
    /// [`EnclosedError`]: cells that are no surface, a rim that is free to move, no volume.
    pub(crate) fn close(
        &self,
        load: usize,
        reference: &Reference,
        constraints: &Constraints,
    ) -> Result<(), EnclosedError> {
        let cloud = &reference.cloud;
        let mut stands_for: Vec<u32> = (0..cloud.len() as u32).collect();
        for group in &cloud.joined {
            group.iter().for_each(|&a| stands_for[a as usize] = group[0]);
        }
        let place = |a: u32| cloud.positions[a as usize];
        let end = |a: u32, edge: Vec3| {
            let held = constraints.of(a as usize).filter(|held| held.motion.is_none());
            let free = [Vec3::x(), Vec3::y(), Vec3::z()]
                .map(|axis| held.map_or(axis, |held| Vec3::from(held.held.free_part(axis.into()))));
            let held = held.map_or(Vec::new(), |held| held.held.basis().to_vec());
            RimEnd { particle: a, place: place(a), edge, free, held }
        };
        let edges = rims(self.own(reference), |a| stands_for[a as usize])
            .map_err(|particle| EnclosedError::NoSurface { load, particle })?;
        let ends: Vec<RimEnd> = edges
            .iter()
            .flat_map(|&[a, b]| [end(a, place(b) - place(a)), end(b, place(a) - place(b))])
            .collect();
        let corners = || self.own(reference).flat_map(|cell| cell.particles()).copied();
        let of: Vec<u32> = if ends.is_empty() { corners().collect() } else { edges.concat() };
        let middle = of.iter().map(|&a| place(a)).sum::<Vec3>() / of.len() as f64;
        let field = closing(middle, &ends).map_err(|particle| EnclosedError::OpenRim { load, particle })?;
        let volume: f64 = self.own(reference).map(|cell| field.volume(cell, place)).sum();
        let area: f64 = self.own(reference).map(|cell| cell.geometry(&cloud.positions).area).sum();
        let rounding = FLAT * area * area.sqrt();
        let sign = if volume < -rounding { -1.0 } else { 1.0 };
        let rest = sign * volume + self.beside;
        if rest.is_nan() || rest <= rounding {
            return Err(EnclosedError::NoVolume { load, volume: sign * volume, beside: self.beside });
        }
        *self.kept() = Kept { volume: rest, ..Kept::default() };
        let mut particles: Vec<u32> = corners().collect();
        particles.sort_unstable();
        particles.dedup();
        self.closed.get_or_init(|| Closed { field, sign, rest, particles });
        Ok(())
    }

    fn own<'a>(&'a self, reference: &'a Reference) -> impl Iterator<Item = &'a Cell> {
        self.cells.iter().map(|&cell| &reference.cloud.cells[cell as usize])
    }

    fn closed(&self) -> &Closed {
        self.closed.get().expect("closed when the shell was built")
    }

    fn kept(&self) -> std::sync::MutexGuard<'_, Kept> {
        self.kept.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Its volumes in a state.
    pub(crate) fn volumes(&self, body: &Body<'_>) -> Volumes {
        let Closed { field, sign, rest, .. } = self.closed();
        let place = |a: u32| position(&body.state[a as usize]);
        let flux: f64 = self.own(body.reference).map(|cell| field.volume(cell, place)).sum();
        Volumes { now: sign * flux + self.beside, rest: *rest }
    }

    /// Adds a pressure times the gradient of the volume to rows of all particles.
    pub(crate) fn press(&self, pressure: f64, body: &Body<'_>, rows: &mut [Row]) {
        let sign = self.closed().sign;
        let place = |a: u32| position(&body.state[a as usize]);
        for cell in self.own(body.reference) {
            for (&corner, part) in cell.particles().iter().zip(&areas(cell, place)) {
                for k in 0..3 {
                    rows[corner as usize][k] += sign * pressure * part[k];
                }
            }
        }
    }

    /// Adds what it exerts at a share, and keeps pressure and volume.
    pub(crate) fn exert(&self, share: f64, body: &Body<'_>, forces: &mut [Row]) {
        let volumes = self.volumes(body);
        let [pressure, _] = self.content.pressure(share, volumes);
        {
            let mut kept = self.kept();
            (kept.pressure, kept.volume) = (pressure, volumes.now);
        }
        self.press(pressure, body, forces);
    }

    /// The part of its stiffness that lies in the cells, at a share.
    pub(crate) fn stiffness_in_cells(
        &self,
        share: f64,
        body: &Body<'_>,
        put: &mut dyn FnMut(u32, u32, &Block),
    ) {
        let [pressure, _] = self.content.pressure(share, self.for_stiffness(body));
        let sign = self.closed().sign;
        let place = |a: u32| position(&body.state[a as usize]);
        for cell in self.own(body.reference) {
            for (&pushed, row) in cell.particles().iter().zip(&area_changes(cell, place)) {
                for (&moved, block) in cell.particles().iter().zip(row) {
                    put(pushed, moved, &place_block(0, 0, &(block * (sign * pressure))));
                }
            }
        }
    }

    /// Its cells, by number.
    pub(crate) fn cells(&self) -> &[u32] {
        &self.cells
    }

    /// Adds what a unit of its share adds to the forces.
    pub(crate) fn add_rate(&self, rate: f64, body: &Body<'_>, forces: &mut [Row]) {
        self.press(rate * self.content.rate(self.volumes(body)), body, forces);
    }

    /// The volumes by which the stiffness goes: to the first order of the last correction, if that was kept.
    ///
    /// What a stiff liquid makes of the volume's second order is no pressure that it has: a step by the stiffness with that of the first order is
    /// a step of the equations with the pressure as one more unknown.
    fn for_stiffness(&self, body: &Body<'_>) -> Volumes {
        let volumes = self.volumes(body);
        Volumes { now: self.kept().predicted.unwrap_or(volumes.now), ..volumes }
    }

    /// `−p′`, and the gradient by rows of all particles.
    pub(crate) fn beside_pattern(&self, share: f64, body: &Body<'_>) -> (f64, Vec<Row>) {
        let factor = -self.content.pressure(share, self.for_stiffness(body))[1];
        let mut rows = vec![[0.0; 6]; body.state.len()];
        self.press(1.0, body, &mut rows);
        (factor, rows)
    }

    /// The steepest that `−p′` may be at any share, and the gradient by rows of all particles.
    pub(crate) fn steepest(&self, body: &Body<'_>) -> (f64, Vec<Row>) {
        let mut rows = vec![[0.0; 6]; body.state.len()];
        self.press(1.0, body, &mut rows);
        (self.content.stiffness(self.volumes(body)), rows)
    }

    /// Keeps the volume to the first order of a correction, or none.
    pub(crate) fn predict(&self, volume: Option<f64>) {
        self.kept().predicted = volume;
    }

    /// Takes note of the pressure last evaluated, of a state that is kept.
    pub(crate) fn note(&self) {
        let mut kept = self.kept();
        let ([least, greatest], now) = (kept.extremes, kept.pressure);
        kept.extremes = [least.min(now), greatest.max(now.abs())];
    }

    /// Least pressure and greatest magnitude of the states that were kept \[F/L²\].
    pub(crate) fn extremes(&self) -> [f64; 2] {
        self.kept().extremes
    }

    /// Takes up what [`Enclosed::extremes`] gave.
    pub(crate) fn take_up(&self, extremes: [f64; 2]) {
        self.kept().extremes = extremes;
    }

    /// How far the pressure of a liquid fell below that of the surroundings in the states that were kept, and its greatest magnitude; none where it
    /// did not but for rounding \[F/L²\].
    pub(crate) fn pull(&self) -> Option<[f64; 2]> {
        let [least, greatest] = self.kept().extremes;
        let pulls = matches!(self.content, Content::Liquid { .. }) && least < -ROUNDING * greatest;
        pulls.then_some([-least, greatest])
    }

    /// Pressure \[F/L²\] and volume \[L³\] last evaluated.
    pub(crate) fn last(&self) -> [f64; 2] {
        let Kept { pressure, volume, .. } = *self.kept();
        [pressure, volume]
    }

    /// Whether a particle belongs to its cells.
    pub(crate) fn touches(&self, particle: u32) -> bool {
        self.closed().particles.binary_search(&particle).is_ok()
    }
}

fn position(row: &Row) -> Vec3 {
    Vec3::new(row[0], row[1], row[2])
}
