//! What more workers bring.

use super::runs::{busy, find, is, judged, net, own, seconds, serial};
use super::{Found, Of, WAYS, Without};
use crate::record::{Run, Whose};
use crate::timing::plan::STEPS;
use lab_kit::rubric::Timed;
use lab_measure::rubric::{average, scaling_grade, strong_efficiency, weak_efficiency};

/// Workers that do together less than this times what one does, or of whom fewer were at work, are one.
const MORE_THAN_ONE: f64 = 1.1;

/// The solution has to have so many processors to itself: on a machine with other work no line can be drawn
/// between a program of one worker and one whose workers got no processor.
const CLEARLY_MORE: f64 = 1.3;

/// Where the solution itself gets less, of 100, nobody's scaling is graded.
const FIT: f64 = 75.0;

pub(crate) fn scaling(runs: &[Run], timed: &Timed) -> Result<Found, Without> {
    let own = runs.iter().filter(|run| is(run, Whose::Own, timed, STEPS) && run.n == timed.n);
    let mut workers: Vec<usize> = own.map(|run| run.workers).filter(|p| *p > 1).collect();
    workers.sort_unstable();
    if workers.is_empty() {
        return Err(Without::NotTimed("it was timed on a machine with one core".into()));
    }
    let of = |whose, way| average_efficiencies(runs, timed, whose, &workers, way);
    let grade = |[strong, weak]: [f64; 2]| scaling_grade(strong, weak);
    let mut grades = [0.0; 2];
    for (grade_of, way) in grades.iter_mut().zip(WAYS) {
        let own = grade(of(Whose::Own, way)?);
        // What the solution does not reach here, nobody is asked for.
        let most = grade(of(Whose::Solution, way)?);
        if most < FIT {
            return Err(Without::Unfit(format!(
                "the solution itself gets {most:.0} of 100 for its scaling here: something else runs, or \
                 this machine has fewer cores than it says"
            )));
        }
        *grade_of = (100.0 * own / most).min(100.0);
    }
    let [[strong, weak], [their_strong, their_weak]] =
        [of(Whose::Own, WAYS[0])?, of(Whose::Solution, WAYS[0])?];
    let mut words = format!(
        "average efficiency on up to {} workers against the serial program: strong {strong:.2}, weak \
         {weak:.2}; the solution's: {their_strong:.2} and {their_weak:.2}",
        workers.last().unwrap_or(&2)
    );
    if strong == 0.0 || weak == 0.0 {
        words +=
            "; workers that are together no faster than one, or of whom one works, do not scale";
    }
    Ok(Found { grades, words })
}

/// Strong and weak, averaged over the numbers of workers.
fn average_efficiencies(
    runs: &[Run],
    timed: &Timed,
    whose: Whose,
    workers: &[usize],
    way: Of,
) -> Result<[f64; 2], Without> {
    let each = (timed.n / workers.last().unwrap_or(&1)).max(1);
    let run = |n, p| match whose {
        Whose::Own => own(runs, timed, n, p),
        _ => judged(find(runs, whose, timed, (n, p))?),
    };
    let mut found: [Vec<f64>; 2] = Default::default();
    for &p in workers {
        let least = if whose == Whose::Own { MORE_THAN_ONE } else { CLEARLY_MORE };
        let scales = |run: &Run, efficiency: f64| {
            let is_one = busy(run) < least || p as f64 * efficiency < MORE_THAN_ONE;
            if is_one { 0.0 } else { efficiency }
        };
        let one = |n| net(runs, serial(runs, timed, n)?, way);
        let (strong, weak) = (run(timed.n, p)?, run(each * p, p)?);
        let of_strong = strong_efficiency(one(timed.n)?, p, seconds(runs, strong, way)?);
        let of_weak = weak_efficiency(one(each)?, seconds(runs, weak, way)?);
        found[0].push(scales(strong, of_strong));
        found[1].push(scales(weak, of_weak));
    }
    Ok(found.map(|efficiencies| average(&efficiencies).unwrap_or(0.0)))
}
