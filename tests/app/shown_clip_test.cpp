#include "app/study/shown_clip.h"

#include <gtest/gtest.h>

#include "app/choice/clip_choice.h"
#include "base/phantom.h"

namespace macula::app {
namespace {

segment::PatientMask found(double removedMl) {
    return {.map = *LabelMap::create({4, 3, 2}, glm::dmat4(1.0), {}, std::vector<std::uint16_t>(24, 1)),
            .messages = {},
            .removedMl = removedMl};
}

// A mask of which nothing is outside would cost memory and show the same.
TEST(MaskOfPatient, isNoneWhereNothingWasRemoved) {
    EXPECT_FALSE(maskOf(std::make_shared<const segment::PatientMask>(found(0.0))));
}

TEST(MaskOfPatient, sharesTheLifeOfWhatWasFound) {
    auto patient = std::make_shared<const segment::PatientMask>(found(3.5));
    const LabelMap* map = &patient->map;
    const std::optional<Mask> mask = maskOf(patient);
    ASSERT_TRUE(mask);
    patient.reset();
    EXPECT_EQ(mask->labels.get(), map);
    EXPECT_EQ(mask->labels->labels().size(), 24u);
    EXPECT_EQ(mask->numbers, (std::vector<std::uint16_t>{segment::PatientMask::kPatient}));
}

TEST(ShownClip, isTheClipAloneUnlessTheTableIsToGo) {
    const Volume volume = phantom::make({.size = {24, 20, 16}});
    Progress progress;
    const auto shown = shownClip(*chooseClip("left-half"), false, volume, progress);
    ASSERT_TRUE(shown);
    EXPECT_EQ(shown->clip, clipFor(*chooseClip("left-half"), volume));
    EXPECT_FALSE(shown->tableRemoved);
    EXPECT_TRUE(shown->notes.empty());
}

}  // namespace
}  // namespace macula::app
