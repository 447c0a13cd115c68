//! Whether a surface encloses a place, or comes near it.

use sph_core::Vec3;

use crate::mass::Outline;

/// Part of a whole turn of solid angles beyond which a place is inside; on a face rounding decides, which [`Outline::is_near`] tells apart.
const INSIDE: f64 = 0.5;

impl Outline {
    /// Whether it encloses a place: the solid angles of its faces from there, over those of a ball, sum to one inside and to none outside.
    ///
    /// A triangle whose corners a, b, c are seen from the place has `tan ½Ω = a·(b × c)/(|a||b||c| + (a·b)|c| + (b·c)|a| + (c·a)|b|)`
    /// \[vanoosterom1983\].
    pub fn encloses(&self, place: &Vec3) -> bool {
        if !self.within_bounds(place, 0.0) {
            return false;
        }
        let sum: f64 = self.triangles().map(|corners| half_angle(corners.map(|x| x - place))).sum();
        sum > INSIDE * 2.0 * std::f64::consts::PI
    }

    /// Whether a point of its faces lies nearer to a place than `reach` \[L\], on either side of them.
    pub fn is_near(&self, place: &Vec3, reach: f64) -> bool {
        self.within_bounds(place, reach)
            && self.triangles().any(|corners| nearest(corners.map(|x| x - place)).norm() < reach)
    }

    /// Whether a place lies in the box round it, made wider by a margin on all sides.
    fn within_bounds(&self, place: &Vec3, margin: f64) -> bool {
        (0..3).all(|k| {
            self.vertices.iter().any(|x| x[k] + margin >= place[k])
                && self.vertices.iter().any(|x| x[k] - margin <= place[k])
        })
    }
}

/// The point of a triangle that is nearest to the origin: the foot of its plane's normal, where that lies in it, else the nearest of its edges.
fn nearest([a, b, c]: [Vec3; 3]) -> Vec3 {
    let normal = (b - a).cross(&(c - a));
    let left_of = |from: Vec3, to: Vec3| from.cross(&to).dot(&normal) >= 0.0;
    if normal != Vec3::zeros() && left_of(a, b) && left_of(b, c) && left_of(c, a) {
        return normal * (a.dot(&normal) / normal.norm_squared());
    }
    let of_edge = |from: Vec3, to: Vec3| {
        let (along, squared) = (to - from, (to - from).norm_squared());
        let part = if squared > 0.0 { (-from.dot(&along) / squared).clamp(0.0, 1.0) } else { 0.0 };
        from + along * part
    };
    let least = |one: Vec3, other: Vec3| if one.norm_squared() <= other.norm_squared() { one } else { other };
    least(of_edge(a, b), least(of_edge(b, c), of_edge(c, a)))
}

/// Half of the solid angle of a triangle, positive where its corners run clockwise from here, as those of a face that looks outwards do from inside.
fn half_angle([a, b, c]: [Vec3; 3]) -> f64 {
    let (la, lb, lc) = (a.norm(), b.norm(), c.norm());
    let below = la * lb * lc + a.dot(&b) * lc + b.dot(&c) * la + c.dot(&a) * lb;
    libm::atan2(a.dot(&b.cross(&c)), below)
}

#[cfg(test)]
mod tests {
    use crate::shapes::{ball, cuboid};

    #[test]
    fn a_place_is_inside_or_outside() {
        let (box_of, round) = (cuboid([0.0; 3], [1.0, 2.0, 3.0], 0.5), ball([5.0, 0.0, 0.0], 1.0, 0.4));
        for (place, inside) in [
            ([0.5, 0.5, 0.5], [true, false]),
            ([0.01, 1.99, 2.99], [true, false]),
            ([-0.01, 1.0, 1.0], [false, false]),
            ([0.5, 1.0, 3.01], [false, false]),
            ([5.0, 0.1, 0.9], [false, true]),
            ([5.0, 0.8, 0.8], [false, false]),
            ([9.0, 0.0, 0.0], [false, false]),
        ] {
            assert_eq!([&box_of, &round].map(|of| of.encloses(&place.into())), inside, "{place:?}");
        }
    }

    /// Distances of places from a box of 1 × 2 × 3 by its faces, edges and corners; from inside as from outside.
    #[test]
    fn a_place_is_near_by_its_distance_from_the_faces() {
        let of = cuboid([0.0; 3], [1.0, 2.0, 3.0], 0.5);
        for (place, distance) in [
            ([0.5, 1.1, 3.2], 0.2),
            ([0.5, 1.1, 2.8], 0.2),
            ([1.0, 0.7, 1.3], 0.0),
            ([1.3, -0.4, 1.2], 0.5),
            ([1.2, 2.3, 3.6], 0.7),
            ([0.5, 0.9, 1.5], 0.5),
        ] {
            let near = |reach: f64| of.is_near(&place.into(), reach);
            assert_eq!([near(distance - 1e-9), near(distance + 1e-9)], [false, true], "{place:?}");
        }
    }
}
