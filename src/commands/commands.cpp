// The list of commands, the short commands, and the functions that several commands share.
#include "commands/commands.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "base/exit_status.hpp"
#include "base/machine.hpp"
#include "base/signals.hpp"
#include "case/catalogue.hpp"
#include "commands/figures.hpp"
#include "core/errors.hpp"
#include "core/processor_level.hpp"
#include "deck/write.hpp"
#include "tables/csv.hpp"

namespace ehl::program {
namespace {

const Option set{"set", "section.key=value", "overrides or adds a key of the deck", true};
const Option unset{"unset", "section.key", "takes a key out of the deck, as if it were not there", true};
const Option threads{"threads", "N", "number of threads (default: the cores this process may use)"};
const Option profile{"profile", "", "adds where the time went, part by part"};
const Option as_json{"json", "", "one JSON object on stdout and nothing else"};
const Option quiet{"quiet", "", "no progress"};

const Command run_command{"run",
                          "DECK",
                          "solves a case: table and summary on stdout, progress on stderr, result in an HDF5 file",
                          {set,
                           unset,
                           {"output", "FILE.h5", "result file (default: [output] file, else the name of the deck)"},
                           {"overwrite", "", "replace an existing result file"},
                           threads,
                           profile,
                           as_json,
                           quiet},
                          run};

const Command sweep_command{
    "sweep",
    "DECK|TABLE...",
    "solves many cases of one deck, several at a time: one row per case in a CSV table. The same command again goes on "
    "where it was stopped, and with more values beyond",
    {{"vary", "section.key=LIST",
      "a key and its values: 2,5,10 or a:b:n or a:b:n:log or words; several --vary make all combinations, the first "
      "varies slowest; keys that change together: a,b=1:2,3:4",
      true},
     {"cases", "FILE.csv",
      "the cases of a table: a line of keys, section.key between commas, a line of values for each"},
     {"shard", "i/N",
      "the part i of N alone, of nearly the same seconds, into NAME.iofN.csv (default: of a job of a Slurm array its "
      "own)"},
     {"merge", "", "makes one table, --output, of the tables of shards"},
     {"keep", "",
      "keeps the result of each case, fields and all, in one HDF5 file beside the table, /cases/K: `ehl extract --case "
      "K`"},
     {"timing", "", "adds the columns seconds and peak_memory, which are others each time"},
     set,
     unset,
     {"output", "FILE.csv", "the table (default: name of the deck with _sweep.csv)"},
     {"overwrite", "", "begin the table anew"},
     {"threads", "N", "cases at a time, one thread each (default: the cores this process may use)"},
     quiet},
    sweep};

const Command study_command{
    "study",
    "DECK",
    "what accuracy costs in time: the same case over levels, wedge schemes, film evaluators and cycles; error against "
    "seconds and work, as a table and a CSV file that `ehl plot` draws. A deck with [transient]: over the tolerance of "
    "the time integration, error over the run against seconds and steps",
    {{"levels", "a:b",
      "cells of the coarsest and of the finest grid, b = a times a power of two (default: from 64 up to the deck's)"},
     {"wedges", "LIST", "of upstream1,upstream2,upstream3, the last with face logmean_bounded (default: all)"},
     {"evaluators", "LIST", "of mlmi4,mlmi6,mlmi8,fft,direct (default: all; direct up to 20000 nodes)"},
     {"cycles", "LIST",
      "cycles per level, e.g. 1V,2W, or run: as `ehl run` does (default: 1V,2V,1W,2W,run; with heat run)"},
     {"reference", "N",
      "cells of the grid that the reference is extrapolated from, with those below it (default: twice the finest)"},
     {"rtol", "LIST",
      "of a deck with [transient] and instead of all the above: the tolerances (default: 1e-2,1e-3,1e-4,1e-5,1e-6)"},
     set,
     unset,
     {"output", "FILE.csv", "the table (default: name of the deck with _study.csv)"},
     {"overwrite", "", "replace an existing table"},
     {"repeat", "N", "solve everything N times and take the least time (default 3)"},
     {"threads", "N", "number of threads of each solution (default 1)"},
     {"jobs", "N", "solutions at a time (default 1); with more the times are marked as shared"},
     quiet},
    study};

const Command fit_command{
    "fit",
    "DECK",
    "constants of an oil from a measured traction curve: the deck's friction at the measured slide-roll ratios, by "
    "least "
    "squares, with the standard errors of the constants",
    {{"measured", "FILE.csv",
      "a table with the columns srr, mu and, where it is known, sigma, the standard error of mu; a heading may name "
      "their units, SRR [%]"},
     {"free", "section.key",
      "a constant to be found, e.g. shear.tau_0, shear.G, shear.n, friction.limit; the deck has its start; three at "
      "most",
      true},
     set,
     unset,
     {"threads", "N", "cases at a time, one thread each (default: the cores this process may use)"},
     quiet},
    fit};

const Command extract_command{
    "extract",
    "FILE.h5 DATASET",
    "prints a dataset of a result as columns: P, H, levels, history, summary, scales, deck, or a path in the file",
    {{"case", "K", "of a sweep with --keep: the case, from 0 in the order of the table"},
     {"along", "x|y", "only the section of a field along this axis"},
     {"at", "y=0|x=0", "where the section lies: the nearest grid line is taken (default 0)"},
     {"step", "K|last", "number K, from 0, of fields at several times or depths; without it a section of all"},
     {"sample", "N", "a field or a section between its nodes: N points along x (a section: along it), cubic"},
     {"window", "x0:x1[,y0:y1]", "the part of the domain that --sample takes (a section: one range)"},
     {"si", "", "of a deck in SI: places in um, films in nm, pressures in GPa, times in ms, --at likewise"},
     {"matrix", "", "a field as a matrix with its axes, for gnuplot's `matrix nonuniform`"}},
    extract};

const Command plot_command{
    "plot",
    "FILE.h5|FILE.csv",
    "draws the figures of postprocess/ from a result or the table of a sweep or a study, beside it",
    {{"figure", "NAME", "only this figure; they are listed below (default: all that fit and are not on demand)", true},
     {"x", "KEY", "of a sweep: the column along x (default: the swept key with most values)"},
     {"y", "QUANTITY", "of a sweep: a column against it, with error bars and formulas (default: the films)", true},
     {"by", "KEY", "of a sweep: one curve for each value of this column (default: the other swept keys)", true},
     {"axes", "log|linear", "of a sweep's curves (default: log where the values span a factor of 4)"},
     {"measured", "FILE.csv", "of a traction curve: measured points over it, as `ehl fit` reads them"},
     {"time", "T", "of a run in time the field nearest to T, in the unit of the deck's times (default: the last one)"},
     {"format", "png|svg|pdf", "format of the pictures (default: png, or what --output says)"},
     {"width", "W",
      "85mm, 1200px, or a column of a journal (Elsevier's): single (90 mm), onehalf (140 mm), double (190 mm); letters "
      "have 8 pt. Default: the figure's own, single mostly; png has 300 dots per inch"},
     {"title", "TEXT", "words above the figure, none where empty (default: the title of the deck)"},
     {"output", "NAME",
      "the picture, fig3.pdf; of several figures what their names begin with, fig3_centre_lines.pdf; a folder, figs/, "
      "takes names of our own (default: FILE_FIGURE.png beside the file)"}},
    plot};

}  // namespace

const std::vector<Command>& commands() {
  static const std::vector<Command> all{
      run_command,
      {"check",
       "DECK",
       "validates a deck and prints everything that follows from it; solves nothing",
       {set, unset, threads},
       check},
      {"resume",
       "FILE.h5",
       "goes on with a run in time from the checkpoint in its result file, and completes that file",
       {threads, profile, as_json, quiet},
       resume},
      sweep_command,
      study_command,
      fit_command,
      extract_command,
      plot_command,
      {"report",
       "FILE.h5|TABLE.csv...",
       "one HTML page of results and tables of sweeps and studies: figures, numbers with error bars, warnings, deck, "
       "provenance. It needs no network; several files are compared",
       {{"output", "FILE.html", "the page (default: FILE_report.html beside the first file)"},
        {"title", "TEXT", "heading of the page (default: the title of the deck)"},
        {"overwrite", "", "replace an existing page"}},
       report},
      {"keys",
       "[SECTION[.KEY]]",
       "lists the keys of the deck: default, unit, range, meaning, source",
       {{"deck", "", "a complete commented deck instead"}},
       keys},
      {"help", "[COMMAND]", "what the commands do, or one of them and its options", {}, help},
      {"version", "", "version, commit, compiler, and what the numerics in use were compiled for", {}, version}};
  return all;
}

int keys(const Arguments& arguments) {
  const std::string selection = arguments.operands.empty() ? "" : arguments.operands[0];
  if (arguments.has("deck") && !selection.empty())
    refuse("`ehl keys --deck` writes the whole deck: leave " + selection + " out");
  print(arguments.has("deck") ? deck::commented_deck(catalogue()) : deck::list_keys(catalogue(), selection));
  return solved;
}

int help(const Arguments& arguments) {
  const std::string name = arguments.operands.empty() ? "" : arguments.operands[0];
  print(help_text(commands(), name) + (name == "plot" ? list_of_figures(figures_in(folder_of_scripts())) : ""));
  return solved;
}

int version(const Arguments&) {
  print(this_program() + ", for " + core::processor_level() + "\n");
  return solved;
}

int requested_threads(const Arguments& arguments) { return whole_number(arguments, "threads", usable_cores(), 1024); }

std::string table_name(const Arguments& arguments) {
  const std::string stem = std::filesystem::path(arguments.operands[0]).stem();
  const std::string path = arguments.value("output", stem + "_" + arguments.command + ".csv");
  if (!path.ends_with(".csv")) refuse("--output " + path + ": the table's name ends with .csv");
  return path;
}

void print(const std::string& text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) return;
  if (errno == EPIPE) end_by_closed_pipe();
  throw core::FileError(std::string("standard output: cannot be written: ") + std::strerror(errno));
}

}  // namespace ehl::program
