#include "page/result_view.hpp"

#include <cmath>

#include "case/numbers/number.hpp"
#include "core/errors.hpp"

namespace ehl::program {
namespace {

using Kind = results::ResultFile::Kind;

}  // namespace

ResultView::ResultView(const std::string& path) : source(open_result(path)) {
  source.si = scales_of(source.file);
  in_time = has("/transient/frames/time") && source.file.dims("/transient/frames/time").at(0) > 0;
  dry = has("/fields/gap");
  converged = value(numbers::path_of(id::converged)) == 1.0;
}

bool ResultView::has(const std::string& name) const { return source.file.kind(name) != Kind::missing; }

results::Array ResultView::number(const std::string& name) const {
  // In older files error_Hc is the error of the mesh alone.
  for (const char* error : {id::error_Hc, id::error_Hm})
    if (const std::string older = "/summary/total_" + std::string(error); name == numbers::path_of(error) && has(older))
      return number(older);
  if (source.file.kind(name) == Kind::numbers && source.file.dims(name).empty()) return source.numbers(name);
  return {{}, {std::nan("")}, "-", ""};
}

std::string ResultView::text(const std::string& name) const {
  return source.file.kind(name) == Kind::text ? source.file.text(name) : "";
}

}  // namespace ehl::program
