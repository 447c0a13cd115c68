//! Which lanes a pattern of eight bits picks, first of all those that are set.

use super::EIGHT;

/// By pattern: the numbers of the lanes that are set, ascending, a byte each.
pub(super) const PICKED: [[u8; EIGHT]; 256] = {
    let mut all = [[0; EIGHT]; 256];
    let mut pattern = 0;
    while pattern < all.len() {
        let (mut lane, mut place) = (0, 0);
        while lane < EIGHT {
            if pattern >> lane & 1 == 1 {
                all[pattern][place] = lane as u8;
                place += 1;
            }
            lane += 1;
        }
        pattern += 1;
    }
    all
};
