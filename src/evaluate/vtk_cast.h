// VTK's ray casting on the CPU (vtkFixedPointVolumeRayCastMapper), beside which ours is measured.
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
    TransferFunction function;  // fitted to it
    trace::View view;
    trace::Look look = trace::Look::dvr;  // one that is cast; a mean is VTK's sum of values
    bool shading = false;
    DisplayWindow window;  // of projections
    int turns = 5;
    std::size_t threads = 2;
};

struct VtkCast {
    double firstSeconds = 0.0;    // with what VTK prepares once: gradients, its tree of values
    std::vector<double> seconds;  // of each further picture
    double stepMm = 0.0;          // VTK's own choice: half of the mean spacing
    image::Image picture;         // display-encoded RGB, over black
    double fineSeconds = 0.0;     // in steps of a third
    image::Image fine;
    image::Image converged;  // nine rays to a pixel, in steps of a third
};

// After each further picture `afterTurn` is called, so that contenders take turns. In a plug-in that is built
// where VTK is installed. Fails with inputNotUsable when the grid is no box of right angles; with
// deviceNotUsable when there is no plug-in, or no display, which VTK needs.
Result<VtkCast> castWithVtk(const VtkCastRequest& options, const std::function<void()>& afterTurn);

}  // namespace macula::evaluate

// The plug-in's export, which castWithVtk calls.
extern "C" void maculaCastWithVtk(const macula::evaluate::VtkCastRequest& options,
                                  const std::function<void()>& afterTurn,
                                  macula::Result<macula::evaluate::VtkCast>& result);
