#include "evaluate/window_drawing.h"

#include "scene/choice/catalogue.h"

namespace macula::evaluate {

Result<std::shared_ptr<const trace::LightRig>> builtInLights(const std::string& name) {
    MACULA_TRY(const scene::Catalogue catalogue, scene::builtInCatalogue());
    return scene::findLights(catalogue, name);
}

Result<scene::Drawing> drawingOf(const BenchStudy& study) {
    scene::Drawing drawing;
    drawing.transferFunction = std::make_shared<const TransferFunction>(study.function);
    MACULA_TRY(drawing.lights, builtInLights(study.lights));
    return drawing;
}

}  // namespace macula::evaluate
