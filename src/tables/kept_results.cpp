#include "tables/kept_results.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <utility>

#include "core/errors.hpp"
#include "deck/file.hpp"
#include "deck/text.hpp"
#include "results/atomic_file.hpp"
#include "results/collection.hpp"
#include "results/write.hpp"

namespace ehl::program {

namespace files = std::filesystem;

std::string name_of_kept(const std::string& table) { return files::path(table).replace_extension(".h5").string(); }

std::string folder_of_kept(const std::string& table) { return name_of_kept(table) + ".parts"; }

std::string image_of(const results::Content& content) {
  const std::vector<std::byte> image = results::image("the result of a case", content);
  return {reinterpret_cast<const char*>(image.data()), image.size()};
}

KeptResults::KeptResults(const std::string& table, bool overwrite)
    : path_(name_of_kept(table)), folder_(folder_of_kept(table)) {
  if (!overwrite)
    for (const results::Member& one : results::members(path_)) in_file_[one.name] = one.number;
  std::error_code error;
  files::create_directory(folder_, error);
  if (!files::is_directory(folder_)) throw core::FileError(folder_ + ": the folder of the results cannot be made");
  // What a kill left half written is removed, and with --overwrite also what is complete, "0123456789abcdef.h5".
  for (const files::directory_entry& entry : files::directory_iterator(folder_, error))
    if (const std::string name = entry.path().filename();
        name.ends_with(".part") || (overwrite && name.size() == 19 && name.ends_with(".h5")))
      files::remove(entry.path(), error);
}

KeptResults::~KeptResults() {
  std::error_code error;
  files::remove(folder_, error);  // does nothing if the folder holds results
}

// The hash of the name of a case has the same value on every machine.
std::string KeptResults::part(const std::string& name) const {
  return fmt::format("{}/{:016x}.h5", folder_, deck::hash(name));
}

bool KeptResults::has(const std::string& name) const { return in_file_.contains(name) || files::exists(part(name)); }

void KeptResults::add(const std::string& name, const std::string& image) const {
  results::write_atomically(part(name), std::as_bytes(std::span(image)), true);
}

void KeptResults::finish(const std::vector<std::pair<std::size_t, std::string>>& cases) {
  std::vector<results::Member> list;
  bool same = true;  // true if the existing file already holds exactly these results
  for (const auto& [number, name] : cases) {
    if (!has(name)) continue;
    list.push_back({number, name});
    same = same && !files::exists(part(name)) && in_file_.at(name) == number;
  }
  if (same) return;
  results::write_collection(path_, list, [this](const results::Member& one) {
    if (!files::exists(part(one.name))) return results::Source{.path = path_, .number = in_file_.at(one.name)};
    std::ifstream file(part(one.name), std::ios::binary);
    const std::string image{std::istreambuf_iterator<char>(file), {}};
    deck::check_read(file, part(one.name));
    const auto bytes = std::as_bytes(std::span(image));
    return results::Source{.image = {bytes.begin(), bytes.end()}};
  });
  for (const results::Member& one : list) files::remove(part(one.name));
}

std::string merge_kept(const std::vector<std::string>& tables, const std::string& whole) {
  std::vector<results::Member> list;
  std::map<std::size_t, std::string> homes;
  std::string with, without;
  for (const std::string& table : tables) {
    const std::string path = name_of_kept(table);
    if (files::exists(folder_of_kept(table)))
      throw core::FileError(folder_of_kept(table) +
                            ": its shard has not ended: complete it before its results are merged");
    const bool kept = files::exists(path);
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
