// Frames: waited for, begun and ended in this order, with one layer for the eyes at most; and where the eyes
// are.
#include <cmath>

#include "xr/runtime/state.h"

namespace macula::xr_script {

namespace {

XrResult XRAPI_CALL waitFrame(XrSession session, const XrFrameWaitInfo*, XrFrameState* frame) {
    State& all = state();
    const std::lock_guard lock(all.mutex);
    if (const XrResult lost = enteredSession("xrWaitFrame", session); lost != XR_SUCCESS) return lost;
    SessionState& s = *all.session;
    if (!s.isRunning) return wrong(XR_ERROR_SESSION_NOT_RUNNING, "xrWaitFrame: the session does not run");
    // A real one would block for ever.
    if (s.isWaited) return wrong(XR_ERROR_CALL_ORDER_INVALID, "xrWaitFrame: the frame before was not begun");
    const auto period = XrDuration(1e9 / all.script.framesPerS);
    s.isWaited = true;
    s.predicted = kFirstTime + XrTime(all.record.waited) * period;
    s.frame = all.record.waited++;
    frame->predictedDisplayTime = s.predicted;
    frame->predictedDisplayPeriod = period;
    frame->shouldRender = !all.script.shouldRender || all.script.shouldRender(s.frame) ? XR_TRUE : XR_FALSE;
    if (s.state == XR_SESSION_STATE_READY) goTo(XR_SESSION_STATE_SYNCHRONIZED);
    return XR_SUCCESS;
}

XrResult XRAPI_CALL beginFrame(XrSession session, const XrFrameBeginInfo*) {
    State& all = state();
    const std::lock_guard lock(all.mutex);
    if (const XrResult lost = enteredSession("xrBeginFrame", session); lost != XR_SUCCESS) return lost;
    SessionState& s = *all.session;
    if (!s.isRunning) return wrong(XR_ERROR_SESSION_NOT_RUNNING, "xrBeginFrame: the session does not run");
    if (!s.isWaited) return wrong(XR_ERROR_CALL_ORDER_INVALID, "xrBeginFrame without xrWaitFrame");
    s.isWaited = false;
    ++all.record.begun;
    if (s.isBegun) return wrong(XR_FRAME_DISCARDED, "xrBeginFrame: the frame before was not ended");
    s.isBegun = true;
    return XR_SUCCESS;
}

XrResult takeView(const XrCompositionLayerProjectionView& view, SubmittedFrame& frame) {
    State& all = state();
    const auto found = all.swapchains.find(view.subImage.swapchain);
    if (view.type != XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW || found == all.swapchains.end())
        return wrong(XR_ERROR_LAYER_INVALID, "xrEndFrame: the structure of a view");
    const SwapchainState& swapchain = *found->second;
    const XrRect2Di& rect = view.subImage.imageRect;
    if (!swapchain.released || !swapchain.acquired.empty())
        return wrong(XR_ERROR_LAYER_INVALID, "xrEndFrame: the image of a view was not released");
    if (rect.offset.x < 0 || rect.offset.y < 0 || rect.extent.width <= 0 || rect.extent.height <= 0 ||
        std::uint32_t(rect.offset.x + rect.extent.width) > swapchain.info.width ||
        std::uint32_t(rect.offset.y + rect.extent.height) > swapchain.info.height ||
        view.subImage.imageArrayIndex >= swapchain.info.arraySize)
        return wrong(XR_ERROR_SWAPCHAIN_RECT_INVALID, "xrEndFrame: a view lies beside its image");
    const Pose pose = toPose(view.pose);
    if (!(std::abs(glm::length(pose.orientation) - 1.0) < 0.01))
        return wrong(XR_ERROR_POSE_INVALID, "xrEndFrame: the pose of a view");
    const XrFovf& fov = view.fov;
    if (!(fov.angleLeft < fov.angleRight && fov.angleDown < fov.angleUp))
        return wrong(XR_ERROR_LAYER_INVALID, "xrEndFrame: the field of a view is mirrored");
    frame.views.push_back({pose,
                           {fov.angleLeft, fov.angleRight, fov.angleUp, fov.angleDown},
                           {rect.extent.width, rect.extent.height},
                           readImage(swapchain, view.subImage.imageArrayIndex, rect)});
    return XR_SUCCESS;
}

XrResult takeLayers(const XrFrameEndInfo& info, SubmittedFrame& frame) {
    if (info.layerCount > 16) return wrong(XR_ERROR_LAYER_LIMIT_EXCEEDED, "xrEndFrame: layers");
    for (std::uint32_t i = 0; i < info.layerCount; ++i) {
        // Flat ones may lie in front of the one for the eyes.
        if (i > 0 && info.layers[i] && info.layers[i]->type == XR_TYPE_COMPOSITION_LAYER_QUAD) {
            const auto& quad = *reinterpret_cast<const XrCompositionLayerQuad*>(info.layers[i]);
            if (const XrResult taken = takeQuad(quad, frame); taken != XR_SUCCESS) return taken;
            continue;
        }
        if (i > 0) return wrong(XR_ERROR_LAYER_INVALID, "xrEndFrame: two layers for the eyes");
        const auto* layer = reinterpret_cast<const XrCompositionLayerProjection*>(info.layers[i]);
        if (!layer || layer->type != XR_TYPE_COMPOSITION_LAYER_PROJECTION || layer->viewCount != 2)
            return wrong(XR_ERROR_LAYER_INVALID, "xrEndFrame: no projection layer of two views");
        if (!state().spaces.contains(layer->space))
            return wrong(XR_ERROR_HANDLE_INVALID, "xrEndFrame: the space of the layer");
        for (std::uint32_t view = 0; view < 2; ++view)
            if (const XrResult taken = takeView(layer->views[view], frame); taken != XR_SUCCESS) return taken;
    }
    return XR_SUCCESS;
}

// As real runtimes do, a step for each frame.
void goOn(SessionState& session) {
    if (session.state == XR_SESSION_STATE_SYNCHRONIZED)
        goTo(XR_SESSION_STATE_VISIBLE);
    else if (session.state == XR_SESSION_STATE_VISIBLE)
        goTo(XR_SESSION_STATE_FOCUSED);
}

XrResult XRAPI_CALL endFrame(XrSession session, const XrFrameEndInfo* info) {
    State& all = state();
    const std::lock_guard lock(all.mutex);
    if (const XrResult lost = enteredSession("xrEndFrame", session); lost != XR_SUCCESS) return lost;
    SessionState& s = *all.session;
    if (!s.isBegun) return wrong(XR_ERROR_CALL_ORDER_INVALID, "xrEndFrame without xrBeginFrame");
    s.isBegun = false;
    ++all.record.ended;
    if (info->type != XR_TYPE_FRAME_END_INFO || info->displayTime != s.predicted)
        return wrong(XR_ERROR_TIME_INVALID, "xrEndFrame: another time than predicted");
    if (info->environmentBlendMode != XR_ENVIRONMENT_BLEND_MODE_OPAQUE)
        return wrong(XR_ERROR_ENVIRONMENT_BLEND_MODE_UNSUPPORTED, "xrEndFrame: the blend mode");
    SubmittedFrame frame;
    frame.number = s.frame;
    frame.seconds = secondsOf(s.predicted);
    const XrResult taken = takeLayers(*info, frame);
    if (all.record.frames.size() >= kMostFrames) all.record.frames.erase(all.record.frames.begin());
    all.record.frames.push_back(std::move(frame));
    goOn(s);
    return taken;
}

XrResult XRAPI_CALL locateViews(XrSession session, const XrViewLocateInfo* info, XrViewState* viewState,
                                std::uint32_t capacity, std::uint32_t* count, XrView* views) {
    State& all = state();
    const std::lock_guard lock(all.mutex);
    if (const XrResult lost = enteredSession("xrLocateViews", session); lost != XR_SUCCESS) return lost;
    const auto base = all.spaces.find(info->space);
    if (base == all.spaces.end()) return wrong(XR_ERROR_HANDLE_INVALID, "xrLocateViews: the space");
    if (info->displayTime < kFirstTime) return wrong(XR_ERROR_TIME_INVALID, "xrLocateViews: the time");
    *count = 2;
    if (capacity == 0) return XR_SUCCESS;
    if (capacity < 2) return XR_ERROR_SIZE_INSUFFICIENT;
    const double seconds = secondsOf(info->displayTime);
    const auto from = placeOf(*base->second, seconds);
    if (!from) return XR_ERROR_RUNTIME_FAILURE;
    for (std::uint32_t eye = 0; eye < 2; ++eye) {
        if (views[eye].type != XR_TYPE_VIEW) return wrong(XR_ERROR_VALIDATION_FAILURE, "xrLocateViews: type");
        const double aside = (eye == 0 ? -0.5 : 0.5) * all.script.eyesApartM;
        const Pose offset{{aside, 0.0, 0.0}, glm::dquat(1.0, 0.0, 0.0, 0.0)};
        const Field& field = all.script.fields[eye];
        views[eye].pose = fromPose(combined(inverse(*from), combined(headAt(seconds), offset)));
        views[eye].fov = {field.left, field.right, field.up, field.down};
    }
    viewState->viewStateFlags = XR_VIEW_STATE_ORIENTATION_VALID_BIT | XR_VIEW_STATE_POSITION_VALID_BIT |
                                XR_VIEW_STATE_ORIENTATION_TRACKED_BIT;
    if (!all.script.isTracked || all.script.isTracked(seconds))
        viewState->viewStateFlags |= XR_VIEW_STATE_POSITION_TRACKED_BIT;
    return XR_SUCCESS;
}

}  // namespace

PFN_xrVoidFunction frameFunction(std::string_view name) {
    if (name == "xrWaitFrame") return reinterpret_cast<PFN_xrVoidFunction>(waitFrame);
    if (name == "xrBeginFrame") return reinterpret_cast<PFN_xrVoidFunction>(beginFrame);
    if (name == "xrEndFrame") return reinterpret_cast<PFN_xrVoidFunction>(endFrame);
    if (name == "xrLocateViews") return reinterpret_cast<PFN_xrVoidFunction>(locateViews);
    return nullptr;
}

}  // namespace macula::xr_script
