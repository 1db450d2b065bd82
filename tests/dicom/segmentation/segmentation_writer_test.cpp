// Segmentations that are written: our reader finds the same voxels, labels, codes and colours, and other
// tools find no fault.
#include "dicom/write/segmentation_writer.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>

#include "dicom/segmentation/segment_voxels.h"
#include "dicom/write/cie_lab.h"
#include "opens_in_dcmtk.h"
#include "support.h"
#include "synthetic.h"
#include "synthetic_segmentation.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;

std::string textOf(DcmItem& item, const DcmTagKey& tag) {
    OFString all;
    item.findAndGetOFStringArray(tag, all);
    return all.c_str();
}

class SegmentationWriterTest : public testing::Test {
  protected:
    void SetUp() override {
        series_.size = {9, 7, 6};  // 63 cells a frame: no frame ends with a byte
        slices_ = slicesOf(series_);
        files_ = writeFiles(folder_ / "study", series_, slices_);
        owner_.image = SecondaryCapture::Source{files_[0], slices_[0].sopInstanceUid};
        owner_.softwareVersion = "1.0";
        written_.series.seriesInstanceUid = series_.seriesUid;
        written_.series.frameOfReferenceUid = series_.frameOfReferenceUid;
        written_.worldFromVoxel = series_.expectedAffine();
        written_.size = series_.size;
        for (const Slice& slice : slices_)
            written_.slices.push_back(
                {slice.positionMm, ReferencedImage{"1.2.840.10008.5.1.4.1.1.2", slice.sopInstanceUid, {}}});
        add({.number = 1,
             .label = "Liver",
             .description = "All of it",
             .algorithm = "AUTOMATIC",
             .algorithmName = "Net 3",
             .recommendedRgb = std::array<std::uint8_t, 3>{221, 130, 101}},
            [](const glm::ivec3& v) { return v.z >= 1 && v.z <= 3 && (v.x + v.y + v.z) % 2 == 0; });
        written_.segments[0].codes = {CodedName{"123037004", "SCT", "Anatomical Structure"},
                                      CodedName{"10200004", "SCT", "Liver"}};
        add({.number = 2,
             .label = "Cyst",
             .description = {},
             .algorithm = "MANUAL",
             .algorithmName = {},
             .recommendedRgb = {}},
            [](const glm::ivec3& v) { return v == glm::ivec3(8, 6, 5); });  // the last voxel alone
    }

    void add(const Segment& segment, const std::function<bool(const glm::ivec3&)>& isIn) {
        VoxelSet voxels(glm::ivec3(0), series_.size - 1);
        for (int z = 0; z < series_.size.z; ++z)
            for (int y = 0; y < series_.size.y; ++y)
                for (int x = 0; x < series_.size.x; ++x)
                    if (isIn({x, y, z})) voxels.add({x, y, z});
        written_.segments.push_back(
            {.segment = segment, .voxels = std::make_shared<const VoxelSet>(voxels.cropped())});
    }

    void write() {
        const Result<void> done = writeSegmentation(path_, written_, owner_);
        ASSERT_TRUE(done.ok()) << done.error().message.english();
        ASSERT_TRUE(file_.loadFile(path_.c_str()).good());
        file_.loadAllDataIntoMemory();
    }
    // By our reader, on the grid of the series.
    SegmentVoxelSets readBack() {
        const auto header = readSegmentation(path_);
        EXPECT_TRUE(header) << header.error().message.english();
        Progress progress;
        auto sets = loadSegmentVoxels(*header, written_.worldFromVoxel, written_.size, progress);
        EXPECT_TRUE(sets) << sets.error().message.english();
        return *std::move(sets);
    }
    void expectSame() {
        const SegmentVoxelSets sets = readBack();
        EXPECT_FALSE(sets.isResampled);
        EXPECT_EQ(sets.outside, 0u);
        ASSERT_EQ(sets.segments.size(), written_.segments.size());
        for (std::size_t n = 0; n < sets.segments.size(); ++n) {
            Segment expected = written_.segments[n].segment;
            expected.number = std::uint16_t(n + 1);
            EXPECT_EQ(sets.segments[n].segment, expected) << n;
            EXPECT_TRUE(sets.segments[n].voxels == *written_.segments[n].voxels) << n;
        }
    }
    DcmDataset& dataset() { return *file_.getDataset(); }

    const TemporaryFolder folder_;
    const fs::path path_ = folder_ / "seg.dcm";
    SyntheticSeries series_;
    std::vector<Slice> slices_;
    std::vector<fs::path> files_;
    WrittenSegmentation written_;
    NewObject owner_;
    DcmFileFormat file_;
};

TEST_F(SegmentationWriterTest, IsReadAsItWasWritten) {
    write();
    expectSame();
    const auto read = readSegmentCodes(path_);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->sopInstanceUid, textOf(dataset(), DCM_SOPInstanceUID));
    ASSERT_EQ(read->codes.size(), 2u);
    EXPECT_EQ(read->codes.at(1), written_.segments[0].codes);
    EXPECT_EQ(read->codes.at(2).type->meaning, "Tissue") << "a code must be there";
    EXPECT_EQ(textOf(dataset(), DCM_NumberOfFrames), "4") << "three slices of one, one of the other";
    EXPECT_EQ(textOf(dataset(), DCM_SegmentsOverlap), "NO");
    EXPECT_EQ(textOf(dataset(), DCM_PatientID), series_.patientId);
    EXPECT_EQ(textOf(dataset(), DCM_StudyInstanceUID), series_.studyUid);
    EXPECT_EQ(textOf(dataset(), DCM_FrameOfReferenceUID), series_.frameOfReferenceUid);
    DcmItem* series = nullptr;
    ASSERT_TRUE(dataset().findAndGetSequenceItem(DCM_ReferencedSeriesSequence, series).good());
    EXPECT_EQ(textOf(*series, DCM_SeriesInstanceUID), series_.seriesUid);
    DcmSequenceOfItems* images = nullptr;
    ASSERT_TRUE(series->findAndGetSequence(DCM_ReferencedInstanceSequence, images).good());
    ASSERT_EQ(images->card(), 4u);
    EXPECT_EQ(textOf(*images->getItem(3), DCM_ReferencedSOPInstanceUID), slices_[5].sopInstanceUid);
}

// Each bit of the frames, by the rule of PS3.5 8.1.1 alone.
TEST_F(SegmentationWriterTest, CellsFollowEachOtherWithoutGaps) {
    write();
    const Uint8* bytes = nullptr;
    unsigned long count = 0;
    ASSERT_TRUE(dataset().findAndGetUint8Array(DCM_PixelData, bytes, &count).good());
    ASSERT_EQ(count, 32u);  // 4 frames of 63 bits, and one byte to be even
    std::size_t bit = 0;
    for (const auto& [segment, slice] : {std::pair(0, 1), {0, 2}, {0, 3}, {1, 5}})
        for (int y = 0; y < 7; ++y)
            for (int x = 0; x < 9; ++x, ++bit)
                ASSERT_EQ((bytes[bit / 8] >> bit % 8 & 1) != 0,
                          written_.segments[std::size_t(segment)].voxels->contains({x, y, slice}))
                    << bit;
}

TEST_F(SegmentationWriterTest, OverlapsEmptyOnesAndGapsInNumbersAreKept) {
    written_.segments[1].segment.number = 7;  // in the file it is 2
    add({.number = 9,
         .label = "Nothing",
         .description = {},
         .algorithm = "MANUAL",
         .algorithmName = {},
         .recommendedRgb = {}},
        [](const glm::ivec3&) { return false; });
    add({.number = 11,
         .label = "All",
         .description = {},
         .algorithm = "MANUAL",
         .algorithmName = {},
         .recommendedRgb = {}},
        [](const glm::ivec3&) { return true; });
    write();
    EXPECT_EQ(textOf(dataset(), DCM_SegmentsOverlap), "YES");
    EXPECT_EQ(textOf(dataset(), DCM_NumberOfFrames), "10");
    expectSame();
}

TEST_F(SegmentationWriterTest, ASliceWithoutAnImageHasFramesToo) {
    written_.slices[2].of.reset();
    write();
    expectSame();
}

// A tilted gantry, and slices that are slightly off the grid.
TEST_F(SegmentationWriterTest, ShearedAndUnevenStacksStayWhereTheyAre) {
    series_.worldFromVoxel[2] += 0.4 * series_.worldFromVoxel[1];
    slices_ = slicesOf(series_);
    written_.worldFromVoxel = series_.expectedAffine();
    std::vector<glm::dvec3> positions;
    for (std::size_t k = 0; k < slices_.size(); ++k) {
        written_.slices[k].positionMm = slices_[k].positionMm + 0.03 * slices_[k].normal() * double(k % 2);
        positions.push_back(written_.slices[k].positionMm);
    }
    write();
    const auto header = readSegmentation(path_);
    ASSERT_TRUE(header);
    Progress progress;
    const auto sets = loadSegmentVoxels(*header, written_.worldFromVoxel, written_.size, progress, positions);
    ASSERT_TRUE(sets);
    EXPECT_FALSE(sets->isResampled);
    EXPECT_TRUE(sets->segments[0].voxels == *written_.segments[0].voxels);
}

TEST_F(SegmentationWriterTest, LabelsOfAllLanguagesAndAnyLength) {
    written_.segments[0].segment.label = "Größe der Läsion";
    written_.segments[1].segment.label = "病変";
    write();
    expectSame();
    EXPECT_EQ(textOf(dataset(), DCM_SpecificCharacterSet), "ISO_IR 192");
    std::string longest;
    for (int n = 0; n < 70; ++n) longest += "病";
    written_.segments[0].segment.label = longest;
    written_.segments[1].segment.label = "a\\b";
    write();
    SegmentVoxelSets sets = readBack();
    EXPECT_EQ(sets.segments[0].segment.label, longest.substr(0, 64 * 3));
    EXPECT_EQ(sets.segments[1].segment.label, "a/b");
    written_.segments[0].segment.label.clear();
    written_.segments[0].segment.algorithm.clear();
    write();
    sets = readBack();
    EXPECT_EQ(sets.segments[0].segment.label, "Segment 1");
    EXPECT_EQ(sets.segments[0].segment.algorithm, "SEMIAUTOMATIC");
}

TEST_F(SegmentationWriterTest, OfNobodyNothingIsLeftOfThePatient) {
    owner_.isDeidentified = true;
    write();
    expectSame();
    std::ifstream stream(path_, std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(stream)), {});
    for (const std::string& part :
         {series_.patientName, series_.patientId, series_.studyUid + '\0', series_.seriesUid + '\0',
          series_.frameOfReferenceUid + '\0', slices_[1].sopInstanceUid})
        EXPECT_EQ(bytes.find(part), std::string::npos) << part;
}

TEST_F(SegmentationWriterTest, WhatDoesNotFitIsRefusedAndWritesNothing) {
    const auto refused = [&](const std::function<void(WrittenSegmentation&, NewObject&)>& change,
                             ErrorCode code = ErrorCode::usage) {
        WrittenSegmentation segmentation = written_;
        NewObject owner = owner_;
        change(segmentation, owner);
        const Result<void> done = writeSegmentation(path_, segmentation, owner);
        ASSERT_FALSE(done.ok());
        EXPECT_EQ(done.error().code, code);
        EXPECT_FALSE(done.error().hint.empty());
        EXPECT_FALSE(fs::exists(path_));
    };
    using S = WrittenSegmentation;
    using O = NewObject;
    refused([](S& s, O&) { s.segments.clear(); });
    refused([](S& s, O&) {
        for (WrittenSegment& each : s.segments) each.voxels = std::make_shared<const VoxelSet>();
    });
    refused([](S& s, O&) { s.segments[0].voxels.reset(); });
    refused([](S& s, O&) {
        VoxelSet beyond(glm::ivec3(0), glm::ivec3(20));
        beyond.add(glm::ivec3(20));
        s.segments[0].voxels = std::make_shared<const VoxelSet>(beyond);
    });
    refused([](S& s, O&) { s.slices.pop_back(); });
    refused([](S& s, O&) { s.worldFromVoxel[1] += 0.1 * s.worldFromVoxel[0]; });
    refused([](S& s, O&) { s.worldFromVoxel[1] = glm::dvec4(0.0); });
    refused([](S& s, O&) { s.series.frameOfReferenceUid.clear(); });
    refused([](S& s, O&) { s.slices[0].of->sopInstanceUid = "no UID"; });
    refused([](S& s, O&) { s.label = "small letters"; });
    refused([](S&, O& o) { o.image.reset(); });
    refused([](S&, O& o) { o.image->sopInstanceUid += "1"; }, ErrorCode::inputNotUsable);
}

TEST_F(SegmentationWriterTest, ToolsFindNoError) {
    for (const bool isDeidentified : {false, true}) {
        owner_.isDeidentified = isDeidentified;
        ASSERT_TRUE(writeSegmentation(path_, written_, owner_).ok());
        expectOpensInDcmtk(path_);
        if (std::system("command -v dciodvfy >/dev/null 2>&1") != 0) continue;
        const fs::path told = folder_ / "told.txt";
        std::ignore =
            std::system(fmt::format("dciodvfy '{}' >'{}' 2>&1", path_.string(), told.string()).c_str());
        std::ifstream lines(told);
        std::size_t seen = 0;
        for (std::string line; std::getline(lines, line); ++seen)
            EXPECT_EQ(line.find("Error"), std::string::npos) << line;
        EXPECT_GT(seen, 0u);
    }
}

TEST(CieLab, TheSameColourReturns) {
    for (int red = 0; red < 256; red += 5)
        for (int green = 0; green < 256; green += 5)
            for (int blue = 0; blue < 256; blue += 5) {
                const std::array<std::uint8_t, 3> rgb{std::uint8_t(red), std::uint8_t(green),
                                                      std::uint8_t(blue)};
                ASSERT_EQ(rgbOfCieLab(cieLabOfRgb(rgb)), rgb) << red << ' ' << green << ' ' << blue;
            }
    EXPECT_EQ(cieLabOfRgb({255, 255, 255})[0], 65535);
    EXPECT_EQ(cieLabOfRgb({0, 0, 0})[0], 0);
}

}  // namespace
}  // namespace macula::dicom::test
