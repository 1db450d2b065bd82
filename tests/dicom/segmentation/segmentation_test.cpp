// Segmentations land on the voxels they were drawn on, or are refused.
#include "dicom/segmentation/segmentation.h"
#include "toolkit/quiet_toolkit.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcrleerg.h>
#include <dcmtk/dcmdata/dctk.h>

#include <fstream>

#include "bytes.h"
#include "dicom/messages/messages.h"
#include "dicom/read/dataset.h"
#include "dicom/segmentation/segmentation_grid.h"
#include "segmentation/drawing.h"
#include "support.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;

// Pixels of 1 bit, one after the other, least significant first; no frame begins at a byte of its own.
std::string packed(const std::vector<int>& bits) {
    std::string bytes((bits.size() + 7) / 8, '\0');
    for (std::size_t i = 0; i < bits.size(); ++i) {
        if (bits[i]) bytes[i / 8] = static_cast<char>(bytes[i / 8] | 1 << (i % 8));
    }
    if (bytes.size() % 2) bytes += '\0';
    return bytes;
}

// All zero but the pixels (frame, column, row).
std::string dots(const Drawing& d, const std::vector<glm::ivec3>& where) {
    std::vector<int> bits(d.frames.size() * static_cast<std::size_t>(d.columns * d.rows));
    for (const glm::ivec3& p : where)
        bits[static_cast<std::size_t>((p.x * d.rows + p.z) * d.columns + p.y)] = 1;
    return packed(bits);
}

class SegmentationTest : public testing::Test {
  protected:
    fs::path write(const Drawing& d) {
        std::ofstream(folder / "seg", std::ios::binary) << bytesOfDrawing(d);
        return folder / "seg";
    }
    Result<LabelMap> on(const Drawing& d, const glm::dmat4& worldFromVoxel, glm::ivec3 size) {
        const auto segmentation = readSegmentation(write(d));
        if (!segmentation) return segmentation.error();
        Progress progress;
        return loadSegmentation(*segmentation, worldFromVoxel, size, progress);
    }
    Result<LabelMap> alone(const Drawing& d) {
        const auto segmentation = readSegmentation(write(d));
        if (!segmentation) return segmentation.error();
        Progress progress;
        return loadSegmentation(*segmentation, progress);
    }

    TemporaryFolder folder;
};

using Labels = std::vector<std::uint16_t>;

Labels labelsOf(const LabelMap& map) {
    return {map.labels().begin(), map.labels().end()};
}

std::size_t countOf(const LabelMap& map, std::uint16_t label) {
    return static_cast<std::size_t>(std::count(map.labels().begin(), map.labels().end(), label));
}

// Columns 0.25 mm, rows 0.5 mm, slices 2 mm apart.
const glm::dmat4 kGrid = affine({0.25, 0, 0}, {0, 0.5, 0}, {0, 0, 2}, {10, 20, 30});

Drawing twoSlices() {
    Drawing d{.frames = {{{10, 20, 30}, 1}, {{10, 20, 32}, 1}, {{10, 20, 32}, 2}}};
    d.pixels = dots(d, {{0, 0, 0}, {0, 4, 2}, {1, 1, 1}, {2, 3, 0}, {2, 4, 2}});
    return d;
}

TEST_F(SegmentationTest, BinaryFramesThatDoNotBeginAtAByte) {
    const auto map = on(twoSlices(), kGrid, {5, 3, 2});
    ASSERT_TRUE(map) << map.error().message;
    Labels expected(30);
    expected[0] = 1;
    expected[14] = 1;
    expected[15 + 5 + 1] = 1;
    expected[15 + 3] = 2;
    expected[15 + 14] = 2;
    EXPECT_EQ(labelsOf(*map), expected);
    EXPECT_TRUE(map->messages().empty());
    ASSERT_EQ(map->segments().size(), 2u);
    EXPECT_EQ(map->segments()[1], (Segment{.number = 2, .label = "label 2", .algorithm = "MANUAL"}));
    const auto own = alone(twoSlices());
    ASSERT_TRUE(own);
    EXPECT_EQ(labelsOf(*own), expected);
    EXPECT_LT(affineError(own->worldFromVoxel(), kGrid), 1e-9);
}

// The loader takes slices up to a tenth of their distance off for even (geometry.h), and what was drawn on
// them lies where they lie.
TEST_F(SegmentationTest, OnSlicesThatAreNotQuiteEven) {
    const std::vector<glm::dvec3> positionsMm{{10, 20, 30}, {10, 20, 32.18}, {10, 20, 34}};
    Drawing d = twoSlices();
    d.frames = {{{10, 20, 30}, 1}, {{10, 20, 32.18}, 1}, {{10, 20, 32.18}, 2}};
    EXPECT_FALSE(on(d, kGrid, {5, 3, 3}));
    const auto segmentation = readSegmentation(write(d));
    ASSERT_TRUE(segmentation);
    Progress progress;
    const auto map = loadSegmentation(*segmentation, kGrid, {5, 3, 3}, progress, positionsMm);
    ASSERT_TRUE(map) << map.error().message;
    Labels expected(45);
    expected[0] = 1;
    expected[14] = 1;
    expected[15 + 5 + 1] = 1;
    expected[15 + 3] = 2;
    expected[15 + 14] = 2;
    EXPECT_EQ(labelsOf(*map), expected);
    // Between two slices is no slice.
    d.frames[1].positionMm.z = 32.9;
    const auto between = readSegmentation(write(d));
    ASSERT_TRUE(between);
    EXPECT_FALSE(loadSegmentation(*between, kGrid, {5, 3, 3}, progress, positionsMm));
}

TEST_F(SegmentationTest, Summary) {
    const auto s = readSegmentation(write(twoSlices()));
    ASSERT_TRUE(s);
    EXPECT_EQ(s->type, SegmentationType::binary);
    EXPECT_EQ(s->referencedSeriesUids, std::vector<std::string>{"1.2.3.4"});
    EXPECT_EQ(s->seriesInstanceUid, "1.2.9");
    EXPECT_EQ(s->frames.size(), 3u);
    EXPECT_EQ(s->frames[2].segment, 2);
    EXPECT_EQ(s->spacingMm, 2.0);
}

TEST_F(SegmentationTest, Deflated) {
    Drawing d = twoSlices();
    const auto plain = on(d, kGrid, {5, 3, 2});
    d.transferSyntax = kDeflated;
    const auto map = on(d, kGrid, {5, 3, 2});
    ASSERT_TRUE(map) << map.error().message;
    EXPECT_EQ(labelsOf(*map), labelsOf(*plain));
}

// The grid is larger, and begins elsewhere by whole voxels.
TEST_F(SegmentationTest, OffsetByWholeVoxels) {
    const glm::dmat4 larger = affine({0.25, 0, 0}, {0, 0.5, 0}, {0, 0, 2}, {9.5, 19, 26});
    const auto map = on(twoSlices(), larger, {10, 8, 6});
    ASSERT_TRUE(map);
    EXPECT_EQ(map->label(2, 2, 2), 1);
    EXPECT_EQ(map->label(6, 4, 2), 1);
    EXPECT_EQ(map->label(5, 2, 3), 2);
    EXPECT_EQ(countOf(*map, 1) + countOf(*map, 2), 5u);
}

TEST_F(SegmentationTest, AxesOfTheGridInAnyOrderAndDirection) {
    // i downwards, j to the front, k to the right; the frames are axial.
    const glm::dmat4 other = affine({0, 0, -2}, {0, -0.5, 0}, {-0.25, 0, 0}, {11, 21, 32});
    const auto map = on(twoSlices(), other, {2, 3, 5});
    ASSERT_TRUE(map) << map.error().message;
    EXPECT_EQ(map->label(1, 2, 4), 1);
    EXPECT_EQ(map->label(1, 0, 0), 1);
    EXPECT_EQ(map->label(0, 1, 3), 1);
    EXPECT_EQ(map->label(0, 2, 1), 2);
    EXPECT_EQ(map->label(0, 0, 0), 2);
}

TEST_F(SegmentationTest, AShearedGrid) {
    const glm::dmat4 sheared = affine({0.25, 0, 0}, {0, 0.5, 0}, {0, 0.7, 2}, {10, 20, 30});
    Drawing d{.frames = {{{10, 20, 30}, 1}, {{10, 20.7, 32}, 1}, {{10, 22.1, 36}, 2}}};
    d.pixels = dots(d, {{0, 0, 0}, {1, 1, 1}, {2, 4, 2}});
    const auto map = on(d, sheared, {5, 3, 4});
    ASSERT_TRUE(map) << map.error().message;
    EXPECT_EQ(map->label(1, 1, 1), 1);
    EXPECT_EQ(map->label(4, 2, 3), 2);
    const auto own = alone(d);
    ASSERT_TRUE(own) << own.error().message;
    EXPECT_LT(affineError(own->worldFromVoxel(), sheared), 1e-9);
    EXPECT_EQ(labelsOf(*own), labelsOf(*map));
}

TEST_F(SegmentationTest, BetweenTheVoxelsIsAnError) {
    const std::vector<glm::dmat4> off{
        affine({0.25, 0, 0}, {0, 0.5, 0}, {0, 0, 2}, {10, 20, 30.03}),
        affine({0.25, 0, 0}, {0, 0.5, 0}, {0, 0, 2}, {10.1, 20, 30}),
        affine({0.252, 0, 0}, {0, 0.5, 0}, {0, 0, 2}, {10, 20, 30}),
        affine({0.25, 0.01, 0}, {0, 0.5, 0}, {0, 0, 2}, {10, 20, 30}),
        affine({0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 2}, {10, 20, 30}),
        affine({0.25, 0, 0}, {0, 0.5, 0}, {0, 0, 4}, {10, 20, 30}),
    };
    for (const glm::dmat4& grid : off) {
        const auto map = on(twoSlices(), grid, {5, 3, 4});
        ASSERT_FALSE(map);
        EXPECT_EQ(map.error().code, ErrorCode::inputNotUsable);
        EXPECT_NE(map.error().message.english().find("does not lie on the voxels"), std::string::npos);
    }
    const glm::dmat4 slightly = affine({0.25, 0, 0}, {0, 0.5, 0}, {0, 0, 2}, {10.002, 20.004, 30.018});
    EXPECT_TRUE(on(twoSlices(), slightly, {5, 3, 2}));
    EXPECT_NE(on(twoSlices(), off[5], {5, 3, 4}).error().message.english().find("Frame 2 "),
              std::string::npos);
}

TEST_F(SegmentationTest, OverlapsAndVoxelsOutsideAreCounted) {
    Drawing d{.frames = {{{10, 20, 30}, 1}, {{10, 20, 30}, 2}}};
    d.pixels = dots(d, {{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {1, 1, 0}, {1, 2, 0}, {1, 4, 2}});
    const auto map = on(d, kGrid, {5, 2, 1});
    ASSERT_TRUE(map);
    EXPECT_EQ(labelsOf(*map), (Labels{1, 2, 2, 0, 0, 0, 0, 0, 0, 0}));
    ASSERT_EQ(map->messages().size(), 2u);
    EXPECT_EQ(map->messages()[0].key, key::kSegmentsOverlap);
    EXPECT_EQ(map->messages()[0].arguments.at(0).value, decltype(TextArgument::value)(std::int64_t{2}));
    EXPECT_EQ(map->messages()[1].key, key::kSegmentsOutside);
    EXPECT_EQ(map->messages()[1].arguments.at(0).value, decltype(TextArgument::value)(std::int64_t{1}));
}

TEST_F(SegmentationTest, FractionalIsFromHalfOn) {
    Drawing d{.type = "FRACTIONAL", .columns = 6, .rows = 1, .bits = 8, .frames = {{{10, 20, 30}, 2}}};
    d.more = shortElement({0x0062, 0x000E}, "US", word(200));
    d.pixels = std::string("\x00\x63\x64\x65\xC8\x01", 6);  // 0 99 100 101 200 1
    const auto map = on(d, kGrid, {6, 1, 1});
    ASSERT_TRUE(map) << map.error().message;
    EXPECT_EQ(labelsOf(*map), (Labels{0, 0, 2, 2, 2, 0}));
    d.more = shortElement({0x0062, 0x000E}, "US", word(0));
    EXPECT_FALSE(on(d, kGrid, {6, 1, 1}));
}

TEST_F(SegmentationTest, LabelMaps) {
    Drawing d{.type = "LABELMAP",
              .sopClass = "1.2.840.10008.5.1.4.1.1.66.7",
              .columns = 4,
              .rows = 1,
              .bits = 16,
              .frames = {{{10, 20, 30}, 0}, {{10, 20, 32}, 0}}};
    d.pixels = word(0) + word(1) + word(2) + word(300) + word(65535) + word(0) + word(0) + word(2);
    const auto wide = on(d, kGrid, {4, 1, 2});
    ASSERT_TRUE(wide) << wide.error().message;
    EXPECT_EQ(labelsOf(*wide), (Labels{0, 1, 2, 300, 65535, 0, 0, 2}));
    ASSERT_NE(wide->segment(300), nullptr) << "not described, and there";
    EXPECT_EQ(wide->segment(300)->label, "Segment 300");
    EXPECT_EQ(wide->segments().size(), 4u);
    d.bits = 8;
    d.pixels = std::string("\x00\x01\x02\xFF\x00\x00\x00\x02", 8);
    const auto narrow = on(d, kGrid, {4, 1, 2});
    ASSERT_TRUE(narrow);
    EXPECT_EQ(labelsOf(*narrow), (Labels{0, 1, 2, 255, 0, 0, 0, 2}));
    d.bits = 1;
    EXPECT_FALSE(on(d, kGrid, {4, 1, 2}));
}

TEST_F(SegmentationTest, Compressed) {
    Drawing d{.type = "LABELMAP",
              .sopClass = "1.2.840.10008.5.1.4.1.1.66.7",
              .columns = 4,
              .rows = 1,
              .bits = 8,
              .frames = {{{10, 20, 30}, 0}, {{10, 20, 32}, 0}}};
    d.more = shortElement({0x0028, 0x0004}, "CS", "MONOCHROME2");
    d.pixels = std::string("\x00\x01\x02\xFF\x00\x00\x00\x02", 8);
    const fs::path file = write(d);
    silenceToolkit();
    DcmRLEEncoderRegistration::registerCodecs();
    DcmFileFormat format;
    ASSERT_TRUE(format.loadFile(file.c_str()).good());
    ASSERT_TRUE(format.getDataset()->chooseRepresentation(EXS_RLELossless, nullptr).good());
    ASSERT_TRUE(format.saveFile(file.c_str(), EXS_RLELossless).good());
    const auto segmentation = readSegmentation(file);
    ASSERT_TRUE(segmentation) << segmentation.error().message;
    EXPECT_EQ(segmentation->transferSyntaxUid, "1.2.840.10008.1.2.5");
    Progress progress;
    const auto map = loadSegmentation(*segmentation, kGrid, {4, 1, 2}, progress);
    ASSERT_TRUE(map) << map.error().message;
    EXPECT_EQ(labelsOf(*map), (Labels{0, 1, 2, 255, 0, 0, 0, 2}));
}

// Slices without any segment have no frame: the grid has them all the same.
TEST_F(SegmentationTest, OwnGridKeepsEmptySlices) {
    for (const char* stated : {"2", "1", "", "2.0000001", "7"}) {
        SCOPED_TRACE(stated);
        Drawing d{.sliceSpacing = stated,
                  .frames = {{{10, 20, 40}, 1}, {{10, 20, 30}, 1}, {{10, 20, 32}, 1}}};
        d.pixels = dots(d, {{0, 0, 0}, {1, 1, 0}, {2, 2, 0}});
        const auto map = alone(d);
        ASSERT_TRUE(map) << map.error().message;
        const int step = std::string(stated) == "1" ? 2 : 1;
        EXPECT_EQ(map->size(), glm::ivec3(5, 3, 5 * step + 1));
        EXPECT_EQ(map->label(0, 0, 5 * step), 1);
        EXPECT_EQ(map->label(1, 0, 0), 1);
        EXPECT_EQ(map->label(2, 0, step), 1);
        EXPECT_LT(glm::distance(glm::dvec3(map->worldFromVoxel()[3]), glm::dvec3(10, 20, 30)), 1e-9);
    }
    Drawing uneven{.sliceSpacing = "", .frames = {{{10, 20, 30}, 1}, {{10, 20, 32}, 1}, {{10, 20, 35}, 1}}};
    uneven.pixels = dots(uneven, {});
    ASSERT_FALSE(alone(uneven));
    EXPECT_NE(alone(uneven).error().message.english().find("do not lie on one grid"), std::string::npos);
    Drawing one{.frames = {{{10, 20, 30}, 1}}};
    one.pixels = dots(one, {{0, 0, 0}});
    const auto single = alone(one);
    ASSERT_TRUE(single);
    EXPECT_EQ(single->size(), glm::ivec3(5, 3, 1));
    EXPECT_LT(affineError(single->worldFromVoxel(), kGrid), 1e-9);
}

TEST_F(SegmentationTest, HostileHeaders) {
    const glm::ivec3 size{5, 3, 2};
    const auto refused = [&](const Drawing& d) {
        const auto map = on(d, kGrid, size);
        return map ? "loaded" : map.error().message.english();
    };
    Drawing d = twoSlices();
    d.pixels.resize(4);  // of 6
    EXPECT_NE(refused(d).find("ends before its last frame"), std::string::npos) << refused(d);
    d.pixels.clear();
    EXPECT_NE(refused(d).find("ends before"), std::string::npos) << refused(d);
    for (const char* claimed : {"4", "2000000000", "99999999999"}) {
        d = twoSlices();
        d.claimedFrames = claimed;
        const auto segmentation = readSegmentation(write(d));
        // The last is no number of frames at all.
        EXPECT_EQ(segmentation.ok(), std::string(claimed) == "99999999999") << claimed;
    }
    d = twoSlices();
    d.columns = d.rows = 65535;
    EXPECT_NE(refused(d), "loaded");
    for (const int wrong : {0, 3, 12, 24, 64}) {
        d = twoSlices();
        d.bits = wrong;
        EXPECT_NE(refused(d), "loaded") << wrong;
    }
    for (const char* wrong : {"", "0\\0", "-1\\1", "nan\\1", "1e300\\1"}) {
        d = twoSlices();
        d.pixelSpacing = wrong;
        EXPECT_NE(refused(d), "loaded") << wrong;
    }
    for (const char* wrong : {"", "0\\0\\0\\0\\0\\0", "1\\0\\0\\1\\0\\0", "1\\0\\0"}) {
        d = twoSlices();
        d.orientation = wrong;
        EXPECT_NE(refused(d), "loaded") << wrong;
    }
    d = twoSlices();
    d.type = "SOMETHING";
    EXPECT_NE(refused(d), "loaded");
    d = twoSlices();
    d.sopClass = "1.2.840.10008.5.1.4.1.1.2";
    EXPECT_NE(refused(d), "loaded");
    d = twoSlices();
    d.frames[1].segment = 0;
    EXPECT_NE(refused(d), "loaded") << "two segments, and which is not said";
    d.segments = {2};
    EXPECT_EQ(refused(d), "loaded");
    d.segments = {};
    EXPECT_NE(refused(d), "loaded");
    EXPECT_FALSE(readSegmentation(folder / "missing"));
}

// A grid of its own may not be larger than memory, however far apart two frames are.
TEST_F(SegmentationTest, FramesFarApart) {
    Drawing d{.columns = 3000, .rows = 3000, .frames = {{{0, 0, 0}, 1}, {{0, 0, 2e6}, 1}}};
    d.pixels = std::string(3000u * 3000u / 4, '\0');
    const auto map = alone(d);
    ASSERT_FALSE(map);
    EXPECT_EQ(map.error().code, ErrorCode::inputNotUsable);
}

TEST_F(SegmentationTest, CanBeCancelled) {
    const auto segmentation = readSegmentation(write(twoSlices()));
    ASSERT_TRUE(segmentation);
    const CancelToken token;
    token.cancel();
    Progress progress({}, token);
    const auto map = loadSegmentation(*segmentation, kGrid, {5, 3, 2}, progress);
    ASSERT_FALSE(map);
    EXPECT_EQ(map.error().code, ErrorCode::cancelled);
}

TEST_F(SegmentationTest, BadGrids) {
    for (const glm::ivec3 size : {glm::ivec3(0, 3, 2), glm::ivec3(5, -3, 2)})
        EXPECT_FALSE(on(twoSlices(), kGrid, size));
    EXPECT_FALSE(on(twoSlices(), glm::dmat4(0.0), {5, 3, 2}));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(on(twoSlices(), affine({nan, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}), {5, 3, 2}));
}

TEST(GridPlacement, ColumnsAndRows) {
    const glm::dmat4 inverse = glm::inverse(kGrid);
    const ImagePlane plane{.positionMm = {10.5, 22, 34}, .columnSpacingMm = 0.25, .rowSpacingMm = 0.5};
    EXPECT_EQ(placeOnGrid(inverse, plane, 5, 3), (GridPlacement{{2, 4, 2}, {1, 0, 0}, {0, 1, 0}}));
    ImagePlane turned = plane;
    turned.rowDirection = {0, -1, 0};
    turned.columnDirection = {1, 0, 0};
    std::swap(turned.columnSpacingMm, turned.rowSpacingMm);
    EXPECT_EQ(placeOnGrid(inverse, turned, 5, 3), (GridPlacement{{2, 4, 2}, {0, -1, 0}, {1, 0, 0}}));
    // A single column says nothing of its spacing but by the step itself.
    ImagePlane wide = plane;
    wide.columnSpacingMm = 0.5;
    EXPECT_FALSE(placeOnGrid(inverse, wide, 1, 3));
    ImagePlane far = plane;
    far.positionMm.x = 1e300;
    EXPECT_FALSE(placeOnGrid(inverse, far, 5, 3));
}

TEST(Segmentation, RealOnTheGridOfItsSeries) {
    SKIP_WITHOUT_SHARED_DATA();
    const fs::path pair = sharedData() / "odd/legacy_enhanced_pair";
    const auto segmentation = readSegmentation(pair / "label.seg");
    ASSERT_TRUE(segmentation) << segmentation.error().message;
    EXPECT_EQ(segmentation->frames.size(), 3u);
    ASSERT_EQ(segmentation->segments.size(), 1u);
    const Segment& liver = segmentation->segments[0];
    EXPECT_EQ(liver.label, "Liver");
    EXPECT_EQ(liver.description, "Liver Segmentation");
    EXPECT_EQ(liver.algorithm, "SEMIAUTOMATIC");
    EXPECT_EQ(liver.algorithmName, "SlicerEditor");
    // dcmqi's example has 221, 130, 101 for the liver.
    ASSERT_TRUE(liver.recommendedRgb);
    EXPECT_NEAR((*liver.recommendedRgb)[0], 221, 2);
    EXPECT_NEAR((*liver.recommendedRgb)[1], 130, 2);
    EXPECT_NEAR((*liver.recommendedRgb)[2], 101, 2);

    const HeaderFile slice = readHeader(pair / "IMG0001.dcm");
    ASSERT_TRUE(slice.header);
    EXPECT_EQ(segmentation->referencedSeriesUids,
              std::vector<std::string>{slice.header->text(tag::kSeriesInstanceUid).value_or("")});
    const glm::dmat4 grid = affine({0.7, 0, 0}, {0, 0.7, 0}, {0, 0, 2.5}, {46.4649, 5.01881, -177.75});
    Progress progress;
    const auto map = loadSegmentation(*segmentation, grid, {24, 38, 3}, progress);
    ASSERT_TRUE(map) << map.error().message;
    const auto own = loadSegmentation(*segmentation, progress);
    ASSERT_TRUE(own);
    EXPECT_EQ(own->size(), glm::ivec3(24, 38, 3));
    EXPECT_LT(affineError(own->worldFromVoxel(), grid), 1e-9);
    EXPECT_EQ(labelsOf(*own), labelsOf(*map));
    // As the bits of the file say, read here in another way: all frames as one row of bits.
    std::ifstream file(pair / "label.seg", std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    const std::string pixels = bytes.substr(bytes.size() - 342);
    for (std::size_t i = 0; i < 24u * 38 * 3; ++i)
        ASSERT_EQ(map->labels()[i], static_cast<unsigned char>(pixels[i / 8]) >> (i % 8) & 1) << i;
    EXPECT_GT(countOf(*map, 1), 100u);
    EXPECT_LT(countOf(*map, 1), 24u * 38 * 3 / 2);
}

TEST(Segmentation, RealWithoutItsSeries) {
    SKIP_WITHOUT_SHARED_DATA();
    const auto segmentation = readSegmentation(sharedData() / "odd/seg_1frame.dcm");
    ASSERT_TRUE(segmentation) << segmentation.error().message;
    Progress progress;
    const auto map = loadSegmentation(*segmentation, progress);
    ASSERT_TRUE(map) << map.error().message;
    EXPECT_EQ(map->size(), glm::ivec3(512, 512, 1));
    EXPECT_EQ(map->segment(1)->label, "Liver");
    EXPECT_GT(countOf(*map, 1), 100u);
    EXPECT_FALSE(readSegmentation(sharedData() / "odd/enhanced_ct_2frame.dcm"));
}

}  // namespace
}  // namespace macula::dicom::test
