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

TEST(MediaDirectory, ofARealDisc) {
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

TEST_F(MediaDirectoryTest, missingFilesAreTold) {
    touch("A/IM1");
    const auto directory =
        read({record("A\\IM1"), record("A\\IM2"), record("B\\IM1"), record(""), record("A\\IM2")});
    EXPECT_EQ(directory.files, Paths{folder / "A/IM1"});
    EXPECT_EQ(directory.missing, (Paths{folder / "A/IM2", folder / "B/IM1"}));
    EXPECT_EQ(directory.outside, 0u);
}

TEST_F(MediaDirectoryTest, namesAsDiscsChangeThem) {
    for (const char* name : {"dicom/im1", "dicom/im2.;1", "dicom/IM3;1", "dicom/IM4", "dicom/im4"})
        touch(name);
    const auto directory =
        read({record("DICOM\\IM1"), record("DICOM\\IM2"), record("DICOM\\IM3"), record("DICOM\\IM4"),
              record("dicom\\im1;1"), record("DICOM/IM1"), record(".\\DICOM\\IM1")});
    EXPECT_EQ(directory.files, (Paths{folder / "dicom/IM3;1", folder / "dicom/IM4", folder / "dicom/im1",
                                      folder / "dicom/im2.;1"}));
    EXPECT_TRUE(directory.missing.empty());
}

TEST_F(MediaDirectoryTest, whatLiesOutsideIsNeverLookedAt) {
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

TEST_F(MediaDirectoryTest, recordsNotInUseAreNone) {
    const auto directory = read({record("IM1", 0)});
    EXPECT_TRUE(directory.missing.empty());
}

TEST_F(MediaDirectoryTest, foldersAreNoFiles) {
    touch("A/IM1");
    const auto directory = read({record("A"), record("A\\IM1\\IM2")});
    EXPECT_EQ(directory.missing, (Paths{folder / "A", folder / "A/IM1/IM2"}));
}

TEST_F(MediaDirectoryTest, whatIsNoDirectory) {
    EXPECT_FALSE(readMediaDirectory(folder / "DICOMDIR"));
    const auto files = write(smallVolume(), folder / "in");
    EXPECT_FALSE(readMediaDirectory(files[0]));
    std::ofstream(folder / "DICOMDIR") << "no DICOM";
    EXPECT_FALSE(readMediaDirectory(folder / "DICOMDIR"));
}

}  // namespace
}  // namespace macula::dicom::test
