// Pictures that a model never learns from, so that they can judge it.
#pragma once

#include <cstdint>

#include "pipeline/splat/train/training_view.h"

namespace macula::hybrid {

inline constexpr std::size_t kLeastHeldOut = 2;  // with fewer a model is not judged
inline constexpr std::size_t kMostHeldOut = 6;

// Whether view `number`, from 0, is held out if `heldOut` are already, the nearest of them `besideDeg` away.
// The first four are held out early, because a model cannot be judged without any: usually 0, 3, 7 and 14.
// (Not every eighth: views follow a Sobol sequence, each eighth point of which lies in the same eighth of the
// sphere.) Later ones are views more than 75 degrees away from all held-out ones, while these are less than a
// third of all views: otherwise progress on that side would not be measured.
bool isHeldOut(std::uint64_t number, std::size_t heldOut, double besideDeg);

// The view, halved in size by averaging 2 x 2 pixels until neither side is longer than `mostSidePx`: it is
// cheaper to compare, and has less noise. Unchanged if the number of pixels does not fit the view.
splat::TrainingView reducedTo(splat::TrainingView view, int mostSidePx);

// The mean coverage of the picture's known pixels; 0 without any.
double meanCoverage(const splat::TrainingView& view);

}  // namespace macula::hybrid
