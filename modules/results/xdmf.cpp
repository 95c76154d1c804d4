#include <filesystem>
#include <sstream>

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

}  // namespace

std::string xdmf_name(const std::string& path) {
  std::filesystem::path name(path);
  return name.replace_extension(".xmf");
}

std::string xdmf(const std::string& path, const Content& content) {
  const std::string file = escaped(std::filesystem::path(path).filename());
  const std::string x = std::to_string(content.grid.nodes_x());
  const std::string y = std::to_string(content.grid.nodes_y());
  const auto item = [&](const std::string& dimensions, const std::string& dataset, bool single = false) {
    return "<DataItem Dimensions=\"" + dimensions + "\" NumberType=\"Float\" Precision=\"" + (single ? "4" : "8") +
           "\" Format=\"HDF\">" + file + ":" + escaped(dataset) + "</DataItem>";
  };
  std::ostringstream text;
  text << "<?xml version=\"1.0\" ?>\n<!DOCTYPE Xdmf SYSTEM \"Xdmf.dtd\" []>\n<Xdmf Version=\"2.0\">\n <Domain>\n"
       << "  <Grid Name=\"" << escaped(content.title) << "\" GridType=\"Uniform\">\n"
       << "   <Topology TopologyType=\"2DRectMesh\" Dimensions=\"" << y << " " << x << "\"/>\n"
       << "   <Geometry GeometryType=\"VXVY\">\n    " << item(x, "/grid/x") << "\n    " << item(y, "/grid/y")
       << "\n   </Geometry>\n";
  for (const NamedField& field : content.fields)
    text << "   <Attribute Name=\"" << escaped(field.name) << "\" AttributeType=\"Scalar\" Center=\"Node\">\n    "
         << item(y + " " + x, "/fields/" + field.name) << "\n   </Attribute>\n";
  text << "  </Grid>\n";
  if (!content.volume.group.empty()) {
    const Volume& volume = content.volume;
    const std::string along_x = std::to_string(volume.grid.nodes_x()), along_y = std::to_string(volume.grid.nodes_y());
    const std::string along_z = std::to_string(volume.depths.size());
    const std::string all = along_z + " " + along_y + " " + along_x;
    text << "  <Grid Name=\"" << escaped(volume.meaning) << "\" GridType=\"Uniform\">\n"
         << "   <Topology TopologyType=\"3DRectMesh\" Dimensions=\"" << all << "\"/>\n"
         << "   <Geometry GeometryType=\"VXVYVZ\">\n    " << item(along_x, volume.group + "/x") << "\n    "
         << item(along_y, volume.group + "/y") << "\n    " << item(along_z, volume.group + "/z")
         << "\n   </Geometry>\n";
    for (const Series& series : volume.series)
      text << "   <Attribute Name=\"" << escaped(series.name) << "\" AttributeType=\"Scalar\" Center=\"Node\">\n    "
           << item(all, volume.group + "/" + series.name, series.single) << "\n   </Attribute>\n";
    text << "  </Grid>\n";
  }
  text << " </Domain>\n</Xdmf>\n";
  return text.str();
}

}  // namespace ehl::results
