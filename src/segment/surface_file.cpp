#include "segment/surface_file.h"

#include <fmt/format.h>
#include <algorithm>
#include <bit>
#include <cctype>
#include <limits>
#include <new>
#include <vector>

#include "base/atomic_file.h"
#include "base/srgb.h"

namespace macula::segment {

namespace fs = std::filesystem;

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

template <class Value>
void put(std::string& to, const Value& value) {
    const auto* bytes = reinterpret_cast<const char*>(&value);
    to.append(bytes, sizeof value);
}

void put(std::string& to, const glm::dvec3& v) {
    for (int n = 0; n < 3; ++n) put(to, static_cast<float>(v[n]));
}

glm::dvec3 normalOf(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& t) {
    const glm::dvec3 normal = glm::cross(mesh.verticesMm[t[1]] - mesh.verticesMm[t[0]],
                                         mesh.verticesMm[t[2]] - mesh.verticesMm[t[0]]);
    const double length = glm::length(normal);
    return length > 0.0 ? normal / length : glm::dvec3(0.0);
}

std::string stlOf(const TriangleMesh& mesh) {
    constexpr std::size_t kHeader = 80;
    constexpr std::size_t kTriangle = 50;
    std::string bytes = "Macula: patient LPS, mm";  // must not begin with "solid", which means text
    bytes.resize(kHeader, ' ');
    bytes.reserve(kHeader + 4 + kTriangle * mesh.triangles.size());
    put(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const auto& t : mesh.triangles) {
        put(bytes, normalOf(mesh, t));
        for (const std::uint32_t vertex : t) put(bytes, mesh.verticesMm[vertex]);
        put(bytes, std::uint16_t{0});
    }
    return bytes;
}

// Weighted by the areas of the triangles around a vertex.
std::vector<glm::dvec3> vertexNormals(const TriangleMesh& mesh) {
    std::vector<glm::dvec3> normals(mesh.verticesMm.size(), glm::dvec3(0.0));
    for (const auto& t : mesh.triangles) {
        const glm::dvec3 normal = glm::cross(mesh.verticesMm[t[1]] - mesh.verticesMm[t[0]],
                                             mesh.verticesMm[t[2]] - mesh.verticesMm[t[0]]);
        for (const std::uint32_t vertex : t) normals[vertex] += normal;
    }
    for (glm::dvec3& normal : normals) {
        const double length = glm::length(normal);
        normal = length > 0.0 ? normal / length : glm::dvec3(0.0, 0.0, 1.0);  // glTF wants units
    }
    return normals;
}

std::string triple(const glm::dvec3& v) {
    return fmt::format("[{:.9g},{:.9g},{:.9g}]", static_cast<double>(static_cast<float>(v.x)),
                       static_cast<double>(static_cast<float>(v.y)),
                       static_cast<double>(static_cast<float>(v.z)));
}

std::string jsonOf(const TriangleMesh& mesh, const std::array<std::uint8_t, 3>& rgb) {
    glm::dvec3 low(std::numeric_limits<double>::max());
    glm::dvec3 high(-low);
    for (const glm::dvec3& vertex : mesh.verticesMm) {
        low = glm::min(low, vertex);
        high = glm::max(high, vertex);
    }
    const std::size_t vertices = mesh.verticesMm.size();
    const std::size_t points = 12 * vertices;
    const std::size_t indices = 12 * mesh.triangles.size();
    std::array<double, 3> linear{};
    for (std::size_t n = 0; n < 3; ++n) linear[n] = decodedSrgb(double(rgb[n]) / 255.0);
    std::string json =
        R"({"asset":{"version":"2.0","generator":"Macula"},"scene":0,"scenes":[{"nodes":[0]}],)";
    json += R"("nodes":[{"mesh":0,"matrix":[0.001,0,0,0,0,0,-0.001,0,0,0.001,0,0,0,0,0,1]}],)";
    json +=
        R"("meshes":[{"extras":{"frame":"patient LPS","unit":"mm"},"primitives":[{"attributes":{"POSITION":0,)";
    json += R"("NORMAL":1},"indices":2,"material":0}]}],)";
    json +=
        R"("materials":[{"pbrMetallicRoughness":{"metallicFactor":0,"roughnessFactor":0.7,"baseColorFactor":)";
    json += fmt::format("[{:.6f},{:.6f},{:.6f},1]", linear[0], linear[1], linear[2]) + "}}],";
    json += fmt::format("\"buffers\":[{{\"byteLength\":{}}}],", 2 * points + indices);
    json += fmt::format("\"bufferViews\":[{{\"buffer\":0,\"byteLength\":{},\"target\":34962}},", points);
    json +=
        fmt::format("{{\"buffer\":0,\"byteOffset\":{},\"byteLength\":{},\"target\":34962}},", points, points);
    json += fmt::format("{{\"buffer\":0,\"byteOffset\":{},\"byteLength\":{},\"target\":34963}}],", 2 * points,
                        indices);
    json += fmt::format(
        "\"accessors\":[{{\"bufferView\":0,\"componentType\":5126,\"count\":{},\"type\":\"VEC3\",", vertices);
    json += "\"min\":" + triple(low) + ",\"max\":" + triple(high) + "},";
    json +=
        fmt::format("{{\"bufferView\":1,\"componentType\":5126,\"count\":{},\"type\":\"VEC3\"}},", vertices);
    json += fmt::format("{{\"bufferView\":2,\"componentType\":5125,\"count\":{},\"type\":\"SCALAR\"}}]}}",
                        3 * mesh.triangles.size());
    json.resize((json.size() + 3) / 4 * 4, ' ');
    return json;
}

std::string glbOf(const TriangleMesh& mesh, const std::array<std::uint8_t, 3>& rgb) {
    constexpr std::uint32_t kMagic = 0x46546C67;  // "glTF"
    constexpr std::uint32_t kJson = 0x4E4F534A;
    constexpr std::uint32_t kBinary = 0x004E4942;
    const std::string json = jsonOf(mesh, rgb);
    const std::size_t binary = 24 * mesh.verticesMm.size() + 12 * mesh.triangles.size();
    std::string bytes;
    bytes.reserve(28 + json.size() + binary);
    put(bytes, kMagic);
    put(bytes, std::uint32_t{2});
    put(bytes, static_cast<std::uint32_t>(28 + json.size() + binary));
    put(bytes, static_cast<std::uint32_t>(json.size()));
    put(bytes, kJson);
    bytes += json;
    put(bytes, static_cast<std::uint32_t>(binary));
    put(bytes, kBinary);
    for (const glm::dvec3& vertex : mesh.verticesMm) put(bytes, vertex);
    for (const glm::dvec3& normal : vertexNormals(mesh)) put(bytes, normal);
    for (const auto& triangle : mesh.triangles) put(bytes, triangle);
    return bytes;
}

}  // namespace

std::optional<SurfaceFormat> surfaceFormatOf(const fs::path& path) {
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    if (ending == ".stl") return SurfaceFormat::stl;
    if (ending == ".glb") return SurfaceFormat::glb;
    return std::nullopt;
}

Result<void> writeSurface(const fs::path& path, const TriangleMesh& mesh,
                          const std::array<std::uint8_t, 3>& rgb) try {
    const auto format = surfaceFormatOf(path);
    if (!format)
        return Error{ErrorCode::usage, Text("A surface is written as .stl or .glb."), path.string(),
                     Text("Choose one of these endings.")};
    constexpr std::size_t kMostVertices = 100'000'000;  // glTF counts bytes with 32 bits
    if (mesh.verticesMm.size() > kMostVertices || mesh.triangles.size() > kMostTriangles)
        return Error{ErrorCode::usage,
                     Text("The surface has too many triangles for a file."),
                     {},
                     Text("Smooth the segment, or keep its largest part.")};
    const std::string bytes = *format == SurfaceFormat::stl ? stlOf(mesh) : glbOf(mesh, rgb);
    return writeTextAtomically(path, bytes);
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory,
                 Text("There is not enough memory to write this surface."),
                 {},
                 Text("Close other programs, or smooth the segment first.")};
}

}  // namespace macula::segment
