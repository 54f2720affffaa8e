//! Grades from times.

use super::plan::{STEPS, sizes};
use crate::grade::record::{Kind, Measure, Outcome, Record, Run, Status, Verdict, Whose};
use crate::grade::rubric::{Rubric, Timed};
use crate::measure::clock::Times;
use crate::measure::rubric::{
    average, complexity_grade, efficiency_grade, scaling_grade, slope, strong_efficiency,
    weak_efficiency,
};

/// Where the grade by the shortest takes and the grade by the medians are further apart, nothing
/// is graded.
const NOISE: f64 = 5.0;

/// A program that dawdles on small scenes looks flat. One that takes so many times the solution's time
/// on the largest scene is judged by a line that begins at the solution's time on the smallest.
const DAWDLE: f64 = 10.0;

/// The shortest take and the median.
type Of = fn(&Times) -> f64;
const WAYS: [Of; 2] = [Times::min, Times::median];

/// What a measure comes to: the grades both ways, and what was measured, in words.
struct Found {
    grades: [f64; 2],
    words: String,
}

/// Why there is no grade.
enum Without {
    NotTimed(String),
    Wrong(String),
}

/// The measures of a record by a rubric, from the runs that are in it.
pub(crate) fn judge(record: &Record, rubric: &Rubric) -> Vec<Measure> {
    type Judge = fn(&[Run], &Timed) -> Result<Found, Without>;
    let all: [(Kind, &Option<Timed>, Judge); 3] = [
        (Kind::Complexity, &rubric.complexity, complexity),
        (Kind::Scaling, &rubric.scaling, scaling),
        (Kind::Speed, &rubric.speed, speed),
    ];
    let measure = |(kind, timed, judge): (Kind, &Option<Timed>, Judge)| {
        let timed = timed.as_ref()?;
        let found = if !record.timed {
            Err(Without::NotTimed("not timed".into()))
        } else if record.status != Status::Graded {
            Err(Without::Wrong("there is no program to time".into()))
        } else {
            judge(&record.runs, timed)
        };
        Some(measure(kind, timed, found))
    };
    all.into_iter().filter_map(measure).collect()
}

fn measure(kind: Kind, timed: &Timed, found: Result<Found, Without>) -> Measure {
    let (verdict, grade, message) = match found {
        Ok(Found { grades: [by_min, by_median], words }) => {
            if (by_min - by_median).abs() > NOISE {
                let why = format!(
                    "too noisy to grade: {by_min:.0} of 100 by the shortest takes, {by_median:.0} \
                     by the medians ({words}). Grade again while the machine is idle"
                );
                (Verdict::TooNoisy, None, why)
            } else {
                (Verdict::Graded, Some(by_min), words)
            }
        }
        Err(Without::Wrong(why)) => (Verdict::Wrong, Some(0.0), why),
        Err(Without::NotTimed(why)) => (Verdict::NotTimed, None, why),
    };
    // Two decimals: half points are given, and nobody adds up sixteen digits.
    let points = (timed.points * grade.unwrap_or(0.0)).round() / 100.0;
    let variant = timed.variant.clone();
    Measure { kind, variant, verdict, message, grade, points, out_of: timed.points }
}

fn complexity(runs: &[Run], timed: &Timed) -> Result<Found, Without> {
    let sizes = sizes(timed.n);
    let mut points: [Vec<(f64, f64)>; 2] = Default::default();
    let mut pairs = Vec::new();
    let mut slow = None;
    for &n in &sizes {
        let own = own(runs, timed, n, 1)?;
        if own.outcome == Outcome::TooSlow {
            // It took longer than this, so the slope is steeper still.
            slow = Some(own);
            points.iter_mut().for_each(|points| points.push((n as f64, longest(own))));
            break;
        }
        for (points, way) in points.iter_mut().zip(WAYS) {
            points.push((n as f64, net(runs, own, way)?));
        }
        let counted = own.counted.get("pair tests per particle and step");
        pairs.extend(counted.map(|tests| (n as f64, n as f64 * tests)));
    }
    if points[0].len() < 3 {
        let why = "too slow to see how its time grows".to_owned();
        return Ok(Found { grades: [0.0; 2], words: why });
    }
    let mut slopes = [0.0; 2];
    let mut dawdles = false;
    for ((slope_of, points), way) in slopes.iter_mut().zip(&points).zip(WAYS) {
        *slope_of = slope(points);
        let Some(&last) = points.last() else { continue };
        let solution = |n| net(runs, solution(runs, timed, n, 1)?, way);
        if last.1 > DAWDLE * solution(last.0 as usize)? {
            let from_solution = slope(&[(sizes[0] as f64, solution(sizes[0])?), last]);
            dawdles |= from_solution > *slope_of;
            *slope_of = slope_of.max(from_solution);
        }
    }
    let mut words = format!(
        "the time grows as n to the power {:.2}, from {} to {} particles",
        slopes[0], sizes[0], timed.n
    );
    if pairs.len() > 2 {
        words += &format!("; the pairs that it counts, as n to the power {:.2}", slope(&pairs));
    }
    if dawdles {
        words += "; it is so slow on the largest scene that the line begins at the solution's time";
    }
    if let Some(slow) = slow {
        words += &format!("; at n = {} there was {}", slow.n, slow.message);
    }
    Ok(Found { grades: slopes.map(complexity_grade), words })
}

fn scaling(runs: &[Run], timed: &Timed) -> Result<Found, Without> {
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
        last.push(format!("{p} threads {:.2} and {weak:.2}", strong));
    }
    let mean = |efficiencies: &[f64]| average(efficiencies).unwrap_or(0.0);
    let grades = [0, 1]
        .map(|way: usize| scaling_grade(mean(&efficiencies[way][0]), mean(&efficiencies[way][1])));
    let [strong, weak] = &efficiencies[0];
    let words = format!(
        "average efficiency against the serial program: strong {:.2}, weak {:.2} ({})",
        mean(strong),
        mean(weak),
        last.join(", ").replacen("1 threads", "1 thread", 1)
    );
    Ok(Found { grades, words })
}

fn speed(runs: &[Run], timed: &Timed) -> Result<Found, Without> {
    let all = runs.iter().filter(|run| is(run, Whose::Own, timed, STEPS) && run.n == timed.n);
    let Some(workers) = all.map(|run| run.workers).max() else {
        return Err(not_timed(timed, timed.n));
    };
    let own = own(runs, timed, timed.n, workers)?;
    if own.outcome == Outcome::TooSlow {
        return Ok(Found { grades: [0.0; 2], words: own.message.clone() });
    }
    let solution = solution(runs, timed, timed.n, workers)?;
    let mut times = [0.0; 2];
    for (times, way) in times.iter_mut().zip(WAYS) {
        *times = net(runs, own, way)? / net(runs, solution, way)?;
    }
    let words = format!("it takes {:.2} times as long as the solution", times[0]);
    Ok(Found { grades: times.map(|times| efficiency_grade(1.0 / times)), words })
}

fn is(run: &Run, whose: Whose, timed: &Timed, steps: u64) -> bool {
    let same = run.variant == timed.variant || run.whose == Whose::Serial;
    run.whose == whose && run.steps == steps && same
}

fn not_timed(timed: &Timed, n: usize) -> Without {
    Without::NotTimed(format!("{} was not timed at n = {n}: grade it again", timed.variant))
}

fn find<'r>(
    runs: &'r [Run],
    whose: Whose,
    timed: &Timed,
    (n, workers): (usize, usize),
) -> Result<&'r Run, Without> {
    let found =
        runs.iter().find(|r| is(r, whose, timed, STEPS) && r.n == n && r.workers == workers);
    found.ok_or_else(|| not_timed(timed, n))
}

/// A run of the submission, if it was not wrong.
fn own<'r>(runs: &'r [Run], timed: &Timed, n: usize, workers: usize) -> Result<&'r Run, Without> {
    judged(find(runs, Whose::Own, timed, (n, workers))?)
}

fn judged(run: &Run) -> Result<&Run, Without> {
    if run.outcome == Outcome::Wrong {
        let why = format!("its result is wrong, so its time is worth nothing: {}", run.message);
        return Err(Without::Wrong(why));
    }
    Ok(run)
}

fn solution<'r>(
    runs: &'r [Run],
    timed: &Timed,
    n: usize,
    workers: usize,
) -> Result<&'r Run, Without> {
    find(runs, Whose::Solution, timed, (n, workers))
}

fn serial<'r>(runs: &'r [Run], timed: &Timed, n: usize) -> Result<&'r Run, Without> {
    find(runs, Whose::Serial, timed, (n, 1))
}

fn longest(run: &Run) -> f64 {
    run.seconds.iter().copied().fold(0.0, f64::max)
}

/// Seconds of a run's shortest take, without start and result; none without a take.
pub(crate) fn seconds_of(record: &Record, run: &Run) -> Option<f64> {
    if run.outcome == Outcome::Timed { net(&record.runs, run, Times::min).ok() } else { None }
}

/// Seconds of a run; forever if it was too slow.
fn seconds(runs: &[Run], run: &Run, way: Of) -> Result<f64, Without> {
    if run.outcome == Outcome::TooSlow { Ok(f64::INFINITY) } else { net(runs, run, way) }
}

/// Seconds of a run without those that it takes to make such a scene and to send the result.
fn net(runs: &[Run], run: &Run, way: Of) -> Result<f64, Without> {
    let times = |run: &Run| {
        let none = || Without::NotTimed("no take was finished: grade it again".into());
        Times::of(run.seconds.clone()).map(|times| way(&times)).ok_or_else(none)
    };
    let idle = runs.iter().find(|r| r.whose != Whose::Own && r.steps == 0 && r.n == run.n);
    let idle = idle.map(times).transpose()?.unwrap_or(0.0);
    Ok((times(run)? - idle).max(1e-6))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::judge;
    use crate::grade::record::{Kind, Outcome, Record, Run, Verdict, Whose};
    use crate::grade::rubric::{Rubric, Timed};
    use crate::grade::timing::plan::{STEPS, jobs};

    /// A record whose runs all took what `seconds` says, by whose program, n and workers.
    fn record(
        rubric: &Rubric,
        cores: usize,
        seconds: impl Fn(Whose, f64, f64) -> Vec<f64>,
    ) -> Record {
        let sample = include_str!("../../../tests/record.json");
        let mut record: Record = serde_json::from_str(sample).unwrap();
        record.timed = true;
        record.runs = jobs(rubric, cores)
            .iter()
            .map(|job| {
                let start = 0.01;
                let takes = if job.steps == 0 {
                    vec![start; 5]
                } else {
                    let takes = seconds(job.whose, job.n as f64, job.workers as f64);
                    takes.into_iter().map(|take| take + start).collect()
                };
                Run { seconds: takes, ..job.run() }
            })
            .collect();
        record
    }

    fn timed(n: usize) -> Option<Timed> {
        Some(Timed { points: 20.0, variant: "sorted".into(), n })
    }

    fn grade(record: &Record, rubric: &Rubric, kind: Kind) -> (Verdict, Option<f64>, String) {
        let all = judge(record, rubric);
        let measure = all.into_iter().find(|measure| measure.kind == kind).unwrap();
        (measure.verdict, measure.grade, measure.message)
    }

    fn complexity(own: impl Fn(f64) -> f64) -> (Option<f64>, String) {
        let rubric = Rubric { complexity: timed(64_000), ..Rubric::default() };
        let record = record(&rubric, 2, |whose, n, _| {
            vec![if whose == Whose::Own { own(n) } else { 2e-6 * n }; 5]
        });
        let (_, grade, words) = grade(&record, &rubric, Kind::Complexity);
        (grade, words)
    }

    #[test]
    fn the_slope_decides() {
        assert_eq!(complexity(|n| 4e-6 * n).0, Some(100.0));
        assert!(complexity(|n| 1e-9 * n * n).0.unwrap() < 1e-6);
        let (grade, words) = complexity(|n| 1e-7 * n.powf(1.4));
        assert!((grade.unwrap() - 87.5).abs() < 1e-6 && words.contains("power 1.40"), "{words}");
    }

    #[test]
    fn to_dawdle_on_small_scenes_makes_no_line_flat() {
        // All pairs, and a wait until the large scene would be done.
        let (grade, words) = complexity(|n| (1e-9 * n * n).max(4.0));
        assert!(grade.unwrap() < 30.0 && words.contains("begins at the solution's"), "{words}");
        let (grade, _) = complexity(|n| 2e-6 * n + 1.0);
        assert_eq!(grade, Some(100.0), "slow, and yet it grows with n");
    }

    #[test]
    fn who_is_too_slow_for_the_large_scenes_is_not_flat_either() {
        let rubric = Rubric { complexity: timed(64_000), ..Rubric::default() };
        let mut record = record(&rubric, 2, |whose, n, _| {
            vec![if whose == Whose::Own { 1e-9 * n * n } else { 2e-6 * n }; 5]
        });
        for run in record.runs.iter_mut().filter(|r| r.whose == Whose::Own && r.n >= 32_000) {
            (run.outcome, run.seconds) = (Outcome::TooSlow, vec![8.0]);
            run.message = "no result within 8 s".into();
        }
        let (verdict, grade, words) = grade(&record, &rubric, Kind::Complexity);
        assert!(verdict == Verdict::Graded && grade.unwrap() < 1e-6, "{words}");
        assert!(words.contains("at n = 32000 there was no result"), "{words}");
    }

    #[test]
    fn efficiency_is_measured_against_the_serial_program() {
        let rubric = Rubric { scaling: timed(100_000), ..Rubric::default() };
        let perfect = |whose, n: f64, p: f64| {
            vec![if whose == Whose::Own { 2e-6 * n / p } else { 2e-6 * n }; 5]
        };
        let record = record(&rubric, 2, perfect);
        let (_, grade_of, words) = grade(&record, &rubric, Kind::Scaling);
        assert_eq!(grade_of, Some(100.0), "{words}");
        let lazy = |whose, n: f64, _| vec![if whose == Whose::Own { 4e-6 } else { 2e-6 } * n; 5];
        let record = self::record(&rubric, 2, lazy);
        // Strong: 0.5 and 0.25; weak: 0.5 and 0.25.
        let (_, grade_of, words) = grade(&record, &rubric, Kind::Scaling);
        assert!((grade_of.unwrap() - 56.25).abs() < 1e-6, "{words}");
        assert!(words.contains("strong 0.38, weak 0.38"), "{words}");
    }

    #[test]
    fn speed_is_relative_to_the_solution() {
        let rubric = Rubric { speed: timed(1000), ..Rubric::default() };
        let of = |times: f64| {
            let record = record(&rubric, 2, |whose, _, _| {
                vec![if whose == Whose::Own { 0.1 * times } else { 0.1 }; 5]
            });
            grade(&record, &rubric, Kind::Speed).1.unwrap()
        };
        assert_eq!(of(1.1), 100.0);
        assert!((of(2.0) - 75.0).abs() < 1e-6 && (of(4.0) - 37.5).abs() < 1e-6);
    }

    #[test]
    fn noise_is_not_graded_and_wrong_is_worth_nothing() {
        let rubric = Rubric { speed: timed(1000), ..Rubric::default() };
        let mut record = record(&rubric, 2, |whose, _, _| match whose {
            Whose::Own => vec![0.1, 0.3, 0.3, 0.3, 0.4],
            _ => vec![0.1; 5],
        });
        let (verdict, given, words) = grade(&record, &rubric, Kind::Speed);
        assert_eq!((verdict, given), (Verdict::TooNoisy, None));
        assert!(words.contains("Grade again"), "{words}");
        let own = record.runs.iter_mut().find(|run| run.whose == Whose::Own).unwrap();
        (own.outcome, own.message) = (Outcome::Wrong, "particle 3 is lost".into());
        let (verdict, given, words) = grade(&record, &rubric, Kind::Speed);
        assert_eq!((verdict, given), (Verdict::Wrong, Some(0.0)));
        assert!(words.contains("particle 3 is lost"), "{words}");
        record.runs.clear();
        assert_eq!(grade(&record, &rubric, Kind::Speed).0, Verdict::NotTimed);
    }

    #[test]
    fn counted_pairs_stand_beside_the_time() {
        let rubric = Rubric { complexity: timed(64_000), ..Rubric::default() };
        let mut record = record(&rubric, 2, |_, n, _| vec![2e-6 * n; 5]);
        for run in record.runs.iter_mut().filter(|r| r.steps == STEPS) {
            let name = "pair tests per particle and step".to_owned();
            run.counted = BTreeMap::from([(name, run.n as f64)]);
        }
        let (_, given, words) = grade(&record, &rubric, Kind::Complexity);
        assert_eq!(given, Some(100.0), "what a program says of itself is no mark");
        assert!(words.contains("the pairs that it counts, as n to the power 2.00"), "{words}");
    }
}
