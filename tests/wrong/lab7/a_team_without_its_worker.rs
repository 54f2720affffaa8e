// region: 7.9c
// fails: task_7_9_both_loops_are_dealt_out_each_row_to_a_team_of_its_own
// story: List number m is for member m of every team, so that members of different teams wait for each other.
let count = team.count();
parallel_for(n, team, schedule, |_, part| {
    for a in part {
        let first = a + 1;
        parallel_for(n - first, Team::Fresh(count), Schedule::Static, |member, part| {
            look(member, a, first + part.start..first + part.end);
        });
    }
});
