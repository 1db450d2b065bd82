#include "evaluate/vtk_cast.h"

#include <cstdlib>

#include "base/plugin.h"

namespace macula::evaluate {

Result<VtkCast> castWithVtk(const VtkCastRequest& options, const std::function<void()>& afterTurn) {
    if (std::getenv("DISPLAY") == nullptr) {
        return Error{ErrorCode::deviceNotUsable,
                     Text("VTK draws on a display, and there is none."),
                     {},
                     Text("Run it in a desktop session, or under xvfb-run.")};
    }
    MACULA_TRY(void* symbol, symbolOfPlugin("macula-vtk-cast", "maculaCastWithVtk"));
    Result<VtkCast> result = VtkCast{};
    reinterpret_cast<decltype(&maculaCastWithVtk)>(symbol)(options, afterTurn, result);
    return result;
}

}  // namespace macula::evaluate
