//! Makes each drawing a link to its file.
//!
//! The link contains the width at which a phone can show the drawing legibly, or the path of the
//! drawing's version for phones.

use std::fs;
use std::path::Path;

/// Least height of text in a drawing on a phone, in pixels.
const LEAST_TEXT: f64 = 12.0;

/// Puts each `<img>` of an SVG file into a link to this file, unless it is in a link already.
///
/// `folder` is the folder of the page. The paths in the page are relative to it.
pub(crate) fn link(text: &str, folder: &Path) -> String {
    let mut parts = text.split("<img ");
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (image, after) = part.split_at(end_of_tag(part));
        let image = format!("<img {image}");
        match drawing(&image).filter(|_| !after.starts_with("</a>")) {
            Some(file) => out += &linked(&image, file, folder),
            None => out += &image,
        }
        out += after;
    }
    out
}

fn linked(image: &str, file: &str, folder: &Path) -> String {
    let phone = for_phones(file).filter(|phone| folder.join(phone).is_file());
    let width = fs::read_to_string(folder.join(file)).ok().and_then(|svg| legible(&svg));
    let (style, image) = match (phone, width) {
        (Some(phone), _) => (String::new(), on_either(image, &phone)),
        (None, Some(width)) => (format!(" style=\"--legible: {width}px\""), image.into()),
        (None, None) => (String::new(), image.into()),
    };
    format!("<a class=\"figure\"{style} href=\"{file}\">{image}</a>")
}

/// Returns the path of a chart's version for phones: `figures/phone/a.svg` for `figures/a.svg`.
fn for_phones(file: &str) -> Option<String> {
    let (folder, name) = file.rsplit_once('/')?;
    Some(format!("{folder}/phone/{name}"))
}

/// Returns a `<picture>` that shows the image on a page and the file `phone` on a phone.
fn on_either(image: &str, phone: &str) -> String {
    format!("<picture><source media=\"(max-width: 600px)\" srcset=\"{phone}\">{image}</picture>")
}

/// Returns the width in pixels at which the smallest text of a drawing can be read.
///
/// Returns `None` if the drawing has no text.
fn legible(svg: &str) -> Option<f64> {
    let width = numbers(svg, "viewBox=\"0 0 ").next()?;
    let least = numbers(svg, "font-size").min_by(f64::total_cmp)?;
    Some((LEAST_TEXT * width / least).ceil())
}

/// Returns the numbers that follow a name in attributes and style sheets.
fn numbers(svg: &str, name: &'static str) -> impl Iterator<Item = f64> {
    let values = svg.split(name).skip(1).map(|rest| rest.trim_start_matches(['=', ':', '"', ' ']));
    let numbers = values.map(|value| value.split(|c: char| c != '.' && !c.is_ascii_digit()).next());
    numbers.filter_map(|number| number?.parse().ok())
}

/// Returns the end of a tag: a `>` that is not in an attribute.
fn end_of_tag(text: &str) -> usize {
    let mut quoted = false;
    let end = text.find(|c| {
        quoted ^= c == '"';
        c == '>' && !quoted
    });
    end.map_or(text.len(), |at| at + 1)
}

/// Returns the SVG file that an image shows; `None` for other files.
fn drawing(image: &str) -> Option<&str> {
    let file = image.split_once("src=\"")?.1.split('"').next();
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
        assert_eq!(legible(svg), Some(480.0));
        let styled = "<svg viewBox=\"0 0 520 404\"><style>svg { font-size: 17px } .small { font-size: 13px }</style>";
        assert_eq!(legible(styled), Some(480.0));
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
        for other in ["", "![A](a.png)", "<img src=\"a.png\"> x.svg", "`vec![0; n]`", "a <img "] {
            assert_eq!(linked_in(other), other);
        }
    }
}
