// The shape of a measurement on an image: its handles, its lines, and what a hand does to it. Pixels of the
// image, as study::ImageMeasurement.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "study/planar/image_measurement.h"

namespace macula::viewer {

// Its points; of an ellipse the right, left, lower and upper end, then its centre.
std::vector<glm::dvec2> handlesOf(const study::ImageMeasurement& measurement);

// Each a polyline; an ellipse is cut into short pieces. Points that are still missing have none.
std::vector<std::vector<glm::dvec2>> linesOf(const study::ImageMeasurement& measurement);

// An ellipse's end leaves the opposite one where it is; its centre moves the whole.
study::ImageMeasurement withHandleAt(const study::ImageMeasurement& measurement, std::size_t handle,
                                     const glm::dvec2& at);

study::ImageMeasurement movedBy(study::ImageMeasurement measurement, const glm::dvec2& by);

}  // namespace macula::viewer
