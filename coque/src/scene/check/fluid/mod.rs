//! The checks of a fluid and its walls, their keys relative to where they stand in the scene; here of where it is at the start.

mod conditions;
mod current;
mod openings;
mod periodic;
mod speed;
mod still;
mod walls;
mod waves;

use crate::scene::bounded::Positive;
use crate::scene::error::Verdict;
use crate::scene::fluid::FluidScene;
use crate::scene::fluid::geometry::FluidGeometry;
use crate::scene::scope::Scope;

pub(super) use self::conditions::{check_load_of_fluid, check_unsupported, check_velocity_of_fluid};
pub(super) use self::current::check_current;
pub(super) use self::openings::check_openings;
pub(super) use self::periodic::check_periodic;
pub(super) use self::speed::check_sound_speed;
pub(super) use self::still::check_still;
pub(super) use self::waves::check_waves;

/// Bounds what a scene may allocate: ten million particles take some three gigabytes.
const MOST_PARTICLES: f64 = 1e7;
/// Parts of a spacing by which a length may differ from a whole number of them: rounding of decimal numbers, no more.
const WHOLE: f64 = 1e-3;

impl FluidScene {
    /// Refuses the first of its own keys that is out of bounds.
    pub(super) fn check(&self, s: &Scope<'_>) -> Verdict {
        let (word, spacing) = (self.geometry.word(), self.geometry.spacing());
        let at = |key: &str| format!("geometry.{word}.{key}");
        if let FluidGeometry::Blocks(blocks) = &self.geometry
            && blocks.parts.is_empty()
        {
            let repair = "give at least one { lengths = […], origin = […] }";
            return Err(s.value(&at("parts"), "an empty list", "a list of blocks", repair));
        }
        match self.geometry.rings() {
            Some(rings) => {
                s.sized_all(&at("centre"), &rings.centre)?;
                let outer = if word == "disc" { "radius" } else { "outer" };
                if rings.outer.get() <= rings.inner.get() {
                    let bound = format!("greater than the inner radius {}", rings.inner);
                    return Err(s.value(&at(outer), rings.outer, &bound, "swap the two radii"));
                }
                whole(
                    &at(outer),
                    "the width of the rings",
                    rings.outer.get() - rings.inner.get(),
                    spacing,
                    s,
                )?;
            }
            None => self.check_boxes(spacing, s)?,
        }
        let particles: f64 = self.particles_asked();
        if particles <= MOST_PARTICLES {
            return Ok(());
        }
        let bound = format!("wide enough for at most {MOST_PARTICLES:e} particles");
        let value = format!("one that asks for {particles:.3e} particles");
        Err(s.value(&at("spacing"), value, &bound, "use a wider spacing"))
    }

    fn check_boxes(&self, spacing: f64, s: &Scope<'_>) -> Verdict {
        let dimensions = self.dimensions();
        for (path, lengths, origin) in self.geometry.boxes() {
            if !(2..=3).contains(&lengths.len()) || lengths.len() != dimensions {
                let value = format!("a list of {} numbers", lengths.len());
                let repair = "two lengths make a plane fluid, three one in space; all blocks have as many";
                return Err(s.value(&format!("{path}.lengths"), value, "a list of 2 or 3", repair));
            }
            for (i, &length) in lengths.iter().enumerate() {
                let path = format!("{path}.lengths[{i}]");
                whole(&path, "it", length.get(), spacing, s)?;
            }
            if let Some(origin) = origin {
                s.as_many(&format!("{path}.origin"), origin, dimensions, &format!("{path}.lengths"))?;
            }
        }
        Ok(())
    }

    /// Particles that its geometry asks for.
    pub(crate) fn particles_asked(&self) -> f64 {
        let spacing = self.geometry.spacing();
        match self.geometry.rings() {
            Some(rings) => {
                std::f64::consts::PI * (rings.outer.powi(2) - rings.inner.powi(2)) / spacing.powi(2)
            }
            None => {
                let boxes = self.geometry.boxes();
                let count = |(_, lengths, _): &(String, &[Positive], _)| {
                    lengths.iter().map(|l| l.get() / spacing).product::<f64>()
                };
                boxes.iter().map(count).sum()
            }
        }
    }
}

/// A length that rows of particles fill.
fn whole(path: &str, what: &str, length: f64, spacing: f64, s: &Scope<'_>) -> Verdict {
    let rows = length / spacing;
    let nearest = libm::round(rows);
    if (rows - nearest).abs() <= WHOLE && nearest >= 1.0 {
        return Ok(());
    }
    let bound = "a whole number of spacings: rows of particles fill it";
    let [low, high] = [libm::floor(rows).max(1.0), libm::floor(rows).max(1.0) + 1.0].map(|n| n * spacing);
    let value = format!("{length}, {what} {rows:.3} spacings of {spacing}");
    let value = value.replace(", it ", ", ");
    Err(s.value(path, value, bound, &format!("make it {low:.6e} or {high:.6e}, or change the spacing")))
}
