#include "scene/clip/handles_on_slice.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "scene/clip/clip_outline.h"

namespace macula::scene {

namespace {

constexpr double kInsetPx = 12.0;  // from the border of the picture, so that handles are seen whole

struct Segment {
    glm::dvec2 a;
    glm::dvec2 b;
};

// The part of a segment within the picture, less a margin; nothing if the segment is outside.
std::optional<Segment> inPicture(const Segment& segment, const slices::SliceFrame& frame) {
    const glm::dvec2 size(frame.sizePx);
    const glm::dvec2 inset = glm::min(glm::dvec2(kInsetPx), 0.25 * size);
    const glm::dvec2 along = segment.b - segment.a;
    double from = 0.0;
    double to = 1.0;
    for (int axis = 0; axis < 2; ++axis) {
        const double low = inset[axis] - segment.a[axis];
        const double high = size[axis] - inset[axis] - segment.a[axis];
        if (along[axis] == 0.0) {
            if (low > 0.0 || high < 0.0) return std::nullopt;
            continue;
        }
        const auto [first, last] = std::minmax({low / along[axis], high / along[axis]});
        from = std::max(from, first);
        to = std::min(to, last);
    }
    if (!(from < to)) return std::nullopt;
    return Segment{segment.a + from * along, segment.a + to * along};
}

}  // namespace

glm::dvec3 normalOf(Face face) {
    glm::dvec3 normal(0.0);
    normal[axisOf(face)] = isHigh(face) ? 1.0 : -1.0;
    return normal;
}

Box common(const Box& a, const Box& b) {
    return {glm::max(a.low, b.low), glm::min(a.high, b.high)};
}

std::vector<PlacedHandle> handlesOfFaces(ClipHandle::Kind kind, const Box& box) {
    std::vector<PlacedHandle> handles;
    for (const Face face : kFaces) {
        glm::dvec3 at = box.centre();
        at[axisOf(face)] = faceMm(box, face);
        handles.push_back({.handle = {.kind = kind, .face = face}, .atMm = at, .along = normalOf(face)});
    }
    return handles;
}

PlacedHandle handleOfPlane(const ClipHandle& handle, const HalfSpace& plane, const Box& volumeMm) {
    const double off = plane.offsetMm - glm::dot(plane.normal, volumeMm.centre());
    return {.handle = handle, .atMm = volumeMm.centre() + off * plane.normal, .along = plane.normal};
}

void HandlesOnSlice::addFaces(ClipHandle::Kind kind, const Box& box) {
    const std::vector<glm::dvec3> outline = outlineMm(box, frame_.plane);
    const double near = kOnFace * volume_.worldBox().diagonal();
    for (const Face face : kFaces) {
        const int axis = axisOf(face);
        const auto isOn = [&](const glm::dvec3& p) { return std::abs(p[axis] - faceMm(box, face)) <= near; };
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const glm::dvec3& a = outline[i];
            const glm::dvec3& b = outline[(i + 1) % outline.size()];
            if (isOn(a) && isOn(b)) addLine({.kind = kind, .face = face}, normalOf(face), a, b);
        }
    }
}

void HandlesOnSlice::addPlane(const ClipHandle& handle, const HalfSpace& plane) {
    const std::vector<glm::dvec3> outline = outlineMm(volume_.worldBox(), frame_.plane);
    std::vector<glm::dvec3> ends;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec3& a = outline[i];
        const glm::dvec3& b = outline[(i + 1) % outline.size()];
        const double atA = glm::dot(plane.normal, a) - plane.offsetMm;
        const double atB = glm::dot(plane.normal, b) - plane.offsetMm;
        if ((atA >= 0.0) != (atB >= 0.0)) ends.push_back(a + (atA / (atA - atB)) * (b - a));
    }
    if (ends.size() == 2) addLine(handle, plane.normal, ends[0], ends[1]);
}

void HandlesOnSlice::addPoint(const ClipHandle& handle, const glm::dvec3& atMm, const glm::dvec3& along) {
    const glm::dvec2 px = frame_.pictureFromWorld(atMm);
    const glm::dvec2 size(frame_.sizePx);
    if (px.x < 0.0 || px.y < 0.0 || px.x > size.x || px.y > size.y) return;
    handles_.push_back({.handle = handle, .atMm = atMm, .along = along});
}

void HandlesOnSlice::addLine(const ClipHandle& handle, const glm::dvec3& normal, const glm::dvec3& a,
                             const glm::dvec3& b) {
    const glm::dvec3 across = normal - glm::dot(normal, frame_.plane.normal()) * frame_.plane.normal();
    if (!(glm::length(across) > kAcross)) return;
    const auto line = inPicture({frame_.pictureFromWorld(a), frame_.pictureFromWorld(b)}, frame_);
    if (!line) return;
    handles_.push_back({.handle = handle,
                        .atMm = frame_.worldFromPicture(0.5 * (line->a + line->b)),
                        .along = glm::normalize(across)});
}

}  // namespace macula::scene
