// Pairs of volumes of which the true place is known, for comparisons of one registration with another.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/volume.h"

namespace macula::registration::test {

struct ComparedPair {
    std::string name;
    std::shared_ptr<const Volume> fixed;
    std::shared_ptr<const Volume> moving;
    glm::dmat4 truth{1.0};  // movingFromFixed
};

// The phantom after it was moved by 12 mm and turned by 7 degrees.
ComparedPair movedPair();
// That, and: with noise of 60 HU in both; on voxels of 2 x 2 x 10 mm; as MR would have it, without order of
// values; moved by 60 mm; and a part of it only.
std::vector<ComparedPair> comparedPairs();

}  // namespace macula::registration::test
