#include "viewer/pick/anatomy_pick.h"

#include <utility>

namespace macula::viewer {

AnatomyPick::AnatomyPick(QObject* parent)
    : QObject(parent),
      job_(this, {.progressed = [](const ProgressUpdate&) {},
                  .ended =
                      [this](const Result<std::optional<glm::dvec3>>& outcome) {
                          if (outcome && *outcome) Q_EMIT found(**outcome);
                      }}) {}

void AnatomyPick::start(std::shared_ptr<const Volume> volume, scene::Drawing drawing, const Camera& camera,
                        const glm::dvec2& place, double aspectWidthOverHeight) {
    job_.start([volume = std::move(volume), drawing = std::move(drawing), camera, place,
                aspectWidthOverHeight](Progress&) -> Result<std::optional<glm::dvec3>> {
        return scene::firstMatterMm(*volume, drawing, camera, place, aspectWidthOverHeight);
    });
}

}  // namespace macula::viewer
