#include "scene/clip/clip_handles.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "scene/clip/clip_outline.h"
#include "scene/clip/edited_clip.h"
#include "scene/clip/eye_cut.h"

namespace macula::scene {

namespace {

using Kind = ClipHandle::Kind;

constexpr double kOnFace = 1e-6;   // fraction of the volume's diagonal
constexpr double kAcross = 0.1;    // the sine of the least angle at which a plane makes a line on a slice
constexpr double kInsetPx = 12.0;  // from the border of the picture, so that handles are seen whole

struct Segment {
    glm::dvec2 a;
    glm::dvec2 b;
};

glm::dvec3 normalOf(Face face) {
    glm::dvec3 normal(0.0);
    normal[axisOf(face)] = isHigh(face) ? 1.0 : -1.0;
    return normal;
}

std::optional<Box> removedBox(const Clip& clip) {
    if (!clip.box || clip.ofBox != Keep::outside || clip.box->axes != glm::dmat3(1.0)) return std::nullopt;
    return Box{clip.box->centreMm - clip.box->halfSizeMm, clip.box->centreMm + clip.box->halfSizeMm};
}

Box common(const Box& a, const Box& b) {
    return {glm::max(a.low, b.low), glm::min(a.high, b.high)};
}

void addFaces(std::vector<PlacedHandle>& handles, Kind kind, const Box& box) {
    for (const Face face : kFaces) {
        glm::dvec3 at = box.centre();
        at[axisOf(face)] = faceMm(box, face);
        handles.push_back({.handle = {.kind = kind, .face = face}, .atMm = at, .along = normalOf(face)});
    }
}

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

// Handles on one slice.
class OnSlice {
  public:
    OnSlice(const slices::SliceFrame& frame, const Volume& volume) : frame_(frame), volume_(volume) {}

    void addFaces(Kind kind, const Box& box) {
        const std::vector<glm::dvec3> outline = outlineMm(box, frame_.plane);
        const double near = kOnFace * volume_.worldBox().diagonal();
        for (const Face face : kFaces) {
            const int axis = axisOf(face);
            const auto isOn = [&](const glm::dvec3& p) {
                return std::abs(p[axis] - faceMm(box, face)) <= near;
            };
            for (std::size_t i = 0; i < outline.size(); ++i) {
                const glm::dvec3& a = outline[i];
                const glm::dvec3& b = outline[(i + 1) % outline.size()];
                if (isOn(a) && isOn(b)) addLine({.kind = kind, .face = face}, normalOf(face), a, b);
            }
        }
    }

    void addPlane(const ClipHandle& handle, const HalfSpace& plane) {
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

    void addBall(const Ball& ball) {
        const double offMm = frame_.distanceMm(ball.centreMm);
        const double radius2 = ball.radiusMm * ball.radiusMm - offMm * offMm;
        if (!(radius2 > 0.0)) return;
        const glm::dvec3 centre = ball.centreMm - offMm * frame_.plane.normal();
        addPoint({.kind = Kind::ballCentre}, centre, glm::dvec3(0.0));
        addPoint({.kind = Kind::ballRadius}, centre + std::sqrt(radius2) * frame_.plane.right,
                 frame_.plane.right);
    }

    void addCorner(const Octant& corner) {
        const auto sides = sidesOf(corner);
        const double offMm = frame_.distanceMm(corner.pointMm);
        const glm::dvec3 at = corner.pointMm - offMm * frame_.plane.normal();
        // Whether the slice passes through the part that the corner removes.
        const glm::dvec3 inside = at + volume_.worldBox().diagonal() * kOnFace * corner.towards;
        const bool meets = std::ranges::all_of(sides, [&](const HalfSpace& side) {
            const bool isAlong = std::abs(glm::dot(side.normal, frame_.plane.normal())) < kAcross;
            return isAlong || glm::dot(side.normal, inside) >= side.offsetMm;
        });
        if (meets) addPoint({.kind = Kind::corner}, at, glm::dvec3(0.0));
    }

    std::vector<PlacedHandle> take() { return std::move(handles_); }

  private:
    void addLine(const ClipHandle& handle, const glm::dvec3& normal, const glm::dvec3& a,
                 const glm::dvec3& b) {
        const glm::dvec3 across = normal - glm::dot(normal, frame_.plane.normal()) * frame_.plane.normal();
        if (!(glm::length(across) > kAcross)) return;
        const auto line = inPicture({frame_.pictureFromWorld(a), frame_.pictureFromWorld(b)}, frame_);
        if (!line) return;
        handles_.push_back({.handle = handle,
                            .atMm = frame_.worldFromPicture(0.5 * (line->a + line->b)),
                            .along = glm::normalize(across)});
    }
    void addPoint(const ClipHandle& handle, const glm::dvec3& atMm, const glm::dvec3& along) {
        const glm::dvec2 px = frame_.pictureFromWorld(atMm);
        const glm::dvec2 size(frame_.sizePx);
        if (px.x < 0.0 || px.y < 0.0 || px.x > size.x || px.y > size.y) return;
        handles_.push_back({.handle = handle, .atMm = atMm, .along = along});
    }

    const slices::SliceFrame& frame_;
    const Volume& volume_;
    std::vector<PlacedHandle> handles_;
};

}  // namespace

std::vector<PlacedHandle> handlesOf(const OptionalClip& clip, const Cuts& cuts, const Volume& volume) {
    std::vector<PlacedHandle> handles;
    const Box all = volume.worldBox();
    if (const Result<Box> kept = keptBox(clip, volume)) addFaces(handles, Kind::face, *kept);
    const auto addPlane = [&](const ClipHandle& handle, const HalfSpace& plane) {
        const double off = plane.offsetMm - glm::dot(plane.normal, all.centre());
        handles.push_back(
            {.handle = handle, .atMm = all.centre() + off * plane.normal, .along = plane.normal});
    };
    if (clip) {
        const Clip inMm = macula::clipFor(*clip, volume);
        if (const auto removed = removedBox(inMm))
            addFaces(handles, Kind::removedFace, common(*removed, all));
        for (std::size_t i = 0; i < inMm.planes.size(); ++i) {
            if (!isAlongAxis(inMm.planes[i])) addPlane({.kind = Kind::plane, .plane = i}, inMm.planes[i]);
        }
        if (inMm.cut)
            handles.push_back({.handle = {.kind = Kind::corner}, .atMm = inMm.cut->pointMm, .along = {}});
        if (inMm.ball) {
            const Ball& ball = *inMm.ball;
            const glm::dvec3 left(1.0, 0.0, 0.0);
            handles.push_back({.handle = {.kind = Kind::ballCentre}, .atMm = ball.centreMm, .along = {}});
            handles.push_back({.handle = {.kind = Kind::ballRadius},
                               .atMm = ball.centreMm + ball.radiusMm * left,
                               .along = left});
        }
    }
    if (cuts.eye && hasRoomForEyeCut(clip)) addPlane({.kind = Kind::eye}, cuts.eye->plane);
    return handles;
}

std::vector<PlacedHandle> handlesOn(const slices::SliceFrame& frame, const OptionalClip& clip,
                                    const Cuts& cuts, const Volume& volume) {
    if (!frame.isUsable() || frame.sizePx.x < 1 || frame.sizePx.y < 1) return {};
    OnSlice slice(frame, volume);
    if (const Result<Box> kept = keptBox(clip, volume)) slice.addFaces(Kind::face, *kept);
    if (clip) {
        const Clip inMm = macula::clipFor(*clip, volume);
        if (const auto removed = removedBox(inMm))
            slice.addFaces(Kind::removedFace, common(*removed, volume.worldBox()));
        for (std::size_t i = 0; i < inMm.planes.size(); ++i) {
            if (!isAlongAxis(inMm.planes[i]))
                slice.addPlane({.kind = Kind::plane, .plane = i}, inMm.planes[i]);
        }
        if (inMm.cut) slice.addCorner(*inMm.cut);
        if (inMm.ball) slice.addBall(*inMm.ball);
    }
    if (cuts.eye && hasRoomForEyeCut(clip)) slice.addPlane({.kind = Kind::eye}, cuts.eye->plane);
    return slice.take();
}

Result<MovedClip> withHandleAt(const OptionalClip& clip, const Cuts& cuts, const ClipHandle& handle,
                               const glm::dvec3& mm, const Volume& volume) {
    const Error gone{ErrorCode::usage,
                     Text("That part of the clip is not there any more."),
                     {},
                     Text("Take hold of another one.")};
    MovedClip moved{.clip = clip, .cuts = cuts};
    const double at = mm[axisOf(handle.face)];
    switch (handle.kind) {
        case Kind::face: {
            MACULA_TRY(moved.clip, withFace(clip, handle.face, at, volume));
            return moved;
        }
        case Kind::removedFace: {
            MACULA_TRY(moved.clip, withRemovedFace(clip, handle.face, at, volume));
            return moved;
        }
        case Kind::plane: {
            MACULA_TRY(moved.clip, withPlaneThrough(clip, handle.plane, mm, volume));
            return moved;
        }
        case Kind::eye:
            if (!cuts.eye) return gone;
            moved.cuts.eye = through(*cuts.eye, mm, volume);
            return moved;
        case Kind::corner: {
            MACULA_TRY(moved.clip, withCornerAt(clip, mm, volume));
            return moved;
        }
        case Kind::ballCentre:
        case Kind::ballRadius:
            break;
    }
    if (!clip || !clip->clip.ball) return gone;
    const Ball ball = *macula::clipFor(*clip, volume).ball;
    const bool isCentre = handle.kind == Kind::ballCentre;
    MACULA_TRY(moved.clip, withBallAt(clip, isCentre ? mm : ball.centreMm,
                                      isCentre ? ball.radiusMm : glm::length(mm - ball.centreMm), volume));
    return moved;
}

glm::dvec3 draggedTo(const ClipHandle& handle, const glm::dvec3& onSliceMm, const slices::SliceFrame& frame,
                     const OptionalClip& clip, const Volume& volume) {
    if (!clip) return onSliceMm;
    const Clip inMm = macula::clipFor(*clip, volume);
    if (handle.kind == Kind::ballCentre && inMm.ball)
        return onSliceMm + frame.distanceMm(inMm.ball->centreMm) * frame.plane.normal();
    if (handle.kind == Kind::corner && inMm.cut)
        return onSliceMm + frame.distanceMm(inMm.cut->pointMm) * frame.plane.normal();
    return onSliceMm;
}

}  // namespace macula::scene
