//! Lab 14's graders.

use lab14::VARIANTS;
use oracle::contest::Kind;
use oracle::{Runs, scenes};

#[path = "lab14/errors.rs"]
mod errors;
#[path = "lab14/repeated.rs"]
mod repeated;

use errors::*;
use repeated::*;

oracle::questions! {
    task_14_1 {
        meetings => "Five simple scenes, 100 official steps: the position of each particle at the end, in cutoffs.",
        official_error = |random, ask| error(random, ask, Kind::Official, 400)
            => "400 particles of an official scene, 100 official steps: the error, which must be at most twice the \
                error of the official step.",
        everyone = |_, ask| entry().keeps_everyone(ask, &scenes::official(), 100)
            => "1,000 particles, 100 steps: the state after each step, with every particle inside the box.",
        two_runs => "The same scene, twice through one engine and once through a new engine: the states at the end, \
                     which may differ by rounding only.",
        memory = |_, ask| entry().keeps_its_memory(ask)
            => "A long run: the memory in use, which must not grow with the number of steps.",
    }
    task_14_2 {
        thin_gas after "14.1" = |random, ask| error(random, ask, Kind::Thin, 1000)
            => "1,000 particles of a thin gas, 100 official steps: the error, which must be at most twice the error of \
                the official step.",
        crowd after "14.1" = |random, ask| error(random, ask, Kind::Crowd, 300)
            => "300 particles of a crowd, 100 official steps: the error, which must be at most twice the error of the \
                official step.",
        few_fast after "14.1" = |random, ask| error(random, ask, Kind::Fast, 400)
            => "400 particles, four of them fast, 100 official steps: the error, which must be at most twice the error \
                of the official step.",
        small_scenes after "14.1" => "1 to 40 particles in a small box, scene after scene through one engine: the \
                                      error, which must be at most twice the error of the official step.",
        flung after "14.1" = |_, ask| entry().keeps_everyone(ask, &scenes::crowd(3), 5)
            => "200 particles that fling each other across a box of side 2.55 cutoffs: the state after each of 5 \
                steps, with every particle inside the box.",
        steps_in_a_row after "14.1" => "100 steps with a read after each step, and the same 100 steps with one read \
                                        after the last: the positions at the end, which may differ by rounding only.",
    }
}

/// Returns runs of the entry.
fn entry() -> Runs {
    Runs::new("14.1", VARIANTS, "entry").threads(2)
}
