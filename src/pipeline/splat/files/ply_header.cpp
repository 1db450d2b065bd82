#include "pipeline/splat/files/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

namespace macula::splat {

namespace {

// Room for some 10 000 properties; Macula's headers take 2 KiB.
constexpr std::uint64_t kMostHeaderBytes = std::uint64_t{1} << 20;

struct TypeName {
    std::string_view name;
    PlyType type;
};
constexpr std::array<TypeName, 16> kTypes{{{"char", PlyType::int8},
                                           {"uchar", PlyType::uint8},
                                           {"short", PlyType::int16},
                                           {"ushort", PlyType::uint16},
                                           {"int", PlyType::int32},
                                           {"uint", PlyType::uint32},
                                           {"float", PlyType::float32},
                                           {"double", PlyType::float64},
                                           {"int8", PlyType::int8},
                                           {"uint8", PlyType::uint8},
                                           {"int16", PlyType::int16},
                                           {"uint16", PlyType::uint16},
                                           {"int32", PlyType::int32},
                                           {"uint32", PlyType::uint32},
                                           {"float32", PlyType::float32},
                                           {"float64", PlyType::float64}}};

Error badHeader(Text what) {
    return {ErrorCode::inputNotUsable,
            Text("The header of the PLY file {}.", what),
            {},
            Text("Export the model again from where it came.")};
}

Error notPly() {
    return {ErrorCode::inputNotUsable, Text("The file is no PLY."), {}, Text("Choose a model of Gaussians.")};
}

// Reads the lines of the header, ended by \n or \r\n, and no more bytes than a header may have.
class Lines {
  public:
    explicit Lines(std::istream& stream) : stream_(stream) {}

    Result<std::string> next() {
        std::string line;
        for (;; ++bytes_) {
            if (bytes_ >= kMostHeaderBytes) return badHeader(Text("is longer than that of any model"));
            const int c = stream_.get();
            if (c == std::istream::traits_type::eof()) return badHeader(Text("is cut off"));
            if (c == '\n') break;
            line.push_back(static_cast<char>(c));
        }
        ++bytes_;
        if (line.ends_with('\r')) line.pop_back();
        return line;
    }
    std::uint64_t bytes() const { return bytes_; }

  private:
    std::istream& stream_;
    std::uint64_t bytes_ = 0;
};

// Takes the next word off the front of a line.
std::string_view word(std::string_view& line) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    const std::string_view found = line.substr(0, line.find_first_of(" \t"));
    line.remove_prefix(found.size());
    return found;
}

std::optional<PlyType> typeOf(std::string_view name) {
    const auto* found =
        std::find_if(kTypes.begin(), kTypes.end(), [&](const TypeName& t) { return t.name == name; });
    if (found == kTypes.end()) return std::nullopt;
    return found->type;
}

Result<PlyFormat> formatOf(std::string_view line) {
    const std::string_view name = word(line);
    if (word(line) != "1.0") return badHeader(Text("names a version that is not 1.0"));
    if (name == "ascii") return PlyFormat::ascii;
    if (name == "binary_little_endian") return PlyFormat::littleEndian;
    if (name == "binary_big_endian") return PlyFormat::bigEndian;
    return badHeader(Text("names an unknown format"));
}

Result<PlyElement> elementOf(std::string_view line) {
    PlyElement element;
    element.name = word(line);
    const std::string_view count = word(line);
    if (count.starts_with('-')) return badHeader(Text("counts fewer elements than none"));
    const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), element.count);
    if (element.name.empty() || error != std::errc() || end != count.data() + count.size())
        return badHeader(Text("does not say how many elements there are"));
    return element;
}

Result<PlyProperty> propertyOf(std::string_view line) {
    PlyProperty property;
    std::string_view type = word(line);
    if (type == "list") {
        property.countType = typeOf(word(line));
        if (!property.countType || *property.countType == PlyType::float32 ||
            *property.countType == PlyType::float64)
            return badHeader(Text("has a list whose length is no whole number"));
        type = word(line);
    }
    const auto known = typeOf(type);
    if (!known) return badHeader(Text("names an unknown type of number"));
    property.type = *known;
    property.name = word(line);
    if (property.name.empty()) return badHeader(Text("has a property without a name"));
    return property;
}

}  // namespace

std::size_t bytesOf(PlyType type) {
    switch (type) {
        case PlyType::int8:
        case PlyType::uint8:
            return 1;
        case PlyType::int16:
        case PlyType::uint16:
            return 2;
        case PlyType::int32:
        case PlyType::uint32:
        case PlyType::float32:
            return 4;
        case PlyType::float64:
            return 8;
    }
    return 0;
}

bool PlyElement::hasLists() const {
    return std::any_of(properties.begin(), properties.end(),
                       [](const PlyProperty& p) { return p.countType.has_value(); });
}

std::uint64_t PlyElement::leastBytes(PlyFormat format) const {
    std::uint64_t bytes = 0;
    for (const PlyProperty& p : properties)
        bytes += format == PlyFormat::ascii ? 2 : bytesOf(p.countType.value_or(p.type));
    return bytes;
}

Result<PlyHeader> readPlyHeader(std::istream& stream) {
    std::array<char, 3> magic{};
    stream.read(magic.data(), magic.size());
    if (stream.gcount() != 3 || std::string_view(magic.data(), 3) != "ply") return notPly();
    Lines lines(stream);
    MACULA_TRY(const std::string rest, lines.next());
    if (!rest.empty()) return notPly();

    PlyHeader header;
    bool hasFormat = false;
    for (;;) {
        MACULA_TRY(const std::string text, lines.next());
        std::string_view line = text;
        const std::string_view key = word(line);
        if (key == "end_header") break;
        if (key == "comment") {
            line.remove_prefix(std::min<std::size_t>(1, line.size()));
            header.comments.emplace_back(line);
        } else if (key == "format" && !hasFormat) {
            MACULA_TRY(header.format, formatOf(line));
            hasFormat = true;
        } else if (key == "element") {
            MACULA_TRY(PlyElement element, elementOf(line));
            header.elements.push_back(std::move(element));
        } else if (key == "property" && !header.elements.empty()) {
            MACULA_TRY(PlyProperty property, propertyOf(line));
            header.elements.back().properties.push_back(std::move(property));
        } else if (key != "obj_info" && !key.empty()) {
            return badHeader(Text("has a line that is none of a PLY"));
        }
    }
    if (!hasFormat) return badHeader(Text("does not name a format"));
    header.bytes = magic.size() + lines.bytes();
    return header;
}

}  // namespace macula::splat
