// Pictures of others: what is one is shrunk, and nothing else is decoded.
#include "viewer/archive/safe_picture.h"

#include <gtest/gtest.h>

#include <QBuffer>
#include <QByteArray>
#include <cstdint>
#include <random>

#include "viewer/offscreen.h"

namespace macula::viewer {
namespace {

using Kind = net::EncodedPicture::Kind;

std::string encoded(const QImage& image, const char* format) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    EXPECT_TRUE(image.save(&buffer, format));
    return bytes.toStdString();
}

QImage striped(int width, int height) {
    QImage image(width, height, QImage::Format_RGB32);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) image.setPixel(x, y, x < width / 2 ? 0xff000000 : 0xffffffff);
    return image;
}

// The size that a PNG claims, with its checksum put right: the header of a bomb.
std::string claiming(std::string png, std::uint32_t width, std::uint32_t height) {
    const auto put = [&](std::size_t at, std::uint32_t value) {
        for (int i = 0; i < 4; ++i) png[at + std::size_t(i)] = char(value >> (24 - 8 * i));
    };
    put(16, width);
    put(20, height);
    std::uint32_t crc = 0xffffffff;
    for (std::size_t i = 12; i < 29; ++i) {
        crc ^= std::uint8_t(png[i]);
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320u : 0u);
    }
    put(29, ~crc);
    return png;
}

class SafePictureTest : public test::OffscreenTest {};

TEST_F(SafePictureTest, ShrinksToWhatIsWantedAndKeepsTheProportions) {
    for (const auto& [kind, format] : {std::pair{Kind::jpeg, "jpeg"}, std::pair{Kind::png, "png"}}) {
        const QImage picture = decodedPicture({kind, encoded(striped(400, 200), format)}, QSize(72, 72));
        EXPECT_EQ(picture.size(), QSize(72, 36)) << format;
        EXPECT_LT(qGray(picture.pixel(10, 18)), 40) << format;
        EXPECT_GT(qGray(picture.pixel(60, 18)), 215) << format;
        EXPECT_EQ(decodedPicture({kind, encoded(striped(20, 10), format)}, QSize(72, 72)).size(),
                  QSize(20, 10));
    }
    EXPECT_EQ(decodedPicture({Kind::png, encoded(striped(2000, 2), "png")}, QSize(72, 72)).size(),
              QSize(72, 1));
}

TEST_F(SafePictureTest, WhatClaimsToBeHugeIsNotDecoded) {
    const std::string small = encoded(striped(20, 10), "png");
    ASSERT_EQ(decodedPicture({Kind::png, claiming(small, 20, 10)}, QSize(72, 72)).size(), QSize(20, 10));
    EXPECT_TRUE(decodedPicture({Kind::png, claiming(small, 2'000'000, 2'000'000)}, QSize(72, 72)).isNull());
    EXPECT_TRUE(decodedPicture({Kind::png, claiming(small, 2049, 10)}, QSize(72, 72)).isNull());
    EXPECT_TRUE(decodedPicture({Kind::png, claiming(small, 0, 10)}, QSize(72, 72)).isNull());
    EXPECT_TRUE(decodedPicture({Kind::jpeg, encoded(striped(10, 2049), "jpeg")}, QSize(72, 72)).isNull());
}

TEST_F(SafePictureTest, OtherFormatsAreNotTried) {
    const QImage image = striped(20, 10);
    for (const char* format : {"bmp", "ppm", "xpm"}) {
        EXPECT_TRUE(decodedPicture({Kind::png, encoded(image, format)}, QSize(72, 72)).isNull()) << format;
        EXPECT_TRUE(decodedPicture({Kind::jpeg, encoded(image, format)}, QSize(72, 72)).isNull()) << format;
    }
    EXPECT_TRUE(decodedPicture({Kind::jpeg, encoded(image, "png")}, QSize(72, 72)).isNull());
    EXPECT_TRUE(
        decodedPicture({Kind::png, "<svg xmlns=\"http://www.w3.org/2000/svg\"/>"}, QSize(72, 72)).isNull());
    EXPECT_TRUE(decodedPicture({Kind::jpeg, ""}, QSize(72, 72)).isNull());
}

TEST_F(SafePictureTest, BrokenBytesGiveAPictureOrNone) {
    std::mt19937 random(5);
    for (const auto& [kind, format] : {std::pair{Kind::jpeg, "jpeg"}, std::pair{Kind::png, "png"}}) {
        const std::string whole = encoded(striped(64, 64), format);
        for (int round = 0; round < 300; ++round) {
            std::string bytes = whole.substr(0, random() % 4 == 0 ? random() % whole.size() : whole.size());
            for (int i = 0; i < 4 && !bytes.empty(); ++i) bytes[random() % bytes.size()] = char(random());
            const QImage picture = decodedPicture({kind, bytes}, QSize(72, 72));
            EXPECT_LE(picture.width(), 72);
            EXPECT_LE(picture.height(), 72);
        }
    }
}

}  // namespace
}  // namespace macula::viewer
