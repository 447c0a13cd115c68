//! Natural frequencies by shift and invert, and buckling loads linearised about a state.

use crate::eigen::{Extreme, Operator, extreme_pairs};
use crate::error::require;
use crate::pattern::product;
use crate::vectors::norm;
use crate::{BalanceError, Equilibrium, SymmetricSolver};

/// Relative change of the tangent sought when it is differentiated along the load: its error is of the second
/// order in this, rounding of the first order in its inverse.
const PRESTRESS: f64 = 1e-5;
/// Trials of the load step that gives it.
const TRIALS: usize = 8;

/// A mode of free vibration.
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// Eigenvalue ω² \[1/T²\]; negative where the state is unstable.
    pub eigenvalue: f64,
    /// Shape, with unit mass: `φᵀMφ = 1`.
    pub shape: Vec<f64>,
}

impl Mode {
    /// Circular frequency ω \[1/T\]; 0 where the state is unstable.
    pub fn circular_frequency(&self) -> f64 {
        self.eigenvalue.max(0.0).sqrt()
    }
}

/// A buckling mode of the linearised problem.
#[derive(Debug, Clone, PartialEq)]
pub struct BucklingMode {
    /// Critical level: of the base state plus the extrapolated part \[–\].
    pub level: f64,
    /// Shape, its largest entry 1.
    pub shape: Vec<f64>,
}

/// Modes of vibration about the present state with ω² nearest to `shift` \[1/T²\], in order of distance.
///
/// `(K − σM)⁻¹M` is iterated; a shift of 0 gives the lowest modes of a stable, supported structure. Where rigid
/// motions are free, shift a little below zero. Unknowns without mass follow statically.
pub fn natural_modes<E: Equilibrium + ?Sized>(
    system: &mut E,
    level: f64,
    count: usize,
    shift: f64,
) -> Result<Vec<Mode>, BalanceError> {
    let pattern = system.pattern();
    let mut values = vec![0.0; pattern.len()];
    system.tangent(level, &mut values);
    lowest_modes(&pattern, &values, &system.masses(), count, shift)
        .map_err(|error| error.named(system, 0, level))
}

/// Eigenpairs of `K φ = ω² M φ` with diagonal M nearest to a shift; K by its lower triangle.
pub fn lowest_modes(
    pattern: &[(usize, usize)],
    stiffness: &[f64],
    masses: &[f64],
    count: usize,
    shift: f64,
) -> Result<Vec<Mode>, BalanceError> {
    let n = masses.len();
    let carrying = masses.iter().filter(|&&m| m > 0.0).count();
    require(
        count > 0 && count <= carrying,
        "number of modes",
        count as f64,
        "between 1 and the number of unknowns with mass",
    )?;
    let mut solver = SymmetricSolver::new(n, pattern)?;
    let mut shifted = stiffness.to_vec();
    for (&(row, column), value) in pattern.iter().zip(&mut shifted) {
        if row == column {
            *value -= shift * masses[row];
        }
    }
    solver.factor(&shifted)?;
    let mut operator = Vibration { solver, masses };
    let pairs = extreme_pairs(&mut operator, n, count, Extreme::Magnitude)?;
    Ok(pairs.into_iter().map(|(theta, shape)| Mode { eigenvalue: shift + 1.0 / theta, shape }).collect())
}

struct Vibration<'a> {
    solver: SymmetricSolver,
    masses: &'a [f64],
}

impl Operator for Vibration<'_> {
    fn apply(&mut self, v: &[f64], out: &mut [f64]) -> Result<(), BalanceError> {
        self.weigh(v, out);
        self.solver.solve(out)
    }

    fn weigh(&mut self, v: &[f64], out: &mut [f64]) {
        for i in 0..v.len() {
            out[i] = self.masses[i] * v[i];
        }
    }
}

/// Lowest positive critical levels of `(K + μ K_g) φ = 0` about the present equilibrium at `level`.
///
/// `K_g = dK/dλ` along the load is the central difference of tangents at the states `± δ K⁻¹p` and levels
/// `± δ`; δ is chosen so that K changes by about 1e-5. Being the derivative along the whole linear
/// response, it holds the prebuckling displacement as well as the prebuckling stress. Critical levels are
/// `level + μ`. The state is put back.
pub fn linear_buckling<E: Equilibrium + ?Sized>(
    system: &mut E,
    level: f64,
    count: usize,
) -> Result<Vec<BucklingMode>, BalanceError> {
    let n = system.unknowns();
    require(
        count > 0 && count <= n,
        "number of modes",
        count as f64,
        "between 1 and the number of unknowns",
    )?;
    let pattern = system.pattern();
    let mut solver = SymmetricSolver::new(n, &pattern)?;
    let mut base = vec![0.0; pattern.len()];
    system.tangent(level, &mut base);
    let inertia = solver.factor(&base)?;
    if inertia.negative > 0 {
        return Err(BalanceError::Unstable { level, negative: inertia.negative });
    }
    let mut response = vec![0.0; n];
    system.load_rate(level, &mut response);
    let load = norm(&response);
    solver.solve(&mut response).map_err(|error| error.named(system, 0, level))?;

    let saved = system.save();
    let mut difference = |delta: f64| {
        let mut ends = [vec![0.0; pattern.len()], vec![0.0; pattern.len()]];
        for (values, delta) in ends.iter_mut().zip([delta, -delta]) {
            system.restore(&saved);
            let motion: Vec<f64> = response.iter().map(|u| delta * u).collect();
            system.update(&motion);
            system.tangent(level + delta, values);
        }
        system.restore(&saved);
        let [plus, minus] = ends;
        plus.iter().zip(&minus).map(|(p, m)| (p - m) / (2.0 * delta)).collect::<Vec<f64>>()
    };
    let scale = solver.scale();
    let scaled = |values: &[f64]| {
        let square = |(&(i, j), v): (&(usize, usize), &f64)| (v * scale[i] * scale[j]).powi(2);
        pattern.iter().zip(values).map(square).sum::<f64>().sqrt()
    };
    let stiffness = scaled(&base);
    let mut delta = PRESTRESS;
    let mut change = 0.0;
    for _ in 0..TRIALS {
        change = delta * scaled(&difference(delta)) / stiffness;
        if (0.5..2.0).contains(&(change / PRESTRESS)) {
            break;
        }
        // far from the goal the change may be all rounding: approach by bounded factors
        delta *= (PRESTRESS / change).clamp(1e-4, 1e4);
    }
    if change < 0.1 * PRESTRESS {
        return Err(BalanceError::NoPrestress { level, load, change });
    }
    let geometric = difference(delta);

    let mut operator = Buckling { solver, pattern: &pattern, geometric: &geometric };
    let pairs = extreme_pairs(&mut operator, n, count, Extreme::Positive)?;
    Ok(pairs
        .into_iter()
        .map(|(theta, shape)| {
            let largest = shape.iter().fold(0.0, |best: f64, &s| if s.abs() > best.abs() { s } else { best });
            let shape = shape.iter().map(|s| s / largest).collect();
            BucklingMode { level: level + 1.0 / theta, shape }
        })
        .collect())
}

/// `−K⁻¹K_g`, symmetric in the inner product of K; eigenvalues 1/μ.
struct Buckling<'a> {
    solver: SymmetricSolver,
    pattern: &'a [(usize, usize)],
    geometric: &'a [f64],
}

impl Operator for Buckling<'_> {
    fn apply(&mut self, v: &[f64], out: &mut [f64]) -> Result<(), BalanceError> {
        product(self.pattern, self.geometric, v, out);
        out.iter_mut().for_each(|g| *g = -*g);
        self.solver.solve(out)
    }

    fn weigh(&mut self, v: &[f64], out: &mut [f64]) {
        self.solver.product(v, out);
    }
}
