// What is background in a label map object, and what a segment.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "dicom/messages/messages.h"
#include "dicom/read/tags.h"
#include "dicom/segmentation/segment_voxels.h"
#include "dicom/segmentation/segmentation.h"
#include "segmentation/drawing.h"
#include "support.h"

namespace macula::dicom::test {
namespace {

using Labels = std::vector<std::uint16_t>;

const glm::dmat4 kGrid = affine({0.25, 0, 0}, {0, 0.5, 0}, {0, 0, 2}, {10, 20, 30});

class LabelMapTest : public testing::Test {
  protected:
    Result<Segmentation> read(const Drawing& drawing) const {
        std::ofstream(folder_ / "seg", std::ios::binary) << bytesOfDrawing(drawing);
        return readSegmentation(folder_ / "seg");
    }
    // One row of voxels.
    Result<LabelMap> mapOf(const Drawing& drawing) const {
        MACULA_TRY(const Segmentation segmentation, read(drawing));
        Progress progress;
        return loadSegmentation(segmentation, kGrid, {drawing.columns, 1, 1}, progress);
    }

    TemporaryFolder folder_;
};

Labels labelsOf(const LabelMap& map) {
    return {map.labels().begin(), map.labels().end()};
}

Drawing labelMapOf(std::string pixels, int bits = 8) {
    const int columns = static_cast<int>(pixels.size()) * 8 / bits;
    return {.type = "LABELMAP",
            .sopClass = "1.2.840.10008.5.1.4.1.1.66.7",
            .columns = columns,
            .rows = 1,
            .bits = bits,
            .frames = {{{10, 20, 30}, 0}},
            .pixels = std::move(pixels)};
}

std::string paddedWith(int value) {
    return shortElement(tag::kPixelPaddingValue, "US", word(value));
}

std::vector<int> numbersOf(const Segmentation& segmentation) {
    std::vector<int> numbers;
    for (const Segment& segment : segmentation.segments) numbers.push_back(segment.number);
    return numbers;
}

// 0 is a segment like others where 255 is said to be none (PS3.3 C.8.20.2).
TEST_F(LabelMapTest, ALabelMapsBackgroundIsItsPadding) {
    Drawing d = labelMapOf(std::string("\xFF\x00\x01\xFF\x00\x00", 6));
    d.segments = {0, 1};
    d.labels = {{0, "Liver"}, {1, "Tumour"}};
    d.padding = paddedWith(255);
    const auto header = read(d);
    ASSERT_TRUE(header) << header.error().message;
    EXPECT_EQ(numbersOf(*header), (std::vector{0, 1}));
    Progress progress;
    const auto sets = loadSegmentVoxels(*header, kGrid, {6, 1, 1}, progress);
    ASSERT_TRUE(sets) << sets.error().message;
    ASSERT_EQ(sets->segments.size(), 2u) << "no segment 255";
    EXPECT_EQ(sets->segments[0].segment.number, 0);
    EXPECT_EQ(sets->segments[0].segment.label, "Liver");
    EXPECT_EQ(sets->segments[0].voxels.count(), 3u);
    EXPECT_EQ(sets->segments[1].voxels.count(), 1u);
    // A label map has no other value for none than 0.
    const auto map = mapOf(d);
    ASSERT_TRUE(map) << map.error().message;
    EXPECT_EQ(labelsOf(*map), (Labels{0, 256, 1, 0, 256, 256}));
    ASSERT_NE(map->segment(256), nullptr);
    EXPECT_EQ(map->segment(256)->label, "Liver");
    ASSERT_EQ(map->messages().size(), 1u);
    EXPECT_EQ(map->messages()[0].key, key::kSegmentZero);
    EXPECT_NE(map->messages()[0].sentence.english().find("256"), std::string::npos);
}

TEST_F(LabelMapTest, OtherBackgroundsOfLabelMaps) {
    const auto labels = [this](const Drawing& d) {
        const auto map = mapOf(d);
        EXPECT_TRUE(map) << (map ? "" : map.error().message.english());
        return map ? labelsOf(*map) : Labels{};
    };
    Drawing d = labelMapOf(std::string("\xFF\x00\x01\xFE\x02\x00", 6));
    d.padding = paddedWith(0);
    EXPECT_EQ(labels(d), (Labels{255, 0, 1, 254, 2, 0})) << "as where nothing is said";
    d.segments = {0, 1, 2};
    d.labels = {{0, "Background"}};
    EXPECT_EQ(labels(d), (Labels{255, 0, 1, 254, 2, 0})) << "it is described, as nothing";
    d.padding.clear();
    EXPECT_EQ(labels(d), (Labels{255, 0, 1, 254, 2, 0}));
    d.labels = {{0, "Fond"}};
    d.codedBackground = {0};
    EXPECT_EQ(labels(d), (Labels{255, 0, 1, 254, 2, 0}));
    d.codedBackground.clear();
    EXPECT_EQ(labels(d), (Labels{255, 256, 1, 254, 2, 256})) << "and a segment where nothing says so";
    d.segments = {1, 2};
    d.labels.clear();
    for (const auto& [value, limit] : {std::pair(254, 255), std::pair(255, 254)}) {
        d.padding = paddedWith(value) + shortElement(tag::kPixelPaddingRangeLimit, "US", word(limit));
        EXPECT_EQ(labels(d), (Labels{0, 0, 1, 0, 2, 0})) << value;
    }
    d.padding = shortElement(tag::kPixelPaddingValue, "SS", word(0xFFFF));
    EXPECT_EQ(labels(d), (Labels{0, 0, 1, 254, 2, 0})) << "-1 is the highest";
    d.padding = paddedWith(77);
    EXPECT_EQ(labels(d), (Labels{255, 0, 1, 254, 2, 0})) << "not in the pixels: 0 is still none";
}

TEST_F(LabelMapTest, ALabelMapOf16BitsHasASegment0Too) {
    Drawing d = labelMapOf(word(65535) + word(0) + word(1) + word(300), 16);
    d.segments = {0, 1, 65534};
    d.padding = paddedWith(65535);
    const auto map = mapOf(d);
    ASSERT_TRUE(map) << map.error().message;
    EXPECT_EQ(labelsOf(*map), (Labels{0, 65535, 1, 300}));
    EXPECT_EQ(map->segment(65535)->label, "label 0");
}

TEST_F(LabelMapTest, ASegmentUnderTheNumberOfThePaddingIsTold) {
    Drawing d = labelMapOf(std::string("\x01\x02\x00\x01", 4));
    d.padding = paddedWith(2);
    const auto header = read(d);
    ASSERT_TRUE(header) << header.error().message;
    EXPECT_EQ(header->paddedSegments, std::vector<std::uint16_t>{2});
    const auto map = mapOf(d);
    ASSERT_TRUE(map) << map.error().message;
    EXPECT_EQ(labelsOf(*map), (Labels{1, 0, 0, 1}));
    ASSERT_EQ(map->messages().size(), 1u);
    EXPECT_EQ(map->messages()[0].key, key::kSegmentIsPadding);
}

// A file of another writer, of 24 frames: numpy counts 379, 1099 and 72 cells of 0, 2 and 3, and 12058 of
// 255.
TEST(LabelMapOfAnotherWriter, HasItsSegment0) {
    const auto file = sharedData() / "failures/other/seg-labelmap-pad255/seg/s.dcm";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
    const auto header = readSegmentation(file);
    ASSERT_TRUE(header) << header.error().message;
    EXPECT_EQ(numbersOf(*header), (std::vector{0, 2, 3}));
    Progress progress;
    const auto map = loadSegmentation(*header, progress);
    ASSERT_TRUE(map) << map.error().message;
    const auto count = [&](std::uint16_t label) {
        return std::count(map->labels().begin(), map->labels().end(), label);
    };
    EXPECT_EQ(count(256), 379);
    EXPECT_EQ(count(2), 1099);
    EXPECT_EQ(count(3), 72);
    EXPECT_EQ(count(0), 12058);
    EXPECT_EQ(map->segments().size(), 3u);
}

}  // namespace
}  // namespace macula::dicom::test
