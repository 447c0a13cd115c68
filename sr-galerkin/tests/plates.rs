//! Simply supported square plates under pressure, quarter models of plate17.

mod bodies;

use bodies::{block, body, curve, nodes};
use solid_kinematics::{Formulation, Moduli, Orthotropic};
use sph_core::{Basis, Support, Vec3};
use sr_galerkin::{Condition, Galerkin, Load, Parts};

/// What an edge does in the plane of the plate, along its mid-plane line.
#[derive(Clone, Copy, Debug, PartialEq)]
enum InPlane {
    /// It does not move along its normal.
    Immovable,
    /// It does not move along itself.
    Tangential,
    /// It does not move.
    Pinned,
}

/// A quarter of a plate of side a and thickness h, its centre at the origin; supported along its edges.
fn quarter(a: f64, h: f64, in_plane: InPlane, pressure: f64) -> Parts {
    let half = 0.5 * a;
    let mut parts = block([half, half, h], [6, 6, 3], 0.0);
    let step = half / 5.0;
    parts.basis = Basis::Plate17 { across: 2 };
    parts.support = Support::tensor([3.5 * step, 3.5 * step, 2.5 * h / 2.0]);
    for axis in 0..2 {
        let mut normal = Vec3::zeros();
        normal[axis] = 1.0;
        let tangent = Vec3::new(normal.y, normal.x, 0.0);
        parts.conditions.push(Condition::held(nodes(&parts, |x| x[axis] == 0.0), normal));
        let line = nodes(&parts, |x| x[axis] == half && x.z == 0.5 * h);
        parts.conditions.push(Condition::held(line.clone(), Vec3::z()));
        if in_plane != InPlane::Tangential {
            parts.conditions.push(Condition::held(line.clone(), normal));
        }
        if in_plane != InPlane::Immovable {
            parts.conditions.push(Condition::held(line, tangent));
        }
    }
    let faces = parts.cells.faces[5].clone();
    parts.loads.push(Load::Traction { faces, traction: Vec3::new(0.0, 0.0, -pressure) });
    parts
}

fn centre(body: &Galerkin) -> f64 {
    let h = body.rest().iter().fold(0.0, |most: f64, x| most.max(x.z));
    let node = body.rest().iter().position(|x| x.x == 0.0 && x.y == 0.0 && x.z == 0.5 * h).unwrap();
    -body.displacement(node).z / h
}

/// The isotropic plate of §10.2, P = q a⁴/(E h⁴) one at level one.
fn isotropic(formulation: Formulation, in_plane: InPlane) -> Parts {
    let (a, h): (f64, f64) = (100.0, 1.0);
    let mut parts = quarter(a, h, in_plane, (h / a).powi(4));
    parts.material.moduli = Moduli::isotropic(1.0, 0.316).unwrap();
    parts.material.formulation = formulation;
    parts
}

#[test]
fn first() {
    let loads = [12.1, 29.4, 56.9, 99.4, 161.0, 247.0, 358.0, 497.0];
    for f in [bodies::MIDPOINT, Formulation::StVenant] {
        let start = std::time::Instant::now();
        let mut plate = body(isotropic(f, InPlane::Immovable));
        println!("dropped {}", plate.dependent_conditions());
        let (values, steps) = curve(&mut plate, &loads, centre);
        let iterations: Vec<usize> = steps.iter().map(|step| step.converged.iterations).collect();
        println!("{values:.5?} {iterations:?} {:?}", start.elapsed());
    }
    let psi = 6.894757e-3;
    let of = Orthotropic { young: [20684.27, 8825.29, 8825.29], poisson: [0.32; 3], shear: [2551.06; 3] };
    for (in_plane, loads) in [
        (InPlane::Tangential, [0.05, 0.1, 0.2, 0.4, 0.6, 0.8, 1.0, 1.2, 1.4, 1.6, 1.8, 2.0]),
        (InPlane::Pinned, [0.05, 0.1, 0.2, 0.4, 0.6, 0.8, 1.0, 1.2, 1.4, 1.6, 1.8, 2.0]),
    ] {
        let start = std::time::Instant::now();
        let mut parts = quarter(304.8, 3.5052, in_plane, psi);
        parts.material.moduli = Moduli::orthotropic(&of).unwrap();
        let mut plate = body(parts);
        let (values, steps) = curve(&mut plate, &loads, centre);
        let iterations: Vec<usize> = steps.iter().map(|step| step.converged.iterations).collect();
        println!("{values:.5?} {iterations:?} {:?}", start.elapsed());
    }
}
