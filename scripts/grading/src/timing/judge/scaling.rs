//! What more workers bring.

use super::runs::{is, judged, net, not_timed, own, seconds, serial};
use super::{Found, WAYS, Without};
use crate::record::{Run, Whose};
use crate::timing::plan::STEPS;
use lab_kit::rubric::Timed;
use lab_measure::rubric::{average, scaling_grade, strong_efficiency, weak_efficiency};

pub(crate) fn scaling(runs: &[Run], timed: &Timed) -> Result<Found, Without> {
    let own = || runs.iter().filter(|run| is(run, Whose::Own, timed, STEPS));
    let mut strong: Vec<&Run> = own().filter(|run| run.n == timed.n).collect();
    strong.sort_by_key(|run| run.workers);
    let Some(most) = strong.last().map(|run| run.workers) else {
        return Err(not_timed(timed, timed.n));
    };
    if most == 1 {
        return Err(Without::NotTimed("it was timed on a machine with one core".into()));
    }
    let each = (timed.n / most).max(1);
    let mut efficiencies: [[Vec<f64>; 2]; 2] = Default::default();
    let mut last = Vec::new();
    for of_all in &strong {
        let p = of_all.workers;
        let weak = self::own(runs, timed, each * p, p)?;
        let (one, one_weak) = (serial(runs, timed, timed.n)?, serial(runs, timed, each)?);
        for (efficiencies, way) in efficiencies.iter_mut().zip(WAYS) {
            let strong = seconds(runs, judged(of_all)?, way)?;
            let weak = seconds(runs, weak, way)?;
            let one = net(runs, one, way)?;
            efficiencies[0].push(strong_efficiency(one, p, strong));
            efficiencies[1].push(weak_efficiency(net(runs, one_weak, way)?, weak));
        }
        let [strong, weak] = [0, 1].map(|at| efficiencies[0][at].last().copied().unwrap_or(0.0));
        last.push(format!("{p} workers {:.2} and {weak:.2}", strong));
    }
    let mean = |efficiencies: &[f64]| average(efficiencies).unwrap_or(0.0);
    let grades = [0, 1]
        .map(|way: usize| scaling_grade(mean(&efficiencies[way][0]), mean(&efficiencies[way][1])));
    let [strong, weak] = &efficiencies[0];
    let words = format!(
        "average efficiency against the serial program: strong {:.2}, weak {:.2} ({})",
        mean(strong),
        mean(weak),
        last.join(", ").replacen("1 workers", "1 worker", 1)
    );
    Ok(Found { grades, words })
}
