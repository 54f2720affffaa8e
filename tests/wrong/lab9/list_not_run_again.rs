// region: 9.3b
// fails: task_9_3_the_list_grows_and_starts_again
// story: The list grows, but the kernels do not run again: the new list holds zeros.
        let count = finder.run(rows);
        if count > finder.capacity() {
            finder.grow(count)?;
        }
        finder.fetch(count, found);
        Ok(())
