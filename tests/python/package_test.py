"""The Python package: what it takes, gives back and refuses."""

import ctypes
import importlib.util
import os
import pathlib
import pickle
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import threading
import types
import unittest
import unittest.mock
import zlib

import macula
import numpy
from macula import _interface

AFFINE = [[4, 0, 0, -46], [0, 4, 0, -46], [0, 0, 4, -46], [0, 0, 0, 1]]
HEADERS = pathlib.Path(__file__).parents[2] / "src/c/include/macula"


def balls():
    """A large ball of bone on the patient's left, a small one on the right."""
    z, y, x = numpy.meshgrid(*[4.0 * numpy.arange(24) - 46.0] * 3, indexing="ij")
    values = numpy.full(x.shape, -1000, numpy.int16)
    values[(x - 22) ** 2 + y ** 2 + z ** 2 < 18 ** 2] = 1000
    values[(x + 34) ** 2 + y ** 2 + z ** 2 < 7 ** 2] = 1000
    return values


def write_series(folder, patient, series, images=4):
    """CT images of an invented patient: explicit little endian, 4 x 4 pixels."""
    def element(group, number, vr, value):
        value += (b"\0" if vr in ("UI", "OW") else b" ") * (len(value) % 2)
        length = struct.pack("<HI", 0, len(value)) if vr == "OW" else struct.pack("<H", len(value))
        return struct.pack("<HH", group, number) + vr.encode() + length + value

    def words(*values):
        return struct.pack(f"<{len(values)}H", *values)

    for k in range(images):
        uid = f"{series}.{k + 1}".encode()
        ct = b"1.2.840.10008.5.1.4.1.1.2"
        meta = (element(2, 2, "UI", ct) + element(2, 3, "UI", uid) + element(2, 16, "UI", b"1.2.840.10008.1.2.1"))
        body = b"".join(element(*each) for each in [
            (8, 0x16, "UI", ct), (8, 0x18, "UI", uid), (8, 0x60, "CS", b"CT"),
            (0x10, 0x10, "PN", patient.encode()), (0x10, 0x20, "LO", patient.encode()),
            (0x20, 0xD, "UI", f"{series}.100".encode()), (0x20, 0xE, "UI", series.encode()),
            (0x20, 0x13, "IS", str(k + 1).encode()), (0x20, 0x32, "DS", f"0\\0\\{k}".encode()),
            (0x20, 0x37, "DS", b"1\\0\\0\\0\\1\\0"), (0x20, 0x52, "UI", f"{series}.200".encode()),
            (0x28, 2, "US", words(1)), (0x28, 4, "CS", b"MONOCHROME2"), (0x28, 0x10, "US", words(4)),
            (0x28, 0x11, "US", words(4)), (0x28, 0x30, "DS", b"1\\1"), (0x28, 0x100, "US", words(16)),
            (0x28, 0x101, "US", words(16)), (0x28, 0x102, "US", words(15)), (0x28, 0x103, "US", words(0)),
            (0x28, 0x1052, "DS", b"-1024"), (0x28, 0x1053, "DS", b"1"), (0x7FE0, 0x10, "OW", words(*range(16)))])
        file = pathlib.Path(folder) / f"{uid.decode()}"
        file.write_bytes(bytes(128) + b"DICM" + element(2, 0, "UL", struct.pack("<I", len(meta))) + meta + body)


class Interface(unittest.TestCase):
    def test_structs_are_those_of_the_header(self):
        layout = (pathlib.Path(__file__).parents[1] / "c/layout.txt").read_text().split("\n")
        promised = {name: (int(size), int(offset)) for name, size, offset in (line.split() for line in layout if line)}
        ours = {"macula_error": _interface.ErrorStruct, "macula_progress": _interface.Progress,
                "macula_open": _interface.Open, "macula_secrets": _interface.Secrets,
                "macula_query": _interface.Query, "macula_fetch": _interface.Fetch,
                "macula_fetched": _interface.Fetched, "macula_sent": _interface.Sent,
                "macula_refusal": _interface.Refusal, "macula_voxels": _interface.Voxels, "macula_volume": _interface.Volume,
                "macula_camera": _interface.Camera, "macula_picture": _interface.Picture,
                "macula_drawn": _interface.Drawn, "macula_live_options": _interface.LiveOptions,
                "macula_frame": _interface.Frame, "macula_pick": _interface.Pick, "macula_picked": _interface.Picked,
                "macula_shown": _interface.Shown,
                "macula_model": _interface.Model, "macula_training": _interface.Training}
        # Devices of Vulkan are lent, and their images shared, by programs in C and C++.
        promised = {name: at for name, at in promised.items()
                    if not name.startswith(("macula_lent_", "macula_shared_", "macula_device_"))}
        self.assertEqual({name.split(".")[0] for name in promised}, set(ours))
        for name, struct in ours.items():
            self.assertEqual(ctypes.sizeof(struct), promised[name][0], name)
            members = {member: (getattr(struct, member).size, getattr(struct, member).offset)
                       for member, _ in struct._fields_}
            self.assertEqual(members, {place.split(".")[1]: at for place, at in promised.items()
                                       if place.startswith(name + ".")}, name)

    def test_it_looks_for_the_library_by_the_name_that_programs_are_linked_with(self):
        library = pathlib.Path(os.environ["MACULA_LIBRARY"]).resolve()
        self.assertEqual((library.parent / _interface._NAME).resolve(), library)

    def test_only_an_installed_package_looks_below_its_prefix(self):
        library = pathlib.Path("lib") / _interface._NAME
        with tempfile.TemporaryDirectory() as name:
            top = pathlib.Path(name).resolve()
            places = {}
            for folder in ("checkout/python/macula", "usr/lib/python3/dist-packages/macula"):
                (top / folder).mkdir(parents=True)
                module = shutil.copy(_interface.__file__, top / folder)
                for above in (top / folder).parents:  # whoever may write there may have put it there
                    if above == top.parent:
                        break
                    (above / library).parent.mkdir(exist_ok=True)
                    (above / library).touch()
                spec = importlib.util.spec_from_file_location("looked_at", module)
                looked_at = importlib.util.module_from_spec(spec)
                spec.loader.exec_module(looked_at)
                with unittest.mock.patch.dict(os.environ):
                    os.environ.pop("MACULA_LIBRARY")
                    places[folder.split("/")[0]] = looked_at._places()
            self.assertEqual(places["checkout"], [_interface._NAME])
            self.assertEqual(places["usr"], [str(top / "usr" / library), _interface._NAME])

    def test_another_library_is_no_macula(self):
        told = subprocess.run([sys.executable, "-c", "import macula"], capture_output=True, text=True, check=False,
                              env={**os.environ, "MACULA_LIBRARY": "libc.so.6"})
        self.assertNotEqual(told.returncode, 0)
        self.assertIn("ImportError", told.stderr)
        self.assertIn("libmacula0", told.stderr)

    def test_every_function_that_is_called_is_in_the_header(self):
        text = "".join(header.read_text() for header in HEADERS.glob("*.h"))
        declared = set(re.findall(r"(macula_\w+)\(", text))
        self.assertLessEqual(set(_interface._STATUS) | set(_interface._OTHERS), declared)


class Volumes(unittest.TestCase):
    def test_values_come_back_whatever_their_order_in_memory(self):
        values = balls()
        for given in (values, numpy.asfortranarray(values), values.astype(numpy.float64), values[::1]):
            study = macula.study_of(given, AFFINE, unit="HU")
            self.assertTrue(numpy.array_equal(study.values(), values))
            self.assertEqual(study.shape, (24, 24, 24))
            self.assertEqual(study.patient_from_voxel, AFFINE)
        turned = macula.study_of(values.transpose(2, 1, 0), AFFINE, unit="HU")
        self.assertTrue(numpy.array_equal(turned.values(), values.transpose(2, 1, 0)))

    def test_what_is_no_volume_is_refused(self):
        values = balls()
        for bad in (values[0], values.astype(bool), values.astype(numpy.int64), values.astype(">i2")):
            with self.assertRaises(ValueError):
                macula.study_of(bad, AFFINE)
        with self.assertRaises(ValueError):
            macula.study_of(values, AFFINE[:3])
        with self.assertRaises(ValueError):
            macula.study_of(values, AFFINE, unit="mm")
        with self.assertRaises(macula.Error) as refused:
            macula.study_of(values, [[float("nan")] * 4] * 4)
        self.assertTrue(refused.exception.advice)

    def test_what_it_is_not_is_said(self):
        with self.assertRaises(ValueError) as refused:
            macula.study_of(balls().astype(numpy.float16), AFFINE)
        self.assertIn("'e'", str(refused.exception))
        with self.assertRaises(TypeError):
            macula.study_of([[[1, 2], [3, 4]]], AFFINE)

    def test_what_is_of_no_folder_has_no_identifiers(self):
        study = macula.study_of(balls(), AFFINE)
        self.assertEqual((study.study_uid, study.series_uid, study.frame_of_reference_uid), ("", "", ""))
        self.assertEqual((study.found["volumes"], study.found["skipped"]), ([], []))
        self.assertIs(study.is_calibrated, True)

    def test_of_several_patients_a_choice_is_asked_for(self):
        with tempfile.TemporaryDirectory() as folder:
            write_series(folder, "DOE^JANE", "2.25.501")
            write_series(folder, "ROE^JOHN", "2.25.502", images=5)
            with self.assertRaises(macula.Error) as refused:
                macula.open(folder)
            told = refused.exception
            self.assertIn("patient 1 has series 1 (CT, 4 images); patient 2 has series 2 (CT, 5 images)", told.message)
            self.assertIn("series_uid", told.advice)
            self.assertNotIn("DOE", str(told))
            self.assertNotIn("ROE", str(told))
            for series in ("2.25.501", "1"):
                self.assertEqual(macula.open(folder, series_uid=series).series_uid, "2.25.501")

    def test_what_is_built_in_has_titles(self):
        self.assertEqual([preset["name"] for preset in macula.built_in()["presets"]], macula.names("presets"))
        self.assertTrue(all(clip["title"] for clip in macula.built_in()["clips"]))

    def test_without_a_unit_it_is_said(self):
        self.assertIn("unit", " ".join(macula.study_of(balls(), AFFINE).notes))


class Pictures(unittest.TestCase):
    def setUp(self):
        self.view = macula.study_of(balls(), AFFINE, unit="HU").view()

    def test_left_is_at_the_right_from_the_front_and_at_the_left_from_behind(self):
        halves = {}
        for direction in ("anterior", "posterior"):
            self.view.set_direction(direction)
            pixels = numpy.asarray(self.view.draw(40, 40, samples=2)).astype(float)
            halves[direction] = pixels[:, :20, :3].sum(), pixels[:, 20:, :3].sum()
        self.assertGreater(halves["anterior"][1], 3 * halves["anterior"][0])
        self.assertGreater(halves["posterior"][0], 3 * halves["posterior"][1])

    def test_the_background_is_the_one_that_is_chosen(self):
        self.view.set_background("#ff8000")
        pixels = numpy.asarray(self.view.draw(24, 24, samples=1))
        self.assertEqual(pixels[0, 0].tolist(), [255, 128, 0, 255])
        self.assertEqual(self.view.state["background"], "#ff8000")
        self.view.set_background()
        self.assertEqual(numpy.asarray(self.view.draw(24, 24, samples=1))[0, 0].tolist(), [0, 0, 0, 255])
        self.assertRaises(macula.Error, self.view.set_background, "sky")

    def test_the_camera_that_is_told_is_the_one(self):
        first = self.view.draw(40, 30, samples=1)
        self.view.set_camera(**first.camera)
        self.assertEqual(bytes(self.view.draw(40, 30, samples=1).rgba), bytes(first.rgba))

    def test_a_picture_is_saved_as_it_is(self):
        picture = self.view.draw(24, 16, samples=1)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "a.png"
            picture.save(file)
            data = file.read_bytes()
            self.assertEqual([entry.name for entry in pathlib.Path(folder).iterdir()], ["a.png"])
        self.assertIn(b"Not for primary diagnosis.", data)
        start = data.index(b"IDAT") + 4
        lines = zlib.decompress(data[start:start + int.from_bytes(data[start - 8:start - 4], "big")])
        pixels = numpy.frombuffer(lines, numpy.uint8).reshape(16, 1 + 24 * 4)
        self.assertTrue((pixels[:, 0] == 0).all())
        self.assertTrue(numpy.array_equal(pixels[:, 1:].reshape(16, 24, 4), numpy.asarray(picture)))

    def test_progress_is_told_and_cancels(self):
        told = []
        self.view.draw(16, 16, samples=4, progress=lambda stage, fraction: told.append((stage, fraction)))
        self.assertTrue(told and all(stage and 0 <= fraction <= 1 for stage, fraction in told))
        with self.assertRaises(macula.Error) as stopped:
            self.view.draw(16, 16, samples=1 << 20, progress=lambda stage, fraction: True)
        self.assertTrue(stopped.exception.is_cancelled)

    def test_what_a_listener_raises_comes_out(self):
        def broken(_stage, _fraction):
            raise KeyError("mine")

        with self.assertRaises(KeyError):
            self.view.draw(16, 16, samples=1 << 20, progress=broken)
        self.assertFalse(self.view.draw(16, 16, samples=1).is_empty)  # it goes on afterwards

    def test_threads_with_views_of_their_own_draw_on_one_device(self):
        study, pictures = macula.study_of(balls(), AFFINE, unit="HU"), {}

        def draw(index):
            pictures[index] = [bytes(study_view.draw(24, 24, samples=2).rgba) for study_view in [views[index]] * 4]

        views = [study.view() for _ in range(4)]
        threads = [threading.Thread(target=draw, args=(index,)) for index in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual({picture for drawn in pictures.values() for picture in drawn}, {pictures[0][0]})
        self.assertEqual(len(pictures), 4)

    def test_what_was_opened_while_a_listener_raised_is_closed(self):
        closed = []
        watch = macula._Watch(None)
        watch._raised = KeyError("mine")
        with self.assertRaises(KeyError):
            watch.made(0, macula._Handle, ctypes.c_void_p(7), lambda handle: closed.append(handle.value))
        self.assertEqual(closed, [7])

    def test_what_is_wrong_is_said_with_what_to_do(self):
        for wrong in (lambda: self.view.set_preset("cinematic-bonne"), lambda: self.view.set_look("xray"),
                      lambda: self.view.set_box((0, 0, 0), (0, 1, 1)), lambda: self.view.set_direction("up"),
                      lambda: self.view.set_camera((0, 0, 0), (0, 0, 0), (0, 0, 1)),
                      lambda: self.view.draw(8, 8, most_noise=-1.0), lambda: macula.Device("no such card")):
            with self.assertRaises(macula.Error) as refused:
                wrong()
            self.assertTrue(refused.exception.advice)
        with self.assertRaises(ValueError):
            self.view.draw(0, 8)
        self.view.close()
        self.view.close()
        with self.assertRaises(ValueError):
            self.view.draw(8, 8)

    def test_what_would_be_cut_off_or_filled_up_in_silence_is_refused(self):
        for wrong in (lambda: self.view.draw(8, 8, samples=1 << 40), lambda: self.view.draw(8, 8, samples=-1),
                      lambda: self.view.draw(8, 8, seed=-1), lambda: self.view.draw(8, 8, denoise="yes"),
                      lambda: self.view.set_box((0, 0), (1, 1, 1)), lambda: self.view.set_box((0,) * 4, (1, 1, 1)),
                      lambda: self.view.set_camera((0, -500), (0, 0, 0), (0, 0, 1)),
                      lambda: self.view.set_preset("cinematic-bone\0.json"), lambda: macula.open("/tmp\0/other"),
                      lambda: self.view.draw(8, 8, samples=1).save("a.jpg")):
            with self.assertRaises(ValueError):
                wrong()
        self.assertFalse(pathlib.Path("a.jpg").exists())

    def test_what_is_pointed_at_is_where_it_is(self):
        camera = {"position_mm": (22, -500, 0), "target_mm": (22, 0, 0), "up": (0, 0, 1)}
        there = self.view.pick(50.5, 50.5, 101, 101, camera=camera)
        self.assertTrue(numpy.allclose(there, (22, -18, 0), atol=4), there)
        self.assertIsNone(self.view.pick(0.5, 0.5, 101, 101, camera=camera))
        with self.assertRaises(macula.Error):
            self.view.pick(1, 1, 8, 8)  # of what, is not known before it is drawn
        picture = self.view.draw(40, 40, samples=2)
        y, x = numpy.unravel_index(numpy.asarray(picture)[..., :3].sum(axis=2).argmax(), (40, 40))
        self.assertIsNotNone(self.view.pick(x + 0.5, y + 0.5, picture.width, picture.height))

    def test_what_is_closed_while_it_draws_is_closed_after_that(self):
        view, closing = macula.open("phantom:").view(), []

        def hear(_stage, _fraction):
            if not closing:
                closing.append(threading.Thread(target=view.close))
                closing[0].start()
                closing[0].join()  # at once
                view.close()  # and by who draws

        picture = view.draw(16, 16, samples=1, progress=hear)
        self.assertTrue(picture.device)
        self.assertEqual(picture.record["width"], 16)
        with self.assertRaises(ValueError):
            view.draw(16, 16, samples=1)

    def test_drawing_while_progress_is_told_is_refused_and_waits_for_nothing(self):
        others = [lambda: self.view.draw(8, 8, samples=1), lambda: macula.open("phantom:").view().draw(8, 8, samples=1)]
        for other in others:
            with self.assertRaises(ValueError) as refused:
                self.view.draw(8, 8, samples=1, progress=lambda stage, fraction, other=other: other() is None)
            self.assertIn("progress", str(refused.exception))
        self.assertEqual(len(self.view.draw(8, 8, samples=1).rgba), 256)

    def test_one_view_in_several_threads_has_the_pictures_that_were_asked_for(self):
        seeds = {}

        def draw(seed):
            picture = self.view.draw(16, 16, samples=1, seed=seed)
            seeds[seed] = picture.record["seed"]

        threads = [threading.Thread(target=draw, args=(seed,)) for seed in range(6)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(seeds, {seed: seed for seed in range(6)})

    @unittest.skipIf("libtsan" in os.environ.get("LD_PRELOAD", ""),
                     "the thread sanitizer starts no threads after a fork")
    def test_a_process_that_was_forked_draws_on_a_device_of_its_own(self):
        program = """
import macula, os, signal
study = macula.open("phantom:")
device = macula.Device()
before = bytes(study.view().draw(24, 24, samples=1).rgba)
child = os.fork()
if child == 0:
    signal.alarm(60)
    same = bytes(study.view().draw(24, 24, samples=1).rgba) == before
    refused = False
    try:
        study.view().draw(8, 8, device=device)
    except ValueError:
        refused = True
    device.close()
    os._exit(0 if same and refused else 3)
assert os.waitpid(child, 0)[1] == 0
assert bytes(study.view().draw(24, 24, samples=1).rgba) == before
"""
        # Newer ones of Python warn of every fork beside threads.
        told = subprocess.run([sys.executable, "-W", "ignore::DeprecationWarning", "-c", program], capture_output=True,
                              text=True, check=False, timeout=120)
        self.assertEqual((told.returncode, told.stderr), (0, ""))

    def test_an_error_goes_from_process_to_process(self):
        with self.assertRaises(macula.Error) as refused:
            macula.open("/nowhere/DOE^JOHN")
        there = pickle.loads(pickle.dumps(refused.exception))
        self.assertEqual((there.status, there.message, there.advice, there.place, str(there)),
                         (refused.exception.status, refused.exception.message, refused.exception.advice,
                          refused.exception.place, str(refused.exception)))

    def test_a_place_is_not_in_the_sentence(self):
        with self.assertRaises(macula.Error) as refused:
            macula.open("/nowhere/DOE^JOHN")
        self.assertNotIn("DOE", str(refused.exception))
        self.assertIn("DOE", refused.exception.place)


class States(unittest.TestCase):
    def setUp(self):
        self.study = macula.study_of(balls(), AFFINE, unit="HU")

    def test_a_state_goes_from_view_to_view_and_draws_the_same(self):
        view, other = self.study.view(), self.study.view()
        view.set_preset("cinematic-chest")
        view.set_clip("left-half")
        other.state = view.state
        self.assertEqual(other.state, view.state)
        pictures = [each.draw(24, 24, samples=2) for each in (view, other)]
        self.assertEqual(bytes(pictures[0].rgba), bytes(pictures[1].rgba))
        self.assertEqual(pictures[1].record["clip"], "left-half")
        self.assertEqual((pictures[1].record["width"], pictures[1].record["seed"]), (24, 0))

    def test_what_is_no_state_is_refused(self):
        view = self.study.view()
        before = view.state
        for wrong in ("", "[]", {"camera": 5}):
            with self.assertRaises(macula.Error) as refused:
                view.state = wrong
            self.assertTrue(refused.exception.advice)
        self.assertEqual(view.state, before)


class Lives(unittest.TestCase):
    def setUp(self):
        self.view = macula.study_of(balls(), AFFINE, unit="HU").view()

    def test_frames_come_into_the_array_that_is_given_and_are_not_mirrored(self):
        pixels = numpy.zeros((40, 40, 4), numpy.uint8)
        self.view.set_direction("anterior")  # so that the eye is opposite when its place is negated
        with self.view.live(model=False) as live:
            frame = live.frame(40, 40, out=pixels)
            self.assertIn(frame.kind, ("small", "traced"))
            self.assertTrue(numpy.array_equal(numpy.asarray(frame), pixels))
            light = pixels[..., :3].astype(float)
            self.assertGreater(light[:, 20:].sum(), 3 * light[:, :20].sum())
            turned = dict(frame.camera, position_mm=tuple(-x for x in frame.camera["position_mm"]))
            light = numpy.asarray(live.frame(40, 40, camera=turned, moving=True))[..., :3].astype(float)
            self.assertGreater(light[:, :20].sum(), 3 * light[:, 20:].sum())
            for bad in (numpy.zeros((40, 39, 4), numpy.uint8), bytearray(3)):
                with self.assertRaises(ValueError):
                    live.frame(40, 40, out=bad)
            with self.assertRaises(macula.Error):
                live.frame(40, 40, gaze=(float("nan"), 0))
            with self.assertRaises(macula.Error):
                live.train(steps=1)

    def test_what_was_learnt_is_resumed(self):
        with tempfile.TemporaryDirectory() as folder:
            store = pathlib.Path(folder) / "models"
            with self.view.live(store=store) as live:
                self.assertIsNone(live.model.error)
                told = []
                model = live.train(steps=3, progress=lambda stage, fraction: told.append(stage))
                self.assertTrue(told and model.splats > 0 and not model.is_resumed)
                live.save()
                live.write_model(pathlib.Path(folder) / "a.ply")
                with self.assertRaises(macula.Error):
                    live.write_model(pathlib.Path(folder) / "a.ply")
            with self.view.live(store=store) as live:
                self.assertTrue(live.train(steps=1).is_resumed)
                self.assertGreater(live.model.steps, model.steps)

    def test_the_log_is_heard(self):
        lines = []
        macula.log_to(lambda level, line: lines.append((level, line)))
        macula.Device().close()
        macula.log_to(None)
        self.assertTrue(any("renders on" in line for level, line in lines))

    def test_a_live_picture_is_of_the_process_that_opened_it(self):
        closed = []
        live = macula.Live("handle", closed.append)
        with unittest.mock.patch.object(os, "getpid", return_value=os.getpid() + 1):
            with self.assertRaises(ValueError) as refused:
                live.frame(8, 8)
            live.close()
        self.assertIn("forked", str(refused.exception))
        self.assertEqual(closed, [])

    def test_what_is_dropped_while_the_log_is_told_is_closed_by_another_thread(self):
        by, lines, dropped = [], [], []
        closed = threading.Event()

        def close(_handle):
            by.append(threading.get_ident())
            closed.set()

        def has(line, _user, _least):
            lines.append(line)
            return 0

        with unittest.mock.patch.object(macula, "_library", types.SimpleNamespace(macula_log_to=has)):
            macula.log_to(lambda level, line: dropped.clear())
            dropped.append(macula.Live("handle", close))
            lines[0](None, 2, b"a line")
        self.assertTrue(closed.wait(60))
        self.assertNotIn(threading.get_ident(), by)
        macula.log_to(None)

    def test_what_is_interrupted_while_it_closes_is_closed_once(self):
        closed = []

        def close(handle):
            closed.append(handle)
            raise KeyboardInterrupt  # which a call of C raises when it returns

        opened = macula._Handle("handle", close)
        with self.assertRaises(KeyboardInterrupt):
            opened.close()
        opened.close()
        del opened
        self.assertEqual(closed, ["handle"])

    def test_a_device_that_another_thread_draws_with_is_closed_after_that(self):
        device, view, closing = macula.Device(), macula.open("phantom:").view(), []

        def hear(_stage, _fraction):
            if not closing:
                closing.append(threading.Thread(target=device.close))
                closing[0].start()
                closing[0].join()  # at once: what is in use is closed when that ends

        self.assertEqual(len(view.draw(16, 16, samples=1, device=device, progress=hear).rgba), 4 * 16 * 16)
        with self.assertRaises(ValueError):
            view.draw(16, 16, samples=1, device=device)

    def test_of_two_threads_that_want_the_log_the_line_of_the_last_one_lives(self):
        given, others = [], []

        def has(line, _user, _least):
            given.append(line)
            if not others:  # the other thread comes just when the library has the line of this one
                others.append(threading.Thread(target=macula.log_to, args=(lambda level, line: None,)))
                others[0].start()
                others[0].join(0.2)
            return 0

        with unittest.mock.patch.object(macula, "_library", types.SimpleNamespace(macula_log_to=has)):
            macula.log_to(lambda level, line: None)
            others[0].join()
        self.assertEqual(len(given), 2)
        self.assertIs(macula._log_line, given[-1])
        macula.log_to(None)

    def test_who_has_the_log_may_end_with_a_live_picture_open(self):
        # Closing says what it does by threads of Macula, after Python has begun to take itself apart.
        program = """
import macula, sys
macula.log_to(lambda level, line: None, least="debug")
live = macula.open("phantom:").view().live(store=sys.argv[1])
live.frame(32, 32)
"""
        with tempfile.TemporaryDirectory() as folder:
            told = subprocess.run([sys.executable, "-c", program, folder], capture_output=True, text=True, check=False,
                                  timeout=120)
        self.assertEqual((told.returncode, told.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()
