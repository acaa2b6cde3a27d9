// SPDX-License-Identifier: MIT
// The role archive on a piece of memory: for tests of what the solver lists, and to look at single entries.
#pragma once

#include "bolide/concepts/archive.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace bolide::test {

/// Name of an entry, with the groups around it -> its bytes.
using entries = std::map<std::string, std::string>;

template <bool Reading> class memory_archive {
public:
  static constexpr bool reading = Reading;
  explicit memory_archive(entries& e) : entries_(&e) {}

  template <class X> void value(const std::string& name, X& x) {
    if constexpr (requires { x.archive(*this); }) group(name, [&] { x.archive(*this); });
    else if constexpr (requires { x.resize(1); x.data(); }) {
      using item = std::remove_cvref_t<decltype(x[0])>;
      auto& kept = at(name);
      if (reading) x.resize(kept.size() / sizeof(item));
      else kept.resize(x.size() * sizeof(item));
      copy(kept, x.data(), x.size() * sizeof(item));
    } else {
      static_assert(std::is_trivially_copyable_v<X>);
      auto& kept = at(name);
      if (!reading) kept.resize(sizeof x);
      copy(kept, &x, sizeof x);
    }
  }
  template <class F> void group(const std::string& name, F&& f) {
    const std::string outer = prefix_;
    prefix_ += name + "/";
    f();
    prefix_ = outer;
  }
  void expect(bool holds, const std::string& what) {
    if (reading && !holds) throw std::runtime_error(what);
  }
  void same(const std::string& name, const std::string& text) {
    std::string kept = text;
    value(name, kept);
    if (kept != text) throw std::runtime_error(name + " is " + kept + " there and " + text + " here");
  }
  void same(const std::string& name, double number, const std::string&) { same(name, std::to_string(number)); }
  template <class What> void alike(const std::string& name, const std::vector<double>& numbers, double, What&&) {
    std::vector<double> kept = numbers;
    value(name, kept);
  }

private:
  entries* entries_;
  std::string prefix_;
  std::string& at(const std::string& name) {
    if (reading && !entries_->count(prefix_ + name)) throw std::runtime_error("no entry " + prefix_ + name);
    return (*entries_)[prefix_ + name];
  }
  static void copy(std::string& kept, void* x, std::size_t bytes) {
    if (reading && kept.size() != bytes) throw std::runtime_error("another size");
    if (bytes == 0) return;
    if (reading) std::memcpy(x, kept.data(), bytes);
    else std::memcpy(kept.data(), x, bytes);
  }
};
static_assert(bolide::Archive<memory_archive<true>> && bolide::Archive<memory_archive<false>>);

/// All that a solver lists of its state.
template <class State> entries listed(State& sim) {
  entries e;
  memory_archive<false> a(e);
  sim.archive(a);
  return e;
}
template <class State> void put_back(State& sim, entries e) {
  memory_archive<true> a(e);
  sim.archive(a);
}

} // namespace bolide::test
