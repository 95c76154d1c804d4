#include <fmt/core.h>

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
};

std::string item(const Texts& texts, const std::string& dimensions, const std::string& dataset, bool single = false) {
  return "<DataItem Dimensions=\"" + dimensions + "\" NumberType=\"Float\" Precision=\"" + (single ? "4" : "8") +
         "\" Format=\"HDF\">" + texts.file + ":" + escaped(dataset) + "</DataItem>";
}

std::string attribute(const std::string& name, const std::string& data) {
  return "   <Attribute Name=\"" + escaped(name) + "\" AttributeType=\"Scalar\" Center=\"Node\">\n    " + data +
         "\n   </Attribute>\n";
}

std::string mesh(const Texts& texts) {
  return "   <Topology TopologyType=\"2DRectMesh\" Dimensions=\"" + texts.y + " " + texts.x +
         "\"/>\n   <Geometry GeometryType=\"VXVY\">\n    " + item(texts, texts.x, "/grid/x") + "\n    " +
         item(texts, texts.y, "/grid/y") + "\n   </Geometry>\n";
}

std::string grid_of_fields(const Texts& texts, const Content& content) {
  std::string text = "  <Grid Name=\"" + escaped(content.title) + "\" GridType=\"Uniform\">\n" + mesh(texts);
  for (const NamedField& field : content.fields)
    text += attribute(field.name, item(texts, texts.y + " " + texts.x, "/fields/" + field.name));
  return text + "  </Grid>\n";
}

std::string grids_in_time(const Texts& texts, const Content& content) {
  const Frames& frames = content.frames;
  std::string text =
      "  <Grid Name=\"" + escaped(content.title) + "\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (std::size_t k = 0; k < frames.times.size(); ++k) {
    text += "  <Grid Name=\"" + std::to_string(k) + "\" GridType=\"Uniform\">\n   <Time Value=\"" +
            fmt::format("{}", frames.times[k]) + "\"/>\n" + mesh(texts);
    for (const Series& series : frames.series)
      text += attribute(series.name,
                        item(texts, texts.y + " " + texts.x, plane_name(frames.group, series.name, k), series.single));
    text += "  </Grid>\n";
  }
  return text + "  </Grid>\n";
}

std::string grid_in_space(const Texts& texts, const Volume& volume) {
  const std::string x = std::to_string(volume.grid.nodes_x()), y = std::to_string(lines_of(volume.grid));
  const std::string z = std::to_string(volume.depths.size()), all = z + " " + y + " " + x;
  std::string text = "  <Grid Name=\"" + escaped(volume.meaning) +
                     "\" GridType=\"Uniform\">\n   <Topology TopologyType=\"3DRectMesh\" Dimensions=\"" + all +
                     "\"/>\n   <Geometry GeometryType=\"VXVYVZ\">\n    " + item(texts, x, volume.group + "/x") +
                     "\n    " + item(texts, y, volume.group + "/y") + "\n    " + item(texts, z, volume.group + "/z") +
                     "\n   </Geometry>\n";
  for (const Series& series : volume.series)
    text += attribute(series.name, item(texts, all, volume.group + "/" + series.name, series.single));
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
                    std::to_string(lines_of(content.grid))};
  return "<?xml version=\"1.0\" ?>\n<!DOCTYPE Xdmf SYSTEM \"Xdmf.dtd\" []>\n<Xdmf Version=\"2.0\">\n <Domain>\n" +
         (content.frames.series.empty() ? grid_of_fields(texts, content) : grids_in_time(texts, content)) +
         (content.volume.group.empty() ? "" : grid_in_space(texts, content.volume)) + " </Domain>\n</Xdmf>\n";
}

}  // namespace ehl::results
