// SPDX-License-Identifier: MIT
// A value of JSON (RFC 8259) that is put together and written; there is no reader here. Members keep the order in which they were set.
//
//   json_value j;
//   j["steps"] = sim.steps();
//   j["floors"]["expansion"] = 0;
//   write_whole_file("summary.json", j.text());
//
// Numbers have the shortest form that reads back as the same double; one that is none (NaN, infinity) is null, for JSON has no other word.
#pragma once

#include "bolide/core/contract.hpp"

#include <cmath>
#include <concepts>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bolide::observe {

class json_value {
 public:
  json_value() = default; // null
  json_value(bool b) : text_(b ? "true" : "false") {}
  template <std::floating_point T> json_value(T x) : text_(std::isfinite(x) ? to_text(static_cast<double>(x)) : "null") {}
  template <std::integral T>
    requires(!std::same_as<T, bool>)
  json_value(T x) : text_(std::to_string(x)) {}
  json_value(std::string_view s) : text_(quoted(s)) {}
  json_value(const std::string& s) : text_(quoted(s)) {}
  json_value(const char* s) : text_(quoted(s)) {}
  template <class T> json_value(const std::vector<T>& list) : kind_(kind::list) {
    for (const auto& x : list) members_.emplace_back("", json_value(x));
  }

  /// The member of that name, made if it is not there; what was no object becomes one.
  json_value& operator[](std::string_view name) {
    if (kind_ != kind::object) *this = {}, kind_ = kind::object;
    for (auto& [known, value] : members_)
      if (known == name) return value;
    return members_.emplace_back(std::string(name), json_value()).second;
  }
  /// Appends to a list; what was none becomes one.
  void push_back(json_value x) {
    if (kind_ != kind::list) *this = {}, kind_ = kind::list;
    members_.emplace_back("", std::move(x));
  }

  /// Takes over the members of another object.
  void merge(const json_value& other) {
    for (const auto& [name, value] : other.members_) (*this)[name] = value;
  }

  /// Two blanks a level, a list of plain values on one line.
  std::string text(int level = 0) const {
    if (kind_ == kind::plain) return text_;
    const bool object = kind_ == kind::object, nested = object || (!members_.empty() && members_.front().second.kind_ != kind::plain);
    const std::string indent = nested ? "\n" + std::string(2 * static_cast<std::size_t>(level + 1), ' ') : "";
    std::string all(1, object ? '{' : '[');
    for (std::size_t k = 0; k < members_.size(); ++k) {
      all += k == 0 ? indent : nested ? "," + indent : ", ";
      if (object) all += quoted(members_[k].first) + ": ";
      all += members_[k].second.text(level + 1);
    }
    if (nested && !members_.empty()) all += "\n" + std::string(2 * static_cast<std::size_t>(level), ' ');
    return all + (object ? '}' : ']');
  }

 private:
  enum class kind { plain, object, list };
  static std::string quoted(std::string_view s) {
    std::string out = "\"";
    for (const char c : s) {
      if (c == '"' || c == '\\') out.append(1, '\\').append(1, c);
      else if (static_cast<unsigned char>(c) >= 32) out += c;
      else {
        char code[8];
        std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned>(c));
        out += code;
      }
    }
    return out + '"';
  }
  kind kind_ = kind::plain;
  std::string text_ = "null";
  std::vector<std::pair<std::string, json_value>> members_;
};

} // namespace bolide::observe
