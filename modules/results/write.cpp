#include "results/write.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "results/atomic_file.hpp"
#include "results/hdf5_handle.hpp"
#include "results/one_line.hpp"

namespace ehl::results {
namespace {
struct Writer {
  hid_t file;
  std::string path;

  std::string cannot(const std::string& name) const { return path + ": cannot build " + name; }
};

// Of fixed length: texts of variable length lie in a heap without checksum, where one wrong byte of a damaged file
// can crash its reader.
Handle text_type(const Writer& writer, const std::string& text) {
  Handle type = checked(H5Tcopy(H5T_C_S1), H5Tclose, writer.cannot("a text"));
  check(H5Tset_size(type, text.size() + 1), writer.cannot("a text"));
  check(H5Tset_cset(type, H5T_CSET_UTF8), writer.cannot("a text"));
  return type;
}

void attribute(const Writer& writer, hid_t object, const std::string& name, const std::string& text) {
  if (text.empty()) return;
  const Handle type = text_type(writer, text);
  const Handle space = checked(H5Screate(H5S_SCALAR), H5Sclose, writer.cannot(name));
  const Handle made =
      checked(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, writer.cannot(name));
  check(H5Awrite(made, type, text.c_str()), writer.cannot(name));
}

void describe(const Writer& writer, hid_t object, const std::string& unit, const std::string& meaning) {
  attribute(writer, object, "unit", unit);
  attribute(writer, object, "meaning", meaning);
}

// Without the times of the objects, so that the same run gives the same file but for its date in /provenance.
Handle creation(const Writer& writer) {
  Handle properties = checked(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, writer.cannot("a dataset"));
  check(H5Pset_obj_track_times(properties, false), writer.cannot("a dataset"));
  return properties;
}

Handle dataset(const Writer& writer, const std::string& name, hid_t type, hid_t space, hid_t properties) {
  return checked(H5Dcreate2(writer.file, name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT), H5Dclose,
                 writer.cannot(name));
}

Handle group(const Writer& writer, const std::string& name, const std::string& meaning = "") {
  Handle made = checked(H5Gcreate2(writer.file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose,
                        writer.cannot(name));
  attribute(writer, made, "meaning", meaning);
  return made;
}

void text(const Writer& writer, const std::string& name, const std::string& value, const std::string& meaning) {
  const Handle type = text_type(writer, value);
  const Handle space = checked(H5Screate(H5S_SCALAR), H5Sclose, writer.cannot(name));
  const Handle made = dataset(writer, name, type, space, creation(writer));
  check(H5Dwrite(made, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, value.c_str()), writer.cannot(name));
  describe(writer, made, "", meaning);
}

// in: lengths; none: a single number.
void numbers(const Writer& writer, const std::string& name, const std::vector<hsize_t>& dims,
             const std::vector<double>& values, bool whole, const std::string& unit, const std::string& meaning) {
  const int rank = static_cast<int>(dims.size());
  const Handle space = checked(rank == 0 ? H5Screate(H5S_SCALAR) : H5Screate_simple(rank, dims.data(), nullptr),
                               H5Sclose, writer.cannot(name));
  const Handle made = dataset(writer, name, whole ? H5T_STD_I64LE : H5T_IEEE_F64LE, space, creation(writer));
  if (whole) {
    const std::vector<std::int64_t> integers(values.begin(), values.end());
    check(H5Dwrite(made, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, integers.data()), writer.cannot(name));
  } else {
    check(H5Dwrite(made, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), writer.cannot(name));
  }
  describe(writer, made, unit, meaning);
}

void quantity(const Writer& writer, const std::string& name, const Quantity& one) {
  if (const auto* words = std::get_if<std::string>(&one.value)) return text(writer, name, *words, one.meaning);
  const double value = number(one.value);
  const bool whole = !std::holds_alternative<double>(one.value);
  if (std::isfinite(value)) numbers(writer, name, {}, {value}, whole, one.unit, one.meaning);
}

void column(const Writer& writer, const std::string& group, const Column& one) {
  numbers(writer, group + "/" + one.name, {one.values.size()}, one.values, one.whole, one.unit, one.meaning);
}

// In a group that there is.
void quantities(const Writer& writer, const std::string& group, const std::vector<Quantity>& list) {
  for (const Quantity& one : list)
    if (!one.name.empty()) quantity(writer, group + "/" + one.name, one);
}

std::vector<double> stations(const core::Grid& nodes) {
  std::vector<double> x;
  for (int i = 0; i < nodes.nodes_x(); ++i) x.push_back(nodes.X(i));
  return x;
}

void axis(const Writer& writer, const std::string& name, const std::vector<double>& at, const std::string& meaning) {
  numbers(writer, name, {at.size()}, at, false, "a", meaning + ", in Hertz radii");
}

void grid(const Writer& writer, const std::string& of, const core::Grid& nodes) {
  std::vector<double> y;
  for (int j = 0; j < nodes.nodes_y(); ++j) y.push_back(nodes.Y(j));
  axis(writer, of + "/x", stations(nodes), "X of the nodes, along the entrainment");
  axis(writer, of + "/y", y, "Y of the nodes, across the entrainment");
}

// Row = y, column = x.
std::vector<double> row_by_row(const core::Field& from) {
  const auto rows = static_cast<std::size_t>(from.nodes_y());
  const auto columns = static_cast<std::size_t>(from.nodes_x());
  std::vector<double> values(rows * columns);
  for (std::size_t i = 0; i < columns; ++i) {
    const std::span<const double> station = from.station(static_cast<int>(i));
    for (std::size_t j = 0; j < rows; ++j) values[j * columns + i] = station[j];
  }
  return values;
}

void field(const Writer& writer, const std::string& of, const NamedField& entry) {
  const std::vector<double> values = row_by_row(*entry.field);
  const auto rows = static_cast<hsize_t>(entry.field->nodes_y());
  numbers(writer, of + "/" + entry.name, {rows, values.size() / rows}, values, false, entry.unit, entry.meaning);
}

// One field after the other into (time, y, x), each a compressed piece of its own.
void series(const Writer& writer, const std::string& group_name, const Series& entry) {
  if (entry.fields.empty()) return;
  const std::string name = group_name + "/" + entry.name;
  const std::string cannot = writer.cannot(name);
  const hsize_t dims[] = {entry.fields.size(), static_cast<hsize_t>(entry.fields[0]->nodes_y()),
                          static_cast<hsize_t>(entry.fields[0]->nodes_x())};
  const hsize_t piece[] = {1, dims[1], dims[2]};
  constexpr unsigned fast = 1;
  const Handle properties = creation(writer);
  check(H5Pset_chunk(properties, 3, piece), cannot);
  check(H5Pset_shuffle(properties), cannot);
  check(H5Pset_deflate(properties, fast), cannot);
  const Handle space = checked(H5Screate_simple(3, dims, nullptr), H5Sclose, cannot);
  const hid_t type = entry.single ? H5T_IEEE_F32LE : H5T_IEEE_F64LE;
  const Handle made = dataset(writer, name, type, space, properties);
  const Handle of_piece = checked(H5Screate_simple(3, piece, nullptr), H5Sclose, cannot);
  for (std::size_t k = 0; k < entry.fields.size(); ++k) {
    const hsize_t start[] = {k, 0, 0};
    check(H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, piece, nullptr), cannot);
    const std::vector<double> values = row_by_row(*entry.fields[k]);
    check(H5Dwrite(made, H5T_NATIVE_DOUBLE, of_piece, space, H5P_DEFAULT, values.data()), cannot);
  }
  describe(writer, made, entry.unit, entry.meaning);
}

// Every field of a series again as (y, x), a view that takes no room: readers of XDMF take planes of a dataset in
// different orders, and whole datasets alike.
void planes(const Writer& writer, const std::string& group_name, const Series& entry) {
  if (entry.fields.empty()) return;
  const std::string of = group_name + "/" + entry.name, cannot = writer.cannot(of);
  const hsize_t dims[] = {entry.fields.size(), static_cast<hsize_t>(entry.fields[0]->nodes_y()),
                          static_cast<hsize_t>(entry.fields[0]->nodes_x())};
  const hsize_t piece[] = {1, dims[1], dims[2]};
  const Handle all = checked(H5Screate_simple(3, dims, nullptr), H5Sclose, cannot);
  const Handle plane = checked(H5Screate_simple(2, dims + 1, nullptr), H5Sclose, cannot);
  for (hsize_t k = 0; k < dims[0]; ++k) {
    const hsize_t start[] = {k, 0, 0};
    check(H5Sselect_hyperslab(all, H5S_SELECT_SET, start, nullptr, piece, nullptr), cannot);
    const Handle view = creation(writer);
    check(H5Pset_virtual(view, plane, ".", of.c_str(), all), cannot);
    const Handle made = dataset(writer, plane_name(group_name, entry.name, k),
                                entry.single ? H5T_IEEE_F32LE : H5T_IEEE_F64LE, plane, view);
    describe(writer, made, entry.unit, entry.meaning);
  }
}

void frames(const Writer& writer, const Frames& entry) {
  if (entry.group.empty()) return;
  group(writer, entry.group);
  numbers(writer, entry.group + "/time", {entry.times.size()}, entry.times, false, "a/u_m", "times of the fields");
  for (const Series& one : entry.series) series(writer, entry.group, one);
  group(writer, plane_group(entry.group), "the fields in time, each by itself");
  for (const Series& one : entry.series) planes(writer, entry.group, one);
}

void table(const Writer& writer, const Table& entry) {
  const Handle made = group(writer, "/" + entry.name, entry.meaning);
  std::string order;
  for (const Column& one : entry.columns) order += (order.empty() ? "" : " ") + one.name;
  attribute(writer, made, "columns", order);
  for (const Column& one : entry.columns) column(writer, "/" + entry.name, one);
}

void loose(const Writer& writer, const Loose& entry) {
  if (entry.group.empty()) return;
  group(writer, entry.group, entry.meaning);
  quantities(writer, entry.group, entry.numbers);
  for (const Column& one : entry.arrays) column(writer, entry.group, one);
}

void section(const Writer& writer, const core::Grid& along, const Section& entry) {
  if (entry.group.empty()) return;
  group(writer, entry.group, entry.meaning);
  axis(writer, entry.group + "/x", stations(along), "X of the nodes");
  column(writer, entry.group, entry.across);
  for (const NamedField& one : entry.fields) field(writer, entry.group, one);
}

void volume(const Writer& writer, const Volume& entry) {
  if (entry.group.empty()) return;
  attribute(writer, group(writer, entry.group, entry.meaning), "warnings", entry.warnings);
  grid(writer, entry.group, entry.grid);
  axis(writer, entry.group + "/z", entry.depths, "depth below the surface");
  for (const Series& one : entry.series) series(writer, entry.group, one);
  quantities(writer, entry.group, entry.numbers);
  const Column z{"z", "a", "depth below the surface, in Hertz radii", false, entry.depths};
  section(writer, entry.grid, {entry.group + "/section", entry.section_meaning, z, entry.section});
}

void effects(const Writer& writer, const std::vector<EffectRow>& list) {
  if (list.empty()) return;
  group(writer, "/effects", "what the deck called for beyond the basic model, and the time that each took");
  for (const EffectRow& row : list) {
    const std::string name = "/effects/" + row.name;
    numbers(writer, name, {}, {row.seconds}, false, "s", row.what);
    const Handle dataset = checked(H5Dopen2(writer.file, name.c_str(), H5P_DEFAULT), H5Dclose, writer.cannot(name));
    attribute(writer, dataset, "why", row.why);
  }
}

void everything(const Writer& writer, const Content& content) {
  attribute(writer, writer.file, "format", "ehl result");
  attribute(writer, writer.file, "title", content.title);
  text(writer, "/deck", content.deck, "the deck as it was understood: read again, it gives this case");
  group(writer, "/provenance");
  quantities(writer, "/provenance", content.provenance);
  group(writer, "/scales");
  quantities(writer, "/scales", content.scales);
  group(writer, "/grid");
  grid(writer, "/grid", content.grid);
  group(writer, "/fields");
  for (const NamedField& entry : content.fields) field(writer, "/fields", entry);
  group(writer, "/summary");
  quantities(writer, "/summary", content.summary);
  for (const Table& entry : content.tables) table(writer, entry);
  frames(writer, content.frames);
  loose(writer, content.checkpoint);
  volume(writer, content.volume);
  section(writer, content.grid, content.section);
  effects(writer, content.effects);
}

// The whole file in memory. HDF5 reports a full disk as late as in the close, and then cannot be closed any more; so
// it never sees the disk, and the bytes go there by plain system calls whose every failure can be answered.
std::vector<std::byte> image(const std::string& path, const Content& content) {
  const QuietErrors quiet;
  const std::string cannot = path + ": cannot build the result";
  const Handle access = checked(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, cannot);
  const std::size_t block = std::max<std::size_t>(1 << 16, expected_bytes(content.grid, content.fields.size()) / 8);
  check(H5Pset_fapl_core(access, block, false), cannot);
  // The format of HDF5 1.8 puts a checksum on all that describes the data, and every reader of today knows it; the
  // views of fields in time are of 1.10.
  check(H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V110), cannot);
  const Handle file = checked(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose, cannot);
  everything({file, path}, content);
  check(H5Fflush(file, H5F_SCOPE_GLOBAL), cannot);
  // The memory of the driver itself: H5Fget_file_image clears a flag in its copy and forgets the checksum over it.
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  check(size < 0 ? -1 : 0, cannot);
  void** memory = nullptr;
  check(H5Fget_vfd_handle(file, access, reinterpret_cast<void**>(&memory)), cannot);
  std::vector<std::byte> bytes(static_cast<std::size_t>(size));
  std::memcpy(bytes.data(), *memory, bytes.size());
  return bytes;
}

}  // namespace

std::size_t expected_bytes(const core::Grid& nodes, std::size_t fields) {
  const auto points = static_cast<std::size_t>(nodes.nodes_x()) * static_cast<std::size_t>(nodes.nodes_y());
  return 100000 + fields * points * sizeof(double);  // the first for deck, tables, provenance
}

void write(const std::string& path, const Content& content, bool overwrite) {
  if (content.grid.line && content.grid.ny > 0) return write(path, OneLine(content).content, overwrite);
  write_atomically(path, image(path, content), overwrite);
  const std::string description = xdmf(path, content);
  write_atomically(xdmf_name(path), std::as_bytes(std::span(description)), overwrite);
}

}  // namespace ehl::results
