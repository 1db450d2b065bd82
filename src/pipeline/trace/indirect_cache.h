// A cache of indirect light on the device: what arrives at the first vertices of paths from other matter, by
// place (shaders/lib/indirect.glsl). Paths that go on from their first vertex fill it, and others end there.
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

// What the light of a scene depends on, beside what kind of scene it is.
struct LightOfScene {
    std::uint64_t sceneEdition = 0;
    int bounces = 1;
    double strength = 1.0;
    double rotationDeg = 0.0;
    double exposure = 1.0;               // 1 where it changes no light
    ToneMap toneMap = ToneMap::neutral;  // likewise

    bool operator==(const LightOfScene&) const = default;
};

// One for each scene, whichever tracers look at it. Used by one thread at a time, the one that uses the
// device. It takes 7 MB once it is used.
class IndirectCache {
  public:
    explicit IndirectCache(std::shared_ptr<gpu::Device> device) : device_(std::move(device)) {}

    // For a picture that uses it: forgets what it knows of other light. outOfMemory.
    Result<void> prepare(const LightOfScene& light);
    // Something to bind for a picture that does not. outOfMemory.
    Result<void> makeBindable();

    // Three bindings of kernels that trace paths, in the order of shaders/trace/host.glsl. After prepare or
    // makeBindable.
    void appendTo(std::vector<gpu::Binding>& bindings) const;
    // Adds what the paths of a picture with these parameters have told since the last time.
    Result<void> add(gpu::Recorder& recorder, const shared::TraceParams& params);

    // By cell, kIndirectWays in each bucket: its tag, 0 for none; and sums of light in units, and samples.
    struct Content {
        std::vector<std::uint32_t> tags;
        std::vector<glm::uvec4> cells;
    };
    Result<Content> read() const;  // waits; after prepare
    // For tests: as if that had been read. After prepare.
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
    std::optional<LightOfScene> light_;  // that the tables know; nothing: they have to be cleared
};

}  // namespace macula::trace
