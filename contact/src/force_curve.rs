//! A force by an elongation, straight between the points of a table and beyond its ends.

/// A force by an elongation, none at elongation zero, with its energy exactly.
///
/// Between two points and beyond the first and the last of them the force is straight: `f = f₀ + s (e − e₀)`, `U = U₀ + ½ (f₀ + f)(e − e₀)`. On a
/// point the steeper of both slopes counts.
#[derive(Clone, Debug, PartialEq)]
pub struct ForceCurve {
    /// Elongation, force and energy, by ascending elongation, one at least \[L, F, F L\].
    knots: Vec<[f64; 3]>,
    /// Slopes before the first knot, between neighbours, and behind the last \[F/L\].
    slopes: Vec<f64>,
}

/// What a curve has at an elongation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnCurve {
    /// Force, positive where it pulls \[F\].
    pub force: f64,
    /// Slope of the force \[F/L\].
    pub slope: f64,
    /// Energy from elongation zero on \[F L\].
    pub energy: f64,
}

/// To which side a link bears.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bears {
    /// It pulls: no force where it is not longer than at rest.
    Tension,
    /// It pushes: no force where it is not shorter.
    Compression,
    /// Both.
    Both,
}

impl ForceCurve {
    /// A curve through elongations and forces \[L, F\], beyond both ends as before them; none if there are fewer than two, elongations do not ascend,
    /// or the force at elongation zero is not zero to 1e-12 of the greatest.
    pub fn through(points: &[[f64; 2]]) -> Option<Self> {
        if points.len() < 2 || points.windows(2).any(|pair| pair[1][0] <= pair[0][0]) {
            return None;
        }
        let slope = |pair: &[[f64; 2]]| (pair[1][1] - pair[0][1]) / (pair[1][0] - pair[0][0]);
        let inner: Vec<f64> = points.windows(2).map(slope).collect();
        let slopes = [&inner[..1], &inner, &inner[inner.len() - 1..]].concat();
        let mut curve = Self { knots: points.iter().map(|&[e, f]| [e, f, 0.0]).collect(), slopes };
        for i in 1..points.len() {
            let ([e, f], [e1, f1]) = (points[i - 1], points[i]);
            curve.knots[i][2] = curve.knots[i - 1][2] + 0.5 * (f + f1) * (e1 - e);
        }
        let OnCurve { force, energy, .. } = curve.at(0.0);
        curve.knots.iter_mut().for_each(|knot| knot[2] -= energy);
        let greatest = points.iter().map(|point| point[1].abs()).fold(0.0, f64::max);
        (force.abs() <= 1e-12 * greatest).then_some(curve)
    }

    /// A spring of one stiffness \[F/L\] that bears to a side from an elongation of this size on: before it there is no force \[L\].
    pub fn spring(stiffness: f64, bears: Bears, gap: f64) -> Self {
        let (knots, slopes) = match bears {
            Bears::Tension => (vec![gap], vec![0.0, stiffness]),
            Bears::Compression => (vec![-gap], vec![stiffness, 0.0]),
            Bears::Both if gap == 0.0 => (vec![0.0], vec![stiffness; 2]),
            Bears::Both => (vec![-gap, gap], vec![stiffness, 0.0, stiffness]),
        };
        Self { knots: knots.into_iter().map(|e| [e, 0.0, 0.0]).collect(), slopes }
    }

    /// What it has at an elongation \[L\].
    pub fn at(&self, elongation: f64) -> OnCurve {
        let after = self.knots.partition_point(|knot| knot[0] <= elongation);
        let [e, f, u] = self.knots[after.saturating_sub(1)];
        let slope = self.slopes[after];
        let force = f + slope * (elongation - e);
        let energy = u + 0.5 * (f + force) * (elongation - e);
        let before = self.slopes[after.saturating_sub(1)];
        let steeper = elongation == e && before.abs() > slope.abs();
        OnCurve { force, slope: if steeper { before } else { slope }, energy }
    }

    /// The greatest size of its slopes \[F/L\]: `|f| ≤ s |e|` and, of a link between two places, `|f| ≤ s` times their distance where it pulls.
    pub fn steepest(&self) -> f64 {
        self.slopes.iter().map(|slope| slope.abs()).fold(0.0, f64::max)
    }
}

/// Times that a jump of the slope counts: steps are a fifth of those of the slope, since where in a step a stop is met is a part of its energy; a mass that goes to
/// and fro between the stiffest ones keeps it to 3 % over ten rounds.
const KINK: f64 = 25.0;

impl ForceCurve {
    /// The stiffness that the step in time has to be short enough for \[F/L\]: the steepest slope, and more where slopes jump.
    pub fn pace(&self) -> f64 {
        let jump = self.slopes.windows(2).map(|pair| (pair[1] - pair[0]).abs()).fold(0.0, f64::max);
        self.steepest().max(KINK * jump)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The trapezium is exact between two points: energies are sums of those of parts by hand.
    #[test]
    fn a_table_has_forces_between_and_beyond_its_points_and_their_energy() {
        let curve = ForceCurve::through(&[[-1.0, -3.0], [0.0, 0.0], [1.0, 1.0], [2.0, 5.0]]).unwrap();
        for (e, force, slope, energy) in [
            (0.5, 0.5, 1.0, 0.125),
            (1.5, 3.0, 4.0, 0.5 + 1.0),
            (3.0, 9.0, 4.0, 0.5 + 3.0 + 7.0),
            (-2.0, -6.0, 3.0, 6.0),
            (0.0, 0.0, 3.0, 0.0),
            (1.0, 1.0, 4.0, 0.5),
            (2.0, 5.0, 4.0, 3.5),
        ] {
            assert_eq!(curve.at(e), OnCurve { force, slope, energy }, "{e}");
        }
        assert_eq!(curve.steepest(), 4.0);
        assert!(ForceCurve::through(&[[0.0, 0.0]]).is_none());
        assert!(ForceCurve::through(&[[0.0, 0.0], [0.0, 1.0]]).is_none());
        assert!(ForceCurve::through(&[[0.0, 0.5], [1.0, 1.0]]).is_none());
        // Zero lies on no point, and beyond the first.
        assert!(ForceCurve::through(&[[-1.0, -2.0], [1.0, 2.0]]).is_some());
        assert_eq!(ForceCurve::through(&[[1.0, 2.0], [2.0, 4.0]]).unwrap().at(1.0).energy, 1.0);
    }

    #[test]
    fn springs_bear_to_their_side_and_behind_their_gap() {
        let at = |bears, gap, e: f64| {
            let OnCurve { force, slope, energy } = ForceCurve::spring(3.0, bears, gap).at(e);
            [force, slope, energy]
        };
        assert_eq!(at(Bears::Both, 0.0, -0.2), [-0.6000000000000001, 3.0, 0.06000000000000001]);
        assert_eq!(at(Bears::Tension, 0.0, -0.2), [0.0, 0.0, 0.0]);
        assert_eq!(at(Bears::Tension, 0.0, -9.0), [0.0, 0.0, 0.0]);
        assert_eq!(at(Bears::Tension, 0.0, 2.0), [6.0, 3.0, 6.0]);
        assert_eq!(at(Bears::Compression, 0.0, 2.0), [0.0, 0.0, 0.0]);
        assert_eq!(at(Bears::Compression, 0.5, -2.5), [-6.0, 3.0, 6.0]);
        assert_eq!(at(Bears::Both, 0.5, 0.25), [0.0, 0.0, 0.0]);
        assert_eq!(at(Bears::Both, 0.5, -0.25), [0.0, 0.0, 0.0]);
        assert_eq!(at(Bears::Tension, 0.0, 0.0), [0.0, 3.0, 0.0]);
        assert_eq!(at(Bears::Both, 0.5, 2.5), [6.0, 3.0, 6.0]);
    }
}
