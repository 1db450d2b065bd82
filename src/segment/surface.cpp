#include "segment/surface.h"

#include <algorithm>
#include <limits>
#include <new>

#include "base/frames.h"
#include "segment/voxel_sets.h"

namespace macula::segment {

namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// Corners of a cube are numbers of three bits: x, y, z. A tetrahedron leads from corner 0 to 7 by one axis
// after the other, so that each of its edges leads from a corner to one with more bits.
constexpr std::array<std::array<int, 4>, 6> kTetrahedra{
    {{0, 1, 3, 7}, {0, 1, 5, 7}, {0, 2, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 4, 6, 7}}};

glm::ivec3 cornerAt(int corner) {
    return {corner & 1, corner >> 1 & 1, corner >> 2 & 1};
}

class Marching {
  public:
    Marching(const VoxelSet& set, TriangleMesh& mesh)
        : set_(set), mesh_(mesh), low_(set.low() - 1), size_(set.high() - set.low() + 3) {
        for (auto& layer : vertices_) layer.assign(std::size_t(size_.x) * std::size_t(size_.y) * 8, kNone);
    }

    int layers() const { return size_.z - 1; }
    // One layer of cubes, in order. False: too many triangles.
    bool march(int k) {
        if (k > 0) {
            std::swap(vertices_[0], vertices_[1]);
            std::ranges::fill(vertices_[1], kNone);
        }
        layer_ = k;
        for (int j = 0; j + 1 < size_.y; ++j)
            for (int i = 0; i + 1 < size_.x; ++i) marchCube({i, j, k});
        return mesh_.triangles.size() <= kMostTriangles;
    }

  private:
    void marchCube(const glm::ivec3& cube) {
        unsigned in = 0;
        for (int corner = 0; corner < 8; ++corner)
            in |= set_.contains(low_ + cube + cornerAt(corner)) ? 1u << corner : 0u;
        if (in == 0u || in == 0xFFu) return;
        for (const std::array<int, 4>& corners : kTetrahedra) {
            std::array<int, 4> inside{};
            std::array<int, 4> outside{};
            std::size_t ins = 0;
            std::size_t outs = 0;
            for (const int corner : corners) {
                if ((in >> corner & 1u) != 0) {
                    inside[ins++] = corner;
                } else {
                    outside[outs++] = corner;
                }
            }
            if (ins == 1) {
                add(cube, inside[0],
                    {{{inside[0], outside[0]}, {inside[0], outside[1]}, {inside[0], outside[2]}}});
            } else if (ins == 3) {
                add(cube, inside[0],
                    {{{inside[0], outside[0]}, {inside[1], outside[0]}, {inside[2], outside[0]}}});
            } else if (ins == 2) {
                const Edge a{inside[0], outside[0]};
                const Edge b{inside[0], outside[1]};
                const Edge c{inside[1], outside[1]};
                const Edge d{inside[1], outside[0]};
                add(cube, inside[0], {{a, b, c}});
                add(cube, inside[0], {{a, c, d}});
            }
        }
    }

    struct Edge {
        int in = 0;
        int out = 0;
    };

    // Turns the triangle so that the corner `inside` lies behind it.
    void add(const glm::ivec3& cube, int inside, const std::array<Edge, 3>& edges) {
        std::array<glm::ivec3, 3> at;  // twice the places: middles of edges
        for (std::size_t n = 0; n < 3; ++n) at[n] = cornerAt(edges[n].in) + cornerAt(edges[n].out);
        const glm::dvec3 normal = glm::cross(glm::dvec3(at[1] - at[0]), glm::dvec3(at[2] - at[0]));
        const bool facesOut = glm::dot(normal, glm::dvec3(2 * cornerAt(inside) - at[0])) < 0.0;
        std::array<std::uint32_t, 3> triangle{vertexOn(cube, edges[0]), vertexOn(cube, edges[1]),
                                              vertexOn(cube, edges[2])};
        if (!facesOut) std::swap(triangle[1], triangle[2]);
        mesh_.triangles.push_back(triangle);
    }

    std::uint32_t vertexOn(const glm::ivec3& cube, const Edge& edge) {
        const int from = edge.in & edge.out;  // the corner that begins the edge
        const int along = edge.in ^ edge.out;
        const glm::ivec3 begins = cube + cornerAt(from);
        auto& layer = vertices_[std::size_t(begins.z - layer_)];
        std::uint32_t& vertex =
            layer[(std::size_t(begins.y) * std::size_t(size_.x) + std::size_t(begins.x)) * 8 +
                  std::size_t(along)];
        if (vertex == kNone) {
            vertex = std::uint32_t(mesh_.verticesMm.size());
            mesh_.verticesMm.push_back(glm::dvec3(low_ + begins) + 0.5 * glm::dvec3(cornerAt(along)));
        }
        return vertex;
    }

    const VoxelSet& set_;
    TriangleMesh& mesh_;
    glm::ivec3 low_;
    glm::ivec3 size_;
    int layer_ = 0;
    // By the corner where an edge begins, and its direction: of this layer of corners, and the next.
    std::array<std::vector<std::uint32_t>, 2> vertices_;
};

// Moves each vertex by a share of the way to the mean of those beside it. Each edge has two triangles, so
// that each neighbour counts twice.
void relax(TriangleMesh& mesh, double share) {
    std::vector<glm::dvec3> sums(mesh.verticesMm.size(), glm::dvec3(0.0));
    std::vector<std::uint32_t> counts(mesh.verticesMm.size());
    for (const auto& triangle : mesh.triangles) {
        for (std::size_t n = 0; n < 3; ++n) {
            for (const std::size_t other : {(n + 1) % 3, (n + 2) % 3}) {
                sums[triangle[n]] += mesh.verticesMm[triangle[other]];
                ++counts[triangle[n]];
            }
        }
    }
    for (std::size_t n = 0; n < sums.size(); ++n)
        if (counts[n] > 0) mesh.verticesMm[n] += share * (sums[n] / double(counts[n]) - mesh.verticesMm[n]);
}

}  // namespace

double volumeMm3(const TriangleMesh& mesh) {
    if (mesh.verticesMm.empty()) return 0.0;
    const glm::dvec3 about = mesh.verticesMm.front();  // near the mesh, for the sake of rounding
    double sum = 0.0;
    for (const auto& t : mesh.triangles)
        sum += glm::dot(mesh.verticesMm[t[0]] - about,
                        glm::cross(mesh.verticesMm[t[1]] - about, mesh.verticesMm[t[2]] - about));
    return sum / 6.0;
}

Result<TriangleMesh> surfaceOf(const VoxelSet& set, const glm::dmat4& worldFromVoxel, int passes,
                               Progress& progress) try {
    const VoxelSet small = set.cropped();
    if (small.isEmpty())
        return Error{ErrorCode::usage,
                     Text("The segment has no voxel, and so no surface."),
                     {},
                     Text("Draw it first, or choose another one.")};
    const glm::dvec3 size = glm::dvec3(small.high() - small.low() + 3);
    MACULA_TRY_VOID(checkMemory(size.x * size.y, 64.0));
    TriangleMesh mesh;
    Marching marching(small, mesh);
    progress.beginStage(Text("Making a surface"), std::size_t(marching.layers()));
    for (int k = 0; k < marching.layers(); ++k, progress.advance()) {
        if (progress.cancelled()) return segmentingCancelled();
        if (!marching.march(k))
            return Error{ErrorCode::usage,
                         Text("The surface of this segment has more than {} triangles.", kMostTriangles),
                         {},
                         Text("Smooth the segment, or keep its largest part.")};
    }
    // Weights of Taubin, A signal processing approach to fair surface design, 1995.
    constexpr double kShrinks = 0.5;
    constexpr double kSwells = -0.53;
    for (int pass = 0; pass < passes; ++pass) {
        if (progress.cancelled()) return segmentingCancelled();
        relax(mesh, kShrinks);
        relax(mesh, kSwells);
    }
    for (glm::dvec3& vertex : mesh.verticesMm) vertex = transformPoint(worldFromVoxel, vertex);
    if (glm::determinant(glm::dmat3(worldFromVoxel)) < 0.0)
        for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    return mesh;
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory,
                 Text("There is not enough memory for the surface of this segment."),
                 {},
                 Text("Close other programs, or smooth the segment first.")};
}

}  // namespace macula::segment
