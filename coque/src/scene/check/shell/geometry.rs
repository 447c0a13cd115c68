//! Checks of the shape and of the places of its particles.

use crate::scene::error::{SceneError, Verdict};
use crate::scene::scope::Scope;
use crate::scene::shell::ShellScene;
use crate::scene::shell::geometry::{Geometry, Placing};

/// Bounds what a scene may allocate: ten million particles take about ten gigabytes.
const MOST_PARTICLES: usize = 10_000_000;

impl ShellScene {
    pub(super) fn check_geometry(&self, s: &Scope<'_>) -> Verdict {
        let at = |key: &str| format!("geometry.{}.{key}", self.geometry.word());
        match &self.geometry {
            Geometry::Plate(plate) => {
                s.positive(&at("lengths[0]"), plate.lengths[0])?;
                s.positive(&at("lengths[1]"), plate.lengths[1])?;
            }
            Geometry::Cylinder(cylinder) => {
                s.positive(&at("radius"), cylinder.radius)?;
                s.positive(&at("length"), cylinder.length)?;
                s.sized_all(&at("angles"), &cylinder.angles)?;
                s.range(&at("angles"), cylinder.angles, 360.0)?;
            }
            Geometry::Sphere(sphere) => {
                s.positive(&at("radius"), sphere.radius)?;
                let repair = "leave a small hole at the pole, such as 1 degree";
                s.between(&at("polar[0]"), sphere.polar[0], [0.0, 180.0], repair)?;
                s.between(&at("polar[1]"), sphere.polar[1], [0.0, 180.0], repair)?;
                s.range(&at("polar"), sphere.polar, 180.0)?;
                s.sized_all(&at("azimuth"), &sphere.azimuth)?;
                s.range(&at("azimuth"), sphere.azimuth, 360.0)?;
            }
            Geometry::Twisted(strip) => {
                s.positive(&at("length"), strip.length)?;
                s.positive(&at("width"), strip.width)?;
                s.sized(&at("twist"), strip.twist)?;
                s.within(&at("twist"), strip.twist, [-360.0, 360.0], "give the angle within one turn")?;
            }
            Geometry::Mesh(mesh) => s.positive(&at("scale"), mesh.scale)?,
        }
        if self.geometry.mesh().is_none() {
            self.check_places(s)?;
        }
        if let Some(turn) = self.orientation {
            s.direction("orientation.axis", turn.axis)?;
            s.within("orientation.degrees", turn.degrees, [-360.0, 360.0], "give the angle within one turn")?;
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
        if let Some(scattered) = scattered {
            s.positive(&at("scattered.spacing"), scattered.spacing)?;
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
        if let Some(disorder) = disorder {
            let repair = "beyond half a spacing neighbours would change places";
            s.within(&at("disorder.fraction"), disorder.fraction, [0.0, 0.49], repair)?;
        }
        for (i, ratio) in grading.into_iter().flatten().enumerate() {
            let repair = "it is the last spacing over the first: 1 is uniform, 10 and 0.1 are strong";
            s.within(&at(&format!("grading[{i}]")), ratio, [0.001, 1000.0], repair)?;
        }
        Ok(())
    }
}
