//! Checks of rigid bodies in a fluid: edges that rows of its particles fill, and in a plane what leaves it.

use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::{SceneError, Verdict};
use crate::scene::fluid::FluidScene;
use crate::scene::loads::{Axis, LoadKind};
use crate::scene::problem::Scene;
use crate::scene::rigid::{RigidGeometry, RigidScene};
use crate::scene::scope::Scope;
use crate::scene::supports::SupportKind;

/// Part of its own by which the distance of points behind faces may differ from the spacing of the fluid.
const ALIKE: f64 = 0.05;

/// Refuses rigid bodies that a fluid of the scene cannot wet.
pub(super) fn check_wet_rigid(scene: &Scene) -> Verdict {
    let Some((name, fluid)) = scene.fluid() else { return Ok(()) };
    for (body, kind) in &scene.bodies {
        let view = BodyInScene::new(scene, body, kind)?;
        let Some(rigid) = view.as_rigid() else { continue };
        check_size(rigid, fluid, name, &view.body_scope())?;
        if fluid.dimensions() == 2 {
            check_plane(&view, rigid)?;
        }
    }
    Ok(())
}

/// A body is as thick as the rows behind its faces, and a box as long as whole spacings.
fn check_size(rigid: &RigidScene, fluid: &FluidScene, name: &str, s: &Scope<'_>) -> Verdict {
    let spacing = fluid.geometry.spacing();
    let rows = libm::round(2.0 * fluid.formulation.options().smoothing());
    let deep = |path: &str, value: f64| match value >= (rows - 1e-6) * spacing {
        true => Ok(()),
        false => {
            let bound = format!(
                "at least {rows} spacings of `{name}`, {:.6}: the fluid on one side would feel that on the other",
                rows * spacing
            );
            Err(s.value(
                path,
                value,
                &bound,
                "make it thicker, use a narrower spacing of the fluid, or a stiff shell",
            ))
        }
    };
    match &rigid.geometry {
        RigidGeometry::Ball(ball) => deep("geometry.ball.radius", 2.0 * ball.radius.get()),
        RigidGeometry::Box(own) => {
            for axis in 0..fluid.dimensions() {
                let (length, path) = (own.max[axis] - own.min[axis], format!("geometry.box.max[{axis}]"));
                deep(&path, length)?;
                let between = length - spacing;
                let apart = between / libm::round(between / spacing).max(1.0);
                if (apart / spacing - 1.0).abs() > ALIKE {
                    let value = format!("an edge of {length:.6} along {}", ["x", "y", "z"][axis]);
                    let bound = format!(
                        "whole spacings of `{name}`, {spacing}, long to 5 % of each: points behind its faces, {apart:.6} apart, are wall particles of \
                         their own size"
                    );
                    let nearest = spacing * libm::round(length / spacing);
                    return Err(s.value(&path, value, &bound, &format!("make the edge {nearest:.6} long")));
                }
            }
            Ok(())
        }
        RigidGeometry::Mesh(_) => Ok(()),
    }
}

/// In a plane a body goes along x and y and turns about z.
fn check_plane(scene: &BodyInScene<'_>, rigid: &RigidScene) -> Verdict {
    let own = &scene.body_scope();
    if matches!(rigid.geometry, RigidGeometry::Ball(_)) {
        let bound = "a box, or a mesh of a prism along z, in a plane fluid: a ball has no one outline in it";
        let repair = "use [bodies.NAME.rigid.geometry.mesh] with a cylinder along z, or a fluid in space";
        return Err(SceneError::Choice(own.fault("geometry.ball", "a ball", bound, repair)));
    }
    let along = stays_in_plane;
    let about = |s: &Scope<'_>, path: &str, v: [f64; 3]| match v[0] == 0.0 && v[1] == 0.0 {
        true => Ok(()),
        false => {
            let repair = "use [0, 0, 1]: a body in a plane fluid turns in the plane";
            Err(s.value(path, format!("{v:?}"), "along z", repair))
        }
    };
    if let Some(velocity) = &rigid.velocity {
        along(own, "velocity.linear", velocity.linear.unwrap_or_default())?;
        velocity.spin.map_or(Ok(()), |spin| about(own, "velocity.spin.axis", spin.axis))?;
    }
    let s = &scene.scope();
    for support in &scene.supports {
        for (word, kind) in support.kinds() {
            match kind {
                SupportKind::Moved(moved) => {
                    along(s, &support.at(&format!("{word}.direction")), moved.direction)?;
                }
                SupportKind::Rotated(turned) => about(s, &support.at(&format!("{word}.axis")), turned.axis)?,
                _ => {}
            }
        }
        if let Some(direction) = support.spring.as_ref().and_then(|spring| spring.direction) {
            along(s, &support.at("spring.direction"), direction)?;
        }
    }
    for load in &scene.loads {
        for (_, kind) in load.kinds() {
            match kind {
                LoadKind::Force(force) => along(s, &load.at("force.total"), force.total)?,
                LoadKind::Gravity(gravity) => {
                    along(s, &load.at("gravity.acceleration"), gravity.acceleration)?
                }
                LoadKind::Couple(couple) => match couple.axis {
                    Axis::Fixed(axis) => about(s, &load.at("couple.axis"), axis)?,
                    Axis::Edge => {}
                },
                _ => {}
            }
        }
    }
    Ok(())
}

/// Refuses a vector along which a body leaves the plane of a fluid.
pub(super) fn stays_in_plane(s: &Scope<'_>, path: &str, v: [f64; 3]) -> Verdict {
    if v[2] == 0.0 {
        return Ok(());
    }
    let repair = "set its third component to zero: a body in a plane fluid stays in the plane";
    Err(s.value(path, format!("{v:?}"), "in the plane of x and y", repair))
}
