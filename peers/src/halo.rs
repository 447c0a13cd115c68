//! From the particles that each share needs to the lists of what is exchanged.
//!
//! A share needs its own particles and *ghosts*, particles of others that its points or bonds touch. Each peer knows what it needs itself;
//! what others need of it they tell it once.

use std::ops::Range;

use crate::cut::Cut;
use crate::lists::{Lists, Partner};
use crate::peers::Peers;

/// The lists of this peer, from the global numbers of the particles that it needs, in any order, own ones and repetitions among them. All
/// peers call it, with the same cut.
///
/// Each first says how many it needs of whom, in one sum of n² counts for n peers; then the numbers themselves go over a lane of their own.
///
/// # Panics
/// If the cut is one of another number of peers, or there is no such particle.
pub fn agree(peers: &mut dyn Peers, cut: &Cut, needs: &[u32]) -> Lists {
    let (rank, count) = (peers.rank(), peers.count());
    assert_eq!(cut.peers(), count, "a cut for as many peers as there are");
    let needs = ghosts(cut, rank, needs);
    let taken = by_owner(cut, &needs);
    let mut counts = vec![0; count * count];
    for (wanted, taken) in counts[rank * count..][..count].iter_mut().zip(&taken) {
        *wanted = taken.len() as i64;
    }
    peers.add(&mut [], &mut counts);
    let mut end = 0;
    let asked: Vec<Range<usize>> = (0..count)
        .map(|other| {
            let start = end;
            end += counts[other * count + rank] as usize;
            start..end
        })
        .collect();
    // What is sent here are the numbers themselves: rows are places in the two lists.
    let numbers = |range: &Range<usize>| range.clone().map(|i| i as u32).collect();
    let requests = (0..count)
        .map(|other| Partner { rank: other, send: numbers(&taken[other]), take: numbers(&asked[other]) })
        .collect();
    let lane = peers.open(&Lists::new(requests), 1);
    let mut wanted = vec![0; end];
    peers.send(&lane, &|i, number| number[0] = f64::from(needs[i as usize]));
    peers.take(&lane, &mut |i, number| wanted[i as usize] = number[0] as u32);
    peers.close(lane);
    let own = cut.own(rank);
    if let Some(foreign) = wanted.iter().find(|&&particle| !own.contains(&(particle as usize))) {
        peers.fail(&format!(
            "another peer asks for particle {foreign}, which is none of {own:?}: cuts differ"
        ));
    }
    let partner = |other: usize| Partner {
        rank: other,
        send: wanted[asked[other].clone()].to_vec(),
        take: needs[taken[other].clone()].to_vec(),
    };
    Lists::new((0..count).map(partner).collect())
}

/// The lists of all peers, from what each needs: for who wants to know what a cut costs without running it.
///
/// # Panics
/// If there are not as many needs as the cut has peers, or there is no such particle.
pub fn plan(cut: &Cut, needs: &[Vec<u32>]) -> Vec<Lists> {
    assert_eq!(cut.peers(), needs.len(), "needs of as many peers as the cut has");
    let mut partners: Vec<Vec<Partner>> = vec![Vec::new(); needs.len()];
    for (rank, needs) in needs.iter().enumerate() {
        let needs = ghosts(cut, rank, needs);
        for (owner, taken) in
            by_owner(cut, &needs).into_iter().enumerate().filter(|(_, taken)| !taken.is_empty())
        {
            let taken = &needs[taken];
            with(&mut partners[rank], owner).take = taken.to_vec();
            with(&mut partners[owner], rank).send = taken.to_vec();
        }
    }
    partners.into_iter().map(Lists::new).collect()
}

/// What is needed of others, ascending, each once.
fn ghosts(cut: &Cut, rank: usize, needs: &[u32]) -> Vec<u32> {
    let own = cut.own(rank);
    let mut ghosts: Vec<u32> = needs.iter().copied().filter(|&a| !own.contains(&(a as usize))).collect();
    ghosts.sort_unstable();
    ghosts.dedup();
    if let Some(&last) = ghosts.last() {
        assert!((last as usize) < cut.particles(), "particle {last} is needed, of {}", cut.particles());
    }
    ghosts
}

/// Where in a list of ascending numbers those of each owner stand.
fn by_owner(cut: &Cut, ascending: &[u32]) -> Vec<Range<usize>> {
    let before = |border: usize| ascending.partition_point(|&a| (a as usize) < border);
    (0..cut.peers()).map(|rank| before(cut.own(rank).start)..before(cut.own(rank).end)).collect()
}

/// The partner of this rank, a new one if there is none yet.
fn with(partners: &mut Vec<Partner>, rank: usize) -> &mut Partner {
    let at = partners.iter().position(|partner| partner.rank == rank).unwrap_or(partners.len());
    if at == partners.len() {
        partners.push(Partner { rank, send: Vec::new(), take: Vec::new() });
    }
    &mut partners[at]
}
