// Round trips, and files that are not what they claim to be.
#include "image/image_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

#include "base/leaks_of_others.h"

namespace macula::image {
namespace {

namespace fs = std::filesystem;

class ImageFile : public ::testing::Test {
  protected:
    void SetUp() override {
        const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::temp_directory_path() / fmt::format("macula-image-{}-{}", getpid(), test->name());
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path at(const char* name) const { return folder_ / name; }
    std::size_t fileCount() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }
    void put(const char* name, std::string_view bytes) const {
        std::ofstream(at(name), std::ios::binary) << bytes;
    }
    static std::string get(const fs::path& path) {
        std::ifstream stream(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    fs::path folder_;
};

// Flat RGBE scanlines (narrower than 8 pixels, hence not run-length encoded): the simplest valid Radiance
// file.
std::string radianceFile(int width, int height, const std::array<unsigned char, 4>& rgbe) {
    std::string file = fmt::format("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n", height, width);
    for (int i = 0; i < width * height; ++i) file.append(reinterpret_cast<const char*>(rgbe.data()), 4);
    return file;
}

TEST_F(ImageFile, PngKeepsBytesOrderAndMetadata) {
    const std::vector<std::uint8_t> rgba{255, 0,  0,  255, 0, 255, 0, 128, 0, 0, 255, 0,
                                         10,  20, 30, 40,  1, 2,   3, 4,   5, 6, 7,   8};
    const Metadata metadata{{"Software", "Macula test"}, {"macula:preset", "ct-bone"}};
    ASSERT_TRUE(writePng(at("a.png"), 2, 3, rgba, metadata).ok());
    EXPECT_EQ(fileCount(), 1u) << "a temporary file was left";

    const auto image = readImage(at("a.png"));
    ASSERT_TRUE(image.ok()) << image.error().message;
    EXPECT_EQ(image->width, 2);
    EXPECT_EQ(image->height, 3);
    ASSERT_EQ(image->channels, 4);
    EXPECT_EQ(image->encoding, Encoding::display);
    for (std::size_t i = 0; i < rgba.size(); ++i) {
        EXPECT_EQ(std::lround(image->pixels[i] * 255.0f), rgba[i]) << "byte " << i;
    }
    const auto read = readMetadata(at("a.png"), std::array<std::string, 2>{"Software", "macula:preset"});
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(*read, metadata);
}

TEST_F(ImageFile, ExrKeepsValuesDepthAndMetadata) {
    const std::vector<float> rgba{0.0f, 1e-6f, 1000.0f, 1.0f, 0.25f, 0.5f, 0.75f, 0.125f};
    const std::vector<float> depth{812.5f, std::numeric_limits<float>::infinity()};
    ASSERT_TRUE(writeExr(at("a.exr"), 2, 1, rgba, depth, {{"macula:seed", "7"}}).ok());
    const auto image = readImage(at("a.exr"));
    ASSERT_TRUE(image.ok()) << image.error().message;
    ASSERT_EQ(image->channels, 5);
    EXPECT_EQ(image->encoding, Encoding::linear);
    for (std::size_t pixel = 0; pixel < 2; ++pixel) {
        for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(image->pixels[pixel * 5 + c], rgba[pixel * 4 + c]);
        EXPECT_EQ(image->pixels[pixel * 5 + 4], depth[pixel]);
    }
    const auto read = readMetadata(at("a.exr"), std::array<std::string, 1>{"macula:seed"});
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(*read, (Metadata{{"macula:seed", "7"}}));
}

TEST_F(ImageFile, ReadsRadianceHdr) {
    put("a.hdr", radianceFile(4, 2, {128, 64, 32, 130}));  // 128/256 * 2^(130-128) = 2
    const auto image = readImage(at("a.hdr"));
    ASSERT_TRUE(image.ok()) << image.error().message;
    ASSERT_EQ(image->channels, 3);
    EXPECT_NEAR(image->pixels[0], 2.0f, 0.02f);
    EXPECT_NEAR(image->pixels[1], 1.0f, 0.02f);
    EXPECT_EQ(countFaults(*image).total(), 0u);
}

TEST_F(ImageFile, TruncatedFilesAreErrors) {
    const std::string hdr = radianceFile(6, 40, {128, 64, 32, 130});
    put("half.hdr", hdr.substr(0, hdr.size() / 2));
    put("header.hdr", hdr.substr(0, 30));
    ASSERT_TRUE(writePng(at("whole.png"), 64, 64, std::vector<std::uint8_t>(64 * 64 * 4, 77)).ok());
    const std::string png = get(at("whole.png"));
    put("half.png", std::string_view(png).substr(0, png.size() / 2));
    ASSERT_TRUE(writeExr(at("whole.exr"), 64, 64, std::vector<float>(64 * 64 * 4, 0.5f)).ok());
    const std::string exr = get(at("whole.exr"));
    put("half.exr", std::string_view(exr).substr(0, exr.size() / 2));
    const test::LeaksOfOthers ofPng;  // libpng jumps out of OpenImageIO over a text that nobody destroys then
    for (const char* name : {"half.hdr", "header.hdr", "half.png", "half.exr"}) {
        const auto image = readImage(at(name));
        ASSERT_FALSE(image.ok()) << name;
        EXPECT_EQ(image.error().code, ErrorCode::inputNotUsable) << name;
        EXPECT_FALSE(image.error().hint.empty());
    }
}

TEST_F(ImageFile, OtherContentIsNamedSo) {
    put("text.hdr", "this is a shopping list\n");
    put("empty.exr", "");
    for (const char* name : {"text.hdr", "empty.exr"}) {
        const auto image = readImage(at(name));
        ASSERT_FALSE(image.ok());
        EXPECT_EQ(image.error().code, ErrorCode::inputNotUsable);
        EXPECT_NE(image.error().message.english().find("no Radiance HDR"), std::string::npos);
    }
    const auto missing = readImage(at("missing.hdr"));
    ASSERT_FALSE(missing.ok());
    EXPECT_NE(missing.error().message.english().find("does not exist"), std::string::npos);
    EXPECT_FALSE(readImage(folder_).ok());
}

TEST_F(ImageFile, AbsurdSizeIsRefusedBeforeAnyAllocation) {
    put("huge.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2000000000 +X 2000000000\n\1\1\1\1");
    put("wide.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 20000\n\1\1\1\1");
    EXPECT_FALSE(readImage(at("huge.hdr")).ok());
    const auto wide = readImage(at("wide.hdr"));
    ASSERT_FALSE(wide.ok());
    EXPECT_NE(wide.error().message.english().find("too large"), std::string::npos) << wide.error().message;
}

TEST_F(ImageFile, FaultyValuesAreKeptAndCounted) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    ASSERT_TRUE(writeExr(at("bad.exr"), 2, 1,
                         std::vector<float>{nan, infinity, -1.0f, 1.0f, 0.0f, 0.5f, -infinity, 1.0f})
                    .ok());
    const auto image = readImage(at("bad.exr"));
    ASSERT_TRUE(image.ok());
    const Faults faults = countFaults(*image);
    EXPECT_EQ(faults.notFinite, 3u);
    EXPECT_EQ(faults.negative, 1u);
}

TEST_F(ImageFile, UnwritablePlaceLeavesNothing) {
    const std::vector<std::uint8_t> rgba(4, 0);
    const auto noFolder = writePng(at("no/such/folder/a.png"), 1, 1, rgba);
    ASSERT_FALSE(noFolder.ok());
    EXPECT_EQ(noFolder.error().code, ErrorCode::outputNotWritable);
    fs::create_directory(at("taken.png"));  // the rename cannot replace a folder
    EXPECT_FALSE(writePng(at("taken.png"), 1, 1, rgba).ok());
    EXPECT_EQ(fileCount(), 1u);
}

}  // namespace
}  // namespace macula::image
