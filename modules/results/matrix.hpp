#pragma once
// Matrices of numbers from any HDF5 file.
#include <string>

#include "results/read.hpp"

namespace ehl::results {

/// Reads a two-dimensional dataset. errors: core::FileError: the file cannot be read or is not HDF5; there is no such
/// dataset, it is not a table of numbers, or has more than 10^8 of them.
Array read_matrix(const std::string& path, const std::string& dataset);

}  // namespace ehl::results
