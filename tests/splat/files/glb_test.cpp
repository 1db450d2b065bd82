// glTF files of splats: what others will read in them, and what comes back.
#include "pipeline/splat/files/glb.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "splat/model_support.h"

namespace macula::splat {
namespace {

using Json = nlohmann::json;

std::string bytesOf(const Splats& splats) {
    std::ostringstream stream;
    const auto written = writeGlb(stream, splats);
    EXPECT_TRUE(written.ok()) << written.error().message;
    return stream.str();
}

Result<ModelFile> decoded(const std::string& bytes, BadSplats bad = BadSplats::refuse) {
    return decodeGlb(std::as_bytes(std::span(bytes.data(), bytes.size())), bad);
}

std::uint32_t wordAt(const std::string& bytes, std::size_t at) {
    std::uint32_t word = 0;
    std::memcpy(&word, &bytes.at(at), sizeof(word));
    return word;
}

// A reader by the specification alone, which knows nothing of ours.
struct Gltf {
    explicit Gltf(const std::string& bytes) {
        EXPECT_EQ(bytes.substr(0, 4), "glTF");
        EXPECT_EQ(wordAt(bytes, 4), 2u);
        EXPECT_EQ(wordAt(bytes, 8), bytes.size());
        const std::uint32_t text = wordAt(bytes, 12);
        EXPECT_EQ(bytes.substr(16, 4), "JSON");
        EXPECT_EQ(text % 4, 0u);
        json = Json::parse(bytes.substr(20, text));
        EXPECT_EQ(wordAt(bytes, 20 + text + 4), 0x004e4942u);
        binary = bytes.substr(28 + text);
        EXPECT_EQ(wordAt(bytes, 20 + text), binary.size());
        EXPECT_EQ(json["buffers"][0]["byteLength"], binary.size());
        primitive = json["meshes"][0]["primitives"][0];
    }
    // Of one splat.
    std::vector<float> values(const std::string& name, std::size_t splat) const {
        const Json& accessor = json["accessors"][primitive["attributes"].at(name).get<std::size_t>()];
        const Json& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
        EXPECT_EQ(accessor["componentType"], 5126);
        EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0u);
        const std::size_t columns = accessor["type"] == "SCALAR" ? 1 : accessor["type"] == "VEC3" ? 3 : 4;
        EXPECT_EQ(view["byteLength"], accessor["count"].get<std::size_t>() * columns * 4);
        std::vector<float> row(columns);
        std::memcpy(row.data(), &binary.at(view["byteOffset"].get<std::size_t>() + splat * columns * 4),
                    columns * 4);
        return row;
    }

    Json json;
    Json primitive;
    std::string binary;
};

const std::string kName = "KHR_gaussian_splatting:";

TEST(Glb, IsWhatTheExtensionSays) {
    Splats splats = testing::randomModel(7, 2, 11);
    splats.colourSpace = ColourSpace::display;
    const Gltf file(bytesOf(splats));
    EXPECT_EQ(file.json["asset"]["version"], "2.0");
    EXPECT_EQ(file.json["extensionsUsed"], Json::array({"KHR_gaussian_splatting"}));
    EXPECT_EQ(file.primitive["mode"], 0);
    const Json& splatting = file.primitive["extensions"]["KHR_gaussian_splatting"];
    EXPECT_EQ(splatting["kernel"], "ellipse");
    EXPECT_EQ(splatting["colorSpace"], "srgb_rec709_display");
    for (std::size_t i = 0; i < splats.size(); ++i) {
        const auto position = file.values("POSITION", i);
        const auto scale = file.values(kName + "SCALE", i);
        const auto rotation = file.values(kName + "ROTATION", i);
        const glm::dvec4 wxyz = glm::normalize(glm::dvec4(splats.rotation[i]));
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_EQ(position[std::size_t(axis)], splats.position[i][axis]);
            EXPECT_NEAR(scale[std::size_t(axis)] / std::exp(splats.logScale[i][axis]), 1.0, 1e-5);
            EXPECT_NEAR(rotation[std::size_t(axis)], wxyz[axis + 1], 1e-6);
        }
        EXPECT_NEAR(rotation[3], wxyz[0], 1e-6);
        EXPECT_NEAR(file.values(kName + "OPACITY", i)[0], 1.0 / (1.0 + std::exp(-splats.opacityLogit[i])),
                    1e-6);
        EXPECT_EQ(file.values(kName + "SH_DEGREE_0_COEF_0", i)[2], splats.dc[i].b);
        EXPECT_EQ(file.values(kName + "SH_DEGREE_1_COEF_2", i)[0], splats.sh[8 * i + 2].r);
        EXPECT_EQ(file.values(kName + "SH_DEGREE_2_COEF_0", i)[1], splats.sh[8 * i + 3].g);
        EXPECT_EQ(file.values(kName + "SH_DEGREE_2_COEF_4", i)[1], splats.sh[8 * i + 7].g);
    }
    EXPECT_FALSE(file.primitive["attributes"].contains(kName + "SH_DEGREE_3_COEF_0"));
    glm::vec3 low = splats.position[0];
    for (const glm::vec3& p : splats.position) low = glm::min(low, p);
    const Json& position =
        file.json["accessors"][file.primitive["attributes"]["POSITION"].get<std::size_t>()];
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_EQ(position["min"][axis], low[int(axis)]);
}

// glTF is y up, faces z, and is in metres. Left stays left.
TEST(Glb, APatientStandsAndIsNotMirrored) {
    Splats splats = testing::randomModel(1, 0, 1);
    splats.originMm = {1000.0, 2000.0, 3000.0};
    const Json node = Gltf(bytesOf(splats)).json["nodes"][0];
    const glm::dvec4 xyzw(node["rotation"][0].get<double>(), node["rotation"][1].get<double>(),
                          node["rotation"][2].get<double>(), node["rotation"][3].get<double>());
    const glm::dmat3 turn = testing::matrixOf(glm::vec4(xyzw.w, xyzw.x, xyzw.y, xyzw.z));
    const auto goesTo = [&](const glm::dvec3& from, const glm::dvec3& to) {
        EXPECT_LT(glm::distance(turn * from, to), 1e-6);
    };
    goesTo({1, 0, 0}, {1, 0, 0});   // left
    goesTo({0, 0, 1}, {0, 1, 0});   // superior is up
    goesTo({0, -1, 0}, {0, 0, 1});  // anterior faces z
    EXPECT_NEAR(glm::determinant(turn), 1.0, 1e-6);
    EXPECT_EQ(node["scale"][0], 1e-3);
    const glm::dvec3 place(node["translation"][0].get<double>(), node["translation"][1].get<double>(),
                           node["translation"][2].get<double>());
    EXPECT_LT(glm::distance(place, turn * (1e-3 * splats.originMm)), 1e-6);
}

TEST(Glb, AModelComesBack) {
    for (int degree = 0; degree <= kMaxShDegree; ++degree) {
        for (const ColourSpace colours : {ColourSpace::linear, ColourSpace::display}) {
            Splats splats = testing::randomModel(50, degree, unsigned(degree) + 5);
            splats.colourSpace = colours;
            const auto read = decoded(bytesOf(splats));
            ASSERT_TRUE(read.ok()) << read.error().message;
            const Splats& back = read->splats;
            EXPECT_EQ(back.originMm, splats.originMm);
            EXPECT_EQ(back.axes, splats.axes);
            EXPECT_EQ(back.colourSpace, colours);
            EXPECT_EQ(back.lowPass, splats.lowPass);
            ASSERT_EQ(back.shDegree, degree);
            EXPECT_TRUE(testing::sameBits(back.position, splats.position));
            EXPECT_TRUE(testing::sameBits(back.dc, splats.dc));
            EXPECT_TRUE(testing::sameBits(back.sh, splats.sh));
            for (std::size_t i = 0; i < splats.size(); ++i) {
                EXPECT_LT(glm::length(back.logScale[i] - splats.logScale[i]), 1e-5f);
                EXPECT_NEAR(back.opacityLogit[i], splats.opacityLogit[i], 1e-3);
                EXPECT_LT(glm::length(back.rotation[i] - glm::normalize(splats.rotation[i])), 1e-6f);
            }
        }
    }
}

TEST(Glb, ExtremesAreClampedAndCounted) {
    Splats splats = testing::randomModel(3, 0, 2);
    splats.logScale[0] = {-200.0f, 200.0f, 0.0f};
    splats.opacityLogit[1] = 300.0f;
    std::ostringstream stream;
    const auto written = writeGlb(stream, splats);
    ASSERT_TRUE(written.ok());
    EXPECT_EQ(*written, 2u);
    const auto read = decoded(stream.str());
    ASSERT_TRUE(read.ok());
    EXPECT_NEAR(read->splats.logScale[0].x, -kMaxLogScale, 1e-3);
    EXPECT_NEAR(read->splats.logScale[0].y, kMaxLogScale, 1e-3);
    EXPECT_EQ(read->splats.opacityLogit[1], kMaxOpacityLogit);
    Splats bad = splats;
    bad.position[2].y = std::nanf("");
    for (const Splats& refused : {bad, Splats()}) {
        std::ostringstream none;
        const auto refusal = writeGlb(none, refused);
        ASSERT_FALSE(refusal.ok());
        EXPECT_EQ(refusal.error().code, ErrorCode::inputNotUsable);
        EXPECT_TRUE(none.str().empty());
    }
}

// A file with that JSON, and the binary chunk of another.
std::string withJson(const std::string& bytes, const std::function<void(Json&)>& edit) {
    const std::uint32_t text = wordAt(bytes, 12);
    Json json = Json::parse(bytes.substr(20, text));
    edit(json);
    std::string edited = json.dump();
    edited.resize((edited.size() + 3) / 4 * 4, ' ');
    std::string whole = bytes.substr(0, 20) + edited + bytes.substr(20 + text);
    const auto put = [&](std::size_t at, std::size_t value) {
        const auto word = std::uint32_t(value);
        std::memcpy(&whole[at], &word, sizeof(word));
    };
    put(8, whole.size());
    put(12, edited.size());
    return whole;
}

TEST(Glb, FilesOfOthersAreOfUnknownAxes) {
    Splats splats = testing::randomModel(4, 0, 3);
    splats.colourSpace = ColourSpace::display;
    const std::string foreign = withJson(bytesOf(splats), [](Json& json) { json["asset"].erase("extras"); });
    const auto read = decoded(foreign);
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(read->splats.axes, Axes::unknown);
    EXPECT_EQ(read->splats.lowPass, LowPass::classic);
    splats.colourSpace = ColourSpace::linear;
    EXPECT_FALSE(decoded(withJson(bytesOf(splats), [](Json& json) { json["asset"].erase("extras"); })).ok());
}

TEST(Glb, OpacitiesMayBeBytes) {
    Splats splats = testing::randomModel(4, 0, 3);
    splats.opacityLogit = {-2.0f, 0.0f, 1.0f, 2.0f};
    const std::string bytes = withJson(bytesOf(splats), [](Json& json) {
        // The fourth byte of each fallback colour is the opacity.
        const std::size_t colours = json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"];
        const std::size_t opacities =
            json["meshes"][0]["primitives"][0]["attributes"]["KHR_gaussian_splatting:OPACITY"];
        Json& accessor = json["accessors"][opacities];
        accessor["componentType"] = 5121;
        accessor["normalized"] = true;
        accessor["bufferView"] = json["accessors"][colours]["bufferView"];
        accessor["byteOffset"] = 3;
        json["bufferViews"][accessor["bufferView"].get<std::size_t>()]["byteStride"] = 4;
    });
    const auto read = decoded(bytes);
    ASSERT_TRUE(read.ok()) << read.error().message;
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(read->splats.opacityLogit[i], splats.opacityLogit[i], 0.05);
}

TEST(Glb, WhatIsWrongIsSaid) {
    const std::string good = bytesOf(testing::randomModel(4, 1, 3));
    const auto refused = [&](const std::function<void(Json&)>& edit) {
        const auto read = decoded(withJson(good, edit));
        EXPECT_FALSE(read.ok());
        if (!read) {
            EXPECT_EQ(read.error().code, ErrorCode::inputNotUsable);
        }
    };
    const auto attributes = [](Json& json) -> Json& {
        return json["meshes"][0]["primitives"][0]["attributes"];
    };
    refused([&](Json& json) { attributes(json).erase(kName + "SCALE"); });
    refused([&](Json& json) { attributes(json).erase(kName + "SH_DEGREE_1_COEF_1"); });
    refused([&](Json& json) { attributes(json)["POSITION"] = 99; });
    refused([&](Json& json) { json["accessors"][0]["count"] = 5; });
    refused([&](Json& json) { json["accessors"][0]["count"] = 0; });
    refused([&](Json& json) { json["accessors"][0]["byteOffset"] = ~std::uint64_t(0); });
    refused([&](Json& json) { json["accessors"][0]["sparse"] = Json::object(); });
    refused([&](Json& json) { json["bufferViews"][0]["byteOffset"] = std::uint64_t(1) << 40; });
    refused([&](Json& json) { json["bufferViews"][0]["byteStride"] = std::uint64_t(1) << 63; });
    refused([&](Json& json) { json["extensionsRequired"] = Json::array({"EXT_meshopt_compression"}); });
    refused([&](Json& json) { json["meshes"] = 3; });
    refused([&](Json& json) {
        json["meshes"][0]["primitives"][0]["extensions"]["KHR_gaussian_splatting"]["kernel"] = "disk";
    });
}

TEST(Glb, DamageNeverGoesUnnoticedInACrash) {
    const std::string good = bytesOf(testing::randomModel(20, 1, 9));
    std::mt19937 random(4);
    for (int i = 0; i < 400; ++i) {
        const std::string bytes = testing::mutated(good, random);
        const auto read = decoded(bytes, BadSplats::repairOrNone);
        if (read) {
            EXPECT_TRUE(read->splats.validate().ok());
        }
    }
    for (const std::size_t length : {0u, 4u, 12u, 19u, 20u, 100u})
        EXPECT_FALSE(decoded(good.substr(0, length)).ok());
}

}  // namespace
}  // namespace macula::splat
