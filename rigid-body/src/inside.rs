//! Whether a surface encloses a place.

use sph_core::Vec3;

use crate::mass::Outline;

/// Part of a whole turn of solid angles beyond which a place is inside: rounding and places on the faces fall on either side.
const INSIDE: f64 = 0.5;

impl Outline {
    /// Whether it encloses a place: the solid angles of its faces from there, over those of a ball, sum to one inside and to none outside.
    ///
    /// A triangle whose corners a, b, c are seen from the place has `tan ½Ω = a·(b × c)/(|a||b||c| + (a·b)|c| + (b·c)|a| + (c·a)|b|)`
    /// \[vanoosterom1983\].
    pub fn encloses(&self, place: &Vec3) -> bool {
        if !self.within_bounds(place) {
            return false;
        }
        let sum: f64 = self.triangles().map(|corners| half_angle(corners.map(|x| x - place))).sum();
        sum > INSIDE * 2.0 * std::f64::consts::PI
    }

    /// Whether a place lies in the box round it.
    fn within_bounds(&self, place: &Vec3) -> bool {
        (0..3).all(|k| {
            self.vertices.iter().any(|x| x[k] >= place[k]) && self.vertices.iter().any(|x| x[k] <= place[k])
        })
    }
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
}
