#include <glassbox/render/tile/tile_picture.h>

#include <algorithm>
#include <limits>

#include <glassbox/render/engine/show_plane.h>

namespace glassbox {

namespace {

TileRun make_run(const EyePicture& eye, const DrawList& list, const Plan& plan, int tile_side) {
  TileRun run{eye.view, eye.settings, list, plan.methods, render_planes(eye.view), {}, tile_side};
  run.window = {0, 0, int(eye.view.viewport.width()), int(eye.view.viewport.height())};
  return run;
}

// Makes the data for shading the triangles of a slot's draws.
ShadeDraw shade_draw(const TileRun& run, const DrawSlot& slot) {
  const Draw& draw = run.list.draws[slot.draw];
  const DrawMethod& method = run.methods[slot.draw];
  const CornerIndices& indices = *slot.indices;
  const auto or_positions = [&](const std::vector<std::uint32_t>& own) {
    return own.empty() ? indices.positions.data() : own.data();
  };
  ShadeDraw shade;
  shade.first_reference = slot.first_reference;
  shade.end_reference =
      slot.first_reference +
      Reference(slot.draws.size() * draw.triangulation->triangles.size()) * kReferenceStep;
  shade.positions = indices.positions.data();
  shade.screen = slot.screen;
  shade.mirrored = draw.mirrored;
  shade.shows_backs = method.keep_back;
  shade.triangles = draw.triangulation->triangles.data();
  shade.first_number = draw.first_number;
  shade.material = draw.material;
  shade.light = method.light;
  shade.highlights = method.highlights;
  shade.w_is_one = !method.divide;
  if (method.light != LightAt::kNowhere) {
    shade.normal_indices = or_positions(indices.normals);
    shade.normals = slot.eye_space.normals.data();
  }
  if (run.settings.shading == Shading::kFlat && method.light != LightAt::kNowhere) {
    shade.faces = draw.mesh->faces.data();
    shade.corners = draw.mesh->corners.data();
    shade.face_normals = slot.eye_space.face_normals.data();
  }
  if (method.eye_positions) shade.eye_positions = slot.eye_space.positions.data();
  if (method.texture) {
    shade.texture = draw.texture;
    shade.sampler = draw.sampler;
  }
  shade.emits = method.emission;
  shade.emission = draw.emission;
  if (method.emission_texture) {
    shade.emission_texture = draw.emission_texture;
    shade.emission_sampler = draw.emission_sampler;
  }
  if ((method.texture || method.emission_texture) && indices.has_texcoords) {
    shade.texcoord_indices = or_positions(indices.texcoords);
    shade.texcoords = draw.mesh->texcoords.data();
  }
  if (method.vertex_colors) {
    shade.color_indices = or_positions(indices.colors);
    shade.colors = draw.mesh->colors.data();
  }
  return shade;
}

// Prepares an image of the framebuffer: of the picture's size, or empty if it is not wanted. It is
// cleared only if `clear` is set; otherwise all of it is overwritten later.
template <class Pixel>
void prepare_plane(const PixelRect& window, bool wanted, bool clear, Pixel empty,
                   Image<Pixel>& plane) {
  if (!wanted) {
    plane = {};
  } else if (plane.width != window.x1 || plane.height != window.y1) {
    plane = {window.x1, window.y1, empty};
  } else if (clear) {
    std::ranges::fill(plane.pixels, empty);
  }
}

}  // namespace

TilePicture::TilePicture(const EyePicture& eye, const DrawList& list, const Plan& plan,
                         int tile_side)
    : eye_(eye), list_(list), plan_(plan), run_(make_run(eye, list_, plan_, tile_side)) {}

void TilePicture::count_input() const {
  Statistics& statistics = eye_.statistics;
  statistics.instances = list_.draws.size();
  statistics.triangles = list_.triangle_count;
  statistics.degenerate = list_.degenerate;
  statistics.lines = list_.lines;
  statistics.points = list_.points;
  for (std::size_t i = 0; i < list_.draws.size(); ++i) {
    if (!plan_.methods[i].drawn) {
      statistics.left_out += list_.draws[i].triangulation->triangles.size();
    }
  }
}

// Whether some draws need the framebuffer while they are drawn (DrawMethod::into_framebuffer).
bool TilePicture::draws_into_framebuffer() const {
  return std::ranges::any_of(plan_.order,
                             [&](std::uint32_t i) { return run_.methods[i].into_framebuffer; });
}

void TilePicture::prepare_framebuffer(bool one_round) {
  const RenderSettings& s = eye_.settings;
  Framebuffer& target = eye_.target;
  const int samples = samples_drawn(s);
  // Whether depths and colours are read back from the framebuffer.
  const bool through_framebuffer = !one_round || draws_into_framebuffer();
  const bool keep_always = !one_round || !plan_.colors || plan_.read_back || eye_.draws_over();
  keep_picture_ = through_framebuffer || keep_always;
  overwrite_untouched_ = keep_picture_ && !keep_always;
  store_depth_ = !one_round || plan_.keep_depth;
  const auto prepare = [&](bool wanted, auto empty, auto& plane) {
    prepare_plane(run_.window, wanted, keep_picture_, empty, plane);
  };
  prepare(!eye_.draws_over(), s.background, target.color);
  // Depths are cleared only if tiles read them from the framebuffer; otherwise each tile overwrites
  // its depths.
  prepare_plane(run_.window, through_framebuffer || plan_.keep_depth, through_framebuffer,
                kEmptyDepth, target.depth);
  prepare(s.want_distance || s.show == Show::kDepth, std::numeric_limits<float>::infinity(),
          target.distance);
  prepare(s.want_id || s.show == Show::kId, std::uint32_t{0}, target.id);
  prepare(s.show == Show::kOverdraw, std::uint32_t{0}, target.writes);
  std::ranges::fill(target.writes.pixels, 0u);  // increased by the stages of the reference alone
  if (samples > 1 && !one_round) target.samples.clear(run_.window, samples, eye_.color);
}

TilePass TilePicture::pass(const Kernels& kernels, const DrawRound& round, bool first_round) {
  shades_.clear();
  by_reference_.clear();
  for (const DrawSlot& slot : round.slots) {
    by_reference_.push_back(std::uint32_t(shades_.size()));
    shades_.push_back(shade_draw(run_, slot));
  }
  const auto if_there = [](auto& plane) { return plane.pixels.empty() ? nullptr : &plane; };
  const View& view = eye_.view;
  TilePass pass{.run = run_,
                .kernels = kernels,
                .round = round,
                .resolve = {},
                .target = eye_.target,
                .color = eye_.color,
                .overwrite_untouched = overwrite_untouched_,
                .load_depth = !first_round,
                .store_depth = store_depth_,
                .behind_depth = eye_.behind_depth};
  ResolveJob& resolve = pass.resolve;
  resolve.draws = shades_;
  resolve.by_reference = by_reference_;
  resolve.large = round.large.data();
  resolve.lighting = &list_.lighting;
  resolve.transfer = eye_.settings.transfer;
  resolve.mask = eye_.settings.mask;
  resolve.channels = plan_.channels;
  resolve.background = eye_.settings.background;
  resolve.keep_picture = keep_picture_;
  resolve.picture = plan_.colors ? &eye_.color : nullptr;
  resolve.distance = if_there(eye_.target.distance);
  resolve.id = if_there(eye_.target.id);
  resolve.perspective = view.perspective;
  resolve.near = view.near;
  resolve.far = view.far;
  resolve.reversed = view.depth_range == DepthRange::kReversed;
  return pass;
}

void TilePicture::finish() const {
  resolve_samples(eye_.settings, eye_.target, eye_.color);
  if (!eye_.draws_over()) show_plane(eye_.settings.show, eye_.target);
}

}  // namespace glassbox
