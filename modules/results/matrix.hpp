#pragma once
// Numbers in rows and columns from any HDF5 file.
#include <string>

#include "results/read.hpp"

namespace ehl::results {

/// A dataset of two dimensions. errors: core::FileError: the file cannot be read, is no HDF5, has no such dataset, or
/// it is no table of numbers; more than 10^8 of them.
Array read_matrix(const std::string& path, const std::string& dataset);

}  // namespace ehl::results
