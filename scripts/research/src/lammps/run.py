"""LAMMPS on a scene of soft discs: python run.py SCENE SKIN STEPS [FRAMES EVERY]

SCENE holds a line 'n size', then 'x y vx vy' for each particle. Without FRAMES the steps are timed
and the seconds are printed from the particles in memory to the last step: LAMMPS's own loop time leaves
out its first list, which our programs make in their first step. With FRAMES the states after steps 1, 1 + EVERY,
1 + 2 EVERY, ... are written there, one 'x y vx vy' for each particle.
"""

import ctypes
import sys
import tempfile
import time

import lammps

scene, skin, steps = sys.argv[1], float(sys.argv[2]), int(sys.argv[3])
with open(scene) as file:
    n, size = file.readline().split()
    n, size = int(n), float(size)
    rows = [[float(number) for number in file.readline().split()] for _ in range(n)]

log = tempfile.NamedTemporaryFile("r", suffix=".lammps")
lmp = lammps.lammps(cmdargs=["-log", log.name, "-screen", "none"])
lmp.commands_string(f"""
units lj
dimension 2
boundary f f p
atom_style atomic
atom_modify map array sort 20 0.0
region box block 0 {size!r} 0 {size!r} -0.5 0.5
create_box 1 box
mass 1 0.01
timestep 0.0005
pair_style lepton 0.01
pair_coeff * * "0.01/r - 1 - log(0.01/r)"
neighbor {skin!r} bin
neigh_modify delay 0 every 1 check yes
""")
numbers = ctypes.c_double * (3 * n)
x = numbers(*(number for row in rows for number in (row[0], row[1], 0.0)))
v = numbers(*(number for row in rows for number in (row[2], row[3], 0.0)))
made = lmp.create_atoms(n, list(range(1, n + 1)), [1] * n, x, v)
assert made == n, f"LAMMPS took {made} of {n} particles"
lmp.commands_string("""
fix walls all wall/reflect xlo EDGE xhi EDGE ylo EDGE yhi EDGE
fix move all nve
fix flat all enforce2d
thermo 1000000
""")

if len(sys.argv) == 4:
    start = time.perf_counter()
    lmp.command(f"run {steps}")
    seconds = time.perf_counter() - start
    lmp.close()
    # Of several ranks one has the log.
    if log.read():
        print(seconds)
else:
    frames, every = sys.argv[4], int(sys.argv[5])
    with open(frames, "w") as file:
        done = 0
        while done < steps:
            more = min(every if done else 1, steps - done)
            lmp.command(f"run {more}")
            done += more
            x, v = lmp.gather_atoms("x", 1, 3), lmp.gather_atoms("v", 1, 3)
            for i in range(0, 3 * n, 3):
                file.write(f"{x[i]!r} {x[i + 1]!r} {v[i]!r} {v[i + 1]!r}\n")
    lmp.close()
