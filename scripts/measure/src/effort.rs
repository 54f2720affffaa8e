//! How long a measurement may take, as the command line says it.

use clap::Args;

/// Steps of a run, and how often it is repeated.
#[derive(Args)]
pub struct Effort {
    /// Time steps of every run [default: as many as the time allows]
    #[arg(long, value_name = "STEPS", value_parser = clap::value_parser!(u64).range(1..))]
    pub steps: Option<u64>,
    /// How often each run is repeated
    #[arg(long, default_value_t = 3, value_name = "ROUNDS", value_parser = clap::value_parser!(u16).range(1..))]
    pub rounds: u16,
    /// Seconds for all runs together, if --steps does not decide; one step each is the least
    #[arg(long, default_value_t = 60.0, value_name = "SECONDS")]
    pub seconds: f64,
}

impl Effort {
    /// Seconds for each of so many runs in each round.
    pub fn share(&self, runs: usize) -> f64 {
        self.seconds / (runs * usize::from(self.rounds)) as f64
    }
}
