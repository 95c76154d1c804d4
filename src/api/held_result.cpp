#include "api/held_result.hpp"

#include <mutex>
#include <sstream>
#include <utility>

#include "base/exit_status.hpp"
#include "base/failure.hpp"
#include "case/catalogue.hpp"
#include "case/numbers/number.hpp"
#include "core/errors.hpp"
#include "deck/write.hpp"
#include "report/report.hpp"
#include "results/outputs.hpp"
#include "results/read.hpp"
#include "results/write.hpp"
#include "run/pipeline.hpp"

namespace ehl::program {
namespace {

// The HDF5 library must not be called by several threads at once; it reads height maps, and reads and writes results.
std::mutex files;

void guarded(HeldResult& result, const std::function<void()>& work) try { work(); } catch (...) {
  Failure failure = current_failure();
  result.status = failure.status;
  for (std::string& message : failure.messages) result.messages.push_back(std::move(message));
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream from(text);
  for (std::string line; std::getline(from, line);)
    if (!line.empty()) lines.push_back(line);
  return lines;
}

// Joins the values of all fields of an entry into one array.
void gather(results::Entry& entry) {
  for (std::size_t k = 0; k < entry.fields.size(); ++k) {
    const std::vector<double> rows = results::row_by_row(entry, k);
    entry.values.insert(entry.values.end(), rows.begin(), rows.end());
  }
  entry.fields.clear();
}

void hold(HeldResult& result, results::Entry&& entry) {
  if (entry.fields.size() > 1 || entry.dims.size() == 3) gather(entry);
  HeldEntry& held = result.entries.emplace_back(HeldEntry{.entry = std::move(entry)});
  const results::Entry& made = held.entry;
  result.by_path.emplace(made.path, &held);
  if (const std::string* error = results::attribute(made, "error"))
    held.error = made.path.substr(0, made.path.rfind('/') + 1) + *error;
  if (made.kind != results::Entry::Kind::numbers) return;
  if (!made.fields.empty()) {
    held.values = made.fields.front()->at_x(0) + made.first_line;
    held.strides[0] = 1;
    held.strides[1] = made.fields.front()->stride();
    return;
  }
  held.values = made.values.data();
  std::ptrdiff_t step = 1;
  for (std::size_t k = made.dims.size(); k-- > 0; step *= static_cast<std::ptrdiff_t>(made.dims[k]))
    held.strides[k] = step;
}

void hold_all(HeldResult& result, const results::Content& content) {
  for (results::Entry& entry : results::entries(content)) hold(result, std::move(entry));
}

results::Entry numbers_of(const results::ResultFile& file, const std::string& path) {
  results::Entry entry{.path = path, .kind = results::Entry::Kind::numbers, .dims = file.dims(path)};
  if (entry.dims.size() < 3) {
    entry.values = file.numbers(path).values;
    return entry;
  }
  for (std::size_t k = 0; k < entry.dims[0]; ++k) {
    const std::vector<double> one = file.frame(path, k).values;
    entry.values.insert(entry.values.end(), one.begin(), one.end());
  }
  return entry;
}

void hold_below(HeldResult& result, const results::ResultFile& file, const std::string& group) {
  for (const std::string& name : file.names(group)) {
    const std::string path = (group == "/" ? "" : group) + "/" + name;
    const results::ResultFile::Kind kind = file.kind(path);
    if (path == results::plane_group("/transient/frames")) continue;  // a second copy of the frames
    results::Entry entry{.path = path};
    if (kind == results::ResultFile::Kind::numbers) entry = numbers_of(file, path);
    if (kind == results::ResultFile::Kind::text) {
      entry.kind = results::Entry::Kind::text;
      entry.text = file.text(path);
    }
    for (const char* attribute : {"unit", "meaning", "error", "columns", "why"})
      if (std::string text = file.attribute(path, attribute); !text.empty())
        entry.attributes.emplace_back(attribute, std::move(text));
    hold(result, std::move(entry));
    if (kind == results::ResultFile::Kind::group) hold_below(result, file, path);
  }
}

const HeldEntry* found(const HeldResult& result, const std::string& path) {
  const auto at = result.by_path.find(path);
  return at == result.by_path.end() ? nullptr : at->second;
}

}  // namespace

Case case_from(const char* text, const std::string& name, const std::vector<std::string>& overrides, int threads) {
  const std::lock_guard lock(files);
  if (text == nullptr) return read_case(name, overrides, threads);
  return case_of(deck::read_text(text, name, overrides, catalogue()), name, threads);
}

void run_into(HeldResult& result, const std::function<Case()>& read, Progress::Listener listener) {
  guarded(result, [&] {
    const Case& input = result.input.emplace(read());
    if (!listener) listener = [](double, const std::string&) { return true; };
    Progress progress(std::move(listener));
    RunSettings settings{.progress = progress};
    solve_case(input, settings, result.computed);
    result.json = json_of(input, result.computed);
    const Ending ending = ending_of(result.computed, "");
    result.status = ending.status;
    if (!ending.message.empty()) result.messages.push_back(ending.message);
    if (!result.computed.unsolved.empty()) return;
    result.content = whole_content(input, result.computed);
    result.report = printed(input, result.computed, false);
    result.warnings = with_names(all_warnings(input, result.computed));
    hold_all(result, *result.content);
  });
}

void check_into(HeldResult& result, const std::function<Case()>& read) {
  guarded(result, [&] {
    const Case& input = result.input.emplace(read());
    result.report = derived_of(input);
    if (!input.dry) result.warnings = with_names(foreseen_warnings(input));
    results::Content content;
    content.title = input.title;
    content.deck = deck::effective_deck(input.deck);
    content.scales = numbers::scale_quantities(input);
    content.grid = input.scene.grid;
    hold_all(result, content);
  });
}

void open_into(HeldResult& result, const std::string& path, std::optional<std::size_t> number) {
  guarded(result, [&] {
    const std::lock_guard lock(files);
    const results::ResultFile file(path, number);
    hold_below(result, file, "/");
    // The contact's, and those of each effect: /summary/friction_warnings.
    for (const HeldEntry& held : result.entries)
      if (held.entry.path.starts_with("/summary/") && held.entry.path.ends_with("warnings"))
        for (std::string& line : lines_of(held.entry.text)) result.warnings.push_back(std::move(line));
    const HeldEntry* converged = found(result, numbers::path_of(id::converged));
    const HeldEntry* in_time = found(result, numbers::path_of(id::completed));
    const HeldEntry* why = found(result, numbers::path_of(id::failed_check));
    if (converged == nullptr || converged->values == nullptr)
      throw core::FileError(path + ": the file is damaged: it does not state whether it converged");
    if (*converged->values != 1.0) {
      result.status = not_converged;
      result.messages.push_back("not converged: " + (why ? why->entry.text : std::string("the reason is unknown")));
    } else if (in_time != nullptr && in_time->values != nullptr && *in_time->values != 1.0) {
      result.status = not_converged;
      const HeldEntry* ended = found(result, numbers::path_of(id::ended));
      result.messages.push_back("the run in time is not complete" + (ended ? ": " + ended->entry.text : std::string()));
    }
  });
}

int save(HeldResult& result, const std::string& path, bool overwrite) {
  if (!result.content) {
    result.messages.push_back(path + ": there is no result of a run to write");
    return wrong_input;
  }
  HeldResult outcome;  // a copy, so that writing changes nothing in the result
  guarded(outcome, [&] {
    if (const std::string why = unfit_as_result(path); !why.empty()) throw core::InputError(why);
    const std::lock_guard lock(files);
    results::check_files(result.input ? files_of(*result.input) : std::vector<std::string>{},
                         result_outputs(path, overwrite, 0));
    results::write(path, *result.content, overwrite);
  });
  for (std::string& message : outcome.messages) result.messages.push_back(std::move(message));
  return outcome.status;
}

}  // namespace ehl::program
