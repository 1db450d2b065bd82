// XR_KHR_visibility_mask: what no lens shows.
#include <cstring>

#include "xr/runtime/state.h"

namespace macula::xr_script {

namespace {

XrResult XRAPI_CALL getMask(XrSession session, XrViewConfigurationType type, std::uint32_t view,
                            XrVisibilityMaskTypeKHR kind, XrVisibilityMaskKHR* mask) {
    const std::lock_guard lock(state().mutex);
    if (const XrResult lost = enteredSession("xrGetVisibilityMaskKHR", session); lost != XR_SUCCESS)
        return lost;
    if (type != viewConfiguration() || view >= viewCount())
        return wrong(XR_ERROR_VALIDATION_FAILURE, "xrGetVisibilityMaskKHR: the view");
    if (mask->type != XR_TYPE_VISIBILITY_MASK_KHR)
        return wrong(XR_ERROR_VALIDATION_FAILURE, "xrGetVisibilityMaskKHR: type");
    const std::vector<glm::dvec2>& hidden = state().script.hidden;
    const auto count =
        kind == XR_VISIBILITY_MASK_TYPE_HIDDEN_TRIANGLE_MESH_KHR ? std::uint32_t(hidden.size()) : 0u;
    mask->vertexCountOutput = count;
    mask->indexCountOutput = count;
    if (mask->vertexCapacityInput == 0 && mask->indexCapacityInput == 0) return XR_SUCCESS;
    if (mask->vertexCapacityInput < count || mask->indexCapacityInput < count)
        return XR_ERROR_SIZE_INSUFFICIENT;
    for (std::uint32_t i = 0; i < count; ++i) {
        mask->vertices[i] = {float(hidden[i].x), float(hidden[i].y)};
        mask->indices[i] = i;
    }
    return XR_SUCCESS;
}

}  // namespace

PFN_xrVoidFunction maskFunction(std::string_view name) {
    if (!state().extensions.contains(XR_KHR_VISIBILITY_MASK_EXTENSION_NAME)) return nullptr;
    return name == "xrGetVisibilityMaskKHR" ? reinterpret_cast<PFN_xrVoidFunction>(getMask) : nullptr;
}

void changeMask(std::vector<glm::dvec2> hidden) {
    State& s = state();
    const std::lock_guard lock(s.mutex);
    s.script.hidden = std::move(hidden);
    for (std::uint32_t view = 0; s.session && view < viewCount(); ++view) {
        XrEventDataVisibilityMaskChangedKHR event{XR_TYPE_EVENT_DATA_VISIBILITY_MASK_CHANGED_KHR};
        event.session = sessionHandle();
        event.viewConfigurationType = viewConfiguration();
        event.viewIndex = view;
        XrEventDataBuffer buffer{XR_TYPE_EVENT_DATA_BUFFER};
        std::memcpy(&buffer, &event, sizeof(event));
        s.events.push_back(buffer);
    }
}

}  // namespace macula::xr_script
