#include "image/frame_metrics.h"

#include <algorithm>
#include <cmath>

#include "image/planes.h"

namespace macula::image {

namespace {

Error notForEachPixel(Text what) {
    return {ErrorCode::usage, std::move(what), {}, Text("Give one number for each pixel of the pictures.")};
}

std::size_t pixelsOf(const Image& image) {
    return std::size_t(image.width) * std::size_t(image.height);
}

Result<Plane> planeOf(std::span<const float> weights, const Image& like) {
    if (weights.size() != pixelsOf(like))
        return notForEachPixel(Text("The weights do not fit the pictures."));
    if (std::any_of(weights.begin(), weights.end(), [](float w) { return !std::isfinite(w); }))
        return notForEachPixel(Text("A weight is no number."));
    Plane plane(like.width, like.height);
    std::transform(weights.begin(), weights.end(), plane.values.begin(),
                   [](float w) { return std::clamp(double(w), 0.0, 1.0); });
    return plane;
}

// Central differences; one-sided at the edge of the picture.
glm::dvec2 gradient(const Plane& plane, int x, int y) {
    const int left = std::max(x - 1, 0);
    const int right = std::min(x + 1, plane.width - 1);
    const int above = std::max(y - 1, 0);
    const int below = std::min(y + 1, plane.height - 1);
    return {(plane.at(right, y) - plane.at(left, y)) / std::max(right - left, 1),
            (plane.at(x, below) - plane.at(x, above)) / std::max(below - above, 1)};
}

bool isOutside(double weight) {
    return weight <= kOuterWeight;
}
bool isInside(double weight) {
    return weight >= kInnerWeight;
}

bool isAtBorder(const Plane& weights, int x, int y) {
    const double here = weights.at(x, y);
    if (!isOutside(here) && !isInside(here)) return true;
    const auto isOpposite = [&](int toX, int toY) {
        if (toX < 0 || toY < 0 || toX >= weights.width || toY >= weights.height) return false;
        const double there = weights.at(toX, toY);
        return isOutside(here) ? isInside(there) : isOutside(there);
    };
    return isOpposite(x - 1, y) || isOpposite(x + 1, y) || isOpposite(x, y - 1) || isOpposite(x, y + 1);
}

}  // namespace

double SeamVisibility::ratio() const {
    return std::max(frame, kLeast) / std::max(reference, kLeast);
}

Result<std::optional<SeamVisibility>> seamVisibility(const Image& reference, const Image& frame,
                                                     std::span<const float> weights) {
    MACULA_TRY_VOID(comparable(reference, frame));
    MACULA_TRY(const Plane weight, planeOf(weights, frame));
    const Plane a = luminanceOf(reference);
    const Plane b = luminanceOf(frame);
    SeamVisibility sum;
    std::size_t count = 0;
    for (int y = 0; y < weight.height; ++y) {
        for (int x = 0; x < weight.width; ++x) {
            if (!isAtBorder(weight, x, y)) continue;
            const glm::dvec2 across = gradient(weight, x, y);
            const double steepness = glm::length(across);
            if (steepness == 0.0) continue;  // a plateau or a ridge has no direction outwards
            sum.reference += std::abs(glm::dot(gradient(a, x, y), across)) / steepness;
            sum.frame += std::abs(glm::dot(gradient(b, x, y), across)) / steepness;
            ++count;
        }
    }
    if (count == 0) return std::optional<SeamVisibility>();
    return std::optional(
        SeamVisibility{.frame = sum.frame / double(count), .reference = sum.reference / double(count)});
}

Result<std::optional<double>> flicker(const Image& warpedBefore, const Image& frame, const Mask& known) {
    MACULA_TRY_VOID(comparable(warpedBefore, frame));
    if (known.size() != pixelsOf(frame)) return notForEachPixel(Text("The mask does not fit the pictures."));
    const Plane before = luminanceOf(warpedBefore);
    const Plane now = luminanceOf(frame);
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < known.size(); ++i) {
        if (known[i] == 0) continue;
        sum += std::abs(now.values[i] - before.values[i]);
        ++count;
    }
    if (count == 0) return std::optional<double>();
    return std::optional(sum / double(count));
}

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
