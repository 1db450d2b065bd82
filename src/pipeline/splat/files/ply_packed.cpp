#include "pipeline/splat/files/ply_packed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "pipeline/splat/model/constant_colour.h"

namespace macula::splat {

namespace {

constexpr std::size_t kPerChunk = 256;

// The bounds of a chunk, in the order of their names.
enum Bound : std::size_t {
    kMin = 0,
    kMax = 3,
    kMinScale = 6,
    kMaxScale = 9,
    kMinColour = 12,
    kMaxColour = 15
};
constexpr std::array<std::string_view, 18> kBounds{
    "min_x",       "min_y",       "min_z",       "max_x",       "max_y",       "max_z",
    "min_scale_x", "min_scale_y", "min_scale_z", "max_scale_x", "max_scale_y", "max_scale_z",
    "min_r",       "min_g",       "min_b",       "max_r",       "max_g",       "max_b"};
constexpr std::array<std::string_view, 4> kWords{"packed_position", "packed_rotation", "packed_scale",
                                                 "packed_color"};
using Chunk = std::array<float, kBounds.size()>;

Error unusable(Text message) {
    return {ErrorCode::inputNotUsable,
            std::move(message),
            {},
            Text("Export the model again from where it came.")};
}

Error cutOff() {
    return unusable(Text("The PLY file is cut off or damaged."));
}

const PlyElement* elementOf(const PlyHeader& header, std::string_view name) {
    const auto found = std::ranges::find(header.elements, name, &PlyElement::name);
    return found == header.elements.end() ? nullptr : &*found;
}

// Reads an element into `row` by the names of its properties; others are skipped.
template <class Names>
bool readRow(PlyValues& values, const PlyElement& element, const Names& names, std::span<double> row) {
    for (const PlyProperty& property : element.properties) {
        double value = 0.0;
        if (property.countType ? !values.skip(property) : !values.next(property.type, value)) return false;
        const auto name = std::ranges::find(names, property.name);
        if (!property.countType && name != names.end()) row[std::size_t(name - names.begin())] = value;
    }
    return true;
}

std::size_t countOf(const PlyElement& element, std::span<const std::string_view> names) {
    return std::size_t(std::ranges::count_if(element.properties, [&](const PlyProperty& property) {
        return !property.countType && std::ranges::find(names, property.name) != names.end();
    }));
}

float part(std::uint32_t word, int shift, int bits) {
    const std::uint32_t most = (1u << bits) - 1;
    return float((word >> shift) & most) / float(most);
}

glm::vec3 parts111011(std::uint32_t word) {
    return {part(word, 21, 11), part(word, 11, 10), part(word, 0, 11)};
}

glm::vec3 between(const Chunk& chunk, std::size_t low, std::size_t high, const glm::vec3& share) {
    glm::vec3 value(0.0f);
    for (int axis = 0; axis < 3; ++axis) {
        const auto n = std::size_t(axis);
        value[axis] = chunk[low + n] * (1.0f - share[axis]) + chunk[high + n] * share[axis];
    }
    return value;
}

// w, x, y, z
glm::vec4 rotationOf(std::uint32_t word) {
    const int largest = int(word >> 30);
    glm::vec4 rotation(0.0f);
    float rest = 1.0f;
    int shift = 20;
    for (int n = 0; n < 4; ++n) {
        if (n == largest) continue;
        rotation[n] = (part(word, shift, 10) - 0.5f) * std::numbers::sqrt2_v<float>;
        rest -= rotation[n] * rotation[n];
        shift -= 10;
    }
    rotation[largest] = std::sqrt(std::max(rest, 0.0f));
    return rotation;
}

float logitOf(float opacity) {
    return std::log(opacity) - std::log1p(-opacity);  // infinite at 0 and 1, which is clamped later
}

struct Layout {
    const PlyElement* chunk = nullptr;
    const PlyElement* vertex = nullptr;
    const PlyElement* sh = nullptr;  // null: none
    bool hasColourBounds = false;
    int degree = 0;
};

Result<Layout> layoutOf(const PlyHeader& header) {
    Layout layout{elementOf(header, "chunk"), elementOf(header, "vertex"), elementOf(header, "sh")};
    if (layout.chunk == nullptr || layout.vertex == nullptr ||
        countOf(*layout.vertex, kWords) != kWords.size())
        return unusable(Text("The packed PLY file lacks what its splats are packed by."));
    const std::size_t bounds = countOf(*layout.chunk, kBounds);
    layout.hasColourBounds = bounds == kBounds.size();
    const auto ofPlaces = std::span(kBounds).first(kMinColour);
    if (countOf(*layout.chunk, ofPlaces) != ofPlaces.size() ||
        (bounds != kMinColour && !layout.hasColourBounds) ||
        layout.chunk->count < (layout.vertex->count + kPerChunk - 1) / kPerChunk)
        return unusable(Text("The packed PLY file lacks what its splats are packed by."));
    if (layout.sh == nullptr) return layout;
    for (int degree = 1; degree <= kMaxShDegree; ++degree)
        if (layout.sh->properties.size() == 3 * shCount(degree)) layout.degree = degree;
    if (layout.degree == 0 || layout.sh->count != layout.vertex->count || layout.sh->hasLists())
        return unusable(Text("The packed PLY file has coefficients of colour that fit no degree."));
    return layout;
}

void setSplat(Splats& splats, std::size_t i, const std::array<double, 4>& words, const Chunk& chunk,
              bool hasColourBounds) {
    const auto word = [&](std::size_t n) {
        constexpr double kMostWord = 4294967295.0;
        return words[n] >= 0.0 && words[n] <= kMostWord ? std::uint32_t(words[n]) : 0u;
    };
    splats.position[i] = between(chunk, kMin, kMax, parts111011(word(0)));
    splats.rotation[i] = rotationOf(word(1));
    splats.logScale[i] = between(chunk, kMinScale, kMaxScale, parts111011(word(2)));
    glm::vec3 colour(part(word(3), 24, 8), part(word(3), 16, 8), part(word(3), 8, 8));
    if (hasColourBounds) colour = between(chunk, kMinColour, kMaxColour, colour);
    splats.dc[i] = dcOfColour(colour);
    splats.opacityLogit[i] = logitOf(part(word(3), 0, 8));
}

bool readSh(PlyValues& values, const PlyElement& element, Splats& splats) {
    constexpr double kStep = 8.0 / 255.0;
    const std::size_t count = shCount(splats.shDegree);
    for (std::size_t i = 0; i < splats.size(); ++i)
        for (std::size_t n = 0; n < element.properties.size(); ++n) {
            double byte = 0.0;
            if (!values.next(element.properties[n].type, byte)) return false;
            splats.sh[i * count + n % count][int(n / count)] = toFloat(byte * kStep - 4.0);
        }
    return true;
}

}  // namespace

bool isPackedPly(const PlyHeader& header) {
    const PlyElement* vertex = elementOf(header, "vertex");
    return vertex != nullptr && std::ranges::find(vertex->properties, kWords.front(), &PlyProperty::name) !=
                                    vertex->properties.end();
}

Result<Splats> readPackedPly(const PlyHeader& header, PlyValues& values) {
    MACULA_TRY(const Layout layout, layoutOf(header));
    std::vector<Chunk> chunks;
    Splats splats;
    // Before memory is allocated for any of them.
    if (!std::ranges::all_of(header.elements, [&](const PlyElement& each) { return values.canHold(each); }))
        return cutOff();
    for (const PlyElement& element : header.elements) {
        if (&element == layout.chunk) {
            for (std::uint64_t n = 0; n < element.count; ++n) {
                std::array<double, kBounds.size()> row{};
                if (!readRow(values, element, kBounds, row)) return cutOff();
                std::ranges::transform(row, chunks.emplace_back().begin(), toFloat);
            }
        } else if (&element == layout.vertex) {
            if (chunks.size() != layout.chunk->count)
                return unusable(Text("The packed PLY file lacks what its splats are packed by."));
            splats.shDegree = layout.degree;
            splats.resize(element.count);
            for (std::size_t i = 0; i < element.count; ++i) {
                std::array<double, kWords.size()> row{};
                if (!readRow(values, element, kWords, row)) return cutOff();
                setSplat(splats, i, row, chunks[i / kPerChunk], layout.hasColourBounds);
            }
        } else if (&element == layout.sh) {
            if (splats.size() != element.count || !readSh(values, element, splats)) return cutOff();
        } else if (!values.skip(element)) {
            return cutOff();
        }
    }
    return splats;
}

}  // namespace macula::splat
