// SPDX-License-Identifier: MIT
// rooms INCLUDE_DIR              says what the house forbids and exits 1 if there is any
// rooms INCLUDE_DIR PICTURE.svg  writes the picture of the rooms instead; it shows what is there, forbidden or not
#include "layers/rooms.hpp"

#include <iostream>

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: rooms INCLUDE_DIR [PICTURE.svg]\n";
    return 2;
  }
  const auto headers = rooms::read_tree(argv[1]);
  const auto wrong = rooms::violations(headers);
  for (const auto& sentence : wrong) std::cout << sentence << '\n';
  if (argc > 2) {
    std::ofstream file(argv[2]);
    if (!(file << rooms::picture(headers))) {
      std::cerr << "cannot write " << argv[2] << '\n';
      return 2;
    }
  }
  std::cout << headers.size() << " headers, " << wrong.size() << " forbidden include lines\n";
  return argc > 2 || wrong.empty() ? 0 : 1;
}
