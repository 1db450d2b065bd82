// Values within an ellipse in each phase, against values that are known.
#include "scene/slices/time_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>

namespace macula::scene {
namespace {

std::shared_ptr<const study::OpenedStudy> studyOf(float value, const std::string& unit = "HU") {
    VolumeOptions options;
    options.size = {9, 9, 3};
    options.worldFromVoxel = glm::dmat4(1.0);
    options.unit = unit == "HU" ? Unit::hounsfield : Unit::raw;
    // A checkerboard of value - 1 and value + 1.
    std::vector<float> values;
    for (int at = 0; at < 9 * 9 * 3; ++at) values.push_back(value + (at % 2 == 0 ? -1.0f : 1.0f));
    study::OpenedStudy study;
    study.volume =
        std::make_shared<const Volume>(Volume::createFloat(std::move(options), std::move(values)).value());
    return std::make_shared<const study::OpenedStudy>(std::move(study));
}

slices::Measurement ellipse(const std::string& label) {
    return {.label = label,
            .shape = slices::Ellipse{.plane = slices::planeOf(slices::Orientation::axial, {4.0, 4.0, 1.0}),
                                     .radiiMm = {3.0, 3.0}}};
}

std::vector<study::Phase> phases(std::size_t count, bool timed) {
    std::vector<study::Phase> all;
    for (std::size_t i = 0; i < count; ++i)
        all.push_back({.volume = i,
                       .label = Text::verbatim("phase, " + std::to_string(i)),
                       .atMs = timed ? std::optional(150.0 * double(i)) : std::nullopt});
    return all;
}

TEST(TimeCurves, HaveTheMeanOfEachPhase) {
    const std::vector<slices::Measurement> drawn{
        {.shape = slices::Distance{}}, ellipse("aorta"), ellipse("")};
    const auto curves =
        timeCurves(drawn, phases(3, true), {studyOf(10.0f), studyOf(200.0f), studyOf(50.0f)}, {});
    ASSERT_TRUE(curves);
    ASSERT_EQ(curves->curves.size(), 2u);
    EXPECT_EQ(curves->curves[0].label, "aorta");
    EXPECT_EQ(curves->curves[1].number, 3u);
    EXPECT_NE(toCsv(*curves).find(",ellipse 3 mean HU,"), std::string::npos);
    EXPECT_EQ(curves->unit, "HU");
    // 29 voxels: 16 of one colour of the board, 13 of the other.
    const auto& values = curves->curves[0].values;
    ASSERT_EQ(values[0]->voxels, 29u);
    EXPECT_NEAR(std::abs(values[0]->mean - 10.0), 3.0 / 29.0, 1e-6);
    EXPECT_NEAR(values[1]->mean - values[0]->mean, 190.0, 1e-4);
    EXPECT_NEAR(values[2]->mean - values[0]->mean, 40.0, 1e-4);
    const std::string csv = toCsv(*curves);
    EXPECT_TRUE(csv.starts_with("phase,label,ms,aorta mean HU,aorta deviation HU,")) << csv;
    EXPECT_NE(csv.find("\r\n2,\"phase, 1\",150,"), std::string::npos) << csv;
}

TEST(TimeCurves, NeedAnEllipseAndOneUnit) {
    const std::vector<slices::Measurement> lines{{.shape = slices::Distance{}}};
    const auto none = timeCurves(lines, phases(2, false), {studyOf(1.0f), studyOf(2.0f)}, {});
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::usage);
    const std::vector<slices::Measurement> one{ellipse("a")};
    EXPECT_FALSE(timeCurves(one, phases(2, false), {studyOf(1.0f), studyOf(2.0f, "")}, {}));
    const CancelToken token;
    token.cancel();
    const auto cancelled = timeCurves(one, phases(1, false), {studyOf(1.0f)}, token);
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(cancelled.error().code, ErrorCode::cancelled);
}

// A label that a spreadsheet would take for a formula.
TEST(TimeCurves, WriteNoFormulas) {
    const std::vector<slices::Measurement> drawn{ellipse("=1+1")};
    const auto curves = timeCurves(drawn, phases(1, false), {studyOf(3.0f)}, {});
    ASSERT_TRUE(curves);
    EXPECT_NE(toCsv(*curves).find(",'=1+1 mean HU,"), std::string::npos);
}

}  // namespace
}  // namespace macula::scene
