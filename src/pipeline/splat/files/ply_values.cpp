#include "pipeline/splat/files/ply_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

namespace macula::splat {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <class T>
double as(const std::array<char, 8>& bytes) {
    T value;
    std::memcpy(&value, bytes.data(), sizeof value);
    return static_cast<double>(value);
}

bool isSpace(int c) {
    return c == ' ' || c == '\n' || c == '\r' || c == '\t';
}

}  // namespace

bool PlyValues::canHold(const PlyElement& element) const {
    const std::uint64_t each = element.leastBytes(format_);
    // The last number of an ascii file may have no separator after it.
    const std::uint64_t room = format_ == PlyFormat::ascii ? left_ + 1 : left_;
    return each == 0 || element.count <= room / each;
}

bool PlyValues::next(PlyType type, double& value) {
    if (format_ == PlyFormat::ascii) return nextText(value);
    const std::size_t size = bytesOf(type);
    if (size > left_) return false;
    std::array<char, 8> bytes{};
    if (stream_.sgetn(bytes.data(), static_cast<std::streamsize>(size)) != static_cast<std::streamsize>(size))
        return false;
    left_ -= size;
    if (format_ == PlyFormat::bigEndian)
        std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    switch (type) {
        case PlyType::int8:
            value = as<std::int8_t>(bytes);
            break;
        case PlyType::uint8:
            value = as<std::uint8_t>(bytes);
            break;
        case PlyType::int16:
            value = as<std::int16_t>(bytes);
            break;
        case PlyType::uint16:
            value = as<std::uint16_t>(bytes);
            break;
        case PlyType::int32:
            value = as<std::int32_t>(bytes);
            break;
        case PlyType::uint32:
            value = as<std::uint32_t>(bytes);
            break;
        case PlyType::float32:
            value = as<float>(bytes);
            break;
        case PlyType::float64:
            value = as<double>(bytes);
            break;
    }
    return true;
}

bool PlyValues::nextText(double& value) {
    std::array<char, 64> text{};
    std::size_t length = 0;
    while (left_ > 0) {
        const int c = stream_.sbumpc();
        if (c == std::streambuf::traits_type::eof()) break;
        --left_;
        if (isSpace(c)) {
            if (length > 0) break;
            continue;
        }
        if (length == text.size()) return false;
        text[length++] = static_cast<char>(c);
    }
    std::string_view number(text.data(), length);
    if (number.starts_with('+')) number.remove_prefix(1);
    const char* end = number.data() + number.size();
    const auto [stop, error] = std::from_chars(number.data(), end, value);
    if (number.empty() || stop != end) return false;
    if (error == std::errc::result_out_of_range) {
        const bool tiny = number.find("e-") != number.npos || number.find("E-") != number.npos;
        value = std::copysign(tiny ? 0.0 : kInfinity, number.starts_with('-') ? -1.0 : 1.0);
        return true;
    }
    return error == std::errc();
}

bool PlyValues::skipBytes(std::uint64_t count) {
    if (count > left_) return false;
    left_ -= count;
    std::array<char, 4096> none{};
    while (count > 0) {
        const auto portion = static_cast<std::streamsize>(std::min<std::uint64_t>(count, none.size()));
        if (stream_.sgetn(none.data(), portion) != portion) return false;
        count -= static_cast<std::uint64_t>(portion);
    }
    return true;
}

bool PlyValues::skip(const PlyProperty& property) {
    double value = 0.0;
    if (!property.countType) return next(property.type, value);
    if (!next(*property.countType, value)) return false;
    // Written so that NaN from an ascii file fails too.
    if (!(value >= 0.0 && value <= static_cast<double>(left_)) || value != std::floor(value)) return false;
    const auto length = static_cast<std::uint64_t>(value);
    if (format_ != PlyFormat::ascii) return skipBytes(length * bytesOf(property.type));
    for (std::uint64_t i = 0; i < length; ++i) {
        if (!next(property.type, value)) return false;
    }
    return true;
}

bool PlyValues::skip(const PlyElement& element) {
    if (element.properties.empty()) return true;
    if (format_ != PlyFormat::ascii && !element.hasLists())
        return canHold(element) && skipBytes(element.count * element.leastBytes(format_));
    for (std::uint64_t i = 0; i < element.count; ++i) {
        for (const PlyProperty& property : element.properties) {
            if (!skip(property)) return false;
        }
    }
    return true;
}

float toFloat(double value) {
    constexpr double kMost = std::numeric_limits<float>::max();
    // Converting a value beyond the largest float would be undefined behaviour.
    if (std::abs(value) > kMost && !std::isinf(value))
        return static_cast<float>(std::copysign(kInfinity, value));
    return static_cast<float>(value);
}

}  // namespace macula::splat
