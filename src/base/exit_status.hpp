#pragma once
namespace ehl::program {

/// The exit statuses of the program; they are listed only here.
enum ExitStatus : int {
  solved = 0,
  internal_failure = 1,
  wrong_input = 2,
  not_converged = 3,
  file_trouble = 4,
  interrupted = 130,
};

}  // namespace ehl::program
