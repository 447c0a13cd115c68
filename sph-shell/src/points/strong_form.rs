//! The equations of Lin et al. 2013: balance at the particles, each with its own corrected gradient, in two readings of eq. 4.
//!
//! Per area of the mid-surface, with the force resultants `P = n¹⊗T1 + n²⊗T2` and the moments about axes `μ = d × (m¹⊗T1 + m²⊗T2)`:
//!
//! ```text
//! sum         m_a a_a = A_a Σ_b (P_b + P_a)·g_ab + viscosity                     as printed
//! difference  m_a a_a = A_a Σ_b (P_b − P_a)·g_ab − P_a·r_a + f_a + viscosity     the gradient of eq. 2, applied to P
//!             I_a ω̇_a = …, likewise with μ, + A_a T_a                            eq. 9
//! T = −d,α × m^α − d × q    equal to x,α × n^α, as the energy of a point does not feel rotations
//! ```
//!
//! `g_ab = V_b ∇̃W_ab` is the CSPM gradient of a \[chen1999\]. With it `Σ_b g_ab` is no zero at edges: the sum then finds a force
//! where the stress is constant. The difference is exact for linear fields, but knows nothing of edges. What acts there is
//! prescribed as in penalty methods for differences that sum by parts \[svard2014\]: `r_a`, the edge normal times the edge length of a, divides
//! by the area of a, so that the resultant at the edge goes to the load f within the fastest period. Loads need no other form for it.
//!
//! In the difference form all V_b are alike, whatever part of a cell belongs to a particle: so rows beside an edge are central, and `A_a g_ab = −A_b g_ba`
//! but for tangents of edges. Where that holds everywhere (h below .71 on a lattice) difference and edges are the adjoint of
//! the strains, and the operator is symmetric; what is left grows slowly enough for damping. The control of pairs
//! holds the pattern of two spacings, which central differences do not see.
//!
//! Each pair uses the gradient of its first particle: forces do not cancel in pairs, the linearised operator is not symmetric,
//! and there is no energy behind it. docs/formulations.md says what that costs, with the eigenvalues.

use shell_kinematics::{LANES, Pack3, SectionOf, SectionScales, StrainsOf, StretchCorrected};

use crate::control::pairs::PairControl;
use crate::control::shear::ShearPack;
use crate::dispatch::{Work, widest};
use crate::error::ShellError;
use crate::formulation::Divergence;
use crate::packs::{Packs, Row};
use crate::points::point::{Point, PointLaw};
use crate::reference::Reference;
use crate::registers::{Baseline, Registers, pack_of};

/// Of one particle: force resultants \[F/L\], moments about axes \[F\], the torque T per area \[F/L\], and the tangents `x,1` and `x,2`.
type PointRow = [[f64; 3]; 7];

/// Part of the control of wide stencils that the difference form takes \[–\]. On the ring at h = .85 the fastest mode at rest grows at the
/// rate .24 without control, .06 with this part and .60 with all of it, where damping takes .35; without it, it is lost at three quarters.
const CONTROL: f64 = 0.3;

/// Buffers and constants of the strong form.
#[derive(Clone, Debug)]
pub(crate) struct StrongForm {
    /// Factor μ of the artificial viscosity.
    viscosity: f64,
    /// Mass per area `ρ₀ t` \[M/L²\].
    surface_density: f64,
    /// Sign of P_a in the sum over pairs.
    own: f64,
    /// `T1_b·g_ab` and `T2_b·g_ab` of each stencil entry: the gradient of a in the frame of b \[1/L\].
    across: Vec<[f64; 2]>,
    /// `T1_a·r_a` and `T2_a·r_a` \[L\]; empty for the sum.
    edges: Vec<[f64; 2]>,
    /// Control of the difference form.
    control: Option<PairControl>,
    resultants: Vec<PointRow>,
}

/// The points at which the resultants are found, and the law that finds them.
#[derive(Clone, Copy)]
pub(crate) struct Sampling<'a> {
    pub packs: &'a Packs,
    pub shear: &'a [ShearPack],
    pub law: PointLaw<'a>,
}

impl StrongForm {
    /// # Errors
    /// [`ShellError::Space`] for pairs whose gradients cannot be found.
    pub fn new(
        reference: &Reference,
        divergence: Divergence,
        viscosity: f64,
        section: &SectionScales,
        surface_density: f64,
    ) -> Result<Self, ShellError> {
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
        let resultants = vec![[[0.0; 3]; 7]; points.len()];
        let (mut own, mut edges, mut control) = (1.0, Vec::new(), None);
        if divergence == Divergence::Difference {
            let edge = points.iter().zip(&reference.cloud.edge_normals);
            own = -1.0;
            edges = edge.map(|(point, r)| [point.frame.t1.dot(r), point.frame.t2.dot(r)]).collect();
            control = Some(PairControl::new(reference, section, CONTROL)?);
        }
        Ok(Self { viscosity, surface_density, own, across, edges, control, resultants })
    }

    /// Minus the right-hand sides of eqs. 4 and 9, times area, into `forces`; returns the elastic energy of the
    /// strains \[F L\], and that of the control, if it is asked for, else zero.
    pub fn evaluate(
        &mut self,
        reference: &Reference,
        Sampling { packs, shear, law }: Sampling<'_>,
        motion: [&[Row]; 2],
        energy: bool,
        forces: &mut [Row],
        threads: usize,
    ) -> f64 {
        let mut resultants = std::mem::take(&mut self.resultants);
        let mut sampled =
            widest(Sampled { packs, shear, law, state: motion[0], energy, resultants: &mut resultants });
        self.resultants = resultants;
        if let Some(control) = &self.control {
            control.evaluate(motion[0], forces, threads);
            if energy {
                sampled += PairControl::energy(motion[0], forces);
            }
        } else {
            forces.fill([0.0; 6]);
        }
        widest(Balance { equations: self, reference, motion, forces });
        sampled
    }

    #[inline(always)]
    fn particle(&self, a: usize, reference: &Reference, motion: [&[Row]; 2]) -> Row {
        let area = reference.cloud.areas[a];
        let stencil = reference.operator.stencil(a);
        let across = &self.across[reference.operator.entries(a)];
        let [n1, n2, m1, m2, torque, x1, x2] = &self.resultants[a];
        // Forces, and moments about axes.
        let mut sum = [0.0; 6];
        sum[3..].copy_from_slice(torque);
        for (k, &b) in stencil.particles.iter().enumerate() {
            if b as usize == a {
                continue;
            }
            let (g1, g2) = (stencil.g1[k], stencil.g2[k]);
            let [o1, o2] = across[k];
            let [p1, p2, r1, r2, ..] = &self.resultants[b as usize];
            let (own1, own2) = (self.own * g1, self.own * g2);
            for i in 0..3 {
                sum[i] += n1[i] * own1 + n2[i] * own2 + p1[i] * o1 + p2[i] * o2;
                sum[3 + i] += m1[i] * own1 + m2[i] * own2 + r1[i] * o1 + r2[i] * o2;
            }
            let push = self.viscous(a, b as usize, reference, motion);
            if push != 0.0 {
                for i in 0..3 {
                    sum[i] -= push * (x1[i] * g1 + x2[i] * g2);
                }
            }
        }
        let mut resisted = sum.map(|value| -area * value);
        if let Some([r1, r2]) = self.edges.get(a) {
            for i in 0..3 {
                resisted[i] += n1[i] * r1 + n2[i] * r2;
                resisted[3 + i] += m1[i] * r1 + m2[i] * r2;
            }
        }
        // A moment Γ is the force Γ × d on the director: d × (Γ × d) is Γ but for its part along d, which no director feels.
        let [x, y, z, u, v, w] = resisted;
        let [.., d1, d2, d3] = motion[0][a];
        [x, y, z, v * d3 - w * d2, w * d1 - u * d3, u * d2 - v * d1]
    }

    /// `ρ₀² t Π` of eq. 4, with `Π = (μ/ρ₀)(−c̄ϑ + 2ϑ²)` for approaching particles and zero for parting ones
    /// \[F/L\].
    ///
    /// The paper adds Π𝕀 to the tensile-positive stress; read so it would feed energy into approaching
    /// particles. It is subtracted here, as a pressure. And it is turned with the particle, Π F in the place of Π𝕀: P reaches from rest to the
    /// present, and 𝕀 there would push along where the neighbour once was.
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
        M: StrainsOf<R::Numbers> + ?Sized,
        S: SectionOf<R::Numbers> + ?Sized,
    >(
        &mut self,
        registers: R,
        law: PointLaw<'_, M, S>,
    ) -> f64 {
        let mut energy = 0.0;
        let zero = Pack3([registers.splat(0.0); 3]);
        for (index, points) in self.packs.order.iter().enumerate() {
            let point = Point { shear: self.shear.get(index), ..Point::new(self.packs, index) };
            let point = point.treated_in(registers);
            let now = point.strained::<false, M>(law.strain, self.state);
            let found = point.forces::<ENERGY, M, S>(law, &now);
            let (f, p) = (found.on_vectors, now.placement);
            let torque = zero - p.d1.cross(f.m1) - p.d2.cross(f.m2) - p.d.cross(f.q);
            if ENERGY {
                energy += pack_of(registers, found.density * point.weight()).sum();
            }
            let vectors = [f.n1, f.n2, p.d.cross(f.m1), p.d.cross(f.m2), torque, p.x1, p.x2];
            for (k, vector) in vectors.iter().enumerate() {
                let [x, y, z] = vector.0;
                let [[x], [y], [z]] = [registers.store(x), registers.store(y), registers.store(z)];
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
        match (law.of_pair::<StretchCorrected>(), self.energy) {
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
            let found = self.equations.particle(a, self.reference, self.motion);
            for (sum, part) in force.iter_mut().zip(found) {
                *sum += part;
            }
        }
    }
}
