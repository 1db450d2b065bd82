// Pictures that a model never learns from, so that they can judge it.
#pragma once

#include <cstdint>

#include "pipeline/splat/train/training_view.h"

namespace macula::hybrid {

inline constexpr std::size_t kLeastHeldOut = 2;  // a model is judged by no fewer
inline constexpr std::size_t kMostHeldOut = 6;

// Whether view `number`, from 0, is held out when there are `heldOut` already and it is seen from so many
// degrees beside the nearest of them. The first ones soon, because nothing is judged without them: 0, 3, 7
// and 14. (Not every eighth: views come along a Sobol sequence, and each eighth point of that lies in the
// same eighth of the sphere.) And what is seen from a side that none of them shows, more than 75 degrees
// away, as long as they are no more than a third of all: else nobody would notice what is gained there.
bool isHeldOut(std::uint64_t number, std::size_t heldOut, double besideDeg);

// The view, halved in size by means of 2 x 2 pixels until neither side is longer than `mostSidePx`: it costs
// less to compare, and has less noise. Unchanged if the picture is not of its view's size.
splat::TrainingView reducedTo(splat::TrainingView view, int mostSidePx);

// Mean coverage of the picture, over pixels that are known; 0 if none is.
double meanCoverage(const splat::TrainingView& view);

}  // namespace macula::hybrid
