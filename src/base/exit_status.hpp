#pragma once
namespace ehl::program {

/// What the program tells the shell: the one list.
enum ExitStatus : int {
  solved = 0,
  internal_failure = 1,
  wrong_input = 2,
  not_converged = 3,
  file_trouble = 4,
  interrupted = 130,
};

}  // namespace ehl::program
