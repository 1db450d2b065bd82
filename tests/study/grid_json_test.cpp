#include "study/export/grid_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace macula::study {
namespace {

TEST(GridJson, SaysWhereVoxelsLie) {
    const glm::dmat4 grid = affine({-0.5, 0.0, 0.0}, {0.0, 0.0, 2.0}, {0.0, 3.0, 0.0}, {7.0, 8.0, 9.0});
    const auto json = gridToJson({4, 5, 6}, grid);
    EXPECT_EQ(json["size"], (nlohmann::ordered_json{4, 5, 6}));
    EXPECT_EQ(json["spacingMm"], (nlohmann::ordered_json{0.5, 2.0, 3.0}));
    EXPECT_EQ(json["orientation"], "RSP");
    EXPECT_EQ(json["worldFromVoxel"][0], (nlohmann::ordered_json{-0.5, 0.0, 0.0, 7.0}));
    EXPECT_EQ(json["worldFromVoxel"][1], (nlohmann::ordered_json{0.0, 0.0, 3.0, 8.0}));
    EXPECT_EQ(json["worldFromVoxel"][3], (nlohmann::ordered_json{0.0, 0.0, 0.0, 1.0}));
    EXPECT_FALSE(isSheared(grid));
}

// 0.05 degrees are a cosine of 8.7e-4.
TEST(GridJson, TellsATiltedGantry) {
    const auto tilted = [](double degrees) {
        const double angle = degrees * std::acos(-1.0) / 180.0;
        return affine({1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 2.0 * std::sin(angle), 2.0 * std::cos(angle)},
                      {0.0, 0.0, 0.0});
    };
    EXPECT_FALSE(isSheared(tilted(0.0)));
    EXPECT_FALSE(isSheared(tilted(0.04)));
    EXPECT_TRUE(isSheared(tilted(0.06)));
    EXPECT_TRUE(isSheared(tilted(-20.0)));
}

}  // namespace
}  // namespace macula::study
