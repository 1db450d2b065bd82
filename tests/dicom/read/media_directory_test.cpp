#include "dicom/read/media_directory.h"

#include <fstream>

#include "bytes.h"
#include "support.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDirectoryClass = "1.2.840.10008.1.3.10";

std::string record(const std::string& file, int inUse = 0xFFFF) {
    return shortElement({0x0004, 0x1410}, "US", bytesOf(inUse, 2)) +
           (file.empty() ? "" : shortElement({0x0004, 0x1500}, "CS", file));
}

// The SOP class stands in the file meta information only.
std::string mediaDirectory(const std::vector<std::string>& records) {
    const std::string meta = shortElement({0x0002, 0x0002}, "UI", kDirectoryClass) +
                             shortElement({0x0002, 0x0010}, "UI", kExplicit);
    return std::string(128, '\0') + "DICM" + shortElement({0x0002, 0x0000}, "UL", bytesOf(meta.size(), 4)) +
           meta + shortElement({0x0004, 0x1130}, "CS", "DISC") + sequence({0x0004, 0x1220}, records);
}

class MediaDirectoryTest : public testing::Test {
  protected:
    void touch(const std::string& name) {
        fs::create_directories((folder / name).parent_path());
        std::ofstream(folder / name) << 'x';
    }
    MediaDirectory read(const std::vector<std::string>& records) {
        std::ofstream(folder / "DICOMDIR", std::ios::binary) << mediaDirectory(records);
        auto directory = readMediaDirectory(folder / "DICOMDIR");
        EXPECT_TRUE(directory);
        return directory ? *directory : MediaDirectory{};
    }

    TemporaryFolder folder;
};

using Paths = std::vector<fs::path>;

Paths missingIn(const MediaDirectory& directory) {
    Paths paths;
    for (const ListedFile& listed : directory.missing) paths.push_back(listed.file);
    return paths;
}

TEST(MediaDirectory, OfARealDisc) {
    SKIP_WITHOUT_SHARED_DATA();
    const fs::path disc = sharedData() / "odd/dicomdir_media";
    const auto directory = readMediaDirectory(disc / "DICOMDIR");
    ASSERT_TRUE(directory);
    EXPECT_EQ(directory->files.size(), 31u);
    EXPECT_TRUE(directory->missing.empty());
    EXPECT_EQ(directory->outside, 0u);
    std::size_t onDisk = 0;
    for (const auto& entry : fs::recursive_directory_iterator(disc)) onDisk += entry.is_regular_file();
    EXPECT_EQ(onDisk, 31u + 2u) << "DICOMDIR and README.txt";
    EXPECT_EQ(directory->files.front(), disc / "77654033/CR1/6154");
}

TEST_F(MediaDirectoryTest, MissingFilesAreTold) {
    touch("A/IM1");
    const auto directory =
        read({record("A\\IM1"), record("A\\IM2"), record("B\\IM1"), record(""), record("A\\IM2")});
    EXPECT_EQ(directory.files, Paths{folder / "A/IM1"});
    EXPECT_EQ(missingIn(directory), (Paths{folder / "A/IM2", folder / "B/IM1"}));
    EXPECT_EQ(directory.outside, 0u);
}

TEST_F(MediaDirectoryTest, NamesAsDiscsChangeThem) {
    for (const char* name : {"dicom/im1", "dicom/im2.;1", "dicom/IM3;1", "dicom/IM4", "dicom/im4"})
        touch(name);
    const auto directory =
        read({record("DICOM\\IM1"), record("DICOM\\IM2"), record("DICOM\\IM3"), record("DICOM\\IM4"),
              record("dicom\\im1;1"), record("DICOM/IM1"), record(".\\DICOM\\IM1")});
    EXPECT_EQ(directory.files, (Paths{folder / "dicom/IM3;1", folder / "dicom/IM4", folder / "dicom/im1",
                                      folder / "dicom/im2.;1"}));
    EXPECT_TRUE(directory.missing.empty());
}

// Programs that copy media add endings, or take them off.
TEST_F(MediaDirectoryTest, EndingsMayComeAndGo) {
    for (const char* name :
         {"A/IM1.dcm", "A/im2.DCM;1", "A/IM3", "A/IM4.txt", "A/IM4.dcm", "A/IM5.txt", "A/IM5"})
        touch(name);
    const auto directory = read({record("A\\IM1"), record("A\\IM2"), record("A\\IM3.DCM"), record("A\\IM4"),
                                 record("A\\IM5"), record("A\\IM6")});
    EXPECT_EQ(directory.files, (Paths{folder / "A/IM1.dcm", folder / "A/IM3", folder / "A/IM4.dcm",
                                      folder / "A/IM5", folder / "A/im2.DCM;1"}));
    EXPECT_EQ(missingIn(directory), Paths{folder / "A/IM6"});
}

// Records of two series, stored in turns: only offsets say which image is of which.
TEST_F(MediaDirectoryTest, AnImageIsOfTheSeriesThatLeadsToIt) {
    const auto item = [](const std::string& type, std::uint32_t next, std::uint32_t lower,
                         const std::string& more) {
        return shortElement({0x0004, 0x1400}, "UL", bytesOf(next, 4)) +
               shortElement({0x0004, 0x1410}, "US", bytesOf(0xFFFF, 2)) +
               shortElement({0x0004, 0x1420}, "UL", bytesOf(lower, 4)) +
               shortElement({0x0004, 0x1430}, "CS", type) + more;
    };
    const auto series = [&](const std::string& uid, std::uint32_t next, std::uint32_t lower) {
        return item("SERIES", next, lower, shortElement({0x0020, 0x000E}, "UI", uid));
    };
    const auto image = [&](const std::string& file, const std::string& uid, const std::string& number,
                           std::uint32_t next) {
        return item("IMAGE ", next, 0,
                    shortElement({0x0004, 0x1500}, "CS", file) + shortElement({0x0004, 0x1511}, "UI", uid) +
                        shortElement({0x0020, 0x0013}, "IS", number));
    };
    const auto records = [&](const std::vector<std::uint32_t>& at) {
        return std::vector<std::string>{series("2.25.1", at[1], at[3]), series("2.25.2", 0, at[2]),
                                        image("B1", "2.25.21", "31", 0), image("A1", "2.25.11", "7 ", at[4]),
                                        image("A2", "2.25.12", "8 ", 0)};
    };
    // All items have a length of their own, whatever the offsets are.
    std::vector<std::uint32_t> at(5, 0);
    const std::string first = records(at)[0];
    std::uint32_t next = static_cast<std::uint32_t>(mediaDirectory(records(at)).find(first)) - 8;
    for (std::size_t i = 0; i < at.size(); ++i) {
        at[i] = next;
        next += 8 + static_cast<std::uint32_t>(records(at)[i].size());
    }
    const auto directory = read(records(at));
    ASSERT_EQ(directory.missing.size(), 3u);
    const ListedFile& a2 = directory.missing[1];
    EXPECT_EQ(a2.file, folder / "A2");
    EXPECT_EQ(a2.sopInstanceUid, "2.25.12");
    EXPECT_EQ(a2.seriesInstanceUid, "2.25.1");
    EXPECT_EQ(a2.instanceNumber, 8);
    EXPECT_EQ(directory.missing[0].seriesInstanceUid, "2.25.1");
    EXPECT_EQ(directory.missing[2].seriesInstanceUid, "2.25.2");
    EXPECT_EQ(directory.missing[2].instanceNumber, 31);
}

TEST_F(MediaDirectoryTest, WhatLiesOutsideIsNeverLookedAt) {
    const TemporaryFolder elsewhere;
    std::ofstream(elsewhere / "secret") << 'x';
    touch("A/IM1");
    fs::create_directory_symlink(elsewhere.path(), folder / "LINK");
    fs::create_symlink(elsewhere / "secret", folder / "FILE");
    const std::string up = "..\\" + elsewhere.path().filename().string() + "\\secret";
    const auto directory =
        read({record(up), record("A\\..\\..\\x"), record("\\etc\\passwd"), record("/etc/passwd"),
              record("A\\..\\A\\IM1"), record("C:\\IM1"), record("LINK\\secret"), record("FILE"),
              record("A/../../x"), record("LINK\\nothing")});
    EXPECT_TRUE(directory.files.empty());
    EXPECT_TRUE(directory.missing.empty());
    EXPECT_EQ(directory.outside, 10u);
}

TEST_F(MediaDirectoryTest, RecordsNotInUseAreNone) {
    const auto directory = read({record("IM1", 0)});
    EXPECT_TRUE(directory.missing.empty());
}

TEST_F(MediaDirectoryTest, FoldersAreNoFiles) {
    touch("A/IM1");
    const auto directory = read({record("A"), record("A\\IM1\\IM2")});
    EXPECT_EQ(missingIn(directory), (Paths{folder / "A", folder / "A/IM1/IM2"}));
}

TEST_F(MediaDirectoryTest, WhatIsNoDirectory) {
    EXPECT_FALSE(readMediaDirectory(folder / "DICOMDIR"));
    const auto files = write(smallVolume(), folder / "in");
    EXPECT_FALSE(readMediaDirectory(files[0]));
    std::ofstream(folder / "DICOMDIR") << "no DICOM";
    EXPECT_FALSE(readMediaDirectory(folder / "DICOMDIR"));
}

}  // namespace
}  // namespace macula::dicom::test
