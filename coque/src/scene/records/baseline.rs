//! A straight line taken off an acceleration, so that what it moves from rest ends at rest where it began.

/// Takes `c₀ + c₁ s` off the numbers, s the time from the first: velocity and displacement at the last time, integrated from rest along the straight lines between
/// the points, are zero then. One point stays as it is.
pub(super) fn straighten(points: &mut [[f64; 2]]) {
    let (Some(&[start, _]), Some(&[end, _])) = (points.first(), points.last()) else { return };
    let length = end - start;
    if length <= 0.0 {
        return;
    }
    let [velocity, displacement] = ends(points);
    // c₀ T + c₁ T²/2 = v,  c₀ T²/2 + c₁ T³/6 = u.
    let (v, u) = (velocity / length, displacement / (length * length));
    let (constant, slope) = (6.0 * u - 2.0 * v, (6.0 * v - 12.0 * u) / length);
    points.iter_mut().for_each(|[t, x]| *x -= constant + slope * (*t - start));
}

/// Velocity and displacement at the last time.
fn ends(points: &[[f64; 2]]) -> [f64; 2] {
    points.windows(2).fold([0.0; 2], |[v, u], pair| {
        let [[t0, a0], [t1, a1]] = [pair[0], pair[1]];
        let h = t1 - t0;
        [v + h * 0.5 * (a0 + a1), u + h * (v + h * (2.0 * a0 + a1) / 6.0)]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_ends_at_rest_where_it_began() {
        let mut points: Vec<[f64; 2]> =
            (0..40).map(|i| [1.0 + 0.1 * f64::from(i), libm::sin(0.7 * f64::from(i)) + 0.3]).collect();
        let before = ends(&points);
        straighten(&mut points);
        let after = ends(&points);
        assert!(before[1] > 1.0 && after.iter().all(|x| x.abs() < 1e-13), "{before:?} {after:?}");
        // A straight line goes altogether; a correction of what needs none changes nothing.
        let mut line: Vec<[f64; 2]> = (0..5).map(|i| [f64::from(i), 2.0 - f64::from(i)]).collect();
        straighten(&mut line);
        assert!(line.iter().all(|[_, x]| x.abs() < 1e-14), "{line:?}");
    }
}
