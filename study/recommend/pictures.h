// Whole pictures: colours against many more samples, and times of frames.
#pragma once

#include <span>
#include <vector>

#include <glassbox/images/image.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/settings.h>

#include "study/bench/statistics.h"

namespace glassbox::study {

// What is drawn: the view's depth range must be the settings' format's.
struct Shot {
  View view;
  RenderSettings settings;
};

// Every block of factor x factor pixels averaged in linear light, encoded again.
Image<Rgba8> shrunk(const Image<Rgba8>& large, int factor, Transfer transfer);

// The root mean square difference of red, green and blue, 1 for the whole range of a byte. Both have the same size.
double color_error(const Image<Rgba8>& picture, const Image<Rgba8>& reference);

// Nanoseconds of a frame of each, drawn in turn by the tile engine with one thread.
std::vector<Quartiles> frame_times(const Scene& scene, std::span<const Shot> shots);

}  // namespace glassbox::study
