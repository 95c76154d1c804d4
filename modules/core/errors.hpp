#pragma once
// Errors to which a caller can react. A solution that does not converge is a result, not an exception.
#include <stdexcept>
#include <string>
#include <vector>

namespace ehl::core {

/// The input is wrong. Every message says where (file:line or command line), what was given and what is allowed.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& message) : InputError(std::vector<std::string>{message}) {}
  explicit InputError(std::vector<std::string> messages);
  const std::vector<std::string>& messages() const { return messages_; }

 private:
  std::vector<std::string> messages_;
};

/// A file could not be read or written. The message names the file, the attempt and the reason.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The numbers are outside the range of the method: a non-finite value or a zero pivot.
class SolverError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The user asked to stop (Ctrl-C); thrown between cycles, never inside one.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

}  // namespace ehl::core
