#include "hard/judge.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <sstream>

#include "support/json.hpp"
#include "support/temporary_folder.hpp"
#include "support/text.hpp"

namespace hard {
namespace {

constexpr double loose_residual = 2e-2;  // the tolerance of the program if the deck gives none
constexpr double loose_load_error = 1e-3;

using support::contains;

class Judge {
 public:
  Judge(std::uint64_t seed, const Setting& setting) : setting_(setting) {
    verdict_.seed = seed;
    verdict_.deck = random_deck(seed, setting.keys, setting.shares);
    folder_.write("d.ini", verdict_.deck.text);
    for (const File& file : verdict_.deck.files) folder_.write(file.name, file.text);
  }

  Verdict run(bool sampled) {
    const Finished checked = ehl(with_overrides({"check", "d.ini"}), "check");
    if (checked.status == 0 && nodes(checked.out) > setting_.most_nodes) {
      verdict_.end = End::too_large;
      return verdict_;
    }
    const std::string threads = std::to_string(verdict_.deck.threads);
    const Finished ran = ehl(solving("r.h5", threads), "run");
    verdict_.seconds = ran.seconds;
    if (ran.hung || ran.signal != 0) return verdict_;
    verdict_.groups = json_member(ran.out, "M") + ", " + json_member(ran.out, "L");
    if (ran.status == 0) judge_solved(ran);
    if (ran.status == 2) judge_refused(ran, checked.status == 0);
    if (ran.status == 3) judge_not_converged(ran);
    if (ran.status == 4) judge_unreadable(ran);
    expect(ran.status == 0 || (ran.status >= 2 && ran.status <= 4),
           "run ends with 0, 2, 3 or 4, not " + std::to_string(ran.status) + ": " + ran.err);
    expect(ran.status == 2 || ran.status == 4 || checked.status == 0, "check takes what run takes: " + checked.err);
    if (sampled && ran.status == 0) {
      read_back(ran);
      repeat_on_other_threads(ran);
    }
    if (sampled && (ran.status == 0 || ran.status == 3)) read_reports();
    return verdict_;
  }

 private:
  void expect(bool holds, const std::string& what) {
    if (!holds) verdict_.faults.push_back(what);
  }

  std::vector<std::string> with_overrides(std::vector<std::string> words) const {
    for (const std::string& text : verdict_.deck.overrides) words.insert(words.end(), {"--set", text});
    return words;
  }

  std::vector<std::string> solving(const std::string& result, const std::string& threads) const {
    return with_overrides({"run", "d.ini", "--json", "--quiet", "--threads", threads, "--output", result});
  }

  // Runs the program, and checks what must hold for every run.
  Finished ehl(std::vector<std::string> words, const std::string& name) {
    words.insert(words.begin(), setting_.program);
    const Finished ended = run_program(words, folder_.path(), setting_.environment, setting_.limit);
    if (ended.hung) verdict_.end = End::hung;
    if (ended.signal != 0) verdict_.end = End::crashed;
    expect(!ended.hung, name + " ends within " + std::to_string(setting_.limit) + " s");
    expect(ended.signal == 0, name + " ends by itself, not by signal " + std::to_string(ended.signal));
    for (const char* sign : {"Sanitizer", "runtime error:", "terminate called"})
      expect(!contains(ended.err, sign), name + " is clean: " + ended.err);
    if (name == "check") expect_numbers(name, ended.out);
    return ended;
  }

  // No "nan", "-nan" or "inf" where a number should be; unless the deck itself has such a word, which is repeated.
  void expect_numbers(const std::string& name, const std::string& text) {
    if (!no_number_in(verdict_.deck.text + joined_overrides()).empty()) return;
    const std::string found = no_number_in(text);
    expect(found.empty(), name + " shows numbers only, and not: " + found);
  }

  // The report as text, the page and the row of a sweep.
  void read_reports() {
    const std::vector<std::string> run{"run", "d.ini", "--quiet", "--threads", "1", "--output", "text.h5"};
    expect_numbers("the report", ehl(with_overrides(run), "run").out);
    const Finished page = ehl({"report", "text.h5", "--output", "page.html"}, "report");
    expect(page.status == 0, "a page is made of the result: " + page.err);
    expect_numbers("the page", without_pictures(folder_.read("page.html")));
    const std::vector<std::string> sweep{
        "sweep", "d.ini", "--vary", "multigrid.max_cycles=40", "--quiet", "--threads", "1", "--output", "row.csv"};
    const Finished swept = ehl(with_overrides(sweep), "sweep");
    if (swept.status == 0) expect_numbers("the table", folder_.read("row.csv"));
  }

  static double nodes(const std::string& report) {
    const std::string label = "\ngrid         ";
    const std::size_t at = report.find(label);
    std::istringstream stream(at == std::string::npos ? "" : report.substr(at + label.size()));
    double nx = 0.0;
    double ny = 0.0;
    std::string by;
    stream >> nx >> by >> ny;
    return by == "x" ? nx * ny : nx;  // a line contact has one line of nodes
  }

  void judge_solved(const Finished& ran) {
    verdict_.end = End::solved;
    const auto value = [&](const char* name) { return number(json_member(ran.out, name)); };
    expect(support::is_json(ran.out), "solved: the output is JSON: " + ran.out);
    expect(json_member(ran.out, "converged") == "true", "solved: converged is true");
    take(faults_in_time(ran.out));
    take(faults_of_friction(ran.out));
    take(faults_of_starvation(ran.out));
    take(faults_of_heat(ran.out));
    verdict_.warnings = {json_member(ran.out, "warnings")};
    if (json_member(ran.out, "kind") == "dry") return take(faults_of_dry(ran.out));
    for (const char* name : {"Hc", "Hm", "Hc_moes", "Hm_moes", "P_max", "H00", "residual", "load_error", "lambda"})
      expect(std::isfinite(value(name)),
             std::string("solved: ") + name + " is a number: " + json_member(ran.out, name));
    // Hc is interpolated if (0,0) is no node, whereas Hm is the minimum over the nodes.
    constexpr double interpolation = 0.9;
    expect(value("Hm") > 0.0 && value("Hc") >= value("Hm") * interpolation,
           "solved: 0 < Hm <= Hc: " + json_member(ran.out, "Hm") + " and " + json_member(ran.out, "Hc"));
    expect(value("P_max") > 0.0, "solved: P_max > 0");
    expect(value("residual") <= loose_residual || asked_tolerance() > loose_residual,
           "solved: a small residual: " + json_member(ran.out, "residual"));
    expect(value("load_error") <= std::max(loose_load_error, asked_tolerance()),
           "solved: a small load error: " + json_member(ran.out, "load_error"));
    verdict_.Hc = value("Hc");
    if (const std::string told_Hc = json_member(ran.out, "formulas/0/Hc"); !told_Hc.empty())
      verdict_.formula_ratio = verdict_.Hc / number(told_Hc);
    // Without a warning the film is resolved and fully flooded, and the formula should be good to 15 %.
    constexpr double least_ratio = 0.7;
    constexpr double largest_ratio = 1.4;
    // The formula is printed for the shapes that it was made for; it does not account for a supply.
    const bool told = contains(ran.out, "Nijenbanning") && json_member(ran.out, "starvation").empty();
    const bool near_formula = !told || (verdict_.formula_ratio > least_ratio && verdict_.formula_ratio < largest_ratio);
    const bool smooth = !contains(ran.out, "\"name\":\"surfaces\"");
    expect(near_formula || json_member(ran.out, "warnings") != "[]" || !smooth,
           "solved without a warning: Hc near the published formula, not " + std::to_string(verdict_.formula_ratio) +
               " of it");
  }

  void take(const std::vector<std::string>& faults) {
    verdict_.faults.insert(verdict_.faults.end(), faults.begin(), faults.end());
  }

  // The tolerance that the case asks for; 0 if it asks for none.
  double asked_tolerance() const {
    double asked = 0.0;
    for (const std::string& text : {verdict_.deck.text, joined_overrides()})
      if (const std::size_t at = text.find("tolerance"); at != std::string::npos)
        asked = std::max(asked, number(text.substr(text.find_first_of("0123456789", at))));
    return asked;
  }

  std::string joined_overrides() const {
    std::string all;
    for (const std::string& text : verdict_.deck.overrides) all += text + "\n";
    return all;
  }

  // A refusal names the place and the key, in lines that a terminal can show.
  void judge_refused(const Finished& ran, bool check_took_it) {
    verdict_.end = End::refused;
    verdict_.reason = ran.err;
    expect(ran.out.empty(), "refused: nothing on standard output: " + ran.out);
    expect(!ran.err.empty(), "refused: a message");
    expect(!check_took_it, "refused: check says the same: " + ran.err);
    // The far field may be inapplicable although the domain is no shorter than the contact.
    const bool too_near = ran.err.find("closed far field does not hold") != std::string::npos;
    expect(!verdict_.deck.ordinary || too_near, "an ordinary deck is taken: " + ran.err);
    constexpr std::size_t longest_line = 1000;
    std::istringstream lines(ran.err);
    for (std::string line; std::getline(lines, line);) {
      const bool placed = line.starts_with("ehl: d.ini") || line.starts_with("ehl: command line: ");
      expect(placed, "refused: every message begins with its place: " + line);
      expect(line.size() <= longest_line, "refused: short lines, not " + std::to_string(line.size()) + " bytes");
      const bool shown = std::none_of(line.begin(), line.end(), [](unsigned char c) { return c < ' ' || c == 0x7f; });
      expect(shown, "refused: no control characters: " + line);
    }
    expect(!std::filesystem::exists(folder_ / "r.h5"), "refused: no result file");
  }

  // Judges the refusal of a file that the deck names.
  void judge_unreadable(const Finished& ran) {
    verdict_.end = End::refused;
    expect(contains(ran.err, ".csv") || contains(ran.err, "there is no such file"),
           "4: a file that cannot be read: " + ran.err);
    expect(!std::filesystem::exists(folder_ / "r.h5"), "4: no result file");
  }

  void judge_not_converged(const Finished& ran) {
    verdict_.end = End::not_converged;
    verdict_.reason = json_member(ran.out, "failed_check");
    expect(support::is_json(ran.out), "not converged: the output is JSON: " + ran.out);
    // The steady contact may be solved although the run in time failed.
    const bool in_time = json_member(ran.out, "transient/completed") == "false";
    if (in_time) verdict_.reason = json_member(ran.out, "transient/ended");
    expect(json_member(ran.out, "converged") == "false", "not converged: converged is false");
    expect(verdict_.reason.size() > 10, "not converged: a reason");
    expect(contains(ran.err, "not converged: "), "not converged: said on standard error: " + ran.err);
    if (!std::filesystem::exists(folder_ / "r.h5")) return;
    const Finished mark = ehl({"extract", "r.h5", in_time ? "transient_completed" : "converged"}, "extract");
    expect(mark.status == 0 && number(mark.out.substr(mark.out.find('\n') + 1)) == 0.0,
           "not converged: the result is marked: " + mark.out + mark.err);
  }

  // Checks the fields of the result file: as many numbers as nodes, all finite, and the largest P
  // is the P_max of the report.
  void read_back(const Finished& ran) {
    const Finished deck = ehl({"extract", "r.h5", "deck"}, "extract");
    folder_.write("own.ini", deck.out);
    const Finished checked = ehl({"check", "own.ini"}, "check");
    expect(checked.status == 0, "the deck in the result is a deck: " + checked.err + deck.out);
    const Finished mark = ehl({"extract", "r.h5", "converged"}, "extract");
    expect(mark.status == 0 && contains(mark.out, "1"), "the result is marked as converged: " + mark.out + mark.err);
    if (const std::string steps = json_member(ran.out, "transient/steps"); !steps.empty()) {
      const Finished rows = ehl({"extract", "r.h5", "transient"}, "extract");
      take(faults_of_rows(rows.out, number(steps)));
    }
    const Finished field = ehl({"extract", "r.h5", "P"}, "extract");
    expect(field.status == 0, "P can be read back: " + field.err);
    std::istringstream lines(field.out);
    double largest = 0.0;
    double least = 0.0;
    double count = 0.0;
    for (std::string line; std::getline(lines, line);) {
      if (line.empty() || line[0] == '#') continue;
      const double P = number(line.substr(line.rfind(' ')));
      expect(std::isfinite(P), "P is finite: " + line);
      largest = std::max(largest, P);
      least = std::min(least, P);
      ++count;
    }
    expect(count == nodes(checked.out), "P has " + std::to_string(count) + " values");
    expect(largest == number(json_member(ran.out, "P_max")), "P_max is the maximum of P: " + std::to_string(largest));
    expect(least == 0.0, "P is nowhere negative: " + std::to_string(least));
  }

  // Repeats the deck of the result with another number of threads: all digits must agree.
  void repeat_on_other_threads(const Finished& ran) {
    const std::string threads = verdict_.deck.threads == 1 ? "2" : "1";
    const Finished again =
        ehl({"run", "own.ini", "--json", "--quiet", "--threads", threads, "--output", "again.h5"}, "run");
    for (const char* name : {"Hc", "Hm", "P_max", "H00", "residual", "load_error", "least_Hm", "worst_load_error"})
      expect(json_member(again.out, name) == json_member(ran.out, name),
             std::string("the same ") + name + " of the deck in the result, on one thread and on two: " +
                 json_member(ran.out, name) + " and " + json_member(again.out, name));
  }

  const Setting& setting_;
  support::TemporaryFolder folder_;
  Verdict verdict_;
};

}  // namespace

Verdict judge(std::uint64_t seed, const Setting& setting, bool sampled) {
  try {
    return Judge(seed, setting).run(sampled);
  } catch (const std::exception& error) {
    Verdict verdict;
    verdict.seed = seed;
    verdict.faults.push_back(std::string("of the test itself: ") + error.what());
    return verdict;
  }
}

std::string json_member(const std::string& json, const std::string& path) {
  const nlohmann::json all = support::parsed(json);
  const nlohmann::json::json_pointer at("/" + path);
  if (!all.contains(at)) return "";
  return all[at].is_string() ? all[at].get<std::string>() : all[at].dump();
}

}  // namespace hard
