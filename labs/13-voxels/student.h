// Lab 13: voxel colouring. The contracts of the five functions that you write in student.cpp.
//
// Voxels are cubes of edge 1 in grid coordinates: voxel (x, y, z) reaches from (x, y, z) to (x + 1,
// y + 1, z + 1). A camera maps grid coordinates to its picture by P = pixel_from_grid, three rows
// of four: (u w, v w, w) = P (x, y, z, 1), with u and v in pixels from the top left, v down. Pixel
// (i, j) is [i, i + 1) x [j, j + 1) with its centre at (i + 1/2, j + 1/2). w > 0 is in front of the
// camera. Colours are three numbers from 0 to 255. In error bounds, u is the unit roundoff of
// double, 2^-53.
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

// The position of the cameras relative to the box (S1-38): along how many axes all cameras are
// beyond the same face of the box.
enum class Kind {
  kUnknown = -1,
  kOctant = 0,     // along three axes, all cameras are beyond the same face
  kQuadrant = 1,   // along two axes, all cameras are beyond the same face
  kHalfSpace = 2,  // along one axis, all cameras are beyond the same face
  kEmbedded = 3,   // along no axis, and all cameras are in the box
  kSurrounded = 4  // along no axis, and not all cameras are in the box
};
struct Order {
  Kind kind = Kind::kUnknown;
  // For x, y and z: 1 where every camera is below the box, so that layers with growing numbers lead
  // away from all cameras; -1 where every camera is above the box; 0 otherwise.
  std::array<int, 3> away{0, 0, 0};
};

// Task 13.1. How the cameras are placed around the box, and the order in which its voxels are
// visited, for at least one camera. *Below* the box means a coordinate less than the smallest of
// the box, *above* one greater than the largest of the box: a camera on a face is neither below nor
// above, and is in the box if no other coordinate is outside it. The result must be exact.
Order classify(const std::vector<Place>& cameras, const Box& box);

using Colour = std::array<double, 3>;

struct Statistics {
  Colour mean{0, 0, 0};
  double deviation = 0;
};

// Task 13.2. For K colours: the mean of each channel, and the deviation pooled over the channels,
// sqrt(S / (3 (K - 1))), where S is the sum of (value - the channel's mean)^2 over colours and
// channels. Without colours everything is 0, and the deviation of one colour is 0.
// Error bound of a mean: (K + 4) u M, where M is the largest value; of the deviation: (K + 8) u
// sqrt(deviation^2 + M^2). The values may be almost equal. A value is 0 or at least 2^-500, so its
// square does not underflow.
Statistics statistics(const std::vector<Colour>& colours);

// The content of a picture's pixel.
struct Pixel {
  Colour colour{0, 0, 0};
  bool is_background = false;  // the pixel shows no part of the object
  bool is_hidden = false;      // the pixel shows a nearer voxel that is coloured
};

enum class Verdict {
  kUnknown = -1,
  kBackground = 0,    // in one picture all pixels of the voxel are background
  kHidden = 1,        // no picture sees the voxel
  kAlone = 2,         // only one picture sees the voxel
  kInconsistent = 3,  // the colours of the voxel's pixels differ
  kColoured = 4
};

struct Threshold {
  double k1 = 0, k2 = 18;
};

// Task 13.3. The verdict on a voxel. pictures[i] are those pixels of picture i that belong to the
// voxel; it is empty if the voxel is outside the picture, and the picture is then ignored. If in
// one picture all of the voxel's pixels are background: kBackground, regardless of the other
// pictures. A picture *sees* the voxel if one of its pixels is neither background nor hidden. If no
// picture sees it: kHidden; if only one does: kAlone. Otherwise consider all pixels, of all
// pictures together, that are neither background nor hidden: kColoured if their deviation is less
// than T = k1 M + k2, where M is the mean of the deviations within each picture that sees the
// voxel; kInconsistent if not. In no case is the deviation within 2^-40 of T, unless it is exactly
// T.
Verdict judge(const std::vector<std::vector<Pixel>>& pictures, const Threshold& threshold);

using Projection = std::array<std::array<double, 4>, 3>;  // P[row][column]

struct Voxel {
  int x = 0, y = 0, z = 0;
};
struct PixelAt {
  int column = 0, row = 0;
};

// Task 13.4. The pixels of a voxel in a picture of width x height: those whose centres are in the
// smallest upright rectangle around the eight projected corners, or on its border, row by row from
// the top and from left to right. The pixel that contains the projected centre of the voxel is
// always one of them: if its own centre is not in the rectangle it comes last. Pixels outside the
// picture are left out. If a corner is not in front of the camera, the pixel of the voxel's centre
// is the only one; if the voxel's centre is not in front of it, there is none. Exact: no pixel
// centre is within 2^-20 px of a border, and the voxel's centre is not within 2^-20 px of the edge
// of a pixel, unless all numbers have so few digits that nothing is rounded; w is never rounded. A
// position may be far outside the picture, where an int cannot express its pixel.
std::vector<PixelAt> footprint(const Projection& pixel_from_grid, const Voxel& voxel, int width,
                               int height);

struct Picture {
  Projection pixel_from_grid{};
  int width = 0, height = 0;
  std::vector<Pixel> pixels;  // row by row from the top
};

struct Grid {
  std::array<int, 3> count{0, 0, 0};  // voxels along x, y and z
  int axis = 2;                       // layers are stacked along this axis: 0 is x, 1 y, 2 z
  int away = 1;                       // 1: layer 0 comes first; -1: the last layer does
};

struct Coloured {
  Voxel at;
  Colour mean{0, 0, 0};
};

// Task 13.5. Voxel colouring. Layer by layer along the axis, away from the cameras, each voxel is
// judged by the pixel of its centre in each picture (none where the centre is outside the picture
// or not in front of the camera). After each layer, and not before, the pixels of its coloured
// voxels become hidden in all pictures. No pixel is hidden at the beginning. If u or v of a centre
// is a whole number, the division u w / w gives it exactly. Returns the coloured voxels with their
// mean colour, in the order of the layers, within a layer by z, then y, then x. Error bound of a
// colour: (K + 4) u 255 for K pictures.
std::vector<Coloured> sweep(std::vector<Picture> pictures, const Grid& grid,
                            const Threshold& threshold);

}  // namespace lab_13
