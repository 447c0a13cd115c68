//! Prescribed displacements as linear equations between nodal parameters, eliminated.
//!
//! Collocation asks `Σ_J φ_J(X_I) n·d_J = λ ū` of every condition. Elimination with complete pivots gives as many *held* parameters in
//! terms of the free ones, `d_h = Σ T_hj q_j + λ g_h`; dependent equations that agree drop out. Without the border of
//! multipliers the stiffness stays that of a mechanical system: its inertia counts what is unstable.

use sph_core::{PointShape, Vec3};

use crate::error::GalerkinError;
use crate::parts::{Condition, Essential};

/// A pivot below this share of the first is an equation that depends on the others.
const DEPENDENT: f64 = 1e-8;
/// Coefficients below this are rounding.
const ROUNDING: f64 = 1e-14;
/// Not an unknown.
pub(crate) const HELD: u32 = u32::MAX;

/// A held parameter in terms of the unknowns.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct HeldParameter {
    /// The parameter: three times its node and the axis.
    pub parameter: u32,
    /// Unknowns with their coefficients T.
    pub terms: Vec<(u32, f64)>,
    /// Value at level one, unknowns zero \[L\].
    pub rate: f64,
}

/// Which parameters are unknowns, and what the others are.
#[derive(Clone, Debug, Default)]
pub(crate) struct Unknowns {
    /// Parameter of every unknown.
    pub parameters: Vec<u32>,
    /// Unknown of every parameter, or [`HELD`].
    pub of: Vec<u32>,
    /// The held ones.
    pub held: Vec<HeldParameter>,
    /// Equations that said nothing new.
    pub dropped: usize,
    /// Whether any held value goes with the level.
    pub moves: bool,
}

/// One equation over parameters.
struct Equation {
    node: u32,
    terms: Vec<(u32, f64)>,
    value: f64,
}

impl Unknowns {
    /// Eliminates the conditions of a body with these shape functions at its nodes.
    pub fn new(
        nodal: &[PointShape],
        conditions: &[Condition],
        essential: Essential,
    ) -> Result<Self, GalerkinError> {
        let equations = equations(nodal, conditions, essential)?;
        let mut out = Self { of: vec![0; 3 * nodal.len()], ..Self::default() };
        let along = |equation: &Equation| {
            let axis = equation.terms.first().map_or(0, |term| term.0 % 3);
            equation.terms.iter().all(|term| term.0 % 3 == axis).then_some(axis)
        };
        let mut solved = Vec::new();
        // Equations along different axes have no parameter in common.
        if equations.iter().all(|equation| along(equation).is_some()) {
            let mut by_axis = [const { Vec::new() }; 3];
            for equation in equations {
                by_axis[along(&equation).unwrap_or(0) as usize].push(equation);
            }
            for group in by_axis {
                out.dropped += eliminate(&group, &mut solved)?;
            }
        } else {
            out.dropped += eliminate(&equations, &mut solved)?;
        }
        solved.sort_by_key(|row| row.parameter);
        solved.iter().for_each(|row| out.of[row.parameter as usize] = HELD);
        for parameter in 0..out.of.len() {
            if out.of[parameter] != HELD {
                out.of[parameter] = out.parameters.len() as u32;
                out.parameters.push(parameter as u32);
            }
        }
        for row in &mut solved {
            row.terms.iter_mut().for_each(|term| term.0 = out.of[term.0 as usize]);
        }
        out.moves = solved.iter().any(|row| row.rate != 0.0);
        out.held = solved;
        Ok(out)
    }

    /// Number of unknowns.
    pub fn count(&self) -> usize {
        self.parameters.len()
    }

    /// Puts held parameters where a level and the unknowns have them.
    pub fn put(&self, level: f64, parameters: &mut [f64]) {
        for held in &self.held {
            let sum: f64 =
                held.terms.iter().map(|&(u, t)| t * parameters[self.parameters[u as usize] as usize]).sum();
            parameters[held.parameter as usize] = sum + level * held.rate;
        }
    }

    /// Forces on unknowns from those on parameters: `f_j + Σ_h T_hj f_h`.
    pub fn project(&self, forces: &[f64], out: &mut [f64]) {
        for (out, parameter) in out.iter_mut().zip(&self.parameters) {
            *out = forces[*parameter as usize];
        }
        for held in &self.held {
            let force = forces[held.parameter as usize];
            held.terms.iter().for_each(|&(u, t)| out[u as usize] += t * force);
        }
    }
}

fn equations(
    nodal: &[PointShape],
    conditions: &[Condition],
    essential: Essential,
) -> Result<Vec<Equation>, GalerkinError> {
    let mut out = Vec::new();
    for condition in conditions {
        if condition.nodes.is_empty() {
            return Err(GalerkinError::EmptySet("a condition"));
        }
        let length = condition.direction.norm();
        if !(length > 0.0 && length.is_finite()) {
            return Err(GalerkinError::Direction(length));
        }
        if !condition.by.is_finite() {
            let (what, value) = ("the displacement of condition", condition.by);
            return Err(GalerkinError::NotFinite { what, number: out.len(), value });
        }
        let n: Vec3 = condition.direction / length;
        for &node in &condition.nodes {
            let Some(shape) = nodal.get(node as usize) else {
                let count = nodal.len();
                return Err(GalerkinError::NoSuchNode { what: "a condition", node, count });
            };
            let own = ([node], [1.0]);
            let (nodes, values): (&[u32], &[f64]) = match essential {
                Essential::Collocation => (&shape.nodes, &shape.values),
                Essential::Direct => (&own.0, &own.1),
            };
            let terms = nodes.iter().zip(values).flat_map(|(&b, &phi)| {
                (0..3).filter(|&k| n[k] != 0.0).map(move |k| (3 * b + k as u32, phi * n[k]))
            });
            out.push(Equation { node, terms: terms.collect(), value: condition.by });
        }
    }
    Ok(out)
}

/// Solves equations for as many parameters by Gauss and Jordan with complete pivots; the number of those that said nothing.
fn eliminate(equations: &[Equation], solved: &mut Vec<HeldParameter>) -> Result<usize, GalerkinError> {
    let mut columns: Vec<u32> = equations.iter().flat_map(|e| e.terms.iter().map(|term| term.0)).collect();
    columns.sort_unstable();
    columns.dedup();
    let (m, n) = (equations.len(), columns.len());
    let width = n + 1; // the last is the value
    let mut rows = vec![0.0; m * width];
    for (i, equation) in equations.iter().enumerate() {
        for (parameter, value) in &equation.terms {
            let at = columns.partition_point(|column| column < parameter);
            rows[i * width + at] += value;
        }
        rows[i * width + n] = equation.value;
    }
    let mut pivots: Vec<(usize, usize)> = Vec::new();
    let mut open = vec![true; m];
    let mut first = 0.0;
    while pivots.len() < m {
        let mut best = (0.0, 0, 0);
        for i in (0..m).filter(|&i| open[i]) {
            for (j, value) in rows[i * width..][..n].iter().enumerate() {
                if value.abs() > best.0 {
                    best = (value.abs(), i, j);
                }
            }
        }
        let (size, row, column) = best;
        first = f64::max(first, size);
        if size <= DEPENDENT * first {
            break;
        }
        open[row] = false;
        pivots.push((row, column));
        let pivot = rows[row * width + column];
        let own: Vec<f64> = rows[row * width..][..width].iter().map(|value| value / pivot).collect();
        for i in (0..m).filter(|&i| i != row) {
            let share = rows[i * width + column];
            if share != 0.0 {
                let other = &mut rows[i * width..][..width];
                other.iter_mut().zip(&own).for_each(|(value, own)| *value -= share * own);
                other[column] = 0.0;
            }
        }
        rows[row * width..][..width].copy_from_slice(&own);
    }
    let scale = equations.iter().fold(0.0, |most: f64, e| most.max(e.value.abs()));
    for i in (0..m).filter(|&i| open[i]) {
        let left = rows[i * width + n];
        if left.abs() > DEPENDENT * scale {
            let Equation { node, value, .. } = equations[i];
            return Err(GalerkinError::Contradiction { node, wanted: value, left });
        }
    }
    let mut leads = vec![false; n];
    pivots.iter().for_each(|pivot| leads[pivot.1] = true);
    for &(row, column) in &pivots {
        let own = &rows[row * width..][..width];
        let terms =
            (0..n).filter(|&j| !leads[j] && own[j].abs() > ROUNDING).map(|j| (columns[j], -own[j])).collect();
        solved.push(HeldParameter { parameter: columns[column], terms, rate: own[n] });
    }
    Ok(m - pivots.len())
}
