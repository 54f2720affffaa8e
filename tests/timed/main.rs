//! The timed program: `timed NONCE WORKERS`.
//!
//! It waits for an order, makes the scene, and reports that it is ready. Then it waits for a line of
//! the grader, passes the scene to the lab, and sends all particles back. The grader's clock runs
//! from this line to the last particle. No code of the lab has run before this line, so all of the
//! lab's work is timed. If workers are ranks, all ranks have started before the first rank reports.

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
    /// Kind of the scene, if the discs are soft: [`oracle::contest::Kind::name`].
    pub kind: String,
}

fn order(line: &str) -> Option<Order> {
    let mut words = line.trim_end().splitn(7, ' ');
    Some(Order {
        serial: words.next()? == "serial",
        variant: words.next()?.to_owned(),
        threads: words.next()?.parse().ok()?,
        n: words.next()?.parse().ok()?,
        seed: words.next()?.parse().ok()?,
        steps: words.next()?.parse().ok()?,
        kind: words.next()?.to_owned(),
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
    let next = || team.share(if team.is_first() { line() } else { String::new() });
    let Some(order) = order(&next()) else { panic!("there is no such order") };
    let begin = || {
        if team.is_first() {
            println!("\n@{nonce} ready");
        }
        next();
    };
    // x, y, vx, vy of each particle, in the order of ids.
    let state = scene::run(&order, &begin);
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
