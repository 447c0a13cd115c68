//! The hinged cylindrical panel under a central force: through the limit point, and around the snap-back.

use super::{CaseError, Solved, displacement_steps, solve_path};
use crate::fe_shell::{Load, Mesh, Model, Orthotropic, Ply, Section, Side, Support};
use implicit_statics::{Control, PathOptions};
use nalgebra::Vector3;
use std::f64::consts::FRAC_PI_2;

/// What the panel is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PanelSection {
    /// E = 3102.75 N/mm², ν = 0.3.
    Isotropic,
    /// Three plies: along the axis, around, along.
    AxialAroundAxial,
    /// Three plies: around, along the axis, around.
    AroundAxialAround,
}

impl PanelSection {
    fn section(self, thickness: f64) -> Section {
        // shear across the fibres as in the check of the tables; they name E_L, E_T, G_LT and nu_LT alone
        let material = Orthotropic {
            along: 3300.0,
            across: 1100.0,
            poisson: 0.25,
            shear: 660.0,
            shear_across: 660.0,
            density: 1.0e-9,
        };
        let plies = |angles: [f64; 3]| angles.map(|angle| Ply { thickness: thickness / 3.0, angle });
        match self {
            Self::Isotropic => Section::isotropic(3102.75, 0.3, thickness, 1.0e-9),
            Self::AxialAroundAxial => Section::layered(&material, &plies([0.0, FRAC_PI_2, 0.0])),
            Self::AroundAxialAround => Section::layered(&material, &plies([FRAC_PI_2, 0.0, FRAC_PI_2])),
        }
    }
}

const NAMES: [&str; 3] = ["P [N]", "w_crown [mm]", "w_edge [mm]"];

/// One quarter of the panel; the level is the whole force \[N\].
fn quarter(n: usize, thickness: f64, section: PanelSection) -> Result<(Mesh, Model), CaseError> {
    let mesh = Mesh::cylinder(n, n, 2540.0, 254.0, 0.1, 1.0);
    let supports = [
        Support::symmetry(mesh.side(Side::XiStart), Vector3::x()),
        Support::symmetry(mesh.side(Side::EtaStart), Vector3::y()),
        Support::hinge(mesh.side(Side::EtaEnd)),
    ];
    let loads = [Load::Node(mesh.node(0, 0), Vector3::new(0.0, 0.0, -0.25))];
    let model = Model::new(&mesh, section.section(thickness), Vector3::x(), &supports, &loads)?;
    Ok((mesh, model))
}

fn reader(mesh: &Mesh, n: usize) -> impl Fn(f64, &Model) -> Vec<f64> + use<> {
    let (crown, edge) = (mesh.node(0, 0), mesh.node(n, 0));
    move |level, model| vec![level, -model.displacement(crown).z, -model.displacement(edge).z]
}

/// Displacement of the crown driven to `until` \[mm\] in equal steps, n elements on each side of the quarter.
pub fn panel(
    n: usize,
    thickness: f64,
    section: PanelSection,
    until: f64,
    steps: usize,
) -> Result<Solved, CaseError> {
    let (mesh, model) = quarter(n, thickness, section)?;
    let driven = model.unknown(mesh.node(0, 0), &Vector3::z()).ok_or(CaseError::Held("panel"))?;
    let options = displacement_steps(driven, -until, steps);
    let (solved, path) = solve_path(model, &options, &NAMES, reader(&mesh, n))?;
    path.end?;
    Ok(solved)
}

/// Nodes \[mm\], and those of each element.
pub type DeformedShape = (Vec<Vector3<f64>>, Vec<[usize; 4]>);

/// The nodes of the quarter \[mm\] where the crown is at `until` \[mm\], driven there in so many steps, with the axis of the cylinder along y as in
/// the scene of the particles, and the nodes of the elements.
pub fn panel_shape(
    n: usize,
    thickness: f64,
    section: PanelSection,
    until: f64,
    steps: usize,
) -> Result<DeformedShape, CaseError> {
    let (mesh, model) = quarter(n, thickness, section)?;
    let driven = model.unknown(mesh.node(0, 0), &Vector3::z()).ok_or(CaseError::Held("panel"))?;
    let rest = mesh.positions.clone();
    let read = move |_: f64, model: &Model| {
        let moved = |(node, x): (usize, &Vector3<f64>)| (x + model.displacement(node)).yxz();
        rest.iter().enumerate().map(moved).flat_map(|x| [x.x, x.y, x.z]).collect()
    };
    let (solved, path) = solve_path(model, &displacement_steps(driven, -until, steps), &[], read)?;
    path.end?;
    let last = solved.rows.last().map_or(&[][..], Vec::as_slice);
    Ok((last.chunks_exact(3).map(Vector3::from_column_slice).collect(), mesh.elements()))
}

/// The whole path by arc length, from rest until the force leaves −`bound` … `bound` \[N\]; the first step is what 10 N
/// would make, later ones up to six times that.
pub fn panel_path(n: usize, thickness: f64, section: PanelSection, bound: f64) -> Result<Solved, CaseError> {
    let (mesh, model) = quarter(n, thickness, section)?;
    let mut options = PathOptions::new(Control::ArcLength { first: 10.0, range: (-bound, bound) });
    options.largest = 6.0;
    let (solved, path) = solve_path(model, &options, &NAMES, reader(&mesh, n))?;
    path.end?;
    Ok(solved)
}
