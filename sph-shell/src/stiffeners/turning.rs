//! Rotary inertia of stiffeners in modes of vibration: one along the line, another across it.
//!
//! A director that turns along the line takes the sections of the bar with it, `ρ I`; one that leans across it swings the whole bar about the line,
//! `ρ (I_p + A e²)`. Sums over the bars at a particle have two principal axes across its director, along which the masses of modes are diagonal. These
//! axes go with the director, along the great circle from rest.

use sph_core::{Frame, Vec3};

/// Bars at a particle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turning {
    pub particle: u32,
    /// Director at rest, and the first principal axis.
    rest: Vec3,
    axis: Vec3,
    /// Rotary inertias of directors that turn along the first axis and the second \[M L²\].
    inertias: [f64; 2],
}

impl Turning {
    /// Of bars at a particle: the direction of each, and its inertias along and across it.
    pub fn new(particle: u32, frame: &Frame, bars: &[(Vec3, [f64; 2])]) -> Self {
        let (mut first, mut second, mut mixed) = (0.0, 0.0, 0.0);
        for (direction, [along, across]) in bars {
            let (x, y) = (direction.dot(&frame.t1), direction.dot(&frame.t2));
            let square = x * x + y * y;
            first += (along * x * x + across * y * y) / square;
            second += (along * y * y + across * x * x) / square;
            mixed += (along - across) * x * y / square;
        }
        let (mean, half) = (0.5 * (first + second), 0.5 * (first - second));
        let radius = libm::hypot(half, mixed);
        let angle = 0.5 * libm::atan2(mixed, half);
        let axis = frame.t1 * libm::cos(angle) + frame.t2 * libm::sin(angle);
        Self { particle, rest: frame.n, axis, inertias: [mean + radius, mean - radius] }
    }

    /// The principal axes about a present director; none where it is opposite to that at rest, which is every way about.
    pub fn axes(&self, d: &Vec3) -> Option<[Vec3; 2]> {
        let cosine = self.rest.dot(d);
        (cosine > -1.0 + 1e-6).then(|| {
            let axis = self.axis - (self.rest + d) * (self.axis.dot(d) / (1.0 + cosine));
            let axis = (axis - d * d.dot(&axis)).normalize();
            [axis, d.cross(&axis)]
        })
    }

    /// Inertia of a director that turns along a direction \[M L²\].
    pub fn along(&self, d: &Vec3, direction: &Vec3) -> f64 {
        let [one, two] = self.inertias;
        match self.axes(d) {
            Some([first, second]) => one * first.dot(direction).powi(2) + two * second.dot(direction).powi(2),
            None => 0.5 * (one + two),
        }
    }
}
