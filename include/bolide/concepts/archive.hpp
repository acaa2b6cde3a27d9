// SPDX-License-Identifier: MIT
// The role "archive": where is the state of a run kept, or where does it come from?
//
// Whoever has a state lists it once, in `template <class A> void archive(A& a)`, for writing and for reading alike: value(name, x) hands
// x over, or fills it. One list and two archives, so that nothing can be written and not read, or read and not written.
//   value(name, x)        state: a number, an enumeration, a text, an array or a vector of numbers, or an object with archive() of its own
//   group(name, f)        what f() lists gets names below `name`
//   expect(holds, what)   what must be true of what was read; reading ends with a sentence otherwise, writing never looks
// and of what a state is only good for, in `template <class A> void describe(A& a) const`:
//   same(name, text), same(name, number, unit)     must be equal in what was kept and in what is here
//   alike(name, numbers, tolerance, what)          the same of many numbers, up to a relative tolerance; what(k) says what number k is
// Invariants: names are unique within their group; the list does not depend on the state but by the lengths of vectors.
// Cost: a checkpoint is rare; nothing here is called in a time step.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <string>
#include <vector>

namespace bolide {

template <class A>
concept Archive = requires(A& a, bool& flag, double& number, float& single, std::int64_t& whole, std::string& text, std::array<double, 3>& few,
                           std::vector<double>& many, std::vector<float>& singles, std::vector<std::uint32_t>& ids,
                           std::string (*what)(std::size_t)) {
  { A::reading } -> std::convertible_to<bool>;
  a.value("name", flag);
  a.value("name", number);
  a.value("name", single);
  a.value("name", whole);
  a.value("name", text);
  a.value("name", few);
  a.value("name", many);
  a.value("name", singles);
  a.value("name", ids);
  a.group("name", [] {});
  a.expect(flag, "sentence");
  a.same("name", "text");
  a.same("name", number, "unit");
  a.alike("name", many, 1e-9, what);
};

} // namespace bolide
