// A plane across the line of sight, and the clip that it belongs to. World frame: patient LPS, mm.
#pragma once

#include "base/frames.h"
#include "base/result.h"
#include "base/volume.h"
#include "pipeline/volume/clip.h"
#include "scene/clip/cuts.h"

namespace macula::app {

// Across the view of that camera, so far from the middle of the volume's box. Where the box ends before that,
// the plane leaves a voxel of it, and the depth stays as it was asked for: seen along another direction the
// box may reach farther. usage for a camera that is none, or a distance that is no number.
Result<EyeCut> eyeCut(const Camera& camera, double fromMiddleMm, bool followsCamera, const Volume& volume);

// The same direction, elsewhere; a distance that is no number changes nothing.
EyeCut at(EyeCut cut, double fromMiddleMm, const Volume& volume);
// Through that point, or as near to it as leaves a voxel of the box.
EyeCut through(EyeCut cut, const glm::dvec3& mm, const Volume& volume);

// From before all of the volume's box to a voxel before its end.
ValueRange eyeCutRangeMm(const glm::dvec3& normal, const Volume& volume);

// Planes that a clip has room for beside its own; without any, the cut from the eye is left out.
bool hasRoomForEyeCut(const ClipChoice& clip);

// All of it that has a shape, in mm of the volume. The one place where the cut from the eye joins a clip.
Clip clipFor(const ClipChoice& clip, const Cuts& cuts, const Volume& volume);

}  // namespace macula::app
