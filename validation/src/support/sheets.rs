//! Bare sheets for studies: square plates as lists of cells, and shells on them, for what no scene can say.

use coque::{Warning, warnings};
use explicit_dynamics::Amplitude;
use implicit_statics::{Equilibrium, linear_response};
use shell_kinematics::{Isotropic, IsotropicSection, StretchCorrected};
use sph_core::{Cell, Cloud, CubicSpline, Vec3};
use sph_shell::{
    AppliedLoad, Force, Formulation, Load, Parts, Reach, Shell, StaticShell, Support, Supported,
};

use crate::methods::{NODAL_2, NODAL_3, WIDE_14, WIDE_30};

/// Young's modulus \[F/L²\].
pub const YOUNG: f64 = 1e6;
/// Poisson's ratio.
pub const POISSON: f64 = 0.3;
/// Thickness \[L\]; sheets have side one.
pub const THICKNESS: f64 = 0.01;

/// Positions and cells, normals up.
#[derive(Clone, Default)]
pub struct Sheet {
    /// Positions \[L\].
    pub positions: Vec<Vec3>,
    /// Cells.
    pub cells: Vec<Cell>,
}

impl Sheet {
    /// A square of side one from a corner on, n particles a side; particle (i, j) has number i n + j.
    pub fn square(n: usize, corner: Vec3) -> Self {
        let step = 1.0 / (n - 1) as f64;
        let place = |i: usize, j: usize| corner + Vec3::new(i as f64 * step, j as f64 * step, 0.0);
        let cell = |i: usize, j: usize| {
            let a = (i * n + j) as u32;
            Cell::quadrangle([a, a + n as u32, a + n as u32 + 1, a + 1])
        };
        Self {
            positions: (0..n * n).map(|a| place(a / n, a % n)).collect(),
            cells: (0..(n - 1) * (n - 1)).map(|c| cell(c / (n - 1), c % (n - 1))).collect(),
        }
    }

    /// Another sheet beside this one, which keeps its own particles.
    #[must_use]
    pub fn and(mut self, other: &Self) -> Self {
        let first = self.positions.len() as u32;
        self.positions.extend(&other.positions);
        self.cells.extend(other.cells.iter().map(|cell| Cell::quadrangle(cell.corners.map(|a| a + first))));
        self
    }

    /// The cloud; the error in words.
    pub fn cloud(&self) -> Result<Cloud, String> {
        Cloud::from_cells(self.positions.clone(), None, self.cells.clone()).map_err(|error| error.to_string())
    }
}

/// The formulation of a method; cells where it has none of its own here.
fn formulation(method: &str) -> Formulation {
    let nodal =
        |order, smoothing| Formulation::Nodal { order, smoothing, consistent: true, kernel: &CubicSpline };
    match method {
        WIDE_14 => Formulation::StressPoint(Reach::Kernel(&CubicSpline, 1.4)),
        WIDE_30 => Formulation::StressPoint(Reach::Kernel(&CubicSpline, 3.0)),
        NODAL_2 => nodal(2, 1.3),
        NODAL_3 => nodal(3, 1.5),
        _ => Formulation::StressPoint(Reach::Cell),
    }
}

/// Young's modulus \[F/L²\], Poisson's ratio, thickness \[L\], density \[M/L³\].
#[derive(Clone, Copy, Debug)]
pub struct MaterialSection {
    pub young: f64,
    pub poisson: f64,
    pub thickness: f64,
    pub density: f64,
}

/// A shell on a cloud; the error in words.
pub fn shell(
    cloud: Cloud,
    method: &str,
    supports: Vec<Supported>,
    loads: Vec<Box<dyn Load>>,
) -> Result<Shell, String> {
    let body = MaterialSection { young: YOUNG, poisson: POISSON, thickness: THICKNESS, density: 1.0 };
    shell_of(body, cloud, method, supports, loads)
}

/// A shell of some material and thickness on a cloud; the error in words.
pub fn shell_of(
    body: MaterialSection,
    cloud: Cloud,
    method: &str,
    supports: Vec<Supported>,
    loads: Vec<Box<dyn Load>>,
) -> Result<Shell, String> {
    let material = Isotropic::new(body.young, body.poisson).map_err(|error| error.to_string())?;
    let section = IsotropicSection::new(material, body.thickness).map_err(|error| error.to_string())?;
    let constant = |load| AppliedLoad { load, amplitude: Amplitude::Constant };
    let parts = Parts {
        cloud,
        section: Box::new(section),
        strain: &StretchCorrected,
        material_axis: None,
        density: body.density,
        formulation: formulation(method),
        supports,
        loads: loads.into_iter().map(constant).collect(),
        threads: 1,
    };
    Shell::builder(parts).build().map_err(|error| error.to_string())
}

/// Part of the load at which the linear answer is read: directors turn along arcs.
const SMALL: f64 = 1e-6;

/// What a linear study finds.
pub struct Answer {
    /// Displacements of all particles \[L\].
    pub motion: Vec<Vec3>,
    /// What coque tells of the shell.
    pub warnings: Vec<Warning>,
}

/// Displacements of all particles under the loads, linear from rest; the error in words.
pub fn linear(shell: Shell) -> Result<Answer, String> {
    let warnings = warnings(&shell);
    let mut system = StaticShell::new(shell);
    let motion = linear_response(&mut system, 0.0).map_err(|error| error.to_string())?;
    system.update(&motion.iter().map(|q| q * SMALL).collect::<Vec<f64>>());
    let motion = (0..system.shell().len()).map(|a| system.shell().displacement(a) / SMALL).collect();
    Ok(Answer { motion, warnings })
}

/// A support on particles.
pub fn supported(particles: Vec<u32>, support: impl Support + 'static) -> Supported {
    Supported { particles, support: Box::new(support) }
}

/// A dead force with shares.
pub fn force(shares: Vec<(u32, f64)>, total: Vec3) -> Box<dyn Load> {
    Box::new(Force { shares, total })
}
