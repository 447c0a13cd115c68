//! Sums, maxima and rows by 1 to 7 peers: what one has alone, to the bit.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod random;

use std::collections::BTreeSet;

use peers::{Alone, CHUNK, Cut, Exact, Greatest, Lists, Partner, Peers, agree, plan, together};
use random::Random;

/// What each peer finds, which has to be the same on all of them and alone.
fn same<R: Send + PartialEq + std::fmt::Debug>(each: impl Fn(Box<dyn Peers>) -> R + Sync) {
    let alone = each(Box::new(Alone));
    for count in 1..=7 {
        for (rank, found) in together(count, &each).unwrap().into_iter().enumerate() {
            assert_eq!(found, alone, "peer {rank} of {count}");
        }
    }
}

/// Sums of a model in chunks and one by one, of any cut: those whose sum over ranks in doubles would differ.
#[test]
fn sums_have_the_same_bits_for_any_number_of_peers() {
    let mut random = Random(3);
    let values: Vec<f64> =
        (0..23 * CHUNK + 100).map(|_| random.unit() * 2_f64.powi(random.below(60) as i32)).collect();
    let weights: Vec<u32> = values.iter().map(|_| 1 + random.below(40) as u32).collect();
    let add = |mut peers: Box<dyn Peers>| {
        let (rank, count) = (peers.rank(), peers.count());
        let mut found = Vec::new();
        for cut in [Cut::even(values.len(), count), Cut::by_weights(&weights, count)] {
            let own = &values[cut.own(rank)];
            for _ in 0..3 {
                let mut sums = [Exact::new(), Exact::new(), Exact::new()];
                sums[0].add_in_chunks(own.iter().copied());
                sums[1].add_in_chunks(own.iter().map(|x| x * x));
                own.iter().for_each(|&x| sums[2].add(x));
                let mut counts = [own.len() as i64, -3 * own.len() as i64];
                peers.add(&mut sums, &mut counts);
                found.push((sums.map(|sum| sum.value().to_bits()), counts));
            }
        }
        found
    };
    same(add);
    // Cuts inside of chunks: one by one the sum stays what it is.
    let any = |mut peers: Box<dyn Peers>| {
        let mut random = Random(11);
        (0..20)
            .map(|_| {
                let mut borders: Vec<usize> =
                    (1..peers.count()).map(|_| random.below(values.len())).collect();
                borders.extend([0, values.len()]);
                borders.sort_unstable();
                let mut sum = [Exact::new()];
                values[Cut::at(borders).own(peers.rank())].iter().for_each(|&x| sum[0].add(x));
                peers.add(&mut sum, &mut []);
                sum[0].value().to_bits()
            })
            .collect::<BTreeSet<_>>()
    };
    same(any);
    assert_eq!(any(Box::new(Alone)).len(), 1);
    // The check can fail: sums of shares in doubles depend on their number.
    let plain = |count: usize| {
        let cut = Cut::even(values.len(), count);
        let shares = (0..count).map(|rank| values[cut.own(rank)].iter().sum::<f64>());
        shares.sum::<f64>().to_bits()
    };
    assert!((1..=7).map(plain).collect::<BTreeSet<_>>().len() > 1);
}

/// What one alone knows reaches all in the same sum; what is no number too.
#[test]
fn a_word_of_one_reaches_all() {
    for count in 1..=7 {
        let found = together(count, |mut peers| {
            let (last, mut steps) = (peers.rank() + 1 == peers.count(), 0);
            loop {
                let mut sum = [Exact::new()];
                sum[0].add(if last && steps == 4 { f64::NAN } else { 1.0 });
                let mut stop = [i64::from(last && steps == 4)];
                peers.add(&mut sum, &mut stop);
                if stop[0] > 0 {
                    return (steps, sum[0].value().is_nan());
                }
                assert_eq!(sum[0].value(), peers.count() as f64);
                steps += 1;
            }
        });
        assert_eq!(found.unwrap(), vec![(4, true); count]);
    }
}

#[test]
fn the_greatest_is_the_one_with_the_least_number() {
    let mut random = Random(5);
    // Few values, so that many are equal.
    let values: Vec<f64> = (0..4000).map(|_| random.below(50) as f64 - 60.0).collect();
    let mut odd = values.clone();
    odd[3111] = f64::NAN;
    odd[3500] = f64::INFINITY;
    let find = |mut peers: Box<dyn Peers>| {
        let own = Cut::even(values.len(), peers.count()).own(peers.rank());
        let of = |value: &dyn Fn(usize) -> f64| {
            own.clone().fold(Greatest::NONE, |found, a| found.or(Greatest::of(value(a), a as u64)))
        };
        let mut found = [
            of(&|a| values[a]),
            of(&|a| -values[a]),
            of(&|a| odd[a]),
            of(&|a| 0.0 * values[a]),
            Greatest::NONE,
        ];
        peers.greatest(&mut found);
        found.map(|found| (found.value().to_bits(), found.number()))
    };
    same(find);
    let first = |value: f64| values.iter().position(|&x| x == value).unwrap() as u64;
    let found = find(Box::new(Alone));
    assert_eq!(found[0], ((-11_f64).to_bits(), first(-11.0)));
    assert_eq!(found[1], (60_f64.to_bits(), first(-60.0)), "the least, by opposites");
    assert_eq!(found[2], (f64::INFINITY.to_bits(), 3111));
    assert_eq!(found[3], (0, 0), "+0 for −0");
    assert_eq!(found[4], (f64::NEG_INFINITY.to_bits(), u64::MAX));
}

/// What each of some peers needs, at random: near its border, and here and there.
fn needs(random: &mut Random, cut: &Cut) -> Vec<Vec<u32>> {
    let particles = cut.particles();
    let one = |rank: usize, random: &mut Random| {
        let own = cut.own(rank);
        let mut needs: Vec<u32> = own.clone().map(|a| a as u32).collect();
        needs.extend((own.start.saturating_sub(random.below(40))..own.start).map(|a| a as u32));
        needs.extend((own.end..(own.end + random.below(40)).min(particles)).map(|a| a as u32));
        needs.extend((0..random.below(30)).map(|_| random.below(particles) as u32));
        random.shuffle(&mut needs);
        needs
    };
    (0..cut.peers()).map(|rank| one(rank, random)).collect()
}

/// The number of row `particle` in step `step` at column `i`.
fn number(particle: u32, step: usize, i: usize) -> f64 {
    f64::from(particle) + 1e6 * step as f64 + 1e-3 * i as f64
}

#[test]
fn lists_agreed_on_are_those_planned_and_lanes_carry_every_row() {
    let particles = 5 * CHUNK + 33;
    for count in 1..=7 {
        for set in 0..10 {
            let mut random = Random(100 * count as u64 + set);
            let weights: Vec<u32> = (0..particles).map(|_| random.below(9) as u32).collect();
            let cut = Cut::by_weights(&weights, count);
            let needs = needs(&mut random, &cut);
            let planned = plan(&cut, &needs);
            check_plan(&cut, &needs, &planned);
            let found = together(count, |mut peers| {
                let rank = peers.rank();
                let lists = agree(&mut *peers, &cut, &needs[rank]);
                exchange(&mut *peers, &cut, &needs[rank], &lists);
                lists
            });
            assert_eq!(found.unwrap(), planned, "{count} peers, set {set}");
        }
    }
}

/// Everyone takes what it needs of others and nothing else; what one takes the other sends, in the same order.
fn check_plan(cut: &Cut, needs: &[Vec<u32>], planned: &[Lists]) {
    for (rank, lists) in planned.iter().enumerate() {
        let taken: Vec<u32> = lists.partners().iter().flat_map(|partner| partner.take.clone()).collect();
        let wanted: BTreeSet<u32> =
            needs[rank].iter().copied().filter(|&a| !cut.own(rank).contains(&(a as usize))).collect();
        assert_eq!(taken, wanted.into_iter().collect::<Vec<_>>());
        assert_eq!(lists.ghosts(), taken.len());
        for Partner { rank: other, send, take } in lists.partners() {
            let back = planned[*other].partners().iter().find(|partner| partner.rank == rank).unwrap();
            assert_eq!((send, take), (&back.take, &back.send));
            assert!(send.iter().all(|&a| cut.owner(a as usize) == rank));
        }
    }
    let sent: usize = planned.iter().map(Lists::sent).sum();
    assert_eq!(sent, planned.iter().map(Lists::ghosts).sum());
    assert_eq!(planned.iter().map(|lists| lists.bytes_sent(6)).sum::<usize>(), 48 * sent);
}

/// Two lanes of different width, in turn, with sums between: each ghost gets the row of its step, others stay.
fn exchange(peers: &mut dyn Peers, cut: &Cut, needs: &[u32], lists: &Lists) {
    let own = cut.own(peers.rank());
    let needed: BTreeSet<u32> = needs.iter().copied().collect();
    let widths = [6, 1];
    let lanes = widths.map(|width| peers.open(lists, width));
    let mut rows = widths.map(|width| vec![-1.0; cut.particles() * width]);
    for step in 0..6 {
        for (width, rows) in widths.into_iter().zip(&mut rows) {
            for a in own.clone() {
                (0..width).for_each(|i| rows[a * width + i] = number(a as u32, step, i));
            }
        }
        for ((lane, width), rows) in lanes.iter().zip(widths).zip(&rows) {
            peers.send(lane, &|a, row| row.copy_from_slice(&rows[a as usize * width..][..width]));
        }
        peers.add(&mut [], &mut []);
        for ((lane, width), rows) in lanes.iter().zip(widths).zip(&mut rows).rev() {
            let mut taken = 0;
            peers.take(lane, &mut |a, row| {
                rows[a as usize * width..][..width].copy_from_slice(row);
                taken += 1;
            });
            assert_eq!(taken, lists.ghosts());
        }
        for (width, rows) in widths.into_iter().zip(&rows) {
            for (a, row) in (0..).zip(rows.chunks(width)) {
                let right = needed.contains(&a) || own.contains(&(a as usize));
                (0..width).for_each(|i| assert_eq!(row[i], if right { number(a, step, i) } else { -1.0 }));
            }
        }
    }
    for lane in lanes {
        peers.close(lane);
    }
}

/// Each fills its own rows: rank 0 has all of them, or all have.
#[test]
fn rows_are_brought_to_one_and_to_all() {
    for count in 1..=7 {
        for particles in [1, 3 * CHUNK - 5] {
            let width = 3;
            let cut = Cut::even(particles, count);
            let whole: Vec<f64> = (0..particles * width).map(|i| 0.1 * i as f64).collect();
            let found = together(count, |mut peers| {
                let own = cut.own(peers.rank());
                let own = own.start * width..own.end * width;
                let mut mine = vec![-1.0; whole.len()];
                mine[own.clone()].copy_from_slice(&whole[own]);
                let mut all = mine.clone();
                let before = mine.clone();
                for _ in 0..3 {
                    peers.gather(&cut, &mut mine, width);
                    peers.gather_to_all(&cut, &mut all, width);
                }
                (mine == whole, mine == before, all == whole)
            });
            for (rank, (brought, kept, all)) in found.unwrap().into_iter().enumerate() {
                assert!(all && (brought || rank > 0) && (kept || rank == 0 && count > 1));
            }
        }
    }
}
