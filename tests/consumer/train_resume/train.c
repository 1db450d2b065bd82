/* train STUDY FOLDER STEPS [resumed]: teaches the model of a study, keeps it in a folder, and goes on with it
 * the next time; with "resumed" it fails if there was nothing to go on with. */
#include <macula.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failed(const char* what) {
    macula_error error = {sizeof error};
    macula_last_error(&error);
    fprintf(stderr, "train: %s: %s %s\n", what, error.message, error.advice);
    return 0;
}

static int32_t tell(void* user, const char* stage, double fraction) {
    (void)user;
    fprintf(stderr, "%s %3.0f %%\n", stage, 100.0 * fraction);
    return 0; /* go on */
}

static int train(macula_live* live, uint64_t steps, int must_resume) {
    macula_progress progress = {sizeof progress};
    progress.told = tell;
    macula_training training = {sizeof training};
    training.steps = steps;
    macula_model model = {sizeof model};
    if (macula_live_train(live, &training, &progress, &model)) return failed("training");
    printf("%s: %u splats after %llu steps, %s\n", model.stage_name, (unsigned)model.splats,
           (unsigned long long)model.steps, model.origin);
    if (must_resume && !model.is_resumed) {
        fprintf(stderr, "train: there was nothing to resume\n");
        return 0;
    }
    if (macula_live_save(live, &progress)) return failed("saving");
    return model.steps > 0 && model.splats > 0;
}

int main(int argc, char** argv) {
    if (argc < 4) {
        fputs("train STUDY FOLDER STEPS [resumed]\n", stderr);
        return 2;
    }
    macula_live_options options = {sizeof options};
    options.store = argv[2];
    macula_study* study = NULL;
    macula_view* view = NULL;
    macula_device* device = NULL;
    macula_live* live = NULL;
    int done = 0;
    if (macula_study_open(argv[1], NULL, NULL, &study))
        failed("opening");
    else if (macula_view_create(study, &view))
        failed("the view");
    else if (macula_device_open(NULL, &device))
        failed("the device");
    else if (macula_live_open(device, view, &options, NULL, &live))
        failed("the live picture");
    else
        done = train(live, strtoull(argv[3], NULL, 10), argc > 4 && strcmp(argv[4], "resumed") == 0);
    macula_live_close(live);
    macula_device_close(device);
    macula_view_close(view);
    macula_study_close(study);
    return done ? 0 : 1;
}
