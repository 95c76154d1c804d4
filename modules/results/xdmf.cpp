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
  const auto item = [&](const std::string& dimensions, const std::string& dataset) {
    return "<DataItem Dimensions=\"" + dimensions + "\" NumberType=\"Float\" Precision=\"8\" Format=\"HDF\">" + file +
           ":" + escaped(dataset) + "</DataItem>";
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
  text << "  </Grid>\n </Domain>\n</Xdmf>\n";
  return text.str();
}

}  // namespace ehl::results
