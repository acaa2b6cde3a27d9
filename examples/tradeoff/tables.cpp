// SPDX-License-Identifier: MIT
// CSV and JSON.
#include "output.hpp"

#include "bolide/observe/csv.hpp"
#include "bolide/observe/json.hpp"

#include <fstream>

namespace tradeoff {

using bolide::advise::table;

std::string machine() {
  std::ifstream info("/proc/cpuinfo");
  std::string cpu = "unknown CPU";
  for (std::string line; std::getline(info, line);)
    if (line.rfind("model name", 0) == 0) {
      cpu = line.substr(line.find(':') + 2);
      break;
    }
#if defined(__clang__)
  return cpu + ", clang++ " __clang_version__ ", one thread";
#else
  return cpu + ", g++ " __VERSION__ ", one thread";
#endif
}

namespace {
/// One row as values, in the order of advise::column_names.
template <class F> void each_value(const bolide::advise::row& r, F&& f) {
  std::size_t k = 0;
  const auto put = [&](const auto& x) { f(bolide::advise::column_names[k++], x); };
  put(r.problem), put(r.kind), put(r.extent), put(r.duration), put(int(r.tube));
  put(r.how.shape), put(r.how.transfer), put(r.how.scheme), put(r.how.precision), put(r.how.per_axis), put(r.how.courant), put(int(r.how.table));
  put(int(r.skip)), put(r.cells), put(r.error), put(r.cost), put(r.spread), put(r.repeats), put(r.steps), put(r.particles), put(r.particle_steps), put(r.strength);
}
} // namespace

void write_csv(const std::filesystem::path& path, const table& t) {
  std::string text;
  for (const char* name : bolide::advise::column_names) text.append(text.empty() ? "" : ",").append(name);
  for (const auto& r : t.rows) {
    bool first = true;
    each_value(r, [&](const char*, const auto& x) { text.append(first ? "\n" : ",").append(bolide::observe::csv_cell(x).text()), first = false; });
  }
  bolide::observe::write_whole_file(path, text + "\n");
}

void write_json(const std::filesystem::path& path, const table& t, const std::string& measured_on) {
  bolide::observe::json_value j;
  j["machine"] = measured_on;
  for (const auto& r : t.rows) {
    bolide::observe::json_value one;
    each_value(r, [&](const char* name, const auto& x) { one[name] = x; });
    one["ns_per_particle_step"] = 1e9 * r.cost / r.particle_steps;
    j["rows"].push_back(one);
  }
  bolide::observe::write_whole_file(path, j.text() + "\n");
}

} // namespace tradeoff
