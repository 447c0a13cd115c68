//! Buckling loads linearised about a state: shift and invert in the inner product of K, counted by inertia.
//!
//! `(K + μ K_g) φ = 0` with K positive definite and K_g of either sign. About a shift σ,
//!
//! ```text
//! (K + σ K_g)⁻¹ K φ = ν φ,     ν = μ/(μ − σ)                                      [grimes1994]
//! ```
//!
//! the critical levels in (0, σ), and no others, have ν < 0: their number is that of the negative pivots of K + σK_g, and
//! they stand apart from the rest however dense the spectrum is. The shift comes from a few vectors of `−K⁻¹K_g`: a Ritz
//! value of the count-th level lies above it, so that at least so many are below the shift.

use crate::effort::{Counted, CountingSolver};
use crate::eigen::{BLOCK, End, Krylov, Operator, Ritz, TOLERANCE};
use crate::geometric::{Prebuckling, along_load};
use crate::pattern::product;
use crate::vectors::dot;
use crate::{Equilibrium, EquilibriumError, Spectrum, Watch, error::require};

/// Restarts of the search for a shift.
const PROBES: usize = 6;
/// Relative change between restarts at which a Ritz value will do for a shift.
const NEAR: f64 = 1e-2;
/// A level farther than this times the nearest of either sign is none: what extrapolates so far is no buckling load. A
/// strip that is pulled "buckles" by its own stretch at 7·10⁴ times the load that would buckle it pushed.
const REACH: f64 = 1e4;
/// How far beyond the last level the shift is put, relative: half of the gap to the next one, within these.
const BEYOND: [f64; 2] = [1e-6, 1e-2];
/// The same where the last level is known by a Ritz value alone.
const ASIDE: f64 = 1e-3;
/// Levels that may lie below the shift, beyond twice those wanted, before a lower shift is sought.
const CROWD: usize = 60;
/// Factorisations allowed in the search for a shift.
const SHIFTS: usize = 40;

/// What is asked of [`linear_buckling`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BucklingOptions {
    /// Critical levels wanted.
    pub count: usize,
    /// On which side of the base state.
    pub sign: Sign,
    /// Which derivative of the tangent K_g is.
    pub prebuckling: Prebuckling,
}

impl BucklingOptions {
    /// So many levels above the base state, K_g along the whole linear response.
    pub fn new(count: usize) -> Self {
        Self { count, sign: Sign::Positive, prebuckling: Prebuckling::Rotations }
    }
}

/// Which critical levels are wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(
    feature = "scene",
    derive(serde::Serialize, serde::Deserialize, schemars::JsonSchema),
    serde(rename_all = "kebab-case")
)]
pub enum Sign {
    /// Of the load as it is: those above the base state.
    #[default]
    Positive,
    /// Of the load reversed.
    Negative,
    /// The nearest of both.
    Either,
}

/// A buckling mode of the linearised problem.
#[derive(Debug, Clone, PartialEq)]
pub struct BucklingMode {
    /// Critical level: of the base state plus the extrapolated part \[–\].
    pub level: f64,
    /// An exact level lies within this part of the extrapolated one \[–\].
    pub residual: f64,
    /// Rayleigh's quotient of the shape with the other [`Prebuckling`], as a level \[–\]: where the change of shape before
    /// buckling does not count it is the level itself. None where the system does not part the two.
    pub otherwise: Option<f64>,
    /// The linear response from the base state to the level.
    pub before: Vec<f64>,
    /// Shape, its largest entry 1.
    pub shape: Vec<f64>,
}

/// Nearest critical levels of `(K + μ K_g) φ = 0` about the present equilibrium at `level`: `level + μ`, sorted by |μ|.
///
/// Fewer than wanted come back where no more lie within ten thousand times the nearest. The state is put back.
pub fn linear_buckling<'a, E: Equilibrium + ?Sized>(
    system: &mut E,
    level: f64,
    options: &BucklingOptions,
    watch: &'a mut Watch<'a>,
) -> Result<Spectrum<BucklingMode>, EquilibriumError> {
    let n = system.unknowns();
    let bound = "between 1 and the number of unknowns";
    require(options.count > 0 && options.count <= n, "number of modes", options.count as f64, bound)?;
    let pattern = system.pattern();
    let mut solver = CountingSolver::new(n, &pattern, system.coordinates().as_deref(), watch)?;
    let mut base = vec![0.0; pattern.len()];
    system.tangent(level, &mut base);
    if !system.beside_pattern(level).is_empty() {
        let (what, instead) = ("linear buckling", "follow the path to its critical points");
        return Err(EquilibriumError::BesidePattern { what, instead });
    }
    let inertia = solver.factor(&base, &[])?;
    if inertia.negative > 0 {
        return Err(EquilibriumError::Unstable { level, negative: inertia.negative });
    }
    let geometric = along_load(system, level, options.prebuckling, &pattern, &base, &mut solver)?;
    let mut pencil =
        Pencil { solver, pattern: &pattern, base: &base, geometric: &geometric.asked, sign: 1.0, shift: 0.0 };
    let found = match options.sign {
        Sign::Positive => pencil.stretched_or(1.0, options.count, level)?,
        Sign::Negative => pencil.stretched_or(-1.0, options.count, level)?,
        Sign::Either => match (pencil.nearest(1.0, options.count), pencil.nearest(-1.0, options.count)) {
            (Ok(mut both), Ok(other)) => {
                both.join(other, options.count);
                both
            }
            (Ok(one), Err(cause)) | (Err(cause), Ok(one))
                if !matches!(cause, EquilibriumError::Stopped { .. }) && !one.levels.is_empty() =>
            {
                one
            }
            (Err(cause), _) | (_, Err(cause)) => return Err(cause),
        },
    };
    let quotient = |shape: &[f64], other: &[f64]| {
        let along = |values: &[f64]| {
            let mut image = vec![0.0; n];
            product(&pattern, values, shape, &mut image);
            dot(shape, &image)
        };
        level - along(&base) / along(other)
    };
    let modes = found.levels.into_iter().map(|one| {
        let largest = one.shape.iter().fold(0.0, |best: f64, &s| if s.abs() > best.abs() { s } else { best });
        let shape = one.shape.iter().map(|s| s / largest).collect();
        let otherwise = geometric.other.as_deref().map(|other| quotient(&one.shape, other));
        let before = geometric.response.iter().map(|u| u * one.value).collect();
        BucklingMode { level: level + one.value, residual: one.residual, otherwise, before, shape }
    });
    let Counted { from, to, number } = found.counted;
    let counted = Counted { from: level + from, to: level + to, number };
    Ok(Spectrum { modes: modes.collect(), counted, effort: pencil.solver.effort })
}

/// Factors of the pencil on one side, or on both, with their count.
struct Found {
    levels: Vec<Level>,
    counted: Counted,
}

struct Level {
    value: f64,
    residual: f64,
    shape: Vec<f64>,
}

impl Found {
    /// Takes the nearest of both sides.
    fn join(&mut self, other: Self, count: usize) {
        self.levels.extend(other.levels);
        self.levels.sort_by(|a, b| a.value.abs().total_cmp(&b.value.abs()));
        self.levels.truncate(count);
        self.counted.from = other.counted.from;
        self.counted.number += other.counted.number;
    }
}

/// `(K + s σ K_g)⁻¹ K`, at σ = 0 `−s K⁻¹ K_g`, both symmetric in the inner product of K; s is the sign.
struct Pencil<'a> {
    solver: CountingSolver<'a>,
    pattern: &'a [(usize, usize)],
    base: &'a [f64],
    geometric: &'a [f64],
    sign: f64,
    shift: f64,
}

impl Pencil<'_> {
    /// The nearest levels of a sign; an error with the nearest of the other sign where there is none.
    fn stretched_or(&mut self, sign: f64, count: usize, level: f64) -> Result<Found, EquilibriumError> {
        let found = self.nearest(sign, count)?;
        if !found.levels.is_empty() {
            return Ok(found);
        }
        let searched = level + if sign > 0.0 { found.counted.to } else { found.counted.from };
        let other = self.nearest(-sign, 1)?.levels.first().map(|one| level + one.value);
        Err(EquilibriumError::Stretched { searched, other })
    }

    /// The levels of a sign nearest to the base state, none missing.
    fn nearest(&mut self, sign: f64, mut count: usize) -> Result<Found, EquilibriumError> {
        let n = self.solver.scale().len();
        self.sign = sign;
        if self.shift != 0.0 {
            self.below(0.0)?;
        }
        let mut krylov = Krylov::new(self, n, &[])?;
        let (known, top) = self.probe(&mut krylov, count)?;
        let positive = |pair: &&Ritz| pair.value * REACH > top;
        if krylov.complete() {
            count = count.min(known.iter().filter(positive).count());
        }
        let mut last = known.iter().filter(positive).take(count);
        let settled = last.all(|pair| pair.residual <= TOLERANCE * pair.value);
        let reach = REACH / top;
        let mut shift = reach;
        if let Some(pair) = known.iter().filter(positive).nth(count.max(1) - 1) {
            let gap = known
                .get(count)
                .filter(|next| next.value > 0.0)
                .map_or(1.0, |next| pair.value / next.value - 1.0);
            shift =
                (1.0 + if settled { (0.5 * gap).clamp(BEYOND[0], BEYOND[1]) } else { ASIDE }) / pair.value;
        }
        let number = if count == 0 { 0 } else { self.find_shift(shift.min(reach), reach, count)? };
        let to = if count == 0 { reach } else { self.shift };
        let counted = Counted { from: (sign * to).min(0.0), to: (sign * to).max(0.0), number };
        if number == 0 {
            return Ok(Found { levels: Vec::new(), counted });
        }
        let mut values: Vec<(f64, Vec<f64>)> = if settled && number == count {
            known[..count].iter().map(|pair| (1.0 / pair.value, krylov.vector(pair))).collect()
        } else {
            let start: Vec<Vec<f64>> = known.iter().take(BLOCK - 1).map(|pair| krylov.vector(pair)).collect();
            let mut krylov = Krylov::new(self, n, &start)?;
            let bound = |pair: &Ritz| match pair.value {
                nu if nu < 0.0 => pair.residual / (nu * (nu - 1.0)),
                _ => f64::INFINITY,
            };
            let pairs = krylov.converge(self, number, End::Least, &bound)?;
            let found = pairs.iter().take_while(|pair| pair.value < 0.0).count();
            if found != number {
                return Err(EquilibriumError::Miscounted { found, counted: number });
            }
            let level = |pair: &Ritz| self.shift * pair.value / (pair.value - 1.0);
            pairs[..number].iter().map(|pair| (level(pair), krylov.vector(pair))).collect()
        };
        values.sort_by(|a, b| a.0.total_cmp(&b.0));
        values.truncate(count);
        let levels = values.into_iter().map(|(value, shape)| self.judged(value, shape));
        Ok(Found { levels: levels.collect::<Result<_, _>>()?, counted })
    }

    /// A few vectors of −K⁻¹K_g: Ritz pairs, the largest first, and the largest magnitude met on either side.
    fn probe(&mut self, krylov: &mut Krylov, count: usize) -> Result<(Vec<Ritz>, f64), EquilibriumError> {
        let (mut before, mut top) = (0.0_f64, 0.0_f64);
        for _ in 1..PROBES {
            krylov.grow(self, Krylov::depth(count))?;
            let ritz = krylov.ritz(End::Largest);
            top = ritz.iter().fold(top, |top, pair| top.max(pair.value.abs()));
            let settled = |pair: &Ritz| pair.residual <= TOLERANCE * pair.value;
            let last = ritz.get(count - 1).map_or(0.0, |pair| pair.value);
            let at_rest = last * REACH > top && (last - before).abs() <= NEAR * last;
            if krylov.complete() || at_rest || ritz.iter().take(count).all(settled) {
                return Ok((ritz, top));
            }
            before = last;
            krylov.restart(&ritz[..(count + BLOCK).min(ritz.len())]);
        }
        krylov.grow(self, Krylov::depth(count))?;
        Ok((krylov.ritz(End::Largest), top))
    }

    /// Finds a shift with at least `count` levels below it, and not many more; gives their number. Fewer only at `reach`.
    fn find_shift(&mut self, first: f64, reach: f64, count: usize) -> Result<usize, EquilibriumError> {
        let (mut low, mut high) = (0.0, f64::INFINITY);
        let mut shift = first;
        let mut fraction: f64 = 0.05;
        for _ in 0..SHIFTS {
            let (number, zero) = self.below(shift)?;
            if zero > 0 {
                shift *= 1.0 + ASIDE;
                continue;
            }
            if number < count {
                if shift >= reach {
                    return Ok(number);
                }
                low = shift;
            } else if number <= 2 * count + CROWD {
                return Ok(number);
            } else {
                high = shift;
            }
            shift = if high.is_infinite() {
                (2.0 * shift).min(reach)
            } else if low == 0.0 {
                fraction *= 2.0;
                high * (1.0 - fraction).max(0.1)
            } else {
                0.5 * (low + high)
            };
        }
        Err(EquilibriumError::Modes { found: 0, wanted: count, residual: f64::INFINITY, bound: TOLERANCE })
    }

    /// Factorises about a shift; levels between the base state and the shift, and those within rounding of it.
    fn below(&mut self, shift: f64) -> Result<(usize, usize), EquilibriumError> {
        self.shift = shift;
        let signed = self.sign * shift;
        let values: Vec<f64> = self.base.iter().zip(self.geometric).map(|(k, g)| k + signed * g).collect();
        let inertia = self.solver.factor(&values, &[])?;
        Ok((inertia.negative, inertia.zero))
    }

    /// A level with the error bound that one solve with the factor at σ gives: for w = (K + σK_g)⁻¹(K + μK_g)φ an exact
    /// level lies within |μ − σ|/|μ| ‖w‖ of μ, relative and in the norm of K.
    fn judged(&mut self, value: f64, shape: Vec<f64>) -> Result<Level, EquilibriumError> {
        let mut left = vec![0.0; shape.len()];
        let mut weighed = left.clone();
        product(self.pattern, self.geometric, &shape, &mut left);
        self.weigh(&shape, &mut weighed)?;
        let length = dot(&shape, &weighed).sqrt();
        let signed = self.sign * value;
        left.iter_mut().zip(&weighed).for_each(|(g, k)| *g = k + signed * *g);
        self.solver.solve(&mut left)?;
        self.weigh(&left, &mut weighed)?;
        let error = dot(&left, &weighed).max(0.0).sqrt() / length;
        Ok(Level { value: signed, residual: error * (1.0 - self.shift / value).abs(), shape })
    }
}

impl Operator for Pencil<'_> {
    fn apply(&mut self, vectors: &mut [Vec<f64>]) -> Result<(), EquilibriumError> {
        for v in vectors.iter_mut() {
            let mut out = vec![0.0; v.len()];
            if self.shift == 0.0 {
                product(self.pattern, self.geometric, v, &mut out);
                let sign = self.sign;
                out.iter_mut().for_each(|g| *g *= -sign);
            } else {
                self.weigh(v, &mut out)?;
            }
            *v = out;
        }
        self.solver.solve_some(vectors)
    }

    fn weigh(&mut self, v: &[f64], out: &mut [f64]) -> Result<(), EquilibriumError> {
        product(self.pattern, self.base, v, out);
        Ok(())
    }
}
