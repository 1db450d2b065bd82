// What a model begins with.
#include "pipeline/hybrid/model/model_start.h"

#include <gtest/gtest.h>

namespace macula::hybrid {
namespace {

TEST(RelativeTo, MovesTheOriginAndNothingElse) {
    splat::Splats splats;
    splats.originMm = {10.0, 20.0, 30.0};
    splats.resize(3);
    splats.position[2] = {4.0f, 0.0f, 0.0f};
    const splat::Splats moved = relativeTo(splats, {11.0, 20.0, 28.0});
    EXPECT_EQ(moved.originMm, glm::dvec3(11.0, 20.0, 28.0));
    EXPECT_EQ(moved.position[2], glm::vec3(3.0f, 0.0f, 2.0f));
    EXPECT_EQ(boundingBox(moved).low, boundingBox(splats).low);
    EXPECT_EQ(boundingBox(moved).high, boundingBox(splats).high);
}

}  // namespace
}  // namespace macula::hybrid
