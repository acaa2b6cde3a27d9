// SPDX-License-Identifier: MIT
// The project's potentials against LAMMPS (lammps.org; Debian package lammps), an engine that knows nothing of them but the setfl file
// that the library writes: energy and pressure of the perfect lattice at four volumes, then energy, pressure, forces and a short motion of
// a disturbed supercell. And the other way round: public setfl files that come with LAMMPS, read by the library.
// Where no `lmp` is on the path every test here is skipped and says so; none counts as passed.
#include "validate/supercell.hpp"

#include "bolide/eos/cold/cai_ye.hpp"
#include "bolide/eos/cold/lattice_sum.hpp"
#include "bolide/potential/cai_ye.hpp"
#include "bolide/potential/setfl.hpp"
#include "bolide/potential/shells.hpp"
#include "bolide/potential/zhou04.hpp"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using namespace bolide;
using supercell::vector3;

const std::vector<double> stretches = {0.83, 0.95, 1.0, 1.1}; // a/a0

/// LAMMPS turns eV/angstrom^3 into bar with an eV of 1.6021765e-19 J (force->nktv2p of its metal units), 8.4e-8 less than CODATA 2018:
/// taken back here.
double pascal_of_lammps(double bar) { return bar / 1.6021765e6 * supercell::pascal; }

std::string read(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

struct state {
  double energy;   // eV per atom
  double pressure; // Pa
};

/// Every test has an empty folder of its own; LAMMPS runs in it.
class Lammps : public ::testing::Test {
protected:
  fs::path folder;

  void SetUp() override {
    if (std::system("command -v lmp >/dev/null 2>&1") != 0)
      GTEST_SKIP() << "no LAMMPS: `lmp` is not on the path, so nothing is compared with it (Debian: apt-get install lammps)";
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder = fs::temp_directory_path() / ("bolide_lammps_" + std::string(info->name()) + "_" + std::to_string(::getpid()));
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override {
    if (!folder.empty()) fs::remove_all(folder);
  }

  /// 20001 densities, to 1.3 times that of the lattice at 0.83 a0, and 40001 radii.
  template <EmbeddedAtomPotential P> void write_potential(const P& model) const {
    const double a = stretches.front() * model.lattice_constant();
    double rho = 0;
    for (const potential::shell& s : potential::shells(model.structure(), model.reach() / a))
      rho += s.atoms * model.density(s.distance * a).value;
    potential::write_setfl(model, 20001, 1.3 * rho / 20000, 40001, model.reach() / 40000, folder / "Al.setfl");
  }

  /// The reach of a potential without cut-off, 20 angstrom, has more neighbours than LAMMPS expects.
  static constexpr const char* settings = "units metal\nneigh_modify one 20000 page 2000000\n";

  void run(const std::string& input) const {
    std::ofstream(folder / "in.bolide") << input;
    const std::string command = "cd '" + folder.string() + "' && lmp -in in.bolide -log none >screen 2>&1 </dev/null";
    const int status = std::system(command.c_str());
    ASSERT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << read(folder / "screen");
  }

  /// What LAMMPS answers at the four volumes for the perfect lattice; the box has three cells along each axis.
  std::vector<state> lattice_states(const std::string& file, const std::string& element, lattice structure, double a0) const {
    std::ostringstream in;
    in.precision(17);
    for (const double stretch : stretches)
      in << "clear\n"
         << settings << "lattice " << name(structure) << ' ' << stretch * a0
         << "\nregion box block 0 3 0 3 0 3\ncreate_box 1 box\ncreate_atoms 1 box\npair_style eam/alloy\npair_coeff * * " << file << ' '
         << element << "\nthermo_modify norm yes\nrun 0\nprint \"$(pe:%.17g) $(press:%.17g)\" append states\n";
    run(in.str());
    std::istringstream answers(read(folder / "states"));
    std::vector<state> states;
    for (double energy = 0, bar = 0; answers >> energy >> bar;) states.push_back({energy, pascal_of_lammps(bar)});
    EXPECT_EQ(states.size(), stretches.size()) << read(folder / "screen");
    return states;
  }

  /// Bounds: of |E|, and of |p| or of 1 GPa where |p| is less (p passes through 0 near a0).
  template <class Curve> void expect_states(const char* what, const std::vector<state>& lammps, const Curve& curve, double energy_bound,
                                            double pressure_bound) const {
    for (std::size_t i = 0; i < lammps.size(); ++i) {
      const double x = stretches[i] * stretches[i] * stretches[i], energy = curve.energy_per_atom(x), pressure = curve.evaluate(x).pressure;
      const double de = lammps[i].energy - energy, dp = (lammps[i].pressure - pressure) / std::max(std::abs(pressure), 1e9);
      std::printf(
          "[ figures  ] %-14s a/a0 %.2f: E %12.8f eV per atom, p %13.6e Pa; LAMMPS minus library %+.1e eV, %+.1e of max(|p|, 1 GPa)\n",
          what, stretches[i], energy, pressure, de, dp);
      EXPECT_LT(std::abs(de), energy_bound * std::abs(energy));
      EXPECT_LT(std::abs(dp), pressure_bound);
    }
  }

  template <EmbeddedAtomPotential P> void expect_same_lattice(const char* what, const P& model) const {
    write_potential(model);
    const auto lammps = lattice_states("Al.setfl", "Al", model.structure(), model.lattice_constant());
    expect_states(what, lammps, cold::lattice(model), 1e-9, 1e-8);
    expect_states("  setfl reader", lammps, cold::lattice(potential::setfl::read(folder / "Al.setfl")), 1e-9, 1e-8);
  }
};

} // namespace

TEST_F(Lammps, TheSharpCaiYeLatticeIsTheSame) { expect_same_lattice("Cai-Ye sharp", potential::cai_ye(potential::cutoff::sharp)); }
TEST_F(Lammps, TheCaiYeLatticeWithoutCutOffIsTheSame) { expect_same_lattice("Cai-Ye", potential::cai_ye()); }
TEST_F(Lammps, TheZhouLatticeIsTheSame) { expect_same_lattice("Zhou 2004", potential::zhou04()); }

TEST_F(Lammps, ADisturbedSupercellHasTheSameForcesPressureAndMotion) {
  const potential::cai_ye model;
  write_potential(model);
  supercell::block<potential::cai_ye> b(model, 3, model.lattice_constant());
  b.perturb(0.1, 21);

  std::ofstream data(folder / "atoms.data");
  data.precision(17);
  data << "disturbed lattice\n\n" << b.atoms() << " atoms\n1 atom types\n";
  for (const char* axis : {"x", "y", "z"}) data << "0 " << b.edge() << ' ' << axis << "lo " << axis << "hi\n";
  data << "\nAtoms\n\n";
  for (std::size_t i = 0; i < b.atoms(); ++i) data << i + 1 << " 1 " << b.positions()[i].transpose() << '\n';
  data.close();
  run(settings +
      std::string("read_data atoms.data\npair_style eam/alloy\npair_coeff * * Al.setfl Al\nthermo_modify norm no\n"
                  "dump forces all custom 1 forces id fx fy fz\ndump_modify forces sort id format float %.17g\nrun 0\nundump forces\n"
                  "print \"$(pe:%.17g) $(press:%.17g)\" append states\n"
                  "fix motion all nve\ntimestep 0.002\nrun 25\nprint \"$(pe:%.17g) $(press:%.17g)\" append states\n"));

  std::istringstream states(read(folder / "states"));
  double energy[2] = {}, bar[2] = {};
  states >> energy[0] >> bar[0] >> energy[1] >> bar[1];
  ASSERT_TRUE(states) << read(folder / "screen");
  std::ifstream dump(folder / "forces");
  for (std::string line; std::getline(dump, line) && line.rfind("ITEM: ATOMS", 0) != 0;) {}
  double worst = 0, largest = 0;
  for (std::size_t i = 0; i < b.atoms(); ++i) {
    std::size_t id = 0;
    vector3 f;
    dump >> id >> f[0] >> f[1] >> f[2];
    ASSERT_TRUE(dump && id == i + 1);
    worst = std::max(worst, (f - b.forces()[i]).norm());
    largest = std::max(largest, f.norm());
  }
  const double start = b.potential_energy(), pressure = b.pressure();
  for (int i = 0; i < 25; ++i) b.step(2);
  std::printf("[ figures  ] disturbed supercell: forces to %.2f eV/A, LAMMPS minus supercell %.1e eV/A; energy %+.1e eV of %.3f; pressure "
              "%+.1e of %.3e Pa;\n"
              "[ figures  ] after 50 fs: energy %+.1e eV of a change of %.3f eV, pressure %+.1e of %.3e Pa\n",
              largest, worst, energy[0] - start, start, pascal_of_lammps(bar[0]) / pressure - 1, pressure, energy[1] - b.potential_energy(),
              b.potential_energy() - start, pascal_of_lammps(bar[1]) / b.pressure() - 1, b.pressure());
  EXPECT_GT(largest, 1.0);
  EXPECT_LT(worst, 1e-7);
  EXPECT_NEAR(energy[0], start, 1e-9 * std::abs(start));
  EXPECT_NEAR(pascal_of_lammps(bar[0]) / pressure, 1, 1e-8);
  EXPECT_LT(b.potential_energy(), start - 1);
  EXPECT_NEAR(energy[1], b.potential_energy(), 1e-6 * (start - b.potential_energy())); // its unit of time is that of the older eV too
}

/// Coarse files (AlCu: density step 1.04 where the lattice has 4.8) and fine ones: the library interpolates as LAMMPS does.
TEST_F(Lammps, PublicFilesReadByTheLibraryGiveTheSameLattice) {
  const fs::path shipped = "/usr/share/lammps/potentials";
  if (!fs::exists(shipped / "Al_zhou.eam.alloy")) GTEST_SKIP() << "the files that come with LAMMPS are not in " << shipped;
  const struct {
    const char *file, *element;
  } cases[] = {{"AlCu.eam.alloy", "Al"}, {"AlCu.eam.alloy", "Cu"}, {"Cu_mishin1.eam.alloy", "Cu"},
               {"Al_zhou.eam.alloy", "Al"}, {"Cu_zhou.eam.alloy", "Cu"}, {"W_zhou.eam.alloy", "W"}};
  for (const auto& [file, element] : cases) {
    SCOPED_TRACE(file);
    const auto table = potential::setfl::read(shipped / file, element);
    fs::remove(folder / "states");
    const auto lammps = lattice_states((shipped / file).string(), element, table.structure(), table.lattice_constant());
    expect_states(file, lammps, cold::lattice(table), 1e-9, 1e-8);
  }
}
