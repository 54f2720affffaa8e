// region: 9.3c
// fails: task_9_3_the_list_grows_and_starts_again
// story: The count of the step before is never cleared, so a list begins with what is no longer true.
        for kernel in finder.kernels() {
            work.launch(kernel, finder.launch());
        }
