#pragma once
// Maps in the binary format of Digital Surf (MountainsMap), .sur.
#include <string>

#include "case/map_file.hpp"

namespace ehl::program {

/// The heights of a .sur: a header of 512 bytes, a comment and a private zone whose lengths the header states, then the
/// heights line by line along x as integers of 16 or 32 bits; all little endian.
///   height = integer * Z spacing in the unit of the Z step; the offset of all heights is left out, as levelling takes
///   it away; an integer of Zmin - 2 is a missing point if the header says that there are special points.
/// in: the bytes of the file; its name for messages. out: heights with missing points as NaN, and what the header
/// states of units and distances. limits: one surface per file, not compressed, not inverted, in the byte order of PCs;
/// other files are refused with what to do. source: the fields of the header as RosettaSciIO (rsciio/digitalsurf) and
/// Gwyddion (surffile) document them.
ReadHeights read_map_sur(const std::string& bytes, const std::string& name);

}  // namespace ehl::program
