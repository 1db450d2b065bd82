"""Archives from Python. archives_test.cpp starts them, and says in MACULA_TEST_ARCHIVES where they are."""

import datetime
import json
import os
import pathlib
import pickle
import signal
import socket
import tempfile
import threading
import time
import unittest

import macula

HERE = json.loads(os.environ["MACULA_TEST_ARCHIVES"])
UID, IMAGES = HERE["uid"], HERE["images"]
DATA = pathlib.Path(os.environ["XDG_DATA_HOME"]) / "macula"
ARCHIVE_STATUS, CANCELLED_STATUS = 8, 5


def archive(way="dcmqrscp", **secrets):
    return macula.Archive(HERE["archives"][way], **secrets)


def setUpModule():
    for way in ("dcmqrscp", "orthanc"):
        with archive(way) as to:
            sent = to.send(HERE["study"])
            assert (sent.files, sent.stored, sent.refusals) == (IMAGES, IMAGES, []), sent


class WithFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def images(self):
        """Those that lie in the folder of the study."""
        return [file for file in self.folder.glob("*/*.dcm") if file.parent.name != "arriving"]


class Fetches(WithFolder):
    def test_what_is_found_is_fetched_and_opened(self):
        for way in ("dcmqrscp", "orthanc", "web"):
            with self.subTest(way=way), archive(way) as at:
                found = at.find(name="SYNTH*", modality="CT")
                self.assertEqual([study["studyInstanceUid"] for study in found], [UID])
                self.assertEqual((found.is_cut_short, found.unusable), (False, 0))
                self.assertEqual(len(at.series(UID)), len(HERE["series"]))
                heard, stages = [], []
                fetched = at.fetch(UID, into=self.folder / way, progress=lambda *told: stages.append(told),
                                   arrived=lambda *told: heard.append(told))
                self.assertEqual((fetched.kept, fetched.promised, fetched.is_complete, fetched.notes),
                                 (IMAGES, IMAGES, True, []))
                self.assertEqual(heard[-1][:2], (fetched.folder, IMAGES))
                self.assertEqual(heard[-1][2], sum(file.stat().st_size for file in fetched.folder.iterdir()))
                self.assertTrue(all(0 <= fraction <= 1 for _, fraction in stages) and stages)
                with macula.open(fetched.folder) as study:
                    self.assertEqual((study.study_uid, study.shape), (UID, (HERE["slices"], 16, 16)))
                self.assertIn(f"{IMAGES} images came", repr(fetched))

    def test_a_day_is_written_in_several_ways(self):
        day = datetime.date(2020, 1, 2)
        with archive() as at:
            for date in (day, "20200102", (day, day), ("20200101", None), (None, "20200102"), "20191231-20200103",
                         "-20200102", "20200102-"):
                self.assertEqual(len(at.find(date=date)), 1, date)
            for date in (datetime.date(2020, 1, 3), "20200103-", (None, "20200101")):
                self.assertEqual(len(at.find(date=date)), 0, date)
            with self.assertRaises(macula.Error):
                at.find(date="yesterday")
            for wrong in ({"name": "A\0B"}, {"most": -1}, {"most": 2 ** 32}):
                with self.assertRaises(ValueError):
                    at.find(**wrong)

    def test_one_series_is_not_the_study(self):
        with archive() as at:
            for series in (HERE["series"][0], [HERE["series"][0]]):
                fetched = at.fetch(UID, self.folder / str(type(series)), series)
                self.assertEqual((fetched.kept, fetched.is_complete), (HERE["slices"], True))
                with macula.open(fetched.folder) as study:
                    self.assertIn("not known to be complete", study.notes[0])
            with self.assertRaises(ValueError):
                at.fetch(UID, self.folder, series=[])
            with self.assertRaises(macula.Error) as refused:
                at.fetch(UID, self.folder, series="DOE^JANE")
            self.assertNotIn("DOE", str(refused.exception))

    def test_two_threads_fetch_at_once_with_an_archive_each(self):
        met, came = threading.Barrier(2, timeout=30), []

        def fetch(name):
            waits = [True]

            def meet(*_told):  # neither goes on before the other has its first image
                if waits:
                    waits.clear()
                    met.wait()

            with archive("orthanc") as at:  # dcmqrscp sends to one after the other
                came.append(at.fetch(UID, self.folder / name, arrived=meet).kept)

        threads = [threading.Thread(target=fetch, args=(name,)) for name in "ab"]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(came, [IMAGES, IMAGES])

    def test_what_was_refused_is_told_by_file(self):
        with archive("store") as at:
            sent = at.send([pathlib.Path(HERE["odd"]), HERE["study"]])
            self.assertEqual((sent.files, sent.stored), (IMAGES + 1, IMAGES))
            refusal, = sent.refusals
            self.assertEqual(refusal.file, pathlib.Path(HERE["odd"]))
            self.assertTrue(refusal.why and refusal.advice)
            with self.assertRaises(macula.Error):
                at.send([])


class Ends(WithFolder):
    def goes_on(self):
        """Less than all is there, and what is missing comes."""
        there = len(self.images())
        self.assertTrue(0 < there < IMAGES, there)
        with archive() as at:
            fetched = at.fetch(UID, self.folder)
        self.assertEqual((fetched.had_already, fetched.kept), (there, IMAGES - there))
        self.assertTrue(fetched.is_complete)

    def test_whoever_hears_of_images_cancels(self):
        with archive() as at, self.assertRaises(macula.Error) as cancelled:
            at.fetch(UID, self.folder, arrived=lambda *told: True)
        self.assertTrue(cancelled.exception.is_cancelled)
        self.goes_on()

    def test_whoever_hears_of_progress_cancels(self):
        with archive() as at:
            for call in (at.find, at.test, lambda **how: at.series(UID, **how), lambda **how: at.fetch(UID, **how),
                         lambda **how: at.send(HERE["study"], **how)):
                with self.assertRaises(macula.Error) as cancelled:
                    call(progress=lambda stage, fraction: True)
                self.assertEqual(cancelled.exception.status, CANCELLED_STATUS)

    def test_what_a_listener_raises_comes_out(self):
        def fail(*_told):
            raise KeyError("of the listener")

        with archive() as at, self.assertRaises(KeyError):
            at.fetch(UID, self.folder, arrived=fail)
        self.goes_on()

    def test_ctrl_c_ends_a_fetch(self):
        def interrupt(*_told):
            os.kill(os.getpid(), signal.SIGINT)
            time.sleep(0.5)  # until the other thread has heard of it

        with archive() as at, self.assertRaises(KeyboardInterrupt):
            at.fetch(UID, self.folder, arrived=interrupt)
        self.goes_on()

    def test_ctrl_c_ends_waiting_for_one_that_says_nothing(self):
        with socket.create_server(("127.0.0.1", 0)) as silent:
            source = {"name": "Silent",
                      "dimse": {"host": "127.0.0.1", "port": silent.getsockname()[1], "calledAe": "A"}}
            begin = time.monotonic()
            threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
            with macula.Archive(source) as at, self.assertRaises(KeyboardInterrupt):
                at.find()
            self.assertLess(time.monotonic() - begin, 15)

    def test_a_listener_must_not_call(self):
        asked = []
        with archive() as at:
            def meddle(*_told):
                asked.append(True)
                at.find()

            with self.assertRaises(ValueError) as refused:
                at.fetch(UID, self.folder, arrived=meddle)
            self.assertIn("in use", str(refused.exception))
            self.assertEqual(len(asked), 1)
            self.assertEqual(len(at.find()), 1)


class Settings(WithFolder):
    def write(self, name, value):
        DATA.mkdir(parents=True, exist_ok=True)
        file = DATA / name
        file.touch(0o600)
        file.write_text(json.dumps(value))
        self.addCleanup(file.unlink)

    def test_one_that_is_set_up_is_opened_by_its_name(self):
        self.assertEqual(macula.archives(), [])
        with self.assertRaises(macula.Error) as unknown:
            macula.Archive("Hospital")
        self.assertTrue(unknown.exception.advice)
        self.write("sources.json", {"version": 1, "sources": [HERE["archives"]["locked"]]})
        self.write("secrets.json", {"Locked": {"password": HERE["password"]}})
        self.assertEqual([known["name"] for known in macula.archives()], ["Locked"])
        self.assertNotIn(HERE["password"], json.dumps(macula.archives()))
        with macula.Archive("Locked") as at:
            self.assertEqual(at.find(), [])

    def test_a_password_is_given_and_in_no_text(self):
        with archive("locked", password=HERE["password"]) as at:
            self.assertEqual(at.find(), [])
            self.assertNotIn(HERE["password"], repr(at) + repr(vars(at)))
        with archive("locked", password="wrong-battery") as at, self.assertRaises(macula.Error) as refused:
            at.find()
        error = refused.exception
        self.assertEqual(error.status, ARCHIVE_STATUS)
        self.assertNotIn("wrong-battery", error.message + error.advice + error.place)

    def test_each_trouble_has_its_sentence(self):
        sources = HERE["archives"]
        wrong = {**sources["orthanc"], "dimse": {**sources["orthanc"]["dimse"], "calledAe": "SOMEBODY"}}
        closed = {**sources["orthanc"], "dimse": {**sources["orthanc"]["dimse"], "port": HERE["closed"]}}
        for source, step in ((wrong, "AE titles"), (closed, "Port")):
            with macula.Archive(source) as at:
                last = at.test()[-1]
                self.assertEqual((last["name"], last["passed"]), (step, False))
                with self.assertRaises(macula.Error) as refused:
                    at.find()
                error = pickle.loads(pickle.dumps(refused.exception))
                self.assertEqual(error.status, ARCHIVE_STATUS)
                self.assertTrue(error.message and error.advice)
        with archive("orthanc") as at:
            self.assertTrue(all(step["passed"] for step in at.test()))
            with self.assertRaises(macula.Error) as none:
                at.fetch("2.25.404", self.folder)
            self.assertEqual(none.exception.status, ARCHIVE_STATUS)

    def test_what_is_no_archive_is_refused(self):
        for wrong in ({}, {"name": "A"}, [], {**HERE["archives"]["orthanc"], "password": "x"}):
            with self.assertRaises(macula.Error) as refused:
                macula.Archive(wrong)
            self.assertTrue(refused.exception.advice)
        closed = archive()
        closed.close()
        with self.assertRaises(ValueError):
            closed.find()


if __name__ == "__main__":
    unittest.main()
