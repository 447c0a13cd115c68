//! The sweeps over families that yield: what flows in a state, and what is kept of it once a step.

use std::ops::Range;

use lanes::{Lanes, Reals, Sweep, widest};
use parallel::Lists;

use super::flow::{Flow, Kept, Past, Surface};
use super::network::{Network, Pack, Row};
use super::patterns::{Family, Number};
use super::present::{Own, Present, keep};
use crate::plastic::Plastic;
use crate::share::Share;

/// Dilatations `(λ − μ) V θ` of one chunk of nodes, and how they flow.
struct Try<'a> {
    network: &'a Network,
    flow: Tried<'a>,
    rows: &'a [Row],
    first: usize,
    dilatations: &'a mut [f64],
    trial: &'a mut [[f64; 2]],
    coming: &'a mut [Past],
}

/// What was kept.
#[derive(Clone, Copy)]
struct Tried<'a> {
    plastic: &'a Plastic,
    surfaces: &'a [Surface],
    own: &'a [Pack],
    round: &'a [Pack],
    past: &'a [Past],
}

impl Sweep for Try<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) {
        let Self { network, flow, rows, first, dilatations, trial, coming } = self;
        let Some(factors) = &network.dilatation else { return };
        for (i, value) in dilatations.iter_mut().enumerate() {
            let node = first + i;
            let (own, family) = (Own::all(lanes, &rows[node]), network.family(node));
            let packs = network.packs_of(node);
            let kept = (&flow.own[packs.clone()], &flow.round[packs]);
            let [theta, square, along, whole] = if family.is_shifted {
                tried::<L, true>(lanes, &own, &family, kept, rows)
            } else {
                tried::<L, false>(lanes, &own, &family, kept, rows)
            };
            *value = factors[node] * theta.total();
            let sums = [square, along, whole].map(Reals::total);
            (trial[i], coming[i]) = flow.surfaces[node].flow(flow.plastic, flow.past[node].strain, sums);
        }
    }
}

/// θ, `Σ c a²`, `Σ c ρ a` and `Σ c ρ²` of a node, lane by lane, from p and ρ.
#[inline(always)]
fn tried<L: Lanes, const SHIFTED: bool>(
    lanes: L,
    own: &Own<L>,
    family: &Family<'_>,
    (plastic, round): (&[Pack], &[Pack]),
    rows: &[Row],
) -> [Reals<L>; 4] {
    let lengths = family.values::<SHIFTED>(Number::Length, true);
    let stiffnesses = family.values::<SHIFTED>(Number::Stiffness, true);
    let shares = family.values::<SHIFTED>(Number::Own, true);
    let [mut theta, mut square, mut along, mut whole] = [lanes.same(0.0); 4];
    for (k, (plastic, round)) in plastic.iter().zip(round).enumerate() {
        let bond = Present::of(lanes, own, &family.others(k), rows);
        let (round, stiffness) = (lanes.read(round), stiffnesses.of(lanes, k));
        let extension = bond.length - lengths.of(lanes, k);
        theta += shares.of(lanes, k) * extension;
        let elastic = extension - lanes.read(plastic);
        let (stretched, rounded) = (stiffness * elastic, stiffness * round);
        square += stretched * elastic;
        along += rounded * elastic;
        whole += rounded * round;
    }
    [theta, square, along, whole]
}

/// Packs of nodes, split where those of a node begin.
struct ByNode<'a> {
    starts: &'a [u32],
    packs: &'a mut [Pack],
}

impl Lists for ByNode<'_> {
    fn len(&self) -> usize {
        self.starts.len() - 1
    }

    fn split(self, entry: usize) -> (Self, Self) {
        let (before, after) = self.packs.split_at_mut((self.starts[entry] - self.starts[0]) as usize);
        let of = |starts, packs| Self { starts, packs };
        (of(&self.starts[..=entry], before), of(&self.starts[entry..], after))
    }
}

/// Keeps what flows in one chunk of nodes.
struct Keep<'a> {
    network: &'a Network,
    trial: &'a [[f64; 2]],
    rows: &'a [Row],
    first: usize,
    own: ByNode<'a>,
    twin: ByNode<'a>,
    /// ρ at both ends.
    round: [&'a [Pack]; 2],
}

impl Sweep for Keep<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) {
        let Self { network, trial, rows, first, own, twin, round } = self;
        for i in 0..own.len() {
            let node = first + i;
            let at = Own::all(lanes, &rows[node]);
            let here = trial[node];
            let still = here[0] == 0.0;
            let here = here.map(|value| lanes.same(value));
            let family = network.family(node);
            for (number, pack) in network.packs_of(node).enumerate() {
                let others = &family.others(number);
                let ends = others.map(|other| &trial[other as usize]);
                if still && ends.iter().all(|end| end[0] == 0.0) {
                    continue;
                }
                let there = lanes.columns_of_two(ends).map(|four| Reals { lanes, four });
                let rest = if family.is_shifted {
                    family.values::<true>(Number::Length, true).of(lanes, number)
                } else {
                    family.values::<false>(Number::Length, true).of(lanes, number)
                };
                let extension = Present::of(lanes, &at, others, rows).length - rest;
                let k = pack - own.starts[0] as usize;
                let ends = [(&mut own.packs[k], here), (&mut twin.packs[k], there)];
                for ((plastic, [part, expansion]), round) in ends.into_iter().zip(round) {
                    let (kept, round) = (lanes.read(plastic), lanes.read(&round[pack]));
                    *plastic = (kept + ((extension - kept) * part - round * expansion)).pack();
                }
            }
        }
    }
}

impl Network {
    /// Puts `(λ − μ) V θ` of own nodes into the last places of their rows, once places of ghosts are there, and finds what flows;
    /// nothing is kept.
    pub(super) fn try_flow(&self, flow: &mut Flow, rows: &mut [Row], out: &mut [f64], share: &Share) {
        let Flow { plastic, surfaces, own, round, past, trial, coming, .. } = flow;
        let kept = Tried { plastic, surfaces, own, round, past };
        type Parts<'a> = (&'a mut [f64], (&'a mut [[f64; 2]], &'a mut [Past]));
        let mut find = |rows: &[Row], nodes: Range<usize>| {
            let first = nodes.start;
            let lists = (&mut out[nodes.clone()], (&mut trial[nodes.clone()], &mut coming[nodes]));
            share.sweep(first, lists, |first, (dilatations, (trial, coming)): Parts<'_>| {
                widest(Try { network: self, flow: kept, rows, first, dilatations, trial, coming });
            });
        };
        find(rows, share.inner());
        self.take_places(rows, share);
        share.outer(self.len()).into_iter().for_each(|nodes| find(rows, nodes));
        flow.flows = flow.coming[share.own(self.len())].iter().any(|past| past.strain > 0.0);
        keep(rows, out, share);
    }

    /// Keeps what flowed in the rows last evaluated, behind those of the nodes the images; returns the plastic work of all \[F L\].
    pub fn keep_flow(&mut self, rows: &[Row], share: &Share) -> f64 {
        let nodes = share.own(self.len());
        let Some(mut flow) = self.flow.take_if(|flow| share.any(flow.flows)) else { return 0.0 };
        let network = &*self;
        let Kept { ends: [(own, here), (twin, there)], past, trial, coming, works } = flow.kept();
        let round = [here, there];
        let starts = &network.starts[nodes.start..=nodes.end];
        let packs = starts[0] as usize..starts[nodes.len()] as usize;
        let by_node = |packs| ByNode { starts, packs };
        let lists = ((by_node(&mut own[packs.clone()]), by_node(&mut twin[packs])), &mut past[nodes.clone()]);
        type Parts<'a> = ((ByNode<'a>, ByNode<'a>), &'a mut [Past]);
        parallel::reduced(share.threads(), lists, works, |first, ((own, twin), past): Parts<'_>| {
            let first = nodes.start + first;
            widest(Keep { network, trial, rows, first, own, twin, round });
            let mut work = 0.0;
            for (past, coming) in past.iter_mut().zip(&coming[first..]) {
                past.strain += coming.strain;
                past.work += coming.work;
                work += coming.work;
            }
            work
        });
        let [work] = share.sum(works.iter().map(|work| [*work]));
        flow.forget();
        self.flow = Some(flow);
        work
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers of (0, 1) that are the same on every machine.
    fn random(state: &mut u64) -> f64 {
        *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*state >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// `Σ c x y` of a family.
    fn sum(family: &[[f64; 3]], of: impl Fn(&[f64; 3]) -> f64) -> f64 {
        family.iter().map(|bond| bond[0] * of(bond)).sum()
    }

    /// Families of random stiffness, round parts and elastic extensions, some pressed much more than sheared.
    #[test]
    fn returned_families_are_on_the_yield_surface_and_lose_energy() {
        let mut state = 7;
        let (mut far, mut lack, mut along) = ([0.0_f64; 2], 0.0_f64, 0.0_f64);
        let mut flowed = 0;
        for case in 0..100_000 {
            let mut next = || random(&mut state);
            let pressed = if case % 3 == 0 { 3.0 * next() } else { 0.0 };
            let mut family: Vec<[f64; 3]> = (0..30)
                .map(|_| {
                    let (c, round) = (next(), 1.0 + next());
                    [c, round, (next() - 0.5) - pressed * round]
                })
                .collect();
            let plastic = Plastic {
                yield_stress: 0.3 * next() + 1e-3,
                hardening: if case % 2 == 0 { 0.0 } else { next() },
            };
            let surface = Surface { shear: 0.2 + next(), share: 0.1 + next() };
            let strain = next();
            let sums = |family: &[[f64; 3]]| {
                [sum(family, |b| b[2] * b[2]), sum(family, |b| b[1] * b[2]), sum(family, |b| b[1] * b[1])]
            };
            let ([part, expansion], past) = surface.flow(&plastic, strain, sums(&family));
            let stress = surface.stress(sums(&family));
            if past.strain == 0.0 {
                assert!(
                    stress <= plastic.limit(strain) && part == 0.0 && expansion == 0.0 && past.work == 0.0
                );
                continue;
            }
            flowed += 1;
            let stored = 0.25 * sum(&family, |b| b[2] * b[2]);
            let pressure = sums(&family)[1];
            let mut lost = 0.0;
            for [c, round, elastic] in &mut family {
                let plastic = *elastic * part - *round * expansion;
                lost += 0.5 * *c * (*elastic - 0.5 * plastic) * plastic;
                *elastic -= plastic;
            }
            let limit = plastic.limit(strain + past.strain);
            // ‖t_d‖² over its bound: in two passes, so that a pressure takes no digits.
            let s = sums(&family)[1] / sums(&family)[2];
            let square = sum(&family, |b| (b[2] - s * b[1]).powi(2));
            let on = surface.stress([square, 0.0, sums(&family)[2]]) / limit;
            let far = &mut far[usize::from(pressed > 0.0)];
            *far = far.max((on * on - 1.0).abs() * limit / stress);
            along = along.max((sums(&family)[1] - pressure).abs() / sums(&family)[2]);
            let drop = stored - 0.25 * sum(&family, |b| b[2] * b[2]);
            lack = lack.max((drop - lost).abs() / stored);
            // At fixed places the energy falls by the mean of the stresses before and after, times the plastic strain.
            let volume = surface.share * sums(&family)[2];
            let mean = 0.5 * (stress + limit) * past.strain * volume;
            assert!(lost > 0.0 && (lost - mean).abs() < 1e-11 * stored && (0.0..1.0).contains(&part));
            assert!(past.work > 0.0 && past.work <= mean);
        }
        println!("{flowed} flowed; off the surface {far:?}, energy {lack:.1e}, round part {along:.1e}");
        assert!(flowed > 50_000 && lack < 3e-15 && along < 1e-14);
        // Of what is left of a trial state, rounding is as much of the trial. Pressed families lose digits as the square of what is
        // pressed to that of what is sheared: measured 6.5e-13.
        assert!(far[0] < 1e-14 && far[1] < 2e-12, "{far:?}");
    }
}
