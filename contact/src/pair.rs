//! Distance of two features that face each other, a point or an edge from a point, an edge or a face, with its derivatives.

use nalgebra::{Matrix2, Matrix3};
use sph_core::Vec3;

/// Least distance that is divided by, over the longest side at hand: closer than that features have no direction.
const TINY: f64 = 1e-12;

/// The nearest places of two features: `r = Σ w_a x_a`, w one on one side and less one on the other, at the minimum over the parameters.
///
/// With `T_k = Σ ∂_k w_a x_a`, `n = r/d` and `C_ka = ∂_k w_a r + w_a T_k`
///
/// ```text
/// ∂d/∂x_a = w_a n
/// H_ab    = w_a w_b 1 − Σ_kl C_ka (T·T)⁻¹_kl C_lbᵀ
/// ∂²ψ(d)  = (ψ′/d)(H_ab − w_a w_b n nᵀ) + ψ″ w_a w_b n nᵀ
/// ```
///
/// The weights sum to zero and r is along n, so forces of a potential ψ(d) have neither a sum nor a moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair {
    /// Weights w of the places \[–\]; those beyond the last are zero.
    pub weights: [f64; 4],
    /// Distance d \[L\].
    pub distance: f64,
    /// Direction n from the other side to the first.
    pub normal: Vec3,
    kind: Kind,
}

/// What faces what.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Points,
    Segment,
    Face,
    Edges,
}

impl Kind {
    /// Number of places, and of parameters.
    fn counts(self) -> [usize; 2] {
        match self {
            Self::Points => [2, 0],
            Self::Segment => [3, 1],
            Self::Face | Self::Edges => [4, 2],
        }
    }

    /// `∂_k w_a` of up to two parameters.
    fn slopes(self) -> [[f64; 4]; 2] {
        match self {
            Self::Points => [[0.0; 4]; 2],
            Self::Segment => [[0.0, 1.0, -1.0, 0.0], [0.0; 4]],
            Self::Face => [[0.0, 1.0, -1.0, 0.0], [0.0, 1.0, 0.0, -1.0]],
            Self::Edges => [[-1.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, -1.0]],
        }
    }
}

impl Pair {
    /// A point and another point.
    #[inline]
    pub fn points([p, q]: [Vec3; 2]) -> Self {
        Self::of([p, q], [1.0, -1.0, 0.0, 0.0], Kind::Points)
    }

    /// A point and the line through two others.
    #[inline]
    pub fn segment([p, a, b]: [Vec3; 3]) -> Self {
        let along = b - a;
        let part = along.dot(&(p - a)) / along.norm_squared();
        Self::of([p, a, b], [1.0, part - 1.0, -part, 0.0], Kind::Segment)
    }

    /// A point and the plane through three others.
    #[inline]
    pub fn face([p, a, b, c]: [Vec3; 4]) -> Self {
        let (e, f, r) = (b - a, c - a, p - a);
        let [ee, ef, ff] = [e.dot(&e), e.dot(&f), f.dot(&f)];
        let [re, rf] = [r.dot(&e), r.dot(&f)];
        let over = 1.0 / (ee * ff - ef * ef);
        let [u, v] = [(ff * re - ef * rf) * over, (ee * rf - ef * re) * over];
        Self::of([p, a, b, c], [1.0, u + v - 1.0, -u, -v], Kind::Face)
    }

    /// The lines through the first two points and through the last two, which are not parallel.
    #[inline]
    pub fn edges([a, b, c, d]: [Vec3; 4]) -> Self {
        let (e, f, r) = (b - a, d - c, a - c);
        let [ee, ef, ff] = [e.dot(&e), e.dot(&f), f.dot(&f)];
        let [re, rf] = [r.dot(&e), r.dot(&f)];
        let over = 1.0 / (ee * ff - ef * ef);
        let [u, v] = [(ef * rf - ff * re) * over, (ee * rf - ef * re) * over];
        Self::of([a, b, c, d], [1.0 - u, u, v - 1.0, -v], Kind::Edges)
    }

    #[inline]
    fn of<const N: usize>(places: [Vec3; N], weights: [f64; 4], kind: Kind) -> Self {
        let r = places.iter().zip(&weights).fold(Vec3::zeros(), |sum, (x, w)| sum + x * *w);
        let distance = r.norm();
        let size = (places[0] - places[N - 1]).norm();
        let normal = if distance > TINY * size { r / distance } else { Vec3::zeros() };
        Self { weights, distance, normal, kind }
    }

    /// `∂²ψ/∂x_a∂x_b` for a potential of the slope ψ′ \[F\] and the curvature ψ″ \[F/L\] in the distance, at the places that the pair was made of.
    pub fn second(&self, places: &[Vec3], slope: f64, curvature: f64) -> [[Matrix3<f64>; 4]; 4] {
        let (w, n) = (&self.weights, &self.normal);
        let along = self.along(places);
        let inverse = self.inverse(&along);
        let r = n * self.distance;
        let ([count, free], slopes) = (self.kind.counts(), self.kind.slopes());
        let change = |k: usize, a: usize| r * slopes[k][a] + along[k] * w[a];
        let bent = if self.distance > 0.0 { slope / self.distance } else { 0.0 };
        let normals = n * n.transpose();
        let mut out = [[Matrix3::zeros(); 4]; 4];
        for (a, row) in out.iter_mut().enumerate().take(count) {
            for (b, block) in row.iter_mut().enumerate().take(count) {
                let both = w[a] * w[b];
                let mut across = (Matrix3::identity() - normals) * both;
                for k in 0..free {
                    for l in 0..free {
                        across -= change(k, a) * change(l, b).transpose() * inverse[(k, l)];
                    }
                }
                *block = across * bent + normals * (curvature * both);
            }
        }
        out
    }

    /// How far the foot moves along a direction t with each place, at the places that the pair was made of: `Σ_kl (t·T_k)(T·T)⁻¹_kl C_la`
    /// \[–\]. What moves all of them rigidly does not move it.
    pub fn dragged(&self, places: &[Vec3], direction: &Vec3) -> [Vec3; 4] {
        let along = self.along(places);
        let inverse = self.inverse(&along);
        let r = self.normal * self.distance;
        let ([count, free], slopes) = (self.kind.counts(), self.kind.slopes());
        let mut out = [Vec3::zeros(); 4];
        for (a, out) in out.iter_mut().enumerate().take(count) {
            for k in 0..free {
                for l in 0..free {
                    let change = r * slopes[l][a] + along[l] * self.weights[a];
                    *out += change * (inverse[(k, l)] * along[k].dot(direction));
                }
            }
        }
        out
    }

    /// `T_k = Σ ∂_k w_a x_a`.
    fn along(&self, places: &[Vec3]) -> [Vec3; 2] {
        let mut along = [Vec3::zeros(); 2];
        for (along, slopes) in along.iter_mut().zip(&self.kind.slopes()) {
            *along = places.iter().zip(slopes).fold(Vec3::zeros(), |sum, (x, s)| sum + x * *s);
        }
        along
    }

    /// `(T·T)⁻¹`.
    fn inverse(&self, along: &[Vec3; 2]) -> Matrix2<f64> {
        let [t, s] = along;
        match self.kind.counts()[1] {
            2 => {
                let [tt, ts, ss] = [t.dot(t), t.dot(s), s.dot(s)];
                Matrix2::new(ss, -ts, -ts, tt) / (tt * ss - ts * ts)
            }
            1 => Matrix2::new(1.0 / t.dot(t), 0.0, 0.0, 0.0),
            _ => Matrix2::zeros(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    type Kind = fn(&[Vec3]) -> Pair;

    /// Pairs of each kind with feet inside their features, from numbers without a pattern.
    fn cases() -> Vec<(Kind, Vec<Vec3>)> {
        let kinds: [(Kind, usize); 4] = [
            (|x| Pair::points([x[0], x[1]]), 2),
            (|x| Pair::segment([x[0], x[1], x[2]]), 3),
            (|x| Pair::face([x[0], x[1], x[2], x[3]]), 4),
            (|x| Pair::edges([x[0], x[1], x[2], x[3]]), 4),
        ];
        let place = |seed: usize, a: usize| {
            let of = |k: usize| libm::sin(1.7 * seed as f64 + 2.9 * a as f64 + 4.3 * k as f64 + 0.4);
            Vec3::new(of(0), of(1), of(2))
        };
        let all = (0..60).flat_map(|seed| {
            kinds.map(|(kind, count)| (kind, (0..count).map(|a| place(seed, a)).collect::<Vec<_>>()))
        });
        all.filter(|(kind, x)| kind(x).distance > 0.1 && kind(x).weights.iter().all(|w| w.abs() < 4.0))
            .collect()
    }

    /// Central differences of 1e-5: 2e-9 measured at most for slopes, 4e-8 for their change where weights are large.
    #[test]
    fn gradient_and_second_derivative_of_every_kind_of_pair_are_those_of_the_distance() {
        let h = 1e-5;
        let cases = cases();
        assert!(cases.len() > 60);
        for (kind, places) in cases {
            let pair = kind(&places);
            let moved = |a: usize, k: usize, by: f64| {
                let mut moved = places.clone();
                moved[a][k] += by;
                kind(&moved)
            };
            // ψ = d³.
            let d = pair.distance;
            let second = pair.second(&places, 3.0 * d * d, 6.0 * d);
            for b in 0..places.len() {
                for k in 0..3 {
                    let [low, high] = [moved(b, k, -h), moved(b, k, h)];
                    let slope = (high.distance - low.distance) / (2.0 * h);
                    assert!((slope - pair.weights[b] * pair.normal[k]).abs() < 1e-8, "{slope}");
                    for (a, row) in second.iter().enumerate().take(places.len()) {
                        let force =
                            |pair: &Pair| pair.normal * (pair.weights[a] * 3.0 * pair.distance.powi(2));
                        let change = (force(&high) - force(&low)) / (2.0 * h);
                        let error = (change - row[b].column(k)).norm() / (1.0 + change.norm());
                        assert!(error < 1e-7, "{places:?} {a} {b} {k}: {error:.1e}");
                    }
                }
            }
        }
    }

    #[test]
    fn weights_have_no_sum_and_the_way_is_along_the_normal() {
        for (kind, places) in cases() {
            let pair = kind(&places);
            assert!(pair.weights.iter().sum::<f64>().abs() < 1e-14);
            let moment = places
                .iter()
                .zip(&pair.weights)
                .fold(Vec3::zeros(), |sum, (x, w)| sum + x.cross(&(pair.normal * *w)));
            assert!(moment.norm() < 1e-14, "{moment}");
        }
    }
}
