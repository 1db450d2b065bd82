/* share STUDY: shows a study live on Macula's own device, and has its frames in an image of a Vulkan device
 * of this program, on the same card. */
#define _POSIX_C_SOURCE 200809L
#include <macula.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "host_device.h"
#include "host_share.h"

#define WIDTH 96
#define HEIGHT 64

static uint8_t rgba[4 * WIDTH * HEIGHT];

static int failed(const char* what) {
    macula_error error = {sizeof error};
    macula_last_error(&error);
    fprintf(stderr, "share: %s: %s %s\n", what, error.message, error.advice);
    return 0;
}

static int missing(const char* what) {
    fprintf(stderr, "share: %s\n", what);
    return 0;
}

/* Two semaphores where the device can share them, else none: then each call returns with the picture. */
struct turns {
    VkSemaphore free; /* the image may be written */
    VkSemaphore full; /* it is written */
};

static int share_image(struct host_device* host, const macula_device_identity* card, struct turns* turns,
                       macula_shared_image** image) {
    struct host_share made = {VK_FORMAT_R8G8B8A8_UNORM, VK_IMAGE_TILING_OPTIMAL, 0, 1, 0, 0, 0};
    made.usage = VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    if (!host_share_image(host, &made)) return missing("no image that can be shared");
    macula_shared_memory memory = {sizeof memory};
    memory.memory_fd = host_memory_fd(host);
    memcpy(memory.device_uuid, card->device_uuid, sizeof memory.device_uuid);
    memcpy(memory.driver_uuid, card->driver_uuid, sizeof memory.driver_uuid);
    memory.bytes = made.bytes;
    memory.offset = made.offset;
    memory.memory_type = made.memory_type;
    memory.is_dedicated = made.is_dedicated;
    memory.width = WIDTH;
    memory.height = HEIGHT;
    memory.format = made.format;
    memory.tiling = made.tiling;
    memory.usage = made.usage;
    memory.layout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    if (host->has_semaphores) {
        if (!host_make_semaphore(host, &turns->free) || !host_make_semaphore(host, &turns->full))
            return missing("no semaphores");
        memory.wait_fd = host_semaphore_fd(host, turns->free);
        memory.signal_fd = host_semaphore_fd(host, turns->full);
        if (memory.wait_fd <= 0 || memory.signal_fd <= 0) return missing("no semaphores to give away");
    }
    const macula_status status = macula_shared_image_create(&memory, image);
    if (memory.memory_fd >= 0) close(memory.memory_fd);
    if (memory.wait_fd > 0) close(memory.wait_fd);
    if (memory.signal_fd > 0) close(memory.signal_fd);
    return status ? failed("sharing") : 1;
}

/* A frame, and whether the image of this program has what was written to its memory. */
static int draw(struct host_device* host, const struct turns* turns, macula_live* live,
                const macula_frame* frame, macula_shown* shown) {
    if (turns->free && !host_submit(host, VK_NULL_HANDLE, turns->free))
        return missing("the turn is not given");
    if (macula_live_frame(live, frame, NULL, shown)) return failed("a frame");
    if (turns->full && !host_submit(host, turns->full, VK_NULL_HANDLE))
        return missing("the turn is not taken");
    const uint8_t* pixels = host_pixels(host);
    if (!pixels) return missing("the image cannot be read");
    const int same = memcmp(pixels, rgba, sizeof rgba) == 0;
    host_unmap(host);
    return same ? 1 : missing("the image has another picture than the memory");
}

static int show(struct host_device* host, const struct turns* turns, macula_live* live,
                const macula_shared_image* image) {
    macula_frame frame = {sizeof frame};
    frame.width = WIDTH;
    frame.height = HEIGHT;
    frame.rgba = rgba;
    frame.bytes = sizeof rgba;
    frame.shared = image;
    macula_shown shown = {sizeof shown};
    if (!draw(host, turns, live, &frame, &shown)) return 0;

    /* A hand turns the patient a little from frame to frame. */
    macula_camera camera = shown.camera;
    frame.camera = &camera;
    for (int i = 0; i < 5; ++i) {
        frame.is_moving = i < 4;
        if (i < 4) camera.position_mm[0] += 20.0;
        if (!draw(host, turns, live, &frame, &shown)) return 0;
    }
    printf("Macula %s on %s, shared %s semaphores: %s\n", macula_version(), shown.device,
           turns->free ? "with" : "without", *shown.fidelity ? shown.fidelity : "final");
    long light = 0;
    for (size_t i = 0; i < sizeof rgba; ++i) light += rgba[i] * (i % 4 != 3);
    return light > 0 ? 1 : missing("nothing is seen");
}

static int share(macula_device* device, const macula_view* view) {
    macula_device_identity card = {sizeof card};
    if (macula_device_identify(device, &card)) return failed("the card");
    struct host_device host;
    struct turns turns = {VK_NULL_HANDLE, VK_NULL_HANDLE};
    macula_shared_image* image = NULL;
    macula_live* live = NULL;
    const char* what = "";
    int done = 0;
    if (!host_open_on(&host, WIDTH, HEIGHT, card.device_uuid, card.driver_uuid, &what))
        missing(what);
    else if (macula_live_open(device, view, NULL, NULL, &live))
        failed("the live picture");
    else
        done = share_image(&host, &card, &turns, &image) && show(&host, &turns, live, image);
    macula_live_close(live);
    macula_shared_image_close(image);
    if (turns.free) vkDestroySemaphore(host.device, turns.free, NULL);
    if (turns.full) vkDestroySemaphore(host.device, turns.full, NULL);
    host_close(&host);
    return done;
}

int main(int argc, char** argv) {
    if (argc != 2) {
        fputs("share STUDY\n", stderr);
        return 2;
    }
    macula_study* study = NULL;
    macula_view* view = NULL;
    macula_device* device = NULL;
    int done = 0;
    if (macula_study_open(argv[1], NULL, NULL, &study))
        failed("opening");
    else if (macula_view_create(study, &view))
        failed("the view");
    else if (macula_device_open(NULL, &device))
        failed("the device");
    else
        done = share(device, view);
    macula_device_close(device);
    macula_view_close(view);
    macula_study_close(study);
    return done ? 0 : 1;
}
