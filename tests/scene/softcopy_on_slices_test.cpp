// A presentation state of grey slices, on the slices of a volume: the place is that of the image's own
// geometry, the window only where the values are the same, and nothing is ever turned or mirrored.
#include "scene/presentation/softcopy_on_slices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "study/open/found_volumes.h"
#include "support.h"
#include "synthetic_softcopy.h"

namespace macula::scene {
namespace {

using dicom::test::SyntheticSeries;
using dicom::test::SyntheticSoftcopy;

class SoftcopyOnSlicesTest : public testing::Test {
  protected:
    void SetUp() override {
        slices_ = dicom::test::slicesOf(series_);
        dicom::test::writeFiles(folder_ / "images", series_, slices_);
        auto scanned = dicom::test::scan(folder_ / "images");
        ASSERT_TRUE(scanned);
        study_.found = std::make_shared<const study::FoundVolumes>(*std::move(scanned));
        ASSERT_EQ(study_.found->volumes().size(), 1u);
        study_.volume = dicom::test::load(*study_.found->volumes()[0].series);
        ASSERT_TRUE(study_.volume);
        said_.imageUids = {slices_[5].sopInstanceUid, slices_[2].sopInstanceUid};
    }

    // All slices in one file, whose frames are in their order.
    void useOneFileOfManyFrames() {
        dicom::test::writeMultiFrame(folder_ / "frames" / "all.dcm", series_, slices_);
        auto scanned = dicom::test::scan(folder_ / "frames");
        ASSERT_TRUE(scanned);
        study_.found = std::make_shared<const study::FoundVolumes>(*std::move(scanned));
        ASSERT_EQ(study_.found->volumes().size(), 1u);
        study_.volume = dicom::test::load(*study_.found->volumes()[0].series);
        ASSERT_TRUE(study_.volume);
        said_.imageUids = {dicom::test::MultiFrame().sopInstanceUid};
    }

    Result<SoftcopyOnSlices> opened(const SliceState& usual = {}) {
        dicom::test::writeSoftcopy(path_, said_);
        return openSoftcopy(path_, study_, usual);
    }
    SoftcopyOnSlices shown(const SliceState& usual = {}) {
        const auto state = opened(usual);
        EXPECT_TRUE(state.ok()) << (state ? Text() : state.error().message);
        return state ? *state : SoftcopyOnSlices{};
    }
    // Of the first image that is named.
    glm::dvec3 placeMm(double column, double row) const {
        const dicom::test::Slice& image = slices_[5];
        return image.positionMm + image.rowDirection * (column * image.columnSpacingMm) +
               image.columnDirection * (row * image.rowSpacingMm);
    }
    static bool tells(const SoftcopyOnSlices& shown, std::string_view words) {
        return std::ranges::any_of(
            shown.notes, [&](const Text& note) { return note.english().find(words) != std::string::npos; });
    }

    const dicom::test::TemporaryFolder folder_;
    const std::filesystem::path path_ = folder_ / "state.dcm";
    SyntheticSeries series_;
    std::vector<dicom::test::Slice> slices_;
    study::OpenedStudy study_;
    SyntheticSoftcopy said_;
};

TEST_F(SoftcopyOnSlicesTest, TheFirstImageItNamesIsShownThroughItsWindow) {
    for (const dicom::test::Slice& slice : slices_) {
        if (slice.sopInstanceUid != said_.imageUids[0] && slice.sopInstanceUid != said_.imageUids[1])
            said_.imageUids.push_back(slice.sopInstanceUid);
    }
    const SoftcopyOnSlices state = shown();
    ASSERT_TRUE(state.slices.window);
    EXPECT_EQ(state.slices.window->center, -600.0);
    EXPECT_EQ(state.slices.window->width, 1500.0);
    EXPECT_TRUE(state.slices.asAcquired);
    ASSERT_TRUE(state.slices.crosshairMm);
    const glm::dvec3 middle = placeMm(0.5 * (series_.size.x - 1), 0.5 * (series_.size.y - 1));
    EXPECT_LT(glm::length(*state.slices.crosshairMm - middle), 1e-3);
    EXPECT_FALSE(state.slices.isInverted);
    EXPECT_FALSE(state.area) << "all of the image is seen";
    EXPECT_TRUE(state.notes.empty()) << state.notes.front();
}

TEST_F(SoftcopyOnSlicesTest, OfSomeOfTheImagesItSaysSo) {
    EXPECT_TRUE(tells(shown(), "some of the images"));
}

TEST_F(SoftcopyOnSlicesTest, OfAFileOfManyFramesTheFirstThatItNamesIsShown) {
    ASSERT_NO_FATAL_FAILURE(useOneFileOfManyFrames());
    EXPECT_FALSE(tells(shown(), "some of the images")) << "without numbers it is of all frames";
    said_.frames = "6\\3";  // from 1: those of slices_[5] and slices_[2]
    const SoftcopyOnSlices state = shown();
    ASSERT_TRUE(state.slices.crosshairMm);
    const glm::dvec3 middle = placeMm(0.5 * (series_.size.x - 1), 0.5 * (series_.size.y - 1));
    EXPECT_LT(glm::length(*state.slices.crosshairMm - middle), 1e-3);
    EXPECT_TRUE(state.slices.window);
    EXPECT_TRUE(tells(state, "some of the images"));
    said_.frames = std::to_string(slices_.size() + 1);
    const auto beyond = opened();
    ASSERT_FALSE(beyond.ok());
    EXPECT_NE(beyond.error().message.english().find("other images"), std::string::npos);
}

TEST_F(SoftcopyOnSlicesTest, ASizeOnTheScreenThatIsNotShownIsTold) {
    said_.area = {2, 3, 5, 4};
    EXPECT_FALSE(tells(shown(), "fit their pane"));
    said_.sizeMode = "TRUE SIZE";
    EXPECT_TRUE(tells(shown(), "true size"));
    EXPECT_TRUE(shown().area) << "what is to be seen is seen";
    said_.sizeMode = "MAGNIFY";
    said_.area = {1, 1, series_.size.x, series_.size.y};
    EXPECT_TRUE(tells(shown(), "magnification"));
}

TEST_F(SoftcopyOnSlicesTest, APartOfTheImageIsWhereItLiesInThePatient) {
    said_.area = {2, 3, 5, 4};  // 4 columns, 2 rows
    const SoftcopyOnSlices state = shown();
    ASSERT_TRUE(state.area);
    EXPECT_LT(glm::length(state.area->centreMm - placeMm(2.5, 2.5)), 1e-3);
    EXPECT_EQ(state.area->orientation, slices::acquiredOrientation(*study_.volume));
    // The axes of the pane are those of the image, turned by quarters.
    const double columnsMm = 4 * slices_[5].columnSpacingMm;
    const double rowsMm = 2 * slices_[5].rowSpacingMm;
    EXPECT_NEAR(std::max(state.area->sizeMm.x, state.area->sizeMm.y), std::max(columnsMm, rowsMm), 1e-3);
    EXPECT_NEAR(std::min(state.area->sizeMm.x, state.area->sizeMm.y), std::min(columnsMm, rowsMm), 1e-3);
}

TEST_F(SoftcopyOnSlicesTest, AnAreaOfAllOfTheImageIsNone) {
    said_.area = {1, 1, series_.size.x, series_.size.y};
    EXPECT_FALSE(shown().area);
    said_.area = {-40, -3, series_.size.x + 9, series_.size.y + 2};
    EXPECT_FALSE(shown().area);
}

TEST_F(SoftcopyOnSlicesTest, AnAreaBesideTheVolumeIsLeftOutAndTold) {
    said_.area = {9000, 9000, 9100, 9100};
    const SoftcopyOnSlices state = shown();
    EXPECT_FALSE(state.area);
    EXPECT_TRUE(tells(state, "beside the volume"));
}

TEST_F(SoftcopyOnSlicesTest, WhatIsTurnedOrMirroredLosesItsPlaceAndSaysSo) {
    said_.area = {2, 3, 5, 4};
    for (const bool isFlipped : {true, false}) {
        said_.isFlipped = isFlipped;
        said_.rotationDeg = isFlipped ? 0 : 270;
        const SoftcopyOnSlices state = shown();
        EXPECT_FALSE(state.area);
        EXPECT_TRUE(tells(state, "never do"));
        EXPECT_TRUE(state.slices.window) << "a window knows no direction";
    }
}

TEST_F(SoftcopyOnSlicesTest, AWindowOfOtherValuesIsNotShown) {
    const DisplayWindow usual{.center = 40.0, .width = 400.0, .explanation = {}, .function = {}};
    for (const auto& rescale : {std::optional(std::pair(1.0, 0.0)), std::optional(std::pair(2.0, -1024.0)),
                                std::optional<std::pair<double, double>>()}) {
        said_.rescale = rescale;
        const SoftcopyOnSlices state = shown({.window = usual});
        EXPECT_EQ(state.slices.window, usual);
        EXPECT_TRUE(tells(state, "other values"));
    }
}

TEST_F(SoftcopyOnSlicesTest, ItsGreysTakeThePlaceOfThoseOfTheImages) {
    said_.isInverse = true;
    EXPECT_TRUE(shown().slices.isInverted);
    study_.isLowBright = true;  // slices begin with low values white
    EXPECT_FALSE(shown().slices.isInverted);
    said_.isInverse = false;
    EXPECT_TRUE(shown().slices.isInverted);
}

TEST_F(SoftcopyOnSlicesTest, WhatElseIsChosenStays) {
    said_.window.reset();
    SliceState usual;
    usual.window = DisplayWindow{.center = 1.0, .width = 2.0, .explanation = {}, .function = {}};
    usual.slab.thicknessMm = 7.0;
    const SoftcopyOnSlices state = shown(usual);
    EXPECT_EQ(state.slices.window, usual.window);
    EXPECT_EQ(state.slices.slab, usual.slab);
}

TEST_F(SoftcopyOnSlicesTest, OfOtherImagesItIsAnError) {
    said_.imageUids = {"2.25.99"};
    const auto state = opened();
    ASSERT_FALSE(state.ok());
    EXPECT_EQ(state.error().code, ErrorCode::inputNotUsable);
    EXPECT_NE(state.error().message.english().find("other images"), std::string::npos);
    const auto ofNothing = openSoftcopy(path_, {}, {});
    ASSERT_FALSE(ofNothing.ok());
    EXPECT_EQ(ofNothing.error().code, ErrorCode::usage);
}

}  // namespace
}  // namespace macula::scene
