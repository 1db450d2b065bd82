#include "live/model/model_to_write.h"

#include <fstream>
#include <utility>

#include "base/atomic_file.h"
#include "live/model/model_output.h"
#include "live/model/training_identity.h"
#include "pipeline/hybrid/model/peripheral_file.h"
#include "pipeline/splat/model/constant_colour.h"
#include "pipeline/trace/environment.h"

namespace macula::live {

namespace {

Error cancelled() {
    return {ErrorCode::cancelled, Text("Stopped; nothing was written."), {}, {}};
}

Result<void> writeState(const std::filesystem::path& path, const ModelToWrite& model) {
    if (!model.state)
        return Error{ErrorCode::inputNotUsable,
                     Text("The model has learnt nothing yet that training could go on with."),
                     {},
                     Text("Wait until the picture converges, or save it as .ply, .spz or .glb.")};
    const scene::Drawing& drawing = model.drawing;
    hybrid::PeripheralState state = *model.state;  // pictures are shared
    // In memory the key is the name of its scene, which means nothing outside this run.
    state.training.options.key = trainingIdentity(
        *in16Bits(model.volume), *drawing.transferFunction, drawing.clip ? *drawing.clip : Clip{},
        trace::Environment::fromRig(*drawing.lights), drawing.additions ? *drawing.additions : Additions{});
    state.first.key = state.training.options.key;
    return writeAtomically(path, [&](const std::filesystem::path& temporary) -> Result<void> {
        std::ofstream stream(temporary, std::ios::binary);
        splat::PackedPictures packed;
        MACULA_TRY_VOID(hybrid::writePeripheral(stream, state, packed));
        stream.flush();
        if (stream) return {};
        return Error{ErrorCode::outputNotWritable,
                     Text("The model could not be written."),
                     {},
                     Text("Check free space and permissions.")};
    });
}

}  // namespace

splat::Splats asBright(splat::Splats splats, double gain) {
    const auto factor = static_cast<float>(gain);
    for (glm::vec3& dc : splats.dc) dc = splat::dcOfColour(factor * splat::colourOfDc(dc));
    for (glm::vec3& sh : splats.sh) sh *= factor;
    return splats;
}

Result<std::size_t> writeModelFile(const std::filesystem::path& path, const ModelToWrite& model,
                                   bool displayColours, Progress& progress) {
    MACULA_TRY_VOID(checkModelName(path));
    progress.beginStage(Text("Writing the model"), 1);
    if (progress.cancelled()) return cancelled();
    if (holdsTraining(path)) {
        if (displayColours)
            return Error{ErrorCode::usage,
                         Text("What goes on learning needs linear colours."),
                         {},
                         Text("Save it as .ply, .spz or .glb, or without colours as displayed.")};
        MACULA_TRY_VOID(writeState(path, model));
        progress.advance();
        return std::size_t{0};
    }
    MACULA_TRY(const std::size_t limited,
               writeSplats(path, asBright(*model.splats, model.gain), displayColours));
    progress.advance();
    return limited;
}

}  // namespace macula::live
