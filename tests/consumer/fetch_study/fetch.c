/* fetch ARCHIVE [STUDY_UID FOLDER]: prints what an archive holds; or fetches a study into a folder, and opens
 * it. ARCHIVE is the name of one that is set up, or describes one in JSON (docs/pacs.md). */
#include <inttypes.h>
#include <macula.h>
#include <stdio.h>

static int failed(const char* what) {
    macula_error error = {sizeof error};
    macula_last_error(&error);
    fprintf(stderr, "fetch: %s: %s %s\n", what, error.message, error.advice);
    return 1;
}

static int32_t arrived(void* user, const char* folder, uint64_t instances, uint64_t bytes) {
    (void)user;
    (void)folder;
    fprintf(stderr, "%" PRIu64 " images, %" PRIu64 " kB\n", instances, bytes / 1000);
    return 0; /* go on */
}

static int list(macula_archive* archive) {
    const char* studies;
    if (macula_archive_find(archive, NULL, NULL, &studies)) return failed("searching");
    puts(studies);
    return 0;
}

static int fetch(macula_archive* archive, const char* study_uid, const char* folder) {
    macula_fetch wanted = {sizeof wanted};
    wanted.study_uid = study_uid;
    wanted.into = folder;
    wanted.arrived = arrived;
    macula_fetched fetched = {sizeof fetched};
    if (macula_archive_fetch(archive, &wanted, NULL, &fetched)) return failed("fetching");
    for (uint32_t i = 0; macula_archive_note(archive, i); ++i)
        fprintf(stderr, "note: %s\n", macula_archive_note(archive, i));

    macula_study* study;
    macula_volume volume = {sizeof volume};
    if (macula_study_open(fetched.folder, NULL, NULL, &study)) return failed("opening");
    for (uint32_t i = 0; macula_study_note(study, i); ++i)
        fprintf(stderr, "note: %s\n", macula_study_note(study, i));
    const int status = macula_study_volume(study, &volume) ? failed("the volume") : 0;
    if (!status)
        printf("%" PRIu64 " of %" PRIu64 " images came; %d x %d x %d voxels\n", fetched.kept,
               fetched.promised, volume.columns, volume.rows, volume.slices);
    macula_study_close(study);
    return fetched.is_complete ? status : 1;
}

int main(int argc, char** argv) {
    if (argc != 2 && argc != 4) {
        fputs("fetch ARCHIVE [STUDY_UID FOLDER]\n", stderr);
        return 2;
    }
    macula_archive* archive;
    const int is_json = argv[1][0] == '{';
    if (is_json ? macula_archive_of_json(argv[1], NULL, &archive)
                : macula_archive_open(argv[1], NULL, &archive))
        return failed("the archive");
    const int status = argc == 2 ? list(archive) : fetch(archive, argv[2], argv[3]);
    macula_archive_close(archive);
    return status;
}
