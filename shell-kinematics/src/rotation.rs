//! Finite rotations: parallel transport of a director along a great circle.

/// Moves a unit director along the great circle of its rate and carries the rate with it.
///
/// For a director without drilling this is Rodrigues' update with `Δθ = Δt d × ḋ`, and the rate keeps
/// its length. Returns director and rate after `dt`; both are cleaned of round-off (unit length,
/// `d·ḋ = 0`).
#[inline(always)]
pub fn parallel_transport(d: [f64; 3], rate: [f64; 3], dt: f64) -> ([f64; 3], [f64; 3]) {
    let speed2 = rate[0] * rate[0] + rate[1] * rate[1] + rate[2] * rate[2];
    let t2 = speed2 * dt * dt;
    // One step turns a director by far less than a tenth of a radian unless the run is about to fail.
    let (sinc, cos) = if t2 < 0.01 {
        let sinc = 1.0 - t2 / 6.0 * (1.0 - t2 / 20.0 * (1.0 - t2 / 42.0));
        let cos = 1.0 - t2 / 2.0 * (1.0 - t2 / 12.0 * (1.0 - t2 / 30.0 * (1.0 - t2 / 56.0)));
        (sinc, cos)
    } else {
        let theta = t2.sqrt();
        let (sin, cos) = libm::sincos(theta);
        (sin / theta, cos)
    };
    let (along, back) = (sinc * dt, speed2 * sinc * dt);
    let mut new_d = [0.0; 3];
    let mut new_rate = [0.0; 3];
    for i in 0..3 {
        new_d[i] = cos * d[i] + along * rate[i];
        new_rate[i] = cos * rate[i] - back * d[i];
    }
    // The lengths are one up to round-off: one Newton step of 1/√ is exact to the last digit.
    let norm2 = new_d[0] * new_d[0] + new_d[1] * new_d[1] + new_d[2] * new_d[2];
    let scale = 1.5 - 0.5 * norm2;
    for value in &mut new_d {
        *value *= scale;
    }
    let slip = new_d[0] * new_rate[0] + new_d[1] * new_rate[1] + new_d[2] * new_rate[2];
    for i in 0..3 {
        new_rate[i] -= slip * new_d[i];
    }
    (new_d, new_rate)
}
