//! Any number of threads: the same bits.

use super::{SCENES, common::text, of_the_list, ran};

#[test]
fn two_threads_give_the_bits_of_one() {
    for scene in SCENES {
        let one = of_the_list(scene);
        assert_eq!(one.curve, ran(&text(scene.0), scene.1, 2).curve, "{}", scene.0);
    }
}
