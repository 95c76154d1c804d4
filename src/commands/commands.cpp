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

const Option set{"set", "section.key=value", "replaces or adds a key of the deck", true};
const Option unset{"unset", "section.key", "removes a key from the deck", true};
const Option threads{"threads", "N", "number of threads (default: the cores available to this process)"};
const Option profile{
    "profile", "",
    "adds the time that each part of the solution took, and the tuned numbers that differ from their defaults"};
const Option as_json{"json", "", "writes one JSON object to stdout and nothing else"};
const Option quiet{"quiet", "", "shows no progress"};

const Command run_command{
    "run",
    "DECK",
    "solves a case. Writes tables and a summary to stdout, progress to stderr, and the result to an HDF5 file",
    {set,
     unset,
     {"output", "FILE.h5", "result file (default: [output] file, else the name of the deck)"},
     {"overwrite", "", "replaces an existing result file"},
     threads,
     profile,
     as_json,
     quiet},
    run};

const Command sweep_command{
    "sweep",
    "DECK|TABLE...",
    "solves many cases of one deck, several at a time, and writes one row per case to a CSV table. The same command "
    "continues a sweep that was stopped, and extends it if there are more values",
    {{"vary", "section.key=LIST",
      "varies a key over a list: 2,5,10 or a:b:n or a:b:n:log or words. Several --vary give all combinations; the "
      "first varies slowest. Keys varied together: a,b=1:2,3:4",
      true},
     {"cases", "FILE.csv",
      "takes the cases from a table: one line of keys, section.key separated by commas, then one line of values for "
      "each case"},
     {"shard", "i/N",
      "solves only part i of N parts of nearly equal run time, into NAME.iofN.csv (default: in a Slurm job array, the "
      "part of the job)"},
     {"merge", "", "joins the tables of shards into one table, --output"},
     {"keep", "",
      "stores the result of each case with its fields in one HDF5 file next to the table, as /cases/K: `ehl extract "
      "--case K`"},
     {"timing", "", "adds the columns seconds and peak_memory, which differ from run to run"},
     set,
     unset,
     {"output", "FILE.csv", "table to write (default: name of the deck with _sweep.csv)"},
     {"overwrite", "", "starts the table again from the first case"},
     {"threads", "N",
      "number of cases solved at a time, with one thread each (default: the cores available to this process)"},
     quiet},
    sweep};

const Command study_command{
    "study",
    "DECK",
    "measures what accuracy costs in time: solves the same case with several grids, wedge schemes, film evaluators and "
    "cycles, and writes error against seconds and work to a table and a CSV file for `ehl plot`. For a deck with "
    "[transient]: with several tolerances of the time integration, error over the run against seconds and steps",
    {{"levels", "a:b",
      "cells of the coarsest and of the finest grid, b = a times a power of two (default: from 64 up to those of the "
      "deck)"},
     {"wedges", "LIST",
      "subset of upstream1,upstream2,upstream3; upstream3 is used with face = logmean_bounded (default: all)"},
     {"evaluators", "LIST", "subset of mlmi4,mlmi6,mlmi8,fft,direct (default: all; direct up to 20000 nodes)"},
     {"cycles", "LIST",
      "cycles per level, e.g. 1V,2W, or run: those of `ehl run` (default: 1V,2V,1W,2W,run; with heat: run)"},
     {"reference", "N",
      "cells of the finest grid for the reference solution, which is extrapolated from it and the coarser grids "
      "(default: twice the finest)"},
     {"rtol", "LIST",
      "tolerances for a deck with [transient], instead of all options above (default: 1e-2,1e-3,1e-4,1e-5,1e-6)"},
     set,
     unset,
     {"output", "FILE.csv", "table to write (default: name of the deck with _study.csv)"},
     {"overwrite", "", "replaces an existing table"},
     {"repeat", "N", "solves every case N times and reports the shortest time (default 3)"},
     {"threads", "N", "number of threads of each solution (default 1)"},
     {"jobs", "N", "number of solutions at a time (default 1); if more, the times are marked as shared"},
     quiet},
    study};

const Command fit_command{
    "fit",
    "DECK",
    "fits constants of an oil to a measured traction curve: computes the deck's friction at the measured slide-roll "
    "ratios, and gives the least-squares constants with their standard errors",
    {{"measured", "FILE.csv",
      "table with the columns srr, mu and, if known, sigma, the standard error of mu; a heading may give units, SRR "
      "[%]"},
     {"free", "section.key",
      "constant to fit, e.g. shear.tau_0, shear.G, shear.n, friction.limit. The deck gives the starting value; at most "
      "three constants",
      true},
     set,
     unset,
     {"threads", "N",
      "number of cases solved at a time, with one thread each (default: the cores available to this process)"},
     quiet},
    fit};

const Command asperities_command{
    "asperities",
    "MAP",
    "presses a measured map on a smooth plane and lets oil flow through the gaps that remain: asperity pressure, "
    "area in contact and flow factors against the gap, as a table for `ehl plot`. Lengths and pressures are in SI "
    "units",
    {{"dx", "METRES", "distance between the points along x (default: that of the file)"},
     {"dy", "METRES", "distance between the points along y (default: that of the file, else dx)"},
     {"unit", "METRES", "height of the number 1 in the file (default: that of the file)"},
     {"dataset", "NAME", "dataset of a .h5 file (default: height)"},
     {"longest_wave", "METRES", "takes longer waves away, which belong to the form and not to the asperities"},
     {"shortest_wave", "METRES", "takes shorter waves away, e.g. the noise of the instrument"},
     {"E_prime", "PASCAL", "E' = 2/((1-nu1^2)/E1 + (1-nu2^2)/E2) of the two bodies (default: 226.4e9, steel on steel)"},
     {"hardness", "PASCAL", "largest pressure of an asperity, of the softer body (default: elastic)"},
     {"points", "N", "most points along each axis; a map with more is averaged over blocks (default 512)"},
     {"rows", "N", "number of mean pressures (default 13)"},
     {"output", "FILE.csv", "table to write (default: name of the map with _asperities.csv)"},
     {"overwrite", "", "replaces an existing table"},
     threads,
     quiet},
    asperities};

const Command extract_command{
    "extract",
    "FILE.h5 [DATASET]...",
    "prints datasets of a result as columns: P, H, levels, history, summary, scales, deck, or paths in the file; "
    "without "
    "a DATASET, a list of all. Two blank lines separate two datasets",
    {{"case", "K", "case of a sweep with --keep, counted from 0 in the order of the table"},
     {"along", "x|y", "prints only the section of a field along this axis"},
     {"at", "y=0|x=0", "position of the section; the nearest grid line is used (default 0)"},
     {"step", "K,...|last",
      "numbers of the fields, counted from 0, if there are several times or depths; without it the section of all"},
     {"sample", "N",
      "interpolates a field or a section between its nodes (cubic) at N points along x, or along the section"},
     {"window", "x0:x1[,y0:y1]", "part of the domain for --sample; one range for a section"},
     {"si", "",
      "uses SI units, for a deck in SI: positions (--at too) in um, films in nm, pressures in GPa, times in ms"},
     {"matrix", "", "prints a field as a matrix with its axes, for gnuplot's `matrix nonuniform`"},
     {"gnuplot", "PREFIX",
      "prints each dataset as a data block of gnuplot, $PREFIX_DATASET or, of several steps, $PREFIX_DATASET_K: load "
      "'< ehl extract FILE.h5 P H --gnuplot "
      "my'"}},
    extract};

const Command plot_command{
    "plot",
    "FILE.h5|FILE.csv",
    "draws the figures of postprocess/ from a result, or from the table of a sweep, a study or a map's asperities, and "
    "writes them next to that file",
    {{"figure", "NAME",
      "draws only this figure; the figures are listed below (default: all that fit and are not on demand)", true},
     {"x", "KEY", "sweep: column on the x axis (default: the swept key with most values)"},
     {"y", "QUANTITY", "sweep: column on the y axis, with error bars and formulas (default: the films)", true},
     {"by", "KEY", "sweep: one curve for each value of this column (default: the other swept keys)", true},
     {"axes", "log|linear", "sweep: scale of the axes (default: log if the values span a factor of 4)"},
     {"measured", "FILE.csv", "traction curve: overlays measured points, in the format of `ehl fit`"},
     {"time", "T",
      "run in time: draws the field nearest to time T, in the unit of the deck's times (default: the last one)"},
     {"format", "png|svg|pdf", "format of the pictures (default: png, or the ending of --output)"},
     {"width", "W",
      "width of the picture: 85mm, 1200px, or a journal column (Elsevier's): single (90 mm), onehalf (140 mm), double "
      "(190 mm). Letters have 8 pt; png has 300 dots per inch (default: that of the figure, usually single)"},
     {"title", "TEXT", "title above the figure; an empty text gives none (default: the title of the deck)"},
     {"output", "NAME",
      "picture to write, fig3.pdf. With several figures: beginning of their names, fig3_centre_lines.pdf. With a "
      "folder, figs/: the pictures get their default names (default: FILE_FIGURE.png next to the file)"}},
    plot};

}  // namespace

const std::vector<Command>& commands() {
  static const std::vector<Command> all{
      run_command,
      {"check",
       "DECK",
       "validates a deck and prints everything that follows from it, without solving",
       {set, unset, threads},
       check},
      {"resume",
       "FILE.h5",
       "continues a run in time from the checkpoint in its result file, and completes that file",
       {threads, profile, as_json, quiet},
       resume},
      sweep_command,
      study_command,
      fit_command,
      asperities_command,
      extract_command,
      plot_command,
      {"report",
       "FILE.h5|TABLE.csv...",
       "writes one HTML page of results and of tables of sweeps and studies: figures, numbers with error bars, "
       "warnings, deck, provenance. The figures need gnuplot. The page needs no network; several files are compared",
       {{"output", "FILE.html", "page to write (default: FILE_report.html next to the first file)"},
        {"title", "TEXT", "heading of the page (default: the title of the deck)"},
        {"overwrite", "", "replaces an existing page"}},
       report},
      {"keys",
       "[SECTION[.KEY]]",
       "lists the keys of the deck with default, unit, range, meaning and source",
       {{"deck", "", "writes a complete commented deck instead"}},
       keys},
      {"help", "[COMMAND]", "explains the commands, or one command with its options", {}, help},
      {"version",
       "",
       "prints version, commit, compiler, and the processor that the numerics in use were compiled for",
       {},
       version}};
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
  if (!path.ends_with(".csv")) refuse("--output " + path + ": the name of the table must end with .csv");
  return path;
}

void print(const std::string& text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) return;
  if (errno == EPIPE) end_by_closed_pipe();
  throw core::FileError(std::string("standard output: cannot be written: ") + std::strerror(errno));
}

}  // namespace ehl::program
