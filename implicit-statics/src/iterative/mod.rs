//! The linear answer without a factor of the whole tangent: conjugate gradients \[hestenes1952\] with a cycle of multigrid.
//!
//! A direct factor of a surface of n particles takes memory as n log n and is the better way as long as there is room: on thin shells
//! the number of iterations grows with the spacing over the thickness, since nodes by themselves cannot bend without shear.

mod aggregates;
mod multigrid;
mod rows;

use crate::vectors::dot;
use crate::{Equilibrium, EquilibriumError};
use aggregates::Nodes;
use multigrid::Multigrid;
use rows::Rows;

/// How conjugate gradients iterate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConjugateOptions {
    /// Residual over load at which they end, both in the norm of the preconditioner: near the error in the energy norm \[–\].
    pub tolerance: f64,
    /// Iterations allowed.
    pub iterations: usize,
}

impl Default for ConjugateOptions {
    fn default() -> Self {
        Self { tolerance: 1e-9, iterations: 5000 }
    }
}

/// A linear answer and what it took.
#[derive(Clone, Debug, PartialEq)]
pub struct Iterated {
    /// `K⁻¹ p` by unknown.
    pub response: Vec<f64>,
    /// Iterations made.
    pub iterations: usize,
    /// Residual over load at the end, in the norm of the preconditioner.
    pub residual: f64,
    /// Unknowns of each level of multigrid, finest first.
    pub levels: Vec<usize>,
}

/// [`crate::linear_response`] without a factor of the whole tangent. The state stays. The same bits for any number of threads.
///
/// # Errors
/// [`EquilibriumError`] if it does not converge, if the tangent is not positive definite, and for systems that do not tell their
/// places and rigid motions.
pub fn conjugate_response<E: Equilibrium + ?Sized>(
    system: &mut E,
    level: f64,
    options: &ConjugateOptions,
) -> Result<Iterated, EquilibriumError> {
    let n = system.unknowns();
    let rigid = system.rigid_motions().ok_or(EquilibriumError::NoRigidMotions)?;
    let places = system.coordinates().ok_or(EquilibriumError::NoRigidMotions)?;
    let matrix = {
        let pattern = system.pattern();
        let mut values = vec![0.0; pattern.len()];
        system.tangent(level, &mut values);
        if !system.beside_pattern(level).is_empty() {
            let (what, instead) = ("conjugate gradients", "use the direct solver");
            return Err(EquilibriumError::BesidePattern { what, instead });
        }
        Rows::symmetric(n, &pattern, &values)
    };
    // A node: unknowns that follow each other at one place.
    let begin = (0..=n).filter(|&i| i == 0 || i == n || places[i] != places[i - 1]).collect();
    let mut load = vec![0.0; n];
    system.load_rate(level, &mut load);
    if load.iter().all(|&f| f == 0.0) {
        return Ok(Iterated { response: load, iterations: 0, residual: 0.0, levels: vec![n] });
    }
    let mut multigrid = Multigrid::new(matrix, Nodes { begin, rigid })?;
    iterate(&mut multigrid, load, options)
}

fn iterate(
    multigrid: &mut Multigrid,
    load: Vec<f64>,
    options: &ConjugateOptions,
) -> Result<Iterated, EquilibriumError> {
    let n = load.len();
    let (mut x, mut residual, mut z) = (vec![0.0; n], load, vec![0.0; n]);
    multigrid.cycle(&residual, &mut z)?;
    let (mut p, mut kp) = (z.clone(), vec![0.0; n]);
    let whole = dot(&residual, &z);
    let mut square = whole;
    let mut iterations = 0;
    let levels = multigrid.unknowns();
    if multigrid.finest().is_none() {
        return Ok(Iterated { response: z, iterations, residual: 0.0, levels });
    }
    loop {
        if square.is_nan() || square < 0.0 {
            return Err(EquilibriumError::Indefinite { found: "by the preconditioner" });
        }
        let left = (square / whole).sqrt();
        if left <= options.tolerance {
            return Ok(Iterated { response: x, iterations, residual: left, levels });
        }
        if iterations == options.iterations {
            let bound = options.tolerance;
            return Err(EquilibriumError::NotIterated { iterations, residual: left, bound });
        }
        if let Some(matrix) = multigrid.finest() {
            matrix.apply(&p, &mut kp);
        }
        let curvature = dot(&p, &kp);
        if curvature.is_nan() || curvature <= 0.0 {
            return Err(EquilibriumError::Indefinite { found: "along a search direction" });
        }
        let step = square / curvature;
        for i in 0..n {
            x[i] += step * p[i];
            residual[i] -= step * kp[i];
        }
        multigrid.cycle(&residual, &mut z)?;
        let next = dot(&residual, &z);
        let ratio = next / square;
        p.iter_mut().zip(&z).for_each(|(p, z)| *p = z + ratio * *p);
        (square, iterations) = (next, iterations + 1);
    }
}
