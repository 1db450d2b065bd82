"""Archives (PACS): studies in them are found, fetched and sent."""

import collections
import ctypes
import json
import os
import pathlib

from . import _interface
from ._calls import PatientWatch, check, library, texts
from ._handle import Handle, bytes_of, whole

_MOST = 2 ** 32 - 1


def archives():
    """The archives that are set up, as a list of dicts without passwords: what `macula pacs list --json` prints."""
    told = ctypes.c_char_p()
    check(library.macula_archives(told))
    return json.loads(told.value)


def _text(text):
    if text is None:
        return None
    if "\0" in text:  # where C would end: it would be another search
        raise ValueError("A text has no 0 in it.")
    return text.encode()


def _day(day):
    return _text(day.strftime("%Y%m%d") if hasattr(day, "strftime") else day)


def _days(date):
    """The first day and the last: of one day, of a pair, or of "FROM-TO"."""
    if isinstance(date, str) and "-" in date:
        date = date.split("-", 1)
    first, last = (date, date) if date is None or isinstance(date, str) or hasattr(date, "strftime") else date
    return _day(first), _day(last)


class Found(list):
    """Studies that match, each a dict of "studyInstanceUid", "patientName" and so on, which names a patient.
    `is_cut_short`: the archive has more than these; `unusable`: how many answers were left out."""

    def __init__(self, told):
        super().__init__(told["studies"])
        self.is_cut_short, self.unusable = told["isCutShort"], told["unusable"]


class Fetched:
    """What came of a study; macula.open(fetched.folder) opens it. `promised` images are said to be there, `kept` came,
    `had_already` were there before, `refused` were of another study or patient, or unreadable, and `never` did not
    come. If it is not `is_complete`, the notes say why: show them with the study."""

    def __init__(self, told, notes):
        self.folder, self.notes = pathlib.Path(os.fsdecode(told.folder)), notes
        self.is_complete, self.promised, self.kept = bool(told.is_complete), told.promised, told.kept
        self.had_already, self.refused, self.never, self.bytes = (told.had_already, told.refused, told.never,
                                                                  told.bytes)

    def __repr__(self):
        return f"<fetched: {self.kept} images came, {self.had_already} were there, of {self.promised}>"


Refusal = collections.namedtuple("Refusal", "file why advice")
Refusal.__doc__ = "A file that an archive did not store. `file` may name a patient, and belongs in no log."


class Sent:
    """What became of files: how many `files` there were, how many the archive `stored`, and the `refusals` of the
    others."""

    def __init__(self, told, refusals):
        self.files, self.stored, self.refusals = told.files, told.stored, refusals

    def __repr__(self):
        return f"<sent: {self.stored} of {self.files} files stored>"


class Archive(Handle):
    """An archive by its name in macula.archives(), or by a dict that describes it as docs/pacs.md does: {"name":
    "Hospital", "dimse": {"host": "pacs.example.org", "port": 104, "calledAe": "ARCHIVE"}}.

    `password`, `token` and `key_passphrase` are used instead of those that are kept for it, and are kept nowhere. It
    connects for each call anew; one thread at a time uses it. Every call can be cancelled: `progress(stage, fraction)`
    does so by returning True, and so does Ctrl-C. Functions that hear of progress are called by other threads."""

    def __init__(self, archive, password=None, token=None, key_passphrase=None):
        given = [_text(secret) for secret in (password, token, key_passphrase)]
        secrets = None
        if any(secret is not None for secret in given):
            secrets = _interface.Secrets(password=given[0], token=given[1], key_passphrase=given[2])
        handle = ctypes.c_void_p()
        if isinstance(archive, str):
            check(library.macula_archive_open(_text(archive), secrets, handle))
        else:
            check(library.macula_archive_of_json(json.dumps(archive).encode(), secrets, handle))
        super().__init__(handle, library.macula_archive_close)

    def _run(self, watch, call):
        """What `call(handle)` returns; that of no other thread comes in between."""
        def alone():
            with self._held(waits=False) as handle:
                return call(handle)

        return watch.run(alone)

    def _answer(self, progress, ask):
        watch, told = PatientWatch(progress), ctypes.c_char_p()

        def asked(handle):
            watch.check(ask(handle, watch.progress, told))
            return json.loads(told.value)

        return self._run(watch, asked)

    def test(self, progress=None):
        """Tries a connection step by step, up to the first that fails: a list of dicts of "name", "passed", "detail"
        and "advice"."""
        return self._answer(progress, library.macula_archive_test)

    def find(self, name=None, patient_id=None, birth_date=None, accession=None, study_id=None, study_uid=None,
             date=None, modality=None, description=None, referring=None, most=0, progress=None):
        """The studies that match all that is given, as Found. * stands for any letters, ? for one: name="DOE^J*". A day
        is a datetime.date or "YYYYMMDD"; `date`, of the study, also a pair of them, of which one may be None, or
        "FROM-TO". `most`: how many studies at most; 0: 10000."""
        first, last = _days(date)
        query = _interface.Query(most_answers=whole(most, _MOST, "most"), patient_name=_text(name),
                                 patient_id=_text(patient_id), patient_birth_date=_day(birth_date),
                                 accession_number=_text(accession), study_id=_text(study_id),
                                 study_uid=_text(study_uid), date_from=first, date_to=last, modality=_text(modality),
                                 description=_text(description), referring_physician=_text(referring))
        return Found(self._answer(progress, lambda handle, watched, told: library.macula_archive_find(
            handle, query, watched, told)))

    def series(self, study_uid, progress=None):
        """The series of a study, as a list of dicts of "seriesInstanceUid", "number", "modality" and so on."""
        uid = _text(study_uid)
        return self._answer(progress, lambda handle, watched, told: library.macula_archive_series(
            handle, uid, watched, told))

    def fetch(self, study_uid, into=None, series=None, progress=None, arrived=None):
        """Fetches a study, or what is missing of it: returns Fetched.

        `into`: a folder of yours, in which the study gets one of its own; without it the private folder of fetched
        studies, from which Macula removes those that were used longest ago. `series`: UIDs of those that are wanted.
        `arrived(folder, images, bytes)` hears what is there of the study, while it comes, and cancels by returning
        True. What came stays when it is cancelled."""
        wanted = _interface.Fetch(study_uid=_text(study_uid), into=bytes_of(into))
        if series is not None:
            uids = [_text(uid) for uid in ([series] if isinstance(series, str) else series)]
            if not uids:
                raise ValueError("No series is named. Leave series out to fetch all of them.")
            wanted.series_uids = (ctypes.c_char_p * len(uids))(*uids)
            wanted.series_count = len(uids)
        watch, told = PatientWatch(progress), _interface.Fetched()
        if arrived is not None:
            wanted.arrived = _interface.Arrived(lambda _user, folder, images, size: watch.ask(
                arrived, lambda: (pathlib.Path(os.fsdecode(folder)), images, size)))

        def fetched(handle):
            watch.check(library.macula_archive_fetch(handle, wanted, watch.progress, told))
            return Fetched(told, texts(library.macula_archive_note, handle))

        return self._run(watch, fetched)

    def send(self, paths, progress=None):
        """Stores all DICOM files of a file, a folder, or a list of them in the archive: returns Sent. It asks nobody:
        ask your user first, and name the patients (macula.open(path).found)."""
        all_paths = [bytes_of(path) for path in
                     ([paths] if isinstance(paths, (str, bytes, os.PathLike)) else paths)]
        given = (ctypes.c_char_p * len(all_paths))(*all_paths)
        watch, told = PatientWatch(progress), _interface.Sent()

        def sent(handle):
            watch.check(library.macula_archive_send(handle, given, len(all_paths), watch.progress, told))
            return Sent(told, [_refusal(handle, index) for index in range(told.refused)])

        return self._run(watch, sent)


def _refusal(handle, index):
    told = _interface.Refusal()
    check(library.macula_archive_refusal(handle, index, told))
    return Refusal(pathlib.Path(os.fsdecode(told.file)), told.why.decode(), told.advice.decode())
