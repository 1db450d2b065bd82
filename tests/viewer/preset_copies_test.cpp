// Which preset is edited, and what a reset returns to, without the panel.
#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "scene/choice/catalogue.h"
#include "viewer/transfer/counted_values.h"
#include "viewer/transfer/preset_copies.h"

namespace macula::viewer {
namespace {

std::shared_ptr<const Volume> smallVolume() {
    auto volume = Volume::create({.size = glm::ivec3(8), .unit = Unit::hounsfield, .modality = "CT"},
                                 std::vector<std::uint16_t>(512, 1000));
    return std::make_shared<const Volume>(*std::move(volume));
}

class PresetCopiesTest : public testing::Test {
  protected:
    PresetCopiesTest() {
        scene::StudyState state;
        state.preset = *scene::findPreset(session_.catalogue(), "ct-bone");
        session_.show({.volume = smallVolume()}, state);
    }
    void choose(TransferFunction function) {
        session_.change("Preset", [&](scene::StudyState& next) {
            next.preset = std::make_shared<const TransferFunction>(std::move(function));
        });
    }

    StudyEditor session_{*scene::builtInCatalogue()};
    PresetCopies copies_{session_};
};

TEST_F(PresetCopiesTest, AChosenPresetGetsACopyOfAnotherName) {
    const PresetCopies::Edited edited = copies_.edited();
    EXPECT_FALSE(edited.isInState);
    EXPECT_EQ(edited.chosen.function, session_.state().preset);
    EXPECT_NE(edited.function.name, session_.state().preset->name);
}

TEST_F(PresetCopiesTest, AfterAnEditTheCopyIsInTheStateAndTheChosenOneIsStillKnown) {
    const auto chosen = session_.state().preset;
    TransferFunction function = copies_.edited().function;
    function.unitDistanceMm *= 2.0;
    choose(function);
    const PresetCopies::Edited edited = copies_.edited();
    EXPECT_TRUE(edited.isInState);
    EXPECT_EQ(edited.function, function);
    EXPECT_EQ(edited.chosen.inState, chosen);
}

TEST_F(PresetCopiesTest, ACopyOfAnotherSessionHasItsOriginalInTheCatalogue) {
    choose(copies_.edited().function);
    copies_.forget();
    const PresetCopies::Edited edited = copies_.edited();
    EXPECT_TRUE(edited.isInState);
    EXPECT_EQ(edited.chosen.function->name, "ct-bone");
}

TEST_F(PresetCopiesTest, WithoutAChoiceTheVolumeDecides) {
    session_.change("Preset", [](scene::StudyState& next) { next.preset = nullptr; });
    const PresetCopies::Edited edited = copies_.edited();
    EXPECT_FALSE(edited.isInState);
    EXPECT_EQ(edited.chosen.inState, nullptr);
    ASSERT_TRUE(edited.chosen.function);
}

TEST(CountedValues, OnlyAPresetThatIsFittedToTheForegroundWaits) {
    CountedValues values;
    values.begin(smallVolume());
    EXPECT_FALSE(values.histogram());
    const auto map = values.mapFor({});
    ASSERT_TRUE(map);
    EXPECT_EQ(map->shownFrom(42.0), 42.0);
    using Fit = TransferFunction::Fit;
    EXPECT_FALSE(values.mapFor({.fitToVolume = Fit{.low = 0.0, .high = 1.0, .to = Fit::To::foreground}}));
}

}  // namespace
}  // namespace macula::viewer
