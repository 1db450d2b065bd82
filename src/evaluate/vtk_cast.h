// VTK's ray casting on the CPU (vtkFixedPointVolumeRayCastMapper), for comparison with Macula's.
#pragma once

#include <functional>
#include <vector>

#include "base/result.h"
#include "base/volume.h"
#include "image/image.h"
#include "pipeline/trace/settings.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::evaluate {

struct VtkCastRequest {
    const Volume* volume = nullptr;
    TransferFunction function;  // fitted to `volume`
    trace::View view;
    trace::Look look = trace::Look::dvr;  // a ray-cast look; VTK sums values for a mean
    bool shading = false;
    DisplayWindow window;  // for projections
    int turns = 5;
    std::size_t threads = 2;
};

struct VtkCast {
    double firstSeconds = 0.0;    // with one-time preparation: gradients, tree of values
    std::vector<double> seconds;  // of each later picture
    double stepMm = 0.0;          // VTK's own choice: half of the mean spacing
    image::Image picture;         // display-encoded RGB, over black
    double fineSeconds = 0.0;     // in steps of a third
    image::Image fine;
    image::Image converged;  // nine rays per pixel, in steps of a third
};

// Calls `afterTurn` after each later picture, so that contenders alternate. Runs in a plug-in that is built
// if VTK is installed. Fails with inputNotUsable if the axes of the grid are not at right angles; with
// deviceNotUsable without the plug-in, or without a display, which VTK needs.
Result<VtkCast> castWithVtk(const VtkCastRequest& options, const std::function<void()>& afterTurn);

}  // namespace macula::evaluate

// The plug-in's export, which castWithVtk calls.
extern "C" void maculaCastWithVtk(const macula::evaluate::VtkCastRequest& options,
                                  const std::function<void()>& afterTurn,
                                  macula::Result<macula::evaluate::VtkCast>& result);
