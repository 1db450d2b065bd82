// Pictures that a model never learns from, so that they can judge it.
#pragma once

#include <cstdint>

#include "pipeline/splat/training_view.h"

namespace macula::hybrid {

// The first ones soon, because nothing is judged without them; then every seventh. (Not every eighth: views
// come along a Sobol sequence, and each eighth point of that lies in the same eighth of the sphere.)
inline constexpr std::size_t kMostHeldOut = 6;
inline constexpr std::size_t kLeastHeldOut = 2;  // a model is judged by no fewer

// Whether view `number`, from 0, is one of them when there are `heldOut` already: 0, 3, 7, 14, 21 and 28.
bool isHeldOut(std::uint64_t number, std::size_t heldOut);

// The same at half the size and again, by means of 2 x 2 pixels, until neither side is longer than
// `mostSidePx`: it costs less to compare, and has less noise.
splat::TrainingView reducedTo(splat::TrainingView view, int mostSidePx);

// Mean coverage of the picture, over pixels that are known; 0 if none is.
double meanCoverage(const splat::TrainingView& view);

}  // namespace macula::hybrid
