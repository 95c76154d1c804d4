#include "tables/kept_results.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <utility>

#include "core/errors.hpp"
#include "deck/text.hpp"
#include "results/collection.hpp"
#include "results/write.hpp"

namespace ehl::program {
namespace {

// The head of a record in the journal; the name of the case and the bytes of its result follow.
struct Head {
  char mark[8];
  std::uint64_t name_bytes, image_bytes, hash;
};
constexpr std::uint64_t longest_name = 1 << 20;

// The hash by which an incomplete or damaged record is recognised.
std::uint64_t hash_of(const std::string& name, const std::string& image) { return deck::hash(image, deck::hash(name)); }

bool read_at(int file, long long at, void* to, std::size_t bytes) {
  return ::pread(file, to, bytes, at) == static_cast<ssize_t>(bytes);
}

[[noreturn]] void fail(const std::string& path, const char* what) {
  throw core::FileError(path + ": " + what + ": " + std::strerror(errno));
}

}  // namespace

std::string name_of_kept(const std::string& table) {
  return std::filesystem::path(table).replace_extension(".h5").string();
}

std::string journal_of_kept(const std::string& table) { return name_of_kept(table) + ".part"; }

std::string image_of(const results::Content& content) {
  const std::vector<std::byte> image = results::image("the result of a case", content);
  return {reinterpret_cast<const char*>(image.data()), image.size()};
}

KeptResults::KeptResults(const std::string& table, bool overwrite)
    : path_(name_of_kept(table)), journal_(journal_of_kept(table)) {
  if (!overwrite)
    for (const results::Member& one : results::members(path_)) in_file_[one.name] = one.number;
  descriptor_ = ::open(journal_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | (overwrite ? O_TRUNC : 0), 0666);
  if (descriptor_ < 0) fail(journal_, "cannot be written");
  try {
    read_journal();
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

KeptResults::~KeptResults() {
  if (descriptor_ < 0) return;
  if (in_journal_.empty()) ::unlink(journal_.c_str());
  ::close(descriptor_);
}

// Reads up to the first incomplete record: the sweep was killed while it wrote that one.
void KeptResults::read_journal() {
  long long at = 0;
  Head head{};
  while (read_at(descriptor_, at, &head, sizeof head) &&
         std::memcmp(head.mark, results::journal_mark, sizeof head.mark) == 0 && head.name_bytes < longest_name) {
    const auto size = static_cast<std::uint64_t>(::lseek(descriptor_, 0, SEEK_END));
    const auto begins = static_cast<std::uint64_t>(at) + sizeof head + head.name_bytes;
    if (begins > size || head.image_bytes > size - begins) break;
    std::string name(head.name_bytes, '\0'), image(head.image_bytes, '\0');
    const auto of_image = static_cast<long long>(begins);
    if (!read_at(descriptor_, at + static_cast<long long>(sizeof head), name.data(), name.size()) ||
        !read_at(descriptor_, of_image, image.data(), image.size()) || hash_of(name, image) != head.hash)
      break;
    in_journal_[name] = {of_image, image.size()};
    at = of_image + static_cast<long long>(image.size());
  }
  if (::ftruncate(descriptor_, at) != 0 || ::lseek(descriptor_, at, SEEK_SET) != at)
    fail(journal_, "cannot be written");
}

bool KeptResults::has(const std::string& name) const { return in_file_.contains(name) || in_journal_.contains(name); }

void KeptResults::append(const std::string& name, const std::string& image) {
  Head head{{}, name.size(), image.size(), hash_of(name, image)};
  std::memcpy(head.mark, results::journal_mark, sizeof head.mark);
  const std::string record = std::string(reinterpret_cast<const char*>(&head), sizeof head) + name + image;
  const long long at = ::lseek(descriptor_, 0, SEEK_CUR);
  for (std::size_t done = 0; done < record.size();) {
    const ssize_t written = ::write(descriptor_, record.data() + done, record.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail(journal_, "cannot be written");
    done += static_cast<std::size_t>(written);
  }
  if (::fdatasync(descriptor_) != 0 && errno != EINVAL) fail(journal_, "cannot be written");
  in_journal_[name] = {at + static_cast<long long>(sizeof head + name.size()), image.size()};
}

void KeptResults::finish(const std::vector<std::pair<std::size_t, std::string>>& cases) {
  std::vector<results::Member> list;
  bool same = in_journal_.empty();  // true if the existing file already holds exactly these results
  for (const auto& [number, name] : cases) {
    if (!has(name)) continue;
    list.push_back({number, name});
    same = same && in_file_.at(name) == number;
  }
  if (same) return;
  results::write_collection(path_, list, [this](const results::Member& one) {
    const auto found = in_journal_.find(one.name);
    if (found == in_journal_.end()) return results::Source{.path = path_, .number = in_file_.at(one.name)};
    results::Source from{.image = std::vector<std::byte>(found->second.bytes)};
    if (!read_at(descriptor_, found->second.at, from.image.data(), from.image.size())) fail(journal_, "cannot be read");
    return from;
  });
  in_journal_.clear();
}

std::string merge_kept(const std::vector<std::string>& tables, const std::string& whole) {
  std::vector<results::Member> list;
  std::map<std::size_t, std::string> homes;
  std::string with, without;
  for (const std::string& table : tables) {
    const std::string path = name_of_kept(table);
    if (std::filesystem::exists(path + ".part"))
      throw core::FileError(path + ".part: its shard has not ended: complete it before its results are merged");
    const bool kept = std::filesystem::exists(path);
    (kept ? with : without) = path;
    for (const results::Member& one : results::members(path)) {
      list.push_back(one);
      homes[one.number] = path;
    }
  }
  if (with.empty()) return {};
  if (!without.empty()) throw core::FileError(without + ": is missing, but " + with + " is there: merge both or none");
  std::ranges::sort(list, {}, &results::Member::number);
  const std::string path = name_of_kept(whole);
  results::write_collection(path, list, [&](const results::Member& one) {
    return results::Source{.path = homes.at(one.number), .number = one.number};
  });
  return path;
}

}  // namespace ehl::program
