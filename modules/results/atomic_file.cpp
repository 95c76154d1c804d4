#include "results/atomic_file.hpp"

#include <fcntl.h>
#include <signal.h>
#include <stdio.h>  // renameat2
#include <sys/file.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>

#include "core/errors.hpp"

namespace ehl::results {
namespace {

namespace files = std::filesystem;

[[noreturn]] void fail(const std::string& path, const std::string& what, int error) {
  throw core::FileError(path + ": " + what + ": " + std::strerror(error));
}

files::path folder_of(const std::string& path) {
  const files::path folder = files::path(path).parent_path();
  return folder.empty() ? files::path(".") : folder;
}

constexpr char beginning[] = ".", ending[] = ".part";

// Process that owns a temporary file of this path; -1 if the name is not one of a temporary file.
pid_t owner(const std::string& path, const std::string& name) {
  const std::string before = beginning + files::path(path).filename().string() + ".";
  if (!name.starts_with(before) || !name.ends_with(ending)) return -1;
  const char* last = name.data() + name.size() - std::strlen(ending);
  pid_t process = -1;
  const auto [end, error] = std::from_chars(name.data() + std::min(before.size(), name.size()), last, process);
  return error == std::errc{} && end == last ? process : -1;
}

}  // namespace

std::string temporary_name(const std::string& path) {
  const std::string name = files::path(path).filename().string();
  return folder_of(path) / (beginning + name + "." + std::to_string(::getpid()) + ending);
}

namespace {

// Removes temporary files of killed runs: their process and its lock no longer exist.
void clean(const std::string& path) {
  std::error_code error;
  for (const files::directory_entry& entry : files::directory_iterator(folder_of(path), error)) {
    const pid_t process = owner(path, entry.path().filename().string());
    const bool gone = process == ::getpid() || (process > 0 && ::kill(process, 0) != 0 && errno == ESRCH);
    if (!gone || !files::is_regular_file(entry.symlink_status(error))) continue;
    const int file = ::open(entry.path().c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) continue;
    if (::flock(file, LOCK_EX | LOCK_NB) == 0) ::unlink(entry.path().c_str());
    ::close(file);
  }
}

// Target of a symbolic link, so that the link stays; any other path is returned unchanged.
std::string followed(const std::string& path) {
  constexpr int most_links = 40;  // limit of the kernel
  std::error_code error;
  files::path target = path;
  for (int links = 0; files::is_symlink(files::symlink_status(target, error)); ++links) {
    if (links == most_links) fail(path, "cannot be written", ELOOP);
    const files::path next = files::read_symlink(target, error);
    if (error) fail(path, "cannot be written", error.value());
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  return target;
}

void refuse_what_is_no_file(const std::string& path, const files::file_status& status) {
  if (files::is_directory(status)) throw core::FileError(path + ": cannot be written: this is a directory");
  if (files::exists(status) && !files::is_regular_file(status))
    throw core::FileError(path + ": cannot be written: this is not a regular file");
}

/// A file under a temporary name; it is removed unless it is renamed to the final name.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& path)
      : path_(path), target_(followed(path)), name_(temporary_name(target_)) {
    // Never an existing file, and never through a link.
    const auto open = [this] {
      return ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    };
    descriptor_ = open();
    if (descriptor_ < 0 && errno == EEXIST) {
      clean(target_);
      descriptor_ = open();
    }
    if (descriptor_ < 0) fail(path_, "cannot be written", errno);
    ::flock(descriptor_, LOCK_EX | LOCK_NB);  // marks the file as in use; released with the process
  }
  ~TemporaryFile() {
    if (descriptor_ < 0) return;
    if (!name_.empty()) ::unlink(name_.c_str());
    ::close(descriptor_);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail(path_, "cannot be written", errno);
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    // Some file systems report a full disk only here.
    if (::fsync(descriptor_) != 0 && errno != EINVAL) fail(path_, "cannot be written", errno);
  }

  void rename(bool overwrite) {
    std::error_code error;
    refuse_what_is_no_file(path_, files::symlink_status(target_, error));
    int status = -1;
    if (!overwrite) {
      // The file may have been created during the computation.
      status = ::renameat2(AT_FDCWD, name_.c_str(), AT_FDCWD, target_.c_str(), RENAME_NOREPLACE);
      if (status != 0 && errno == EEXIST) fail(path_, "appeared in the meantime and is not overwritten", EEXIST);
      const bool unsupported = status != 0 && (errno == EINVAL || errno == ENOSYS);
      if (status != 0 && !unsupported) fail(path_, "cannot be written", errno);
    }
    if (status != 0 && ::rename(name_.c_str(), target_.c_str()) != 0) fail(path_, "cannot be written", errno);
    name_.clear();
  }

 private:
  std::string path_;    // as given
  std::string target_;  // target of links
  std::string name_;
  int descriptor_ = -1;
};

}  // namespace

void check_writable(const std::string& path, bool overwrite, std::size_t bytes) {
  if (path.empty()) throw core::FileError("the name of the output file is empty");
  std::error_code error;
  const std::string target = followed(path);
  const files::file_status status = files::symlink_status(target, error);
  refuse_what_is_no_file(path, status);
  if (files::exists(status) && !overwrite)
    throw core::FileError(path + ": already exists: give --overwrite or another --output");
  const std::string folder = folder_of(target);
  if (!files::is_directory(folder, error))
    throw core::FileError(path + ": cannot be written: there is no folder " + folder);
  clean(target);
  TemporaryFile probe(path);

  struct statvfs disk {};
  if (::statvfs(folder.c_str(), &disk) != 0) return;  // writing will report the problem
  const double room = static_cast<double>(disk.f_bavail) * static_cast<double>(disk.f_frsize);
  constexpr double mega = 1e6;
  if (room < static_cast<double>(bytes))
    throw core::FileError(path + ": cannot be written: the result needs " +
                          std::to_string(static_cast<double>(bytes) / mega) + " MB, but the disk has room for " +
                          std::to_string(room / mega) + " MB");
}

void write_atomically(const std::string& path, std::span<const std::byte> bytes, bool overwrite) {
  TemporaryFile file(path);
  file.write(bytes);
  file.rename(overwrite);
  const int folder = ::open(folder_of(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;
  ::fsync(folder);  // makes the new name durable; not supported by all file systems
  ::close(folder);
}

}  // namespace ehl::results
