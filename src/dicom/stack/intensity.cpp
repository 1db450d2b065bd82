#include "dicom/stack/intensity.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace macula::dicom {

namespace {

constexpr int kSignedOffset = 32768;
constexpr std::int64_t kLargestStored = 65535;

int offsetOf(const CellFormat& format) {
    return format.isSigned ? kSignedOffset : 0;
}

// The raw values that the stored bits can hold.
RawRange storedBitsRange(const CellFormat& format) {
    if (format.isSigned) return {-(1 << (format.bitsStored - 1)), (1 << (format.bitsStored - 1)) - 1};
    return {0, (1 << format.bitsStored) - 1};
}

std::uint16_t unpack(const CellFormat& format, std::uint16_t cell) {
    if (format.isSigned) {
        // The stored bits go to the top of the word, so that its arithmetic shift extends the sign.
        const auto top = static_cast<std::int16_t>(static_cast<std::uint16_t>(cell << (15 - format.highBit)));
        return static_cast<std::uint16_t>((top >> (16 - format.bitsStored)) + kSignedOffset);
    }
    return static_cast<std::uint16_t>((cell >> (format.highBit + 1 - format.bitsStored)) &
                                      ((1u << format.bitsStored) - 1));
}

float toFloat(double value) {
    const bool fits = std::abs(value) <= double{std::numeric_limits<float>::max()};  // false for NaN
    return fits ? static_cast<float>(value) : std::numeric_limits<float>::quiet_NaN();
}

}  // namespace

CellFormat floatFormat(CellKind kind) {
    const int bits = kind == CellKind::float64 ? 64 : 32;
    return {bits, bits, bits - 1, true, kind};
}

bool isUsable(const CellFormat& format) {
    if (format.kind != CellKind::integer) return format == floatFormat(format.kind);
    const int bits = format.bitsAllocated;
    return (bits == 1 || bits == 8 || bits == 16 || bits == 32) && format.bitsStored >= 1 &&
           format.highBit < bits && format.highBit + 1 >= format.bitsStored;
}

bool isNarrow(const CellFormat& format) {
    return format.kind == CellKind::integer && format.bitsAllocated <= 16;
}

RawRange paddingRange(const CellFormat& format, std::uint16_t valueWord,
                      std::optional<std::uint16_t> limitWord) {
    const auto raw = [&](std::uint16_t word) {
        return format.isSigned ? static_cast<int>(static_cast<std::int16_t>(word)) : static_cast<int>(word);
    };
    const int value = raw(valueWord);
    const int limit = limitWord ? raw(*limitWord) : value;
    return {std::min(value, limit), std::max(value, limit)};
}

std::uint16_t ModalityLut::operator()(std::int64_t raw) const {
    const std::int64_t last = static_cast<std::int64_t>(entries.size()) - 1;
    return entries[static_cast<std::size_t>(std::clamp<std::int64_t>(raw - firstMapped, 0, last))];
}

std::shared_ptr<const ModalityLut> readModalityLut(const std::array<std::uint16_t, 3>& descriptor,
                                                   std::span<const std::uint16_t> data,
                                                   bool pixelsAreSigned) {
    const std::size_t count = descriptor[0] == 0 ? 65536 : descriptor[0];
    const auto [bits, first] = std::pair(descriptor[2], descriptor[1]);
    if (bits < 1 || bits > 16) return nullptr;
    ModalityLut lut;
    lut.firstMapped = pixelsAreSigned ? static_cast<std::int16_t>(first) : static_cast<int>(first);
    if (data.size() >= count) {
        lut.entries.assign(data.begin(), data.begin() + static_cast<std::ptrdiff_t>(count));
    } else if (bits <= 8 && data.size() >= (count + 1) / 2) {
        for (std::size_t i = 0; i < count; ++i) {
            lut.entries.push_back(static_cast<std::uint16_t>(data[i / 2] >> (i % 2 == 0 ? 0 : 8) & 0xFF));
        }
    } else {
        return nullptr;
    }
    return std::make_shared<const ModalityLut>(std::move(lut));
}

bool SliceIntensity::operator==(const SliceIntensity& other) const {
    const auto sameLut = [&] {
        if (modalityLut == other.modalityLut) return true;
        return modalityLut && other.modalityLut && *modalityLut == *other.modalityLut;
    };
    return format == other.format && slope == other.slope && intercept == other.intercept &&
           padding == other.padding && floatPadding == other.floatPadding && sameLut();
}

std::optional<Text> completePadding(std::span<SliceIntensity> slices) {
    std::optional<RawRange> common;
    std::size_t missing = 0;
    for (const SliceIntensity& slice : slices) {
        if (!slice.padding) {
            ++missing;
        } else if (common && *common != *slice.padding) {
            return {};
        } else {
            common = slice.padding;
        }
    }
    if (!common || missing == 0) return {};
    for (SliceIntensity& slice : slices) slice.padding = common;
    return Text("{} of {} slices declare no padding value; that of the others was taken for them.", missing,
                slices.size());
}

void unpackCells(const CellFormat& format, const std::optional<RawRange>& padding,
                 std::span<std::uint16_t> cells) {
    if (!format.isSigned && format.bitsStored == 16) return;
    const RawRange holds = storedBitsRange(format);
    const bool paddingIsOutside = padding && format.highBit + 1 == format.bitsStored &&
                                  (padding->low < holds.low || padding->high > holds.high);
    if (!paddingIsOutside) {
        for (std::uint16_t& cell : cells) cell = unpack(format, cell);
        return;
    }
    for (std::uint16_t& cell : cells) {
        const int whole = format.isSigned ? static_cast<std::int16_t>(cell) : static_cast<int>(cell);
        cell = padding->contains(whole) ? static_cast<std::uint16_t>(whole + offsetOf(format))
                                        : unpack(format, cell);
    }
}

std::size_t cellsBeyondStoredBits(const CellFormat& format, const std::optional<RawRange>& padding,
                                  std::span<const std::uint16_t> cells, std::uint16_t overlays) {
    const int above = format.bitsAllocated - format.highBit - 1;
    const int below = format.highBit + 1 - format.bitsStored;
    if (!isNarrow(format) || (above <= 0 && below <= 0)) return 0;
    const auto without = static_cast<std::uint16_t>(~overlays);
    const unsigned ones = (((1u << above) - 1u) << (format.highBit + 1)) & without;
    const unsigned low = ((1u << below) - 1u) & without;
    std::size_t count = 0;
    for (const std::uint16_t cell : cells) {
        const unsigned top = unsigned{cell} & ones;
        if (top == 0 && (unsigned{cell} & low) == 0) continue;
        const bool isNegative = format.isSigned && (unsigned{cell} >> format.highBit & 1u) != 0;
        if (isNegative && top == ones && (unsigned{cell} & low) == 0) continue;
        const int whole = format.isSigned ? static_cast<std::int16_t>(cell) : static_cast<int>(cell);
        count += padding && padding->contains(whole) ? 0 : 1;
    }
    return count;
}

std::optional<StoredRange> unpackedPadding(const SliceIntensity& slice) {
    if (!slice.padding) return {};
    const int offset = offsetOf(slice.format);
    const auto unpacked = [&](int raw) {
        return static_cast<std::uint16_t>(std::clamp(raw + offset, 0, 65535));
    };
    return StoredRange{unpacked(slice.padding->low), unpacked(slice.padding->high)};
}

void applyMap(const SliceMap& map, std::span<std::uint16_t> unpacked) {
    switch (map.kind) {
        case SliceMap::Kind::keep:
            return;
        case SliceMap::Kind::invert:
            for (std::uint16_t& voxel : unpacked) voxel = static_cast<std::uint16_t>(65535 - voxel);
            return;
        case SliceMap::Kind::linear:
            for (std::uint16_t& voxel : unpacked) {
                if (map.padding && map.padding->contains(voxel)) {
                    voxel = 0;
                    continue;
                }
                const std::int64_t x = map.modalityLut ? (*map.modalityLut)(voxel - map.lutOffset) : voxel;
                voxel = static_cast<std::uint16_t>(
                    std::clamp<std::int64_t>(map.scale * x + map.shift, 0, kLargestStored));
            }
            return;
    }
}

void applyIntensity(const SliceIntensity& slice, std::span<const std::uint16_t> unpacked,
                    std::span<float> values) {
    const std::optional<StoredRange> padding = unpackedPadding(slice);
    const int offset = offsetOf(slice.format);
    for (std::size_t i = 0; i < unpacked.size(); ++i) {
        const int raw = unpacked[i] - offset;
        if (padding && padding->contains(unpacked[i])) {
            values[i] = std::numeric_limits<float>::quiet_NaN();
        } else {
            values[i] =
                toFloat(slice.modalityLut ? (*slice.modalityLut)(raw) : slice.slope * raw + slice.intercept);
        }
    }
}

std::size_t applyIntensity(const SliceIntensity& slice, std::span<const double> numbers,
                           std::span<float> values) {
    const bool isInteger = slice.format.kind == CellKind::integer;
    const auto isPadding = [&](double raw) {
        if (isInteger) return slice.padding && slice.padding->contains(raw);
        return slice.floatPadding && slice.floatPadding->low <= raw && raw <= slice.floatPadding->high;
    };
    std::size_t notFinite = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const double raw = numbers[i];
        if (isPadding(raw)) {
            values[i] = std::numeric_limits<float>::quiet_NaN();
        } else if (slice.modalityLut && isInteger) {
            values[i] = (*slice.modalityLut)(static_cast<std::int64_t>(raw));
        } else {
            values[i] = toFloat(slice.slope * raw + slice.intercept);
            notFinite += std::isnan(values[i]) ? 1 : 0;
        }
    }
    return notFinite;
}

}  // namespace macula::dicom
