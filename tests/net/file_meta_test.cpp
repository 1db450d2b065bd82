// The first bytes of a DICOM file: what they say, and what no hostile ones can do.
#include "net/archive/file_meta.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "dicom/support.h"
#include "dicom/synthetic.h"

namespace macula::net {
namespace {

std::string bytesOfFile(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::optional<FileMeta> metaOf(const std::string& bytes) {
    return fileMetaOf(std::as_bytes(std::span(bytes)));
}

std::string element(char number, const std::string& vr, const std::string& value) {
    std::string bytes{2, 0, number, 0};
    bytes += vr;
    if (vr == "OB") bytes += std::string(2, '\0');
    bytes += static_cast<char>(value.size() & 0xff);
    bytes += static_cast<char>(value.size() >> 8 & 0xff);
    if (vr == "OB" || vr.empty()) bytes += std::string(2, '\0');
    return bytes + value;
}

const std::string kBegin = std::string(128, '\0') + "DICM";
const std::string kData("\x08\0\x16\0UI\2\0001\0", 10);

TEST(FileMeta, IsThatOfAFileOfDcmtk) {
    const dicom::test::TemporaryFolder folder;
    dicom::test::SyntheticSeries series;
    series.size = {2, 2, 1};
    const auto file = dicom::test::writeFiles(folder.path(), series).front();
    const auto meta = readFileMeta(file);
    ASSERT_TRUE(meta.ok());
    EXPECT_EQ(meta->sopClassUid, "1.2.840.10008.5.1.4.1.1.2");
    EXPECT_EQ(meta->sopInstanceUid, dicom::test::slicesOf(series).front().sopInstanceUid);
    EXPECT_EQ(meta->transferSyntaxUid, "1.2.840.10008.1.2.1");
    // The dataset begins with group 8.
    EXPECT_EQ(bytesOfFile(file).substr(meta->datasetOffset, 2), std::string("\x08\0", 2));
}

TEST(FileMeta, IsReadWithAndWithoutVr) {
    for (const char* vr : {"UI", ""}) {
        const auto meta = metaOf(kBegin + element(2, vr, "1.2") + element(3, vr, std::string("3.4.5\0", 6)) +
                                 element(16, vr, "6") + kData);
        ASSERT_TRUE(meta) << vr;
        EXPECT_EQ(meta->sopClassUid, "1.2");
        EXPECT_EQ(meta->sopInstanceUid, "3.4.5");
        EXPECT_EQ(meta->transferSyntaxUid, "6");
    }
    const auto meta =
        metaOf(kBegin + element(1, "OB", std::string("\0\1", 2)) + element(3, "UI", "3.4") + kData);
    ASSERT_TRUE(meta);
    EXPECT_EQ(meta->sopInstanceUid, "3.4");
}

TEST(FileMeta, UidsThatAreNoneAreEmpty) {
    const auto meta =
        metaOf(kBegin + element(2, "UI", "../../etc") + element(3, "UI", std::string(65, '1')) + kData);
    ASSERT_TRUE(meta);
    EXPECT_EQ(meta->sopClassUid, "");
    EXPECT_EQ(meta->sopInstanceUid, "");
}

TEST(FileMeta, OfOtherBytesThereIsNone) {
    EXPECT_FALSE(metaOf(""));
    EXPECT_FALSE(metaOf("DICM"));
    EXPECT_FALSE(metaOf(kBegin));
    EXPECT_FALSE(metaOf(kBegin + kData));
    std::string tooLong = kBegin + element(3, "UI", "1.2");
    tooLong[kBegin.size() + 6] = '\x40';
    EXPECT_FALSE(metaOf(tooLong)) << "a length that leads behind the end";
    const std::string large(0xfff0, 'x');
    EXPECT_FALSE(metaOf(kBegin + element(3, "UI", "1.2") + element(2, "OB", large) + kData));
    const std::string whole = kBegin + element(2, "UI", "1.2") + element(3, "UI", "3.4") + kData;
    for (std::size_t bytes = 0; bytes < whole.size(); ++bytes) (void)metaOf(whole.substr(0, bytes));
}

TEST(FileMeta, OfNoFileIsAnErrorWithAdvice) {
    const dicom::test::TemporaryFolder folder;
    for (const auto& place : {folder / "missing", folder.path()}) {
        const auto meta = readFileMeta(place);
        ASSERT_FALSE(meta.ok());
        EXPECT_EQ(meta.error().code, ErrorCode::inputNotUsable);
        EXPECT_FALSE(meta.error().hint.empty());
    }
}

}  // namespace
}  // namespace macula::net
