#include "pipeline/splat/files/ply.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "splat/model_support.h"

namespace macula::splat {
namespace {

std::string written(const Splats& splats) {
    std::ostringstream stream;
    EXPECT_TRUE(writePly(stream, splats).ok());
    return stream.str();
}

Result<ModelFile> parse(const std::string& bytes, BadSplats bad = BadSplats::refuse) {
    std::istringstream stream(bytes);
    return readPly(stream, bytes.size(), bad);
}

template <class T>
void append(std::string& bytes, T value, bool bigEndian = false) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    if (bigEndian) std::reverse(raw, raw + sizeof value);
    bytes.append(raw, sizeof value);
}

float floatAt(const std::string& bytes, std::size_t offset) {
    float value = 0;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

// A file as the authors' own code writes it: 62 properties, degree 3.
std::string foreignHeader(std::size_t count, const char* format = "binary_little_endian") {
    std::string text =
        std::string("ply\nformat ") + format + " 1.0\nelement vertex " + std::to_string(count) + "\n";
    const auto add = [&](const std::string& name) { text += "property float " + name + "\n"; };
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz", "f_dc_0", "f_dc_1", "f_dc_2"}) add(name);
    for (int k = 0; k < 45; ++k) add("f_rest_" + std::to_string(k));
    for (const char* name : {"opacity", "scale_0", "scale_1", "scale_2", "rot_0", "rot_1", "rot_2", "rot_3"})
        add(name);
    return text + "end_header\n";
}

TEST(Ply, RoundTripIsExact) {
    for (int degree = 0; degree <= kMaxShDegree; ++degree) {
        Splats splats = testing::randomModel(50, degree, 7);
        splats.position[0] = glm::vec3(-0.0f, 1e-42f, 3e38f);
        splats.logScale[1] = glm::vec3(100.0f, -100.0f, 0.1f);
        splats.opacityLogit[2] = 1e30f;
        if (degree == 1) {
            splats.axes = Axes::unknown;
            splats.colourSpace = ColourSpace::display;
        }
        if (degree == 2) splats.lowPass = LowPass::classic;
        if (degree == 3) splats.lowPass = LowPass::mip;
        const std::string bytes = written(splats);
        const auto read = parse(bytes);
        ASSERT_TRUE(read.ok()) << read.error().message;
        EXPECT_TRUE(testing::sameBits(read->splats, splats)) << degree;
        EXPECT_EQ(written(read->splats), bytes);
    }
}

TEST(Ply, OursIsLaidOutAsTheConventionSays) {
    Splats splats;
    splats.originMm = glm::dvec3(0.1, -2.0, 1e6);
    splats.shDegree = 1;
    splats.resize(2);
    splats.position[1] = glm::vec3(1, 2, 3);
    splats.dc[1] = glm::vec3(4, 5, 6);
    for (int k = 0; k < 3; ++k)
        splats.sh[3 + static_cast<std::size_t>(k)] =
            glm::vec3(7 + k, 10 + k, 13 + k);  // channel-major: 7 to 15
    splats.opacityLogit[1] = 16;
    splats.logScale[1] = glm::vec3(17, 18, 19);
    splats.rotation[1] = glm::vec4(20, 21, 22, 23);
    const std::string bytes = written(splats);
    const std::string header =
        "ply\nformat binary_little_endian 1.0\n"
        "comment macula model 1\ncomment macula axes patient-lps-mm\n"
        "comment macula origin-mm 0.1 -2 1e+06\ncomment macula colours linear\n"
        "comment macula low-pass adaptive\n"
        "element vertex 2\n"
        "property float x\nproperty float y\nproperty float z\n"
        "property float nx\nproperty float ny\nproperty float nz\n"
        "property float f_dc_0\nproperty float f_dc_1\nproperty float f_dc_2\n"
        "property float f_rest_0\nproperty float f_rest_1\nproperty float f_rest_2\n"
        "property float f_rest_3\nproperty float f_rest_4\nproperty float f_rest_5\n"
        "property float f_rest_6\nproperty float f_rest_7\nproperty float f_rest_8\n"
        "property float opacity\nproperty float scale_0\nproperty float scale_1\nproperty float scale_2\n"
        "property float rot_0\nproperty float rot_1\nproperty float rot_2\nproperty float rot_3\n"
        "end_header\n";
    ASSERT_EQ(bytes.substr(0, header.size()), header);
    constexpr std::size_t kRow = 26 * 4;
    ASSERT_EQ(bytes.size(), header.size() + 2 * kRow);
    const std::size_t second = header.size() + kRow;
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(floatAt(bytes, second + 4 * (3 + k)), 0.0f);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(floatAt(bytes, second + 4 * k), static_cast<float>(k + 1));
    for (std::size_t k = 6; k < 26; ++k) EXPECT_EQ(floatAt(bytes, second + 4 * k), static_cast<float>(k - 2));
}

TEST(Ply, ForeignFilesAreReadAsTheyAreWrittenElsewhere) {
    std::string bytes = foreignHeader(3);
    for (int row = 0; row < 3; ++row) {
        for (int k = 0; k < 62; ++k) append(bytes, static_cast<float>(100 * row + k));
    }
    const auto read = parse(bytes);
    ASSERT_TRUE(read.ok()) << read.error().message;
    const Splats& s = read->splats;
    ASSERT_EQ(s.size(), 3u);
    EXPECT_EQ(s.shDegree, 3);
    EXPECT_EQ(s.axes, Axes::unknown);
    EXPECT_EQ(s.colourSpace, ColourSpace::display);
    EXPECT_EQ(s.lowPass, LowPass::classic);
    EXPECT_EQ(s.originMm, glm::dvec3(0.0));
    EXPECT_EQ(s.position[2], glm::vec3(200, 201, 202));
    EXPECT_EQ(s.dc[1], glm::vec3(106, 107, 108));
    EXPECT_EQ(s.sh[15 + 0], glm::vec3(109, 124, 139));
    EXPECT_EQ(s.sh[15 + 14], glm::vec3(123, 138, 153));
    EXPECT_EQ(s.opacityLogit[0], 54);
    EXPECT_EQ(s.logScale[0], glm::vec3(55, 56, 57));
    EXPECT_EQ(s.rotation[1], glm::vec4(158, 159, 160, 161));
}

// The same two splats in other words.
constexpr double kTwo[2][14] = {{1, 2, 3, 0.25, 0.5, 0.75, -1, 1, 0, -1, 1, 0, 0.5, 0},
                                {-1.5, 0, 7, 1, 0, -1, 2.5, 0.125, 0, 0, 0, 1, 0, 0}};
constexpr const char* kNames[14] = {"x",       "y",       "z",       "f_dc_0", "f_dc_1", "f_dc_2", "opacity",
                                    "scale_0", "scale_1", "scale_2", "rot_0",  "rot_1",  "rot_2",  "rot_3"};

void expectTwo(const Result<ModelFile>& read) {
    ASSERT_TRUE(read.ok()) << read.error().message;
    const Splats& s = read->splats;
    ASSERT_EQ(s.size(), 2u);
    EXPECT_EQ(s.shDegree, 0);
    for (std::size_t i = 0; i < 2; ++i) {
        const auto row = [&](int k) { return static_cast<float>(kTwo[i][k]); };
        EXPECT_EQ(s.position[i], glm::vec3(row(0), row(1), row(2)));
        EXPECT_EQ(s.dc[i], glm::vec3(row(3), row(4), row(5)));
        EXPECT_EQ(s.opacityLogit[i], row(6));
        EXPECT_EQ(s.logScale[i], glm::vec3(row(7), row(8), row(9)));
        EXPECT_EQ(s.rotation[i], glm::vec4(row(10), row(11), row(12), row(13)));
    }
}

// One splat, in the words of another program.
Result<ModelFile> oneOf(const std::vector<std::pair<std::string, std::string>>& typesAndNames,
                        const std::string& row) {
    std::string text = "ply\nformat ascii 1.0\nelement vertex 1\n";
    for (const auto& [type, name] : typesAndNames) text += "property " + type + " " + name + "\n";
    return parse(text + "end_header\n" + row + "\n");
}

std::vector<std::pair<std::string, std::string>> usualNames() {
    std::vector<std::pair<std::string, std::string>> names;
    for (const char* name : kNames) names.emplace_back("float", name);
    return names;
}

TEST(Ply, ColoursMayBeBytes) {
    auto names = usualNames();
    names[3] = {"uchar", "red"};
    names[4] = {"uchar", "green"};
    names[5] = {"uchar", "blue"};
    const auto read = oneOf(names, "1 2 3 255 51 0 -1 1 0 -1 1 0 0 0");
    ASSERT_TRUE(read.ok()) << read.error().message;
    for (int c = 0; c < 3; ++c) {
        const double wanted[] = {1.0, 0.2, 0.0};
        EXPECT_NEAR(0.5 + 0.28209479177387814 * double(read->splats.dc[0][c]), wanted[c], 1e-6);
    }
    // Beside coefficients they are what points were before they became splats.
    names = usualNames();
    names.emplace_back("uchar", "red");
    const auto both = oneOf(names, "1 2 3 0.25 0.5 0.75 -1 1 0 -1 1 0 0 0 255");
    ASSERT_TRUE(both.ok()) << both.error().message;
    EXPECT_EQ(both->splats.dc[0], glm::vec3(0.25f, 0.5f, 0.75f));
    // Of floats nobody knows how far they go.
    names = usualNames();
    names[3] = {"float", "red"};
    names[4] = {"float", "green"};
    names[5] = {"float", "blue"};
    EXPECT_FALSE(oneOf(names, "1 2 3 1 0 0 -1 1 0 -1 1 0 0 0").ok());
}

TEST(Ply, SplatsMayBeFlat) {
    auto names = usualNames();
    names.erase(names.begin() + 9);
    const auto read = oneOf(names, "1 2 3 0.25 0.5 0.75 -1 1 0.5 1 0 0 0");
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(read->splats.logScale[0], glm::vec3(1.0f, 0.5f, -kMaxLogScale));
    EXPECT_EQ(read->splats.lowPass, LowPass::classic);
}

// Yu et al. 2024: deviations sqrt(s^2 + f^2), and opacity times the share of the volume that they had before.
TEST(Ply, MipSplattingsFilterIsPartOfTheModel) {
    auto names = usualNames();
    names.emplace_back("float", "filter_3D");
    const auto drawn = [&](double logit, const glm::dvec3& logScale, double filter, glm::dvec3& deviation) {
        const auto read = oneOf(names, fmt::format("1 2 3 0 0 0 {} {} {} {} 1 0 0 0 {}", logit, logScale.x,
                                                   logScale.y, logScale.z, filter));
        if (!read.ok()) {
            ADD_FAILURE() << read.error().message;
            return 0.0;
        }
        EXPECT_EQ(read->splats.lowPass, LowPass::mip);
        deviation = glm::exp(glm::dvec3(read->splats.logScale[0]));
        return 1.0 / (1.0 + std::exp(-double(read->splats.opacityLogit[0])));
    };
    for (const double logit : {-8.0, -0.5, 0.0, 2.0, 12.0}) {
        for (const double filter : {1e-6, 0.02, 0.3, 5.0}) {
            const glm::dvec3 scale(0.5, 0.01, 2.0);
            glm::dvec3 deviation(0.0);
            const double opacity = drawn(logit, glm::log(scale), filter, deviation);
            const glm::dvec3 wide = glm::sqrt(scale * scale + filter * filter);
            const double share = scale.x * scale.y * scale.z / (wide.x * wide.y * wide.z);
            EXPECT_LT(glm::length(deviation / wide - 1.0), 1e-5) << filter;
            EXPECT_NEAR(opacity / (share / (1.0 + std::exp(-logit))), 1.0, 1e-4) << logit << " " << filter;
        }
    }
    // At the extremes nothing becomes what is no number.
    for (const char* row : {"1e30 0 0 0 1 0 0 0 0", "1e30 0 0 0 1 0 0 0 1e-30",
                            "-1e30 -300 400 0 1 0 0 0 1e30", "20 -300 -300 -300 1 0 0 0 0.1"}) {
        const auto read = oneOf(names, std::string("1 2 3 0 0 0 ") + row);
        ASSERT_TRUE(read.ok()) << read.error().message << row;
    }
    const auto none = oneOf(names, "1 2 3 0 0 0 30 1 1 1 1 0 0 0 0");
    ASSERT_TRUE(none.ok());
    EXPECT_EQ(none->splats.opacityLogit[0], 30.0f);
    EXPECT_FALSE(oneOf(names, "1 2 3 0 0 0 1 1 1 1 1 0 0 0 nan").ok());
}

TEST(Ply, AnyOrderTypeAndByteOrder) {
    for (const bool big : {false, true}) {
        std::string bytes = "ply\r\nformat binary_" + std::string(big ? "big" : "little") +
                            "_endian 1.0\r\nobj_info made by hand\r\ncomment macula\r\n"
                            "element camera 3\r\nproperty list uchar short ids\r\nproperty int8 kind\r\n"
                            "element nothing 999999999999\r\nelement plain 2\r\nproperty double d\r\n"
                            "element vertex 2\r\nproperty list uint float32 extra\r\n";
        for (int k = 13; k >= 0; --k)
            bytes += std::string("property ") +
                     (k == 0    ? "float64"
                      : k == 2  ? "char"
                      : k == 11 ? "ushort"
                                : "float") +
                     " " + kNames[k] + "\r\nproperty uchar unknown_" + std::to_string(k) + "\r\n";
        bytes += "element face 1000\r\nproperty list uchar int vertex_index\r\nend_header\r\n";
        for (int camera = 0; camera < 3; ++camera) {
            append(bytes, static_cast<std::uint8_t>(camera));
            for (int k = 0; k < camera; ++k) append(bytes, std::int16_t{-1}, big);
            append(bytes, std::int8_t{5});
        }
        for (int k = 0; k < 2; ++k) append(bytes, 0.5, big);
        for (const auto& row : kTwo) {
            append(bytes, std::uint32_t{1}, big);
            append(bytes, 3.5f, big);
            for (int k = 13; k >= 0; --k) {
                if (k == 0)
                    append(bytes, row[k], big);
                else if (k == 2)
                    append(bytes, static_cast<std::int8_t>(row[k]));
                else if (k == 11)
                    append(bytes, static_cast<std::uint16_t>(row[k]), big);
                else
                    append(bytes, static_cast<float>(row[k]), big);
                append(bytes, std::uint8_t{255});
            }
        }
        expectTwo(parse(bytes));
    }
}

TEST(Ply, Ascii) {
    std::string bytes =
        "ply\nformat ascii 1.0\nelement camera 1\nproperty list uchar int ids\nelement vertex 2\n";
    for (const char* name : kNames) bytes += std::string("property float ") + name + "\n";
    bytes += "end_header\n3 7 8 9\n";
    bytes += "1 2.0 +3 2.5e-1 .5 0.75 -1 1 1e-999 -1 1 0 5E-1 0 \n-1.5 0 7 1 -0e5 -1 2.5 125e-3 0 0 0 1 0 0";
    expectTwo(parse(bytes));
    // The last number may not be cut in two unseen, but those before it may not be missing.
    EXPECT_FALSE(parse(bytes.substr(0, bytes.size() - 2)).ok());
}

TEST(Ply, BadSplatsAreRefusedOrRepaired) {
    std::string bytes = foreignHeader(3);
    for (int row = 0; row < 3; ++row) {
        for (int k = 0; k < 62; ++k)
            append(bytes, row == 1 && k == 20   ? std::nanf("")
                          : row == 2 && k == 54 ? std::numeric_limits<float>::infinity()
                                                : 1.0f);
    }
    const auto refused = parse(bytes);
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().message.english().find("2 of the 3"), std::string::npos)
        << refused.error().message;
    const auto repaired = parse(bytes, BadSplats::repair);
    ASSERT_TRUE(repaired.ok());
    EXPECT_EQ(repaired->splats.size(), 2u);
    EXPECT_EQ(repaired->repaired.dropped, 1u);
    EXPECT_EQ(repaired->repaired.clamped, 1u);
    EXPECT_EQ(repaired->splats.opacityLogit[1], kMaxOpacityLogit);
}

TEST(Ply, WriterRefusesWhatIsNotValid) {
    std::ostringstream stream;
    EXPECT_FALSE(writePly(stream, Splats{}).ok());
    Splats splats = testing::randomModel(2, 0, 1);
    splats.dc[1].x = std::nanf("");
    EXPECT_FALSE(writePly(stream, splats).ok());
    EXPECT_TRUE(stream.str().empty());
}

}  // namespace
}  // namespace macula::splat
