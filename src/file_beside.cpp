#include "file_beside.hpp"

#include <filesystem>
#include <system_error>

namespace ehl::program {

std::string found_beside(const std::string& file, const std::string& deck) {
  namespace files = std::filesystem;
  std::error_code error;
  if (files::exists(file, error)) return file;
  const files::path beside = files::path(deck).parent_path() / file;
  return files::exists(beside, error) ? beside.string() : file;
}

}  // namespace ehl::program
