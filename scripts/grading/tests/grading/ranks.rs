//! A lab whose workers are ranks, timed.

use std::thread::available_parallelism;

use serde_json::Value;

use crate::class::Class;
use crate::command::{grade, record, run};

fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

#[test]
#[ignore = "compiles the bindings of MPI and takes times; run it by hand"]
fn ranks_are_timed_and_judged_as_threads_are() {
    let class = Class::alone(6);
    let into = class.temporary().join("records");
    if !run(grade(&class, &into, &[])) {
        return;
    }
    let record = record(&into, "solved").unwrap();
    assert!(list(&record["tasks"]).iter().all(|task| task["passed"] == true), "{record:#}");
    assert_eq!(record["timed"], true);

    let cores = available_parallelism().unwrap().get() as u64;
    let of = |whose: &str, idle: bool| {
        let is = move |run: &&Value| run["whose"] == whose && (run["steps"] == 0) == idle;
        list(&record["runs"]).iter().filter(is).collect::<Vec<_>>()
    };
    let ranks = |run: &Value| run["workers"].as_u64().unwrap();
    let mut own: Vec<u64> = of("own", false).into_iter().map(ranks).collect();
    own.sort_unstable();
    own.dedup();
    assert_eq!(own.last(), Some(&cores));
    // What it takes to start the ranks and to bring the scene there and back is known for each.
    let idle: Vec<u64> = of("solution", true).into_iter().map(ranks).collect();
    assert!(own.iter().all(|ranks| idle.contains(ranks)), "{idle:?}");
    assert!(!of("serial", false).is_empty());
    for run in list(&record["runs"]) {
        assert_eq!(run["outcome"], "timed", "{run:#}");
        let takes = list(&run["seconds"]);
        assert!((1..=15).contains(&takes.len()), "{run:#}");
        assert!(takes.iter().all(|take| take.as_f64().unwrap() > 0.0), "{run:#}");
    }

    let measures = list(&record["measures"]);
    let kinds: Vec<_> = measures.iter().map(|measure| measure["kind"].as_str().unwrap()).collect();
    assert_eq!(kinds, ["scaling", "speed"]);
    for measure in measures {
        // A busy machine may be too noisy to grade; it never makes the solution wrong.
        assert_ne!(measure["verdict"], "wrong", "{measure:#}");
        assert_eq!(measure["verdict"] == "graded", measure["grade"].is_number(), "{measure:#}");
    }
}
