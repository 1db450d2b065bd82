// Rows out of pages that are made to harm; what chance does to a database is in damage_test.cpp.
#include "session/database_pages.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>

namespace macula::session {
namespace {

constexpr std::size_t kPage = 4096;

std::string bigEndian(std::uint64_t value, int bytes) {
    std::string text;
    for (int i = bytes - 1; i >= 0; --i) text += static_cast<char>(value >> (8 * i));
    return text;
}

std::string varint(std::uint64_t value) {
    std::string text(1, static_cast<char>(value & 127));
    for (value >>= 7; value > 0; value >>= 7) text.insert(0, 1, static_cast<char>(128 | (value & 127)));
    return text;
}

// A leaf that is full of pointers to the same cell, at its end.
std::string fullOf(const std::string& cell, bool isFirst) {
    std::string page;
    if (isFirst) page = std::string("SQLite format 3\0", 16) + bigEndian(kPage, 2);
    page.resize(isFirst ? 100 : 0);
    const std::size_t place = kPage - cell.size();
    const std::size_t cells = (place - page.size() - 8) / 2;
    page += "\x0D" + bigEndian(0, 2) + bigEndian(cells, 2) + bigEndian(place, 2) + std::string(1, '\0');
    for (std::size_t i = 0; i < cells; ++i) page += bigEndian(place, 2);
    page.resize(place);
    return page + cell;
}

// A cell that goes on in so many pages, from the one of that number on.
std::string cellOver(std::uint64_t pages, std::uint64_t number) {
    constexpr std::uint64_t kLocal = (kPage - 12) * 32 / 255 - 23;
    return varint(kLocal + pages * (kPage - 4)) + varint(1) + std::string(kLocal, 'a') + bigEndian(number, 4);
}

void expectNothingSoon(const std::string& file) {
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_TRUE(rowsInPages(std::as_bytes(std::span(file))).empty());
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    EXPECT_LT(took.count(), 10.0);  // sanitizers take their time; without the limits it was hours
}

std::string circleAt(std::uint64_t number) {
    return bigEndian(number, 4) + std::string(kPage - 4, 'b');
}

// Of a page like these, each cell of which claims the same 16 MB, the search took half a minute.
TEST(DatabasePages, ACircleOfPagesIsNoLongSearch) {
    constexpr std::uint64_t kPages = 20;
    std::string file;
    for (std::uint64_t i = 0; i + 1 < kPages; ++i) file += fullOf(cellOver(3900, kPages), i == 0);
    expectNothingSoon(file + circleAt(kPages));
}

// The same within the size of the file.
TEST(DatabasePages, CellsThatShareAChainAreNoLongSearch) {
    constexpr std::uint64_t kPages = 400;
    std::string file;
    for (std::uint64_t i = 0; i + 1 < kPages; ++i) file += fullOf(cellOver(kPages - 2, kPages), i == 0);
    expectNothingSoon(file + circleAt(kPages));
}

TEST(DatabasePages, AnyBytesMayBePassed) {
    for (const std::size_t size : {0u, 1u, 99u, 100u, 107u, 108u, 4096u, 5000u})
        for (const char byte : {'\0', '\x0D', '\xFF'}) expectNothingSoon(std::string(size, byte));
}

}  // namespace
}  // namespace macula::session
