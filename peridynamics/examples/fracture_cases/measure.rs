//! What is measured of cracks: functions of node positions and damage, and wave speeds.

use sph_core::Vec3;

/// Damage of a node beside a crack: a clean cut leaves about 0.4 in the first row.
pub const CRACKED: f64 = 0.35;

/// Nodes at rest with their damage.
pub struct Damaged<'a> {
    pub positions: &'a [Vec3],
    pub damage: &'a [f64],
}

impl Damaged<'_> {
    /// Cracked nodes among those that `within` holds for.
    pub fn cracked(&self, within: impl Fn(&Vec3) -> bool) -> Vec<Vec3> {
        let both = self.positions.iter().zip(self.damage);
        both.filter(|(x, damage)| **damage > CRACKED && within(x)).map(|(x, _)| *x).collect()
    }

    /// Greatest x of a cracked node; none where nothing is cracked.
    pub fn tip(&self, within: impl Fn(&Vec3) -> bool) -> Option<f64> {
        self.cracked(within).iter().map(|x| x.x).max_by(f64::total_cmp)
    }

    /// Of each column of a lattice from left to right: its x, and the heights of the bands of cracked nodes, ascending. A
    /// band ends where three whole nodes follow.
    pub fn bands(&self, spacing: f64, within: impl Fn(&Vec3) -> bool) -> Vec<(f64, Vec<f64>)> {
        let mut cracked = self.cracked(within);
        let column = |x: &Vec3| (x.x / spacing).round() as i64;
        cracked.sort_by(|a, b| column(a).cmp(&column(b)).then(a.y.total_cmp(&b.y)));
        cracked
            .chunk_by(|a, b| column(a) == column(b))
            .map(|nodes| {
                let parts = nodes.chunk_by(|a, b| b.y - a.y < 3.5 * spacing);
                let mean = |band: &[Vec3]| band.iter().map(|x| x.y).sum::<f64>() / band.len() as f64;
                (nodes[0].x, parts.map(mean).collect())
            })
            .collect()
    }

    /// Farthest cracked node from a notch tip, as distance and angle to the x-axis in degrees, and the angle of the line
    /// through the tip that fits the cracked nodes up to `near` best.
    pub fn direction(&self, tip: Vec3, near: f64, within: impl Fn(&Vec3) -> bool) -> [f64; 3] {
        let from: Vec<Vec3> = self.cracked(within).iter().map(|x| x - tip).collect();
        let Some(far) = from.iter().max_by(|a, b| a.norm().total_cmp(&b.norm())) else { return [0.0; 3] };
        let degrees = |y: f64, x: f64| libm::atan2(y.abs(), x).to_degrees();
        let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
        for d in from.iter().filter(|d| d.norm() < near) {
            (xx, xy, yy) = (xx + d.x * d.x, xy + d.x * d.y.abs(), yy + d.y * d.y);
        }
        // The principal direction of the second moments about the tip.
        let fit = 0.5 * libm::atan2(2.0 * xy, xx - yy).to_degrees();
        [far.norm(), degrees(far.y, far.x), fit]
    }
}

/// Length of a line through points.
pub fn length(points: &[(f64, f64)]) -> f64 {
    points.windows(2).map(|w| libm::hypot(w[1].0 - w[0].0, w[1].1 - w[0].1)).sum()
}

/// Rayleigh's speed of a plane with these speeds of pressure and shear waves: the root below c_s of
/// `(2 − v²/c_s²)² = 4 √(1 − v²/c_p²) √(1 − v²/c_s²)`.
pub fn rayleigh_speed(pressure: f64, shear: f64) -> f64 {
    let excess = |v: f64| {
        let (p, s) = ((v / pressure).powi(2), (v / shear).powi(2));
        (2.0 - s).powi(2) - 4.0 * ((1.0 - p) * (1.0 - s)).sqrt()
    };
    let (mut low, mut high) = (0.5 * shear, shear * (1.0 - 1e-9));
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if excess(middle) < 0.0 { low = middle } else { high = middle }
    }
    low
}

/// Speeds of a tip from `(time, place)`: the mean from the first growth to the end, and the greatest over a window.
pub fn speeds(path: &[(f64, f64)], window: f64) -> [f64; 2] {
    let start = path.iter().position(|at| at.1 > path[0].1).unwrap_or(0).saturating_sub(1);
    let last = path.last().copied().unwrap_or_default();
    let end = path.iter().copied().find(|at| at.1 >= last.1).unwrap_or(last);
    let mean = (end.1 - path[start].1) / (end.0 - path[start].0);
    let over = |&(t, x): &(f64, f64)| {
        let later = path.iter().find(|at| at.0 >= t + window)?;
        Some((later.1 - x) / (later.0 - t))
    };
    [mean, path.iter().filter_map(over).fold(0.0, f64::max)]
}
