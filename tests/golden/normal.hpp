#pragma once
// The normal form of a printed text: what depends on rounding, speed, machine, version or folder is a placeholder.
#include <string>
#include <vector>

namespace golden {

/// Which numbers of a text are compared.
enum class Numbers {
  kept,     ///< all but times, "in 0.3 s": the command computes nothing
  replaced  ///< none but counts of nodes, "65 x 65", and lines of a file, "d.ini:17": the command computes
};

/// A folder or the processor, and the placeholder that stands for it.
struct Place {
  std::string path;
  std::string name;
};

/// The normal form of a text, in this order:
/// 1. The path of a folder is its name in capital letters, as in FOLDER/point.h5; the name of the processor is MACHINE.
/// 2. A date is DATE, a commit COMMIT, a compiler COMPILER, the program's version VERSION, the hash of a deck HASH, the
///    processor MACHINE, its level LEVEL, and the number of threads N. Lines of progress, which only slow runs print,
///    are left out.
/// 3. With Numbers::replaced, every number is "#", its sign included, and the spaces beside it are one, so that the
///    width of a column does not matter. A number is kept if it is joined to a letter (2U, Sq1, 1/Pa), a power (H^2),
///    is a count of nodes (65 x 65), or is the line of a file (d.ini:17). The words nan and inf are no numbers, and
///    stay.
std::string normal(std::string text, Numbers numbers, const std::vector<Place>& places);

}  // namespace golden
