#include "dicom/presentation/palette_tables.h"

#include <cmath>

namespace macula::dicom {

namespace {

constexpr std::size_t kMostEntries = 65536;
constexpr std::uint16_t kDiscrete = 0;
constexpr std::uint16_t kLinear = 1;
constexpr std::uint16_t kIndirect = 2;

class Segments {
  public:
    Segments(std::span<const std::uint16_t> words, std::size_t count) : words_(words), count_(count) {}

    std::optional<std::vector<std::uint16_t>> expand() {
        std::size_t at = 0;
        while (at < words_.size()) {
            if (words_.size() - at == 1 && words_[at] == 0) break;  // padding to an even length
            if (!any(at)) return {};
        }
        if (entries_.size() != count_) return {};
        return std::move(entries_);
    }

  private:
    // Each of these functions moves `at` past its segment, and returns whether that fits.
    bool any(std::size_t& at) {
        if (words_[at] != kIndirect) return direct(at);
        if (words_.size() - at < 4) return false;
        const std::size_t segments = words_[at + 1];
        // The offset counts bytes.
        std::size_t from = (std::size_t{words_[at + 3]} << 16 | words_[at + 2]) / 2;
        if (from >= at) return false;  // only earlier segments
        at += 4;
        for (std::size_t i = 0; i < segments; ++i) {
            // A segment of these must not be indirect.
            if (from >= words_.size() || !direct(from)) return false;
        }
        return true;
    }

    bool direct(std::size_t& at) {
        if (words_.size() - at < 3) return false;
        const std::uint16_t kind = words_[at];
        const std::size_t length = words_[at + 1];
        if (length == 0 || length > count_ - entries_.size()) return false;
        if (kind == kDiscrete) {
            if (words_.size() - at - 2 < length) return false;
            const auto values = words_.subspan(at + 2, length);
            entries_.insert(entries_.end(), values.begin(), values.end());
            at += 2 + length;
            return true;
        }
        if (kind != kLinear || entries_.empty()) return false;
        const double from = entries_.back();
        const double to = words_[at + 2];
        for (std::size_t i = 1; i <= length; ++i)
            entries_.push_back(std::uint16_t(std::lround(from + (to - from) * double(i) / double(length))));
        at += 3;
        return true;
    }

    std::span<const std::uint16_t> words_;
    std::size_t count_;
    std::vector<std::uint16_t> entries_;
};

// Entries of 8 bits come two in a word, the first in its lower half, or one in each.
std::vector<std::uint16_t> entriesOf(std::vector<std::uint16_t> words, std::size_t count, int bits) {
    if (bits == 8 && words.size() < count && words.size() == (count + 1) / 2) {
        std::vector<std::uint16_t> entries;
        for (const std::uint16_t word : words) {
            entries.push_back(word & 0xFFu);
            entries.push_back(std::uint16_t(word >> 8));
        }
        words = std::move(entries);
    }
    if (words.size() == count + 1) words.pop_back();  // padding to an even length
    return words;
}

}  // namespace

std::optional<std::vector<std::uint16_t>> expandSegments(std::span<const std::uint16_t> words,
                                                         std::size_t count) {
    if (count > kMostEntries) return {};
    return Segments(words, count).expand();
}

std::optional<PaletteTable> readPaletteTable(const Dataset& from, Tag descriptor, Tag data, Tag segmented) {
    const std::vector<std::uint16_t> format = from.words(descriptor);
    if (format.size() != 3 || (format[2] != 8 && format[2] != 16)) return {};
    const std::size_t count = format[0] == 0 ? kMostEntries : format[0];
    PaletteTable table{.firstValue = static_cast<std::int16_t>(format[1]), .values = {}};
    if (from.has(data)) {
        table.values = entriesOf(from.words(data), count, format[2]);
    } else if (auto expanded = expandSegments(from.words(segmented), count)) {
        table.values = *std::move(expanded);
    }
    if (table.values.size() != count || count < 2) return {};
    if (format[2] == 8) {
        for (std::uint16_t& value : table.values) value = std::uint16_t((value & 0xFFu) * 257u);
    }
    return table;
}

}  // namespace macula::dicom
