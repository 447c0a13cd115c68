//! The linear obstacle course: roof, pinched cylinder, hemisphere with hole, twisted beam.
//!
//! Data as in `linear_obstacle_course`; n elements on each side of the part that symmetry leaves.

use super::{CaseError, Solved, solve_linear};
use crate::fe_shell::{Load, Mesh, Model, Section, Side, Support};
use nalgebra::Vector3;

/// Scordelis–Lo roof, one quarter: downward displacement of the middle of the free edge \[ft\]; reference 0.3024.
pub fn scordelis_lo(n: usize) -> Result<Solved, CaseError> {
    let (radius, half_length, angle) = (25.0, 25.0, 40.0_f64.to_radians());
    let mesh = Mesh::cylinder(n, n, radius, half_length, angle, 1.0);
    let supports = [
        Support::symmetry(mesh.side(Side::XiStart), Vector3::x()),
        Support::diaphragm(mesh.side(Side::XiEnd), Vector3::x()),
        Support::symmetry(mesh.side(Side::EtaStart), Vector3::y()),
    ];
    let section = Section::isotropic(4.32e8, 0.0, 0.25, 1.0);
    let model = Model::new(&mesh, section, Vector3::x(), &supports, &[Load::Area(-Vector3::z() * 90.0)])?;
    let edge = mesh.node(0, n);
    solve_linear(model, &["w_edge [length]"], |model, motion| vec![-model.displacement_in(motion, edge).z])
}

/// Cylinder between diaphragms pinched by two forces, one eighth: displacement under a force; reference 1.8248e-5.
///
/// Places along and around go with the power `grading` of the lattice: 1 is uniform, more crowds the force.
pub fn pinched_cylinder(n: usize, grading: f64) -> Result<Solved, CaseError> {
    let mesh = Mesh::cylinder(n, n, 300.0, 300.0, std::f64::consts::FRAC_PI_2, grading);
    let section = Section::isotropic(3.0e6, 0.3, 3.0, 1.0);
    let model = Model::new(&mesh, section, Vector3::x(), &eighth(&mesh), &[quarter_force(&mesh)])?;
    let loaded = mesh.node(0, 0);
    solve_linear(model, &["w_load [length]"], |model, motion| vec![-model.displacement_in(motion, loaded).z])
}

/// Supports of one eighth of a cylinder between diaphragms.
pub(super) fn eighth(mesh: &Mesh) -> [Support; 4] {
    [
        Support::symmetry(mesh.side(Side::XiStart), Vector3::x()),
        Support::diaphragm(mesh.side(Side::XiEnd), Vector3::x()),
        Support::symmetry(mesh.side(Side::EtaStart), Vector3::y()),
        Support::symmetry(mesh.side(Side::EtaEnd), Vector3::z()),
    ]
}

/// A quarter of a unit inward force at the crown of the middle section.
pub(super) fn quarter_force(mesh: &Mesh) -> Load {
    Load::Node(mesh.node(0, 0), Vector3::new(0.0, 0.0, -0.25))
}

/// Hemisphere with an 18° hole under two pairs of forces, one quarter: mean of the outward and the inward
/// displacement under the forces; reference 0.0940, computed 0.0937.
pub fn hemisphere_with_hole(n: usize) -> Result<Solved, CaseError> {
    hemisphere_of_thickness(n, HEMISPHERE_THICKNESS)
}

/// The same of some thickness; the radius is 10.
pub fn hemisphere_of_thickness(n: usize, thickness: f64) -> Result<Solved, CaseError> {
    let (mesh, model) = hemisphere(n, thickness, 1.0)?;
    let (out, inward) = (mesh.node(0, 0), mesh.node(n, 0));
    solve_linear(model, &["outward [length]", "inward [length]"], |model, motion| {
        vec![model.displacement_in(motion, out).x, -model.displacement_in(motion, inward).y]
    })
}

/// Thickness of the published hemisphere.
pub(super) const HEMISPHERE_THICKNESS: f64 = 0.04;

/// One quarter of the hemisphere with a force on each loaded node.
pub(super) fn hemisphere(n: usize, thickness: f64, force: f64) -> Result<(Mesh, Model), CaseError> {
    let mesh = Mesh::belt(n, n, 10.0, 72.0_f64.to_radians());
    let (out, inward) = (mesh.node(0, 0), mesh.node(n, 0));
    let supports = [
        Support::symmetry(mesh.side(Side::XiStart), Vector3::y()),
        Support::symmetry(mesh.side(Side::XiEnd), Vector3::x()),
        Support::roller(vec![out], Vector3::z()),
    ];
    let loads = [Load::Node(out, Vector3::x() * force), Load::Node(inward, -Vector3::y() * force)];
    let section = Section::isotropic(6.825e7, 0.3, thickness, 1.0);
    let model = Model::new(&mesh, section, Vector3::z(), &supports, &loads)?;
    Ok((mesh, model))
}

/// The four twisted beams.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TwistedBeam {
    /// Thickness, 0.32 or 0.0032 \[length\].
    pub thickness: f64,
    /// Direction of the tip force: z lies in the plane of the tip, y across it.
    pub direction: Vector3<f64>,
    /// The tip force \[force\].
    pub force: f64,
}

/// Cantilever twisted by a quarter turn: displacement of the middle of the tip along y and z.
///
/// References (z, y): thick 0.005424, 0.001754; thin, for a force of 1e-6, 0.005256, 0.001294.
pub fn twisted_beam(columns: usize, rows: usize, beam: &TwistedBeam) -> Result<Solved, CaseError> {
    let mesh = Mesh::twisted(columns, rows, 12.0, 1.1);
    let supports = [Support::clamp(mesh.side(Side::XiStart))];
    let loads = [Load::Edge(mesh.side(Side::XiEnd), beam.direction * beam.force)];
    let section = Section::isotropic(29.0e6, 0.22, beam.thickness, 1.0);
    let model = Model::new(&mesh, section, Vector3::x(), &supports, &loads)?;
    let (low, high) = (mesh.node(columns, rows / 2), mesh.node(columns, rows.div_ceil(2)));
    solve_linear(model, &["V_tip [length]", "W_tip [length]"], |model, motion| {
        let tip = (model.displacement_in(motion, low) + model.displacement_in(motion, high)) * 0.5;
        vec![tip.y, tip.z]
    })
}
