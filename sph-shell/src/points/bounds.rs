//! The range of the model: no point turned inside out, stretched or crushed out of all proportion.

use std::ops::Range;

use shell_kinematics::LANES;

use crate::formulation::{Formulation, Reach};
use crate::packs::Row;
use crate::points::point::Point;
use crate::points::scheme::Points;
use crate::reference::Reference;

/// Least and greatest principal stretch of the mid-surface.
///
/// Sections are linear laws for small strains at constant thickness. By their own Poisson's ratio ν the thickness is gone
/// when `ε₁ + ε₂ = (1 − ν)/ν`, along one axis at a stretch of 1 + 1/ν: 4.3 for ν = 0.3, 10 for ν = 0.11. Pressed below
/// 1/√3, Green–Lagrange strains give less force again. A tenth and ten times are well beyond both.
const STRETCHES: (f64, f64) = (0.1, 10.0);

/// What is wrong with a sampling point.
pub(crate) struct BoundViolation {
    /// The point, by number and place.
    pub place: String,
    /// The quantity.
    pub what: &'static str,
    /// What it is.
    pub value: f64,
    /// What it must be.
    pub bound: &'static str,
}

impl Points {
    /// The first sampling point of a range of packs beyond the range of the model.
    ///
    /// `J = (x,1 × x,2)·d` is the area over that of the reference where the director is normal; not positive, the surface
    /// is folded through itself or its director lies in it.
    pub(crate) fn first_bound_violation(
        &self,
        reference: &Reference,
        state: &[Row],
        among: Range<usize>,
    ) -> Option<BoundViolation> {
        let packs = &self.packs;
        for (index, points) in packs.order.iter().enumerate().take(among.end).skip(among.start) {
            let (p, _) = Point::new(packs, index).treated().interpolate::<false>(state);
            let area = p.x1.cross(p.x2).dot(p.d).lanes();
            let squares = [p.x1.dot(p.x1), p.x2.dot(p.x2), p.x1.dot(p.x2)].map(|c| c.lanes());
            for lane in 0..LANES {
                let [c11, c22, c12] = squares.map(|c| c[lane]);
                let (mean, half) = (0.5 * (c11 + c22), 0.5 * (c11 - c22));
                let spread = (half * half + c12 * c12).sqrt();
                // Not a number is beyond every bound.
                let (least, most) = (mean - spread, mean + spread);
                let (low, high) = STRETCHES;
                if area[lane] > 0.0 && least > low * low && most < high * high {
                    continue;
                }
                let (what, value, bound) = if area[lane].is_nan() || area[lane] <= 0.0 {
                    (
                        "the area, signed, over that of the start,",
                        area[lane],
                        "above 0: it is turned inside out",
                    )
                } else if most < high * high {
                    ("the least stretch", least.max(0.0).sqrt(), "above 0.1")
                } else {
                    ("the greatest stretch", most.sqrt(), "below 10")
                };
                return Some(BoundViolation {
                    place: self.name_point(reference, points[lane] as usize),
                    what,
                    value,
                    bound,
                });
            }
        }
        None
    }

    /// A sampling point by number and place, for messages.
    fn name_point(&self, reference: &Reference, point: usize) -> String {
        let kind = match self.formulation {
            Formulation::StressPoint(Reach::Cell) => "cell",
            Formulation::StressPoint(Reach::Kernel(..)) => "the point of cell",
            _ => "particle",
        };
        let x = reference.from_zero(reference.operator.points[point].position);
        format!("{kind} {point} at ({:.4}, {:.4}, {:.4})", x.x, x.y, x.z)
    }
}
