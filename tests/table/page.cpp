// SPDX-License-Identifier: MIT
// page ROWS PAGE [NAME=TEXT ...]    writes PAGE (docs/verification.md) from the rows in ROWS; each NAME=TEXT is a line about where it was made.
#include "table/page.hpp"

#include <fstream>
#include <iostream>

namespace {

std::string processor() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  return "unknown";
}

int write_page(int argc, char** argv) {
  if (argc < 3) throw std::runtime_error("usage: page ROWS PAGE [NAME=TEXT ...]");
  std::ifstream in(argv[1]);
  if (!in) throw std::runtime_error(std::string("cannot read ") + argv[1] + " (did any test record a row?)");
  const auto rows = bolide::table::read_rows(in);
  bolide::table::facts where{{"processor", processor()}};
  for (int i = 3; i < argc; ++i) {
    const std::string text = argv[i];
    const auto at = text.find('=');
    if (at == std::string::npos) throw std::runtime_error("'" + text + "' is not NAME=TEXT");
    where.emplace_back(text.substr(0, at), text.substr(at + 1));
  }
  std::ofstream out(argv[2]);
  out << bolide::table::render(rows, where);
  out.close();
  if (!out) throw std::runtime_error(std::string("cannot write ") + argv[2]);
  std::cout << argv[2] << ": " << rows.size() << " rows\n";
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  try {
    return write_page(argc, argv);
  } catch (const std::exception& e) {
    std::cerr << "page: " << e.what() << "\n";
    return 1;
  }
}
