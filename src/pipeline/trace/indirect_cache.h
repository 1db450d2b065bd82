// A cache of indirect light on the device: by position, the light that other matter sends to the first
// vertices of paths (shaders/lib/indirect.glsl). Some paths continue from their first vertex and fill it;
// others end there and read it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/trace/settings.h"
#include "shared/indirect_light.h"
#include "shared/trace_params.h"

namespace macula::trace {

// What the light of a scene depends on: when it changes, the cache is out of date.
struct LightOfScene {
    std::uint64_t sceneEdition = 0;
    int bounces = 1;
    double strength = 1.0;
    double rotationDeg = 0.0;
    double exposure = 1.0;               // 1 unless it changes light (grey faces)
    ToneMap toneMap = ToneMap::neutral;  // neutral unless it changes light

    bool operator==(const LightOfScene&) const = default;
};

// Each scene has one, which all its tracers share. Used by one thread at a time, the one that uses the
// device. It takes 7 MB from its first use on.
class IndirectCache {
  public:
    explicit IndirectCache(std::shared_ptr<gpu::Device> device) : device_(std::move(device)) {}

    // For a picture that uses the cache: clears it if it holds other light, or is full. outOfMemory.
    Result<void> prepare(const LightOfScene& light);
    // For a picture that does not use the cache: makes tiny tables to bind. outOfMemory.
    Result<void> makeBindable();

    // Appends the three bindings of kernels that trace paths, in the order of shaders/trace/host.glsl. After
    // prepare or makeBindable.
    void appendTo(std::vector<gpu::Binding>& bindings) const;
    // Adds the light that paths of a picture with these parameters have recorded since the last call.
    Result<void> add(gpu::Recorder& recorder, const shared::TraceParams& params);

    // By cell, kIndirectWays in each bucket: its tag, 0 if it is empty; the sums of its light, in units; and
    // its samples.
    struct Content {
        std::vector<std::uint32_t> tags;
        std::vector<glm::uvec4> cells;
    };
    Result<Content> read() const;  // waits; after prepare
    // For tests: makes this the content of the cache. After prepare.
    Result<void> write(const Content& content);

  private:
    struct Tables {
        gpu::TexelBuffer tags, cells;
        gpu::Buffer records, dropped;
    };
    static Result<Tables> makeTables(const std::shared_ptr<gpu::Device>& device, std::uint64_t buckets,
                                     std::uint64_t records);
    Result<void> forget();
    bool isFull() const;

    std::shared_ptr<gpu::Device> device_;
    std::optional<Tables> tables_;
    bool isUsable_ = false;  // the tables have their full size
    std::optional<gpu::Kernel> add_;
    std::optional<LightOfScene> light_;  // whose light the tables hold; nothing: they have to be cleared
};

}  // namespace macula::trace
