//! Turns each known-wrong body that is run here into an expression.

use std::path::Path;
use std::{env, fs, io};

/// Page and heading of each program.
const BODIES: [(&str, &str); 2] =
    [("lab3.md", "no_barrier_before_the_arrivals"), ("lab4.md", "old_bin_first")];

fn main() -> io::Result<()> {
    let out = env::var_os("OUT_DIR").ok_or_else(|| io::Error::other("cargo sets OUT_DIR"))?;
    for (page, name) in BODIES {
        let path = Path::new("../wrong").join(page);
        println!("cargo::rerun-if-changed={}", path.display());
        let text = fs::read_to_string(&path)?;
        let body = body(&text, name)
            .ok_or_else(|| io::Error::other(format!("{page} has no program '{name}'")))?;
        fs::write(Path::new(&out).join(name).with_extension("rs"), format!("{{\n{body}}}\n"))?;
    }
    Ok(())
}

/// Returns the code of the program under a heading of a page.
fn body<'a>(page: &'a str, name: &str) -> Option<&'a str> {
    let (_, section) = page.split_once(&format!("\n## {name}\n"))?;
    let (_, code) = section.split_once("```rust\n")?;
    Some(code.split_once("```\n")?.0)
}
