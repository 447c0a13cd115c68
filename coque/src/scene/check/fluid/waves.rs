//! Checks of waves: what a wall makes of them, and the beach on which they run out.

use fluid_sph::Waves;
use sph_core::Vec3;

use crate::scene::body_in_scene::gravity_on;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::fluid::FluidScene;
use crate::scene::fluid::formulation::FluidMethod;
use crate::scene::fluid::geometry::Extent;
use crate::scene::problem::{BodyScene, Scene};
use crate::scene::scope::Scope;
use crate::scene::walls::WallMotion;
use crate::scene::waves::{Beach, SpectrumShape, WallWaves};

/// Cosine of the angle to gravity beyond which a direction is not horizontal: rounding.
const LEVEL: f64 = 1e-9;

/// Spacings within which a depth and a hinge agree with the water at the start: floors have sills and lattices their rounding.
const NEAR: f64 = 2.0;

/// Where the water is at the start along gravity, heights \[L\].
struct Pool {
    /// The axis of gravity, and the sign of what is above.
    axis: usize,
    up: f64,
    surface: f64,
    /// The lower face of each block.
    floors: Vec<f64>,
    near: f64,
}

impl Pool {
    /// None under gravity along no axis: blocks then have no level surface.
    fn of(fluid: &FluidScene, gravity: &Vec3) -> Option<Self> {
        let axis = (0..3).find(|&axis| gravity[axis].abs() >= (1.0 - LEVEL) * gravity.norm())?;
        let up = -gravity[axis].signum();
        let ends = fluid.geometry.extents().into_iter().map(|extent| {
            let [a, b] = [extent.least[axis], extent.least[axis] + extent.lengths[axis]].map(|x| up * x);
            [a.min(b), a.max(b)]
        });
        let ends: Vec<[f64; 2]> = ends.collect();
        let surface = ends.iter().fold(f64::NEG_INFINITY, |most, end| most.max(end[1]));
        let floors = ends.into_iter().map(|end| end[0]).collect();
        Some(Self { axis, up, surface, floors, near: NEAR * fluid.geometry.spacing() })
    }

    /// The floor that is nearest to a height, unless it is near enough.
    fn missed(&self, height: f64) -> Option<f64> {
        let off = |floor: &&f64| (*floor - height).abs();
        self.floors
            .iter()
            .min_by(|a, b| off(a).total_cmp(&off(b)))
            .copied()
            .filter(|floor| off(&floor) > self.near)
    }

    /// Refuses another depth than that of the water.
    fn check_depth(&self, s: &Scope<'_>, path: &str, depth: f64) -> Verdict {
        let Some(floor) = self.missed(self.surface - depth) else { return Ok(()) };
        let own = self.surface - floor;
        let bound = format!("within two spacings of the depth of the water at the start, {own:.6}");
        Err(s.value(path, depth, &bound, &format!("make it {own:.6}, or fill the flume as deep")))
    }

    /// Refuses a hinge that is not at the floor.
    fn check_hinge(&self, s: &Scope<'_>, hinge: &[f64; 3]) -> Verdict {
        let Some(floor) = self.missed(self.up * hinge[self.axis]) else { return Ok(()) };
        let (path, floor) = (format!("motion.waves.hinge[{}]", self.axis), self.up * floor);
        let bound = format!(
            "within two spacings of the floor of the water, {floor:.6}: the stroke is that of a flap from the floor"
        );
        Err(s.value(
            &path,
            hinge[self.axis],
            &bound,
            &format!("make it {floor:.6}, or leave it out for a piston"),
        ))
    }
}

/// Refuses waves that no wall makes, and beaches on which none run out.
pub(in crate::scene::check) fn check_waves(scene: &Scene) -> Verdict {
    let Some((name, fluid)) = scene.fluid() else { return Ok(()) };
    let gravity = gravity_on(scene, name);
    for (body, walls) in &scene.bodies {
        let BodyScene::Walls(walls) = walls else { continue };
        let Some(WallMotion { waves: Some(waves), translation, rotation }) = &walls.motion else { continue };
        let s = &scene.source.body(body, "walls");
        if translation.is_some() || rotation.is_some() {
            let (bound, repair) = ("the whole motion of the walls", "remove `translation` and `rotation`");
            return Err(SceneError::Choice(s.fault(
                "motion.waves",
                "waves beside another motion",
                bound,
                repair,
            )));
        }
        check_direction(s, "motion.waves.along", waves.along, &gravity, fluid)?;
        check_made(s, waves, &gravity, Pool::of(fluid, &gravity).as_ref())?;
    }
    let Some(beach) = &fluid.beach else { return Ok(()) };
    check_beach(&scene.source.body(name, "fluid"), fluid, beach, &gravity)
}

/// Waves need gravity, and go across it.
fn check_direction(
    s: &Scope<'_>,
    path: &str,
    along: [f64; 3],
    gravity: &Vec3,
    fluid: &FluidScene,
) -> Verdict {
    if gravity.norm() == 0.0 {
        let (bound, repair) =
            ("gravity on the fluid", "add loads = [{ on = \"all\", gravity = { acceleration = […] } }]");
        return Err(SceneError::Choice(s.fault(path, "waves", &format!("none without {bound}"), repair)));
    }
    s.direction(path, along)?;
    s.in_plane(path, along, fluid.dimensions() == 2)?;
    let along = Vec3::from(along).normalize();
    if along.dot(&gravity.normalize()).abs() > LEVEL {
        let repair = "give a direction along the surface of the water";
        return Err(s.value(path, format!("{:?}", <[f64; 3]>::from(along)), "across gravity", repair));
    }
    Ok(())
}

fn check_made(s: &Scope<'_>, waves: &WallWaves, gravity: &Vec3, pool: Option<&Pool>) -> Verdict {
    let of = Waves { period: waves.period.get(), depth: waves.depth.get(), gravity: gravity.norm() };
    if waves.height.get() > of.breaking_height() {
        let bound = format!(
            "at most {:.4}, at which waves {:.4} long in water {} deep break",
            of.breaking_height(),
            of.length(),
            waves.depth
        );
        return Err(s.value(
            "motion.waves.height",
            waves.height,
            &bound,
            "lower it, or give a longer period",
        ));
    }
    if let Some(SpectrumShape::Table(points)) = waves.spectrum.as_ref().map(|spectrum| &spectrum.shape) {
        check_table(s, points)?;
        let peak = 1.0 / waves.period.get();
        if let (Some(first), Some(last)) = (points.first(), points.last())
            && !(first[0]..=last[0]).contains(&peak)
        {
            let bound = format!(
                "the period of the peak of the table, from {:.4} to {:.4}",
                1.0 / last[0],
                1.0 / first[0]
            );
            return Err(s.value(
                "motion.waves.period",
                waves.period,
                &bound,
                "give that of its greatest density",
            ));
        }
    }
    pool.map_or(Ok(()), |pool| pool.check_depth(s, "motion.waves.depth", waves.depth.get()))?;
    let Some(hinge) = waves.hinge else { return Ok(()) };
    s.sized_all("motion.waves.hinge", &hinge)?;
    pool.map_or(Ok(()), |pool| pool.check_hinge(s, &hinge))
}

/// Densities that frequencies have.
fn check_table(s: &Scope<'_>, points: &[[f64; 2]]) -> Verdict {
    let path = "motion.waves.spectrum.shape.table";
    for (i, point) in points.iter().enumerate() {
        s.sized_all(&format!("{path}[{i}]"), point)?;
    }
    let ascends = points.len() > 1 && points.windows(2).all(|pair| pair[0][0] < pair[1][0]);
    let positive = points.iter().all(|[frequency, density]| *frequency > 0.0 && *density >= 0.0);
    if ascends && positive && points.iter().any(|[_, density]| *density > 0.0) {
        return Ok(());
    }
    let bound = "a list of [frequency, density] with ascending frequencies above zero, no density below it and one above";
    Err(s.value(path, "something else", bound, "sort it by frequency, and leave out what has no energy"))
}

fn check_beach(s: &Scope<'_>, fluid: &FluidScene, beach: &Beach, gravity: &Vec3) -> Verdict {
    s.sized_all("beach.from", &beach.from)?;
    check_direction(s, "beach.along", beach.along, gravity, fluid)?;
    if matches!(fluid.formulation.options().method, FluidMethod::Source) {
        let (bound, repair) = ("none with `method = \"source\"`", "leave the method out");
        return Err(SceneError::Choice(s.fault("beach", "a beach", bound, repair)));
    }
    let of = Waves { period: beach.period.get(), depth: beach.depth.get(), gravity: gravity.norm() };
    if beach.length.get() < of.length() {
        let bound =
            format!("at least {:.4}, the length of the waves: shorter ones send them back", of.length());
        return Err(s.value("beach.length", beach.length, &bound, "make the tank and its beach longer"));
    }
    Pool::of(fluid, gravity).map_or(Ok(()), |pool| pool.check_depth(s, "beach.depth", beach.depth.get()))?;
    let along = Vec3::from(beach.along).normalize();
    let end = |extent: Extent| {
        let far = |axis: usize| {
            let [near, far] = [extent.least[axis], extent.least[axis] + extent.lengths[axis]];
            (along[axis] * near).max(along[axis] * far)
        };
        (0..3).map(far).sum::<f64>()
    };
    let end = fluid.geometry.extents().into_iter().map(end).fold(f64::NEG_INFINITY, f64::max);
    let beyond = Vec3::from(beach.from).dot(&along) - end;
    if beyond > -0.5 * fluid.geometry.spacing() {
        let bound = "before the end of the water along the beach: no particle lies in it";
        let repair = "let it begin its length before the end of the water, or turn `along` round";
        return Err(s.value("beach.from", format!("{:?}", beach.from), bound, repair));
    }
    Ok(())
}
