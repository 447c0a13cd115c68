//! Own weight of moving least squares: Wendland's C⁶ function, on the source's cantilever under a small load.
//!
//! Any [`Kernel`] is a [`Weight`], stretched to the support; its integral does not matter, the basis is reproduced whatever it is.
//!
//! `cargo run -p sr-galerkin --example own_weight`

use std::error::Error;
use std::f64::consts::PI;

use implicit_statics::{Equilibrium, linear_response};
use solid_kinematics::{Formulation, Material, Moduli, Tangent, Tensor};
use sph_core::{Basis, Hexahedra, Kernel, MovingLeastSquares, Support, Vec3, Weight, WendlandC4};
use sr_galerkin::{Condition, Essential, Galerkin, Load, Parts, Volumes};

struct WendlandC6;

impl Kernel for WendlandC6 {
    fn name(&self) -> &'static str {
        "wendland-c6"
    }

    fn describe(&self) -> &'static str {
        "Wendland's C6 kernel, support 2 h"
    }

    fn support(&self) -> f64 {
        2.0
    }

    fn value(&self, q: f64) -> f64 {
        let u = 0.5 * q;
        39.0 / (14.0 * PI) * (1.0 - u).max(0.0).powi(8) * (1.0 + u * (8.0 + u * (25.0 + u * 32.0)))
    }

    fn slope(&self, q: f64) -> f64 {
        let u = 0.5 * q;
        -39.0 / (28.0 * PI) * 22.0 * u * (1.0 - u).max(0.0).powi(7) * (1.0 + u * (7.0 + u * 16.0))
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let weights = [
        ("csrbf2", Weight::Csrbf2),
        ("wendland-c4", Weight::Kernel(&WendlandC4)),
        ("own", Weight::Kernel(&WendlandC6)),
    ];
    for (name, weight) in weights {
        let (basis, deflection) = (reproduced(weight)?, tip(weight)?);
        println!("{name:<12} x y off by {basis:.1e}, tip over the slender beam's {deflection:.4}");
        if basis > 1e-12 || !(0.98..1.02).contains(&deflection) {
            return Err(format!("{name}: {basis:e}, {deflection}").into());
        }
    }
    Ok(())
}

/// Nodes in rows, 21×3×3, and the planes between cells.
fn nodes() -> (Vec<Vec3>, [Vec<f64>; 3]) {
    let planes = |count: usize| (0..count).map(|i| i as f64).collect::<Vec<_>>();
    let (x, y) = (planes(21), planes(3));
    let row = |x: f64| (0..9).map(move |at| Vec3::new(x, f64::from(at / 3), f64::from(at % 3)));
    (x.iter().flat_map(|&x| row(x)).collect(), [x, y.clone(), y])
}

/// How far the quadratic basis is off at a place: the greatest error of `x y` and its gradient.
fn reproduced(weight: Weight) -> Result<f64, Box<dyn Error>> {
    let (nodes, _) = nodes();
    let squares = MovingLeastSquares::new(&nodes, Basis::Quadratic, Support::sphere(2.5), weight)?;
    let at = Vec3::new(7.3, 0.4, 1.7);
    let shape = squares.at(&at)?;
    let known = |node: &u32| nodes[*node as usize].x * nodes[*node as usize].y;
    let both = shape.nodes.iter().zip(&shape.values).zip(&shape.gradients);
    let mut off = [-at.x * at.y, -at.y, -at.x, 0.0];
    for ((node, value), slope) in both {
        let f = known(node);
        [*value, slope[0], slope[1], slope[2]].iter().zip(&mut off).for_each(|(part, off)| *off += part * f);
    }
    Ok(off.iter().fold(0.0, |most: f64, off| most.max(off.abs())))
}

/// Deflection of a beam of 20×2×2 under a small load through its volume, over q L⁴/(8 E I).
fn tip(weight: Weight) -> Result<f64, Box<dyn Error>> {
    let (nodes, planes) = nodes();
    let clamped: Vec<u32> = (0..9).collect();
    let mut body = Galerkin::new(Parts {
        cells: Hexahedra::between(&planes)?,
        rule: 3,
        cut: None,
        basis: Basis::Quadratic,
        support: Support::sphere(2.5),
        weight,
        material: Material {
            moduli: Moduli::isotropic(1.0, 0.0)?,
            formulation: Formulation::StVenant,
            plastic: None,
        },
        axes: Tensor::identity(),
        density: 1.0,
        mirrors: Vec::new(),
        conditions: Condition::fixed(&clamped).into_iter().collect(),
        essential: Essential::Collocation,
        loads: vec![Load::Body(Vec3::new(0.0, 0.0, -1e-9))],
        tangent: Tangent::Continuum,
        volumes: Volumes::Shared,
        threads: 1,
        nodes,
    })?;
    let motion = linear_response(&mut body, 0.0)?;
    body.update(&motion);
    // q = 4·10⁻⁹ by length, I = 4/3; shear adds 1.2 % at L/h = 10.
    let slender = 4e-9 * 20.0_f64.powi(4) / (8.0 * 4.0 / 3.0);
    Ok(-body.displacement(9 * 20 + 4).z / slender)
}
