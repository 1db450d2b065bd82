// Own segments: stored, written and read again, they have the same voxels; nothing else is taken for one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "formats/volume_file.h"
#include "scene/segments/own_segments.h"
#include "scene/segments/own_segments_json.h"
#include "scene/segments/segment_recipe.h"
#include "scene/segments/segmentation_file.h"
#include "scene/segments/segments_to_file.h"
#include "study/open/opened_study.h"
#include "study/segmentation/loaded_segmentation.h"
#include "support.h"
#include "synthetic.h"

namespace macula::scene {
namespace {

VoxelSet someVoxels(const glm::ivec3& size, double share, unsigned seed) {
    std::mt19937 random(seed);
    VoxelSet set(glm::ivec3(0), size - 1);
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i)
                if (double(random() % 1000) < 1000.0 * share) set.add({i, j, k});
    return set;
}

OwnSegment ownOf(std::uint16_t number, std::string label, VoxelSet voxels) {
    OwnSegment own;
    own.segment.number = number;
    own.segment.label = std::move(label);
    own.segment.algorithm = "MANUAL";
    own.segment.recommendedRgb = {10, 200, 30};
    own.voxels = std::make_shared<const VoxelSet>(std::move(voxels));
    return own;
}

// An oblique series of 21 x 19 x 17 voxels.
class OwnSegments : public testing::Test {
  protected:
    void SetUp() override {
        series_.size = {21, 19, 17};
        dicom::test::writeFiles(folder_ / "ct", series_);
        Progress progress;
        auto study = study::openStudy(folder_.path(), progress);
        ASSERT_TRUE(study) << study.error().message;
        study_ = *std::move(study);
    }
    const Volume& volume() const { return *study_.volume; }
    std::vector<OwnSegment> drawn() const {
        return {ownOf(1, "Läsion <1>", someVoxels(volume().size(), 0.3, 1)),
                ownOf(3, "all", someVoxels(volume().size(), 1.0, 2)), ownOf(4, "none", VoxelSet()),
                ownOf(9, "one", [] {
                    VoxelSet set({20, 18, 16}, {20, 18, 16});
                    set.add({20, 18, 16});
                    return set;
                }())};
    }
    // A volume of numbers on the grid of the series.
    Volume labels(const std::function<float(std::size_t)>& value, double shiftMm = 0.0) const {
        glm::dmat4 world = volume().worldFromVoxel();
        world[3].x += shiftMm;
        std::vector<float> values;
        for (std::size_t n = 0; n < volume().voxelCount(); ++n) values.push_back(value(n));
        return *Volume::createFloat({.size = volume().size(), .worldFromVoxel = world}, std::move(values));
    }

    dicom::test::TemporaryFolder folder_;
    dicom::test::SyntheticSeries series_;
    study::OpenedStudy study_;
    Progress progress_;
};

TEST_F(OwnSegments, AreCountedAndStoredVoxelByVoxel) {
    const auto revision = ownRevision(drawn(), volume());
    EXPECT_EQ(revision->digest.size(), 64u);
    EXPECT_NE(revision->digest, ownRevision(drawn(), volume())->digest) << "each has its own";
    const double ml = std::abs(glm::determinant(glm::dmat3(volume().worldFromVoxel()))) / 1000.0;
    EXPECT_NEAR(*revision->segment(3)->volumeMl, 21 * 19 * 17 * ml, 1e-9);
    EXPECT_LT(glm::distance(*revision->segment(3)->centroidMm,
                            transformPoint(volume().worldFromVoxel(), {10, 9, 8})),
              1e-9);
    EXPECT_FALSE(revision->segment(4)->volumeMl);
    const auto json = toJson(*revision, volume());
    ASSERT_TRUE(json);
    const auto read = ownRevisionFromJson(*json, volume());
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ((*read)->digest, revision->digest);
    ASSERT_EQ((*read)->segments.size(), 4u);
    for (std::size_t n = 0; n < 4; ++n) {
        EXPECT_TRUE((*read)->segments[n].segment == revision->segments[n].segment);
        EXPECT_TRUE(*(*read)->segments[n].voxels == *revision->segments[n].voxels) << n;
    }
}

TEST_F(OwnSegments, WhatIsStoredIsNotTrusted) {
    const std::string good =
        *toJson(*ownRevision({ownOf(1, "a", someVoxels({5, 5, 5}, 0.5, 3))}, volume()), volume());
    ASSERT_TRUE(ownRevisionFromJson(good, volume()));
    const auto with = [&](const std::string& what, const std::string& instead) {
        std::string text = good;
        const auto at = text.find(what);
        EXPECT_NE(at, std::string::npos) << what;
        return text.replace(at, what.size(), instead);
    };
    for (const std::string& bad :
         {std::string(), std::string("{}"), std::string("[1]"), good.substr(0, good.size() / 2),
          with("\"size\":[21,", "\"size\":[22,"), with("\"high\":[", "\"high\":[9000,"),
          with("\"low\":[", "\"low\":[-1,"), with("\"number\":1", "\"number\":0"),
          with("\"runs\":\"", "\"runs\":\"/////////////////////w=="),
          with("\"runs\":\"", "\"runs\":\"gICAgICAgICAgICA"), with("\"digest\":\"", "\"digest\":\"../")})
        EXPECT_FALSE(ownRevisionFromJson(bad, volume())) << bad.substr(0, 80);
}

TEST_F(OwnSegments, AreTheSameAfterADicomFile) {
    const auto revision = ownRevision(drawn(), volume());
    SegmentationRequest request{
        .parts = {}, .volume = study_.volume, .found = study_.found, .volumeIndex = study_.volumeIndex};
    request.parts.push_back({revision, {}, {1, 3, 4, 9}});
    const auto notes = writeSegmentation(folder_ / "own.dcm", request);
    ASSERT_TRUE(notes) << notes.error().message;
    auto again = study::openStudy(folder_.path(), progress_);
    ASSERT_TRUE(again);
    const study::FoundVolume& of = again->found->volumes().at(again->volumeIndex);
    const auto found = study::findSegmentations(*again->found, of, progress_);
    ASSERT_TRUE(found && found->size() == 1 && found->front().canBeShown());
    const auto loaded = study::loadSegments(found->front(), *again->volume, *of.stack, progress_);
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_FALSE((*loaded)->isResampled);
    ASSERT_EQ((*loaded)->segments.size(), 3u) << "without the empty one";
    const std::vector<std::uint16_t> numbers{1, 3, 9};
    for (std::size_t n = 0; n < 3; ++n) {
        const study::LoadedSegment& was = *revision->segment(numbers[n]);
        const study::LoadedSegment& is = (*loaded)->segments[n];
        EXPECT_TRUE(*is.voxels == *was.voxels) << n;
        EXPECT_EQ(is.segment.label, was.segment.label);
        EXPECT_EQ(is.segment.algorithm, "MANUAL");
        EXPECT_EQ(is.segment.recommendedRgb, was.segment.recommendedRgb);
        EXPECT_NEAR(*is.volumeMl, *was.volumeMl, 1e-6);
    }
}

TEST_F(OwnSegments, AreTheSameAfterALabelMap) {
    const VoxelSet first = someVoxels(volume().size(), 0.3, 5);
    VoxelSet second(glm::ivec3(0), volume().size() - 1);
    someVoxels(volume().size(), 0.4, 6).forEach([&](const glm::ivec3& v) {
        if (!first.contains(v)) second.add(v);
    });
    const SegmentsToSave what{.segments = {ownOf(2, "a", first), ownOf(300, "b", second)},
                              .surfaceOf = {},
                              .volume = study_.volume};
    const auto path = folder_ / "own.nii.gz";
    const auto notes = saveSegments(path, what, progress_);
    ASSERT_TRUE(notes) << notes.error().message;
    const auto map = formats::readVolumeFile(path, progress_);
    ASSERT_TRUE(map);
    for (const glm::dvec3& corner : {glm::dvec3(0.0), glm::dvec3(20, 18, 16)})
        EXPECT_LT(glm::distance(transformPoint((*map)->worldFromVoxel(), corner),
                                transformPoint(volume().worldFromVoxel(), corner)),
                  1e-3);
    const auto read = segmentsOfLabels(**map, volume());
    ASSERT_TRUE(read) << read.error().message;
    ASSERT_EQ(read->size(), 2u);
    EXPECT_EQ((*read)[0].segment.number, 2);
    EXPECT_EQ((*read)[1].segment.number, 300);
    EXPECT_TRUE(*(*read)[0].voxels == first);
    EXPECT_TRUE(*(*read)[1].voxels == second);
}

TEST_F(OwnSegments, InALabelMapTheLastOneOfSeveralCountsAndThatIsSaid) {
    const auto flat = flattened(drawn(), volume());
    ASSERT_TRUE(flat);
    EXPECT_EQ(flat->overlapping, someVoxels(volume().size(), 0.3, 1).count() + 1);
    EXPECT_EQ(flat->map.label(0, 0, 0), 3);
    EXPECT_EQ(flat->map.label(20, 18, 16), 9);
    const SegmentsToSave none{.segments = {ownOf(1, "none", {})}, .surfaceOf = {}, .volume = study_.volume};
    EXPECT_EQ(saveSegments(folder_ / "a.nii", none, progress_).error().code, ErrorCode::usage);
    EXPECT_EQ(saveSegments(folder_ / "a.stl", none, progress_).error().code, ErrorCode::usage);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "a.stl"));
}

TEST_F(OwnSegments, OtherResultsThanLabelsOnThisGridAreRefused) {
    EXPECT_TRUE(segmentsOfLabels(labels([](std::size_t n) { return n == 7 ? 5.0f : 0.0f; }), volume()));
    const auto refused = [&](const Volume& map) {
        const auto read = segmentsOfLabels(map, volume());
        return !read && read.error().code == ErrorCode::inputNotUsable;
    };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(refused(labels([](std::size_t) { return 0.0f; }))) << "empty";
    EXPECT_TRUE(refused(labels([](std::size_t n) { return n == 7 ? 0.5f : 0.0f; })));
    EXPECT_TRUE(refused(labels([](std::size_t n) { return n == 7 ? -1.0f : 0.0f; })));
    EXPECT_TRUE(refused(labels([](std::size_t n) { return n == 7 ? 65536.0f : 0.0f; })));
    EXPECT_TRUE(refused(labels([=](std::size_t n) { return n == 7 ? nan : 1.0f; })));
    EXPECT_TRUE(refused(labels([](std::size_t n) { return float(n % 2000); }))) << "more than a thousand";
    EXPECT_TRUE(refused(labels([](std::size_t) { return 1.0f; }, 1.0))) << "elsewhere";
    const Volume other = *Volume::createFloat({.size = {2, 2, 2}}, std::vector<float>(8, 1.0f));
    EXPECT_TRUE(refused(other));
}

TEST_F(OwnSegments, ARecipeTakesItsStepsInOrder) {
    std::vector<float> values(1000, 0.0f);
    const auto at = [](int i, int j, int k) {
        return std::size_t(k) * 100 + std::size_t(j) * 10 + std::size_t(i);
    };
    for (int k = 1; k < 6; ++k)
        for (int j = 1; j < 6; ++j)
            for (int i = 1; i < 6; ++i) values[at(i, j, k)] = 100.0f;
    values[at(3, 3, 3)] = 0.0f;  // a hole
    values[at(8, 8, 8)] = 100.0f;
    const Volume cube = *Volume::createFloat({.size = {10, 10, 10}}, std::move(values));
    const auto count = [&](const SegmentRecipe& recipe) {
        const auto made = madeBy(recipe, cube, progress_);
        return made ? int(made->count()) : -1;
    };
    const ValueRange bright{50.0, 200.0};
    EXPECT_EQ(count({.threshold = bright}), 125);
    EXPECT_EQ(count({.threshold = bright, .largest = true}), 124);
    EXPECT_EQ(count({.threshold = bright, .fewestMl = 0.002, .fillsHoles = true}), 125);
    EXPECT_EQ(count({.threshold = bright, .growFromMm = glm::dvec3(8.0)}), 1);
    EXPECT_EQ(
        count({.threshold = bright, .growFromMm = glm::dvec3(2.0), .fillsHoles = true, .shrinkMm = 1.0}), 27);
    EXPECT_EQ(count({.growFromMm = glm::dvec3(9.0, 0.0, 0.0), .tolerance = 1.0}), 1000 - 125 - 1);
    EXPECT_EQ(count({}), -1);
    EXPECT_EQ(count({.growFromMm = glm::dvec3(2.0)}), -1) << "over which values?";
    EXPECT_EQ(count({.threshold = bright, .growFromMm = glm::dvec3(7.0)}), -1) << "not in the threshold";
    EXPECT_EQ(count({.threshold = bright, .growFromMm = glm::dvec3(70.0)}), -1);
}

}  // namespace
}  // namespace macula::scene
