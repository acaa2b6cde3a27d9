// SPDX-License-Identifier: MIT
// A cold curve chosen at run time; itself a ColdCurve, so that every phase model is compiled once for all of them.
#pragma once

#include "parameters.hpp"

#include "bolide/concepts/cold_curve.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace explorer {

class any_cold {
public:
  template <class Cold> explicit any_cold(Cold cold, std::string remark = {})
      : model_(std::make_shared<model<Cold>>(std::move(cold))), remark_(std::move(remark)) {}
  bolide::cold_point<double> evaluate(double x) const { return model_->evaluate(x); }
  double reference_density() const { return model_->reference_density(); }

  /// How far a table is from the exact curve; empty for an exact one.
  const std::string& remark() const { return remark_; }

private:
  struct role {
    virtual ~role() = default;
    virtual bolide::cold_point<double> evaluate(double x) const = 0;
    virtual double reference_density() const = 0;
  };
  template <class Cold> struct model : role {
    Cold cold;
    explicit model(Cold c) : cold(std::move(c)) {}
    bolide::cold_point<double> evaluate(double x) const override { return cold.evaluate(x); }
    double reference_density() const override { return cold.reference_density(); }
  };
  std::shared_ptr<const role> model_;
  std::string remark_;
};
static_assert(bolide::ColdCurve<any_cold>);

/// The curve of that name, its parameters taken from `set`; as a table if asked. Throws bolide::bad_parameter for an unknown name.
any_cold make_cold(const std::string& name, assignments& set, bool table);

/// The curves that come from files (cold_files.cpp): FILE or FILE:ELEMENT; two columns, with --set density=... where the first is x.
any_cold make_setfl(const std::string& where);
any_cold make_user_table(const std::string& file, assignments& set);

/// Throws bolide::bad_parameter with the known names unless this is one.
void check_cold_name(const std::string& name);

struct cold_entry {
  std::string name, source;
};
const std::vector<cold_entry>& all_cold_curves();

} // namespace explorer
