#pragma once
// Result files: HDF5, and an XDMF beside it for ParaView.
#include <cstddef>
#include <string>
#include <vector>

#include "results/content.hpp"

namespace ehl::results {

/// Bytes that a result takes, nearly.
std::size_t expected_bytes(const core::Grid& grid, std::size_t fields);

/// Name of the XDMF file that belongs to a result: R.h5 -> R.xmf.
std::string xdmf_name(const std::string& path);

/// Writes /deck, /provenance, /scales, /grid/{x,y}, /fields, /summary and the tables, each with unit and meaning as
/// attributes; fields are (row = y, column = x). Then the XDMF. Both appear whole or not at all.
/// errors: core::FileError with path and reason.
void write(const std::string& path, const Content& content, bool overwrite);

/// The bytes of the HDF5 file that write() writes. in: its name, for messages. errors: core::FileError.
std::vector<std::byte> image(const std::string& path, const Content& content);

/// Names in the file of a field in time by itself: /transient/frames/planes/P_3.
std::string plane_group(const std::string& frames);
std::string plane_name(const std::string& frames, const std::string& series, std::size_t k);

/// The XDMF text for a result file. in: path of the HDF5 file, named relative to the XDMF beside it.
std::string xdmf(const std::string& path, const Content& content);

}  // namespace ehl::results
