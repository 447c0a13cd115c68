//! Finite rotations: parallel transport of a director along a great circle.

use crate::pack::Number;

/// θ² \[rad²\] below which series of four terms are exact to the last digit.
const SMALL: f64 = 0.01;

/// Moves a unit director along the great circle of its rate and carries the rate with it.
///
/// For a director without drilling this is Rodrigues' update with `Δθ = Δt d × ḋ`, and the rate keeps
/// its length. Returns director and rate after `dt`; both are cleaned of round-off (unit length,
/// `d·ḋ = 0`).
#[inline(always)]
pub fn parallel_transport<N: Number>(d: [N; 3], rate: [N; 3], dt: f64) -> ([N; 3], [N; 3]) {
    let speed2 = rate[0] * rate[0] + rate[1] * rate[1] + rate[2] * rate[2];
    let t2 = speed2 * dt * dt;
    // One step turns a director by far less than a tenth of a radian unless the run is about to fail.
    let [sinc, cos] = if t2.below(SMALL) { small(t2) } else { any(t2) };
    let (along, back) = (sinc * dt, speed2 * sinc * dt);
    let (mut new_d, mut new_rate) = (d, rate);
    for i in 0..3 {
        new_d[i] = cos * d[i] + along * rate[i];
        new_rate[i] = cos * rate[i] - back * d[i];
    }
    // The lengths are one up to round-off: one Newton step of 1/√ is exact to the last digit.
    let norm2 = new_d[0] * new_d[0] + new_d[1] * new_d[1] + new_d[2] * new_d[2];
    let scale = norm2.all(1.5) - norm2 * 0.5;
    for value in &mut new_d {
        *value = *value * scale;
    }
    let slip = new_d[0] * new_rate[0] + new_d[1] * new_rate[1] + new_d[2] * new_rate[2];
    for i in 0..3 {
        new_rate[i] = new_rate[i] - slip * new_d[i];
    }
    (new_d, new_rate)
}

/// `sin θ/θ` and `cos θ` from `θ² < 0.01`, by their series.
#[inline(always)]
fn small<N: Number>(t2: N) -> [N; 2] {
    let one = t2.all(1.0);
    let [mut sinc, mut cos] = [one; 2];
    for divisor in [42.0, 20.0, 6.0] {
        sinc = one - t2 * (1.0 / divisor) * sinc;
    }
    for divisor in [56.0, 30.0, 12.0, 2.0] {
        cos = one - t2 * (1.0 / divisor) * cos;
    }
    [sinc, cos]
}

/// The same from any θ²: each number as it would be by itself.
#[cold]
#[inline(never)]
fn any<N: Number>(t2: N) -> [N; 2] {
    let of = |t2: f64| {
        if t2 < SMALL {
            return small(t2);
        }
        let theta = t2.sqrt();
        let (sin, cos) = libm::sincos(theta);
        [sin / theta, cos]
    };
    [t2.each(|t2| of(t2)[0]), t2.each(|t2| of(t2)[1])]
}
