#include "dicom/jpeg_lossless.h"

#include <array>
#include <bit>
#include <cstring>
#include <optional>
#include <vector>

namespace macula::dicom {

namespace {

using Result = JpegLosslessResult;

constexpr int kLookupBits = 13;
constexpr int kLongestCode = 16;
constexpr int kMostCategory = 16;  // bits of a difference

// What the next bits mean.
struct Entry {
    std::int32_t difference = 0;
    std::uint8_t bits =
        0;  // of code and difference, or of the code only; 0: the code is longer than the lookup
    bool isWhole = false;  // `difference` is known
    std::uint8_t category = 0;
};

struct HuffmanTable {
    std::array<std::uint8_t, kLongestCode + 1> counts{};  // of codes of each length
    std::vector<std::uint8_t> categories;
    std::vector<Entry> lookup;
};

std::int32_t extended(std::uint32_t bits, int category) {
    const auto value = static_cast<std::int32_t>(bits);
    return category > 0 && value < (1 << (category - 1)) ? value - (1 << category) + 1 : value;
}

// False when the codes are more than their lengths have room for.
bool buildLookup(HuffmanTable& table) {
    table.lookup.assign(std::size_t{1} << kLookupBits, {});
    std::uint32_t code = 0;
    std::size_t symbol = 0;
    for (int length = 1; length <= kLongestCode; ++length, code <<= 1) {
        for (int n = 0; n < table.counts[static_cast<std::size_t>(length)]; ++n, ++code, ++symbol) {
            if (code >= 1u << length) return false;
            if (length > kLookupBits) continue;
            const int category = table.categories[symbol];
            const int extra = category == kMostCategory ? 0 : category;
            const int spare = kLookupBits - length;
            for (std::uint32_t rest = 0; rest < 1u << spare; ++rest) {
                Entry& entry = table.lookup[code << spare | rest];
                entry.category = static_cast<std::uint8_t>(category);
                entry.isWhole = extra <= spare;
                entry.bits = static_cast<std::uint8_t>(entry.isWhole ? length + extra : length);
                if (category == kMostCategory) {
                    entry.difference = 32768;
                } else if (entry.isWhole) {
                    entry.difference = extended(rest >> (spare - extra), category);
                }
            }
        }
    }
    return true;
}

// The entropy-coded bits, without the zeros stuffed after FF; behind their end zeros without end.
class Bits {
  public:
    explicit Bits(std::span<const std::byte> bytes) : bytes_(bytes) {}

    // At least 48 bits.
    void refill() {
        if (count_ > 48) return;
        if (at_ + 8 <= bytes_.size()) {
            std::uint64_t next;
            std::memcpy(&next, bytes_.data() + at_, 8);
            // No byte is FF: their complements have no zero byte.
            const std::uint64_t inverse = ~next;
            if (((inverse - 0x0101010101010101u) & ~inverse & 0x8080808080808080u) == 0) {
                if constexpr (std::endian::native == std::endian::little) next = __builtin_bswap64(next);
                const int bytes = (64 - count_) / 8;
                buffer_ |= next >> (64 - 8 * bytes) << (64 - 8 * bytes - count_);
                count_ += 8 * bytes;
                at_ += static_cast<std::size_t>(bytes);
                return;
            }
        }
        while (count_ <= 56) addByte();
    }
    std::uint32_t peek(int bits) const { return static_cast<std::uint32_t>(buffer_ >> (64 - bits)); }
    void skip(int bits) {
        buffer_ <<= bits;
        count_ -= bits;
    }
    // More was taken than there was.
    bool overrun() const { return count_ < invented_; }

  private:
    void addByte() {
        std::uint64_t byte = 0;
        bool there = at_ < bytes_.size();
        if (there) {
            byte = std::to_integer<std::uint64_t>(bytes_[at_]);
            if (byte == 0xFF) {
                there = at_ + 1 < bytes_.size() && bytes_[at_ + 1] == std::byte{0};  // else a marker
                if (there) ++at_;
            }
        }
        if (there) {
            ++at_;
        } else {
            byte = 0;
            invented_ += 8;
        }
        buffer_ |= byte << (56 - count_);
        count_ += 8;
    }

    std::span<const std::byte> bytes_;
    std::size_t at_ = 0;
    std::uint64_t buffer_ = 0;  // from the top
    int count_ = 0;
    std::int64_t invented_ = 0;  // bits at the end of the buffer, and before
};

// A code that is longer than the lookup, and its difference.
std::optional<std::int32_t> longDifference(const HuffmanTable& table, Bits& bits) {
    std::uint32_t code = 0;
    std::size_t symbol = 0;
    for (int length = 1; length <= kLongestCode; ++length, code <<= 1) {
        const std::uint32_t count = table.counts[static_cast<std::size_t>(length)];
        const std::uint32_t next = bits.peek(length);
        if (next - code < count) {
            const int category = table.categories[symbol + (next - code)];
            bits.skip(length);
            if (category == 0) return 0;
            if (category == kMostCategory) return 32768;
            const std::uint32_t value = bits.peek(category);
            bits.skip(category);
            return extended(value, category);
        }
        code += count;
        symbol += count;
    }
    return {};
}

inline bool nextDifference(const HuffmanTable& table, Bits& bits, std::int32_t& difference) {
    bits.refill();
    const Entry& entry = table.lookup[bits.peek(kLookupBits)];
    if (entry.isWhole) {
        bits.skip(entry.bits);
        difference = entry.difference;
        return true;
    }
    if (entry.bits > 0) {
        bits.skip(entry.bits);
        difference = extended(bits.peek(entry.category), entry.category);
        bits.skip(entry.category);
        return true;
    }
    const auto found = longDifference(table, bits);
    difference = found.value_or(0);
    return found.has_value();
}

struct Scan {
    int precision = 0;
    int columns = 0;
    int rows = 0;
    int shift = 0;  // the point transform
    HuffmanTable table;
    std::span<const std::byte> data;
};

class Headers {
  public:
    explicit Headers(std::span<const std::byte> stream) : stream_(stream) {}

    Result read(Scan& scan) {
        std::size_t at = 2;  // after the start-of-image marker
        while (at + 4 <= stream_.size() && byte(at) == 0xFF) {
            const int marker = byte(at + 1);
            if (marker == 0xFF) {  // a fill byte
                ++at;
                continue;
            }
            const std::size_t length = static_cast<std::size_t>(word(at + 2));
            if (length < 2 || at + 2 + length > stream_.size()) return Result::damaged;
            segment_ = {at + 4, at + 2 + length};
            at += 2 + length;
            Result result = Result::decoded;
            if (marker == 0xC4) result = readTables();
            if (marker == 0xC3) result = readFrame(scan);
            if (marker == 0xDA) return readScan(scan, at);
            // Another process, arithmetic coding, JPEG-LS, or restarts.
            if (marker != 0xC3 && marker != 0xC4 && marker >= 0xC0 && marker <= 0xCF)
                return Result::otherKind;
            if (marker == 0xF7 || marker == 0xDD) return Result::otherKind;
            if (result != Result::decoded) return result;
        }
        return Result::damaged;
    }

  private:
    int byte(std::size_t i) const { return std::to_integer<int>(stream_[i]); }
    int word(std::size_t i) const { return byte(i) << 8 | byte(i + 1); }
    std::size_t left() const { return segment_.end - segment_.at; }

    Result readTables() {
        while (left() > 0) {
            if (left() < 1 + kLongestCode) return Result::damaged;
            const int name = byte(segment_.at++);
            if (name > 3) return Result::otherKind;
            HuffmanTable& table = tables_[static_cast<std::size_t>(name)];
            std::size_t codes = 0;
            for (std::size_t length = 1; length <= kLongestCode; ++length) {
                table.counts[length] = static_cast<std::uint8_t>(byte(segment_.at++));
                codes += table.counts[length];
            }
            if (left() < codes) return Result::damaged;
            table.categories.clear();
            for (std::size_t i = 0; i < codes; ++i) {
                if (byte(segment_.at) > kMostCategory) return Result::damaged;
                table.categories.push_back(static_cast<std::uint8_t>(byte(segment_.at++)));
            }
        }
        return Result::decoded;
    }

    Result readFrame(Scan& scan) {
        if (left() < 9) return Result::damaged;
        scan.precision = byte(segment_.at);
        scan.rows = word(segment_.at + 1);
        scan.columns = word(segment_.at + 3);
        return byte(segment_.at + 5) == 1 ? Result::decoded : Result::otherKind;
    }

    Result readScan(Scan& scan, std::size_t dataBegin) {
        if (scan.precision < 2 || scan.precision > 16 || left() < 6) return Result::damaged;
        const int components = byte(segment_.at);
        const int name = byte(segment_.at + 2) >> 4;
        const int predictor = byte(segment_.at + 3);
        if (components != 1 || predictor != 1) return Result::otherKind;
        scan.shift = byte(segment_.at + 5) & 15;
        if (name > 3 || scan.shift >= scan.precision) return Result::damaged;
        scan.table = std::move(tables_[static_cast<std::size_t>(name)]);
        if (scan.table.categories.empty() || !buildLookup(scan.table)) return Result::damaged;
        scan.data = stream_.subspan(dataBegin);
        return Result::decoded;
    }

    std::span<const std::byte> stream_;
    struct {
        std::size_t at = 0;
        std::size_t end = 0;
    } segment_;
    std::array<HuffmanTable, 4> tables_;
};

}  // namespace

JpegLosslessResult decodeJpegLossless(std::span<const std::byte> stream, int columns, int rows,
                                      std::span<std::uint16_t> cells) {
    Scan scan;
    if (const Result result = Headers(stream).read(scan); result != Result::decoded) return result;
    if (scan.columns != columns || scan.rows != rows) return Result::damaged;
    const auto width = static_cast<std::size_t>(columns);
    if (cells.size() != width * static_cast<std::size_t>(rows)) return Result::damaged;
    Bits bits(scan.data);
    for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row) {
        std::uint16_t* const line = cells.data() + row * width;
        // The first of a row is predicted from above, the first of all from the middle of the range.
        std::uint32_t value = row > 0 ? *(line - width) : 1u << (scan.precision - scan.shift - 1);
        for (std::size_t i = 0; i < width; ++i) {
            std::int32_t difference = 0;
            if (!nextDifference(scan.table, bits, difference)) return Result::damaged;
            value = (value + static_cast<std::uint32_t>(difference)) & 0xFFFF;
            line[i] = static_cast<std::uint16_t>(value);
        }
        if (bits.overrun()) return Result::damaged;
    }
    if (scan.shift > 0) {
        for (std::uint16_t& cell : cells) cell = static_cast<std::uint16_t>(cell << scan.shift);
    }
    return Result::decoded;
}

}  // namespace macula::dicom
