// SPDX-License-Identifier: MIT
// The files that the measured rows become.
#pragma once

#include "problems.hpp"

#include "bolide/advise/table.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tradeoff {

/// "AMD EPYC, g++ 12.2.0": the machine and what compiled this program.
std::string machine();

void write_csv(const std::filesystem::path& path, const bolide::advise::table& t);
void write_json(const std::filesystem::path& path, const bolide::advise::table& t, const std::string& measured_on);

/// Error against cost of one problem, with its Pareto front: PNG.
void write_picture(const std::filesystem::path& path, const bolide::advise::table& t, const std::string& problem);
/// All problems in one self-contained page: hovering a mark names its composition.
void write_report(const std::filesystem::path& path, const bolide::advise::table& t, const std::string& measured_on);

/// docs/tradeoff.md (`judged`, `fresh`: the judge's sections, may be empty), docs/img/tradeoff.png and include/bolide/advise/measured.hpp below `root`.
void write_docs(const std::filesystem::path& root, const bolide::advise::table& t, const std::string& measured_on, const std::string& judged, const std::string& fresh);

} // namespace tradeoff
