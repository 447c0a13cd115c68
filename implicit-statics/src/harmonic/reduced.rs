//! The steady answer in modes and one shape more, which stands for all that they leave out.

use super::motion::{CycleEnergies, HarmonicMotion, weighed};
use super::{Complex, HarmonicDamping};
use crate::modal::Mode;
use crate::pattern::product;
use crate::vectors::dot;
use crate::{Equilibrium, EquilibriumError, SymmetricSolver};

/// Part of the static work of the load below which what modes leave out is rounding: its amplitude is the root of it.
const LEFT_OUT: f64 = 1e-16;
/// Distance of ω² from that of a mode, over it, within which an answer without damping is none.
const AT_RESONANCE: f64 = 1e-12;

/// A system in shapes that neither stiffness nor mass couples: modes, and the truncation vector of a load \[dickens1997\].
///
/// ```text
/// r = p − MΦΦᵀp      c = K⁻¹ r      k = c·Kc,  m = c·Mc
/// ```
///
/// c is orthogonal to all modes in K and in M. With it the answer at ω = 0 is that of the whole system, whatever the number of modes, and between
/// that and the last mode it carries inertia and damping of its own, as mode acceleration does not.
#[derive(Clone, Debug, PartialEq)]
pub struct ReducedResponse {
    shapes: Vec<ReducedShape>,
    masses: Vec<f64>,
    damping: HarmonicDamping,
    left_out: f64,
    carried: f64,
}

/// A shape with what stiffness, mass and load are along it.
#[derive(Clone, Debug, PartialEq)]
struct ReducedShape {
    stiffness: f64,
    mass: f64,
    load: f64,
    shape: Vec<f64>,
}

impl ReducedResponse {
    /// From modes of the present state of a system, and the load of its level one. The shift \[1/T²\] is that of the modes: zero where supports
    /// hold all rigid motions, else below.
    ///
    /// # Errors
    /// Of the factor.
    pub fn new<E: Equilibrium + ?Sized>(
        system: &mut E,
        level: f64,
        modes: Vec<Mode>,
        shift: f64,
        damping: HarmonicDamping,
    ) -> Result<Self, EquilibriumError> {
        let (n, masses) = (system.unknowns(), system.vibrating_masses());
        let mut load = vec![0.0; n];
        system.load_rate(level, &mut load);
        let mut shapes: Vec<ReducedShape> = modes
            .into_iter()
            .map(|mode| ReducedShape {
                stiffness: mode.eigenvalue,
                mass: 1.0,
                load: dot(&mode.shape, &load),
                shape: mode.shape,
            })
            .collect();
        let mut rest = load.clone();
        for mode in &shapes {
            let part = mode.load;
            rest.iter_mut().zip(&masses).zip(&mode.shape).for_each(|((r, m), x)| *r -= part * m * x);
        }
        let pattern = system.pattern();
        let mut values = vec![0.0; pattern.len()];
        system.tangent(level, &mut values);
        let beside = system.beside_pattern(level);
        let mut solver = SymmetricSolver::placed(n, &pattern, system.coordinates().as_deref())?;
        let shifted = pattern
            .iter()
            .zip(&values)
            .map(|(&(row, column), &k)| if row == column { k - shift * masses[row] } else { k });
        solver.factor_with(&shifted.collect::<Vec<f64>>(), &beside)?;
        solver.solve(&mut rest)?;
        for mode in &shapes {
            let part: f64 = masses.iter().zip(&rest).zip(&mode.shape).map(|((m, c), x)| m * c * x).sum();
            rest.iter_mut().zip(&mode.shape).for_each(|(c, x)| *c -= part * x);
        }
        let mut image = vec![0.0; n];
        product(&pattern, &values, &rest, &mut image);
        beside.iter().for_each(|term| term.add_product(1.0, &rest, &mut image));
        let own = ReducedShape {
            stiffness: dot(&rest, &image),
            mass: weighed(&masses, &rest),
            load: dot(&rest, &load),
            shape: rest,
        };
        let modal = |mode: &ReducedShape| mode.load * mode.load / mode.stiffness;
        let known: f64 = shapes.iter().filter(|mode| mode.stiffness > 0.0).map(modal).sum();
        let left_out = own.load / (own.load + known);
        if left_out > LEFT_OUT && own.stiffness > 0.0 {
            shapes.push(own);
        }
        let carried = load.iter().zip(&masses).filter(|(_, m)| **m > 0.0).map(|(p, m)| p * p / m).sum();
        Ok(Self { shapes, masses, damping, left_out: left_out.max(0.0), carried })
    }

    /// `pᵀM⁻¹p`, which is `Σ (φᵀp)²` over all modes: of the load of a base that is accelerated by one the mass that moves against it \[M\].
    pub fn carried(&self) -> f64 {
        self.carried
    }

    /// Loads of the shapes, φᵀp: of a base that is accelerated by one the participation factors of the modes with their signs turned, as their shapes have a
    /// mass of one.
    pub fn loads(&self) -> impl Iterator<Item = f64> {
        self.shapes.iter().map(|shape| shape.load)
    }

    /// Circular frequency \[1/T\] and part of the critical damping \[–\] of each shape; zeros of one that is not stable.
    pub fn swings(&self) -> impl Iterator<Item = [f64; 2]> {
        self.shapes.iter().map(|shape| {
            let omega = (shape.stiffness.max(0.0) / shape.mass).sqrt();
            if omega > 0.0 { [omega, self.damping.ratio(omega)] } else { [0.0; 2] }
        })
    }

    /// Coordinates of the shapes at rest under the load; zero of one that is not stable.
    pub fn at_rest(&self) -> impl Iterator<Item = f64> {
        self.shapes.iter().map(|own| if own.stiffness > 0.0 { own.load / own.stiffness } else { 0.0 })
    }

    /// Part of the static work of the load that the modes leave out \[–\], which the further shape answers for.
    pub fn left_out(&self) -> f64 {
        self.left_out
    }

    /// The shapes: the modes, and the further one if there is any.
    pub fn shapes(&self) -> impl ExactSizeIterator<Item = &[f64]> {
        self.shapes.iter().map(|shape| &shape.shape[..])
    }

    /// Masses of the unknowns.
    pub fn masses(&self) -> &[f64] {
        &self.masses
    }

    /// Coordinates of the shapes at a circular frequency \[1/T\].
    ///
    /// # Errors
    /// [`EquilibriumError::Resonance`] where nothing damps and ω is a natural frequency within rounding.
    pub fn at(&self, omega: f64) -> Result<Vec<Complex>, EquilibriumError> {
        let one = |shape: &ReducedShape| {
            let (re, im) = (shape.stiffness - omega * omega * shape.mass, self.lag(shape, omega));
            let bound = AT_RESONANCE * shape.stiffness.abs();
            if shape.load != 0.0 && im == 0.0 && re.abs() <= bound {
                return Err(EquilibriumError::Resonance { omega });
            }
            Ok(if shape.load == 0.0 { Complex::default() } else { Complex::new(re, im).under(shape.load) })
        };
        self.shapes.iter().map(one).collect()
    }

    /// κ of each shape: what a force that its strains exert is times the elastic one.
    pub fn kappas(&self, omega: f64) -> impl Iterator<Item = Complex> {
        self.shapes.iter().map(move |shape| {
            let loss = match self.damping {
                HarmonicDamping::Ratio(_) if shape.stiffness > 0.0 => {
                    self.lag(shape, omega) / shape.stiffness
                }
                HarmonicDamping::Ratio(_) => 0.0,
                damping => damping.at(omega).1,
            };
            Complex::new(1.0, loss)
        })
    }

    /// The motion of these coordinates.
    pub fn motion(&self, coordinates: &[Complex]) -> HarmonicMotion {
        let mut motion =
            HarmonicMotion { real: vec![0.0; self.masses.len()], imaginary: vec![0.0; self.masses.len()] };
        for (z, shape) in coordinates.iter().zip(&self.shapes) {
            motion.real.iter_mut().zip(&shape.shape).for_each(|(u, x)| *u += z.re * x);
            motion.imaginary.iter_mut().zip(&shape.shape).for_each(|(u, x)| *u += z.im * x);
        }
        motion
    }

    /// Energies of these coordinates at a circular frequency.
    pub fn energies(&self, coordinates: &[Complex], omega: f64) -> CycleEnergies {
        let mut all = CycleEnergies::default();
        for (z, shape) in coordinates.iter().zip(&self.shapes) {
            let (stored, moving) = (shape.stiffness * z.square(), shape.mass * z.square());
            let own = CycleEnergies::of([stored, moving, shape.load * z.im], omega, (0.0, 0.0));
            all.internal += own.internal;
            all.kinetic += own.kinetic;
            all.external += own.external;
            all.dissipated += std::f64::consts::PI * self.lag(shape, omega) * z.square();
        }
        all
    }

    /// What lags by a quarter of a cycle behind a unit of a shape \[as its stiffness\].
    fn lag(&self, shape: &ReducedShape, omega: f64) -> f64 {
        if let HarmonicDamping::Ratio(ratio) = self.damping {
            return 2.0 * ratio * omega * (shape.stiffness.max(0.0) * shape.mass).sqrt();
        }
        let (mass, loss) = self.damping.at(omega);
        loss * shape.stiffness + omega * mass * shape.mass
    }
}
