// A traced scene on the host: finds the box of visible matter, and a digest that tells whether a kept picture
// shows the same scene.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "base/result.h"
#include "base/volume.h"
#include "pipeline/trace/environment.h"
#include "pipeline/trace/settings.h"
#include "pipeline/volume/additions.h"
#include "pipeline/volume/clip.h"
#include "pipeline/volume/medium.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::hybrid {

class TracedScene {
  public:
    // The volume must be stored16. Fits the function to it, as the tracer does. Fails if the function, the
    // clip or the additions are not valid.
    static Result<TracedScene> create(std::shared_ptr<const Volume> volume, const TransferFunction& function,
                                      const Clip& clip, const trace::Environment& environment,
                                      const Additions& additions = {});

    // visibleBoxMm of what an eye sees, without matter that a clip removes and that only casts shadow.
    const Box& seenMm() const { return seenMm_; }

    // SHA-256, 64 hexadecimal digits, over all that a path-traced picture depends on: the volume's
    // fingerprint and the range of values in each of its bricks, the optics by value, clip, mask, additions,
    // lights, camera, size, settings, samples, and the compiled kernel itself. Contains no patient data.
    Result<std::string> pictureKey(const trace::View& view, const trace::Settings& settings,
                                   std::uint32_t samplesPerPixel) const;

  private:
    TracedScene(std::shared_ptr<const Volume> volume, const Clip& clip, const trace::Environment& environment,
                const Additions& additions)
        : volume_(std::move(volume)), clip_(clip), additions_(additions), environment_(environment) {}

    std::shared_ptr<const Volume> volume_;
    Clip clip_;
    Additions additions_;
    trace::Environment environment_;
    Medium medium_;
    Box seenMm_;
    std::string digest_;  // over all but view, settings and samples
};

}  // namespace macula::hybrid
