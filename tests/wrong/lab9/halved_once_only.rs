// region: 9.3b
// fails: task_9_3_the_list_grows_and_starts_again
// story: Where there is no memory the rows are halved once; a half that has no room either is cut off.
        let mut count = finder.run(rows.clone());
        if count > finder.capacity() {
            match finder.grow(count) {
                Ok(()) => count = finder.run(rows),
                Err(error) if rows.len() < 2 => return Err(error),
                Err(_) => {
                    let middle = rows.start + rows.len() as u32 / 2;
                    for half in [rows.start..middle, middle..rows.end] {
                        let count = finder.run(half).min(finder.capacity());
                        finder.fetch(count, found);
                    }
                    return Ok(());
                }
            }
        }
        finder.fetch(count, found);
        Ok(())
