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
        meetings => "Five simple scenes, 100 official steps: where the particles are, in cutoffs.",
        official_error = |random, ask| error(random, ask, Kind::Official, 400)
            => "400 particles of an official scene, 100 official steps: at most twice the official step's error.",
        everyone = |_, ask| entry().keeps_everyone(ask, &scenes::official(), 100)
            => "1,000 particles, 100 steps: after each step every particle is there, inside the box.",
        two_runs => "The same scene twice through one engine and once through a new one: the same motion up to rounding.",
        memory = |_, ask| entry().keeps_its_memory(ask)
            => "A long run: the memory that it holds does not grow with the number of steps.",
    }
    task_14_2 {
        thin_gas after "14.1" = |random, ask| error(random, ask, Kind::Thin, 1000)
            => "1,000 particles of a thin gas, 100 official steps: at most twice the official step's error.",
        crowd after "14.1" = |random, ask| error(random, ask, Kind::Crowd, 300)
            => "300 particles of a crowd, 100 official steps: at most twice the official step's error.",
        few_fast after "14.1" = |random, ask| error(random, ask, Kind::Fast, 400)
            => "400 particles, of which four are fast, 100 official steps: at most twice the official step's error.",
        small_scenes after "14.1" => "1 to 40 particles in a small box, scene after scene through one engine: at most \
                                      twice the official step's error.",
        flung after "14.1" = |_, ask| entry().keeps_everyone(ask, &scenes::crowd(3), 5)
            => "200 particles in a box of 2.55 cutoffs, which fling each other through it: after each of 5 steps every \
                particle is there, inside the box.",
        steps_in_a_row after "14.1" => "100 single steps, and the same 100 in a row: the same motion.",
    }
}

/// Returns runs of the entry.
fn entry() -> Runs {
    Runs::new("14.1", VARIANTS, "entry").threads(2)
}
