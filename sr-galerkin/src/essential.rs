//! Prescribed displacements as linear equations between nodal parameters, eliminated.
//!
//! Collocation asks `Σ_J φ_J(X_I) n·d_J = λ ū` of every condition. Elimination gives as many *held* parameters in terms of the free
//! ones, `d_h = Σ T_hj q_j + Σ_c G_hc λū_c`; dependent equations that agree drop out. Without the border of
//! multipliers the stiffness stays that of a mechanical system: its inertia counts what is unstable.
//!
//! A unit of a condition moves held parameters by G_hc, the free ones staying: the work of the forces that balance the body on this
//! motion, `Σ_h G_hc (f_int − f_ext)_h`, is the force with which the condition holds its nodes.

use heat_conduction::Eliminated;
use sph_core::{PointShape, Vec3};

use crate::discretisation::Discretisation;
use crate::error::GalerkinError;
use crate::parts::{Condition, Essential};

/// An equation of which the others leave less than this share depends on them.
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
    /// Conditions with the value that a unit of each gives, unknowns zero: G.
    pub moves: Vec<(u32, f64)>,
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
    condition: u32,
    terms: Vec<(u32, f64)>,
}

impl Unknowns {
    /// Eliminates the conditions of a body with these shape functions at its nodes.
    pub fn new(
        space: &Discretisation,
        conditions: &[Condition],
        essential: Essential,
    ) -> Result<Self, GalerkinError> {
        let equations = equations(space, conditions, essential)?;
        let mut out = Self { of: vec![0; 3 * space.nodes.len()], ..Self::default() };
        let by: Vec<f64> = conditions.iter().map(|condition| condition.by).collect();
        let mut solved = eliminate(&equations, &by, 3 * space.nodes.len())?;
        out.dropped = equations.len() - solved.len();
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

    /// Forces with which conditions hold their nodes, from those on parameters that balance the body \[F\].
    pub fn reactions(&self, forces: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        for held in &self.held {
            let force = forces[held.parameter as usize];
            held.moves.iter().for_each(|&(condition, g)| out[condition as usize] += g * force);
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
    space: &Discretisation,
    conditions: &[Condition],
    essential: Essential,
) -> Result<Vec<Equation>, GalerkinError> {
    let mut out = Vec::new();
    for (number, condition) in conditions.iter().enumerate() {
        if condition.nodes.is_empty() {
            return Err(GalerkinError::EmptySet("a condition"));
        }
        let length = condition.direction.norm();
        if !(length > 0.0 && length.is_finite()) {
            return Err(GalerkinError::Direction(length));
        }
        if !condition.by.is_finite() {
            let (what, value) = ("the displacement of condition", condition.by);
            return Err(GalerkinError::NotFinite { what, number, value });
        }
        let n: Vec3 = condition.direction / length;
        for &node in &condition.nodes {
            let Some(shape) = space.nodal.get(node as usize) else {
                let count = space.nodal.len();
                return Err(GalerkinError::NoSuchNode { what: "a condition", node, count });
            };
            let terms = row(space, essential, shape, (node, n));
            out.push(Equation { node, condition: number as u32, terms });
        }
    }
    Ok(out)
}

/// Coefficients of the displacement of a node along a direction, by parameters; one may stand there twice.
pub(crate) fn row(
    space: &Discretisation,
    essential: Essential,
    shape: &PointShape,
    (node, n): (u32, Vec3),
) -> Vec<(u32, f64)> {
    let own = ([node], [1.0]);
    let (nodes, values): (&[u32], &[f64]) = match essential {
        Essential::Collocation => (&shape.nodes, &shape.values),
        Essential::Direct => (&own.0, &own.1),
    };
    let terms = nodes.iter().zip(values).flat_map(|(&b, &phi)| {
        let (b, n) = space.images.direction(b, &n);
        (0..3).filter(move |&k| n[k] != 0.0).map(move |k| (3 * b + k as u32, phi * n[k]))
    });
    terms.collect()
}

/// Solves equations one after the other, each for the parameter that it weighs most; those that say nothing new are left out.
fn eliminate(
    equations: &[Equation],
    by: &[f64],
    parameters: usize,
) -> Result<Vec<HeldParameter>, GalerkinError> {
    let scale = by.iter().fold(0.0, |most: f64, by| most.max(by.abs()));
    let mut row = SparseRow::new(parameters + by.len()); // conditions stand behind the parameters
    let mut rows: Vec<(u32, Vec<(u32, f64)>)> = Vec::new();
    for equation in equations {
        let mut most = 0.0_f64;
        for &(column, value) in &equation.terms {
            row.add(column, value);
            most = most.max(value.abs());
        }
        row.add(parameters as u32 + equation.condition, -1.0);
        for (pivot, terms) in &rows {
            row.eliminate(*pivot, terms);
        }
        let (column, pivot) = row.largest(parameters as u32);
        if pivot.abs() > DEPENDENT * most {
            rows.push((column, row.take(1.0 / pivot)));
            continue;
        }
        let rest = row.take(1.0).into_iter().filter(|&(column, _)| column as usize >= parameters);
        let left: f64 = rest.map(|(column, g)| -g * by[column as usize - parameters]).sum();
        if left.abs() > DEPENDENT * scale {
            let (node, wanted) = (equation.node, by[equation.condition as usize]);
            return Err(GalerkinError::Contradiction { node, wanted, left });
        }
    }
    // Backwards: rows behind hold no held parameter but their own.
    for at in (0..rows.len()).rev() {
        let (before, behind) = rows.split_at_mut(at + 1);
        let (_, terms) = &mut before[at];
        terms.iter().for_each(|&(column, value)| row.add(column, value));
        for (pivot, terms) in behind.iter() {
            row.eliminate(*pivot, terms);
        }
        *terms = row.take(1.0);
    }
    let held = |(parameter, terms): (u32, Vec<(u32, f64)>)| {
        let split = terms.partition_point(|term| (term.0 as usize) < parameters);
        let of = |part: &[(u32, f64)], first: usize| {
            part.iter().filter(|term| term.0 != parameter).map(|&(c, t)| (c - first as u32, -t)).collect()
        };
        let moves: Vec<(u32, f64)> = of(&terms[split..], parameters);
        let rate = moves.iter().map(|&(condition, g)| g * by[condition as usize]).sum();
        HeldParameter { parameter, terms: of(&terms[..split], 0), moves, rate }
    };
    Ok(rows.into_iter().map(held).collect())
}

/// Parameters for which equations with these coefficients are solved, each a condition of its own; those that depend on others are left out.
pub(crate) fn held_alone(rows: &[&[(u32, f64)]], parameters: usize) -> Vec<Eliminated> {
    let equation =
        |(condition, row): (u32, &&[(u32, f64)])| Equation { node: 0, condition, terms: row.to_vec() };
    let equations: Vec<Equation> = (0..).zip(rows).map(equation).collect();
    // Conditions of zero cannot contradict each other.
    let solved = eliminate(&equations, &vec![0.0; rows.len()], parameters).unwrap_or_default();
    let held = |HeldParameter { parameter, terms, moves, .. }| Eliminated { parameter, terms, moves };
    solved.into_iter().map(held).collect()
}

/// A row under elimination: its values in full, and which of them were touched.
struct SparseRow {
    values: Vec<f64>,
    touched: Vec<bool>,
    columns: Vec<u32>,
}

impl SparseRow {
    fn new(width: usize) -> Self {
        Self { values: vec![0.0; width], touched: vec![false; width], columns: Vec::new() }
    }

    fn add(&mut self, column: u32, value: f64) {
        let at = column as usize;
        if !self.touched[at] {
            self.touched[at] = true;
            self.columns.push(column);
        }
        self.values[at] += value;
    }

    /// Takes out a parameter by the row that was solved for it.
    fn eliminate(&mut self, pivot: u32, terms: &[(u32, f64)]) {
        let share = self.values[pivot as usize];
        if share != 0.0 {
            terms.iter().for_each(|&(column, value)| self.add(column, -share * value));
            self.values[pivot as usize] = 0.0;
        }
    }

    /// The parameter that weighs most, the first of several, with its value.
    fn largest(&self, parameters: u32) -> (u32, f64) {
        let mut best = (u32::MAX, 0.0_f64);
        for &column in self.columns.iter().filter(|&&column| column < parameters) {
            let value = self.values[column as usize];
            let more = value.abs() > best.1.abs() || value.abs() == best.1.abs() && column < best.0;
            best = if more { (column, value) } else { best };
        }
        best
    }

    /// The row times a factor, by rising columns, without what is rounding; the next starts from zeros.
    fn take(&mut self, factor: f64) -> Vec<(u32, f64)> {
        self.columns.sort_unstable();
        let mut out = Vec::with_capacity(self.columns.len());
        for column in self.columns.drain(..) {
            let at = column as usize;
            let value = factor * self.values[at];
            if value.abs() > ROUNDING {
                out.push((column, value));
            }
            (self.values[at], self.touched[at]) = (0.0, false);
        }
        out
    }
}
