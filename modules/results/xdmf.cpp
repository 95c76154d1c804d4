#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "results/entries.hpp"
#include "results/write.hpp"

namespace ehl::results {
namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      default: result += c;
    }
  }
  return result;
}

// Texts shared by all grids of a result.
struct Texts {
  std::string file{};  // name of the HDF5 file
  std::string x{};     // dimensions
  std::string y{};
  const std::vector<InSi>& si;
};

/// An array of the HDF5 file.
struct Item {
  std::string dimensions{};
  std::string dataset{};
  std::string unit{};
  bool single = false;  ///< in single precision
};

const InSi* in_si(const Texts& texts, const std::string& unit) {
  const auto found = std::ranges::find(texts.si, unit, &InSi::unit);
  return found == texts.si.end() ? nullptr : &*found;
}

// All digits of a factor without an exponent, which the expressions of the XDMF library do not know.
std::string plain_digits(double factor) {
  constexpr int digits = 17;
  const int before_point = static_cast<int>(std::floor(std::log10(factor))) + 1;
  return fmt::format("{:.{}f}", factor, std::max(0, digits - before_point));
}

// The array, in SI as the product with the factor of its unit.
std::string text_of(const Texts& texts, const Item& item) {
  const std::string size = "<DataItem Dimensions=\"" + item.dimensions + "\"";
  const std::string own = size + " NumberType=\"Float\" Precision=\"" + (item.single ? "4" : "8") +
                          "\" Format=\"HDF\">" + texts.file + ":" + escaped(item.dataset) + "</DataItem>";
  const InSi* to = in_si(texts, item.unit);
  if (to == nullptr) return own;
  return size + " ItemType=\"Function\" Function=\"" + plain_digits(to->factor) + " * $0\">" + own + "</DataItem>";
}

// "P", or "P_Pa" in SI.
std::string name_of(const Texts& texts, const std::string& name, const std::string& unit) {
  const InSi* to = in_si(texts, unit);
  return to == nullptr ? name : name + "_" + to->name;
}

std::string attribute(const Texts& texts, const std::string& name, const Item& item) {
  return "   <Attribute Name=\"" + escaped(name_of(texts, name, item.unit)) +
         "\" AttributeType=\"Scalar\" Center=\"Node\">\n    " + text_of(texts, item) + "\n   </Attribute>\n";
}

std::string mesh(const Texts& texts) {
  return "   <Topology TopologyType=\"2DRectMesh\" Dimensions=\"" + texts.y + " " + texts.x +
         "\"/>\n   <Geometry GeometryType=\"VXVY\">\n    " + text_of(texts, {texts.x, "/grid/x", "a"}) + "\n    " +
         text_of(texts, {texts.y, "/grid/y", "a"}) + "\n   </Geometry>\n";
}

std::string grid_of_fields(const Texts& texts, const Content& content) {
  std::string text = "  <Grid Name=\"" + escaped(content.title) + "\" GridType=\"Uniform\">\n" + mesh(texts);
  for (const NamedField& field : content.fields)
    text += attribute(texts, field.name, {texts.y + " " + texts.x, "/fields/" + field.name, field.unit});
  return text + "  </Grid>\n";
}

std::string grids_in_time(const Texts& texts, const Content& content) {
  const Frames& frames = content.frames;
  const InSi* seconds = in_si(texts, "a/u_m");
  std::string text =
      "  <Grid Name=\"" + escaped(content.title) + "\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (std::size_t k = 0; k < frames.times.size(); ++k) {
    const double time = seconds == nullptr ? frames.times[k] : frames.times[k] * seconds->factor;
    text += "  <Grid Name=\"" + std::to_string(k) + "\" GridType=\"Uniform\">\n   <Time Value=\"" +
            fmt::format("{}", time) + "\"/>\n" + mesh(texts);
    for (const Series& series : frames.series)
      text +=
          attribute(texts, series.name,
                    {texts.y + " " + texts.x, plane_name(frames.group, series.name, k), series.unit, series.single});
    text += "  </Grid>\n";
  }
  return text + "  </Grid>\n";
}

std::string grid_in_space(const Texts& texts, const Volume& volume) {
  const std::string x = std::to_string(volume.grid.nodes_x()), y = std::to_string(lines_of(volume.grid));
  const std::string z = std::to_string(volume.depths.size()), all = z + " " + y + " " + x;
  std::string text = "  <Grid Name=\"" + escaped(volume.meaning) +
                     "\" GridType=\"Uniform\">\n   <Topology TopologyType=\"3DRectMesh\" Dimensions=\"" + all +
                     "\"/>\n   <Geometry GeometryType=\"VXVYVZ\">\n    " +
                     text_of(texts, {x, volume.group + "/x", "a"}) + "\n    " +
                     text_of(texts, {y, volume.group + "/y", "a"}) + "\n    " +
                     text_of(texts, {z, volume.group + "/z", "a"}) + "\n   </Geometry>\n";
  for (const Series& series : volume.series)
    text += attribute(texts, series.name, {all, volume.group + "/" + series.name, series.unit, series.single});
  return text + "  </Grid>\n";
}

}  // namespace

std::string plane_group(const std::string& frames) { return frames + "/planes"; }

std::string plane_name(const std::string& frames, const std::string& series, std::size_t k) {
  return plane_group(frames) + "/" + series + "_" + std::to_string(k);
}

std::string xdmf_name(const std::string& path) {
  std::filesystem::path name(path);
  return name.replace_extension(".xmf");
}

std::string xdmf(const std::string& path, const Content& content) {
  const Texts texts{escaped(std::filesystem::path(path).filename()), std::to_string(content.grid.nodes_x()),
                    std::to_string(lines_of(content.grid)), content.si};
  return "<?xml version=\"1.0\" ?>\n<!DOCTYPE Xdmf SYSTEM \"Xdmf.dtd\" []>\n<Xdmf Version=\"2.0\">\n <Domain>\n" +
         (content.frames.series.empty() ? grid_of_fields(texts, content) : grids_in_time(texts, content)) +
         (content.volume.group.empty() ? "" : grid_in_space(texts, content.volume)) + " </Domain>\n</Xdmf>\n";
}

}  // namespace ehl::results
