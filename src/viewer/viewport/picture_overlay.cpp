#include "viewer/viewport/picture_overlay.h"

#include <utility>

#include "viewer/overlay/painted_text.h"
#include "viewer/status/status_texts.h"
#include "viewer/theme/theme.h"

namespace macula::viewer {

void PictureOverlay::setNames(std::vector<std::string> names) {
    names_ = std::move(names);
}

bool PictureOverlay::showNames(bool shown) {
    return std::exchange(namesShown_, shown) != shown;
}

bool PictureOverlay::showCube(bool shown) {
    return std::exchange(cubeShown_, shown) != shown;
}

std::shared_ptr<const live::PictureText> PictureOverlay::text(const scene::Drawing& drawing, QSize pixels,
                                                              double pixelRatio) {
    TextOf wanted{.lines = linesOver(namesShown_ ? names_ : std::vector<std::string>(), drawing),
                  .pixels = pixels,
                  .pixelRatio = pixelRatio,
                  .fontScale = fontScaleOverPictures()};
    wanted.lines.notes.insert(wanted.lines.notes.begin(), notes_.begin(), notes_.end());
    if (wanted == textOf_) return text_;
    textOf_ = std::move(wanted);
    text_ = paintText(textOf_.lines, pixels, pixelRatio);
    return text_;
}

std::shared_ptr<const live::PictureText> PictureOverlay::marks(const std::optional<MarkedPicture>& picture,
                                                               std::vector<ToolMark> ofTools,
                                                               const scene::EdgeLetters& letters) {
    std::optional<Marked> wanted;
    if (picture)
        wanted = Marked{.picture = *picture,
                        .hasCube = cubeShown_,
                        .fontScale = fontScaleOverPictures(),
                        .ofTools = std::move(ofTools)};
    if (wanted == marked_) return marks_;
    Marked stands = wanted.value_or(Marked{});  // without the marks of tools, which lie above it
    stands.ofTools = marked_ ? marked_->ofTools : std::vector<ToolMark>();
    const bool isSame = wanted && marked_ && stands == *marked_;
    marked_ = std::move(wanted);
    if (!isSame) standing_ = marked_ ? paintStanding(*marked_, letters) : nullptr;
    marks_ = marked_ ? withToolMarks(standing_, marked_->ofTools, marked_->picture.pixels,
                                     marked_->picture.pixelRatio)
                     : nullptr;
    return marks_;
}

std::shared_ptr<const live::PictureText> PictureOverlay::paintStanding(const Marked& marked,
                                                                       const scene::EdgeLetters& letters) {
    return withSideLetters(marked.hasCube ? paintCubeAndScale(marked.picture) : nullptr, letters,
                           marked.picture.pixels, marked.picture.pixelRatio);
}

}  // namespace macula::viewer
