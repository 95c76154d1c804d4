#include "results/read.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "results/collection.hpp"
#include "results/content.hpp"
#include "results/hdf5_handle.hpp"

namespace ehl::results {

void run_no_hdf5_at_exit() { H5dont_atexit(); }

Handle open_hdf5(const std::string& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) throw core::FileError(path + ": cannot be read: this is a directory");
  if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error))
    throw core::FileError(path + ": cannot be read: this is not a regular file");
  errno = 0;
  if (!std::ifstream(path)) throw core::FileError(path + ": cannot be read: " + std::strerror(errno));
  const QuietErrors quiet;
  // A foreign file must not make the program read other files, so external links are disabled. From the second call on
  // the link class is unknown, and the call does nothing.
  H5Lunregister(H5L_TYPE_EXTERNAL);
  if (H5Fis_hdf5(path.c_str()) == 0) throw core::FileError(path + ": cannot be read: this is not an HDF5 file");
  return checked(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, path + ": cannot be read");
}

namespace {

// True if the numbers come from other files; views of data in the same file are allowed.
bool lies_elsewhere(hid_t layout) {
  if (H5Pget_external_count(layout) > 0) return true;
  std::size_t sources = 0;
  if (H5Pget_layout(layout) != H5D_VIRTUAL) return false;
  if (H5Pget_virtual_count(layout, &sources) < 0) return true;
  for (std::size_t k = 0; k < sources; ++k) {
    char name[2] = {};  // "." is this file
    if (H5Pget_virtual_filename(layout, k, name, sizeof name) != 1 || name[0] != '.') return true;
  }
  return false;
}

}  // namespace

Dataset open_dataset(hid_t file, const std::string& name, const std::string& cannot) {
  Handle set = checked(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, cannot);
  Handle space = checked(H5Dget_space(set), H5Sclose, cannot);
  Handle type = checked(H5Dget_type(set), H5Tclose, cannot);
  const int rank = H5Sget_simple_extent_ndims(space);
  if (rank < 0) throw core::FileError(cannot + ": it has no shape");
  std::vector<hsize_t> dims(static_cast<std::size_t>(rank));
  if (rank > 0) H5Sget_simple_extent_dims(space, dims.data(), nullptr);
  const Handle layout = checked(H5Dget_create_plist(set), H5Pclose, cannot);
  if (lies_elsewhere(layout)) throw core::FileError(cannot + ": its numbers are in other files, which are not read");
  return {std::move(set), std::move(space), std::move(type), std::move(dims)};
}

namespace {

// Text of an attribute or a dataset, of fixed or variable length. in: read, a function that reads into memory.
template <class Read>
std::string read_text(hid_t type, Read read) {
  if (H5Tis_variable_str(type) > 0) {
    char* text = nullptr;
    if (read(static_cast<void*>(&text)) < 0 || text == nullptr) return "";
    const std::string result(text);
    H5free_memory(text);
    return result;
  }
  std::string result(H5Tget_size(type), '\0');
  if (read(static_cast<void*>(result.data())) < 0) return "";
  return result.substr(0, result.find('\0'));
}

}  // namespace

struct ResultFile::Implementation {
  std::string path;
  std::string root;  // path of the result: empty, or a member of a collection
  Handle file;

  std::string full(const std::string& name) const { return name == "/" && !root.empty() ? root : root + name; }

  std::string cannot(const std::string& name) const { return path + ": cannot read " + name; }
};

ResultFile::ResultFile(const std::string& path, std::optional<std::size_t> number)
    : implementation_(std::make_unique<Implementation>(
          Implementation{path, number ? member_name(*number) : std::string(), open_hdf5(path)})) {
  const QuietErrors quiet;
  const bool collection = text_attribute(implementation_->file, "/", "format") == collection_format;
  if (collection && !number)
    throw core::FileError(path + ": contains the results of a sweep: choose a case (--case K, cases from 0)");
  if (!collection && number) throw core::FileError(path + ": is not a file of a sweep with --keep: it has no cases");
  if (number && kind("/") != Kind::group) throw core::FileError(path + ": has no case " + std::to_string(*number));
  if (attribute("/", "format") != result_format)
    throw core::FileError(path + ": this is an HDF5 file, but not a result of ehl");
}

ResultFile::~ResultFile() = default;
ResultFile::ResultFile(ResultFile&&) noexcept = default;
ResultFile& ResultFile::operator=(ResultFile&&) noexcept = default;

const std::string& ResultFile::path() const { return implementation_->path; }

ResultFile::Kind ResultFile::kind(const std::string& name) const {
  const QuietErrors quiet;
  const hid_t id = H5Oopen(implementation_->file, implementation_->full(name).c_str(), H5P_DEFAULT);
  if (id < 0) return Kind::missing;
  const Handle object(id, H5Oclose);
  if (H5Iget_type(object) == H5I_GROUP) return Kind::group;
  if (H5Iget_type(object) != H5I_DATASET) return Kind::missing;
  const Handle type(H5Dget_type(object), H5Tclose);
  return H5Tget_class(type) == H5T_STRING ? Kind::text : Kind::numbers;
}

std::vector<std::string> ResultFile::names(const std::string& group) const {
  const QuietErrors quiet;
  const Handle opened = checked(H5Gopen2(implementation_->file, implementation_->full(group).c_str(), H5P_DEFAULT),
                                H5Gclose, implementation_->cannot(group));
  std::vector<std::string> found;
  const auto keep = [](hid_t, const char* name, const H5L_info_t*, void* data) -> herr_t {
    static_cast<std::vector<std::string>*>(data)->emplace_back(name);
    return 0;
  };
  // In the native order: for any other the library follows an index that may be damaged.
  check(H5Literate(opened, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, keep, &found), implementation_->cannot(group));
  std::ranges::sort(found);
  return found;
}

namespace {

hsize_t bytes_stored(hid_t set, hid_t layout) {
  constexpr hsize_t most_of_deflate = 1032;  // largest compression ratio of the format
  return (H5Pget_nfilters(layout) > 0 ? most_of_deflate : 1) * H5Dget_storage_size(set);
}

// Upper bound of the bytes of a dataset from its stored size. A view stores nothing, so its sources count.
hsize_t bytes_behind(hid_t file, hid_t set, const std::string& cannot) {
  const Handle layout = checked(H5Dget_create_plist(set), H5Pclose, cannot);
  std::size_t sources = 0;
  if (H5Pget_layout(layout) != H5D_VIRTUAL) return bytes_stored(set, layout);
  if (H5Pget_virtual_count(layout, &sources) < 0) return 0;
  hsize_t bytes = 0;
  for (std::size_t k = 0; k < sources; ++k) {
    std::string name(4096, '\0');
    if (H5Pget_virtual_dsetname(layout, k, name.data(), name.size()) <= 0) return 0;
    const Handle source = checked(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, cannot);
    const Handle plain = checked(H5Dget_create_plist(source), H5Pclose, cannot);
    if (H5Pget_layout(plain) != H5D_VIRTUAL) bytes += bytes_stored(source, plain);
  }
  return bytes;
}

}  // namespace

Array ResultFile::numbers(const std::string& name) const {
  const QuietErrors quiet;
  const std::string cannot = implementation_->cannot(name);
  const auto [set, space, type, dims] = open_dataset(implementation_->file, implementation_->full(name), cannot);
  const H5T_class_t kind = H5Tget_class(type);
  if (kind != H5T_FLOAT && kind != H5T_INTEGER) throw core::FileError(cannot + ": it contains no numbers");
  if (dims.size() > 2) throw core::FileError(cannot + ": it has " + std::to_string(dims.size()) + " dimensions");
  const hssize_t points = H5Sget_simple_extent_npoints(space);
  // A damaged header can state more numbers than the file has, so no memory is reserved before this check.
  const hsize_t stored = bytes_behind(implementation_->file, set, cannot);
  if (points < 0 || (points > 0 && stored / H5Tget_size(type) < static_cast<hsize_t>(points)))
    throw core::FileError(cannot + ": the file is damaged: it contains fewer numbers than it states");
  Array array;
  array.dims.assign(dims.begin(), dims.end());
  array.values.resize(static_cast<std::size_t>(points));
  check(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, array.values.data()), cannot);
  array.unit = attribute(name, "unit");
  array.meaning = attribute(name, "meaning");
  return array;
}

std::vector<std::size_t> ResultFile::dims(const std::string& name) const {
  const QuietErrors quiet;
  const std::vector<hsize_t> dims =
      open_dataset(implementation_->file, implementation_->full(name), implementation_->cannot(name)).dims;
  return {dims.begin(), dims.end()};
}

std::string ResultFile::axis(const std::string& field, const std::string& name) const {
  for (const std::string& home : {field.substr(0, field.rfind('/')), std::string("/grid")})
    if (kind(home + "/" + name) == Kind::numbers) return home + "/" + name;
  return "";
}

std::string ResultFile::rows(const std::string& field) const {
  const std::string home = field.substr(0, field.rfind('/'));
  const auto has = [&](const char* name) { return kind(home + "/" + name) == Kind::numbers; };
  return has("z") && !has("y") ? "z" : "y";
}

Array ResultFile::frame(const std::string& name, std::size_t k) const {
  const QuietErrors quiet;
  const std::string cannot = implementation_->cannot(name);
  const Dataset opened = open_dataset(implementation_->file, implementation_->full(name), cannot);
  const std::vector<hsize_t>& lengths = opened.dims;
  if (lengths.size() != 3 || k >= lengths[0])
    throw core::FileError(cannot + ": it has no field number " + std::to_string(k));
  Array array;
  array.dims = {lengths[1], lengths[2]};
  // A damaged header can state more numbers than fit into memory, so the dimensions are compared with the grid.
  const std::string x = axis(name, "x"), y = axis(name, rows(name));
  const auto fits = [&](const std::string& axis, hsize_t length) {
    return !axis.empty() && dims(axis) == std::vector<std::size_t>{length};
  };
  if (!fits(y, lengths[1]) || !fits(x, lengths[2]))
    throw core::FileError(cannot + ": the file is damaged: the size does not match its grid");
  array.values.resize(lengths[1] * lengths[2]);
  const hsize_t start[] = {k, 0, 0};
  const hsize_t piece[] = {1, lengths[1], lengths[2]};
  check(H5Sselect_hyperslab(opened.space, H5S_SELECT_SET, start, nullptr, piece, nullptr), cannot);
  const Handle memory = checked(H5Screate_simple(3, piece, nullptr), H5Sclose, cannot);
  check(H5Dread(opened.set, H5T_NATIVE_DOUBLE, memory, opened.space, H5P_DEFAULT, array.values.data()), cannot);
  array.unit = attribute(name, "unit");
  array.meaning = attribute(name, "meaning");
  return array;
}

std::string ResultFile::text(const std::string& name) const {
  const QuietErrors quiet;
  const std::string cannot = implementation_->cannot(name);
  const Dataset opened = open_dataset(implementation_->file, implementation_->full(name), cannot);
  if (H5Tget_class(opened.type) != H5T_STRING || H5Sget_simple_extent_npoints(opened.space) != 1)
    throw core::FileError(cannot + ": it is not text");
  return read_text(opened.type,
                   [&](void* to) { return H5Dread(opened.set, opened.type, H5S_ALL, H5S_ALL, H5P_DEFAULT, to); });
}

std::string text_attribute(hid_t file, const std::string& object, const std::string& name) {
  const hid_t id = H5Aopen_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  if (id < 0) return "";
  const Handle found(id, H5Aclose);
  const Handle type(H5Aget_type(found), H5Tclose);
  const Handle space(H5Aget_space(found), H5Sclose);
  if (H5Tget_class(type) != H5T_STRING || H5Sget_simple_extent_npoints(space) != 1) return "";
  return read_text(type, [&](void* to) { return H5Aread(found, type, to); });
}

std::string ResultFile::attribute(const std::string& object, const std::string& name) const {
  const QuietErrors quiet;
  return text_attribute(implementation_->file, implementation_->full(object), name);
}

}  // namespace ehl::results
