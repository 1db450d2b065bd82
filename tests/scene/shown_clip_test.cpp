#include "scene/drawing/shown_clip.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/phantom.h"
#include "scene/choice/clip_choice.h"
#include "segment/scene.h"

namespace macula::scene {
namespace {

segment::PatientMask found(double removedMl) {
    return {.map = *LabelMap::create({4, 3, 2}, glm::dmat4(1.0), {}, std::vector<std::uint16_t>(24, 1)),
            .messages = {},
            .removedMl = removedMl};
}

// A mask of which nothing is outside would cost memory and show the same.
TEST(MaskOfPatient, IsNoneWhereNothingWasRemoved) {
    EXPECT_FALSE(maskOf(std::make_shared<const segment::PatientMask>(found(0.0))));
}

TEST(MaskOfPatient, SharesTheLifeOfWhatWasFound) {
    auto patient = std::make_shared<const segment::PatientMask>(found(3.5));
    const LabelMap* map = &patient->map;
    const std::optional<Mask> mask = maskOf(patient);
    ASSERT_TRUE(mask);
    patient.reset();
    EXPECT_EQ(mask->labels.get(), map);
    EXPECT_EQ(mask->labels->labels().size(), 24u);
    EXPECT_EQ(mask->numbers, (std::vector<std::uint16_t>{segment::PatientMask::kPatient}));
}

TEST(ShownClip, IsTheClipAloneUnlessTheTableIsToGo) {
    const Volume volume = phantom::make({.size = {24, 20, 16}});
    Progress progress;
    const auto shown = shownClip(*chooseClip("left-half"), false, volume, progress);
    ASSERT_TRUE(shown);
    EXPECT_EQ(shown->clip, clipFor(*chooseClip("left-half"), volume));
    EXPECT_FALSE(shown->tableRemoved);
    EXPECT_TRUE(shown->notes.empty());
}

// Nobody asked: it goes where it is sure, with a sentence that says how to have it back.
TEST(ShownClip, LeavesASureTableOutWhereNobodyAsked) {
    const segment::test::Made lying = segment::test::make({});
    Progress progress;
    const auto shown = shownClip(StudyState{}, lying.volume, progress, UnaskedTable::goesWhereSure);
    ASSERT_TRUE(shown.ok());
    EXPECT_TRUE(shown->tableRemoved);
    ASSERT_TRUE(shown->clip.mask);
    ASSERT_FALSE(shown->notes.empty());
    EXPECT_NE(shown->notes.back().english().find("--keep-table"), std::string::npos);
    const auto asked = shownClip(StudyState{.leavesTableOut = true}, lying.volume, progress);
    ASSERT_TRUE(asked.ok());
    EXPECT_TRUE(std::ranges::equal(shown->clip.mask->labels->labels(), asked->clip.mask->labels->labels()))
        << "the same goes as when somebody asks";
    const auto stays = shownClip(StudyState{}, lying.volume, progress);
    EXPECT_FALSE(stays->clip.mask);
}

TEST(ShownClip, KeepsWhatIsNotSureAndSaysHowItGoes) {
    // Flattened by the table: it is found, and it touches the person in most slices.
    const segment::test::Made lying = segment::test::make({.gapMm = 0.0, .sunkMm = 8.0});
    ASSERT_EQ(segment::test::find(lying.volume).confidence, segment::Confidence::moderate);
    Progress progress;
    const auto shown = shownClip(StudyState{}, lying.volume, progress, UnaskedTable::goesWhereSure);
    ASSERT_TRUE(shown.ok());
    EXPECT_FALSE(shown->tableRemoved);
    EXPECT_FALSE(shown->clip.mask);
    ASSERT_EQ(shown->notes.size(), 1u);
    EXPECT_NE(shown->notes.front().english().find("--remove-table"), std::string::npos);
}

TEST(ShownClip, IsQuietWhereThereIsNoTableAndOfWhatIsNoCt) {
    Progress progress;
    for (const Unit unit : {Unit::hounsfield, Unit::raw}) {
        const auto volume =
            Volume::create({.size = {8, 8, 8}, .unit = unit}, std::vector<std::uint16_t>(512, 7));
        ASSERT_TRUE(volume.ok());
        const auto shown = shownClip(StudyState{}, *volume, progress, UnaskedTable::goesWhereSure);
        ASSERT_TRUE(shown.ok());
        EXPECT_FALSE(shown->clip.mask);
        EXPECT_TRUE(shown->notes.empty());
    }
}

TEST(ShownClip, ThatIsStoppedWhileItLooksForATableIsNone) {
    const segment::test::Made lying = segment::test::make({});
    const CancelToken token;
    token.cancel();
    Progress progress({}, token);
    const auto shown = shownClip(StudyState{}, lying.volume, progress, UnaskedTable::goesWhereSure);
    ASSERT_FALSE(shown.ok());
    EXPECT_EQ(shown.error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace macula::scene
