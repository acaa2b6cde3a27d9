// SPDX-License-Identifier: MIT
// Checkpoints as files: what goes in comes out, observers go on where they stood, and every file that is none of this run is refused.
#if __has_include(<hdf5.h>)

#include "bolide/hdf5/checkpoint.hpp"

#include "bolide/eos/stiffened_gas.hpp"
#include "bolide/failure/tension.hpp"
#include "bolide/observe/every.hpp"
#include "bolide/observe/take_snapshot.hpp"
#include "bolide/observe/tracer.hpp"
#include "bolide/observe/vtk.hpp"
#include "unit/solver/memory_archive.hpp"
#include "unit/solver/scenes.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <set>
#include <sstream>

#if defined(__SANITIZE_ADDRESS__)
/// HDF5 loses memory of its own when a damaged file makes it give up; what the checkpoint loses is found all the same.
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5"; }
#endif

namespace bolide {
namespace {
using namespace test;
namespace fs = std::filesystem;

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}
void write(const fs::path& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

class Checkpoint : public testing::Test {
protected:
  fs::path folder = fs::path(testing::TempDir()) /
                    ("bolide_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + "_" + std::to_string(::getpid()));
  fs::path file = folder / "run.h5";
  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }
};

/// A cheap scene in one dimension: 40 particles of two stiffened gases.
struct cheap {
  double cell = 0.1 * mm, gamma = 4.4, tension = 1e9, courant = 0.4, wall = -2 * mm, end = 1; // end: m, of the box
  bool box = false, second_wall = false;
  std::string name = "flyer";
};
template <class Method> auto cheap_scene(const cheap& how = {}) {
  using point = vec<double, 1>;
  const material medium{eos::stiffened_gas{{.gamma = how.gamma, .p_inf = 1.6e10, .rho0 = 2785}}, strength::none{}, failure::tension{how.tension}};
  const initial_state at{2785, 0};
  controls<typename Method::scalar> c;
  c.courant = how.courant;
  const body flyer{how.name, box{point{-1 * mm}, point{0}}, medium, 0.05 * mm, at, point{600.}};
  const body plate{"plate", box{point{0}, point{1 * mm}}, medium, 0.05 * mm, at};
  solver sim{space::planar_1d{}, grid::sparse{how.cell}, typename Method::shape_type{}, typename Method::transfer_type{}, typename Method::scheme_type{}, c, flyer,
             plate};
  sim.add(grid::mirror{0, how.wall, true});
  if (how.second_wall) sim.add(grid::mirror{0, 4 * mm, false});
  leaving_box<1> b;
  b.low << -1;
  b.high << how.end;
  if (how.box) sim.add(b);
  return sim;
}

std::string refusal(const fs::path& file, auto&& state) {
  try {
    hdf5::restore(file, state);
  } catch (const hdf5::checkpoint_error& e) { return e.what(); }
  return "";
}
void expect_names(const std::string& sentence, const std::vector<std::string>& what) {
  for (const auto& part : what) EXPECT_NE(sentence.find(part), std::string::npos) << "'" << part << "' is not in: " << sentence;
}

template <class Method> void goes_on(const fs::path& file) {
  auto sim = small_impact<Method>(), again = small_impact<Method>();
  for (int i = 0; i < 57; ++i) sim.step();
  hdf5::save(file, sim);
  hdf5::restore(file, again);
  for (int i = 0; i < 57; ++i) sim.step(), again.step();
  EXPECT_EQ(state_hash(sim), state_hash(again));
  EXPECT_EQ(sim.time(), again.time());
  EXPECT_EQ(sim.energies().residual(), again.energies().residual());
  EXPECT_EQ(sim.energies().drift(), again.energies().drift());
}
TEST_F(Checkpoint, ARunGoesOnToTheSameBitsInDouble) { goes_on<bspline_apic_usf>(file); }
TEST_F(Checkpoint, ARunGoesOnToTheSameBitsInFloat) { goes_on<method<shape::linear, transfer::flip, scheme::musl, float>>(file); }

TEST_F(Checkpoint, OnTwoThreadsItGoesOnAsOnOne) { // 20,000 particles: enough that the loops run in parallel
  const auto scene = [](int threads) {
    using point = vec<double, 2>;
    controls<double> c;
    c.threads = threads;
    c.first_step = 1;
    const auto medium = material{eos::stiffened_gas{{.gamma = 4.4, .p_inf = 1.6e10, .rho0 = 2785}}, strength::none{}, failure::tension{1e9}};
    const initial_state at{2785, 0};
    const body block{"block", box{point{0, -5 * mm}, point{10 * mm, 0}}, medium, 0.05 * mm, at, point{0, 600.}, jitter{0.1, 5}};
    return solver{space::axisymmetric{}, grid::sparse{0.1 * mm}, shape::quadratic_bspline{}, transfer::apic{}, scheme::usf{}, c, block};
  };
  auto one = scene(1), two = scene(2);
  EXPECT_EQ(one.particle_count(), 20000u);
  for (int i = 0; i < 6; ++i) one.step();
  hdf5::save(file, one);
  hdf5::restore(file, two);
#if defined(_OPENMP)
  EXPECT_EQ(two.threads(), 2);
#endif
  for (int i = 0; i < 6; ++i) one.step(), two.step();
  EXPECT_EQ(state_hash(one), state_hash(two));
}

/// A run with observers that keep a state. `stop` ends it early, with rows and frames written after the last checkpoint.
void observed_run(const fs::path& folder, double until, bool restart) {
  auto sim = cheap_scene<linear_flip_usf>();
  observe::tracer gauge(folder / "gauge.csv", {3, 30}, 7e-9);
  observe::tracer every_step(folder / "steps.csv", {17});
  observe::vtk_series frames(folder);
  observe::every draw(0.05 * us, [&](const auto& s) { frames.write(observe::take_snapshot(s)); });
  const auto state = [&](auto& a) {
    a.value("simulation", sim);
    a.value("gauge", gauge);
    a.value("every_step", every_step);
    a.value("draw", draw);
    a.value("frames", frames);
  };
  observe::every keep(0.03 * us, [&](const auto&) { hdf5::save(folder / "run.h5", state); });
  if (restart) hdf5::restore(folder / "run.h5", state);
  sim.run(until, gauge, keep, draw, every_step); // observers before and after the one that saves
}
TEST_F(Checkpoint, ObserversGoOnWithoutARowOrAFrameTwice) {
  observed_run(folder / "whole", 0.3 * us, false);
  observed_run(folder / "parts", 0.3 * us, false);
  for (int cut = 0; cut < 2; ++cut) { // the checkpoint before the last one: all that follows it is written again
    fs::copy_file(hdf5::previous(folder / "parts/run.h5"), folder / "parts/run.h5", fs::copy_options::overwrite_existing);
    observed_run(folder / "parts", 0.3 * us, true);
  }
  int compared = 0;
  for (const auto& entry : fs::directory_iterator(folder / "whole")) {
    const auto name = entry.path().filename();
    if (name.extension() == ".h5") continue;
    EXPECT_EQ(read(entry.path()), read(folder / "parts" / name)) << name;
    ++compared;
  }
  EXPECT_GE(compared, 2 + 7 + 1); // two tables, frames at 0, 50, ... 300 ns, their list
}
TEST_F(Checkpoint, ATracerGoesOnThoughItsParticleHasLeft) {
  const auto run = [&](double until, bool restart) {
    auto sim = cheap_scene<linear_flip_usf>({.end = 1.1 * mm, .box = true});
    observe::tracer gauge(folder / "gauge.csv", {17, 39}, 1e-8);
    const auto state = [&](auto& a) { a.value("simulation", sim), a.value("gauge", gauge); };
    if (restart) hdf5::restore(file, state);
    sim.run(until, gauge);
    if (!restart) hdf5::save(file, state);
    return sim.particle_count();
  };
  EXPECT_LT(run(1.2 * us, false), 39u);
  run(1.4 * us, true);
  std::set<std::string> rows;
  std::istringstream table(read(folder / "gauge.csv"));
  for (std::string line; std::getline(table, line);) EXPECT_TRUE(rows.insert(line).second) << "twice: " << line;
  EXPECT_EQ(rows.rbegin()->rfind("time (s)", 0), 0u);
  EXPECT_GT(rows.size(), 140u) << "one row per sample of particle 17 and some of 39";
}
TEST_F(Checkpoint, ATableOfAnotherRunIsNotAppendedTo) {
  observed_run(folder, 0.1 * us, false);
  write(folder / "gauge.csv", "time (s)\n1\n");
  EXPECT_THROW(observed_run(folder, 0.2 * us, true), observe::output_error);
  observed_run(folder, 0.1 * us, false);
  fs::resize_file(folder / "gauge.csv", 200);
  EXPECT_THROW(observed_run(folder, 0.2 * us, true), observe::output_error);
  fs::remove(folder / "gauge.csv"); // of a run that goes on in another folder: begun anew
  observed_run(folder, 0.2 * us, true);
  EXPECT_EQ(read(folder / "gauge.csv").rfind("time (s),", 0), 0u);
}

TEST_F(Checkpoint, AnotherCompositionIsRefusedWithASentenceThatNamesBoth) {
  auto sim = cheap_scene<linear_flip_usf>();
  for (int i = 0; i < 20; ++i) sim.step();
  hdf5::save(file, sim);
  EXPECT_EQ(refusal(file, cheap_scene<linear_flip_usf>()), "");
  const std::string path = file.string(), other = "of another composition";
  expect_names(refusal(file, cheap_scene<linear_flip_musl>()), {path, other, "scheme is 'usf' in the file and 'musl' here"});
  expect_names(refusal(file, cheap_scene<bspline_flip_usf>()), {path, other, "shape is 'linear' in the file and 'bspline' here"});
  expect_names(refusal(file, cheap_scene<method<shape::linear, transfer::flip, scheme::usf, float>>()),
               {path, other, "precision is 'double' in the file and 'float' here"});
  expect_names(refusal(file, small_flyer<linear_flip_usf>()), {path, other, "mirror"});
  expect_names(refusal(file, small_impact<linear_flip_usf>()), {path, other, "space is 'planar_1d' in the file and 'axisymmetric' here"});
  expect_names(refusal(file, cheap_scene<linear_flip_usf>({.cell = 0.2 * mm})), {path, other, "cell size is 1e-04 m in the file and 2e-04 m here"});
  expect_names(refusal(file, cheap_scene<linear_flip_usf>({.courant = 0.3})), {path, other, "Courant number is 0.4 in the file and 0.3 here"});
  expect_names(refusal(file, cheap_scene<linear_flip_usf>({.wall = -3 * mm})), {path, other, "mirror 0 is", "node -20", "node -30"});
  expect_names(refusal(file, cheap_scene<linear_flip_usf>({.second_wall = true})), {path, other, "mirrors is 1 in the file and 2 here"});
  expect_names(refusal(file, cheap_scene<linear_flip_usf>({.box = true})), {path, other, "leaving box is 'none' in the file and '-1 .. 1 m' here"});
  expect_names(refusal(file, cheap_scene<linear_flip_usf>({.name = "disc"})), {path, other, "body_0/name is 'flyer' in the file and 'disc' here"});
  expect_names(refusal(file, cheap_scene<linear_flip_usf>({.gamma = 4.4001})), {path, other, "body_0/material", "at 800 kg/m3", "in the file and"});
  expect_names(refusal(file, cheap_scene<linear_flip_usf>({.tension = 1.001e9})),
               {path, other, "body_0/material", "density at which stretched material"});
}
TEST_F(Checkpoint, AChangedConstantOfAnyModelIsNoticed) {
  const auto with = [](strength::johnson_cook strength, failure::tension_or_melt failure, viscosity::bulk viscosity) {
    return small_impact<bspline_apic_usf>(
        material{eos::isentrope_temperature{eos::mie_grueneisen{{.constant_gamma = true}}}, strength, failure, viscosity});
  };
  const strength::johnson_cook strength;
  const failure::tension_or_melt fails{1.5e9};
  auto sim = with(strength, fails, viscosity::bulk{});
  hdf5::save(file, sim);
  EXPECT_EQ(refusal(file, with(strength, fails, viscosity::bulk{})), "");
  auto changed = [&](auto change) {
    auto s = strength;
    change(s);
    return refusal(file, with(s, fails, viscosity::bulk{}));
  };
  expect_names(changed([](auto& s) { s.a *= 1.001; }), {"body_0/material", "deviator"});
  expect_names(changed([](auto& s) { s.b *= 1.01; }), {"body_0/material", "deviator"});
  expect_names(changed([](auto& s) { s.n *= 1.01; }), {"body_0/material", "deviator"});
  expect_names(changed([](auto& s) { s.c *= 1.01; }), {"body_0/material", "deviator"});
  expect_names(changed([](auto& s) { s.q *= 1.01; }), {"body_0/material", "deviator"});
  expect_names(changed([](auto& s) { s.shear_modulus *= 1.001; }), {"body_0/material"});
  expect_names(refusal(file, with(strength, failure::tension_or_melt{1.501e9}, viscosity::bulk{})), {"body_0/material", "fails"});
  expect_names(refusal(file, with(strength, fails, viscosity::bulk{1.5, 0.07})), {"body_0/material", "viscous_pressure"});
  expect_names(refusal(file, small_impact<bspline_apic_usf>(aluminium(), transfer::apic{.heat = 0})),
               {"heat of the transfer is 1 in the file and 0 here"});
}

TEST_F(Checkpoint, FilesThatAreNoneAreRefused) {
  auto sim = cheap_scene<linear_flip_usf>();
  expect_names(refusal(file, sim), {file.string(), "cannot be read"});
  expect_names(refusal(folder, sim), {folder.string(), "no file"});
  write(file, "");
  expect_names(refusal(file, sim), {"is no HDF5 file"});
  write(file, "time (s),step\n0,0\n");
  expect_names(refusal(file, sim), {"is no HDF5 file"});
  H5Fclose(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  expect_names(refusal(file, sim), {"is an HDF5 file but no checkpoint of bolide"});
}
TEST_F(Checkpoint, AnotherVersionIsRefused) {
  auto sim = cheap_scene<linear_flip_usf>();
  hdf5::save(file, sim);
  const auto overwrite = [&](const char* name, std::int64_t x) {
    const hid_t f = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), a = H5Aopen(f, name, H5P_DEFAULT);
    EXPECT_GE(H5Awrite(a, H5T_NATIVE_INT64, &x), 0);
    H5Aclose(a);
    H5Fclose(f);
  };
  overwrite("version", hdf5::format_version + 1);
  expect_names(refusal(file, sim), {"has format version 2", "reads version 1"});
  hdf5::save(file, sim);
  overwrite("entries", 7);
  expect_names(refusal(file, sim), {"holds 7 entries where this program reads", "another version of bolide"});
  double here = 0;
  hdf5::save(file, [&](auto& a) { a.value("state", sim); });
  expect_names(refusal(file, [&](auto& a) { a.value("state", sim), a.value("more", here); }), {"lacks the entry more"});
}

TEST_F(Checkpoint, ADamagedFileIsRefusedOrMakesNoDifference) {
  auto sim = cheap_scene<linear_flip_usf>();
  for (int i = 0; i < 20; ++i) sim.step();
  hdf5::save(file, sim);
  const std::string whole = read(file);
  const auto state = listed(sim);
  const fs::path damaged = folder / "damaged.h5";
  for (std::size_t bytes = 1; bytes < whole.size(); bytes = bytes * 5 / 4 + 1) {
    write(damaged, whole.substr(0, bytes));
    EXPECT_NE(refusal(damaged, cheap_scene<linear_flip_usf>()), "") << bytes << " of " << whole.size() << " bytes";
  }
  std::mt19937_64 random(4);
  int refused = 0;
  for (int i = 0; i < 400; ++i) {
    std::string bytes = whole;
    bytes[random() % bytes.size()] ^= static_cast<char>(1 << random() % 8);
    write(damaged, bytes);
    auto again = cheap_scene<linear_flip_usf>();
    const auto sentence = refusal(damaged, again);
    refused += !sentence.empty();
    if (sentence.empty()) {
      EXPECT_EQ(listed(again), state) << "a flipped bit came through";
    }
  }
  EXPECT_GT(refused, 200) << "most bytes matter";
}

TEST_F(Checkpoint, TheOneBeforeIsKept) {
  auto sim = cheap_scene<linear_flip_usf>();
  EXPECT_EQ(hdf5::previous("out/run.h5"), fs::path("out/run_previous.h5"));
  for (int k = 0; k < 3; ++k) {
    hdf5::save(file, sim);
    EXPECT_EQ(fs::exists(hdf5::previous(file)), k > 0);
    for (int i = 0; i < 5; ++i) sim.step();
  }
  for (const auto& [path, steps] : {std::pair{file, 10L}, std::pair{hdf5::previous(file), 5L}}) {
    auto again = cheap_scene<linear_flip_usf>();
    hdf5::restore(path, again);
    EXPECT_EQ(again.steps(), steps);
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 2) << "nothing is left aside";
}

TEST_F(Checkpoint, AFullDiskLeavesWhatWasThere) {
  auto sim = cheap_scene<linear_flip_usf>();
  for (int i = 0; i < 5; ++i) sim.step();
  hdf5::save(file, sim);
  const std::string before = read(file);
  sim.step();
  struct rlimit limit;
  ::getrlimit(RLIMIT_FSIZE, &limit);
  const auto old = std::signal(SIGXFSZ, SIG_IGN);
  for (const rlim_t most : {0u, 1000u, 20000u}) { // bytes that a file may have
    struct rlimit small = limit;
    small.rlim_cur = most;
    ::setrlimit(RLIMIT_FSIZE, &small);
    std::string sentence;
    try {
      hdf5::save(file, sim);
    } catch (const observe::output_error& e) { sentence = e.what(); }
    ::setrlimit(RLIMIT_FSIZE, &limit);
    expect_names(sentence, {file.string(), "cannot be written"});
    EXPECT_EQ(read(file), before);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1) << "nothing is left aside";
  }
  std::signal(SIGXFSZ, old);
  hdf5::save(file, sim); // and it goes on
  auto again = cheap_scene<linear_flip_usf>();
  hdf5::restore(file, again);
  EXPECT_EQ(again.steps(), 6);
}

} // namespace
} // namespace bolide

#endif
