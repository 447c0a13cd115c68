//! Which pairs of particles share a block of the tangent, and where the pairs of each sampling point lie among them.

use implicit_statics::BlockPattern;
use shell_kinematics::LANES;

use crate::Shell;
use crate::packs::Packs;
use crate::points::scheme::Scheme;

/// The block of a pair of particles of a sampling point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Target(u32);

/// Set where the first particle of the pair comes before the second: its block is stored as that of the second with it.
const TURNED: u32 = 1 << 31;

impl Target {
    /// A pair of lanes that only fill up: it has no block.
    const NONE: Self = Self(u32::MAX);

    /// The number of the block counted from `first`, if it is one of `count`, and whether it is stored transposed.
    #[inline(always)]
    pub fn within(self, first: usize, count: usize) -> Option<(usize, bool)> {
        let number = (self.0 & !TURNED) as usize;
        let place = number.wrapping_sub(first);
        (self != Self::NONE && place < count).then_some((place, self.0 & TURNED != 0))
    }
}

/// The blocks of a shell and where its points find theirs.
#[derive(Clone, Debug)]
pub(crate) struct ShellPattern {
    /// Pairs of particles, the first not before the second.
    pub pairs: BlockPattern,
    /// Blocks of the pairs of each pack: each entry with those not before it, the base first.
    targets: Vec<[Target; LANES]>,
    /// First target of each pack, and the end.
    firsts: Vec<u32>,
    /// Least and largest row of the blocks of each pack.
    rows: Vec<[u32; 2]>,
    /// For each particle that hangs by a tie those that it shares a block with.
    pub of_hanging: Vec<Vec<u32>>,
}

impl ShellPattern {
    pub fn new(shell: &Shell) -> Self {
        let mut rows: Vec<Vec<u32>> = vec![Vec::new(); shell.len()];
        let operator = &shell.reference.operator;
        for p in 0..operator.points.len() {
            let particles = operator.stencil(p).particles;
            for &a in particles {
                rows[a as usize].extend(particles.iter().filter(|&&b| b < a));
            }
        }
        shell.load_stiffness(1.0, &mut |a, b, _| rows[a.max(b) as usize].push(a.min(b)));
        if let Some(own) = &shell.loading.own_contact {
            own.pattern(|a, b| rows[a.max(b) as usize].push(a.min(b)));
        }
        for [a, b] in shell.body_springs().pairs().into_iter().chain(shell.stiffeners.pairs()) {
            rows[a.max(b) as usize].push(a.min(b));
        }
        if let Scheme::Wide { control, .. } = &shell.points.scheme {
            for (a, row) in rows.iter_mut().enumerate() {
                row.extend(control.blocks_of(a).map(|(b, _)| b).filter(|&b| (b as usize) < a));
            }
        }
        let of_hanging = shell.dependents.ties.add_pairs(&mut rows);
        shell.dependents.junctions.add_pairs(&mut rows);
        let mut pattern = Self {
            pairs: BlockPattern::new(rows.len(), |a, row| row.append(&mut rows[a])),
            targets: Vec::new(),
            firsts: vec![0],
            rows: Vec::new(),
            of_hanging,
        };
        (0..shell.points.packs.points.len())
            .for_each(|index| pattern.find_targets(&shell.points.packs, index));
        pattern
    }

    fn find_targets(&mut self, packs: &Packs, index: usize) {
        let pack = &packs.points[index];
        let particles = &packs.particles[pack.first as usize..][..pack.width as usize];
        let weight = packs.constants.get(index).weight.lanes();
        let particle = |entry: usize, lane: usize| match entry.checked_sub(1) {
            None => pack.base[lane],
            Some(k) => particles[k][lane],
        };
        let mut rows = [u32::MAX, 0];
        for l in 0..=particles.len() {
            for k in l..=particles.len() {
                let target = |lane: usize| {
                    let (a, b) = (particle(k, lane), particle(l, lane));
                    // Filled-up places repeat the base with zero, filling lanes the last point without weight.
                    let fills = |entry: usize, own: u32| entry > 0 && own == pack.base[lane];
                    if weight[lane] == 0.0 || fills(k, a) || fills(l, b) {
                        return Target::NONE;
                    }
                    let number = self.pairs.find(a.max(b), a.min(b)).map(|number| number as u32);
                    number.map_or(Target::NONE, |number| Target(number | if a < b { TURNED } else { 0 }))
                };
                let targets: [Target; LANES] = std::array::from_fn(target);
                self.targets.push(targets);
                for lane in (0..LANES).filter(|&lane| targets[lane] != Target::NONE) {
                    let row = particle(k, lane).max(particle(l, lane));
                    rows = [rows[0].min(row), rows[1].max(row)];
                }
            }
        }
        self.firsts.push(self.targets.len() as u32);
        self.rows.push(rows);
    }

    /// Blocks of the pairs of a pack.
    #[inline(always)]
    pub fn targets(&self, index: usize) -> &[[Target; LANES]] {
        &self.targets[self.firsts[index] as usize..self.firsts[index + 1] as usize]
    }

    /// Whether a pack has blocks in these rows.
    #[inline(always)]
    pub fn touches(&self, index: usize, rows: &std::ops::Range<usize>) -> bool {
        let [least, largest] = self.rows[index].map(|row| row as usize);
        least < rows.end && largest >= rows.start
    }
}
