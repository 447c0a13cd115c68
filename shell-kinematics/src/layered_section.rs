//! Layered sections: orthotropic plies in plane stress, each rotated in its plane, by classical lamination.
//!
//! A ply's plane-stress stiffness in its own axes is `Q11 = E_L/(1−ν²E_T/E_L)`, `Q22 = Q11 E_T/E_L`,
//! `Q12 = ν Q22`, `Q66 = G_LT`. Turned by θ it is, with the invariants of \[tsai1968\],
//!
//! ```text
//! U1 = (3Q11+3Q22+2Q12+4Q66)/8   U2 = (Q11−Q22)/2   U3 = (Q11+Q22−2Q12−4Q66)/8
//! U4 = (Q11+Q22+6Q12−4Q66)/8     U5 = (Q11+Q22−2Q12+4Q66)/8
//! Q̄11 = U1 + U2 cos2θ + U3 cos4θ   Q̄12 = U4 − U3 cos4θ   Q̄16 = ½U2 sin2θ + U3 sin4θ
//! Q̄22 = U1 − U2 cos2θ + U3 cos4θ   Q̄66 = U5 − U3 cos4θ   Q̄26 = ½U2 sin2θ − U3 sin4θ
//! ```
//!
//! and the strain `e + ζκ` gives `N = Ae + Bκ`, `M = Be + Dκ` with `A, B, D = Σ ∫ Q̄ (1, ζ, ζ²) dζ`.

use crate::expansion::Expansion;
use crate::pack::Pack;
use crate::section::{Isotropic, MaterialError, Section, SectionScales, finite_expansion, linear_tangent};
use crate::stiffness::{Matrix3, Stiffness};
use crate::strains::{Resultants, Strains};
use crate::strength::Strength;
use crate::tangent::Matrix8;
use crate::transverse_shear::{Sheared, shear_correction};

/// Orthotropic linear elasticity of a ply in plane stress: one axis along the fibre, one across it.
#[derive(Clone, Copy, Debug)]
pub struct Orthotropic {
    along: f64,
    across: f64,
    poisson: f64,
    shear: f64,
    shear_across: f64,
    expansion: Option<[f64; 2]>,
    strength: Option<Strength>,
}

impl Orthotropic {
    /// Young's moduli `along` and `across` the fibre \[F/L²\], major Poisson's ratio ν_LT (contraction across under
    /// stress along) \[–\], shear modulus G_LT in the planes that hold the fibre and G_TT in the plane across it
    /// \[F/L²\].
    ///
    /// # Errors
    /// [`MaterialError::Modulus`] unless all moduli are positive and finite, [`MaterialError::MajorPoisson`] unless
    /// `ν_LT² < E_L/E_T`: beyond that some strain would release energy.
    pub fn new(
        along: f64,
        across: f64,
        poisson: f64,
        shear: f64,
        shear_across: f64,
    ) -> Result<Self, MaterialError> {
        for (what, value) in [
            ("Young's modulus along the fibre", along),
            ("Young's modulus across the fibre", across),
            ("the shear modulus along the fibre", shear),
            ("the shear modulus across the fibre", shear_across),
        ] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(MaterialError::Modulus { what, value });
            }
        }
        let left = 1.0 - poisson * poisson * (across / along);
        if left.is_nan() || left <= 0.0 {
            return Err(MaterialError::MajorPoisson { value: poisson, bound: (along / across).sqrt() });
        }
        Ok(Self { along, across, poisson, shear, shear_across, expansion: None, strength: None })
    }

    /// The same with coefficients of thermal expansion along the fibre and across it \[1/Θ\], Θ a temperature.
    ///
    /// # Errors
    /// [`MaterialError::Constant`] unless both are finite.
    pub fn expanding(self, [along, across]: [f64; 2]) -> Result<Self, MaterialError> {
        Ok(Self { expansion: Some([finite_expansion(along)?, finite_expansion(across)?]), ..self })
    }

    /// The same with what a ply of it bears.
    pub fn strong(self, strength: Strength) -> Self {
        Self { strength: Some(strength), ..self }
    }

    /// What a ply of it bears, where that is known.
    pub fn strength(&self) -> Option<&Strength> {
        self.strength.as_ref()
    }

    /// Coefficients of thermal expansion along the fibre and across it \[1/Θ\], where they are known.
    pub(crate) fn expansion(&self) -> Option<[f64; 2]> {
        self.expansion
    }

    /// One that is the same in all directions.
    pub(crate) fn isotropic(material: &Isotropic) -> Self {
        let (young, shear, poisson) = (material.young, material.shear(), material.poisson);
        let expansion = material.expansion.map(|own| [own; 2]);
        let strength = material.strength.map(Strength::Yield);
        Self { along: young, across: young, poisson, shear, shear_across: shear, expansion, strength }
    }

    /// Strain `11, 22, 2·12` of a ply that is free, rotated by `angle` \[rad\], a degree of temperature \[1/Θ\].
    fn free_strain(&self, angle: f64) -> Option<[f64; 3]> {
        let (s, c) = libm::sincos(angle);
        self.expansion.map(|[l, t]| [l * c * c + t * s * s, l * s * s + t * c * c, 2.0 * s * c * (l - t)])
    }

    /// As far as the transverse shear of a ply of a thickness \[L\] goes: means over all directions.
    fn sheared(&self, thickness: f64) -> Sheared {
        let [q11, q22, q12, q66] = self.plane_stress();
        let stretch = (3.0 * (q11 + q22) + 2.0 * q12 + 4.0 * q66) / 8.0;
        Sheared { stretch, shear: 0.5 * (self.shear + self.shear_across), thickness }
    }

    /// `[Q11, Q22, Q12, Q66]` in the axes of the fibre \[F/L²\].
    pub(crate) fn plane_stress(&self) -> [f64; 4] {
        let ratio = self.across / self.along;
        let q11 = self.along / (1.0 - self.poisson * self.poisson * ratio);
        [q11, q11 * ratio, q11 * ratio * self.poisson, self.shear]
    }

    /// The greatest stiffness that a plane wave meets, `max Q̄11(θ)` \[F/L²\].
    ///
    /// A wave along n that moves along m meets `Q:(m⊗n):(m⊗n)`. With p = cos of the angle between them and c = cos 2α of
    /// the direction half-way, four times it is
    /// `(p+c)²Q11 + (p−c)²Q22 + 2(p²−c²)Q12 + 4(1−c²)Q66`: convex in p, so greatest for m = ±n, and then a parabola in
    /// c between Q22 at −1 and Q11 at 1 whose top may lie between them.
    fn stiffest(&self) -> f64 {
        let [q11, q22, q12, q66] = self.plane_stress();
        let [slope, bend] = [2.0 * (q11 - q22), q11 + q22 - 2.0 * q12 - 4.0 * q66];
        let ends = q11.max(q22);
        let top = -0.5 * slope / bend;
        if bend < 0.0 && top.abs() < 1.0 {
            let middle = q11 + q22 + 2.0 * q12 + 4.0 * q66;
            ends.max(0.25 * (middle + slope * top + bend * top * top))
        } else {
            ends
        }
    }

    /// Plane-stress stiffness and transverse shear stiffness of a ply rotated by `angle` \[rad\].
    fn rotated(&self, angle: f64) -> (Matrix3, [[f64; 2]; 2]) {
        let [q11, q22, q12, q66] = self.plane_stress();
        let (s2, c2) = libm::sincos(2.0 * angle);
        let (s4, c4) = libm::sincos(4.0 * angle);
        let u1 = (3.0 * (q11 + q22) + 2.0 * q12 + 4.0 * q66) / 8.0;
        let u2 = 0.5 * (q11 - q22);
        let u3 = (q11 + q22 - 2.0 * q12 - 4.0 * q66) / 8.0;
        let u4 = (q11 + q22 + 6.0 * q12 - 4.0 * q66) / 8.0;
        let u5 = (q11 + q22 - 2.0 * q12 + 4.0 * q66) / 8.0;
        let across = u4 - u3 * c4;
        let [skew1, skew2] = [0.5 * u2 * s2 + u3 * s4, 0.5 * u2 * s2 - u3 * s4];
        let plane = [
            [u1 + u2 * c2 + u3 * c4, across, skew1],
            [across, u1 - u2 * c2 + u3 * c4, skew2],
            [skew1, skew2, u5 - u3 * c4],
        ];
        let [mean, half] = [0.5 * (self.shear + self.shear_across), 0.5 * (self.shear - self.shear_across)];
        (plane, [[mean + half * c2, half * s2], [half * s2, mean - half * c2]])
    }
}

/// One ply of a [`LayeredSection`].
#[derive(Clone, Copy, Debug)]
pub struct Ply {
    /// What it is made of.
    pub material: Orthotropic,
    /// Thickness \[L\].
    pub thickness: f64,
    /// Angle of the fibre from the first axis of the point's frame, positive towards the second \[rad\].
    pub angle: f64,
}

/// Plies on one another, bent by one director.
///
/// Transverse shear is `Q = k Σ t_k Ḡ_k γ`: one shear strain for all plies, and one factor by which the energy is that of the shear stress of
/// bending, 5/6 of plies of one material, small where a soft core lies between stiff faces (transverse_shear.rs).
#[derive(Clone, Debug)]
pub struct LayeredSection {
    /// What is read of its plies (ply_stress.rs); no step looks at them.
    pub(crate) plies: Vec<Ply>,
    pub(crate) stiffness: Stiffness,
    scales: SectionScales,
    expansion: Option<Expansion>,
}

impl LayeredSection {
    /// Plies from the lowest (against the normal) to the highest; their middle is the mid-surface.
    ///
    /// # Errors
    /// [`MaterialError`] for no ply at all, a thickness that is not positive, an angle that is not finite.
    pub fn new(plies: &[Ply]) -> Result<Self, MaterialError> {
        if plies.is_empty() {
            return Err(MaterialError::NoPlies);
        }
        for ply in plies {
            if !(ply.thickness > 0.0 && ply.thickness.is_finite()) {
                return Err(MaterialError::Thickness(ply.thickness));
            }
            if !ply.angle.is_finite() {
                return Err(MaterialError::Angle(ply.angle));
            }
        }
        let thickness: f64 = plies.iter().map(|ply| ply.thickness).sum();
        let [mut membrane, mut coupling, mut bending] = [[[0.0; 3]; 3]; 3];
        let mut shear = [[0.0; 2]; 2];
        let sheared: Vec<Sheared> = plies.iter().map(|ply| ply.material.sheared(ply.thickness)).collect();
        let correction = shear_correction(&sheared);
        let mut bottom = -0.5 * thickness;
        let mut expansion = Some(Expansion::none(thickness));
        for ply in plies {
            let (plane, across) = ply.material.rotated(ply.angle);
            let (t, middle) = (ply.thickness, bottom + 0.5 * ply.thickness);
            // ∫1, ∫ζ, ∫ζ² over the ply, about its own middle: no difference of nearly equal cubes.
            let moments = [t, t * middle, t * (middle * middle + t * t / 12.0)];
            for (matrix, moment) in [&mut membrane, &mut coupling, &mut bending].into_iter().zip(moments) {
                add(matrix, &plane, moment);
            }
            add(&mut shear, &across, correction * t);
            let free = ply.material.free_strain(ply.angle);
            expansion = expansion.zip(free).map(|(sum, free)| sum.with_ply(&plane, free, moments));
            bottom += t;
        }
        let stiffest = plies.iter().fold(0.0_f64, |most, ply| most.max(ply.material.stiffest()));
        let stiffness = Stiffness { membrane, coupling, bending, shear };
        let scales = stiffness.scales(thickness, stiffest * thickness);
        Ok(Self { plies: plies.to_vec(), stiffness, scales, expansion })
    }
}

impl LayeredSection {
    /// Transverse shear stiffness \[F/L\].
    pub(crate) fn transverse_shear(&self) -> &[[f64; 2]; 2] {
        &self.stiffness.shear
    }
}

fn add<const N: usize>(sum: &mut [[f64; N]; N], matrix: &[[f64; N]; N], factor: f64) {
    for (row, from) in sum.iter_mut().zip(matrix) {
        row.iter_mut().zip(from).for_each(|(value, more)| *value += factor * more);
    }
}

impl Section for LayeredSection {
    fn linear(&self) -> bool {
        true
    }

    fn resultants(&self, strains: &Strains) -> Resultants {
        self.stiffness.resultants(strains)
    }

    fn tangent(&self, _: &Strains) -> Matrix8 {
        linear_tangent(self)
    }

    fn expansion(&self) -> Option<Expansion> {
        self.expansion
    }

    fn energy(&self, strains: &Strains) -> Pack {
        self.resultants(strains).work(strains) * 0.5
    }

    /// Membrane is that of the stiffest ply in its stiffest direction through the whole thickness: no wave is faster.
    fn scales(&self) -> SectionScales {
        self.scales
    }
}
