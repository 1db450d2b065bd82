#include "scene/clip/removed_on_slice.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "scene/camera/picture_rays.h"
#include "scene/clip/clip_outline.h"
#include "scene/clip/clip_shapes.h"
#include "scene/clip/eye_cut.h"

namespace macula::scene {

namespace {

constexpr double kEdgeOn = 1e-6;  // relative: below this a slice counts as seen edge-on

Contour inPicture(const std::vector<glm::dvec3>& outlineMm, const slices::SliceFrame& frame) {
    Contour line;
    for (const glm::dvec3& mm : outlineMm) line.push_back(frame.pictureFromWorld(mm));
    if (!line.empty()) line.push_back(line.front());
    return line;
}

// The area to which unbounded outlines are clipped: the picture, and as much around it on each side.
Contour aroundPicture(double size) {
    return {{-size, -size}, {2.0 * size, -size}, {2.0 * size, 2.0 * size}, {-size, 2.0 * size}};
}

double sizeOf(const slices::SliceFrame& frame) {
    return double(std::max({frame.sizePx.x, frame.sizePx.y, 1}));
}

// A line of the picture of a camera, and a place on it.
struct SeenLine {
    glm::dvec2 normal;
    double offset = 0.0;

    double side(const glm::dvec2& p) const { return glm::dot(normal, p) + offset; }
    glm::dvec2 along() const { return {-normal.y, normal.x}; }
};

// The line that a slice appears as when seen edge-on. Nothing if it is not in front of the eye.
std::optional<SeenLine> lineSeenOf(const glm::dmat3& seenFromPicture) {
    glm::dvec3 across(0.0);
    double most = 0.0;
    for (int a = 0; a < 3; ++a) {
        const glm::dvec3& p = seenFromPicture[a];
        const glm::dvec3& q = seenFromPicture[(a + 1) % 3];
        const double sine = glm::length(glm::cross(p, q)) / (glm::length(p) * glm::length(q));
        if (!(sine > most)) continue;  // also skips a zero vector, where it is NaN
        most = sine;
        across = glm::cross(p, q);
    }
    const double length = glm::length(glm::dvec2(across));
    if (!(length > kEdgeOn * glm::length(across))) return std::nullopt;
    return SeenLine{.normal = glm::dvec2(across) / length, .offset = across.z / length};
}

// For a slice seen edge-on: strips along the rays through the parts of its line that the outline encloses.
std::vector<Contour> stripsBehind(const std::vector<glm::dvec2>& outline, const glm::dmat3& seenFromPicture,
                                  const slices::SliceFrame& frame) {
    const auto line = lineSeenOf(seenFromPicture);
    if (!line) return {};
    struct Crossing {
        double at;
        int turn;
    };
    std::vector<Crossing> crossings;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2& a = outline[i];
        const glm::dvec2& b = outline[(i + 1) % outline.size()];
        const double atA = line->side(a);
        const double atB = line->side(b);
        if ((atA >= 0.0) == (atB >= 0.0)) continue;
        crossings.push_back({glm::dot(line->along(), a + (atA / (atA - atB)) * (b - a)), atA < 0.0 ? 1 : -1});
    }
    std::ranges::sort(crossings, {}, &Crossing::at);
    std::vector<Contour> strips;
    int winding = 0;
    double from = 0.0;
    for (const Crossing& crossing : crossings) {
        if (winding == 0) from = crossing.at;
        winding += crossing.turn;
        if (winding != 0 || !(crossing.at > from)) continue;
        // The two conditions together imply z above 0, in front of the eye.
        const auto placeAt = [&](const glm::dvec2& px) {
            const glm::dvec3 p = seenFromPicture * glm::dvec3(px, 1.0);
            return glm::dvec2(glm::dot(line->along(), glm::dvec2(p)), p.z);
        };
        Contour strip = within(aroundPicture(sizeOf(frame)), [&](const glm::dvec2& px) {
            const glm::dvec2 p = placeAt(px);
            return p.x - from * p.y;
        });
        strip = within(strip, [&](const glm::dvec2& px) {
            const glm::dvec2 p = placeAt(px);
            return crossing.at * p.y - p.x;
        });
        if (strip.size() > 2) strips.push_back(std::move(strip));
    }
    return strips;
}

}  // namespace

std::vector<Contour> removedContours(const Clip& clip, const slices::SliceFrame& frame) {
    std::vector<Contour> contours;
    if (!frame.isUsable()) return contours;
    for (const ShownShapePtr& shape : shownShapes(clip))
        std::ranges::move(shape->removedOn(frame), std::back_inserter(contours));
    return contours;
}

std::vector<Contour> clipLines(const OptionalClip& clip, const Cuts& cuts, const Volume& volume,
                               const slices::SliceFrame& frame) {
    std::vector<Contour> lines;
    if (!frame.isUsable()) return lines;
    if (Contour kept = inPicture(keptOutlineMm(clip, volume, frame.plane), frame); !kept.empty())
        lines.push_back(std::move(kept));
    Contour ofVolume = inPicture(outlineMm(volume.worldBox(), frame.plane), frame);
    if (!ofVolume.empty()) ofVolume.pop_back();
    // Closed lines cover those of planes.
    std::vector<Contour> closed;
    for (const ShownShapePtr& shape : shownShapes(clipFor(clip, cuts, volume))) {
        Contour line = shape->lineOn(frame, ofVolume);
        if (line.empty()) continue;
        (line.front() == line.back() ? closed : lines).push_back(std::move(line));
    }
    std::ranges::move(closed, std::back_inserter(lines));
    return lines;
}

std::vector<Contour> behindOutline(const ScissorCut& cut, const slices::SliceFrame& frame) {
    const auto rays = PictureRays::of(cut.camera, 1.0);
    if (!rays || !frame.isUsable()) return {};
    // Maps pixels to half heights of the camera's picture, both homogeneous, so that lines stay lines.
    const glm::dmat3 seenFromPicture(rays->homogeneousStep(frame.plane.right * frame.mmPerPixel),
                                     rays->homogeneousStep(frame.plane.down * frame.mmPerPixel),
                                     rays->homogeneous(frame.worldFromPicture({0.0, 0.0})));
    const double scale =
        glm::length(seenFromPicture[0]) * glm::length(seenFromPicture[1]) * glm::length(seenFromPicture[2]);
    const double determinant = glm::determinant(seenFromPicture);
    if (!(std::abs(determinant) > kEdgeOn * scale)) return stripsBehind(cut.outline, seenFromPicture, frame);
    const glm::dmat3 pictureFromSeen = glm::inverse(seenFromPicture);
    std::vector<glm::dvec3> seen;
    for (const glm::dvec2& p : cut.outline) seen.push_back(pictureFromSeen * glm::dvec3(p, 1.0));
    // Where the slice passes beside or behind the eye, an outline is unbounded: it is cut off around the
    // picture. These sides together imply z above 0, in front of the eye.
    const double size = sizeOf(frame);
    for (int axis = 0; axis < 2; ++axis) {
        seen = within(seen, [&](const glm::dvec3& p) { return p[axis] + size * p.z; });
        seen = within(seen, [&](const glm::dvec3& p) { return 2.0 * size * p.z - p[axis]; });
    }
    std::erase_if(seen, [](const glm::dvec3& p) { return !(p.z > 0.0); });
    Contour contour;
    for (const glm::dvec3& p : seen) contour.emplace_back(p.x / p.z, p.y / p.z);
    if (contour.size() < 3) return {};
    return {std::move(contour)};
}

bool isInsideContours(std::span<const Contour> contours, const glm::dvec2& px) {
    int winding = 0;
    for (const Contour& contour : contours) {
        for (std::size_t i = 0; i < contour.size(); ++i) {
            const glm::dvec2& a = contour[i];
            const glm::dvec2& b = contour[(i + 1) % contour.size()];
            const double left = (b.x - a.x) * (px.y - a.y) - (px.x - a.x) * (b.y - a.y);
            if (a.y <= px.y && px.y < b.y && left > 0.0) ++winding;
            if (b.y <= px.y && px.y < a.y && left < 0.0) --winding;
        }
    }
    return winding != 0;
}

}  // namespace macula::scene
