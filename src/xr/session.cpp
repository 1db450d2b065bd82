#include "xr/session.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "base/check.h"
#include "xr/xr_error.h"

namespace macula::xr {

namespace {

const XrPosef kHere{{0.0f, 0.0f, 0.0f, 1.0f}, {0.0f, 0.0f, 0.0f}};

template <class Event>
Event eventAs(const XrEventDataBuffer& buffer) {
    static_assert(sizeof(Event) <= sizeof(buffer));
    Event event{};
    std::memcpy(&event, &buffer, sizeof(event));
    return event;
}

}  // namespace

XrPosef toXr(const Pose& pose) {
    const glm::quat q(glm::normalize(pose.orientation));
    const glm::vec3 p(pose.positionM);
    return {{q.x, q.y, q.z, q.w}, {p.x, p.y, p.z}};
}

Pose fromXr(const XrPosef& pose) {
    const XrQuaternionf& q = pose.orientation;
    return {{pose.position.x, pose.position.y, pose.position.z}, glm::dquat(q.w, q.x, q.y, q.z)};
}

Result<Session> Session::begin(std::shared_ptr<Runtime> runtime, std::shared_ptr<gpu::Device> device,
                               const SessionOptions& request) {
    Session session(std::move(runtime), std::move(device));
    MACULA_TRY_VOID(session.create());
    session.chooseBlendMode(request);
    MACULA_TRY_VOID(session.makeStage());
    return session;
}

Session::Session(Session&& other) noexcept
    : runtime_(std::move(other.runtime_)),
      device_(std::move(other.device_)),
      session_(std::exchange(other.session_, XR_NULL_HANDLE)),
      stage_(std::exchange(other.stage_, XR_NULL_HANDLE)),
      blend_(other.blend_),
      phase_(other.phase_),
      recentredFrom_(other.recentredFrom_),
      hasNewMasks_(other.hasNewMasks_),
      framesBegun_(other.framesBegun_),
      framesEnded_(other.framesEnded_) {}

Session::~Session() {
    if (!session_) return;
    if (stage_) runtime_->call().DestroySpace(stage_);
    runtime_->call().DestroySession(session_);
}

Result<void> Session::create() {
    XrGraphicsBindingVulkan2KHR binding{XR_TYPE_GRAPHICS_BINDING_VULKAN2_KHR};
    binding.instance = device_->instance();
    binding.physicalDevice = device_->physical();
    binding.device = device_->handle();
    binding.queueFamilyIndex = device_->queueFamily();
    binding.queueIndex = 0;
    XrSessionCreateInfo info{XR_TYPE_SESSION_CREATE_INFO, &binding};
    info.systemId = runtime_->system();
    MACULA_XR_TRY(runtime_->call().CreateSession(runtime_->instance(), &info, &session_),
                  Text("begin a session"));
    return {};
}

// Prefers darkness around the anatomy, unless the request wants the real room visible.
void Session::chooseBlendMode(const SessionOptions& request) {
    const std::vector<XrEnvironmentBlendMode>& modes = runtime_->blendModes();
    const auto choose = [&](XrEnvironmentBlendMode mode) {
        const bool isOffered = std::find(modes.begin(), modes.end(), mode) != modes.end();
        if (isOffered) blend_ = mode;
        return isOffered;
    };
    if (request.showsRoom &&
        (choose(XR_ENVIRONMENT_BLEND_MODE_ALPHA_BLEND) || choose(XR_ENVIRONMENT_BLEND_MODE_ADDITIVE)))
        return;
    if (!choose(XR_ENVIRONMENT_BLEND_MODE_OPAQUE) && !modes.empty()) blend_ = modes.front();
}

// Uses the floor space if the headset knows it, otherwise the place where it was put on.
Result<void> Session::makeStage() {
    std::uint32_t count = 0;
    MACULA_XR_TRY(runtime_->call().EnumerateReferenceSpaces(session_, 0, &count, nullptr),
                  Text("tell which spaces it knows"));
    std::vector<XrReferenceSpaceType> types(count);
    MACULA_XR_TRY(runtime_->call().EnumerateReferenceSpaces(session_, count, &count, types.data()),
                  Text("tell which spaces it knows"));
    const bool hasStage = std::find(types.begin(), types.end(), XR_REFERENCE_SPACE_TYPE_STAGE) != types.end();
    XrReferenceSpaceCreateInfo info{XR_TYPE_REFERENCE_SPACE_CREATE_INFO};
    info.referenceSpaceType = hasStage ? XR_REFERENCE_SPACE_TYPE_STAGE : XR_REFERENCE_SPACE_TYPE_LOCAL;
    info.poseInReferenceSpace = kHere;
    MACULA_XR_TRY(runtime_->call().CreateReferenceSpace(session_, &info, &stage_), Text("find its place"));
    return {};
}

Result<Session::Phase> Session::listen() {
    while (phase_ != Phase::ended) {
        XrEventDataBuffer event{XR_TYPE_EVENT_DATA_BUFFER};
        const XrResult polled = runtime_->call().PollEvent(runtime_->instance(), &event);
        if (polled == XR_EVENT_UNAVAILABLE) break;
        MACULA_XR_TRY(polled, Text("tell what it does"));
        MACULA_TRY_VOID(hear(event));
    }
    return phase_;
}

Result<void> Session::hear(const XrEventDataBuffer& event) {
    switch (event.type) {
        case XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING:
            return xrError(XR_ERROR_INSTANCE_LOST, Text("go on"));
        case XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING: {
            const auto pending = eventAs<XrEventDataReferenceSpaceChangePending>(event);
            if (pending.session == session_)
                recentredFrom_ = std::max(recentredFrom_.value_or(pending.changeTime), pending.changeTime);
            return {};
        }
        case XR_TYPE_EVENT_DATA_VISIBILITY_MASK_CHANGED_KHR:
            if (eventAs<XrEventDataVisibilityMaskChangedKHR>(event).session == session_) hasNewMasks_ = true;
            return {};
        case XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED: {
            const auto changed = eventAs<XrEventDataSessionStateChanged>(event);
            return changed.session == session_ ? changeTo(changed.state) : Result<void>();
        }
        default:
            return {};
    }
}

Result<void> Session::changeTo(XrSessionState state) {
    switch (state) {
        case XR_SESSION_STATE_READY: {
            XrSessionBeginInfo info{XR_TYPE_SESSION_BEGIN_INFO};
            info.primaryViewConfigurationType = runtime_->viewConfiguration();
            MACULA_XR_TRY(runtime_->call().BeginSession(session_, &info), Text("begin to show pictures"));
            phase_ = Phase::running;
            return {};
        }
        case XR_SESSION_STATE_STOPPING:
            phase_ = Phase::waiting;
            MACULA_XR_TRY(runtime_->call().EndSession(session_), Text("stop showing pictures"));
            return {};
        case XR_SESSION_STATE_EXITING:
            phase_ = Phase::ended;
            return {};
        case XR_SESSION_STATE_LOSS_PENDING:
            return xrError(XR_ERROR_SESSION_LOST, Text("go on"));
        default:  // shouldRender says whether frames are visible
            return {};
    }
}

bool Session::wasRecentred(XrTime time) {
    if (!recentredFrom_ || time < *recentredFrom_) return false;
    recentredFrom_.reset();
    return true;
}

bool Session::hasNewMasks() {
    return std::exchange(hasNewMasks_, false);
}

Result<VisibilityMask> Session::maskOf(std::uint32_t view) const {
    if (!runtime_->offer().hasMask) return VisibilityMask();
    const auto ask = [&](XrVisibilityMaskKHR& mask) {
        return runtime_->call().GetVisibilityMaskKHR(session_, runtime_->viewConfiguration(), view,
                                                     XR_VISIBILITY_MASK_TYPE_HIDDEN_TRIANGLE_MESH_KHR, &mask);
    };
    XrVisibilityMaskKHR mask{XR_TYPE_VISIBILITY_MASK_KHR};
    MACULA_XR_TRY(ask(mask), Text("tell what its lenses show"));
    if (mask.vertexCountOutput == 0 || mask.indexCountOutput == 0) return VisibilityMask();
    std::vector<XrVector2f> corners(mask.vertexCountOutput);
    std::vector<std::uint32_t> indices(mask.indexCountOutput);
    mask.vertexCapacityInput = mask.vertexCountOutput;
    mask.vertices = corners.data();
    mask.indexCapacityInput = mask.indexCountOutput;
    mask.indices = indices.data();
    const XrResult filled = ask(mask);
    if (filled == XR_ERROR_SIZE_INSUFFICIENT) return VisibilityMask();  // it is changing; an event follows
    MACULA_XR_TRY(filled, Text("tell what its lenses show"));
    corners.resize(std::min<std::size_t>(corners.size(), mask.vertexCountOutput));
    indices.resize(std::min<std::size_t>(indices.size(), mask.indexCountOutput));
    std::vector<glm::dvec2> places;
    for (const XrVector2f& corner : corners) places.push_back({corner.x, corner.y});
    return VisibilityMask(std::move(places), indices);
}

Result<void> Session::requestEnd() {
    if (phase_ != Phase::running) {
        phase_ = Phase::ended;
        return {};
    }
    MACULA_XR_TRY(runtime_->call().RequestExitSession(session_), Text("end the session"));
    return {};
}

Result<FrameTime> Session::beginFrame() {
    MACULA_CHECK(phase_ == Phase::running);
    const XrFrameWaitInfo wait{XR_TYPE_FRAME_WAIT_INFO};
    XrFrameState state{XR_TYPE_FRAME_STATE};
    MACULA_XR_TRY(runtime_->call().WaitFrame(session_, &wait, &state), Text("tell when it shows a picture"));
    const XrFrameBeginInfo begin{XR_TYPE_FRAME_BEGIN_INFO};
    MACULA_XR_TRY(runtime_->call().BeginFrame(session_, &begin), Text("begin a picture"));
    ++framesBegun_;
    return FrameTime{state.predictedDisplayTime, double(state.predictedDisplayPeriod) * 1e-6,
                     state.shouldRender == XR_TRUE};
}

Result<std::vector<Eye>> Session::eyesAt(XrTime time, bool* isTracked) const {
    XrViewLocateInfo info{XR_TYPE_VIEW_LOCATE_INFO};
    info.viewConfigurationType = runtime_->viewConfiguration();
    info.displayTime = time;
    info.space = stage_;
    XrViewState state{XR_TYPE_VIEW_STATE};
    const std::uint32_t wanted = runtime_->viewCount();
    std::uint32_t count = 0;
    std::vector<XrView> views(wanted, {XR_TYPE_VIEW});
    MACULA_XR_TRY(runtime_->call().LocateViews(session_, &info, &state, wanted, &count, views.data()),
                  Text("tell where the eyes are"));
    constexpr XrViewStateFlags kKnown =
        XR_VIEW_STATE_ORIENTATION_VALID_BIT | XR_VIEW_STATE_POSITION_VALID_BIT;
    if (isTracked) *isTracked = (state.viewStateFlags & XR_VIEW_STATE_POSITION_TRACKED_BIT) != 0;
    std::vector<Eye> eyes;
    if ((state.viewStateFlags & kKnown) != kKnown || count != wanted) return eyes;
    for (const XrView& view : views) {
        if (!isUsable(fromXr(view.pose))) return std::vector<Eye>();
        eyes.push_back({fromXr(view.pose), std::tan(double(view.fov.angleLeft)),
                        std::tan(double(view.fov.angleRight)), std::tan(double(view.fov.angleUp)),
                        std::tan(double(view.fov.angleDown))});
    }
    return eyes;
}

Result<void> Session::endFrame(const FrameTime& time, std::span<const XrCompositionLayerProjectionView> views,
                               std::span<const XrCompositionLayerQuad> quads) {
    XrCompositionLayerProjection layer{XR_TYPE_COMPOSITION_LAYER_PROJECTION};
    layer.space = stage_;
    if (blendsByAlpha()) layer.layerFlags = XR_COMPOSITION_LAYER_BLEND_TEXTURE_SOURCE_ALPHA_BIT;
    layer.viewCount = static_cast<std::uint32_t>(views.size());
    layer.views = views.data();
    std::vector<const XrCompositionLayerBaseHeader*> layers;
    if (!views.empty()) layers.push_back(reinterpret_cast<const XrCompositionLayerBaseHeader*>(&layer));
    for (const XrCompositionLayerQuad& quad : quads)
        layers.push_back(reinterpret_cast<const XrCompositionLayerBaseHeader*>(&quad));
    XrFrameEndInfo info{XR_TYPE_FRAME_END_INFO};
    info.displayTime = time.displayed;
    info.environmentBlendMode = blend_;
    info.layerCount = static_cast<std::uint32_t>(layers.size());
    info.layers = layers.data();
    MACULA_XR_TRY(runtime_->call().EndFrame(session_, &info), Text("show a picture"));
    ++framesEnded_;
    return {};
}

Result<std::optional<Pose>> Session::locate(XrSpace space, XrTime time) const {
    XrSpaceLocation location{XR_TYPE_SPACE_LOCATION};
    MACULA_XR_TRY(runtime_->call().LocateSpace(space, stage_, time, &location), Text("tell where hands are"));
    constexpr XrSpaceLocationFlags kKnown =
        XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT;
    if ((location.locationFlags & kKnown) != kKnown) return std::optional<Pose>();
    const Pose pose = fromXr(location.pose);
    return isUsable(pose) ? std::optional(pose) : std::nullopt;
}

}  // namespace macula::xr
