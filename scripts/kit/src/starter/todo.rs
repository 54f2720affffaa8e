//! Recognises the `todo!` that replaces an answer in a starter.

use crate::answers::RegionId;

/// Returns the region and title in a line with a todo; `None` if the line has none.
///
/// In Rust the line contains `todo!("task 3.2b: title")`, in a shader `todo: task 9.2: title`.
pub fn todo(line: &str) -> Option<(RegionId, &str)> {
    let shader = line.trim_start().strip_prefix("// todo: task ");
    let rest = shader.or_else(|| Some(line.split_once("todo!(\"task ")?.1))?;
    let (id, rest) = rest.split_once(": ")?;
    Some((id.parse().ok()?, rest.split('"').next()?))
}

#[cfg(test)]
mod tests {
    use super::todo;

    #[test]
    fn todos_are_found() {
        let (id, title) = todo("        todo!(\"task 1.3b: one step: all pairs\")").unwrap();
        assert_eq!((id.to_string(), title), ("1.3b".into(), "one step: all pairs"));
        let (id, title) = todo("    // todo: task 9.2: a scan").unwrap();
        assert_eq!((id.to_string(), title), ("9.2".into(), "a scan"));
        let given = "panic!(\"task 3.10: member {number} is too early\")";
        for other in ["// task 1.3: x", "//! a comment `// todo: task 9.2: …`", given] {
            assert!(todo(other).is_none(), "{other}");
        }
    }
}
