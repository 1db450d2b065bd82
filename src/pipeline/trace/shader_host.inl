// The class that shaders/lib becomes in C++. Each including file defines MACULA_HOST, its name; MACULA_REAL,
// float or double; and MACULA_VOXELS, how it reads voxels: LinearVoxels or PooledVoxels. A class, because the
// shader functions read tables and parameters as globals; by inclusion and not as a template, because `float`
// in the shaders must mean MACULA_REAL.
//
// No include guard, no namespace: the including file gives both.

#define OUT(type) type&
#define INOUT(type) type&
#define PRECISE

struct MACULA_HOST : GlslInCpp<MACULA_REAL> {
    using Real = MACULA_REAL;
    static constexpr int kClipKeeps = shared::kClipKeeps;
    static constexpr int kClipCuts = shared::kClipCuts;
    static constexpr int kCastMatter = shared::kCastMatter;
    static constexpr int kCastMaximum = shared::kCastMaximum;
    static constexpr int kCastMinimum = shared::kCastMinimum;
    static constexpr int kCastMean = shared::kCastMean;
    static constexpr int kCoatSteps = shared::kCoatSteps;
    static constexpr uint kNetSamples = shared::kNetSamples;
    static constexpr uint kIndirectBuckets = shared::kIndirectBuckets;
    static constexpr uint kIndirectWays = shared::kIndirectWays;

    // As in the shaders, in this precision.
#define float MACULA_REAL
#define MEMBER(type, name) type name;
#define ARRAY_MEMBER(type, name, count) std::array<type, shared::count> name;
    struct Params {
        MACULA_TRACE_PARAMS(MEMBER, ARRAY_MEMBER)
    };
#undef MEMBER
#undef ARRAY_MEMBER

    static Params paramsOf(const shared::TraceParams& from) {
        Params to;
#define CONVERT(type, name) to.name = type(from.name);
#define CONVERT_ARRAY(type, name, count) \
    for (std::size_t i = 0; i < to.name.size(); ++i) to.name[i] = type(from.name[i]);
        MACULA_TRACE_PARAMS(CONVERT, CONVERT_ARRAY)
#undef CONVERT
#undef CONVERT_ARRAY
        return to;
    }
#undef float

    MACULA_HOST(const HostTables<MACULA_VOXELS>& tables, const shared::TraceParams& p, Filter filter)
        : params(paramsOf(p)),
          tables_(tables),
          trilinear_(filter != Filter::stochastic),
          smooth_(filter == Filter::smooth),
          sharp_(filter == Filter::sharp),
          clip_(isClipped(p)) {}

    Params params;

    Real fetchStored(const ivec3& voxel) const {
        return Real(tables_.voxels.at(voxel));
    }
    void fetchCorners(const ivec3& low, const ivec3& high, vec4& near, vec4& far) const {
        near = {fetchStored(low), fetchStored({high.x, low.y, low.z}), fetchStored({low.x, high.y, low.z}),
                fetchStored({high.x, high.y, low.z})};
        far = {fetchStored({low.x, low.y, high.z}), fetchStored({high.x, low.y, high.z}),
               fetchStored({low.x, high.y, high.z}), fetchStored(high)};
    }
    using Blocks = MACULA_VOXELS::Blocks;
    Blocks blocksOfBrick(const ivec3& brick) const {
        return tables_.voxels.blocksOfBrick(brick);
    }
    Real fetchFrom(const Blocks& blocks, const ivec3& voxel) const {
        return Real(tables_.voxels.from(blocks, voxel));
    }
    Real fetchExtinction(int entry) const {
        return Real(tables_.extinctionPerMm[entry]);
    }
    Real fetchGradientOpacity(int step) const {
        return Real(tables_.gradientOpacity[std::size_t(step)]);
    }
    vec3 fetchAlbedo(int entry) const {
        return vec3(glm::vec3(tables_.albedo[entry]));
    }
    vec4 fetchMatter(int entry) const {
        return vec4(fetchAlbedo(entry), fetchExtinction(entry));
    }
    bool useSteep() const {
        return !tables_.steep.empty();
    }
    bool useSteepDensity() const {
        return tables_.hasSteepDensity;
    }
    Real fetchSteepExtinction(int entry) const {
        return Real(tables_.steep[std::size_t(entry)].w);
    }
    vec4 fetchSteepMatter(int entry) const {
        return vec4(tables_.steep[std::size_t(entry)]);
    }
    Real fetchBound(int brick) const {
        return Real(tables_.bounds[brick]);
    }
    vec4 fetchEnvironment(int texel) const {
        const EnvironmentTexel& there = tables_.environment[texel];
        return vec4(vec3(there.radiance), Real(there.pdfPerSr));
    }
    Real fetchCumulative(int index) const {
        return Real(tables_.cumulative[index]);
    }
    bool useTrilinear() const {
        return trilinear_;
    }
    bool useSmooth() const {
        return smooth_;
    }
    bool useSharp() const {
        return sharp_;
    }
    bool useClip() const {
        return clip_;
    }
    bool useMask() const {
        return !tables_.mask.empty();
    }
    Real fetchMask(const ivec3& voxel) const {
        const std::size_t n =
            (std::size_t(voxel.z) * std::size_t(params.volumeSize.y) + std::size_t(voxel.y)) *
                std::size_t(params.volumeSize.x) +
            std::size_t(voxel.x);
        return Real(tables_.mask[n / 32] >> (n % 32) & 1u);
    }
    bool useSecond() const {
        return !tables_.second.isEmpty();
    }
    Real fetchSecond(const ivec3& voxel) const {
        return Real(tables_.second.at(voxel));
    }
    vec4 fetchSecondMatter(int entry) const {
        return vec4(tables_.additions[entry]);
    }
    bool useTints() const {
        return !tables_.tints.empty();
    }
    int fetchTint(const ivec3& voxel) const {
        const ivec3 at = voxel - params.tintLow;
        const ivec3& size = params.tintSize;
        if (at.x < 0 || at.y < 0 || at.z < 0 || at.x >= size.x || at.y >= size.y || at.z >= size.z) return 0;
        return tables_
            .tints[(std::size_t(at.z) * std::size_t(size.y) + std::size_t(at.y)) * std::size_t(size.x) +
                   std::size_t(at.x)];
    }
    vec4 fetchTintColour(int tint) const {
        return vec4(tables_.additions[params.secondEntryCount + tint - 1]);
    }
    bool useGradientOpacity() const {
        return !tables_.gradientOpacity.empty();
    }
    bool useSurfaces() const {
        return params.surfaceWeight > Real(0);
    }
    bool useShading() const {
        return cast.shading;
    }
    int castLook() const {
        return cast.look;
    }
    bool useIndirect() const {
        return !tables_.indirectTags.empty();
    }
    uvec4 fetchIndirectTags(int bucket) const {
        const auto* const tags = &tables_.indirectTags[std::size_t(bucket) * kIndirectWays];
        return {tags[0], tags[1], tags[2], tags[3]};
    }
    uvec4 fetchIndirectCell(int cell) const {
        return tables_.indirectCells[std::size_t(cell)];
    }
    bool hasGreyFaces() const {
        return clip_ && params.greyFaces != 0;
    }

    CastKind cast;  // what castSample() does

#define OF_LAYERS
#define MARCH_STEP layerStep
#define float MACULA_REAL
#include "lib/trace_lib.glsl"
#undef float
    // For code that follows rays in vectors.
    static constexpr Real kRouletteBelow = Real(ROULETTE_BELOW);
    static constexpr Real kRoundedBound = Real(ROUNDED_BOUND);
    static constexpr Real kBrickShift = Real(BRICK_SHIFT);
    static constexpr int kBrickEdge = BRICK;
    static constexpr int kStride = STRIDE;
    static constexpr int kCuts = CUTS::length();
    static constexpr Real kFine = Real(FINE);
    static constexpr Real kDepth3_4 = Real(DEPTH_3_4);
    static constexpr Real kDepth1_2 = Real(DEPTH_1_2);
    static constexpr Real kDepth1_4 = Real(DEPTH_1_4);
    static constexpr Real kDepthOpaque = Real(DEPTH_OPAQUE);
    static constexpr int kMostRounds = MOST_ROUNDS;
    static constexpr int kLayers = LAYERS;
    static constexpr int kCastSteps = CAST_STEPS;
    static constexpr Real kCastOpaque = Real(CAST_OPAQUE);
#undef PI
#undef BRICK
#undef PARALLEL
#undef FAR_MM
#undef CUTS
#undef BRICK_SHIFT
#undef GRAZING
#undef ROULETTE_BELOW
#undef ROUNDED_BOUND
#undef SHADOW_LOOSENESS
#undef SEEN_ENOUGH
#undef FACE_WEIGHT
#undef FACE_DEPTH
#undef MANY_SURFACE_ROUNDS
#undef STRIDE
#undef DEPTH_3_4
#undef OF_LAYERS
#undef MARCH_STEP
#undef LAYERS
#undef DEPTH_1_2
#undef DEPTH_1_4
#undef DEPTH_OPAQUE
#undef FINE
#undef MOST_ROUNDS
#undef LENS_RAYS
#undef SHOULDER
#undef WHITE_AT
#undef CAST_STEPS
#undef CAST_STEPS_LATE
#undef MANY_ROUNDS
#undef CAST_OPAQUE
#undef INDIRECT_DOUBT
#undef INDIRECT_LEVELS
#undef INDIRECT_WIDER
#undef INDIRECT_PRIOR

  private:
    HostTables<MACULA_VOXELS> tables_;
    bool trilinear_;
    bool smooth_;
    bool sharp_;
    bool clip_;
};

#undef OUT
#undef INOUT
#undef PRECISE
