//! Where strains are sampled and how wide the stencils reach.

use sph_core::Kernel;

/// How far the stencil of a stress point reaches.
#[derive(Clone, Copy)]
pub enum Reach {
    /// The particles of the cell, in closed form: the compact limit of the corrected kernel.
    Cell,
    /// A corrected kernel reaching this many times the distance to the fourth nearest particle \[–\].
    Kernel(&'static dyn Kernel, f64),
}

/// How the strong form reads the divergence.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "scene",
    derive(serde::Deserialize, schemars::JsonSchema),
    serde(rename_all = "kebab-case")
)]
pub enum Divergence {
    /// `Σ (P_b + P_a)·∇W`, as printed: at edges far off.
    #[default]
    Sum,
    /// `Σ (P_b − P_a)·∇W` with the resultants of edges prescribed.
    Difference,
}

/// Where strains are sampled; everything after the stencil is the same code.
#[derive(Clone, Copy)]
pub enum Formulation {
    /// One sampling point per cell of the cloud.
    StressPoint(Reach),
    /// Sampling at the particles by weighted least squares of the given order, as the adjoint of an energy.
    Nodal {
        /// Polynomials up to this order are differentiated exactly (1, 2 or 3).
        order: usize,
        /// Smoothing length over local spacing \[–\].
        smoothing: f64,
        /// Whether gradients are changed so that their transpose balances constant stress.
        consistent: bool,
        /// Weight function.
        kernel: &'static dyn Kernel,
    },
    /// Eqs. 4, 8 and 9 of \[lin2013\]: balance at the particles with each particle's own corrected gradient.
    StrongForm {
        /// Smoothing length over local spacing \[–\].
        smoothing: f64,
        /// Factor μ of the artificial viscosity \[–\] (the paper: 1 to 4).
        viscosity: f64,
        /// Reading of the divergence.
        divergence: Divergence,
        /// Weight function.
        kernel: &'static dyn Kernel,
    },
}

impl Formulation {
    /// Name in scenes and reports, with its sampling and reach.
    pub fn method(&self) -> String {
        match self {
            Self::StressPoint(Reach::Cell) => "stress-point cell".into(),
            Self::StressPoint(Reach::Kernel(_, reach)) => format!("stress-point {reach}"),
            Self::Nodal { order, .. } => format!("nodal {order}"),
            Self::StrongForm { smoothing, divergence: Divergence::Sum, .. } => {
                format!("strong-form {smoothing}")
            }
            Self::StrongForm { smoothing, .. } => format!("strong-form difference {smoothing}"),
        }
    }
}

impl std::fmt::Debug for Formulation {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.method())
    }
}
