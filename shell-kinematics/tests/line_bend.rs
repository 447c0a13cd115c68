//! A line that bends in the surface: derivatives, rigid motions, circles.

use nalgebra::{Rotation3, SVector, Vector3};
use shell_kinematics::{LineBend, LinePlacement};

fn v(x: f64, y: f64, z: f64) -> Vector3<f64> {
    Vector3::new(x, y, z)
}

fn placement() -> LinePlacement {
    LinePlacement { before: v(0.9, 0.2, -0.1), after: v(1.1, -0.3, 0.2), d: v(0.1, -0.2, 0.9) }
}

fn bend() -> LineBend {
    let rest = LinePlacement { before: v(1.0, 0.1, 0.0), after: v(1.0, 0.0, 0.1), d: v(0.0, 0.1, 1.0) };
    LineBend::new(2.3, 0.8, &rest)
}

fn stepped(by: &SVector<f64, 9>) -> LinePlacement {
    let LinePlacement { before, after, d } = placement();
    let part = |first: usize| Vector3::from_fn(|k, _| by[first + k]);
    LinePlacement { before: before + part(0), after: after + part(3), d: d + part(6) }
}

/// Central differences of a step of 1e-5 leave 1e-10 of a derivative to truncation and as much to rounding.
#[test]
fn forces_and_tangent_are_derivatives() {
    let (bend, here, h) = (bend(), placement(), 1e-5);
    let (forces, tangent) = (bend.forces(&here), bend.tangent(&here, None));
    for k in 0..9 {
        let way = SVector::<f64, 9>::from_fn(|i, _| if i == k { h } else { 0.0 });
        let [plus, minus] = [stepped(&way), stepped(&-way)];
        let slope = (bend.energy(&plus) - bend.energy(&minus)) / (2.0 * h);
        assert!((slope - forces[k]).abs() < 1e-8 * forces.norm(), "{k}: {slope} {}", forces[k]);
        let column = (bend.forces(&plus) - bend.forces(&minus)) / (2.0 * h);
        assert!((column - tangent.column(k)).norm() < 1e-8 * tangent.norm(), "{k}");
    }
    assert!((tangent - tangent.transpose()).norm() < 1e-14 * tangent.norm());
    // Forces of vectors that turn together have no moment, and stretch of a way or of the director changes no turn.
    let turned: Vector3<f64> = [here.before, here.after, here.d]
        .iter()
        .enumerate()
        .map(|(k, u)| u.cross(&Vector3::from_fn(|i, _| forces[3 * k + i])))
        .sum();
    assert!(turned.norm() < 1e-14 * forces.norm(), "{turned}");
    let along: f64 = (0..3).map(|i| here.before[i] * forces[i]).sum();
    assert!(along.abs() < 1e-14 * forces.norm());
}

/// Turned it is the same; on a circle of radius R in the surface neighbours at the angle α turn by α: `κ = sin α/(R α)`.
#[test]
fn circles_have_their_curvature() {
    let straight = LinePlacement { before: v(0.1, 0.0, 0.0), after: v(0.1, 0.0, 0.0), d: v(0.0, 0.0, 1.0) };
    let bend = LineBend::new(3.0, 0.1, &straight);
    let (radius, angle) = (4.0_f64, 0.025_f64);
    let turn = Rotation3::new(v(0.0, 0.0, angle));
    let bent = LinePlacement { after: turn * straight.after, ..straight };
    assert!((bend.moment(&bent) / (3.0 / radius) - 1.0).abs() < 2e-4, "{}", bend.moment(&bent));
    let whole = Rotation3::new(v(0.4, -1.3, 0.9));
    let LinePlacement { before, after, d } = bent;
    let away = LinePlacement { before: whole * before, after: whole * after, d: whole * d };
    assert!((bend.energy(&away) / bend.energy(&bent) - 1.0).abs() < 1e-12);
    // Out of the surface it does not bend.
    let up = LinePlacement { after: v(0.09, 0.0, 0.04), ..straight };
    assert_eq!(bend.energy(&up), 0.0);
}
