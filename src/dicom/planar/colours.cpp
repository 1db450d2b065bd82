#include "dicom/planar/colours.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace macula::dicom {

namespace {

constexpr int kMost8 = 255;
constexpr int kMiddle = 128;  // of a colour difference: grey

struct TablePlace {
    Tag descriptor;
    Tag data;
    Tag segmented;
};
constexpr std::array<TablePlace, 3> kTables{
    TablePlace{{0x0028, 0x1101}, {0x0028, 0x1201}, {0x0028, 0x1221}},   // red
    TablePlace{{0x0028, 0x1102}, {0x0028, 0x1202}, {0x0028, 0x1222}},   // green
    TablePlace{{0x0028, 0x1103}, {0x0028, 0x1203}, {0x0028, 0x1223}}};  // blue
constexpr std::size_t kMostEntries = 65536;

std::uint8_t to8(double value) {
    return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, long{kMost8}));
}

// Y, Cb and Cr, each from 0 to 255.
std::array<double, 3> rgbOf(ColourModel model, double y, double cb, double cr) {
    if (model == ColourModel::ybrPartial) {
        constexpr double kLuminance = 255.0 / 219.0;
        constexpr double kDifference = 255.0 / 224.0;
        y = (y - 16.0) * kLuminance;
        cb = (cb - kMiddle) * kDifference + kMiddle;
        cr = (cr - kMiddle) * kDifference + kMiddle;
    }
    return {y + 1.402 * (cr - kMiddle), y - 0.344136 * (cb - kMiddle) - 0.714136 * (cr - kMiddle),
            y + 1.772 * (cb - kMiddle)};
}

// PS3.3 C.7.9.2: discrete runs, lines to the next value, and runs that are repeated from elsewhere.
class Expansion {
  public:
    explicit Expansion(std::span<const std::uint16_t> words) : words_(words) {}

    // Nothing where the segments are damaged, or make more entries than a table can have.
    std::optional<std::vector<std::uint16_t>> entries() {
        if (!segmentsUpTo(words_.size(), true)) return {};
        return std::move(entries_);
    }

  private:
    bool segmentsUpTo(std::size_t end, bool mayRepeat) {
        while (at_ < end) {
            if (!segment(mayRepeat) || entries_.size() > kMostEntries) return false;
        }
        return true;
    }
    bool segment(bool mayRepeat) {
        if (at_ + 2 >= words_.size()) return false;
        const unsigned kind = words_[at_];
        const std::size_t count = words_[at_ + 1];
        at_ += 2;
        if (kind == 0) return run(count);
        if (kind == 1) return line(count);
        return kind == 2 && mayRepeat && repeat(count);
    }
    bool run(std::size_t count) {
        if (at_ + count > words_.size()) return false;
        entries_.insert(entries_.end(), words_.begin() + std::ptrdiff_t(at_),
                        words_.begin() + std::ptrdiff_t(at_ + count));
        at_ += count;
        return true;
    }
    bool line(std::size_t count) {
        if (entries_.empty()) return false;
        const double from = entries_.back();
        const double step = count > 0 ? (double(words_[at_]) - from) / double(count) : 0.0;
        for (std::size_t i = 1; i <= count; ++i)
            entries_.push_back(static_cast<std::uint16_t>(std::lround(from + step * double(i))));
        ++at_;
        return true;
    }
    bool repeat(std::size_t segments) {
        if (at_ + 2 > words_.size()) return false;
        // The offset is in bytes; two words make it.
        const std::size_t offset = (std::size_t{words_[at_]} | std::size_t{words_[at_ + 1]} << 16) / 2;
        const std::size_t behind = at_ + 2;
        at_ = offset;
        for (std::size_t i = 0; i < segments; ++i) {
            if (at_ >= behind || !segment(false) || entries_.size() > kMostEntries) return false;
        }
        at_ = behind;
        return true;
    }

    std::span<const std::uint16_t> words_;
    std::vector<std::uint16_t> entries_;
    std::size_t at_ = 0;
};

struct Table {
    int firstMapped = 0;
    int bits = 16;
    std::vector<std::uint16_t> entries;
};

std::optional<Table> readTable(const Dataset& header, const TablePlace& place, bool pixelsAreSigned) {
    const std::vector<std::uint16_t> descriptor = header.words(place.descriptor);
    if (descriptor.size() != 3) return {};
    Table table;
    table.firstMapped = pixelsAreSigned ? static_cast<std::int16_t>(descriptor[1]) : descriptor[1];
    table.bits = descriptor[2];
    const std::size_t count = descriptor[0] == 0 ? kMostEntries : descriptor[0];
    std::vector<std::uint16_t> words = header.words(place.data);
    if (words.empty()) {
        auto expanded = Expansion(header.words(place.segmented)).entries();
        if (!expanded) return {};
        words = *std::move(expanded);
    }
    if (words.size() < count && table.bits == 8 && words.size() >= (count + 1) / 2) {  // two in a word
        for (std::size_t i = 0; i < count; ++i)
            table.entries.push_back(i % 2 == 0 ? words[i / 2] & 0xff : words[i / 2] >> 8);
        return table;
    }
    if (words.size() < count || (table.bits != 8 && table.bits != 16)) return {};
    words.resize(count);
    table.entries = std::move(words);
    return table;
}

}  // namespace

std::optional<ColourModel> colourModelOf(std::string_view photometricInterpretation) {
    constexpr std::array<std::pair<std::string_view, ColourModel>, 6> kModels{
        {{"RGB", ColourModel::rgb},
         {"YBR_FULL", ColourModel::ybrFull},
         {"YBR_FULL_422", ColourModel::ybrFull},
         {"YBR_PARTIAL_422", ColourModel::ybrPartial},
         {"YBR_ICT", ColourModel::rgb},
         {"YBR_RCT", ColourModel::rgb}}};
    const auto* found = std::ranges::find(kModels, photometricInterpretation,
                                          &std::pair<std::string_view, ColourModel>::first);
    return found == kModels.end() ? std::nullopt : std::optional(found->second);
}

std::vector<std::uint8_t> toRgb(ColourModel model, int bitsStored, std::span<const std::uint16_t> samples) {
    MACULA_CHECK(samples.size() % 3 == 0 && bitsStored >= 1 && bitsStored <= 16);
    const double most = double((1u << unsigned(bitsStored)) - 1);
    const double scale = kMost8 / most;
    std::vector<std::uint8_t> rgb(samples.size());
    if (model == ColourModel::rgb) {
        std::ranges::transform(samples, rgb.begin(),
                               [&](std::uint16_t sample) { return to8(scale * sample); });
        return rgb;
    }
    for (std::size_t i = 0; i < samples.size(); i += 3) {
        const auto colour = rgbOf(model, scale * samples[i], scale * samples[i + 1], scale * samples[i + 2]);
        for (std::size_t c = 0; c < 3; ++c) rgb[i + c] = to8(colour[c]);
    }
    return rgb;
}

const std::array<std::uint8_t, 3>& ColourPalette::operator()(int raw) const {
    const auto last = std::ptrdiff_t(colours.size()) - 1;
    return colours[std::size_t(std::clamp(std::ptrdiff_t{raw} - firstMapped, std::ptrdiff_t{0}, last))];
}

std::optional<ColourPalette> readPalette(const Dataset& header, bool pixelsAreSigned) {
    std::vector<Table> tables;
    bool isSmall = true;
    for (const TablePlace& place : kTables) {
        std::optional<Table> table = readTable(header, place, pixelsAreSigned);
        if (!table) return {};
        const bool fits = tables.empty() || (table->firstMapped == tables[0].firstMapped &&
                                             table->entries.size() == tables[0].entries.size());
        if (!fits) return {};
        isSmall = isSmall &&
                  std::ranges::all_of(table->entries, [](std::uint16_t entry) { return entry <= kMost8; });
        tables.push_back(*std::move(table));
    }
    ColourPalette palette{.firstMapped = tables[0].firstMapped, .colours = {}};
    palette.colours.resize(tables[0].entries.size());
    for (std::size_t c = 0; c < tables.size(); ++c) {
        const int shift = isSmall || tables[c].bits == 8 ? 0 : 8;
        for (std::size_t i = 0; i < palette.colours.size(); ++i)
            palette.colours[i][c] = static_cast<std::uint8_t>(tables[c].entries[i] >> shift);
    }
    return palette;
}

}  // namespace macula::dicom
