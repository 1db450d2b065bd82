#include "pipeline/hybrid/views/traced_scene.h"

#include <span>
#include <type_traits>

#include "base/fingerprint.h"
#include "base/sha256.h"
#include "pipeline/trace/scene.h"
#include "pipeline/volume/brick_grid.h"
#include "pipeline/volume/mask_bits.h"
#include "pipeline/volume/visible_box.h"
#include "pipeline/volume/volume_fit.h"
#include "shaders/trace.h"

namespace macula::hybrid {

namespace {

// Hashes the bytes of numbers; they must have no padding.
template <class T>
std::string hashOf(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % alignof(float) == 0);
    return sha256Hex(std::as_bytes(values)) + "\n";
}

}  // namespace

Result<TracedScene> TracedScene::create(std::shared_ptr<const Volume> volume,
                                        const TransferFunction& function, const Clip& clip,
                                        const trace::Environment& environment, const Additions& additions) {
    MACULA_CHECK(volume != nullptr && volume->format() == VoxelFormat::stored16);
    MACULA_TRY_VOID(validate(function));
    MACULA_TRY_VOID(validate(clip));
    MACULA_TRY_VOID(validate(additions, *volume));
    TracedScene scene(std::move(volume), clip, environment, additions);
    const Volume& v = *scene.volume_;
    const TransferFunction fit = fitted(function, v);
    const BrickGrid grid = makeBrickGrid(v);
    std::optional<MaskBits> mask;
    if (clip.mask) mask = maskBits(*clip.mask, v);
    // Majorants of visible matter only: the tracer's own also cover removed matter that casts shadow.
    Clip ofEye = clip;
    ofEye.removedCastsShadow = false;
    scene.medium_ = makeMedium(v, grid, fit, ofEye, mask ? &*mask : nullptr, addedBounds(additions, v, grid));
    scene.seenMm_ = visibleBoxMm(v, grid, scene.medium_);

    static_assert(sizeof(EntryRange) == 4 && sizeof(trace::EnvironmentTexel) == 16);
    const Medium& medium = scene.medium_;
    std::string text = fingerprint(v) + "\n" + hashOf<EntryRange>(grid.ranges);
    text += hashOf<float>(medium.extinctionPerMm) + hashOf<glm::vec4>(medium.albedo) +
            hashOf<float>(medium.gradientOpacity) + hashOf<glm::vec4>(medium.steep) +
            hashOf<float>(medium.bounds);
    text += mask ? hashOf<std::uint32_t>(mask->words) : "no mask\n";
    if (additions.second)
        text += fingerprint(*additions.second->volume) + "\n" +
                hashOf<EntryRange>(makeBrickGrid(*additions.second->volume).ranges);
    if (!additions.isNothing()) text += hashOf<glm::vec4>(additionTable(additions));
    if (additions.tints) text += sha256Hex(std::as_bytes(std::span(additions.tints->box->voxels))) + "\n";
    text += hashOf<trace::EnvironmentTexel>(environment.texels());
    text += hashOf<std::uint32_t>(shaders::trace_path_comp.words);
    scene.digest_ = sha256Hex(text);
    return scene;
}

Result<std::string> TracedScene::pictureKey(const trace::View& view, const trace::Settings& settings,
                                            std::uint32_t samplesPerPixel) const {
    MACULA_CHECK(trace::isPathTraced(settings.look));
    MACULA_TRY(const shared::TraceParams params,
               makeTraceParams(*volume_, medium_, environment_, view, settings, clip_, additions_));
    return sha256Hex(fmt::format("{} {} {} {} {}", digest_, sha256Hex(std::as_bytes(std::span(&params, 1))),
                                 trace::nameOf(settings.filter), nameOf(settings.denoising),
                                 samplesPerPixel));
}

}  // namespace macula::hybrid
