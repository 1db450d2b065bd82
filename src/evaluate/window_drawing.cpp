#include "evaluate/window_drawing.h"

#include "scene/choice/catalogue.h"

namespace macula::evaluate {

Result<std::shared_ptr<const trace::LightRig>> builtInLights(const std::string& name) {
    MACULA_TRY(const app::Catalogue catalogue, app::builtInCatalogue());
    return app::findLights(catalogue, name);
}

Result<app::Drawing> drawingOf(const BenchStudy& study) {
    app::Drawing drawing;
    drawing.transferFunction = std::make_shared<const TransferFunction>(study.function);
    MACULA_TRY(drawing.lights, builtInLights(study.lights));
    return drawing;
}

}  // namespace macula::evaluate
