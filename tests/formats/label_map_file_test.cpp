// Label maps as other programs write them: of numbers alone, and of 3D Slicer with names, colours and layers.
#include "formats/label_map_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "import_support.h"

namespace macula::formats::test {
namespace {

namespace fs = std::filesystem;

constexpr int kVoxels = 3 * 4 * 5;

// Two layers that alternate voxel by voxel: the liver and a tumour in it overlap.
std::string slicerHeader(const std::string& segments, int layers) {
    return "NRRD0004\ntype: unsigned char\ndimension: 4\nspace: left-posterior-superior\n"
           "sizes: " +
           std::to_string(layers) +
           " 3 4 5\nspace directions: none (1,0,0) (0,2,0) (0,0,3)\nkinds: list domain domain domain\n"
           "encoding: raw\nspace origin: (10,20,30)\n" +
           segments + "\n";
}

const std::string kLiverAndTumour =
    "Segment0_ID:=Segment_1\nSegment0_Name:=Liver\nSegment0_Color:=0.5 0 1\nSegment0_LabelValue:=1\n"
    "Segment0_Layer:=0\n"
    "Segment1_ID:=Segment_2\nSegment1_Name:=Tumour\nSegment1_Color:=2 nan 0\nSegment1_LabelValue:=1\n"
    "Segment1_Layer:=1\n";

std::string layersOf(int layers, const std::function<int(int voxel, int layer)>& valueAt) {
    std::string bytes;
    for (int voxel = 0; voxel < kVoxels; ++voxel)
        for (int layer = 0; layer < layers; ++layer) bytes += char(valueAt(voxel, layer));
    return bytes;
}

class LabelMaps : public Import {
  protected:
    LabelMapFile read(const fs::path& path) {
        auto file = readLabelMapFile(path, progress_);
        if (!file) {
            ADD_FAILURE() << file.error().message;
            return {};
        }
        return *std::move(file);
    }
    std::string refusedLabels(const fs::path& path) {
        const auto file = readLabelMapFile(path, progress_);
        if (file) return "accepted";
        EXPECT_EQ(file.error().code, ErrorCode::inputNotUsable);
        EXPECT_FALSE(file.error().hint.empty());
        EXPECT_EQ(file.error().where, path.string());
        return file.error().message.english();
    }
    // A NIfTI file of floats that are all 0 but for one.
    std::string refusedValue(float value) {
        NiftiBytes file = makeNifti(16, 4);
        file.set(352 + 4 * 7, value);
        return refusedLabels(write("labels.nii", file.bytes));
    }

    Progress progress_;
};

TEST_F(LabelMaps, SegmentsOfSlicerHaveNamesAndColoursAndOverlap) {
    const auto inLiver = [](int voxel) { return voxel < 30; };
    const auto inTumour = [](int voxel) { return voxel >= 20 && voxel < 33; };
    const LabelMapFile file =
        read(write("a.seg.nrrd", slicerHeader(kLiverAndTumour, 2) + layersOf(2, [&](int voxel, int layer) {
                                     return layer == 0 ? inLiver(voxel) : inTumour(voxel);
                                 })));
    ASSERT_EQ(file.segments.size(), 2u);
    EXPECT_TRUE(file.hasNames);
    EXPECT_EQ(file.size, glm::ivec3(3, 4, 5));
    EXPECT_EQ(transformPoint(file.worldFromVoxel, {1, 1, 1}), glm::dvec3(11, 22, 33));
    EXPECT_EQ(file.segments[0].segment.label, "Liver");
    EXPECT_EQ(file.segments[0].segment.recommendedRgb, (std::array<std::uint8_t, 3>{128, 0, 255}));
    EXPECT_EQ(file.segments[1].segment.label, "Tumour");
    EXPECT_FALSE(file.segments[1].segment.recommendedRgb) << "which is no colour";
    EXPECT_EQ(file.segments[0].segment.number, 1);
    EXPECT_EQ(file.segments[1].segment.number, 2) << "both have the value 1, each in its layer";
    for (int voxel = 0; voxel < kVoxels; ++voxel) {
        const glm::ivec3 at(voxel % 3, voxel / 3 % 4, voxel / 12);
        EXPECT_EQ(file.segments[0].voxels.contains(at), inLiver(voxel)) << voxel;
        EXPECT_EQ(file.segments[1].voxels.contains(at), inTumour(voxel)) << voxel;
    }
}

// Of before 2020: a layer for each segment, and no label values.
TEST_F(LabelMaps, OldSegmentationsOfSlicerHaveALayerForEachSegment) {
    const LabelMapFile file =
        read(write("old.seg.nrrd", slicerHeader("Segment0_ID:=a\nSegment0_Name:=Left\nSegment1_ID:=b\n", 2) +
                                       layersOf(2, [](int voxel, int layer) { return voxel % 2 == layer; })));
    ASSERT_EQ(file.segments.size(), 2u);
    EXPECT_EQ(file.segments[0].segment.label, "Left");
    EXPECT_EQ(file.segments[1].segment.label, "Label 2") << "it has no name";
    EXPECT_EQ(file.segments[0].voxels.count(), 30u);
    EXPECT_EQ(file.segments[1].voxels.count(), 30u);
    EXPECT_FALSE(file.segments[1].voxels.contains({0, 0, 0}));
}

// What the header does not describe is shown all the same, and what it describes and nobody drew is listed.
TEST_F(LabelMaps, ValuesWithoutADescriptionAreSegmentsToo) {
    const LabelMapFile file = read(
        write("b.seg.nrrd",
              slicerHeader("Segment0_ID:=a\nSegment0_Name:=Liver\nSegment0_LabelValue:=4\nSegment1_ID:=b\n"
                           "Segment1_Name:=Nothing\nSegment1_LabelValue:=9\n",
                           1) +
                  layersOf(1, [](int voxel, int) { return voxel == 3   ? 4
                                                          : voxel == 5 ? 6
                                                                       : 0; })));
    ASSERT_EQ(file.segments.size(), 3u);
    EXPECT_EQ(file.segments[0].segment.number, 4);
    EXPECT_EQ(file.segments[1].segment.label, "Label 6");
    EXPECT_EQ(file.segments[2].segment.label, "Nothing");
    EXPECT_TRUE(file.segments[2].voxels.isEmpty());
}

TEST_F(LabelMaps, NumbersAloneAreLabels) {
    NiftiBytes bytes = makeNifti(512, 2);  // 16 bits without a sign
    bytes.set<std::uint16_t>(352, 65535);
    bytes.set<std::uint16_t>(352 + 2 * 13, 7);  // (1, 0, 1)
    for (const fs::path& path : {write("a.nii", bytes.bytes), write("a.nii.gz", gzipped(bytes.bytes))}) {
        const LabelMapFile file = read(path);
        ASSERT_EQ(file.segments.size(), 2u);
        EXPECT_FALSE(file.hasNames);
        EXPECT_EQ(file.segments[0].segment.label, "Label 7");
        EXPECT_TRUE(file.segments[0].voxels.contains({1, 0, 1}));
        EXPECT_EQ(file.segments[0].voxels.count(), 1u);
        EXPECT_EQ(file.segments[1].segment.number, 65535);
    }
    NiftiBytes floats = makeNifti(16, 4);  // whole numbers as floating point
    floats.set(352, 3.0f);
    EXPECT_EQ(read(write("f.nii", floats.bytes)).segments.at(0).segment.number, 3);
}

TEST_F(LabelMaps, OtherImagesAreRefused) {
    EXPECT_SAYS(refusedValue(0.5f), "no numbers of segments");
    EXPECT_SAYS(refusedValue(-1.0f), "no numbers of segments");
    EXPECT_SAYS(refusedValue(65536.0f), "no numbers of segments");
    EXPECT_SAYS(refusedValue(std::nanf("")), "no numbers of segments");
    EXPECT_SAYS(refusedValue(INFINITY), "no numbers of segments");
    EXPECT_SAYS(refusedValue(0.0f), "no segment");
    NiftiBytes times = makeNifti(4, 2);
    times.set<std::int16_t>(40, 4);
    times.set<std::int16_t>(48, 3);
    times.bytes.resize(352 + 3 * kVoxels * 2);
    EXPECT_SAYS(refusedLabels(write("t.nii", times.bytes)), "3 volumes");
    // 2000 numbers in 20 x 10 x 10 voxels.
    NiftiBytes many = makeNifti(512, 2);
    for (const auto& [offset, length] : {std::pair(42, 20), {44, 10}, {46, 10}})
        many.set<std::int16_t>(std::size_t(offset), std::int16_t(length));
    many.bytes.resize(352 + 2 * 2000);
    for (std::size_t n = 0; n < 2000; ++n) many.set<std::uint16_t>(352 + 2 * n, std::uint16_t(n));
    EXPECT_SAYS(refusedLabels(write("m.nii", many.bytes)), "more than 1000 segments");
    EXPECT_SAYS(refusedLabels(write("cut.seg.nrrd", slicerHeader(kLiverAndTumour, 2) + "abc")), "cut off");
    // Without the segments of Slicer, an axis of a list is no layers.
    EXPECT_SAYS(refusedLabels(write("list.nrrd", slicerHeader("", 2) + std::string(2 * kVoxels, '\1'))),
                "2 volumes");
}

TEST_F(LabelMaps, LayersThatAreNotThereAreEmpty) {
    const std::string far =
        "Segment0_ID:=a\nSegment0_LabelValue:=1\nSegment0_Layer:=18446744073709551615\nSegment1_ID:=b\n"
        "Segment1_LabelValue:=99999999\nSegment1_Layer:=0\n";
    const LabelMapFile file = read(write("far.seg.nrrd", slicerHeader(far, 1) + std::string(kVoxels, '\1')));
    ASSERT_EQ(file.segments.size(), 2u);
    EXPECT_EQ(file.segments[0].voxels.count() + file.segments[1].voxels.count(), std::size_t(kVoxels));
}

TEST(LabelMapNames, OfSlicer) {
    EXPECT_TRUE(isSegmentationName("/a/Segmentation.seg.nrrd"));
    EXPECT_TRUE(isSegmentationName("A.SEG.NRRD"));
    EXPECT_FALSE(isSegmentationName("a.nrrd"));
    EXPECT_FALSE(isSegmentationName("seg.nrrd"));
}

// Counts of ../shared/data/planar/truth/7_segmentations.json, made without this code.
TEST(SharedLabelMaps, HaveTheVoxelsOfTheTruth) {
    SKIP_WITHOUT_SHARED_DATA();
    const fs::path folder = dicom::test::sharedData() / "planar/7_segmentations";
    const std::vector<std::pair<std::string, std::vector<std::pair<int, std::size_t>>>> files{
        {"dcmqi_ct_liver/liver_seg.nrrd", {{1, 107098}}},
        {"dcmqi_ct_liver/partial_overlaps-1.nrrd", {{1, 9602}, {4, 6693}, {5, 4713}}},
        {"dcmqi_labelmap/labelmap.nrrd", {{1, 630}}},
        {"made_surface_sts008/labelmap.nii.gz", {{1, 4679}, {2, 4183}}}};
    for (const auto& [name, counts] : files) {
        if (!fs::exists(folder / name)) continue;
        Progress progress;
        const auto file = readLabelMapFile(folder / name, progress);
        ASSERT_TRUE(file) << name << ": " << file.error().message;
        ASSERT_EQ(file->segments.size(), counts.size()) << name;
        for (std::size_t n = 0; n < counts.size(); ++n) {
            EXPECT_EQ(file->segments[n].segment.number, counts[n].first) << name;
            EXPECT_EQ(file->segments[n].voxels.count(), counts[n].second) << name;
        }
    }
}

}  // namespace
}  // namespace macula::formats::test
