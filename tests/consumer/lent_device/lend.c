/* lend STUDY: shows a study live on a Vulkan device of this program, and has its frames in an image of it. */
#include <macula.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>

#include "host_device.h"

#define WIDTH 96
#define HEIGHT 64

static uint8_t rgba[4 * WIDTH * HEIGHT];

struct queue_lock {
    pthread_mutex_t mutex;
    long uses;
};

static void lock_queue(void* user) {
    struct queue_lock* lock = user;
    pthread_mutex_lock(&lock->mutex);
    ++lock->uses;
}

static void unlock_queue(void* user) {
    struct queue_lock* lock = user;
    pthread_mutex_unlock(&lock->mutex);
}

static int failed(const char* what) {
    macula_error error = {sizeof error};
    macula_last_error(&error);
    fprintf(stderr, "lend: %s: %s %s\n", what, error.message, error.advice);
    return 0;
}

/* Whether the image of the host has what was written to its memory. */
static int is_same(struct host_device* host, struct queue_lock* lock) {
    lock_queue(lock);
    const uint8_t* pixels = host_pixels(host);
    unlock_queue(lock);
    if (!pixels) return 0;
    const int same = memcmp(pixels, rgba, sizeof rgba) == 0;
    host_unmap(host);
    return same;
}

static int show(struct host_device* host, macula_live* live, struct queue_lock* lock) {
    macula_lent_image image = {sizeof image};
    image.image = (uint64_t)host->image;
    image.layout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    macula_frame frame = {sizeof frame};
    frame.width = WIDTH;
    frame.height = HEIGHT;
    frame.rgba = rgba;
    frame.bytes = sizeof rgba;
    frame.image = &image;
    macula_shown shown = {sizeof shown};
    if (macula_live_frame(live, &frame, NULL, &shown)) return failed("the first frame");

    /* A hand turns the patient a little from frame to frame. */
    macula_camera camera = shown.camera;
    frame.camera = &camera;
    for (int i = 0; i < 5; ++i) {
        frame.is_moving = i < 4;
        if (i < 4) camera.position_mm[0] += 20.0;
        if (macula_live_frame(live, &frame, NULL, &shown)) return failed("a frame");
        if (!is_same(host, lock)) {
            fprintf(stderr, "lend: the image has another picture than the memory\n");
            return 0;
        }
    }
    printf("Macula %s on %s, shown as it is: %s\n", macula_version(), shown.device,
           *shown.fidelity ? shown.fidelity : "final");
    long light = 0;
    for (size_t i = 0; i < sizeof rgba; ++i) light += rgba[i] * (i % 4 != 3);
    if (!light) fprintf(stderr, "lend: nothing is seen\n");
    return light > 0;
}

int main(int argc, char** argv) {
    if (argc != 2) {
        fputs("lend STUDY\n", stderr);
        return 2;
    }
    struct host_device host;
    const char* what = "";
    if (!host_open(&host, WIDTH, HEIGHT, &what)) {
        fprintf(stderr, "lend: %s\n", what);
        return 1;
    }
    struct queue_lock lock = {PTHREAD_MUTEX_INITIALIZER, 0};
    macula_lent_device lent = {sizeof lent};
    lent.instance = host.instance;
    lent.physical_device = host.physical;
    lent.device = host.device;
    lent.queue = host.queue;
    lent.queue_family = host.family;
    lent.lock_queue = lock_queue;
    lent.unlock_queue = unlock_queue;
    lent.user = &lock;

    macula_study* study = NULL;
    macula_view* view = NULL;
    macula_device* device = NULL;
    macula_live* live = NULL;
    int done = 0;
    if (macula_study_open(argv[1], NULL, NULL, &study))
        failed("opening");
    else if (macula_view_create(study, &view))
        failed("the view");
    else if (macula_device_lend(&lent, &device))
        failed("lending");
    else if (macula_live_open(device, view, NULL, NULL, &live))
        failed("the live picture");
    else
        done = show(&host, live, &lock);
    macula_live_close(live);
    macula_device_close(device);
    macula_view_close(view);
    macula_study_close(study);
    /* The device is still the host's, and works. */
    done = done && is_same(&host, &lock) && lock.uses > 10;
    host_close(&host);
    return done ? 0 : 1;
}
