//! How far answers on ever finer lattices are from the one that they approach.
//!
//! Answers a₁, a₂, a₃ on spacings h₁ > h₂ > h₃ with an error C hᵖ differ by
//!
//! ```text
//! |a₁ − a₂| / |a₂ − a₃| = (h₁ᵖ − h₂ᵖ)/(h₂ᵖ − h₃ᵖ),    |a₃ − a| = |a₂ − a₃| h₃ᵖ/(h₂ᵖ − h₃ᵖ)
//! ```
//!
//! which gives the order p, and with it the error of the finest, as the grid convergence index has it \[roache1994\].

/// Orders that are believed: singular loads leave the first, the methods here are of the second in what is smooth.
pub(super) const ORDERS: [f64; 2] = [0.5, 2.0];
/// Factor on an error whose order was found, and on one whose order was not, both as \[roache1994\] has them.
const SAFETY: [f64; 2] = [1.25, 3.0];

/// What answers on three lattices tell of their error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Convergence {
    /// Error on the finest of them, as a share of the answer, safety included \[–\].
    pub error: f64,
    /// Order with which it falls \[–\]: as found but at most two; one where the answers do not approach each other.
    pub order: f64,
    /// Whether the answers approach each other as a power of the spacing.
    pub regular: bool,
}

impl Convergence {
    /// Of the distances between the first and the second answer and between the second and the third, as shares of the
    /// answer; `turned` where the two steps go in opposite directions.
    pub fn of([h1, h2, h3]: [f64; 3], [first, second]: [f64; 2], turned: bool) -> Self {
        let order = if turned { None } else { order([h1, h2, h3], [first, second]) };
        let Some(order) = order else {
            return Self { error: SAFETY[1] * first.max(second), order: 1.0, regular: false };
        };
        let share = 1.0 / (libm::pow(h2 / h3, order) - 1.0);
        Self { error: SAFETY[0] * share * second, order, regular: true }
    }

    /// The spacing at which the error is so large, over the finest of the three.
    pub fn spacing_for(&self, error: f64) -> f64 {
        libm::pow(error / self.error, 1.0 / self.order)
    }
}

/// The order with which two differences in a row fall, of answers on spacings h₁ > h₂ > h₃: two at most, none below one half.
pub(super) fn order(spacings: [f64; 3], differences: [f64; 2]) -> Option<f64> {
    order_within(ORDERS, spacings, differences)
}

/// The same between other bounds, the greatest where it is beyond.
pub(super) fn order_within(
    bounds: [f64; 2],
    [h1, h2, h3]: [f64; 3],
    [first, second]: [f64; 2],
) -> Option<f64> {
    let ratio = |p: f64| (libm::pow(h1, p) - libm::pow(h2, p)) / (libm::pow(h2, p) - libm::pow(h3, p));
    let [mut low, mut high] = bounds;
    if first < ratio(low) * second {
        return None;
    }
    if first >= ratio(high) * second {
        low = high;
    }
    // The ratio grows with the order; sixty halvings leave nothing of the bracket.
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if ratio(middle) * second <= first {
            low = middle;
        } else {
            high = middle;
        }
    }
    Some(low)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Distances between answers with the error C hᵖ.
    fn distances(h: [f64; 3], p: f64, c: f64) -> [f64; 2] {
        let error = h.map(|h| c * libm::pow(h, p));
        [error[0] - error[1], error[1] - error[2]]
    }

    #[test]
    fn a_power_of_the_spacing_is_found_again() {
        let h = [0.25, 0.17, 0.125];
        for (p, c) in [(0.7, 0.02), (1.0, 3.0), (1.6, 0.5), (2.0, 1.0)] {
            let found = Convergence::of(h, distances(h, p, c), false);
            let error = SAFETY[0] * c * libm::pow(h[2], p);
            assert!(found.regular, "{found:?}");
            assert!((found.order - p).abs() < 1e-9 && (found.error / error - 1.0).abs() < 1e-9, "{found:?}");
            // Twice as fine as the place where the error is what was asked leaves 2⁻ᵖ of it.
            let spacing = h[2] * found.spacing_for(0.5 * error);
            assert!((SAFETY[0] * c * libm::pow(spacing, p) / (0.5 * error) - 1.0).abs() < 1e-9);
        }
    }

    #[test]
    fn what_falls_faster_than_the_second_order_is_not_believed_to() {
        let h = [0.25, 0.17, 0.125];
        let found = Convergence::of(h, distances(h, 4.0, 1.0), false);
        assert_eq!((found.order, found.regular), (2.0, true));
        assert!(found.error > libm::pow(h[2], 4.0));
    }

    #[test]
    fn what_does_not_approach_counts_three_times_its_last_steps() {
        let h = [0.25, 0.17, 0.125];
        for (steps, turned) in [([0.01, 0.02], false), ([0.02, 0.01], true), ([0.01, 0.0099], false)] {
            let found = Convergence::of(h, steps, turned);
            assert_eq!((found.order, found.regular), (1.0, false));
            assert_eq!(found.error, 3.0 * steps[0].max(steps[1]));
        }
    }

    #[test]
    fn answers_that_do_not_differ_have_no_error() {
        let found = Convergence::of([4.0, 2.0, 1.0], [0.0, 0.0], false);
        assert_eq!((found.error, found.regular), (0.0, true));
    }
}
