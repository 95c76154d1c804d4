#include "results/write.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "results/atomic_file.hpp"
#include "results/entries.hpp"
#include "results/hdf5_handle.hpp"

namespace ehl::results {
namespace {

// Texts have a fixed length: HDF5 stores those of variable length in a heap without checksum, where one wrong byte of a
// damaged file can crash a reader.
Handle text_type(const std::string& text, const std::string& cannot) {
  Handle type = checked(H5Tcopy(H5T_C_S1), H5Tclose, cannot);
  check(H5Tset_size(type, text.size() + 1), cannot);
  check(H5Tset_cset(type, H5T_CSET_UTF8), cannot);
  return type;
}

}  // namespace

void add_text_attribute(hid_t object, const std::string& name, const std::string& text, const std::string& cannot) {
  const Handle type = text_type(text, cannot);
  const Handle space = checked(H5Screate(H5S_SCALAR), H5Sclose, cannot);
  const Handle made =
      checked(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, cannot);
  check(H5Awrite(made, type, text.c_str()), cannot);
}

namespace {

struct Writer {
  hid_t file;
  std::string path;

  std::string cannot(const std::string& name) const { return path + ": cannot build " + name; }
};

void describe(const Writer& writer, hid_t object, const Entry& entry) {
  for (const auto& [name, text] : entry.attributes) add_text_attribute(object, name, text, writer.cannot(entry.path));
}

Handle of_dataset(const Writer& writer) { return creation(H5P_DATASET_CREATE, writer.cannot("a dataset")); }

Handle dataset(const Writer& writer, const std::string& name, hid_t type, hid_t space, hid_t properties) {
  return checked(H5Dcreate2(writer.file, name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT), H5Dclose,
                 writer.cannot(name));
}

void group(const Writer& writer, const Entry& entry) {
  const std::string cannot = writer.cannot(entry.path);
  const Handle own = creation(H5P_GROUP_CREATE, cannot);
  const Handle made =
      entry.path == "/"
          ? checked(H5Gopen2(writer.file, "/", H5P_DEFAULT), H5Gclose, cannot)
          : checked(H5Gcreate2(writer.file, entry.path.c_str(), H5P_DEFAULT, own, H5P_DEFAULT), H5Gclose, cannot);
  describe(writer, made, entry);
}

void text(const Writer& writer, const Entry& entry) {
  const Handle type = text_type(entry.text, writer.cannot(entry.path));
  const Handle space = checked(H5Screate(H5S_SCALAR), H5Sclose, writer.cannot(entry.path));
  const Handle made = dataset(writer, entry.path, type, space, of_dataset(writer));
  check(H5Dwrite(made, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, entry.text.c_str()), writer.cannot(entry.path));
  describe(writer, made, entry);
}

std::vector<hsize_t> lengths_of(const Entry& entry) { return {entry.dims.begin(), entry.dims.end()}; }

hid_t stored_type(const Entry& entry) {
  if (entry.whole) return H5T_STD_I64LE;
  return entry.single ? H5T_IEEE_F32LE : H5T_IEEE_F64LE;
}

void numbers(const Writer& writer, const Entry& entry) {
  const std::string cannot = writer.cannot(entry.path);
  const std::vector<hsize_t> dims = lengths_of(entry);
  const int rank = static_cast<int>(dims.size());
  const Handle space =
      checked(rank == 0 ? H5Screate(H5S_SCALAR) : H5Screate_simple(rank, dims.data(), nullptr), H5Sclose, cannot);
  const Handle made = dataset(writer, entry.path, stored_type(entry), space, of_dataset(writer));
  const std::vector<double> of_field = entry.fields.empty() ? std::vector<double>{} : row_by_row(entry, 0);
  const std::vector<double>& values = entry.fields.empty() ? entry.values : of_field;
  if (entry.whole) {
    const std::vector<std::int64_t> integers(values.begin(), values.end());
    check(H5Dwrite(made, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, integers.data()), cannot);
  } else {
    check(H5Dwrite(made, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), cannot);
  }
  describe(writer, made, entry);
}

// Writes one field after the other to (time, y, x), each as one compressed chunk.
void series(const Writer& writer, const Entry& entry) {
  const std::string cannot = writer.cannot(entry.path);
  const std::vector<hsize_t> dims = lengths_of(entry);
  const hsize_t piece[] = {1, dims[1], dims[2]};
  constexpr unsigned fast = 1;
  const Handle properties = of_dataset(writer);
  check(H5Pset_chunk(properties, 3, piece), cannot);
  check(H5Pset_shuffle(properties), cannot);
  check(H5Pset_deflate(properties, fast), cannot);
  const Handle space = checked(H5Screate_simple(3, dims.data(), nullptr), H5Sclose, cannot);
  const Handle made = dataset(writer, entry.path, stored_type(entry), space, properties);
  const Handle of_piece = checked(H5Screate_simple(3, piece, nullptr), H5Sclose, cannot);
  for (std::size_t k = 0; k < entry.fields.size(); ++k) {
    const hsize_t start[] = {k, 0, 0};
    check(H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, piece, nullptr), cannot);
    const std::vector<double> values = row_by_row(entry, k);
    check(H5Dwrite(made, H5T_NATIVE_DOUBLE, of_piece, space, H5P_DEFAULT, values.data()), cannot);
  }
  describe(writer, made, entry);
}

// Adds every field of a series as a view (y, x) without data: readers of XDMF disagree on planes of a dataset, but not
// on whole datasets.
void planes(const Writer& writer, const std::string& group_name, const std::string& name, const Entry& entry) {
  const std::string cannot = writer.cannot(entry.path);
  const std::vector<hsize_t> dims = lengths_of(entry);
  const hsize_t piece[] = {1, dims[1], dims[2]};
  const Handle all = checked(H5Screate_simple(3, dims.data(), nullptr), H5Sclose, cannot);
  const Handle plane = checked(H5Screate_simple(2, dims.data() + 1, nullptr), H5Sclose, cannot);
  for (hsize_t k = 0; k < dims[0]; ++k) {
    const hsize_t start[] = {k, 0, 0};
    check(H5Sselect_hyperslab(all, H5S_SELECT_SET, start, nullptr, piece, nullptr), cannot);
    const Handle view = of_dataset(writer);
    check(H5Pset_virtual(view, plane, ".", entry.path.c_str(), all), cannot);
    describe(writer, dataset(writer, plane_name(group_name, name, k), stored_type(entry), plane, view), entry);
  }
}

void everything(const Writer& writer, const Content& content) {
  const std::vector<Entry> all = entries(content);
  for (const Entry& entry : all) {
    if (entry.kind == Entry::Kind::group)
      group(writer, entry);
    else if (entry.kind == Entry::Kind::text)
      text(writer, entry);
    else if (entry.dims.size() == 3)
      series(writer, entry);
    else
      numbers(writer, entry);
  }
  const std::string& of = content.frames.group;
  if (of.empty()) return;
  group(writer, {.path = plane_group(of), .attributes = {{"meaning", "the fields in time, one by one"}}});
  for (const Entry& entry : all)
    if (entry.dims.size() == 3 && entry.path.starts_with(of + "/"))
      planes(writer, of, entry.path.substr(of.size() + 1), entry);
}

}  // namespace

// HDF5 may report a full disk as late as in the close and then cannot close the file. So it writes only to memory, and
// system calls whose errors can be handled write the bytes to disk.
std::vector<std::byte> image(const std::string& path, const Content& content) {
  const QuietErrors quiet;
  const std::string cannot = path + ": cannot build the result";
  const Handle access = checked(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, cannot);
  const std::size_t block = std::max<std::size_t>(1 << 16, expected_bytes(content.grid, content.fields.size()) / 8);
  check(H5Pset_fapl_core(access, block, false), cannot);
  // The format of HDF5 1.8 has checksums on all metadata and is widely readable; views need that of 1.10.
  check(H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V110), cannot);
  const Handle root = creation(H5P_FILE_CREATE, cannot);
  const Handle file = checked(H5Fcreate(name_in_memory, H5F_ACC_TRUNC, root, access), H5Fclose, cannot);
  everything({file, path}, content);
  check(H5Fflush(file, H5F_SCOPE_GLOBAL), cannot);
  // The driver's own memory is copied: H5Fget_file_image clears a flag in its copy without updating the checksum.
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  check(size < 0 ? -1 : 0, cannot);
  void** memory = nullptr;
  check(H5Fget_vfd_handle(file, access, reinterpret_cast<void**>(&memory)), cannot);
  std::vector<std::byte> bytes(static_cast<std::size_t>(size));
  std::memcpy(bytes.data(), *memory, bytes.size());
  return bytes;
}

std::size_t expected_bytes(const core::Grid& nodes, std::size_t fields) {
  const auto points = static_cast<std::size_t>(nodes.nodes_x()) * static_cast<std::size_t>(lines_of(nodes));
  return 100000 + fields * points * sizeof(double);  // the constant is for deck, tables and provenance
}

void write(const std::string& path, const Content& content, bool overwrite) {
  write_atomically(path, image(path, content), overwrite);
  const std::string description = xdmf(path, content);
  write_atomically(xdmf_name(path), std::as_bytes(std::span(description)), overwrite);
}

}  // namespace ehl::results
