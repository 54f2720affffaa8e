//! Programs of several ranks, run from outside: tests start `mpiexec` as a student does.

mod columns;
mod job;
mod killed;
mod on_each;
mod on_ranks;
mod words;

pub use columns::{join_columns, print_column};
pub use job::{Ended, Job};
pub use killed::ends_when_a_rank_is_killed;
pub use on_each::on_each;
pub use on_ranks::OnRanks;
