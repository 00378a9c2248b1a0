// A user's first program: places of the pipeline as types, a picture written and read back.
#include <cstdio>

#include <glassbox/base/spaces.h>
#include <glassbox/images/read.h>
#include <glassbox/images/write.h>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  using namespace glassbox;

  Transform<World, Object> world_from_object;
  world_from_object.at(0, 3) = 2;
  Transform<Eye, World> eye_from_world;
  eye_from_world.at(2, 3) = -5;
  const auto p_eye = eye_from_world * world_from_object * Point<Object, double>(1, 0, 0);
  if (p_eye != Point<Eye, double>(3, 0, -5)) {
    std::fprintf(stderr, "(%g, %g, %g) instead of (3, 0, -5)\n", p_eye.x, p_eye.y, p_eye.z);
    return 1;
  }

  const Image<Rgba8> picture(8, 4, {200, 100, 50, 255});
  if (const auto written = write_image(argv[1], picture); !written) {
    std::fprintf(stderr, "%s\n", written.error().message().c_str());
    return 1;
  }
  const auto back = read_image(argv[1]);
  return back && *back == picture ? 0 : 1;
}
