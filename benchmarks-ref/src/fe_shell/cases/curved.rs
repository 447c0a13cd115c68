//! Doubly symmetric shells under large point forces: hemisphere, open cylinder, cylinder between diaphragms.

use super::linear::{HEMISPHERE_THICKNESS, eighth, hemisphere, quarter_force};
use super::{CaseError, Solved, displacement_steps, load_steps, solve_path};
use crate::fe_shell::{Load, Mesh, Model, Section, Side, Support};
use nalgebra::Vector3;
use std::f64::consts::FRAC_PI_2;

/// Hemisphere with an 18° hole under forces of 400 (200 on the quarter): displacements under them.
pub fn hemisphere_with_hole_large(n: usize, steps: usize) -> Result<Solved, CaseError> {
    let (mesh, model) = hemisphere(n, HEMISPHERE_THICKNESS, 200.0)?;
    let (out, inward) = (mesh.node(0, 0), mesh.node(n, 0));
    let names = ["level [-]", "outward [length]", "inward [length]"];
    let (solved, path) = solve_path(model, &load_steps(steps), &names, |level, model| {
        vec![level, model.displacement(out).x, -model.displacement(inward).y]
    })?;
    path.end?;
    Ok(solved)
}

/// Pull-out of the open cylinder, one eighth: elements along half the length and around the quarter; the
/// displacement under the force is driven to `until` in equal steps.
pub fn open_cylinder(elements: [usize; 2], until: f64, steps: usize) -> Result<Solved, CaseError> {
    let [columns, rows] = elements;
    let mesh = Mesh::cylinder(columns, rows, 4.953, 5.175, FRAC_PI_2, 1.0);
    let supports = [
        Support::symmetry(mesh.side(Side::XiStart), Vector3::x()),
        Support::symmetry(mesh.side(Side::EtaStart), Vector3::y()),
        Support::symmetry(mesh.side(Side::EtaEnd), Vector3::z()),
    ];
    let loads = [Load::Node(mesh.node(0, 0), Vector3::z() * 1.0e4)];
    let section = Section::isotropic(10.5e6, 0.3125, 0.094, 1.0);
    let model = Model::new(&mesh, section, Vector3::x(), &supports, &loads)?;
    let (a, b, c) = (mesh.node(0, 0), mesh.node(0, rows), mesh.node(columns, rows));
    let driven = model.unknown(a, &Vector3::z()).ok_or(CaseError::Held("open cylinder"))?;
    let names = ["load [-]", "W_A [length]", "minus_U_B [length]", "minus_U_C [length]"];
    let options = displacement_steps(driven, until, steps);
    let (solved, path) = solve_path(model, &options, &names, |level, model| {
        vec![level, model.displacement(a).z, -model.displacement(b).y, -model.displacement(c).y]
    })?;
    path.end?;
    Ok(solved)
}

/// Cylinder between diaphragms pinched to large displacements, one eighth, as [`open_cylinder`].
pub fn pinched_cylinder_large(elements: [usize; 2], until: f64, steps: usize) -> Result<Solved, CaseError> {
    let [columns, rows] = elements;
    let mesh = Mesh::cylinder(columns, rows, 100.0, 100.0, FRAC_PI_2, 1.0);
    let section = Section::isotropic(3.0e4, 0.3, 1.0, 1.0);
    let model = Model::new(&mesh, section, Vector3::x(), &eighth(&mesh), &[quarter_force(&mesh)])?;
    let (a, b) = (mesh.node(0, 0), mesh.node(0, rows));
    let driven = model.unknown(a, &Vector3::z()).ok_or(CaseError::Held("pinched cylinder"))?;
    let names = ["load [-]", "minus_W_A [length]", "U_B [length]"];
    let options = displacement_steps(driven, -until, steps);
    let (solved, path) = solve_path(model, &options, &names, |level, model| {
        vec![level / 12000.0, -model.displacement(a).z, model.displacement(b).y]
    })?;
    path.end?;
    Ok(solved)
}
