#include <glassbox/render/trace/verdict.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include <glm/matrix.hpp>

#include <glassbox/mesh/triangulate.h>
#include <glassbox/raster/snap.h>
#include <glassbox/raster/triangle_setup.h>
#include <glassbox/render/staged/staged.h>
#include <glassbox/render/trace/tracer.h>

namespace glassbox {

namespace {

PixelRect picture_of(const View& view) {
  return {0, 0, int(view.viewport.width()), int(view.viewport.height())};
}

// ---- the view ----

double depth_at(const Transform<Clip, Eye>& m, double eye_z) {
  const double w = m.at(3, 2) * eye_z + m.at(3, 3);
  return (m.at(2, 2) * eye_z + m.at(2, 3)) / w;
}

// ---- assembly ----

NoAreaVerdict no_area(const Scene& scene, const NumberedTriangle& triangle) {
  const Mesh& mesh = scene.meshes[scene.instances[triangle.instance].mesh];
  const Face& face = mesh.faces[triangle.face];
  NoAreaVerdict found;
  for (std::uint32_t i = 0; i < face.count; ++i) {
    found.corners.push_back(mesh.positions[mesh.corners[face.first + i].position]);
  }
  for (std::size_t i = 0; i < found.corners.size(); ++i) {
    const bool repeated =
        std::count(found.corners.begin(), found.corners.end(), found.corners[i]) > 1;
    if (repeated) found.reason = NoArea::kRepeatedPosition;
  }
  const auto& whole = triangulate(mesh).degenerate_faces;
  if (face.count > 3 && std::binary_search(whole.begin(), whole.end(), triangle.face)) {
    found.reason = NoArea::kWholeFace;
  }
  return found;
}

// ---- clip ----

ClippedCorner clipped_corner(const TracedCorner& corner, const ClipPlane& plane, const View& view) {
  const Point<Clip>& p = corner.clip;
  ClippedCorner clipped{p, -corner.eye.z, signed_distance(plane, p), {}};
  if (p.w > 0) {
    const Viewport& window = view.viewport;
    const double w = p.w;
    clipped.screen = Point<Screen, double>{
        (p.x / w + 1) / 2 * double(window.width()) + double(window.left),
        (1 - p.y / w) / 2 * double(window.height()) + double(window.top), p.z / w};
  }
  return clipped;
}

ClippingVerdict clipping(const TracedTriangle& triangle, const Trace& trace, const View& view,
                         TriangleResult result) {
  ClippingVerdict found;
  if (result == TriangleResult::kClippedAway) {
    for (std::size_t i = 0; i < triangle.clipping.size(); ++i) {
      found.steps.push_back({trace.planes[i].name, triangle.clipping[i].after.count});
    }
    found.steps.back().vertices_left = 0;  // what is left has fewer than three different vertices
    found.plane = found.steps.size() - 1;
  } else {
    found.plane = first_outside_plane(triangle, trace.planes).value_or(0);
  }
  found.equation = trace.planes[found.plane];
  found.inside_opengl_depth = true;
  for (std::size_t k = 0; k < 3; ++k) {
    found.corners[k] = clipped_corner(triangle.corners[k], found.equation, view);
    const Point<Clip>& p = triangle.corners[k].clip;
    found.inside_opengl_depth = found.inside_opengl_depth && -p.w <= p.z && p.z <= p.w;
  }
  return found;
}

// ---- setup, cull, coverage ----

NoScreenAreaVerdict no_screen_area(const TracedPiece& piece) {
  NoScreenAreaVerdict found;
  for (std::size_t k = 0; k < 3; ++k) {
    found.screen[k] = piece.vertices[k].position;
    found.snapped[k] = snap(piece.vertices[k]);
  }
  const auto& [a, b, c] = found.screen;
  const double ux = double(b.x) - double(a.x), uy = double(b.y) - double(a.y);
  const double vx = double(c.x) - double(a.x), vy = double(c.y) - double(a.y);
  found.area_px2 = std::abs(ux * vy - uy * vx) / 2;
  return found;
}

CullVerdict culling(const Scene& scene, const View& view, const RenderSettings& settings,
                    const TracedTriangle& triangle, const TracedPiece& piece) {
  const Instance& instance = scene.instances[triangle.instance];
  const Transform<World, Object>& world_from_object = scene.nodes[instance.node].world_from_node;
  CullVerdict found;
  const double area = double(piece.setup->double_area) / (2.0 * kSubpixels * kSubpixels);
  found.area_px2 = piece.setup->clockwise ? -area : area;
  found.front = piece.front;
  found.mirrored = piece.front == piece.setup->clockwise;
  found.rule = settings.cull;
  found.double_sided = scene.materials[scene.meshes[instance.mesh].material].double_sided;
  if (const auto viewer =
          viewer_in_object_space(view.eye_from_world * world_from_object, view.perspective)) {
    const std::array<Point<Object>, 3> corners{
        triangle.corners[0].object, triangle.corners[1].object, triangle.corners[2].object};
    found.object_space = test_back_face(corners, *viewer);
  }
  return found;
}

// Returns the pixels of the picture whose centres are near the triangle.
PixelRect pixels_near(const TracedPiece& piece, const PixelRect& picture) {
  std::array<SnappedVertex, 3> snapped;
  for (std::size_t k = 0; k < 3; ++k) snapped[k] = snap(piece.vertices[k]);
  const PixelRect box = pixels_in_box(snapped);  // empty if between two columns of centres
  return intersect({box.x0 - 1, box.y0 - 1, box.x1 + 1, box.y1 + 1}, picture);
}

// For triangles of the fan that cover no centre in the picture: finds the smallest miss (the
// distance to a centre), or by how much they are outside the picture.
void judge_coverage(const TracedTriangle& triangle, const PixelRect& picture,
                    TriangleVerdict& verdict) {
  const auto size = [](const OutsideDistances& o) {
    return o.beyond_edge.value_or(double(std::max({o.left, o.top, o.right, o.bottom})));
  };
  for (const TracedPiece& piece : triangle.pieces) {
    if (!piece.setup || piece.culled) continue;
    if (const auto outside = outside_distances(piece, picture)) {
      if (!verdict.outside || size(*outside) < size(*verdict.outside)) verdict.outside = outside;
      continue;
    }
    const CentreMiss miss = nearest_miss(*piece.setup, pixels_near(piece, picture));
    if (!verdict.nearest_centre || miss.subpixels < verdict.nearest_centre->subpixels) {
      verdict.nearest_centre = miss;
    }
  }
  if (verdict.nearest_centre) verdict.outside.reset();
}

void judge_geometry(const Scene& scene, const View& view, const RenderSettings& settings,
                    const Trace& trace, const TracedTriangle& triangle, TriangleVerdict& verdict) {
  const PixelRect picture = picture_of(view);
  for (const TracedPiece& piece : triangle.pieces) {
    if (!piece.setup) {
      if (++verdict.pieces_without_area == 1) verdict.no_screen_area = no_screen_area(piece);
    } else if (piece.culled) {
      if (++verdict.pieces_turned_away == 1) {
        verdict.cull = culling(scene, view, settings, triangle, piece);
      }
    } else {
      ++verdict.pieces_set_up;
    }
  }
  verdict.result = result_before_fragments(triangle, trace.planes, settings, picture);
  switch (verdict.result) {
    case TriangleResult::kBehindEye:
    case TriangleResult::kOutsidePlane:
    case TriangleResult::kClippedAway:
      verdict.clipping = clipping(triangle, trace, view, verdict.result);
      break;
    case TriangleResult::kOutsidePicture:
      judge_coverage(triangle, picture, verdict);
      break;
    default:
      break;
  }
}

// ---- fragments ----

void judge_fragments(const Scene& scene, const View& view, const RenderSettings& settings,
                     TriangleVerdict& verdict) {
  const std::uint32_t number = verdict.triangle.number;
  ResultCounter counter(view, settings, number);
  DepthFights fights(view, settings.depth);
  render_staged(scene, view, with_one_sample(settings), {&counter, &fights});
  counter.finish();
  verdict.fights = fights.fights(scene);
  std::erase_if(verdict.fights, [&](const DepthFight& fight) {
    return fight.first != number && fight.second != number;
  });
  verdict.fragments = counter.entries()[number].fragments;
  verdict.details = counter.details();
  verdict.result = result_of(verdict.fragments, verdict.result);
  if (verdict.fragments.covered == 0) judge_coverage(*verdict.traced, picture_of(view), verdict);
}

}  // namespace

ViewConventions conventions_of(const View& view) {
  const Transform<Clip, Eye>& m = view.clip_from_eye;
  const bool reversed = view.depth_range == DepthRange::kReversed;
  ViewConventions found;
  found.right_handed_eye = glm::determinant(glm::dmat3(view.eye_from_world.columns)) > 0;
  // In the direction of the gaze w grows; in a parallel view, where w is 1, depth grows (with a
  // reversed range it falls).
  found.gaze_is_minus_z = view.perspective ? m.at(3, 2) < 0 : (m.at(2, 2) < 0) != reversed;
  found.hands_mixed = found.right_handed_eye != found.gaze_is_minus_z;
  found.near_depth = depth_at(m, found.gaze_is_minus_z ? -view.near : view.near);
  const double expected = reversed ? 1 : 0;
  found.opengl_range = std::abs(found.near_depth + 1) < std::abs(found.near_depth - expected);
  return found;
}

Result<TriangleVerdict> triangle_verdict(const Scene& scene, const View& view,
                                         const RenderSettings& settings, std::uint64_t number) {
  const auto triangle = find_triangle(scene, number);
  if (!triangle) {
    const std::uint64_t count = count_triangles(scene);
    return fail("triangle " + std::to_string(number),
                count == 0 ? "the scene has no triangles"
                           : "the scene has " + std::to_string(count) + " triangles, 0 .. " +
                                 std::to_string(count - 1),
                count == 0 ? "choose another scene" : "name one of these");
  }
  TriangleVerdict verdict;
  verdict.triangle = *triangle;
  verdict.conventions = conventions_of(view);
  TraceFilter filter;
  filter.triangle = triangle->number;
  filter.fragments = false;
  RenderSettings traced_settings = settings;
  traced_settings.want_id = settings.wireframe;
  const TracedRun run = trace(scene, view, traced_settings, filter);
  if (run.trace.triangles.empty()) {
    verdict.no_area = no_area(scene, *triangle);
    return verdict;
  }
  verdict.traced = run.trace.triangles.front();
  judge_geometry(scene, view, settings, run.trace, *verdict.traced, verdict);
  if (verdict.result == TriangleResult::kLines) {
    const auto& ids = run.rendering.buffers.id.pixels;
    verdict.line_pixels = std::uint64_t(std::count(ids.begin(), ids.end(), triangle->number + 1));
  } else if (verdict.result == TriangleResult::kBetweenCentres) {
    judge_fragments(scene, view, settings, verdict);
  }
  return verdict;
}

}  // namespace glassbox
