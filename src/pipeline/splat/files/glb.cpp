#include "pipeline/splat/files/glb.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "pipeline/splat/files/glb_layout.h"
#include "pipeline/splat/files/model_notes.h"
#include "pipeline/splat/model/constant_colour.h"

namespace macula::splat {

namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "values are written as they lie in memory");

constexpr double kMetresPerMm = 1e-3;

// The attributes of the primitive, one after another, and their entries in the JSON.
class Attributes {
  public:
    template <class Value>
    void add(const std::string& name, const char* type, const std::vector<Value>& values) {
        addView(name, type, glb::kFloat, values.size(), values.data(), values.size() * sizeof(Value));
    }
    // glTF requires the bounding box of positions.
    void addPositions(const std::vector<glm::vec3>& positions) {
        glm::vec3 low(std::numeric_limits<float>::max());
        glm::vec3 high(std::numeric_limits<float>::lowest());
        for (const glm::vec3& p : positions) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
        add("POSITION", "VEC3", positions);
        accessors_.back()["min"] = Json{low.x, low.y, low.z};
        accessors_.back()["max"] = Json{high.x, high.y, high.z};
    }
    void addColours(const std::vector<std::uint32_t>& rgba8) {
        addView("COLOR_0", "VEC4", glb::kUnsignedByte, rgba8.size(), rgba8.data(), rgba8.size() * 4);
        accessors_.back()["normalized"] = true;
    }

    Json names() const { return names_; }
    void putInto(Json& json) const {
        json["accessors"] = accessors_;
        json["bufferViews"] = views_;
        json["buffers"] = Json::array({{{"byteLength", bytes_.size()}}});
    }
    const std::string& bytes() const { return bytes_; }

  private:
    void addView(const std::string& name, const char* type, int component, std::size_t count,
                 const void* data, std::size_t bytes) {
        names_[name] = accessors_.size();
        accessors_.push_back(
            {{"bufferView", views_.size()}, {"componentType", component}, {"count", count}, {"type", type}});
        views_.push_back({{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes}});
        bytes_.append(static_cast<const char*>(data), bytes);  // always a multiple of 4
    }

    Json names_ = Json::object();
    Json accessors_ = Json::array();
    Json views_ = Json::array();
    std::string bytes_;
};

float limited(float value, float most) {
    return std::clamp(value, -most, most);
}

bool isBeyond(const Splats& splats, std::size_t i) {
    const glm::vec3 scale = glm::abs(splats.logScale[i]);
    return std::max({scale.x, scale.y, scale.z}) > kMaxLogScale ||
           std::abs(splats.opacityLogit[i]) > kMaxOpacityLogit;
}

float opacityOf(float logit) {
    return static_cast<float>(1.0 / (1.0 + std::exp(-double(limited(logit, kMaxOpacityLogit)))));
}

std::uint32_t rgba8(const glm::vec3& colour, float opacity) {
    const auto byte = [](float value) {
        return static_cast<std::uint32_t>(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f)));
    };
    return byte(colour.r) | byte(colour.g) << 8u | byte(colour.b) << 16u | byte(opacity) << 24u;
}

Attributes attributesOf(const Splats& splats, std::size_t& clamped) {
    const std::size_t count = splats.size();
    std::vector<glm::vec4> rotations(count);
    std::vector<glm::vec3> scales(count);
    std::vector<float> opacities(count);
    std::vector<std::uint32_t> colours(count);
    for (std::size_t i = 0; i < count; ++i) {
        clamped += isBeyond(splats, i) ? 1 : 0;
        const glm::dvec4 wxyz = glm::normalize(glm::dvec4(splats.rotation[i]));
        rotations[i] = glm::vec4(glm::dvec4(wxyz[1], wxyz[2], wxyz[3], wxyz[0]));
        for (int axis = 0; axis < 3; ++axis)
            scales[i][axis] =
                static_cast<float>(std::exp(double(limited(splats.logScale[i][axis], kMaxLogScale))));
        opacities[i] = opacityOf(splats.opacityLogit[i]);
        colours[i] = rgba8(colourOfDc(splats.dc[i]), opacities[i]);
    }
    Attributes attributes;
    attributes.addPositions(splats.position);
    attributes.add(glb::attribute("ROTATION"), "VEC4", rotations);
    attributes.add(glb::attribute("SCALE"), "VEC3", scales);
    attributes.add(glb::attribute("OPACITY"), "SCALAR", opacities);
    attributes.add(glb::harmonic(0, 0), "VEC3", splats.dc);
    const std::size_t perSplat = shCount(splats.shDegree);
    std::size_t k = 0;
    for (int degree = 1; degree <= splats.shDegree; ++degree) {
        for (int n = 0; n <= 2 * degree; ++n, ++k) {
            std::vector<glm::vec3> coefficients(count);
            for (std::size_t i = 0; i < count; ++i) coefficients[i] = splats.sh[i * perSplat + k];
            attributes.add(glb::harmonic(degree, n), "VEC3", coefficients);
        }
    }
    attributes.addColours(colours);
    return attributes;
}

// The node that converts the model to glTF's axes and metres.
Json nodeOf(const Splats& splats) {
    if (splats.axes == Axes::unknown) return {{"mesh", 0}, {"rotation", {1.0, 0.0, 0.0, 0.0}}};
    const double half = std::sqrt(0.5);
    const glm::dvec3 metres = kMetresPerMm * splats.originMm;
    return {{"mesh", 0},
            {"rotation", {-half, 0.0, 0.0, half}},
            {"scale", {kMetresPerMm, kMetresPerMm, kMetresPerMm}},
            {"translation", {metres.x, metres.z, -metres.y}}};  // x left, z superior, -y anterior
}

Json jsonOf(const Splats& splats, const Attributes& attributes) {
    const bool isLinear = splats.colourSpace == ColourSpace::linear;
    Json json{{"asset",
               {{"version", "2.0"}, {"generator", "Macula"}, {"extras", {{glb::kNotes, notesOf(splats)}}}}},
              {"extensionsUsed", Json::array({glb::kExtension})},
              {"scene", 0},
              {"scenes", Json::array({{{"nodes", Json::array({0})}}})},
              {"nodes", Json::array({nodeOf(splats)})}};
    const Json splatting{{"kernel", glb::kKernel},
                         {"colorSpace", isLinear ? glb::kLinearColours : glb::kDisplayColours},
                         {"projection", "perspective"},
                         {"sortingMethod", "cameraDistance"}};
    const Json primitive{{"attributes", attributes.names()},
                         {"mode", glb::kPoints},
                         {"extensions", {{glb::kExtension, splatting}}}};
    json["meshes"] = Json::array({{{"primitives", Json::array({primitive})}}});
    attributes.putInto(json);
    return json;
}

void putNumber(std::ostream& stream, std::uint32_t number) {
    stream.write(reinterpret_cast<const char*>(&number), sizeof(number));
}

void putChunk(std::ostream& stream, std::uint32_t kind, const std::string& bytes) {
    putNumber(stream, static_cast<std::uint32_t>(bytes.size()));
    putNumber(stream, kind);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace

Result<std::size_t> writeGlb(std::ostream& stream, const Splats& splats) {
    MACULA_TRY_VOID(splats.validate());
    const Error tooLarge{ErrorCode::inputNotUsable,
                         Text("The model is too large for a glTF file."),
                         {},
                         Text("Write it as .ply instead.")};
    if (splats.size() == 0)
        return Error{
            ErrorCode::inputNotUsable, Text("The model holds no splats."), {}, Text("Train it again.")};
    const std::uint64_t floats = 3 + 4 + 3 + 1 + 1 + 3 * (1 + shCount(splats.shDegree));
    if (splats.size() > (kMostGlbBytes - (1u << 20)) / (4 * floats)) return tooLarge;
    std::size_t clamped = 0;
    const Attributes attributes = attributesOf(splats, clamped);
    std::string json = jsonOf(splats, attributes).dump();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    stream.write(glb::kMagic.data(), static_cast<std::streamsize>(glb::kMagic.size()));
    putNumber(stream, glb::kVersion);
    putNumber(stream, static_cast<std::uint32_t>(glb::kHeaderBytes + 2 * glb::kChunkHeaderBytes +
                                                 json.size() + attributes.bytes().size()));
    putChunk(stream, glb::kJsonChunk, json);
    putChunk(stream, glb::kBinaryChunk, attributes.bytes());
    return clamped;
}

bool looksLikeGlb(std::string_view begin) {
    return begin.starts_with(glb::kMagic);
}

}  // namespace macula::splat
