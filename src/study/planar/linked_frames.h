// Frames of two stacks that lie at one place of the patient: boxes of images that scroll together, and the
// line of one image on another. Places are in Stack::frames.
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <optional>

#include "dicom/stack/stack.h"

namespace macula::study {

// Whether both name the same frame of reference, so that places in mm are the same.
bool shareFrameOfReference(const dicom::Frame& a, const dicom::Frame& b);

// How far one frame lies behind another along the normal of the latter, in mm; 0 in one frame of reference.
// Nothing where either has no plane, or they are not parallel, to 20 degrees: then `linkedFrame` counts
// frames instead.
std::optional<double> shiftMm(const dicom::Frame& from, const dicom::Frame& to);

// The frame of `to` that lies nearest to frame `from`, moved by `shiftMm` along its normal; of frames at one
// place the first. Nothing where they have no planes, or are not parallel.
std::optional<std::size_t> linkedFrame(const dicom::Frame& from, const dicom::Stack& to, double shiftMm);

// The corners of an image as they are seen on another along the normal of that one, in its pixels from the
// outer corner of the first. Nothing unless both lie in one frame of reference, and across each other, within
// 45 degrees.
std::optional<std::array<glm::dvec2, 4>> outlineOn(const dicom::Frame& on, const dicom::Frame& image);

}  // namespace macula::study
