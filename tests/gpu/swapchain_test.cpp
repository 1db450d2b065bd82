#include "pipeline/gpu/swapchain.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vulkan/vulkan.h>
#include <xcb/xcb.h>
// Needs the types of xcb.
#include <vulkan/vulkan_xcb.h>

#include "gpu/gpu_test.h"
#include "gpu/lose_device.h"
#include "pipeline/gpu/recorder.h"

namespace macula::gpu {
namespace {

// An X server without a display, of our own: tests run the same with and without a desktop.
class VirtualDisplay {
  public:
    VirtualDisplay() {
        int pipeEnds[2];
        if (pipe(pipeEnds) != 0) return;
        process_ = fork();
        if (process_ == 0) {
            close(pipeEnds[0]);
            const std::string descriptor = std::to_string(pipeEnds[1]);
            execl(MACULA_XVFB, MACULA_XVFB, "-displayfd", descriptor.c_str(), "-screen", "0", "400x300x24",
                  "-nolisten", "tcp", nullptr);
            _exit(127);
        }
        close(pipeEnds[1]);
        char buffer[16] = {};
        for (std::size_t used = 0; used + 1 < sizeof(buffer) && name_.empty();) {
            const ssize_t got = ::read(pipeEnds[0], buffer + used, sizeof(buffer) - 1 - used);
            if (got <= 0) break;
            used += static_cast<std::size_t>(got);
            if (const char* end = std::strchr(buffer, '\n'))
                name_ = ":" + std::string(static_cast<const char*>(buffer), end);
        }
        close(pipeEnds[0]);
    }
    VirtualDisplay(const VirtualDisplay&) = delete;
    VirtualDisplay& operator=(const VirtualDisplay&) = delete;
    ~VirtualDisplay() {
        if (process_ <= 0) return;
        kill(process_, SIGTERM);
        waitpid(process_, nullptr, 0);
    }

    const std::string& name() const { return name_; }  // empty if it did not start

  private:
    pid_t process_ = -1;
    std::string name_;
};

class SwapchainTest : public ::testing::Test {
  protected:
    void SetUp() override {
        if (display_.name().empty()) GTEST_SKIP() << "Xvfb does not start";
        connection_ = xcb_connect(display_.name().c_str(), nullptr);
        ASSERT_EQ(xcb_connection_has_error(connection_), 0);
        const xcb_screen_t* screen = xcb_setup_roots_iterator(xcb_get_setup(connection_)).data;
        window_ = xcb_generate_id(connection_);
        xcb_create_window(connection_, XCB_COPY_FROM_PARENT, window_, screen->root, 0, 0, 200, 100, 0,
                          XCB_WINDOW_CLASS_INPUT_OUTPUT, screen->root_visual, 0, nullptr);
        xcb_map_window(connection_, window_);
        roundTrip();

        instance_ = expectOk(Instance::create(
            {.extensions = {"VK_KHR_surface", "VK_KHR_xcb_surface"}, .validation = validationOfTests()}));
        VkXcbSurfaceCreateInfoKHR info{VK_STRUCTURE_TYPE_XCB_SURFACE_CREATE_INFO_KHR};
        info.connection = connection_;
        info.window = window_;
        ASSERT_EQ(vkCreateXcbSurfaceKHR(instance_->handle(), &info, nullptr, &surface_), VK_SUCCESS);
        device_ = expectOk(Device::create(*instance_, {.extensions = {VK_KHR_SWAPCHAIN_EXTENSION_NAME}}));
    }

    void TearDown() override {
        device_.reset();
        if (surface_) vkDestroySurfaceKHR(instance_->handle(), surface_, nullptr);
        if (instance_)
            for (const std::string& message : instance_->validationMessages()) ADD_FAILURE() << message;
        if (connection_) xcb_disconnect(connection_);
    }

    void roundTrip() {
        free(xcb_get_input_focus_reply(connection_, xcb_get_input_focus(connection_), nullptr));
    }

    void resizeWindow(std::uint32_t width, std::uint32_t height) {
        const std::uint32_t values[] = {width, height};
        xcb_configure_window(connection_, window_, XCB_CONFIG_WINDOW_WIDTH | XCB_CONFIG_WINDOW_HEIGHT,
                             values);
        roundTrip();
    }

    // Presents one frame of `image`, resizing as often as the swapchain asks.
    void show(Swapchain& swapchain, const Image& image) {
        for (int attempt = 0; attempt < 5; ++attempt) {
            const auto frame = expectOk(swapchain.acquire(5'000'000'000));
            if (frame.status == Swapchain::Status::outOfDate) {
                expectOk(swapchain.resize({1, 1}));
                continue;
            }
            ASSERT_TRUE(frame.usable()) << int(frame.status);
            auto recorder = expectOk(Recorder::create(device_, "present"));
            recorder.blit(image, frame.target());
            const Ticket ticket =
                expectOk(recorder.submit({.wait = frame.available, .signal = frame.rendered}));
            if (expectOk(swapchain.present(frame, ticket)) == Swapchain::Status::ready) return;
            expectOk(swapchain.resize({1, 1}));
        }
        FAIL() << "nothing could be presented";
    }

    // 0xRRGGBB of a pixel of the window.
    std::uint32_t pixelAt(std::int16_t x, std::int16_t y) {
        xcb_get_image_reply_t* reply = xcb_get_image_reply(
            connection_, xcb_get_image(connection_, XCB_IMAGE_FORMAT_Z_PIXMAP, window_, x, y, 1, 1, ~0u),
            nullptr);
        if (!reply) return 0xdeadbeef;
        std::uint32_t pixel = 0;
        std::memcpy(&pixel, xcb_get_image_data(reply), sizeof(pixel));
        free(reply);
        return pixel & 0xffffffu;
    }

    void expectColour(std::int16_t x, std::int16_t y, std::uint32_t wanted) {
        std::uint32_t seen = 0;
        for (int attempt = 0; attempt < 200 && seen != wanted; ++attempt) {  // presentation is asynchronous
            seen = pixelAt(x, y);
            if (seen != wanted) usleep(10'000);
        }
        EXPECT_EQ(seen, wanted) << fmt::format("{:06x} against {:06x} at {}, {}", seen, wanted, x, y);
    }

    VirtualDisplay display_;
    xcb_connection_t* connection_ = nullptr;
    xcb_window_t window_ = 0;
    std::optional<Instance> instance_;
    VkSurfaceKHR surface_ = VK_NULL_HANDLE;
    std::shared_ptr<Device> device_;
};

TEST_F(SwapchainTest, ShowsColoursAndFollowsTheWindow) {
    const Image image = expectOk(Image::create(
        device_, {.label = "frame", .width = 40, .height = 20, .format = VK_FORMAT_R8G8B8A8_UNORM}));
    auto recorder = expectOk(Recorder::create(device_, "colour"));
    recorder.clear(image, {{1.0f, 0.4f, 0.2f, 1.0f}});
    expectOk(recorder.submit());

    for (const PresentMode mode : {PresentMode::fifo, PresentMode::mailbox}) {
        resizeWindow(200, 100);
        auto swapchain = expectOk(Swapchain::create(device_, surface_, {.extent = {200, 100}, .mode = mode}));
        EXPECT_EQ(swapchain.extent().width, 200u);
        for (int frame = 0; frame < 8; ++frame) show(swapchain, image);
        expectColour(0, 0, 0xff6633);
        expectColour(199, 99, 0xff6633);

        resizeWindow(300, 150);
        for (int frame = 0; frame < 8; ++frame) show(swapchain, image);
        EXPECT_EQ(swapchain.extent().width, 300u);
        expectColour(299, 149, 0xff6633);
    }
}

TEST_F(SwapchainTest, ImagesThatWereNeverPresentedComeBack) {
    const Image image = expectOk(Image::create(
        device_, {.label = "frame", .width = 40, .height = 20, .format = VK_FORMAT_R8G8B8A8_UNORM}));
    auto recorder = expectOk(Recorder::create(device_, "colour"));
    recorder.clear(image, {{1.0f, 0.4f, 0.2f, 1.0f}});
    expectOk(recorder.submit());
    auto swapchain = expectOk(Swapchain::create(device_, surface_, {.extent = {200, 100}}));
    for (int i = 0; i < 6; ++i) {
        ASSERT_TRUE(expectOk(swapchain.acquire(5'000'000'000)).usable()) << i;
        ASSERT_EQ(expectOk(swapchain.acquire(5'000'000'000)).status, Swapchain::Status::outOfDate) << i;
        expectOk(swapchain.resize({200, 100}));
    }
    show(swapchain, image);
    expectColour(0, 0, 0xff6633);
}

TEST_F(SwapchainTest, IsNotHiddenByAResizeThatFailed) {
    const Image image = expectOk(Image::create(
        device_, {.label = "frame", .width = 40, .height = 20, .format = VK_FORMAT_R8G8B8A8_UNORM}));
    auto recorder = expectOk(Recorder::create(device_, "colour"));
    recorder.clear(image, {{1.0f, 0.4f, 0.2f, 1.0f}});
    expectOk(recorder.submit());
    auto swapchain = expectOk(Swapchain::create(device_, surface_, {.extent = {200, 100}}));
    test::answerFalsely({.call = test::VulkanCall::swapchain, .result = VK_ERROR_OUT_OF_DEVICE_MEMORY});
    EXPECT_EQ(swapchain.resize({200, 100}).error().code, ErrorCode::outOfMemory);
    EXPECT_EQ(expectOk(swapchain.acquire(5'000'000'000)).status, Swapchain::Status::outOfDate);
    show(swapchain, image);
    expectColour(0, 0, 0xff6633);
}

}  // namespace
}  // namespace macula::gpu
