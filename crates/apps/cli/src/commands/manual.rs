//! `asperity manual`: man pages and completions of shells.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use clap::{Args, Command};
use clap_complete::Shell;

use crate::program;

/// Write man pages and completions of bash, zsh and fish
#[derive(Debug, Args)]
#[command(
    hide = true,
    after_help = include_str!("../help/manual.txt")
)]
pub struct Manual {
    /// Folder to write to, made if it does not exist
    folder: PathBuf,
}

/// For each shell the folder of its completions.
const SHELLS: [(Shell, &str); 3] = [
    (Shell::Bash, "bash-completion/completions"),
    (Shell::Zsh, "zsh/site-functions"),
    (Shell::Fish, "fish/vendor_completions.d"),
];

impl Manual {
    pub fn run(self) -> Result<()> {
        let mut program = program().disable_help_subcommand(true);
        let write = |folder: &str, write: &mut dyn FnMut(&Path) -> std::io::Result<()>| {
            let folder = self.folder.join(folder);
            let written = fs::create_dir_all(&folder).and_then(|()| write(&folder));
            written.with_context(|| format!("cannot write to {}", folder.display()))
        };
        write("man/man1", &mut |folder| clap_mangen::generate_to(program.clone(), folder))?;
        for (shell, folder) in SHELLS {
            write(folder, &mut |folder| {
                let path = complete(shell, &mut program, folder)?;
                // The name under which bash loads completions by need.
                if shell == Shell::Bash {
                    fs::rename(path, folder.join("asperity"))
                } else {
                    Ok(())
                }
            })?;
        }
        Ok(())
    }
}

fn complete(shell: Shell, program: &mut Command, folder: &Path) -> std::io::Result<PathBuf> {
    clap_complete::generate_to(shell, program, "asperity", OsString::from(folder))
}
