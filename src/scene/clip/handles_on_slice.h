// Places handles on a slice: in the middle of the visible part of a line, or at a point.
#pragma once

#include <vector>

#include "scene/clip/clip_shapes.h"

namespace macula::scene {

constexpr double kOnFace = 1e-6;  // fraction of the volume's diagonal
constexpr double kAcross = 0.1;   // the sine of the least angle at which a plane makes a line on a slice

glm::dvec3 normalOf(Face face);  // to the outside
Box common(const Box& a, const Box& b);

// In the volume: in the middle of each face, and where a plane is nearest to the middle of the volume.
std::vector<PlacedHandle> handlesOfFaces(ClipHandle::Kind kind, const Box& box);
PlacedHandle handleOfPlane(const ClipHandle& handle, const HalfSpace& plane, const Box& volumeMm);

class HandlesOnSlice {
  public:
    // Both outlive it.
    HandlesOnSlice(const slices::SliceFrame& frame, const Volume& volume) : frame_(frame), volume_(volume) {}

    const slices::SliceFrame& frame() const { return frame_; }
    Box volumeMm() const { return volume_.worldBox(); }

    void addFaces(ClipHandle::Kind kind, const Box& box);
    void addPlane(const ClipHandle& handle, const HalfSpace& plane);
    // Not beside the picture.
    void addPoint(const ClipHandle& handle, const glm::dvec3& atMm, const glm::dvec3& along);

    std::vector<PlacedHandle> take() { return std::move(handles_); }

  private:
    void addLine(const ClipHandle& handle, const glm::dvec3& normal, const glm::dvec3& a,
                 const glm::dvec3& b);

    const slices::SliceFrame& frame_;
    const Volume& volume_;
    std::vector<PlacedHandle> handles_;
};

}  // namespace macula::scene
