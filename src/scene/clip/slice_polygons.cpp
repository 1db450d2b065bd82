#include "scene/clip/slice_polygons.h"

namespace macula::scene {

Contour pictureOf(const slices::SliceFrame& frame) {
    const glm::dvec2 size(frame.sizePx);
    return {{0.0, 0.0}, {size.x, 0.0}, {size.x, size.y}, {0.0, size.y}};
}

Contour withinAll(Contour polygon, std::span<const HalfSpace> sides, const slices::SliceFrame& frame) {
    for (const HalfSpace& side : sides) polygon = within(polygon, SideInPicture(side, frame));
    return polygon;
}

std::vector<Contour> removedBySides(std::span<const HalfSpace> sides, Keep keep,
                                    const slices::SliceFrame& frame) {
    std::vector<Contour> contours;
    const auto add = [&](Contour contour) {
        if (contour.size() > 2) contours.push_back(std::move(contour));
    };
    if (keep == Keep::outside) {
        add(withinAll(pictureOf(frame), sides, frame));
        return contours;
    }
    for (const HalfSpace& side : sides) {
        const SideInPicture keeps(side, frame);
        add(within(pictureOf(frame), [&](const glm::dvec2& px) { return -keeps(px); }));
    }
    return contours;
}

Contour closedLine(Contour polygon) {
    if (polygon.size() < 3) return {};
    polygon.push_back(polygon.front());
    return polygon;
}

}  // namespace macula::scene
