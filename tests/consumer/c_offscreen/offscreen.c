/* offscreen STUDY PRESET OUT.ppm: draws a study without a window, with what Macula has to say of it on
 * stderr. */
#include <macula.h>
#include <stdio.h>
#include <stdlib.h>

#define WIDTH 200
#define HEIGHT 160

static int failed(const char* what) {
    macula_error error = {sizeof error};
    macula_last_error(&error);
    fprintf(stderr, "offscreen: %s: %s %s\n", what, error.message, error.advice);
    return 1;
}

static int32_t tell(void* user, const char* stage, double fraction) {
    (void)user;
    fprintf(stderr, "%s %3.0f %%\n", stage, 100.0 * fraction);
    return 0; /* go on */
}

static int write_picture(const char* path, const uint8_t* rgba) {
    FILE* file = fopen(path, "wb");
    if (!file) return 0;
    fprintf(file, "P6\n%d %d\n255\n", WIDTH, HEIGHT);
    for (size_t i = 0; i < (size_t)WIDTH * HEIGHT; ++i) fwrite(rgba + 4 * i, 1, 3, file);
    return fclose(file) == 0;
}

int main(int argc, char** argv) {
    if (argc != 4) {
        fputs("offscreen STUDY PRESET OUT.ppm\n", stderr);
        return 2;
    }
    macula_progress progress = {sizeof progress};
    progress.told = tell;
    macula_study* study;
    if (macula_study_open(argv[1], NULL, &progress, &study)) return failed("opening");
    for (uint32_t i = 0; macula_study_note(study, i); ++i)
        fprintf(stderr, "note: %s\n", macula_study_note(study, i));

    macula_view* view;
    macula_device* device;
    if (macula_view_create(study, &view)) return failed("the view");
    if (macula_view_set_preset(view, argv[2], 0)) return failed("the preset");
    if (macula_device_open(NULL, &device)) return failed("the device");

    uint8_t* rgba = malloc(4 * WIDTH * HEIGHT);
    if (!rgba) return 1;
    macula_picture picture = {sizeof picture};
    picture.width = WIDTH;
    picture.height = HEIGHT;
    picture.samples_per_pixel = 8;
    picture.denoise = MACULA_DENOISED;
    picture.rgba = rgba;
    picture.bytes = 4 * WIDTH * HEIGHT;
    macula_drawn drawn = {sizeof drawn};
    if (macula_draw(device, view, &picture, &progress, &drawn)) return failed("drawing");
    for (uint32_t i = 0; macula_view_note(view, i); ++i)
        fprintf(stderr, "note: %s\n", macula_view_note(view, i));
    printf("Macula %s, %s, preset %s, %.0f samples per pixel\n", macula_version(), drawn.device, drawn.preset,
           drawn.samples_per_pixel);

    const int written = write_picture(argv[3], rgba);
    free(rgba);
    macula_device_close(device);
    macula_view_close(view);
    macula_study_close(study);
    return written && !drawn.is_empty ? 0 : 1;
}
