#include "app/step_command.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/arguments.h"
#include "app/chain_text.h"
#include "app/exit_codes.h"
#include "app/output.h"
#include "app/text_layout.h"

#include <glassbox/base/printable.h>
#include <glassbox/pipeline/decimal.h>

namespace glassbox::app {

namespace {

constexpr double kLargest = double(std::numeric_limits<float>::max());

glm::dvec4 parse_point(const std::string& text) {
  const auto commas = std::count(text.begin(), text.end(), ',');
  if (commas != 2 && commas != 3) {
    throw CLI::ValidationError("--point", "needs X,Y,Z or X,Y,Z,W, not '" + text + "'");
  }
  const bool homogeneous = commas == 3;
  glm::dvec4 point(0, 0, 0, 1);
  if (homogeneous) {
    const auto [x, y, z, w] = parse_numbers<4>("--point", text);
    point = {x, y, z, w};
  } else {
    const auto [x, y, z] = parse_numbers<3>("--point", text);
    point = {x, y, z, 1};
  }
  for (int i = 0; i < 4; ++i) {
    if (std::abs(point[i]) > kLargest) {
      throw CLI::ValidationError("--point", "needs numbers that a float can hold, up to 3.4e38");
    }
  }
  return point;
}

std::array<double, 4> parse_window(const std::string& text) {
  const auto window = parse_numbers<4>("--viewport", text);
  constexpr double kEnd = 1 << 20;
  for (const double number : window) {
    if (std::abs(number) > kEnd) {
      throw CLI::ValidationError("--viewport", "needs numbers up to 1048576, not '" + text + "'");
    }
  }
  if (!(window[2] > 0 && window[3] != 0)) {
    throw CLI::ValidationError(
        "--viewport",
        "needs x,y,width,height with a positive width and a height, not '" + text + "'");
  }
  return window;
}

const ApiDialect& dialect_named(const std::string& name) {
  for (const ApiDialect& dialect : api_dialects()) {
    if (name == dialect.name) return dialect;
  }
  return api_dialects().front();
}

std::string point_text(const glm::vec4& p) {
  return p.w == 1 ? fmt::format("({}, {}, {})", p.x, p.y, p.z)
                  : fmt::format("({}, {}, {}, {})", p.x, p.y, p.z, p.w);
}

const char* order_word(NumberOrder order) {
  return order == NumberOrder::kRows ? "rows" : "columns";
}

}  // namespace

void StepCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "step", "a triangle of a scene, or a point through your own matrices, through every space");
  command.footer(
      "Examples:\n"
      "  glassbox step teapot --triangle 1000\n"
      "  glassbox step room --size 320x180 --pick 160,90 --bits\n"
      "  glassbox step model.glb --triangle 7 --vertex 0 --json trace.json\n"
      "  glassbox step --point 0,0,0 --view view.txt --proj proj.txt --size 1280x720\n"
      "  glassbox step --point 1,2,3 --model m.txt --view v.txt --proj p.txt --dialect vulkan\n"
      "  glassbox step --point 0,0,-5 --proj '1 0 0 0  0 1 0 0  0 0 -1.02 -0.202  0 0 -1 0'\n"
      "  myprogram | glassbox step --point 0,0,0 --point 1,1,1 --view - --proj proj.txt --json "
      "-\n\n"
      "A matrix is a file, - for standard input, or the sixteen numbers themselves, as your "
      "program\n"
      "prints them: brackets, commas and names do not matter. The first four are the first row of\n"
      "p' = M p, unless --order columns is given or the layout says otherwise (GLM's to_string "
      "does).\n"
      "Several points tell more than one. docs/step.md has the whole story.");
  scene_.add_to(command);
  command
      .add_option_function<std::vector<std::string>>(
          "--point",
          [this](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) points_.push_back(parse_point(text));
          },
          "the point in object space; again for more points")
      ->type_name("X,Y,Z[,W]")
      ->allow_extra_args(false)
      ->group("Your own matrices");
  const auto add_matrix = [&](const char* name, std::optional<std::string>& source,
                              const char* help) {
    command.add_option(name, source, help)->type_name("FILE|-|NUMBERS")->group("Your own matrices");
  };
  add_matrix("--model", model_, "world from object; the identity where it is not given");
  add_matrix("--view", view_, "eye from world");
  add_matrix("--proj", projection_, "clip from eye; a product with the view will do, too");
  command
      .add_option_function<std::string>(
          "--order",
          [this](const std::string& text) {
            if (text != "rows" && text != "columns") {
              throw CLI::ValidationError("--order", "needs rows or columns, not '" + text + "'");
            }
            order_ = text == "rows" ? NumberOrder::kRows : NumberOrder::kColumns;
          },
          "what the numbers list first: rows of p' = M p, or columns (rows of p M)")
      ->type_name("rows|columns")
      ->group("Your own matrices");
  std::string names;
  for (const ApiDialect& dialect : api_dialects()) {
    names += (names.empty() ? "" : "|") + std::string(dialect.name);
  }
  command
      .add_option_function<std::string>(
          "--dialect",
          [this, names](const std::string& text) {
            dialect_ = CLI::detail::to_lower(text);
            if (dialect_named(*dialect_).name != *dialect_) {
              throw CLI::ValidationError("--dialect",
                                         "needs one of " + names + ", not '" + text + "'");
            }
          },
          "whose clip space and window; else what the projection looks made for")
      ->type_name(names)
      ->group("Your own matrices");
  command
      .add_option_function<std::string>(
          "--world",
          [this](const std::string& text) {
            if (text != "right" && text != "left") {
              throw CLI::ValidationError("--world", "needs right or left, not '" + text + "'");
            }
            world_ = text == "right" ? Hand::kRight : Hand::kLeft;
          },
          "the handedness of your world, if you know it")
      ->type_name("right|left")
      ->group("Your own matrices");
  command
      .add_option_function<std::string>(
          "--viewport", [this](const std::string& text) { window_ = parse_window(text); },
          "the window's rectangle, as glViewport takes it")
      ->type_name("X,Y,W,H")
      ->group("Your own matrices")
      ->excludes(command.get_option("--size"));
  command
      .add_option_function<std::vector<std::string>>(
          "--expect",
          [this](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) {
              const auto [x, y] = parse_numbers<2>("--expect", text);
              expected_.push_back({x, y});
            }
          },
          "where the point ought to appear; again for further points, in order")
      ->type_name("X,Y")
      ->allow_extra_args(false)
      ->group("Your own matrices");
  command.add_flag("--bits", bits_, "the bits of each float, too, in hexadecimal")
      ->group("Other outputs");
  command.add_option("--json", json_output_, "the same as JSON; - is standard output")
      ->type_name("FILE|-")
      ->group("Other outputs");
  command.callback([this, &exit_code] { exit_code = run(); });
}

Result<void> StepCommand::read_matrix(const char* option, const std::optional<std::string>& source,
                                      GivenMatrix& matrix, std::string& origin) {
  if (!source) return {};
  const auto located = [&](Error error) {
    error.place = error.place.empty() ? option : std::string(option) + ", " + error.place;
    return tl::unexpected(std::move(error));
  };
  const auto read = read_matrix_source(*source);
  if (!read) return located(read.error());
  const auto parsed = parse_matrix_text(read->text, read->name);
  if (!parsed) return located(parsed.error());
  const NumberOrder order = order_of(*parsed, order_);
  matrix = to_matrix(*parsed, order);
  origin = fmt::format("{}, read by {}", printable(read->name), order_word(order));
  if (!parsed->recognised.empty()) origin += fmt::format(" ({})", parsed->recognised);
  return {};
}

Result<void> StepCommand::read_matrices() {
  const std::optional<std::string>* sources[] = {&model_, &view_, &projection_};
  if (std::count_if(std::begin(sources), std::end(sources),
                    [](const auto* source) { return *source && **source == "-"; }) > 1) {
    return fail("--model, --view, --proj", "more than one of them is standard input",
                "put the others into files");
  }
  if (const auto read = read_matrix("--model", model_, setup_.model, origins_.model); !read)
    return read;
  if (const auto read = read_matrix("--view", view_, setup_.view, origins_.view); !read)
    return read;
  return read_matrix("--proj", projection_, setup_.projection, origins_.projection);
}

void StepCommand::choose_dialect() {
  guess_or_ask();
  if (!window_ || (*window_)[3] > 0) return;
  // A viewport of negative height, as Vulkan has it, turns y over: the same as a clip space with y the other way.
  auto& [x, y, width, height] = *window_;
  y += height;
  height = -height;
  setup_.dialect.ndc_y_down = !setup_.dialect.ndc_y_down;
}

void StepCommand::guess_or_ask() {
  if (dialect_) {
    setup_.dialect = dialect_named(*dialect_);
    dialect_reason_ = "as asked";
    return;
  }
  const GuessedDialect guess = guess_dialect(setup_.projection);
  setup_.dialect = *guess.dialect;
  dialect_reason_ = "guessed: " + guess.reason;
}

Viewport StepCommand::viewport() const {
  const auto [x, y, width, height] = window_.value_or(std::array<double, 4>{0, 0, 1280, 720});
  return window_rectangle(setup_.dialect, float(x), float(y), float(width), float(height));
}

ChainSetting StepCommand::chain_setting() const {
  return {setup_.dialect, viewport(), projection_facts(setup_.projection, setup_.dialect.depth),
          bits_, std::nullopt};
}

std::string StepCommand::verdict(const std::vector<VertexChain>& chains) const {
  std::string text = "VERDICT\n";
  for (const VertexChain& chain : chains) {
    std::string line = point_text(chain.object) + " is " + fate_text(chain, chain_setting());
    if (chain.fate == VertexFate::kVisible) {
      const Point<Screen>& p = chain.screen->screen.position;
      line += fmt::format(" at ({:.2f}, {:.2f})", p.x, p.y);
    }
    if (chain.object.w == 0) line += "; w = 0 makes it a direction, which no translation moves";
    text += wrapped("  ", line);
  }
  text += findings_text(findings_);
  if (report_.visible == report_.points) return text;
  if (report_.points > 1 && report_.behind_eye > 0) {
    text += wrapped(
        "  ", fmt::format("w is negative for {} of {} points", report_.behind_eye, report_.points));
  }
  if (report_.alternatives.empty()) {
    const bool alarmed =
        std::any_of(findings_.begin(), findings_.end(),
                    [](const Finding& finding) { return finding.severity == Severity::kAlarm; });
    return text +
           wrapped("  ", alarmed ? "No other change of convention brings it into the picture: mend "
                                   "what is wrong first"
                                 : "No change of convention that is tried here brings it into the "
                                   "picture: look where it stands, and what the camera sees");
  }
  const bool pairs = report_.alternatives.front().second.has_value();
  const char* where = expected_.empty() ? "in the picture" : "where it is expected";
  text += "\n" +
          wrapped("  ", fmt::format("If the point{} ought to be {}, {} would do{}:",
                                    chains.size() == 1 ? "" : "s", where,
                                    pairs ? "two changes together" : "one of these changes",
                                    report_.alternatives.size() == 1
                                        ? ""
                                        : " (the likeliest first; what was meant only you know)"));
  return text + alternatives_text(report_);
}

std::string StepCommand::text(const std::vector<VertexChain>& chains) const {
  const auto [x, y, width, height] = window_.value_or(std::array<double, 4>{0, 0, 1280, 720});
  std::string text = wrapped(
      "", fmt::format("{} ({}), window {} x {} pixels{}", setup_.dialect.title, dialect_reason_,
                      width, height, x == 0 && y == 0 ? "" : fmt::format(" at ({}, {})", x, y)));
  text += "\n" + matrices_text(setup_, origins_);
  ChainSetting setting = chain_setting();
  for (std::size_t i = 0; i < chains.size(); ++i) {
    const VertexChain& chain = chains[i];
    setting.open_px = open_px_[i];
    text += "\nPOINT " + point_text(chain.object) + "\n" + chain_text(chain, setting);
  }
  return text + "\n" + verdict(chains);
}

nlohmann::ordered_json StepCommand::json(const std::vector<VertexChain>& chains) const {
  const auto [x, y, width, height] = window_.value_or(std::array<double, 4>{0, 0, 1280, 720});
  nlohmann::ordered_json json{{"schema", "glassbox-step-point-1"},
                              {"dialect", setup_.dialect.name},
                              {"dialect_reason", dialect_reason_},
                              {"viewport", {x, y, width, height}}};
  json["matrices"] = matrices_json(setup_, origins_);
  ChainSetting setting = chain_setting();
  json["points"] = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < chains.size(); ++i) {
    setting.open_px = open_px_[i];
    json["points"].push_back(chain_json(chains[i], setting));
  }
  json["findings"] = findings_json(findings_);
  json["visible"] = report_.visible;
  json["behind_eye"] = report_.behind_eye;
  json["alternatives"] = alternatives_json(report_);
  json["spoiling_alternatives"] = report_.spoiling;
  return json;
}

ChainMatrices StepCommand::chain_matrices() const {
  return {Transform<World, Object, float>(glm::mat4(setup_.model.m)),
          Transform<Eye, World, float>(glm::mat4(setup_.view.m)),
          Transform<Clip, Eye, float>(glm::mat4(setup_.projection.m))};
}

// What the digits add to the bounds of the window's coordinates.
double StepCommand::open_px(const glm::vec4& point, const VertexChain& chain) const {
  if (!chain.screen) return 0;
  ChainMatrices printed = chain_matrices();
  printed.world_from_object_bound = setup_.model.uncertainty;
  printed.eye_from_world_bound = setup_.view.uncertainty;
  printed.clip_from_eye_bound = setup_.projection.uncertainty;
  const VertexChain open = walk(point, printed, setup_.dialect, viewport());
  return std::max(open.screen->bound.x - chain.screen->bound.x,
                  open.screen->bound.y - chain.screen->bound.y);
}

int StepCommand::run() {
  if (scene_.is_asked_for() && !points_.empty()) {
    return refuse({"", "--point", "a scene is named, too",
                   "give a scene and a triangle, or points and matrices"});
  }
  if (scene_.is_asked_for()) return scene_.run(bits_, json_output_);
  if (points_.empty()) {
    return refuse({"", "", "there is nothing to step through",
                   "give a scene and --triangle N, or --point X,Y,Z and your matrices"});
  }
  return step_points();
}

int StepCommand::step_points() {
  const std::vector<std::string> words = words_given(scene_.picture());
  if (std::find(words.begin(), words.end(), "--size") != words.end()) {
    window_ = {0, 0, double(scene_.picture().size.width), double(scene_.picture().size.height)};
  }
  if (!model_ && !view_ && !projection_) {
    return refuse({"", "", "there is no matrix to go through",
                   "give at least one of --model, --view and --proj"});
  }
  if (expected_.size() > points_.size()) {
    return refuse(
        {"", "--expect", "there are more expected places than points", "give one for each"});
  }
  if (const auto read = read_matrices(); !read) return refuse(read.error());
  choose_dialect();
  setup_.world = world_;
  if (window_ && (*window_)[2] >= 1 && (*window_)[3] >= 1) {
    setup_.picture = glm::ivec2(int((*window_)[2]), int((*window_)[3]));
  }

  const ChainMatrices matrices = chain_matrices();
  std::vector<VertexChain> chains;
  std::vector<CheckedPoint> checked;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const glm::vec4 point(points_[i]);
    chains.push_back(walk(point, matrices, setup_.dialect, viewport()));
    open_px_.push_back(open_px(point, chains.back()));
    checked.push_back({points_[i], std::nullopt});
    if (i < expected_.size()) checked.back().expected = expected_[i];
  }
  findings_ = check_matrices(setup_);
  report_ = check_conventions(setup_, viewport(), checked);

  if (json_output_) {
    if (const auto written = write_json(*json_output_, json(chains)); !written) {
      return refuse(written.error());
    }
    if (*json_output_ == "-") return kSuccess;
  }
  fmt::print("{}", text(chains));
  return kSuccess;
}

}  // namespace glassbox::app
