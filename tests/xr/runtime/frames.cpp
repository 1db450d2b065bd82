// Frames: waited for, begun and ended in this order, with one layer for the eyes at most; and where the eyes
// are.
#include <algorithm>
#include <cmath>
#include <thread>

#include "xr/runtime/state.h"

namespace macula::xr_script {

namespace {

using Clock = std::chrono::steady_clock;

// Of a paced headset: how many times it has shown something since its first frame.
std::uint64_t timesShown(const SessionState& s, std::chrono::nanoseconds period) {
    return std::uint64_t((Clock::now() - *s.begunAt) / period);
}

// A frame that is begun at one time is shown at the next, or at the first after it was drawn. Waits for the
// next time for which a frame can be begun, and counts those that passed without one.
void waitForTime(std::unique_lock<std::recursive_mutex>& lock, std::chrono::nanoseconds period) {
    State& all = state();
    SessionState& s = *all.session;
    if (!s.begunAt) {
        s.begunAt = Clock::now();
        s.slot = 0;
        return;
    }
    const std::uint64_t now = timesShown(s, period);
    const std::uint64_t next = std::max({s.slot + 1, s.shownAt, now});
    all.record.missed += next - s.slot - 1;
    s.slot = next;
    const Clock::time_point until = *s.begunAt + period * std::int64_t(next);
    lock.unlock();
    std::this_thread::sleep_until(until);
    lock.lock();
}

XrResult XRAPI_CALL waitFrame(XrSession session, const XrFrameWaitInfo*, XrFrameState* frame) {
    State& all = state();
    std::unique_lock lock(all.mutex);
    if (const XrResult lost = enteredSession("xrWaitFrame", session); lost != XR_SUCCESS) return lost;
    SessionState& s = *all.session;
    if (!s.isRunning) return wrong(XR_ERROR_SESSION_NOT_RUNNING, "xrWaitFrame: the session does not run");
    // A real one would block for ever.
    if (s.isWaited) return wrong(XR_ERROR_CALL_ORDER_INVALID, "xrWaitFrame: the frame before was not begun");
    const auto period = XrDuration(1e9 / all.script.framesPerS);
    s.isWaited = true;
    s.located = 0;
    if (all.script.isPaced) waitForTime(lock, std::chrono::nanoseconds(period));
    const std::uint64_t slot = all.script.isPaced ? s.slot : all.record.waited;
    s.predicted = kFirstTime + XrTime(slot) * period;
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

// The swapchain that a view shows a part of; null, and `result` says why, where it shows none.
const SwapchainState* swapchainOf(const XrSwapchainSubImage& part, XrResult& result) {
    State& all = state();
    const auto found = all.swapchains.find(part.swapchain);
    if (found == all.swapchains.end()) {
        result = wrong(XR_ERROR_HANDLE_INVALID, "xrEndFrame: the swapchain of a view");
        return nullptr;
    }
    const SwapchainState& swapchain = *found->second;
    const XrRect2Di& rect = part.imageRect;
    if (!swapchain.released || !swapchain.acquired.empty()) {
        result = wrong(XR_ERROR_LAYER_INVALID, "xrEndFrame: the image of a view was not released");
        return nullptr;
    }
    if (rect.offset.x < 0 || rect.offset.y < 0 || rect.extent.width <= 0 || rect.extent.height <= 0 ||
        std::uint32_t(rect.offset.x + rect.extent.width) > swapchain.info.width ||
        std::uint32_t(rect.offset.y + rect.extent.height) > swapchain.info.height ||
        part.imageArrayIndex >= swapchain.info.arraySize) {
        result = wrong(XR_ERROR_SWAPCHAIN_RECT_INVALID, "xrEndFrame: a view lies beside its image");
        return nullptr;
    }
    return &swapchain;
}

XrResult takeDepth(const XrCompositionLayerDepthInfoKHR& info, SubmittedView& view) {
    State& all = state();
    if (!all.extensions.contains(XR_KHR_COMPOSITION_LAYER_DEPTH_EXTENSION_NAME))
        return wrong(XR_ERROR_LAYER_INVALID, "xrEndFrame: depths without their extension");
    XrResult result = XR_SUCCESS;
    const SwapchainState* swapchain = swapchainOf(info.subImage, result);
    if (!swapchain) return result;
    const XrExtent2Di& extent = info.subImage.imageRect.extent;
    if (!isDepth(*swapchain)) return wrong(XR_ERROR_LAYER_INVALID, "xrEndFrame: depths that are colours");
    if (extent.width != view.sizePx.x || extent.height != view.sizePx.y)
        return wrong(XR_ERROR_LAYER_INVALID, "xrEndFrame: depths of another size than the picture");
    if (!(info.minDepth >= 0.0f && info.minDepth < info.maxDepth && info.maxDepth <= 1.0f))
        return wrong(XR_ERROR_VALIDATION_FAILURE, "xrEndFrame: the range of depths");
    if (!(info.nearZ > 0.0f && info.farZ > 0.0f && info.nearZ != info.farZ))
        return wrong(XR_ERROR_VALIDATION_FAILURE, "xrEndFrame: near and far");
    SubmittedDepth depth;
    depth.sizePx = {extent.width, extent.height};
    depth.minDepth = info.minDepth;
    depth.maxDepth = info.maxDepth;
    depth.nearM = info.nearZ;
    depth.farM = info.farZ;
    if (all.script.keepsPictures)
        depth.depths = readDepths(*swapchain, info.subImage.imageArrayIndex, info.subImage.imageRect);
    view.depth = std::move(depth);
    return XR_SUCCESS;
}

XrResult takeView(const XrCompositionLayerProjectionView& view, SubmittedFrame& frame) {
    State& all = state();
    if (view.type != XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW)
        return wrong(XR_ERROR_LAYER_INVALID, "xrEndFrame: the structure of a view");
    XrResult result = XR_SUCCESS;
    const SwapchainState* swapchain = swapchainOf(view.subImage, result);
    if (!swapchain) return result;
    if (isDepth(*swapchain)) return wrong(XR_ERROR_LAYER_INVALID, "xrEndFrame: a picture of depths");
    const XrRect2Di& rect = view.subImage.imageRect;
    const Pose pose = toPose(view.pose);
    if (!(std::abs(glm::length(pose.orientation) - 1.0) < 0.01))
        return wrong(XR_ERROR_POSE_INVALID, "xrEndFrame: the pose of a view");
    const XrFovf& fov = view.fov;
    if (!(fov.angleLeft < fov.angleRight && fov.angleDown < fov.angleUp))
        return wrong(XR_ERROR_LAYER_INVALID, "xrEndFrame: the field of a view is mirrored");
    SubmittedView taken;
    taken.pose = pose;
    taken.field = {fov.angleLeft, fov.angleRight, fov.angleUp, fov.angleDown};
    taken.sizePx = {rect.extent.width, rect.extent.height};
    if (all.script.keepsPictures) taken.rgba = readImage(*swapchain, view.subImage.imageArrayIndex, rect);
    for (const auto* next = static_cast<const XrBaseInStructure*>(view.next); next; next = next->next) {
        if (next->type != XR_TYPE_COMPOSITION_LAYER_DEPTH_INFO_KHR)
            return wrong(XR_ERROR_LAYER_INVALID, "xrEndFrame: what is chained to a view");
        result = takeDepth(*reinterpret_cast<const XrCompositionLayerDepthInfoKHR*>(next), taken);
        if (result != XR_SUCCESS) return result;
    }
    frame.views.push_back(std::move(taken));
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
        if (!layer || layer->type != XR_TYPE_COMPOSITION_LAYER_PROJECTION || layer->viewCount != viewCount())
            return wrong(XR_ERROR_LAYER_INVALID, "xrEndFrame: no projection layer of all views");
        if (!state().spaces.contains(layer->space))
            return wrong(XR_ERROR_HANDLE_INVALID, "xrEndFrame: the space of the layer");
        frame.usesAlpha = (layer->layerFlags & XR_COMPOSITION_LAYER_BLEND_TEXTURE_SOURCE_ALPHA_BIT) != 0;
        if (layer->layerFlags & XR_COMPOSITION_LAYER_UNPREMULTIPLIED_ALPHA_BIT)
            return wrong(XR_ERROR_LAYER_INVALID, "xrEndFrame: colours that are not premultiplied");
        for (std::uint32_t view = 0; view < viewCount(); ++view)
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
    const std::vector<int>& modes = all.script.blendModes;
    if (std::find(modes.begin(), modes.end(), int(info->environmentBlendMode)) == modes.end())
        return wrong(XR_ERROR_ENVIRONMENT_BLEND_MODE_UNSUPPORTED, "xrEndFrame: the blend mode");
    SubmittedFrame frame;
    frame.number = s.frame;
    frame.seconds = secondsOf(s.predicted);
    frame.blendMode = int(info->environmentBlendMode);
    const XrResult taken = takeLayers(*info, frame);
    if (all.script.isPaced) {
        waitForDevice();  // a picture that is not drawn yet is not shown
        s.shownAt = timesShown(s, std::chrono::nanoseconds(XrDuration(1e9 / all.script.framesPerS))) + 1;
    }
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
    if (info->viewConfigurationType != viewConfiguration())
        return wrong(XR_ERROR_VIEW_CONFIGURATION_TYPE_UNSUPPORTED, "xrLocateViews: the views");
    *count = viewCount();
    if (capacity == 0) return XR_SUCCESS;
    if (capacity < *count) return XR_ERROR_SIZE_INSUFFICIENT;
    const double seconds = secondsOf(info->displayTime);
    const auto from = placeOf(*base->second, seconds);
    if (!from) return XR_ERROR_RUNTIME_FAILURE;
    const auto& foreseen = all.script.foreseenAsideM;
    const Pose off{{foreseen ? foreseen(all.session->located) : 0.0, 0.0, 0.0},
                   glm::dquat(1.0, 0.0, 0.0, 0.0)};
    ++all.session->located;
    const Pose head = combined(headAt(seconds), off);
    for (std::uint32_t eye = 0; eye < *count; ++eye) {
        if (views[eye].type != XR_TYPE_VIEW) return wrong(XR_ERROR_VALIDATION_FAILURE, "xrLocateViews: type");
        const double aside = (eye % 2 == 0 ? -0.5 : 0.5) * all.script.eyesApartM;
        const Pose offset{{aside, 0.0, 0.0}, glm::dquat(1.0, 0.0, 0.0, 0.0)};
        const Field& field = eye < 2 ? all.script.fields[eye] : all.script.insetFields[eye - 2];
        views[eye].pose = fromPose(combined(inverse(*from), combined(head, offset)));
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
