// A picture of the phantom.
#include <live/device/open_device.h>
#include <pictures/drawn_picture.h>
#include <scene/choice/catalogue.h>
#include <study/open/opened_study.h>

#include "ends.h"

int main() {
    using namespace macula;
    Progress progress;
    auto study = study::openStudy(std::nullopt, progress);
    if (!study) return fail(study.error());
    const auto catalogue = scene::builtInCatalogue();
    if (!catalogue) return fail(catalogue.error());
    auto device = live::openDevice("", {});
    if (!device) return fail(device.error());
    bool isWhole = false;
    pictures::PictureRequest request;
    request.scene.volume = study->volume;
    request.scene.function = *scene::presetFor(*catalogue, *study->volume);
    request.sizePx = {32, 32};
    request.samplesPerPixel = 1;
    const auto drawn = device->run([&](const auto& lent) -> Result<void> {
        const auto picture = pictures::drawPicture(lent, request, progress);
        if (!picture) return picture.error();
        isWhole = picture->rgba.size() == std::size_t{4} * 32 * 32;
        return {};
    });
    if (!drawn) return fail(drawn.error());
    return expect(isWhole, "a picture of 32 x 32");
}
