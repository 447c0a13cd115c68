//! Which code ran.

use std::process::Command;
use std::sync::OnceLock;

static COMMIT: OnceLock<Option<String>> = OnceLock::new();

/// The commit of the checkout, `+` behind it where tracked files differ from it; none without git or outside a checkout.
pub fn commit() -> Option<String> {
    COMMIT.get_or_init(find).clone()
}

fn find() -> Option<String> {
    let git = |words: &[&str]| {
        let out = Command::new("git").args(words).current_dir(env!("CARGO_MANIFEST_DIR")).output().ok()?;
        out.status.success().then(|| String::from_utf8_lossy(&out.stdout).trim().to_owned())
    };
    let head = git(&["rev-parse", "HEAD"])?;
    let changed = git(&["status", "--porcelain", "--untracked-files=no"])?;
    Some(if changed.is_empty() { head } else { head + "+" })
}
