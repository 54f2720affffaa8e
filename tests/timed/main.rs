//! The program whose time is taken: `timed NONCE WORKERS`.
//!
//! It says that it is there, waits for an order, and carries it out: it makes the scene, hands it
//! to the lab, and sends all particles back. The grader's clock runs from the order to the last
//! particle, so whatever is done in between is paid for, and nothing can be done before. Where
//! workers are ranks, all of them are there before the first says so.

#![allow(missing_docs)]

use std::env;
use std::io::{self, Write};
use std::process::ExitCode;

mod scene;
mod team;

use team::Team;

/// What to run.
pub struct Order {
    /// Whether the serial program of the labs before, not this lab's.
    pub serial: bool,
    pub variant: String,
    pub threads: usize,
    pub n: u64,
    pub seed: u32,
    pub steps: u64,
}

fn order(line: &str) -> Option<Order> {
    let mut words = line.split_whitespace();
    Some(Order {
        serial: words.next()? == "serial",
        variant: words.next()?.to_owned(),
        threads: words.next()?.parse().ok()?,
        n: words.next()?.parse().ok()?,
        seed: words.next()?.parse().ok()?,
        steps: words.next()?.parse().ok()?,
    })
}

fn line() -> String {
    let mut line = String::new();
    // A grader that closes the pipe wants no more.
    let _ = io::stdin().read_line(&mut line);
    line
}

fn main() -> ExitCode {
    let mut arguments = env::args().skip(1);
    let nonce = arguments.next().unwrap_or_default();
    let workers = arguments.next().and_then(|workers| workers.parse().ok()).unwrap_or(1);
    team::gather(workers, |team| match timed(&nonce, team) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    })
}

/// Carries out an order together with the rest of the team.
fn timed(nonce: &str, team: &Team<'_>) -> io::Result<()> {
    if team.is_first() {
        println!("\n@{nonce} ready");
    }
    let told = team.share(if team.is_first() { line() } else { String::new() });
    let Some(order) = order(&told) else { panic!("there is no such order") };
    // x, y, vx, vy of each particle, by number.
    let state = scene::run(&order);
    let Some(state) = state else { panic!("there is no variant {}", order.variant) };
    if !team.is_first() {
        return Ok(());
    }
    let mut bytes = Vec::with_capacity(8 * state.len() + 64);
    write!(bytes, "\n@{nonce} state {}\n", 8 * state.len())?;
    state.iter().for_each(|value| bytes.extend_from_slice(&value.to_le_bytes()));
    let mut out = io::stdout().lock();
    out.write_all(&bytes)?;
    out.flush()?;
    drop(out);
    // The grader looks how much the processors did, as long as this process is there.
    line();
    Ok(())
}
