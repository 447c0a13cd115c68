//! The checks of a shell, its keys relative to where it stands in the scene; here of its shape and the places of its particles.

mod by_temperature;
mod formulation;
mod given;
mod initial_stress;
mod material;
mod own_law;
mod parts;
mod placed;
mod plies;
mod rigid;
mod stiffeners;

use crate::scene::bounded::Polar;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::scope::Scope;
use crate::scene::shell::ShellScene;
use crate::scene::shell::geometry::{Geometry, Placing};

pub(super) use self::by_temperature::check_tabled_load;
pub(super) use self::own_law::check_plastic;
pub(super) use self::parts::check_parts;
pub(super) use self::placed::check_wetting;

impl ShellScene {
    /// Refuses the first thing that is out of bounds.
    pub(super) fn check(&self, s: &Scope<'_>) -> Result<(), SceneError> {
        self.check_geometry(s)?;
        self.check_placed(s)?;
        self.check_material(s)?;
        formulation::check_formulation(&self.formulation, s)
    }
}

/// Bounds what a scene may allocate: ten million particles take about ten gigabytes.
const MOST_PARTICLES: usize = 10_000_000;

impl ShellScene {
    pub(super) fn check_geometry(&self, s: &Scope<'_>) -> Verdict {
        let at = |key: &str| format!("geometry.{}.{key}", self.geometry.word());
        match &self.geometry {
            Geometry::Plate(_) | Geometry::Mesh(_) => {}
            Geometry::Cylinder(cylinder) => {
                s.sized_all(&at("angles"), &cylinder.angles)?;
                s.range(&at("angles"), cylinder.angles, 360.0)?;
            }
            Geometry::Sphere(sphere) => {
                s.range(&at("polar"), sphere.polar.map(Polar::get), 180.0)?;
                s.sized_all(&at("azimuth"), &sphere.azimuth)?;
                s.range(&at("azimuth"), sphere.azimuth, 360.0)?;
            }
            Geometry::Twisted(strip) => s.sized(&at("twist"), strip.twist.get())?,
        }
        if self.geometry.mesh().is_none() {
            self.check_places(s)?;
        }
        if let Some(turn) = self.orientation {
            s.direction("orientation.axis", turn.axis)?;
        }
        Ok(())
    }

    /// Where particles stand: a lattice with its options, or scattered.
    fn check_places(&self, s: &Scope<'_>) -> Verdict {
        let path = format!("geometry.{}", self.geometry.word());
        let at = |key: &str| format!("{path}.{key}");
        let Placing { particles, disorder, grading, scattered } = self.geometry.placing();
        let mut given = Vec::new();
        given.extend(particles.map(|_| "particles"));
        given.extend(scattered.map(|_| "scattered"));
        s.exactly_one(&path, "way to place particles", &given, &["particles", "scattered"])?;
        if scattered.is_some() {
            let of_lattice = [("disorder", disorder.is_some()), ("grading", grading.is_some())];
            if let Some((key, _)) = of_lattice.into_iter().find(|(_, given)| *given) {
                let repair = format!("remove `{key}`, or give `particles = [n, m]` in place of `scattered`");
                let fault = s.fault(&at(key), key, "none with `scattered` particles", &repair);
                return Err(SceneError::Choice(fault));
            }
        }
        if let Some([n1, n2]) = particles {
            for (i, n) in [n1, n2].into_iter().enumerate() {
                if n < 2 {
                    let repair = "particles lie on both edges: at least two";
                    return Err(s.value(&at(&format!("particles[{i}]")), n, "2 or more", repair));
                }
            }
            if n1.checked_mul(n2).is_none_or(|n| n > MOST_PARTICLES) {
                let bound = format!("at most {MOST_PARTICLES} particles in all");
                return Err(s.value(&at("particles"), format!("[{n1}, {n2}]"), &bound, "use fewer"));
            }
        }
        Ok(())
    }
}
