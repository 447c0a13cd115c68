//! Rows of wall particles along a polyline in the plane.
//!
//! A row is the line at a distance d from the polyline on the side of the wall. Raw, it is made of the segments moved
//! by d; where the wall turns outside they are joined in a mitre (cut off where the corner is sharper than 30°),
//! where it turns inside they cross. Of the raw line only what lies no nearer than d to the polyline counts; its
//! pieces are joined and walked at even spacing, with a particle on every corner.

use libm::ceil;

use super::offsets::Offsets;
use super::stretch::{Row, Stretch};
use super::wall_rows::{apart, check, check_count};
use crate::Vec3;
use crate::error::SpaceError;

/// Steps per spacing in which a raw row is looked at.
const STEPS: f64 = 16.0;
/// Outer corners whose turn has a cosine below this are cut off: the mitre is longer than 4 d.
const CUT: f64 = -0.875; // 151°
/// What lies this part of the spacing nearer than a row is not nearer: rounding.
const ROUNDING: f64 = 1e-7;
/// Halvings of a step that find the end of what is free: to 4e-9 of the spacing.
const BISECTIONS: usize = 24;

/// Sides of a line, seen along it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "scene",
    derive(serde::Deserialize, schemars::JsonSchema),
    serde(rename_all = "kebab-case")
)]
pub enum LineSide {
    /// On the left.
    Left,
    /// On the right.
    Right,
}

/// Rows of wall particles along a polyline in the plane z = 0, the first half a spacing behind it, row by row.
///
/// `points` \[L\] are in order; a polyline whose last point is its first is closed. Open ends are flush: the wall
/// stops where the polyline does. Outer corners are closed by a mitre, down to 30° and cut off beyond; inside a
/// corner the rows end on its bisector. No two particles are nearer than half of `spacing` \[L\]. A wall between two
/// parts of the polyline less than a spacing apart has no particle: [`leaks`](crate::leaks) counts such places.
///
/// # Errors
/// [`SpaceError::OutOfRange`] for a spacing that is not positive, rows out of \[1, 20\] and more than 10⁸ particles;
/// [`SpaceError::TooFew`] for less than two points, [`SpaceError::BadNumber`] for coordinates that are none,
/// [`SpaceError::Coincident`] for two points in a row at the same place.
pub fn polyline_rows(
    points: &[[f64; 2]],
    side: LineSide,
    spacing: f64,
    rows: usize,
) -> Result<Vec<Vec3>, SpaceError> {
    let polyline = Polyline::new(points, side, spacing, rows)?;
    let farthest = (rows as f64 - 0.5) * spacing;
    let segments = polyline.triangles();
    let offsets = Offsets::new(&segments, spacing, farthest, ROUNDING);
    let mut particles = Vec::new();
    for row in 0..rows {
        let distance = (row as f64 + 0.5) * spacing;
        let free = |x: &Vec3| offsets.none_nearer(x, distance);
        for stretch in polyline.stretches(distance, spacing, free) {
            stretch.fill(spacing, &mut particles);
        }
    }
    Ok(apart(particles, spacing))
}

/// Points where the first row of a polyline's wall should stand: half a spacing behind it, a quarter apart.
///
/// # Errors
/// As [`polyline_rows`].
pub fn polyline_first_row(
    points: &[[f64; 2]],
    side: LineSide,
    spacing: f64,
) -> Result<Vec<Vec3>, SpaceError> {
    let polyline = Polyline::new(points, side, spacing, 1)?;
    let along = polyline.segments.iter().flat_map(|segment| {
        let count = ceil((segment.to - segment.from).norm() / (0.25 * spacing));
        let behind = segment.normal * (0.5 * spacing);
        let at = move |i: usize| segment.from.lerp(&segment.to, (i as f64 + 0.5) / count) + behind;
        (0..count as usize).map(at)
    });
    let segments = polyline.triangles();
    Ok(Offsets::new(&segments, spacing, 0.5 * spacing, ROUNDING).kept(along, 0.5 * spacing))
}

/// A segment of the polyline, with unit vectors along it and into the wall.
#[derive(Clone, Copy)]
struct Segment {
    from: Vec3,
    to: Vec3,
    along: Vec3,
    normal: Vec3,
}

struct Polyline {
    segments: Vec<Segment>,
    closed: bool,
}

impl Polyline {
    fn new(points: &[[f64; 2]], side: LineSide, spacing: f64, rows: usize) -> Result<Self, SpaceError> {
        check(spacing, rows)?;
        if points.len() < 2 {
            return Err(SpaceError::TooFew { what: "points of a polyline", found: points.len(), needed: 2 });
        }
        for (particle, &[x, y]) in points.iter().enumerate() {
            if let Some(&value) = [x, y].iter().find(|value| !value.is_finite()) {
                let (what, bound) = ("a coordinate of a polyline", "a finite number");
                return Err(SpaceError::BadNumber { particle, what, value, bound });
            }
        }
        let places: Vec<Vec3> = points.iter().map(|&[x, y]| Vec3::new(x, y, 0.0)).collect();
        let extent = places.iter().fold(0.0, |most: f64, x| most.max((x - places[0]).norm()));
        let (bound, mut length, mut segments) = (1e-9 * extent, 0.0, Vec::new());
        for (first, pair) in places.windows(2).enumerate() {
            let (from, to) = (pair[0], pair[1]);
            let distance = (to - from).norm();
            if distance <= bound {
                return Err(SpaceError::Coincident { first, second: first + 1, distance, bound });
            }
            let along = (to - from) / distance;
            let left = Vec3::new(-along.y, along.x, 0.0);
            let normal = if side == LineSide::Left { left } else { -left };
            segments.push(Segment { from, to, along, normal });
            length += distance;
        }
        check_count(length / spacing * rows as f64)?;
        let closed = segments.len() > 2 && (places[places.len() - 1] - places[0]).norm() <= bound;
        Ok(Self { segments, closed })
    }

    /// The segments as flat triangles.
    fn triangles(&self) -> Vec<[Vec3; 3]> {
        self.segments.iter().map(|segment| [segment.from, segment.to, segment.to]).collect()
    }

    /// The raw line at a distance from the polyline: its corners \[L\].
    fn raw(&self, distance: f64) -> Vec<Vec3> {
        let count = self.segments.len();
        let mut corners = Vec::new();
        if !self.closed {
            corners.push(self.segments[0].from + self.segments[0].normal * distance);
        }
        for i in 0..if self.closed { count } else { count - 1 } {
            let (a, b) = (self.segments[i], self.segments[(i + 1) % count]);
            let (turn, opens) = (a.along.dot(&b.along), a.along.dot(&b.normal) > 0.0);
            // A corner on which the wall turns back altogether is an outer one.
            let opens = opens || turn < -1.0 + 1e-12;
            let at = |along: f64, of: &Segment| a.to + (of.normal + of.along * along) * distance;
            if !opens {
                corners.extend([at(0.0, &a), at(0.0, &b)]);
            } else if turn > CUT {
                corners.push(a.to + (a.normal + b.normal) * (distance / (1.0 + turn)));
            } else {
                // The tangent on the bisector cuts both lines off at d tan(θ/4).
                let half = (0.5 * (1.0 + turn)).max(0.0).sqrt();
                let quarter = ((1.0 - half) / (1.0 + half)).sqrt();
                corners.extend([at(quarter, &a), at(-quarter, &b)]);
            }
        }
        match self.closed {
            true => corners.push(corners[0]),
            false => corners.push(self.segments[count - 1].to + self.segments[count - 1].normal * distance),
        }
        corners
    }

    /// The parts of the raw line that are free, as far as they hang together.
    fn stretches(&self, distance: f64, spacing: f64, free: impl Fn(&Vec3) -> bool) -> Vec<Stretch> {
        let corners = self.raw(distance);
        let mut row = Row::new(spacing);
        for pair in corners.windows(2) {
            // An even number of steps: the middle is looked at, which is free on bends of short segments.
            let steps = 2.0 * ceil((pair[1] - pair[0]).norm() / spacing * 0.5 * STEPS).max(4.0);
            let at = |step: usize| pair[0].lerp(&pair[1], step as f64 / steps);
            let line: Vec<(Vec3, bool)> = (0..=steps as usize).map(at).map(|x| (x, free(&x))).collect();
            for (i, &(x, is_free)) in line.iter().enumerate() {
                if !is_free {
                    continue;
                }
                match i.checked_sub(1).map(|before| line[before]) {
                    None => row.begin(x),
                    Some((before, false)) => row.begin(border(x, before, &free)),
                    Some((_, true)) => {}
                }
                row.go_on(x);
                if let Some(&(after, false)) = line.get(i + 1) {
                    row.go_on(border(x, after, &free));
                }
            }
        }
        let ends = [corners[0], corners[corners.len() - 1]];
        row.stretches(if self.closed { None } else { Some(ends) })
    }
}

/// The border between a free point and one that is not.
fn border(mut inside: Vec3, mut outside: Vec3, free: &impl Fn(&Vec3) -> bool) -> Vec3 {
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (inside + outside);
        if free(&middle) { inside = middle } else { outside = middle }
    }
    inside
}
