//! One point of a bar along a line of the surface: strains from the tangent of the line and the director, with their transposes.
//!
//! The centroid line of the bar runs at the height e over the line of the particles, `r = x + e d`. Of the line the bar knows three vectors:
//! `x′`, the mean director d and `d′`, derivatives by the length of the line at rest. With the arc over the chord c of the turn from end to end, as the
//! surface has it (`c = 1 + u/6 + 3u²/40`, `u = 1 − d·d`), and a capital for rest,
//!
//! ```text
//! r′ = x′ + e c d′      p = r′·r′
//! ε = (p − P)/2P + ½ g (τ̂² − T̂²)           stretch of the centroid line; fibres beside it lengthen as the bar twists
//! κ = (c r′·d′/√p − …)/√P                    bending in the plane of the director, freed of stretch
//! γ = x′·d/(√p |d|) − …                      transverse shear
//! τ = τ̂ − T̂,  τ̂ = c (x′ × d)·d′/(√p |d| √P)  twist
//! ψ = ½ √P (EA ε² + EI κ² + GA_s γ² + GJ τ²)  energy by length of the line of particles
//! ```
//!
//! After Reissner \[reissner1972\] \[simo1985\], of whose three directors one is the shell's and the bar has no other; g is the square of the polar radius of
//! gyration about the centroid \[wagner1929\]. Bending of the line in the surface is not seen: there the surface itself is stiff. A director of unit
//! length has `d·d′ = 0`, so that r′ has no part along d beside that of x′.
//!
//! All of it is a function of the six products `x′·x′, x′·d′, d′·d′, d·d, x′·d, (x′ × d)·d′`, of which rotations leave every one: [`Jet`] differentiates
//! that function, the rest is written out.

use std::f64::consts::PI;

use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

use crate::jet::{Jet, VARIABLES};

/// Least length of the centroid line over that of the particles at rest: less is a bar that reaches the centre of curvature of its line.
const LEAST_LENGTH: f64 = 0.1;

/// Stiffness of the cross-section of a bar.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BarSection {
    /// EA \[F\].
    pub axial: f64,
    /// EI about the axis across the bar in the surface, through the centroid \[F L²\].
    pub bending: f64,
    /// GA of transverse shear, with whatever factor it has \[F\].
    pub shear: f64,
    /// GJ \[F L²\].
    pub torsion: f64,
    /// Square of the polar radius of gyration about the centroid \[L²\].
    pub gyration: f64,
}

/// The line and the director at a point.
#[derive(Clone, Copy, Debug)]
pub struct BarPlacement {
    /// `x′` \[–\].
    pub x1: Vector3<f64>,
    /// The director, the mean of both ends \[–\].
    pub d: Vector3<f64>,
    /// `d′` \[1/L\].
    pub d1: Vector3<f64>,
}

/// Strains: axial \[–\], curvature \[1/L\], shear \[–\], twist \[1/L\].
pub type BarStrains = [f64; 4];

/// Forces over `[x′, d, d′]`.
pub type BarForces = SVector<f64, 9>;

/// Second derivatives over `[x′, d, d′]`.
pub type BarTangent = SMatrix<f64, 9, 9>;

/// A bar at a point of its line.
#[derive(Clone, Copy, Debug)]
pub struct Bar {
    section: BarSection,
    height: f64,
    rest: Rest,
}

/// What is measured at rest.
#[derive(Clone, Copy, Debug)]
struct Rest {
    /// `P`, and the square root \[–\].
    square: f64,
    length: f64,
    /// Curvature and twist by length of the particles, shear.
    curvature: f64,
    shear: f64,
    twist: f64,
}

/// What becomes strains: `p`, curvature, shear, twist by length of the particles.
fn measures<const N: usize>(s: [Jet<N>; VARIABLES], height: f64) -> [Jet<N>; 4] {
    let [s1, s2, s3, s4, s5, s6] = s;
    let u = (s4 * -1.0).changed(-1.0, 1.0);
    let arc = (u * u * (3.0 / 40.0) + u * (1.0 / 6.0)).changed(-1.0, 1.0);
    let (along, square) = (arc * s2, arc * arc * s3);
    let p = s1 + along * (2.0 * height) + square * (height * height);
    let over_length = p.inverse_root();
    let over_both = (p * s4).inverse_root();
    [p, (along + square * height) * over_length, s5 * over_both, arc * s6 * over_both]
}

impl BarSection {
    /// A rectangle of moduli E and G \[F/L²\], its width across the bar in the surface and its height along the director \[L\]: shear with the factor
    /// 5/6, torsion of St Venant,
    ///
    /// ```text
    /// J = a b³/3 [1 − (192/π⁵) (b/a) Σ_{n odd} tanh(nπa/2b)/n⁵]        a the longer side \[timoshenko1951\]
    /// ```
    pub fn rectangle([young, shear]: [f64; 2], width: f64, height: f64) -> Self {
        let (a, b) = (width.max(height), width.min(height));
        let term = |n: f64| libm::tanh(0.5 * n * PI * a / b) / n.powi(5);
        let sum: f64 = (0..16).map(|k| term(f64::from(2 * k + 1))).sum();
        let torsion = a * b.powi(3) / 3.0 * (1.0 - 192.0 / PI.powi(5) * b / a * sum);
        let area = width * height;
        Self {
            axial: young * area,
            bending: young * area * height * height / 12.0,
            shear: shear * area * 5.0 / 6.0,
            torsion: shear * torsion,
            gyration: (width * width + height * height) / 12.0,
        }
    }

    /// A part of it, such as the half on one side of a plane along it.
    pub fn part(self, share: f64) -> Self {
        Self {
            axial: self.axial * share,
            bending: self.bending * share,
            shear: self.shear * share,
            torsion: self.torsion * share,
            ..self
        }
    }
}

impl BarPlacement {
    fn products(&self) -> [f64; VARIABLES] {
        let Self { x1, d, d1 } = self;
        [x1.dot(x1), x1.dot(d1), d1.dot(d1), d.dot(d), x1.dot(d), x1.cross(d).dot(d1)]
    }

    fn jets<const N: usize>(&self) -> [Jet<N>; VARIABLES] {
        let products = self.products();
        std::array::from_fn(|i| Jet::variable(i, products[i]))
    }

    /// `∂s/∂[x′, d, d′]`, a row each product.
    fn gradients(&self) -> [BarForces; VARIABLES] {
        let Self { x1, d, d1 } = self;
        let zero = Vector3::zeros();
        let row = |a: Vector3<f64>, b: Vector3<f64>, c: Vector3<f64>| {
            BarForces::from_iterator(a.iter().chain(b.iter()).chain(c.iter()).copied())
        };
        [
            row(x1 * 2.0, zero, zero),
            row(*d1, zero, *x1),
            row(zero, zero, d1 * 2.0),
            row(zero, d * 2.0, zero),
            row(*d, *x1, zero),
            row(d.cross(d1), d1.cross(x1), x1.cross(d)),
        ]
    }

    /// `Σ f ∂²s/∂[x′, d, d′]²`.
    fn second(&self, f: &[f64; VARIABLES]) -> BarTangent {
        let one = Matrix3::identity();
        let Self { x1, d, d1 } = self;
        let [x, m, w] = [0, 3, 6];
        let blocks = [
            (x, x, one * (2.0 * f[0])),
            (x, w, one * f[1] + d.cross_matrix() * f[5]),
            (w, w, one * (2.0 * f[2])),
            (m, m, one * (2.0 * f[3])),
            (x, m, one * f[4] - d1.cross_matrix() * f[5]),
            (m, w, -x1.cross_matrix() * f[5]),
        ];
        let mut out = BarTangent::zeros();
        for (row, column, block) in blocks {
            out.fixed_view_mut::<3, 3>(row, column).copy_from(&block);
            if row != column {
                out.fixed_view_mut::<3, 3>(column, row).copy_from(&block.transpose());
            }
        }
        out
    }
}

impl Bar {
    /// A bar that is free of stress at rest; none where its centroid line comes to the centre of curvature of the line of particles, or beyond.
    pub fn new(section: BarSection, height: f64, rest: &BarPlacement) -> Option<Self> {
        let [p, curvature, shear, twist] = measures::<0>(rest.jets(), height).map(|measure| measure.value);
        // Along the line of particles: negative on the far side of the centre.
        let along = (rest.x1 + rest.d1 * height).dot(&rest.x1) / rest.x1.norm_squared();
        let rest = Rest { square: p, length: p.sqrt(), curvature, shear, twist };
        (along > LEAST_LENGTH).then_some(Self { section, height, rest })
    }

    /// Length of the centroid line over that of the particles at rest \[–\].
    pub fn length(&self) -> f64 {
        self.rest.length
    }

    fn strain_jets<const N: usize>(&self, placement: &BarPlacement) -> [Jet<N>; 4] {
        let Rest { square, length, curvature, shear, twist } = self.rest;
        let [p, k, s, t] = measures(placement.jets(), self.height);
        let helix = (t * t).changed(twist * twist, 0.5 * self.section.gyration / square);
        let axial = p.changed(square, 0.5 / square) + helix;
        [axial, k.changed(curvature, 1.0 / length), s.changed(shear, 1.0), t.changed(twist, 1.0 / length)]
    }

    /// Strains.
    pub fn strains(&self, placement: &BarPlacement) -> BarStrains {
        self.strain_jets::<0>(placement).map(|strain| strain.value)
    }

    /// Axial force \[F\], bending moment about the centroid \[F L\], shear force \[F\], torque \[F L\].
    pub fn resultants(&self, strains: &BarStrains) -> [f64; 4] {
        let BarSection { axial, bending, shear, torsion, .. } = self.section;
        let [e, k, s, t] = strains;
        [axial * e, bending * k, shear * s, torsion * t]
    }

    /// Energy by length of the line of particles \[F\].
    pub fn energy(&self, placement: &BarPlacement) -> f64 {
        let strains = self.strains(placement);
        let work = self.resultants(&strains).into_iter().zip(strains).map(|(force, strain)| force * strain);
        0.5 * self.rest.length * work.sum::<f64>()
    }

    /// The derivative of [`Bar::energy`] over the placement.
    pub fn forces(&self, placement: &BarPlacement) -> BarForces {
        let strains = self.strain_jets::<0>(placement);
        let stress = self.resultants(&strains.map(|strain| strain.value));
        let over: [f64; VARIABLES] = over_products(&strains, &stress);
        let parts = placement.gradients().into_iter().zip(over);
        parts.map(|(gradient, f)| gradient * f).sum::<BarForces>() * self.rest.length
    }

    /// Its second derivative, with the stresses of another placement if one is given.
    pub fn tangent(&self, placement: &BarPlacement, stressed: Option<&BarPlacement>) -> BarTangent {
        let strains = self.strain_jets::<VARIABLES>(placement);
        let values = stressed.map_or_else(|| strains.map(|strain| strain.value), |there| self.strains(there));
        let stress = self.resultants(&values);
        let BarSection { axial, bending, shear, torsion, .. } = self.section;
        let stiffness = [axial, bending, shear, torsion];
        let gradients = placement.gradients();
        let mut out = placement.second(&over_products(&strains, &stress));
        for i in 0..VARIABLES {
            let mut row = BarForces::zeros();
            for j in 0..VARIABLES {
                let over: f64 = (0..4)
                    .map(|k| {
                        let strain = &strains[k];
                        stiffness[k] * strain.slope[i] * strain.slope[j] + stress[k] * strain.curve[i][j]
                    })
                    .sum();
                row += gradients[j] * over;
            }
            out += gradients[i] * row.transpose();
        }
        out * self.rest.length
    }
}

/// `Σ σ ∂ε/∂s`.
fn over_products<const N: usize>(strains: &[Jet<N>; 4], stress: &[f64; 4]) -> [f64; VARIABLES] {
    std::array::from_fn(|i| strains.iter().zip(stress).map(|(strain, stress)| stress * strain.slope[i]).sum())
}
