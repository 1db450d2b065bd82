/* Archives (PACS): studies in them are found, fetched and sent, by DIMSE or by DICOMweb. docs/pacs.md says
 * how archives are set up. */
#ifndef MACULA_ARCHIVE_H
#define MACULA_ARCHIVE_H

#include <stdint.h>

#include "progress.h"
#include "status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Its calls connect anew each time. One thread at a time uses it: for several fetches at once, open one for
 * each thread. */
typedef struct macula_archive macula_archive;

/* The archives that are set up for this user, as JSON: what `macula pacs list --json` prints. It holds no
 * passwords. Lives until this thread calls it again. */
MACULA_API macula_status macula_archives(const char** json);

/* What proves to an archive who you are. Macula keeps it in memory until the archive is closed, and writes it
 * nowhere. */
typedef struct macula_secrets {
    uint32_t size;
    uint32_t reserved;          /* 0 */
    const char* password;       /* of the user, or of the OAuth 2 client */
    const char* token;          /* bearer */
    const char* key_passphrase; /* of the file `key` */
} macula_secrets;

/* Opens an archive by its name in macula_archives; upper and lower case count only if several names differ in
 * nothing else. `secrets` null: those that the user keeps for it. Connects to nothing yet. */
MACULA_API macula_status macula_archive_open(const char* name, const macula_secrets* secrets,
                                             macula_archive** archive);
/* Opens an archive that is in no list. `json` is one of the "sources" of docs/pacs.md: {"name": "Hospital",
 * "dimse": {"host": "pacs.example.org", "port": 104, "calledAe": "ARCHIVE"}}. Its name is noted beside the
 * studies that are fetched from it. */
MACULA_API macula_status macula_archive_of_json(const char* json, const macula_secrets* secrets,
                                                macula_archive** archive);

/* Tries a connection step by step, up to the first step that fails, as JSON: what `macula pacs test --json`
 * prints, a list of {"name", "passed", "detail", "advice"}. MACULA_DONE also if a step failed. Lives until
 * the next call for this handle. */
MACULA_API macula_status macula_archive_test(macula_archive* archive, const macula_progress* progress,
                                             const char** json);

/* Which studies are searched for: those that all these texts match. Null matches every study. In names, the
 * ID, numbers and the description, * stands for any letters and ? for one. */
typedef struct macula_query {
    uint32_t size;
    uint32_t most_answers;    /* 0: 10000 */
    const char* patient_name; /* components separated by ^ */
    const char* patient_id;
    const char* patient_birth_date; /* YYYYMMDD */
    const char* accession_number;
    const char* study_id;
    const char* study_uid;
    const char* date_from; /* YYYYMMDD, of the study */
    const char* date_to;   /* the same day is part of it */
    const char* modality;  /* one, "CT" */
    const char* description;
    const char* referring_physician;
} macula_query;
/* Searches, as JSON: what `macula find --json` prints. It names patients. {"studies": [{"studyInstanceUid",
 * "patientName", ...}], "isCutShort", "unusable"}: tell your user if it is cut short, because there are more,
 * and how many answers were unusable. `query` may be null. Lives until the next call for this handle. */
MACULA_API macula_status macula_archive_find(macula_archive* archive, const macula_query* query,
                                             const macula_progress* progress, const char** json);
/* The series of a study, as JSON: the list "series" of `macula find --series --json`. Lives until the next
 * call for this handle. */
MACULA_API macula_status macula_archive_series(macula_archive* archive, const char* study_uid,
                                               const macula_progress* progress, const char** json);

/* What is there of the study that is being fetched: `instances` and `bytes` in `folder`, which another thread
 * may open meanwhile with macula_study_open. The text lives for the call. Called while images arrive, some
 * ten times a second at most, and for the last one; from any thread, never two at once, and never while the
 * progress of the fetch is told. A result other than 0 cancels the fetch, and the handle that cancels too if
 * there is one. It must not call Macula, nor throw. */
typedef int32_t (*macula_arrived)(void* user, const char* folder, uint64_t instances, uint64_t bytes);

/* What is fetched, and where to. */
typedef struct macula_fetch {
    uint32_t size;
    uint32_t series_count; /* how many series_uids there are; 0: all series */
    const char* study_uid;
    const char* const* series_uids;
    /* The study gets a folder of its own in this one, which is created if it is missing, and where Macula
     * removes nothing. Null: in the user's private folder of fetched studies, from which the next fetches
     * remove those that were used longest ago (docs/pacs.md). */
    const char* into;
    macula_arrived arrived; /* may be null */
    void* user;             /* for `arrived` */
} macula_fetch;

/* What came. */
typedef struct macula_fetched {
    uint32_t size;
    int32_t is_complete;  /* 0: images that the archive has are missing, or may be; a note says so */
    const char* folder;   /* for macula_study_open. Lives until the next call for this handle */
    uint64_t promised;    /* images that the archive says it has, of what was asked for */
    uint64_t kept;        /* that came */
    uint64_t had_already; /* that were there before */
    uint64_t refused;     /* that came and were not kept: of another study or patient, or unreadable */
    uint64_t never;       /* that are promised and did not come */
    uint64_t bytes;       /* received */
} macula_fetched;
/* Fetches a study, or goes on with one that was fetched in part: only what is missing comes. What came stays
 * after a failure too, and after MACULA_CANCELLED. A fetch that is cancelled when all has come is
 * MACULA_DONE. MACULA_ARCHIVE if the archive has no such study. A second fetch of the same study waits ten
 * seconds for the first to end, and fails then (MACULA_USAGE). */
MACULA_API macula_status macula_archive_fetch(macula_archive* archive, const macula_fetch* fetch,
                                              const macula_progress* progress, macula_fetched* fetched);
/* Sentences on the last study that was fetched: what never came, may be missing, or was refused. Show them
 * with the study. Null if the index is too large. They live until another function than
 * macula_archive_refusal is called for this handle. */
MACULA_API const char* macula_archive_note(const macula_archive* archive, uint32_t index);

/* What became of files that were sent. */
typedef struct macula_sent {
    uint32_t size;
    uint32_t reserved; /* 0 */
    uint64_t files;    /* of DICOM that were there */
    uint64_t stored;   /* by the archive */
    uint64_t refused;  /* all others: see macula_archive_refusal */
} macula_sent;
/* Stores all DICOM files of these files and folders in the archive, as they are. It asks nobody: ask your
 * user first, and name the patients (macula_study_found). MACULA_DONE also if files were refused.
 * MACULA_INPUT if a path holds no file of DICOM, or one that is damaged: then nothing was sent. If it is
 * cancelled, the error says how many files were stored. */
MACULA_API macula_status macula_archive_send(macula_archive* archive, const char* const* paths,
                                             uint32_t path_count, const macula_progress* progress,
                                             macula_sent* sent);
/* A file that the archive did not store. The texts live until another function than macula_archive_note is
 * called for this handle. */
typedef struct macula_refusal {
    uint32_t size;
    uint32_t reserved;  /* 0 */
    const char* file;   /* may name a patient, and belongs in no log */
    const char* why;    /* one sentence, which names no patient */
    const char* advice; /* what to do; may be empty */
} macula_refusal;
/* Fills in a file that was refused when files were sent last. MACULA_USAGE if the index is too large. */
MACULA_API macula_status macula_archive_refusal(const macula_archive* archive, uint32_t index,
                                                macula_refusal* refusal);

/* Closes the archive, and frees its texts. What was fetched stays. */
MACULA_API void macula_archive_close(macula_archive* archive);

#ifdef __cplusplus
}
#endif

#endif
