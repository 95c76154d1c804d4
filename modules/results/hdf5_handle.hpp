#pragma once
// Owner of HDF5 identifiers, for the source files of this module only.
#include <hdf5.h>

#include <new>
#include <string>
#include <vector>

#include "core/errors.hpp"

namespace ehl::results {

/// Owns one identifier of the library and closes it.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);

  Handle(hid_t id, Close close) : id_(id), close_(close) {}
  ~Handle() { release(); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  Handle(Handle&& other) noexcept : id_(other.id_), close_(other.close_) { other.id_ = H5I_INVALID_HID; }
  Handle& operator=(Handle&&) = delete;

  bool valid() const { return id_ >= 0; }
  operator hid_t() const { return id_; }

 private:
  void release() {
    if (id_ >= 0) close_(id_);
    id_ = H5I_INVALID_HID;
  }
  hid_t id_;
  Close close_;
};

/// Suppresses the printing of the library's error stack during its lifetime; the stack stays readable.
/// errors: std::bad_alloc if there is no memory for the library.
class QuietErrors {
 public:
  QuietErrors() {
    // The library aborts the process if its initialization finds no memory, so memory is checked before.
    constexpr std::size_t needed_by_set_up = 16U << 20;
    ::operator delete(::operator new(needed_by_set_up));
    if (H5open() < 0) throw std::bad_alloc();
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~QuietErrors() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;

 private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

/// Innermost and most specific entry of the library's error stack ("truncated file: eof = ...").
inline std::string library_reason() {
  std::string reason;
  const auto keep_last = [](unsigned, const H5E_error2_t* error, void* data) -> herr_t {
    if (error->desc != nullptr && *error->desc != '\0') *static_cast<std::string*>(data) = error->desc;
    return 0;
  };
  // Downward: from the called function to the place of the error.
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, keep_last, &reason);
  return reason.empty() ? "the HDF5 library gives no reason" : reason;
}

/// The handle; errors: core::FileError "<what>: <reason>".
inline Handle checked(hid_t id, Handle::Close close, const std::string& what) {
  if (id < 0) throw core::FileError(what + ": " + library_reason());
  return {id, close};
}

/// Creation properties for a class of objects, without time stamps, so that equal contents give equal bytes.
inline Handle creation(hid_t object_class, const std::string& cannot) {
  Handle properties = checked(H5Pcreate(object_class), H5Pclose, cannot);
  if (H5Pset_obj_track_times(properties, false) < 0) throw core::FileError(cannot + ": " + library_reason());
  return properties;
}

/// Name of a file that the library keeps only in memory. Nothing can exist below a file such as /dev/null; the library
/// would read an existing file of the same name.
constexpr char name_in_memory[] = "/dev/null/result in memory";

/// Opens a file for reading. errors: core::FileError: missing, a directory, not HDF5, truncated.
Handle open_hdf5(const std::string& path);

/// errors: core::FileError "<what>: <reason>" if the status of a library call is negative.
inline void check(herr_t status, const std::string& what) {
  if (status < 0) throw core::FileError(what + ": " + library_reason());
}

/// An open dataset with its shape and type.
struct Dataset {
  Handle set;
  Handle space;
  Handle type;
  std::vector<hsize_t> dims;  ///< empty: a single value
};
/// in: cannot, the beginning of error messages. errors: core::FileError.
Dataset open_dataset(hid_t file, const std::string& name, const std::string& cannot);

/// Adds a text attribute. in: cannot, the beginning of error messages. errors: core::FileError.
void add_text_attribute(hid_t object, const std::string& name, const std::string& text, const std::string& cannot);
/// A text attribute of an object in a file; empty if there is none.
std::string text_attribute(hid_t file, const std::string& object, const std::string& name);

}  // namespace ehl::results
