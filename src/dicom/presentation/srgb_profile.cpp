#include "dicom/presentation/srgb_profile.h"

#include <array>
#include <cmath>
#include <span>
#include <string_view>
#include <utility>

namespace macula::dicom {

namespace {

using Bytes = std::vector<std::uint8_t>;

// Big endian, as all of ICC.
void put16(Bytes& to, unsigned value) {
    to.push_back(std::uint8_t(value >> 8));
    to.push_back(std::uint8_t(value));
}
void put32(Bytes& to, std::uint32_t value) {
    put16(to, value >> 16);
    put16(to, value & 0xFFFFu);
}
void putName(Bytes& to, std::string_view four) {
    to.insert(to.end(), four.begin(), four.end());
}
// s15Fixed16Number
void putFixed(Bytes& to, double value) {
    put32(to, static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(value * 65536.0))));
}

Bytes fixedNumbers(std::string_view type, std::span<const double> values) {
    Bytes tag;
    putName(tag, type);
    put32(tag, 0);
    for (const double value : values) putFixed(tag, value);
    return tag;
}

Bytes text(std::string_view ascii) {
    Bytes tag;
    putName(tag, "mluc");
    put32(tag, 0);
    put32(tag, 1);   // one language
    put32(tag, 12);  // bytes of its record
    putName(tag, "enUS");
    put32(tag, static_cast<std::uint32_t>(2 * ascii.size()));
    put32(tag, 28);
    for (const char c : ascii) put16(tag, static_cast<unsigned char>(c));
    while (tag.size() % 4 != 0) tag.push_back(0);
    return tag;
}

// IEC 61966-2-1: a line below 0.04045, a power above.
Bytes curve() {
    Bytes tag;
    putName(tag, "para");
    put32(tag, 0);
    put16(tag, 3);
    put16(tag, 0);
    for (const double value : {2.4, 1.0 / 1.055, 0.055 / 1.055, 1.0 / 12.92, 0.04045}) putFixed(tag, value);
    return tag;
}

Bytes header(std::size_t size) {
    Bytes bytes;
    put32(bytes, static_cast<std::uint32_t>(size));
    put32(bytes, 0);           // no preferred colour management
    put32(bytes, 0x04300000);  // version
    putName(bytes, "scnr");
    putName(bytes, "RGB ");
    putName(bytes, "XYZ ");
    for (const unsigned part : {2024u, 1u, 1u, 0u, 0u, 0u}) put16(bytes, part);
    putName(bytes, "acsp");
    for (int i = 0; i < 4; ++i) put32(bytes, 0);  // platform, flags, maker, model
    put32(bytes, 0);
    put32(bytes, 0);                                                          // attributes
    put32(bytes, 0);                                                          // perceptual
    for (const double white : {0.9642, 1.0, 0.8249}) putFixed(bytes, white);  // D50
    bytes.resize(128, 0);
    return bytes;
}

}  // namespace

std::vector<std::uint8_t> srgbProfile() {
    // The primaries of sRGB and its white D65, adapted to D50 by the linear Bradford transform.
    constexpr std::array kWhite{0.9642, 1.0, 0.8249};
    constexpr std::array kRed{0.436065, 0.222488, 0.013916};
    constexpr std::array kGreen{0.385147, 0.716873, 0.097076};
    constexpr std::array kBlue{0.143066, 0.060608, 0.714096};
    constexpr std::array kAdapted{1.047882,  0.022918,  -0.050217, 0.029587, 0.990479,
                                  -0.017059, -0.009247, 0.015076,  0.751678};
    const std::array<std::pair<std::string_view, Bytes>, 10> tags{{{"desc", text("sRGB")},
                                                                   {"cprt", text("No copyright")},
                                                                   {"wtpt", fixedNumbers("XYZ ", kWhite)},
                                                                   {"chad", fixedNumbers("sf32", kAdapted)},
                                                                   {"rXYZ", fixedNumbers("XYZ ", kRed)},
                                                                   {"gXYZ", fixedNumbers("XYZ ", kGreen)},
                                                                   {"bXYZ", fixedNumbers("XYZ ", kBlue)},
                                                                   {"rTRC", curve()},
                                                                   {"gTRC", curve()},
                                                                   {"bTRC", curve()}}};
    Bytes table;
    Bytes data;
    put32(table, static_cast<std::uint32_t>(tags.size()));
    const std::size_t begin = 128 + 4 + 12 * tags.size();
    for (const auto& [name, bytes] : tags) {
        putName(table, name);
        put32(table, static_cast<std::uint32_t>(begin + data.size()));
        put32(table, static_cast<std::uint32_t>(bytes.size()));
        data.insert(data.end(), bytes.begin(), bytes.end());
    }
    Bytes profile = header(begin + data.size());
    profile.insert(profile.end(), table.begin(), table.end());
    profile.insert(profile.end(), data.begin(), data.end());
    return profile;
}

}  // namespace macula::dicom
