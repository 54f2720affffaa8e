//! Threads that work in rounds, even if a round panics or another round begins inside a round.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use workers::Workers;

/// Numbers of threads: one, some, and more than most machines have cores.
const COUNTS: [usize; 4] = [1, 2, 3, 8];

fn workers(count: usize) -> Workers {
    Workers::new(count).expect("some threads start")
}

#[test]
fn results_are_in_the_order_of_the_pieces() {
    for workers in COUNTS.map(workers) {
        for n in [0, 1, 2, 7, 50] {
            let squares = workers.map((0..n).collect(), |k: usize| k * k);
            assert_eq!(squares, (0..n).map(|k| k * k).collect::<Vec<_>>());
        }
    }
}

#[test]
fn pieces_may_borrow_and_be_written() {
    for workers in COUNTS.map(workers) {
        let mut numbers = vec![1; 40];
        for _ in 0..20 {
            workers.map(numbers.chunks_mut(3).collect(), |piece: &mut [u32]| {
                piece.iter_mut().for_each(|number| *number += 1);
            });
        }
        assert_eq!(numbers, [21; 40]);
    }
}

#[test]
fn each_thread_is_called_once() {
    for count in COUNTS {
        let workers = workers(count);
        for _ in 0..20 {
            let called = Mutex::new(Vec::new());
            workers.on_each(|thread| called.lock().expect("no panics").push(thread));
            let mut called = called.into_inner().expect("no panics");
            called.sort_unstable();
            assert_eq!(called, (0..count).collect::<Vec<_>>());
        }
    }
}

#[test]
fn a_round_inside_a_round_is_done_by_its_caller() {
    let workers = workers(3);
    let sums = workers.map((0..6).collect(), |k: usize| {
        let calls = AtomicUsize::new(0);
        workers.on_each(|_| {
            calls.fetch_add(1, Ordering::Relaxed);
        });
        let numbers = workers.map((0..4).collect(), |l: usize| k * l);
        numbers.into_iter().sum::<usize>() + calls.into_inner()
    });
    assert_eq!(sums, [3, 9, 15, 21, 27, 33]);
}

#[test]
fn a_panic_reaches_the_caller_and_the_threads_go_on() {
    for workers in COUNTS.map(workers) {
        for bad in 0..4 {
            let work = |k: usize| assert_ne!(k, bad, "as intended");
            let all = AssertUnwindSafe(|| workers.map((0..4).collect(), work));
            assert!(catch_unwind(all).is_err());
        }
        assert!(catch_unwind(AssertUnwindSafe(|| workers.on_each(|_| panic!()))).is_err());
        assert_eq!(workers.map(vec![1, 2, 3], |k: u32| k + 1), [2, 3, 4]);
    }
}

#[test]
fn callers_may_share_threads() {
    let workers = workers(2);
    std::thread::scope(|scope| {
        for first in [0, 100] {
            let workers = &workers;
            scope.spawn(move || {
                for _ in 0..20 {
                    let found = workers.map((first..first + 5).collect(), |k: usize| k + 1);
                    assert_eq!(found, (first + 1..first + 6).collect::<Vec<_>>());
                }
            });
        }
    });
}

#[test]
fn sorted_by_any_number_of_threads() {
    let numbers: Vec<u32> = (0..200_u32).map(|k| k.wrapping_mul(2_654_435_761) >> 20).collect();
    for workers in COUNTS.map(workers) {
        for len in [0, 1, 2, 3, 200] {
            let mut some = numbers[..len].to_vec();
            workers.sort(&mut some, u32::cmp);
            let mut right = numbers[..len].to_vec();
            right.sort_unstable();
            assert_eq!(some, right);
        }
    }
}
