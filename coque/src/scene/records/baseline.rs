//! A straight line taken off an acceleration, so that what it moves from rest ends at rest where it began.

use explicit_dynamics::Amplitude;

/// Fewest points, the closing one among them: two numbers are taken off the others.
pub(super) const FEWEST: usize = 3;

/// Part of the product of their sizes below which the two conditions are taken for one.
const SINGULAR: f64 = 1e-9;

/// Adds the point that brings a course to zero, one step behind its last; none where it ends there.
pub(super) fn close(points: &mut Vec<[f64; 2]>) {
    if let [.., [before, _], [end, last]] = points[..]
        && last != 0.0
    {
        points.push([end + (end - before), 0.0]);
    }
}

/// Takes `c₀ + c₁ s` off all numbers but the last, which is zero and stays so; s is the time from the first over that to the last. Velocity and displacement at
/// the last time, integrated from rest at time zero along the straight lines between the points, are zero then. None, and nothing taken off, where no such line
/// is to be found: too few points, or none after time zero.
pub(super) fn straighten(points: &mut [[f64; 2]]) -> Option<()> {
    let (&[start, _], &[end, _]) = (points.first()?, points.last()?);
    if points.len() < FEWEST || end <= 0.0 {
        return None;
    }
    let place = |t: f64| (t - start) / (end - start);
    let last = points.len() - 1;
    let of = |numbers: &dyn Fn(usize, [f64; 2]) -> f64| {
        let course = points.iter().enumerate();
        let course =
            course.map(|(i, &[t, x])| [t, if i < last { numbers(i, [t, x]) } else { 0.0 }]).collect();
        let [velocity, displacement] = Amplitude::Table(course).integrals(end);
        [velocity / end, displacement / (end * end)]
    };
    let [one, line, own] = [of(&|_, _| 1.0), of(&|_, [t, _]| place(t)), of(&|_, [_, x]| x)];
    let [cross, size] = [one[0] * line[1], line[0] * one[1]];
    let determinant = cross - size;
    if determinant.abs() <= SINGULAR * (cross.abs() + size.abs()) {
        return None;
    }
    let constant = (own[0] * line[1] - own[1] * line[0]) / determinant;
    let slope = (one[0] * own[1] - one[1] * own[0]) / determinant;
    points[..last].iter_mut().for_each(|[t, x]| *x -= constant + slope * place(*t));
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Greatest of what is left of velocity and displacement, over what the same numbers would make without signs.
    fn left(points: &[[f64; 2]]) -> f64 {
        let end = points.last().unwrap()[0];
        let most = points.iter().fold(0.0_f64, |most, [_, x]| most.max(x.abs()));
        let [v, u] = Amplitude::Table(points.to_vec()).integrals(end);
        (v / (most * end)).abs().max((u / (most * end * end)).abs())
    }

    /// From time zero, from before and from after it, where a course is what it is at its first point; ending at zero or not.
    #[test]
    fn it_ends_at_rest_where_it_began() {
        for (begin, lift) in [(0.0, 0.3), (1.0, 0.3), (-0.55, 0.3), (0.0, 0.0)] {
            let mut points: Vec<[f64; 2]> =
                (0..40).map(|i| [begin + 0.1 * f64::from(i), libm::sin(0.7 * f64::from(i)) + lift]).collect();
            if lift == 0.0 {
                points.last_mut().unwrap()[1] = 0.0;
            }
            close(&mut points);
            assert_eq!(points.len(), if lift == 0.0 { 40 } else { 41 });
            let before = left(&points);
            assert!(straighten(&mut points).is_some());
            // Sums of forty numbers.
            assert!(before > 1e-3 && left(&points) < 1e-14, "{begin}: {before} {}", left(&points));
            assert_eq!(points.last().unwrap()[1], 0.0);
            // A correction of what needs none changes nothing.
            let once = points.clone();
            assert!(straighten(&mut points).is_some());
            assert!(points.iter().zip(&once).all(|(a, b)| (a[1] - b[1]).abs() < 1e-13));
        }
    }

    #[test]
    fn a_straight_line_goes_altogether_and_two_points_have_none() {
        let mut line: Vec<[f64; 2]> = (0..5).map(|i| [f64::from(i), 2.0 - f64::from(i)]).collect();
        close(&mut line);
        assert!(straighten(&mut line).is_some() && line.iter().all(|[_, x]| x.abs() < 1e-13), "{line:?}");
        let mut two = [[0.0, 1.0], [1.0, 0.0]];
        assert!(straighten(&mut two).is_none() && two == [[0.0, 1.0], [1.0, 0.0]]);
        assert!(straighten(&mut [[-3.0, 1.0], [-2.0, 1.0], [-1.0, 0.0]]).is_none());
    }
}
