#include <fmt/format.h>

#include "cli/report/csv_field.h"
#include "study/commands/scene/curve_report.h"

namespace glassbox::study {

std::string curve_csv(const CurveReport& report) {
  std::string text =
      "scene,width,height,way,knob,rms,largest,wrong,flip,depth_error,threads,ns,ns_lower,"
      "ns_upper,disturbed,standing,machine,compiler,flags,version\n";
  const study::Origin& from = report.origin;
  for (const study::CurvePoint& point : report.curve.points) {
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
                        csv_field(report.scene), report.size.width, report.size.height,
                        csv_field(name_of(point.way)), name_of(point.way.knob), point.error.rms,
                        point.error.largest, point.error.wrong, point.error.flip, point.depth_error,
                        point.way.threads(), point.ns.median, point.ns.lower, point.ns.upper,
                        point.disturbed, point.standing ? name_of(*point.standing) : "",
                        csv_field(from.machine), csv_field(from.compiler), csv_field(from.flags),
                        csv_field(from.version));
  }
  return text;
}

}  // namespace glassbox::study
