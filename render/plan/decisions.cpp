#include <glassbox/render/plan/decisions.h>

#include <algorithm>

#include <fmt/format.h>

#include <glassbox/raster/texture.h>
#include <glassbox/render/engine/object_cull.h>

namespace glassbox {

namespace {

struct Subject {
  const Plan& plan;
  const PlannedEye& eye;
  const Draw& draw;
  const DrawMethod& method;
};

Decision needed(const char* stage, std::string because, std::string numbers = {}) {
  return {stage, true, std::move(because), std::move(numbers)};
}
Decision left_out(const char* stage, std::string because, std::string numbers = {}) {
  return {stage, false, std::move(because), std::move(numbers)};
}

std::string in_all(const char* what, std::size_t count) {
  return fmt::format("{} {}", count, what);
}

// Names the box that the decision uses: the draw's own, or that of its group of instances.
const char* box_of(const BoxClassification& classification) {
  return classification.of_group ? "the box of its group of instances" : "its box";
}

// ---- the stages, in order ----

Decision whole_object(const Subject& s) {
  constexpr const char* kStage = "the whole draw";
  const BoxClassification& classification = s.method.classification;
  if (s.method.hidden) {
    const char* const where =
        "wherever its box may be visible, opaque triangles drawn before it are at least as near as "
        "its own";
    return s.method.drawn ? needed(kStage, "the other eye may see it", where)
                          : left_out(kStage, where);
  }
  if (classification.outside_of == nullptr) {
    return needed(kStage, s.draw.prepared->all_finite
                              ? fmt::format("{} is not entirely outside a plane of the frustum",
                                            box_of(classification))
                              : std::string("a position is not finite, so its box cannot be used"));
  }
  const std::string numbers =
      fmt::format("outside it by at least {:.3g} in clip space", classification.distance);
  if (!s.method.drawn) {
    return left_out(
        kStage,
        fmt::format("all corners of {}, rounding included, are outside a plane of the view: {}",
                    box_of(classification), classification.outside_of),
        numbers);
  }
  return needed(kStage, s.plan.leaves_out ? "the other eye may see it" : kNoPlan, numbers);
}

// This decision is made only for meshes that have clusters.
Decision clusters(const Subject& s) {
  constexpr const char* kStage = "triangles out of sight";
  const std::string numbers = in_all("clusters", s.draw.prepared->clusters.clusters.size());
  if (s.method.no_clusters_because == nullptr) {
    return left_out(kStage,
                    "a cluster of 64 is removed before its vertices are transformed if its box is "
                    "outside a plane, or if the cone of its normals faces away by more than "
                    "snapping and float can change",
                    numbers);
  }
  return needed(kStage, s.method.no_clusters_because, numbers);
}

// This decision is made only for small meshes with several instances.
Decision alone(const Subject& s) {
  constexpr const char* kStage = "a draw by itself";
  if (s.method.alone_because != nullptr) return needed(kStage, s.method.alone_because);
  const PreparedMesh& mesh = *s.draw.prepared;
  return left_out(kStage,
                  "consecutive instances of its mesh share one list of triangles once their "
                  "vertices are on the screen",
                  fmt::format("at most {} together",
                              mesh.joined.positions.size() / mesh.indices.positions.size()));
}

Decision duplicate_vertices(const Subject& s) {
  constexpr const char* kStage = "repeated vertices";
  const std::size_t corners = s.draw.prepared->indices.positions.size();
  const std::size_t positions = s.draw.mesh->positions.size();
  const std::string numbers = fmt::format("{} corners, {} positions", corners, positions);
  if (corners <= positions) {
    return needed(kStage, "no two corners share a position, or not all positions are drawn",
                  numbers);
  }
  return left_out(kStage,
                  "corners refer to positions by index, and each position is transformed once",
                  numbers);
}

Decision plane_tests(const Subject& s) {
  constexpr const char* kStage = "clip test of vertices";
  const BoxClassification& classification = s.method.classification;
  if (!s.method.test_planes) {
    return left_out(
        kStage,
        fmt::format("{} is inside all clipping planes, rounding included", box_of(classification)),
        fmt::format("{:.3g} from the nearest of the near, eye and far planes",
                    classification.distance));
  }
  if (classification.inside) return needed(kStage, kNoPlan);
  return needed(kStage, "its box reaches one of the clipping planes",
                in_all("positions", s.draw.mesh->positions.size()));
}

Decision side_clipping(const Subject& s) {
  constexpr const char* kStage = "clipping in x and y";
  if (s.method.classification.in_guard_band) {
    return left_out(kStage, fmt::format("{} is inside the guard band (32768 px around the centre), "
                                        "where the edge functions fit into integers",
                                        box_of(s.method.classification)));
  }
  return needed(kStage, "its box may leave the guard band");
}

// This decision is reported only if --cull-stage object is set; otherwise the area on the screen
// always decides.
Decision early_culling(const Subject& s) {
  constexpr const char* kStage = "culling in object space";
  const ObjectCulling culling = object_culling(s.draw, s.eye.view, s.eye.settings);
  if (!culling.test) return left_out(kStage, culling.because);
  return needed(kStage, culling.because,
                in_all("triangles", s.draw.triangulation->triangles.size()));
}

Decision divide(const Subject& s) {
  constexpr const char* kStage = "divide by w";
  if (!s.method.divide) {
    return left_out(kStage, "parallel view: the last row of the matrix is 0 0 0 1, so that w is 1");
  }
  return needed(kStage, s.eye.view.perspective ? "perspective: w is the distance along the gaze"
                        : s.plan.leaves_out    ? "w may differ from 1"
                                               : kNoPlan);
}

Decision perspective(const Subject& s) {
  constexpr const char* kStage = "perspective correction";
  if (!s.method.divide)
    return left_out(kStage, "w is 1 at every vertex: perspective changes nothing");
  return needed(kStage,
                "decided triangle by triangle: where the three w are equal it changes nothing");
}

Decision eye_normals(const Subject& s) {
  constexpr const char* kStage = "normals to eye space";
  const std::size_t count =
      s.draw.mesh->normals.size() + (s.method.face_normals ? s.draw.mesh->faces.size() : 0);
  if (!s.method.normals) {
    return left_out(kStage, s.plan.colors ? "nothing is lit" : "no colours are requested",
                    in_all("normals", count));
  }
  const bool lit = s.method.light != LightAt::kNowhere;
  return needed(kStage,
                lit                 ? "light depends on them"
                : s.plan.leaves_out ? "the other eye's light depends on them"
                                    : kNoPlan,
                in_all("normals", count));
}

Decision eye_positions(const Subject& s) {
  constexpr const char* kStage = "positions to eye space";
  const std::string numbers = in_all("positions", s.draw.mesh->positions.size());
  if (s.method.eye_positions) {
    if (!s.plan.leaves_out) return needed(kStage, kNoPlan, numbers);
    if (s.method.light == LightAt::kVertices) {
      return needed(kStage, "light is computed at the vertices", numbers);
    }
    return needed(kStage, "a light, or the highlights, depend on where the surface is", numbers);
  }
  return left_out(
      kStage,
      s.method.light == LightAt::kNowhere
          ? "nothing is lit"
          : "lights are directional, and there are no highlights that depend on the viewer",
      numbers);
}

bool is_textured(const Draw& draw) {
  return draw.texture != nullptr || draw.emission_texture != nullptr;
}

Decision texture_coordinates(const Subject& s) {
  constexpr const char* kStage = "texture coordinates";
  if (s.method.staged_because != nullptr) {
    return needed(kStage, "a staged draw interpolates all attributes");
  }
  if (s.method.texture) return needed(kStage, "the material has a texture");
  if (s.method.emission_texture) return needed(kStage, "the emission has a texture");
  return left_out(kStage, !is_textured(s.draw) ? "there is no texture"
                          : s.plan.colors      ? "the picture does not show the texture"
                                               : "no colours are requested");
}

Decision mip_selection(const Subject& s) {
  constexpr const char* kStage = "choice of a mip level";
  const bool staged = s.method.staged_because != nullptr;
  if (!is_textured(s.draw) || (!staged && !s.method.texture && !s.method.emission_texture)) {
    return left_out(kStage, "no texture is sampled");
  }
  if (staged) return needed(kStage, "a staged draw always chooses one");
  if ((!s.method.texture || samples_base_only(*s.draw.sampler)) &&
      (!s.method.emission_texture || samples_base_only(*s.draw.emission_sampler))) {
    return left_out(kStage, "the sampler uses only the base level, with one filter");
  }
  return needed(kStage, "the sampler has levels or filters to choose from");
}

Decision light(const Subject& s) {
  constexpr const char* kStage = "light";
  if (s.method.light == LightAt::kNowhere) {
    return left_out(kStage, !s.plan.colors                        ? "no colours are requested"
                            : s.draw.material->unlit              ? "the material is not lit"
                            : s.eye.settings.show != Show::kColor ? "the picture shows no light"
                                                                  : "shading is off");
  }
  const bool blended = s.draw.material->alpha_mode == AlphaMode::kBlend;
  return needed(kStage, s.method.light == LightAt::kVertices
                            ? "at the vertices, because of flat or Gouraud shading"
                        : blended
                            ? "for every fragment that passes the depth test, because it is blended"
                            : "only for fragments that are visible at a pixel");
}

Decision highlights(const Subject& s) {
  constexpr const char* kStage = "highlights";
  if (s.method.light == LightAt::kNowhere) return left_out(kStage, "nothing is lit");
  if (s.method.staged_because != nullptr) {
    return needed(kStage, "a staged draw computes them with the light");
  }
  if (!s.method.highlights) return left_out(kStage, "the material's specular colour is 0");
  return needed(kStage, s.plan.leaves_out ? "the material's specular colour is not 0" : kNoPlan);
}

Decision emission(const Subject& s) {
  constexpr const char* kStage = "emission";
  if (s.method.light == LightAt::kNowhere) return left_out(kStage, "the picture shows no light");
  if (s.draw.emits()) return needed(kStage, "the material emits light");
  if (s.method.emission) return needed(kStage, kNoPlan);
  return left_out(kStage, "the material emits no light");
}

Decision blending(const Subject& s) {
  constexpr const char* kStage = "colour read-back";
  if (s.draw.material->alpha_mode == AlphaMode::kBlend) {
    return needed(kStage, "it is blended with what is behind it");
  }
  return left_out(kStage, "it is opaque where it is drawn");
}

}  // namespace

std::vector<Decision> decisions(const Plan& plan, const PlannedEye& eye, std::size_t draw) {
  const Subject s{plan, eye, eye.list.draws[draw], plan.methods[draw]};
  if (!s.method.drawn) return {whole_object(s)};
  std::vector<Decision> all{whole_object(s),
                            duplicate_vertices(s),
                            plane_tests(s),
                            side_clipping(s),
                            divide(s),
                            eye_normals(s),
                            eye_positions(s),
                            perspective(s),
                            texture_coordinates(s),
                            mip_selection(s),
                            light(s),
                            highlights(s),
                            emission(s),
                            blending(s)};
  if (!s.draw.prepared->clusters.clusters.empty()) all.insert(all.begin() + 1, clusters(s));
  if (!s.draw.prepared->joined.positions.empty()) all.insert(all.begin() + 1, alone(s));
  if (eye.settings.cull_stage == CullStage::kObject) all.push_back(early_culling(s));
  return all;
}

namespace {

Decision colors(const Plan& plan, const PlannedEye& eye) {
  constexpr const char* kStage = "colours";
  if (!plan.leaves_out) return needed(kStage, kNoPlan);
  if (plan.colors && eye.settings.show == Show::kId) {
    return needed(
        kStage,
        "lines and points, which have no triangle number, are blended with what is behind them");
  }
  if (plan.colors && samples_drawn(eye.settings) > 1) {
    return needed(kStage,
                  "the picture shows them; computed once for each pixel and each triangle that one "
                  "of its samples shows");
  }
  if (plan.colors) {
    return needed(
        kStage, "the picture shows them; computed once for each pixel that shows something opaque");
  }
  const bool staged = std::ranges::any_of(
      plan.order, [&](std::uint32_t i) { return plan.methods[i].staged_because != nullptr; });
  if (staged)
    return needed(kStage, "the picture does not show them, but the staged draws compute them");
  return left_out(kStage,
                  eye.settings.show == Show::kColor
                      ? "no channel is written"
                      : "the picture is made from another plane of the framebuffer after drawing");
}

Decision masked_channels(const Plan& plan, const RenderSettings& settings) {
  constexpr const char* kStage = "encoding of channels";
  const ColorMask& mask = settings.mask;
  if (mask.r && mask.g && mask.b) return needed(kStage, "red, green and blue are written");
  if (!plan.leaves_out) return needed(kStage, kNoPlan);
  if (!plan.colors) return left_out(kStage, "no channel is written");
  return left_out(kStage, "channels that the mask does not let through are not encoded",
                  fmt::format("written: {}{}{}", mask.r ? "red " : "", mask.g ? "green " : "",
                              mask.b ? "blue" : ""));
}

// Reports which channels are shaded, only if the mask removes some; otherwise all are shaded.
void add_shaded_channels(const Plan& plan, const RenderSettings& settings,
                         std::vector<Decision>& decisions) {
  constexpr const char* kStage = "light of channels";
  const ColorMask& mask = settings.mask;
  if ((mask.r && mask.g && mask.b) || !plan.colors) return;
  if (!plan.leaves_out) {
    decisions.push_back(needed(kStage, kNoPlan));
  } else if (mask.r && mask.b) {
    decisions.push_back(needed(
        kStage,
        "red and blue are both written, and only neighbouring channels can be computed alone"));
  } else if (samples_drawn(settings) > 1) {
    decisions.push_back(needed(kStage, "with several samples all three channels are computed"));
  } else {
    decisions.push_back(left_out(
        kStage,
        fmt::format("{} is not computed for opaque pixels, because no channel depends on another",
                    mask.r ? "blue" : "red")));
  }
}

// Reports what happens to samples, only if there is more than one per pixel.
void add_samples(const RenderSettings& settings, std::vector<Decision>& decisions) {
  constexpr const char* kStage = "samples";
  if (settings.samples == 1) return;
  const std::string numbers = fmt::format("{} per pixel", settings.samples);
  if (samples_drawn(settings) == 1) {
    decisions.push_back(left_out(
        kStage, "a picture of depths, triangle numbers or overdraw shows values at pixel centres",
        numbers));
  } else {
    decisions.push_back(needed(
        kStage, "each has a depth and a colour; a pixel shows the mean of its samples' colours",
        numbers));
  }
}

Decision depth_plane(const Plan& plan) {
  constexpr const char* kStage = "depth plane";
  if (plan.keep_depth) {
    return needed(kStage, plan.leaves_out ? "requested" : kNoPlan);
  }
  return left_out(kStage,
                  "not requested: depths stay in the tile's buffer, unless staged draws or a "
                  "second round of draws read them");
}

Decision file_order(const Plan& plan) {
  constexpr const char* kStage = "file order";
  if (!plan.leaves_out) return needed(kStage, kNoPlan);
  const auto compared = std::ranges::count_if(
      plan.methods, [](const DrawMethod& method) { return method.drawn || method.hidden; });
  if (compared < 2) return needed(kStage, "there are no two draws to compare");
  if (plan.moved == 0) {
    return needed(kStage, "no draw is entirely in front of an earlier one that it may overtake");
  }
  return left_out(kStage,
                  "nearer draws come first if their ranges of depth codes do not overlap, so no "
                  "tie is decided differently",
                  fmt::format("{} draws have overtaken others", plan.moved));
}

}  // namespace

std::vector<Decision> decisions(const Plan& plan, const PlannedEye& eye) {
  std::vector<Decision> all{file_order(plan), colors(plan, eye),
                            masked_channels(plan, eye.settings), depth_plane(plan)};
  add_shaded_channels(plan, eye.settings, all);
  add_samples(eye.settings, all);
  return all;
}

std::string describe_method(const DrawMethod& method) {
  if (!method.drawn) return "not drawn";
  if (method.staged_because != nullptr) {
    return std::string("staged, tile by tile: ") + method.staged_because;
  }
  if (method.large_because != nullptr) {
    return std::string("in SIMD lanes, each triangle set up by itself: ") + method.large_because;
  }
  return "in SIMD lanes";
}

}  // namespace glassbox
