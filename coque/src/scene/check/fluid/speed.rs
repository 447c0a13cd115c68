//! The least speed of sound: from the height that a fluid may fall and the velocity with which it sets out.

use crate::scene::body_in_scene::gravity_on;
use crate::scene::error::Verdict;
use crate::scene::fluid::FluidScene;
use crate::scene::fluid::geometry::Extent;
use crate::scene::problem::{BodyScene, Scene};
use crate::scene::walls::WallGeometry;
use sph_core::Vec3;

/// Least ratio of the speed of sound to the greatest speed of the flow: densities then change by two percent.
const LEAST: f64 = 7.0;

/// Refuses a speed of sound below seven times the speed that the fluid reaches falling freely.
pub(in crate::scene::check) fn check_sound_speed(scene: &Scene) -> Verdict {
    let Some((name, fluid)) = scene.fluid() else { return Ok(()) };
    let (fall, start) = (greatest_fall(scene, name, fluid), fluid.greatest_velocity());
    let speed = fall.max(start);
    let sound = fluid.liquid().sound_speed;
    if sound.get() >= LEAST * speed {
        return Ok(());
    }
    let from = match fall >= start {
        true => format!("√(2gH) = {fall:.4} of falling over its height"),
        false => format!("{start:.4} at the start"),
    };
    let bound = format!("at least {:.4}, {LEAST} times the speed {from}", LEAST * speed);
    let repair = format!("{:.4}, ten times that speed, keeps densities within one percent", 10.0 * speed);
    let s = scene.source.body(name, "fluid");
    Err(s.value("material.liquid.sound_speed", sound, &bound, &repair))
}

/// Speed of a fall from the highest place of the fluid to its lowest, or to the lowest of walls.
fn greatest_fall(scene: &Scene, name: &str, fluid: &FluidScene) -> f64 {
    // Along periodic sides nothing falls from a height: what speed it gets there friction decides.
    let gravity = gravity_on(scene, name);
    let gravity = fluid.periodic.map_or(gravity, |periodic| periodic.across(&gravity));
    let g = gravity.norm();
    if g == 0.0 {
        return 0.0;
    }
    let down = gravity / g;
    let depths = |extent: &Extent| {
        let least: f64 = (0..3).map(|i| down[i] * extent.least[i]).sum();
        let along = |i: usize| down[i] * extent.lengths[i];
        [
            least + (0..3).map(|i| along(i).min(0.0)).sum::<f64>(),
            least + (0..3).map(|i| along(i).max(0.0)).sum::<f64>(),
        ]
    };
    let fluids: Vec<[f64; 2]> = fluid.geometry.extents().iter().map(depths).collect();
    let top = fluids.iter().map(|depth| depth[0]).fold(f64::INFINITY, f64::min);
    let walls = scene.bodies.values().filter_map(|body| match body {
        BodyScene::Walls(walls) => Some(walls.geometry.depth(&down)),
        _ => None,
    });
    let bottom = fluids.iter().map(|depth| depth[1]).chain(walls.flatten()).fold(f64::NEG_INFINITY, f64::max);
    (2.0 * g * (bottom - top).max(0.0)).sqrt()
}

impl FluidScene {
    /// Greatest speed with which a particle sets out, from the corners of the boxes.
    fn greatest_velocity(&self) -> f64 {
        let Some(velocity) = &self.velocity else { return 0.0 };
        let linear = Vec3::from(velocity.linear.unwrap_or_default());
        let (spin, point) = velocity.spin.map_or_else(Default::default, |spin| {
            (Vec3::from(spin.axis).normalize() * spin.rate, Vec3::from(spin.point))
        });
        let corners = self.geometry.extents().into_iter().flat_map(|Extent { least, lengths }| {
            (0..8).map(move |corner| {
                Vec3::from([0, 1, 2].map(|i| least[i] + if corner >> i & 1 == 1 { lengths[i] } else { 0.0 }))
            })
        });
        corners.map(|x| (linear + spin.cross(&(x - point))).norm()).fold(0.0, f64::max)
    }
}

impl WallGeometry {
    /// Greatest depth along a direction \[L\] of the faces that a fluid may reach; none of a surface before its file is read.
    fn depth(&self, down: &Vec3) -> Option<f64> {
        let at = |x: &[f64]| x.iter().enumerate().map(|(i, x)| down[i] * x).sum::<f64>();
        let greatest = |a: &[f64], b: &[f64]| {
            let along = |(i, (a, b)): (usize, (&f64, &f64))| (down[i] * a).max(down[i] * b);
            a.iter().zip(b).enumerate().map(along).sum::<f64>()
        };
        match self {
            Self::Basin(basin) => Some(greatest(&basin.min, &basin.max)),
            // The fluid may fall to the side of an obstacle and of a line as well as on them.
            Self::Block(_) => None,
            Self::Polyline(line) => line.points.iter().map(|x| at(x)).reduce(f64::max),
            Self::Surface(_) => None,
        }
    }
}
