//! The geometric stiffness: how the tangent changes with the load, along the whole linear response or by its stresses alone.

use crate::effort::CountingSolver;
use crate::vectors::norm;
use crate::{Equilibrium, EquilibriumError};

/// Relative change of the tangent sought when it is differentiated along the load: its error is of the second
/// order in this, rounding of the first order in its inverse.
const PRESTRESS: f64 = 1e-5;
/// Trials of the load step that gives it.
const TRIALS: usize = 8;

/// Which derivative of the tangent the geometric stiffness is.
///
/// With strains ε(q), resultants σ and the linear response u of the unit load, at an unstressed base state
///
/// ```text
/// dK/dλ = (∂²ε u)ᵀ C ∂ε + ∂εᵀ C (∂²ε u) + σ(u)·∂²ε     Rotations
///                                        σ(u)·∂²ε     Stress
/// ```
///
/// The first two terms are the change of shape before buckling, in unknowns that turn with the structure: where they
/// vanish, as in flat plates and straight columns under loads in their plane, the two agree.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(
    feature = "scene",
    derive(serde::Serialize, serde::Deserialize, schemars::JsonSchema),
    serde(rename_all = "kebab-case"),
    schemars(description = "What a linearised buckling analysis holds of the state before buckling.")
)]
pub enum Prebuckling {
    /// The linear response as it is: the change of shape as well as the stresses, in directions that turn along.
    #[default]
    Rotations,
    /// The stresses of the linear response alone, in the undeformed shape, as most finite-element programs have it.
    Stress,
}

impl Prebuckling {
    /// The other of the two.
    fn other(self) -> Self {
        match self {
            Self::Rotations => Self::Stress,
            Self::Stress => Self::Rotations,
        }
    }
}

/// K_g of both kinds.
pub(crate) struct Geometric {
    /// The kind that was asked for, entries of the pattern.
    pub asked: Vec<f64>,
    /// The other kind; none where the system cannot part its stresses from its shape.
    pub other: Option<Vec<f64>>,
    /// The linear response to a unit of level.
    pub response: Vec<f64>,
}

/// `K_g` about the equilibrium at `level`, by central differences between the levels ± δ along the linear response.
///
/// The solver holds the factor of `base`. The stiffness of loads that follow the structure is part of the tangent, and
/// of K_g in either case. The state is put back.
pub(crate) fn along_load<E: Equilibrium + ?Sized>(
    system: &mut E,
    level: f64,
    kind: Prebuckling,
    pattern: &[(usize, usize)],
    base: &[f64],
    solver: &mut CountingSolver<'_>,
) -> Result<Geometric, EquilibriumError> {
    let mut response = vec![0.0; system.unknowns()];
    system.load_rate(level, &mut response);
    let load = norm(&response);
    solver.solve(&mut response).map_err(|error| error.named(system, 0, level))?;

    let mut difference = |kind: Prebuckling, delta: f64| -> Option<Vec<f64>> {
        let mut ends = [vec![0.0; pattern.len()], vec![0.0; pattern.len()]];
        for (values, delta) in ends.iter_mut().zip([delta, -delta]) {
            let motion: Vec<f64> = response.iter().map(|u| delta * u).collect();
            match kind {
                Prebuckling::Rotations => system.turned_tangent([level, level + delta], &motion, values),
                Prebuckling::Stress if system.stressed_tangent(level + delta, &motion, values) => {}
                Prebuckling::Stress => return None,
            }
        }
        let [plus, minus] = ends;
        Some(plus.iter().zip(&minus).map(|(p, m)| (p - m) / (2.0 * delta)).collect())
    };
    let scale = solver.scale().to_vec();
    let scaled = |values: &[f64]| {
        let square = |(&(i, j), v): (&(usize, usize), &f64)| (v * scale[i] * scale[j]).powi(2);
        pattern.iter().zip(values).map(square).sum::<f64>().sqrt()
    };
    let stiffness = scaled(base);
    let mut delta = PRESTRESS;
    let mut change = 0.0;
    for _ in 0..TRIALS {
        solver.ask()?;
        let asked = difference(kind, delta).ok_or(EquilibriumError::Inseparable)?;
        change = delta * scaled(&asked) / stiffness;
        if (0.5..2.0).contains(&(change / PRESTRESS)) {
            let other = difference(kind.other(), delta);
            return Ok(Geometric { asked, other, response });
        }
        // far from the goal the change may be all rounding: approach by bounded factors
        delta *= (PRESTRESS / change).clamp(1e-4, 1e4);
    }
    if change < 0.1 * PRESTRESS {
        return Err(EquilibriumError::NoPrestress { level, load, change });
    }
    let asked = difference(kind, delta).ok_or(EquilibriumError::Inseparable)?;
    let other = difference(kind.other(), delta);
    Ok(Geometric { asked, other, response })
}
