//! Format of the answers: each is stored with its question, and consists of numbers or of a text.
//!
//! An entry consists of the length of the question, the question, the length of the answer in
//! bytes, and the answer. The answer is a list of 64-bit floating-point numbers, or a text. All
//! numbers are little-endian. The last entry is an answer to the question [`END`], so that a
//! program that broke off is detected.

use std::io::{self, Read, Write};

/// Name of the pseudo-question after the last question.
pub(super) const END: &str = "end";

/// Greatest length in bytes of a question or an answer. Longer questions and answers are refused,
/// because no lab has any.
const MOST: u64 = 1 << 30;

pub(super) fn write(file: &mut impl Write, question: &str, answer: &[u8]) -> io::Result<()> {
    for part in [question.as_bytes(), answer] {
        file.write_all(&(part.len() as u64).to_le_bytes())?;
        file.write_all(part)?;
    }
    Ok(())
}

/// Reads the next question and its answer.
pub(super) fn read(file: &mut impl Read) -> io::Result<(String, Vec<u8>)> {
    let question = String::from_utf8_lossy(&part(file)?).into_owned();
    Ok((question, part(file)?))
}

fn part(file: &mut impl Read) -> io::Result<Vec<u8>> {
    let mut length = [0; 8];
    file.read_exact(&mut length)?;
    let length = u64::from_le_bytes(length);
    if length > MOST {
        return Err(io::ErrorKind::InvalidData.into());
    }
    let mut bytes = Vec::new();
    file.take(length).read_to_end(&mut bytes)?;
    if bytes.len() as u64 == length { Ok(bytes) } else { Err(io::ErrorKind::UnexpectedEof.into()) }
}

pub(super) fn to_bytes(numbers: &[f64]) -> Vec<u8> {
    numbers.iter().flat_map(|number| number.to_le_bytes()).collect()
}

/// Converts bytes to numbers. `None` if the length is not a multiple of eight bytes.
pub(super) fn to_numbers(bytes: &[u8]) -> Option<Vec<f64>> {
    let (numbers, rest) = bytes.as_chunks::<8>();
    rest.is_empty().then(|| numbers.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect())
}

#[cfg(test)]
mod tests {
    use super::{read, to_bytes, to_numbers, write};

    #[test]
    fn answers_are_read_back() {
        let mut file = Vec::new();
        write(&mut file, "how many?", &to_bytes(&[1.5, f64::NAN])).unwrap();
        write(&mut file, "a table", b"x").unwrap();
        let mut rest = &file[..];
        let (question, answer) = read(&mut rest).unwrap();
        assert_eq!(question, "how many?");
        let numbers = to_numbers(&answer).unwrap();
        assert!(numbers[0] == 1.5 && numbers[1].is_nan());
        assert_eq!(read(&mut rest).unwrap(), ("a table".into(), b"x".to_vec()));
        assert!(read(&mut rest).is_err(), "the file is at its end");
        assert!(read(&mut &file[..12]).is_err(), "a part of an answer");
        assert!(read(&mut &[255; 9][..]).is_err(), "an absurd length");
        assert_eq!(to_numbers(b"1234567"), None);
    }
}
