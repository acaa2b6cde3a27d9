// SPDX-License-Identifier: MIT
// optimise: -O2
// The example aluminium_impact as its users meet it: every option's refusal, the exit codes, the files, and that a run can be repeated
// from what it wrote. All runs are coarse; what the clouds look like at the paper's resolution is tested elsewhere.
#include <gtest/gtest.h>

#if defined(BOLIDE_EXAMPLE)

#include <nlohmann/json.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

struct answer {
  int code;
  std::string out, err;
};

/// Every test has an empty folder of its own; the program runs in it.
class AluminiumImpact : public ::testing::Test {
protected:
  fs::path folder;
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder = fs::temp_directory_path() / ("bolide_impact_" + std::string(info->name()) + "_" + std::to_string(::getpid()));
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  answer run(const std::string& arguments) const {
    const std::string command = "cd '" + folder.string() + "' && " BOLIDE_EXAMPLE " " + arguments + " >stdout 2>stderr </dev/null";
    const int status = std::system(command.c_str());
    answer a{WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(folder / "stdout"), read(folder / "stderr")};
    fs::remove(folder / "stdout");
    fs::remove(folder / "stderr");
    return a;
  }
  json summary(const std::string& of = "out") const { return json::parse(read(folder / of / "summary.json")); }
};

/// A run of a tenth of a second: 900 particles.
const std::string coarse = "--spacing 0.4mm --cell 0.8mm --until 1us --threads 1 --frames 1 --out out ";

void expect_names(const std::string& sentence, const std::vector<std::string>& what) {
  for (const auto& part : what) EXPECT_NE(sentence.find(part), std::string::npos) << "'" << part << "' is not in: " << sentence;
}

} // namespace

// ---- what is refused: one sentence with value, bound and unit, exit code 2, no file ---------------------------------------------------

TEST_F(AluminiumImpact, BadValuesAreRefusedWithASentenceAndNothingIsWritten) {
  const struct {
    const char* arguments;
    std::vector<std::string> names;
  } cases[] = {
      {"--diameter 9.5", {"--diameter", "9.5", "no unit", "m km cm mm um nm"}},
      {"--diameter 9.5us", {"--diameter", "9.5us", "a unit of a time", "mm"}},
      {"--diameter -9.5mm", {"--diameter", "-9.5mm", "more than 0", "1m"}},
      {"--diameter 2m", {"--diameter", "2m", "at most 1m"}},
      {"--velocity 6640", {"--velocity", "6640", "no unit", "m/s km/s"}},
      {"--velocity 0m/s", {"--velocity", "0m/s", "more than 0", "km/s"}},
      {"--thickness 2.2", {"--thickness", "no unit", "mm"}},
      {"--thickness 0mm", {"--thickness", "0mm", "more than 0"}},
      {"--plate-radius 50", {"--plate-radius", "no unit"}},
      {"--plate-radius 1mm", {"--plate-radius", "1mm", "half of the diameter", "4.75mm"}},
      {"--spacing 0.05", {"--spacing", "no unit"}},
      {"--spacing 5mm", {"--spacing", "5mm", "a quarter of the diameter", "2.375mm"}},
      {"--spacing 1e-4mm --cell 1e-4mm", {"--spacing", "number of particles", "1e8"}},
      {"--cell 0.1", {"--cell", "no unit"}},
      {"--cell 0.01mm", {"--cell", "0.01mm", "at least the spacing", "0.05mm"}},
      {"--cell 1mm", {"--cell", "1mm", "16 times the spacing", "0.8mm"}},
      {"--coarse-beyond 20", {"--coarse-beyond", "no unit"}},
      {"--coarse-beyond 50mm", {"--coarse-beyond", "50mm", "less than the plate's radius"}},
      {"--coarse-beyond 4mm", {"--coarse-beyond", "4mm", "half of the diameter", "4.75mm"}},
      {"--coarse-beyond 20mm --cell 0.05mm", {"--spacing", "--coarse-beyond", "less than that of the rim"}},
      {"--until 6.6", {"--until", "no unit", "us"}},
      {"--until 0us", {"--until", "0us", "more than 0"}},
      {"--cfl 1.6", {"--cfl", "1.6", "at most 1.5", "no unit"}},
      {"--cfl 0", {"--cfl", "0", "more than 0"}},
      {"--cfl nan", {"--cfl", "nan"}},
      {"--cfl 0.4mm", {"--cfl", "0.4mm", "no unit"}},
      {"--shape cubic", {"--shape", "cubic", "bspline|linear"}},
      {"--shape linear", {"--transfer", "apic", "--shape linear", "unsound"}},
      {"--scheme usl", {"--scheme", "usl", "usf|musl"}},
      {"--transfer pic", {"--transfer", "pic", "apic|flip"}},
      {"--precision half", {"--precision", "half", "double|float"}},
      {"--eos ideal", {"--eos", "ideal", "paper|mixed|helm|reference|mie-gruneisen|tillotson"}},
      {"--initial warm", {"--initial", "warm", "ambient|cold"}},
      {"--tension 1.5", {"--tension", "1.5", "no unit", "GPa"}},
      {"--tension -1GPa", {"--tension", "-1GPa", "more than 0", "none"}},
      {"--viscosity 1.5", {"--viscosity", "1.5", "two numbers"}},
      {"--viscosity 1.5,-1", {"--viscosity", "-1", "at least 0"}},
      {"--jitter 50%", {"--jitter", "50%", "less than 0.5"}},
      {"--jitter 0.1mm", {"--jitter", "0.1mm", "no unit"}},
      {"--seed 1.5", {"--seed", "1.5", "whole number"}},
      {"--box 60mm,-40mm", {"--box", "three lengths"}},
      {"--box 60mm,40mm,-40mm", {"--box", "z_max", "z_min = 40mm"}},
      {"--box 60,-40,80", {"--box", "no unit"}},
      {"--threads -1", {"--threads", "-1", "0 to 1024"}},
      {"--step-cap 0", {"--step-cap", "0", "whole number from 1"}},
      {"--frames many", {"--frames", "many", "whole number"}},
      {"--fields velocity,colour", {"--fields", "colour", "temperature"}},
      {"--ensemble 0", {"--ensemble", "0", "1 to 1000"}},
      {"--projectile gold", {"--projectile", "gold", "no such material", "copper"}},
      {"--target copper", {"--target", "copper", "--eos mixed", "mie-gruneisen"}},
      {"--target lead --eos tillotson", {"--target", "lead", "--eos tillotson"}},
      {"--target copper --compare", {"--target", "copper", "--eos paper"}},
      {"--compare --eos mixed", {"--eos", "--compare"}},
      {"--config nowhere.json", {"--config", "nowhere.json", "cannot be read"}},
      {"--out ''", {"--out", "folder"}},
      {"--out /dev/null", {"--out", "/dev/null", "no folder"}},
      {"--colour red", {"--colour", "--help"}},
      {"--velocity", {"--velocity", "--help"}},
      {"9.5mm", {"9.5mm", "--help"}},
  };
  for (const auto& c : cases) {
    const auto a = run(c.arguments);
    EXPECT_EQ(a.code, 2) << c.arguments;
    EXPECT_EQ(a.out, "") << c.arguments;
    expect_names(a.err, c.names);
    EXPECT_EQ(std::count(a.err.begin(), a.err.end(), '\n'), 1) << "one sentence for " << c.arguments << ": " << a.err;
    EXPECT_TRUE(fs::is_empty(folder)) << "files were left by " << c.arguments;
  }
}

TEST_F(AluminiumImpact, BadConfigFilesAreRefused) {
  const struct {
    const char* content;
    std::vector<std::string> names;
  } cases[] = {
      {"{ \"diameter\": 9.5 }", {"diameter", "9.5", "no unit", "mm"}},
      {"{ \"diametre\": \"9.5mm\" }", {"diametre", "no such setting", "diameter"}},
      {"{ \"eos\": [] }", {"eos", "[]", "text"}},
      {"{ \"eos\": ", {"scene.json", "is no JSON"}},
      {"[1]", {"scene.json", "object"}},
      {"{ \"settings\": 3 }", {"scene.json", "object"}},
      {"{ \"velocity\": \"-1km/s\" }", {"velocity", "-1km/s", "more than 0"}},
  };
  for (const auto& c : cases) {
    std::ofstream(folder / "scene.json") << c.content;
    const auto a = run("--config scene.json --out out");
    EXPECT_EQ(a.code, 2) << c.content;
    expect_names(a.err, c.names);
    EXPECT_FALSE(fs::exists(folder / "out"));
  }
}

TEST_F(AluminiumImpact, FolderThatCannotBeMadeIsExitCodeOne) {
  const auto a = run(coarse + "--out /proc/bolide");
  EXPECT_EQ(a.code, 1);
  expect_names(a.err, {"/proc/bolide"});
}

// ---- what only talks ------------------------------------------------------------------------------------------------------------------

TEST_F(AluminiumImpact, HelpListsEveryOptionWithItsDefault) {
  const auto a = run("--help");
  EXPECT_EQ(a.code, 0);
  for (const char* option :
       {"--eos",       "--compare",      "--projectile", "--target",    "--list-materials", "--config", "--diameter", "--velocity",
        "--thickness", "--plate-radius", "--spacing",    "--cell",      "--until",          "--cfl",    "--shape",    "--scheme",
        "--transfer",  "--tension",      "--viscosity",  "--precision", "--initial",        "--jitter", "--seed",     "--box",
        "--threads",   "--out",          "--quick",      "--coarse-beyond", "--help",      "--version",        "--frames", "--fields",   "--ensemble"})
    expect_names(a.out, {option});
  expect_names(a.out, {"9.5mm", "6.64km/s", "2.2mm", "50mm", "0.05mm", "0.1mm", "6.6us", "1.5GPa", "1.5,0.06", "Exit codes"});
}

TEST_F(AluminiumImpact, VersionAndMaterialsGoToStandardOutput) {
  const auto version = run("--version");
  EXPECT_EQ(version.code, 0);
  expect_names(version.out, {"aluminium_impact", "bolide", "0."});
  const auto list = run("--list-materials");
  EXPECT_EQ(list.code, 0);
  expect_names(list.out, {"aluminium_6061", "copper", "steel_4340", "tungsten", "kg/m3", "from memory"});
  EXPECT_TRUE(fs::is_empty(folder));
}

// ---- what a run leaves ----------------------------------------------------------------------------------------------------------------

TEST_F(AluminiumImpact, RunWritesSummaryHistoryFramesAndPictures) {
  const auto a = run(coarse + "--frames 2");
  ASSERT_EQ(a.code, 0) << a.err;
  const json s = summary();
  for (const char* key : {"eos",
                          "shape",
                          "scheme",
                          "transfer",
                          "precision",
                          "tension",
                          "initial",
                          "particles",
                          "steps",
                          "simulated_s",
                          "wall_s",
                          "solver_s",
                          "ns_per_particle_step",
                          "threads",
                          "mass_discrete_kg",
                          "mass_geometric_kg",
                          "length_plate_to_front_mm",
                          "length_veil_to_front_mm",
                          "width_mm",
                          "width_p99_mm",
                          "hole_diameter_mm",
                          "front_speed_m_s",
                          "energy_drift_relative",
                          "ledger_residual_relative",
                          "momentum_error_relative",
                          "peak_pressure_GPa",
                          "peak_pressure_p999_GPa",
                          "mass_fraction_over_150_GPa",
                          "mass_fraction_over_1p5_reference",
                          "molten_fraction_projectile",
                          "median_debris_temperature_K",
                          "left_grid_particles",
                          "floors",
                          "settings",
                          "status",
                          "energy"})
    EXPECT_TRUE(s.contains(key)) << key;
  EXPECT_EQ(s["status"], "done");
  EXPECT_DOUBLE_EQ(s["simulated_s"].get<double>(), 1e-6);
  EXPECT_EQ(s["floors"].size(), 6u);
  EXPECT_LT(std::abs(s["ledger_residual_relative"].get<double>()), 1e-9);
  EXPECT_LT(std::abs(s["momentum_error_relative"].get<double>()), 1e-12);
  EXPECT_NEAR(s["mass_discrete_kg"].get<double>(), s["mass_geometric_kg"].get<double>(), 0.1 * s["mass_geometric_kg"].get<double>());

  // the parts of the internal energy, each summed from its own formula
  for (const char* when : {"initial", "final"}) {
    const json& e = s["energy"][when];
    const double internal = e["internal_J"],
                 parts = e["cold_J"].get<double>() + e["thermal_J"].get<double>() + e["elastic_shear_J"].get<double>();
    EXPECT_NEAR(parts, internal, 1e-9 * internal) << when;
  }

  // history.csv: every row has the columns of the header, time rises to the end
  std::istringstream history(read(folder / "out/history.csv"));
  std::string line;
  std::getline(history, line);
  const auto commas = std::count(line.begin(), line.end(), ',');
  expect_names(line, {"time (s)", "dt (s)", "cause", "kinetic (J)", "cold (J)", "thermal (J)", "work_mismatch (J)", "momentum_z",
                      "most_pressure (Pa)"});
  double time = -1;
  int rows = 0;
  for (; std::getline(history, line); ++rows) {
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), commas);
    EXPECT_GT(std::stod(line), time);
    time = std::stod(line);
  }
  EXPECT_DOUBLE_EQ(time, 1e-6);
  EXPECT_GT(rows, 20);

  // ParaView: the frames that the collection names are there, start and end among them
  const std::string collection = read(folder / "out/particles.pvd");
  expect_names(collection, {"particles_0000.vtu", "particles_0002.vtu", "timestep=\"0\""});
  EXPECT_EQ(collection.find("particles_0003.vtu"), std::string::npos);
  for (const char* frame : {"particles_0000.vtu", "particles_0001.vtu", "particles_0002.vtu"}) {
    const std::string content = read(folder / "out" / frame);
    expect_names(content, {"temperature", "region"});
    EXPECT_EQ(content.find("Name=\"energy\""), std::string::npos) << "a field that was not chosen";
    expect_names(content.substr(content.size() - 40), {"</VTKFile>"});
  }

  // pictures: named on standard output, whole PNG files
  for (const char* picture : {"cloud_phase.png", "cloud_speed.png", "cloud_temperature.png", "radiograph.png"}) {
    expect_names(a.out, {picture});
    const std::string content = read(folder / "out" / picture);
    EXPECT_EQ(content.substr(1, 3), "PNG");
    EXPECT_EQ(content.substr(content.size() - 8, 4), "IEND");
  }
  for (const auto& entry : fs::directory_iterator(folder / "out")) EXPECT_NE(entry.path().extension(), ".part");
  expect_names(a.out, {"length", "width", "solver", "checked: the energy ledger closes"});
  expect_names(a.err, {"mass is 9 % less", "spacing"}); // 2.2 mm are 5.5 layers of 0.4 mm
  expect_names(a.err, {"100.0 %"});                     // progress in plain lines: no terminal here
  EXPECT_EQ(a.err.find('\r'), std::string::npos);
}

TEST_F(AluminiumImpact, DefaultSceneHas58010Particles) {
  const auto a = run("--until 0.002us --frames 0 --pictures none --out out");
  ASSERT_EQ(a.code, 0) << a.err;
  EXPECT_EQ(summary()["particles"], 58010);
  expect_names(a.out, {"58010 particles, expected 58010"});
  EXPECT_FALSE(fs::exists(folder / "out/particles.pvd")); // --frames 0
}

TEST_F(AluminiumImpact, EchoedSettingsReproduceTheSummary) {
  ASSERT_EQ(run(coarse + "--diameter 9.53mm --velocity 6.7km/s --jitter 10% --seed 7 --pictures none --viscosity 1.2,0.1 --tension 2GPa "
                         "--box 12mm,-8mm,9mm "
                         "--fields velocity,pressure --eos helm --target aluminium_6061 --initial cold")
                .code,
            0);
  json first = summary();
  EXPECT_EQ(first["settings"]["diameter"], "9.53mm");
  EXPECT_EQ(first["settings"]["jitter"], "0.1");
  ASSERT_EQ(run("--config out/summary.json --out again").code, 0);
  json again = summary("again");
  std::ofstream(folder / "scene.json") << first["settings"].dump();
  ASSERT_EQ(run("--config scene.json --out third").code, 0);
  json third = summary("third");
  for (json* s : {&first, &again, &third})
    for (const char* clock : {"wall_s", "solver_s", "ns_per_particle_step"}) s->erase(clock);
  EXPECT_EQ(first, again);
  EXPECT_EQ(first, third);
}

TEST_F(AluminiumImpact, CommandLineGoesBeforeConfigAndConfigBeforeQuick) {
  std::ofstream(folder / "scene.json")
      << R"({"spacing": "0.4mm", "cell": "0.8mm", "until": "0.5us", "cfl": 0.3, "threads": 1, "tension": "none"})";
  ASSERT_EQ(run("--quick --config scene.json --until 0.25us --out out").code, 0);
  const json s = summary()["settings"];
  EXPECT_EQ(s["spacing"], "0.4mm");
  EXPECT_EQ(s["until"], "0.25us");
  EXPECT_EQ(s["cfl"], "0.3");
  EXPECT_EQ(s["frames"], "1");
  EXPECT_EQ(s["tension"], "none");
}

// ---- what the options do --------------------------------------------------------------------------------------------------------------

TEST_F(AluminiumImpact, BoxLetsMaterialLeaveAndCountsIt) {
  ASSERT_EQ(run(coarse + "--until 2us --box 45mm,-6mm,6mm").code, 0);
  const json s = summary();
  const double left = s["mass_left_kg"],
               before = s["energy"]["initial"]["kinetic_J"].get<double>() + s["energy"]["initial"]["internal_J"].get<double>();
  EXPECT_GT(s["left_grid_particles"].get<int>(), 100);
  EXPECT_GT(left, 0.004); // 5 mm of the plate's rim alone weigh 9 g
  EXPECT_GT(s["momentum_left_kg_m_s"][1].get<double>(), 0);
  EXPECT_GT(s["energy_left_J"].get<double>(), 0.01 * before);
  EXPECT_LT(std::abs(s["ledger_residual_relative"].get<double>()), 1e-9);
  EXPECT_LT(std::abs(s["momentum_error_relative"].get<double>()), 1e-12);
  EXPECT_LT(std::abs(s["energy_drift_relative"].get<double>()), 3e-3);
}

TEST_F(AluminiumImpact, EveryCompositionRuns) {
  for (const char* composition : {"--shape linear --transfer flip", "--shape bspline --transfer flip", "--shape bspline --transfer apic"})
    for (const char* scheme : {"usf", "musl"})
      for (const char* precision : {"double", "float"}) {
        const std::string chosen = std::string(composition) + " --scheme " + scheme + " --precision " + precision;
        const auto a = run(coarse + "--until 0.4us --frames 0 --pictures none " + chosen);
        EXPECT_EQ(a.code, 0) << chosen << a.err;
        const json s = summary();
        EXPECT_EQ(s["scheme"], scheme);
        EXPECT_EQ(s["precision"], precision);
        EXPECT_LT(std::abs(s["ledger_residual_relative"].get<double>()), precision == std::string("double") ? 1e-9 : 1e-5) << chosen;
        EXPECT_LT(std::abs(s["energy_drift_relative"].get<double>()), 3e-3) << chosen;
      }
}

TEST_F(AluminiumImpact, EveryMaterialRuns) {
  for (const char* name :
       {"aluminium", "aluminium_2024", "aluminium_6061", "aluminium_1100", "copper", "iron", "steel_4340", "lead", "tungsten"}) {
    const auto a = run(coarse + "--until 0.4us --frames 0 --pictures none --eos mie-gruneisen --projectile " + name + " --target " + name);
    EXPECT_EQ(a.code, 0) << name << a.err;
  }
  for (const char* name : {"copper", "iron"})
    EXPECT_EQ(run(coarse + "--until 0.4us --frames 0 --pictures none --eos tillotson --target " + std::string(name)).code, 0) << name;
}

TEST_F(AluminiumImpact, CompareRunsAllEquationsOfState) {
  const auto a = run(coarse + "--compare");
  ASSERT_EQ(a.code, 0) << a.err;
  const json c = json::parse(read(folder / "out/compare.json"));
  ASSERT_EQ(c["runs"].size(), 6u);
  EXPECT_FALSE(c.contains("experiment")); // 1 us is not the paper's case
  for (const char* eos : {"paper", "mixed", "helm", "reference", "mie-gruneisen", "tillotson"}) {
    EXPECT_EQ(summary(std::string("out/") + eos)["eos"], eos);
    expect_names(a.out, {eos});
  }
  EXPECT_NE(summary("out/mixed")["median_debris_temperature_K"], summary("out/tillotson")["median_debris_temperature_K"]);
  EXPECT_EQ(read(folder / "out/compare.png").substr(1, 3), "PNG");
  const std::string table = read(folder / "out/compare.csv");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 7);
}

TEST_F(AluminiumImpact, ThePapersTableStandsBesideThePapersCase) {
  const auto a = run("--spacing 0.4mm --cell 0.8mm --frames 0 --threads 1 --eos tillotson --out out");
  ASSERT_EQ(a.code, 0) << a.err;
  expect_names(a.out, {"paper", "experiment", "38.7", "34.1", "37.7", "34.2"});
}

TEST_F(AluminiumImpact, EnsembleGivesMeanAndScatter) {
  const auto a = run(coarse + "--ensemble 3 --seed 5");
  ASSERT_EQ(a.code, 0) << a.err;
  double sum = 0, squares = 0;
  for (const char* seed : {"5", "6", "7"}) {
    const json s = summary(std::string("out/seed_") + seed);
    EXPECT_EQ(s["settings"]["jitter"], "0.1");
    const double width = s["width_mm"];
    sum += width;
    squares += width * width;
  }
  const json e = json::parse(read(folder / "out/ensemble.json"))["runs"][0];
  EXPECT_EQ(e["members"], 3);
  EXPECT_NEAR(e["measures"]["width_mm"]["mean"].get<double>(), sum / 3, 1e-12 * sum);
  const double deviation = std::sqrt((squares - sum * sum / 3) / 2);
  EXPECT_GT(deviation, 0);
  EXPECT_NEAR(e["measures"]["width_mm"]["standard_deviation"].get<double>(), deviation, 1e-6 * deviation);
  expect_names(a.out, {"+-"});
}

TEST_F(AluminiumImpact, CoarseRimHasFewerParticlesAndTheSameCloud) {
  const std::string scene = "--spacing 0.2mm --cell 0.4mm --until 4us --threads 1 --frames 0 --pictures none ";
  ASSERT_EQ(run(scene + "--out fine").code, 0);
  const auto a = run(scene + "--out two --coarse-beyond 20mm");
  ASSERT_EQ(a.code, 0) << a.err;
  const json fine = summary("fine"), two = summary("two");
  EXPECT_EQ(two["settings"]["coarse-beyond"], "20mm");
  EXPECT_EQ(fine["particles"].get<int>() - two["particles"].get<int>(), 150 * 11 - 109 * 8) << "rim: 8 layers of 0.275 mm for 11 of 0.2 mm";
  EXPECT_NEAR(two["mass_discrete_kg"].get<double>(), fine["mass_discrete_kg"].get<double>(), 1e-3 * fine["mass_discrete_kg"].get<double>());
  for (const char* measure : {"length_plate_to_front_mm", "width_mm", "hole_diameter_mm", "front_speed_m_s"})
    EXPECT_NEAR(two[measure].get<double>(), fine[measure].get<double>(), 0.01 * fine[measure].get<double>()) << measure;
  EXPECT_LE(std::abs(two["ledger_residual_relative"].get<double>()), 1e-9);
}

TEST_F(AluminiumImpact, NothingDownstreamIsNoNumberAndNoFailure) {
  const auto a = run(coarse + "--until 0.1us --velocity 100m/s");
  EXPECT_EQ(a.code, 0) << a.err;
  EXPECT_TRUE(summary()["length_plate_to_front_mm"].is_null());
  EXPECT_EQ(a.out.find("nan"), std::string::npos);
}

// ---- stopped --------------------------------------------------------------------------------------------------------------------------

TEST_F(AluminiumImpact, StoppedRunSaysWhyAndLeavesValidFiles) {
  const auto a = run(coarse + "--step-cap 20");
  EXPECT_EQ(a.code, 3);
  expect_names(a.err, {"stopped at step 20", "step cap of 20", "particle", "position", "pressure"});
  const json s = summary();
  EXPECT_EQ(s["status"], "stopped");
  EXPECT_EQ(s["steps"], 20);
  expect_names(s["message"], {"step cap of 20"});
  expect_names(read(folder / "out/particles.pvd"), {"particles_0001.vtu", "</VTKFile>"});
  EXPECT_TRUE(fs::exists(folder / "out/cloud_phase.png"));
}

// ---- interrupted ----------------------------------------------------------------------------------------------------------------------

TEST_F(AluminiumImpact, InterruptLeavesValidFiles) {
  const std::string out = (folder / "out").string();
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    if (!std::freopen("/dev/null", "w", stdout) || !std::freopen("/dev/null", "w", stderr)) _exit(99);
    execl(BOLIDE_EXAMPLE, BOLIDE_EXAMPLE, "--threads", "1", "--out", out.c_str(),
          static_cast<char*>(nullptr)); // minutes, if nobody stops it
    _exit(98);
  }
  // wait for a few rows: the run is under way
  for (int i = 0; i < 600; ++i) {
    const std::string history = read(folder / "out/history.csv");
    if (std::count(history.begin(), history.end(), '\n') >= 3) break;
    ::usleep(100'000);
  }
  ASSERT_EQ(::kill(child, SIGINT), 0);
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  const json s = summary();
  EXPECT_EQ(s["status"], "interrupted");
  EXPECT_LT(s["simulated_s"].get<double>(), 6.6e-6);
  const std::string history = read(folder / "out/history.csv");
  EXPECT_EQ(history.back(), '\n');
  const std::string collection = read(folder / "out/particles.pvd");
  expect_names(collection, {"</VTKFile>", "particles_0000.vtu", "particles_0001.vtu"}); // the last frame is that of the interruption
  EXPECT_TRUE(fs::exists(folder / "out/particles_0001.vtu"));
  for (const auto& entry : fs::directory_iterator(folder / "out")) EXPECT_NE(entry.path().extension(), ".part");
}

#else
TEST(AluminiumImpact, ProgramIsThere) { GTEST_SKIP() << "the example is not built: one of its libraries is missing"; }
#endif
