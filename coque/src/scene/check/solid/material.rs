//! Checks of the material of a solid and of the bonds that carry it: what breaks, what is cracked, what touches.

use peridynamics::Space;
use sph_core::Vec3;

use crate::scene::error::{SceneError, Verdict};
use crate::scene::scope::Scope;
use crate::scene::solid::SolidScene;
use crate::scene::solid::formulation::{Plane, SolidFormulation};
use crate::scene::solid::fracture::{Contact, Crack, Fracture};

/// Poisson's ratio of pairwise forces may be written with three digits.
const ROUNDING: f64 = 5e-4;

impl SolidScene {
    /// The space that its bonds lie in.
    pub(crate) fn space(&self) -> Space {
        match self.formulation.plane() {
            Some(Plane::Stress) => Space::PlaneStress,
            Some(Plane::Strain) => Space::PlaneStrain,
            None if self.has_directors() => Space::PlaneStress,
            None => Space::Solid,
        }
    }

    pub(super) fn check_formulation(&self, s: &Scope<'_>) -> Verdict {
        let word = self.formulation.word();
        let at = |key: &str| format!("formulation.{word}.{key}");
        let two = self.dimensions() == 2;
        match &self.formulation {
            SolidFormulation::TwoSheets(_) if !two => {
                let repair = "give two lengths and a thickness: lengths = [a, b], thickness = t";
                let value = format!("a list of {} numbers", self.dimensions());
                Err(s.value("geometry.block.lengths", value, "a list of 2 for two sheets", repair))
            }
            SolidFormulation::TwoSheets(_) | SolidFormulation::Galerkin(_) => Ok(()),
            _ if two && self.formulation.plane().is_none() => {
                let repair =
                    format!("add `plane = \"stress\"` or `plane = \"strain\"` in `formulation.{word}`");
                let bound = "given beside two lengths";
                Err(SceneError::Missing(s.fault(&at("plane"), "nothing", bound, &repair)))
            }
            _ if !two && self.formulation.plane().is_some() => {
                let repair = "remove it, or give two lengths for a plane block";
                let fault = s.fault(&at("plane"), "a plane", "none beside three lengths", repair);
                Err(SceneError::Choice(fault))
            }
            _ => Ok(()),
        }
    }

    pub(super) fn check_material(&self, s: &Scope<'_>) -> Verdict {
        let word = self.material.word();
        let Some((_, nu)) = self.material.isotropic() else {
            let repair = "use [material.elastic], or [bodies.NAME.solid.formulation.galerkin]";
            let (value, bound) = ("an orthotropic material", "an isotropic one where bonds carry the solid");
            return Err(SceneError::Choice(s.fault(&format!("material.{word}"), value, bound, repair)));
        };
        let at = |key: &str| format!("material.{word}.{key}");
        let space = self.space();
        let top = if space == Space::PlaneStress { 1.0 } else { 0.5 };
        let repair = "ν = 0.5 is incompressible; most solids have 0.2 to 0.4";
        s.between(&at("poisson"), nu, [-1.0, top], repair)?;
        let only = space.pairwise_poisson();
        // Pairwise bonds that yield are refused as such.
        if !matches!(self.formulation, SolidFormulation::BondBased(_))
            || self.material.yields()
            || (nu - only).abs() <= ROUNDING
        {
            return Ok(());
        }
        let bound = format!("{only:.4}, that of pairwise forces in this space");
        let repair = "use [formulation.state-based] for any other, or this value";
        Err(s.value(&at("poisson"), nu, &bound, repair))
    }
}

/// Corners this close to the plane of a crack, over its size, lie in it but for rounding.
const FLAT: f64 = 1e-6;

impl SolidScene {
    pub(super) fn check_fracture(&self, s: &Scope<'_>) -> Verdict {
        if let Some(fracture) = &self.fracture {
            check_limits(fracture, s)?;
        } else if !self.unbreakable.is_empty() {
            let repair = "remove it, or say when bonds break: fracture.energy = …";
            let bound = "none without `fracture`, where no bond breaks";
            return Err(SceneError::Choice(s.fault("unbreakable", "sets of nodes", bound, repair)));
        }
        for (i, crack) in self.cracks.iter().enumerate() {
            self.check_crack(&format!("cracks[{i}]"), crack, s)?;
        }
        self.contact.as_ref().map_or(Ok(()), |contact| self.check_contact(contact, s))
    }

    fn check_crack(&self, at: &str, crack: &Crack, s: &Scope<'_>) -> Verdict {
        let Crack { from, to, corners } = crack;
        let segment = from.is_some() || to.is_some();
        if self.dimensions() == 2 {
            let (Some(from), Some(to), None) = (from, to, corners) else {
                let repair = "cracks = [{ from = [0.0, 1.0], to = [2.0, 1.0] }]";
                let bound = "`from` and `to` in a plane";
                return Err(SceneError::Choice(s.fault(at, &given(crack), bound, repair)));
            };
            s.coordinates(&format!("{at}.from"), from, 2)?;
            s.coordinates(&format!("{at}.to"), to, 2)?;
            if from != to {
                return Ok(());
            }
            let repair = "move one end: a crack without length breaks nothing";
            return Err(s.value(&format!("{at}.to"), format!("{to:?}"), "another point than `from`", repair));
        }
        let (Some(corners), false) = (corners, segment) else {
            let repair = "cracks = [{ corners = [[0, 0, 0], [1, 0, 0], [1, 1, 0]] }]";
            return Err(SceneError::Choice(s.fault(at, &given(crack), "`corners` in space", repair)));
        };
        for (i, corner) in corners.iter().enumerate() {
            s.sized_all(&format!("{at}.corners[{i}]"), corner)?;
        }
        if is_convex(corners) {
            return Ok(());
        }
        let value = format!("{} corners that are not", corners.len());
        let bound = "at least three corners of a plane convex polygon, in order";
        Err(s.value(&format!("{at}.corners"), value, bound, "put them in order, or give two cracks"))
    }

    fn check_contact(&self, contact: &Contact, s: &Scope<'_>) -> Verdict {
        if self.has_directors() {
            let repair = "remove it, or use three lengths for a block in space";
            let bound = "none of a plate of two sheets";
            return Err(SceneError::Choice(s.fault("contact", "contact", bound, repair)));
        }
        for (i, wall) in contact.walls.iter().enumerate() {
            let at = |key: &str| format!("contact.walls[{i}].{key}");
            s.sized_all(&at("point"), &wall.point)?;
            s.direction(&at("normal"), wall.normal)?;
            s.in_plane(&at("normal"), wall.normal, self.is_plane())?;
        }
        Ok(())
    }
}

fn check_limits(fracture: &Fracture, s: &Scope<'_>) -> Verdict {
    let mut alternatives = Vec::new();
    alternatives.extend(fracture.energy.map(|_| "energy"));
    alternatives.extend(fracture.stretch.map(|_| "stretch"));
    s.exactly_one("fracture", "limit", &alternatives, &["energy", "stretch"])?;
    if fracture.stretch.is_some() && fracture.by.is_some() {
        let repair = "remove `by`: `stretch` says what is measured";
        let fault = s.fault("fracture.by", "a measure", "none beside `stretch`", repair);
        return Err(SceneError::Choice(fault));
    }
    Ok(())
}

/// What of a crack is given, in words.
fn given(crack: &Crack) -> String {
    let mut keys = Vec::new();
    keys.extend(crack.from.as_ref().map(|_| "`from`"));
    keys.extend(crack.to.as_ref().map(|_| "`to`"));
    keys.extend(crack.corners.as_ref().map(|_| "`corners`"));
    if keys.is_empty() { "nothing".into() } else { keys.join(" and ") }
}

/// Whether corners are those of a plane convex polygon, in order.
fn is_convex(corners: &[[f64; 3]]) -> bool {
    let count = corners.len();
    if count < 3 {
        return false;
    }
    let x = |i: usize| Vec3::from(corners[i % count]);
    let turn = |i: usize| (x(i + 1) - x(i)).cross(&(x(i + 2) - x(i + 1)));
    let normal: Vec3 = (0..count).map(turn).sum();
    let size = (0..count).map(|i| (x(i) - x(0)).norm()).fold(0.0, f64::max);
    let unit = normal.normalize();
    let flat = (0..count).all(|i| (x(i) - x(0)).dot(&unit).abs() <= FLAT * size);
    // Turning the same way at every corner, and once round in all.
    let around: f64 = (0..count)
        .map(|i| {
            let (a, b) = (x(i + 1) - x(i), x(i + 2) - x(i + 1));
            libm::atan2(a.cross(&b).dot(&unit), a.dot(&b))
        })
        .sum();
    flat && (0..count).all(|i| turn(i).dot(&unit) > 0.0) && (around - std::f64::consts::TAU).abs() < FLAT
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn convex_polygons_are_known() {
        let square = [[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [1.0, 1.0, 1.0], [0.0, 1.0, 1.0]];
        assert!(is_convex(&square));
        assert!(!is_convex(&square[..2]));
        let [a, b, c, d] = square;
        assert!(!is_convex(&[a, c, b, d]));
        assert!(!is_convex(&[a, b, c, [0.0, 1.0, 1.1]]));
        assert!(!is_convex(&[a, b, [0.2, 0.2, 1.0], d]));
        assert!(!is_convex(&[a, a, a]));
        // Twice round.
        assert!(!is_convex(&[a, b, c, d, a, b, c, d]));
    }
}
