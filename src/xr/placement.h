// Places the anatomy in the room, and moves and cuts it with the hands. Knows no OpenXR.
//
// `stageFromWorld` maps patient LPS in mm to the stage in metres: a rotation, a translation and a scale,
// never a mirror. At real size a millimetre of the patient is one of the room.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "base/frames.h"
#include "pipeline/volume/clip.h"
#include "xr/eyes.h"

namespace macula::xr {

inline constexpr double kMetresPerMm = 1e-3;
inline constexpr double kNearM = 0.01;  // in the room: the head may go inside the anatomy

// Upright at real size, its middle at eye level, its anterior side towards the wearer, and within reach.
glm::dmat4 stageFromWorldBefore(const Pose& head, const Box& seenMm);

// The scale of the anatomy in the room: 1 at real size.
double scaleOf(const glm::dmat4& stageFromWorld);

// The near distance kNearM in mm of the patient: a head may go inside, and nothing is drawn right at the
// eyes.
double nearMmOf(const glm::dmat4& stageFromWorld);

// The placement after a hand that held the anatomy has moved from `then` to `now`.
glm::dmat4 followingHand(const glm::dmat4& stageFromWorldThen, const Pose& then, const Pose& now);

// The same with two hands: the point between them stays there; the anatomy turns with the line between the
// hands, and scales with its length, from kLeastScale to kMostScale.
inline constexpr double kLeastScale = 0.05;
inline constexpr double kMostScale = 20.0;
glm::dmat4 followingHands(const glm::dmat4& stageFromWorldThen, const std::array<Pose, 2>& then,
                          const std::array<Pose, 2>& now);

// The blade of a knife with this pose is the plane of its own y and z axes; everything to its right is
// removed.
HalfSpace keptBeside(const Pose& knife, const glm::dmat4& worldFromStage);

}  // namespace macula::xr
