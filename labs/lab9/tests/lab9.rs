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
        launch_table => "Workgroups that are asked for, on a device with at most 4 along an axis and 256 invocations in each: \
                         the rows of the launch, or why it is refused.",
        launches => "Any number of workgroups or items and any limits: the launch, or the error and its numbers.",
        refusals => "A launch that never ran, and a kernel that is no WGSL: whether they are refused with a reason.",
    }
    task_9_2 {
        pairs_passed_on => "Four discs of radius 1 in a square of side 20: which pairs the filter passes on.",
        slow_contacts => "Discs that touch and approach so slowly that single precision cannot tell it from \
                                      parting: the pairs that are passed on.",
        a_full_list => "More pairs than a list has room for, and as many: how many are counted, in the list, and \
                                    different.",
        filter_in_single => "Discs of all kinds, in single precision: every colliding pair is passed on once, and \
                                         hardly any other.",
        filter_in_double => "Discs of all kinds, in double precision: every colliding pair is passed on once, and \
                                         hardly any other.",
    }
    task_9_3 {
        confirmed_list => "Four discs, and what a device passed on: which of it the host confirms, and the times.",
        confirmed => "What a device passed on, one list after the other: kind, discs, time of each that is confirmed.",
        kernel_runs => "A list with room for all candidates, and a list without: how often the kernels run, and how often the \
                        list grows.",
        grown => "Lists that grow, and devices with little memory: how many candidates are found, and how \
                                   many of them differ.",
        disc_turns = |_, ask| turns(ask, Deal::Discs)
            => "Four invocations that share the discs: none does over two fifths of the work.",
        disc_candidates after "9.1, 9.2" = |random, ask| candidates(random, ask, Deal::Discs)
            => "Steps of basic: kind, discs, time of each candidate.",
        basic_bytes after "9.1, 9.2" = |random, ask| bytes(random, ask, "9.3", &["basic-f64", "basic-f32"])
            => "Variant basic: the bytes of lab 7's sequential program.",
    }
    task_9_4 {
        pair_numbers => "Six discs and five discs: the pairs in each row of the rectangle.",
        rectangles => "Few discs: the pairs that have a number.",
        late_rows => "100,000 discs: the pairs of a row, early or late, that are dealt.",
        pair_turns = |_, ask| turns(ask, Deal::Pairs)
            => "Four invocations that share the pairs: none does over two fifths of the work.",
        pair_candidates after "9.1, 9.2, 9.3" = |random, ask| candidates(random, ask, Deal::Pairs)
            => "Steps of balanced: kind, discs, time of each candidate.",
        balanced_bytes after "9.1, 9.2, 9.3" = |random, ask| bytes(random, ask, "9.4", &["balanced-f64", "balanced-f32"])
            => "Variant balanced: the bytes of lab 7's sequential program.",
        large_workgroups => "Variant balanced with workgroups of 65,536: whether they are refused with this number.",
    }
    task_9_5 {
        chosen_candidates => "Seven candidates of six discs, some at one time: which of them are chosen.",
        choices => "Few and many candidates among 300 discs: kind, discs, time of each that is chosen.",
        chosen_bytes after "9.1, 9.2, 9.3, 9.4" = |random, ask| bytes(random, ask, "9.5", &["chosen-f32"])
            => "Variant chosen: the bytes of lab 7's sequential program.",
    }
    task_9_6 {
        summed_blocks => "Nine counts, summed by three workgroups of three invocations: the counts before each in \
                                      its own block, and in all.",
        meetings => "Numbers that a workgroup shares: whether a barrier lies between any two accesses of two invocations to one \
                     of them, and whether all invocations come to each barrier.",
        scans => "Few and many numbers, workgroups of any size: the sum of the numbers before each.",
    }
    task_9_7 {
        sorted_particles => "Eight particles in nine bins: where each bin begins, and the particles in it.",
        bins => "Few bins: the particles by bin and by id, and where each bin begins.",
        double_steps => "Variant soft-f64, few bins: each step is the model's.",
        statistics => "Variant soft-f64, few bins: dmin, davg and navg of each step.",
        many_bins after "9.6" => "More bins than a workgroup has invocations: the particles by bin and by id, and where each \
                                  bin begins.",
        double_steps_of_many after "9.6" => "Variant soft-f64, scenes of all kinds: each step is the model's.",
        double_repeats after "9.6" => "Variant soft-f64: the same bits in a second run, and 200 steps beside the model.",
    }
    task_9_8 {
        single_step => "Three particles before a step of soft-f32 and after it, in a box of 10.01 cutoffs, ten bins by ten.",
        carried => "Particles that move by little or much, ahead or back: the column and the offset that they come to.",
        single_steps => "Variant soft-f32, few bins: the first step, within the roundings of one step.",
        single_steps_of_many after "9.6, 9.7" => "Variant soft-f32, scenes of all kinds: each step, from where the program \
                                                  itself was before the step, within the roundings of one step.",
        single_repeats after "9.6, 9.7" => "Variant soft-f32: every particle stays in the box, and the same bits in a second \
                                            run.",
    }
}

/// Asks for the bytes of whole runs of variants of hard discs.
fn bytes(random: &mut Random, ask: &mut impl Ask, task: &'static str, variants: &[&'static str]) {
    for variant in variants {
        same_bytes(random, ask, task, variant);
    }
}
