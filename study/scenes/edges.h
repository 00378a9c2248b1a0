// Finds the pixels at edges of a picture: a program that rounds differently may give them to
// another triangle.
#pragma once

#include <cstdint>

#include <glassbox/images/image.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/raster/samples.h>

namespace glassbox::study {

// Sets `edge` to 1 where the 3 x 3 pixels around a pixel have at least two different values of
// `id`.
void mark_edges(const Image<std::uint32_t>& id, Image<std::uint8_t>& edge);

// Sets `edge` to 1 where the two images differ.
void mark_differences(const Image<std::uint32_t>& a, const Image<std::uint32_t>& b,
                      Image<std::uint8_t>& edge);

// The view whose pixel centres show what samples at `offset` show in `view`.
View view_at_sample(View view, const SampleOffset& offset);

}  // namespace glassbox::study
