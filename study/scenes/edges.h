// Where a picture has edges: the pixels that another program, which rounds otherwise, may give to another triangle.
#pragma once

#include <cstdint>

#include <glassbox/images/image.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/raster/samples.h>

namespace glassbox::study {

// Sets 1 where `id` has two values or more in the pixel's 3 x 3 neighbourhood.
void mark_edges(const Image<std::uint32_t>& id, Image<std::uint8_t>& edge);

// Sets 1 where the two images differ.
void mark_differences(const Image<std::uint32_t>& a, const Image<std::uint32_t>& b,
                      Image<std::uint8_t>& edge);

// The view in which pixel centres see what the samples at `offset` see.
View seen_at(View view, const SampleOffset& offset);

}  // namespace glassbox::study
