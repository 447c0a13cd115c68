//! Own section: a plate whose stiffness is graded through its thickness, metal below and ceramic above.
//!
//! A [`Section`] turns strains into resultants, as the derivative of an energy. Young's modulus goes from
//! E₀ below to E₁ above with a power of the height, ν is the same throughout, so that all stiffnesses are one matrix of
//! plane stress, `C = 1/(1−ν²) [[1,ν,0],[ν,1,0],[0,0,(1−ν)/2]]`, times a moment of E:
//!
//! ```text
//! E(ζ) = E₀ + (E₁ − E₀)(½ + ζ/t)ⁿ,     N = C(A e + B κ),   M = C(B e + D κ),   Q = κ_s G t γ
//! A, B, D = ∫ E(ζ) (1, ζ, ζ²) dζ = E₀ t^(k+1) m_k(0) + (E₁ − E₀) t^(k+1) m_k(n),   m_k(n) = ∫₀¹ sⁿ (s − ½)ᵏ ds
//! ```
//!
//! B does not vanish: bending stretches the mid-surface. Under a moment M on opposite edges and none on the others,
//!
//! ```text
//! κ11 = M/(D − B²/A),   κ22 = −ν κ11,   e = −(B/A) κ        (the neutral surface lies at ζ = B/A)
//! ```
//!
//! uniformly, whatever the mesh: the shell must give it to round-off.
//!
//! `cargo run --release -p coque --example 5_own_section`; before: `4_own_load`, next: `6_own_kernel`.

use std::error::Error;

use explicit_dynamics::Amplitude;
use implicit_statics::{Equilibrium, linear_response};
use shell_kinematics::{
    Matrix8, Pack, Resultants, Section, SectionScales, Strains, StretchCorrected, linear_tangent,
};
use sph_core::{Plate, Side, Vec3, jittered_lattice};
use sph_shell::{
    AppliedLoad, CoupleAxis, EdgeCouple, Formulation, Held, Parts, Reach, Shell, StaticShell, Supported,
    SymmetryPlane,
};

/// A plate graded through its thickness.
struct Graded {
    thickness: f64,
    poisson: f64,
    /// A, B, D over 1−ν² \[F/L, F, F L\].
    moments: [f64; 3],
    /// Transverse shear stiffness \[F/L\], κ_s = 5/6 as of a homogeneous plate.
    shear: f64,
}

impl Graded {
    /// From `E = [E₀, E₁]` \[F/L²\], ν, t and the exponent n.
    fn new(young: [f64; 2], poisson: f64, thickness: f64, exponent: f64) -> Self {
        let shape = |n: f64| {
            let [a, b, c] = [1.0, 2.0, 3.0].map(|k| 1.0 / (n + k));
            [a, b - 0.5 * a, c - b + 0.25 * a]
        };
        let (even, graded) = (shape(0.0), shape(exponent));
        let moments: [f64; 3] = std::array::from_fn(|k| {
            let mean = young[0] * even[k] + (young[1] - young[0]) * graded[k];
            mean * thickness.powi(k as i32 + 1) / (1.0 - poisson * poisson)
        });
        let shear = 5.0 / 6.0 * moments[0] * 0.5 * (1.0 - poisson);
        Self { thickness, poisson, moments, shear }
    }
}

impl Section for Graded {
    fn linear(&self) -> bool {
        true
    }

    fn resultants(&self, strains: &Strains) -> Resultants {
        let [a, b, d] = self.moments;
        let nu = self.poisson;
        let plane = |s: [Pack; 3]| [s[0] + s[1] * nu, s[1] + s[0] * nu, s[2] * (0.5 * (1.0 - nu))];
        let mixed = |first: f64, second: f64| -> [Pack; 3] {
            std::array::from_fn(|i| strains.membrane[i] * first + strains.curvature[i] * second)
        };
        Resultants {
            membrane: plane(mixed(a, b)),
            moment: plane(mixed(b, d)),
            shear: strains.shear.map(|gamma| gamma * self.shear),
        }
    }

    fn tangent(&self, _: &Strains) -> Matrix8 {
        linear_tangent(self)
    }

    fn energy(&self, strains: &Strains) -> Pack {
        self.resultants(strains).work(strains) * 0.5
    }

    fn scales(&self) -> SectionScales {
        let ([a, b, d], thickness) = (self.moments, self.thickness);
        SectionScales { thickness, bending: d - b * b / a, shear: self.shear, membrane: a }
    }
}

/// Relative: round-off, the thin plate being 10⁵ times stiffer against stretching than against bending.
const TOLERANCE: f64 = 1e-9;

fn main() -> Result<(), Box<dyn Error>> {
    let section = Graded::new([70e9, 380e9], 0.3, 0.01, 2.0);
    let off = difference(&section);
    println!("resultants against differences of the energy: {off:.1e}");
    let moment = 100.0; // N, a couple per length
    let [a, b, _] = section.moments;
    let curvature = moment / (section.scales().bending * (1.0 - section.poisson.powi(2)));
    let exact = [-b / a * curvature, 0.5 * curvature, -0.5 * section.poisson * curvature];

    let (mut system, corners) = plate(section, moment)?;
    let response = linear_response(&mut system, 0.0)?;
    system.update(&response);
    let moved = corners.map(|a| system.shell().displacement(a as usize));
    let found = [moved[0].x, -moved[0].z, -moved[1].z];
    let mut errors = 0.0;
    println!("{:<14} {:>13} {:>13}", "displacement", "found [m]", "exact");
    for (i, name) in ["u at (1, 0)", "w at (1, 0)", "w at (0, 1)"].into_iter().enumerate() {
        println!("{name:<14} {:>13.6e} {:>13.6e}", found[i], exact[i]);
        errors += (found[i] / exact[i] - 1.0).abs();
    }
    println!("sum of relative errors {errors:.1e}");
    if off + errors <= TOLERANCE { Ok(()) } else { Err(format!("at most {TOLERANCE:.0e} is allowed").into()) }
}

/// `σ·δ` against `(U(ε + δ) − U(ε − δ))/2` for strains ε and a change δ without any symmetry, over the energy.
fn difference(section: &Graded) -> f64 {
    let strain = [1e-3, -2e-3, 1.5e-3, 0.3, 0.1, -0.2, 1e-3, 2e-3];
    let change = [2e-6, 1e-6, -3e-6, 1e-4, 4e-4, 3e-4, -1e-6, 2e-6];
    let at = |factor: f64| {
        let [a, b, c, d, e, f, g, h] = std::array::from_fn(|i| Pack::splat(strain[i] + factor * change[i]));
        Strains { membrane: [a, b, c], curvature: [d, e, f], shear: [g, h] }
    };
    let energy = |factor: f64| section.energy(&at(factor)).lanes()[0];
    let work = |other: &Strains| section.resultants(&at(0.0)).work(other).lanes()[0];
    (0.5 * (energy(1.0) - energy(-1.0)) - (work(&at(1.0)) - work(&at(0.0)))).abs() / energy(0.0)
}

/// A quarter of a plate of 2 × 2 on a disordered cloud, a couple on x = 1; and the corners (1, 0) and (0, 1).
fn plate(section: Graded, moment: f64) -> Result<(StaticShell, [u32; 2]), Box<dyn Error>> {
    let cloud = jittered_lattice(&Plate { lengths: [1.0, 1.0] }, [9, 9], 0.25, 1)?;
    let sides = cloud.sides.clone().ok_or("a lattice has sides")?;
    let corner = |u, v| sides.corner(u, v).ok_or("two sides meet in a corner");
    let corners = [corner(Side::U1, Side::V0)?, corner(Side::U0, Side::V1)?];
    let held = |particles: &[u32], support| Supported { particles: particles.to_vec(), support };
    let middle = [corner(Side::U0, Side::V0)?];
    let supports = vec![
        held(sides.edge(Side::U0), Box::new(SymmetryPlane { normal: Vec3::x() })),
        held(sides.edge(Side::V0), Box::new(SymmetryPlane { normal: Vec3::y() })),
        held(&middle, Box::new(Held { displacement: vec![Vec3::z()], director: None })),
    ];
    // On an uneven edge each particle stands for its own part of it, half way to its neighbours.
    let edge = sides.edge(Side::U1).iter().map(|&a| (a, cloud.edge_normals[a as usize].x)).collect();
    let couple = EdgeCouple { edge, moment, axis: CoupleAxis::Fixed(Vec3::y()) };
    let shell = Shell::builder(Parts {
        supports,
        loads: vec![AppliedLoad { load: Box::new(couple), amplitude: Amplitude::Constant }],
        section: Box::new(section),
        strain: &StretchCorrected,
        material_axis: None,
        density: 5000.0,
        formulation: Formulation::StressPoint(Reach::Cell),
        threads: 1,
        cloud,
    })
    .build()?;
    Ok((StaticShell::new(shell), corners))
}
