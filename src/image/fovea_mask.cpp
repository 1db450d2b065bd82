#include "image/fovea_mask.h"

#include <cmath>

namespace macula::image {

namespace {

// NaN is in no range.
bool isUsable(const FoveaInPicture& fovea) {
    const auto isInside = [](double gaze) { return gaze >= -1.0 && gaze <= 1.0; };
    return fovea.sizePx.x >= 1 && fovea.sizePx.y >= 1 && fovea.verticalFovDeg >= 0.1 &&
           fovea.verticalFovDeg <= 170.0 && isInside(fovea.gaze.x) && isInside(fovea.gaze.y) &&
           fovea.fieldDeg > 0.0 && fovea.fieldDeg <= 180.0;
}

}  // namespace

Result<Mask> foveaMask(const FoveaInPicture& fovea) {
    if (!isUsable(fovea)) {
        return Error{
            ErrorCode::usage,
            Text("There is no such fovea in a picture."),
            {},
            Text("Give a picture of 0.1 to 170 degrees, a gaze inside it, and a field above 0 and at "
                 "most 180 degrees.")};
    }
    const glm::dvec2 size(fovea.sizePx);
    const double halfHeight = std::tan(glm::radians(fovea.verticalFovDeg) / 2.0);
    const glm::dvec2 halfSize(halfHeight * size.x / size.y, halfHeight);
    const glm::dvec3 gaze(fovea.gaze * halfSize, 1.0);
    const double half = glm::radians(fovea.fieldDeg) / 2.0;
    Mask mask;
    mask.reserve(std::size_t(fovea.sizePx.x) * std::size_t(fovea.sizePx.y));
    for (int y = 0; y < fovea.sizePx.y; ++y) {
        for (int x = 0; x < fovea.sizePx.x; ++x) {
            const glm::dvec2 place = 2.0 * (glm::dvec2(x, y) + 0.5) / size - 1.0;
            const glm::dvec3 seen(place.x * halfSize.x, -place.y * halfSize.y, 1.0);
            // The arc cosine would be imprecise for small angles.
            const double angle = std::atan2(glm::length(glm::cross(gaze, seen)), glm::dot(gaze, seen));
            mask.push_back(angle <= half ? 1 : 0);
        }
    }
    return mask;
}

}  // namespace macula::image
