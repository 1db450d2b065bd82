// The mutual information of two volumes: Mattes, "PET-CT image registration in the chest using free-form
// deformations", IEEE Trans Med Imaging 22 (2003), with the normalisation of Studholme, "An overlap invariant
// entropy measure of 3D medical image alignment", Pattern Recognition 32 (1999).
#pragma once

#include <cstddef>
#include <span>

#include "registration/intensity_bins.h"
#include "registration/sample_points.h"
#include "registration/scalar_grid.h"

namespace macula::registration {

struct Likeness {
    double information = 0.0;  // mutual information, in nats
    // (H(fixed) + H(moving)) / H(fixed, moving): from 1, nothing in common, to 2. Unlike mutual information,
    // it does not grow merely because less of the volumes overlaps.
    double normalised = 1.0;
    double overlap = 0.0;  // share of the points where the moving volume has a value
};

// Fixed values fall into one bin, moving ones into four (a cubic B-spline), so likeness changes smoothly with
// the transform. Sums are taken in one order on any number of cores: the same points give the same bits.
Likeness likenessOf(std::span<const SamplePoint> points, const ScalarGrid& moving, const IntensityBins& bins,
                    const glm::dmat4& movingFromFixed);

}  // namespace macula::registration
