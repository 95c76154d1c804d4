#pragma once
// Result files: HDF5, and an XDMF file for ParaView.
#include <cstddef>
#include <string>
#include <vector>

#include "results/content.hpp"

namespace ehl::results {

/// Approximate size of a result in bytes.
std::size_t expected_bytes(const core::Grid& grid, std::size_t fields);

/// Name of the XDMF file of a result: R.h5 -> R.xmf.
std::string xdmf_name(const std::string& path);

/// Writes /deck, /provenance, /scales, /grid/{x,y}, /fields, /summary and the tables, with unit and meaning as
/// attributes; fields are (row = y, column = x). Then writes the XDMF file. Each is written completely or not at all.
/// errors: core::FileError with path and reason.
void write(const std::string& path, const Content& content, bool overwrite);

/// Bytes of the HDF5 file that write() writes. in: its path, for messages. errors: core::FileError.
std::vector<std::byte> image(const std::string& path, const Content& content);

/// Group and name of a single plane of a field in time: /transient/frames/planes/P_3.
std::string plane_group(const std::string& frames);
std::string plane_name(const std::string& frames, const std::string& series, std::size_t k);

/// XDMF text for a result file. in: path of the HDF5 file, which the XDMF names relative to itself.
std::string xdmf(const std::string& path, const Content& content);

}  // namespace ehl::results
