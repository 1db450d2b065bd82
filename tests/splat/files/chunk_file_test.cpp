// The container of .macula files: what goes in comes out, and what is damaged is told.
#include "pipeline/splat/files/chunk_file.h"

#include <gtest/gtest.h>

#include <cstring>
#include <sstream>

#include "pipeline/splat/files/byte_planes.h"
#include "splat/model_support.h"

namespace macula::splat {
namespace {

std::vector<std::byte> bytesOf(std::string_view text) {
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

// Noise, and nothing, and what is nearly the same.
std::vector<std::byte> someBytes(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::byte> bytes(count);
    for (std::size_t i = 0; i < count; ++i)
        bytes[i] = static_cast<std::byte>(i % 3 == 0 ? random() : i % 3 == 1 ? 0u : random() % 2);
    return bytes;
}

TEST(BytePlanes, GiveBackWhatWentIn) {
    for (const std::uint32_t stride : {1u, 4u, 16u, 168u}) {
        for (const std::size_t elements : {0u, 1u, 2u, 1000u}) {
            const std::vector<std::byte> data = someBytes(stride * elements, stride);
            const auto packed = packPlanes(data, stride);
            ASSERT_TRUE(packed.ok());
            std::vector<std::byte> back(data.size());
            EXPECT_TRUE(unpackPlanes(*packed, stride, back).value());
            EXPECT_EQ(back, data);
            std::vector<std::byte> longer(data.size() + stride);
            EXPECT_FALSE(unpackPlanes(*packed, stride, longer).value());
            if (!back.empty()) {
                EXPECT_FALSE(
                    unpackPlanes(*packed, stride, std::span(back).first(data.size() - stride)).value());
                EXPECT_FALSE(
                    unpackPlanes(std::span(*packed).first(packed->size() - 1), stride, back).value());
            }
            std::vector<std::byte> followed = *packed;
            followed.push_back(std::byte{0});
            EXPECT_FALSE(unpackPlanes(followed, stride, back).value());
        }
    }
}

// Exponents that hardly differ and last digits that do: a quarter and more is saved.
TEST(BytePlanes, PackFloats) {
    std::mt19937 random(7);
    std::vector<float> values(10000);
    for (float& value : values) value = 1.0f + float(random() % 8388608u) / 8388608.0f;
    const auto packed = packPlanes(std::as_bytes(std::span(values)), 4);
    ASSERT_TRUE(packed.ok());
    EXPECT_LT(packed->size(), 0.8 * 4.0 * double(values.size()));
}

const std::vector<std::byte> kNumbers = someBytes(160, 3);
const std::string kText = "a line\n";

std::string fileOf(std::uint32_t version = 7) {
    std::ostringstream stream;
    const std::vector<std::byte> text = bytesOf(kText);
    const std::vector<Chunk> chunks{
        {"text", text, 0}, {"twice", text, 0}, {"numbers", kNumbers, 16}, {"twice", {}, 4}};
    EXPECT_TRUE(writeChunks(stream, version, chunks).ok());
    return stream.str();
}

// All there is in it, or the error.
Result<std::string> readAll(const std::string& bytes, std::uint32_t version = 7) {
    std::istringstream stream(bytes);
    MACULA_TRY(ChunkFile file, ChunkFile::open(stream, bytes.size(), version));
    MACULA_TRY(std::string all, file.readText("text"));
    MACULA_TRY(const std::vector<std::byte> numbers, file.read("numbers", kNumbers.size()));
    all.append(reinterpret_cast<const char*>(numbers.data()), numbers.size());
    for (const ChunkEntry& entry : file.entries()) {
        MACULA_TRY(std::vector<std::byte> stored, file.stored(entry));
        MACULA_TRY([[maybe_unused]] const auto plain, ChunkFile::unpacked(entry, std::move(stored)));
    }
    return all;
}

TEST(ChunkFileTest, GivesBackWhatWentIn) {
    const auto all = readAll(fileOf());
    ASSERT_TRUE(all.ok());
    EXPECT_EQ(*all, kText + std::string(reinterpret_cast<const char*>(kNumbers.data()), kNumbers.size()));
    EXPECT_EQ(fileOf(), fileOf());
    const std::string bytes = fileOf();
    std::istringstream stream(bytes);
    auto file = ChunkFile::open(stream, bytes.size(), 7);
    ASSERT_TRUE(file.ok());
    ASSERT_EQ(file->entries().size(), 4u);
    EXPECT_EQ(file->entries()[3].name, "twice");
    EXPECT_FALSE(file->readText("none").ok());
    EXPECT_FALSE(file->readText("twice").ok());
    EXPECT_FALSE(file->read("text", kText.size() + 1).ok());
}

TEST(ChunkFileTest, NamesBothVersions) {
    const auto read = readAll(fileOf(9));
    ASSERT_FALSE(read.ok());
    EXPECT_NE(read.error().message.english().find("version 9"), std::string::npos);
    EXPECT_NE(read.error().message.english().find("version 7"), std::string::npos);
    EXPECT_FALSE(read.error().hint.empty());
}

TEST(ChunkFileTest, EveryChangedBitIsTold) {
    const std::string bytes = fileOf();
    for (std::size_t i = 0; i < 8 * bytes.size(); ++i) {
        std::string changed = bytes;
        changed[i / 8] = static_cast<char>(changed[i / 8] ^ (1 << (i % 8)));
        const auto read = readAll(changed);
        ASSERT_FALSE(read.ok()) << "bit " << i;
        ASSERT_EQ(read.error().code, ErrorCode::inputNotUsable);
    }
    for (std::size_t length = 0; length < bytes.size(); ++length)
        ASSERT_FALSE(readAll(bytes.substr(0, length)).ok()) << length;
    EXPECT_FALSE(readAll(bytes + "x").ok());
}

// What lies behind the chunk that is asked for is not read: it need not even be there.
TEST(ChunkFileTest, TheBeginningIsReadWithoutTheRest) {
    const std::string bytes = fileOf();
    std::istringstream whole(bytes);
    auto all = ChunkFile::open(whole, bytes.size(), 7);
    ASSERT_TRUE(all.ok());
    const ChunkEntry& numbers = all->entries()[2];
    const std::string begin = bytes.substr(0, numbers.offset + numbers.storedBytes);
    std::istringstream stream(begin);
    EXPECT_FALSE(ChunkFile::open(stream, bytes.size(), 7).ok());
    auto file = ChunkFile::openUntil(stream, bytes.size(), 7, "numbers");
    ASSERT_TRUE(file.ok());
    EXPECT_EQ(file->entries().size(), 3u);
    EXPECT_TRUE(file->has("text"));
    EXPECT_TRUE(file->has("numbers"));
    EXPECT_FALSE(file->has("number"));
    EXPECT_EQ(*file->read("numbers", kNumbers.size()), kNumbers);
    EXPECT_EQ(*file->readText("text"), kText);
    EXPECT_FALSE(ChunkFile::openUntil(stream, bytes.size(), 7, "none").ok()) << "looked for up to the end";
    std::istringstream again(bytes);
    EXPECT_EQ(ChunkFile::openUntil(again, bytes.size(), 7, "none")->entries().size(), 4u);
    // With the file too short for its bytes.
    EXPECT_FALSE(ChunkFile::openUntil(again, numbers.offset + numbers.storedBytes - 1, 7, "numbers").ok());
}

TEST(ChunkFileTest, WhatIsPackedAlreadyIsWrittenAsItIs) {
    const std::vector<std::byte> other = someBytes(160, 5);
    const auto packed = packPlanes(kNumbers, 16);
    ASSERT_TRUE(packed.ok());
    std::ostringstream plain;
    std::ostringstream before;
    ASSERT_TRUE(writeChunks(plain, 7, std::vector<Chunk>{{"a", kNumbers, 16}, {"b", other, 4}}).ok());
    ASSERT_TRUE(
        writeChunks(before, 7, std::vector<Chunk>{{"a", kNumbers, 16, *packed}, {"b", other, 4}}).ok());
    EXPECT_EQ(before.str(), plain.str());
}

// With checksums that agree: sizes that a file of that length cannot hold are refused before there is room
// for them.
TEST(ChunkFileTest, ImpossibleSizesAreRefused) {
    const std::string bytes = fileOf();
    const std::size_t numbersAt = bytes.find("numbers");
    ASSERT_NE(numbersAt, std::string::npos);
    const auto with = [&](std::size_t offset, auto value) {
        std::string changed = bytes;
        std::memcpy(&changed[numbersAt + offset], &value, sizeof(value));
        const std::uint32_t crc = checksum(std::as_bytes(std::span(changed)).subspan(numbersAt, 32));
        std::memcpy(&changed[numbersAt + 32], &crc, sizeof(crc));
        return changed;
    };
    ASSERT_TRUE(readAll(with(24, std::uint32_t{16})).ok());
    for (const std::uint64_t size : {std::uint64_t(1) << 62, std::uint64_t(1) << 40, std::uint64_t(1) << 20,
                                     ~std::uint64_t(0), ~std::uint64_t(0) - 15}) {
        EXPECT_FALSE(readAll(with(8, size)).ok());
        EXPECT_FALSE(readAll(with(16, size)).ok());
    }
    for (const std::uint32_t stride : {0u, 7u, 257u, 0xffffffffu})
        EXPECT_FALSE(readAll(with(24, stride)).ok()) << stride;
}

}  // namespace
}  // namespace macula::splat
