// Where the anatomy stands in the room, and how hands move and cut it. Knows no OpenXR.
//
// `stageFromWorld` takes patient LPS in mm to the stage in metres: a turn, a shift and a scale, never a
// mirror. At real-world scale a millimetre of the patient is one of the room.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "base/frames.h"
#include "pipeline/volume/clip.h"
#include "xr/eyes.h"

namespace macula::xr {

inline constexpr double kMetresPerMm = 1e-3;
inline constexpr double kNearM = 0.01;  // of the room: the head may go inside the anatomy

// Upright at real-world scale, its middle at the height of the eyes, its anterior side towards who stands
// there, near enough to reach for.
glm::dmat4 stageFromWorldBefore(const Pose& head, const Box& seenMm);

// How large the anatomy is in the room: 1 at real-world scale.
double scaleOf(const glm::dmat4& stageFromWorld);

// Of the patient, as far as a centimetre of the room: a head may go inside, and what touches the eyes is not
// drawn.
double nearMmOf(const glm::dmat4& stageFromWorld);

// What was grabbed by a hand that was there `then` follows it.
glm::dmat4 followingHand(const glm::dmat4& stageFromWorldThen, const Pose& then, const Pose& now);

// By two hands: what lay between them stays between them; it turns as the line from one to the other, and
// grows as they part, within kLeastScale and kMostScale.
inline constexpr double kLeastScale = 0.05;
inline constexpr double kMostScale = 20.0;
glm::dmat4 followingHands(const glm::dmat4& stageFromWorldThen, const std::array<Pose, 2>& then,
                          const std::array<Pose, 2>& now);

// The blade of a knife that is held so is the plane of its own y and z; what is to the right of it is
// removed.
HalfSpace keptBeside(const Pose& knife, const glm::dmat4& worldFromStage);

}  // namespace macula::xr
