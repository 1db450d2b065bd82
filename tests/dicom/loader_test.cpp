#include "dicom/loader.h"

#include <chrono>
#include <fstream>

#include "base/atomic_file.h"
#include "base/log.h"
#include "edit.h"
#include "support.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;

TEST(Loader, SlopePerSlice) {
    const TemporaryFolder folder;
    const Volume original = smallVolume(obliqueAffine(), {1.0, 0.0}, "MR");
    const auto files = write(original, folder.path());
    for (std::size_t k = 0; k < files.size(); ++k)
        setText(files[k], tag::kRescaleSlope, std::to_string(k + 1));
    const auto volume = loadFolder(folder.path());
    ASSERT_NE(volume, nullptr);
    EXPECT_TRUE(volume->provenance().assumptions.empty());  // 1, 2, 3 … have a common step: exact
    for (int k = 0; k < 6; ++k) EXPECT_EQ(volume->value(3, 2, k), (k + 1) * original.value(3, 2, k));
}

TEST(Loader, TheBodyPartIsWhatAllImagesSay) {
    const TemporaryFolder folder;
    const auto files = write(smallVolume(obliqueAffine(), {1.0, 0.0}, "MR"), folder.path());
    EXPECT_EQ(loadFolder(folder.path())->bodyPart(), "") << "nobody said";
    const Tag bodyPart{0x0018, 0x0015};
    for (const fs::path& file : files) setText(file, bodyPart, "HEAD");
    EXPECT_EQ(loadFolder(folder.path())->bodyPart(), "HEAD");
}

TEST(Loader, SlopePerSliceWithoutCommonStepIsKeptInFloat) {
    const TemporaryFolder folder;
    const Volume original = smallVolume(obliqueAffine(), {1.0, 0.0}, "MR");
    const auto files = write(original, folder.path());
    for (std::size_t k = 0; k < files.size(); ++k) {
        setText(files[k], tag::kRescaleSlope, fmt::format("{:.6f}", 0.01 * std::sqrt(double(k + 2))));
    }
    const auto volume = loadFolder(folder.path());
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(volume->format(), VoxelFormat::float32);
    EXPECT_TRUE(volume->provenance().assumptions.empty());
    for (int k = 0; k < 6; ++k) {
        const double slope = std::stod(fmt::format("{:.6f}", 0.01 * std::sqrt(double(k + 2))));
        EXPECT_EQ(volume->value(3, 2, k), static_cast<float>(slope * original.value(3, 2, k)));
    }
}

TEST(Loader, NegativeSlope) {
    const TemporaryFolder folder;
    const Volume original = smallVolume();
    for (const fs::path& file : write(original, folder.path(), {.pixelSign = PixelSign::asSigned})) {
        setText(file, tag::kRescaleSlope, "-1");
        setText(file, tag::kRescaleIntercept, "0");
    }
    const auto volume = loadFolder(folder.path());
    ASSERT_NE(volume, nullptr);
    const double raw = original.stored(1, 2, 3) - 32768.0;
    EXPECT_EQ(volume->value(1, 2, 3), -raw);
}

TEST(Loader, Monochrome1KeepsItsValues) {
    const TemporaryFolder folder;
    const Volume original = smallVolume();
    for (const fs::path& file : write(original, folder.path())) {
        setText(file, tag::kPhotometricInterpretation, "MONOCHROME1");
    }
    const auto volume = loadFolder(folder.path());
    ASSERT_NE(volume, nullptr);
    expectSameValues(*volume, original);
}

TEST(Loader, MissingRescaleInCtIsAnAssumptionNotASilentDefault) {
    const TemporaryFolder folder;
    for (const fs::path& file : write(smallVolume(), folder.path())) {
        remove(file, tag::kRescaleSlope);
        remove(file, tag::kRescaleIntercept);
    }
    const auto found = scan(folder.path());
    ASSERT_TRUE(found);
    const Series& series = found->studies.at(0).series.at(0);
    EXPECT_TRUE(hasMessage(series, key::kMissingRescale));
    const auto volume = load(series);
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(volume->provenance().assumptions.size(), 2u);
    EXPECT_EQ(volume->unit(), Unit::raw);
    EXPECT_TRUE(hasMessage(series, key::kNoHounsfield));
}

TEST(Loader, MissingRescaleInMrIsNormal) {
    const TemporaryFolder folder;
    for (const fs::path& file : write(smallVolume(obliqueAffine(), {1.0, 0.0}, "MR"), folder.path())) {
        remove(file, tag::kRescaleSlope);
        remove(file, tag::kRescaleIntercept);
    }
    const auto volume = loadFolder(folder.path());
    ASSERT_NE(volume, nullptr);
    EXPECT_TRUE(volume->provenance().assumptions.empty());
}

// Compressed samples of 8 bits take one byte in the stream even when the cells have two.
TEST(Loader, EightStoredBits) {
    using enum WriteSyntax;
    for (const WriteSyntax syntax : {explicitLittleEndian, rle, jpegLossless, jpegLs}) {
        for (const int bitsAllocated : {8, 16}) {
            SCOPED_TRACE(
                fmt::format("syntax {}, {} bits allocated", static_cast<int>(syntax), bitsAllocated));
            const TemporaryFolder folder;
            const auto files = write(smallVolume(obliqueAffine(), {2.0, -7.0}, "MR"), folder.path());
            std::vector<std::uint8_t> values;
            for (int n = 0; n < 20; ++n) values.push_back(static_cast<std::uint8_t>(255 - 13 * n));
            for (const fs::path& file : files) saveWithEightBits(file, bitsAllocated, values, syntax);
            const auto volume = loadFolder(folder.path());
            ASSERT_NE(volume, nullptr);
            for (int k = 0; k < 6; ++k) {
                for (int n = 0; n < 20; ++n) {
                    ASSERT_EQ(volume->value(n % 5, n / 5, k), 2.0 * values[static_cast<std::size_t>(n)] - 7.0)
                        << n;
                }
            }
        }
    }
}

TEST(Loader, SliceCutOffAfterTheScanIsAGap) {
    const TemporaryFolder folder;
    for (const WriteSyntax syntax :
         {WriteSyntax::explicitLittleEndian, WriteSyntax::rle, WriteSyntax::jpegLs}) {
        const fs::path place = folder / fmt::format("DOE^JOHN{}", static_cast<int>(syntax));
        const Volume original = smallVolume();
        const auto files = write(original, place, {.syntax = syntax});
        const auto found = scan(place);
        ASSERT_TRUE(found);
        truncate(files[4], 16);
        const auto volume = load(found->studies.at(0).series.at(0));
        ASSERT_NE(volume, nullptr);
        EXPECT_EQ(volume->provenance().interpolatedSlices, (std::vector<SliceRange>{{4, 4}}));
        EXPECT_NEAR(volume->value(1, 2, 4), 0.5 * (original.value(1, 2, 3) + original.value(1, 2, 5)), 0.5);
        EXPECT_EQ(volume->value(1, 2, 5), original.value(1, 2, 5));
        ASSERT_EQ(volume->provenance().messages.size(), 2u);
        EXPECT_EQ(volume->provenance().messages[0].key, key::kTruncatedFile);
        EXPECT_EQ(volume->provenance().messages[1].key, key::kGapInterpolated);
    }
}

// The stack's own gap is at 3 (it was the fourth); when the first slice is lost as well, it is the third.
TEST(Loader, GapsAreNumberedAsTheVolumeIs) {
    const TemporaryFolder folder;
    const auto files = write(smallVolume(), folder.path());
    fs::remove(files[3]);
    const auto found = scan(folder.path());
    ASSERT_TRUE(found);
    const Series& series = found->studies.at(0).series.at(0);
    ASSERT_TRUE(hasMessage(series, key::kGapInterpolated));
    truncate(files[0], 16);
    const auto volume = load(series);
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(volume->provenance().interpolatedSlices, (std::vector<SliceRange>{{2, 2}}));
    const auto& messages = volume->provenance().messages;
    ASSERT_EQ(messages.back().key, key::kGapInterpolated);
    EXPECT_NE(messages.back().sentence.english().find("3"), std::string::npos) << messages.back().sentence;
    int told = 0;
    for (const Text& sentence : volume->provenance().assumptions) {
        if (sentence.english().find("interpolated") == std::string::npos) continue;
        ++told;
        EXPECT_EQ(sentence, messages.back().sentence);
    }
    EXPECT_EQ(told, 1);
}

// The damage in the following three makes the decoders themselves read or abort where they must not.
TEST(Loader, RleSegmentOutsideTheFile) {
    const TemporaryFolder folder;
    const auto files = write(smallVolume(), folder.path(), {.syntax = WriteSyntax::rle});
    std::string bytes = *readText(files[2]);
    const std::size_t header =
        bytes.find(std::string("\2\0\0\0\x40\0\0\0", 8));  // two segments, the first at 64
    ASSERT_NE(header, std::string::npos);
    bytes.replace(header + 8, 4, "\x7F\x7F\x7F\x7F");
    std::ofstream(files[2], std::ios::binary) << bytes;
    const auto volume = loadFolder(folder.path());
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(volume->provenance().interpolatedSlices, (std::vector<SliceRange>{{2, 2}}));
    ASSERT_EQ(volume->provenance().messages.size(), 2u);
    EXPECT_EQ(volume->provenance().messages[0].key, key::kDamagedFile);
}

TEST(Loader, Jpeg2000InColourWhereTheHeaderSaysGrey) {
    SKIP_WITHOUT_SHARED_DATA();
    const TemporaryFolder folder;
    for (const auto& entry : fs::directory_iterator(sharedData() / "odd/rgb_series_j2k")) {
        const fs::path file = folder.path() / entry.path().filename();
        fs::copy_file(entry.path(), file);
        fs::permissions(file, fs::perms::owner_all);
        setWord(file, tag::kSamplesPerPixel, 1);
        setText(file, tag::kPhotometricInterpretation, "MONOCHROME2");
    }
    const auto found = scan(folder.path());
    ASSERT_TRUE(found);
    const Series& series = found->studies.at(0).series.at(0);
    ASSERT_TRUE(series.canBeVolume()) << keysOf(series);
    Progress progress;
    const auto volume = loadVolume(series, series.stacks.at(0), progress);
    ASSERT_FALSE(volume);
    EXPECT_EQ(volume.error().code, ErrorCode::inputNotUsable);
}

TEST(Loader, Jpeg2000CutOffInsideItsFrame) {
    SKIP_WITHOUT_SHARED_DATA();
    const TemporaryFolder folder;
    std::string bytes = *readText(sharedData() / "odd/transfer_syntaxes" /
                                  "JPEG2000LosslessOnlyTransferSyntax_1.2.840.10008.1.2.4.90.dcm");
    const std::size_t cut = bytes.size() / 2;
    bytes.replace(cut, bytes.size() - 8 - cut, bytes.size() - 8 - cut, '\0');
    std::ofstream(folder / "half", std::ios::binary) << bytes;
    const auto found = scan(folder.path());
    ASSERT_TRUE(found);
    Series series = found->studies.at(0).series.at(0);
    Stack stack = series.stacks.at(0);
    stack.messages.clear();
    stack.slices = {{0, 0, 0.0}};
    stack.worldFromVoxel = glm::dmat4(1.0);
    Progress progress;
    EXPECT_FALSE(loadVolume(series, stack, progress));
}

TEST(Loader, UnknownTransferSyntaxIsNamed) {
    const TemporaryFolder folder;
    write(smallVolume(), folder.path());
    auto found = scan(folder.path());
    ASSERT_TRUE(found);
    Series series = found->studies.at(0).series.at(0);
    Stack stack;
    for (Frame frame : series.stacks.at(0).frames) {
        Instance instance = *frame.instance;
        instance.transferSyntaxUid = "1.2.840.10008.1.2.4.110";
        frame.instance = std::make_shared<Instance>(instance);
        stack.frames.push_back(std::move(frame));
    }
    assess(stack, "CT");
    ASSERT_NE(stack.whyNoVolume(), nullptr);
    EXPECT_EQ(stack.whyNoVolume()->key, key::kUnsupportedTransferSyntax);
    Progress progress;
    const auto volume = loadVolume(series, stack, progress);
    ASSERT_FALSE(volume);
    EXPECT_NE(volume.error().message.english().find("JPEG XL Lossless"), std::string::npos);
    EXPECT_NE(volume.error().message.english().find("1.2.840.10008.1.2.4.110"), std::string::npos);
}

TEST(Loader, CancelStopsWithin200Milliseconds) {
    SKIP_WITHOUT_SHARED_DATA();
    const auto found = scan(sharedData() / "ct_chest_ricord");
    ASSERT_TRUE(found);
    using Clock = std::chrono::steady_clock;
    const CancelToken token;
    Clock::time_point cancelledAt;
    Progress progress(
        [&](const ProgressUpdate& update) {
            if (update.fraction == 0.0 || token.cancelled()) return;
            cancelledAt = Clock::now();
            token.cancel();
        },
        token);
    const Series& series = found->studies.at(0).series.at(0);
    const auto volume = loadVolume(series, series.stacks.at(0), progress);
    const auto returned = Clock::now();
    ASSERT_FALSE(volume);
    EXPECT_EQ(volume.error().code, ErrorCode::cancelled);
    EXPECT_LT(std::chrono::duration<double>(returned - cancelledAt).count(), 0.2);
}

TEST(Loader, BestSeriesIsTheLargestOriginal) {
    const TemporaryFolder folder;
    const auto make = [&](const char* name, int slices, int number, const char* imageType) {
        std::vector<std::uint16_t> voxels(static_cast<std::size_t>(4 * 4 * slices), 100);
        VolumeOptions options;
        options.size = {4, 4, slices};
        options.worldFromVoxel = obliqueAffine();
        options.modality = "CT";
        auto volume = Volume::create(options, std::move(voxels));
        ASSERT_TRUE(volume);
        for (const fs::path& file : write(*volume, folder / name, {.seriesNumber = number})) {
            setText(file, tag::kImageType, imageType);
        }
    };
    make("scout", 60, 1, "ORIGINAL\\PRIMARY\\LOCALIZER");
    make("axial", 30, 2, "ORIGINAL\\PRIMARY\\AXIAL");
    make("thin", 22, 3, "ORIGINAL\\PRIMARY\\AXIAL");
    make("reformatted", 40, 4, "DERIVED\\SECONDARY\\REFORMATTED");
    const auto found = scan(folder.path());
    ASSERT_TRUE(found);
    const ChosenStack best = bestVolume(*found);
    ASSERT_TRUE(best);
    EXPECT_EQ(best.series->number, 2);
    EXPECT_NE(best.why.english().find("4 x 4 x 30"), std::string::npos) << best.why;
}

TEST(Loader, NoBestSeriesSaysWhy) {
    const TemporaryFolder folder;
    const auto files = write(smallVolume(), folder.path());
    for (const std::size_t k : {1, 2, 3, 4}) fs::remove(files[k]);
    const auto found = scan(folder.path());
    ASSERT_TRUE(found);
    for (const fs::path& file : {files[0], files[5]}) remove(file, tag::kPixelSpacing);
    const auto spoiled = scan(folder.path());
    ASSERT_TRUE(spoiled);
    EXPECT_FALSE(bestVolume(*spoiled));
    EXPECT_NE(bestVolume(*spoiled).why.english().find("how large a pixel is"), std::string::npos)
        << bestVolume(*spoiled).why;
}

TEST(Loader, LogHoldsNoPatientData) {
    const TemporaryFolder folder;
    const auto files = write(smallVolume(), folder / "DOE^JOHN");
    truncate(files[0], 10);
    std::ofstream(folder / "DOE^JOHN/DOE.dcm")
        << std::string(128, '\0') << "DICM" << std::string(400, '\x7F');
    log::setLevel(log::Level::debug);
    testing::internal::CaptureStderr();
    Progress progress;
    const auto found = scanFolder(folder.path(), progress);
    if (found) {
        const Series& series = found->studies.at(0).series.at(0);
        (void)loadVolume(series, series.stacks.at(0), progress);
    }
    const std::string output = testing::internal::GetCapturedStderr();
    log::setLevel(log::Level::warning);
    EXPECT_NE(output.find("skipped"), std::string::npos);        // the log was on
    EXPECT_EQ(output.find("Dcm"), std::string::npos) << output;  // and DCMTK's own was not
    for (const char* secret : {"DOE", "JOHN", "PHANTOM^MACULA", "2.25."}) {
        EXPECT_EQ(output.find(secret), std::string::npos) << output;
    }
}

}  // namespace
}  // namespace macula::dicom::test
