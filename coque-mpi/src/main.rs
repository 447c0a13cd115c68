//! The command `coque-mpi`: what `coque` is, for several processes that a launcher of MPI starts together.

use std::process::ExitCode;

use coque::{ProcessGroup, launched};
use coque_mpi::World;

/// The code of what is refused before anything runs.
const BAD_INPUT: u8 = 2;

fn main() -> ExitCode {
    match World::join() {
        Ok(world) => {
            if let Some(world) = &world {
                world.end_on_panic();
            }
            let group = world.as_ref().map(|world| world as &dyn ProcessGroup);
            coque::command_line_in(group, std::env::args_os()).into()
        }
        Err(error) => {
            // Once is enough.
            if launched().and_then(|launched| launched.rank).unwrap_or(0) == 0 {
                eprintln!("{error}");
            }
            BAD_INPUT.into()
        }
    }
}
