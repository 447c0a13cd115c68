//! Any bytes as a file of this format end in a surface or in a refusal.
#![no_main]

use coque::mesh::{Format, parse, report};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let _ = parse("fuzz", Format::Ply, bytes).and_then(|surface| report(&surface));
});
