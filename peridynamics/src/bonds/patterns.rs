//! Packs that nodes share, and what those of each node differ by.
//!
//! A shift is a difference of bits as integers: of numbers of one sign that is their distance in units of the last place, and
//! added to the bits it gives the number back, whatever it is.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::ops::Range;

use lanes::{LANES, Lanes, Pack, Reals, Shift, shifted};

/// Numbers whose bits are the same above these, after rounding, look alike.
const ROUGH: u32 = 24;
/// Shifts that there are none of.
const OWN: u32 = u32::MAX;
const SHARED: u32 = OWN - 1;

/// What the packs of a node are like.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Like {
    /// First pack of the pattern.
    pub pattern: u32,
    /// First shift; or that there are none, because no other node has the pattern, or this one had it first.
    shift: u32,
}

impl Like {
    /// A pattern of its own.
    pub fn own(pattern: u32) -> Self {
        Self { pattern, shift: OWN }
    }

    /// A pattern that others have too.
    pub fn shared(pattern: u32) -> Self {
        Self { pattern, shift: SHARED }
    }

    /// Whether no other node has the pattern.
    pub fn is_own(self) -> bool {
        self.shift == OWN
    }

    fn shifted(self) -> Option<usize> {
        (self.shift < SHARED).then_some(self.shift as usize)
    }
}

/// Packs, one behind the other.
#[derive(Clone, Debug, Default)]
pub(crate) struct Packs {
    /// Other ends, from the number of the node; lanes that only fill up a pack repeat one and have no stiffness.
    ends: Vec<[i32; LANES]>,
    /// Lengths r at which bonds pull with nothing, those at rest but for heat \[L\].
    lengths: Vec<Pack>,
    /// Stiffnesses of whole bonds \[F/L\]; zero once broken.
    stiffness: Vec<Pack>,
    /// Dᵢⱼ, the share of a bond in the dilatation of its own node \[1/L\]; zero once broken. Empty without a dilatation.
    own: Vec<Pack>,
    /// Dⱼᵢ, its share in that of the other node \[1/L\]; zero once broken.
    twin: Vec<Pack>,
}

impl Packs {
    /// Number of packs.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Makes it empty.
    pub fn clear(&mut self) {
        self.ends.clear();
        self.arrays_mut().into_iter().for_each(Vec::clear);
    }

    /// Puts a bond behind others, the first with the number zero.
    pub fn put(&mut self, number: usize, end: i32, length: f64, stiffness: f64, shares: Option<[f64; 2]>) {
        let (pack, lane) = (number / LANES, number % LANES);
        if lane == 0 {
            self.ends.push([end; LANES]);
            self.lengths.push([length; LANES]);
            self.stiffness.push([0.0; LANES]);
            if shares.is_some() {
                self.own.push([0.0; LANES]);
                self.twin.push([0.0; LANES]);
            }
        }
        self.ends[pack][lane..].fill(end);
        self.lengths[pack][lane..].fill(length);
        self.stiffness[pack][lane] = stiffness;
        if let Some([own, twin]) = shares {
            self.own[pack][lane] = own;
            self.twin[pack][lane] = twin;
        }
    }

    /// Puts all packs of others behind; returns the first.
    pub fn append(&mut self, packs: &Self) -> u32 {
        let first = self.len() as u32;
        self.ends.extend_from_slice(&packs.ends);
        let arrays = self.arrays_mut().into_iter().zip(packs.arrays());
        arrays.for_each(|(all, more)| all.extend_from_slice(more));
        first
    }

    /// Lengths at which bonds pull with nothing \[L\].
    pub fn lengths_mut(&mut self) -> &mut [Pack] {
        &mut self.lengths
    }

    /// Takes all that it carries from a lane.
    pub fn sever(&mut self, pack: usize, lane: usize) {
        for array in [&mut self.stiffness, &mut self.own, &mut self.twin] {
            if let Some(pack) = array.get_mut(pack) {
                pack[lane] = 0.0;
            }
        }
    }

    /// A number that packs alike but for rounding share, but for a few.
    pub fn look(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        self.ends.as_flattened().hash(&mut hasher);
        let rough = |value: f64| value.to_bits().wrapping_add(1 << (ROUGH - 1)) >> ROUGH;
        for array in self.arrays() {
            let mut sum = 0_u64;
            array.as_flattened().iter().for_each(|&value| sum = sum.rotate_left(5) ^ rough(value));
            sum.hash(&mut hasher);
        }
        hasher.finish()
    }

    /// Gives back what was reserved in vain.
    pub fn shrink(&mut self) {
        self.ends.shrink_to_fit();
        self.arrays_mut().into_iter().for_each(Vec::shrink_to_fit);
    }

    fn arrays(&self) -> [&Vec<Pack>; 4] {
        [&self.lengths, &self.stiffness, &self.own, &self.twin]
    }

    fn arrays_mut(&mut self) -> [&mut Vec<Pack>; 4] {
        [&mut self.lengths, &mut self.stiffness, &mut self.own, &mut self.twin]
    }

    /// Memory \[bytes\].
    pub fn bytes(&self) -> usize {
        size_of_val(&self.ends[..]) + self.arrays().map(|array| size_of_val(&array[..])).iter().sum::<usize>()
    }
}

/// Shifts of the packs of nodes that have the pattern of another: of lengths, stiffnesses, and where there are any of both shares.
#[derive(Clone, Debug, Default)]
pub(crate) struct Shifts([Vec<Shift>; 4]);

impl Shifts {
    /// Makes room for so many packs.
    pub fn reserve(&mut self, packs: usize, shares: bool) {
        let arrays = if shares { 4 } else { 2 };
        self.0[..arrays].iter_mut().for_each(|array| array.reserve_exact(packs));
    }

    /// Adds those of a node's packs from a pattern; nothing where they are not alike.
    pub fn add(&mut self, patterns: &Packs, pattern: Range<usize>, packs: &Packs) -> Option<Like> {
        let first = self.0[0].len();
        let alike =
            patterns.ends[pattern.clone()] == packs.ends && self.add_all(patterns, pattern.clone(), packs);
        if alike {
            return Some(Like { pattern: pattern.start as u32, shift: first as u32 });
        }
        self.0.iter_mut().for_each(|array| array.truncate(first));
        None
    }

    fn add_all(&mut self, patterns: &Packs, pattern: Range<usize>, packs: &Packs) -> bool {
        for ((shifts, like), own) in self.0.iter_mut().zip(patterns.arrays()).zip(packs.arrays()) {
            let like = like.get(pattern.clone()).unwrap_or_default();
            for (like, own) in like.iter().zip(own) {
                let by: [u64; LANES] =
                    std::array::from_fn(|lane| own[lane].to_bits().wrapping_sub(like[lane].to_bits()));
                let shift = by.map(|by| by as i16);
                if by.iter().zip(shift).any(|(&by, shift)| by as i64 != i64::from(shift)) {
                    return false;
                }
                shifts.push(shift);
            }
        }
        true
    }

    /// Memory \[bytes\].
    pub fn bytes(&self) -> usize {
        self.0.iter().map(|array| size_of_val(&array[..])).sum()
    }
}

/// A number of each bond, where arrays of packs have it.
#[derive(Clone, Copy)]
pub(crate) enum Number {
    Length,
    Stiffness,
    /// Its share in the dilatation of its own node.
    Own,
    /// That in the dilatation of the other node.
    Twin,
}

/// The packs of a node.
#[derive(Clone, Copy)]
pub(crate) struct Family<'a> {
    node: u32,
    ends: &'a [[i32; LANES]],
    /// By [`Number`]; empty what the law has not.
    likes: [&'a [Pack]; 4],
    /// The same; all empty where its numbers are those of the pattern.
    shifts: [&'a [Shift]; 4],
    pub is_shifted: bool,
}

impl<'a> Family<'a> {
    /// Of a node with so many packs.
    #[inline(always)]
    pub fn of(node: usize, count: usize, like: Like, patterns: &'a Packs, shifts: &'a Shifts) -> Self {
        let first = like.pattern as usize;
        let [a, b, c, d] = patterns.arrays();
        let mut out = Self {
            node: node as u32,
            ends: &patterns.ends[first..first + count],
            likes: [
                part(a, first, count),
                part(b, first, count),
                part(c, first, count),
                part(d, first, count),
            ],
            shifts: [&[]; 4],
            is_shifted: false,
        };
        if let Some(first) = like.shifted() {
            let [a, b, c, d] = &shifts.0;
            out.shifts =
                [part(a, first, count), part(b, first, count), part(c, first, count), part(d, first, count)];
            out.is_shifted = true;
        }
        out
    }

    /// Number of packs.
    #[inline(always)]
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// The nodes at the other ends of a pack, beyond the nodes images.
    #[inline(always)]
    pub fn others(&self, pack: usize) -> [u32; LANES] {
        let [a, b, c, d] = self.ends[pack];
        let of = |end: i32| self.node.wrapping_add_signed(end);
        [of(a), of(b), of(c), of(d)]
    }

    /// Lanes whose other ends come before a node or an image.
    pub fn before(&self, other: usize) -> usize {
        let ends = self.ends.as_flattened();
        ends.partition_point(|&end| (self.node.wrapping_add_signed(end) as usize) < other)
    }

    /// One number of all bonds, none unless wanted.
    #[inline(always)]
    pub fn values<const SHIFTED: bool>(&self, number: Number, wanted: bool) -> Values<'a, SHIFTED> {
        let (k, count) = (number as usize, if wanted { self.ends.len() } else { 0 });
        let shifts: &[Shift] = if SHIFTED { &self.shifts[k][..count] } else { &[] };
        Values { likes: &self.likes[k][..count], shifts }
    }

    /// One number of one bond; zero where there is none.
    pub fn value(&self, number: Number, pack: usize, lane: usize) -> f64 {
        let k = number as usize;
        let like = self.likes[k].get(pack).map_or(0.0, |pack| pack[lane]);
        self.shifts[k].get(pack).map_or(like, |shift| shifted(like, shift[lane]))
    }

    /// The same packs with numbers of their own.
    pub fn exact(&self) -> Packs {
        let of = |k: usize| -> Vec<Pack> {
            let number = [Number::Length, Number::Stiffness, Number::Own, Number::Twin][k];
            let pack = |pack: usize| std::array::from_fn(|lane| self.value(number, pack, lane));
            (0..self.likes[k].len()).map(pack).collect()
        };
        Packs { ends: self.ends.to_vec(), lengths: of(0), stiffness: of(1), own: of(2), twin: of(3) }
    }
}

/// So many entries of an array that has them or is empty.
#[inline(always)]
fn part<T>(array: &[T], first: usize, count: usize) -> &[T] {
    array.get(first..first + count).unwrap_or_default()
}

/// One number of each bond of a node.
#[derive(Clone, Copy)]
pub(crate) struct Values<'a, const SHIFTED: bool> {
    likes: &'a [Pack],
    shifts: &'a [Shift],
}

impl<const SHIFTED: bool> Values<'_, SHIFTED> {
    /// Of a pack.
    #[inline(always)]
    pub fn of<L: Lanes>(&self, lanes: L, pack: usize) -> Reals<L> {
        if SHIFTED {
            lanes.read_shifted(&self.likes[pack], &self.shifts[pack])
        } else {
            lanes.read(&self.likes[pack])
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)] // a test may stop where it stands

    use super::*;

    /// Packs of so many bonds whose numbers are off some by these parts.
    fn packs(bonds: usize, off: f64) -> Packs {
        let mut out = Packs::default();
        for k in 0..bonds {
            let of = |number: f64| (number + k as f64) * (1.0 + off * (k as f64 + number));
            out.put(k, k as i32 - 3, of(1.0), of(2.0), Some([of(3.0), -of(4.0)]));
        }
        out
    }

    /// Packs a little off a pattern come back with all their bits and look as it does; those far off are not taken.
    #[test]
    fn what_is_shared_keeps_its_bits() {
        let (pattern, alike, other) = (packs(23, 0.0), packs(23, 1e-15), packs(23, 1e-9));
        let (mut patterns, mut shifts) = (Packs::default(), Shifts::default());
        patterns.append(&packs(5, 0.1));
        let first = patterns.append(&pattern) as usize;
        let range = first..first + pattern.len();
        assert!(shifts.add(&patterns, range.clone(), &other).is_none() && shifts.bytes() == 0);
        assert!(shifts.add(&patterns, range.clone(), &packs(22, 0.0)).is_none());
        let like = shifts.add(&patterns, range, &alike).unwrap();
        assert_eq!(pattern.look(), alike.look());
        assert_ne!(pattern.look(), other.look());
        let family = Family::of(100, alike.len(), like, &patterns, &shifts);
        let exact = family.exact();
        let bits = |packs: &Packs| -> Vec<u64> {
            packs.arrays().iter().flat_map(|array| array.as_flattened()).map(|x| x.to_bits()).collect()
        };
        assert!(bits(&exact) == bits(&alike) && bits(&alike) != bits(&pattern));
        assert_eq!(family.others(0), [97, 98, 99, 100]);
        // The last bond fills its pack up.
        assert_eq!(family.others(5), [117, 118, 119, 119]);
    }
}
