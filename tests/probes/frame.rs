//! The program that lets a parent process look into a lab: `probe TASK SEED NONCE`.
//!
//! It makes inputs from the seed, asks the lab, and writes what came out, a line per question.
//! It judges nothing: the same program with the solution behind it gets the same question, and the
//! parent compares.

#![allow(missing_docs, dead_code)]

use std::io::Write;

mod lab;

/// Writes answers.
pub struct Answers {
    nonce: String,
}

/// Numbers from a seed (splitmix64).
pub struct Random(u64);

impl Answers {
    /// What must be the solution's to the bit.
    pub fn exact(&mut self, question: &str, values: &[f64]) {
        self.write("exact", question, values);
    }

    /// What may differ by rounding.
    pub fn close(&mut self, question: &str, values: &[f64]) {
        self.write("close", question, values);
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
        let mut out = std::io::stdout().lock();
        // A closed pipe is no error.
        let _ = writeln!(out, "\n@{} {how}|{question}|{}", self.nonce, bits.join(" "));
        let _ = out.flush();
    }
}

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number from `least` to `most`.
    pub fn between(&mut self, least: f64, most: f64) -> f64 {
        let unit = (self.bits() >> 11) as f64 / (1u64 << 53) as f64;
        least + (most - least) * unit
    }

    /// A whole number below `most`.
    pub fn below(&mut self, most: usize) -> usize {
        (self.bits() % most as u64) as usize
    }
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let [_, task, seed, nonce] = &arguments[..] else { panic!("probe TASK SEED NONCE") };
    let mut random = Random(seed.parse().expect("the seed is a number"));
    let mut answers = Answers { nonce: nonce.clone() };
    lab::ask(task, &mut random, &mut answers);
    answers.exact("end", &[]);
}
