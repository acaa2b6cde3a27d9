// SPDX-License-Identifier: MIT
// Files that survive a power cut: their bytes are on the disk before they get their name, and the file that had the name is kept.
//
// Steps of replace_keeping_previous(path, previous): PATH.part, written and closed, is flushed to the disk (fsync); PATH gets `previous` as a
// second name (a hard link put in place by a rename), so that it is never without either; PATH.part is renamed to PATH; the folder is
// flushed. A process that is killed between any two steps leaves a whole file under PATH. Where the file system has no hard links PATH is
// renamed to `previous` instead, and a kill in that moment leaves the whole file under that name.
#pragma once

#include "bolide/observe/whole_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace bolide::observe {

/// Waits until a file's bytes (or a folder's names) are on the disk. Some file systems cannot flush a folder: that is no error.
inline void flush_to_disk(const std::filesystem::path& path) {
  errno = 0;
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool flushed = file >= 0 && ::fsync(file) == 0;
  const int why = errno;
  if (file >= 0) ::close(file);
  if (!flushed && !(why == EINVAL || why == EROFS)) throw output_error("cannot flush " + path.string() + " to the disk: " + std::strerror(why));
}

/// Gives PATH.part the name PATH; what had it before is `previous` from now on.
inline void replace_keeping_previous(const std::filesystem::path& path, const std::filesystem::path& previous) {
  flush_to_disk(aside(path));
  if (std::filesystem::exists(path)) {
    std::error_code error;
    std::filesystem::remove(aside(previous), error);
    std::filesystem::create_hard_link(path, aside(previous), error);
    if (error) std::filesystem::rename(path, aside(previous), error);
    if (error) throw output_error("cannot keep " + path.string() + " as " + previous.string() + ": " + error.message());
    rename_from_aside(previous);
  }
  rename_from_aside(path);
  flush_to_disk(path.parent_path().empty() ? "." : path.parent_path());
}

} // namespace bolide::observe
