//! Checks of supports, loads and the velocity of a solid.

use super::Checked;
use crate::scene::error::SceneError;
use crate::scene::loads::{Load, LoadKind};
use crate::scene::problem::Scene;
use crate::scene::solid::SolidScene;
use crate::scene::supports::{Support, SupportKind};

impl Scene {
    /// Refuses a velocity out of the plane of a plane block.
    pub(super) fn check_solid_velocity(&self, solid: &SolidScene) -> Checked {
        let (s, plane) = (&self.body_scope(), solid.is_plane());
        let Some(velocity) = solid.velocity else { return Ok(()) };
        s.in_plane("velocity.linear", velocity.linear.unwrap_or_default(), plane)?;
        match velocity.spin {
            Some(spin) if plane && (spin.axis[0] != 0.0 || spin.axis[1] != 0.0) => {
                let repair = "a plane block turns in its plane: axis = [0, 0, 1]";
                Err(s.value("velocity.spin.axis", format!("{:?}", spin.axis), "along z", repair))
            }
            _ => Ok(()),
        }
    }

    /// Refuses what nodes cannot be held by.
    pub(in crate::scene::check) fn check_solid_support(
        &self,
        at: &str,
        support: &Support,
        solid: &SolidScene,
    ) -> Checked {
        let (s, plane) = (&self.scope(), solid.is_plane());
        for (word, kind) in support.kinds() {
            match kind {
                SupportKind::Clamped => {}
                SupportKind::Symmetry(mirror) => {
                    s.in_plane(&format!("{at}.symmetry.normal"), mirror.normal, plane)?
                }
                SupportKind::Moved(moved) => {
                    s.in_plane(&format!("{at}.moved.direction"), moved.direction, plane)?
                }
                SupportKind::Held(held) => {
                    for (i, &v) in held.displacement.iter().enumerate() {
                        s.in_plane(&format!("{at}.held.displacement[{i}]"), v, plane)?;
                    }
                    if !held.director.is_empty() && !solid.has_directors() {
                        let repair = "remove it: only plates of two sheets have directors";
                        let path = format!("{at}.held.director");
                        return Err(SceneError::Choice(s.fault(&path, "a director", "none here", repair)));
                    }
                }
                SupportKind::Hinged | SupportKind::Diaphragm(_) | SupportKind::Rotated(_) => {
                    let bound = "`held`, `moved`, `symmetry` or `clamped` on a solid";
                    let repair = "use held = { displacement = […] } with the directions that do not move";
                    let fault = s.fault(&format!("{at}.{word}"), &format!("`{word}`"), bound, repair);
                    return Err(SceneError::Choice(fault));
                }
            }
        }
        Ok(())
    }

    /// Refuses what nodes cannot carry.
    pub(in crate::scene::check) fn check_solid_load(
        &self,
        at: &str,
        load: &Load,
        solid: &SolidScene,
    ) -> Checked {
        let (s, plane) = (&self.scope(), solid.is_plane());
        for (word, kind) in load.kinds() {
            match kind {
                LoadKind::Force(force) => s.in_plane(&format!("{at}.force.total"), force.total, plane)?,
                LoadKind::Gravity(gravity) => {
                    s.in_plane(&format!("{at}.gravity.acceleration"), gravity.acceleration, plane)?
                }
                LoadKind::Traction(traction) => {
                    s.in_plane(&format!("{at}.traction.value"), traction.value, plane)?
                }
                LoadKind::Couple(_) | LoadKind::Pressure(_) => {
                    let bound = "`force`, `traction` or `gravity` on a solid";
                    let repair = "use traction = { value = […] } on a face: dead force by area";
                    let fault = s.fault(&format!("{at}.{word}"), &format!("`{word}`"), bound, repair);
                    return Err(SceneError::Choice(fault));
                }
            }
        }
        Ok(())
    }

    /// A traction acts on a face of a block.
    pub(in crate::scene::check) fn check_traction(&self, at: &str, load: &Load) -> Checked {
        let s = &self.scope();
        let Some(traction) = load.traction else { return Ok(()) };
        if self.as_solid().is_none() {
            let repair = "use `force` on an edge, or `pressure` on all";
            let bound = "`force`, `couple`, `pressure` or `gravity` on a shell";
            let fault = s.fault(&format!("{at}.traction"), "`traction`", bound, repair);
            return Err(SceneError::Choice(fault));
        }
        s.sized_all(&format!("{at}.traction.value"), &traction.value)?;
        if let Some(depth) = traction.depth {
            s.positive(&format!("{at}.traction.depth"), depth)?;
        }
        let faces = &self.built_in()[1..];
        self.only_on(at, &load.on, "a traction acts on a face of the block", faces)
    }
}
