//! The zone behind an opening: points that stand beyond it and move as it says, and the rows in which they are fed.

use std::ops::Range;

use explicit_dynamics::Amplitude;
use sph_core::{CellList, Vec3};

use crate::boundary::points::Boundary;
use crate::openings::opening::{Given, Opening};

/// How far beside its rows a particle still goes through an opening, in spacings.
const BESIDE: f64 = 2.0;
/// How far before an opening the depth of the water is counted, and how high it may stand, in depths at the start.
const COUNTED: f64 = 2.0;
const HIGHEST: f64 = 2.0;
/// Times in which rows follow the depth, and its mean that, in √(depth/g): some ways of a wave along what is counted, and longer than waves of a channel take that are to go out.
const LAG: f64 = 5.0;
const SLOW: f64 = 20.0;
/// Least height of a layer in spacings: that of one layer of half a spacing.
const LOWEST: f64 = 0.5;
/// Part of a spacing within which places agree: rounding.
pub(crate) const NEAR: f64 = 1e-6;

/// A row of points, along the way through the opening.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Row {
    /// Where it begins, at the outer end of the zone \[L\].
    pub place: Vec3,
    /// Height along −g \[L\].
    pub height: f64,
    /// How far it has gone since a point was fed \[L\].
    pub gone: f64,
}

/// A zone of whole spacings beyond an opening, as wide as the kernel reaches.
#[derive(Clone, Debug)]
pub(crate) struct Zone {
    pub opening: Opening,
    /// Its points among those of the boundary.
    pub points: Range<usize>,
    /// Distance of neighbouring particles \[L\].
    pub spacing: f64,
    /// How many columns of points fill it.
    pub columns: usize,
    /// The rows by height: first those that the fluid has at the start, with those above them.
    pub rows: Vec<Row>,
    /// Direction in which heights are measured.
    pub up: Vec3,
    /// Gravity, if it lies along the opening: rows are fed up to a level then \[L/T²\]; else zero, and all are.
    gravity: f64,
    /// Height at which the lowest row begins \[L\].
    bottom: f64,
    /// Depth of the fluid at the start \[L\], and particles before the opening then, over some depths.
    depth_at_start: f64,
    count_at_start: usize,
    /// Particles there now.
    pub count: usize,
    /// Depth up to which rows are fed, and its mean over some time \[L\].
    pub fed: f64,
    pub mean: f64,
    /// Velocity that is asked for, as slow as the depth that is fed, and its mean over the time of that of the depth \[L/T\].
    pub asked: f64,
    pub asked_mean: f64,
    /// Box across it \[L\].
    low: Vec3,
    high: Vec3,
    /// Factor of its velocity in the last step; else the mean velocity into the fluid \[L/T\].
    pub velocity: f64,
    /// Particles that came in and went out.
    pub came: u64,
    pub went: u64,
}

impl Zone {
    /// That of an opening, from the places of a fluid; `gravity` that along it, or zero \[L/T²\]. Without rows where no fluid is near.
    pub fn new(
        opening: Opening,
        fluid: &[Vec3],
        spacing: f64,
        columns: usize,
        up: Vec3,
        gravity: f64,
    ) -> Self {
        let depth = columns as f64 * spacing;
        let mut zone = Self {
            opening,
            points: 0..0,
            spacing,
            columns,
            rows: Vec::new(),
            up,
            gravity,
            bottom: 0.0,
            depth_at_start: 0.0,
            count_at_start: 0,
            count: 0,
            fed: 0.0,
            mean: 0.0,
            asked: 0.0,
            asked_mean: 0.0,
            low: Vec3::repeat(f64::INFINITY),
            high: Vec3::repeat(f64::NEG_INFINITY),
            velocity: 0.0,
            came: 0,
            went: 0,
        };
        let into = zone.opening.into;
        let near = |at: &&Vec3| (0.0..spacing * (1.0 - NEAR)).contains(&zone.distance(at));
        let beside: Vec<Vec3> = fluid.iter().filter(near).copied().collect();
        for at in &beside {
            let (gone, height) = (zone.distance(at), up.dot(at));
            zone.rows.push(Row { place: at - into * (gone + depth), height, gone });
            for k in 0..3 {
                zone.low[k] = zone.low[k].min(at[k] - BESIDE * spacing);
                zone.high[k] = zone.high[k].max(at[k] + BESIDE * spacing);
            }
        }
        for k in 0..3 {
            if up[k] > 0.5 {
                zone.high[k] = f64::INFINITY;
            } else if up[k] < -0.5 {
                zone.low[k] = f64::NEG_INFINITY;
            }
            if into[k] != 0.0 {
                (zone.low[k], zone.high[k]) = (f64::NEG_INFINITY, f64::INFINITY);
            }
        }
        let heights = || beside.iter().map(|at| up.dot(at));
        zone.bottom = heights().fold(f64::INFINITY, f64::min) - 0.5 * spacing;
        zone.depth_at_start = heights().fold(f64::NEG_INFINITY, f64::max) + 0.5 * spacing - zone.bottom;
        zone.fed = match zone.opening.given {
            Given::Velocity { level: Some(level), .. } | Given::Pressure { level, .. } => level - zone.bottom,
            _ => zone.depth_at_start,
        };
        zone.mean = zone.fed;
        zone.count_at_start = fluid.iter().filter(|at| zone.counts(at)).count();
        zone.count = zone.count_at_start;
        zone.add_rows_above();
        zone.rows.sort_by(|a, b| {
            let beside = || (0..3).map(|k| a.place[k].total_cmp(&b.place[k])).find(|order| order.is_ne());
            a.height.total_cmp(&b.height).then_with(|| beside().unwrap_or(std::cmp::Ordering::Equal))
        });
        zone
    }

    /// Rows above those at the start, up to a level that is given or so far as one may rise.
    fn add_rows_above(&mut self) {
        let spacing = self.spacing;
        let depth = if self.follows() { HIGHEST * self.depth_at_start } else { self.fed };
        if self.gravity == 0.0 {
            return;
        }
        let top = self.bottom + depth;
        let base = self.rows.clone();
        let places: Vec<Vec3> = base.iter().map(|row| row.place).collect();
        let (list, mut found) = (CellList::new(&places, spacing), Vec::new());
        for row in &base {
            let above = row.place + self.up * spacing;
            list.within(&above, 0.5 * spacing, &mut found);
            if !found.is_empty() {
                continue;
            }
            let count = libm::ceil((top - row.height) / spacing).max(0.0) as usize;
            for k in 1..=count {
                let by = k as f64 * spacing;
                self.rows.push(Row { place: row.place + self.up * by, height: row.height + by, ..*row });
            }
        }
    }

    /// How far a place lies inside the opening \[L\].
    pub fn distance(&self, at: &Vec3) -> f64 {
        (at - self.opening.at).dot(&self.opening.into)
    }

    /// Whether rows are fed as far as the water before the opening stands.
    pub fn follows(&self) -> bool {
        self.gravity > 0.0 && matches!(self.opening.given, Given::Velocity { level: None, .. })
    }

    /// Whether a place counts for the depth of the water before the opening.
    pub fn counts(&self, at: &Vec3) -> bool {
        (0.0..COUNTED * self.depth_at_start).contains(&self.distance(at)) && self.holds(at)
    }

    /// Width of the zone \[L\].
    pub fn depth(&self) -> f64 {
        self.columns as f64 * self.spacing
    }

    /// Whether a place lies behind or before the opening, not beside it.
    pub fn holds(&self, at: &Vec3) -> bool {
        (0..3).all(|k| self.low[k] <= at[k] && at[k] <= self.high[k])
    }

    /// Where those wait that are not in the flow: at the outer end \[L\].
    pub fn aside(&self) -> Vec3 {
        self.opening.at - self.opening.into * self.depth()
    }

    /// By how much the velocity gives way to a wave that comes out of the fluid, with which it goes on: `√(g/h) (h − h̄)`, less `u − ū` of the wave
    /// that it makes itself, whose height goes with the change of what is asked for \[L/T\].
    fn gives_way(&self) -> f64 {
        if !self.follows() {
            return 0.0;
        }
        (self.gravity / self.mean).sqrt() * (self.fed - self.mean) - (self.asked - self.asked_mean)
    }

    /// Mean over the rows that are fed of the velocity that is asked for \[L/T\].
    fn asks(&self) -> f64 {
        let Given::Velocity { into, profile, .. } = &self.opening.given else { return 0.0 };
        let (mut sum, mut count) = (0.0, 0.0);
        for number in (0..self.rows.len()).filter(|&row| self.feeds(row)) {
            sum += Amplitude::along(profile, self.height(number));
            count += 1.0;
        }
        if count > 0.0 { into * self.velocity * sum / count } else { 0.0 }
    }

    /// Velocity into the fluid at a height \[L/T\].
    pub fn velocity_at(&self, height: f64) -> f64 {
        match &self.opening.given {
            Given::Velocity { into, profile, .. } => {
                into * self.velocity * Amplitude::along(profile, height) - self.gives_way()
            }
            _ => self.velocity,
        }
    }

    /// Moves its points and rows through a step that ends at a time \[T\].
    pub fn advance(&mut self, boundary: &mut Boundary, near: &[bool], time: f64, dt: f64) {
        if let Given::Velocity { course, .. } = &self.opening.given {
            self.velocity = course.value(time - 0.5 * dt);
        }
        let given = matches!(self.opening.given, Given::Velocity { .. });
        let mut fastest: f64 = 0.0;
        for point in self.points.clone().filter(|&point| near[point]) {
            if given {
                let height = self.up.dot(&boundary.points[point]);
                boundary.velocities[point] = self.opening.into * self.velocity_at(height);
            }
            let velocity = boundary.velocities[point];
            fastest = fastest.max(velocity.norm_squared());
            boundary.points[point] += velocity * dt;
        }
        boundary.advance = boundary.advance.max(fastest.sqrt() * dt);
        if self.follows() {
            let depth = self.depth_at_start * self.count as f64 / self.count_at_start as f64;
            let time = (self.depth_at_start / self.gravity).sqrt();
            let depth = depth.min(HIGHEST * self.depth_at_start);
            self.fed += (depth - self.fed) * (dt / (LAG * time)).min(1.0);
            self.mean += (self.fed - self.mean) * (dt / (SLOW * time)).min(1.0);
            self.asked += (self.asks() - self.asked) * (dt / (LAG * time)).min(1.0);
            self.asked_mean += (self.asked - self.asked_mean) * (dt / (SLOW * time)).min(1.0);
        }
        let apart = self.apart();
        for number in 0..self.rows.len() {
            let way = self.velocity_at(self.height(number)) * dt;
            let gone = &mut self.rows[number].gone;
            *gone += way;
            // What goes out leaves the next place free behind it.
            while *gone < 0.0 {
                *gone += apart;
            }
        }
    }

    /// How many layers of rows are fed, and how much higher than a spacing each is, so that they fill the depth.
    fn layers(&self) -> (f64, f64) {
        if self.gravity == 0.0 {
            return (f64::INFINITY, 1.0);
        }
        let layers = libm::round(self.fed / self.spacing).max(1.0);
        (layers, (self.fed / self.spacing / layers).max(LOWEST))
    }

    /// Distance of the points of a row: of higher layers less, for each has the volume of a particle \[L\].
    pub fn apart(&self) -> f64 {
        self.spacing / self.layers().1
    }

    /// Whether a row is fed.
    pub fn feeds(&self, row: usize) -> bool {
        self.rows[row].height < self.bottom + self.layers().0 * self.spacing
    }

    /// Height at which a row is fed \[L\].
    pub fn height(&self, row: usize) -> f64 {
        let height = self.rows[row].height;
        if self.gravity == 0.0 { height } else { self.bottom + (height - self.bottom) * self.layers().1 }
    }
}
