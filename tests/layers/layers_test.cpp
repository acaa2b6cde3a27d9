// SPDX-License-Identifier: MIT
// The house keeps its rules: arrows run down only, outside libraries stay in their rooms, the picture shows what is there.
// Each rule is also shown to fail, on a tree made up for it.
#include "layers/rooms.hpp"

#include <gtest/gtest.h>

namespace {

const std::filesystem::path source_dir = BOLIDE_SOURCE_DIR;

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const auto& line : lines) text += line + "\n";
  return text;
}

TEST(Layers, TheTreeIsClean) {
  const auto headers = rooms::read_tree(source_dir / "include/bolide");
  ASSERT_GT(headers.size(), 5u);
  EXPECT_EQ(joined(rooms::violations(headers)), "");
}

TEST(Layers, ThePictureIsUpToDate) {
  std::ifstream file(source_dir / "docs/img/rooms.svg");
  std::stringstream committed;
  committed << file.rdbuf();
  EXPECT_TRUE(committed.str() == rooms::picture(rooms::read_tree(source_dir / "include/bolide")))
      << "docs/img/rooms.svg is out of date: cmake --build build/release --target rooms_picture";
}

/// A tree on disk with the headers given as path -> text.
class synthetic_tree {
public:
  explicit synthetic_tree(const std::map<std::string, std::string>& files) {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    root_ = std::filesystem::path(testing::TempDir()) / (std::string("bolide_layers_") + test->name());
    std::filesystem::remove_all(root_);
    for (const auto& [path, text] : files) {
      std::filesystem::create_directories((root_ / path).parent_path());
      std::ofstream(root_ / path) << text;
    }
  }
  ~synthetic_tree() { std::filesystem::remove_all(root_); }
  synthetic_tree(const synthetic_tree&) = delete;
  synthetic_tree& operator=(const synthetic_tree&) = delete;
  std::string violations() const { return joined(rooms::violations(rooms::read_tree(root_))); }

private:
  std::filesystem::path root_;
};

TEST(Layers, AnArrowUpIsCaught) {
  const synthetic_tree tree({{"core/low.hpp", "#pragma once\n#include \"bolide/solver/high.hpp\"\n"}, {"solver/high.hpp", "#pragma once\n"}});
  EXPECT_EQ(tree.violations(), "core/low.hpp: room core must not include room solver: the arrow runs up\n");
}

TEST(Layers, AnArrowSidewaysIsCaught) {
  const synthetic_tree tree({{"eos/gas.hpp", "#include \"bolide/strength/none.hpp\"\n"}, {"strength/none.hpp", ""}});
  EXPECT_EQ(tree.violations(), "eos/gas.hpp: room eos must not include room strength: the arrow runs sideways\n");
}

TEST(Layers, AnArrowWrittenWithBlanksIsCaught) {
  const synthetic_tree tree({{"eos/gas.hpp", "  #  include  \"bolide/strength/none.hpp\" // why\n"}, {"strength/none.hpp", ""}});
  EXPECT_NE(tree.violations().find("sideways"), std::string::npos);
}

TEST(Layers, TheTimeLoopDoesNotSeeTheAnalysis) {
  const synthetic_tree tree({{"solver/run.hpp", "#include \"bolide/analysis/hugoniot.hpp\"\n"}, {"analysis/hugoniot.hpp", ""}});
  EXPECT_NE(tree.violations().find("room solver must not include room analysis"), std::string::npos);
}

TEST(Layers, ArrowsDownAndSubfoldersAreFine) {
  const synthetic_tree tree({{"core/lane.hpp", "#include <cmath>\n"},
                             {"eos/cold/rose.hpp", "#include \"bolide/core/lane.hpp\"\n"},
                             {"eos/grover.hpp", "#include \"bolide/eos/cold/rose.hpp\"\n"},
                             {"analysis/hugoniot.hpp", "#include \"bolide/eos/grover.hpp\"\n#include <functional>\n"},
                             {"gsl/roots.hpp", "#include \"bolide/analysis/hugoniot.hpp\"\n#include <gsl/gsl_roots.h>\n"},
                             {"observe/csv.hpp", "#include \"bolide/core/lane.hpp\"\n#include <fstream>\n"},
                             {"bolide.hpp", "#include \"bolide/observe/csv.hpp\"\n"}});
  EXPECT_EQ(tree.violations(), "");
}

TEST(Layers, OutsideLibrariesStayInTheirRooms) {
  const synthetic_tree tree({{"eos/gas.hpp", "#include <Eigen/Core>\n"},
                             {"analysis/roots.hpp", "#include <gsl/gsl_roots.h>\n"},
                             {"observe/shot.hpp", "#include <png.h>\n"},
                             {"observe/scene.hpp", "#include <nlohmann/json.hpp>\n"}});
  EXPECT_EQ(tree.violations(), "analysis/roots.hpp: <gsl/gsl_roots.h> belongs to room gsl alone\n"
                               "eos/gas.hpp: <Eigen/Core> belongs to room core alone\n"
                               "observe/scene.hpp: <nlohmann/json.hpp> is an outside library: it needs a room and a CMake target of its own\n"
                               "observe/shot.hpp: <png.h> belongs to room png alone\n");
}

TEST(Layers, HeavyHeadersStayAtTheEdge) {
  for (const std::string heavy : {"iostream", "fstream", "functional", "regex", "ranges"}) {
    const synthetic_tree tree({{"solver/run.hpp", "#include <" + heavy + ">\n"}});
    EXPECT_NE(tree.violations().find("<" + heavy + "> only in observe"), std::string::npos);
  }
}

TEST(Layers, UnknownRoomHeaderAndUmbrellaAreCaught) {
  const synthetic_tree tree({{"utils/all.hpp", ""},
                             {"eos/gas.hpp", "#include \"gas_table.hpp\"\n"},
                             {"solver/run.hpp", "#include \"bolide/bolide.hpp\"\n"},
                             {"gsl/roots.hpp", ""},
                             {"bolide.hpp", "#include \"bolide/gsl/roots.hpp\"\n"}});
  const auto found = tree.violations();
  EXPECT_NE(found.find("utils/all.hpp: room utils is not in the table"), std::string::npos) << found;
  EXPECT_NE(found.find("eos/gas.hpp: \"gas_table.hpp\" is no header of the library"), std::string::npos) << found;
  EXPECT_NE(found.find("solver/run.hpp: the umbrella is for users"), std::string::npos) << found;
  EXPECT_NE(found.find("bolide.hpp: room gsl is an optional target"), std::string::npos) << found;
}

TEST(Layers, ImpliedArrowsAreLeftOutOfThePicture) {
  const std::map<std::string, std::set<std::string>> graph = {{"core", {}}, {"concepts", {"core"}}, {"eos", {"core", "concepts"}}};
  EXPECT_TRUE(rooms::implied(graph, "eos", "core"));
  EXPECT_FALSE(rooms::implied(graph, "eos", "concepts"));
}

} // namespace
