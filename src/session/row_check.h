// A checksum of each row: SQLite has none for its pages, so a bit flipped on disk would pass for a value.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace macula::session {

// NULL, INTEGER or TEXT: the types that columns use.
using Value = std::variant<std::monostate, std::int64_t, std::string>;

// CRC-64/XZ (ECMA-182, reflected): detects every burst of up to 64 bits, and misses other changes once in
// 2^64. `before` is the checksum of the bytes before.
std::uint64_t crc64(std::string_view bytes, std::uint64_t before = 0);

// RowSum computes the checksum of a row column by column, in SQLite's memory, so that checking a row does not
// copy it.
class RowSum {
  public:
    explicit RowSum(std::string_view table) : crc_(crc64(table)) {}
    void add(std::int64_t number);
    void add(std::string_view text);
    void addNull() { crc_ = crc64("n", crc_); }
    std::int64_t value() const { return static_cast<std::int64_t>(crc_); }

  private:
    std::uint64_t crc_;
};

// Checksum of the table's name and all columns but row_check, with their types and lengths. It includes the
// id, so a row found under another id fails as well.
std::int64_t rowCheck(std::string_view table, std::span<const Value> values);

}  // namespace macula::session
