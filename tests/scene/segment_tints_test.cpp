// Colours of segments in 3D: voxels are gone through for another geometry alone.
#include "scene/segments/segment_tints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "base/phantom.h"
#include "study/segmentation/loaded_segmentation.h"

namespace macula::scene {
namespace {

const std::string kDigest(64, 'a');

// Segment n has the voxels n - 1 to n + 1 of a row, so that neighbours overlap.
class ColouredRow : public testing::Test {
  protected:
    void make(int segments) {
        volume_ = std::make_shared<const Volume>(phantom::make({.size = {segments + 2, 3, 3}}));
        auto loaded = std::make_shared<study::LoadedSegmentation>();
        loaded->digest = kDigest;
        choice_ = {};
        choice_.digest = kDigest;
        choice_.isShown = true;
        for (int n = 1; n <= segments; ++n) {
            VoxelSet voxels({n - 1, 1, 1}, {n + 1, 1, 1});
            for (int x = n - 1; x <= n + 1; ++x) voxels.add({x, 1, 1});
            study::LoadedSegment segment;
            segment.segment.number = std::uint16_t(n);
            segment.voxels = std::make_shared<const VoxelSet>(std::move(voxels));
            loaded->segments.push_back(std::move(segment));
            SegmentSettings one;
            one.number = std::uint16_t(n);
            one.isColouredIn3d = true;
            one.rgb = {200, 100, 50};
            choice_.segments.push_back(one);
        }
        loaded_ = {loaded};
    }
    PlannedTints planned() const {
        auto made = plannedTints(std::vector{choice_}, loaded_);
        EXPECT_TRUE(made) << made.error().message;
        return made ? *std::move(made) : PlannedTints{};
    }
    std::shared_ptr<const TintBox> box(const TintGeometry& geometry) const {
        Progress progress;
        auto made = tintBox(geometry, *volume_, progress);
        EXPECT_TRUE(made) << made.error().message;
        return made ? *made : nullptr;
    }
    // Of a voxel of the row; nothing where it has none.
    static std::optional<SegmentTints::Colour> colourAt(const SegmentTints& tints, int x) {
        const glm::ivec3 at = glm::ivec3(x, 1, 1) - tints.box->low;
        if (at.x < 0 || at.x >= tints.box->size.x) return std::nullopt;
        const std::uint8_t number = tints.box->voxels.at(std::size_t(at.x));
        if (number == 0) return std::nullopt;
        return tints.colours.at(std::size_t(number) - 1);
    }

    std::shared_ptr<const Volume> volume_;
    SegmentationSettings choice_;
    LoadedSegmentations loaded_;
};

TEST_F(ColouredRow, AnotherColourOrOpacityIsTheSameGeometryAndTheRightPicture) {
    make(3);
    const PlannedTints before = planned();
    const auto first = box(before.geometry);
    choice_.segments[0].opacityIn3d = 0.25;
    choice_.segments[1].rgb = {0, 255, 0};
    choice_.segments[2].opacityIn3d = 0.0;
    const PlannedTints after = planned();
    EXPECT_EQ(after.geometry, before.geometry);
    EXPECT_NE(after.colours, before.colours);
    const SegmentTints tints{first, after.colours};
    Progress progress;
    const auto anew = segmentTints(std::vector{choice_}, loaded_, *volume_, progress);
    ASSERT_TRUE(anew && *anew);
    for (int x = 0; x < volume_->size().x; ++x) {
        // Of voxels x the last segment that has it is x + 1, or the last one.
        const SegmentSettings& one = choice_.segments[std::size_t(std::min(x, 2))];
        const auto found = colourAt(tints, x);
        ASSERT_TRUE(found) << x;
        EXPECT_EQ(*found, *colourAt(**anew, x)) << x;
        EXPECT_FLOAT_EQ(found->opacity, float(one.opacityIn3d)) << x;
        EXPECT_FLOAT_EQ(found->rgb.g, float((*one.rgb)[1]) / 255.0f) << x;
    }
}

TEST_F(ColouredRow, FewerSegmentsAreAnotherGeometryAndNoneIsNone) {
    make(3);
    const TintGeometry all = planned().geometry;
    choice_.segments[1].isColouredIn3d = false;
    EXPECT_NE(planned().geometry, all);
    EXPECT_EQ(planned().geometry.parts.size(), 2u);
    choice_.isShown = false;
    EXPECT_TRUE(planned().geometry.parts.empty());
    EXPECT_TRUE(planned().colours.empty());
    choice_.isShown = true;
    loaded_.clear();
    EXPECT_TRUE(planned().geometry.parts.empty()) << "not there yet";
}

TEST_F(ColouredRow, AsManyAsColoursCanBeHaveOneEach) {
    make(int(SegmentTints::kMostColours));
    EXPECT_EQ(planned().colours.size(), SegmentTints::kMostColours) << "though all are of one colour";
    EXPECT_EQ(planned().geometry.parts.back().colour, 255);
    Additions added;
    added.tints = SegmentTints{box(planned().geometry), planned().colours};
    EXPECT_TRUE(validate(added, *volume_).ok());
}

// Of more segments than that those of one colour share it, and too many colours are an error.
TEST_F(ColouredRow, OfMoreThoseOfOneColourShareIt) {
    make(400);
    EXPECT_EQ(planned().colours.size(), 1u);
    for (int n = 0; n < 200; ++n) choice_.segments[std::size_t(n)].rgb = {0, 0, std::uint8_t(n)};
    const PlannedTints many = planned();
    EXPECT_EQ(many.colours.size(), 201u);
    const SegmentTints tints{box(many.geometry), many.colours};
    EXPECT_FLOAT_EQ(colourAt(tints, 57)->rgb.b, 57.0f / 255.0f);
    EXPECT_FLOAT_EQ(colourAt(tints, 300)->rgb.r, 200.0f / 255.0f);
    for (int n = 200; n < 400; ++n) choice_.segments[std::size_t(n)].rgb = {9, 0, std::uint8_t(n - 200)};
    const auto refused = plannedTints(std::vector{choice_}, loaded_);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::inputNotUsable);
    EXPECT_FALSE(refused.error().hint.empty());
}

TEST_F(ColouredRow, WhoCancelsGetsNoBox) {
    make(3);
    CancelToken token;
    token.cancel();
    Progress progress({}, token);
    const auto made = tintBox(planned().geometry, *volume_, progress);
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace macula::scene
