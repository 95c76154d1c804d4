#pragma once
// The results of a sweep with --keep: one HDF5 file next to the table. During the sweep each result is a file of its
// own in a folder, which `ehl` reads as any result; the complete files survive a kill at any moment. When all cases
// have ended, they become the one file.
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "results/content.hpp"

namespace ehl::program {

/// The name of the results file: "t.h5" for the table "t.csv".
std::string name_of_kept(const std::string& table);
/// The name of the folder, "t.h5.parts".
std::string folder_of_kept(const std::string& table);

/// The result file of a case, in memory: what `ehl run` writes for a steady contact.
std::string image_of(const results::Content& content);

class KeptResults {
 public:
  /// Reads the existing results: the file of an earlier sweep, and the folder of a sweep that was interrupted.
  /// in: path of the table, whose files were checked (results/outputs.hpp); overwrite: discard what exists.
  /// errors: core::FileError for a file of another kind, or if the folder cannot be made.
  KeptResults(const std::string& table, bool overwrite);
  ~KeptResults();
  KeptResults(const KeptResults&) = delete;
  KeptResults& operator=(const KeptResults&) = delete;

  /// in: name of a case: its varied keys, "contact.M=20 contact.L=5".
  bool has(const std::string& name) const;
  /// Writes the result of a case; it is on disk when the function returns. errors: core::FileError.
  void add(const std::string& name, const std::string& image) const;
  /// Writes the file of all kept results and removes the folder. in: numbers and names of the
  /// cases. errors: core::FileError.
  void finish(const std::vector<std::pair<std::size_t, std::string>>& cases);

  const std::string& path() const { return path_; }

 private:
  std::string part(const std::string& name) const;  ///< the file of a case in the folder

  std::string path_, folder_;
  std::map<std::string, std::size_t> in_file_{};  ///< number of the case in the file of an earlier sweep
};

/// Merges the result files of shards. in: the tables of the shards; the table of the whole sweep; its cases. out: path
/// of the merged file; empty if no shard has kept results.
/// errors: core::FileError if a shard lacks its file or is not finished, or if a result belongs to no case.
std::string merge_kept(const std::vector<std::string>& tables, const std::string& whole);

}  // namespace ehl::program
