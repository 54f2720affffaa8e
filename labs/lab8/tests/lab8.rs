//! Lab 8's graders.

#[path = "lab8/candidates.rs"]
mod candidates;
#[path = "lab8/certain.rs"]
mod certain;
#[path = "lab8/collided.rs"]
mod collided;
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
#[path = "lab8/wires.rs"]
mod wires;

use master_examples::*;
use news_example::*;
use runs::*;
use strip_examples::*;

oracle::questions! {
    task_8_1 {
        table_of_offsets => "1 to 9 workers: (1) the blocks of worker 0, (2) for each distance, two of these blocks \
                             that are this far apart.",
        few_blocks = deal::few_blocks => "1 to 600 workers: the blocks of worker 0. The rule must pick each of these \
                                          blocks.",
    }
    task_8_2 {
        table_of_jobs => "Five workers with the blocks of the report, and four workers: the jobs of each worker.",
        jobs_of_all = deal::dealt
            => "1 to 300 workers, and blocks that make every distance: the jobs of each worker, one job for each \
                distance.",
    }
    task_8_3 {
        table_of_searches => "Six discs in three blocks, and four jobs: for each job, (1) the number of pair tests, \
                              (2) the candidates with their times.",
        searches = deal::searches
            => "Up to 1025 discs in blocks, and a job: (1) the number of pair tests, (2) the candidates, which are \
                appended to the candidate that the list already contains.",
    }
    task_8_4 {
        handed_out => "A master and its workers on three ranks: (1) the master's lists of discs, (2) the discs that \
                       arrive on each rank. A bar separates two lists.",
        hands_out = messages::hands_out
            => "Lists of any length on 1, 2 and more ranks: (1) the discs that arrive, (2) the number of sends that \
                the master begins before it waits for a send. It must begin all sends first.",
    }
    task_8_5 {
        collected => "A master and its workers on three ranks: (1) the list of discs of each rank, (2) the discs that \
                      the function returns.",
        collects = messages::collects
            => "Lists of any length on 1, 2 and more ranks: the discs that the master gets, in the order of workers.",
    }
    task_8_6 {
        after_a_step => "Five workers with three blocks of two discs each, and two collisions: (1) the discs that \
                         each worker receives, (2) the discs of worker 0 before and after it receives them.",
        collided_discs = collided::collided_discs
            => "Up to 70,000 discs with collisions, and the blocks of a worker: the discs that the worker receives.",
        updates = collided::updates => "The discs of a worker, and discs that arrive: the worker's discs afterwards.",
    }
    task_8_7 {
        three_steps after "8.1, 8.2, 8.3, 8.4, 8.5, 8.6"
            => "Four discs on a master and two workers: the state after each of three steps.",
        bits_with_master after "8.1, 8.2, 8.3, 8.4, 8.5, 8.6"
            => "Many scenes on 1 to 5 ranks: the state after each of 6 steps, which must have the same bits as in lab \
                7's `sequential`.",
        master_works after "8.1, 8.2, 8.3, 8.4, 8.5, 8.6"
            => "A master that works too, on 2 and 4 ranks: the state after each step, which must have the same bits \
                as in lab 7's `sequential`.",
        blocks_again after "8.1, 8.2, 8.3, 8.4, 8.5, 8.6"
            => "Workers that receive all discs of their blocks in every step: the state after each step, which must \
                have the same bits as in lab 7's `sequential`.",
        counts_with_master after "8.1, 8.2, 8.3, 8.4, 8.5, 8.6"
            => "400 discs on 1 and 3 ranks: the numbers of pair tests, candidates and collisions. They must be the \
                same as in lab 7's `sequential`.",
        quiet_steps after "8.1, 8.2, 8.3, 8.4, 8.5, 8.6" = messages::quiet_steps
            => "Two discs that meet once: the bytes sent after the first step. Only discs that have collided may be \
                sent.",
        kept_deal after "8.1, 8.2, 8.3, 8.4, 8.5, 8.6" = messages::kept_deal
            => "Two steps of an engine that already has a deal: the deal after these steps, which must not change.",
        shares_with_master after "8.1, 8.2, 8.3, 8.4, 8.5, 8.6"
            => "Three workers: the pair tests of the busiest rank. They must be at most two thirds of all pair tests.",
        memory_with_master after "8.1, 8.2, 8.3, 8.4, 8.5, 8.6"
            => "1000 discs in a long run on 3 ranks: the memory in use, which must not grow with the number of steps.",
        as_reported after "8.1, 8.2, 8.3, 8.4, 8.5, 8.6"
            => "The report's program, which the lab gives you, on 1 to 5 ranks: the state after each step, which must \
                have the same bits as in lab 7's `sequential`.",
        program_with_master after "8.1, 8.2, 8.3, 8.4, 8.5, 8.6"
            => "The lab's own program: (1) whether the whole job ends after one rank is killed, (2) the error message \
                if the input is not a scene.",
    }
    task_8_8 {
        table_of_boxes => "Six discs and three strips: (1) the strips that the box of each disc reaches, (2) the rank \
                           that tests each pair.",
        boxes = strips::boxes => "A disc and strips: the first and the last rank whose strip the disc's box reaches.",
        lookers = strips::lookers => "Two discs, and the strips that the box of each reaches: the rank that tests the \
                                      pair, if any rank does.",
    }
    task_8_9 {
        table_of_ghosts after "8.8" => "Rank 1 of three, and its five discs: the discs that it copies (1) for rank 0, \
                                        (2) for rank 2.",
        ghosts after "8.8" = strips::ghosts
            => "Up to 70,000 discs, strips and partners: the ghosts for each partner, in the order of the discs.",
    }
    task_8_10 {
        table_of_ends => "Six discs on rank 1, with rivals on other ranks: the outcome of five candidates.",
        rounds = certain::rounds
            => "Candidates of up to 300 discs, and rivals that change between the rounds. After each of four rounds: \
                (1) the candidates taken, (2) the open candidates, (3) the discs that are free.",
        crowd_behind_one = certain::crowd_behind_one
            => "A million candidates that wait for one open candidate: the open candidates after 100,000 rounds. A \
                program that examines all candidates in each round would not finish.",
    }
    task_8_11 {
        table_of_news after "8.10" => "A tower of eight discs on three ranks: the candidates that each rank (1) \
                                       takes, (2) leaves open, and (3) reports to the other ranks, in three rounds.",
        news_for_partners = news::news_for_partners => "Taken and open candidates of a rank: the news for each \
                                                        partner. The taken candidates must come first.",
        news_from_ranks = news::news_from_ranks => "News from other ranks, three times: (1) the discs that are free, \
                                                    (2) the rival of each disc.",
        together after "8.10" = together::together
            => "Two to five ranks that exchange their news: the candidates that these ranks take together. A single \
                rank with all candidates would take the same ones.",
    }
    task_8_12 {
        table_of_moves => "Six discs, some of them ghosts, after the decisions of a step: (1) the discs that this \
                           rank moves, (2) the states of these discs afterwards.",
        moves = moves::moves => "Up to 3000 discs of a rank: the discs that the rank moves, with their states after \
                                 the step.",
    }
    task_8_13 {
        one_step after "8.8, 8.9, 8.10, 8.11, 8.12"
            => "A tower of six discs on three ranks: the own discs, the ghosts and the collisions of each rank in a \
                step.",
        bits_with_cuts after "8.5, 8.8, 8.9, 8.10, 8.11, 8.12"
            => "Many scenes on 1 to 5 ranks: the state after each of 6 steps, which must have the same bits as in lab \
                7's `sequential`.",
        cuts_that_move after "8.5, 8.8, 8.9, 8.10, 8.11, 8.12"
            => "Cuts that move in every step: the state after each of 6 steps, which must have the same bits as in \
                lab 7's `sequential`.",
        counts_with_cuts after "8.8, 8.9, 8.10, 8.11, 8.12"
            => "400 discs on 1 and 4 ranks: the numbers of candidates and collisions. They must be the same as in lab \
                7's `sequential`.",
        only_what_crosses after "8.8, 8.9, 8.10, 8.11, 8.12"
            => "4000 discs on 4 ranks: (1) the number of ghosts in a step, (2) the number of bytes sent in a step. \
                Only discs near a cut may be sent.",
        neighbours after "8.8, 8.9, 8.10, 8.11, 8.12" = messages::neighbours
            => "Slow discs on 5 ranks: (1) the partners of each rank, which are at most its two neighbours, (2) the \
                number of calls that bring lists to all ranks, which must be 0.",
        quiet_rounds after "8.8, 8.9, 8.10, 8.11, 8.12" = messages::quiet_rounds
            => "Discs at rest on 3 ranks, once without a collision and once with one: the number of calls of \
                Allreduce in a step. One call is needed for the range, and one for each round.",
        walls_meanwhile after "8.8, 8.9, 8.10, 8.11, 8.12" = messages::walls_meanwhile
            => "Slow discs on 3 ranks: whether the ranks find the wall collisions while the ghosts travel, as they \
                must.",
        many_rounds after "8.8, 8.9, 8.10, 8.11, 8.12"
            => "A chain of 240 discs that crosses a cut again and again, on 2 and 4 ranks: the state after a step \
                with more than a hundred rounds, which must have the same bits as in lab 7's `sequential`.",
        shares_with_cuts after "8.8, 8.9, 8.10, 8.11, 8.12"
            => "Four strips: the pair tests of the busiest rank. They must be at most two thirds of all pair tests.",
        memory_with_cuts after "8.8, 8.9, 8.10, 8.11, 8.12"
            => "1000 discs in a long run on 2 ranks: the memory in use, which must not grow with the number of steps.",
        program_with_cuts after "8.5, 8.8, 8.9, 8.10, 8.11, 8.12"
            => "The lab's own program: whether the whole job ends after one rank is killed.",
    }
}
