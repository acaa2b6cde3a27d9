// SPDX-License-Identifier: MIT
// Speed of the composed solver over the textbook solver (textbook.hpp), and over the limits of the core (limits.hpp), in one run.
//
//   benchmark_ratios [--out FILE.json] [--only TEXT] [--repeats N] [--most PARTICLES]
//
// Not a Google Benchmark program: that times one function after the other, minutes apart, and on a shared machine a ratio of two such times is
// noise. Here the solvers of a row take turns, some tens of milliseconds each, and are compared repeat by repeat. Thread CPU time, one thread (the row
// of two threads: the clock on the wall); the figure is the median over the repeats, beside the least.
//
// Scene: block_scene.hpp, advanced by 60 steps before the clock starts, so that most of it yields. At the end the kinetic energies of the solvers of
// a row must agree within 1 % (else exit 1), so that what is timed is the same motion; tests/verify/textbook_test.cpp is the sharp test.
// Shares: 305 flop and 208 B per particle and step in r-z with linear shape functions, double (a count of the prototype's two sweeps,
// docs/performance.md); the flops of the textbook solver are counted here by a number type that counts.
// --most leaves out rows of more particles (default 1.1e6; 1e7 needs 4 GB and a minute more).
#include "block_scene.hpp"
#include "hand_written.hpp"
#include "limits.hpp"
#include "machine.hpp"
#include "paper_scene.hpp"

#include "bolide/grid/uniform.hpp"
#include "bolide/strength/johnson_cook.hpp"

#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace {
using namespace bolide;
using real = long double;

// ---- results ------------------------------------------------------------------------------------------------------------------------
double median(std::vector<double> x) {
  std::sort(x.begin(), x.end());
  const std::size_t n = x.size();
  return n == 0 ? 0 : (x[(n - 1) / 2] + x[n / 2]) / 2;
}
std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return text;
}
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}
/// Numbers and texts by name, one JSON object.
struct entry {
  std::vector<std::pair<std::string, std::string>> values;
  entry& add(const std::string& name, double x) {
    values.emplace_back(name, number(x));
    return *this;
  }
  entry& add(const std::string& name, const std::string& text) {
    values.emplace_back(name, quoted(text));
    return *this;
  }
  std::string text() const {
    std::string out = "{";
    for (const auto& [name, value] : values) out += (out.size() > 1 ? ", " : "") + quoted(name) + ": " + value;
    return out + "}";
  }
};
struct results {
  entry machine;
  std::vector<entry> times, ratios;
  void write(const std::string& file) const {
    std::ofstream out(file);
    const auto list = [&](const char* name, const std::vector<entry>& rows) {
      out << ",\n  \"" << name << "\": [";
      for (std::size_t i = 0; i < rows.size(); ++i) out << (i ? ",\n    " : "\n    ") << rows[i].text();
      out << "]";
    };
    out << "{\n  \"machine\": " << machine.text();
    list("times", times);
    list("ratios", ratios);
    out << "\n}\n";
    out.close();
    if (!out) std::printf("cannot write %s\n", file.c_str());
  }
};

// ---- contestants --------------------------------------------------------------------------------------------------------------------
/// Bytes that the heap has given out.
double heap_bytes() {
#if defined(__GLIBC__)
  const auto info = mallinfo2();
  return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
#else
  return std::nan("");
#endif
}

/// A solver with its scene.
struct contestant {
  std::string name;
  double particles = 0, bytes = 0;          // bytes of heap per particle after the first step
  std::function<void(int)> advance;         // by so many steps
  std::function<double()> kinetic_energy;   // J
  std::vector<double> times;                // ns per particle and step, one per repeat
  double time() const { return median(times); }
};

template <class Solver, class T> double kinetic_energy_of_book(const Solver& sim) {
  double sum = 0;
  for (const auto& p : sim.particles) {
    double v2 = 0;
    if constexpr (Solver::dim == 2) v2 = square(static_cast<double>(p.vr)) + square(static_cast<double>(p.vz));
    else
      for (const T v : p.v) v2 += square(static_cast<double>(v));
    sum += 0.5 * static_cast<double>(p.m) * v2;
  }
  return sum;
}
template <class T, class Shape, int Dim> contestant book(const std::string& name, const scenes::block<Dim>& scene) {
  const double before = heap_bytes();
  const auto sim = std::make_shared<decltype(scenes::by_the_book<T, Shape>(scene))>(scenes::by_the_book<T, Shape>(scene));
  contestant c{name, static_cast<double>(sim->particles.size()), 0, {}, {}, {}};
  c.advance = [sim, dt = static_cast<T>(scene.dt())](int steps) {
    for (int i = 0; i < steps; ++i) sim->step(dt);
  };
  c.kinetic_energy = [sim] { return kinetic_energy_of_book<std::remove_cvref_t<decltype(*sim)>, T>(*sim); };
  c.advance(1);
  c.bytes = (heap_bytes() - before) / c.particles;
  return c;
}
template <class T, class Shape, int Dim> contestant composed(const std::string& name, const scenes::block<Dim>& scene) {
  const double before = heap_bytes();
  const auto sim = std::make_shared<decltype(scenes::composed<T, Shape>(scene))>(scenes::composed<T, Shape>(scene));
  contestant c{name, static_cast<double>(sim->particle_count()), 0, {}, {}, {}};
  c.advance = [sim, dt = scene.dt()](int steps) {
    for (int i = 0; i < steps; ++i) sim->step(dt);
  };
  c.kinetic_energy = [sim] { return sim->energies().now.kinetic; };
  c.advance(1);
  c.bytes = (heap_bytes() - before) / c.particles;
  return c;
}

/// The composed solver's step written by hand for one composition (hand_written.hpp).
contestant by_hand(const std::string& name, const scenes::block<2>& scene) {
  const double before = heap_bytes();
  const std::shared_ptr<hand_written::rz> sim = hand_written::by_hand(scene);
  contestant c{name, static_cast<double>(sim->size()), 0, {}, {}, {}};
  c.advance = [sim, dt = scene.dt()](int steps) {
    for (int i = 0; i < steps; ++i) sim->step(dt);
  };
  c.kinetic_energy = [sim] {
    using hand = hand_written::rz;
    double sum = 0;
    for (std::size_t i = 0; i < sim->size(); ++i) sum += 0.5 * sim->of[hand::particle_mass][i] * (square(sim->of[hand::vr][i]) + square(sim->of[hand::vz][i]));
    return sum;
  };
  c.advance(1);
  c.bytes = (heap_bytes() - before) / c.particles;
  return c;
}

/// The contestants take turns: `repeats` times `steps` steps each, after `warm_up` steps that are not timed.
void race(std::vector<contestant>& all, int warm_up, int repeats, int steps) {
  for (auto& c : all) c.advance(warm_up - 1); // one step is done
  for (int r = 0; r < repeats; ++r)
    for (auto& c : all) {
      const double begin = limits::thread_seconds();
      c.advance(steps);
      c.times.push_back(1e9 * (limits::thread_seconds() - begin) / (c.particles * steps));
    }
}

struct session {
  results out;
  int repeats = 0; // 0: as many as the row says
  std::string only;
  double most = 1.1e6;
  bool agree = true;
  double fma_double = 0, bandwidth = 0;

  bool wants(const std::string& group) const { return group.find(only) != std::string::npos; }
  /// Times the contestants of a group, the first of which is the textbook solver in double.
  void run(const std::string& group, std::vector<contestant> all, int warm_up, int rounds, int steps) {
    race(all, warm_up, repeats > 0 ? repeats : rounds, steps);
    const double energy = all[0].kinetic_energy();
    for (const auto& c : all) {
      const double ratio = c.kinetic_energy() / energy;
      const bool same = std::abs(ratio - 1) < 0.01;
      agree = agree && same;
      const double least = *std::min_element(c.times.begin(), c.times.end()), mean = [&] {
        double sum = 0;
        for (const double t : c.times) sum += t;
        return sum / static_cast<double>(c.times.size());
      }();
      std::printf("  %-26s %-16s %8.2f %8.2f %8.2f   %6.0f   %.4f%s\n", group.c_str(), c.name.c_str(), c.time(), least, mean, c.bytes, ratio,
                  same ? "" : " DIFFERS");
      out.times.push_back(entry()
                              .add("group", group)
                              .add("solver", c.name)
                              .add("particles", c.particles)
                              .add("ns_median", c.time())
                              .add("ns_least", least)
                              .add("ns_mean", mean)
                              .add("heap_bytes_per_particle", c.bytes)
                              .add("kinetic_energy_over_textbook", ratio));
    }
    std::fflush(stdout);
    last = std::move(all);
  }
  std::vector<contestant> last;
  const contestant& find(const std::string& name) const {
    return *std::find_if(last.begin(), last.end(), [&](const contestant& c) { return c.name == name; });
  }
  /// Median over the repeats of textbook over composed, repeat by repeat.
  double speed_up(const std::string& name) const {
    std::vector<double> r;
    const auto& c = find(name);
    for (std::size_t i = 0; i < c.times.size(); ++i) r.push_back(last[0].times[i] / c.times[i]);
    return median(r);
  }
  /// A figure with what is asked of it.
  void figure(const std::string& what, double value, double must, double aim, bool at_least = true) {
    figures.push_back({what, value, must, aim, at_least});
    const std::string met = (at_least ? value >= must : value <= must) ? "yes" : "no";
    out.ratios.push_back(entry().add("measure", what).add("value", value).add("must", must).add("aim", aim).add("met", met));
  }
  void print_figures() const {
    std::printf("\n  %-82s %8s %8s %8s\n", "measure", "value", "must", "aim");
    for (const auto& f : figures)
      std::printf("  %-82s %8.3g %8.3g %8.3g  %s\n", f.what.c_str(), f.value, f.must, f.aim,
                  (f.at_least ? f.value >= f.must : f.value <= f.must) ? "" : "missed");
  }
  struct figure_row {
    std::string what;
    double value, must, aim;
    bool at_least;
  };
  std::vector<figure_row> figures;
};

// ---- a number that counts -----------------------------------------------------------------------------------------------------------
struct counted {
  double x = 0;
  static inline double operations = 0, divisions = 0, roots = 0;
  counted() = default;
  template <class N> requires std::is_arithmetic_v<N> explicit counted(N n) : x(static_cast<double>(n)) {}
  explicit operator int() const { return static_cast<int>(x); }
  static counted of(double value) {
    ++operations;
    return counted(value);
  }
  friend counted operator+(counted a, counted b) { return of(a.x + b.x); }
  friend counted operator-(counted a, counted b) { return of(a.x - b.x); }
  friend counted operator*(counted a, counted b) { return of(a.x * b.x); }
  friend counted operator/(counted a, counted b) {
    ++divisions;
    return of(a.x / b.x);
  }
  friend counted operator-(counted a) { return counted(-a.x); } // a sign
  counted& operator+=(counted b) { return *this = *this + b; }
  counted& operator*=(counted b) { return *this = *this * b; }
  friend bool operator<(counted a, counted b) { return a.x < b.x; }
  friend bool operator>(counted a, counted b) { return a.x > b.x; }
  friend counted sqrt(counted a) {
    ++roots;
    return of(std::sqrt(a.x));
  }
};
template <class Shape, int Dim> void count_operations(session& s, const std::string& name, int cells) {
  const scenes::block<Dim> scene{cells};
  auto sim = scenes::by_the_book<counted, Shape>(scene);
  for (int i = 0; i < 60; ++i) sim.step(counted(scene.dt()));
  counted::operations = counted::divisions = counted::roots = 0;
  sim.step(counted(scene.dt()));
  const auto n = static_cast<double>(sim.particles.size());
  std::printf("  textbook, %-14s %6.0f flop per particle and step, of these %.2f divisions and %.2f square roots\n", name.c_str(),
              counted::operations / n, counted::divisions / n, counted::roots / n);
  s.out.machine.add("textbook flop, " + name, counted::operations / n);
}

// ---- Johnson-Cook -------------------------------------------------------------------------------------------------------------------
struct yield_states {
  static constexpr std::size_t n = 4096;
  std::vector<double> strain, rate, temperature, yield;
  yield_states() : strain(n), rate(n), temperature(n), yield(n) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> log_strain(std::log(1e-4), std::log(2.0)), log_rate(0, std::log(1e7)), t(293, 600);
    for (std::size_t i = 0; i < n; ++i) {
      strain[i] = std::exp(log_strain(random));
      rate[i] = std::exp(log_rate(random));
      temperature[i] = t(random);
    }
  }
  template <class V> __attribute__((noinline)) void evaluate(const strength::johnson_cook& m) {
    for (std::size_t i = 0; i < n; i += static_cast<std::size_t>(lane_width<V>))
      store(m.yield_stress(load<V>(&strain[i]), load<V>(&rate[i]), load<V>(&temperature[i]), V(933.0)), &yield[i]);
  }
  double error(const strength::johnson_cook& m) const {
    double worst = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const real y = (real(m.a) + real(m.b) * std::pow(real(strain[i]), real(m.n))) * (1 + real(m.c) * std::log(real(rate[i]))) *
                     (1 - (real(temperature[i]) - real(m.room_temperature)) / (933 - real(m.room_temperature)));
      worst = std::max(worst, static_cast<double>(std::abs(real(yield[i]) / y - 1)));
    }
    return worst;
  }
};
void johnson_cook(session& s) {
  const strength::johnson_cook m;
  yield_states states;
  std::vector<double> scalar, vector;
  const auto time = [&](auto&& f) {
    const double begin = limits::thread_seconds();
    for (int i = 0; i < 50; ++i) f();
    return 1e9 * (limits::thread_seconds() - begin) / (50.0 * yield_states::n);
  };
  double error_scalar = 0, error_vector = 0;
  for (int r = 0; r < 15; ++r) {
    scalar.push_back(time([&] { states.evaluate<double>(m); }));
    error_scalar = states.error(m);
    vector.push_back(time([&] { states.evaluate<native_pack<double>>(m); }));
    error_vector = states.error(m);
  }
  std::printf("  Johnson-Cook yield stress: libm %.2f ns, error %.1e; pack of %d %.2f ns, error %.1e\n", median(scalar), error_scalar,
              native_width<double>, median(vector), error_vector);
  const auto row = [&](const char* name, double ns, double error) {
    s.out.times.push_back(entry().add("group", "Johnson-Cook yield").add("solver", name).add("ns_median", ns).add("relative_error", error));
  };
  row("libm", median(scalar), error_scalar);
  row("pack", median(vector), error_vector);
  s.figure("Johnson-Cook yield, pack over libm", median(scalar) / median(vector), 6, 8);
  s.figure("Johnson-Cook yield, pack, largest relative error", error_vector, 2e-15, 2e-15, false);
}

// ---- threads ------------------------------------------------------------------------------------------------------------------------
/// One thread and two, in turn every other step, by the clock on the wall: the machine must be quiet.
void threads(session& s) {
  const scenes::block<2> scene{120};
  auto one = scenes::composed<double, shape::linear>(scene, 1), two = scenes::composed<double, shape::linear>(scene, 2);
  const auto time = [](auto& sim) {
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < 2; ++i) sim.step();
    return 1e9 * std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / (2 * static_cast<double>(sim.particle_count()));
  };
  std::vector<double> single, both, efficiency;
  for (int r = -5; r < (s.repeats > 0 ? s.repeats : 200); ++r) {
    const double a = time(one), b = time(two);
    if (r >= 0) single.push_back(a), both.push_back(b), efficiency.push_back(a / (2 * b));
  }
  const auto state = [](const auto& sim) {
    std::vector<double> all;
    sim.for_each_body([&](const auto& set) {
      const auto& p = set.columns;
      for (std::size_t i = 0; i < p.size(); ++i)
        for (int d = 0; d < 2; ++d) all.push_back(p.template get<field::position>(d)[i]), all.push_back(p.template get<field::velocity>(d)[i]);
    });
    return all;
  };
  const bool same = state(one) == state(two);
  s.agree = s.agree && same;
  std::printf("  two threads, r-z linear, 57,600: one thread %.2f ns, two %.2f ns by the clock on the wall (medians); %s\n", median(single), median(both),
              same ? "the same bits" : "DIFFERENT BITS");
  s.out.times.push_back(entry().add("group", "threads").add("solver", "composed double, one thread").add("ns_median", median(single)));
  s.out.times.push_back(entry().add("group", "threads").add("solver", "composed double, two threads").add("ns_median", median(both)));
  s.figure("58k, r-z linear USF double: efficiency of two threads", median(efficiency), 0.90, 0.95);
}

// ---- the rows -----------------------------------------------------------------------------------------------------------------------
using linear = shape::linear;
using bspline = shape::quadratic_bspline;

void limits_of_the_core(session& s) {
  s.fma_double = limits::fma_rate<double>();
  const double fma_float = limits::fma_rate<float>(), cache = limits::update_bandwidth(limits::second_level_bytes);
  const double clock = limits::clock_rate();
  s.bandwidth = limits::update_bandwidth(limits::memory_bytes);
  std::printf("  %s, %.2f GHz; %s; flags: %s\n", machine::cpu_model().c_str(), 1e-9 * clock, machine::compiler().c_str(), machine::flags);
  std::printf("  multiply-adds %.1f Gflop/s double, %.1f float; update bandwidth %.1f GB/s memory, %.1f second-level cache\n", 1e-9 * s.fma_double,
              1e-9 * fma_float, 1e-9 * s.bandwidth, 1e-9 * cache);
  s.out.machine.add("cpu", machine::cpu_model()).add("clock_hertz", clock).add("compiler", machine::compiler()).add("flags", machine::flags);
  s.out.machine.add("lanes_double", native_width<double>).add("fma_double", s.fma_double).add("fma_float", fma_float);
  s.out.machine.add("update_bandwidth_memory", s.bandwidth).add("update_bandwidth_second_level", cache);
}

void rz_58k(session& s) {
  const scenes::block<2> scene{120};
  s.run("r-z linear, 57,600",
        {book<double, textbook::linear>("textbook double", scene), book<float, textbook::linear>("textbook float", scene),
         composed<double, linear>("composed double", scene), composed<float, linear>("composed float", scene), by_hand("by hand double", scene)},
        60, 11, 20);
  s.figure("58k, r-z linear USF double: composed solver over a hand-written kernel of its step", s.speed_up("by hand double") / s.speed_up("composed double"), 1.05, 1.00,
           false);
  s.figure("58k, r-z linear USF, textbook double, ns (35 of performance.md times 1.3)", s.last[0].time(), 45.5, 35, false);
  s.figure("58k, r-z linear USF double, one thread: speed over the textbook solver", s.speed_up("composed double"), 4.5, 6);
  s.figure("58k, r-z linear USF float: speed over the textbook solver in double", s.speed_up("composed float"), 7, 10);
  s.figure("58k, r-z linear USF double: share of measured FMA peak (305 flop)", 305e9 / s.find("composed double").time() / s.fma_double, 0.30, 0.50);
}
void rz_58k_elastic(session& s) { // nothing yields: the textbook's branch is always predicted
  scenes::block<2> scene{120};
  scene.metal.yield = 100e9;
  s.run("r-z linear, 57,600 elastic",
        {book<double, textbook::linear>("textbook double", scene), composed<double, linear>("composed double", scene)}, 60, 11, 20);
}
void rz_58k_quadratic(session& s) {
  const scenes::block<2> scene{120};
  s.run("r-z quadratic, 57,600",
        {book<double, textbook::quadratic>("textbook double", scene), composed<double, bspline>("composed double", scene),
         composed<float, bspline>("composed float", scene)},
        60, 11, 20);
  s.figure("58k, r-z quadratic USF, textbook double, ns (70 of performance.md times 1.3)", s.last[0].time(), 91, 70, false);
  s.figure("58k, r-z quadratic USF double: speed over the textbook solver", s.speed_up("composed double"), 4.2, 6);
}
void rz_1m(session& s) {
  const scenes::block<2> scene{500};
  s.run("r-z linear, 1,000,000",
        {book<double, textbook::linear>("textbook double", scene), composed<double, linear>("composed double", scene),
         composed<float, linear>("composed float", scene)},
        60, 9, 4);
  s.bandwidth = std::max(s.bandwidth, limits::update_bandwidth(limits::memory_bytes)); // the best of two tries, before and after
  const double of_bandwidth = s.find("composed double").time() * 1e-9 * s.bandwidth / 208;
  s.figure("1M, r-z linear double: time over (208 B / update bandwidth)", of_bandwidth, 2.5, 1.5, false);
}
void xyz_1m(session& s) {
  const scenes::block<3> scene{50};
  s.run("3-D 8-node, 1,000,000",
        {book<double, textbook::linear>("textbook double", scene), composed<double, linear>("composed double", scene)}, 60, 9, 3);
  s.figure("1M, 3-D 8-node double: speed over the textbook solver", s.speed_up("composed double"), 2.8, 5);
}
void xyz_1m_quadratic(session& s) {
  const scenes::block<3> scene{50};
  s.run("3-D 27-node, 1,000,000",
        {book<double, textbook::quadratic>("textbook double", scene), composed<double, bspline>("composed double", scene)}, 20, 7, 2);
  s.figure("1M, 3-D 27-node double: speed over the textbook solver", s.speed_up("composed double"), 3, 5);
}
/// The paper's scene, and what empty space around it costs: specks of material in the corners of a box of 560 x 900 cells. To compare with, the textbook
/// solver, which sweeps its whole grid, with a block of as many particles in a tight box and in that one.
template <class Grid> contestant in_space(const std::string& name, const Grid& grid, bool specks, bool box) {
  scenes::paper scene;
  scene.specks = specks;
  const double before = heap_bytes();
  const auto sim = std::make_shared<decltype(scenes::composed(scene, grid))>(scenes::composed(scene, grid));
  if (box) sim->add(leaving_box<2>{-scene.high(), scene.high()}); // never reached: what is asked of every particle is the cost
  contestant c{name, static_cast<double>(sim->particle_count()), 0, {}, {}, {}};
  c.advance = [sim](int steps) {
    for (int i = 0; i < steps; ++i) sim->step();
  };
  c.kinetic_energy = [sim] { return sim->energies().now.kinetic; };
  c.advance(1);
  c.bytes = (heap_bytes() - before) / c.particles;
  return c;
}
contestant book_in_space(const std::string& name, const scenes::block<2>& scene) {
  const double before = heap_bytes();
  const scenes::paper wide;
  using solver_type = textbook::rz<double, textbook::linear>;
  const auto sim = std::make_shared<solver_type>(scene.metal, textbook::box<2>{{scene.corner() - scene.margin * scene.h, scene.corner() - scene.margin * scene.h},
                                                                               {wide.cells_r + 1, wide.cells_z + 1}, scene.h});
  sim->particles = scenes::by_the_book<double, textbook::linear>(scene).particles;
  contestant c{name, static_cast<double>(sim->particles.size()), 0, {}, {}, {}};
  c.advance = [sim, dt = scene.dt()](int steps) {
    for (int i = 0; i < steps; ++i) sim->step(dt);
  };
  c.kinetic_energy = [sim] { return kinetic_energy_of_book<solver_type, double>(*sim); };
  c.advance(1);
  c.bytes = (heap_bytes() - before) / c.particles;
  return c;
}
void empty_space(session& s) {
  const double h = scenes::paper().h;
  s.run("paper's scene",
        {in_space("sparse, tight", grid::sparse{h}, false, false), in_space("sparse, leaving", grid::sparse{h}, false, true),
         in_space("sparse, 560 x 900", grid::sparse{h}, true, true), in_space("uniform, tight", grid::uniform{h}, false, false),
         in_space("uniform, 560x900", grid::uniform{h}, true, true)},
        300, 15, 15);
  s.figure("paper's scene in a box of 560 x 900 cells over a tight one, sparse grid", 1 / s.speed_up("sparse, 560 x 900"), 1.2, 1.05, false);
  const double uniform = s.speed_up("uniform, tight") / s.speed_up("uniform, 560x900");
  std::printf("  uniform grid, 560 x 900 over tight: %.3f\n", uniform);
  s.out.ratios.push_back(entry().add("measure", "uniform grid, 560 x 900 over tight").add("value", uniform));
  const scenes::block<2> block{120};
  s.run("block in empty space", {book<double, textbook::linear>("textbook, tight", block), book_in_space("textbook, 560x900", block)}, 60, 11, 10);
  const double dense = 1 / s.speed_up("textbook, 560x900");
  std::printf("  a dense grid swept whole (textbook), 560 x 900 over tight: %.2f\n", dense);
  s.out.ratios.push_back(entry().add("measure", "textbook solver, 560 x 900 over tight").add("value", dense));
}
/// The cost per particle from 1e4 to 1e7.
void scaling(session& s) {
  std::map<std::string, std::vector<double>> times;
  for (const int cells : {50, 158, 500, 1581}) {
    const scenes::block<2> scene{cells};
    const double particles = 4.0 * cells * cells;
    if (particles > s.most) break;
    const int steps = std::clamp(static_cast<int>(1e6 / particles), 1, 50);
    char name[40];
    std::snprintf(name, sizeof name, "scaling, %.0f", particles);
    s.run(name,
          {book<double, textbook::linear>("textbook double", scene), composed<double, linear>("composed double", scene),
           composed<float, linear>("composed float", scene)},
          particles > 2e6 ? 5 : 30, particles > 2e6 ? 3 : 7, steps);
    for (const auto& c : s.last) times[c.name].push_back(c.time());
  }
  for (const auto& [name, t] : times)
    std::printf("  scaling of %s: largest cost per particle over least %.2f\n", name.c_str(),
                *std::max_element(t.begin(), t.end()) / *std::min_element(t.begin(), t.end()));
}
} // namespace

int main(int argc, char** argv) {
  session s;
  std::string file;
  for (int i = 1; i < argc; ++i) {
    const std::string option = argv[i];
    if (i + 1 < argc && option == "--out") file = argv[++i];
    else if (i + 1 < argc && option == "--only") s.only = argv[++i];
    else if (i + 1 < argc && option == "--repeats") s.repeats = std::atoi(argv[++i]);
    else if (i + 1 < argc && option == "--most") s.most = std::atof(argv[++i]);
    else {
      std::printf("usage: benchmark_ratios [--out FILE.json] [--only TEXT] [--repeats N] [--most PARTICLES]\n"
                  "  groups: limits flops rz_58k rz_58k_elastic rz_58k_quadratic rz_1m xyz_1m xyz_1m_quadratic empty scaling johnson_cook threads\n");
      return 2;
    }
  }
  limits_of_the_core(s);
  if (s.wants("flops")) {
    count_operations<textbook::linear, 2>(s, "r-z linear", 40);
    count_operations<textbook::quadratic, 2>(s, "r-z quadratic", 40);
    count_operations<textbook::linear, 3>(s, "3-D 8-node", 12);
    count_operations<textbook::quadratic, 3>(s, "3-D 27-node", 12);
  }
  if (s.wants("johnson_cook")) johnson_cook(s);
  if (s.wants("threads")) threads(s);
  std::printf("\n  %-26s %-16s %8s %8s %8s   %6s   %s\n", "ns per particle and step", "solver", "median", "least", "mean", "B heap",
              "kinetic energy over the textbook's");
  if (s.wants("rz_58k")) rz_58k(s);
  if (s.wants("rz_58k_elastic")) rz_58k_elastic(s);
  if (s.wants("rz_58k_quadratic")) rz_58k_quadratic(s);
  if (s.most >= 1e6) {
    if (s.wants("rz_1m")) rz_1m(s);
    if (s.wants("xyz_1m")) xyz_1m(s);
    if (s.wants("xyz_1m_quadratic")) xyz_1m_quadratic(s);
  }
  if (s.wants("empty")) empty_space(s);
  if (s.wants("scaling")) scaling(s);
  s.print_figures();
  if (!file.empty()) s.out.write(file);
  return s.agree ? 0 : 1;
}
