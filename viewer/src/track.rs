//! A field over all frames, its range, and where most of its numbers lie.

use mesh_io::Array;
use serde::Serialize;

/// Share of the numbers that lie below the lower percentile, and above the upper one.
const TAIL: f64 = 0.02;
/// Parts of the range in which numbers are counted for percentiles.
const PARTS: usize = 4096;

/// A field over all frames.
#[derive(Clone, Debug)]
pub(crate) struct Track {
    pub name: String,
    pub unit: Option<String>,
    pub components: Vec<String>,
    /// Numbers a row.
    pub width: usize,
    /// All numbers of each frame, row by row.
    pub frames: Vec<Vec<f32>>,
}

/// Where numbers lie, over all frames.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(crate) struct Range {
    /// Least number.
    pub low: f64,
    /// Greatest number.
    pub high: f64,
    /// Two in a hundred are below.
    pub lower: f64,
    /// Two in a hundred are above.
    pub upper: f64,
}

impl Track {
    /// A field without frames.
    pub fn new(name: &str, array: &Array) -> Self {
        let (unit, components) = (array.unit.clone(), array.components.clone());
        Self { name: name.into(), unit, components, width: array.width, frames: Vec::new() }
    }

    /// The range of each component.
    pub fn ranges(&self) -> Vec<Range> {
        let of = |component: usize| {
            range(|| {
                self.frames
                    .iter()
                    .flat_map(move |frame| frame[component..].iter().step_by(self.width))
                    .map(|&x| x.into())
            })
        };
        (0..self.width).map(of).collect()
    }

    /// Whether a row is a vector in space, which has a length.
    pub fn is_vector(&self) -> bool {
        self.width == 3 && self.components.is_empty()
    }

    /// The range of the lengths of vectors.
    pub fn lengths(&self) -> Range {
        let length = |row: &[f32]| row.iter().map(|&x| f64::from(x) * f64::from(x)).sum::<f64>().sqrt();
        range(|| self.frames.iter().flat_map(|frame| frame.chunks_exact(3)).map(length))
    }
}

/// The range of numbers that can be asked for again; what is no number is passed over.
fn range<I: Iterator<Item = f64>>(numbers: impl Fn() -> I) -> Range {
    let finite = || numbers().filter(|x| x.is_finite());
    let (low, high) = finite().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
    if low > high {
        return Range { low: 0.0, high: 0.0, lower: 0.0, upper: 0.0 };
    }
    let width = high - low;
    if width == 0.0 {
        return Range { low, high, lower: low, upper: high };
    }
    let mut counts = vec![0_u64; PARTS];
    let mut all = 0;
    for x in finite() {
        counts[(((x - low) / width * PARTS as f64) as usize).min(PARTS - 1)] += 1;
        all += 1;
    }
    let tail = (TAIL * all as f64) as u64;
    // The end of the part beyond which no more than the tail lies.
    let cut = |counts: &mut dyn Iterator<Item = &u64>| {
        let mut seen = 0;
        counts
            .take_while(|&&count| {
                seen += count;
                seen <= tail
            })
            .count() as f64
            / PARTS as f64
            * width
    };
    let (lower, upper) = (low + cut(&mut counts.iter()), high - cut(&mut counts.iter().rev()));
    Range { low, high, lower, upper }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn track(width: usize, frames: Vec<Vec<f32>>) -> Track {
        Track { name: "a".into(), unit: None, components: Vec::new(), width, frames }
    }

    #[test]
    fn percentiles_leave_out_what_is_rare() {
        // 0 to 999, and one far out: 2 % of 1001 is 20.
        let mut numbers: Vec<f32> = (0..1000).map(|i| i as f32).collect();
        numbers.push(f32::NAN);
        let range = track(1, vec![numbers.clone(), vec![1e4]]).ranges()[0];
        assert_eq!((range.low, range.high), (0.0, 1e4));
        // A part of the range is 1e4 / 4096 = 2.4 wide.
        assert!((range.lower - 20.0).abs() < 2.5 && (range.upper - 980.0).abs() < 2.5, "{range:?}");
    }

    #[test]
    fn components_and_lengths_have_ranges_of_their_own() {
        let track = track(3, vec![vec![3.0, 0.0, 4.0], vec![0.0, -1.0, 0.0]]);
        let ranges = track.ranges();
        assert_eq!([ranges[0].high, ranges[1].low, ranges[2].high], [3.0, -1.0, 4.0]);
        let lengths = track.lengths();
        assert_eq!((lengths.low, lengths.high), (1.0, 5.0));
    }

    #[test]
    fn constants_and_nothing_have_a_range_without_width() {
        let constant = track(1, vec![vec![7.0; 5]]).ranges()[0];
        assert_eq!((constant.low, constant.upper), (7.0, 7.0));
        assert_eq!(track(1, vec![vec![f32::NAN]]).ranges()[0].high, 0.0);
    }
}
