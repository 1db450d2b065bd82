// How a person left a series of images: what is kept of it between runs. Holds no UID and no text of a file;
// only a label that a person typed can name somebody.
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/volume.h"
#include "study/planar/image_measurement.h"

namespace macula::study {

struct ImagesState {
    std::vector<ImageMeasurement> measurements;
    std::size_t place = 0;                // of the image in the series, from 0
    std::optional<DisplayWindow> window;  // a person's; nothing: that of the file
    bool isInverted = false;
    int quarters = 0;  // clockwise, 0 to 3, and then perhaps mirrored
    bool isMirrored = false;
    std::optional<double> scale;  // logical pixels for a column; nothing: fits the pane
    glm::dvec2 middlePx{0.0};     // of the image from the middle of the pane
    bool overlaysAreShown = true;

    bool operator==(const ImagesState&) const = default;
};

// The names of all members of the text, for those who merge it with an older one.
inline constexpr std::array<std::string_view, 10> kImagesStateMembers{
    "version", "measurements", "place", "window", "inverted",
    "turned",  "mirrored",     "scale", "middle", "overlays"};

std::string toJsonText(const ImagesState& state);
// Nothing for text of another kind. What makes no sense within is left out: numbers that are not finite or
// out of range, measurements without their points, those beyond kMostImageMeasurements, long labels' ends.
std::optional<ImagesState> imagesStateOf(std::string_view json);

}  // namespace macula::study
