//! The git repository of a class.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use anyhow::{Context, Result, bail};

/// Commits these files of the folder and no others. Makes the repository if there is none.
///
/// Returns whether there was anything to commit.
///
/// # Errors
/// Git is not installed, or fails.
pub(super) fn commit(folder: &Path, message: &str, paths: &[PathBuf]) -> Result<bool> {
    if !folder.join(".git").exists() {
        git(folder, &["init", "--quiet", "--initial-branch=main"], &[])?;
    }
    if paths.is_empty() {
        return Ok(false);
    }
    const THESE: [&str; 2] = ["--pathspec-from-file=-", "--pathspec-file-nul"];
    git(folder, &[&["add", "--force"], &THESE[..]].concat(), paths)?;
    // Git needs a name for the committer. If the user has not set one, the kit uses its own.
    let known = git(folder, &["var", "GIT_COMMITTER_IDENT"], &[]).is_ok();
    let who = ["-c", "user.name=Cutoff", "-c", "user.email=cutoff@localhost"];
    let who = if known { &[][..] } else { &who[..] };
    let commit = ["commit", "--quiet", "--message", message];
    git(folder, &[who, &commit, &THESE].concat(), paths)?;
    Ok(true)
}

/// Runs git in the folder, with these paths as its input.
fn git(folder: &Path, arguments: &[&str], paths: &[PathBuf]) -> Result<()> {
    let mut git = Command::new("git");
    git.current_dir(folder).arg("--literal-pathspecs").args(arguments);
    let git = git.stdin(Stdio::piped()).stdout(Stdio::null()).stderr(Stdio::piped());
    let mut git = git.spawn().context("git did not start: is it installed?")?;
    let names = paths.iter().map(|path| path.display().to_string() + "\0");
    let mut input = git.stdin.take().context("git has no input")?;
    // If git ends before it has read the input, git's output gives the reason.
    let _ = input.write_all(names.collect::<String>().as_bytes());
    drop(input);
    let output = git.wait_with_output()?;
    if !output.status.success() {
        bail!("git {}: {}", arguments[0], String::from_utf8_lossy(&output.stderr).trim());
    }
    Ok(())
}
