#include "core/errors.hpp"

namespace ehl::core {
namespace {
std::string joined(const std::vector<std::string>& messages) {
  std::string text;
  for (const std::string& message : messages) text += (text.empty() ? "" : "\n") + message;
  return text;
}
}  // namespace

// An error without a message would go unnoticed where messages are collected.
InputError::InputError(std::vector<std::string> messages)
    : std::runtime_error(joined(messages)), messages_(std::move(messages)) {
  if (messages_.empty())
    messages_.emplace_back("the input is wrong, but the program gave no reason: please report this");
}

}  // namespace ehl::core
