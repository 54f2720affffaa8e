// region: 13.7b
// fails: task_13_7_no_other_epoch_is_cheaper, task_13_7_table_of_depths
// story: Epochs are as long as lists last: in strips a few cutoffs high every rank moves nearly all particles.
let _ = (outlook.fastest, outlook.height, outlook.particles);
outlook.most
