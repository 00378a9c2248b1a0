// A user's first program: it loads, frames, renders and writes a scene, and reads the picture back.
#include <cstdio>

#include <glassbox/images/read.h>
#include <glassbox/images/write.h>
#include <glassbox/mesh/formats/load.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/staged/staged.h>

namespace {

int refuse(const glassbox::Error& error) {
  std::fprintf(stderr, "%s\n", error.message().c_str());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  using namespace glassbox;
  constexpr int kWidth = 320, kHeight = 180;

  const Result<Scene> scene = load_scene("teapot");
  if (!scene) return refuse(scene.error());
  const Result<Camera> camera = framing_camera(*scene, double(kWidth) / kHeight);
  if (!camera) return refuse(camera.error());
  const Result<View> view = make_view(*camera, kWidth, kHeight);
  if (!view) return refuse(view.error());

  const Rendering rendering = render_staged(*scene, *view, RenderSettings{});
  if (const auto written = write_image(argv[1], rendering.buffers.color); !written) {
    return refuse(written.error());
  }
  const auto back = read_image(argv[1]);
  return back && *back == rendering.buffers.color && rendering.statistics.written > 0 ? 0 : 1;
}
