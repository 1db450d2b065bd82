// The rows of the gallery of presets, without a widget.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "scene/choice/catalogue.h"
#include "viewer/offscreen.h"
#include "viewer/presets/preset_list_model.h"

namespace macula::viewer {
namespace {

class PresetRowsTest : public test::OffscreenTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        session_.emplace(*scene::builtInCatalogue());
        library_.emplace(*session_, nullptr);
        rows_.emplace(*session_, *library_);
        session_->show(smallStudy());
    }
    void TearDown() override {
        rows_.reset();
        library_.reset();
        session_.reset();
        OffscreenTest::TearDown();
    }
    std::size_t presetsIn(PresetGroup group) const {
        const auto rows = rows_->rows();
        return std::size_t(std::ranges::count_if(
            rows, [&](const PresetRow& row) { return row.group == group && row.preset; }));
    }

    std::optional<StudyEditor> session_;
    std::optional<PresetLibrary> library_;
    std::optional<PresetRows> rows_;
};

TEST_F(PresetRowsTest, OthersAreFoldedUntilAPersonLooks) {
    EXPECT_GT(presetsIn(PresetGroup::fitting), 0u);
    EXPECT_EQ(presetsIn(PresetGroup::others), 0u);
    EXPECT_TRUE(rows_->toggle(PresetGroup::others));
    EXPECT_TRUE(rows_->expanded().contains(PresetGroup::others));
    EXPECT_GT(presetsIn(PresetGroup::others), 0u);
    EXPECT_EQ(presetsIn(PresetGroup::fitting) + presetsIn(PresetGroup::others), library_->builtIn().size());
}

TEST_F(PresetRowsTest, AFilterShowsAllThatItFindsAndNothingIsFolded) {
    rows_->setFilter(QStringLiteral("bone"));
    EXPECT_FALSE(rows_->toggle(PresetGroup::fitting));
    EXPECT_EQ(rows_->expanded().size(), kPresetGroups.size());
    for (const PresetRow& row : rows_->rows()) {
        if (!row.preset) {
            EXPECT_GT(row.count, 0u) << "an empty group has no heading";
        }
    }
    EXPECT_GT(presetsIn(PresetGroup::fitting), 0u);
    rows_->setFilter(QStringLiteral("no preset has these words"));
    EXPECT_TRUE(rows_->rows().empty());
}

TEST_F(PresetRowsTest, AFavouriteIsInItsGroupBesides) {
    const live::PresetRef ref = library_->builtIn().front().ref;
    library_->setFavourite(ref, true);
    EXPECT_TRUE(rows_->favourites().contains(ref));
    EXPECT_EQ(presetsIn(PresetGroup::favourites), 1u);
    EXPECT_EQ(rows_->rows().front().group, PresetGroup::favourites);
}

}  // namespace
}  // namespace macula::viewer
