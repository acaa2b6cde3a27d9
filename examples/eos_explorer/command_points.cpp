// SPDX-License-Identifier: MIT
// points: the state of every input line. All lines are read before the first is answered, so that a bad one leaves no output.
#include "commands.hpp"
#include "text.hpp"

namespace explorer {
namespace {

using bolide::bad_parameter;

/// Which column holds the volume (as V/V0 or as density) and which the energy.
struct columns {
  std::size_t volume, energy;
  bool is_ratio;
};

columns columns_of(const std::vector<std::string>& header) {
  const auto is = [&](const char* a, const char* b) { return header.size() == 2 && header[0] == a && header[1] == b; };
  if (is("x", "e") || is("rho", "e")) return {0, 1, header[0] == "x"};
  if (is("e", "x") || is("e", "rho")) return {1, 0, header[1] == "x"};
  std::string found;
  for (const auto& name : header) found += (found.empty() ? "" : ",") + name;
  throw bad_parameter("line 1: the header '" + found + "' must be x,e (V/V0 and J/kg) or rho,e (kg/m3 and J/kg)");
}

struct point {
  double rho, e;
};

point point_of(const csv_line& line, const columns& c, double reference_density) {
  const std::string where = "line " + std::to_string(line.number);
  const double volume = read_number(line.cells[c.volume], where), e = read_number(line.cells[c.energy], where);
  if (!(volume > 0))
    throw bad_parameter(where + ": " + (c.is_ratio ? "x" : "rho") + " = " + bolide::to_text(volume) + " must be > 0");
  const double rho = c.is_ratio ? reference_density / volume : volume;
  if (!(rho > 0 && rho < 1e300)) throw bad_parameter(where + ": '" + line.cells[c.volume] + "' gives no density that a double can hold");
  return {rho, e};
}

} // namespace

answer points(const request& r) {
  model_choice choice = r.model;
  const eos_pointer eos = make_eos(choice);
  const csv_input in = read_csv(input_of(r));
  const columns c = columns_of(in.header);
  std::vector<point> all;
  for (const auto& line : in.lines) all.push_back(point_of(line, c, eos->reference_density()));

  std::vector<std::string> header = in.header;
  for (const char* name : {"region", "temperature_K", "pressure_Pa", "sound_speed_squared_m2_s2", "dp_de", "dp_dV", "melt_fraction", "status"})
    header.emplace_back(name);
  csv_output out(header);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto [rho, e] = all[i];
    const auto [s, region, status] = eos->describe(rho, e);
    const double dp_dV = s.pressure * s.pressure_energy - s.sound_speed_squared * rho * rho; // c^2 = V^2 (p p_e - p_V)
    std::vector<std::string> row = in.lines[i].cells;
    row.insert(row.end(), {region, written(s.temperature), written(s.pressure), written(s.sound_speed_squared),
                           written(s.pressure_energy), written(dp_dV), eos->knows_melting() ? written(s.melt_fraction) : "",
                           status});
    out.put(row);
  }
  return answer_of(out.text(), *eos);
}

} // namespace explorer
