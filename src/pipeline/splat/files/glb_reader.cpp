// decodeGlb of glb.h.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/splat/files/glb.h"
#include "pipeline/splat/files/glb_layout.h"
#include "pipeline/splat/files/model_notes.h"

namespace macula::splat {

namespace {

using Json = nlohmann::json;
using Bytes = std::span<const std::byte>;

Error unusable(Text message, Text hint = Text("Export the model again from where it came.")) {
    return {ErrorCode::inputNotUsable, std::move(message), {}, std::move(hint)};
}
Error damaged() {
    return unusable(Text("The glTF file is damaged or cut off."));
}

std::uint32_t numberAt(Bytes bytes, std::size_t at) {
    std::uint32_t number = 0;
    std::memcpy(&number, bytes.data() + at, sizeof(number));
    return number;
}

// The member with that key; null if there is none.
const Json* member(const Json& json, const std::string& key) {
    if (!json.is_object()) return nullptr;
    const auto found = json.find(key);
    return found == json.end() ? nullptr : &*found;
}
const Json* element(const Json& json, const std::string& list, std::uint64_t index) {
    const Json* all = member(json, list);
    return all != nullptr && all->is_array() && index < all->size() ? &(*all)[index] : nullptr;
}
std::optional<std::uint64_t> wholeNumber(const Json& json, const std::string& key) {
    const Json* value = member(json, key);
    if (value == nullptr || !value->is_number_unsigned()) return std::nullopt;
    return value->get<std::uint64_t>();
}
std::string textIn(const Json& json, const std::string& key) {
    const Json* value = member(json, key);
    return value != nullptr && value->is_string() ? value->get<std::string>() : std::string();
}

struct Component {
    int type;
    std::size_t bytes;
    double high;  // the value that means 1 in a normalised attribute
    bool isSigned;
};
constexpr std::array<Component, 5> kComponents{{{glb::kByte, 1, 127.0, true},
                                                {glb::kUnsignedByte, 1, 255.0, false},
                                                {glb::kShort, 2, 32767.0, true},
                                                {glb::kUnsignedShort, 2, 65535.0, false},
                                                {glb::kFloat, 4, 1.0, true}}};

double valueOf(const std::byte* from, const Component& component) {
    const auto as = [&](auto value) {
        std::memcpy(&value, from, sizeof(value));
        return double(value);
    };
    switch (component.type) {
        case glb::kByte:
            return as(std::int8_t());
        case glb::kUnsignedByte:
            return as(std::uint8_t());
        case glb::kShort:
            return as(std::int16_t());
        case glb::kUnsignedShort:
            return as(std::uint16_t());
        default:
            return as(float());
    }
}

constexpr std::uint64_t kMostJsonBytes = 16u << 20;  // the JSON of a model takes a few thousand

// The two parts of a file.
struct Parts {
    Json json;
    Bytes binary;
};

Result<Parts> partsOf(Bytes bytes) {
    constexpr std::size_t kFirst = glb::kHeaderBytes + glb::kChunkHeaderBytes;
    if (bytes.size() < kFirst) return damaged();
    if (numberAt(bytes, 4) != glb::kVersion)
        return unusable(Text("The glTF file is not of version 2."), Text("Export it as binary glTF 2.0."));
    const std::uint64_t length = numberAt(bytes, 8);
    const std::uint64_t jsonBytes = numberAt(bytes, glb::kHeaderBytes);
    if (length > bytes.size() || numberAt(bytes, glb::kHeaderBytes + 4) != glb::kJsonChunk ||
        jsonBytes > length - std::min<std::uint64_t>(length, kFirst))
        return damaged();
    if (jsonBytes > kMostJsonBytes)
        return unusable(Text("The glTF file holds far more than a model."), Text("Export the model alone."));
    const Bytes text = bytes.subspan(kFirst, jsonBytes);
    Parts parts;
    parts.json = Json::parse(reinterpret_cast<const char*>(text.data()),
                             reinterpret_cast<const char*>(text.data()) + text.size(), nullptr, false);
    if (!parts.json.is_object()) return damaged();
    const std::uint64_t binary = kFirst + jsonBytes;
    if (length < binary + glb::kChunkHeaderBytes) return parts;  // has no binary chunk
    if (numberAt(bytes, binary + 4) != glb::kBinaryChunk ||
        numberAt(bytes, binary) > length - binary - glb::kChunkHeaderBytes)
        return damaged();
    parts.binary = bytes.subspan(binary + glb::kChunkHeaderBytes, numberAt(bytes, binary));
    return parts;
}

class Reader {
  public:
    explicit Reader(const Parts& parts) : json_(parts.json), binary_(parts.binary) {}

    Result<Splats> read() const {
        MACULA_TRY_VOID(checkExtensions());
        const Json* primitive = findPrimitive();
        if (primitive == nullptr)
            return unusable(Text("The glTF file holds no Gaussians."),
                            Text("Choose one with the extension KHR_gaussian_splatting."));
        const Json& splatting = (*primitive)["extensions"][glb::kExtension];
        if (textIn(splatting, "kernel") != glb::kKernel)
            return unusable(Text("The Gaussians of the glTF file are of another kind than ellipses."));
        const Json* names = member(*primitive, "attributes");
        if (names == nullptr) return damaged();
        MACULA_TRY(Splats splats, readAttributes(*names));
        MACULA_TRY_VOID(applyNotes(notes(), splats));
        const bool isLinear = textIn(splatting, "colorSpace") == glb::kLinearColours;
        if (isLinear != (splats.colourSpace == ColourSpace::linear))
            return unusable(
                Text("The glTF file has colours in linear light of a display, which cannot be drawn."),
                Text("Export it with colours in sRGB."));
        return splats;
    }

  private:
    // Refuses a file that requires extensions other than ours.
    Result<void> checkExtensions() const {
        const Json* required = member(json_, "extensionsRequired");
        if (required == nullptr || !required->is_array()) return {};
        for (const Json& name : *required) {
            if (name != glb::kExtension)
                return unusable(Text("The Gaussians of the glTF file are packed in a way that is not known."),
                                Text("Export it without compression, or as PLY or SPZ."));
        }
        return {};
    }

    const Json* findPrimitive() const {
        const Json* meshes = member(json_, "meshes");
        if (meshes == nullptr || !meshes->is_array()) return nullptr;
        for (const Json& mesh : *meshes) {
            const Json* primitives = member(mesh, "primitives");
            if (primitives == nullptr || !primitives->is_array()) continue;
            for (const Json& primitive : *primitives) {
                const Json* extensions = member(primitive, "extensions");
                if (extensions != nullptr && member(*extensions, glb::kExtension) != nullptr)
                    return &primitive;
            }
        }
        return nullptr;
    }

    std::vector<std::string> notes() const {
        std::vector<std::string> lines;
        const Json* asset = member(json_, "asset");
        const Json* extras = asset != nullptr ? member(*asset, "extras") : nullptr;
        const Json* list = extras != nullptr ? member(*extras, glb::kNotes) : nullptr;
        if (list == nullptr || !list->is_array()) return lines;
        for (const Json& line : *list) {
            if (line.is_string()) lines.push_back(line.get<std::string>());
        }
        return lines;
    }

    // The values of an attribute, `columns` for each splat; nothing if the attribute is missing.
    Result<std::optional<std::vector<float>>> values(const Json& names, const std::string& name,
                                                     std::size_t columns) const {
        using Values = std::optional<std::vector<float>>;
        const auto index = wholeNumber(names, name);
        if (!index) return Values();
        const Json* accessor = element(json_, "accessors", *index);
        if (accessor == nullptr || member(*accessor, "sparse") != nullptr) return damaged();
        constexpr std::array<std::string_view, 5> kTypes{"", "SCALAR", "VEC2", "VEC3", "VEC4"};
        const auto count = wholeNumber(*accessor, "count");
        const auto view = wholeNumber(*accessor, "bufferView");
        const auto type = wholeNumber(*accessor, "componentType");
        const auto component = std::ranges::find_if(
            kComponents, [&](const Component& c) { return type && std::uint64_t(c.type) == *type; });
        if (!count || !view || component == kComponents.end() ||
            textIn(*accessor, "type") != kTypes.at(columns))
            return damaged();
        MACULA_TRY(const Rows rows, rowsOf(*view, wholeNumber(*accessor, "byteOffset").value_or(0), *count,
                                           columns * component->bytes));
        const Json* normalized = member(*accessor, "normalized");
        const bool isNormalized =
            normalized != nullptr && *normalized == true && component->type != glb::kFloat;
        std::vector<float> read(*count * columns);
        for (std::uint64_t i = 0; i < *count; ++i) {
            for (std::size_t c = 0; c < columns; ++c) {
                double value = valueOf(rows.first + i * rows.stride + c * component->bytes, *component);
                if (isNormalized) value = std::max(value / component->high, component->isSigned ? -1.0 : 0.0);
                read[i * columns + c] = static_cast<float>(value);
            }
        }
        return Values(std::move(read));
    }

    struct Rows {
        const std::byte* first = nullptr;
        std::uint64_t stride = 0;
    };
    // The rows of an accessor, checked to lie within the file.
    Result<Rows> rowsOf(std::uint64_t index, std::uint64_t offset, std::uint64_t count,
                        std::uint64_t rowBytes) const {
        const Json* view = element(json_, "bufferViews", index);
        if (view == nullptr || wholeNumber(*view, "buffer") != std::optional<std::uint64_t>(0) ||
            member(*view, "extensions") != nullptr)
            return unusable(Text("The Gaussians are not in the glTF file itself."),
                            Text("Export it as one binary file (.glb), without compression."));
        const std::uint64_t from = wholeNumber(*view, "byteOffset").value_or(0);
        const auto bytes = wholeNumber(*view, "byteLength");
        const std::uint64_t stride = wholeNumber(*view, "byteStride").value_or(rowBytes);
        if (!bytes || from > binary_.size() || *bytes > binary_.size() - from || stride < rowBytes ||
            stride > *bytes || offset > *bytes || count == 0 || rowBytes > *bytes - offset ||
            count - 1 > (*bytes - offset - rowBytes) / stride)
            return count == 0 ? unusable(Text("The model holds no splats."), Text("Export it again."))
                              : damaged();
        return Rows{.first = binary_.data() + from + offset, .stride = stride};
    }

    Result<std::vector<float>> needed(const Json& names, const std::string& name, std::size_t columns,
                                      std::size_t count) const {
        MACULA_TRY(auto found, values(names, name, columns));
        if (!found || found->size() != count * columns)
            return unusable(Text("The glTF file lacks the attribute {} of some Gaussians.", name));
        return std::move(*found);
    }

    Result<Splats> readAttributes(const Json& names) const {
        MACULA_TRY(const auto positions, values(names, "POSITION", 3));
        if (!positions) return damaged();
        const std::size_t count = positions->size() / 3;
        MACULA_TRY(const std::vector<float> rotations, needed(names, glb::attribute("ROTATION"), 4, count));
        MACULA_TRY(const std::vector<float> scales, needed(names, glb::attribute("SCALE"), 3, count));
        MACULA_TRY(const std::vector<float> opacities, needed(names, glb::attribute("OPACITY"), 1, count));
        MACULA_TRY(const std::vector<float> dc, needed(names, glb::harmonic(0, 0), 3, count));
        Splats splats;
        while (splats.shDegree < kMaxShDegree &&
               member(names, glb::harmonic(splats.shDegree + 1, 0)) != nullptr)
            ++splats.shDegree;
        splats.resize(count);
        const auto three = [](const std::vector<float>& from, std::size_t i) {
            return glm::vec3(from[3 * i], from[3 * i + 1], from[3 * i + 2]);
        };
        for (std::size_t i = 0; i < count; ++i) {
            splats.position[i] = three(*positions, i);
            splats.rotation[i] = {rotations[4 * i + 3], rotations[4 * i], rotations[4 * i + 1],
                                  rotations[4 * i + 2]};
            splats.opacityLogit[i] = logitOf(opacities[i]);
            splats.logScale[i] = logOf(three(scales, i));
            splats.dc[i] = three(dc, i);
        }
        const std::size_t perSplat = shCount(splats.shDegree);
        std::size_t k = 0;
        for (int degree = 1; degree <= splats.shDegree; ++degree) {
            for (int n = 0; n <= 2 * degree; ++n, ++k) {
                MACULA_TRY(const std::vector<float> coefficients,
                           needed(names, glb::harmonic(degree, n), 3, count));
                for (std::size_t i = 0; i < count; ++i) splats.sh[i * perSplat + k] = three(coefficients, i);
            }
        }
        return splats;
    }

    // An impossible opacity or scale becomes a number that is not finite, which is then refused or repaired.
    static float logitOf(float opacity) {
        const double o = opacity;
        if (!(o >= 0.0 && o <= 1.0)) return std::numeric_limits<float>::quiet_NaN();
        return static_cast<float>(
            std::clamp(std::log(o) - std::log1p(-o), -double(kMaxOpacityLogit), double(kMaxOpacityLogit)));
    }
    static glm::vec3 logOf(const glm::vec3& scale) {
        glm::vec3 logs(0.0f);
        for (int axis = 0; axis < 3; ++axis) {
            const double log = std::log(double(scale[axis]));  // NaN below 0
            logs[axis] = static_cast<float>(log < -double(kMaxLogScale) ? -double(kMaxLogScale) : log);
        }
        return logs;
    }

    const Json& json_;
    Bytes binary_;
};

}  // namespace

Result<ModelFile> decodeGlb(std::span<const std::byte> bytes, BadSplats bad) {
    MACULA_TRY(const Parts parts, partsOf(bytes));
    MACULA_TRY(Splats splats, Reader(parts).read());
    return finishModel(std::move(splats), bad);
}

}  // namespace macula::splat
