#pragma once
// The results of a sweep with --keep: one HDF5 file beside the table. While the sweep goes on they stand in a journal,
// of which a kill at any moment leaves whole results; when all cases have ended they become the file.
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "case/film_solution.hpp"

namespace ehl::program {

/// "t.h5" of the table "t.csv".
std::string name_of_kept(const std::string& table);
/// Its journal, "t.h5.part".
std::string journal_of_kept(const std::string& table);

/// The result file of a case, in memory: what `ehl run` writes of the steady contact. in: the solution, with finite
/// films. errors: core::SolverError of an effect that is computed after the film.
std::string kept_result(const Case& input, FilmSolution&& found);

class KeptResults {
 public:
  /// Reads what there is: the file of an earlier sweep, and the journal of one that was cut short. in: path of the
  /// table, whose files were checked (results/outputs.hpp); overwrite: begin again. errors: core::FileError: a file of
  /// another kind.
  KeptResults(const std::string& table, bool overwrite);
  ~KeptResults();
  KeptResults(const KeptResults&) = delete;
  KeptResults& operator=(const KeptResults&) = delete;

  /// in: a case by its varied keys, "contact.M=20 contact.L=5".
  bool has(const std::string& name) const;
  /// Keeps the result of a case, on disk when it returns. errors: core::FileError.
  void append(const std::string& name, const std::string& image);
  /// Makes the file of those that are kept, and takes the journal away. in: numbers and names of the cases.
  /// errors: core::FileError.
  void finish(const std::vector<std::pair<std::size_t, std::string>>& cases);

  const std::string& path() const { return path_; }

 private:
  struct Record {
    long long at = 0;
    std::size_t bytes = 0;
  };
  void read_journal();

  std::string path_, journal_;
  std::map<std::string, std::size_t> in_file_{};  ///< number in the file of an earlier sweep
  std::map<std::string, Record> in_journal_{};
  int descriptor_ = -1;
};

/// The files of shards as one. in: their tables; that of the whole; its cases. out: its path; empty where none of the
/// shards has kept results. errors: core::FileError: one has none, or is not finished; a member of no case.
std::string merge_kept(const std::vector<std::string>& tables, const std::string& whole);

}  // namespace ehl::program
