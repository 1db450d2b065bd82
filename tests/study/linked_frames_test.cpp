// Frames at one place of the patient, against closed form.
#include "study/planar/linked_frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace macula::study {
namespace {

// Frames of 100 x 50 pixels, 1 mm wide and 2 mm high, with these positions along z.
dicom::Stack axial(std::initializer_list<double> heightsMm, const char* reference = "a") {
    dicom::Stack stack;
    dicom::Instance instance;
    instance.columns = 100;
    instance.rows = 50;
    const auto shared = std::make_shared<const dicom::Instance>(instance);
    for (const double z : heightsMm) {
        dicom::Frame frame;
        frame.instance = shared;
        frame.frameOfReferenceUid = reference;
        frame.plane =
            dicom::ImagePlane{.positionMm = {0.0, 0.0, z}, .columnSpacingMm = 1.0, .rowSpacingMm = 2.0};
        stack.frames.push_back(frame);
    }
    return stack;
}

TEST(LinkedFrames, LieNearestInMillimetres) {
    const dicom::Stack thick = axial({0.0, 5.0, 10.0, 15.0});
    const dicom::Stack thin = axial({0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0});
    EXPECT_EQ(linkedFrame(thick.frames[1], thin, 0.0), 5u);
    EXPECT_EQ(linkedFrame(thick.frames[3], thin, 0.0), 10u) << "the last, where there is none";
    EXPECT_EQ(linkedFrame(thin.frames[7], thick, 0.0), 1u);
    EXPECT_EQ(linkedFrame(thin.frames[8], thick, 0.0), 2u);
    EXPECT_EQ(shiftMm(thin.frames[8], thick.frames[0]), 0.0) << "one frame of reference: as they lie";
}

TEST(LinkedFrames, OfAnotherFrameOfReferenceAreShifted) {
    const dicom::Stack now = axial({100.0, 105.0, 110.0});
    const dicom::Stack before = axial({-40.0, -37.5, -35.0, -32.5, -30.0}, "b");
    const auto shift = shiftMm(now.frames[0], before.frames[1]);
    ASSERT_TRUE(shift);
    EXPECT_DOUBLE_EQ(*shift, -137.5);
    EXPECT_EQ(linkedFrame(now.frames[0], before, *shift), 1u);
    EXPECT_EQ(linkedFrame(now.frames[1], before, *shift), 3u);
    EXPECT_EQ(linkedFrame(now.frames[2], before, *shift), 4u);
}

TEST(LinkedFrames, RunAgainstEachOtherWhereTheirNormalsDo) {
    const dicom::Stack up = axial({0.0, 1.0, 2.0});
    dicom::Stack down = axial({2.0, 1.0, 0.0});
    for (dicom::Frame& frame : down.frames) frame.plane->rowDirection = {-1.0, 0.0, 0.0};
    EXPECT_EQ(linkedFrame(up.frames[0], down, 0.0), 2u);
}

TEST(LinkedFrames, HaveNoneWithoutPlanesOrAcross) {
    const dicom::Stack stack = axial({0.0, 1.0});
    dicom::Stack coronal = stack;
    for (dicom::Frame& frame : coronal.frames) frame.plane->columnDirection = {0.0, 0.0, -1.0};
    EXPECT_FALSE(linkedFrame(stack.frames[0], coronal, 0.0));
    EXPECT_FALSE(shiftMm(stack.frames[0], coronal.frames[0]));
    dicom::Stack none = stack;
    for (dicom::Frame& frame : none.frames) frame.plane.reset();
    EXPECT_FALSE(linkedFrame(stack.frames[0], none, 0.0));
    EXPECT_FALSE(linkedFrame(none.frames[0], stack, 0.0));
    EXPECT_FALSE(linkedFrame(stack.frames[0], {}, 0.0));
    dicom::Stack odd = axial({std::nan(""), std::numeric_limits<double>::infinity()});
    EXPECT_FALSE(linkedFrame(stack.frames[0], odd, 0.0));
    EXPECT_FALSE(linkedFrame(stack.frames[0], stack, std::nan("")));
}

TEST(OutlineOnAnImage, IsALineAcross) {
    const dicom::Stack slices = axial({-30.0});
    dicom::Stack coronal = axial({10.0});
    coronal.frames[0].plane->positionMm = {-20.0, 5.0, 10.0};
    coronal.frames[0].plane->columnDirection = {0.0, 0.0, -1.0};  // rows run to the feet, 2 mm each
    const auto line = outlineOn(coronal.frames[0], slices.frames[0]);
    ASSERT_TRUE(line);
    for (const glm::dvec2& corner : *line) EXPECT_NEAR(corner.y, 20.5, 1e-9) << "40 mm below the first row";
    EXPECT_NEAR((*line)[0].x, 20.0, 1e-9) << "half a pixel before the centre at 20 mm";
    EXPECT_NEAR((*line)[1].x, 120.0, 1e-9);
    EXPECT_FALSE(outlineOn(slices.frames[0], slices.frames[0])) << "not across";
    EXPECT_FALSE(outlineOn(coronal.frames[0], axial({0.0}, "b").frames[0])) << "another frame of reference";
    EXPECT_FALSE(outlineOn(coronal.frames[0], axial({0.0}, "").frames[0]));
}

}  // namespace
}  // namespace macula::study
