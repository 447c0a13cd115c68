//! A browser on the path, for tests that look at pages as people see them.

use std::io::Write;
use std::path::Path;
use std::process::Command;

/// What browsers of the family are called.
const NAMES: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "chrome"];

/// The browser; none, and a word on the terminal about `what` is left out, where there is none.
///
/// # Panics
/// Under `CI`, where nothing may be left out.
pub fn browser(what: &str) -> Option<&'static str> {
    let answers =
        |name: &&str| Command::new(name).arg("--version").output().is_ok_and(|o| o.status.success());
    let found = NAMES.into_iter().find(answers);
    if found.is_none() {
        let message = format!("*** SKIPPED: none of {} is on the path; {what} ***\n", NAMES.join(", "));
        let strict = std::env::var_os("CI").is_some_and(|value| !value.is_empty());
        assert!(!strict, "{message}under CI a browser is needed: apt-get install chromium");
        // Past the capture of the test runner: what was left out must not look like what passed.
        let _ = std::io::stderr().write_all(message.as_bytes());
    }
    found
}

/// A file, with what follows its name in the address, as a browser without a screen shows it: its elements once it is
/// loaded, and what the browser wrote to its log.
pub fn opened(browser: &str, flags: &[&str], file: &Path, behind: &str) -> (String, String) {
    let profile = file.with_extension("profile");
    let output = Command::new(browser)
        .args(["--headless", "--no-sandbox", "--enable-logging=stderr", "--dump-dom"])
        .args(flags)
        .arg(format!("--user-data-dir={}", profile.display()))
        .arg(format!("file://{}{behind}", file.display()))
        .output();
    let _ = std::fs::remove_dir_all(profile);
    let text = |bytes: Vec<u8>| String::from_utf8_lossy(&bytes).into_owned();
    output.map_or_else(|error| (String::new(), error.to_string()), |o| (text(o.stdout), text(o.stderr)))
}
