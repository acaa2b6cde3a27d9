// SPDX-License-Identifier: MIT
// Files that are whole or not there: written aside under the name PATH.part, closed, then renamed over PATH.
//
// A rename within one folder is atomic on POSIX systems, so a reader, or a run that is killed, never leaves half a file under the name
// that counts. Folders that are missing are made.
#pragma once

#include "bolide/core/contract.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

namespace bolide::observe {

/// Thrown when a result cannot be written. what() is a sentence with the path and the system's reason.
struct output_error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Where the file is written before it gets its name.
inline std::filesystem::path aside(const std::filesystem::path& path) {
  std::filesystem::path other = path;
  other += ".part";
  return other;
}

/// Makes the folder that `path` lies in.
inline void make_folder_of(const std::filesystem::path& path) {
  if (path.parent_path().empty()) return;
  std::error_code error;
  std::filesystem::create_directories(path.parent_path(), error);
  if (error) throw output_error("cannot make the folder " + path.parent_path().string() + ": " + error.message());
}

/// Gives the finished file its name.
inline void rename_from_aside(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::rename(aside(path), path, error);
  if (error) throw output_error("cannot rename " + aside(path).string() + " to " + path.string() + ": " + error.message());
}

/// Writes these bytes over a file. Returns the system's reason where that fails, nothing where it works.
inline std::string write_bytes(const std::filesystem::path& path, std::string_view bytes) {
  errno = 0;
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  if (file) file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (file) file.close();
  if (file) return {};
  return errno ? std::strerror(errno) : "unknown reason";
}

/// Writes the whole content, or throws output_error and leaves what was there before.
inline void write_whole_file(const std::filesystem::path& path, std::string_view content) {
  make_folder_of(path);
  if (const std::string reason = write_bytes(aside(path), content); !reason.empty()) {
    std::error_code ignored;
    std::filesystem::remove(aside(path), ignored);
    throw output_error("cannot write " + path.string() + ": " + reason);
  }
  rename_from_aside(path);
}

} // namespace bolide::observe
