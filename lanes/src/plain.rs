//! Lanes in plain loops.

use super::picked::PICKED;
use super::{EIGHT, LANES, Lanes, Pack, Shift};

/// Plain loops, for any processor.
#[derive(Clone, Copy, Debug)]
pub struct Plain;

/// The number whose bits, as an integer, are greater by this.
#[inline(always)]
pub fn shifted(number: f64, by: i16) -> f64 {
    f64::from_bits(number.to_bits().wrapping_add_signed(by.into()))
}

#[inline(always)]
fn each(of: impl Fn(usize) -> f64) -> Pack {
    std::array::from_fn(of)
}

impl Lanes for Plain {
    type Four = Pack;
    type Eight = [f32; EIGHT];

    #[inline(always)]
    fn splat(self, value: f64) -> Pack {
        [value; LANES]
    }

    #[inline(always)]
    fn load(self, pack: &Pack) -> Pack {
        *pack
    }

    #[inline(always)]
    fn load_shifted(self, pack: &Pack, by: &Shift) -> Pack {
        each(|lane| shifted(pack[lane], by[lane]))
    }

    #[inline(always)]
    fn columns(self, rows: [&Pack; LANES]) -> [Pack; LANES] {
        std::array::from_fn(|place| each(|lane| rows[lane][place]))
    }

    #[inline(always)]
    fn store(self, a: Pack) -> Pack {
        a
    }

    #[inline(always)]
    fn columns_of_two(self, rows: [&[f64; 2]; LANES]) -> [Pack; 2] {
        std::array::from_fn(|place| each(|lane| rows[lane][place]))
    }

    #[inline(always)]
    fn rows(self, columns: [Pack; LANES]) -> [Pack; LANES] {
        std::array::from_fn(|lane| each(|place| columns[place][lane]))
    }

    #[inline(always)]
    fn rows_of_two(self, [a, b]: [Pack; 2]) -> [[f64; 2]; LANES] {
        std::array::from_fn(|lane| [a[lane], b[lane]])
    }

    #[inline(always)]
    fn add(self, a: Pack, b: Pack) -> Pack {
        each(|lane| a[lane] + b[lane])
    }

    #[inline(always)]
    fn sub(self, a: Pack, b: Pack) -> Pack {
        each(|lane| a[lane] - b[lane])
    }

    #[inline(always)]
    fn mul(self, a: Pack, b: Pack) -> Pack {
        each(|lane| a[lane] * b[lane])
    }

    #[inline(always)]
    fn div(self, a: Pack, b: Pack) -> Pack {
        each(|lane| a[lane] / b[lane])
    }

    #[inline(always)]
    fn sqrt(self, a: Pack) -> Pack {
        each(|lane| a[lane].sqrt())
    }

    #[inline(always)]
    fn max(self, a: Pack, b: Pack) -> Pack {
        each(|lane| if a[lane] > b[lane] { a[lane] } else { b[lane] })
    }

    #[inline(always)]
    fn min(self, a: Pack, b: Pack) -> Pack {
        each(|lane| if a[lane] < b[lane] { a[lane] } else { b[lane] })
    }

    #[inline(always)]
    fn outside(self, a: Pack, low: Pack, high: Pack) -> u8 {
        (0..LANES).fold(0, |bits, lane| bits | u8::from(a[lane] > high[lane] || a[lane] < low[lane]) << lane)
    }

    #[inline(always)]
    fn total(self, a: Pack) -> f64 {
        (a[0] + a[1]) + (a[2] + a[3])
    }

    #[inline(always)]
    fn greatest(self, a: Pack) -> f64 {
        a[0].max(a[1]).max(a[2].max(a[3]))
    }

    #[inline(always)]
    fn splat_eight(self, value: f32) -> [f32; EIGHT] {
        [value; EIGHT]
    }

    #[inline(always)]
    fn load_eight(self, eight: &[f32; EIGHT]) -> [f32; EIGHT] {
        *eight
    }

    #[inline(always)]
    fn sub_eight(self, a: [f32; EIGHT], b: [f32; EIGHT]) -> [f32; EIGHT] {
        std::array::from_fn(|lane| a[lane] - b[lane])
    }

    #[inline(always)]
    fn add_eight(self, a: [f32; EIGHT], b: [f32; EIGHT]) -> [f32; EIGHT] {
        std::array::from_fn(|lane| a[lane] + b[lane])
    }

    #[inline(always)]
    fn mul_eight(self, a: [f32; EIGHT], b: [f32; EIGHT]) -> [f32; EIGHT] {
        std::array::from_fn(|lane| a[lane] * b[lane])
    }

    #[inline(always)]
    fn not_above(self, a: [f32; EIGHT], b: [f32; EIGHT]) -> u8 {
        (0..EIGHT).fold(0, |bits, lane| {
            let above = a[lane] > b[lane];
            bits | u8::from(!above) << lane
        })
    }

    #[inline(always)]
    fn picked(self, pattern: u8, of: &[u32; EIGHT]) -> [u32; EIGHT] {
        PICKED[pattern as usize].map(|lane| of[usize::from(lane) % EIGHT])
    }
}
