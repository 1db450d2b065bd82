// PLY files that are no models, or damaged ones.
#include <gtest/gtest.h>

#include <sstream>

#include "pipeline/splat/files/ply.h"
#include "splat/model_support.h"

namespace macula::splat {
namespace {

Result<ModelFile> parse(const std::string& bytes) {
    std::istringstream stream(bytes);
    return readPly(stream, bytes.size());
}

std::string binaryModel(std::size_t count, int degree) {
    std::ostringstream stream;
    EXPECT_TRUE(writePly(stream, testing::randomModel(count, degree, 3)).ok());
    return stream.str();
}

constexpr const char* kProperties =
    "property float x\nproperty float y\nproperty float z\nproperty float f_dc_0\nproperty float f_dc_1\n"
    "property float f_dc_2\nproperty float opacity\nproperty float scale_0\nproperty float scale_1\n"
    "property float scale_2\nproperty float rot_0\nproperty float rot_1\nproperty float rot_2\n"
    "property float rot_3\n";

// A header of an ascii model of one splat with something in its place.
std::string ascii(const std::string& beforeVertex, const std::string& count, const std::string& more = "",
                  const std::string& data = "1 2 3 0 0 0 0 0 0 0 1 0 0 0\n") {
    return "ply\nformat ascii 1.0\n" + beforeVertex + "element vertex " + count + "\n" + kProperties + more +
           "end_header\n" + data;
}

std::string without(std::string text, const std::string& part) {
    text.erase(text.find(part), part.size());
    return text;
}

struct Case {
    std::string bytes;
    std::string says;
};

TEST(PlyBad, EachSaysWhatIsWrong) {
    ASSERT_TRUE(parse(ascii("", "1")).ok());
    const std::string ours =
        "comment macula model 1\ncomment macula axes unknown\ncomment macula colours display\n"
        "comment macula low-pass classic\n";
    ASSERT_TRUE(parse(ascii(ours + "comment macula origin-mm 1 2 3\n", "1")).ok());
    std::string many;
    for (int k = 0; k < 72; ++k) many += "property float f_rest_" + std::to_string(k) + "\n";
    const std::vector<Case> cases{
        {"", "no PLY"},
        {"pl", "no PLY"},
        {"solid cube\n", "no PLY"},
        {"plyers\nformat ascii 1.0\n", "no PLY"},
        {"ply\n", "cut off"},
        {"ply\nformat ascii 1.0\nelement vertex 1\n", "cut off"},
        {"ply\nend_header\n", "does not name a format"},
        {"ply\nformat ascii 2.0\nend_header\n", "version"},
        {"ply\nformat utf8 1.0\nend_header\n", "unknown format"},
        {"ply\nformat ascii 1.0\nproperty float x\nend_header\n", "line that is none"},
        {"ply\nformat ascii 1.0\nnonsense\nend_header\n", "line that is none"},
        {"ply\nformat ascii 1.0\nend_header\n", "no points"},
        {"ply\ncomment " + std::string(2 << 20, 'x'), "longer than"},
        {ascii("", "-1"), "fewer elements than none"},
        {ascii("", "many"), "how many"},
        {ascii("", "1.5"), "how many"},
        {ascii("", "99999999999999999999999"), "how many"},
        {ascii("", "18446744073709551615"), "too small"},
        {ascii("", "1000000000000"), "too small"},
        {ascii("", "2"), "too small"},
        {ascii("", "0"), "no splats"},
        {ascii("", "1", "property float x\n", "1 2 3 0 0 0 0 0 0 0 1 0 0 0 0"), "x twice"},
        {ascii("", "1", "property half nx\n"), "unknown type"},
        {ascii("", "1", "property float\n"), "without a name"},
        {ascii("", "1", "property list float int nx\n"), "no whole number"},
        {ascii("", "1", "property float f_rest_0\n", "1 2 3 0 0 0 0 0 0 0 1 0 0 0 0"), "has 1 coefficients"},
        {ascii("", "1", many, std::string(200, '1')), "has 72 coefficients"},
        {ascii("", "1", "", "1 2 3 0 0 0 0 0 0 0 1 0 0 x\n"), "splat 1 of 1"},
        {ascii("", "1", "", "1 2 3 0 0 0 0 0 0 0 1 0 0\n    "), "splat 1 of 1"},
        {ascii("", "1", "", "1 2 3 0 0 0 0 0 0 0 1 0 0 " + std::string(100, '0')), "splat 1 of 1"},
        {ascii("", "1", "", "1 2 nan 0 0 0 0 0 0 0 1 0 0 0\n"), "1 of the 1"},
        {ascii("", "1", "", "1 2 1e60 0 0 0 0 0 0 0 1 0 0 0\n"), "1 of the 1"},
        {ascii("", "1", "", "1 2 1e999 0 0 0 0 0 0 0 1 0 0 0\n"), "1 of the 1"},
        {ascii("", "1", "", "1 2 3 0 0 0 0 0 0 0 0 0 0 0\n"), "1 of the 1"},  // no rotation
        {ascii("element a 1\nproperty list char int ids\n", "1", "", "-1 1 2 3 0 0 0 0 0 0 0 1 0 0 0\n"),
         "damaged"},
        {ascii("element a 1\nproperty list int int ids\n", "1", "",
               "2000000000 1 2 3 0 0 0 0 0 0 0 1 0 0 0\n"),
         "damaged"},
        {without(ascii("", "1"), "property float opacity\n"), "lacks opacity"},
        {without(without(ascii("", "1"), "property float rot_3\n"), "property float scale_2\n"),
         "lacks rot_3"},
        {"ply\nformat ascii 1.0\nelement vertex 1\nproperty uint packed_position\nend_header\n1\n",
         "packed by"},
        {ascii(ours, "1"), "origin"},
        {ascii(ours + "comment macula origin-mm 1 2 nan\n", "1"), "origin"},
        {ascii(ours + "comment macula origin-mm 1 2 3 4\n", "1"), "origin"},
        {ascii(ours + "comment macula origin-mm 1 2\n", "1"), "origin"},
        {ascii(ours + "comment macula origin-mm 1 2 3\ncomment macula axes unknown\n", "1"), "axes"},
        {ascii("comment macula model 2\n", "1"), "version"},
        {ascii("comment macula axes unknown\n", "1"), "version"},
        {ascii(without(ours, "comment macula colours display\n") + "comment macula origin-mm 1 2 3\n", "1"),
         "colours"},
    };
    for (const Case& c : cases) {
        const auto read = parse(c.bytes);
        ASSERT_FALSE(read.ok()) << c.says << "\n" << c.bytes.substr(0, 300);
        EXPECT_EQ(read.error().code, ErrorCode::inputNotUsable);
        EXPECT_NE(read.error().message.english().find(c.says), std::string::npos)
            << read.error().message << "\nfor " << c.says;
        EXPECT_FALSE(read.error().hint.empty());
    }
}

TEST(PlyBad, CutOffAnywhere) {
    const std::string bytes = binaryModel(3, 1);
    ASSERT_TRUE(parse(bytes).ok());
    for (std::size_t length = 0; length < bytes.size(); ++length)
        ASSERT_FALSE(parse(bytes.substr(0, length)).ok()) << length;
}

// Whatever the bytes, there is an error or a valid model. Run under the sanitizers by the asan preset.
TEST(PlyBad, RandomDamage) {
    std::mt19937 random(20260729);
    const std::string sources[] = {
        binaryModel(4, 0), binaryModel(2, 1), ascii("", "1"),
        ascii("element a 1\nproperty list char int ids\n", "1", "", "2 1 2 1 2 3 0 0 0 0 0 0 0 1 0 0 0\n")};
    int refused = 0;
    for (int i = 0; i < 4000; ++i) {
        std::string bytes = testing::mutated(sources[i % 4], random);
        if (random() % 4 == 0) bytes = testing::mutated(bytes, random);
        const auto read = parse(bytes);
        refused += read.ok() ? 0 : 1;
        if (read.ok()) {
            ASSERT_TRUE(read->splats.validate().ok());
            ASSERT_GT(read->splats.size(), 0u);
        }
    }
    EXPECT_GT(refused, 1000);
    EXPECT_LT(refused, 4000);
}

}  // namespace
}  // namespace macula::splat
