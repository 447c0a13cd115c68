//! What the literal strong form violates, and by how much: known failures, asserted as they are.

use crate::common::{self, curved, flat, free_shell, shake};
use explicit_dynamics::{Clock, Dynamics, LinearisedDynamics};
use nalgebra::{DMatrix, Rotation3};
use sph_core::{CubicSpline, Vec3};
use sph_shell::{Divergence, Formulation, Reference, Shell};

const LITERAL: Formulation = Formulation::StrongForm {
    smoothing: 1.2,
    viscosity: 0.0,
    divergence: Divergence::Sum,
    kernel: &CubicSpline,
};

fn forces(shell: &mut Shell) -> Vec<[f64; 6]> {
    shell.evaluate_internal(false);
    (0..shell.len()).map(|a| shell.internal_force(a)).collect()
}

fn greatest(forces: &[[f64; 6]]) -> f64 {
    forces.iter().flatten().fold(0.0, |m: f64, f| m.max(f.abs()))
}

#[test]
fn it_does_not_conserve_momentum() {
    let mut body = free_shell(curved([7, 6]), LITERAL, 0.2);
    shake(&mut body, 0.1, 3);
    let f = forces(&mut body);
    let net: Vec3 = f.iter().map(|f| Vec3::new(f[0], f[1], f[2])).sum();
    let share = net.norm() / greatest(&f);
    println!("net force {share:.2} of the greatest");
    assert!(share > 0.05, "{share}");
}

#[test]
fn its_stiffness_is_not_symmetric() {
    let mut body = free_shell(flat([7, 7], [1.0, 1.0]), LITERAL, 0.1);
    let n = body.unknowns();
    let (mut matrix, mut unit, mut column) = (DMatrix::zeros(n, n), vec![0.0; n], vec![0.0; n]);
    for j in 0..n {
        unit[j] = 1.0;
        body.apply(&unit, &mut column);
        unit[j] = 0.0;
        for i in 0..n {
            matrix[(i, j)] = column[i];
        }
    }
    let skew = (&matrix - matrix.transpose()).amax() / matrix.amax();
    println!("asymmetry {skew:.3} of the largest entry");
    // 4.8 %, masses divided out (they hide part of it: edge particles are light). An adjoint leaves 1e-9.
    assert!(skew > 0.02, "{skew}");
}

#[test]
fn it_fails_the_membrane_patch() {
    let cloud = flat([8, 7], [1.7, 1.5]);
    let mut body = free_shell(cloud.clone(), LITERAL, 0.2);
    let strain = 1e-6;
    for (a, x) in cloud.positions.iter().enumerate() {
        body.set_state(a, x + Vec3::new(strain * x.x, 0.0, 0.0), Vec3::z());
    }
    let n = common::YOUNG * 0.2 / (1.0 - common::POISSON * common::POISSON) * strain;
    let worst = forces(&mut body)
        .iter()
        .zip(&cloud.edge_normals)
        .fold(0.0_f64, |worst, (f, normal)| worst.max((f[0] - n * normal.x).abs()));
    let residual = worst / (n * cloud.spacing());
    println!("membrane patch residual {residual:.2}");
    assert!(residual > 0.05, "{residual}");
}

#[test]
fn it_gains_or_loses_energy_in_free_vibration() {
    let mut body = free_shell(flat([9, 4], [2.0, 1.0]), LITERAL, 0.2);
    for a in 0..body.len() {
        let x = body.position(a);
        body.set_rate(a, Vec3::new(0.0, 0.0, 0.1 * libm::sin(3.0 * x.x)), Vec3::zeros());
    }
    let mut clock = Clock::start(&mut body, 1.0, 0.1, 0.0).unwrap();
    let start = {
        clock.step(&mut body, f64::INFINITY, |_| 1.0).unwrap();
        clock.kinetic
    };
    for _ in 0..4000 {
        clock.step(&mut body, f64::INFINITY, |_| 1.0).unwrap();
    }
    let drift = (clock.kinetic + body.evaluate(clock.now)) / start - 1.0;
    println!("energy drift {drift:.2e} at a tenth of the stable step");
    // The energy-based formulations stay below 1e-3 at four tenths of it.
    assert!(drift.abs() > 1e-2, "{drift}");
}

#[test]
fn rigid_motion_is_still_free() {
    let cloud = curved([7, 6]);
    let mut body = free_shell(cloud.clone(), LITERAL, 0.2);
    shake(&mut body, 0.1, 9);
    let scale = greatest(&forces(&mut body));
    let rotation = Rotation3::from_scaled_axis(Vec3::new(1.0, -0.7, 2.1));
    for (a, (x, frame)) in cloud.positions.iter().zip(&cloud.frames).enumerate() {
        body.set_state(a, rotation * x, rotation * frame.n);
    }
    assert!(greatest(&forces(&mut body)) < 1e-10 * scale);
}

#[test]
fn the_viscosity_opposes_approach_only() {
    let literal = Formulation::StrongForm {
        smoothing: 1.2,
        viscosity: 2.0,
        divergence: Divergence::Sum,
        kernel: &CubicSpline,
    };
    let push = |speed: f64| {
        let mut body = free_shell(flat([7, 7], [1.0, 1.0]), literal, 0.1);
        // Everything moves towards (or from) the middle.
        for a in 0..body.len() {
            let x = body.position(a);
            body.set_rate(a, Vec3::new(0.5 - x.x, 0.5 - x.y, 0.0) * speed, Vec3::zeros());
        }
        let f = forces(&mut body);
        // Power of the internal forces' resistance: positive when they oppose the motion.
        (0..body.len()).map(|a| Vec3::new(f[a][0], f[a][1], f[a][2]).dot(&body.velocity(a))).sum::<f64>()
    };
    assert!(push(0.1) > 0.0, "approach is resisted");
    assert_eq!(push(-0.1), 0.0, "parting is free");
}

/// Eq. 3 of \[lin2013\], `ρ̇_a = −ρ_a Σ_b (v_b − v_a)·∇Φ_ab` \[M/(L³T)\]. In the total Lagrangian form the density of eq. 4 is that
/// of the reference, so no march needs it.
fn density_rate(reference: &Reference, density: f64, velocities: &[Vec3], particle: usize) -> f64 {
    let frame = &reference.operator.points[particle].frame;
    let stencil = reference.operator.stencil(particle);
    let divergence = stencil.particles.iter().enumerate().map(|(k, &b)| {
        let gradient = frame.t1 * stencil.g1[k] + frame.t2 * stencil.g2[k];
        (velocities[b as usize] - velocities[particle]).dot(&gradient)
    });
    -density * divergence.sum::<f64>()
}

#[test]
fn density_follows_the_divergence() {
    let body = free_shell(flat([7, 7], [1.0, 1.0]), LITERAL, 0.1);
    // v = (0.3 x + y, −0.1 y): divergence 0.2 everywhere, exact for a linear field (eq. 3).
    let velocities: Vec<Vec3> = (0..body.len())
        .map(|a| body.position(a))
        .map(|x| Vec3::new(0.3 * x.x + x.y, -0.1 * x.y, 0.0))
        .collect();
    for a in 0..body.len() {
        assert!((density_rate(body.reference(), 2.0, &velocities, a) + 0.4).abs() < 1e-12);
    }
}
