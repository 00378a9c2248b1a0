#include "app/bench/page.h"

#include <cstddef>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/bench/json.h"
#include "app/bench/text.h"
#include "bench_page.h"  // made by html/embed.cmake

#include <glassbox/html/blob.h>
#include <glassbox/html/escaped.h>

namespace glassbox::app {

std::string bench_page(const BenchReport& report) {
  nlohmann::ordered_json manifest = bench_json(report);
  for (std::size_t i = 0; i < report.scalings.size(); ++i)
    manifest["scaling"][i]["told"] = scaling_text(report.scalings[i]);
  const std::string numbers =
      fmt::format("<section>\n<h2>Numbers</h2>\n<pre>{}</pre>\n</section>\n</main>\n",
                  escaped(bench_text(report)));
  return assemble_page(kBenchPage, "glassbox bench", numbers + json_block("manifest", manifest));
}

}  // namespace glassbox::app
