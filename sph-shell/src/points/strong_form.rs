//! The equations of Lin et al. 2013 to the letter: pairwise sums with each particle's own corrected gradient.
//!
//! Equation 4, per area of the mid-surface, with the force resultants `P = n¹⊗T1 + n²⊗T2`:
//!
//! ```text
//! m_a a_a = A_a Σ_b (P_a + P_b)·g_ab + viscosity,     g_ab = V_b ∇̃W_ab  (CSPM gradient of a, \[chen1999\])
//! ```
//!
//! and equation 9 likewise with the moment resultants and the shear force. Each pair uses the gradient of its
//! first particle: forces do not cancel in pairs, the linearised operator is not symmetric, and there is no
//! energy behind it. It is kept because the paper describes it; the report prints what it costs in accuracy.

use shell_kinematics::{LANES, SectionOf, StrainsOf};

use crate::control::shear::ShearPack;
use crate::dispatch::{Work, widest};
use crate::packs::{Packs, Row};
use crate::points::point::{Point, PointLaw};
use crate::reference::Reference;
use crate::registers::{Baseline, Registers};

/// Resultants of one particle: `n1, n2, q, m1, m2`.
type PointRow = [[f64; 3]; 5];

/// Buffers and constants of the strong form.
#[derive(Clone, Debug)]
pub(crate) struct StrongForm {
    /// Factor μ of the artificial viscosity.
    viscosity: f64,
    /// Mass per area `ρ₀ t` \[M/L²\].
    surface_density: f64,
    /// `T1_b·g_ab` and `T2_b·g_ab` of each stencil entry: the gradient of a in the frame of b \[1/L\].
    across: Vec<[f64; 2]>,
    resultants: Vec<PointRow>,
}

impl StrongForm {
    pub fn new(reference: &Reference, viscosity: f64, surface_density: f64) -> Self {
        // Sampling points are particles here, with frames of their own where a material axis rotated them.
        let points = &reference.operator.points;
        let mut across = Vec::with_capacity(reference.operator.particles.len());
        for (a, point) in points.iter().enumerate() {
            let frame = &point.frame;
            let stencil = reference.operator.stencil(a);
            for (k, &b) in stencil.particles.iter().enumerate() {
                let gradient = frame.t1 * stencil.g1[k] + frame.t2 * stencil.g2[k];
                let other = &points[b as usize].frame;
                across.push([other.t1.dot(&gradient), other.t2.dot(&gradient)]);
            }
        }
        Self { viscosity, surface_density, across, resultants: vec![[[0.0; 3]; 5]; points.len()] }
    }

    /// Minus the right-hand sides of eqs. 4 and 9, times area, into `forces`; returns the elastic energy of the
    /// strains \[F L\] if it is asked for, else zero.
    pub fn evaluate(
        &mut self,
        reference: &Reference,
        packs: &Packs,
        shear: &[ShearPack],
        law: PointLaw<'_>,
        motion: [&[Row]; 2],
        energy: bool,
        forces: &mut [Row],
    ) -> f64 {
        let mut resultants = std::mem::take(&mut self.resultants);
        let sampled =
            widest(Sampled { packs, shear, law, state: motion[0], energy, resultants: &mut resultants });
        self.resultants = resultants;
        widest(Balance { equations: self, reference, motion, forces });
        sampled
    }

    #[inline(always)]
    fn particle(&self, a: usize, reference: &Reference, motion: [&[Row]; 2]) -> Row {
        let area = reference.cloud.areas[a];
        let stencil = reference.operator.stencil(a);
        let across = &self.across[reference.operator.entries(a)];
        let [n1, n2, q, m1, m2] = &self.resultants[a];
        let mut sum = [0.0; 6];
        for k in 0..3 {
            sum[3 + k] = -q[k];
        }
        for (k, &b) in stencil.particles.iter().enumerate() {
            if b as usize == a {
                continue;
            }
            let (g1, g2) = (stencil.g1[k], stencil.g2[k]);
            let [o1, o2] = across[k];
            let [p1, p2, _, r1, r2] = &self.resultants[b as usize];
            for i in 0..3 {
                sum[i] += n1[i] * g1 + n2[i] * g2 + p1[i] * o1 + p2[i] * o2;
                sum[3 + i] += m1[i] * g1 + m2[i] * g2 + r1[i] * o1 + r2[i] * o2;
            }
            let push = self.viscous(a, b as usize, reference, motion);
            if push != 0.0 {
                let frame = &reference.operator.points[a].frame;
                let gradient = frame.t1 * g1 + frame.t2 * g2;
                for i in 0..3 {
                    sum[i] -= push * gradient[i];
                }
            }
        }
        sum.map(|value| -area * value)
    }

    /// `ρ₀² t Π` of eq. 4, with `Π = (μ/ρ₀)(−c̄ϑ + 2ϑ²)` for approaching particles and zero for parting ones
    /// \[F/L\].
    ///
    /// The paper adds Π to the tensile-positive stress; read so it would feed energy into approaching
    /// particles. It is subtracted here, as a pressure.
    #[inline(always)]
    fn viscous(&self, a: usize, b: usize, reference: &Reference, [state, rates]: [&[Row]; 2]) -> f64 {
        let (mut along, mut square) = (0.0, 0.0);
        for k in 0..3 {
            let x = state[a][k] - state[b][k];
            along += (rates[a][k] - rates[b][k]) * x;
            square += x * x;
        }
        if along >= 0.0 {
            return 0.0;
        }
        let approach = along / square.sqrt();
        self.viscosity
            * self.surface_density
            * (-reference.sound_speed * approach + 2.0 * approach * approach)
    }
}

/// The resultants of all particles on their way through the points.
struct Sampled<'a, 'b> {
    packs: &'a Packs,
    shear: &'a [ShearPack],
    law: PointLaw<'a>,
    state: &'a [Row],
    energy: bool,
    resultants: &'b mut [PointRow],
}

impl Sampled<'_, '_> {
    #[inline(always)]
    fn all<
        const ENERGY: bool,
        R: Registers,
        M: StrainsOf<R::Four> + ?Sized,
        S: SectionOf<R::Four> + ?Sized,
    >(
        &mut self,
        registers: R,
        law: PointLaw<'_, M, S>,
    ) -> f64 {
        let mut energy = 0.0;
        for (index, points) in self.packs.order.iter().enumerate() {
            let point = Point { shear: self.shear.get(index), ..Point::new(self.packs, index) };
            let point = point.treated_in(registers);
            let now = point.strained::<false, M>(law.strain, self.state);
            let found = point.forces::<ENERGY, M, S>(law, &now);
            let f = found.on_vectors;
            if ENERGY {
                energy += registers.store(found.density * registers.load(&point.pack.weight)).sum();
            }
            let vectors = [f.n1, f.n2, f.q, f.m1, f.m2];
            for (k, vector) in vectors.iter().enumerate() {
                let [x, y, z] = vector.0;
                let [x, y, z] =
                    [registers.store(x).lanes(), registers.store(y).lanes(), registers.store(z).lanes()];
                for lane in 0..LANES {
                    self.resultants[points[lane] as usize][k] = [x[lane], y[lane], z[lane]];
                }
            }
        }
        energy
    }
}

impl Work for Sampled<'_, '_> {
    type Output = f64;

    #[inline(always)]
    fn run<R: Registers>(mut self, registers: R) -> f64 {
        let law = self.law;
        match (law.default_pair(), self.energy) {
            (_, true) => self.all::<true, _, _, _>(Baseline, law),
            (None, false) => self.all::<false, _, _, _>(Baseline, law),
            (Some(law), false) => self.all::<false, _, _, _>(registers, law),
        }
    }
}

/// All particles on their way through the equations.
struct Balance<'a, 'b> {
    equations: &'a StrongForm,
    reference: &'a Reference,
    motion: [&'a [Row]; 2],
    forces: &'b mut [Row],
}

impl Work for Balance<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run<R: Registers>(self, _: R) {
        for (a, force) in self.forces.iter_mut().enumerate() {
            *force = self.equations.particle(a, self.reference, self.motion);
        }
    }
}
