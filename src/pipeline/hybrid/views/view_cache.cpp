#include "pipeline/hybrid/views/view_cache.h"

#include <utility>

#include "base/sha256.h"
#include "shaders/trace.h"

namespace macula::hybrid {

namespace {

// The digest of all kernels, besides the path tracer's own, that such pictures depend on.
const std::string& kernelsDigest() {
    static const std::string digest = [] {
        std::string text;
        for (const gpu::ShaderCode* code :
             {&shaders::trace_guides_comp, &shaders::denoise_gather_comp, &shaders::denoise_prepare_comp,
              &shaders::denoise_filter_comp, &shaders::denoise_specks_comp, &shaders::trace_layers_comp,
              &shaders::trace_path_primaries_comp})
            text += sha256Hex(std::as_bytes(std::span(code->words)));
        return sha256Hex(text);
    }();
    return digest;
}

// The version of the host's part in such pictures; raise it with each change.
constexpr int kVersion = 3;

}  // namespace

// The key differs from that of a ground-truth picture, whose coverage comes from its samples.
Result<std::string> ViewCache::keyOf(const ViewMaking& making) const {
    MACULA_TRY(const std::string traced,
               scene_.pictureKey(making.view, making.settings, making.samplesPerPixel));
    return sha256Hex(fmt::format("to learn from {} {} {}", kVersion, traced, kernelsDigest()));
}

Result<std::vector<std::string>> ViewCache::keysOf(std::span<const ViewMaking> makings) const {
    std::vector<std::string> keys;
    std::string all;
    for (const ViewMaking& making : makings) {
        MACULA_TRY(const std::string key, keyOf(making));
        keys.push_back(key);
        all += key;
    }
    const std::string set = sha256Hex(all);
    for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = sha256Hex(fmt::format("lit {} of {}", i, set));
    return keys;
}

std::optional<TracedView> ViewCache::read(const std::string& key, const ViewMaking& making) const {
    std::optional<KeptPicture> kept = cache_.find(key);
    if (!kept || kept->sizePx != glm::ivec2(making.view.width, making.view.height)) return {};
    return TracedView{.camera = making.view.camera,
                      .sizePx = kept->sizePx,
                      .rgba = std::move(kept->rgba),
                      .samplesPerPixel = double(making.samplesPerPixel)};
}

Result<std::optional<TracedView>> ViewCache::find(const ViewMaking& making) const {
    MACULA_TRY(const std::string key, keyOf(making));
    return read(key, making);
}

Result<void> ViewCache::keep(const ViewMaking& making, const TracedView& view) const {
    MACULA_TRY(const std::string key, keyOf(making));
    return cache_.keep(key, {.sizePx = view.sizePx, .rgba = view.rgba});
}

Result<std::optional<std::vector<TracedView>>> ViewCache::findSet(std::span<const ViewMaking> makings) const {
    using Views = std::optional<std::vector<TracedView>>;
    MACULA_TRY(const std::vector<std::string> keys, keysOf(makings));
    std::vector<TracedView> views;
    for (std::size_t i = 0; i < makings.size(); ++i) {
        std::optional<TracedView> view = read(keys[i], makings[i]);
        if (!view) return Views();
        view->isLit = true;
        views.push_back(std::move(*view));
    }
    return Views(std::move(views));
}

Result<void> ViewCache::keepSet(std::span<const ViewMaking> makings,
                                std::span<const TracedView> views) const {
    MACULA_CHECK(makings.size() == views.size());
    MACULA_TRY(const std::vector<std::string> keys, keysOf(makings));
    for (std::size_t i = 0; i < views.size(); ++i)
        MACULA_TRY_VOID(cache_.keep(keys[i], {.sizePx = views[i].sizePx, .rgba = views[i].rgba}));
    return {};
}

}  // namespace macula::hybrid
