#include "base/failure.hpp"

#include <exception>
#include <filesystem>
#include <ios>
#include <new>

#include "base/exit_status.hpp"
#include "core/errors.hpp"

namespace ehl::program {

Failure current_failure() try { throw; } catch (const core::InputError& error) {
  return {wrong_input, error.messages()};
} catch (const core::FileError& error) {
  return {file_trouble, {error.what()}};
} catch (const core::SolverError& error) {
  return {not_converged, {std::string("not converged: ") + error.what()}};
} catch (const core::Interrupted&) {
  return {interrupted, {"interrupted: nothing was written"}};
} catch (const std::filesystem::filesystem_error& error) {
  return {file_trouble, {error.what()}};
} catch (const std::ios_base::failure& error) {
  return {file_trouble, {std::string("a file could not be read or written: ") + error.what()}};
} catch (const std::bad_alloc&) {
  return {internal_failure, {"out of memory: use fewer cells (`ehl check` estimates the need)"}};
} catch (const std::exception& error) {
  return {internal_failure, {std::string("internal failure: ") + error.what()}};
}

}  // namespace ehl::program
