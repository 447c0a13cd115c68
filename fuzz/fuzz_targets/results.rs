//! Any bytes as a frame, as a list of frames or as a curve end in a picture or in a refusal.
#![no_main]

use std::fs;
use std::path::PathBuf;
use std::sync::LazyLock;

use coque::{Curve, Picture, Sheet, listed, picture_svg, plot_svg};

/// A folder of this process.
static FOLDER: LazyLock<PathBuf> = LazyLock::new(|| {
    let folder = std::env::temp_dir().join(format!("coque-fuzz-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder for files");
    folder
});

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let file = FOLDER.join("result");
    fs::write(&file, bytes).expect("room for a file");
    let _ = listed(&file);
    if let Ok(sheet) = Sheet::read(&file) {
        let _ = picture_svg(&sheet, &Picture::new("fuzz"));
    }
    if let Ok(text) = str::from_utf8(bytes)
        && let Ok(curve) = text.parse::<Curve>()
    {
        let name = |i: usize| curve.columns.get(i).map_or("", |column| &column.name);
        let _ = plot_svg(&curve, name(0), name(1), "fuzz", &FOLDER.join("curve.svg"));
    }
});
