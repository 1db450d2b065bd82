// The images of a study that are fetched before the others, so that a person soon sees something.
#pragma once

#include <vector>

#include "net/archive/query.h"

namespace macula::net {

// Neighbours from the middle of the largest series, by their numbers: archives send in no order of space, and
// images that lie scattered make no volume until most are there. Nothing for a study that is small, and for a
// series whose images have no numbers of their own.
std::vector<FoundInstance> firstImagesOf(const std::vector<FoundInstance>& wanted);

}  // namespace macula::net
