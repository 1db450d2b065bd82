// Numbers of images as other workstations tell them.
#include "study/open/image_numbers.h"

#include <gtest/gtest.h>

#include <memory>

#include "study/found_by_hand.h"

namespace macula::study {
namespace {

using Numbers = std::vector<int>;

dicom::Stack numbered(const Numbers& numbers) {
    dicom::Stack stack = test::volumeOf(numbers.size());
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        auto instance = std::make_shared<dicom::Instance>();
        if (numbers[k] != 0) instance->instanceNumber = numbers[k];
        stack.frames[k].instance = std::move(instance);
    }
    return stack;
}

// From head to feet, as most series are numbered, while slices are counted from the feet.
TEST(ImageNumbers, ThoseOfASeriesThatIsNumberedFromTheHead) {
    EXPECT_EQ(imageNumbersOf(numbered({3, 2, 1}), 3), (Numbers{3, 2, 1}));
    EXPECT_EQ(imageNumbersOf(numbered({101, 102, 103}), 3), (Numbers{101, 102, 103}));
    EXPECT_EQ(imageNumbersOf(numbered({1, 2, 3}), 3), (Numbers{1, 2, 3}));
}

TEST(ImageNumbers, SayNothingBesideThoseOfSlicesWhereTheyCountTheSame) {
    EXPECT_TRUE(countAsSlices(Numbers{1, 2, 3}));
    EXPECT_TRUE(countAsSlices(Numbers{1, 0, 3})) << "one is interpolated";
    EXPECT_TRUE(countAsSlices(Numbers{}));
    EXPECT_FALSE(countAsSlices(Numbers{3, 2, 1}));
    EXPECT_FALSE(countAsSlices(Numbers{11, 12, 13}));
}

TEST(ImageNumbers, NoneWhereTheySayNothingOrMayBeWrong) {
    EXPECT_EQ(imageNumbersOf(numbered({3, 0, 1}), 3), Numbers{}) << "one is missing";
    EXPECT_EQ(imageNumbersOf(numbered({3, 3, 1}), 3), Numbers{}) << "one stands twice";
    EXPECT_EQ(imageNumbersOf(numbered({3, -2, 1}), 3), Numbers{});
    EXPECT_EQ(imageNumbersOf(numbered({3, 2, 1}), 2), Numbers{}) << "which of them was cut off?";
    EXPECT_EQ(imageNumbersOf(dicom::Stack(), 0), Numbers{});
    EXPECT_EQ(imageNumbersOf(test::volumeOf(4), 4), Numbers{}) << "frames of one file";
    dicom::Stack broken = numbered({3, 2, 1});
    broken.slices[1].below = broken.slices[1].above = 7;
    EXPECT_EQ(imageNumbersOf(broken, 3), Numbers{});
}

TEST(ImageNumbers, OfWhatIsInterpolatedThereIsNoImage) {
    dicom::Stack stack = numbered({3, 2, 1});
    stack.slices = {{.below = 0, .above = 0, .weight = 0.0},
                    {.below = 0, .above = 1, .weight = 0.5},
                    {.below = 1, .above = 1, .weight = 0.0},
                    {.below = 2, .above = 2, .weight = 0.0}};
    EXPECT_EQ(imageNumbersOf(stack, 4), (Numbers{3, 0, 2, 1}));
}

}  // namespace
}  // namespace macula::study
