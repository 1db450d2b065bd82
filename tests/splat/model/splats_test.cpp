#include "pipeline/splat/model/splats.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace macula::splat {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Splats that differ in every array.
Splats numbered(std::size_t count, int degree) {
    Splats splats;
    splats.shDegree = degree;
    splats.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        splats.position[i] = glm::vec3(static_cast<float>(i));
        splats.opacityLogit[i] = 0.5f * static_cast<float>(i);
        for (std::size_t k = 0; k < shCount(degree); ++k)
            splats.sh[i * shCount(degree) + k] = glm::vec3(static_cast<float>(100 * i + k));
    }
    return splats;
}

TEST(Splats, NewOnesAreValid) {
    for (int degree = 0; degree <= kMaxShDegree; ++degree) {
        EXPECT_TRUE(numbered(5, degree).validate().ok());
        EXPECT_TRUE(numbered(0, degree).validate().ok());
    }
}

TEST(Splats, ArraysMustAgree) {
    const auto broken = [](auto change) {
        Splats splats = numbered(3, 1);
        change(splats);
        return !splats.validate().ok();
    };
    EXPECT_TRUE(broken([](Splats& s) { s.position.pop_back(); }));
    EXPECT_TRUE(broken([](Splats& s) { s.logScale.pop_back(); }));
    EXPECT_TRUE(broken([](Splats& s) { s.rotation.pop_back(); }));
    EXPECT_TRUE(broken([](Splats& s) { s.opacityLogit.pop_back(); }));
    EXPECT_TRUE(broken([](Splats& s) { s.dc.pop_back(); }));
    EXPECT_TRUE(broken([](Splats& s) { s.sh.pop_back(); }));
    EXPECT_TRUE(broken([](Splats& s) { s.shDegree = 0; }));
    EXPECT_TRUE(broken([](Splats& s) { s.shDegree = -1; }));
    EXPECT_TRUE(broken([](Splats& s) { s.shDegree = 4; }));
    EXPECT_TRUE(broken([](Splats& s) { s.originMm.y = kNan; }));
}

TEST(Splats, ValidateCountsTheBad) {
    Splats splats = numbered(9, 1);
    splats.position[0].z = kNan;
    splats.logScale[1].x = -kInfinity;
    splats.rotation[2] = glm::vec4(0.0f);
    splats.rotation[3] = glm::vec4(1e30f);
    splats.opacityLogit[4] = kInfinity;
    splats.dc[5].y = kNan;
    splats.sh[3 * 6 + 2].x = kNan;
    const auto result = splats.validate();
    ASSERT_FALSE(result.ok());
    EXPECT_NE(result.error().message.english().find("7 of the 9"), std::string::npos)
        << result.error().message;
}

TEST(Splats, RepairKeepsWhatCanBeDrawn) {
    Splats splats = numbered(8, 1);
    splats.position[0].z = kNan;                       // dropped
    splats.logScale[1] = glm::vec3(-kInfinity, 0, 0);  // flat
    splats.opacityLogit[2] = kInfinity;                // opaque
    splats.rotation[3] = glm::vec4(0.0f);              // dropped
    splats.logScale[4].y = kNan;                       // dropped
    splats.sh[3 * 5 + 2].x = kInfinity;                // dropped
    splats.logScale[6].z = -1e6f;                      // flat
    const auto done = repair(splats);
    ASSERT_TRUE(done.ok());
    EXPECT_EQ(done->dropped, 4u);
    EXPECT_EQ(done->clamped, 3u);
    ASSERT_TRUE(splats.validate().ok());
    ASSERT_EQ(splats.size(), 4u);
    const std::size_t origin[] = {1, 2, 6, 7};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(splats.position[i].x, static_cast<float>(origin[i]));
        EXPECT_EQ(splats.sh[3 * i + 1].x, static_cast<float>(100 * origin[i] + 1));
    }
    EXPECT_EQ(splats.logScale[0].x, -kMaxLogScale);
    EXPECT_EQ(splats.opacityLogit[1], kMaxOpacityLogit);
    EXPECT_EQ(splats.logScale[2].z, -kMaxLogScale);
    EXPECT_EQ(splats.opacityLogit[3], 3.5f);
}

TEST(Splats, RepairLeavesOutWhatFloodsThePicture) {
    Splats splats = numbered(8, 1);
    for (glm::vec3& scale : splats.logScale) scale = glm::vec3(0.0f);
    const double extent = glm::length(splats.position[7] - splats.position[0]);
    const auto times = [&](double factor) { return static_cast<float>(std::log(factor * extent)); };
    splats.logScale[1].y = kInfinity;
    splats.logScale[2].z = 1e6f;
    splats.logScale[3].x = 15.0f;  // of a damaged byte: 3 km
    splats.logScale[4].x = times(10.1);
    splats.logScale[5].x = times(9.9);  // a backdrop, at most
    const auto done = repair(splats);
    ASSERT_TRUE(done.ok());
    EXPECT_EQ(done->dropped, 4u);
    EXPECT_EQ(done->clamped, 0u);
    ASSERT_EQ(splats.size(), 4u);
    EXPECT_EQ(splats.logScale[1].x, times(9.9));
    // Where all are alike, however large beside their distance, none floods.
    Splats alike;
    alike.resize(3);
    for (glm::vec3& scale : alike.logScale) scale = glm::vec3(5.0f);
    EXPECT_EQ(repair(alike)->dropped, 0u);
}

TEST(Splats, RepairRefusesWhatIsBrokenAsAWhole) {
    Splats splats = numbered(3, 0);
    splats.dc.pop_back();
    EXPECT_FALSE(repair(splats).ok());
}

TEST(Splats, BandsSurviveAChangeOfDegree) {
    Splats splats = numbered(3, 2);
    splats.setShDegree(1);
    ASSERT_TRUE(splats.validate().ok());
    EXPECT_EQ(splats.sh[3 * 2 + 2].y, 202.0f);
    splats.setShDegree(3);
    ASSERT_TRUE(splats.validate().ok());
    EXPECT_EQ(splats.sh[15 * 2 + 2].y, 202.0f);
    EXPECT_EQ(splats.sh[15 * 2 + 3].y, 0.0f);
    splats.setShDegree(0);
    EXPECT_TRUE(splats.sh.empty());
}

TEST(Splats, BoxIsInTheWorld) {
    Splats splats = numbered(3, 0);
    splats.originMm = glm::dvec3(1e5, -1e5, 0.125);
    splats.position[1] = glm::vec3(-4.0f, 7.0f, 0.0f);
    const Box box = boundingBox(splats);
    EXPECT_EQ(box.low, glm::dvec3(1e5 - 4, -1e5, 0.125));
    EXPECT_EQ(box.high, glm::dvec3(1e5 + 2, -1e5 + 7, 2.125));
    const Box none = boundingBox(Splats{});
    EXPECT_GT(none.low.x, none.high.x);
}

}  // namespace
}  // namespace macula::splat
