#include "dicom/scan.h"

#include <fstream>

#include "dicom/scan_failure.h"
#include "edit.h"
#include "support.h"
#include "synthetic.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;

Error scanError(const fs::path& path) {
    Progress progress;
    auto result = scanFolder(path, progress);
    if (result) {
        ADD_FAILURE() << "no error for " << path;
        return {};
    }
    EXPECT_FALSE(result.error().message.empty());
    EXPECT_FALSE(result.error().hint.empty());
    return result.error();
}

TEST(Scan, MissingFolder) {
    const Error error = scanError("/nowhere/DOE^JOHN");
    EXPECT_EQ(error.code, ErrorCode::inputNotUsable);
    EXPECT_NE(error.message.english().find("does not exist"), std::string::npos);
    EXPECT_EQ((error.message.english() + error.hint.english()).find("DOE"), std::string::npos);
}

// In a folder of somebody else, as a service meets it: what one may not look at is not said to be missing.
TEST(Scan, WhatMayNotBeLookedAtIsNotCalledMissing) {
    const TemporaryFolder folder;
    const std::filesystem::path closed = folder / "closed";
    std::filesystem::create_directories(closed / "study");
    std::filesystem::permissions(closed, std::filesystem::perms::none);
    Error error;
    {
        const WithoutRootsRights nobody;
        error = scanError(closed / "study");
    }
    std::filesystem::permissions(closed, std::filesystem::perms::owner_all);
    EXPECT_EQ(error.message, "The folder cannot be read.");
    EXPECT_NE(error.hint.english().find("permissions"), std::string::npos);
}

TEST(Scan, FolderWithoutDicom) {
    const TemporaryFolder folder;
    std::ofstream(folder / "notes.dcm")
        << "The name says DICOM, the content does not. " << std::string(500, 'x');
    std::ofstream(folder / "empty.dcm") << "";
    std::ofstream(folder / "._IM00001.dcm")
        << std::string("\0\5\x16\7\0\2\0\0Mac OS X        ", 24) << std::string(300, '\0');
    EXPECT_NE(scanError(folder.path()).message.english().find("no DICOM image among the 2 files"),
              std::string::npos);
    EXPECT_NE(scanError(folder / "notes.dcm").message.english().find("not a DICOM image"), std::string::npos);
}

TEST(Scan, FolderOfOneFileThatIsNoDicom) {
    const TemporaryFolder folder;
    std::ofstream(folder / "letter.txt") << "A letter. " << std::string(500, 'x');
    EXPECT_EQ(scanError(folder.path()).message,
              "There is no DICOM image in this folder: the only file in it is none.");
    EXPECT_EQ(scanError(folder / "letter.txt").message, "The file is not a DICOM image.");
}

TEST(Scan, FolderOfOneArchive) {
    const TemporaryFolder folder;
    std::ofstream(folder / "study.zip", std::ios::binary) << "PK\x03\x04" << std::string(500, 'x');
    for (const fs::path& path : {folder.path(), folder / "study.zip"}) {
        const Error error = scanError(path);
        EXPECT_NE(error.message.english().find("archive"), std::string::npos) << error.message;
        EXPECT_NE(error.hint.english().find("npack"), std::string::npos) << error.hint;
    }
}

// By what they begin with, and by names that leave it open.
TEST(Scan, ArchivesOfEachKindAreNamed) {
    struct Case {
        std::string name;
        std::string begin;
        std::string kind;
    };
    const std::string tar = std::string(257, 'x') + "ustar";
    using namespace std::string_literals;
    for (const Case& c : std::vector<Case>{{"study", "PK\x03\x04", "zip"},
                                           {"IM1.dcm.gz", "\x1f\x8b\x08", "gzip"},
                                           {"IM1.dcm", "\x1f\x8b\x08", "gzip"},
                                           {"study.tgz", "\x1f\x8b\x08", "gzip"},
                                           {"study.tar", tar, "tar"},
                                           {"study", tar, "tar"},
                                           {"study.7z", "7z\xbc\xaf\x27\x1c", "7z"},
                                           {"study.RAR", "Rar!\x1a\x07", "RAR"},
                                           {"study.tar.xz", "\xfd"s + "7zXZ\0"s, "xz"},
                                           {"study.tar.bz2", "BZh9", "bzip2"},
                                           {"study.tar.zst", "\x28\xb5\x2f\xfd", "Zstandard"}}) {
        SCOPED_TRACE(c.name);
        const TemporaryFolder folder;
        std::ofstream(folder / c.name, std::ios::binary) << c.begin << std::string(500, 'x');
        const Error error = scanError(folder.path());
        EXPECT_NE(error.message.english().find("archive (" + c.kind + ")"), std::string::npos)
            << error.message;
        EXPECT_NE(error.hint.english().find("npack"), std::string::npos) << error.hint;
    }
    for (const char* name : {"letter.docx", "viewer.jar", "volume.nii.gz", "setup.exe"}) {
        const TemporaryFolder folder;
        std::ofstream(folder / name, std::ios::binary) << "PK\x03\x04" << std::string(500, 'x');
        EXPECT_EQ(scanError(folder.path()).message.english().find("archive"), std::string::npos) << name;
    }
}

TEST(Scan, ALoneDirectoryOfAMediumSaysWhatIsNotThere) {
    const TemporaryFolder folder;
    writeDirectory(folder / "DICOMDIR", {"IMAGES\\A", "IMAGES\\B", "IMAGES\\C"});
    for (const fs::path& path : {folder.path(), folder / "DICOMDIR"}) {
        const Error error = scanError(path);
        EXPECT_NE(error.message.english().find("none of the 3 files that it lists"), std::string::npos)
            << error.message;
        EXPECT_NE(error.hint.english().find("Copy the whole medium"), std::string::npos) << error.hint;
    }
}

TEST(Scan, WhereNothingCanBeReadEachReasonIsNamed) {
    const TemporaryFolder folder;
    const auto files = write(smallVolume(), folder.path());
    ASSERT_EQ(files.size(), 6u);
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (i < 4) {
            remove(files[i], tag::kPixelData);
        } else {
            fs::resize_file(files[i], 200);
        }
    }
    const Error error = scanError(folder.path());
    EXPECT_EQ(error.message,
              "None of the 6 DICOM files in this folder can be read: 4 without pixel data, 2 damaged, or not "
              "written "
              "as they say.");
    EXPECT_FALSE(error.hint.empty());
}

// No file here gives an error of input and output; what is said of one is (Dataset.FilesThatAreElsewhere has
// the errno).
TEST(Scan, AMediumThatGivesErrorsIsNotCalledOffline) {
    Scan scan;
    FolderListing listing;
    for (const char* name : {"IM1", "IM2"}) {
        listing.files.emplace_back(name);
        scan.skipped.push_back({name, message(key::kUnreadableMedium), {}});
    }
    const Error of2 = nothingFound(scan, "disc", listing);
    EXPECT_EQ(
        of2.message,
        "None of the 2 DICOM files in this folder can be read: 2 on a medium that cannot be read there.");
    EXPECT_NE(of2.hint.english().find("Clean the disc"), std::string::npos) << of2.hint;
    listing.files.pop_back();
    scan.skipped.pop_back();
    EXPECT_NE(nothingFound(scan, "disc", listing).message.english().find("medium gave an error"),
              std::string::npos);
}

TEST(Scan, PathsThatAreTooLongAreNotAMatterOfPermissions) {
    const std::string deep = "/" + std::string(5000, 'x');
    EXPECT_NE(scanError(deep).message.english().find("longer than this system can open"), std::string::npos);

    // Made step by step: no system call is given the whole path.
    const TemporaryFolder folder;
    const fs::path before = fs::current_path();
    write(smallVolume(), folder.path());
    fs::current_path(folder.path());
    const std::string name(200, 'd');
    for (int level = 0; level < 25; ++level) {
        fs::create_directory(name);
        fs::current_path(name);
    }
    std::ofstream("IM1") << "x";
    fs::current_path(before);
    const auto found = scan(folder.path());
    ASSERT_TRUE(found);
    ASSERT_EQ(found->skipped.size(), 1u);
    EXPECT_EQ(found->skipped[0].message.key, key::kPathTooLong);
}

TEST(Scan, EmptyFolder) {
    const TemporaryFolder folder;
    EXPECT_EQ(scanError(folder.path()).code, ErrorCode::inputNotUsable);
    EXPECT_EQ(scanError(folder.path()).message, "There is no file in this folder.");
}

TEST(Scan, ContentDecidesAndOneBadFileStopsNothing) {
    const TemporaryFolder folder;
    const auto files = write(smallVolume(), folder / "deep/er");
    fs::rename(files[0], folder / "readme.txt");
    std::ofstream(folder / "report.dcm") << "no DICOM";
    std::ofstream damaged(folder / "broken", std::ios::binary);
    damaged << std::string(128, '\0') << "DICM" << std::string(400, '\x7F');
    damaged.close();
    const auto found = scan(folder.path());
    ASSERT_TRUE(found);
    ASSERT_EQ(found->studies.size(), 1u);
    ASSERT_EQ(found->studies[0].series.size(), 1u);
    const Series& series = found->studies[0].series[0];
    EXPECT_EQ(series.instances, 6u);
    EXPECT_TRUE(series.canBeVolume()) << keysOf(series);
    EXPECT_EQ(found->notDicom, 1u);
    EXPECT_EQ(found->filesSeen, 8u);
    ASSERT_EQ(found->skipped.size(), 1u);
    EXPECT_EQ(found->skipped[0].message.key, key::kDamagedFile);
}

TEST(Scan, WhatInfoShows) {
    const TemporaryFolder folder;
    write(smallVolume(affine({0, 0.5, 0}, {0, 0, -0.75}, {-2, 0, 0}, {10, 20, 30}), {1.0, 0.0}, "MR"),
          folder.path(), {.seriesDescription = "Täst", .seriesNumber = 7});
    const auto found = scan(folder.path());
    ASSERT_TRUE(found);
    const Study& study = found->studies.at(0);
    const Series& series = study.series.at(0);
    EXPECT_EQ(study.date, "20000101");
    EXPECT_EQ(study.patientId, "MACULA-PHANTOM");
    EXPECT_EQ(series.modality, "MR");
    EXPECT_EQ(series.description, "Täst");
    EXPECT_EQ(series.number, 7);
    const Stack& stack = series.stacks.at(0);
    EXPECT_EQ(stack.columns, 5);
    EXPECT_EQ(stack.rows, 4);
    EXPECT_EQ(stack.slices.size(), 6u);
    EXPECT_EQ(stack.orientation, "PIR");
    EXPECT_EQ(series.patientPosition, "HFS");
    EXPECT_EQ(series.transferSyntaxUids, std::vector<std::string>{"1.2.840.10008.1.2.1"});
    ASSERT_TRUE(stack.spacingMm);
    EXPECT_EQ(*stack.spacingMm, glm::dvec3(0.5, 0.75, 2.0));
    EXPECT_EQ(*stack.firstPositionMm, glm::dvec3(10, 20, 30));
    EXPECT_EQ(*stack.lastPositionMm, glm::dvec3(0, 20, 30));
}

TEST(Scan, ResultDoesNotDependOnNames) {
    const TemporaryFolder folder;
    const auto files = write(smallVolume(), folder.path());
    const auto before = scan(folder.path());
    for (std::size_t k = 0; k < files.size(); ++k) fs::rename(files[k], folder / std::string(1, "qawszx"[k]));
    const auto after = scan(folder.path());
    ASSERT_TRUE(before && after);
    for (std::size_t k = 0; k < files.size(); ++k) {
        EXPECT_EQ(before->studies[0].series[0].stacks[0].frames[k].instance->sopInstanceUid,
                  after->studies[0].series[0].stacks[0].frames[k].instance->sopInstanceUid);
    }
}

TEST(Scan, SymbolicLinkLoop) {
    const TemporaryFolder folder;
    write(smallVolume(), folder / "a");
    fs::create_directory_symlink(folder.path(), folder / "a/loop");
    const auto found = scan(folder.path());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->filesSeen, 6u);
}

TEST(Scan, AFileTwiceIsOneSlice) {
    const TemporaryFolder folder;
    const auto files = write(smallVolume(), folder.path());
    fs::copy_file(files[2], folder / "copy of slice");
    const auto found = scan(folder.path());
    ASSERT_TRUE(found);
    const Series& series = found->studies.at(0).series.at(0);
    EXPECT_EQ(series.instances, 6u);
    EXPECT_TRUE(series.canBeVolume());
    EXPECT_TRUE(hasMessage(series, key::kDuplicateFiles));
}

TEST(Scan, SameUidButOtherContentIsNeverDropped) {
    const TemporaryFolder folder;
    const auto files = write(smallVolume(), folder.path());
    fs::copy_file(files[2], folder / "changed");
    setPixels(folder / "changed", std::vector<std::uint16_t>(20, 77));
    const auto found = scan(folder.path());
    ASSERT_TRUE(found);
    const Series& series = found->studies.at(0).series.at(0);
    EXPECT_EQ(series.instances, 7u);
    EXPECT_TRUE(hasMessage(series, key::kDuplicateInstances));
    ASSERT_EQ(series.stacks.size(), 2u);
    EXPECT_EQ(series.stacks[0].frames.size(), 6u);
    EXPECT_TRUE(series.stacks[0].canBeVolume());
    EXPECT_EQ(series.stacks[1].frames.size(), 1u);
}

TEST(Scan, TwoPatientsAreNeverOneSeries) {
    const TemporaryFolder folder;
    const auto files = write(smallVolume(), folder.path());
    setText(files[5], tag::kPatientId, "SOMEONE-ELSE");
    const auto found = scan(folder.path());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->studies.size(), 2u);
}

TEST(Scan, MissingSliceIsInterpolatedAndToldOf) {
    const TemporaryFolder folder;
    const auto files = write(smallVolume(), folder.path());
    fs::remove(files[3]);
    const auto found = scan(folder.path());
    ASSERT_TRUE(found);
    const Series& series = found->studies.at(0).series.at(0);
    EXPECT_TRUE(series.canBeVolume());
    EXPECT_TRUE(hasMessage(series, key::kMissingSlices));
    EXPECT_TRUE(hasMessage(series, key::kGapInterpolated));
    EXPECT_EQ(series.stacks.at(0).slices.size(), 6u);
    EXPECT_TRUE(series.stacks.at(0).slices[3].interpolated());
}

TEST(Scan, TruncatedSliceIsToldOfInItsSeries) {
    const TemporaryFolder folder;
    const auto files = write(smallVolume(), folder.path());
    truncate(files[0], 12);
    const auto found = scan(folder.path());
    ASSERT_TRUE(found);
    const Series& series = found->studies.at(0).series.at(0);
    EXPECT_EQ(series.instances, 5u);
    EXPECT_TRUE(hasMessage(series, key::kTruncatedFile));
    ASSERT_EQ(found->skipped.size(), 1u);
    EXPECT_EQ(found->skipped[0].message.key, key::kTruncatedFile);
    EXPECT_EQ(found->skipped[0].file, files[0]);
}

TEST(Scan, WithoutPreambleAndMetaInformation) {
    const TemporaryFolder folder;
    const Volume volume = smallVolume();
    for (const fs::path& file : write(volume, folder.path())) saveBare(file);
    const auto read = loadFolder(folder.path());
    ASSERT_NE(read, nullptr);
    expectSameValues(*read, volume);
}

// One image of six that does not fit is not in the volume, and the series says what was separated and why
// not.
TEST(Scan, AnImageThatDoesNotFitIsSetApart) {
    struct Case {
        std::string_view key;
        std::function<void(const fs::path&)> spoil;
    };
    const std::vector<Case> cases{
        {key::kNoPosition, [](const fs::path& f) { remove(f, tag::kImagePositionPatient); }},
        {key::kMalformedNumbers,
         [](const fs::path& f) { setText(f, tag::kImageOrientationPatient, "1\\0\\0\\0\\1"); }},
        {key::kNoPixelSpacing, [](const fs::path& f) { remove(f, tag::kPixelSpacing); }},
        {key::kInvalidOrientation, [](const fs::path& f) { setText(f, tag::kPixelSpacing, "0\\1"); }},
        {key::kInconsistentOrientation,
         [](const fs::path& f) { setText(f, tag::kImageOrientationPatient, "1\\0\\0\\0\\1\\0"); }},
        {key::kInconsistentPixelSpacing, [](const fs::path& f) { setText(f, tag::kPixelSpacing, "3\\3"); }},
        {key::kInconsistentSize, [](const fs::path& f) { setWord(f, tag::kRows, 2); }},
        {key::kInconsistentPosition,
         [](const fs::path& f) { setText(f, tag::kFrameOfReferenceUid, "1.2.3"); }},
        {key::kSplitSeries,
         [](const fs::path& f) { setText(f, tag::kPhotometricInterpretation, "PALETTE COLOR"); }},
    };
    for (const Case& c : cases) {
        SCOPED_TRACE(c.key);
        const TemporaryFolder folder;
        c.spoil(write(smallVolume(), folder.path())[2]);
        const auto found = scan(folder.path());
        ASSERT_TRUE(found);
        const Series& series = found->studies.at(0).series.at(0);
        EXPECT_TRUE(hasMessage(series, c.key)) << keysOf(series);
        ASSERT_EQ(series.stacks.size(), 2u) << keysOf(series);
        for (const Stack& stack : series.stacks) {
            EXPECT_EQ(stack.canBeVolume(), stack.frames.size() == 5);
            EXPECT_FALSE(stack.splitBy.empty());
        }
    }
}

TEST(Scan, HeadersThatMakeNoVolume) {
    struct Case {
        std::string_view key;
        std::function<void(const fs::path&)> spoil;
    };
    const std::vector<Case> cases{
        {key::kUnsupportedBits, [](const fs::path& f) { setWord(f, tag::kHighBit, 20); }},
        {key::kInvalidRescale, [](const fs::path& f) { setText(f, tag::kRescaleSlope, "0"); }},
        {key::kInvalidRescale, [](const fs::path& f) { setText(f, tag::kRescaleIntercept, "many"); }},
    };
    for (const Case& c : cases) {
        SCOPED_TRACE(c.key);
        const TemporaryFolder folder;
        for (const fs::path& file : write(smallVolume(), folder.path())) c.spoil(file);
        const auto found = scan(folder.path());
        ASSERT_TRUE(found);
        const Series& series = found->studies.at(0).series.at(0);
        EXPECT_TRUE(hasMessage(series, c.key)) << keysOf(series);
        EXPECT_FALSE(series.canBeVolume());
        Progress progress;
        const auto volume = loadVolume(series, series.stacks.at(0), progress);
        ASSERT_FALSE(volume);
        EXPECT_EQ(volume.error().code, ErrorCode::inputNotUsable);
    }
}

TEST(Scan, Cancelled) {
    const TemporaryFolder folder;
    write(smallVolume(), folder.path());
    Progress progress;
    progress.token().cancel();
    const auto found = scanFolder(folder.path(), progress);
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().code, ErrorCode::cancelled);
}

TEST(Scan, RealOddFiles) {
    SKIP_WITHOUT_SHARED_DATA();
    const fs::path odd = sharedData() / "odd";
    const auto found = scan(odd);
    ASSERT_TRUE(found);
    std::vector<std::string> others;
    for (const Study& study : found->studies) {
        for (const Series& series : study.series) {
            for (std::size_t i = 0; i < series.objects.size(); ++i) others.push_back(series.modality);
        }
    }
    EXPECT_EQ(std::count(others.begin(), others.end(), "RTSTRUCT"), 2);
    EXPECT_EQ(std::count(others.begin(), others.end(), "SEG"), 2);
    const auto skipped = [&](const char* name) {
        const auto at = std::find_if(found->skipped.begin(), found->skipped.end(),
                                     [&](const SkippedFile& s) { return s.file.filename() == name; });
        return at == found->skipped.end() ? std::string() : at->message.key;
    };
    EXPECT_EQ(skipped("truncated_mr.dcm"), key::kTruncatedFile);
    for (const Study& study : found->studies) {
        for (const Series& series : study.series) {
            if (series.stacks.empty()) {
                EXPECT_FALSE(series.messages.empty());
            }
            for (const Stack& stack : series.stacks) {
                EXPECT_EQ(stack.canBeVolume(), stack.whyNoVolume() == nullptr) << keysOf(series);
            }
        }
    }
    EXPECT_NE(scanError(odd / "truncated_mr.dcm").message.english().find("ends before its pixel data"),
              std::string::npos);
    const auto single = [&](const char* name) { return scan(odd / name)->studies.at(0).series.at(0); };
    EXPECT_TRUE(hasMessage(single("rgb_series_j2k"), key::kColourImage));
    EXPECT_TRUE(hasMessage(single("rgb_secondary_capture.dcm"), key::kColourImage));
    EXPECT_TRUE(single("enhanced_ct_2frame.dcm").canBeVolume());
    EXPECT_TRUE(hasMessage(single("enhanced_mr_10frame.dcm"), key::kMultiFrameNoPosition));
    EXPECT_TRUE(hasMessage(single("ct_localizer_scout.dcm"), key::kSingleSlice));
    EXPECT_TRUE(isLocalizer(single("ct_localizer_scout.dcm").stacks.at(0)));
    EXPECT_TRUE(hasMessage(single("monochrome1_dx.dcm"), key::kNoPosition))
        << keysOf(single("monochrome1_dx.dcm"));
    EXPECT_TRUE(hasMessage(single("no_preamble_ct.dcm"), key::kSingleSlice));
    EXPECT_TRUE(hasMessage(single("transfer_syntaxes"), key::kDuplicateInstances));
}

TEST(Scan, NamesInOtherAlphabetsAreUtf8) {
    SKIP_WITHOUT_SHARED_DATA();
    const auto name = [](const char* file) {
        const HeaderFile read = readHeader(sharedData() / "odd/charsets" / file);
        return read.header ? read.header->text(tag::kPatientName).value_or("") : std::string();
    };
    EXPECT_EQ(name("chrX1.dcm"), "Wang^XiaoDong=王^小東=");
    EXPECT_EQ(name("chrH31.dcm"), "Yamada^Tarou=山田^太郎=やまだ^たろう");
    EXPECT_EQ(name("chrRuss.dcm"), "Люкceмбypг");
    EXPECT_EQ(name("chrArab.dcm"), "قباني^لنزار");
    EXPECT_EQ(name("chrKoreanMulti.dcm"), "김희중");
}

TEST(Scan, TellsOfStudiesWhileTheyAreRead) {
    const TemporaryFolder folder;
    write(smallVolume(), folder / "a", {.seriesDescription = "First", .seriesNumber = 3});
    std::vector<Scan> glimpses;
    Progress progress;
    const auto found = scanFolder(folder.path(), progress,
                                  {.glimpsed = [&](Scan seen) { glimpses.push_back(std::move(seen)); }});
    ASSERT_TRUE(found);
    ASSERT_FALSE(glimpses.empty());  // the first comes with the first header
    std::size_t images = 0;
    for (const Scan& seen : glimpses) {
        ASSERT_EQ(seen.studies.size(), 1u);
        EXPECT_EQ(seen.patients, 1);
        EXPECT_EQ(seen.studies[0].patientId, found->studies[0].patientId);
        EXPECT_EQ(seen.studies[0].date, found->studies[0].date);
        ASSERT_EQ(seen.studies[0].series.size(), 1u);
        const Series& series = seen.studies[0].series[0];
        EXPECT_EQ(series.description, "First");
        EXPECT_EQ(series.number, 3);
        EXPECT_TRUE(series.stacks.empty());
        EXPECT_GT(series.instances, images);
        images = series.instances;
    }
    EXPECT_LE(images, found->studies[0].series[0].instances);
}

TEST(Scan, AGlimpseShowsNothingOfFilesThatAreNoDicom) {
    const TemporaryFolder folder;
    std::ofstream(folder / "notes.txt") << std::string(500, 'x');
    int glimpses = 0;
    Progress progress;
    EXPECT_FALSE(scanFolder(folder.path(), progress, {.glimpsed = [&](const Scan&) { ++glimpses; }}));
    EXPECT_EQ(glimpses, 0);
}

}  // namespace
}  // namespace macula::dicom::test
