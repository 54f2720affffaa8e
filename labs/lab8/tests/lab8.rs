//! Lab 8's graders.

#[path = "lab8/candidates.rs"]
mod candidates;
#[path = "lab8/certain.rs"]
mod certain;
#[path = "lab8/crowds.rs"]
mod crowds;
#[path = "lab8/deal.rs"]
mod deal;
#[path = "lab8/decided.rs"]
mod decided;
#[path = "lab8/master_examples.rs"]
mod master_examples;
#[path = "lab8/messages.rs"]
mod messages;
#[path = "lab8/moves.rs"]
mod moves;
#[path = "lab8/news.rs"]
mod news;
#[path = "lab8/news_example.rs"]
mod news_example;
#[path = "lab8/runs.rs"]
mod runs;
#[path = "lab8/strip_examples.rs"]
mod strip_examples;
#[path = "lab8/strips.rs"]
mod strips;
#[path = "lab8/together.rs"]
mod together;
#[path = "lab8/told.rs"]
mod told;
#[path = "lab8/wires.rs"]
mod wires;

use master_examples::*;
use news_example::*;
use runs::*;
use strip_examples::*;

oracle::questions! {
    task_8_1 {
        table_of_offsets => "1 to 9 workers: the blocks of worker 0, and of each distance two blocks that are so far apart.",
        few_blocks = deal::few_blocks => "1 to 600 workers: the blocks of worker 0, each picked by the rule.",
    }
    task_8_2 {
        table_of_jobs => "Five workers with the blocks of the report, and four workers: the jobs of each.",
        jobs_of_all = deal::dealt
            => "1 to 300 workers, blocks that make every distance: a job of each distance for each worker.",
    }
    task_8_3 {
        table_of_searches => "Six discs in three blocks, and four jobs: the pairs looked at, and the candidates with times.",
        searches = deal::searches
            => "Up to 1025 discs in blocks, a job: the pairs looked at, and the candidates behind those from before.",
    }
    task_8_4 {
        handed_out => "A master and its workers on three ranks: the master's lists of discs, with a bar between lists, and \
                       what arrives.",
        hands_out = messages::hands_out
            => "Lists of any length on 1, 2 and more ranks: what arrives, and all sends begin before one is waited for.",
    }
    task_8_5 {
        collected => "A master and its workers on three ranks: the list of discs of each, and what is returned.",
        collects = messages::collects
            => "Lists of any length on 1, 2 and more ranks: what the master has, in the order of workers.",
    }
    task_8_6 {
        after_a_step => "Five workers with three blocks of two discs each, two collisions: which discs each is told of, and \
                         the discs of worker 0 before and after.",
        told_discs = told::told_discs
            => "Collisions of up to 70,000 discs, and the blocks of a worker: the discs that it is told of.",
        updates = told::updates => "The discs of a worker, and discs that arrive: all discs afterwards.",
    }
    task_8_7 {
        three_steps after "8.1, 8.2, 8.3, 8.4, 8.5, 8.6"
            => "Four discs on a master and two workers: where they are after each of three steps.",
        bits_with_master after "8.1, 8.2, 8.3, 8.4, 8.5, 8.6"
            => "Many scenes on 1 to 5 ranks: the bits of lab 7's sequential program after each of 6 steps.",
        master_works after "8.1, 8.2, 8.3, 8.4, 8.5, 8.6"
            => "A master that works too, on 2 and 4 ranks: the bits of lab 7's sequential program.",
        blocks_again after "8.1, 8.2, 8.3, 8.4, 8.5, 8.6"
            => "Workers that get their blocks again in every step: the bits of lab 7's sequential program.",
        counts_with_master after "8.1, 8.2, 8.3, 8.4, 8.5, 8.6"
            => "400 discs on 1 and 3 ranks: pair tests, candidates and collisions as in lab 7's sequential program.",
        quiet_steps after "8.1, 8.2, 8.3, 8.4, 8.5, 8.6" = messages::quiet_steps
            => "Two discs that meet once: only what has collided travels after the first step.",
        kept_deal after "8.1, 8.2, 8.3, 8.4, 8.5, 8.6" = messages::kept_deal
            => "Two steps that begin with a deal that is there already: the deal after them.",
        shares_with_master after "8.1, 8.2, 8.3, 8.4, 8.5, 8.6"
            => "Three workers: none looks at more than two thirds of the pairs.",
        memory_with_master after "8.1, 8.2, 8.3, 8.4, 8.5, 8.6"
            => "1000 discs in a long run on 3 ranks: memory does not grow with the steps.",
        as_reported after "8.1, 8.2, 8.3, 8.4, 8.5, 8.6"
            => "The report's program, which is given, on 1 to 5 ranks: the bits of lab 7's sequential program.",
        program_with_master after "8.1, 8.2, 8.3, 8.4, 8.5, 8.6"
            => "The lab's own program: a rank that is killed ends the job, and so does input that is no scene.",
    }
    task_8_8 {
        table_of_boxes => "Six discs and three strips: the strips that each box reaches, and the rank that looks at a pair.",
        boxes = strips::boxes => "A disc and strips: the first and the last rank whose strip its box reaches.",
        lookers = strips::lookers => "Two discs and the strips that each reaches: the rank that looks at the pair, if any.",
    }
    task_8_9 {
        table_of_ghosts after "8.8" => "The five discs of rank 1 of three: which of them are copied for rank 0 and rank 2.",
        ghosts after "8.8" = strips::ghosts
            => "Up to 70,000 discs, strips and partners: the ghosts for each partner, in the order of the discs.",
    }
    task_8_10 {
        table_of_ends => "Six discs on rank 1, with rivals of other ranks: what becomes of five candidates.",
        rounds = certain::rounds
            => "Candidates of up to 300 discs, and rivals that change: after each of four rounds what is taken, what is open, \
                and which discs are free.",
        crowd_behind_one = certain::crowd_behind_one
            => "A million candidates behind one that stays open: 100,000 rounds come to an end.",
    }
    task_8_11 {
        table_of_news after "8.10" => "A tower of eight discs on three ranks: what each takes, leaves open and tells the \
                                       others in three rounds.",
        tells = news::tells => "Taken and open candidates of a rank: the news for each partner, taken ones first.",
        hears = news::hears => "News of other ranks, three times: which discs are free, and the rival of each.",
        together after "8.10" = together::together
            => "Two to five ranks that tell each other their news: together they take what one rank would.",
    }
    task_8_12 {
        table_of_moves => "Six discs after the decisions of a step, own ones and ghosts: which of them this rank moves, and \
                           where they end.",
        moves = moves::moves => "Up to 3000 discs of a rank: those that it moves, as they are after the step.",
    }
    task_8_13 {
        one_step after "8.8, 8.9, 8.10, 8.11, 8.12"
            => "A tower of six discs on three ranks: own discs, ghosts and collisions of each rank in a step.",
        bits_with_cuts after "8.5, 8.8, 8.9, 8.10, 8.11, 8.12"
            => "Many scenes on 1 to 5 ranks: the bits of lab 7's sequential program after each of 6 steps.",
        cuts_that_move after "8.5, 8.8, 8.9, 8.10, 8.11, 8.12"
            => "Cuts that move in every step: the bits of lab 7's sequential program.",
        counts_with_cuts after "8.8, 8.9, 8.10, 8.11, 8.12"
            => "400 discs on 1 and 4 ranks: candidates and collisions as in lab 7's sequential program.",
        only_what_crosses after "8.8, 8.9, 8.10, 8.11, 8.12"
            => "4000 discs on 4 ranks: ghosts and bytes of a step, which only discs near a cut cause.",
        neighbours after "8.8, 8.9, 8.10, 8.11, 8.12" = messages::neighbours
            => "Slow discs on 5 ranks: each rank sends to the two beside it, and no list goes to all.",
        walls_meanwhile after "8.8, 8.9, 8.10, 8.11, 8.12" = messages::walls_meanwhile
            => "Slow discs on 3 ranks: the wall collisions are found while the ghosts travel.",
        many_rounds after "8.8, 8.9, 8.10, 8.11, 8.12"
            => "A chain of 240 discs to and fro across a cut, on 2 and 4 ranks: the bits of lab 7's sequential program after a \
                step of more than a hundred rounds.",
        shares_with_cuts after "8.8, 8.9, 8.10, 8.11, 8.12"
            => "Four strips: no rank looks at more than two thirds of the pairs.",
        memory_with_cuts after "8.8, 8.9, 8.10, 8.11, 8.12"
            => "1000 discs in a long run on 2 ranks: memory does not grow with the steps.",
        program_with_cuts after "8.5, 8.8, 8.9, 8.10, 8.11, 8.12"
            => "The lab's own program: a rank that is killed ends the job.",
    }
}
