//! What is refused at a point.

/// Constants that are no elastic material.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ElasticError {
    /// A constant out of bounds.
    #[error("{what} is {value}; it must be {bound}")]
    Constant {
        /// Which.
        what: &'static str,
        /// Its value.
        value: f64,
        /// What it must be.
        bound: &'static str,
    },
    /// Moduli with preferred directions of a material that flows.
    #[error(
        "a material that flows by von Mises' criterion has preferred directions; give it isotropic moduli"
    )]
    Preferred,
    /// Some strain would store no energy.
    #[error(
        "the orthotropic compliance is not positive definite: its least pivot over 1/E is {pivot:.3e}; lower Poisson's ratios, each |nu_ij| below sqrt(E_i/E_j)"
    )]
    Indefinite {
        /// The pivot that is not positive.
        pivot: f64,
    },
}

/// A deformation that an update cannot follow.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum PointError {
    /// The material would be turned inside out.
    #[error("det F is {determinant:.3e}; it must be positive: take smaller steps or more nodes")]
    Inverted {
        /// Determinant of the deformation gradient, or of its mean over the step.
        determinant: f64,
    },
    /// Strain and rotation do not exist.
    #[error(
        "the rotation of the step has sin θ = {sine:.4}; the decomposition exists up to 1: take smaller steps"
    )]
    BeyondRightAngle {
        /// Its sine.
        sine: f64,
    },
}
