//! A curve y(x) given by points: interpolation, turning points, and the distance to another curve.

use crate::error::ReferenceError;
use std::cmp::Ordering;
use std::ops::RangeBounds;

/// A polyline y(x) with growing x; units are those of the columns it was made from.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    x: Vec<f64>,
    y: Vec<f64>,
}

/// A turning point, or the place of a largest difference.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extremum {
    /// Where it lies, in the unit of the abscissa.
    pub x: f64,
    /// Its value, in the unit of the ordinate.
    pub y: f64,
}

impl Curve {
    /// A curve through the points (x, y); x has to grow strictly, and every value has to be finite.
    pub fn new(x: Vec<f64>, y: Vec<f64>) -> Result<Self, ReferenceError> {
        if x.len() != y.len() || x.len() < 2 {
            return Err(ReferenceError::BadLength { x: x.len(), y: y.len() });
        }
        let mut previous = f64::NEG_INFINITY;
        for (index, (&x, &y)) in x.iter().zip(&y).enumerate() {
            if !(x.is_finite() && y.is_finite() && x > previous) {
                return Err(ReferenceError::NotGrowing { index, x, y, previous });
            }
            previous = x;
        }
        Ok(Self { x, y })
    }

    /// The abscissae.
    pub fn x(&self) -> &[f64] {
        &self.x
    }

    /// The ordinates.
    pub fn y(&self) -> &[f64] {
        &self.y
    }

    /// The ordinate at `x`, linear between the points; the curve is never continued beyond its ends.
    pub fn at(&self, x: f64) -> Result<f64, ReferenceError> {
        let (first, last) = self.span();
        if !(first <= x && x <= last) {
            return Err(ReferenceError::OutOfRange { x, first, last });
        }
        let right = self.x.partition_point(|&abscissa| abscissa < x).max(1);
        let (x0, x1) = (self.x[right - 1], self.x[right]);
        let (y0, y1) = (self.y[right - 1], self.y[right]);
        let s = (x - x0) / (x1 - x0);
        Ok((1.0 - s) * y0 + s * y1)
    }

    /// The maximum over the points with x in `range`, by the parabola through the largest and its two neighbours.
    ///
    /// On a load–deflection curve this is the limit point. The range matters: a snap-through curve ends higher
    /// than its limit load, and a dynamic one may ripple. A largest value at an end of the range is an error.
    pub fn maximum(&self, range: impl RangeBounds<f64>) -> Result<Extremum, ReferenceError> {
        self.turning_point("maximum", range, f64::total_cmp)
    }

    /// The minimum over the points with x in `range`, found as [`Curve::maximum`] is.
    pub fn minimum(&self, range: impl RangeBounds<f64>) -> Result<Extremum, ReferenceError> {
        self.turning_point("minimum", range, |a, b| b.total_cmp(a))
    }

    /// The largest |self − reference| over the reference's points with x in `range`, and where it occurs.
    ///
    /// The reference is taken at its own points, so that its interpolation adds no error.
    pub fn max_difference(
        &self,
        reference: &Self,
        range: impl RangeBounds<f64>,
    ) -> Result<Extremum, ReferenceError> {
        let mut worst: Option<Extremum> = None;
        for (&x, &y) in reference.x.iter().zip(&reference.y).filter(|(x, _)| range.contains(x)) {
            let difference = (self.at(x)? - y).abs();
            if worst.is_none_or(|worst| difference > worst.y) {
                worst = Some(Extremum { x, y: difference });
            }
        }
        let (first, last) = reference.span();
        worst.ok_or(ReferenceError::EmptyRange { first, last })
    }

    fn span(&self) -> (f64, f64) {
        (self.x[0], self.x[self.x.len() - 1])
    }

    fn turning_point(
        &self,
        kind: &'static str,
        range: impl RangeBounds<f64>,
        order: impl Fn(&f64, &f64) -> Ordering,
    ) -> Result<Extremum, ReferenceError> {
        let inside: Vec<usize> = (0..self.x.len()).filter(|&i| range.contains(&self.x[i])).collect();
        let (first, last) = self.span();
        let best = inside.iter().copied().max_by(|&a, &b| order(&self.y[a], &self.y[b]));
        let best = best.ok_or(ReferenceError::EmptyRange { first, last })?;
        if best == inside[0] || best == inside[inside.len() - 1] {
            return Err(ReferenceError::ExtremumAtEdge { kind, x: self.x[best], y: self.y[best] });
        }
        Ok(self.parabola_vertex(best))
    }

    /// The vertex of the parabola through the points i − 1, i, i + 1, by Newton's divided differences:
    /// y = y₀ + a (x − x₀) + b (x − x₀)(x − x₁), y' = 0 at x = (x₀ + x₁ − a/b)/2.
    ///
    /// Of equal extreme values the last one is taken, so the next ordinate differs and b is never zero.
    fn parabola_vertex(&self, i: usize) -> Extremum {
        let (x0, x1, x2) = (self.x[i - 1], self.x[i], self.x[i + 1]);
        let (y0, y1, y2) = (self.y[i - 1], self.y[i], self.y[i + 1]);
        let a = (y1 - y0) / (x1 - x0);
        let b = ((y2 - y1) / (x2 - x1) - a) / (x2 - x0);
        let x = 0.5 * (x0 + x1 - a / b);
        Extremum { x, y: y0 + (x - x0) * (a + b * (x - x1)) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn parabola() -> Curve {
        // y = 5 − (x − 2.2)², on uneven points: the fit through three of them is exact
        let x = vec![0.0, 0.7, 1.9, 2.4, 3.7, 4.0];
        let y = x.iter().map(|x| 5.0 - (x - 2.2_f64).powi(2)).collect();
        Curve::new(x, y).unwrap()
    }

    #[test]
    fn interpolates_linearly_and_hits_its_points() {
        let curve = Curve::new(vec![0.0, 1.0, 3.0], vec![1.0, 2.0, -2.0]).unwrap();
        assert_eq!(curve.at(0.0).unwrap(), 1.0);
        assert_eq!(curve.at(0.25).unwrap(), 1.25);
        assert_eq!(curve.at(1.0).unwrap(), 2.0);
        assert_eq!(curve.at(2.0).unwrap(), 0.0);
        assert_eq!(curve.at(3.0).unwrap(), -2.0);
        assert!(matches!(curve.at(3.1), Err(ReferenceError::OutOfRange { .. })));
        assert!(matches!(curve.at(f64::NAN), Err(ReferenceError::OutOfRange { .. })));
    }

    #[test]
    fn refuses_what_is_no_curve() {
        assert!(matches!(Curve::new(vec![0.0], vec![1.0]), Err(ReferenceError::BadLength { .. })));
        assert!(matches!(Curve::new(vec![0.0, 1.0], vec![1.0]), Err(ReferenceError::BadLength { .. })));
        for x in [vec![0.0, 1.0, 1.0], vec![0.0, 2.0, 1.0], vec![0.0, 1.0, f64::NAN]] {
            let error = Curve::new(x, vec![0.0; 3]).unwrap_err();
            assert!(matches!(error, ReferenceError::NotGrowing { index: 2, .. }), "{error}");
        }
    }

    #[test]
    fn finds_the_vertex_of_a_parabola_exactly() {
        let top = parabola().maximum(..).unwrap();
        assert_relative_eq!(top.x, 2.2, epsilon = 1e-13);
        assert_relative_eq!(top.y, 5.0, epsilon = 1e-13);
        let upside_down =
            Curve::new(parabola().x.clone(), parabola().y.iter().map(|y| -y).collect()).unwrap();
        let bottom = upside_down.minimum(..).unwrap();
        assert_relative_eq!(bottom.x, 2.2, epsilon = 1e-13);
        assert_relative_eq!(bottom.y, -5.0, epsilon = 1e-13);
    }

    #[test]
    fn an_extremum_at_the_edge_of_the_range_is_refused() {
        let curve = parabola();
        assert!(matches!(curve.maximum(..=1.9), Err(ReferenceError::ExtremumAtEdge { kind: "maximum", .. })));
        assert!(matches!(curve.minimum(..), Err(ReferenceError::ExtremumAtEdge { kind: "minimum", .. })));
        assert!(matches!(curve.maximum(5.0..), Err(ReferenceError::EmptyRange { .. })));
    }

    #[test]
    fn a_plateau_has_its_vertex_near_its_end() {
        // through (2, 1), (3, 1), (4, 0): vertex at 2.5, an eighth above the plateau
        let curve = Curve::new(vec![0.0, 1.0, 2.0, 3.0, 4.0], vec![0.0, 1.0, 1.0, 1.0, 0.0]).unwrap();
        assert_eq!(curve.maximum(..).unwrap(), Extremum { x: 2.5, y: 1.125 });
    }

    #[test]
    fn measures_the_largest_difference_at_the_reference_points() {
        let curve = Curve::new(vec![0.0, 4.0], vec![0.0, 4.0]).unwrap();
        let reference = Curve::new(vec![0.0, 1.0, 2.0, 3.0], vec![0.0, 1.5, 2.0, 2.2]).unwrap();
        let worst = curve.max_difference(&reference, ..).unwrap();
        assert_relative_eq!(worst.x, 3.0);
        assert_relative_eq!(worst.y, 0.8, epsilon = 1e-14);
        assert_relative_eq!(curve.max_difference(&reference, ..=2.0).unwrap().y, 0.5);
        assert!(matches!(reference.max_difference(&curve, ..), Err(ReferenceError::OutOfRange { .. })));
        assert!(matches!(curve.max_difference(&reference, 3.5..), Err(ReferenceError::EmptyRange { .. })));
    }
}
