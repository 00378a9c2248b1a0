#include <cstdint>
#include <span>

#include <nlohmann/json.hpp>

#include <glassbox/html/blob.h>

#include "app/study/extremes/report.h"
#include "extremes_page.h"  // made by html/embed.cmake

namespace glassbox::app {

std::string extremes_page(const ExtremesReport& report, const std::string& command) {
  nlohmann::ordered_json manifest = extremes_json(report);
  manifest["command"] = command;
  for (std::size_t i = 0; i < report.cases.size(); ++i) {
    auto& pictures = manifest["cases"][i]["pictures"] = nlohmann::ordered_json::array();
    for (const study::ExtremePicture& picture : report.cases[i].what.pictures) {
      const std::string png = picture.png();
      const auto* bytes = reinterpret_cast<const std::uint8_t*>(png.data());
      pictures.push_back({{"name", picture.name}, {"png", base64(std::span(bytes, png.size()))}});
    }
  }
  return assemble_page(kExtremesPage, "glassbox study extremes", json_block("manifest", manifest));
}

}  // namespace glassbox::app
