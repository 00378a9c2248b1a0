// Lab 13: voxel colouring. The contracts of the five functions that you write in student.cpp.
//
// Voxels are cubes of edge 1 in grid coordinates: voxel (x, y, z) reaches from (x, y, z) to (x + 1, y + 1, z + 1). A camera carries grid
// coordinates to its picture by P = pixel_from_grid, three rows of four: (u w, v w, w) = P (x, y, z, 1), u and v in pixels from the top left,
// y down, pixel (i, j) is [i, i + 1) x [j, j + 1) with its middle at (i + 1/2, j + 1/2). w > 0 is before the camera. Colours are three numbers
// from 0 to 255. u is the rounding unit of double, 2^-53.
#pragma once

#include <array>
#include <vector>

namespace lab_13 {

struct Place {
  double x = 0, y = 0, z = 0;
};
struct Box {
  Place low, high;  // low <= high along each axis
};

// How cameras stand to the box (S1-38).
enum class Kind {
  kUnknown = -1,
  kOctant = 0,     // beyond one of its faces along three axes
  kQuadrant = 1,   // along two
  kHalfSpace = 2,  // along one
  kEmbedded = 3,   // along none, and all of them in the box
  kSurrounded = 4  // along none, and not all in the box
};
struct Order {
  Kind kind = Kind::kUnknown;
  // For x, y and z: 1 where every camera is below the box, so that layers with growing numbers lead away from all of them; -1 where every
  // camera is above it; else 0.
  std::array<int, 3> away{0, 0, 0};
};

// Task 13.1. Which of these it is, at least one camera. *Below* the box is a coordinate that is less than the box's least, *above* one that is
// more than its greatest: on a face is neither, and is in the box. Exact.
Order classify(const std::vector<Place>& cameras, const Box& box);

using Colour = std::array<double, 3>;

struct Statistics {
  Colour mean{0, 0, 0};
  double deviation = 0;
};

// Task 13.2. Of K colours: the mean of each channel, and the deviation pooled over the channels, sqrt(S / (3 (K - 1))) with S the sum over
// colours and channels of (value - the channel's mean)^2. Without colours all is 0, and of one the deviation is 0.
// Bound of a mean: (K + 4) u M, M the largest value; of the deviation: (K + 8) u sqrt(deviation^2 + M^2): the values may be much alike.
Statistics statistics(const std::vector<Colour>& colours);

// What a picture has in a pixel.
struct Pixel {
  Colour colour{0, 0, 0};
  bool is_background = false;  // it shows none of the object
  bool is_hidden = false;      // something nearer has been coloured there
};

enum class Verdict {
  kUnknown = -1,
  kBackground = 0,    // a picture shows background there
  kHidden = 1,        // no picture sees it
  kAlone = 2,         // one picture alone
  kInconsistent = 3,  // their colours differ
  kColoured = 4
};

struct Threshold {
  double k1 = 0, k2 = 18;
};

// Task 13.3. What becomes of a voxel. pictures[i] are those pixels of picture i that are the voxel's; none where it lies beside the picture,
// which then says nothing. If in one picture all of its pixels are background: kBackground, whatever the others say. A picture *sees* the voxel
// if one of its pixels is neither background nor hidden. If fewer than two pictures see it: kHidden or kAlone. Else kColoured if the deviation
// of all pixels that are neither, of all pictures together, is less than T = k1 M + k2, M the mean of the deviations within each picture
// that sees it; else kInconsistent. No case has a deviation that is within 2^-40 of T, but for those that are exactly equal.
Verdict judge(const std::vector<std::vector<Pixel>>& pictures, const Threshold& threshold);

using Projection = std::array<std::array<double, 4>, 3>;  // P[row][column]

struct Voxel {
  int x = 0, y = 0, z = 0;
};
struct PixelAt {
  int column = 0, row = 0;
};

// Task 13.4. The pixels of a voxel in a picture of width x height: those whose middles are in the smallest upright rectangle around the eight
// corners' places, on its border too, row by row from the top and from left to right. The pixel that has the place of the voxel's middle is
// always one of them: where it is not in the rectangle it comes last. Pixels beside the picture are left out. If a corner is not before the
// camera, the middle's pixel is the only one, and if the middle is not, there is none. Exact: no middle is within 2^-20 px of a border, but
// where all numbers are short.
std::vector<PixelAt> footprint(const Projection& pixel_from_grid, const Voxel& voxel, int width,
                               int height);

struct Picture {
  Projection pixel_from_grid{};
  int width = 0, height = 0;
  std::vector<Pixel> pixels;  // row by row from the top
};

struct Grid {
  std::array<int, 3> count{0, 0, 0};  // voxels along x, y and z
  int axis = 2;                       // of the layers: 0 is x, 1 y, 2 z
  int away = 1;                       // 1: layer 0 first; -1: the last one first
};

struct Coloured {
  Voxel at;
  Colour mean{0, 0, 0};
};

// Task 13.5. Voxel colouring. Layer after layer along the axis, away from the cameras, each voxel is judged by the pixel of its middle in each
// picture (none where the middle is beside the picture or not before the camera). After each layer the pixels of its coloured voxels become
// hidden in all pictures, and not before. No pixel is hidden at the beginning. The coloured voxels with their mean colour, in the order of
// the layers, within a layer by z, then y, then x. Bound of a colour: (K + 4) u 255 of K pictures.
std::vector<Coloured> sweep(std::vector<Picture> pictures, const Grid& grid,
                            const Threshold& threshold);

}  // namespace lab_13
