//! What was handed in: [`read`](read()) takes in an archive or a folder, without writing anything.

mod archive;
mod read;

pub(crate) use read::read;

#[cfg(test)]
mod tests {
    use std::fs;

    use lab_kit::submission::{LeftOut, Sources, pack};

    use super::read;

    fn sources(files: &[(&str, &str)]) -> Sources {
        files.iter().map(|(path, text)| ((*path).into(), text.as_bytes().to_vec())).collect()
    }

    #[test]
    fn what_is_packed_comes_out_again() {
        let folder = tempfile::tempdir().unwrap();
        let files = sources(&[("src/lib.rs", "pub fn f() {}"), ("src/deep/own.rs", "x")]);
        let archive = folder.path().join("a.tar.gz");
        fs::write(&archive, pack("2".parse().unwrap(), &files).unwrap()).unwrap();
        let labs = read(&archive).unwrap();
        let labs = labs.labs.into_iter().map(|(lab, collected)| (lab, collected.files));
        assert_eq!(labs.collect::<Vec<_>>(), [("2".parse().unwrap(), files)]);
    }

    #[test]
    fn uploads_in_a_folder_are_unpacked() {
        let folder = tempfile::tempdir().unwrap();
        let put = |name: &str, lab: &str, text: &str| {
            let archive = pack(lab.parse().unwrap(), &sources(&[("src/lib.rs", text)])).unwrap();
            fs::write(folder.path().join(name), archive).unwrap();
        };
        put("one.tar.gz", "1", "first");
        put("two.tgz", "2", "second");
        fs::write(folder.path().join("comment.txt"), "hello").unwrap();
        let handed_in = read(folder.path()).unwrap();
        let texts = handed_in.labs.values().map(|lab| lab.files["src/lib.rs"].as_slice());
        assert_eq!(texts.collect::<Vec<_>>(), [b"first".as_slice(), b"second"]);
        assert_eq!(handed_in.left_out, [("comment.txt".into(), LeftOut::Elsewhere)]);
        put("two again.tgz", "2", "third");
        let error = read(folder.path()).unwrap_err().to_string();
        assert!(error.contains("lab 2 is in more than one archive"), "{error}");
    }
}
