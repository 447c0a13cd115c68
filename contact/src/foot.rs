//! Where over a surface a point stands at rest: weights of nodes, two directions along the surface, and how far off it the point is.

use nalgebra::{Matrix3, Matrix6, Vector6};
use sph_core::Vec3;

/// Area over that of its sides below which a face has no normal \[–\].
const FLAT: f64 = 1e-12;
/// Square of the distance, over that of the farthest node, below which a fit goes through a node.
const AT_NODE: f64 = 1e-4;
/// Weight of the curvature beside that of nodes: it is none where they do not show it.
const UNSEEN: f64 = 1e-6;
/// Iterations of the projection on a quadrilateral, that of Gauss and Newton.
const ITERATIONS: usize = 30;
/// Change of a coordinate of a quadrilateral at which they end \[–\].
const SETTLED: f64 = 1e-14;
/// Weight of a corner that is rounding \[–\].
const NO_WEIGHT: f64 = 1e-13;
/// Distance from the point, over that from its face and an edge of it, at which weights and a height by directors are found \[–\].
const REACHED: f64 = 1e-10;

/// A point over some nodes at rest, `x = Σ w_i x_i + d n` with `n = t₁ × t₂/|t₁ × t₂|` and `t_k = Σ a_ki x_i`.
#[derive(Clone, Debug, PartialEq)]
pub struct Foot {
    /// Weights w of the nodes, which sum to one \[–\].
    pub weights: Vec<f64>,
    /// Weights a of the nodes in both directions along the surface, which sum to zero.
    pub along: [Vec<f64>; 2],
    /// Signed distance d off the surface, along its normal \[L\].
    pub offset: f64,
    /// Length of `t₁ × t₂`.
    pub(crate) stretch: f64,
}

/// The place of a face that is nearest to a point, its rim included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// The place \[L\].
    pub place: Vec3,
    /// Unit normal of the face there.
    pub normal: Vec3,
    /// Distance of the point \[L\].
    pub distance: f64,
    at: [f64; 2],
}

impl Nearest {
    /// That of a face of three corners or four, whose surface is bilinear; none on a face without an area.
    pub fn on(point: &Vec3, corners: &[Vec3]) -> Option<Self> {
        let (at, distance) = match corners.len() {
            3 => in_triangle(point, corners),
            4 => in_quadrilateral(point, corners),
            _ => return None,
        };
        let (weights, along) = shape(corners.len(), at);
        let sum = |weights: &[f64; 4]| -> Vec3 { corners.iter().zip(weights).map(|(x, w)| x * *w).sum() };
        let across = sum(&along[0]).cross(&sum(&along[1]));
        let size = corners.iter().map(|x| (x - corners[0]).norm_squared()).fold(0.0, f64::max);
        let normal = across.try_normalize(FLAT * size)?;
        Some(Self { place: sum(&weights), normal, distance, at })
    }

    /// Weights w of the corners of the face and the height ζ at which the point stands at `Σ w_i (x_i + ζ d_i)`, d directors at the corners: by
    /// Newton's method from the nearest place, on and beyond the rim too. None where it does not settle.
    pub fn by_directors(
        &self,
        point: &Vec3,
        corners: &[Vec3],
        directors: &[Vec3],
    ) -> Option<(Vec<f64>, f64)> {
        let count = corners.len();
        let sum = |weights: &[f64; 4], of: &dyn Fn(usize) -> Vec3| -> Vec3 {
            (0..count).map(|i| of(i) * weights[i]).sum()
        };
        let director = |i: usize| directors[i];
        let (mut at, mut height) = (self.at, 0.0);
        for _ in 0..ITERATIONS {
            let (weights, along) = shape(count, at);
            let raised = |i: usize| corners[i] + directors[i] * height;
            let left = point - sum(&weights, &raised);
            let columns = [sum(&along[0], &raised), sum(&along[1], &raised), sum(&weights, &director)];
            let step = Matrix3::from_columns(&columns).lu().solve(&left)?;
            at = [at[0] + step.x, at[1] + step.y];
            height += step.z;
            let size = corners.iter().map(|x| (x - corners[0]).norm()).fold(0.0, f64::max);
            if step.x.abs().max(step.y.abs()).max(step.z.abs() / size) <= SETTLED {
                break;
            }
        }
        let (weights, _) = shape(count, at);
        let mut weights: Vec<f64> =
            weights[..count].iter().map(|w| if w.abs() < NO_WEIGHT { 0.0 } else { *w }).collect();
        let whole: f64 = weights.iter().sum();
        weights.iter_mut().for_each(|weight| *weight /= whole);
        let left =
            (0..count).map(|i| (corners[i] + directors[i] * height) * weights[i]).sum::<Vec3>() - point;
        (left.norm() <= REACHED * (self.distance + (corners[1] - corners[0]).norm()))
            .then_some((weights, height))
    }

    /// The foot of the point on the corners of the face alone.
    pub fn on_corners(&self, point: &Vec3, corners: &[Vec3]) -> Option<Foot> {
        let (weights, along) = shape(corners.len(), self.at);
        let own = |weights: [f64; 4]| weights[..corners.len()].to_vec();
        Foot::exact(point, corners, own(weights), along.map(own))
    }
}

impl Foot {
    /// The foot of a point on a surface through nodes, near a place of it with this normal: place and normal are those of a quadratic
    /// least-squares fit in the plane of the normal, which counts near nodes most. So neither lags behind a surface that bends, at a rim
    /// neither. None on nodes in one line.
    pub fn fitted(point: &Vec3, nodes: &[Vec3], place: &Vec3, normal: &Vec3) -> Option<Self> {
        let first = normal.cross(&Vec3::ith(normal.iamin(), 1.0)).normalize();
        let second = normal.cross(&first);
        let radius = nodes.iter().map(|x| (x - place).norm()).fold(0.0, f64::max);
        let terms = |x: &Vec3| {
            let r = (x - place) / radius;
            let [u, v] = [r.dot(&first), r.dot(&second)];
            let near = u * u + v * v + AT_NODE;
            (Vector6::new(1.0, u, v, u * u, u * v, v * v), 1.0 / (near * near))
        };
        // Curvature that nodes do not show is none; a linear field is fitted without error.
        let mut sums = Matrix6::from_diagonal(&(Vector6::new(0.0, 0.0, 0.0, 4.0, 2.0, 4.0) * UNSEEN));
        let all: Vec<(Vector6<f64>, f64)> = nodes.iter().map(terms).collect();
        all.iter().for_each(|(own, near)| sums += own * own.transpose() * *near);
        let inverse = sums.cholesky()?;
        let of = |row: usize| -> Vec<f64> {
            let weights = inverse.solve(&Vector6::ith(row, 1.0));
            all.iter().map(|(own, near)| weights.dot(own) * near).collect()
        };
        Self::exact(point, nodes, of(0), [of(1), of(2)])
    }

    /// The foot with weights moved by what they leave of the way to the point along the surface, and with exact sums.
    fn exact(point: &Vec3, nodes: &[Vec3], mut weights: Vec<f64>, mut along: [Vec<f64>; 2]) -> Option<Self> {
        let whole: f64 = weights.iter().sum();
        weights.iter_mut().for_each(|weight| *weight /= whole);
        for own in &mut along {
            let left = own.iter().sum::<f64>() / own.len() as f64;
            own.iter_mut().for_each(|weight| *weight -= left);
        }
        let sum = |weights: &[f64]| -> Vec3 { nodes.iter().zip(weights).map(|(x, w)| x * *w).sum() };
        let [t, s] = [sum(&along[0]), sum(&along[1])];
        let across = t.cross(&s);
        let stretch = across.norm();
        if stretch <= FLAT * t.norm() * s.norm() {
            return None;
        }
        let normal = across / stretch;
        let left = point - sum(&weights);
        // What is left lies along t, s and n.
        let [part, other] = [left.cross(&s).dot(&normal) / stretch, t.cross(&left).dot(&normal) / stretch];
        for (weight, (a, b)) in weights.iter_mut().zip(along[0].iter().zip(&along[1])) {
            *weight += part * a + other * b;
        }
        Some(Self { weights, along, offset: left.dot(&normal), stretch })
    }
}

/// Weights of corners at a place of a face, and their changes with its two coordinates.
pub(crate) fn shape(corners: usize, [u, v]: [f64; 2]) -> ([f64; 4], [[f64; 4]; 2]) {
    if corners == 3 {
        return ([1.0 - u - v, u, v, 0.0], [[-1.0, 1.0, 0.0, 0.0], [-1.0, 0.0, 1.0, 0.0]]);
    }
    let weights = [(1.0 - u) * (1.0 - v), u * (1.0 - v), u * v, (1.0 - u) * v];
    (weights, [[v - 1.0, 1.0 - v, v, -v], [u - 1.0, -u, u, 1.0 - u]])
}

/// The place of a triangle nearest to a point, and its distance.
fn in_triangle(point: &Vec3, corners: &[Vec3]) -> ([f64; 2], f64) {
    let (e, f, r) = (corners[1] - corners[0], corners[2] - corners[0], point - corners[0]);
    let [ee, ef, ff] = [e.dot(&e), e.dot(&f), f.dot(&f)];
    let over = 1.0 / (ee * ff - ef * ef);
    let inside = [(ff * r.dot(&e) - ef * r.dot(&f)) * over, (ee * r.dot(&f) - ef * r.dot(&e)) * over];
    let away = |[u, v]: [f64; 2]| (r - e * u - f * v).norm();
    if inside[0] >= 0.0 && inside[1] >= 0.0 && inside[0] + inside[1] <= 1.0 {
        return (inside, away(inside));
    }
    let part = |from: Vec3, way: Vec3| ((r - from).dot(&way) / way.norm_squared()).clamp(0.0, 1.0);
    let [a, b, c] = [part(Vec3::zeros(), e), part(e, f - e), part(Vec3::zeros(), f)];
    let sides = [[a, 0.0], [1.0 - b, b], [0.0, c]];
    let nearer = |a: &[f64; 2], b: &[f64; 2]| away(*a).total_cmp(&away(*b));
    let best = sides.into_iter().min_by(nearer).unwrap_or_default();
    (best, away(best))
}

/// The place of a bilinear quadrilateral nearest to a point, coordinates from zero to one, and its distance.
fn in_quadrilateral(point: &Vec3, corners: &[Vec3]) -> ([f64; 2], f64) {
    let at = |place: [f64; 2]| -> Vec3 {
        let (weights, _) = shape(4, place);
        corners.iter().zip(weights).map(|(x, w)| x * w).sum()
    };
    let mut place = [0.5; 2];
    for _ in 0..ITERATIONS {
        let (_, along) = shape(4, place);
        let [t, s] = along.map(|own| corners.iter().zip(own).map(|(x, w)| x * w).sum::<Vec3>());
        let r = point - at(place);
        let [tt, ts, ss] = [t.dot(&t), t.dot(&s), s.dot(&s)];
        let over = 1.0 / (tt * ss - ts * ts);
        let ways = [(ss * r.dot(&t) - ts * r.dot(&s)) * over, (tt * r.dot(&s) - ts * r.dot(&t)) * over];
        // On a rim the other coordinate alone moves.
        let held = |k: usize| place[k] == 0.0 && ways[k] < 0.0 || place[k] == 1.0 && ways[k] > 0.0;
        let ways = match [held(0), held(1)] {
            [false, false] => ways,
            [true, false] => [0.0, r.dot(&s) / ss],
            [false, true] => [r.dot(&t) / tt, 0.0],
            [true, true] => [0.0; 2],
        };
        let next = [0, 1].map(|k: usize| (place[k] + ways[k]).clamp(0.0, 1.0));
        let moved = (next[0] - place[0]).abs().max((next[1] - place[1]).abs());
        place = next;
        if moved <= SETTLED || moved.is_nan() {
            break;
        }
    }
    (place, (point - at(place)).norm())
}

#[cfg(test)]
mod tests {
    use super::*;

    const WARPED: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [1.1, 0.1, 0.1], [1.3, 0.9, -0.1], [-0.1, 1.0, 0.2]];

    fn back(foot: &Foot, nodes: &[Vec3]) -> Vec3 {
        let sum = |weights: &[f64]| -> Vec3 { nodes.iter().zip(weights).map(|(x, w)| x * *w).sum() };
        let [t, s] = [0, 1].map(|k: usize| sum(&foot.along[k]));
        sum(&foot.weights) + t.cross(&s).normalize() * foot.offset
    }

    const POINTS: [[f64; 3]; 4] = [[0.4, 0.3, 0.2], [1.4, 0.5, -0.3], [-0.3, -0.2, 0.1], [0.5, 1.6, 0.4]];

    /// Inside, beyond rims and corners, of warped quadrilaterals and triangles; rounding.
    #[test]
    fn every_point_is_where_its_foot_says() {
        let corners = WARPED.map(Vec3::from);
        for count in [3, 4] {
            let corners = &corners[..count];
            for point in POINTS.map(Vec3::from) {
                let nearest = Nearest::on(&point, corners).unwrap();
                let own = nearest.on_corners(&point, corners).unwrap();
                let fitted = Foot::fitted(&point, corners, &nearest.place, &nearest.normal).unwrap();
                for foot in [own, fitted] {
                    assert!((back(&foot, corners) - point).norm() < 1e-13, "{count} {foot:?}");
                    assert!((foot.weights.iter().sum::<f64>() - 1.0).abs() < 1e-13);
                }
                assert!((nearest.place - point).norm() - nearest.distance < 1e-13);
            }
        }
        assert_eq!(Nearest::on(&Vec3::zeros(), &[Vec3::x(), Vec3::x() * 2.0, Vec3::x() * 3.0]), None);
    }

    /// Against a fine raster of the face, which is no nearer.
    #[test]
    fn no_place_of_a_face_is_nearer() {
        let corners = WARPED.map(Vec3::from);
        for point in POINTS.map(Vec3::from) {
            for count in [3, 4] {
                let found = Nearest::on(&point, &corners[..count]).unwrap().distance;
                let mut least = f64::INFINITY;
                for i in 0..=200 {
                    for j in 0..=200 {
                        let place = [f64::from(i) / 200.0, f64::from(j) / 200.0];
                        if count == 4 || place[0] + place[1] <= 1.0 {
                            let (weights, _) = shape(count, place);
                            let x: Vec3 = corners.iter().zip(weights).map(|(x, w)| x * w).sum();
                            least = least.min((x - point).norm());
                        }
                    }
                }
                assert!(found < least + 1e-12 && found > least - 0.01, "{point} {count}: {found} {least}");
            }
        }
    }

    /// Nodes of a flat lattice that is bent to `z = ½ κ x²`: the foot goes along, and the normal leans by κ x, at the rim as inside; 1e-6 found,
    /// of what is left between nodes of a weight.
    #[test]
    fn foot_and_normal_follow_a_surface_that_bends() {
        let flat: Vec<Vec3> = (0..12).map(|a| Vec3::new(f64::from(a / 3), f64::from(a % 3), 0.0)).collect();
        let curvature = 1e-3;
        for x in [0.0, 0.4, 1.0, 2.7, 3.0] {
            let point = Vec3::new(x, 0.8, 0.5);
            let foot = Foot::fitted(&point, &flat, &Vec3::new(x, 0.8, 0.0), &Vec3::z()).unwrap();
            let bent: Vec<Vec3> =
                flat.iter().map(|x| x + Vec3::z() * (0.5 * curvature * x.x * x.x)).collect();
            let sum = |weights: &[f64]| -> Vec3 { bent.iter().zip(weights).map(|(x, w)| x * *w).sum() };
            let (place, normal) =
                (sum(&foot.weights), sum(&foot.along[0]).cross(&sum(&foot.along[1])).normalize());
            assert!(
                (place.z - 0.5 * curvature * x * x).abs() < 1e-5 * curvature,
                "{x} {}",
                place.z / curvature
            );
            let slope = -normal.x / normal.z / curvature * foot.offset.signum();
            assert!((slope.abs() - x).abs() < 1e-4, "{x} {slope}");
        }
    }
}
