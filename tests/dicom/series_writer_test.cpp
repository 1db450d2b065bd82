#include "dicom/write/series_writer.h"

#include <fstream>

#include "base/atomic_file.h"
#include "base/phantom.h"
#include "base/sha256.h"
#include "edit.h"
#include "support.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;

// Gives the files names in another order, and of another kind.
void shuffleNames(const std::vector<fs::path>& files) {
    for (const fs::path& file : files) {
        fs::rename(file, file.parent_path() / (sha256Hex(file.filename().string()).substr(0, 8) + ".txt"));
    }
}

void expectRoundTrip(const Volume& volume, const SeriesWriterOptions& options = {}) {
    const TemporaryFolder folder;
    shuffleNames(write(volume, folder.path(), options));
    const auto read = loadFolder(folder.path());
    ASSERT_NE(read, nullptr);
    expectSameValues(*read, volume);
    EXPECT_LT(affineError(read->worldFromVoxel(), volume.worldFromVoxel()), 1e-6);
    EXPECT_EQ(read->modality(), volume.modality());
    EXPECT_EQ(read->unit(), volume.unit());
    EXPECT_TRUE(read->provenance().assumptions.empty());
    ASSERT_EQ(read->padding().has_value(), volume.padding().has_value());
    if (volume.padding()) {
        EXPECT_EQ(read->unitsFromStored()(read->padding()->low),
                  volume.unitsFromStored()(volume.padding()->low));
        EXPECT_EQ(read->unitsFromStored()(read->padding()->high),
                  volume.unitsFromStored()(volume.padding()->high));
        EXPECT_EQ(read->unitsFromStored()(read->storedRange().low),
                  volume.unitsFromStored()(volume.storedRange().low));
    }
}

TEST(SeriesWriter, RoundTripInEveryTransferSyntaxAndSign) {
    using enum WriteSyntax;
    for (const WriteSyntax syntax : {explicitLittleEndian, implicitLittleEndian, explicitBigEndian, deflated,
                                     rle, jpegLossless, jpegLs}) {
        for (const PixelSign sign : {PixelSign::asUnsigned, PixelSign::asSigned}) {
            SCOPED_TRACE(fmt::format("syntax {} sign {}", static_cast<int>(syntax), static_cast<int>(sign)));
            expectRoundTrip(smallVolume(), {.syntax = syntax, .pixelSign = sign});
        }
    }
}

TEST(SeriesWriter, RoundTripOfPadding) {
    for (const PixelSign sign : {PixelSign::asUnsigned, PixelSign::asSigned}) {
        expectRoundTrip(smallVolume(StoredRange{24, 24}), {.pixelSign = sign});
        expectRoundTrip(smallVolume(StoredRange{24, 105}), {.pixelSign = sign});
    }
}

TEST(SeriesWriter, RoundTripOfMr) {
    expectRoundTrip(smallVolume(obliqueAffine(), {0.25, 0.0}, "MR"));
}

TEST(SeriesWriter, RoundTripOfASagittalStack) {
    const glm::dmat4 sagittal = affine({0, 1.015625, 0}, {0, 0, -1.015625}, {-4.8, 0, 0}, {81.6, -130, 130});
    expectRoundTrip(smallVolume(sagittal, {1.0, 0.0}, "MR"));
}

TEST(SeriesWriter, RoundTripOfAShearedStack) {
    const glm::dmat4 sheared = affine({0.4, 0, 0}, {0, 0.5, 0}, {0.3, 0.6, 2.5}, {1, 2, 3});
    expectRoundTrip(smallVolume(sheared, {1.0, -1024.0}, "CT"));
}

TEST(SeriesWriter, RoundTripOfThePhantom) {
    expectRoundTrip(phantom::make({.size = {80, 72, 60}, .spacingMm = {3.75, 3.75, 5.0}}));
}

TEST(SeriesWriter, SameVolumeGivesTheSameFiles) {
    const TemporaryFolder folder;
    const auto first = write(smallVolume(), folder / "a");
    const auto second = write(smallVolume(), folder / "b");
    ASSERT_EQ(first.size(), 6u);
    for (std::size_t k = 0; k < first.size(); ++k) {
        EXPECT_EQ(*readText(first[k]), *readText(second[k]));
        EXPECT_EQ(first[k].filename(), fmt::format("IM{:05}.dcm", k + 1));
    }
    EXPECT_EQ(write(smallVolume(), folder / "a").size(), 6u);  // again, in place
}

TEST(SeriesWriter, NeverTouchesFilesThatAreThere) {
    const TemporaryFolder folder;
    std::ofstream(folder / "IM00001.dcm") << "something else";
    Progress progress;
    const auto files = writeSeries(smallVolume(), folder.path(), {}, progress);
    ASSERT_FALSE(files);
    EXPECT_EQ(files.error().code, ErrorCode::outputNotWritable);
    EXPECT_EQ(*readText(folder / "IM00001.dcm"), "something else");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST(SeriesWriter, CancelledWritingLeavesNothing) {
    const TemporaryFolder folder;
    Progress progress;
    progress.token().cancel();
    const auto files = writeSeries(smallVolume(), folder / "out", {}, progress);
    ASSERT_FALSE(files);
    EXPECT_EQ(files.error().code, ErrorCode::cancelled);
    EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(SeriesWriter, RefusesWhatDicomCannotExpress) {
    const TemporaryFolder folder;
    Progress progress;
    const glm::dmat4 skewed = affine({1, 0.1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0});
    const auto notPerpendicular = writeSeries(smallVolume(skewed, {}, "CT"), folder / "a", {}, progress);
    ASSERT_FALSE(notPerpendicular);
    EXPECT_EQ(notPerpendicular.error().code, ErrorCode::usage);
    EXPECT_FALSE(writeSeries(smallVolume(obliqueAffine(), {}, "US"), folder / "b", {}, progress));
}

TEST(SeriesWriter, PatientIsObviouslyNone) {
    const TemporaryFolder folder;
    write(smallVolume(), folder.path());
    const auto found = scan(folder.path());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->studies[0].patientName, "PHANTOM^MACULA");
    EXPECT_TRUE(found->studies[0].studyInstanceUid.starts_with("2.25."));
    EXPECT_LE(found->studies[0].studyInstanceUid.size(), 64u);
}

}  // namespace
}  // namespace macula::dicom::test
