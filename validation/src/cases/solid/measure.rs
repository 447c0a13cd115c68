//! What is measured of cracks: tips, bands and directions by the damage of nodes, and speeds.

use coque::Body;
use coque::scene::Measured;
use sph_core::Vec3;

/// Damage of a node beside a crack: a clean cut leaves about 0.4 in the first row.
const CRACKED: f64 = 0.35;

/// Cracked nodes at rest among those that `within` holds for.
pub fn cracked(body: &dyn Body, within: impl Fn(&Vec3) -> bool) -> Vec<Vec3> {
    let rest = body.configuration().rest;
    let is_cracked =
        |a: &usize| within(&rest[*a]) && body.read(Measured::Damage, *a, &Vec3::zeros()) > CRACKED;
    (0..rest.len()).filter(is_cracked).map(|a| rest[a]).collect()
}

/// Greatest x of a cracked node; none where nothing is cracked.
pub fn tip(body: &dyn Body, within: impl Fn(&Vec3) -> bool) -> Option<f64> {
    cracked(body, within).iter().map(|x| x.x).max_by(f64::total_cmp)
}

/// Of each column of a lattice from left to right: its x, and the heights of the bands of cracked nodes, ascending. A band
/// ends where three whole nodes follow.
pub fn bands(body: &dyn Body, spacing: f64, within: impl Fn(&Vec3) -> bool) -> Vec<(f64, Vec<f64>)> {
    let mut cracked = cracked(body, within);
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
pub fn direction(body: &dyn Body, tip: Vec3, near: f64, within: impl Fn(&Vec3) -> bool) -> [f64; 3] {
    let from: Vec<Vec3> = cracked(body, within).iter().map(|x| x - tip).collect();
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

/// Length of a line through points.
pub fn length(points: &[(f64, f64)]) -> f64 {
    points.windows(2).map(|w| libm::hypot(w[1].0 - w[0].0, w[1].1 - w[0].1)).sum()
}

/// Mean speed of a tip from `(time, place)`, from its first growth to its end; zero where it does not grow.
pub fn mean_speed(path: &[(f64, f64)]) -> f64 {
    let Some(first) = path.windows(2).find(|pair| pair[1].1 > pair[0].1).map(|pair| pair[0]) else {
        return 0.0;
    };
    let last = path.last().copied().unwrap_or(first);
    let end = path.iter().copied().find(|at| at.1 >= last.1).unwrap_or(last);
    (end.1 - first.1) / (end.0 - first.0)
}

/// Speeds of a tip over windows of time, with the middle of each, from `(time, place)`.
pub fn speeds(path: &[(f64, f64)], window: f64) -> Vec<(f64, f64)> {
    let over = |&(t, x): &(f64, f64)| {
        let later = path.iter().find(|at| at.0 >= t + window)?;
        Some((0.5 * (t + later.0), (later.1 - x) / (later.0 - t)))
    };
    path.iter().filter_map(over).collect()
}

/// The greatest speed over a window of time.
pub fn greatest_speed(path: &[(f64, f64)], window: f64) -> f64 {
    speeds(path, window).iter().fold(0.0, |most, at| at.1.max(most))
}
