// Curved planes: pictures along a curve (Kanitsar, Fleischmann, Wegenkittl, Felkel and Gröller, CPR: Curved
// planar reformation, IEEE Visualization 2002).
#pragma once

#include <functional>
#include <optional>

#include "base/volume.h"
#include "slices/curve.h"
#include "slices/sampled_slice.h"

namespace macula::slices {

enum class CurvedKind {
    straightened,  // the curve is a level line in the middle of the picture; lengths along it are true
    stretched,     // the surface that a line sweeps along the curve, unrolled: all lengths in it are true
};

// A picture along a curve, which runs to the right. Its pixels are square; (0, 0) is its upper left corner.
class CurvedFrame {
  public:
    // `curve` is usable. `turnDeg` turns the surface about the curve: 0 shows what is across it, 90 what is
    // beside it. The height in mm becomes whole pixels; a side has at most kMostPixels, with larger pixels.
    CurvedFrame(Curve curve, CurvedKind kind, double turnDeg, double heightMm, double mmPerPixel);

    const Curve& curve() const { return curve_; }
    double mmPerPixel() const { return mmPerPixel_; }
    glm::ivec2 sizePx() const { return sizePx_; }

    // A column of pixels lies on a line in the volume.
    struct Column {
        CurvePlace place;       // where the line meets the curve
        double curvePx = 0.0;   // in the picture, from its upper edge
        glm::dvec3 down{0.0};   // unit vector
        glm::dvec3 depth{0.0};  // across the surface: unit vector
    };
    Column column(double xPx) const;
    glm::dvec3 worldFromPicture(const glm::dvec2& px) const;
    // Where a place of the curve is in the picture.
    glm::dvec2 pictureFromCurve(double atMm) const;

    static constexpr int kMostPixels = 8192;

  private:
    void unroll();

    Curve curve_;
    CurvedKind kind_;
    double turnDeg_;
    double mmPerPixel_;
    glm::ivec2 sizePx_{0};
    // For a stretched picture: the line that sweeps, and for each of the curve's places the length of the way
    // across the line, and the height along it above the middle.
    glm::dvec3 sweep_{0.0};
    std::vector<double> acrossMm_;
    std::vector<double> heightMm_;
};

// Values between voxels as sampleSlice with Filter::linear, in the volume's unit. A slab takes steps of at
// most half the smallest side of a voxel across the surface, longer ones beyond some 500 voxels. Uses all
// cores. Calls `cancelled` for each column, from several threads; if it returns true, the result is empty.
// May throw std::bad_alloc.
SampledSlice sampleCurved(const Volume& volume, const CurvedFrame& frame, const Slab& slab,
                          const std::function<bool()>& cancelled = {});

}  // namespace macula::slices
