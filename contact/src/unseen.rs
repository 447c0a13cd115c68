//! Bodies between which nothing acts: where they are nearer than their faces allow, or in each other.
//!
//! It looks at places alone. A pair of cells counts where it is nearer than the sum D of the half thicknesses, or where an edge of one
//! goes through the other; pairs that were near at rest already do not. Cells that butt, one beyond the edge of the other and in its plane, do
//! not either: a strip whose ends meet is a ring. What passes between two looks is not found.

use sph_core::{Cell, CellList, Vec3};

use crate::nearest::{Part, on_triangle};

/// Distance at rest over D within which cells of one body, or of two that are joined, do not count.
const NEAR_AT_REST: f64 = 1.6;
/// Least part of the way between two places that leads along the normal where one is over the other \[–\].
const OVER: f64 = 0.5;
/// Part of D below which the direction from one to the other tells nothing; what goes on from there crosses.
const NO_DIRECTION: f64 = 0.05;
/// Part of D by which nothing but rounding counts as nearer.
const ROUNDING: f64 = 1e-6;

/// A body as others may run into it: cells over its particles, or particles alone as cells of one corner.
#[derive(Clone, Copy, Debug)]
pub struct Bystander<'a> {
    /// Cells of one, three or four corners.
    pub cells: &'a [Cell],
    /// Particles at rest \[L\].
    pub rest: &'a [Vec3],
    /// The same now.
    pub now: &'a [Vec3],
    /// Half of its thickness, or the radius of a particle \[L\].
    pub half: f64,
}

/// Where two bodies, or two parts of one, are too near.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TooNear {
    /// A place of either \[L\].
    pub places: [Vec3; 2],
    /// Their distance \[L\]; zero where they are in each other.
    pub distance: f64,
    /// Distance at which faces touch \[L\].
    pub touching: f64,
}

impl Bystander<'_> {
    /// Where it is nearest to itself, if it is too near; parts within 1.6 D at rest, and cells that meet there, do not count.
    pub fn in_itself(&self) -> Option<TooNear> {
        let touching = 2.0 * self.half;
        if self.has_hardly_moved(touching) {
            return None;
        }
        nearest([self, self], Rule { touching, apart: NEAR_AT_REST * touching, itself: true })
    }

    /// Where two bodies are nearest to each other, if they are too near. Parts that were so at rest do not count; of bodies that are
    /// joined none within 1.6 D of the other at rest.
    pub fn in_each_other(&self, other: &Bystander<'_>, joined: bool) -> Option<TooNear> {
        let touching = self.half + other.half;
        let apart = if joined { NEAR_AT_REST * touching } else { 0.0 };
        nearest([self, other], Rule { touching, apart, itself: false })
    }

    /// Whether no two parts have come so much nearer to each other that those that count could touch.
    fn has_hardly_moved(&self, touching: f64) -> bool {
        let moved = || self.now.iter().zip(self.rest).map(|(now, rest)| now - rest);
        let mean = moved().sum::<Vec3>() / self.now.len().max(1) as f64;
        let most = moved().map(|way| (way - mean).norm_squared()).fold(0.0, f64::max).sqrt();
        2.0 * most < (NEAR_AT_REST - 1.0) * touching
    }
}

/// Which pairs of cells count.
#[derive(Clone, Copy)]
struct Rule {
    touching: f64,
    /// Distance at rest that they had at least \[L\]; zero: they did not touch.
    apart: f64,
    itself: bool,
}

/// The ball about a cell.
#[derive(Clone, Copy)]
struct Ball {
    centre: Vec3,
    radius: f64,
}

fn balls(cells: &[Cell], at: &[Vec3]) -> Vec<Ball> {
    let of = |cell: &Cell| {
        let own = cell.particles();
        let centre = own.iter().map(|&a| at[a as usize]).sum::<Vec3>() / own.len() as f64;
        let square = |most: f64, &a: &u32| most.max((at[a as usize] - centre).norm_squared());
        Ball { centre, radius: own.iter().fold(0.0, square).sqrt() }
    };
    cells.iter().map(of).collect()
}

/// The nearest pair of cells that counts.
fn nearest([a, b]: [&Bystander<'_>; 2], rule: Rule) -> Option<TooNear> {
    let touching = rule.touching * (1.0 - ROUNDING);
    let of_b = balls(b.cells, b.now);
    let largest = of_b.iter().fold(0.0_f64, |most, ball| most.max(ball.radius));
    let (mut low, mut high) = (Vec3::repeat(f64::INFINITY), Vec3::repeat(f64::NEG_INFINITY));
    for ball in &of_b {
        let reach = Vec3::repeat(ball.radius + touching);
        (low, high) = (low.inf(&(ball.centre - reach)), high.sup(&(ball.centre + reach)));
    }
    let of_a = balls(a.cells, a.now);
    let meets = |ball: &Ball| {
        (0..3).all(|k| ball.centre[k] + ball.radius >= low[k] && ball.centre[k] - ball.radius <= high[k])
    };
    if !of_a.iter().any(meets) {
        return None;
    }
    let rest = [balls(a.cells, a.rest), balls(b.cells, b.rest)];
    let centres: Vec<Vec3> = of_b.iter().map(|ball| ball.centre).collect();
    let list = CellList::new(&centres, 2.0 * largest + touching);
    let (mut near, mut found) = (Vec::new(), None::<TooNear>);
    for (c, ball) in of_a.iter().enumerate().filter(|(_, ball)| meets(ball)) {
        list.within(&ball.centre, ball.radius + largest + touching, &mut near);
        for d in near.iter().map(|&d| d as usize).filter(|&d| !rule.itself || d > c) {
            let other = &of_b[d];
            let apart = |x: &Ball, y: &Ball| (x.centre - y.centre).norm() - x.radius - y.radius;
            let beside = rule.apart > 0.0 && apart(&rest[0][c], &rest[1][d]) < rule.apart;
            if beside || apart(ball, other) >= touching {
                continue;
            }
            let cells = [&a.cells[c], &b.cells[d]];
            let Some((places, distance)) = distance(cells, [a.now, b.now], touching) else { continue };
            if found.is_some_and(|found| found.distance <= distance) {
                continue;
            }
            if rule.apart == 0.0 && self::distance(cells, [a.rest, b.rest], touching).is_some() {
                continue;
            }
            found = Some(TooNear { places, distance, touching: rule.touching });
        }
    }
    found
}

/// The nearest places of two cells and their distance, zero where an edge of one goes through the other; none beyond a distance.
fn distance([c, d]: [&Cell; 2], [of_c, of_d]: [&[Vec3]; 2], touching: f64) -> Option<([Vec3; 2], f64)> {
    let (c, d) = (Corners::of(c, of_c), Corners::of(d, of_d));
    if [&c, &d].iter().any(|own| own.normal().is_some_and(|normal| c.apart_along(&d, &normal) >= touching)) {
        return None;
    }
    let mut best: Option<([Vec3; 2], f64)> = None;
    for (own, other, turned) in [(&c, &d, false), (&d, &c, true)] {
        let normal = other.normal();
        let over = |way: Vec3, away: f64| {
            normal.is_none_or(|n| away > NO_DIRECTION * touching && n.dot(&way).abs() >= OVER * away)
        };
        for triangle in other.triangles() {
            for place in own.places() {
                let (part, square) = on_triangle(place, triangle);
                let away = square.sqrt();
                if away < touching && best.is_none_or(|(_, least)| away < least) {
                    let there = foot(place, triangle, part);
                    if !over(place - there, away) {
                        continue;
                    }
                    best = Some((if turned { [there, *place] } else { [*place, there] }, away));
                }
            }
            let off = NO_DIRECTION * touching;
            if let Some(place) = own.sides().find_map(|side| through(side, triangle, off)) {
                return Some(([place; 2], 0.0));
            }
        }
    }
    best
}

/// Corners of a cell, and its middle where it has four.
struct Corners {
    corners: [Vec3; 4],
    middle: Vec3,
    count: usize,
}

impl Corners {
    fn of(cell: &Cell, at: &[Vec3]) -> Self {
        let corners = cell.corners.map(|a| at[a as usize]);
        Self { corners, middle: corners.iter().sum::<Vec3>() / 4.0, count: usize::from(cell.count) }
    }

    /// Normal of a cell, as its diagonals have it; none of a particle.
    fn normal(&self) -> Option<Vec3> {
        let [a, b, c, d] = self.corners;
        let across = if self.count == 3 { (b - a).cross(&(c - a)) } else { (c - a).cross(&(d - b)) };
        across.try_normalize(0.0)
    }

    /// How far two cells are apart along a direction of length one at least \[L\], negative where they are beside each other.
    fn apart_along(&self, other: &Self, along: &Vec3) -> f64 {
        let ends = |own: &Self| {
            own.places()
                .map(|place| along.dot(place))
                .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
        };
        let [[a, b], [c, d]] = [ends(self), ends(other)];
        (c - b).max(a - d)
    }

    fn places(&self) -> impl Iterator<Item = &Vec3> {
        self.corners[..self.count].iter()
    }

    /// Four triangles about the middle of a quadrilateral, itself of a triangle, a place of a particle.
    fn triangles(&self) -> impl Iterator<Item = [Vec3; 3]> {
        let Self { corners: [a, b, c, _], middle, count } = *self;
        let whole = match count {
            1 => Some([a; 3]),
            3 => Some([a, b, c]),
            _ => None,
        };
        let parts = if count == 4 { 4 } else { 0 };
        whole.into_iter().chain((0..parts).map(move |i| [self.corners[i], self.corners[(i + 1) % 4], middle]))
    }

    fn sides(&self) -> impl Iterator<Item = [Vec3; 2]> {
        let count = if self.count < 3 { 0 } else { self.count };
        (0..count).map(move |i| [self.corners[i], self.corners[(i + 1) % count]])
    }
}

/// The place of a triangle nearest to another, whose part is known.
fn foot(place: &Vec3, corners: [Vec3; 3], part: Part) -> Vec3 {
    match part {
        Part::Corner(i) => corners[i],
        Part::Side(i) => {
            let (from, along) = (corners[i], corners[(i + 1) % 3] - corners[i]);
            from + along * (along.dot(&(place - from)) / along.norm_squared())
        }
        Part::Inside => {
            let normal = (corners[1] - corners[0]).cross(&(corners[2] - corners[0]));
            place - normal * (normal.dot(&(place - corners[0])) / normal.norm_squared())
        }
    }
}

/// Where a segment goes through a triangle, both ends of which are off its plane by more than a distance \[L\]: edges that meet in a butt joint cross
/// by rounding.
fn through([from, to]: [Vec3; 2], [a, b, c]: [Vec3; 3], off: f64) -> Option<Vec3> {
    let normal = (b - a).cross(&(c - a));
    let [here, there] = [from, to].map(|end| normal.dot(&(end - a)));
    if here * there >= 0.0 || here.abs().min(there.abs()) <= off * normal.norm() {
        return None;
    }
    let place = from + (to - from) * (here / (here - there));
    let inside = |x: Vec3, y: Vec3| normal.dot(&(y - x).cross(&(place - x))) >= 0.0;
    (inside(a, b) && inside(b, c) && inside(c, a)).then_some(place)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A sheet of unit squares, bent by a map.
    fn sheet(count: u32, map: impl Fn(f64, f64) -> Vec3) -> (Vec<Cell>, Vec<Vec3>) {
        let number = |i: u32, j: u32| i * (count + 1) + j;
        let places = (0..=count).flat_map(|i| (0..=count).map(move |j| (i, j)));
        let places = places.map(|(i, j)| map(f64::from(i), f64::from(j))).collect();
        let cells = (0..count).flat_map(|i| (0..count).map(move |j| (i, j)));
        let cell = |(i, j)| Cell {
            corners: [number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)],
            count: 4,
        };
        (cells.map(cell).collect(), places)
    }

    const HALF: f64 = 0.1;

    fn flat(x: f64, y: f64) -> Vec3 {
        Vec3::new(x, y, 0.0)
    }

    #[test]
    fn two_sheets_are_too_near_below_the_sum_of_their_halves_and_where_they_cross() {
        let (cells, rest) = sheet(4, flat);
        let over =
            |height: f64| -> Vec<Vec3> { rest.iter().map(|x| x + Vec3::new(0.3, 0.2, height)).collect() };
        let far = over(0.25);
        let lower = Bystander { cells: &cells, rest: &rest, now: &rest, half: HALF };
        for (height, near) in [(0.21, false), (0.19, true), (-0.19, true), (-0.21, false)] {
            let now = over(height);
            let upper = Bystander { cells: &cells, rest: &far, now: &now, half: HALF };
            let found = lower.in_each_other(&upper, false);
            assert_eq!(found.is_some(), near, "{height}: {found:?}");
            if let Some(found) = found {
                assert!((found.distance - height.abs()).abs() < 1e-12 && found.touching == 2.0 * HALF);
                let [here, there] = found.places;
                assert!(((here - there).norm() - found.distance).abs() < 1e-12 && here.z == 0.0);
            }
        }
        // End to end in one plane nothing is over the other.
        for gap in [0.15, 1e-3] {
            let beside: Vec<Vec3> = rest.iter().map(|x| x + Vec3::new(4.0 + gap, 0.3, 0.0)).collect();
            let next = Bystander { cells: &cells, rest: &far, now: &beside, half: HALF };
            assert_eq!(lower.in_each_other(&next, false), None, "{gap}");
        }
        // A sheet on edge, its particles farther from the other than they may be, its edges through it.
        let stands: Vec<Vec3> = rest.iter().map(|x| Vec3::new(2.3, x.x, x.y - 1.5)).collect();
        let upper = Bystander { cells: &cells, rest: &far, now: &stands, half: HALF };
        assert_eq!(lower.in_each_other(&upper, false).map(|found| found.distance), Some(0.0));
        // What was so at rest does not count.
        let upper = Bystander { rest: &stands, ..upper };
        assert_eq!(lower.in_each_other(&upper, false), None);
    }

    #[test]
    fn a_sheet_that_is_rolled_up_meets_itself_and_one_that_is_bent_does_not() {
        let (cells, rest) = sheet(12, flat);
        let rolled = |radius: f64| -> Vec<Vec3> {
            let at = |x: &Vec3| {
                let (sin, cos) = libm::sincos(x.x / radius);
                Vec3::new(radius * sin, x.y, radius * (1.0 - cos))
            };
            rest.iter().map(at).collect()
        };
        // A whole turn closes at the radius 12/(2π) = 1.91: ends that butt are no harm, those that overlap are in each other.
        for (radius, near) in [
            (2.2, false),
            (1.95, false),
            (1.92, false),
            (12.0 / std::f64::consts::TAU, false),
            (1.8, true),
            (1.6, true),
        ] {
            let now = rolled(radius);
            let body = Bystander { cells: &cells, rest: &rest, now: &now, half: HALF };
            assert_eq!(body.in_itself().is_some(), near, "{radius}");
        }
    }

    #[test]
    fn particles_meet_faces_and_each_other() {
        let (cells, rest) = sheet(2, flat);
        let lower = Bystander { cells: &cells, rest: &rest, now: &rest, half: HALF };
        let grain = [Cell { corners: [0; 4], count: 1 }];
        let far = [Vec3::new(0.7, 0.6, 5.0)];
        let meets = |height: f64| {
            let now = [Vec3::new(0.7, 0.6, height)];
            let ball = Bystander { cells: &grain, rest: &far, now: &now, half: 0.5 };
            lower.in_each_other(&ball, false).is_some()
        };
        assert!(!meets(0.61) && meets(0.59) && meets(-0.59));
        let now = [Vec3::new(0.7, 1.5, 5.0)];
        let other = [Vec3::new(9.0, 9.0, 9.0)];
        let [one, two] = [(&far, &far), (&other, &now)].map(|(rest, now)| Bystander {
            cells: &grain,
            rest,
            now,
            half: 0.5,
        });
        assert_eq!(one.in_each_other(&two, false).map(|found| (found.distance * 1e9).round()), Some(9e8));
    }
}
