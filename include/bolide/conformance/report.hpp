// SPDX-License-Identifier: MIT
// What a conformance suite found: one line per check, with the worst figure, where it was, its bound, and what that means.
//
//   passed          worst <= bound
//   stated          worst > bound, but whoever asked has stated this violation beforehand: its check, its size, where, and why
//   failed          neither; the worst figure that nobody has stated
//   not applicable  nothing to check, and the reason
// A report has passed if no check has failed. Printed by operator<<, as a table; the program includes <iostream>.
#pragma once

#include "bolide/core/contract.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bolide::conformance {

enum class outcome { passed, stated, not_applicable, failed };
constexpr const char* name(outcome o) {
  constexpr const char* names[] = {"passed", "stated", "not applicable", "FAILED"};
  return names[static_cast<int>(o)];
}

/// A violation that is known: of which check, how large its figure may be, why it is so, and over which density ratios rho/rho0 (of a cold
/// curve: volume ratios x) it may be met. One check may have several.
struct stated_violation {
  std::string check;
  double bound;
  std::string reason;
  double from = 0, to = std::numeric_limits<double>::infinity();
};

struct finding {
  std::string check;
  outcome result;
  double worst;      // the check's figure where it is largest; infinity stands for NaN and infinity
  double bound;      // what it may be
  std::string where; // empty if the figure belongs to no place
  std::string note;
};

struct report {
  std::string subject;
  std::vector<finding> findings;

  bool passed() const {
    return std::none_of(findings.begin(), findings.end(), [](const finding& f) { return f.result == outcome::failed; });
  }
  /// The finding of a check. Throws bad_parameter where the suite has no such check.
  const finding& at(std::string_view check) const {
    const auto f = std::find_if(findings.begin(), findings.end(), [&](const finding& one) { return one.check == check; });
    require(f != findings.end(), "conformance check \"" + std::string(check) + "\": findings of that name", 0, "at least 1");
    return *f;
  }
};

/// One check while it runs: its worst figure, and where. A figure above the bound is the stated violation's where one covers it.
class measure {
public:
  measure(std::string check, double bound, const std::vector<stated_violation>& stated) : check_(std::move(check)), bound_(bound), stated_(stated) {}

  /// At rho/rho0 (or x) and e. NaN is the worst figure there is.
  void add(double figure, double ratio, double energy = std::nan("")) {
    ++points_;
    if (std::isnan(figure)) figure = std::numeric_limits<double>::infinity();
    place& p = figure > bound_ && is_stated(figure, ratio) ? excused_ : worst_;
    if (figure > p.figure || std::isnan(p.ratio)) p = {figure, ratio, energy};
  }

  std::size_t points() const { return points_; }
  double bound() const { return bound_; }

  /// where(ratio, energy) puts a place in words.
  template <class Where> finding close(const Where& where, std::string note) const {
    const bool failed = worst_.figure > bound_, excused = !failed && excused_.figure > bound_;
    const place& p = excused ? excused_ : worst_;
    finding f{check_, outcome::passed, p.figure, bound_, p.figure > 0 ? where(p.ratio, p.energy) : std::string(), std::move(note)};
    if (points_ == 0) f.result = outcome::not_applicable;
    else if (failed) f.result = outcome::failed;
    else if (excused) f.result = outcome::stated;
    for (const stated_violation& s : stated_)
      if (s.check == check_ && points_ > 0) append(f.note, (f.result == outcome::passed ? "not seen, though stated: " : "stated: ") + s.reason);
    return f;
  }

private:
  struct place {
    double figure = 0, ratio = std::nan(""), energy = std::nan("");
  };
  bool is_stated(double figure, double ratio) const {
    return std::any_of(stated_.begin(), stated_.end(), [&](const stated_violation& s) {
      return s.check == check_ && figure <= s.bound && ratio >= s.from && ratio <= s.to;
    });
  }
  static void append(std::string& note, const std::string& more) { note += (note.empty() ? "" : "; ") + more; }

  std::string check_;
  double bound_;
  const std::vector<stated_violation>& stated_;
  place worst_, excused_;
  std::size_t points_ = 0;
};

namespace detail {
inline std::string short_text(double x) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, x, std::chars_format::general, 4).ptr;
  return {buffer, end};
}
inline std::string padded(std::string text, std::size_t width) {
  if (text.size() < width) text.append(width - text.size(), ' ');
  return text;
}
} // namespace detail

/// Throws bad_parameter where a violation is stated of a check that the suite has not: a misspelt name would excuse nothing.
inline void require_known_checks(const report& r, const std::vector<stated_violation>& stated) {
  for (const stated_violation& s : stated) r.at(s.check);
}

inline std::ostream& operator<<(std::ostream& out, const report& r) {
  std::size_t check = 5, where = 5;
  for (const finding& f : r.findings) check = std::max(check, f.check.size()), where = std::max(where, f.where.size());
  const auto line = [&](const std::string& a, const std::string& b, const std::string& c, const std::string& d, const std::string& e,
                        const std::string& f) {
    const std::string text = detail::padded(a, check + 2) + detail::padded(b, 16) + detail::padded(c, 11) + detail::padded(d, 11) +
                             detail::padded(e, where + 2) + f;
    out << text.substr(0, text.find_last_not_of(' ') + 1) << '\n';
  };
  out << "conformance of " << r.subject << '\n';
  line("check", "result", "worst", "bound", "where", "");
  std::size_t failed = 0;
  for (const finding& f : r.findings) {
    const bool measured = f.result != outcome::not_applicable;
    failed += f.result == outcome::failed;
    line(f.check, name(f.result), measured ? detail::short_text(f.worst) : "", measured ? detail::short_text(f.bound) : "", f.where, f.note);
  }
  return out << (failed == 0 ? "passed" : "FAILED") << ": " << r.findings.size() << " checks, " << failed << " failed\n";
}

} // namespace bolide::conformance
