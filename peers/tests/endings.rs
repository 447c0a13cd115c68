//! Whoever fails, panics, leaves or calls something else ends all with one message, within a second; nobody hangs.

use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

use peers::{Alone, CHUNK, Cut, Exact, Failure, Greatest, Lane, Lists, Partner, Peers, agree, together};

/// What peers end with; fails if they hang.
fn ending<R: Send + std::fmt::Debug + 'static>(
    count: usize,
    each: impl Fn(Box<dyn Peers>) -> R + Sync + Send + 'static,
) -> Failure {
    let (done, waits) = channel();
    let start = Instant::now();
    thread::spawn(move || done.send(together(count, each)));
    // Far longer than it takes, for a busy machine: what hangs hangs for ever.
    match waits.recv_timeout(Duration::from_secs(20)) {
        Ok(found) => {
            assert!(start.elapsed() < Duration::from_secs(10));
            found.expect_err("a failure")
        }
        Err(RecvTimeoutError::Timeout) => panic!("{count} peers hang"),
        Err(RecvTimeoutError::Disconnected) => panic!("no answer"),
    }
}

/// Both send all they have to both sides of a ring, then take.
fn ring(peers: &dyn Peers) -> Lists {
    let (rank, count) = (peers.rank(), peers.count());
    let mut others = vec![(rank + 1) % count, (rank + count - 1) % count];
    others.sort_unstable();
    others.dedup();
    others.retain(|&other| other != rank);
    let partner = |other: usize| Partner { rank: other, send: vec![rank as u32], take: vec![other as u32] };
    Lists::new(others.into_iter().map(partner).collect())
}

/// Steps of sums and rows; in one of them one peer does something else.
fn march(mut peers: Box<dyn Peers>, odd: usize, step: usize, what: impl Fn(&mut dyn Peers)) {
    let lists = ring(&*peers);
    let lane = peers.open(&lists, 2);
    for now in 0..10 {
        if peers.rank() == odd && now == step {
            what(&mut *peers);
        }
        peers.send(&lane, &|_, row| row.fill(1.0));
        peers.take(&lane, &mut |_, _| {});
        peers.add(&mut [Exact::new()], &mut []);
        peers.greatest(&mut [Greatest::NONE]);
    }
}

#[test]
fn who_fails_ends_all() {
    for count in 1..=7 {
        for odd in [0, count - 1] {
            let failure =
                ending(count, move |peers| march(peers, odd, 3, |peers| peers.fail("the disk is full")));
            assert_eq!(failure, Failure { rank: odd, count, message: "the disk is full".to_owned() });
            assert_eq!(failure.to_string(), format!("peer {odd} of {count}: the disk is full"));
        }
    }
}

#[test]
fn who_panics_ends_all() {
    for count in 1..=7 {
        let odd = count / 2;
        let failure = ending(count, move |peers| march(peers, odd, 2, |_| panic!("index {} of {}", 7, 3)));
        assert_eq!(failure, Failure { rank: odd, count, message: "index 7 of 3".to_owned() });
        // While rows are written.
        let failure = ending(count, move |mut peers| {
            let lists = ring(&*peers);
            let lane = peers.open(&lists, 1);
            peers.send(&lane, &|_, _| panic!("a row"));
            peers.take(&lane, &mut |_, _| {});
            assert!(peers.count() > 1, "a row");
        });
        assert_eq!(failure.message, "a row");
    }
}

/// One returns while others count on it: in a sum, and on a lane.
#[test]
fn who_leaves_ends_all() {
    for count in 2..=7 {
        let failure = ending(count, |mut peers| {
            if peers.rank() > 0 {
                peers.add(&mut [], &mut []);
            }
        });
        assert!(failure.message.starts_with("no peer can go on: Left, Meets"), "{failure}");
        let failure = ending(count, |mut peers| {
            let lists = ring(&*peers);
            let lane = peers.open(&lists, 1);
            if peers.rank() > 0 {
                peers.send(&lane, &|_, row| row.fill(0.0));
                peers.take(&lane, &mut |_, _| {});
            }
        });
        assert!(failure.message.contains("Takes { lane: 0, from: 0 }"), "{failure}");
    }
}

/// Others do something that can never meet.
#[test]
fn who_does_something_else_ends_all() {
    let failure = ending(3, |mut peers| match peers.rank() {
        1 => peers.greatest(&mut [Greatest::NONE]),
        _ => peers.add(&mut [], &mut [0]),
    });
    assert!(failure.message.contains("where another peer calls"), "{failure}");
    let failure = ending(2, |mut peers| {
        let sums = peers.rank() + 1;
        peers.add(&mut vec![Exact::new(); sums], &mut []);
    });
    assert!(failure.message.contains("sums: 1") && failure.message.contains("sums: 2"), "{failure}");
    // One waits for rows, the other for all.
    let failure = ending(2, |mut peers| {
        let lists = ring(&*peers);
        let lane = peers.open(&lists, 1);
        if peers.rank() == 0 {
            peers.send(&lane, &|_, row| row.fill(0.0));
            peers.take(&lane, &mut |_, _| {});
        }
        peers.add(&mut [], &mut []);
    });
    assert!(failure.message.contains("Takes { lane: 0, from: 1 }, Meets"), "{failure}");
}

#[test]
fn lanes_that_do_not_fit_are_refused() {
    let lists = |rank: usize, send: usize, take: usize| {
        Lists::new(vec![Partner { rank, send: vec![0; send], take: vec![0; take] }])
    };
    let open = move |given: fn(usize) -> (usize, usize, usize), width: usize| {
        ending(2, move |mut peers| {
            let (other, send, take) = given(peers.rank());
            peers.open(&lists(other, send, take), width)
        })
        .message
    };
    let found = open(|rank| (1 - rank, 4, if rank == 0 { 4 } else { 5 }), 3);
    assert_eq!(found, "peer 0 sends 4 rows of which 5 are taken");
    let found = open(|rank| (1 - rank, if rank == 1 { 2 } else { 0 }, 0), 3);
    assert_eq!(found, "peer 1 sends 2 rows of which 0 are taken");
    assert_eq!(open(|_| (2, 1, 1), 3), "a lane to peer 2, which is no other of 2");
    assert!(open(|rank| (rank, 1, 1), 3).ends_with("which is no other of 2"));
    assert_eq!(open(|rank| (1 - rank, 1, 1), 0), "a lane for rows of no numbers");
    assert!(std::panic::catch_unwind(|| lists(0, 1, 0)).is_ok_and(|lists| lists.ghosts() == 0));
    assert!(std::panic::catch_unwind(|| Alone.open(&lists(1, 1, 1), 1)).is_err());
}

fn send(peers: &mut dyn Peers, lane: &Lane) {
    peers.send(lane, &|_, row| row.fill(0.0));
}

#[test]
fn a_lane_is_sent_on_and_taken_from_in_turn() {
    let used = |how: fn(&mut dyn Peers, &Lane)| {
        ending(3, move |mut peers| {
            let lists = ring(&*peers);
            let lane = peers.open(&lists, 1);
            how(&mut *peers, &lane);
            peers.close(lane);
        })
        .message
    };
    let twice = used(|peers, lane| {
        send(peers, lane);
        send(peers, lane);
    });
    assert_eq!(twice, "lane 0 was sent on and not taken from");
    assert_eq!(used(|peers, lane| peers.take(lane, &mut |_, _| {})), "a take on lane 0 without a send");
    assert_eq!(used(send), "lane 0 was sent on and not taken from");
    let closed = used(|peers, lane| {
        peers.close(Lane::numbered(lane.number()));
        send(peers, lane);
    });
    assert_eq!(closed, "lane 0 is not open");
    // Agreeing on lists leaves no lane open.
    let failure = ending(2, |mut peers| {
        agree(&mut *peers, &Cut::even(2 * CHUNK, 2), &[0, CHUNK as u32]);
        send(&mut *peers, &Lane::numbered(0));
    });
    assert_eq!(failure.message, "lane 0 is not open");
}

#[test]
fn cuts_that_differ_are_refused() {
    let particles = 4 * CHUNK;
    let failure = ending(2, move |mut peers| {
        // Each thinks that the other has what it has itself.
        let border = if peers.rank() == 0 { CHUNK } else { 3 * CHUNK };
        agree(&mut *peers, &Cut::at(vec![0, border, particles]), &[2 * CHUNK as u32])
    });
    assert!(failure.message.contains("cuts differ"), "{failure}");
    let failure = ending(2, |mut peers| {
        let rows = &mut [0.0; 10];
        peers.gather(&Cut::even(5, 3), rows, 2);
    });
    assert_eq!(failure.message, "10 numbers in rows of 2, of 3 peers with 5 particles");
}

/// All that is left of a wait when another ends the march: no message of its own.
#[test]
fn the_first_message_counts() {
    let failure = ending(5, |peers| {
        if peers.rank() != 2 {
            thread::sleep(Duration::from_millis(50));
            peers.fail("later");
        }
        peers.fail("first");
    });
    assert_eq!((failure.rank, failure.message.as_str()), (2, "first"));
}
