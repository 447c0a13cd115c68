//! Checks of walls: their shape and their motion.

use explicit_dynamics::Amplitude;

use crate::scene::body_in_scene::BodyInScene;
use crate::scene::check::amplitude::check_amplitude;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::scope::Scope;
use crate::scene::sets::OF_WALLS;
use crate::scene::walls::{Basin, Obstacle, WallGeometry, WallsScene};

impl WallsScene {
    /// Refuses the first of its own keys that is out of bounds.
    pub(in crate::scene::check) fn check(&self, scene: &BodyInScene<'_>, s: &Scope<'_>) -> Verdict {
        match &self.geometry {
            WallGeometry::Basin(basin) => check_basin(basin, s)?,
            WallGeometry::Block(block) => check_obstacle(block, s)?,
            WallGeometry::Polyline(line) => {
                for (i, point) in line.points.iter().enumerate() {
                    s.sized_all(&format!("geometry.polyline.points[{i}]"), point)?;
                }
                if line.points.len() < 2 {
                    let value = format!("a list of {}", line.points.len());
                    let repair = "add points, in order along the wall";
                    return Err(s.value("geometry.polyline.points", value, "at least two points", repair));
                }
                let same = |pair: &[[f64; 2]]| pair[0] == pair[1];
                if let Some(i) = line.points.windows(2).position(same) {
                    let path = format!("geometry.polyline.points[{}]", i + 1);
                    let value = format!("{:?}", line.points[i + 1]);
                    return Err(s.value(&path, value, "another point than the one before it", "remove it"));
                }
            }
            WallGeometry::Surface(surface) => {
                s.sized_all("geometry.surface.inside", &surface.inside)?;
            }
        }
        self.check_motion(scene, s)
    }

    /// Particles that rows of so many take, a spacing apart; none of a surface before its file is read.
    pub(in crate::scene::check) fn particles_asked(&self, spacing: f64, rows: f64) -> f64 {
        let faces = |lengths: Vec<f64>| -> f64 {
            let counts: Vec<f64> = lengths.iter().map(|length| length / spacing + 2.0 * rows).collect();
            let volume: f64 = counts.iter().product();
            counts.iter().map(|count| 2.0 * rows * volume / count).sum()
        };
        match &self.geometry {
            WallGeometry::Basin(basin) => {
                faces(basin.min.iter().zip(&basin.max).map(|(a, b)| b - a).collect())
            }
            WallGeometry::Block(block) => faces(block.lengths.iter().map(|length| length.get()).collect()),
            WallGeometry::Polyline(line) => {
                let length = |pair: &[[f64; 2]]| {
                    ((pair[1][0] - pair[0][0]).powi(2) + (pair[1][1] - pair[0][1]).powi(2)).sqrt()
                };
                rows * (line.points.windows(2).map(length).sum::<f64>() / spacing)
            }
            WallGeometry::Surface(_) => 0.0,
        }
    }

    fn check_motion(&self, scene: &BodyInScene<'_>, s: &Scope<'_>) -> Verdict {
        let Some(motion) = &self.motion else { return Ok(()) };
        let plane = self.geometry.dimensions() == 2;
        if motion.waves.is_some() {
            return Ok(());
        }
        if motion.translation.is_none() && motion.rotation.is_none() {
            let repair = "motion.translation = { by = [0.1, 0, 0], amplitude = { sine = { period = 1.0 } } }";
            let bound = "`translation`, `rotation` or both, or `waves`";
            return Err(SceneError::Choice(s.fault("motion", "neither", bound, repair)));
        }
        if let Some(translation) = &motion.translation {
            s.sized_all("motion.translation.by", &translation.by)?;
            s.in_plane("motion.translation.by", translation.by, plane)?;
            check_course(scene, s, "motion.translation.amplitude", &translation.amplitude)?;
        }
        let Some(rotation) = &motion.rotation else { return Ok(()) };
        s.direction("motion.rotation.axis", rotation.axis)?;
        s.sized_all("motion.rotation.centre", &rotation.centre)?;
        s.sized("motion.rotation.by", rotation.by)?;
        if plane && (rotation.axis[0] != 0.0 || rotation.axis[1] != 0.0) {
            let repair = "walls of a plane fluid turn in its plane: axis = [0, 0, 1]";
            return Err(s.value("motion.rotation.axis", format!("{:?}", rotation.axis), "along z", repair));
        }
        check_course(scene, s, "motion.rotation.amplitude", &rotation.amplitude)
    }
}

/// A course of a wall: like that of a prescribed motion it starts at zero.
fn check_course(scene: &BodyInScene<'_>, s: &Scope<'_>, path: &str, amplitude: &Amplitude) -> Verdict {
    check_amplitude(scene, &s.path(path), amplitude)?;
    let starts_at_zero = match amplitude {
        Amplitude::Constant => false,
        Amplitude::Table(points) => points[0][1] == 0.0 && points[0][0] >= 0.0,
        _ => true,
    };
    if starts_at_zero {
        return Ok(());
    }
    let repair = "start the table at [0.0, 0.0], or use ramp, smooth or sine";
    Err(SceneError::Choice(s.fault(path, "a sudden motion", "a course in time that starts at zero", repair)))
}

fn check_basin(basin: &Basin, s: &Scope<'_>) -> Verdict {
    let at = |key: &str| format!("geometry.basin.{key}");
    let dimensions = basin.min.len();
    if !(2..=3).contains(&dimensions) {
        let value = format!("a list of {dimensions} numbers");
        let repair = "two coordinates make plane walls, three walls in space";
        return Err(s.value(&at("min"), value, "a list of 2 or 3", repair));
    }
    s.sized_all(&at("min"), &basin.min)?;
    s.as_many(&at("max"), &basin.max, dimensions, "geometry.basin.min")?;
    if let Some(axis) = (0..dimensions).find(|&axis| basin.min[axis] >= basin.max[axis]) {
        let bound = format!("greater than the least, {}", basin.min[axis]);
        return Err(s.value(&at(&format!("max[{axis}]")), basin.max[axis], &bound, "swap the coordinates"));
    }
    let faces = &OF_WALLS[1..=2 * dimensions];
    basin
        .open
        .iter()
        .enumerate()
        .try_for_each(|(i, side)| s.word(&at(&format!("open[{i}]")), side, faces))?;
    if faces.iter().all(|face| basin.open.iter().any(|open| open == face)) {
        let repair = "close a side, or remove the body";
        return Err(s.value(&at("open"), "every side", "fewer than all sides", repair));
    }
    Ok(())
}

fn check_obstacle(block: &Obstacle, s: &Scope<'_>) -> Verdict {
    let at = |key: &str| format!("geometry.block.{key}");
    let dimensions = block.lengths.len();
    if !(2..=3).contains(&dimensions) {
        let value = format!("a list of {dimensions} numbers");
        let repair = "two lengths make plane walls, three walls in space";
        return Err(s.value(&at("lengths"), value, "a list of 2 or 3", repair));
    }
    block.origin.as_ref().map_or(Ok(()), |origin| s.coordinates(&at("origin"), origin, dimensions))
}
