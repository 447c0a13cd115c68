//! `coque completion`, `coque man`: what a shell and a manual know of the command, made from its own words.

use clap::{Args, Command};
use clap_complete::{Shell, generate};
use clap_mangen::Man;

use super::stderr::{Refused, print};

#[derive(Args)]
pub struct Completion {
    /// The shell.
    shell: Shell,
}

pub const COMPLETION_HELP: &str = "\
Examples:
  bash        coque completion bash > ~/.local/share/bash-completion/completions/coque
  zsh         coque completion zsh > ~/.zfunc/_coque, with fpath+=~/.zfunc before compinit in ~/.zshrc
  fish        coque completion fish > ~/.config/fish/completions/coque.fish
  PowerShell  coque completion powershell >> $PROFILE";

pub const MAN_HELP: &str = "\
Examples:
  coque man | man -l -                                           read it
  coque man > ~/.local/share/man/man1/coque.1                    then: man coque";

/// Prints the completion of a shell.
pub fn completion(completion: &Completion, mut command: Command) -> Result<(), Refused> {
    let mut text = Vec::new();
    generate(completion.shell, &mut command, "coque", &mut text);
    print(&String::from_utf8_lossy(&text))
}

/// Prints the manual page: the command, then each of its words.
pub fn man(command: &Command) -> Result<(), Refused> {
    let mut text = Vec::new();
    let unwritten = |error: std::io::Error| Refused::from(format!("cannot write the page: {error}\n"));
    let all = Man::new(command.clone());
    all.render_title(&mut text).map_err(unwritten)?;
    all.render_name_section(&mut text).map_err(unwritten)?;
    all.render_synopsis_section(&mut text).map_err(unwritten)?;
    all.render_extra_section(&mut text).map_err(unwritten)?;
    for word in command.get_subcommands().filter(|word| word.get_name() != "help") {
        let title = format!(".SH \"coque {}\"\n", word.get_name());
        text.extend(title.to_uppercase().replace("COQUE", "coque").into_bytes());
        let page = Man::new(word.clone());
        page.render_description_section(&mut text).map_err(unwritten)?;
        page.render_options_section(&mut text).map_err(unwritten)?;
        page.render_extra_section(&mut text).map_err(unwritten)?;
    }
    print(&String::from_utf8_lossy(&text))
}
