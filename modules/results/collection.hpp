#pragma once
// Many results in one file: /cases/K, each as a result file has it from its root.
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace ehl::results {

/// What the attribute `format` of such a file says.
constexpr char collection_format[] = "ehl sweep";

/// How a journal of results begins, from which a collection will be made.
constexpr char journal_mark[] = "ehlkept1";

/// How a result is called within a collection: "/cases/12".
std::string member_name(std::size_t number);

/// A result of a collection.
struct Member {
  std::size_t number = 0;
  std::string name{};  ///< what tells it from the others, for people and for programs: "contact.M=20 contact.L=5"
};

/// Those in a file, by number; none where there is no file. errors: core::FileError: unreadable, or no collection.
std::vector<Member> members(const std::string& path);

/// Where the result of a member comes from: a whole result file in memory, or a member of another collection.
struct Source {
  std::vector<std::byte> image{};
  std::string path{};  ///< of a collection, where there is no image
  std::size_t number = 0;
};

/// Writes a collection that appears whole or not at all, and replaces one that is there. in: `source` is asked for each
/// member in turn, so that one result is in memory at a time. errors: core::FileError.
void write_collection(const std::string& path, const std::vector<Member>& list,
                      const std::function<Source(const Member&)>& source);

}  // namespace ehl::results
