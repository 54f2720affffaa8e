//! The timed program: `timed NONCE WORKERS`.
//!
//! It reports that it is ready, waits for an order, and executes it: it makes the scene, passes it
//! to the lab, and sends all particles back. The grader's clock runs from the order to the last
//! particle, so all work in between is timed, and no work can be done before the order. If workers
//! are ranks, all ranks are ready before the first rank reports this.

#![allow(missing_docs)]

use std::env;
use std::io::{self, Write};
use std::process::ExitCode;

mod scene;
mod team;

use team::Team;

/// A request to run a program.
pub struct Order {
    /// Whether to run the serial program of the earlier labs instead of this lab's program.
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
    // If the grader has closed the pipe, the line is empty and there is no further order.
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

/// Executes an order together with the rest of the team.
fn timed(nonce: &str, team: &Team<'_>) -> io::Result<()> {
    if team.is_first() {
        println!("\n@{nonce} ready");
    }
    let message = team.share(if team.is_first() { line() } else { String::new() });
    let Some(order) = order(&message) else { panic!("there is no such order") };
    // x, y, vx, vy of each particle, in the order of ids.
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
    // Wait for the grader, which can read the processor time only while this process exists.
    line();
    Ok(())
}
