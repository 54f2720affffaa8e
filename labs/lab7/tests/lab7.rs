//! Lab 7's graders.

use common::hard::Scene;
use hard_discs::{Square, Survey};
use lab7::{VARIANTS, choose_windows};
use oracle::hard::{Runs, scenes};
use oracle::{Ask, Random};

#[path = "lab7/boxes.rs"]
mod boxes;
#[path = "lab7/cells.rs"]
mod cells;
#[path = "lab7/choices.rs"]
mod choices;
#[path = "lab7/collisions.rs"]
mod collisions;
#[path = "lab7/examples.rs"]
mod examples;
#[path = "lab7/interrupted.rs"]
mod interrupted;
#[path = "lab7/loops.rs"]
mod loops;
#[path = "lab7/meetings.rs"]
mod meetings;
#[path = "lab7/pairs.rs"]
mod pairs;
#[path = "lab7/parts.rs"]
mod parts;
#[path = "lab7/program.rs"]
mod program;
#[path = "lab7/search_examples.rs"]
mod search_examples;
#[path = "lab7/steps.rs"]
mod steps;
#[path = "lab7/teams.rs"]
mod teams;
#[path = "lab7/walls.rs"]
mod walls;
#[path = "lab7/words.rs"]
mod words;

use boxes::*;
use cells::*;
use choices::*;
use collisions::*;
use examples::*;
use interrupted::*;
use loops::*;
use meetings::*;
use pairs::*;
use parts::*;
use search_examples::*;
use steps::*;
use teams::*;
use walls::*;

oracle::questions! {
    task_7_1 {
        wall_table => "A disc of radius 1 in a square of side 10, so centres are from 1 to 9: when it hits a wall in this \
                       step, and which.",
        walls => "A disc anywhere in any square: λ, what it hits, and which disc it is; no numbers if it hits nothing.",
    }
    task_7_2 {
        touch_table => "Two discs of radius 1, the second at d and with velocity D as the first one sees it: when they \
                        touch in this step.",
        meetings => "Two discs anywhere, of any size and speed: λ when they touch, no number if they do not.",
        contacts => "Two discs in contact, nearly so, overlapping, grazing, or at the end of the step: λ when they touch, \
                     no number if they do not.",
    }
    task_7_3 {
        order_table => "Two candidates: whether the first one is taken before the other or after it.",
        orders => "Any two candidates: the first comes before the second (-1), after it (1), or is the same (0).",
    }
    task_7_4 {
        take_table after "7.3" => "Six candidates in the order in which they were found: which are taken, and as which.",
        single_takes => "One candidate and which discs are free: what is taken, and which discs are free then.",
        takes_of_walls after "7.3" => "Discs that each hit a wall: all of these candidates are taken.",
        takes after "7.3" => "Candidates in any order: those that are taken, in order of time, and which discs are free then.",
        many_takes after "7.3" => "A million candidates: how many are taken. Comparing every two of them does not come to an \
                                   end.",
    }
    task_7_5 {
        stop_table => "A disc of radius 1 that has collided in a square of side 10, so centres are from 1 to 9: where it \
                       waits.",
        stops => "A disc inside or beyond walls, in any square: where it waits, x y vx vy.",
    }
    task_7_6 {
        collision_table after "7.5" => "Discs of radius 1 that collide at λ = 1/2 in a square of side 20: where they are \
                                        before the step and after it, and their collisions.",
        bounces after "7.5" => "A disc that hits walls: x y vx vy after the step, its collisions with discs and with walls.",
        collisions after "7.5" => "Two discs that touch: x y vx vy of each after the step, and its collisions.",
        pushes after "7.5" => "A disc that is pushed at a wall behind it: where it waits, and its collisions.",
    }
    task_7_7 {
        step_table after "7.1, 7.2, 7.3, 7.4, 7.5, 7.6"
            => "Four discs of radius 1 in a square of side 20: before a step and after it. Disc 3 would touch disc 1 at \
                λ = 9/13, when disc 1 has met disc 0 already.",
        windows after "7.3, 7.4" => "A window of a step: the first wall of a later window, and the first disc of each \
                                     collision that is taken.",
        several_steps after "7.1, 7.2, 7.3, 7.4, 7.5, 7.6" => "Eight steps of one disc or two: a step begins with nothing \
                                                              taken.",
        steps_in_windows after "7.1, 7.2, 7.3, 7.4, 7.5, 7.6"
            => "A step that is cut into windows: what the finder is asked, what happens, and where all discs end.",
        lattices after "7.1, 7.2, 7.3, 7.4, 7.5, 7.6"
            => "A hundred lattices, where many collisions are at exactly the same time: one step of each.",
        crowded after "7.1, 7.2, 7.3, 7.4, 7.5, 7.6"
            => "Twenty crowded scenes of 400 discs: each of 20 steps, from where the program itself was before the step.",
        crafted after "7.1, 7.2, 7.3, 7.4, 7.5, 7.6" => "Scenes of all kinds, by name: each of 10 steps.",
        unseen after "7.1, 7.2, 7.3, 7.4, 7.5, 7.6"
            = |_, ask| sequential().threads(2).follows_unseen_scenes(ask)
            => "Forty scenes from thin to crowded: each of 3 steps.",
        memory after "7.1, 7.2, 7.3, 7.4, 7.5, 7.6" = |_, ask| sequential().keeps_its_memory(ask)
            => "A long run: the memory that it holds does not grow with the number of steps.",
        bad_input => "The program and a bad input: one line of error, which names the line of the input.",
        many_discs = many_discs_of_sequential
            => "The program and 12,000 discs, in a gigabyte: memory grows with the discs, not with their pairs.",
    }
    task_7_8 {
        part_table => "The iterations of a loop, in fixed parts and from the queue: who does which.",
        parts => "A loop of any length in fixed parts: begin and end of each part.",
        queues => "A loop of any length from the queue: begin and end of each part, and nothing after the end.",
        interrupted_queue => "Two workers at one queue, the second takes a part at a load or before a store of the first: \
                              begin and end of each part.",
    }
    task_7_9 {
        loop_table after "7.8" => "Six discs, two workers, fixed parts: which list each pair of discs 1 and 3 comes into, if \
                                   the outer loop is shared out, the inner one, or both.",
        fixed_loops after "7.8" => "Any number of discs and workers, fixed parts: which list each pair comes into.",
        queued_loops after "7.8" => "Any number of discs and workers, a queue: all parts of rows, each once.",
        held_up after "7.8" => "Rows from a queue, in parts of one row and of several, while one worker is held up: the rows \
                                that the other worker does.",
        fresh_teams after "7.8" => "Both loops shared out: each row has a team of its own.",
        shared_loops after "7.8" => "A team of threads: all look at pairs, and none at nearly all.",
        pairs_of_loops after "7.2, 7.8" => "Scenes of all kinds, two threads: the pairs that are found.",
    }
    task_7_10 {
        slot_table => "Three candidates, one after another, into a list under a lock and one without: what is in the slots \
                       that count.",
        appends => "Any number of candidates, one after another: the slots that are used, and what is in them.",
        interrupted_lock => "Two workers append under a lock, the second when the first has given the lock back: all \
                             candidates are in the list.",
        short_lock => "A candidate is appended under a lock: it is written when the lock has been given back.",
        no_lock => "Two workers append without a lock: neither waits for the other.",
        interrupted_count => "Two workers append without a lock, the second at a load or before a store of the first: all \
                              candidates are in the list.",
        pairs_in_one_list after "7.2, 7.8, 7.9" => "Scenes of all kinds, three threads and one list: the pairs that are \
                                                    found.",
    }
    task_7_11 {
        span_table => "A disc along one axis in a window of the step: the box that it can touch, from low to high.",
        spans => "Any disc and any window: low and high of its box.",
    }
    task_7_12 {
        block_table => "A box in a square of side 8, whose small blocks are 2 wide: its block, and the blocks around that.",
        look_table => "Five discs and their blocks: how often the search looks at each pair. Once if the two may meet, \
                       shown with the lower disc.",
        blocks => "Any box in any square: its block; and the blocks around each block.",
        looks_around => "Discs in any blocks: each pair that may meet, once.",
        pairs_of_grid after "7.2, 7.8, 7.11" => "Scenes of all kinds, the grid: the pairs that are found.",
    }
    task_7_13 {
        partner_table => "Seven boxes in rows of ten columns, sorted by row and column: the entries behind each one that share \
                          a column with it.",
        columns => "Boxes in any cells: the first entry that shares a column with an entry, and the first behind these.",
        far_columns => "Cells whose numbers need more than 32 bits: the entries that share a column.",
        many_columns => "A million boxes: how often two share a column. Looking at all the rest for each does not come to an \
                         end.",
        pairs_of_cells after "7.2, 7.11" => "Scenes of all kinds, sorted cells in windows: the pairs that are found.",
    }
    task_7_14 {
        window_table => "A thousand discs: what a step costs in some numbers of windows, and which number is chosen. An entry \
                         costs 60; a pair 1 and, if it is asked, 10 more, both times the crowding.",
        plans => "Discs slow and fast, thin and dense: no other number of windows costs less.",
        unseen after "7.1, 7.2, 7.3, 7.4, 7.5, 7.6, 7.7, 7.11, 7.13" = |_, ask| planned().follows_unseen_scenes(ask)
            => "Forty scenes from thin to crowded, in windows: each of 3 steps.",
        memory after "7.1, 7.2, 7.3, 7.4, 7.5, 7.6, 7.7, 7.11, 7.13" = |_, ask| planned().keeps_its_memory(ask)
            => "A long run: the memory that it holds does not grow with the number of steps.",
        many_discs = many_discs_of_planned
            => "The program and 50,000 discs, in a gigabyte: memory grows with the discs, not with their pairs.",
        same_bits after "7.1, 7.2, 7.3, 7.4, 7.5, 7.6, 7.7, 7.8, 7.9, 7.10, 7.11, 7.12, 7.13"
            => "Every program of the lab, on any number of threads: the bits of the sequential one.",
        strips after "7.1, 7.2, 7.3, 7.4, 7.5, 7.6, 7.7, 7.11, 7.13"
            => "9,000 discs in many strips, on any number of threads: the bits of the sequential program.",
    }
}

/// Returns runs of the variant `sequential`.
fn sequential() -> Runs {
    Runs::new("7.7", VARIANTS, "sequential")
}

/// Returns runs of the variant `planned`.
fn planned() -> Runs {
    // Runs this task's function first, so that an unsolved starter stops at this task's `todo!`.
    let scene = one_disc();
    let square = Square::of(&scene);
    choose_windows(&Survey::of(scene.discs(), square), square, 1.0);
    Runs::new("7.14", VARIANTS, "planned").threads(2)
}

fn one_disc() -> Scene {
    scenes::of(10.0, 1.0, &[(5.0, 5.0, 0.0, 0.0)])
}

fn lattices(_: &mut Random, ask: &mut impl Ask) {
    for seed in 0..100 {
        sequential().resynchronised(ask, &format!("lattice {seed}"), &scenes::lattice(seed), 1);
    }
}

fn crowded(_: &mut Random, ask: &mut impl Ask) {
    for seed in 0..20 {
        let scene = scenes::random(400, 0.3, 2.0, 1000 + seed);
        sequential().resynchronised(ask, &format!("crowded {seed}"), &scene, 20);
    }
}

fn crafted(_: &mut Random, ask: &mut impl Ask) {
    for (name, scene) in scenes::all() {
        sequential().resynchronised(ask, name, &scene, 10);
    }
}

/// Asks for a step of one disc, so that an unsolved starter stops at the task's `todo!` and not at
/// a `todo!` in the program.
fn steps_alone(runs: &Runs) {
    runs.run(|engine| {
        engine.load(&one_disc());
        engine.step();
    });
}

fn bad_input(_: &mut Random, ask: &mut impl Ask) {
    ask.in_tests_only(|| {
        steps_alone(&sequential());
        program::refuses_bad_input();
    });
}

/// Checks that `sequential` fits into one gigabyte, which a list of all pairs exceeds.
fn many_discs_of_sequential(_: &mut Random, ask: &mut impl Ask) {
    ask.in_tests_only(|| {
        steps_alone(&sequential());
        program::fits_into_memory("sequential", "12000");
    });
}

/// Checks that `planned` fits into one gigabyte. A byte for each pair needs more, so the report's
/// programs crash at this N.
fn many_discs_of_planned(_: &mut Random, ask: &mut impl Ask) {
    ask.in_tests_only(|| {
        steps_alone(&planned());
        program::fits_into_memory("planned", "50000");
    });
}

fn same_bits(_: &mut Random, ask: &mut impl Ask) {
    planned();
    let first = Runs::new("7.14", VARIANTS, "sequential");
    for (name, scene) in scenes::all() {
        for variant in VARIANTS {
            let runs = Runs::new("7.14", VARIANTS, variant.name);
            // Starting a fresh team for each inner loop is slow.
            let is_slow = variant.name.starts_with("nested") && scene.len() > 100;
            let threads = if is_slow { &[1, 2][..] } else { &[1, 2, 3, 4, 8] };
            let programs: Vec<Runs> = threads.iter().map(|&on| runs.clone().threads(on)).collect();
            first.same_bits(ask, &programs, (name, &scene), 6);
        }
    }
}

/// Returns a scene whose density grows towards the bottom, so that strips differ in their numbers
/// of rows.
fn uneven(n: usize) -> Scene {
    let mut random = Random::new(716);
    let mut discs = Vec::new();
    for _ in 0..n {
        let x = random.between(1.0, 999.0);
        let up = random.between(0.0, 1.0);
        let [vx, vy] = [(); 2].map(|()| random.between(-30.0, 30.0));
        discs.push((x, 1.0 + 998.0 * up * up * up, vx, vy));
    }
    scenes::of(1000.0, 1.0, &discs)
}

/// Asks for scenes with enough discs for many strips, and for loops in several pieces.
fn strips(_: &mut Random, ask: &mut impl Ask) {
    planned();
    let first = Runs::new("7.14", VARIANTS, "sequential");
    for (name, scene) in [
        ("dense", scenes::random(9000, 0.6, 3.0, 9)),
        ("sparse", scenes::random(9000, 0.001, 1.0, 10)),
        ("fast", scenes::fast(9000, 11)),
        ("uneven", uneven(9000)),
        ("one disc", one_disc()),
    ] {
        let mut programs = Vec::new();
        for variant in ["cells", "planned"] {
            let runs = Runs::new("7.14", VARIANTS, variant);
            programs.extend([1, 2, 3, 8].map(|threads| runs.clone().threads(threads)));
        }
        first.same_bits(ask, &programs, (name, &scene), 2);
    }
}
