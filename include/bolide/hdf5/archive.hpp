// SPDX-License-Identifier: MIT
// The role archive (concepts/archive.hpp) as an HDF5 file: numbers and texts are attributes of groups, vectors are data sets with a check
// sum of their bytes as attribute. With hdf5/checkpoint.hpp the only headers that include the HDF5 library (its C interface): link bolide::hdf5.
//
// The file's own structure carries check sums of the library (format of HDF5 1.8), the data sets ours: a bit that flipped anywhere is
// found when it is read, before it is used. What is written is built in memory and goes to the disk in one piece: the library
// (1.10.8) crashes at the end of a program whose disk was full when it closed a file. A file is read on machines of the same byte order as the one that wrote it.
#pragma once

#include "bolide/concepts/archive.hpp"
#include "bolide/core/contract.hpp"
#include "bolide/observe/whole_file.hpp"

#include <hdf5.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#if !H5_VERSION_GE(1, 10, 2)
#error "bolide::hdf5 needs HDF5 1.10.2 or newer"
#endif

namespace bolide::hdf5 {

/// Thrown when a checkpoint cannot be used: absent, foreign, damaged, of another version or composition. what() is a sentence with the path.
struct checkpoint_error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline constexpr std::int64_t format_version = 1;

namespace detail {

/// The library prints no errors of its own while one of these lives.
class quiet_errors {
public:
  quiet_errors() {
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~quiet_errors() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }
  quiet_errors(const quiet_errors&) = delete;
  quiet_errors& operator=(const quiet_errors&) = delete;

private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

/// What the library says of its last error: the innermost cause.
inline std::string reason() {
  std::string text;
  const auto keep = [](unsigned n, const H5E_error2_t* e, void* to) -> herr_t {
    if (n == 0 && e->desc) *static_cast<std::string*>(to) = e->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep, &text);
  return text.empty() ? "no reason given" : text;
}

/// Owns an identifier of the library.
class handle {
public:
  handle(hid_t id, herr_t (*closing)(hid_t)) : id_(id), close_(closing) {}
  handle(handle&& o) noexcept : id_(std::exchange(o.id_, H5I_INVALID_HID)), close_(o.close_) {}
  handle& operator=(handle&&) = delete;
  ~handle() {
    if (id_ >= 0) close_(id_);
  }
  hid_t get() const { return id_; }
  explicit operator bool() const { return id_ >= 0; }
  /// Closes now and says whether it worked.
  bool close() { return close_(std::exchange(id_, H5I_INVALID_HID)) >= 0; }

private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

template <class X> hid_t native_type() {
  if constexpr (std::is_enum_v<X>) return native_type<std::underlying_type_t<X>>();
  else if constexpr (std::is_same_v<X, float>) return H5T_NATIVE_FLOAT;
  else if constexpr (std::is_same_v<X, double>) return H5T_NATIVE_DOUBLE;
  else {
    static_assert(std::is_integral_v<X> && !std::is_same_v<X, bool>,
                  "bolide: hdf5: value() takes numbers, enumerations, texts, arrays and vectors of numbers, and objects with archive()");
    constexpr bool s = std::is_signed_v<X>;
    if constexpr (sizeof(X) == 1) return s ? H5T_NATIVE_INT8 : H5T_NATIVE_UINT8;
    else if constexpr (sizeof(X) == 2) return s ? H5T_NATIVE_INT16 : H5T_NATIVE_UINT16;
    else if constexpr (sizeof(X) == 4) return s ? H5T_NATIVE_INT32 : H5T_NATIVE_UINT32;
    else return s ? H5T_NATIVE_INT64 : H5T_NATIVE_UINT64;
  }
}

/// FNV-1a over words of eight bytes, the last filled with zeros.
inline std::uint64_t check_sum(const void* data, std::size_t bytes) {
  const auto* at = static_cast<const unsigned char*>(data);
  std::uint64_t sum = 1469598103934665603ull;
  for (std::size_t i = 0; i < bytes; i += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, at + i, std::min<std::size_t>(8, bytes - i));
    sum = (sum ^ word) * 1099511628211ull;
    sum ^= sum >> 32;
  }
  return sum;
}

template <class X> struct is_vector : std::false_type {};
template <class X> struct is_vector<std::vector<X>> : std::true_type {};
template <class X> struct is_array : std::false_type {};
template <class X, std::size_t N> struct is_array<std::array<X, N>> : std::true_type {};

} // namespace detail

/// An HDF5 file as an archive that is written or read.
template <bool Reading> class archive {
public:
  static constexpr bool reading = Reading;

  /// Creates or opens a checkpoint.
  explicit archive(std::filesystem::path path) : path_(std::move(path)), file_(open(path_)) {
    enter(H5Gopen2(file_.get(), "/", H5P_DEFAULT), "/");
    header();
  }
  /// Ends the archive. What was written is handed to the system; of what was read nothing may be left over.
  void finish() {
    std::uint64_t entries = entries_;
    number("entries", entries);
    if constexpr (reading) {
      if (entries != entries_ - 1)
        fail("holds " + std::to_string(entries) + " entries where this program reads " + std::to_string(entries_ - 1) +
             ": it was written by another version of bolide");
    } else {
      groups_.clear();
      const std::string bytes = image();
      if (!file_.close()) fail("cannot be written: " + detail::reason());
      if (const std::string reason = observe::write_bytes(path_, bytes); !reason.empty()) fail("cannot be written: " + reason);
    }
  }

  template <class X> void value(const std::string& name, X& x) {
    if constexpr (requires { x.archive(*this); }) group(name, [&] { x.archive(*this); });
    else if constexpr (detail::is_vector<X>::value) data_set(name, x);
    else if constexpr (std::is_same_v<X, std::string>) text(name, x);
    else if constexpr (detail::is_array<X>::value) numbers(name, x.data(), x.size());
    else if constexpr (std::is_same_v<X, bool>) {
      std::uint8_t flag = x;
      number(name, flag);
      x = flag != 0;
    } else number(name, x);
  }
  template <class F> void group(const std::string& name, F&& list) {
    enter(reading ? H5Gopen2(here(), name.c_str(), H5P_DEFAULT) : H5Gcreate2(here(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), name);
    list();
    groups_.pop_back();
    names_.pop_back();
  }
  void expect(bool holds, const std::string& what) {
    if (reading && !holds) fail("is damaged: " + what);
  }
  void same(const std::string& name, const std::string& here_is) {
    std::string kept = here_is;
    text(name, kept);
    if (kept != here_is) another(name, "'" + kept + "'", "'" + here_is + "'");
  }
  void same(const std::string& name, double here_is, const std::string& unit) {
    double kept = here_is;
    number(name, kept);
    const std::string with_unit = unit.empty() ? "" : " " + unit;
    if (!(kept == here_is)) another(name, to_text(kept) + with_unit, to_text(here_is) + with_unit);
  }
  template <class What> void alike(const std::string& name, const std::vector<double>& here_are, double tolerance, What&& what) {
    std::vector<double> kept = here_are;
    data_set(name, kept);
    if (kept.size() != here_are.size()) another(name, std::to_string(kept.size()) + " numbers", std::to_string(here_are.size()));
    for (std::size_t k = 0; k < kept.size(); ++k) {
      const double a = kept[k], b = here_are[k];
      if (a == b || (std::isnan(a) && std::isnan(b)) || std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b))) continue;
      another(name + ", " + what(k), to_text(a), to_text(b));
    }
  }

private:
  static constexpr const char* magic = "bolide checkpoint";
  detail::quiet_errors quiet_;
  std::filesystem::path path_;
  detail::handle file_;
  std::vector<detail::handle> groups_;
  std::vector<std::string> names_;
  std::uint64_t entries_ = 0;

  [[noreturn]] static void fail_at(const std::filesystem::path& path, const std::string& what) {
    const std::string sentence = "checkpoint " + path.string() + " " + what;
    if constexpr (reading) throw checkpoint_error(sentence);
    else throw observe::output_error(sentence);
  }
  [[noreturn]] void fail(const std::string& what) const { fail_at(path_, what); }
  [[noreturn]] void another(const std::string& name, const std::string& kept, const std::string& here_is) const {
    fail("is of another composition: " + full(name) + " is " + kept + " in the file and " + here_is + " here");
  }
  std::string full(const std::string& name) const {
    std::string text;
    for (std::size_t k = 1; k < names_.size(); ++k) text += names_[k] + "/";
    return text + name;
  }

  static detail::handle open(const std::filesystem::path& path) {
    const detail::handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_libver_bounds(access.get(), H5F_LIBVER_V18, H5F_LIBVER_V18); // groups, attributes and headers with check sums (the next format marks a file that is open)
    if constexpr (!reading) {
      H5Pset_fapl_core(access.get(), std::size_t{1} << 20, 0); // in memory, grown by 1 MiB
      detail::handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get()), H5Fclose);
      if (!file) fail_at(path, "cannot be written: " + detail::reason());
      return file;
    } else {
      if (std::error_code error; !std::filesystem::is_regular_file(path, error))
        fail_at(path, "cannot be read: " + (error ? error.message() : std::string("it is no file")));
      const htri_t known = H5Fis_hdf5(path.c_str());
      if (known == 0) fail_at(path, "is no HDF5 file");
      detail::handle file(known > 0 ? H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()) : H5I_INVALID_HID, H5Fclose);
      if (!file) fail_at(path, "cannot be opened: " + detail::reason());
      return file;
    }
  }
  /// The bytes of the file that was built.
  std::string image() const {
    if (H5Fflush(file_.get(), H5F_SCOPE_LOCAL) < 0) fail("cannot be written: " + detail::reason());
    const auto size = H5Fget_file_image(file_.get(), nullptr, 0);
    void* memory = nullptr; // of the driver: where the pointer to its bytes lies (the bytes of H5Fget_file_image have a wrong check sum)
    if (size <= 0 || H5Fget_vfd_handle(file_.get(), H5P_DEFAULT, &memory) < 0) fail("cannot be written: " + detail::reason());
    return std::string(*static_cast<const char* const*>(memory), static_cast<std::size_t>(size));
  }
  void header() {
    if (reading && H5Aexists(here(), "format") <= 0) fail("is an HDF5 file but no checkpoint of bolide");
    std::string format = magic;
    text("format", format);
    if (format != magic) fail("is an HDF5 file but no checkpoint of bolide");
    std::int64_t version = format_version;
    number("version", version);
    if (version != format_version)
      fail("has format version " + std::to_string(version) + "; this program reads version " + std::to_string(format_version));
  }
  hid_t here() const { return groups_.back().get(); }
  void enter(hid_t group, const std::string& name) {
    detail::handle opened(group, H5Gclose);
    if (!opened) trouble(name);
    groups_.push_back(std::move(opened));
    names_.push_back(name);
  }
  /// An entry that cannot be read is missing or damaged; one that cannot be written tells why.
  [[noreturn]] void trouble(const std::string& name) const {
    if constexpr (reading) fail("lacks the entry " + full(name) + " or is damaged there (" + detail::reason() + ")");
    else fail("cannot be written: entry " + full(name) + ": " + detail::reason());
  }

  template <class X> void number(const std::string& name, X& x) { numbers(name, &x, 1); }
  template <class X> void numbers(const std::string& name, X* x, std::size_t n) {
    ++entries_;
    attribute(here(), name, x, n);
  }
  template <class X> void attribute(hid_t of, const std::string& name, X* x, std::size_t n) {
    const hid_t type = detail::native_type<X>();
    if constexpr (reading) {
      const detail::handle a(H5Aopen(of, name.c_str(), H5P_DEFAULT), H5Aclose);
      if (!a) trouble(name);
      const detail::handle space(H5Aget_space(a.get()), H5Sclose), kept(H5Aget_type(a.get()), H5Tclose);
      if (H5Sget_simple_extent_npoints(space.get()) != static_cast<hssize_t>(n) || !same_kind(kept.get(), type))
        fail("has another kind of number in " + full(name));
      if (H5Aread(a.get(), type, x) < 0) trouble(name);
    } else {
      const hsize_t size = n;
      const detail::handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
      const detail::handle a(H5Acreate2(of, name.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
      if (!a || H5Awrite(a.get(), type, x) < 0) trouble(name);
    }
  }
  static bool same_kind(hid_t a, hid_t b) { return H5Tget_class(a) == H5Tget_class(b) && H5Tget_size(a) == H5Tget_size(b); }

  void text(const std::string& name, std::string& x) {
    ++entries_;
    const detail::handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    if constexpr (reading) {
      const detail::handle a(H5Aopen(here(), name.c_str(), H5P_DEFAULT), H5Aclose);
      if (!a) trouble(name);
      const detail::handle kept(H5Aget_type(a.get()), H5Tclose);
      if (H5Tget_class(kept.get()) != H5T_STRING || H5Tis_variable_str(kept.get()) != 0) fail("has no text in " + full(name));
      std::string bytes(H5Tget_size(kept.get()), '\0');
      if (H5Aread(a.get(), kept.get(), bytes.data()) < 0) trouble(name);
      x = bytes.c_str();
    } else {
      H5Tset_size(type.get(), x.size() + 1);
      const detail::handle space(H5Screate(H5S_SCALAR), H5Sclose);
      const detail::handle a(H5Acreate2(here(), name.c_str(), type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
      if (!a || H5Awrite(a.get(), type.get(), x.c_str()) < 0) trouble(name);
    }
  }

  template <class X> void data_set(const std::string& name, std::vector<X>& x) {
    ++entries_;
    const hid_t type = detail::native_type<X>();
    std::uint64_t sum = 0;
    if constexpr (reading) {
      const detail::handle set(H5Dopen2(here(), name.c_str(), H5P_DEFAULT), H5Dclose);
      if (!set) trouble(name);
      const detail::handle space(H5Dget_space(set.get()), H5Sclose), kept(H5Dget_type(set.get()), H5Tclose);
      const auto n = H5Sget_simple_extent_npoints(space.get());
      if (n < 0 || !same_kind(kept.get(), type)) fail("has another kind of number in " + full(name));
      attribute(set.get(), "check_sum", &sum, 1);
      std::vector<X> bytes(static_cast<std::size_t>(n));
      if (n > 0 && H5Dread(set.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()) < 0) trouble(name);
      expect(detail::check_sum(bytes.data(), bytes.size() * sizeof(X)) == sum, "the check sum of " + full(name) + " is another");
      x.swap(bytes);
    } else {
      const hsize_t size = x.size();
      const detail::handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
      const detail::handle set(H5Dcreate2(here(), name.c_str(), type, space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
      if (!set || (size > 0 && H5Dwrite(set.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, x.data()) < 0)) trouble(name);
      sum = detail::check_sum(x.data(), x.size() * sizeof(X));
      attribute(set.get(), "check_sum", &sum, 1);
    }
  }
};

using writer = archive<false>;
using reader = archive<true>;
static_assert(bolide::Archive<writer> && bolide::Archive<reader>);

} // namespace bolide::hdf5
