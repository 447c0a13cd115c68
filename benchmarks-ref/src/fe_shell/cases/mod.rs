//! The reference problems on the finite-element shell: one function per case, resolution in, figures out.

mod buckling;
mod curved;
mod linear;
mod panel;
mod plates;
mod strips;

pub use buckling::{column_buckling, plate_buckling, plate_path, plate_shortened};
pub use curved::{hemisphere_with_hole_large, open_cylinder, pinched_cylinder_large};
pub use linear::{
    TwistedBeam, hemisphere_of_thickness, hemisphere_with_hole, pinched_cylinder, scordelis_lo, twisted_beam,
};
pub use panel::{DeformedShape, PanelSection, panel, panel_path, panel_shape};
pub use plates::{PlateEdges, plate_centre_against_corners, plate_deflection, plate_frequencies};
pub use strips::{Strip, end_moment, end_shear};

use super::{FeShellError, Model};
use implicit_statics::{
    Control, Equilibrium, EquilibriumError, Path, PathOptions, Start, SymmetricSolver, follow,
};
use std::ops::ControlFlow;
use std::time::Instant;
use thiserror::Error;

/// Why a case has no result.
#[derive(Debug, Error)]
pub enum CaseError {
    /// The model cannot be built.
    #[error(transparent)]
    Build(#[from] FeShellError),
    /// The balance is not found.
    #[error(transparent)]
    Balance(#[from] EquilibriumError),
    /// A controlled displacement is held by the supports.
    #[error(
        "the displacement that drives the case \"{0}\" is held; its supports and its load contradict each other"
    )]
    Held(&'static str),
}

/// Figures of one run.
#[derive(Debug, Clone, PartialEq)]
pub struct Solved {
    /// Names of the columns, with their units.
    pub columns: Vec<&'static str>,
    /// A row per state, or one row for a linear case.
    pub rows: Vec<Vec<f64>>,
    /// Nodes of the mesh.
    pub nodes: usize,
    /// Mean spacing of the nodes: the square root of their mean area \[L\].
    pub spacing: f64,
    /// Free degrees of freedom.
    pub unknowns: usize,
    /// Tangents factorised; one for a linear case.
    pub iterations: usize,
    /// Wall time without building the mesh \[s\].
    pub seconds: f64,
}

impl Solved {
    /// A column by its number.
    pub fn column(&self, index: usize) -> Vec<f64> {
        self.rows.iter().map(|row| row[index]).collect()
    }
}

/// Displacements under the load at level one, linear from the reference configuration.
fn solve_linear(
    mut model: Model,
    columns: &[&'static str],
    read: impl Fn(&Model, &[f64]) -> Vec<f64>,
) -> Result<Solved, CaseError> {
    let start = Instant::now();
    let pattern = model.pattern();
    let mut solver = SymmetricSolver::new(model.unknowns(), &pattern)?;
    let mut values = vec![0.0; pattern.len()];
    model.tangent(0.0, &mut values);
    solver.factor(&values)?;
    let mut motion = vec![0.0; model.unknowns()];
    model.external(1.0, &mut motion);
    solver.solve(&mut motion)?;
    Ok(Solved {
        columns: columns.to_vec(),
        rows: vec![read(&model, &motion)],
        nodes: model.nodes(),
        spacing: model.spacing(),
        unknowns: model.unknowns(),
        iterations: 1,
        seconds: start.elapsed().as_secs_f64(),
    })
}

/// Values of modes as rows `mode, value`, counted from one.
fn numbered(values: Vec<f64>) -> Vec<Vec<f64>> {
    values.into_iter().enumerate().map(|(i, value)| vec![(i + 1) as f64, value]).collect()
}

/// The path from rest under a control; every converged state becomes a row.
///
/// The second part tells how the path ended: a failure on the way keeps the rows before it.
fn solve_path(
    model: Model,
    options: &PathOptions,
    columns: &[&'static str],
    read: impl Fn(f64, &Model) -> Vec<f64>,
) -> Result<(Solved, Path), CaseError> {
    let start = Instant::now();
    let mut rows = Vec::new();
    let mut options = options.clone();
    options.newton.line_search = false;
    let mut model = model.predict_resultants();
    let path = follow(&mut model, &Start::default(), &options, |point, model| {
        rows.push(read(point.level(), model));
        ControlFlow::Continue(())
    });
    let solved = Solved {
        columns: columns.to_vec(),
        rows,
        nodes: model.nodes(),
        spacing: model.spacing(),
        unknowns: model.unknowns(),
        iterations: path.points.iter().map(|point| point.converged.iterations + 1).sum(),
        seconds: start.elapsed().as_secs_f64(),
    };
    Ok((solved, path))
}

/// Load steps of constant size up to level one.
fn load_steps(steps: usize) -> PathOptions {
    constant(PathOptions::new(Control::Load { step: 1.0 / steps as f64, until: 1.0 }))
}

/// Steps of constant size of one displacement.
fn displacement_steps(unknown: usize, until: f64, steps: usize) -> PathOptions {
    let functional = vec![(unknown, until.signum())];
    let step = until.abs() / steps as f64;
    constant(PathOptions::new(Control::Displacement { functional, step, until: until.abs() }))
}

/// Steps that neither grow nor shrink with the number of iterations; one that fails is still cut.
fn constant(options: PathOptions) -> PathOptions {
    PathOptions { largest: 1.0, target_iterations: options.newton.iterations, ..options }
}
