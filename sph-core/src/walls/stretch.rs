//! A row of wall particles along a curve: the parts that hang together, with a particle on every corner.

use libm::round;

use super::wall_rows::divisions;
use crate::Vec3;

/// Ends nearer than this part of the spacing are joined.
const JOIN: f64 = 0.125;
/// Points nearer than this part of the spacing are one.
const SAME: f64 = 1e-4;
/// Corners that turn by less than this (its cosine) are bends: no particle need stand on them.
const BEND: f64 = 0.866; // 30°

/// A row under way: its stretches so far.
pub(super) struct Row {
    stretches: Vec<Stretch>,
    spacing: f64,
}

/// A part of a row without a gap: points along it, much closer than particles.
#[derive(Default)]
pub(super) struct Stretch {
    points: Vec<Vec3>,
    /// Whether it begins and ends flush with an open end, half a gap beyond the last particle.
    flush: [bool; 2],
    /// Whether its last point is its first.
    ring: bool,
}

impl Row {
    /// A row without points, for particles so far apart \[L\].
    pub(super) fn new(spacing: f64) -> Self {
        Self { stretches: Vec::new(), spacing }
    }

    /// Goes on with the last stretch where it ends at a point, or begins a new one there.
    pub(super) fn begin(&mut self, start: Vec3) {
        let end = self.stretches.last().and_then(|stretch| stretch.points.last());
        if end.is_none_or(|end| (end - start).norm() > JOIN * self.spacing) {
            self.stretches.push(Stretch { points: vec![start], ..Stretch::default() });
        }
    }

    /// The next point of the stretch under way; one at the place of the last is left out.
    pub(super) fn go_on(&mut self, x: Vec3) {
        let Some(Stretch { points, .. }) = self.stretches.last_mut() else { return };
        if points.last().is_none_or(|last| (last - x).norm() > SAME * self.spacing) {
            points.push(x);
        }
    }

    /// The stretches of a row with two open ends, or of a closed one.
    pub(super) fn stretches(mut self, ends: Option<[Vec3; 2]>) -> Vec<Stretch> {
        let near = |x: Option<&Vec3>, y: Option<&Vec3>, reach: f64| {
            x.zip(y).is_some_and(|(x, y)| (x - y).norm() <= reach * self.spacing)
        };
        if let Some([first, last]) = &ends {
            for Stretch { points, flush, .. } in &mut self.stretches {
                *flush = [near(points.first(), Some(first), SAME), near(points.last(), Some(last), SAME)];
            }
            return self.stretches;
        }
        let start = self.stretches.first().and_then(|stretch| stretch.points.first());
        let end = self.stretches.last().and_then(|stretch| stretch.points.last());
        if near(start, end, JOIN) {
            let first = self.stretches.remove(0);
            match self.stretches.last_mut() {
                Some(last) => last.points.extend(&first.points[1..]),
                None => self.stretches.push(Stretch { ring: true, ..first }),
            }
        }
        self.stretches
    }
}

impl Stretch {
    /// Places particles on all corners and evenly between them.
    pub(super) fn fill(mut self, spacing: f64, particles: &mut Vec<Vec3>) {
        let mut corners = self.corners();
        let mut last = self.points.len() - 1;
        if self.ring {
            self.points.pop();
            let Some(&first) = corners.first() else { return self.walk_round(spacing, particles) };
            self.points.rotate_left(first);
            self.points.push(self.points[0]);
            corners = corners[1..].iter().map(|corner| corner - first).collect();
            last = self.points.len() - 1;
        }
        corners.push(last);
        let mut from = 0;
        for to in corners {
            let line = Line::new(&self.points[from..=to]);
            let half = |flush: bool| if flush { 0.5 } else { 0.0 };
            let (before, after) = (half(self.flush[0] && from == 0), half(self.flush[1] && to == last));
            let gaps = match before + after {
                0.0 => divisions(line.length(), spacing) as f64,
                halves => round(line.length() / spacing - halves).max(0.0),
            };
            let gap = line.length() / (gaps + before + after);
            particles.extend((0..=gaps as usize).map(|i| line.at((before + i as f64) * gap)));
            from = to;
        }
    }

    /// Places particles round a ring without corners.
    fn walk_round(mut self, spacing: f64, particles: &mut Vec<Vec3>) {
        self.points.push(self.points[0]);
        let line = Line::new(&self.points);
        let count = divisions(line.length(), spacing);
        particles.extend((0..count).map(|i| line.at(line.length() * (i as f64 / count as f64))));
    }

    /// Points at which it turns sharply; of a ring its first point may be one.
    fn corners(&self) -> Vec<usize> {
        let points = &self.points;
        let last = points.len() - 1;
        let turns = |before: usize, at: usize, after: usize| {
            let (a, b) = (points[at] - points[before], points[after] - points[at]);
            a.dot(&b) < BEND * a.norm() * b.norm()
        };
        let first = self.ring && last > 1 && turns(last - 1, 0, 1);
        let inner = (1..last.max(1)).filter(|&at| turns(at - 1, at, at + 1));
        first.then_some(0).into_iter().chain(inner).collect()
    }
}

/// A line through points, by the length along it.
struct Line<'a> {
    points: &'a [Vec3],
    /// Length from the first point to each \[L\].
    lengths: Vec<f64>,
}

impl<'a> Line<'a> {
    fn new(points: &'a [Vec3]) -> Self {
        let mut lengths = vec![0.0];
        for pair in points.windows(2) {
            lengths.push(lengths[lengths.len() - 1] + (pair[1] - pair[0]).norm());
        }
        Self { points, lengths }
    }

    /// Its whole length \[L\].
    fn length(&self) -> f64 {
        self.lengths[self.lengths.len() - 1]
    }

    /// The point so far along it \[L\].
    fn at(&self, along: f64) -> Vec3 {
        let after = self.lengths.partition_point(|&length| length <= along);
        if after >= self.points.len() {
            return self.points[self.points.len() - 1];
        }
        let part = (along - self.lengths[after - 1]) / (self.lengths[after] - self.lengths[after - 1]);
        self.points[after - 1].lerp(&self.points[after], part)
    }
}
