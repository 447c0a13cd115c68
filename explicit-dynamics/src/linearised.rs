//! A system in mass-scaled coordinates `M^½ q`, in which degrees of freedom of any unit become alike.

/// A system whose mass-scaled tangent can be applied to a vector.
pub trait LinearisedDynamics {
    /// Length of the vectors.
    fn unknowns(&self) -> usize;

    /// `out = M^{-½} K M^{-½} v` at the present configuration; symmetric.
    fn apply(&mut self, v: &[f64], out: &mut [f64]);

    /// `a·b`. A system of which others march parts adds over all of them.
    fn dot(&mut self, a: &[f64], b: &[f64]) -> f64 {
        a.iter().zip(b).map(|(x, y)| x * y).sum()
    }
}

/// A system that tells how far from rest it is, in vectors of [`LinearisedDynamics::unknowns`].
pub trait MassScaled: LinearisedDynamics {
    /// `out = M^{-½} (external − internal)` of the last forces evaluated, without what supports bear.
    fn out_of_balance(&self, out: &mut [f64]);

    /// `out = M^½ v`, the velocities.
    fn rates(&self, out: &mut [f64]);

    /// `‖M^½ u‖`, the displacement from the reference configuration \[M^½ L\].
    fn displaced(&self) -> f64;
}
