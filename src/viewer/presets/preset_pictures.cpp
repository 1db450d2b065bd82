#include "viewer/presets/preset_pictures.h"

#include <new>
#include <optional>
#include <utility>

namespace macula::viewer {

namespace {

QImage asImage(const pictures::PresetThumbnail& thumbnail) {
    const QImage borrowed(thumbnail.rgba.data(), thumbnail.sizePx, thumbnail.sizePx, QImage::Format_RGBA8888);
    return borrowed.copy();
}

}  // namespace

PresetPictures::PresetPictures()
    : job_(this, {.ended = [this](const Result<Drawn>& drawn) { take(drawn); }}) {}

void PresetPictures::begin(std::shared_ptr<const Volume> volume) {
    job_.cancel();
    drawing_.reset();
    coarse_.reset();
    hasNone_ = false;
    volume_ = std::move(volume);
}

void PresetPictures::draw(const LibraryPreset& preset) {
    drawing_ = preset.function;
    std::optional<ClipPreset> clip;
    if (preset.own && preset.own->seen) clip = preset.own->seen->state.clip;
    job_.start([volume = volume_, coarse = coarse_, function = preset.function,
                clip = std::move(clip)](Progress& progress) -> Result<Drawn> {
        try {
            Drawn drawn{.coarse = coarse, .picture = {}};
            if (!drawn.coarse) {
                MACULA_TRY(drawn.coarse, pictures::CoarseVolume::of(volume, progress.token()));
            }
            const Clip hidden = clip ? clipFor(*clip, *volume) : Clip{};
            const auto made = pictures::presetThumbnail(*drawn.coarse, *function, &hidden, progress.token());
            if (made) drawn.picture = asImage(*made);  // otherwise the preset has no picture
            return drawn;
        } catch (const std::bad_alloc&) {
            return Error{ErrorCode::outOfMemory,
                         Text("There is not enough memory for small pictures."),
                         {},
                         Text("Close other programs.")};
        }
    });
}

void PresetPictures::take(const Result<Drawn>& made) {
    const auto function = std::exchange(drawing_, nullptr);
    if (!made) {
        hasNone_ = true;
        Q_EMIT failed(made.error());
        return;
    }
    coarse_ = made->coarse;
    Q_EMIT drawn(function, made->picture);
}

}  // namespace macula::viewer
