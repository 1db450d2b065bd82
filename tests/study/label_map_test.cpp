// Label maps of other programs as segmentations of an open volume: where they lie, and what is said of it.
#include "study/segmentation/label_map.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "formats/volume_file.h"
#include "study/open/opened_study.h"
#include "support.h"

namespace macula::study {
namespace {

namespace fs = std::filesystem;

// Oblique, anisotropic.
glm::dmat4 placed() {
    const double s = std::sin(0.3);
    const double c = std::cos(0.3);
    return affine(glm::dvec3(c, s, 0.0) * 0.8, glm::dvec3(-s, c, 0.0) * 0.9, {0.0, 0.0, 2.5}, {12, -30, 77});
}

Volume volumeOf(const glm::ivec3& size, const glm::dmat4& worldFromVoxel) {
    return *Volume::create({.size = size, .worldFromVoxel = worldFromVoxel},
                           std::vector<std::uint16_t>(std::size_t(size.x * size.y * size.z), 7));
}

class LabelMapOnAVolume : public testing::Test {
  protected:
    // Segment 3 is where `isIn` says so, in mm.
    fs::path write(const char* name, const glm::ivec3& size, const glm::dmat4& worldFromVoxel) {
        std::vector<std::uint16_t> labels;
        for (int k = 0; k < size.z; ++k)
            for (int j = 0; j < size.y; ++j)
                for (int i = 0; i < size.x; ++i)
                    labels.push_back(isIn(transformPoint(worldFromVoxel, {i, j, k})) ? 3 : 0);
        const auto map = LabelMap::create(size, worldFromVoxel, {}, std::move(labels));
        EXPECT_TRUE(map);
        EXPECT_TRUE(formats::writeVolumeFile(*map, folder_ / name, progress_));
        return folder_ / name;
    }
    bool isIn(const glm::dvec3& mm) const { return glm::distance(mm, middleMm_) < 4.3; }
    bool says(const OpenedLabelMap& opened, const std::string& words) const {
        return std::ranges::any_of(opened.loaded->notes, [&](const Text& note) {
            return note.english().find(words) != std::string::npos;
        });
    }
    void expectVoxels(const OpenedLabelMap& opened) {
        const VoxelSet& voxels = *opened.loaded->segments.at(0).voxels;
        for (int k = 0; k < kSize.z; ++k)
            for (int j = 0; j < kSize.y; ++j)
                for (int i = 0; i < kSize.x; ++i)
                    ASSERT_EQ(voxels.contains({i, j, k}), isIn(transformPoint(placed(), {i, j, k})))
                        << i << " " << j << " " << k;
    }

    static constexpr glm::ivec3 kSize{14, 12, 8};
    dicom::test::TemporaryFolder folder_;
    Progress progress_;
    Volume volume_ = volumeOf(kSize, placed());
    glm::dvec3 middleMm_ = transformPoint(placed(), {6, 5, 4});
};

TEST_F(LabelMapOnAVolume, OfItsVoxelsIsTakenAsItIs) {
    for (const char* name : {"a.nii.gz", "a.nrrd", "a.mha"}) {
        const auto opened = openLabelMap(write(name, kSize, placed()), volume_, progress_);
        ASSERT_TRUE(opened) << opened.error().message;
        expectVoxels(*opened);
        EXPECT_FALSE(opened->loaded->isResampled);
        EXPECT_TRUE(says(*opened, "no frame of reference"));
        EXPECT_TRUE(says(*opened, "not their names"));
        EXPECT_EQ(opened->found.title, name);
        EXPECT_TRUE(opened->found.canBeShown());
        EXPECT_EQ(opened->found.digest, opened->loaded->digest);
        ASSERT_EQ(opened->found.header.segments.size(), 1u);
        EXPECT_EQ(opened->found.header.segments[0].number, 3);
        const LoadedSegment& segment = opened->loaded->segments[0];
        EXPECT_NEAR(*segment.volumeMl, double(segment.voxels->count()) * 0.8 * 0.9 * 2.5 / 1000.0, 1e-6);
        EXPECT_LT(glm::distance(*segment.centroidMm, middleMm_), 1e-3);
    }
}

// Rows from the other side, slices from the other end, columns for rows: still the same voxels.
TEST_F(LabelMapOnAVolume, StoredInAnotherOrderIsTheSame) {
    const glm::dmat4 p = placed();
    const glm::dvec3 corner = transformPoint(p, {0, kSize.y - 1, kSize.z - 1});
    const glm::dmat4 turned = affine(-glm::dvec3(p[1]), glm::dvec3(p[0]), -glm::dvec3(p[2]), corner);
    const auto opened =
        openLabelMap(write("b.nrrd", {kSize.y, kSize.x, kSize.z}, turned), volume_, progress_);
    ASSERT_TRUE(opened) << opened.error().message;
    expectVoxels(*opened);
    EXPECT_FALSE(opened->loaded->isResampled);
    EXPECT_EQ(guessLabelMap(folder_ / "b.nrrd", volume_), LabelMapGuess::maybe);
}

TEST_F(LabelMapOnAVolume, OnOtherVoxelsTakesTheNearestAndSaysSo) {
    glm::dmat4 shifted = placed();
    shifted[3] += glm::dvec4(0.02, 0.0, 0.0, 0.0);  // more than a hundredth of a mm
    const auto opened = openLabelMap(write("c.nrrd", kSize, shifted), volume_, progress_);
    ASSERT_TRUE(opened);
    EXPECT_TRUE(opened->loaded->isResampled);
    EXPECT_TRUE(says(*opened, "nearest voxel"));
    shifted[3] = placed()[3] + glm::dvec4(0.005, 0.0, 0.0, 0.0);
    EXPECT_FALSE(openLabelMap(write("d.nrrd", kSize, shifted), volume_, progress_)->loaded->isResampled);
    // Of half the voxels: each of the volume takes the one that its centre lies in.
    const glm::dmat4 coarse = placed() * affine({2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {0.5, 0.5, 0.5});
    const auto half = openLabelMap(write("e.nrrd", kSize / 2, coarse), volume_, progress_);
    ASSERT_TRUE(half);
    EXPECT_TRUE(half->loaded->isResampled);
    for (const glm::ivec3 voxel : {glm::ivec3(6, 5, 4), glm::ivec3(7, 4, 4), glm::ivec3(0, 0, 0)})
        EXPECT_EQ(half->loaded->segments[0].voxels->contains(voxel),
                  isIn(transformPoint(coarse, glm::dvec3(voxel / 2))));
    EXPECT_EQ(guessLabelMap(folder_ / "e.nrrd", volume_), LabelMapGuess::no);
}

TEST_F(LabelMapOnAVolume, ElsewhereIsRefused) {
    glm::dmat4 away = placed();
    away[3] += glm::dvec4(500.0, 0.0, 0.0, 0.0);
    middleMm_.x += 500.0;
    const fs::path path = write("away.nrrd", kSize, away);
    const auto opened = openLabelMap(path, volume_, progress_);
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().code, ErrorCode::inputNotUsable);
    EXPECT_EQ(opened.error().where, path.string());
    EXPECT_FALSE(openLabelMap(folder_ / "none.nrrd", volume_, progress_));
    EXPECT_EQ(guessLabelMap(folder_ / "none.nrrd", volume_), LabelMapGuess::no);
    EXPECT_EQ(guessLabelMap(folder_ / "a.dcm", volume_), LabelMapGuess::no);
    EXPECT_EQ(guessLabelMap(folder_ / "x.seg.nrrd", volume_), LabelMapGuess::yes);
}

TEST_F(LabelMapOnAVolume, StopsWhenItIsCancelled) {
    const CancelToken token;
    token.cancel();
    Progress progress([](const ProgressUpdate&) {}, token);
    const auto opened = openLabelMap(write("a.nrrd", kSize, placed()), volume_, progress);
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().code, ErrorCode::cancelled);
}

// The CT of a sarcoma and its label map, made with nibabel: on the same voxels, in an order of their own.
TEST(SharedLabelMap, LiesOnItsCt) {
    SKIP_WITHOUT_SHARED_DATA();
    const fs::path data = dicom::test::sharedData() / "planar";
    const fs::path labels = data / "7_segmentations/made_surface_sts008/labelmap.nii.gz";
    if (!fs::exists(labels)) GTEST_SKIP() << "not here: " << labels;
    Progress progress;
    const auto study = openStudy(data / "3_radiotherapy/rt_sarcoma_sts008", progress);
    ASSERT_TRUE(study) << study.error().message;
    const auto opened = openLabelMap(labels, *study->volume, progress);
    ASSERT_TRUE(opened) << opened.error().message;
    EXPECT_FALSE(opened->loaded->isResampled);
    ASSERT_EQ(opened->loaded->segments.size(), 2u);
    EXPECT_EQ(opened->loaded->segments[0].voxels->count(), 4679u);
    EXPECT_EQ(opened->loaded->segments[1].voxels->count(), 4183u);
    EXPECT_NEAR(*opened->loaded->segments[0].volumeMl, 14.59152, 1e-4);
    EXPECT_NEAR(*opened->loaded->segments[1].volumeMl, 13.04474, 1e-4);
}

}  // namespace
}  // namespace macula::study
