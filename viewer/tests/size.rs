//! How large pages get: ten thousand particles in forty frames, a shell and a fluid.

#![allow(clippy::unwrap_used)] // a failed test may stop here

#[allow(dead_code)] // the program that prints a tenfold of it
#[path = "../examples/large_page.rs"]
mod large_page;

#[test]
fn ten_thousand_particles_in_forty_frames_take_three_megabytes() {
    for name in ["shell", "fluid"] {
        let html = viewer::page(large_page::shown(name, [125, 80]).unwrap(), 1 << 30, 1).unwrap().html;
        // 13 of 16 bits a number of a fluid, four numbers a particle and frame, a third more in base64: 3.5 MB at most.
        assert!(html.len() <= 3_500_000, "{name}: {} bytes", html.len());
    }
}
