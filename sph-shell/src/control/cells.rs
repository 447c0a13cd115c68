//! Zero-energy control of cells: the hourglass of four particles, with free twist and free rigid motion.
//!
//! For the pattern h = (1, −1, 1, −1) the vectors `q_x = Σγ_b x_b`, `q_d = Σγ_b d_b`, with
//! `γ_b = ¼[h_b − G1_b(h·ξ) − G2_b(h·η)]` (\[flanagan1981\]), vanish on linear fields. Their components in the
//! point's own moving vectors,
//!
//! ```text
//! s1 = q_x·x,1   s2 = q_x·x,2   s3 = q_x·d + ½(H11 k11 + H22 k22 + H12 k12)   s4 = q_d·x,1   s5 = q_d·x,2
//! ```
//!
//! less their reference values, are penalised by `U_h = (4/3)[β_x k_s (s1²+s2²+s3²) + β_d D_b (s4²+s5²)]`.
//! `H_αβ` makes a constant twist free: a Kirchhoff shell has `x,αβ·d = −k_αβ`. The factor 8/3 is the mean of
//! |∇|² of the bilinear hourglass times the squared side; `k_s = (5/6)Gt·t²/(t²+w)` keeps the penalty at bending
//! scale for thin shells, where one at shear scale would lock like (Δ/t)².
//!
//! # Swirl of directors
//!
//! Tilts α = c y about one axis and β = −c x about the other leave no strain at the middle of a cell: κ12 is the
//! *symmetric* part of `x,α·d,β`. Where directors stand upright on the surface the antisymmetric part is zero
//! (`x,α·d,β = −x,αβ·d`), so `s6 = x,1·d,2 − x,2·d,1` is curl of shear alone, whose energy `½ w (5/6)Gt c² (Δ1²+Δ2²)/12`
//! over the cell the one point does not see. It is put back: `½ w k_a s6²`, `k_a = (5/6)Gt·t²/(t²+w)·ρ²/12` with ρ² the
//! mean of ξ² + η² over the particles, at bending scale for thin shells as above. Without it coarse strips under a
//! couple lose their loaded end: the mode releases `⅓ w M:k ρ² c²`, and is held by neighbours alone.
//!
//! # Curvature along arcs
//!
//! Directors are unit vectors, their differences chords. Where a cell turns by ψ = kΔ and its directors swing by
//! ±θ about that, the stencil finds `x,1·d,1 = (2/Δ) sin ½ψ cos θ` and `d·d = cos² ½ψ cos² θ`. Two things follow.
//! The swing releases `½ w M:k θ²` of bending energy (M the moments, k the *total* curvature: the directors' forces
//! along themselves sum to `w M:k`; a shell that is curved but free of stress releases nothing), more than
//! `(4/3) β_d D_b θ²` can hold once M:k w > (8/3) β_d D_b, that is kΔ > 0.52 for an elastic strip and β_d = 0.1.
//! And a strip under a couple turns too far by (kΔ)²/6: 0.28 % of the length of a ring of 49 cells.
//!
//! Strains therefore take `k̂ = c k`, arcs for chords. With `u = 1 − d·d` and `z = s4² + s5²` (the part of u that
//! is swing, ≈ `cos² ½ψ sin² θ`), `c = arcsin(√v)/√v · √(1 + z/(1−u))`, `v = u − z`, which is to second order
//!
//! ```text
//! c = 1 + u/6 + 3u²/40 + z (1/3 + 13u/30)
//! ```
//!
//! The z² of the series is left out: it would only soften large swings. The energy is `w ψ(k̂) + U_h`, a potential,
//! so no stiffness that follows the curvature is needed: β_d = 0.1 would hold a swing to kΔ ≈ 1.2. u and z are scalar products
//! of vectors that turn with the shell, and of second order about a flat cell: objective, patch tests unchanged.
//! Measurements and the alternatives: docs/zero-energy-control.md.

mod tangent;

use shell_kinematics::{LANES, Number, Pack, Pack3, Placement, PlacementForces};
use sph_core::{SamplingOperator, Vec3};

use crate::regions::Scales;
use crate::registers::{Registers, in_all};

pub(crate) use tangent::{PointTangent, ScaleTangent, VECTORS};

/// Share β_x of the full stiffness of the position hourglass, for shells thin and thick against the spacing \[–\].
const POSITION_SHARE: [f64; 2] = [0.1, 0.5];
/// Share β_d of the director hourglass \[–\]. One would be the fully integrated value and costs 0.3 % on a plate, 1.3 %
/// on the pinched cylinder.
const DIRECTOR_SHARE: f64 = 0.2;
/// Coefficients of u and u² in the scale c \[–\].
const CHORD: [f64; 2] = [1.0 / 6.0, 3.0 / 40.0];
/// Coefficients of z and uz \[–\].
const HOURGLASS: [f64; 2] = [1.0 / 3.0, 13.0 / 30.0];

/// Constants of the control of four cells.
#[derive(Clone, Debug, Default)]
pub(crate) struct CellPack<P = Pack> {
    /// `¼ h·ξ`, `¼ h·η` \[L\].
    lever: [P; 2],
    /// `H11, H22, H12 = Σγξ², Σγη², Σγξη` \[L²\].
    twist: [P; 3],
    /// `(8/3) β_x k_s` \[F/L\] and `(8/3) β_d D_b` \[F L\]; zero for triangles.
    stiffness: [P; 2],
    /// `w k_a` \[F L³\]; zero for triangles.
    swirl: P,
    /// One quarter; zero for triangles, which have no pattern.
    quarter: P,
    /// Reference values of s1…s6.
    reference: [P; 6],
}

/// The hourglass of four cells as it is now.
pub(crate) struct CellState<P = Pack> {
    q: [Pack3<P>; 2],
    /// s1…s6 less their reference values.
    s: [P; 6],
    /// The same from which the tangent takes the control's forces.
    pulled: [P; 6],
    /// 1 − d·d, the spread of the directors \[–\].
    u: P,
    /// s4² + s5² \[–\].
    z: P,
    /// ∂c/∂z.
    by_z: P,
    /// Arc over chord c \[–\].
    pub scale: P,
    /// Curvature by chords \[1/L\].
    pub curvature: [P; 3],
}

/// What the control adds: forces on the patterns, to be spread by ±¼.
pub(crate) struct PatternForces<P = Pack> {
    pub position: Pack3<P>,
    pub director: Pack3<P>,
}

impl CellPack {
    /// Constants for the sampling points of one pack; reference values are set by [`CellPack::rest`].
    pub fn new(
        operator: &SamplingOperator,
        points: &[u32; LANES],
        weight: Pack,
        positions: &[Vec3],
        scales: &Scales,
    ) -> Self {
        let mut pack = Self::default();
        for (lane, &p) in points.iter().enumerate() {
            let stencil = operator.stencil(p as usize);
            // A triangle has no hourglass.
            if stencil.particles.len() != 4 || weight.lanes()[lane] == 0.0 {
                continue;
            }
            let point = &operator.points[p as usize];
            let local = |axis: &Vec3| -> [f64; 4] {
                std::array::from_fn(|b| (positions[stencil.particles[b] as usize] - point.position).dot(axis))
            };
            let (xi, eta) = (local(&point.frame.t1), local(&point.frame.t2));
            let pattern = [1.0, -1.0, 1.0, -1.0];
            let sum = |f: &dyn Fn(usize) -> f64| (0..4).map(f).sum::<f64>();
            let lever = [sum(&|b| 0.25 * pattern[b] * xi[b]), sum(&|b| 0.25 * pattern[b] * eta[b])];
            let gamma = |b: usize| 0.25 * pattern[b] - stencil.g1[b] * lever[0] - stencil.g2[b] * lever[1];
            let section = scales.at(p as usize);
            let (t, w) = (section.thickness, point.weight);
            let thick = t * t / (t * t + w);
            let shear = section.shear * thick;
            let share = POSITION_SHARE[0] + (POSITION_SHARE[1] - POSITION_SHARE[0]) * thick;
            let values = [
                lever[0],
                lever[1],
                sum(&|b| gamma(b) * xi[b] * xi[b]),
                sum(&|b| gamma(b) * eta[b] * eta[b]),
                sum(&|b| gamma(b) * xi[b] * eta[b]),
                8.0 / 3.0 * share * shear,
                8.0 / 3.0 * DIRECTOR_SHARE * section.bending,
                w * shear * sum(&|b| 0.25 * (xi[b] * xi[b] + eta[b] * eta[b])) / 12.0,
                0.25,
            ];
            let [l1, l2] = &mut pack.lever;
            let [h11, h22, h12] = &mut pack.twist;
            let [kx, kd] = &mut pack.stiffness;
            let slots = [l1, l2, h11, h22, h12, kx, kd, &mut pack.swirl, &mut pack.quarter];
            for (slot, value) in slots.into_iter().zip(values) {
                let mut lanes = slot.lanes();
                lanes[lane] = value;
                *slot = Pack::new(lanes);
            }
        }
        pack
    }

    /// All constants.
    pub fn numbers(&self) -> impl Iterator<Item = Pack> + use<> {
        let Self { lever, twist, stiffness, swirl, quarter, reference } = self.clone();
        lever.into_iter().chain(twist).chain(stiffness).chain([swirl, quarter]).chain(reference)
    }

    /// The constants in registers.
    #[inline(always)]
    pub fn load<const P: usize, R: Registers<P>>(of: [&Self; P], registers: R) -> CellPack<R::Numbers> {
        CellPack {
            lever: registers.loads(in_all(of, |of| &of.lever)),
            twist: registers.loads(in_all(of, |of| &of.twist)),
            stiffness: registers.loads(in_all(of, |of| &of.stiffness)),
            swirl: registers.load(in_all(of, |of| &of.swirl)),
            quarter: registers.load(in_all(of, |of| &of.quarter)),
            reference: registers.loads(in_all(of, |of| &of.reference)),
        }
    }

    /// Takes the present state as the reference; returns its curvature by arcs.
    pub fn rest(&mut self, p: &Placement, curvature: &[Pack; 3], raw: [Pack3; 2]) -> [Pack; 3] {
        self.reference = self.components(p, curvature, &self.patterns(p, raw));
        self.state(p, curvature, raw).arc(*curvature)
    }

    /// `γ_b` of particles from their sign in the pattern and their gradients \[–\].
    #[inline(always)]
    pub fn gamma(&self, sign: f64, g1: Pack, g2: Pack) -> Pack {
        self.quarter * sign - self.lever[0] * g1 - self.lever[1] * g2
    }
}

impl<P: Number> CellPack<P> {
    /// `q_x` and `q_d` from the raw pattern sums `Σh_b x_b`, `Σh_b d_b`.
    #[inline(always)]
    fn patterns(&self, p: &Placement<P>, raw: [Pack3<P>; 2]) -> [Pack3<P>; 2] {
        let [l1, l2] = self.lever;
        [raw[0] * self.quarter - p.x1 * l1 - p.x2 * l2, raw[1] * self.quarter - p.d1 * l1 - p.d2 * l2]
    }

    /// s1…s6 before their reference values are taken off.
    #[inline(always)]
    fn components(&self, p: &Placement<P>, curvature: &[P; 3], q: &[Pack3<P>; 2]) -> [P; 6] {
        let [h11, h22, h12] = self.twist;
        let bent = h11 * curvature[0] + h22 * curvature[1] + h12 * curvature[2];
        let swirl = p.x1.dot(p.d2) - p.x2.dot(p.d1);
        [q[0].dot(p.x1), q[0].dot(p.x2), q[0].dot(p.d) + bent * 0.5, q[1].dot(p.x1), q[1].dot(p.x2), swirl]
    }

    /// Patterns, their components and the scale of the curvature in the present placement.
    #[inline(always)]
    pub fn state(&self, p: &Placement<P>, curvature: &[P; 3], raw: [Pack3<P>; 2]) -> CellState<P> {
        let q = self.patterns(p, raw);
        let now = self.components(p, curvature, &q);
        let mut s = now;
        for i in 0..6 {
            s[i] = now[i] - self.reference[i];
        }
        let one = s[0].all(1.0);
        let u = one - p.d.dot(p.d);
        let z = s[3] * s[3] + s[4] * s[4];
        let by_z = one.all(HOURGLASS[0]) + u * HOURGLASS[1];
        let scale = one + u * (one.all(CHORD[0]) + u * CHORD[1]) + z * by_z;
        CellState { q, s, pulled: s, u, z, by_z, scale, curvature: *curvature }
    }

    /// Stiffness of s1…s6, without what the scale of the curvature adds to s4, s5.
    #[inline(always)]
    pub fn stiffnesses(&self) -> [P; 6] {
        let ([kx, kd], swirl) = (self.stiffness, self.swirl);
        [kx, kx, kx, kd, kd, swirl]
    }

    /// What the control pulls at s1…s6, and its energy \[F L\]; `released` is w M:k of [`CellState::released`].
    #[inline(always)]
    pub fn pulls(&self, state: &CellState<P>, released: P) -> ([P; 6], P) {
        let CellState { s, .. } = state;
        let [kx, kd] = self.stiffness;
        let held = kd + state.by_z * released * 2.0;
        let r = [s[0] * kx, s[1] * kx, s[2] * kx, s[3] * held, s[4] * held, s[5] * self.swirl];
        (r, ((s[0] * r[0] + s[1] * r[1] + s[2] * r[2]) + state.z * kd + s[5] * r[5]) * 0.5)
    }

    /// Adds the forces of what the control pulls to those of the point; returns the pattern forces.
    #[inline(always)]
    pub fn add(
        &self,
        p: &Placement<P>,
        state: &CellState<P>,
        released: P,
        [r1, r2, r3, r4, r5, r6]: [P; 6],
        f: &mut PlacementForces<P>,
    ) -> PatternForces<P> {
        let q = &state.q;
        let [h11, h22, h12] = self.twist;
        let position = p.x1 * r1 + p.x2 * r2 + p.d * r3;
        let director = p.x1 * r4 + p.x2 * r5;
        let half3 = r3 * 0.5;
        let [l1, l2] = self.lever;
        f.n1 += q[0] * r1 + q[1] * r4 + (p.d1 * h11 + p.d2 * h12) * half3 + p.d2 * r6 - position * l1;
        f.n2 += q[0] * r2 + q[1] * r5 + (p.d2 * h22 + p.d1 * h12) * half3 - p.d1 * r6 - position * l2;
        f.q += q[0] * r3 - p.d * (state.by_u() * released * 2.0);
        f.m1 += (p.x1 * h11 + p.x2 * h12) * half3 - p.x2 * r6 - director * l1;
        f.m2 += (p.x2 * h22 + p.x1 * h12) * half3 + p.x1 * r6 - director * l2;
        PatternForces { position: position * self.quarter, director: director * self.quarter }
    }
}

impl<P: Number> CellState<P> {
    /// s1…s6 less their reference values.
    pub fn components(&self) -> &[P; 6] {
        &self.s
    }

    /// What the scale of the curvature adds to the pulls at s4, s5.
    #[inline(always)]
    pub fn pulled_by_scale(&self, released: P) -> [P; 2] {
        let more = self.by_z * released * 2.0;
        [self.s[3] * more, self.s[4] * more]
    }

    /// Takes the control's forces, for the tangent, from another state.
    pub fn pull_as(&mut self, other: &Self) {
        self.pulled = other.s;
    }

    /// ∂c/∂u.
    #[inline(always)]
    fn by_u(&self) -> P {
        self.u.all(CHORD[0]) + self.u * (2.0 * CHORD[1]) + self.z * HOURGLASS[1]
    }

    /// The curvature measured along arcs: a chord's, times the scale.
    #[inline(always)]
    pub fn arc(&self, curvature: [P; 3]) -> [P; 3] {
        let [k11, k22, k12] = curvature;
        [k11 * self.scale, k22 * self.scale, k12 * self.scale]
    }

    /// M:k, what a unit of shortening would release per area, from forces on the curvature by arcs \[F/L\].
    #[inline(always)]
    pub fn released(&self, moment: &[P; 3]) -> P {
        let [k11, k22, k12] = self.curvature;
        k11 * moment[0] + k22 * moment[1] + k12 * moment[2]
    }
}
