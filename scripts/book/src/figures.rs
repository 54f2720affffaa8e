//! Each drawing is a link to itself, which knows how wide a phone must show it, or that there is a form for phones.

use std::fs;
use std::path::Path;

/// Text in a drawing is at least so high on a phone, in pixels.
const LEAST_TEXT: f64 = 12.0;

/// Puts a link to its own file around every SVG image that is in no link yet, be it an `<img>` or
/// Markdown's `![…](…)`. Files are looked for from `folder`, that of the page.
pub(crate) fn link(text: &str, folder: &Path) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some((at, image)) = next_image(rest) {
        let (before, after) = (&rest[..at], &rest[at + image.len()..]);
        out.push_str(before);
        match drawing(image) {
            Some(file) if image.starts_with('<') && !after.starts_with("</a>") => {
                let svg = fs::read_to_string(folder.join(file)).ok();
                let phone = for_phones(file).filter(|file| folder.join(file).is_file());
                let (style, image) = match (phone, svg.and_then(|svg| legible(&svg))) {
                    (Some(phone), _) => (String::new(), on_either(image, &phone)),
                    (None, Some(width)) => {
                        (format!(" style=\"--legible: {width}px\""), image.into())
                    }
                    (None, None) => (String::new(), image.into()),
                };
                out.push_str(&format!("<a class=\"figure\"{style} href=\"{file}\">{image}</a>"));
            }
            Some(file) if image.starts_with('!') && !before.ends_with('[') => {
                out.push_str(&format!("[{image}]({file})"));
            }
            _ => out.push_str(image),
        }
        rest = after;
    }
    out + rest
}

/// Where the form of a chart for phones would be: `figures/phone/a.svg` for `figures/a.svg`.
fn for_phones(file: &str) -> Option<String> {
    let (folder, name) = file.rsplit_once('/')?;
    Some(format!("{folder}/phone/{name}"))
}

/// The image on a page, the other file on a phone.
fn on_either(image: &str, phone: &str) -> String {
    format!("<picture><source media=\"(max-width: 600px)\" srcset=\"{phone}\">{image}</picture>")
}

/// How wide a drawing must be shown, in pixels, so that its smallest text can be read; none if it has no text.
fn legible(svg: &str) -> Option<f64> {
    let width = numbers(svg, "viewBox=\"0 0 ").next()?;
    let least = numbers(svg, "font-size").min_by(f64::total_cmp)?;
    Some((LEAST_TEXT * width / least).ceil())
}

/// The numbers behind a name, in attributes and in style sheets.
fn numbers(svg: &str, name: &'static str) -> impl Iterator<Item = f64> {
    let values = svg.split(name).skip(1).map(|rest| rest.trim_start_matches(['=', ':', '"', ' ']));
    let digits = |value: &str| value.find(|c: char| c != '.' && !c.is_ascii_digit());
    values.filter_map(move |value| value[..digits(value)?].parse().ok())
}

/// Where the next image begins, and the image.
fn next_image(text: &str) -> Option<(usize, &str)> {
    let tag = text.find("<img ").and_then(|at| {
        let mut quoted = false;
        let end = text[at..].find(|c| {
            quoted ^= c == '"';
            c == '>' && !quoted
        })?;
        Some((at, &text[at..=at + end]))
    });
    // `vec![` in a program is none: no file stands behind its bracket.
    let markdown = text.match_indices("![").find_map(|(at, _)| {
        let file = at + text[at..].find(']')?;
        let end = text[file..].starts_with("](").then(|| text[file..].find(')'))??;
        Some((at, &text[at..=file + end]))
    });
    [tag, markdown].into_iter().flatten().min_by_key(|(at, _)| *at)
}

/// The SVG file that an image shows.
fn drawing(image: &str) -> Option<&str> {
    let file = match image.split_once("src=\"") {
        Some((_, rest)) => rest.split('"').next(),
        None => image.rsplit_once("](").and_then(|(_, rest)| rest.strip_suffix(')')),
    };
    file.filter(|file| file.ends_with(".svg"))
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::{legible, link};

    fn linked_in(text: &str) -> String {
        link(text, Path::new("no such folder"))
    }

    #[test]
    fn a_phone_shows_the_smallest_text() {
        let svg = "<svg viewBox=\"0 0 520 404\"><text font-size=\"17\">a</text><text font-size=\"13\">b</text>";
        assert_eq!(legible(svg), Some(440.0));
        let styled = "<svg viewBox=\"0 0 520 404\"><style>svg { font-size: 17px } .small { font-size: 13px }</style>";
        assert_eq!(legible(styled), Some(440.0));
        assert_eq!(legible("<svg viewBox=\"0 0 520 404\"><rect/>"), None);
    }

    #[test]
    fn a_phone_shows_the_form_for_phones() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir_all(folder.path().join("figures/phone")).unwrap();
        std::fs::write(folder.path().join("figures/phone/a.svg"), "<svg/>").unwrap();
        let linked = link("<img src=\"figures/a.svg\" alt=\"A\">", folder.path());
        let source = "<source media=\"(max-width: 600px)\" srcset=\"figures/phone/a.svg\">";
        assert!(linked.contains(&format!("<picture>{source}<img ")), "{linked}");
    }

    #[test]
    fn drawings_are_links_and_nothing_else() {
        let tag = "<figure>\n<img src=\"figures/a.svg\" alt=\"A > B\">\n</figure> and ";
        let linked = "<figure>\n<a class=\"figure\" href=\"figures/a.svg\"><img \
                      src=\"figures/a.svg\" alt=\"A > B\"></a>\n</figure> and ";
        assert_eq!(linked_in(&tag.repeat(2)), linked.repeat(2));
        assert_eq!(linked_in(linked), linked, "what is a link stays as it is");
        let linked = "see [![A](a.svg)](a.svg).";
        assert_eq!(linked_in("see ![A](a.svg)."), linked);
        assert_eq!(linked_in(linked), linked, "what is a link stays as it is");
        let code = "`vec![0; n]` and ";
        assert_eq!(
            linked_in(&format!("{code}{tag}[B](#b)")),
            format!(
                "{code}<figure>\n<a class=\"figure\" href=\"figures/a.svg\"><img src=\"figures/a.svg\" alt=\"A > B\"></a>\n</figure> and [B](#b)"
            )
        );
        for other in ["", "![A](a.png)", "<img src=\"a.png\"> x.svg", "wow!", "a![0] <img "] {
            assert_eq!(linked_in(other), other);
        }
    }
}
