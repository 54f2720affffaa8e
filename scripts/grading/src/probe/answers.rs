//! What a probe answers, and whether it is what the solution answers.

use super::runs;

/// Two results that differ by rounding differ by at most so much, relative to 1 + their size.
const CLOSE: f64 = 1e-10;

/// What a program said to one question.
#[derive(Debug, PartialEq)]
pub(crate) struct Answer {
    how: How,
    pub(crate) question: String,
    values: Vec<f64>,
}

/// How an answer is compared with the solution's.
#[derive(Clone, Copy, Debug, PartialEq)]
enum How {
    /// It is the same.
    Exact,
    /// It differs by rounding.
    Close,
    /// It is a run that the model follows.
    Steps,
    /// It is a run with the same bits.
    Bits,
}

impl How {
    fn named(name: &str) -> Option<Self> {
        Some(match name {
            "exact" => Self::Exact,
            "close" => Self::Close,
            "steps" => Self::Steps,
            "bits" => Self::Bits,
            _ => return None,
        })
    }
}

/// The answers that a program wrote, a line each; none if a line is no answer. Who was ended may have
/// begun another line.
pub(crate) fn answers(written: &str) -> Option<Vec<Answer>> {
    let answer = |line: &str| {
        let mut parts = line.splitn(3, '|');
        let how = How::named(parts.next()?)?;
        let question = parts.next()?.to_owned();
        let bits = parts.next()?.split_whitespace();
        let values = bits.map(|bits| Some(f64::from_bits(u64::from_str_radix(bits, 16).ok()?)));
        Some(Answer { how, question, values: values.collect::<Option<_>>()? })
    };
    let whole = written.rsplit_once('\n').map_or("", |(whole, _)| whole);
    whole.lines().map(answer).collect()
}

/// How strictly is the solution's to say: a submission's own word on that is not heard.
pub(crate) fn compare(expected: &[Answer], given: &[Answer]) -> Option<String> {
    for (index, right) in expected.iter().enumerate() {
        let question = &right.question;
        let Some(answer) = given.get(index) else {
            return Some(format!("it ended without an answer to: {question}"));
        };
        if answer.question != *question {
            return Some(format!("it answered '{}' to: {question}", answer.question));
        }
        if let Some(words) = wrong(right, answer) {
            return Some(format!("{question}: {words}"));
        }
    }
    (given.len() > expected.len()).then(|| "it gave more answers than there were questions".into())
}

/// What is wrong with an answer.
fn wrong(right: &Answer, answer: &Answer) -> Option<String> {
    match right.how {
        How::Exact => differs(&right.values, &answer.values, |got, want| {
            got == want || got.is_nan() && want.is_nan()
        }),
        How::Close => differs(&right.values, &answer.values, |got, want| {
            (got - want).abs() <= CLOSE * (1.0 + want.abs())
        }),
        How::Steps => runs::off_the_model(&right.values, &answer.values),
        How::Bits => runs::other_bits(&right.values, &answer.values),
    }
}

/// The share of the questions that were answered rightly. The last one only says that the probe came to its end.
pub(crate) fn share(expected: &[Answer], given: &[Answer]) -> f64 {
    let asked = expected.split_last().map_or(expected, |(_, asked)| asked);
    let is_right = |(right, answer): &(&Answer, &Answer)| {
        right.question == answer.question && wrong(right, answer).is_none()
    };
    asked.iter().zip(given).filter(is_right).count() as f64 / asked.len().max(1) as f64
}

/// As people write it: 103, 0.25, 1e-12.
fn number(value: f64) -> String {
    let plain = value == 0.0 || (1e-4..1e9).contains(&value.abs());
    if plain { value.to_string() } else { format!("{value:e}") }
}

fn differs(right: &[f64], given: &[f64], same: impl Fn(f64, f64) -> bool) -> Option<String> {
    let list = |values: &[f64]| match values {
        [] => "nothing".to_owned(),
        some => some.iter().map(|value| number(*value)).collect::<Vec<_>>().join(", "),
    };
    let wrong = given.iter().zip(right).position(|(got, want)| !same(*got, *want));
    match wrong {
        None if given.len() == right.len() => None,
        _ if given.len().max(right.len()) <= 8 => {
            Some(format!("{}; right is {}", list(given), list(right)))
        }
        None => Some(format!("{} values, not {}", given.len(), right.len())),
        Some(at) => {
            Some(format!("value {} is {}, not {}", at + 1, number(given[at]), number(right[at])))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::How::{Close, Exact};
    use super::{Answer, How, answers, compare, number, share};

    fn answer(how: How, values: &[f64]) -> Answer {
        Answer { how, question: "q".into(), values: values.to_vec() }
    }

    #[test]
    fn every_line_is_an_answer() {
        let written = "exact|q|3ff0000000000000\nclose|q|0\nexa";
        assert_eq!(answers(written), Some(vec![answer(Exact, &[1.0]), answer(Close, &[0.0])]));
        assert_eq!(answers("exact|q|0\nnonsense\n"), None);
        assert_eq!(answers(""), Some(vec![]));
    }

    #[test]
    fn numbers_are_written_as_people_do() {
        let all = [103.0, 0.25, 0.0, -3.5e-11, 1e12, f64::NAN];
        assert_eq!(all.map(number), ["103", "0.25", "0", "-3.5e-11", "1e12", "NaN"]);
    }

    #[test]
    fn the_solution_says_how_strictly() {
        let right = [answer(Exact, &[1.0])];
        assert_eq!(compare(&right, &[answer(Exact, &[1.0])]), None);
        assert!(compare(&right, &[answer(Close, &[1.0 + 1e-15])]).is_some());
        let about = [answer(Close, &[1.0])];
        assert_eq!(compare(&about, &[answer(Exact, &[1.0 + 1e-12])]), None);
        assert!(compare(&about, &[answer(Close, &[f64::NAN])]).is_some());
        assert!(compare(&about, &[]).is_some(), "no answer");
        let twice = [answer(Close, &[1.0]), answer(Close, &[1.0])];
        assert!(compare(&about, &twice).is_some(), "one too many");
        let four = [1.0, 2.0, 3.0, 4.0].map(|value| answer(Close, &[value]));
        let half = [1.0, 0.0, 3.0].map(|value| answer(Close, &[value]));
        assert_eq!((share(&four, &half), share(&four, &four[..1])), (2.0 / 3.0, 1.0 / 3.0));
    }
}
