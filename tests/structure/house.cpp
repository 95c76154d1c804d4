#include "structure/house.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>

namespace house {
namespace {

namespace fs = std::filesystem;

bool contains(const std::vector<std::string>& list, const std::string& word) {
  return std::ranges::find(list, word) != list.end();
}

std::string without_comments(const std::string& cmake_text) {
  std::istringstream lines(cmake_text);
  std::string text;
  for (std::string line; std::getline(lines, line);) text += line.substr(0, line.find('#')) + '\n';
  return text;
}

constexpr std::string_view effects_folder = "effects/";

// The module of a path below modules/: its first folder, or for an effect its first two.
std::string module_of(const std::string& path) {
  const std::size_t from = path.starts_with(effects_folder) ? effects_folder.size() : 0;
  return path.substr(0, path.find('/', from));
}

// A library, the beginning of its header names, the modules that may include it and, if given, the files.
struct Door {
  std::string library;
  std::vector<std::string> prefixes;
  std::vector<std::string> owners;
  std::vector<std::string> files = {};
  bool open_to(const SourceFile& file) const {
    return contains(owners, file.owner) && (files.empty() || contains(files, file.path.generic_string()));
  }
  std::string name() const { return files.empty() ? owners.front() : files.front(); }
};

std::vector<Door> doors() {
  return {
      {"Boost.Program_options",
       {"boost/program_options"},
       {"deck", "src"},
       {"modules/deck/document.cpp", "src/commands/arguments.cpp"}},
      {"nlohmann-json", {"nlohmann/"}, {"src"}},
      {"HDF5", {"hdf5", "H5"}, {"results"}},
      {"SUNDIALS",
       {"sundials/", "kinsol/", "ida/", "idas/", "cvode/", "arkode/", "nvector/", "sunlinsol/", "sunnonlinsol/",
        "sunmatrix/"},
       {"newton", "transient"},
       {"modules/newton/gmres.cpp", "modules/transient/ida.cpp"}},
      {"FFTW", {"fftw3"}, {"mlmi"}},
      {"Eigen",
       {"Eigen/", "unsupported/Eigen/"},
       {"mlmi", "newton", "multigrid"},
       {"modules/mlmi/fourier_transform_eigen.cpp", "modules/newton/preconditioner.cpp",
        "modules/newton/line_factors.hpp", "modules/newton/line_factors.cpp", "modules/multigrid/acceleration.cpp"}},
  };
}

}  // namespace

std::string read_text(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

int line_count(const std::string& text) { return static_cast<int>(std::ranges::count(text, '\n')); }

std::vector<Module> read_modules(const std::string& cmake_text) {
  std::vector<Module> modules;
  const std::string text = without_comments(cmake_text);
  const std::string call = "ehl_add_module(";
  for (std::size_t at = text.find(call); at != std::string::npos; at = text.find(call, at + 1)) {
    const std::size_t begin = at + call.size();
    std::istringstream words(text.substr(begin, text.find(')', begin) - begin));
    Module module;
    words >> module.name;
    std::string section;
    for (std::string word; words >> word;) {
      if (word == "SOURCES" || word == "DEPENDS" || word == "LIBRARIES") {
        section = word;
      } else if (section == "DEPENDS") {
        module.depends.push_back(word);
      }
    }
    modules.push_back(module);
  }
  return modules;
}

std::vector<Include> read_includes(const std::string& source_text) {
  std::vector<Include> includes;
  std::istringstream lines(source_text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::erase_if(line, [](char c) { return c == ' ' || c == '\t'; });
    if (!line.starts_with("#include")) continue;
    const std::size_t open = line.find_first_of("\"<");
    if (open == std::string::npos) continue;
    const std::size_t close = line.find_first_of("\">", open + 1);
    includes.push_back({number, line.substr(open + 1, close - open - 1), line[open] == '"'});
  }
  return includes;
}

bool has_word(const std::string& text, const std::string& word) {
  const auto in_word = [&](std::size_t at) {
    return at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '_');
  };
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    if (!in_word(at + word.size()) && (at == 0 || !in_word(at - 1))) return true;
  }
  return false;
}

std::vector<SourceFile> read_sources(const fs::path& root, const std::string& folder) {
  std::vector<SourceFile> files;
  if (!fs::exists(root / folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
    const fs::path extension = entry.path().extension();
    if (!entry.is_regular_file() || (extension != ".cpp" && extension != ".hpp")) continue;
    SourceFile file;
    file.path = fs::relative(entry.path(), root);
    file.owner = folder == "modules" ? module_of(fs::relative(file.path, folder).generic_string()) : folder;
    file.text = read_text(entry.path());
    files.push_back(file);
  }
  std::ranges::sort(files, {}, &SourceFile::path);
  return files;
}

std::vector<std::string> order_offences(const std::vector<Module>& modules) {
  std::vector<std::string> offences, above;
  for (const Module& module : modules) {
    for (const std::string& dependency : module.depends) {
      if (!contains(above, dependency))
        offences.push_back(module.name + " depends on " + dependency + ", which is not declared above it");
    }
    if (contains(above, module.name)) offences.push_back(module.name + " is declared twice");
    above.push_back(module.name);
  }
  return offences;
}

bool is_effect(const std::string& module) { return module.starts_with(effects_folder); }

std::vector<std::string> effect_offences(const std::vector<Module>& modules, const std::vector<SourceFile>& files) {
  std::vector<std::string> offences;
  bool among_effects = false;
  for (const Module& module : modules) {
    if (is_effect(module.name)) {
      among_effects = true;
      continue;
    }
    if (among_effects) offences.push_back(module.name + " is declared behind an effect: the effects come last");
    for (const std::string& dependency : module.depends)
      if (is_effect(dependency)) offences.push_back(module.name + " depends on " + dependency + ", an effect");
  }
  for (const SourceFile& file : files) {
    if (is_effect(file.owner) || file.path.generic_string().find("modules/") != 0) continue;
    for (const Include& include : read_includes(file.text))
      if (include.path.starts_with(effects_folder))
        offences.push_back(file.path.string() + ":" + std::to_string(include.line) + " includes " + include.path +
                           ": no module below the effects knows one of them");
  }
  return offences;
}

std::vector<std::string> include_offences(const std::vector<Module>& modules, const std::vector<SourceFile>& files) {
  std::vector<std::string> offences;
  for (const SourceFile& file : files) {
    const auto owner = std::ranges::find(modules, file.owner, &Module::name);
    const bool is_module = owner != modules.end();
    for (const Include& include : read_includes(file.text)) {
      if (!include.quoted) continue;
      const std::string target = module_of(include.path);
      const bool names_module = std::ranges::find(modules, target, &Module::name) != modules.end();
      const bool allowed = is_module ? target == file.owner || contains(owner->depends, target)
                                     : names_module || file.owner == "src" || file.owner == "tests";
      if (!allowed) {
        offences.push_back(file.path.string() + ":" + std::to_string(include.line) + " includes " + include.path +
                           ", which " + file.owner + " does not declare");
      }
    }
  }
  return offences;
}

std::vector<std::string> wing_offences(const std::vector<SourceFile>& files) {
  const std::vector<std::string> wings = {"base",   "case", "report",  "run",
                                          "tables", "page", "commands"};  // from the lowest to the highest
  const auto height = [&](const std::string& path) {
    return std::ranges::find(wings, path.substr(0, path.find('/'))) - wings.begin();
  };
  std::vector<std::string> offences;
  for (const SourceFile& file : files) {
    const std::string inside = file.path.lexically_relative("src").generic_string();
    for (const Include& include : read_includes(file.text))
      if (std::ranges::find(wings, module_of(include.path)) != wings.end() && height(include.path) > height(inside))
        offences.push_back(file.path.string() + ":" + std::to_string(include.line) + " includes " + include.path +
                           ", a wing above it");
  }
  return offences;
}

std::vector<std::string> door_offences(const std::vector<SourceFile>& files) {
  std::vector<std::string> offences;
  for (const SourceFile& file : files) {
    for (const Include& include : read_includes(file.text)) {
      for (const Door& door : doors()) {
        const bool matches = std::ranges::any_of(
            door.prefixes, [&](const std::string& prefix) { return include.path.starts_with(prefix); });
        if (matches && !door.open_to(file)) {
          offences.push_back(file.path.string() + ":" + std::to_string(include.line) + " includes " + include.path +
                             "; the door to " + door.library + " is " + door.name());
        }
      }
    }
  }
  return offences;
}

}  // namespace house
