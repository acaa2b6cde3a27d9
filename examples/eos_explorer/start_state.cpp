// SPDX-License-Identifier: MIT
// Where a Hugoniot starts, and the option values that several commands share.
#include "commands.hpp"
#include "text.hpp"

#include "bolide/eos/scaled_density.hpp"
#include "bolide/eos/state.hpp"

#include <cmath>

namespace explorer {

using bolide::bad_parameter;
using bolide::quantity::dimension;

namespace {

/// eos::scaled_density of a model chosen at run time.
class scaled_eos : public any_eos {
public:
  scaled_eos(eos_pointer base, double factor) : base_(std::move(base)), factor_(factor), scaled_({base_.get()}, factor) {}
  bolide::thermal_point<double> evaluate(double rho, double e) const override { return scaled_.evaluate(rho, e); }
  double reference_density() const override { return scaled_.reference_density(); }
  bool knows_temperature() const override { return base_->knows_temperature(); }
  bool knows_melting() const override { return base_->knows_melting(); }
  described_point describe(double rho, double e) const override {
    described_point d = base_->describe(rho / factor_, e);
    d.at = evaluate(rho, e);
    return d;
  }
  bolide::eos::validity_box validity() const override {
    const auto box = base_->validity();
    return {factor_ * box.density_low, factor_ * box.density_high, box.energy_low, box.energy_high};
  }

  std::string remark() const override { return base_->remark(); }

private:
  eos_pointer base_;
  double factor_;
  bolide::eos::scaled_density<thermal_handle> scaled_;
};

struct point {
  double density, energy;
};

point unscaled_start(const request& r, const any_eos& eos) {
  const std::string kind = r.has("initial") ? r.given.at("initial") : "cold";
  if (kind == "cold") return {eos.reference_density(), 0};
  if (kind != "ambient") throw bad_parameter("--initial = '" + kind + "': must be cold or ambient");
  const double T0 = r.has("temperature") ? read_quantity(r.given.at("temperature"), dimension::temperature, "--temperature") : 293;
  return with_model(eos, [&](const auto& model) {
    const auto s = bolide::eos::ambient_state(model, T0);
    return point{s.density, s.energy};
  });
}

} // namespace

start start_of(const request& r, model_choice choice, const std::string& density_option) {
  eos_pointer eos = make_eos(choice);
  if (r.has("from")) {
    const auto state = read_numbers(r.given.at("from"), "--from");
    if (state.size() != 2) throw bad_parameter("--from = '" + r.given.at("from") + "': must be RHO,E in kg/m3 and J/kg (for example 2785,0)");
    bolide::require(state[0] > 0, "--from density", state[0], "> 0", "kg/m3");
    return {eos, state[0], state[1], eos->evaluate(state[0], state[1]).pressure};
  }
  point p = unscaled_start(r, *eos);
  if (r.has(density_option)) {
    const double wanted = read_quantity(r.given.at(density_option), dimension::density, "--" + density_option);
    bolide::require(wanted > 0, "--" + density_option, wanted, "> 0", "kg/m3");
    eos = std::make_shared<scaled_eos>(eos, wanted / p.density);
    p.density = wanted;
  }
  return {eos, p.density, p.energy, eos->evaluate(p.density, p.energy).pressure};
}

answer answer_of(std::string csv, const any_eos& eos) {
  answer a{std::move(csv), {}, {}};
  if (const std::string remark = eos.remark(); !remark.empty()) a.remarks.push_back(remark);
  return a;
}

std::string input_of(const request& r) { return r.input ? *r.input : read_all(r.in); }

std::vector<double> numbers_of(const request& r, const std::string& name, dimension d, bool positive) {
  const auto check = [&](double value, const std::string& where) {
    if (positive && !(value > 0)) throw bad_parameter(where + ": " + name + " = " + bolide::to_text(value) + " must be > 0");
    return value;
  };
  std::vector<double> values;
  if (r.has(name)) {
    for (const auto& part : split_list(r.given.at(name))) values.push_back(check(read_quantity(part, d, "--" + name), "--" + name));
    return values;
  }
  const csv_input in = read_csv(input_of(r));
  if (in.header.size() != 1 || in.header[0] != name)
    throw bad_parameter("line 1: the header must be '" + name + "' (or give the numbers as --" + name + ")");
  for (const auto& line : in.lines) {
    const std::string where = "line " + std::to_string(line.number);
    values.push_back(check(read_number(line.cells[0], where), where));
  }
  return values;
}

} // namespace explorer
