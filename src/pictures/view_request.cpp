#include "pictures/view_request.h"

#include <fmt/format.h>

#include "scene/choice/lights_choice.h"
#include "scene/choice/preset_choice.h"
#include "scene/drawing/drawing_of.h"
#include "scene/drawing/shown_clip.h"

namespace macula::pictures {

Result<PictureRequest> requestOf(const ViewPicture& picture, bool isLinear) {
    const glm::ivec2 size = picture.sizePx;
    if (size.x < 1 || size.y < 1 || size.x > trace::kMaxPictureSide || size.y > trace::kMaxPictureSide)
        return Error{ErrorCode::usage, Text("The picture cannot have that size."),
                     fmt::format("{} x {}", size.x, size.y),
                     Text("Take 1 to {} pixels for each side.", trace::kMaxPictureSide)};
    MACULA_TRY_VOID(check(picture.effects));
    MACULA_TRY(Effort effort, effortOf(picture.effort, picture.drawing.settings));
    const scene::Drawing& drawing = picture.drawing;
    return PictureRequest{.scene = {.volume = in16Bits(picture.volume),
                                    .function = *drawing.transferFunction,
                                    .clip = drawing.clip ? *drawing.clip : Clip{},
                                    .environment = trace::Environment::fromRig(*drawing.lights),
                                    .additions = drawing.additions ? *drawing.additions : Additions{}},
                          .camera = picture.camera,
                          .sizePx = size,
                          .settings = effort.settings,
                          .samplesPerPixel = effort.samplesPerPixel,
                          .isLinear = isLinear,
                          .background = drawing.background.value_or(scene::kBlackBackground),
                          .effects = picture.effects};
}

RenderRecord recordOf(const ViewPicture& picture, const PictureRequest& request, const DrawnPicture& drawn) {
    RenderRecord record;
    record.seriesDigest = picture.seriesDigest;
    record.preset = scene::publicPresetName(request.scene.function);
    record.lights = scene::publicLightsName(*picture.drawing.lights);
    record.clip = request.scene.clip.hasShape() ? "clipped" : "none";
    if (request.scene.clip.mask) record.masked = request.scene.clip.mask->remark.english();
    record.additions = scene::remarkOf(request.scene.additions, request.settings.look).english();
    record.tableRemoved = record.masked.find(scene::kTableLeftOut) != std::string::npos;
    record.presetFitted = request.scene.function.fitToVolume.has_value();
    record.window = request.settings.window;
    record.add(request, drawn);
    return record;
}

std::vector<Text> sentencesOf(const DrawnPicture& drawn, const PictureRequest& request) {
    std::vector<Text> sentences;
    for (const PictureNote& note : notesOf(drawn, request))
        sentences.push_back(Text::joined({note.sentence, note.action}, " "));
    return sentences;
}

}  // namespace macula::pictures
