//! The package beside a submission: the probe, and the program that runs all of the lab's.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};

use crate::{probe, timing};
use lab_kit::Facts;
use lab_kit::files::{read_bytes, read_text, write_file};
use lab_kit::submission::Sources;
use lab_kit::{Kit, Lab, files_below};

/// Its manifest and its sources, by their paths in it.
#[derive(Clone)]
pub(super) struct Programs {
    manifest: String,
    sources: Sources,
}

/// What its programs are called.
pub(super) const NAMES: [&str; 2] = [probe::PROGRAM, timing::PROGRAM];

impl Programs {
    /// Those of a lab, laid beside `folder`, the lab's own.
    pub(super) fn of(kit: &Kit, lab: Lab, rubric: &Facts, folder: &Path) -> Result<Self> {
        let serial = rubric.scaling.is_some();
        let mut sources = Sources::new();
        let mut add = |from: &Path, to: String| {
            sources.insert(to, read_bytes(from)?);
            anyhow::Ok(())
        };
        for (path, to) in probe_sources(kit, lab)? {
            add(&path, to)?;
        }
        let timed = format!("src/bin/{}", timing::PROGRAM);
        for (to, from) in timing::sources(rubric) {
            add(&kit.path(from), format!("{timed}/{to}"))?;
        }
        sources.insert(format!("{timed}/scene.rs"), scene(lab, rubric).into_bytes());
        Ok(Self { manifest: manifest(folder, lab, serial)?, sources })
    }

    /// Puts programs that do nothing into `package`: as long as a submission is compiled, there is nothing
    /// of ours for it to include.
    pub(super) fn hide(&self, package: &Path) -> Result<()> {
        if package.exists() {
            fs::remove_dir_all(package)?;
        }
        let is_main = |path: &&String| path.ends_with("main.rs");
        for path in self.sources.keys().filter(is_main) {
            write_file(&package.join(path), b"fn main() {}")?;
        }
        write_file(&package.join("Cargo.toml"), self.manifest.as_bytes())
    }

    /// Puts the programs themselves there.
    pub(super) fn show(&self, package: &Path) -> Result<()> {
        self.sources.iter().try_for_each(|(path, text)| write_file(&package.join(path), text))
    }
}

/// The probe's files and their paths in its package: the frame, what the labs share, the lab's own, and
/// what these have in common with the lab's tests and with the oracle.
fn probe_sources(kit: &Kit, lab: Lab) -> Result<Vec<(PathBuf, String)>> {
    let (own, parts) = (format!("lab{lab}.rs"), format!("lab{lab}_"));
    let (tests, folder) = (kit.path("tests"), kit.path("tests/probes"));
    ensure!(
        folder.join(&own).is_file(),
        "there is no tests/probes/{own}: lab {lab} cannot be graded"
    );
    let probes = files_below(&folder)?.into_iter().filter_map(|path| {
        let name = match path.strip_prefix(&folder).ok()?.to_str()? {
            "frame.rs" => "main.rs",
            name if name == own => "lab.rs",
            name if name.starts_with("lab") && !name.starts_with(&parts) => return None,
            name => name,
        };
        let to = format!("src/{name}");
        Some((path, to))
    });
    let mut sources: Vec<_> = probes.collect();
    let texts = sources.iter().map(|(path, _)| read_text(path)).collect::<Result<String>>()?;
    let oracle = files_below(&tests.join("oracle/src"))?;
    let shared = kit.test_sources(lab)?.into_iter().chain(oracle).filter_map(|path| {
        let to = path.strip_prefix(&tests).ok()?.to_str()?.to_owned();
        texts.contains(&format!("\"../{to}\"")).then_some((path, to))
    });
    sources.extend(shared);
    Ok(sources)
}

/// The module that carries out an order: with the lab's program of that name, or with the serial one.
fn scene(lab: Lab, rubric: &Facts) -> String {
    let (mut modules, mut run) = (String::new(), String::from("None"));
    for (discs, variants) in timing::programs(rubric) {
        modules += &format!("mod {discs};\n");
        run += &format!(".or_else(|| {discs}::run(order, lab{lab}::{variants}))");
    }
    if rubric.scaling.is_some() {
        run =
            format!("if order.serial {{ soft::run(order, solution2::VARIANTS) }} else {{ {run} }}");
    }
    format!("{modules}\npub fn run(order: &crate::Order) -> Option<Vec<f64>> {{\n    {run}\n}}\n")
}

/// It needs the lab and whatever the lab needs: their types go in and out.
fn manifest(folder: &Path, lab: Lab, serial: bool) -> Result<String> {
    let text = fs::read_to_string(folder.join("Cargo.toml"))?;
    let (_, rest) = text.split_once("[dependencies]\n").context("the lab depends on nothing")?;
    let mut needs = rest.split("\n[").next().unwrap_or_default().to_owned();
    if serial && !needs.contains("solution2.") {
        needs.push_str("\nsolution2.workspace = true");
    }
    Ok(format!(
        "[package]\nname = \"probe\"\nedition.workspace = true\npublish = false\n\n\
         [dependencies]\nlab{lab} = {{ path = \"../lab{lab}\" }}\n{needs}\n"
    ))
}

/// What probe and timed program are made of, by paths in the kit.
pub(super) fn files(kit: &Kit, lab: Lab) -> Result<Vec<PathBuf>> {
    let probes = probe_sources(kit, lab)?.into_iter().map(|(path, _)| path);
    let timed = timing::sources(&kit.facts(lab)?).into_iter().map(|(_, path)| kit.path(path));
    Ok(probes.chain(timed).collect())
}
