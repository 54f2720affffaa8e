//! Every link inside the built book leads to something that is there.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Component, Path, PathBuf};

use anyhow::Result;
use html5gum::emitters::default::DefaultEmitter;
use html5gum::{Token, Tokenizer};

use lab_kit::files::{files_below, read_text};

/// A page: what can be linked to in it, and what it links to.
#[derive(Default)]
struct Page {
    anchors: BTreeSet<String>,
    links: BTreeSet<String>,
}

/// Looks at every `href` and `src` of every page below `build`.
///
/// # Errors
/// The folder cannot be read. Links that lead nowhere are returned, a line each.
pub(crate) fn check(build: &Path) -> Result<Vec<String>> {
    let mut pages = BTreeMap::new();
    for path in files_below(build)? {
        if path.extension().is_some_and(|e| e == "html") {
            let html = read_text(&path)?;
            pages.insert(path, read(&html));
        }
    }
    let mut wrong = Vec::new();
    for (path, page) in &pages {
        for link in &page.links {
            if let Err(why) = follow(build, path, link, &pages) {
                let name = path.strip_prefix(build).unwrap_or(path);
                wrong.push(format!("{}: the link {link} {why}", name.display()));
            }
        }
    }
    Ok(wrong)
}

fn read(html: &str) -> Page {
    let mut page = Page::default();
    let mut emitter = DefaultEmitter::default();
    // The text of a script is no markup.
    emitter.naively_switch_states(true);
    for Ok(token) in Tokenizer::new_with_emitter(html, emitter) {
        let Token::StartTag(tag) = token else { continue };
        for (name, value) in &tag.attributes {
            let value = String::from_utf8_lossy(value).into_owned();
            match &name[..] {
                b"id" | b"name" => page.anchors.insert(value),
                b"href" | b"src" => page.links.insert(value),
                _ => false,
            };
        }
    }
    page
}

fn follow(
    build: &Path,
    from: &Path,
    link: &str,
    pages: &BTreeMap<PathBuf, Page>,
) -> Result<(), &'static str> {
    let elsewhere = ["http://", "https://", "mailto:", "data:", "javascript:"];
    if elsewhere.iter().any(|scheme| link.starts_with(scheme)) {
        return Ok(());
    }
    let (path, anchor) = link.split_once('#').unwrap_or((link, ""));
    let path = path.split('?').next().unwrap_or_default();
    let target = match path {
        "" => from.to_owned(),
        path => match path.strip_prefix('/') {
            Some(absolute) => build.join(absolute),
            None => tidy(&from.parent().unwrap_or(build).join(path)),
        },
    };
    let target = if target.is_dir() { target.join("index.html") } else { target };
    if !target.is_file() {
        return Err("leads to no file");
    }
    match pages.get(&target) {
        Some(page) if !anchor.is_empty() && !page.anchors.contains(anchor) => {
            Err("leads to no such place in the page")
        }
        _ => Ok(()),
    }
}

/// The path without `.` and `..`.
fn tidy(path: &Path) -> PathBuf {
    let mut tidy = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir => {
                tidy.pop();
            }
            Component::CurDir => {}
            part => tidy.push(part),
        }
    }
    tidy
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::check;

    fn faults(body: &str) -> Vec<String> {
        let build = tempfile::tempdir().unwrap();
        fs::create_dir(build.path().join("deep")).unwrap();
        fs::write(build.path().join("picture.svg"), "<svg/>").unwrap();
        fs::write(build.path().join("deep/other.html"), "<h2 id='there'>There</h2>").unwrap();
        fs::write(build.path().join("index.html"), body).unwrap();
        check(build.path()).unwrap()
    }

    #[test]
    fn links_that_lead_somewhere() {
        for link in [
            "deep/other.html",
            "deep/other.html#there",
            "deep/../index.html",
            "#here",
            "https://a.b/c#d",
        ] {
            assert_eq!(faults(&format!("<p id=here><a href='{link}'>x</a>")), [""; 0], "{link}");
        }
        assert!(faults("<img src=picture.svg>").is_empty());
    }

    #[test]
    fn links_that_do_not() {
        for link in ["gone.html", "deep/other.html#here", "#there", "deep"] {
            assert_eq!(faults(&format!("<a href='{link}'>x</a>")).len(), 1, "{link}");
        }
        assert_eq!(faults("<img src=gone.svg>").len(), 1);
    }

    #[test]
    fn a_link_in_a_comment_or_script_is_none() {
        assert!(
            faults("<!-- <a href=gone.html> --><script>'<a href=gone.html>'</script>").is_empty()
        );
    }
}
