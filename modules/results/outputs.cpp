#include "results/outputs.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "results/atomic_file.hpp"
#include "results/collection.hpp"
#include "results/content.hpp"
#include "results/hdf5_handle.hpp"

namespace ehl::results {
namespace {

namespace files = std::filesystem;

std::string beginning_of(const std::string& path) {
  constexpr std::streamsize most = 4096;
  std::string text(most, '\0');
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw core::FileError(path + ": cannot be read: " + std::strerror(errno));
  file.read(text.data(), most);
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

// Attribute `format` of an HDF5 file; empty if there is none or it cannot be read.
std::string format_of(const std::string& path) try {
  const QuietErrors quiet;
  return text_attribute(open_hdf5(path), "/", "format");
} catch (const core::FileError&) {
  return {};
}

bool is_picture(const std::string& text) {
  for (const std::string_view start : {"\x89PNG", "GIF8", "%PDF"})
    if (text.starts_with(start)) return true;
  return text.find("<svg") != std::string::npos;
}

bool is_page(const std::string& path, const std::string& start) {
  // A page names its writer at its end.
  if (!start.starts_with("<!DOCTYPE html>")) return false;
  std::ifstream file(path, std::ios::binary);
  std::string line;
  while (std::getline(file, line))
    if (line.find("Page written by ehl ") != std::string::npos) return true;
  return false;
}

bool is_same(const std::string& one, const std::string& other) {
  std::error_code error;
  if (files::exists(one, error) && files::exists(other, error)) return files::equivalent(one, other, error);
  const files::path path = files::weakly_canonical(one, error);
  return !path.empty() && path == files::weakly_canonical(other, error);
}

}  // namespace

std::string foreign_to(FileKind kind, const std::string& path) {
  std::error_code error;
  if (!files::is_regular_file(path, error) || files::file_size(path, error) == 0) return {};
  const auto unless = [](bool good, const char* why) { return good ? std::string() : std::string(why); };
  switch (kind) {
    case FileKind::result: return unless(format_of(path) == result_format, "is not a result of ehl");
    case FileKind::kept_results:
      return unless(format_of(path) == collection_format, "does not contain the stored results of a sweep");
    default: break;
  }
  const std::string text = beginning_of(path);
  switch (kind) {
    case FileKind::xdmf: return unless(text.find("<Xdmf") != std::string::npos, "is not an XDMF file");
    case FileKind::table:
      return unless(
          text.starts_with("# ehl sweep") || text.starts_with("# ehl study") || text.starts_with("# ehl asperities"),
          "is not a table of `ehl sweep`, `ehl study` or `ehl asperities`");
    case FileKind::page: return unless(is_page(path, text), "is not a page of `ehl report`");
    default: return unless(is_picture(text), "is not a picture");
  }
}

void check_files(const std::vector<std::string>& inputs, const std::vector<Output>& outputs) {
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    const Output& output = outputs[k];
    for (const std::string& input : inputs)
      if (!output.path.empty() && is_same(output.path, input))
        throw core::FileError(output.path + ": cannot be written: it is read by this run (" + input +
                              "): give another --output");
    for (std::size_t other = 0; other < k; ++other)
      if (is_same(output.path, outputs[other].path))
        throw core::FileError(output.path + ": cannot be written: it is the same file as " + outputs[other].path +
                              ", which this run writes too");
  }
  for (const Output& output : outputs) {
    if (const std::string why = foreign_to(output.kind, output.path); !why.empty())
      throw core::FileError(output.path + ": already exists and " + why +
                            ", so it is not overwritten: move it away, or give another --output");
    check_writable(output.path, output.overwrite, output.bytes);
  }
}

}  // namespace ehl::results
