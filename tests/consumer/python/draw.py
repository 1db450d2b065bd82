"""draw.py STUDY FOLDER: draws a study in three presets, and a volume of its own making, with the installed package."""

import pathlib
import sys

import macula

source, folder = sys.argv[1], pathlib.Path(sys.argv[2])
folder.mkdir(parents=True, exist_ok=True)
with macula.open(source) as study:
    print(f"Macula {macula.version()}: {study.titles[study.index]}, {study.shape}")
    view = study.view()
    for preset in ("cinematic-bone", "cinematic-chest", "ct-lung"):
        view.set_preset(preset)
        picture = view.draw(160, 120, samples=4, denoise=True)
        if picture.is_empty or picture.preset != preset:
            sys.exit(f"{preset}: {picture.notes}")
        picture.save(folder / f"{preset}.png")

# Without NumPy: what has the buffer protocol will do.
voxels = memoryview(bytearray(b"\xff" * 16 ** 3)).cast("B", (16, 16, 16))
made = macula.study_of(voxels, [[2, 0, 0, -15], [0, 2, 0, -15], [0, 0, 2, -15], [0, 0, 0, 1]], unit="HU")
if made.value_range != (255.0, 255.0) or made.shape != (16, 16, 16):
    sys.exit("The volume is another.")
try:
    macula.open(folder / "nothing")
except macula.Error as error:
    print("As it should be:", error)
else:
    sys.exit("What is not there was opened.")
