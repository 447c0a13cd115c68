//! Any bytes as a file of this format end in a surface or in a refusal.
#![no_main]

use coque::mesh::{Format, parse, parse_body, report, report_body};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let _ = parse("fuzz", Format::Gmsh, bytes).and_then(|surface| report(&surface));
    let _ = parse_body("fuzz", Format::Gmsh, bytes).and_then(|surface| report_body(&surface));
});
