// SPDX-License-Identifier: MIT
// Writes an image as a PNG file (8-bit RGB) with libpng. The only header that includes it: link bolide::png.
//
// The file is written aside and renamed (observe/whole_file.hpp), so that a killed run never leaves half a picture.
// Cost: about 35 ms per million pixels, most of it compression.
#pragma once

#include "bolide/observe/image.hpp"
#include "bolide/observe/whole_file.hpp"

#include <png.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>

namespace bolide::png {

namespace detail {
struct close_file {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// libpng reports an error by this call, which must not return; throwing through it is what its manual allows in C++ programs.
[[noreturn]] inline void raise(png_structp, png_const_charp message) { throw observe::output_error(message); }
inline void ignore_warning(png_structp, png_const_charp) {}

/// Owns libpng's two structures.
struct writer {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, raise, ignore_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  writer() {
    if (!info) throw observe::output_error("libpng gives no writer (out of memory, or header and library differ)");
  }
  ~writer() { png_destroy_write_struct(&png, &info); }
  writer(const writer&) = delete;
  writer& operator=(const writer&) = delete;
};

inline void write_rows(std::FILE* file, const observe::image& picture) {
  writer w;
  png_init_io(w.png, file);
  png_set_IHDR(w.png, w.info, static_cast<png_uint_32>(picture.width()), static_cast<png_uint_32>(picture.height()), 8,
               PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(w.png, w.info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_write_info(w.png, w.info);
  for (int y = 0; y < picture.height(); ++y) png_write_row(w.png, picture.row(y));
  png_write_end(w.png, w.info);
}
} // namespace detail

/// Writes `picture` to `path`; throws observe::output_error with path and reason and leaves what was there before.
inline void write_png(const std::filesystem::path& path, const observe::image& picture) {
  require(picture.width() > 0, "width of the picture " + path.string(), picture.width(), "at least 1", "pixels");
  observe::make_folder_of(path);
  const std::filesystem::path part = observe::aside(path);
  try {
    const std::unique_ptr<std::FILE, detail::close_file> file(std::fopen(part.c_str(), "wb"));
    if (!file) throw observe::output_error(std::strerror(errno));
    detail::write_rows(file.get(), picture);
    if (std::fflush(file.get()) != 0) throw observe::output_error(std::strerror(errno));
  } catch (const observe::output_error& e) {
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw observe::output_error("cannot write the picture " + path.string() + ": " + e.what());
  }
  observe::rename_from_aside(path);
}

} // namespace bolide::png
