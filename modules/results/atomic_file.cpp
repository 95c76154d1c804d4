#include "results/atomic_file.hpp"

#include <fcntl.h>
#include <stdio.h>  // renameat2
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
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

std::string temporary_name(const std::string& path) {
  const files::path whole(path);
  const std::string name = files::path(path).filename().string();
  std::string hidden = ".";
  hidden += name + "." + std::to_string(::getpid()) + ".part";
  return folder_of(path) / hidden;
}

/// A file under a name of its own that disappears unless it is given the final name.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& path) : path_(path), name_(temporary_name(path)) {
    descriptor_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor_ < 0) fail(path_, "cannot be written", errno);
  }
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!name_.empty()) ::unlink(name_.c_str());
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
    // Some file systems discover a full disk only here.
    if (::fsync(descriptor_) != 0 && errno != EINVAL) fail(path_, "cannot be written", errno);
    const int status = ::close(descriptor_);
    descriptor_ = -1;
    if (status != 0) fail(path_, "cannot be written", errno);
  }

  void rename(bool overwrite) {
    int status = -1;
    if (!overwrite) {
      // The file may have appeared while the case was being solved.
      status = ::renameat2(AT_FDCWD, name_.c_str(), AT_FDCWD, path_.c_str(), RENAME_NOREPLACE);
      if (status != 0 && errno == EEXIST) fail(path_, "appeared in the meantime and is not overwritten", EEXIST);
      const bool unsupported = status != 0 && (errno == EINVAL || errno == ENOSYS);
      if (status != 0 && !unsupported) fail(path_, "cannot be written", errno);
    }
    if (status != 0 && ::rename(name_.c_str(), path_.c_str()) != 0) fail(path_, "cannot be written", errno);
    name_.clear();
  }

 private:
  std::string path_;
  std::string name_;
  int descriptor_ = -1;
};

}  // namespace

void check_writable(const std::string& path, bool overwrite, std::size_t bytes) {
  if (path.empty()) throw core::FileError("the name of the output file is empty");
  std::error_code error;
  const files::file_status status = files::status(path, error);
  if (files::exists(status)) {
    if (files::is_directory(status)) throw core::FileError(path + ": cannot be written: this is a directory");
    if (!files::is_regular_file(status)) throw core::FileError(path + ": cannot be written: this is no regular file");
    if (!overwrite) throw core::FileError(path + ": exists already: give --overwrite or another --output");
  }
  const std::string folder = folder_of(path);
  if (!files::is_directory(folder, error))
    throw core::FileError(path + ": cannot be written: there is no folder " + folder);
  TemporaryFile probe(path);

  struct statvfs disk {};
  if (::statvfs(folder.c_str(), &disk) != 0) return;  // then the writing itself will tell
  const double room = static_cast<double>(disk.f_bavail) * static_cast<double>(disk.f_frsize);
  constexpr double mega = 1e6;
  if (room < static_cast<double>(bytes))
    throw core::FileError(path + ": cannot be written: the result needs " +
                          std::to_string(static_cast<double>(bytes) / mega) + " MB and the disk has room for " +
                          std::to_string(room / mega) + " MB");
}

void write_atomically(const std::string& path, std::span<const std::byte> bytes, bool overwrite) {
  TemporaryFile file(path);
  file.write(bytes);
  file.rename(overwrite);
  const int folder = ::open(folder_of(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;
  ::fsync(folder);  // the new name, too, survives a power cut; not every file system can, and nothing is lost if not
  ::close(folder);
}

}  // namespace ehl::results
