#pragma once
// Reads the source tree as text: the dependency list and the includes.
#include <filesystem>
#include <string>
#include <vector>

namespace house {

struct Module {
  std::string name;
  std::vector<std::string> depends;
};

/// The ehl_add_module(...) calls of a CMake file, in order; comments are ignored.
std::vector<Module> read_modules(const std::string& cmake_text);

struct Include {
  int line = 0;
  std::string path;     ///< between the quotes or brackets
  bool quoted = false;  ///< "..." rather than <...>
};

/// The #include lines of a source file.
std::vector<Include> read_includes(const std::string& source_text);

struct SourceFile {
  std::filesystem::path path;  ///< relative to the root
  std::string owner;           ///< modules/<owner>/..., with two folders in effects/; "src" or "tests"
  std::string text;
};

/// All C++ files below a folder of the root, in alphabetical order. The owner is the module of a file below modules/
/// ("mlmi", "effects/subsurface"), otherwise the top folder.
std::vector<SourceFile> read_sources(const std::filesystem::path& root, const std::string& folder);

// Each of the following returns one line per offence: file, line, what is wrong.

/// Dependencies that are not declared before the module that names them.
std::vector<std::string> order_offences(const std::vector<Module>& modules);
/// Quoted includes of modules that the owner does not declare. src and tests may include every module.
std::vector<std::string> include_offences(const std::vector<Module>& modules, const std::vector<SourceFile>& files);
/// Effects that a module below them includes or depends on, and modules declared after an effect.
std::vector<std::string> effect_offences(const std::vector<Module>& modules, const std::vector<SourceFile>& files);
/// Includes from a folder of src/ into a higher one: from top to bottom main.cpp, commands, page, tables, run,
/// report, case, base.
std::vector<std::string> wing_offences(const std::vector<SourceFile>& files);
/// Headers of a library included by modules that may not use it.
std::vector<std::string> door_offences(const std::vector<SourceFile>& files);

/// Files of modules/ that implement a part of the discrete Reynolds operator outside its homes, one path each: rows,
/// weights of the wedge, means of epsilon between nodes.
std::vector<std::string> operator_offences(const std::vector<SourceFile>& files, const std::vector<std::string>& homes);

/// True if the word occurs on its own, and not as a part of a longer one.
bool has_word(const std::string& text, const std::string& word);
std::string read_text(const std::filesystem::path& path);
/// The number of lines.
int line_count(const std::string& text);

}  // namespace house
