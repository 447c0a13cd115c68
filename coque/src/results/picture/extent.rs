//! What a picture takes: the bounds of what is seen and the ends of its colours; of the frames of a run together.

/// Parts of all values that may lie below and above the ends of the colours.
const TAIL: f64 = 0.02;
/// All values have one colour range unless it is so many times that of most of them.
const FAR: f64 = 2.0;

/// The bounds of what a picture shows, and of its values; those of several frames give all their pictures one zoom and one
/// colour range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PictureExtent {
    /// To the right and up as the viewer sees it \[L\].
    pub(super) seen: [[f64; 2]; 2],
    /// Least and greatest value.
    pub(super) all: [f64; 2],
    /// Ends that 2 % of the values lie beyond at most, on either side.
    most: [f64; 2],
}

const NONE: [f64; 2] = [f64::INFINITY, f64::NEG_INFINITY];

fn united([low, high]: [f64; 2], [lower, upper]: [f64; 2]) -> [f64; 2] {
    [low.min(lower), high.max(upper)]
}

impl PictureExtent {
    pub(super) fn of<'a>(points: impl Iterator<Item = &'a [f64; 3]>, values: &[f64]) -> Self {
        let mut seen = [NONE; 2];
        for point in points {
            for (bounds, &x) in seen.iter_mut().zip(point).filter(|(_, x)| x.is_finite()) {
                *bounds = united(*bounds, [x; 2]);
            }
        }
        let mut finite: Vec<f64> = values.iter().copied().filter(|value| value.is_finite()).collect();
        finite.sort_unstable_by(f64::total_cmp);
        let (Some(&low), Some(&high)) = (finite.first(), finite.last()) else {
            return Self { seen, all: NONE, most: NONE };
        };
        let beyond = (TAIL * finite.len() as f64) as usize;
        Self { seen, all: [low, high], most: [finite[beyond], finite[finite.len() - 1 - beyond]] }
    }

    /// The extent of two frames. Each frame gives the ends of its own values: what happens in one of forty is not an outlier.
    #[must_use]
    pub fn with(&self, other: &Self) -> Self {
        let seen = [0, 1].map(|axis| united(self.seen[axis], other.seen[axis]));
        Self { seen, all: united(self.all, other.all), most: united(self.most, other.most) }
    }

    /// Ends of the colours, and whether values lie beyond them: outliers that would leave all others one colour.
    pub fn colours(&self) -> ([f64; 2], bool) {
        let ([low, high], [lower, upper]) = (self.all, self.most);
        let few = upper > lower && high - low > FAR * (upper - lower);
        (if few { self.most } else { self.all }, few)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_outlier_does_not_set_the_colours() {
        let mut values: Vec<f64> = (0..=100).map(f64::from).collect();
        let even = PictureExtent::of([].iter(), &values);
        assert_eq!(even.colours(), ([0.0, 100.0], false));
        values[50] = 1e6;
        let struck = PictureExtent::of([].iter(), &values);
        // Two of the 101 values lie beyond either end.
        assert_eq!((struck.colours(), struck.all), (([2.0, 99.0], true), [0.0, 1e6]));
        // A thin crack is all there is to see: where most values are the same, all of them are coloured.
        let crack: Vec<f64> = (0..1000).map(|i| if i < 10 { 1.0 } else { 0.0 }).collect();
        assert_eq!(PictureExtent::of([].iter(), &crack).colours(), ([0.0, 1.0], false));
        assert_eq!(PictureExtent::of([].iter(), &[f64::NAN]).colours(), (NONE, false));
    }

    #[test]
    fn frames_have_one_extent() {
        let of =
            |x: f64, values: &[f64]| PictureExtent::of([[x, 1.0, 9.0], [f64::NAN, 2.0, 0.0]].iter(), values);
        let both = of(-1.0, &[0.0; 100]).with(&of(3.0, &(0..100).map(f64::from).collect::<Vec<_>>()));
        assert_eq!(both.seen, [[-1.0, 3.0], [1.0, 2.0]]);
        // The last of many frames, all others at rest, keeps its colours.
        let long = (0..60).fold(both, |all, _| all.with(&of(0.0, &[0.0; 100])));
        assert_eq!(long.colours(), ([0.0, 99.0], false));
    }
}
