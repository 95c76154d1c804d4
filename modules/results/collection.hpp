#pragma once
// Several results in one file: /cases/K, each with the contents of a result file.
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace ehl::results {

/// Attribute `format` of such a file.
constexpr char collection_format[] = "ehl sweep";

/// Name of a result within a collection: "/cases/12".
std::string member_name(std::size_t number);

/// A result in a collection.
struct Member {
  std::size_t number = 0;
  std::string name{};  ///< identifies it: "contact.M=20 contact.L=5"
};

/// Members of a file, by number; none if there is no file. errors: core::FileError: unreadable, or not a collection.
std::vector<Member> members(const std::string& path);

/// Origin of a member: a complete result file in memory, or a member of another collection.
struct Source {
  std::vector<std::byte> image{};
  std::string path{};  ///< of a collection, if there is no image
  std::size_t number = 0;
};

/// Writes a collection completely or not at all, replacing an existing one. in: `source` is called for one member after
/// the other, so that one result is in memory at a time. errors: core::FileError.
void write_collection(const std::string& path, const std::vector<Member>& list,
                      const std::function<Source(const Member&)>& source);

}  // namespace ehl::results
