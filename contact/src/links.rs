//! Links: springs whose force is a curve of their elongation, cables and gaps among them, between places and to the ground.
//!
//! With the elongation e of [`Reach`] along the unit vector n from the near end to the far one, ℓ the distance of the ends where the line between
//! them turns with them:
//!
//! ```text
//! U = σ U_c(e)        f_near = σ f_c(e) n = −f_far        ∂²U = σ (s n nᵀ + f_c/ℓ (1 − n nᵀ))
//! ```
//!
//! σ is the share of a link in its curve, s its slope. Both ends feel the same force along the line between them: momentum is kept, and moment of
//! momentum where the line is that of the ends. Since `f_c ≤ s_max e ≤ s_max ℓ`, the steepest slope bounds both terms.

use nalgebra::Matrix3;
use sph_core::Vec3;

use crate::force_curve::{ForceCurve, OnCurve};
use crate::reach::{Far, Reach};

/// A link: its ends, and its share in a curve.
#[derive(Clone, Debug)]
pub struct Link {
    /// Ends and elongation.
    pub reach: Reach,
    /// Number of its curve.
    pub curve: usize,
    /// Factor on the curve \[–\].
    pub share: f64,
}

/// Links between places.
#[derive(Clone, Debug)]
pub struct Links {
    links: Vec<Link>,
    curves: Vec<ForceCurve>,
    /// Pairs of places that share a block, ascending.
    pairs: Vec<[usize; 2]>,
    /// Places at rest \[L\].
    rest: Vec<Vec3>,
}

impl Links {
    /// Links by these curves, between places that stand here at rest \[L\].
    pub fn new(links: Vec<Link>, curves: Vec<ForceCurve>, rest: Vec<Vec3>) -> Self {
        let mut pairs: Vec<[usize; 2]> = links.iter().filter_map(|link| pair(&link.reach)).collect();
        pairs.sort_unstable();
        pairs.dedup();
        Self { links, curves, pairs, rest }
    }

    /// Pairs of places that share a block of the stiffness, each once, and each place with itself.
    pub fn pairs(&self) -> Vec<[usize; 2]> {
        let own = (0..self.rest.len()).map(|a| [a, a]);
        own.chain(self.pairs.iter().copied()).collect()
    }

    /// What a link has at places: that of its curve, its line, and the factor of its turn.
    fn of(&self, link: &Link, places: &[[f64; 3]]) -> (OnCurve, Vec3, f64) {
        let (elongation, n, turning) = link.reach.drawn(places, &self.rest);
        let OnCurve { force, slope, energy } = self.curves[link.curve].at(elongation);
        let share = link.share;
        let on = OnCurve { force: force * share, slope: slope * share, energy: energy * share };
        (on, n, turning)
    }

    /// Fills in the forces at places; returns the energy \[F L\].
    pub fn evaluate(&self, places: &[[f64; 3]], forces: &mut [[f64; 3]]) -> f64 {
        forces.fill([0.0; 3]);
        let mut energy = 0.0;
        for link in &self.links {
            let (on, n, _) = self.of(link, places);
            energy += on.energy;
            link.reach.pull(&(n * on.force), forces);
        }
        energy
    }

    /// Fills in the forces that resist a motion of the places from where they stand, `∂²U u`.
    pub fn resist(&self, places: &[[f64; 3]], motion: &[[f64; 3]], forces: &mut [[f64; 3]]) {
        forces.fill([0.0; 3]);
        for link in &self.links {
            let block = self.block(link, places);
            let mut apart = -Vec3::from(motion[link.reach.near]);
            if let Far::Place(b) = link.reach.far {
                apart += Vec3::from(motion[b]);
            }
            link.reach.pull(&-(block * apart), forces);
        }
    }

    /// Fills in the second derivatives of the energy at places, a block for each of [`Links::pairs`] \[F/L\].
    pub fn stiffness(&self, places: &[[f64; 3]], blocks: &mut [[[f64; 3]; 3]]) {
        blocks.fill([[0.0; 3]; 3]);
        for link in &self.links {
            let own = self.block(link, places);
            let mut add = |block: usize, sign: f64| {
                for i in 0..3 {
                    (0..3).for_each(|j| blocks[block][i][j] += sign * own[(i, j)]);
                }
            };
            add(link.reach.near, 1.0);
            if let Far::Place(b) = link.reach.far {
                add(b, 1.0);
            }
            if let Some(at) = pair(&link.reach).and_then(|pair| self.pairs.binary_search(&pair).ok()) {
                add(self.rest.len() + at, -1.0);
            }
        }
    }

    fn block(&self, link: &Link, places: &[[f64; 3]]) -> Matrix3<f64> {
        let (on, n, turning) = self.of(link, places);
        let along = n * n.transpose();
        let across = if turning > 0.0 { Matrix3::identity() - along } else { Matrix3::zeros() };
        along * on.slope + across * (on.force * turning)
    }

    /// A bound of the square of the highest frequency of places of these masses \[M\] on the links, wherever they stand, by the sums over rows of
    /// `M^{-½} K M^{-½}` \[1/T²\].
    pub fn fastest(&self, masses: &[f64]) -> f64 {
        let mut sums = vec![0.0; masses.len()];
        for Link { reach, curve, share } in &self.links {
            reach.bound(self.curves[*curve].pace() * share, masses, &mut sums);
        }
        sums.into_iter().fold(0.0, f64::max)
    }
}

/// The places of both ends, ascending; none of a link to the ground.
fn pair(reach: &Reach) -> Option<[usize; 2]> {
    match reach.far {
        Far::Place(b) => Some([reach.near.min(b), reach.near.max(b)]),
        Far::Ground(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::force_curve::Bears;
    use crate::reach::Span;

    /// Three places with a cable, a table along a direction, and both to the ground.
    fn links() -> Links {
        let link = |near, far, span, curve| Link { reach: Reach { near, far, span }, curve, share: 0.5 };
        let curves = vec![
            ForceCurve::spring(7.0, Bears::Tension, 0.0),
            ForceCurve::through(&[[-1.0, -4.0], [0.0, 0.0], [0.2, 0.3], [1.0, 5.0]]).unwrap(),
        ];
        let n = Vec3::new(1.0, 2.0, -1.0).normalize();
        let links = vec![
            link(1, Far::Place(0), Span::Length(0.8), 0),
            link(0, Far::Place(2), Span::Along(n), 1),
            link(2, Far::Ground(Vec3::new(0.3, 2.0, 2.0)), Span::Length(2.1), 1),
            link(1, Far::Ground(Vec3::zeros()), Span::Along(-n), 1),
            link(2, Far::Place(1), Span::Length(9.0), 0),
        ];
        Links::new(links, curves, vec![Vec3::zeros(), Vec3::x(), Vec3::new(1.0, 1.0, 0.5)])
    }

    const PLACES: [[f64; 3]; 3] = [[0.1, -0.2, 0.3], [1.2, 0.1, -0.1], [0.9, 1.3, 0.2]];

    /// Steps of 1e-4 stay on one piece of each curve; central differences are then off by their square times third derivatives of some ten.
    #[test]
    fn forces_and_blocks_are_derivatives() {
        let links = links();
        let pairs = links.pairs();
        assert_eq!(pairs, [[0, 0], [1, 1], [2, 2], [0, 1], [0, 2], [1, 2]]);
        let mut forces = [[0.0; 3]; 3];
        let mut blocks = vec![[[0.0; 3]; 3]; pairs.len()];
        assert!(links.evaluate(&PLACES, &mut forces) > 0.0);
        links.stiffness(&PLACES, &mut blocks);
        for (a, k) in (0..9).map(|at| (at / 3, at % 3)) {
            let mut motion = [[0.0; 3]; 3];
            motion[a][k] = 1.0;
            let at = |h: f64| {
                let (mut places, mut forces) = (PLACES, [[0.0; 3]; 3]);
                places[a][k] += h;
                (links.evaluate(&places, &mut forces), forces)
            };
            let ((up, after), (down, before)) = (at(1e-4), at(-1e-4));
            assert!(((up - down) / 2e-4 + forces[a][k]).abs() < 2e-7);
            let mut resisted = [[0.0; 3]; 3];
            links.resist(&PLACES, &motion, &mut resisted);
            let mut by_blocks = [[0.0; 3]; 3];
            for (&[p, q], block) in pairs.iter().zip(&blocks) {
                for i in 0..3 {
                    for j in 0..3 {
                        by_blocks[p][i] += block[i][j] * motion[q][j];
                        by_blocks[q][j] += if p == q { 0.0 } else { block[i][j] * motion[p][i] };
                    }
                }
            }
            for (b, i) in (0..9).map(|at| (at / 3, at % 3)) {
                let slope = (after[b][i] - before[b][i]) / 2e-4;
                assert!((slope + resisted[b][i]).abs() < 2e-7, "{a} {k} {b} {i}: {slope} {}", resisted[b][i]);
                assert!((by_blocks[b][i] - resisted[b][i]).abs() < 1e-14);
            }
        }
    }

    /// What is slack exerts nothing at all, whatever stands beside it.
    #[test]
    fn a_slack_cable_changes_no_bit() {
        let all = links();
        let mut without = all.clone();
        without.links.pop();
        let (mut with, mut other) = ([[0.0; 3]; 3], [[0.0; 3]; 3]);
        assert_eq!(all.evaluate(&PLACES, &mut with), without.evaluate(&PLACES, &mut other));
        assert_eq!(with, other);
    }

    /// One link between masses 1 and 2 has `s (1/m_a + 1/m_b)`, 1.5 s along its line; the bound by rows is 1 + √½ of s.
    #[test]
    fn the_bound_lies_above_the_frequency_of_two_masses() {
        let reach = Reach { near: 0, far: Far::Place(1), span: Span::Length(1.0) };
        let curve = ForceCurve::spring(4.0, Bears::Both, 0.0);
        let links = Links::new(
            vec![Link { reach, curve: 0, share: 0.25 }],
            vec![curve],
            vec![Vec3::zeros(), Vec3::x()],
        );
        assert!((links.fastest(&[1.0, 2.0]) - 1.0 - 0.5_f64.sqrt()).abs() < 1e-15);
    }

    #[test]
    fn ends_on_one_place_pull_along_no_line() {
        let reach = Reach { near: 0, far: Far::Ground(Vec3::zeros()), span: Span::Length(0.0) };
        let curve = ForceCurve::spring(4.0, Bears::Both, 0.0);
        let links = Links::new(vec![Link { reach, curve: 0, share: 1.0 }], vec![curve], vec![Vec3::zeros()]);
        let mut forces = [[1.0; 3]];
        assert_eq!(links.evaluate(&[[0.0; 3]], &mut forces), 0.0);
        assert_eq!(forces, [[0.0; 3]]);
    }
}
