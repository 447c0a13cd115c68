//! How particles turn with a motion: the spin that fits their neighbours, and directions that go along.

use nalgebra::{Matrix3, Rotation3};

use crate::Vec3;

/// Share of its trace added to the inertia of the neighbours, so that those on a line have one.
const RIDGE: f64 = 1e-9;

/// The spin \[1/T\] of each particle that fits the velocities of its neighbours best: `J ω = Σ r × (v_b − v_a)`,
/// `J = Σ (r² 1 − r rᵀ)`, r from the particle to a neighbour. A rigid motion has its own; about a line of particles it is zero.
///
/// A pair serves both of its particles.
pub fn fitted_spins(
    positions: &[Vec3],
    velocities: &[Vec3],
    pairs: impl Iterator<Item = (usize, usize)>,
) -> Vec<Vec3> {
    let mut sums = vec![(Matrix3::zeros(), Vec3::zeros()); positions.len()];
    for (a, b) in pairs {
        let r = positions[b] - positions[a];
        let inertia = Matrix3::identity() * r.norm_squared() - r * r.transpose();
        let moment = r.cross(&(velocities[b] - velocities[a]));
        for particle in [a, b] {
            sums[particle].0 += inertia;
            sums[particle].1 += moment;
        }
    }
    let spin = |(inertia, moment): (Matrix3<f64>, Vec3)| {
        let ridge = Matrix3::identity() * (RIDGE * inertia.trace());
        (inertia + ridge).try_inverse().map_or_else(Vec3::zeros, |inverse| inverse * moment)
    };
    sums.into_iter().map(spin).collect()
}

/// Turns up to three orthonormal directions among themselves, so that they lie nearest to others after these have turned by a
/// rotation vector: within the plane of two, either way of one, all the way of three.
pub fn follow_turn(directions: &mut [Vec3], before: &[Vec3], turn: &Vec3) {
    let turned = Rotation3::from_scaled_axis(*turn);
    match directions {
        [] => {}
        [e] => *e *= e.dot(&(turned * before[0])).signum(),
        [e, f] => {
            let [first, second] = [turned * before[0], turned * before[1]];
            // the plane rotation that leaves the greatest sum of products
            let (sine, cosine) = (f.dot(&first) - e.dot(&second), e.dot(&first) + f.dot(&second));
            let length = libm::hypot(sine, cosine);
            let (sine, cosine) = (sine / length, cosine / length);
            (*e, *f) = (*e * cosine + *f * sine, *f * cosine - *e * sine);
        }
        all => all.iter_mut().zip(before).for_each(|(e, before)| *e = turned * before),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rigid_motion_has_its_own_spin() {
        let positions = [[0.0, 0.0, 0.0], [1.0, 0.1, 0.0], [0.2, 0.9, 0.3], [-0.4, 0.5, 0.1]].map(Vec3::from);
        let spin = Vec3::new(0.3, -0.7, 0.2);
        let velocities = positions.map(|x| Vec3::new(1.0, 2.0, 3.0) + spin.cross(&x));
        let pairs = [(0, 1), (0, 2), (0, 3), (1, 2), (2, 3)];
        for found in fitted_spins(&positions, &velocities, pairs.into_iter()) {
            assert!((found - spin).norm() < 1e-7, "{found}");
        }
    }

    /// On a line nothing tells the spin about it.
    #[test]
    fn a_line_spins_across_itself_only() {
        let positions = [0.0, 1.0, 2.0].map(|x| Vec3::x() * x);
        let velocities = positions.map(|x| Vec3::new(0.5, 0.2, 0.0).cross(&x));
        let found = fitted_spins(&positions, &velocities, [(0, 1), (1, 2)].into_iter());
        assert!(found.iter().all(|spin| (spin - Vec3::y() * 0.2).norm() < 1e-7), "{found:?}");
    }

    #[test]
    fn directions_follow_a_turn_as_far_as_they_may() {
        let turn = Vec3::z() * 0.4;
        let (sine, cosine) = libm::sincos(0.4_f64);
        let goal = [Vec3::new(cosine, sine, 0.0), Vec3::new(-sine, cosine, 0.0), Vec3::z()];
        let before = [Vec3::x(), Vec3::y(), Vec3::z()];
        let mut three = before;
        follow_turn(&mut three, &before, &turn);
        let mut two = [Vec3::y(), -Vec3::x()];
        follow_turn(&mut two, &before[..2], &turn);
        for (found, goal) in three.iter().chain(&two).zip(goal.iter().chain(&goal[..2])) {
            assert!((found - goal).norm() < 1e-15, "{found}");
        }
        let mut one = [-Vec3::x()];
        follow_turn(&mut one, &before[..1], &turn);
        assert_eq!(one[0], Vec3::x());
    }
}
