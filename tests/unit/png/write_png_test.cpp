// SPDX-License-Identifier: MIT
// Needs libpng's header; without it the room is not built and there is nothing to test.
#if __has_include(<png.h>)
#include "bolide/png/write_png.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <vector>

namespace bolide::png {
namespace {

std::filesystem::path fresh_folder(const std::string& name) {
  const auto path = std::filesystem::temp_directory_path() / ("bolide_png_" + name + "_" + std::to_string(getpid()));
  std::filesystem::remove_all(path);
  return path;
}

TEST(write_png, reads_back_the_same) {
  const auto folder = fresh_folder("same"), path = folder / "deeper" / "picture.png";
  observe::image picture(37, 11);
  for (int y = 0; y < 11; ++y)
    for (int x = 0; x < 37; ++x)
      picture(x, y) = {static_cast<std::uint8_t>(7 * x), static_cast<std::uint8_t>(20 * y), static_cast<std::uint8_t>(x * y)};
  write_png(path, picture);
  EXPECT_FALSE(std::filesystem::exists(observe::aside(path)));

  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  ASSERT_TRUE(png_image_begin_read_from_file(&header, path.c_str()));
  header.format = PNG_FORMAT_RGB;
  ASSERT_EQ(header.width, 37u);
  ASSERT_EQ(header.height, 11u);
  std::vector<png_byte> bytes(PNG_IMAGE_SIZE(header));
  ASSERT_TRUE(png_image_finish_read(&header, nullptr, bytes.data(), 0, nullptr));
  for (int y = 0; y < 11; ++y)
    for (int x = 0; x < 37; ++x) {
      const png_byte* p = &bytes[static_cast<std::size_t>(3 * (37 * y + x))];
      ASSERT_EQ((observe::rgb{p[0], p[1], p[2]}), picture(x, y)) << x << " " << y;
    }
  std::filesystem::remove_all(folder);
}

TEST(write_png, failure_is_a_sentence_and_leaves_nothing) {
  const auto folder = fresh_folder("failure"), path = folder / "picture.png";
  std::filesystem::create_directories(observe::aside(path)); // a folder where the file should be written
  try {
    write_png(path, observe::image(3, 3));
    FAIL() << "no exception";
  } catch (const observe::output_error& e) {
    EXPECT_EQ(std::string(e.what()).find("cannot write the picture " + path.string() + ": "), 0u) << e.what();
  }
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_THROW(write_png(path, observe::image()), bad_parameter);
  std::filesystem::remove_all(folder);
}

TEST(write_png, a_full_disc_is_reported) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const auto folder = fresh_folder("full"), path = folder / "picture.png";
  std::filesystem::create_directories(folder);
  std::filesystem::create_symlink("/dev/full", observe::aside(path));
  EXPECT_THROW(write_png(path, observe::image(300, 300)), observe::output_error);
  EXPECT_FALSE(std::filesystem::exists(path));
  std::filesystem::remove_all(folder);
}

} // namespace
} // namespace bolide::png
#endif
