//! Numbers to text: shares of their range in 16 bits, differences between frames, byte planes, deflate, base64.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use miniz_oxide::deflate::compress_to_vec;

use crate::track::{Range, Track};

/// The share that stands for no number.
const NONE: u16 = u16::MAX;
/// Steps of a range.
const STEPS: f64 = 65534.0;
/// Effort of the compression, of 10: beyond it a page gets 2 % smaller and takes twice as long.
const EFFORT: u8 = 4;

/// A number as a share of a range.
fn share(x: f32, range: &Range) -> u16 {
    let (x, width) = (f64::from(x), range.high - range.low);
    match (x.is_finite(), width > 0.0) {
        (false, _) => NONE,
        (true, false) => 0,
        (true, true) => ((x - range.low) / width * STEPS).round() as u16,
    }
}

/// One frame of a track: component after component, the difference to the frame before in 16 bits, the low bytes of all,
/// then the high ones.
pub(crate) fn frame(track: &Track, ranges: &[Range], number: usize) -> String {
    let (width, present) = (track.width, &track.frames[number]);
    let before = number.checked_sub(1).map(|before| &track.frames[before]);
    let count = present.len();
    let mut planes = vec![0; 2 * count];
    let (low, high) = planes.split_at_mut(count);
    let mut at = 0;
    for (component, range) in ranges.iter().enumerate() {
        for i in (component..count).step_by(width) {
            let word = share(present[i], range).wrapping_sub(before.map_or(0, |row| share(row[i], range)));
            [low[at], high[at]] = word.to_le_bytes();
            at += 1;
        }
    }
    text(&planes)
}

/// Whole numbers: the difference to the one before, in four planes of bytes.
pub(crate) fn whole(numbers: impl ExactSizeIterator<Item = u32>) -> String {
    let mut before = 0;
    four(numbers.map(|number| {
        let word = number.wrapping_sub(before);
        before = number;
        word
    }))
}

/// Numbers in single precision, in four planes of bytes.
pub(crate) fn single(numbers: impl ExactSizeIterator<Item = f32>) -> String {
    four(numbers.map(f32::to_bits))
}

fn four(words: impl ExactSizeIterator<Item = u32>) -> String {
    let count = words.len();
    let mut planes = vec![0; 4 * count];
    for (i, word) in words.enumerate() {
        for (plane, byte) in word.to_le_bytes().into_iter().enumerate() {
            planes[plane * count + i] = byte;
        }
    }
    text(&planes)
}

fn text(bytes: &[u8]) -> String {
    STANDARD.encode(compress_to_vec(bytes, EFFORT))
}

#[cfg(test)]
mod tests {
    use super::*;
    use miniz_oxide::inflate::decompress_to_vec;

    fn bytes(text: &str) -> Vec<u8> {
        decompress_to_vec(&STANDARD.decode(text).unwrap()).unwrap()
    }

    /// What a browser makes of the frames, as `page/data.js` does.
    fn unpacked(track: &Track) -> Vec<Vec<f64>> {
        let ranges = track.ranges();
        let mut shares = vec![0_u16; track.frames[0].len()];
        let rows = shares.len() / track.width;
        let mut frames = Vec::new();
        for number in 0..track.frames.len() {
            let planes = bytes(&frame(track, &ranges, number));
            let (low, high) = planes.split_at(shares.len());
            for (i, share) in shares.iter_mut().enumerate() {
                *share = share.wrapping_add(u16::from_le_bytes([low[i], high[i]]));
            }
            let value = |i: usize| {
                let (row, component) = (i / track.width, i % track.width);
                let Range { low, high, .. } = ranges[component];
                match shares[component * rows + row] {
                    NONE => f64::NAN,
                    share => low + f64::from(share) * (high - low) / STEPS,
                }
            };
            frames.push((0..shares.len()).map(value).collect());
        }
        frames
    }

    #[test]
    fn numbers_come_back_within_half_a_step_of_their_range() {
        let value = |frame: usize, i: usize| {
            ((1 + i) as f32 * 0.37 + frame as f32 * 0.11).sin() * [1e-9, 3.0, 1e7][i % 3]
        };
        let mut frames: Vec<Vec<f32>> =
            (0..5).map(|frame| (0..999).map(|i| value(frame, i)).collect()).collect();
        frames[2][7] = f32::NAN;
        let track = Track { name: "a".into(), unit: None, components: Vec::new(), width: 3, frames };
        let ranges = track.ranges();
        for (frame, found) in track.frames.iter().zip(unpacked(&track)) {
            for (i, (&x, found)) in frame.iter().zip(found).enumerate() {
                let Range { low, high, .. } = ranges[i % 3];
                // Half a step of 65534, and the rounding of a sum in double precision.
                let bound = 0.5 * (high - low) / STEPS * (1.0 + 1e-9);
                assert!(
                    x.is_nan() && found.is_nan() || (f64::from(x) - found).abs() <= bound,
                    "{i}: {x} {found}"
                );
            }
        }
    }

    #[test]
    fn what_stands_still_takes_no_room() {
        let constant = Track {
            name: "a".into(),
            unit: None,
            components: Vec::new(),
            width: 1,
            frames: vec![vec![0.3; 10_000]; 2],
        };
        let ranges = constant.ranges();
        let hash = |i: u32| {
            let mixed = (i ^ (i >> 7)).wrapping_mul(2_654_435_761);
            (mixed ^ (mixed >> 15)).wrapping_mul(2_246_822_519) >> 8
        };
        let noise: Vec<f32> = (0..10_000).map(|i| hash(i) as f32).collect();
        let still = Track { frames: vec![noise.clone(), noise], ..constant.clone() };
        assert!(frame(&constant, &ranges, 0).len() < 100);
        let ranges = still.ranges();
        assert!(frame(&still, &ranges, 0).len() > 20_000 && frame(&still, &ranges, 1).len() < 100);
        assert!(unpacked(&constant)[1].iter().all(|&x| x == f64::from(0.3_f32)));
    }

    #[test]
    fn whole_and_single_numbers_come_back_to_the_last_bit() {
        let joined = |text: &str| -> Vec<u32> {
            let planes = bytes(text);
            let count = planes.len() / 4;
            (0..count)
                .map(|i| u32::from_le_bytes([0, 1, 2, 3].map(|plane| planes[plane * count + i])))
                .collect()
        };
        let numbers = [5_u32, 3, 4_000_000_000, 0];
        let mut sum = 0_u32;
        let back: Vec<u32> = joined(&whole(numbers.into_iter()))
            .into_iter()
            .map(|d| {
                sum = sum.wrapping_add(d);
                sum
            })
            .collect();
        assert_eq!(back, numbers);
        let singles = [0.1_f32, -7.5e20, 0.0];
        let back: Vec<f32> = joined(&single(singles.into_iter())).into_iter().map(f32::from_bits).collect();
        assert_eq!(back, singles);
    }
}
