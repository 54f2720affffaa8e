//! The program that lets a parent process look into a lab: `probe FILE TASK SEED`.
//!
//! It makes inputs from the seed, asks the lab, and writes what came out into the file, a line per
//! question: what the lab prints is its own affair. It judges nothing: the same program with the
//! solution behind it gets the same question, and the parent compares.

#![allow(missing_docs, dead_code)]

use std::fs::File;
use std::io::Write;

mod lab;
#[path = "../oracle/src/random.rs"]
mod random;

pub use random::Random;

/// Writes answers.
pub struct Answers {
    file: File,
}

impl Answers {
    /// What must be the solution's to the bit.
    pub fn exact(&mut self, question: &str, values: &[f64]) {
        self.write("exact", question, values);
    }

    /// What may differ by rounding.
    pub fn close(&mut self, question: &str, values: &[f64]) {
        self.write("close", question, values);
    }

    /// For questions that tests ask too: what is right is the solution's to say here.
    pub fn told(&mut self) -> impl FnMut(&str, Vec<f64>, Vec<f64>) {
        |question, found, _| self.exact(question, &found)
    }

    /// A run that the parent takes again with the model, step by step, from where each step began:
    /// side of the box, number of particles, and x y vx vy of all before the first step and after
    /// every one.
    pub fn steps(&mut self, question: &str, run: &[f64]) {
        self.write("steps", question, run);
    }

    /// Such a run, which must be the solution's to the bit.
    pub fn bits(&mut self, question: &str, run: &[f64]) {
        self.write("bits", question, run);
    }

    fn write(&mut self, how: &str, question: &str, values: &[f64]) {
        let bits: Vec<String> = values.iter().map(|v| format!("{:x}", v.to_bits())).collect();
        let line = format!("{how}|{question}|{}\n", bits.join(" "));
        self.file.write_all(line.as_bytes()).expect("the file has room");
    }
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let [_, file, task, seed] = &arguments[..] else { panic!("probe FILE TASK SEED") };
    let mut random = Random::new(seed.parse().expect("the seed is a number"));
    // Ranks have the file open at the same time.
    let file = File::options().append(true).open(file).expect("the file is there");
    let mut answers = Answers { file };
    lab::ask(task, &mut random, &mut answers);
    answers.exact("end", &[]);
}
