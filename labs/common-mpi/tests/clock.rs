//! Recorded activities of a job whose activities are known.
//!
//! As in `job.rs`, a test starts this program again on ranks to play a part.

use std::process::ExitCode;
use std::thread::sleep;
use std::time::Duration;

use common::Activity::{self, Communicate, Compute, Wait};
use common_mpi::{Clock, Partners, as_rank};
use mpi::traits::*;
use oracle::mpiexec::Job;

#[test]
fn a_rank_waits_until_its_partner_has_come() {
    let ended = Job::part("0.0", "the_second_rank_comes_late", 2).run();
    assert!(ended.status.success(), "{}", ended.stderr);
}

#[test]
#[ignore = "a part of a_rank_waits_until_its_partner_has_come"]
fn the_second_rank_comes_late() {
    let code = as_rank(|world| {
        let late = world.rank() == 1;
        let other = world.process_at_rank(1 - world.rank());
        let mut clock = Clock::new(true);
        clock.start(world);
        for _ in 0..2 {
            clock.begin_step();
            if late {
                // The other rank is in its call already.
                other.receive::<u8>();
                sleep(Duration::from_millis(100));
            }
            clock.call(Partners::All, || {
                if !late {
                    other.send(&0_u8);
                }
                world.barrier();
            });
            clock.end_step();
        }
        let sums = clock.report(world);
        let events = clock.events(world).expect("it records");
        if late {
            assert!(events.is_empty(), "the root has the events of all");
            return ExitCode::SUCCESS;
        }
        for step in 0..2 {
            let of = |rank, activity| {
                events.iter().find(|e| (e.rank, e.step, e.activity) == (rank, step, activity))
            };
            let wait = of(0, Wait).expect("it waits");
            let compute = of(1, Compute).expect("it computes");
            assert_eq!(wait.end, compute.end, "rank 0 waits until rank 1 comes, step {step}");
            assert_eq!(of(1, Wait), None, "rank 1 finds rank 0 there");
            assert!(of(0, Communicate).is_some() && of(1, Communicate).is_some());
        }
        let mut steps = events.chunk_by(|a, b| (a.rank, a.step) == (b.rank, b.step));
        let without_gaps =
            steps.all(|step| step.windows(2).all(|pair| pair[0].end == pair[1].begin));
        assert!(without_gaps, "no gaps within a step: {events:?}");
        for (activity, (name, sum)) in Activity::ALL.into_iter().zip(sums) {
            let of_it = events.iter().filter(|event| event.activity == activity);
            let expected: f64 = of_it.map(|event| event.end - event.begin).sum();
            assert!((sum - expected).abs() < 1e-9, "{name}: {sum}, by the events {expected}");
        }
        ExitCode::SUCCESS
    });
    assert_eq!(code, ExitCode::SUCCESS);
}

#[test]
fn a_clock_that_is_off_records_nothing() {
    let ended = Job::part("0.0", "nothing_is_recorded", 1).run();
    assert!(ended.status.success(), "{}", ended.stderr);
}

#[test]
#[ignore = "a part of a_clock_that_is_off_records_nothing"]
fn nothing_is_recorded() {
    let code = as_rank(|world| {
        let mut clock = Clock::new(false);
        clock.start(world);
        clock.begin_step();
        assert_eq!(clock.call(Partners::All, || clock.work(|| 7)), 7);
        clock.end_step();
        assert_eq!((clock.events(world), clock.report(world)), (None, Vec::new()));
        ExitCode::SUCCESS
    });
    assert_eq!(code, ExitCode::SUCCESS);
}
