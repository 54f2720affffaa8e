use std::f64::consts::PI;
use std::process::ExitCode;

use common::soft::{CUTOFF, Particle, Scene};
use common_mpi::as_rank;
use lab13::{
    best_depth, best_steps, choose, deep_width, ghost_width, must_renew, pairs_across, right_steps,
};
use mpi::topology::SimpleCommunicator;
use neighbour_list::kernels::Positions;
use oracle::mpiexec::{self, Ended, OnRanks};
use oracle::{Columns, Model, Random, ask, right, scenes, spaced, within};
use strips::{Outlook, Scenery, Strips};
use watched::test;

#[path = "lab13/questions.rs"]
mod questions;

/// The lab's own program: the student's or the solution's.
const PROGRAM: &str =
    match (option_env!("CARGO_BIN_EXE_lab13"), option_env!("CARGO_BIN_EXE_solution13")) {
        (Some(program), _) | (None, Some(program)) => program,
        (None, None) => panic!("the lab has no program"),
    };

/// Whole steps need tasks 13.1 to 13.6; the program meets the last one first.
fn on_ranks(ranks: usize) -> OnRanks {
    OnRanks::new("13.6", PROGRAM, "strips", ranks)
}

/// A variant on so many ranks.
type On = fn(usize) -> OnRanks;

/// Runs on each of these numbers of ranks follow the model.
fn follow(on: On, ranks: &[usize], scene: &Scene, steps: usize) {
    ranks.iter().for_each(|&ranks| on(ranks).follows_the_model(scene, steps));
}

/// Tests of a variant: each asks what stands behind its name.
macro_rules! tests {
    ($on:ident: $(fn $test:ident = $ask:ident;)*) => {
        $(
            #[test]
            fn $test() {
                $ask($on);
            }
        )*
    };
}

fn official_bytes(on: On) {
    [1, 2, 3, 5].into_iter().for_each(|ranks| on(ranks).official_bytes());
}

fn dense(on: On) {
    follow(on, &[1, 2, 3, 5], &scenes::dense(), 40);
    on(3).follows_the_model(&scenes::close_pairs(), 20);
    for scene in scenes::edges().iter().step_by(7) {
        on(2).follows_the_model(scene, 3);
    }
}

fn lasts(on: On) {
    follow(on, &[2, 3], &Scene::counter(2000, 3).expect("a scene"), 120);
}

fn few_rows(on: On) {
    follow(on, &[4, 7], &scenes::crowd(3), 12);
    let alone = Scene::new(0.3, vec![Particle { x: 0.1, y: 0.3, ..Particle::default() }]);
    on(3).follows_the_model(&alone.expect("a scene"), 3);
}

fn fast(on: On) {
    scenes::fast().iter().for_each(|scene| follow(on, &[2, 5], scene, 20));
}

fn empty_ranks(on: On) {
    for y in [0.0, 45.0 * CUTOFF] {
        on(4).follows_the_model(&scenes::corner(y), 20);
    }
    // Other ranks have rows and no particles, or no rows.
    on(5).follows_the_model(&scenes::one_row(), 10);
}

fn drifting(on: On) {
    let (grader, scene) = (on(3).option("--param", "rebalance=1"), scenes::drifting());
    grader.follows_the_model(&scene, 40);
    let [anew] = grader.counters(&scene, 40, ["times the strips were cut anew"]);
    assert!(anew >= 3.0, "the scene crossed the box and the strips were cut anew {anew} times");
}

fn killed(on: On) {
    on(3).ends_when_a_rank_is_killed();
}

/// Has each rank of a job do `check`, on each of these numbers of ranks.
fn on_each(task: &str, counts: &[usize], check: impl FnOnce(&SimpleCommunicator)) -> Ended {
    mpiexec::on_each(task, counts, || {
        as_rank(|world| {
            check(world);
            ExitCode::SUCCESS
        });
    })
}

fn strips(edges: &[f64]) -> Strips {
    Strips { edges: edges.to_vec() }
}

#[test]
fn task_13_1_ghosts_are_as_wide_as_two_move() {
    questions::widths(&mut Random::new(1), &mut right, false);
}

#[test]
fn task_13_1_no_other_number_of_steps_is_cheaper() {
    questions::lasting(&mut Random::new(10), &mut right);
}

#[test]
fn task_13_1_table_of_widths() {
    let mut table =
        String::from("for how many steps ghosts are chosen, and how wide, in cutoffs\n\n");
    table += "strip  neighbours   cutoffs that the fastest goes in a step\n";
    let speeds = [0.01, 0.05, 0.1, 1.0, 45.0];
    let columns = speeds.map(|speed| format!("{speed:>14}")).concat();
    table += &format!("     if at random {columns}\n");
    for (height, neighbours) in [(3.0, 0.6), (3.0, 5.0), (100.0, 0.6), (100.0, 5.0), (1e4, 0.6)] {
        table += &format!("{height:>5}  {neighbours:>10} ");
        for speed in speeds {
            let steps = best_steps(Scenery {
                fastest: speed * CUTOFF,
                density: neighbours / (PI * CUTOFF * CUTOFF),
                height: height * CUTOFF,
                most: 20,
            });
            let width = ghost_width(speed * CUTOFF, steps) / CUTOFF;
            table += &format!("{steps:>7}{width:>7.2}");
        }
        table += "\n";
    }
    insta::assert_snapshot!(table);
}

const BELOW: f64 = f64::NEG_INFINITY;
const ABOVE: f64 = f64::INFINITY;

#[test]
fn task_13_2_partners_are_within_the_width() {
    questions::neighbours(&mut Random::new(2), &mut right);
}

#[test]
fn task_13_3_ghosts_are_near_the_strip() {
    questions::ghosts(&mut Random::new(3), &mut right);
}

#[test]
fn task_13_3_pairs_across_are_within_reach() {
    within("13.3", 60, || questions::across(&mut Random::new(30), &mut right));
}

#[test]
fn task_13_3_the_example_of_the_book() {
    const WIDTH: f64 = 1.2;
    let [dozen, _] = scenes::dozen();
    let strips = strips(&[BELOW, 2.0, 4.0, ABOVE]);
    let of = |rank: usize| -> Vec<&Particle> {
        dozen.iter().filter(|p| strips.owner(p.y) == rank).collect()
    };
    let chosen = |from: usize, to: usize| -> Vec<&Particle> {
        let own = of(from);
        let y: Vec<f64> = own.iter().map(|p| p.y).collect();
        choose(&y, &strips.strip(to), WIDTH).iter().map(|index| own[*index as usize]).collect()
    };
    let across = |rank: usize, other: usize| {
        let (own, ghosts) = (chosen(rank, other), chosen(other, rank));
        let axis = |of: &[&Particle], axis: fn(&Particle) -> f64| -> Vec<f64> {
            of.iter().map(|p| axis(p)).collect()
        };
        let [x, y] = [axis(&own, |p| p.x), axis(&own, |p| p.y)];
        let [ghost_x, ghost_y] = [axis(&ghosts, |p| p.x), axis(&ghosts, |p| p.y)];
        let positions = Positions { x: &x, y: &y, first: 0 };
        let pairs =
            pairs_across(positions, Positions { x: &ghost_x, y: &ghost_y, first: 0 }, WIDTH);
        spaced(
            pairs
                .iter()
                .map(|[i, j]| format!("{}-{}", own[*i as usize].id, ghosts[*j as usize].id)),
        )
    };
    let ids = |particles: &[&Particle]| spaced(particles.iter().map(|p| p.id));
    let before = |rank: usize| rank.checked_sub(1);
    let after = |rank: usize| Some(rank + 1).filter(|rank| *rank < 3);
    let with =
        |other: Option<usize>, cell: &dyn Fn(usize) -> String| other.map_or_else(String::new, cell);
    let mut table = Columns::new((0..3).map(|rank| format!("rank {rank}")));
    table.row("own particles", (0..3).map(|rank| ids(&of(rank))));
    for (way, other) in [("before", &before as &dyn Fn(usize) -> Option<usize>), ("after", &after)]
    {
        let sent = |rank| with(other(rank), &|other| ids(&chosen(rank, other)));
        table.row(format!("to the rank {way}"), (0..3).map(sent));
    }
    let ghosts = |rank: usize| {
        let from = [before(rank), after(rank)].into_iter().flatten();
        let all: Vec<&Particle> = from.flat_map(|other| chosen(other, rank)).collect();
        format!("{} ({})", ids(&of(rank)), ids(&all))
    };
    table.row("with ghosts, in ()", (0..3).map(ghosts));
    for (way, other) in [("before", &before as &dyn Fn(usize) -> Option<usize>), ("after", &after)]
    {
        let pairs = |rank| with(other(rank), &|other| across(rank, other));
        table.row(format!("pairs across, to the rank {way}"), (0..3).map(pairs));
    }
    insta::assert_snapshot!(table.to_string());
}

#[test]
fn task_13_4_inner_particles_move_while_positions_are_under_way() {
    on_each("13.4", &[1, 2, 3, 5], |world| {
        questions::exchanges(world, &mut Random::new(4), &mut right);
    });
}

#[test]
fn task_13_5_rows_share_the_load() {
    questions::loads(&mut Random::new(5), &mut right);
}

#[test]
fn task_13_6_one_rank_decides_for_all() {
    on_each("13.6", &[1, 2, 3, 5], |world| {
        questions::renewals(world, &mut Random::new(6), &mut right);
        assert!(must_renew(world, false, f64::INFINITY, 0.0), "before the first list");
    });
}

tests! { on_ranks:
    fn task_13_6_the_official_bytes = official_bytes;
    fn task_13_6_dense_scenes_follow_the_model = dense;
    fn task_13_6_a_scene_that_lasts_many_lists = lasts;
    fn task_13_6_more_ranks_than_rows = few_rows;
    fn task_13_6_fast_particles = fast;
    fn task_13_6_empty_ranks = empty_ranks;
    fn task_13_6_strips_are_cut_anew_when_the_scene_drifts = drifting;
    fn task_13_6_a_killed_rank_ends_the_job = killed;
}

#[test]
fn task_13_6_particles_that_become_fast() {
    // A pair so close that it flies apart at once, among particles at rest: through several strips
    // before any list expects it.
    let mut particles =
        scenes::lattice_with_jitter(600, 60.0 * CUTOFF, 0.01, 5).particles().to_vec();
    let middle = 30.0 * CUTOFF;
    particles.push(Particle { x: middle, y: middle, ..Particle::default() });
    particles.push(Particle { x: middle, y: middle + 0.02 * CUTOFF, ..Particle::default() });
    let scene = Scene::new(60.0 * CUTOFF, particles).expect("a scene");
    follow(on_ranks, &[2, 5], &scene, 20);
}

#[test]
fn task_13_6_two_meet_across_the_border() {
    // With a skin of 1 c a list lasts until a particle has flown c/2. These two start 2.05 c apart on
    // two ranks, and touch after both have flown 0.525 c.
    let at = |y: f64, vy: f64| Particle { x: 0.05, y, vx: 0.0, vy, id: 0 };
    let scene = Scene::new(0.1, vec![at(0.03, 1.0), at(0.0505, -1.0)]).expect("a scene");
    on_ranks(2).option("--param", "skin=1").follows_the_model(&scene, 40);
}

#[test]
fn task_13_6_a_run_repeats_to_the_bit() {
    let scene = scenes::dense();
    let grader = on_ranks(3);
    let [first, second] = [grader.states(&scene, 60), grader.states(&scene, 60)];
    assert!(first == second, "two runs on three ranks gave different bits");
}

#[test]
fn task_13_6_threads_do_not_show() {
    let scene = Scene::counter(1000, 2).expect("a scene");
    let alone = on_ranks(2).states(&scene, 30);
    for threads in ["1", "3"] {
        let grader = OnRanks::new("13.6", PROGRAM, "strips-threads", 2).option("-t", threads);
        assert!(grader.states(&scene, 30) == alone, "other bits on {threads} threads a rank");
    }
}

#[test]
fn task_13_6_statistics_of_a_dense_box() {
    // A few steps: then particles that came close have parted by what rounding made of them.
    let averages = |ranks| on_ranks(ranks).averages(&scenes::dense(), 4);
    let one = averages(1);
    for ranks in [2, 5] {
        assert_eq!(averages(ranks), one, "statistics of {ranks} ranks");
    }
}

#[test]
fn task_13_6_lists_last_and_only_positions_are_sent() {
    let scene = Scene::counter(20_000, 1).expect("a scene");
    let grader = on_ranks(2);
    let names = ["steps per list", "messages per step, busiest rank"];
    let [steps, messages] = grader.counters(&scene, 100, names);
    assert!(steps > 4.0, "a list lasted {steps} steps");
    // One message of positions and one word in a step; what a list costs is spread over its steps.
    assert!(messages < 4.0, "{messages} messages in a step on two ranks");
}

#[test]
fn task_13_7_what_is_wrong_comes_nearer() {
    questions::widths(&mut Random::new(7), &mut right, true);
}

#[test]
fn task_13_7_no_other_epoch_is_cheaper() {
    questions::depths(&mut Random::new(70), &mut right);
}

#[test]
fn task_13_7_table_of_depths() {
    let mut table =
        String::from("for how many steps ghosts are chosen, and how deep, in cutoffs\n\n");
    table += "strip  particles   cutoffs that the fastest goes in a step\n";
    let speeds = [0.01, 0.05, 0.1, 1.0, 45.0];
    let columns = speeds.map(|speed| format!("{speed:>15}")).concat();
    table += &format!("                {columns}\n");
    for (height, particles) in [(3.0, 20.0), (35.0, 500.0), (112.0, 5e3), (1118.0, 5e5)] {
        table += &format!("{height:>5}  {particles:>9} ");
        for speed in speeds {
            let fastest = speed * CUTOFF;
            let outlook = Outlook { fastest, height: height * CUTOFF, particles, most: 20 };
            let steps = best_depth(outlook);
            let depth = deep_width(fastest, steps) / CUTOFF;
            table += &format!("{steps:>8}{depth:>7.2}");
        }
        table += "\n";
    }
    insta::assert_snapshot!(table);
}

#[test]
fn task_13_8_steps_are_right_until_the_ghosts_are_used_up() {
    questions::rights(&mut Random::new(8), &mut right);
}

#[test]
fn task_13_8_all_ranks_go_back_or_none() {
    on_each("13.8", &[1, 2, 3, 5], |world| {
        questions::confirmations(world, &mut Random::new(80), &mut right);
    });
}

include!("lab13/deep.rs");
