#include "results/matrix.hpp"

#include "results/hdf5_handle.hpp"

namespace ehl::results {
namespace {

constexpr hsize_t most_numbers = 100'000'000;

}  // namespace

Array read_matrix(const std::string& path, const std::string& dataset) {
  const QuietErrors quiet;
  const Handle file = open_hdf5(path);
  const std::string cannot = path + ": cannot read " + dataset;
  const auto [set, space, type, dims] = open_dataset(file, dataset, cannot);
  const H5T_class_t kind = H5Tget_class(type);
  if (kind != H5T_FLOAT && kind != H5T_INTEGER) throw core::FileError(cannot + ": it contains no numbers");
  if (dims.size() != 2)
    throw core::FileError(cannot + ": it has " + std::to_string(dims.size()) + " dimensions and must have two");
  // A damaged header can state any size, and a compressed dataset may exceed its size on disk.
  if (dims[1] > 0 && dims[0] > most_numbers / dims[1])
    throw core::FileError(cannot + ": it contains more than 10^8 numbers");
  Array array;
  array.dims = {dims[0], dims[1]};
  array.values.resize(dims[0] * dims[1]);
  if (!array.values.empty())
    check(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, array.values.data()), cannot);
  return array;
}

}  // namespace ehl::results
