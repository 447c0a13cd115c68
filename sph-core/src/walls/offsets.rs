//! Distance from a surface of triangles, or from a polyline: is anything of it nearer than so much?

use libm::ceil;

use crate::Vec3;
use crate::neighbours::CellList;

/// Triangles, found by sample points on them; a triangle may be a segment, its last corner repeated.
pub(super) struct Offsets<'a> {
    triangles: &'a [[Vec3; 3]],
    spacing: f64,
    /// What lies this much nearer than asked is not nearer \[L\].
    slack: f64,
    /// Sample points, no point of a triangle farther than a spacing from one of its own.
    samples: CellList,
    /// The triangle of each sample.
    owners: Vec<u32>,
}

impl<'a> Offsets<'a> {
    /// Of triangles, for distances up to `farthest` \[L\]; what lies nearer than asked by the part `slack` of the
    /// spacing is not nearer.
    pub(super) fn new(triangles: &'a [[Vec3; 3]], spacing: f64, farthest: f64, slack: f64) -> Self {
        let (mut places, mut owners) = (Vec::new(), Vec::new());
        for (owner, triangle) in triangles.iter().enumerate() {
            places.extend(spread(triangle, spacing));
            owners.resize(places.len(), owner as u32);
        }
        let samples = CellList::new(&places, spacing.max(0.5 * farthest));
        Self { triangles, spacing, slack: slack * spacing, samples, owners }
    }

    /// Whether no point of the surface is nearer than `distance` \[L\].
    pub(super) fn none_nearer(&self, x: &Vec3, distance: f64) -> bool {
        let least = distance - self.slack;
        let mut near = Vec::new();
        self.samples.within(x, distance + self.spacing, &mut near);
        let mut before = None;
        near.iter().all(|&sample| {
            let owner = self.owners[sample as usize];
            let again = before.replace(owner) == Some(owner);
            again || (closest(&self.triangles[owner as usize], x) - x).norm_squared() >= least * least
        })
    }

    /// Of points at a `distance` \[L\] from the triangles that they belong to, those that are no nearer to another,
    /// and those that are, unless one of the first is within a spacing: there the surface is trimmed, but not lost.
    pub(super) fn kept(&self, points: impl Iterator<Item = Vec3>, distance: f64) -> Vec<Vec3> {
        let (mut free, mut trimmed): (Vec<Vec3>, Vec<Vec3>) =
            points.partition(|x| self.none_nearer(x, distance));
        let list = CellList::new(&free, self.spacing);
        let mut found = Vec::new();
        trimmed.retain(|x| {
            list.within(x, self.spacing, &mut found);
            found.is_empty()
        });
        free.append(&mut trimmed);
        free
    }
}

/// Points spread over a triangle in rows along its longest edge, corners included; no point of it is farther than
/// `step` \[L\] from one of them.
pub(super) fn spread(triangle: &[Vec3; 3], step: f64) -> impl Iterator<Item = Vec3> {
    let length = |i: usize| (triangle[(i + 1) % 3] - triangle[i]).norm();
    let first = (1..3).fold(0, |best, i| if length(i) > length(best) { i } else { best });
    let [a, b, c] = [0, 1, 2].map(|j| triangle[(first + j) % 3]);
    let longest = length(first);
    let height = (b - a).cross(&(c - a)).norm() / longest.max(f64::MIN_POSITIVE);
    let rows = ceil(height / (0.8 * step));
    (0..=rows as usize).flat_map(move |i| {
        let part = if rows > 0.0 { i as f64 / rows } else { 0.0 };
        let (start, end) = (a.lerp(&c, part), b.lerp(&c, part));
        let gaps = ceil(longest * (1.0 - part) / step);
        (0..=gaps as usize).map(move |k| start.lerp(&end, k as f64 / gaps.max(1.0)))
    })
}

/// The point of a triangle that is closest to x.
pub(super) fn closest(triangle: &[Vec3; 3], x: &Vec3) -> Vec3 {
    let [a, b, c] = triangle;
    let normal = (b - a).cross(&(c - a));
    let square = normal.norm_squared();
    if square > 0.0 {
        let foot = x - normal * (normal.dot(&(x - a)) / square);
        let inside = |p: &Vec3, q: &Vec3| normal.dot(&(q - p).cross(&(foot - p))) >= 0.0;
        if inside(a, b) && inside(b, c) && inside(c, a) {
            return foot;
        }
    }
    let along = |p: &Vec3, q: &Vec3| {
        let edge = q - p;
        let part = edge.dot(&(x - p)) / edge.norm_squared().max(f64::MIN_POSITIVE);
        p + edge * part.clamp(0.0, 1.0)
    };
    let nearer = |p: Vec3, q: Vec3| if (p - x).norm_squared() <= (q - x).norm_squared() { p } else { q };
    nearer(along(a, b), nearer(along(b, c), along(c, a)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_closest_point_is_the_closest_of_many() {
        let triangle = [Vec3::new(0.0, 0.0, 0.1), Vec3::new(2.0, 0.3, 0.0), Vec3::new(0.4, 1.1, -0.2)];
        for x in
            spread(&[Vec3::new(-3.0, -2.0, 0.4), Vec3::new(6.0, -3.0, 0.2), Vec3::new(0.0, 5.0, -1.0)], 0.7)
        {
            let best = (closest(&triangle, &x) - x).norm();
            let sampled = spread(&triangle, 0.01).map(|y| (y - x).norm()).fold(f64::INFINITY, f64::min);
            assert!(best <= sampled && sampled - best < 0.01, "{x}: {best} {sampled}");
        }
    }
}
