#include "labs/commands/drawing_report.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cli/options/scene_input.h"
#include "cli/report/text_layout.h"
#include "inspect/page.h"

#include <glassbox/base/printable.h>

namespace glassbox::labs {

namespace {

using Json = nlohmann::ordered_json;

std::string record_place(const labs::DrawingResult& result, const WrongRecord& record) {
  const labs::JudgedStage& stage = result.stages[record.stage];
  return record.triangle == kNone
             ? fmt::format("stage {} ({}), record {}", stage.name, stage.functions, record.record)
             : fmt::format("stage {} ({}), triangle {}", stage.name, stage.functions,
                           record.triangle);
}

std::string record_text(const labs::DrawingResult& result, const WrongRecord& record) {
  const labs::WrongNumber& n = record.number;
  std::string text = fmt::format("  {}\n    {}{}\n", record_place(result, record), n.element,
                                 n.explanation.empty() ? "" : ": " + n.explanation);
  if (n.explanation != "missing") text += fmt::format("      yours      {}\n", n.yours);
  if (n.explanation != "too many") text += fmt::format("      reference  {}\n", n.reference);
  if (n.explanation.empty())
    text +=
        fmt::format("      distance   {:.6g}{}; at most {:.6g} is allowed\n",
                    std::abs(n.yours - n.reference), n.unit.empty() ? "" : " " + n.unit, n.bound);
  return text + wrapped("    ", "its input: " + record.input);
}

std::string seen_text(const std::optional<std::uint32_t>& triangle) {
  return triangle ? fmt::format("triangle {}", *triangle) : "the background";
}

std::string stages_text(const labs::DrawingResult& result) {
  std::string text = fmt::format("  {:<12}{:<10}{:<46}{:>9}{:>9}\n", "stage", "space", "functions",
                                 "records", "wrong");
  for (const labs::JudgedStage& stage : result.stages)
    text += fmt::format("  {:<12}{:<10}{:<46}{:>9}{:>9}\n", stage.name, stage.stage,
                        stage.functions, stage.records, stage.wrong);
  return text;
}

std::string pixel_text(const DrawingReport& report) {
  const labs::DrawingResult& result = report.result;
  const std::size_t pixels = result.yours.pixels.size();
  if (!result.first_pixel)
    return fmt::format("All {} pixels are the same as the reference's.\n", pixels);
  const labs::WrongPixel& p = *result.first_pixel;
  std::string text = fmt::format(
      "{} of {} pixels differ. The first is ({}, {}): yours is {}, the reference's is {}.\nThere "
      "your picture shows {}, and the reference shows {}.\n",
      result.differing_pixels, pixels, p.x, p.y, colour_text(p.yours), colour_text(p.reference),
      seen_text(p.your_triangle), seen_text(p.reference_triangle));
  if (result.record_of_pixel) {
    text += "The first wrong record of this pixel:\n" +
            record_text(result, result.wrong[*result.record_of_pixel]);
  }
  return text;
}

// The fraction of pixels that have a channel which differs by more than 8/255 from the pipeline's
// picture.
double share_differing(const Image<Rgba8>& picture, const Image<Rgba8>& truth) {
  constexpr int kSeen = 8;
  std::size_t differing = 0;
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    const Rgba8 &a = picture.pixels[i], &b = truth.pixels[i];
    differing += std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)}) > kSeen;
  }
  return double(differing) / double(picture.pixels.size());
}

std::string truth_text(const labs::DrawingResult& result) {
  if (!result.truth) return "";
  return fmt::format(
      "{:.2f} % of your pixels and {:.2f} % of the reference's are more than 8/255\n"
      "away from the pipeline's picture of the scene.\n",
      100 * share_differing(result.yours, *result.truth),
      100 * share_differing(result.reference, *result.truth));
}

// The commands that show the first wrong triangle, or the first wrong pixel.
std::string debug_commands_text(const DrawingReport& report) {
  const auto& p = report.result.first_pixel;
  if (!p) return "";
  const auto triangle = p->your_triangle ? p->your_triangle : p->reference_triangle;
  std::string text = "These commands show the reference's numbers:\n";
  if (triangle && report.lab.number != 1)
    text += fmt::format("  glassbox step {}{} --triangle {}\n", report.scene, report.picture_words,
                        *triangle);
  return text + fmt::format("  glassbox pixel {}{} --at {},{}\n", report.scene,
                            report.picture_words, p->x, p->y);
}

Json record_json(const labs::DrawingResult& result, const WrongRecord& record) {
  const labs::WrongNumber& n = record.number;
  Json json{{"stage", result.stages[record.stage].name}, {"record", record.record}};
  json["triangle"] = record.triangle == kNone ? Json(nullptr) : Json(record.triangle);
  json["element"] = n.element;
  json["yours"] = n.yours;
  json["reference"] = n.reference;
  json["bound"] = n.bound;
  json["unit"] = n.unit;
  json["input"] = record.input;
  if (!n.explanation.empty()) json["explanation"] = n.explanation;
  return json;
}

Json triangle_json(const std::optional<std::uint32_t>& triangle) {
  return triangle ? Json(*triangle) : Json(nullptr);
}

}  // namespace

std::string colour_text(const Rgba8& c) {
  return fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b);
}

Image<Rgba8> side_by_side(const labs::DrawingResult& result) {
  constexpr int kGap = 4;
  constexpr Rgba8 kPaper{128, 128, 128, 255};
  const int width = result.yours.width;
  std::vector<const Image<Rgba8>*> pictures{&result.yours, &result.reference};
  if (result.truth) pictures.push_back(&*result.truth);
  const int count = int(pictures.size());
  Image<Rgba8> row(count * width + (count - 1) * kGap, result.yours.height, kPaper);
  for (int i = 0; i < count; ++i) {
    for (int y = 0; y < row.height; ++y) {
      for (int x = 0; x < width; ++x)
        row.at(i * (width + kGap) + x, y) = pictures[std::size_t(i)]->at(x, y);
    }
  }
  return row;
}

std::string drawing_text(const DrawingReport& report) {
  const labs::DrawingResult& result = report.result;
  std::string text = fmt::format("Lab {}: {}\n\n{}\n{}", report.lab.number, report.lab.title,
                                 stages_text(result), pixel_text(report));
  text += truth_text(result);
  if (result.right() && result.first_pixel)
    text += "Every record is within its error bound: the pixels differ by rounding only.\n";
  if (result.first_record && result.first_record != result.record_of_pixel)
    text += "The first wrong record of the whole scene:\n" +
            record_text(result, result.wrong[*result.first_record]);
  if (!result.right()) text += debug_commands_text(report);
  if (!report.drawing.not_drawn.empty())
    text += fmt::format("Not used for this picture: {}.\n", report.drawing.not_drawn);
  if (!report.printed.empty())
    text += "\nYour code printed:\n" + printable(report.printed, 4000) + "\n";
  return text;
}

Json drawing_json(const DrawingReport& report) {
  const labs::DrawingResult& result = report.result;
  Json json{{"lab", report.lab.folder},    {"scene", report.scene},
            {"width", result.yours.width}, {"height", result.yours.height},
            {"right", result.right()},     {"stages", Json::array()}};
  for (const labs::JudgedStage& stage : result.stages)
    json["stages"].push_back({{"name", stage.name},
                              {"space", stage.stage},
                              {"functions", stage.functions},
                              {"records", stage.records},
                              {"wrong", stage.wrong}});
  json["differing_pixels"] = result.differing_pixels;
  if (result.truth)
    json["beside_truth"] = {{"yours", share_differing(result.yours, *result.truth)},
                            {"reference", share_differing(result.reference, *result.truth)}};
  if (const auto& p = result.first_pixel) {
    json["first_pixel"] = {{"x", p->x},
                           {"y", p->y},
                           {"yours", colour_text(p->yours)},
                           {"reference", colour_text(p->reference)},
                           {"your_triangle", triangle_json(p->your_triangle)},
                           {"reference_triangle", triangle_json(p->reference_triangle)}};
  }
  if (const auto i = result.record_of_pixel)
    json["first_record_of_pixel"] = record_json(result, result.wrong[*i]);
  if (const auto i = result.first_record)
    json["first_record"] = record_json(result, result.wrong[*i]);
  json["seconds"] = report.seconds;
  json["student_seconds"] = report.student_seconds;
  return json;
}

namespace {

using Json = nlohmann::ordered_json;

Json wrong_json(const labs::WrongNumber& n) {
  return {{"element", n.element}, {"yours", n.yours}, {"reference", n.reference},
          {"bound", n.bound},     {"unit", n.unit},   {"explanation", n.explanation}};
}

Json records_json(const labs::DrawingResult& result) {
  Json records = Json::array();
  for (const labs::KeptRecord& each : result.kept) {
    records.push_back({{"stage", each.stage},
                       {"record", each.record},
                       {"triangle", each.triangle == kNone ? Json(nullptr) : Json(each.triangle)},
                       {"yours", each.yours},
                       {"reference", each.reference},
                       {"wrong", each.wrong ? wrong_json(*each.wrong) : Json(nullptr)}});
  }
  return records;
}

// The settings of the run for the picture under the page's overlays: the colours as drawn, without
// what the student's code changes in the finished picture (`finish`).
labs::PictureSetup displayed_setup(labs::PictureSetup setup) {
  setup.finish = nullptr;
  if (setup.settings.show != Show::kNormal && setup.settings.show != Show::kUv)
    setup.settings.show = Show::kColor;
  return setup;
}

}  // namespace

Result<std::string> lab_drawing_page(const DrawingReport& report, const labs::DrawingInput& drawn,
                                     const labs::ComparedPictures& both,
                                     const std::vector<std::string>& words) {
  const labs::PictureSetup yours = displayed_setup(both.yours),
                           reference = displayed_setup(both.reference);
  // If the student's code changes the finished picture, the page shows the changed picture in
  // addition to the run's.
  const bool other = both.yours.finish != nullptr;
  const labs::DrawingResult& result = both.result;
  const Image<Rgba8> reference_picture =
      other ? result.reference : std::move(reference.render().buffers.color);
  Json student = drawing_json(report);
  student["records"] = records_json(both.result);

  inspect::InspectOptions options;
  options.scene_name = scene_title(report.scene) + ", lab " + std::to_string(report.lab.number);
  options.words = words;
  options.program = "glassbox " GLASSBOX_VERSION;
  options.command = "glassbox lab render FOLDER " + report.scene + report.picture_words;
  options.stages = yours.stages.get();
  options.student = student.dump(-1, ' ', false, Json::error_handler_t::replace);
  options.reference = &reference_picture;
  if (other) options.made = &result.yours;
  if (result.truth) options.truth = &*result.truth;
  const auto page =
      inspect::make_inspect_page(yours.scene, drawn.camera, yours.view, yours.settings, options);
  if (!page) return tl::unexpected(page.error());
  return page->html;
}

}  // namespace glassbox::labs
