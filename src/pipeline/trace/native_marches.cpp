#include "pipeline/trace/native_marches.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <span>

#include "base/parallel.h"
#include "pipeline/trace/native_tables.h"
#include "shared/guide_params.h"
#include "shared/pixel_layers.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/trace/native_marches.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>
// After it, in this order.
#include "pipeline/trace/native_host-inl.h"

#include "pipeline/trace/march_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace macula::trace {
namespace HWY_NAMESPACE {
namespace {

// What all rays of a dispatch share.
struct Rays {
    Rays(const gpu::NativeDispatch& dispatch, const SceneKind& kind, int firstRow_)
        : scene(kind),
          params(dispatch.binding<const shared::TraceParams>(0)[0]),
          tables(nativeTables(dispatch, params, {.scene = kind})),
          host(tables, params, Filter::trilinear),
          firstRow(firstRow_),
          endRow(std::min(params.imageSize.y, firstRow + shared::kBlockEdge * int(dispatch.groups()[1]))) {}

    SceneKind scene;
    const shared::TraceParams& params;
    HostTables<PooledVoxels> tables;
    NativeHost host;
    int firstRow;
    int endRow;
};

// The pixels whose rays march together: two rows of them, so that they stay near each other.
struct Packet {
    static constexpr int kRows = Marches::kLanes > 1 ? 2 : 1;
    static constexpr int kColumns = int(Marches::kLanes) / kRows;

    std::array<glm::ivec2, Marches::kLanes> pixels;
    std::size_t count = 0;

    Packet(const glm::ivec2& first, const glm::ivec2& end) {
        for (int y = first.y; y < std::min(end.y, first.y + kRows); ++y)
            for (int x = first.x; x < std::min(end.x, first.x + kColumns); ++x) pixels[count++] = {x, y};
    }
};

// Calls one(packet, host, lanes) for each packet. Rows are few at a time, so threads take columns.
template <class One>
void forEachPacket(const Rays& rays, const One& one) {
    constexpr int kColumns = 8;  // of a task: in the middle rays take longest
    const int width = rays.params.imageSize.x;
    std::atomic<int> next{0};
    parallelFor(coreCount(), [&](std::size_t) {
        NativeHost host = rays.host;  // a copy, because layers write to it
        const auto lanes = std::make_unique<MarchLanes>(rays.tables, host, rays.scene);
        for (int first = next.fetch_add(kColumns); first < width; first = next.fetch_add(kColumns)) {
            const int end = std::min(width, first + kColumns);
            for (int y = rays.firstRow; y < rays.endRow; y += Packet::kRows)
                for (int x = first; x < end; x += Packet::kColumns)
                    one(Packet({x, y}, {end, rays.endRow}), host, *lanes);
        }
    });
}

// Marches along the centre rays of a packet's pixels.
struct PacketMarches {
    std::array<NativeHost::EyeRay, Marches::kLanes> eyes;
    std::array<NativeHost::BrickWalk, Marches::kLanes> walks;
    std::array<float, Marches::kLanes> faces;
    Marches found;

    PacketMarches(const Packet& packet, NativeHost& host, MarchLanes& lanes, bool findsLayers) {
        for (std::size_t n = 0; n < packet.count; ++n) {
            eyes[n] = host.eyeRay(glm::vec2(packet.pixels[n]) + 0.5f);
            walks[n] = host.startMarch(eyes[n], faces[n]);
        }
        for (auto& layer : found.layerMm) std::fill(std::begin(layer), std::end(layer), -1.0f);
        lanes.run(std::span(walks).first(packet.count), findsLayers, found);
    }
};

}  // namespace

void fillGuides(const gpu::NativeDispatch& dispatch, const SceneKind& scene) {
    const auto push = dispatch.push<shared::GuidePush>();
    const Rays rays(dispatch, scene, push.firstRow);
    const auto surfaces = dispatch.binding<glm::vec4>(16);
    const auto matters = dispatch.binding<glm::vec4>(17);
    const auto motions = dispatch.binding<glm::vec4>(18);
    const NativeHost::Fovea fovea{push.planeHalfSize, push.gaze, push.foveaRadius, push.foveaMagnification};
    const NativeHost::Eye before{push.oursMm, push.right, push.up, push.forward, fovea, push.parallelMm};
    const bool isBlurred = rays.params.lensRadiusMm > 0.0f;
    const auto tell = [&](const glm::ivec2& pixel, const NativeHost::Guide& guide) {
        const std::size_t index =
            std::size_t(pixel.y) * std::size_t(rays.params.imageSize.x) + std::size_t(pixel.x);
        surfaces[index] = {guide.normal, guide.depthMm};
        matters[index] = {guide.albedo, guide.coverage};
        motions[index] = {guide.motion, guide.confidence, guide.beforeMm};
    };
    forEachPacket(rays, [&](const Packet& packet, NativeHost& host, MarchLanes& lanes) {
        if (isBlurred) {
            for (std::size_t n = 0; n < packet.count; ++n)
                tell(packet.pixels[n], host.guideOf(glm::vec2(packet.pixels[n]) + 0.5f, before));
            return;
        }
        const PacketMarches marches(packet, host, lanes, false);
        for (std::size_t n = 0; n < packet.count; ++n) {
            NativeHost::March march = marches.found.of(n);
            if (marches.faces[n] > 0.0f)
                host.endAtFace(march, marches.walks[n].endMm, marches.faces[n] * host.params.exposure);
            const glm::vec2 centre = glm::vec2(packet.pixels[n]) + 0.5f;
            tell(packet.pixels[n], host.guideOfMarch(march, marches.eyes[n], centre, before));
        }
    });
}

void fillLayers(const gpu::NativeDispatch& dispatch, const SceneKind& scene) {
    const Rays rays(dispatch, scene, dispatch.push<shared::LayersPush>().firstRow);
    const auto pixels = dispatch.binding<shared::PixelLayers>(16);
    const auto tell = [&](const glm::ivec2& pixel, const NativeHost& host,
                          const NativeHost::LayeredRay& ray) {
        const auto& mm = host.layerMm;
        pixels[std::size_t(pixel.y) * std::size_t(rays.params.imageSize.x) + std::size_t(pixel.x)] = {
            {mm[0], mm[1], mm[2], mm[3]}, {mm[4], mm[5], mm[6], mm[7]}, ray.coverage, ray.meanMm};
    };
    forEachPacket(rays, [&](const Packet& packet, NativeHost& host, MarchLanes& lanes) {
        const PacketMarches marches(packet, host, lanes, true);
        for (std::size_t n = 0; n < packet.count; ++n) {
            for (int layer = 0; layer < Marches::kLayers; ++layer)
                host.layerMm[layer] = marches.found.layerMm[layer][n];
            NativeHost::March march = marches.found.of(n);
            tell(packet.pixels[n], host, host.layersOfMarch(march, marches.walks[n], marches.faces[n]));
        }
    });
}

}  // namespace HWY_NAMESPACE
}  // namespace macula::trace
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace macula::trace {

HWY_EXPORT(fillGuides);
HWY_EXPORT(fillLayers);

namespace {

// What lanes march through.
bool isOfMarchLanes(const SceneKind& scene) {
    return !scene.second && !scene.tints;
}

}  // namespace

gpu::NativeKernel nativeGuides(const SceneKind& scene) {
    if (!isOfMarchLanes(scene)) return {};
    return [scene](const gpu::NativeDispatch& dispatch) {
        HWY_DYNAMIC_DISPATCH(fillGuides)(dispatch, scene);
    };
}

gpu::NativeKernel nativeLayers(const SceneKind& scene) {
    if (!isOfMarchLanes(scene)) return {};
    return [scene](const gpu::NativeDispatch& dispatch) {
        HWY_DYNAMIC_DISPATCH(fillLayers)(dispatch, scene);
    };
}

}  // namespace macula::trace
#endif
