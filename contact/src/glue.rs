//! Points glued to surfaces: each stays where it stood over its surface, as that moves and turns.
//!
//! A point x stands at rest over some nodes of the surface at their weights w and a distance d off it ([`Foot`]). With
//!
//! ```text
//! r = x − Σ w_i x_i − d n,   n = m/|m|,  m = t₁ × t₂,  t_k = Σ a_ki x_i
//! U = ½ k |r|²
//! ```
//!
//! nothing changes where both sides move rigidly: forces have neither a sum nor a moment. For a fixed r, with `P = 1 − n nᵀ`, `q = P r/|m|` and
//! `M_i = b_i [t₁]× − a_i [t₂]×` the derivative of m by a node (a, b its numbers along t₁ and t₂), what acts is
//!
//! ```text
//! on the point −k r,   on a node  k (w_i r + d M_iᵀ q)
//! ∂²U/∂x_i∂x_j = k [A_iᵀ A_j − d (M_iᵀ S M_j − (a_i b_j − a_j b_i) [q]×)],    A_i = w_i 1 + d P M_i/|m|
//! S = −(n (P r)ᵀ + (P r) nᵀ + (n·r) P)/|m|²
//! ```
//!
//! `−k A_i` between point and node, `k 1` of the point itself: exact, so that Newton's method ends as it does without.
//!
//! A point may as well stand at given numbers c of places, among which directors of a shell count as places of unit length ([`Hold::Places`]):
//!
//! ```text
//! x = Σ w_i (x_i + ζ d_i) at rest,   r = x − Σ w_i (x_i + ζ d_i) = x − Σ c_i y_i,   U = ½ k |r|²
//! −k r on the point,  k w_i r on a node,  k ζ w_i r on a director: forces have no sum, for Σ w_i = 1, and with the couples d_i × k ζ w_i r no moment
//! ```
//!
//! There r is linear in places and directors, and turns where all of them turn rigidly.

use nalgebra::Matrix3;
use sph_core::Vec3;

use crate::foot::Foot;

/// A point glued to a surface, by numbers of places.
#[derive(Clone, Debug, PartialEq)]
pub struct Glued {
    /// The point.
    pub point: usize,
    /// Nodes of the surface about its foot, or places that hold it otherwise.
    pub nodes: Vec<usize>,
    /// How they hold it.
    pub hold: Hold,
    /// Force by distance, above zero \[F/L\].
    pub stiffness: f64,
}

/// How a point is held by nodes.
#[derive(Clone, Debug, PartialEq)]
pub enum Hold {
    /// Over the surface through them, as far off it as at rest.
    Surface(Foot),
    /// At these numbers of them, directors of a shell among them \[–, of directors L\].
    Places(Vec<f64>),
}

/// Points glued to surfaces.
#[derive(Clone, Debug)]
pub struct Glue {
    glued: Vec<Glued>,
    /// What rounding leaves of r at rest, which is taken out, so that nothing acts there \[L\].
    left: Vec<Vec3>,
    places: usize,
    /// Pairs of places that share a block, ascending, places with themselves among them.
    pairs: Vec<[usize; 2]>,
}

/// A point glued to a surface where its places are now.
struct State {
    r: Vec3,
    normal: Vec3,
    /// 1/|m|.
    over: f64,
    along: [Vec3; 2],
    /// P r/|m|.
    q: Vec3,
}

impl Glued {
    fn sum(&self, places: &[[f64; 3]], weights: &[f64]) -> Vec3 {
        self.nodes.iter().zip(weights).map(|(&i, w)| Vec3::from(places[i]) * *w).sum()
    }

    fn state(&self, foot: &Foot, places: &[[f64; 3]], left: &Vec3) -> State {
        let along = [self.sum(places, &foot.along[0]), self.sum(places, &foot.along[1])];
        let across = along[0].cross(&along[1]);
        let over = 1.0 / across.norm();
        let normal = across * over;
        let middle = self.sum(places, &foot.weights);
        let r = Vec3::from(places[self.point]) - middle - normal * foot.offset - left;
        State { q: (r - normal * normal.dot(&r)) * over, r, normal, over, along }
    }

    /// How far the point is from its place \[L\].
    fn gap(&self, places: &[[f64; 3]], left: &Vec3) -> Vec3 {
        match &self.hold {
            Hold::Surface(foot) => self.state(foot, places, left).r,
            Hold::Places(numbers) => Vec3::from(places[self.point]) - self.sum(places, numbers) - left,
        }
    }

    /// Hands the products of the numbers by which places take part in r to `put`, for every ordered pair: of a point that they hold linearly.
    fn linear(&self, numbers: &[f64], mut put: impl FnMut(usize, usize, f64)) {
        let parts = || {
            std::iter::once((self.point, 1.0))
                .chain(self.nodes.iter().copied().zip(numbers.iter().map(|c| -c)))
        };
        for (a, left) in parts() {
            parts().for_each(|(b, right)| put(a, b, left * right));
        }
    }

    /// Places with the numbers by which each takes part at most: the point 1, a node how far a unit of its motion moves the place over the
    /// surface at rest.
    fn parts(&self, rest: &[[f64; 3]]) -> Vec<(usize, f64)> {
        let part: Box<dyn Fn(usize) -> f64> = match &self.hold {
            Hold::Places(numbers) => Box::new(|i| numbers[i].abs()),
            Hold::Surface(Foot { weights, along, offset, stretch }) => {
                let [t, s] = [self.sum(rest, &along[0]), self.sum(rest, &along[1])];
                // The normal leans by the motion along it, in a direction in the surface.
                let leans =
                    move |i: usize| offset.abs() * (t * along[1][i] - s * along[0][i]).norm() / stretch;
                Box::new(move |i| weights[i].abs() + leans(i))
            }
        };
        let nodes = self.nodes.iter().enumerate().map(|(i, &place)| (place, part(i)));
        std::iter::once((self.point, 1.0)).chain(nodes).collect()
    }
}

impl Glue {
    /// Points glued to surfaces, all places being here at rest \[L\].
    pub fn new(glued: Vec<Glued>, rest: &[[f64; 3]]) -> Self {
        let places = rest.len();
        let mut pairs: Vec<[usize; 2]> = (0..places).map(|a| [a, a]).collect();
        for own in &glued {
            let all: Vec<usize> = std::iter::once(own.point).chain(own.nodes.iter().copied()).collect();
            for (i, &a) in all.iter().enumerate() {
                pairs.extend(all[..i].iter().map(|&b| [a.min(b), a.max(b)]));
            }
        }
        pairs.sort_unstable();
        pairs.dedup();
        let mut own = Self { glued, left: Vec::new(), places, pairs };
        own.settle(rest);
        own
    }

    /// Takes out what rounding leaves of r where places are at rest \[L\]: as whoever moves them says it, to the last bit.
    pub fn settle(&mut self, rest: &[[f64; 3]]) {
        self.left = self.glued.iter().map(|own| own.gap(rest, &Vec3::zeros())).collect();
    }

    /// The points.
    pub fn glued(&self) -> &[Glued] {
        &self.glued
    }

    /// Pairs of places that share a block of the stiffness, each once, and each place with itself.
    pub fn pairs(&self) -> &[[usize; 2]] {
        &self.pairs
    }

    /// Makes the stiffnesses others, each by its number \[F/L\].
    pub fn stiffen(&mut self, stiffness: impl Fn(usize, f64) -> f64) {
        self.glued.iter_mut().enumerate().for_each(|(i, own)| own.stiffness = stiffness(i, own.stiffness));
    }

    /// How far a point is from its place over the surface \[L\], by its number.
    pub fn gap(&self, number: usize, places: &[[f64; 3]]) -> Vec3 {
        self.glued[number].gap(places, &self.left[number])
    }

    /// Fills in the forces at places; returns the energy \[F L\].
    pub fn evaluate(&self, places: &[[f64; 3]], forces: &mut [[f64; 3]]) -> f64 {
        forces.fill([0.0; 3]);
        let mut energy = 0.0;
        for (own, left) in self.glued.iter().zip(&self.left) {
            let k = own.stiffness;
            let foot = match &own.hold {
                Hold::Surface(foot) => foot,
                Hold::Places(numbers) => {
                    let r = own.gap(places, left);
                    energy += 0.5 * k * r.norm_squared();
                    add(&mut forces[own.point], &(r * -k));
                    own.nodes
                        .iter()
                        .zip(numbers)
                        .for_each(|(&node, c)| add(&mut forces[node], &(r * (k * c))));
                    continue;
                }
            };
            let State { r, along: [t, s], q, .. } = own.state(foot, places, left);
            let Foot { weights, along, offset, .. } = foot;
            energy += 0.5 * k * r.norm_squared();
            add(&mut forces[own.point], &(r * -k));
            let (by_t, by_s) = (s.cross(&q), q.cross(&t));
            for (i, &node) in own.nodes.iter().enumerate() {
                let leans = by_t * along[0][i] + by_s * along[1][i];
                add(&mut forces[node], &((r * weights[i] + leans * *offset) * k));
            }
        }
        energy
    }

    /// Hands `∂²U/∂x_a∂x_b` at places to `put`, for every ordered pair of places of each glued point, with the forces that act at `strained`.
    fn second(
        &self,
        places: &[[f64; 3]],
        strained: &[[f64; 3]],
        mut put: impl FnMut(usize, usize, &Matrix3<f64>),
    ) {
        for (own, left) in self.glued.iter().zip(&self.left) {
            let k = own.stiffness;
            let foot = match &own.hold {
                Hold::Surface(foot) => foot,
                Hold::Places(numbers) => {
                    own.linear(numbers, |a, b, share| put(a, b, &(Matrix3::identity() * (k * share))));
                    continue;
                }
            };
            let State { normal: n, over, along: [t, s], .. } = own.state(foot, places, left);
            let r = own.gap(strained, left);
            let Foot { weights, along, offset: d, .. } = foot;
            let plane = Matrix3::identity() - n * n.transpose();
            let flat = plane * r;
            let q = flat * over;
            let bent = n * flat.transpose() + flat * n.transpose() + plane * n.dot(&r);
            let bent = bent * -(over * over);
            let count = own.nodes.len();
            let lean = |i: usize| t.cross_matrix() * along[1][i] - s.cross_matrix() * along[0][i];
            let leans: Vec<Matrix3<f64>> = (0..count).map(lean).collect();
            let carry = |i: usize| Matrix3::identity() * weights[i] + plane * leans[i] * (d * over);
            let carried: Vec<Matrix3<f64>> = (0..count).map(carry).collect();
            put(own.point, own.point, &(Matrix3::identity() * k));
            for (i, &a) in own.nodes.iter().enumerate() {
                let across = carried[i] * -k;
                put(own.point, a, &across);
                put(a, own.point, &across.transpose());
                for (j, &b) in own.nodes.iter().enumerate() {
                    let twist = along[0][i] * along[1][j] - along[0][j] * along[1][i];
                    let of_normal = leans[i].transpose() * bent * leans[j] - q.cross_matrix() * twist;
                    put(a, b, &((carried[i].transpose() * carried[j] - of_normal * *d) * k));
                }
            }
        }
    }

    /// Fills in the forces that resist a small motion at places, `∂²U/∂x² u`.
    pub fn resist(&self, places: &[[f64; 3]], motion: &[[f64; 3]], forces: &mut [[f64; 3]]) {
        forces.fill([0.0; 3]);
        self.second(places, places, |a, b, block| add(&mut forces[a], &(block * Vec3::from(motion[b]))));
    }

    /// Fills in the second derivatives of the energy at places, a block for each of [`Glue::pairs`] \[F/L\].
    pub fn stiffness(&self, places: &[[f64; 3]], blocks: &mut [[[f64; 3]; 3]]) {
        self.stressed(places, places, blocks);
    }

    /// The same with the forces that act at `strained`, a small motion away, and without the change of shape of that motion.
    pub fn stressed(&self, places: &[[f64; 3]], strained: &[[f64; 3]], blocks: &mut [[[f64; 3]; 3]]) {
        blocks.fill([[0.0; 3]; 3]);
        self.second(places, strained, |a, b, change| {
            let Ok(at) = self.pairs.binary_search(&[a, b]) else { return };
            for i in 0..3 {
                (0..3).for_each(|j| blocks[at][i][j] += change[(i, j)]);
            }
        });
    }

    /// A bound of the square of the highest frequency of places of these masses \[M\] that stand here at rest \[L\], by the sums over rows of
    /// `M^{-½} K M^{-½}`: a place takes part in the motion of a glued point by no more than a number c, `K ≤ k c cᵀ` \[1/T²\].
    pub fn fastest(&self, rest: &[[f64; 3]], masses: &[f64]) -> f64 {
        let mut sums = vec![0.0; self.places];
        for own in &self.glued {
            let parts = own.parts(rest);
            let of = |&(place, part): &(usize, f64)| part / masses[place].sqrt();
            let whole: f64 = parts.iter().map(of).sum();
            parts.iter().for_each(|part| sums[part.0] += own.stiffness * of(part) * whole);
        }
        sums.into_iter().fold(0.0, f64::max)
    }

    /// The mass that swings on the spring of each glued point at least, `1/Σ c²/m` \[M\].
    pub fn swinging(&self, rest: &[[f64; 3]], masses: &[f64]) -> Vec<f64> {
        let of = |own: &Glued| {
            1.0 / own.parts(rest).iter().map(|&(place, part)| part * part / masses[place]).sum::<f64>()
        };
        self.glued.iter().map(of).collect()
    }
}

fn add(to: &mut [f64; 3], v: &Vec3) {
    (0..3).for_each(|k| to[k] += v[k]);
}
