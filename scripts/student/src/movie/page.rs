//! The page of a movie.
//!
//! It contains the data of a run, the book's scripts that play it, and a still picture for browsers
//! without scripts.

use std::fmt::Write;

use anyhow::{Result, ensure};
use lab_kit::escape::html;
use lab_kit::files::read_text;
use lab_kit::{Discs, Kit, facts};
use serde_json::json;

use super::frames::Movie;

/// Maximal number of bytes of a page.
const MOST: usize = 1_000_000;
/// Bytes of a page that contain neither frames nor discs of the picture.
const REST: usize = 90_000;
/// Letters of a disc in a frame: four numbers of two bytes, with six bits in a letter.
const LETTERS_PER_DISC: usize = 11;
/// Letters of a disc in the picture.
const LETTERS_OF_STILL: usize = 14;
/// Letters of the data about a whole frame.
const LETTERS_PER_FRAME: usize = 40;

/// The book's scripts, in the order of their dependencies.
const SCRIPTS: [&str; 12] = [
    "random", "soft", "searches", "hard", "player", "panel", "layers", "recorded", "owners",
    "kinds", "movie", "boxes",
];

/// Data of a page about its run.
pub(super) struct Run {
    /// Title: lab, variant, workers.
    pub(super) title: String,
    pub(super) discs: Discs,
    pub(super) radius: f64,
    pub(super) dt: f64,
    /// Step of the first frame, and number of steps between frames.
    pub(super) first: u32,
    pub(super) between: u32,
    pub(super) workers: u16,
    /// Initial settings of the page.
    pub(super) shown: facts::Movie,
}

/// Returns the number of frames of `n` discs that fit into a page.
pub(super) fn room(n: usize) -> usize {
    (MOST - REST).saturating_sub(LETTERS_OF_STILL * n) / (LETTERS_PER_DISC * n + LETTERS_PER_FRAME)
}

/// Writes the whole page of a run.
///
/// # Errors
/// If a script of the book cannot be read, or if the page is too long.
pub(super) fn write(kit: &Kit, run: &Run, movie: &Movie) -> Result<String> {
    let is_soft = run.discs == Discs::Soft;
    let data = json!({
        "kind": if is_soft { "soft" } else { "hard" },
        "n": movie.n, "size": movie.size, "radius": run.radius, "fastest": movie.fastest,
        "dt": run.dt, "first": run.first, "between": run.between,
        "workers": run.workers, "layers": run.shown.layers, "method": run.shown.asks, "cut": run.shown.cut,
        "energy": movie.energy, "touching": movie.touching, "frames": movie.frames(),
    });
    let mut scripts = String::new();
    for name in SCRIPTS {
        scripts += &read_text(&kit.path(format!("book/src/live/{name}.js")))?;
    }
    let says = says(run, movie);
    let page = include_str!("page.html")
        .replace("STYLE", &read_text(&kit.path("book/theme/live.css"))?)
        .replace("TITLE", &html(&run.title))
        .replace("PICTURE", &picture(run, movie))
        .replace("SAYS", &html(&says))
        .replace("SCRIPTS", &scripts)
        // The data must not contain the end tag of the script around it.
        .replace("MOVIE", &data.to_string().replace('<', "\\u003c"));
    ensure!(page.len() <= MOST, "the page would have {} bytes, more than {MOST}", page.len());
    Ok(page)
}

/// Describes the picture and the movie in words.
fn says(run: &Run, movie: &Movie) -> String {
    let frames = movie.energy.len();
    let last = run.first + run.between * (frames as u32 - 1);
    let n = movie.n;
    let time = f64::from(last) * run.dt;
    let energy = movie.energy[frames - 1];
    let circles = match run.discs {
        Discs::Soft => format!(
            "Circles have the diameter c = {}, so two that overlap are within the cutoff; they are orange, and \
             there are {} such pairs",
            2.0 * run.radius,
            movie.touching[frames - 1]
        ),
        Discs::Hard => format!("Circles are the discs, of radius {}", run.radius),
    };
    format!(
        "The end of the run: {n} discs in a box of side {:.4} after step {last}, at time {time:.4}. {circles}. \
         The energy is {energy:.4}; at step {} it was {:.4}. Where scripts run, all {frames} frames play.",
        movie.size, run.first, movie.energy[0]
    )
}

/// Draws the last frame. A disc is a line of zero length with round ends, which needs the fewest
/// letters.
fn picture(run: &Run, movie: &Movie) -> String {
    const SIDE: f64 = 4000.0;
    let scale = SIDE / movie.size;
    let mut paths = [String::new(), String::new()];
    for (disc, touches) in &movie.still {
        let x = disc.x * scale;
        let y = SIDE - disc.y * scale;
        write!(paths[usize::from(*touches)], "M{x:.0} {y:.0}h0").expect("a string grows");
    }
    let [apart, touching] = paths;
    format!(
        "data:image/svg+xml,%3Csvg xmlns='http://www.w3.org/2000/svg' width='680' height='680' \
         viewBox='-20 -20 4040 4040'%3E\
         %3Crect width='4000' height='4000' fill='%23fff' stroke='%23717982' stroke-width='12'/%3E\
         %3Cg fill='none' stroke-linecap='round' stroke-width='{:.1}'%3E\
         %3Cpath stroke='%23717982' d='{apart}'/%3E%3Cpath stroke='%23c75000' d='{touching}'/%3E\
         %3C/g%3E%3C/svg%3E",
        2.0 * run.radius * scale
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::movie::frames;

    fn run(discs: Discs) -> Run {
        Run {
            title: "Lab 0, <nothing>".into(),
            discs,
            radius: 0.005,
            dt: 0.0005,
            first: 1,
            between: 2,
            workers: 3,
            shown: facts::Movie { layers: vec!["</script>".into()], ..Default::default() },
        }
    }

    /// Makes a movie of `frames` frames of `n` discs that fly to the right.
    fn flying(n: usize, frames: usize) -> Movie {
        let mut text = format!("{n} 0.5\n");
        for frame in 0..frames {
            for i in 0..n {
                let x = 0.0009 * frame as f64;
                let y = 0.5 * i as f64 / n as f64;
                writeln!(text, "{x} {y} 1.23456 -0.9").unwrap();
            }
            text += "\n";
        }
        frames::soft(&text).unwrap()
    }

    #[test]
    fn a_page_is_one_file_and_says_without_scripts_what_it_shows() {
        let kit = Kit::find().unwrap();
        let movie = flying(3, 5);
        let page = write(&kit, &run(Discs::Soft), &movie).unwrap();
        for outside in [" src=\"http", "src=\"/", "<link", "@import", "url("] {
            assert!(!page.contains(outside), "the page loads {outside}");
        }
        assert_eq!(page.matches("src=").count(), 1, "nothing but the picture has a source");
        assert!(page.contains("<h1>Lab 0, &lt;nothing></h1>"));
        let figure = page.split_once("<figure").unwrap().1.split_once("</figure>").unwrap().0;
        let caption = "3 discs in a box of side 0.5000 after step 9, at time 0.0045.";
        assert_eq!(figure.matches(caption).count(), 2, "in the picture's words and in the caption");
        assert_eq!(figure.matches("h0").count(), 3, "a disc each in the picture");
        for name in ["STYLE", "TITLE", "PICTURE", "SAYS", "SCRIPTS"] {
            assert!(!page.contains(name), "{name} is left in the page");
        }
        let data = page.split_once("type=\"application/json\">").unwrap().1;
        let data: serde_json::Value =
            serde_json::from_str(data.split_once("</script>").unwrap().0).unwrap();
        assert_eq!(data["layers"][0], "</script>");
        assert_eq!(data["frames"].as_str().unwrap(), movie.frames());
        assert_eq!((&data["n"], &data["between"]), (&json!(3), &json!(2)));
    }

    #[test]
    fn what_there_is_room_for_makes_a_page_of_less_than_a_megabyte() {
        let kit = Kit::find().unwrap();
        for n in [1, 500, 2000] {
            let frames = room(n).min(2000);
            let page = write(&kit, &run(Discs::Soft), &flying(n, frames)).unwrap();
            assert!(page.len() <= MOST && (n == 1 || page.len() > MOST * 8 / 10), "{}", page.len());
        }
        let long = write(&kit, &run(Discs::Soft), &flying(500, 2 * room(500)));
        assert!(long.unwrap_err().to_string().contains("more than 1000000"));
        assert!(room(500) >= 150 && room(100_000) < 2);
    }
}
