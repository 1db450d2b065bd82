#include "study/documents/image_places.h"

#include <gtest/gtest.h>

#include "study/found_by_hand.h"

namespace macula::study {
namespace {

dicom::Stack withUids(dicom::Stack stack, const std::string& prefix) {
    int number = 0;
    for (dicom::Frame& frame : stack.frames) {
        dicom::Instance instance;
        instance.sopInstanceUid = prefix + std::to_string(++number);
        instance.instanceNumber = 10 * number;
        frame.instance = std::make_shared<const dicom::Instance>(std::move(instance));
    }
    return stack;
}

std::shared_ptr<const FoundVolumes> twoPatients() {
    dicom::Stack loop = test::refused(dicom::key::kSingleSlice, "US");
    dicom::Instance instance;
    instance.sopInstanceUid = "2.25.9";
    instance.frames = 3;
    const auto shared = std::make_shared<const dicom::Instance>(std::move(instance));
    loop.frames.clear();
    for (int n = 0; n < 3; ++n) {
        dicom::Frame frame;
        frame.instance = shared;
        frame.number = n;
        loop.frames.push_back(std::move(frame));
    }
    dicom::Scan scan;
    scan.studies.push_back(test::studyOf(0, "DOE^JANE", "20200102", "Chest",
                                         {test::seriesOf(3, "Lung", {withUids(test::volumeOf(4), "2.25.1")}),
                                          test::seriesOf(4, "Loop", {std::move(loop)}, "US")}));
    scan.studies.push_back(
        test::studyOf(1, "ROE^RICHARD", "20200102", "Chest",
                      {test::seriesOf(5, "Lung", {withUids(test::volumeOf(4), "2.25.2")})}));
    scan.patients = 2;
    return std::make_shared<const FoundVolumes>(std::move(scan));
}

TEST(ImagePlaces, AnImageIsFoundByItsUidAndFrame) {
    const auto found = twoPatients();
    const ImagePlaces places(*found, 0);
    const auto slice = places.of({"", "2.25.13", {}});
    ASSERT_TRUE(slice);
    EXPECT_EQ(slice->frame, 2u);
    EXPECT_EQ(slice->volume, 0u);
    EXPECT_EQ(nameOf(*slice).english(), "Series 3, image 30");
    const auto frame = places.of({"", "2.25.9", {2, 3}});
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->frame, 1u);
    EXPECT_FALSE(frame->volume);
    EXPECT_NE(nameOf(*frame).english().find("frame 2"), std::string::npos);
    EXPECT_EQ(places.of({"", "2.25.9", {}})->frame, 0u);
    EXPECT_FALSE(places.of({"", "2.25.9", {7}}));
    EXPECT_FALSE(places.of({"", "", {}}));
}

TEST(ImagePlaces, AnotherPatientsImageIsNeverFound) {
    const auto found = twoPatients();
    EXPECT_FALSE(ImagePlaces(*found, 0).of({"", "2.25.21", {}}));
    EXPECT_TRUE(ImagePlaces(*found, 1).of({"", "2.25.21", {}}));
    EXPECT_FALSE(ImagePlaces(*found, 1).of({"", "2.25.11", {}}));
}

}  // namespace
}  // namespace macula::study
