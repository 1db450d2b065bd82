#include "session/row_check.h"

#include <array>

namespace macula::session {

namespace {

// kTables[k][b]: the contribution of byte b to the sum when k more bytes follow ("slicing by 8", Kounavis and
// Berry).
using Tables = std::array<std::array<std::uint64_t, 256>, 8>;
constexpr Tables makeTables() {
    Tables tables{};
    for (std::uint64_t i = 0; i < 256; ++i) {
        std::uint64_t value = i;
        for (int bit = 0; bit < 8; ++bit)
            value = (value >> 1) ^ ((value & 1) != 0 ? 0xc96c5795d7870f42u : std::uint64_t{0});
        tables[0][i] = value;
    }
    for (std::size_t k = 1; k < tables.size(); ++k)
        for (std::size_t i = 0; i < 256; ++i)
            tables[k][i] = tables[0][tables[k - 1][i] & 0xff] ^ (tables[k - 1][i] >> 8);
    return tables;
}
constexpr Tables kTables = makeTables();

std::uint64_t ofNumber(char kind, std::uint64_t number, std::uint64_t before) {
    char bytes[9]{kind};
    for (int i = 0; i < 8; ++i) bytes[i + 1] = static_cast<char>(number >> (8 * i));
    return crc64({bytes, sizeof bytes}, before);
}

}  // namespace

std::uint64_t crc64(std::string_view bytes, std::uint64_t before) {
    std::uint64_t crc = ~before;
    for (; bytes.size() >= 8; bytes.remove_prefix(8)) {
        std::uint64_t sum = 0;
        for (std::size_t i = 0; i < 8; ++i)
            sum ^= kTables[7 - i][(crc >> (8 * i) ^ static_cast<unsigned char>(bytes[i])) & 0xff];
        crc = sum;
    }
    for (const char byte : bytes)
        crc = kTables[0][(crc ^ static_cast<unsigned char>(byte)) & 0xff] ^ (crc >> 8);
    return ~crc;
}

void RowSum::add(std::int64_t number) {
    crc_ = ofNumber('i', static_cast<std::uint64_t>(number), crc_);
}

void RowSum::add(std::string_view text) {
    crc_ = crc64(text, ofNumber('t', text.size(), crc_));
}

std::int64_t rowCheck(std::string_view table, std::span<const Value> values) {
    RowSum sum(table);
    for (const Value& value : values) {
        if (const auto* number = std::get_if<std::int64_t>(&value)) {
            sum.add(*number);
        } else if (const auto* text = std::get_if<std::string>(&value)) {
            sum.add(*text);
        } else {
            sum.addNull();
        }
    }
    return sum.value();
}

}  // namespace macula::session
