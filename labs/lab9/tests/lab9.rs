//! Lab 9's graders.

use device_discs::hard::Deal;
use oracle::{Ask, Random};

#[path = "lab9/adapter.rs"]
mod adapter;
#[path = "lab9/carries.rs"]
mod carries;
#[path = "lab9/choices.rs"]
mod choices;
#[path = "lab9/examples.rs"]
mod examples;
#[path = "lab9/filters.rs"]
mod filters;
#[path = "lab9/launched.rs"]
mod launched;
#[path = "lab9/launches.rs"]
mod launches;
#[path = "lab9/lists.rs"]
mod lists;
#[path = "lab9/meetings.rs"]
mod meetings;
#[path = "lab9/rectangles.rs"]
mod rectangles;
#[path = "lab9/searches.rs"]
mod searches;
#[path = "lab9/sorts.rs"]
mod sorts;
#[path = "lab9/steps.rs"]
mod steps;

use carries::*;
use choices::*;
use examples::*;
use filters::*;
use launches::*;
use lists::*;
use meetings::*;
use rectangles::*;
use searches::*;
use sorts::*;
use steps::*;

oracle::questions! {
    task_9_1 {
        launch_table => "A device that can run at most 4 workgroups along an axis and 256 invocations in each \
                         workgroup, and a number of workgroups: the rows of the launch, or the reason why the launch \
                         is refused.",
        launches => "Any number of workgroups or items, and any limits: the launch, or the error and its two numbers.",
        refusals => "A launch that the device cannot run, and a kernel that is not valid WGSL: whether each is \
                     refused with a reason, as it must be.",
    }
    task_9_2 {
        pairs_passed_on => "Four discs of radius 1 in a square of side 20: for each pair, the number of times that \
                            the filter passes it on.",
        slow_contacts => "Discs in contact that approach so slowly that, in single precision, they may seem to move \
                          apart: the pairs passed on. All contacts must be passed on.",
        at_the_bounds => "Pairs at exactly the bounds `reach_squared` and `receding`, and pairs beyond these bounds: \
                          the pairs passed on. Only pairs beyond a bound are ruled out.",
        a_full_list => "As many pairs as a list has room for, and more: (1) the number of pairs counted, (2) the \
                        number in the list, (3) the number of different pairs in the list, (4) the number of pairs \
                        written behind the end of the list, which must be 0.",
        filter_in_single => "Discs of all kinds, in single precision: the pairs passed on. Every colliding pair must \
                             be passed on once, and hardly any other pair.",
        filter_in_double => "Discs of all kinds, in double precision: the pairs passed on. Every colliding pair must \
                             be passed on once, and hardly any other pair.",
    }
    task_9_3 {
        confirmed_list => "Four discs, and the candidates that a device passed on: (1) the candidates that the host \
                           confirms, (2) the times of these candidates.",
        confirmed => "Lists of candidates that a device passed on, one after another: kind, discs and time of each \
                      candidate that is confirmed.",
        kernel_runs => "A list with room for all candidates, and a list with too little room: (1) the number of runs \
                        of the kernels, (2) the number of times that the list grows, (3) the room in the list \
                        afterwards.",
        grown => "Lists that grow, and devices with little memory: (1) the number of candidates found, (2) the number \
                  of different candidates.",
        disc_turns = |_, ask| turns(ask, Deal::Discs)
            => "Four invocations that share the discs: the number of pairs that each invocation passes on. It must be \
                at most two fifths of all pairs.",
        disc_candidates after "9.1, 9.2" = |random, ask| candidates(random, ask, Deal::Discs)
            => "Steps of `basic`: kind, discs and time of each candidate.",
        basic_bytes after "9.1, 9.2" = |random, ask| bytes(random, ask, "9.3", &["basic-f64", "basic-f32"])
            => "The variant `basic`: the state at the end, which must have the same bits as in lab 7's `sequential`.",
    }
    task_9_4 {
        pair_numbers => "The rectangle of the pairs of six discs, and the rectangle of the pairs of five discs: the \
                         pairs in each row.",
        rectangles => "Few discs: the pairs that have a number. Every pair must have exactly one number.",
        late_rows => "100,000 discs: the pairs in one row near the beginning or near the end of the rectangle.",
        pair_turns = |_, ask| turns(ask, Deal::Pairs)
            => "Four invocations that share the pairs: the number of pairs that each invocation passes on. The numbers \
                may differ by at most 1.",
        pair_candidates after "9.1, 9.2, 9.3" = |random, ask| candidates(random, ask, Deal::Pairs)
            => "Steps of `balanced`: kind, discs and time of each candidate.",
        balanced_bytes after "9.1, 9.2, 9.3" = |random, ask| bytes(random, ask, "9.4", &["balanced-f64", "balanced-f32"])
            => "The variant `balanced`: the state at the end, which must have the same bits as in lab 7's \
                `sequential`.",
        large_workgroups => "The variant `balanced` with workgroups of 65,536 invocations: whether it is refused with \
                             an error that contains this number, as it must be.",
    }
    task_9_5 {
        chosen_candidates => "Seven candidates of six discs, some of which happen at the same time: the candidates \
                              that are chosen.",
        choices => "Few and many candidates among 300 discs: kind, discs and time of each candidate that is chosen.",
        chosen_bytes after "9.1, 9.2, 9.3, 9.4" = |random, ask| bytes(random, ask, "9.5", &["chosen-f32"])
            => "The variant `chosen`: the state at the end, which must have the same bits as in lab 7's `sequential`.",
    }
    task_9_6 {
        summed_blocks => "Nine counts that three workgroups of three invocations sum: for each count, the sum of the \
                          counts before it (1) in its own block, (2) in all blocks.",
        meetings => "Numbers that a workgroup shares: (1) the first conflict, (2) the number of invocations that reach \
                     each barrier (all must). A conflict is two accesses to one number by two invocations without \
                     a barrier in between. A round needs two barriers.",
        scans => "Few and many numbers, and workgroups of any size: for each number, the sum of the numbers before \
                  it.",
    }
    task_9_7 {
        sorted_particles => "Eight particles in nine bins: (1) the index at which each bin begins, (2) the particles \
                             in each bin.",
        bins => "Few bins: (1) the particles in the order of bins and ids, (2) the index at which each bin begins.",
        double_steps => "The variant `soft-f64` with few bins: the state after each step, compared with the model.",
        statistics => "The variant `soft-f64` with few bins: (1) dmin, davg and navg of each step, (2) the number of \
                       pair tests of a step.",
        many_bins after "9.6" => "More bins than a workgroup has invocations: (1) the particles in the order of bins \
                                  and ids, (2) the index at which each bin begins.",
        double_steps_of_many after "9.6" => "The variant `soft-f64` in scenes of all kinds: the state after each step, \
                                             compared with the model.",
        double_repeats after "9.6" => "The variant `soft-f64`: (1) the bits of a second run, which must equal the \
                                       bits of the first, (2) the state after each of 200 steps, compared with \
                                       the model.",
    }
    task_9_8 {
        single_step => "Three particles in a box of 10.01 cutoffs with ten rows of ten bins: their states before and \
                        after a step of `soft-f32`.",
        carried => "Particles that move forwards or backwards, by a little or a lot: the column and the offset of \
                    each particle afterwards.",
        single_steps => "The variant `soft-f32` with few bins: the state after the first step. It may differ from the \
                         model by the rounding errors of one step.",
        single_steps_of_many after "9.6, 9.7" => "The variant `soft-f32` in scenes of all kinds: the state after each \
                                                  step. It may differ from the model by the rounding errors of one \
                                                  step, because the model starts each step from the state that your \
                                                  program had before the step.",
        single_repeats after "9.6, 9.7" => "The variant `soft-f32`: (1) all particles, which must stay in the box, \
                                            (2) the bits of a second run, which must equal the bits of \
                                            the first.",
    }
}

/// Asks for the bytes of whole runs of variants of hard discs.
fn bytes(random: &mut Random, ask: &mut impl Ask, task: &'static str, variants: &[&'static str]) {
    for variant in variants {
        same_bytes(random, ask, task, variant);
    }
}
