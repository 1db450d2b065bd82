// A plane across the line of sight, and the clip that it belongs to. World frame: patient LPS, mm.
#pragma once

#include "base/frames.h"
#include "base/result.h"
#include "base/volume.h"
#include "pipeline/volume/clip.h"
#include "scene/clip/cuts.h"

namespace macula::scene {

// Cuts across the view of `camera` at this distance from the middle of the volume's box. The plane leaves at
// least a voxel of the box, while fromMiddleMm keeps the requested distance: along another direction the box
// may reach farther. usage for an invalid camera, or a distance that is not finite.
Result<EyeCut> eyeCut(const Camera& camera, double fromMiddleMm, bool followsCamera, const Volume& volume);

// The cut at another distance; a distance that is not finite changes nothing.
EyeCut at(EyeCut cut, double fromMiddleMm, const Volume& volume);
// The cut through `mm`, or as near to it as leaves a voxel of the box.
EyeCut through(EyeCut cut, const glm::dvec3& mm, const Volume& volume);

// The distances from the middle that are useful: from the near end of the volume's box, where the cut removes
// nothing, to one voxel before its far end.
ValueRange eyeCutRangeMm(const glm::dvec3& normal, const Volume& volume);

// Whether the clip has room for one more plane; if not, the cut from the eye is left out.
bool hasRoomForEyeCut(const OptionalClip& clip);

// The clip in mm of the volume, with the plane of the cut from the eye, which no other function adds.
Clip clipFor(const OptionalClip& clip, const Cuts& cuts, const Volume& volume);

}  // namespace macula::scene
