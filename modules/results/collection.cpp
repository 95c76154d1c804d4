#include "results/collection.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "results/atomic_file.hpp"
#include "results/hdf5_handle.hpp"

namespace ehl::results {

namespace {

Handle opened(const std::string& path) {
  Handle file = open_hdf5(path);
  if (text_attribute(file, "/", "format") != collection_format)
    throw core::FileError(path + ": this is an HDF5 file, but not the stored results of a sweep");
  return file;
}

// Opens a result file in memory.
Handle opened(const std::vector<std::byte>& image, const std::string& cannot) {
  const Handle access = checked(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, cannot);
  check(H5Pset_fapl_core(access, 1 << 20, false), cannot);
  check(H5Pset_file_image(access, const_cast<std::byte*>(image.data()), image.size()), cannot);
  return checked(H5Fopen(name_in_memory, H5F_ACC_RDONLY, access), H5Fclose, cannot);
}

void fill(const std::string& name, const std::string& cannot, const std::vector<Member>& list,
          const std::function<Source(const Member&)>& source) {
  const Handle access = checked(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, cannot);
  check(H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V110), cannot);
  const Handle root = creation(H5P_FILE_CREATE, cannot), plain = creation(H5P_GROUP_CREATE, cannot);
  const Handle file = checked(H5Fcreate(name.c_str(), H5F_ACC_EXCL, root, access), H5Fclose, cannot);
  add_text_attribute(file, "format", collection_format, cannot);
  const Handle cases = checked(H5Gcreate2(file, "/cases", H5P_DEFAULT, plain, H5P_DEFAULT), H5Gclose, cannot);
  add_text_attribute(cases, "meaning", "the cases of a sweep, by number, each in the layout of a result file", cannot);
  for (const Member& one : list) {
    const Source from = source(one);
    const Handle origin = from.image.empty() ? opened(from.path) : opened(from.image, cannot);
    const std::string there = from.image.empty() ? member_name(from.number) : "/";
    const std::string here = member_name(one.number);
    check(H5Ocopy(origin, there.c_str(), file, here.c_str(), H5P_DEFAULT, H5P_DEFAULT), cannot + " " + here);
    if (from.image.empty()) continue;  // a member of a collection already has its name
    const Handle made = checked(H5Gopen2(file, here.c_str(), H5P_DEFAULT), H5Gclose, cannot);
    add_text_attribute(made, "case", one.name, cannot);
  }
  check(H5Fflush(file, H5F_SCOPE_GLOBAL), cannot);
}

}  // namespace

std::string member_name(std::size_t number) { return "/cases/" + std::to_string(number); }

std::vector<Member> members(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return {};
  const QuietErrors quiet;
  const Handle file = opened(path);
  const std::string cannot = path + ": cannot read /cases";
  const Handle cases = checked(H5Gopen2(file, "/cases", H5P_DEFAULT), H5Gclose, cannot);
  std::vector<std::string> names;
  const auto keep = [](hid_t, const char* name, const H5L_info_t*, void* data) -> herr_t {
    static_cast<std::vector<std::string>*>(data)->emplace_back(name);
    return 0;
  };
  check(H5Literate(cases, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, keep, &names), cannot);
  std::vector<Member> list;
  for (const std::string& name : names) {
    if (name.empty() || name.size() > 9 || name.find_first_not_of("0123456789") != std::string::npos)
      throw core::FileError(path + ": the file is damaged: /cases/" + name + " is not a case");
    list.push_back({std::stoul(name), text_attribute(file, "/cases/" + name, "case")});
  }
  std::ranges::sort(list, {}, &Member::number);
  return list;
}

void write_collection(const std::string& path, const std::vector<Member>& list,
                      const std::function<Source(const Member&)>& source) {
  const QuietErrors quiet;
  const std::string cannot = path + ": cannot be written";
  const std::string temporary = temporary_name(path);
  ::unlink(temporary.c_str());
  try {
    fill(temporary, cannot, list, source);
    const int descriptor = ::open(temporary.c_str(), O_RDONLY | O_CLOEXEC);
    const bool safe = descriptor >= 0 && (::fsync(descriptor) == 0 || errno == EINVAL);
    if (descriptor >= 0) ::close(descriptor);
    if (!safe || ::rename(temporary.c_str(), path.c_str()) != 0)
      throw core::FileError(cannot + ": " + std::strerror(errno));
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
}

}  // namespace ehl::results
