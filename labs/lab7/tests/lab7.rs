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
        wall_table => "A disc of radius 1 in a square of side 10, so that its centre moves from 1 to 9: (1) the time \
                       λ at which it hits a wall in this step, (2) the wall.",
        walls => "A disc anywhere in any square: (1) the time λ of its first wall collision, (2) the kind of \
                  collision, (3) the disc. No numbers if it hits no wall.",
    }
    task_7_2 {
        touch_table => "Two discs of radius 1. As seen from the first disc, the second is at d and has the velocity \
                        D: the time λ at which they touch in this step.",
        meetings => "Two discs anywhere, of any size and speed: the time λ at which they touch, or no number if they \
                     do not touch.",
        contacts => "Two discs that are in contact or nearly in contact, that overlap, that graze each other, or that \
                     touch at the end of the step: the time λ at which they touch, or no number if they do not touch.",
    }
    task_7_3 {
        order_table => "Two candidates: whether the first candidate is taken before the second or after it.",
        orders => "Any two candidates: -1 if the first candidate is taken before the second, 1 if after the second, 0 \
                   if the two are the same.",
    }
    task_7_4 {
        take_table after "7.3" => "Six candidates in the order in which they were found: the candidates that are \
                                   taken, in the order in which they are taken.",
        single_takes => "One candidate, and the discs that are free: (1) the candidates taken afterwards, (2) the \
                         discs that are still free.",
        takes_of_walls after "7.3" => "Discs that each hit a wall: the candidates that are taken. All candidates must \
                                       be taken.",
        takes after "7.3" => "Candidates in any order: (1) the candidates taken, in the order of time, (2) the discs \
                              that are still free.",
        many_takes after "7.3" => "A million candidates: the number of candidates taken. A program that compares each \
                                   candidate with all others would not finish.",
    }
    task_7_5 {
        stop_table => "A disc of radius 1 that has collided in a square of side 10, so that its centre moves from 1 \
                       to 9: the position at which the disc waits.",
        stops => "A disc inside a square or beyond its walls: the position at which the disc waits, and its velocity \
                  (x y vx vy).",
    }
    task_7_6 {
        collision_table after "7.5" => "Discs of radius 1 that collide at λ = 1/2 in a square of side 20: (1) their \
                                        states before and after the step, (2) their numbers of collisions.",
        bounces after "7.5" => "A disc that hits walls: (1) x y vx vy after the step, (2) its number of collisions \
                                with discs, (3) its number of collisions with walls.",
        collisions after "7.5" => "Two discs that touch: for each disc, (1) x y vx vy after the step, (2) its number \
                                   of collisions with discs, (3) its number of collisions with walls.",
        pushes after "7.5" => "A disc that is pushed back against a wall behind it: (1) x y vx vy after the step, \
                               (2) its number of collisions with discs, (3) its number of collisions with walls.",
    }
    task_7_7 {
        step_table after "7.1, 7.2, 7.3, 7.4, 7.5, 7.6"
            => "Four discs of radius 1 in a square of side 20: their states before and after a step. Without disc 0, \
                disc 3 would touch disc 1 at λ = 9/13, but disc 1 meets disc 0 earlier.",
        windows after "7.3, 7.4" => "A window of a step: (1) the index of the first wall collision of a later window, \
                                     (2) the first disc of each collision taken.",
        several_steps after "7.1, 7.2, 7.3, 7.4, 7.5, 7.6" => "One or two discs, for eight steps: the state after \
                                                               each step. No collision may be left over from the step \
                                                               before.",
        steps_in_windows after "7.1, 7.2, 7.3, 7.4, 7.5, 7.6"
            => "A step that is divided into windows: (1) the number of times that the finder is asked for the number \
                of windows, (2) the windows for which the finder is called, (3) the collisions, (4) the state of \
                each disc at the end.",
        lattices after "7.1, 7.2, 7.3, 7.4, 7.5, 7.6"
            => "A hundred lattices, in which many collisions happen at exactly the same time: the state of each \
                lattice after one step.",
        crowded after "7.1, 7.2, 7.3, 7.4, 7.5, 7.6"
            => "Twenty crowded scenes of 400 discs: the state after each of 20 steps. The test's model starts each \
                step from the state that your program had before the step.",
        crafted after "7.1, 7.2, 7.3, 7.4, 7.5, 7.6" => "Scenes of all kinds, by name: the state after each of 10 \
                                                         steps.",
        unseen after "7.1, 7.2, 7.3, 7.4, 7.5, 7.6"
            = |_, ask| sequential().threads(2).follows_unseen_scenes(ask)
            => "Forty scenes, from sparse to crowded: the state after each of 3 steps.",
        memory after "7.1, 7.2, 7.3, 7.4, 7.5, 7.6" = |_, ask| sequential().keeps_its_memory(ask)
            => "A long run: the memory in use, which must not grow with the number of steps.",
        bad_input => "The lab's program and bad inputs: the program's error. It must be one line, which names the \
                      wrong line of the input.",
        many_discs = many_discs_of_sequential
            => "The lab's program and 12,000 discs: a step in one gigabyte of memory. Memory may grow with the number \
                of discs, but not with the number of pairs.",
    }
    task_7_8 {
        part_table => "The iterations of a loop: (1) the iterations that each worker does in fixed parts, (2) the \
                       iterations that each call takes from the queue.",
        parts => "A loop of any length in fixed parts: the begin and the end of each worker's part.",
        queues => "A loop of any length from the queue. Sometimes the first iterations are taken already: the begin \
                   and the end of each part. No part may come after the end of the loop.",
        interrupted_queue => "Two workers take parts from one queue. The second worker takes a part just before \
                              and just after the first changes the count: the begin and the end of each part.",
    }
    task_7_9 {
        loop_table after "7.8" => "Six discs, two workers and fixed parts: the list that receives each pair of discs \
                                   1 and 3, if the workers share the outer loop, the inner loop, or both loops.",
        fixed_loops after "7.8" => "Any number of discs and workers, and fixed parts: the list that receives each \
                                    pair.",
        queued_loops after "7.8" => "Any number of discs and workers, and a queue: the parts of each row. Each pair \
                                     must be in exactly one part.",
        held_up after "7.8" => "Rows from a queue, in parts of one row and of several rows, while one worker is \
                                delayed: the rows that the other worker does.",
        fresh_teams after "7.8" => "Both loops are shared, and each row has its own team: the number of rows whose \
                                    second worker (1) is a thread of the outer team, (2) was the second worker of \
                                    another row before. Both must be 0.",
        shared_loops after "7.8" => "A team of threads: the number of threads that test pairs. All threads must test \
                                     pairs, and no thread may test nearly all of them.",
        pairs_of_loops after "7.2, 7.8" => "Scenes of all kinds, and two threads: the pairs found.",
    }
    task_7_10 {
        slot_table => "Three candidates that are appended one after another, with a lock and without a lock: the \
                       candidates in the slots in use.",
        appends => "Any number of candidates, appended one after another: (1) the number of slots in use, (2) the \
                    candidates in these slots.",
        interrupted_lock => "Two workers that append under a lock. The second worker appends whenever the first has \
                             released the lock: the candidates in the list. No candidate may be missing.",
        short_lock => "A candidate that is appended under a lock: the content of its slot when the lock is released. \
                       The slot must not be written until then.",
        no_lock => "Two workers that append without a lock: whether one worker must wait for the other. It is an \
                    error if either has to wait.",
        interrupted_count => "Two workers that append without a lock. The second worker appends just before and just \
                              after the first changes the count: the candidates in the list. No candidate may be \
                              missing.",
        pairs_in_one_list after "7.2, 7.8, 7.9" => "Scenes of all kinds, three threads and one list: the pairs found.",
    }
    task_7_11 {
        span_table => "A disc along one axis in a window of the step: the low end and the high end of the box that \
                       the disc can touch.",
        spans => "Any disc and any window: the low end and the high end of the disc's box.",
    }
    task_7_12 {
        block_table => "A box in a square of side 8, whose small blocks have the side 2: (1) the block of the box, \
                        (2) the blocks around that block.",
        look_table => "Five discs and their blocks: the number of times that the search tests each pair, in the row \
                       of the disc with the lower number. A pair that may meet must be tested once.",
        blocks => "Any box in any square: (1) the block of the box, (2) for each block, the blocks around it.",
        looks_around => "Discs in any blocks: the pairs tested. Each pair that may meet must be tested once.",
        pairs_of_grid after "7.2, 7.8, 7.11" => "Scenes of all kinds, and the grid: the pairs found.",
    }
    task_7_13 {
        partner_table => "Seven boxes in rows of ten columns, sorted by row and column: for each entry, the later \
                          entries that share a column with it.",
        columns => "Boxes in any cells: (1) the first later entry that shares a column with an entry, (2) the entry \
                    after the last one that shares a column with it.",
        far_columns => "Cells whose numbers need more than 32 bits: (1) the first later entry that shares a column \
                        with an entry, (2) the entry after the last one that shares a column with it.",
        many_columns => "A million boxes: the number of pairs that share a column. A program that compares each box \
                         with all later boxes would not finish.",
        pairs_of_cells after "7.2, 7.11" => "Scenes of all kinds, and sorted cells in windows: the pairs found.",
    }
    task_7_14 {
        window_table => "A thousand discs: (1) the cost of a step for some numbers of windows, (2) the number that is \
                         chosen. An entry costs 60. A pair costs 1, and 10 more if it is tested; both are multiplied \
                         by the crowding.",
        plans => "Slow and fast discs, sparse and dense scenes: the chosen number of windows. No other number of \
                  windows may cost less.",
        unseen after "7.1, 7.2, 7.3, 7.4, 7.5, 7.6, 7.7, 7.11, 7.13" = |_, ask| planned().follows_unseen_scenes(ask)
            => "Forty scenes in windows, from sparse to crowded: the state after each of 3 steps.",
        memory after "7.1, 7.2, 7.3, 7.4, 7.5, 7.6, 7.7, 7.11, 7.13" = |_, ask| planned().keeps_its_memory(ask)
            => "A long run: the memory in use, which must not grow with the number of steps.",
        many_discs = many_discs_of_planned
            => "The lab's program and 50,000 discs: a step in one gigabyte of memory. Memory may grow with the number \
                of discs, but not with the number of pairs.",
        same_bits after "7.1, 7.2, 7.3, 7.4, 7.5, 7.6, 7.7, 7.8, 7.9, 7.10, 7.11, 7.12, 7.13"
            => "Every program of the lab, on any number of threads: the state after 6 steps, which must have the same \
                bits as in `sequential`.",
        strips after "7.1, 7.2, 7.3, 7.4, 7.5, 7.6, 7.7, 7.11, 7.13"
            => "9,000 discs in many strips, on any number of threads: the state after 2 steps, which must have the \
                same bits as in `sequential`.",
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
