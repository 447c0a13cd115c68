//! Unknowns that turn with the shell: a rigid turn leaves the tangent in them as it is, and the way to a state leads there.

use crate::common::{curved, disordered_curved, energy_formulations, flat, free_shell, scattered_flat, tee};
use implicit_statics::Equilibrium;
use nalgebra::Rotation3;
use sph_core::Vec3;
use sph_shell::{Shell, StaticShell};

const STEP: f64 = 1e-5;

/// The free shells that turn, one of them with a junction.
fn shells() -> Vec<(String, Shell)> {
    let clouds = [
        ("flat", flat([5, 4], [1.0, 1.0])),
        ("curved", curved([5, 4])),
        ("disordered", disordered_curved([5, 4])),
        ("scattered", scattered_flat(0.25, [1.0, 1.0])),
    ];
    let mut out = vec![("tee".to_string(), free_shell(tee(3, 0.4, 2), energy_formulations()[0].1, 0.05))];
    for (cloud_name, cloud) in clouds {
        for (name, formulation) in energy_formulations() {
            out.push((format!("{cloud_name}, {name}"), free_shell(cloud.clone(), formulation, 0.05)));
        }
    }
    out
}

/// A rigid turn as a motion of the unknowns, per radian: central, without the second order of the turn.
fn turn(system: &StaticShell, spin: Vec3) -> Vec<f64> {
    let angle = 1e-4;
    let [forth, back] = [angle, -angle].map(|angle| {
        let rotation = Rotation3::from_scaled_axis(spin * angle);
        let turned: Vec<f64> = (system.save().chunks_exact(3))
            .flat_map(|v| <[f64; 3]>::from(rotation * Vec3::from_column_slice(v)))
            .collect();
        let mut motion = vec![0.0; system.unknowns()];
        assert!(system.motion_to(&turned, &mut motion));
        motion
    });
    forth.iter().zip(&back).map(|(forth, back)| (forth - back) / (2.0 * angle)).collect()
}

/// Relative change of the tangent along a motion, in unknowns that turn or in fixed ones.
fn change(system: &mut StaticShell, motion: &[f64], turning: bool) -> f64 {
    let count = system.pattern().len();
    let mut ends = [vec![0.0; count], vec![0.0; count]];
    for (sign, values) in [1.0, -1.0].into_iter().zip(&mut ends) {
        let motion: Vec<f64> = motion.iter().map(|q| sign * STEP * q).collect();
        if turning {
            system.turned_tangent([0.0; 2], &motion, values);
        } else {
            let rest = system.save();
            system.update(&motion);
            system.tangent(0.0, values);
            system.restore(&rest);
        }
    }
    let norm = |values: &mut dyn Iterator<Item = f64>| values.map(|v| v * v).sum::<f64>().sqrt();
    let off = norm(&mut ends[0].iter().zip(&ends[1]).map(|(p, m)| (p - m) / (2.0 * STEP)));
    off / norm(&mut ends[0].iter().copied())
}

/// What is left is the second order of the step and rounding over it; in fixed unknowns the change is of order one.
#[test]
fn a_rigid_turn_leaves_the_tangent_as_it_is() {
    let spin = Vec3::new(0.5, -0.3, 0.8);
    for (name, shell) in shells() {
        let mut system = StaticShell::new(shell);
        let motion = turn(&system, spin);
        let (turning, fixed) = (change(&mut system, &motion, true), change(&mut system, &motion, false));
        println!("{name}: {turning:.1e}, fixed {fixed:.1e}");
        assert!(turning < 5e-9 && fixed > 0.1, "{name}: {turning:.1e} {fixed:.1e}");
    }
}

#[test]
fn the_way_to_a_turned_state_leads_there() {
    let rotation = Rotation3::from_scaled_axis(Vec3::new(0.4, -0.7, 0.2));
    for (name, shell) in shells() {
        let mut system = StaticShell::new(shell);
        let turned: Vec<f64> = (system.save().chunks_exact(3))
            .flat_map(|v| <[f64; 3]>::from(rotation * Vec3::from_column_slice(v)))
            .collect();
        let mut motion = vec![0.0; system.unknowns()];
        assert!(system.motion_to(&turned, &mut motion));
        system.update(&motion);
        let off = system.save().iter().zip(&turned).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off < 1e-14, "{name}: {off:.1e}");
    }
}
