//! All that the command prints: a terminal that has gone or a log that is full ends no run, and nothing steers a terminal.

use std::io::{self, IsTerminal, Write};
use std::sync::atomic::{AtomicBool, Ordering};

use crate::{Rendering, SceneError, plain_text, render};

/// Whether this process leaves speaking to another.
static SILENT: AtomicBool = AtomicBool::new(false);

/// Prints nothing from here on: another process speaks for this one.
pub fn be_silent() {
    SILENT.store(true, Ordering::Relaxed);
}

/// Prints again.
pub fn speak() {
    SILENT.store(false, Ordering::Relaxed);
}

/// Why a command ends with nothing done, ready to print.
pub struct Refused(String);

impl Refused {
    /// A scene that was refused, drawn; what came from the scene is plain in it.
    pub fn scene(error: &SceneError) -> Self {
        Self(render(error, Rendering { width: 100, colour: io::stderr().is_terminal() }))
    }

    /// Of a failure that another process says.
    pub fn unsaid() -> Self {
        Self(String::new())
    }

    /// With words before it that say whose it is.
    pub fn by(self, whose: &str) -> Self {
        Self(format!("{whose}{}", self.0))
    }

    /// Prints it.
    pub fn say(&self) {
        put(&self.0);
    }
}

impl From<String> for Refused {
    fn from(text: String) -> Self {
        Self(plain_text(&text).into_owned())
    }
}

/// Prints a line to the standard error.
pub fn say(text: &str) {
    put(&format!("{}\n", plain_text(text)));
}

/// Words come after the results: that they cannot be printed changes nothing.
fn put(text: &str) {
    if SILENT.load(Ordering::Relaxed) {
        return;
    }
    let _ = io::stderr().write_all(text.as_bytes());
}

/// Prints to the standard output, whose reader may have gone.
pub fn print(text: &str) -> Result<(), Refused> {
    let mut out = io::stdout();
    match out.write_all(plain_text(text).as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(format!("cannot print: {error}\n").into())
        }
        _ => Ok(()),
    }
}
