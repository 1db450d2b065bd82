// The class that shaders/lib becomes in C++. Included three times, with MACULA_HOST its name and MACULA_REAL
// float or double: a class, because the shader functions read tables and parameters as globals; by inclusion
// and not as a template, because `float` in the shaders must mean MACULA_REAL.
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

    MACULA_HOST(const ReferenceTracer::Tables& tables, const shared::TraceParams& p, Filter filter)
        : params(paramsOf(p)),
          entries_(tables.entries.data()),
          extinction_(tables.extinctionPerMm.data()),
          gradientOpacity_(tables.gradientOpacity.data()),
          albedo_(tables.albedo.data()),
          steep_(tables.steep),
          bounds_(tables.bounds.data()),
          environment_(tables.environment.data()),
          cumulative_(tables.cumulative.data()),
          trilinear_(filter != Filter::stochastic),
          smooth_(filter == Filter::smooth),
          sharp_(filter == Filter::sharp) {
        clip_ = isClipped(p);
        mask_ = tables.mask;
        secondEntries_ = tables.secondEntries;
        additions_ = tables.additions.data();
        tints_ = tables.tints;
        indirectTags_ = tables.indirectTags;
        indirectCells_ = tables.indirectCells;
        hasGradientOpacity_ = !tables.gradientOpacity.empty();
    }

    Params params;

    // Reads every voxel at full resolution: the truth that the device is tested against.
    Real fetchStored(const ivec3& voxel) const {
        const ivec3& size = params.volumeSize;
        return Real(entries_[(std::size_t(voxel.z) * std::size_t(size.y) + std::size_t(voxel.y)) *
                                 std::size_t(size.x) +
                             std::size_t(voxel.x)]);
    }
    void fetchCorners(const ivec3& low, const ivec3& high, vec4& near, vec4& far) const {
        near = {fetchStored(low), fetchStored({high.x, low.y, low.z}), fetchStored({low.x, high.y, low.z}),
                fetchStored({high.x, high.y, low.z})};
        far = {fetchStored({low.x, low.y, high.z}), fetchStored({high.x, low.y, high.z}),
               fetchStored({low.x, high.y, high.z}), fetchStored(high)};
    }
    struct Blocks {};
    Blocks blocksOfBrick(const ivec3&) const { return {}; }
    Real fetchFrom(Blocks, const ivec3& voxel) const { return fetchStored(voxel); }
    Real fetchExtinction(int entry) const { return Real(extinction_[entry]); }
    Real fetchGradientOpacity(int step) const { return Real(gradientOpacity_[step]); }
    vec3 fetchAlbedo(int entry) const { return vec3(glm::vec3(albedo_[entry])); }
    vec4 fetchMatter(int entry) const { return vec4(fetchAlbedo(entry), fetchExtinction(entry)); }
    bool useSteep() const { return !steep_.empty(); }
    bool useSteepDensity() const { return useSteep(); }
    Real fetchSteepExtinction(int entry) const { return Real(steep_[std::size_t(entry)].w); }
    vec4 fetchSteepMatter(int entry) const { return vec4(steep_[std::size_t(entry)]); }
    Real fetchBound(int brick) const { return Real(bounds_[brick]); }
    vec4 fetchEnvironment(int texel) const {
        return vec4(vec3(environment_[texel].radiance), Real(environment_[texel].pdfPerSr));
    }
    Real fetchCumulative(int index) const { return Real(cumulative_[index]); }
    bool useTrilinear() const { return trilinear_; }
    bool useSmooth() const { return smooth_; }
    bool useSharp() const { return sharp_; }
    bool useClip() const { return clip_; }
    bool useMask() const { return !mask_.empty(); }
    Real fetchMask(const ivec3& voxel) const {
        const std::size_t n = (std::size_t(voxel.z) * std::size_t(params.volumeSize.y) + std::size_t(voxel.y)) *
                                  std::size_t(params.volumeSize.x) +
                              std::size_t(voxel.x);
        return Real(mask_[n / 32] >> (n % 32) & 1u);
    }
    bool useSecond() const { return !secondEntries_.empty(); }
    Real fetchSecond(const ivec3& voxel) const {
        const ivec3& size = params.secondSize;
        return Real(secondEntries_[(std::size_t(voxel.z) * std::size_t(size.y) + std::size_t(voxel.y)) *
                                       std::size_t(size.x) +
                                   std::size_t(voxel.x)]);
    }
    vec4 fetchSecondMatter(int entry) const { return vec4(additions_[entry]); }
    bool useTints() const { return !tints_.empty(); }
    int fetchTint(const ivec3& voxel) const {
        const ivec3 at = voxel - params.tintLow;
        const ivec3& size = params.tintSize;
        if (at.x < 0 || at.y < 0 || at.z < 0 || at.x >= size.x || at.y >= size.y || at.z >= size.z) return 0;
        return tints_[(std::size_t(at.z) * std::size_t(size.y) + std::size_t(at.y)) * std::size_t(size.x) +
                      std::size_t(at.x)];
    }
    vec4 fetchTintColour(int tint) const { return vec4(additions_[params.secondEntryCount + tint - 1]); }
    bool useGradientOpacity() const { return hasGradientOpacity_; }
    bool useSurfaces() const { return params.surfaceWeight > Real(0); }
    bool useShading() const { return cast.shading; }
    int castLook() const { return cast.kind; }
    bool useIndirect() const { return !indirectTags_.empty(); }
    uvec4 fetchIndirectTags(int bucket) const {
        const auto* const tags = &indirectTags_[std::size_t(bucket) * kIndirectWays];
        return {tags[0], tags[1], tags[2], tags[3]};
    }
    uvec4 fetchIndirectCell(int cell) const { return indirectCells_[std::size_t(cell)]; }
    bool hasGreyFaces() const { return clip_ && params.greyFaces != 0; }

    ReferenceTracer::Cast cast;  // what castSample() does

#define OF_LAYERS
#define MARCH_STEP layerStep
#define float MACULA_REAL
#include "lib/trace_lib.glsl"
#undef float
#undef PI
#undef BRICK
#undef PARALLEL
#undef FAR_MM
#undef CUTS
#undef BRICK_SHIFT
#undef GRAZING
#undef ROULETTE_BELOW
#undef SHADOW_LOOSENESS
#undef SEEN_ENOUGH
#undef FACE_WEIGHT
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
    const std::uint16_t* entries_;
    const float* extinction_;
    const float* gradientOpacity_;
    const glm::vec4* albedo_;
    std::span<const glm::vec4> steep_;  // empty: steep matter has no curves of its own
    const float* bounds_;
    const EnvironmentTexel* environment_;
    const float* cumulative_;
    bool trilinear_;
    bool smooth_;
    bool sharp_;
    bool clip_;
    std::span<const std::uint32_t> mask_;
    std::span<const std::uint16_t> secondEntries_;  // empty: there is no second volume
    const glm::vec4* additions_;
    std::span<const std::uint8_t> tints_;  // empty: none
    bool hasGradientOpacity_;
    std::span<const std::uint32_t> indirectTags_;  // empty: no cache
    std::span<const glm::uvec4> indirectCells_;
};

#undef OUT
#undef INOUT
#undef PRECISE
