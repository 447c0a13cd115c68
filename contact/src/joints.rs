//! Springs between places of two surfaces or solids: along a direction fixed in space, of no length at rest.
//!
//! A spring of stiffness k along the unit vector n has `½ k (n·(u_b − u_a))²`, u the displacements of its ends since rest. Both ends feel
//! the same force along n, with opposite signs: momentum is kept to rounding; moment of momentum is kept where the line between the ends
//! stays along n.

use sph_core::Vec3;

/// A spring between two places, by their numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// The places, not the same.
    pub ends: [usize; 2],
    /// Force by displacement \[F/L\], above zero.
    pub stiffness: f64,
    /// Unit vector.
    pub direction: Vec3,
}

/// Springs between places.
#[derive(Clone, Debug)]
pub struct Joints {
    springs: Vec<Joint>,
    /// Pairs of places that share a block, ascending.
    pairs: Vec<[usize; 2]>,
    /// Places at rest \[L\].
    rest: Vec<Vec3>,
}

impl Joints {
    /// Springs between places that stand here at rest \[L\].
    pub fn new(springs: Vec<Joint>, rest: Vec<Vec3>) -> Self {
        let mut pairs: Vec<[usize; 2]> = springs.iter().map(|spring| ordered(spring.ends)).collect();
        pairs.sort_unstable();
        pairs.dedup();
        Self { springs, pairs, rest }
    }

    /// Pairs of places that share a block of the stiffness, each once, and each place with itself.
    pub fn pairs(&self) -> Vec<[usize; 2]> {
        let own = (0..self.rest.len()).map(|a| [a, a]);
        own.chain(self.pairs.iter().copied()).collect()
    }

    /// Fills in the forces at places; returns the energy \[F L\].
    pub fn evaluate(&self, places: &[[f64; 3]], forces: &mut [[f64; 3]]) -> f64 {
        let moved = |a: usize| Vec3::from(places[a]) - self.rest[a];
        forces.fill([0.0; 3]);
        let mut energy = 0.0;
        for Joint { ends: [a, b], stiffness, direction } in &self.springs {
            let longer = direction.dot(&(moved(*b) - moved(*a)));
            energy += 0.5 * stiffness * longer * longer;
            let pull = direction * (stiffness * longer);
            for k in 0..3 {
                forces[*a][k] += pull[k];
                forces[*b][k] -= pull[k];
            }
        }
        energy
    }

    /// Fills in the forces that resist a motion of the places.
    pub fn resist(&self, motion: &[[f64; 3]], forces: &mut [[f64; 3]]) {
        forces.fill([0.0; 3]);
        for Joint { ends: [a, b], stiffness, direction } in &self.springs {
            let longer = direction.dot(&(Vec3::from(motion[*b]) - Vec3::from(motion[*a])));
            let pull = direction * (stiffness * longer);
            for k in 0..3 {
                forces[*a][k] -= pull[k];
                forces[*b][k] += pull[k];
            }
        }
    }

    /// Fills in the second derivatives of the energy, a block for each of [`Joints::pairs`] \[F/L\].
    pub fn stiffness(&self, blocks: &mut [[[f64; 3]; 3]]) {
        blocks.fill([[0.0; 3]; 3]);
        for Joint { ends, stiffness, direction } in &self.springs {
            let own = direction * direction.transpose() * *stiffness;
            let mut add = |block: usize, sign: f64| {
                for i in 0..3 {
                    (0..3).for_each(|j| blocks[block][i][j] += sign * own[(i, j)]);
                }
            };
            ends.iter().for_each(|&end| add(end, 1.0));
            if let Ok(at) = self.pairs.binary_search(&ordered(*ends)) {
                add(self.rest.len() + at, -1.0);
            }
        }
    }

    /// A bound of the square of the highest frequency of places of these masses \[M\] on the springs, by the sums over rows of
    /// `M^{-½} K M^{-½}` \[1/T²\].
    pub fn fastest(&self, masses: &[f64]) -> f64 {
        let mut sums = vec![0.0; masses.len()];
        for Joint { ends: [a, b], stiffness, .. } in &self.springs {
            let across = stiffness / (masses[*a] * masses[*b]).sqrt();
            sums[*a] += stiffness / masses[*a] + across;
            sums[*b] += stiffness / masses[*b] + across;
        }
        sums.into_iter().fold(0.0, f64::max)
    }
}

fn ordered([a, b]: [usize; 2]) -> [usize; 2] {
    [a.min(b), a.max(b)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Three places, the first two joined twice.
    fn joints() -> Joints {
        let spring =
            |ends, stiffness, direction: Vec3| Joint { ends, stiffness, direction: direction.normalize() };
        let springs = vec![
            spring([1, 0], 2.0, Vec3::new(1.0, 2.0, -1.0)),
            spring([0, 1], 0.5, Vec3::new(0.0, 1.0, 1.0)),
            spring([1, 2], 3.0, Vec3::z()),
        ];
        Joints::new(springs, vec![Vec3::zeros(), Vec3::x(), Vec3::new(1.0, 1.0, 0.5)])
    }

    const PLACES: [[f64; 3]; 3] = [[0.1, -0.2, 0.3], [1.2, 0.1, -0.1], [0.9, 1.3, 0.2]];

    /// Central differences of a quadratic energy are exact but for rounding, 1e-16 of it over the step.
    #[test]
    fn forces_are_the_derivative_of_the_energy_and_keep_momentum() {
        let joints = joints();
        let (mut forces, mut other) = ([[0.0; 3]; 3], [[0.0; 3]; 3]);
        joints.evaluate(&PLACES, &mut forces);
        for a in 0..3 {
            for k in 0..3 {
                let at = |h: f64| {
                    let mut places = PLACES;
                    places[a][k] += h;
                    joints.evaluate(&places, &mut [[0.0; 3]; 3])
                };
                let slope = (at(1e-3) - at(-1e-3)) / 2e-3;
                assert!((slope + forces[a][k]).abs() < 1e-12, "{a} {k}: {slope} {}", forces[a][k]);
            }
        }
        for k in 0..3 {
            assert!(forces.iter().map(|force| force[k]).sum::<f64>().abs() < 1e-15);
        }
        // What resists a motion is the change of the forces over it: they are linear.
        let motion = [[0.3, 0.1, -0.2], [0.0, 0.2, 0.5], [-0.4, 0.1, 0.1]];
        let there: [[f64; 3]; 3] =
            std::array::from_fn(|a| std::array::from_fn(|k| PLACES[a][k] + motion[a][k]));
        joints.evaluate(&there, &mut other);
        let mut resisting = [[0.0; 3]; 3];
        joints.resist(&motion, &mut resisting);
        for a in 0..3 {
            (0..3).for_each(|k| assert!((forces[a][k] - other[a][k] - resisting[a][k]).abs() < 1e-14));
        }
    }

    #[test]
    fn blocks_resist_as_the_springs_do() {
        let joints = joints();
        let pairs = joints.pairs();
        assert_eq!(pairs, [[0, 0], [1, 1], [2, 2], [0, 1], [1, 2]]);
        let mut blocks = vec![[[0.0; 3]; 3]; pairs.len()];
        joints.stiffness(&mut blocks);
        let motion = PLACES;
        let (mut expected, mut found) = ([[0.0; 3]; 3], [[0.0; 3]; 3]);
        joints.resist(&motion, &mut expected);
        for (&[a, b], block) in pairs.iter().zip(&blocks) {
            for i in 0..3 {
                for j in 0..3 {
                    found[a][i] += block[i][j] * motion[b][j];
                    if a != b {
                        found[b][j] += block[i][j] * motion[a][i];
                    }
                }
            }
        }
        for a in 0..3 {
            (0..3).for_each(|k| assert!((expected[a][k] - found[a][k]).abs() < 1e-14));
        }
    }

    /// One spring alone has `k (1/m_a + 1/m_b)`, 1.5 of masses 1 and 2; the bound is that of rows, 1 + √½.
    #[test]
    fn the_bound_lies_above_the_frequency_of_two_masses() {
        let spring = Joint { ends: [0, 1], stiffness: 1.0, direction: Vec3::x() };
        let joints = Joints::new(vec![spring], vec![Vec3::zeros(); 2]);
        let bound = joints.fastest(&[1.0, 2.0]);
        assert!((bound - 1.0 - 0.5_f64.sqrt()).abs() < 1e-15 && bound >= 1.5);
        assert!((joints.fastest(&[2.0, 2.0]) - 1.0).abs() < 1e-15);
    }
}
